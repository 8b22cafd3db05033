//! Bodies that remember, once a pull has parted them.

use super::course::{Course, Extent, Path};
use super::*;
use crate::contact::error::BedError;
use crate::contact::viscoelastic::attraction::Attraction;
use crate::contact::viscoelastic::continuous::ContinuousContact;
use crate::contact::viscoelastic::memory::Memory;
use crate::input::quantity::{Amplitude, Length};
use crate::material::{Relaxation, Spectrum};
use crate::shape::{Cylinder, Lying, Paraboloid, Profile, WavyParaboloid};
use std::sync::Arc;

/// E∞ [Pa], E₁ [Pa] and τ [s]: a free spring has one mode, of the time λ = τ(1 + E₁/E∞).
const SOFT: (f64, f64, f64) = (1.2e6, 2e6, 0.1);

fn relaxing() -> Arc<Spectrum> {
    let (equilibrium, modulus, time) = SOFT;
    Arc::new(Spectrum::new(&Relaxation { equilibrium, terms: vec![(modulus, time)], viscosity: 0.0 }))
}

fn length(value: f64) -> Length {
    Length::new(value).unwrap()
}

/// Shapes, each with a push and a pull [N] that parts it.
fn shapes() -> [(Arc<dyn Profile>, [f64; 2]); 3] {
    let amplitude = Amplitude::new(2e-7).unwrap();
    let wavy = WavyParaboloid { radius: length(5e-3), amplitude, wavelength: length(2e-4) };
    let cylinder = Cylinder { radius: length(5e-3), datum: length(1e-2), width: Some(length(1e-2)) };
    [(ball(), [1e-3, -4e-3]), (Arc::new(wavy), [1e-3, -4e-3]), (Arc::new(Lying::from(&cylinder)), [5e-2, -0.3])]
}

fn adhesive(profile: &Arc<dyn Profile>, law: Attraction) -> ContinuousContact {
    ContinuousContact::new(Memory::new(relaxing(), profile.clone()).with(law))
}

fn ball() -> Arc<dyn Profile> {
    Arc::new(Paraboloid { radius: length(5e-3) })
}

/// States at the ends of entries of a force [N] and a time [s], and what happens on the way.
fn led(contact: &mut dyn ContactModel, accuracy: f64, history: &[(f64, f64)]) -> (Vec<Normal>, Vec<Occurrence>) {
    let (mut driver, mut begin) = (Driver::new(contact, accuracy), 0.0);
    let (mut states, mut seen) = (Vec::new(), Vec::new());
    for &(force, over) in history {
        let (normal, tangential) = (Path::To(force), Path::Stay);
        let course = Course { control: Control::Force, normal, tangential, over, extent: Extent::Entry };
        driver.begin(contact, course, 0.0).unwrap();
        let happened = driver.advance(contact, 1.0).unwrap();
        seen.extend(happened.into_iter().map(|event| Occurrence { time: begin + event.time, ..event }));
        states.push(driver.state(contact));
        begin += over;
    }
    (states, seen)
}

/// Between parting and the end of the entry the springs recover, U = U₀ e^(−2t/λ), and what they lose is dissipated; a
/// later contact finds them as after a hold. Bounds: rounding of U and of the sum; on two ways to the same motion the
/// accuracy asked for, and the root of it where the pull is greatest, for there the contact turns with the force.
#[test]
fn what_a_pull_has_parted_relaxes_in_the_rest_of_its_entry() {
    let accuracy = 1e-4;
    let (equilibrium, modulus, time) = SOFT;
    let spectrum = relaxing();
    let laws = [
        Attraction::relaxed(0.02, &spectrum),
        Attraction::relaxed(0.02, &spectrum).closing(5e-3),
        Attraction::instantaneous(0.02, &spectrum),
    ];
    for ((profile, [push, pull]), law) in shapes().iter().flat_map(|shape| laws.map(|law| (shape, law))) {
        let bed = || adhesive(profile, law);
        let (whole, seen) = led(&mut bed(), accuracy, &[(*push, 0.5), (*pull, 0.5), (*push, 0.5)]);
        let parting = seen.iter().find(|event| event.after.indentation.is_none()).unwrap();
        let (torn, rested) = (parting.after, whole[1]);
        let (stored, waits) = (torn.stored.elastic, 1.0 - parting.time);
        let left = stored * (-2.0 * waits * equilibrium / (time * (equilibrium + modulus))).exp();
        assert!(waits > 0.1 && stored > 0.0 && rested.indentation.is_none(), "{law:?}: {parting:?}");
        assert!((rested.stored.elastic / left - 1.0).abs() < 1e-11, "{law:?}: {rested:?} {left:e}");
        let lost = rested.dissipated - torn.dissipated;
        let rounding = 1e-13 * (torn.dissipated + stored);
        assert!((lost - (stored - rested.stored.elastic)).abs() < rounding, "{law:?}: {torn:?} {rested:?}");

        // The same motion, cut before its end, and a hold.
        let cut = push + 0.9 * (pull - push);
        let history = [(*push, 0.5), (cut, 0.45), (cut, 0.05), (*pull, 0.0), (*push, 0.5)];
        let (held, _) = led(&mut bed(), accuracy, &history);
        let off = [
            held[3].stored.elastic / rested.stored.elastic - 1.0,
            held[3].dissipated / rested.dissipated - 1.0,
            held[4].indentation.unwrap() / whole[2].indentation.unwrap() - 1.0,
            held[4].contact_radius.unwrap() / whole[2].contact_radius.unwrap() - 1.0,
        ];
        let bounds = [accuracy.sqrt(), accuracy.sqrt(), 10.0 * accuracy, 10.0 * accuracy];
        assert!(off.iter().zip(bounds).all(|(off, bound)| off.abs() < bound), "{law:?}: {off:?}");
    }
}

/// What a pull has parted is led to a depth from first touch on, as elastic bodies are, and held there it stays there; a
/// retraction leaves it apart.
#[test]
fn what_a_pull_has_parted_is_led_from_touch() {
    let spectrum = relaxing();
    for law in [Attraction::relaxed(0.02, &spectrum), Attraction::relaxed(0.02, &spectrum).closing(5e-3)] {
        for (normal, half) in [(Path::To(1e-6), 5e-7), (Path::Stay, 0.0), (Path::To(-1e-6), -5e-7)] {
            let mut contact = adhesive(&ball(), law);
            let mut driver = Driver::new(&contact, 1e-4);
            let course =
                |control, normal| Course { control, normal, tangential: Path::Stay, over: 1.0, extent: Extent::Entry };
            for force in [1e-3, -4e-3] {
                driver.begin(&mut contact, course(Control::Force, Path::To(force)), 0.0).unwrap();
                driver.advance(&mut contact, 1.0).unwrap();
            }
            assert!(driver.state(&contact).indentation.is_none());
            driver.begin(&mut contact, course(Control::Indentation, normal), 0.0).unwrap();
            driver.advance(&mut contact, 0.5).unwrap();
            let state = driver.state(&contact);
            assert!((state.indentation.unwrap() - half).abs() < 1e-18, "{law:?}: {state:?}");
            driver.advance(&mut contact, 1.0).unwrap();
            // Held at touch, what is left of the dent keeps the ball off for as long as it recovers.
            assert_eq!(contact.joined(), half > 0.0, "{law:?} {normal:?}");
        }
        let mut contact = adhesive(&ball(), law);
        let mut driver = Driver::new(&contact, 1e-4);
        let pull = Course {
            control: Control::Force,
            normal: Path::To(-4e-3),
            tangential: Path::Stay,
            over: 1.0,
            extent: Extent::Entry,
        };
        driver.begin(&mut contact, pull, 0.0).unwrap();
        driver.advance(&mut contact, 1.0).unwrap();
        driver
            .begin(
                &mut contact,
                Course { control: Control::Indentation, normal: Path::UntilParted { speed: 1e-6 }, ..pull },
                0.0,
            )
            .unwrap();
        driver.advance(&mut contact, 1.0).unwrap();
        assert!(!contact.joined());
    }
}

/// After forty times λ nothing is left, and all of it is heat.
#[test]
fn what_is_stored_at_parting_falls_to_zero() {
    let law = Attraction::relaxed(0.02, &relaxing());
    let mut contact = adhesive(&ball(), law);
    // The pull grows on after the bodies have parted, for 12 s.
    let (states, seen) = led(&mut contact, 1e-4, &[(1e-3, 0.5), (-2.4e-2, 12.5)]);
    let torn = seen.iter().find(|event| event.after.indentation.is_none()).unwrap().after;
    assert!(states[1].stored.elastic < 1e-30 * torn.stored.elastic, "{:?}", states[1]);
    let lost = states[1].dissipated - torn.dissipated;
    assert!((lost / torn.stored.elastic - 1.0).abs() < 1e-12, "{lost:e} {torn:?}");
}

/// An edge that opens by a rate law lets go under a pull that weakens already: the bodies come together again when the
/// same entry pushes. −(3/2)πwR = −0.4712 mN is what they bear in the end.
#[test]
fn what_a_weakening_pull_has_parted_comes_together_when_it_pushes() {
    let law = Attraction::with_rate(0.02, &relaxing(), (1e-2, 0.5)).to_accuracy(1e-4);
    let mut contact = adhesive(&ball(), law);
    let (states, seen) = led(&mut contact, 1e-4, &[(1e-3, 1.0), (-6e-4, 0.1), (6e-4, 20.0)]);
    let parting = seen.iter().find(|event| event.after.indentation.is_none()).unwrap();
    assert!(parting.time > 1.1 && parting.before.force < -4.712e-4, "{parting:?}");
    assert!((states[2].force / 6e-4 - 1.0).abs() < 1e-3 && states[2].contact_radius > Some(0.0), "{states:?}");
    // A ball that has rested for eight seconds, thirty times λ, is one never touched.
    let mut fresh = adhesive(&ball(), law);
    let (untouched, _) = led(&mut fresh, 1e-4, &[(6e-4, 10.0)]);
    let off = states[2].contact_radius.unwrap() / untouched[0].contact_radius.unwrap() - 1.0;
    assert!(off.abs() < 1e-3, "{off:e}");
}

/// A pull that fades to nothing does not bring parted bodies together, though by rounding it is none before its end.
#[test]
fn a_pull_that_fades_to_nothing_leaves_the_bodies_apart() {
    for (pull, over) in [(-4e-3 / 3.0, 1.9), (-4e-3 / 6.0, 1.9), (-4e-3 / 7.0, 2.3)] {
        assert!(pull / (pull / over) < over);
        let law = Attraction::with_rate(0.02, &relaxing(), (1e-2, 0.5)).to_accuracy(1e-3);
        let mut contact = adhesive(&ball(), law);
        let (states, _) = led(&mut contact, 1e-3, &[(-4e-3, 1.0), (pull, 1.0), (0.0, over)]);
        assert!(states.iter().all(|state| state.contact_radius.is_none_or(|radius| radius <= 0.0)), "{states:?}");
    }
}

/// A pull that tears bodies apart gives what springs that give at once do not give of the work of adhesion: what has been
/// lost is not found again, and the springs keep no more than they had.
#[test]
fn a_pull_that_tears_finds_nothing_again() {
    let spectrum = relaxing();
    let slow = Attraction::relaxed(0.02, &spectrum);
    let rate = Attraction::with_rate(0.02, &spectrum, (1e-2, 0.5)).to_accuracy(1e-4);
    let laws = [slow, slow.closing(5e-3), Attraction::instantaneous(0.02, &spectrum), rate];
    for ((profile, [push, pull]), law) in shapes().iter().flat_map(|shape| laws.map(|law| (shape, law))) {
        let mut contact = adhesive(profile, law);
        let (_, seen) = led(&mut contact, 1e-3, &[(*push, 1.0), (*pull, 2.0)]);
        let Occurrence { before, after, .. } =
            seen.into_iter().find(|event| event.after.indentation.is_none()).unwrap();
        let kept = 1.0 - 1e-12;
        assert!(after.dissipated >= kept * before.dissipated, "{law:?}: {before:?} {after:?}");
        assert!(after.stored.elastic <= before.stored.elastic, "{law:?}: {before:?} {after:?}");
    }
}

/// Springs let go at once are those of an indenter drawn back faster than anything relaxes, without its work; behind a
/// dashpot they keep all they have. Bound: rounding of the energies.
#[test]
fn springs_let_go_at_once_are_those_of_a_sudden_retraction() {
    let (equilibrium, modulus, time) = SOFT;
    let bed = |viscosity: f64| {
        let relaxation = Relaxation { equilibrium, terms: vec![(modulus, time), (3e5, 2.0)], viscosity };
        let mut bed = Memory::new(Arc::new(Spectrum::new(&relaxation)), ball());
        bed.reach(5e-6, 0.3).unwrap();
        bed
    };
    let (mut left, mut drawn) = (bed(0.0), bed(0.0));
    left.leave();
    drawn.reach(left.indentation(), 1e-21).unwrap();
    for wait in [0.0, 0.05, 1.0] {
        if wait > 0.0 {
            [&mut left, &mut drawn].into_iter().for_each(|bed| bed.advance(0.0, wait).unwrap());
        }
        let off = left.ledger().stored / drawn.ledger().stored - 1.0;
        assert!(off.abs() < 1e-9 && left.ledger().stored > 0.0, "{wait}: {off:e}");
    }
    let mut damped = bed(1e3);
    let stored = damped.ledger().stored;
    damped.leave();
    assert!((damped.ledger().stored / stored - 1.0).abs() < 1e-9 && damped.radius() <= 0.0, "{:?}", damped.ledger());
}

/// A liquid that is stretched steadily bears v ΣEᵢτᵢ: below √(2πaE(0)w) its edge holds for ever, above it gives way.
#[test]
fn a_liquid_that_flows_fast_enough_is_never_torn_off() {
    let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 0.0, terms: vec![(2e6, 0.05)], viscosity: 0.0 }));
    let law = Attraction::instantaneous(0.05, &spectrum);
    let mut contact = ContinuousContact::new(Memory::new(spectrum, ball()).with(law));
    contact.follow(&Straight::between(0.0, 1e-5, 1.0)).unwrap();
    let a = contact.state().contact_radius.unwrap();
    let holds = (std::f64::consts::TAU * a * 2e6 * 0.05).sqrt() / (2e6 * 0.05);
    let driver = Driver::new(&contact, 1e-6);
    let slow = driver.last_depth(&mut contact, 0.5 * holds);
    assert!(matches!(slow, Err(ContactError::Bed(BedError::NeverParts { .. }))), "{slow:?}");
    assert!(driver.last_depth(&mut contact, 2.0 * holds).is_ok());
}
