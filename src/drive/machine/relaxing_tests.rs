//! A mass drawn over springs that relax, against the memory of elastic bodies, closed forms and its ledger.

use super::*;
use crate::contact::model::TangentialBed;
use crate::friction::contact::ViscoelasticFriction;
use crate::friction::{Grip, Pose, TangentialMemory, ViscoelasticBed};
use crate::input::quantity::Length;
use crate::material::{Relaxation, Spectrum};
use crate::shape::Paraboloid;
use proptest::prelude::*;
use std::f64::consts::PI;
use std::sync::Arc;

const SPRINGS: usize = 400;
const SUSPENSION: Suspension = Suspension { mass: 1.0, stiffness: 0.5, damping: 0.05 };

fn ball() -> Paraboloid {
    Paraboloid { radius: Length::new(1.0).unwrap() }
}

fn grip(coefficient: f64) -> Grip {
    Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient }
}

/// A ball on springs of the given relaxation, pressed to d = 1 within `over`.
fn pressed(equilibrium: f64, terms: &[(f64, f64)], coefficient: f64, over: f64) -> Box<dyn TangentialBed> {
    let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium, terms: terms.to_vec(), viscosity: 0.0 }));
    let bed = ViscoelasticBed::new(&ball(), spectrum, grip(coefficient), SPRINGS.try_into().unwrap(), 1.1).unwrap();
    let mut friction = ViscoelasticFriction::new(bed, 1.0);
    friction.go((1.0 / over, 0.0), over);
    Box::new(friction)
}

fn changes(mass: &mut dyn DrawnMass, until: f64) -> Vec<DrawnMoment> {
    std::iter::from_fn(|| mass.step(until).unwrap()).collect()
}

/// How far what is there at the end is from what has been put in, as a part of it, or of what the spring holds as it is drawn by a
/// thousandth of the depth, where nothing moves.
fn open(mass: &SteppedDrawn, begin: f64) -> f64 {
    let (state, tangential) = (mass.state(), mass.tangential());
    let spring = 0.5 * mass.suspension().stiffness * state.extension * state.extension;
    let kept = mass.suspension().kinetic(state.speed) + spring + tangential.stored.unwrap();
    let lost = state.damped + tangential.dissipated.unwrap() + mass.relaxed();
    let least = 0.5 * mass.suspension().stiffness * 1e-6;
    (kept + lost - begin - state.work).abs() / state.work.abs().max(kept).max(least)
}

/// Without terms it is the memory of turning points: times and forces of slips to a cell in 400, as bound in the friction of
/// beds.
#[test]
fn springs_that_do_not_relax_are_those_of_elastic_bodies() {
    let mut memory = TangentialMemory::new(Arc::new(ball()), grip(0.4));
    memory.advance(Pose { indentation: 1.0, slide: 0.0 }).unwrap();
    let mut elastic = Drawn::new(SUSPENSION, memory, 0.75);
    let mut stepped = SteppedDrawn::new(pressed(1.0, &[], 0.4, 1.0), SUSPENSION, 0.75, 1e-6);
    for speed in [0.1, -0.15] {
        let until = elastic.state().time + 60.0;
        elastic.draw(speed);
        stepped.draw(speed);
        let (right, seen) = (changes(&mut elastic, until), changes(&mut stepped, until));
        assert_eq!(right.len(), seen.len());
        assert!(right.len() > 4, "{right:?}");
        for (right, seen) in right.iter().zip(&seen) {
            assert_eq!(right.what, seen.what);
            let off = (right.state.time - seen.state.time).abs() / right.state.time;
            assert!(off < 2e-3 && (right.force - seen.force).abs() < 2e-3 * right.force.abs(), "{right:?} {seen:?}");
        }
        assert!((elastic.state().slide - stepped.state().slide).abs() < 5e-3 * elastic.state().slide.abs());
    }
}

/// Terms far slower than the motion are part of the floor, and those far faster are gone: to what relaxes in the meantime,
/// 60/τ, and the way gone in τ.
#[test]
fn the_limits_of_slow_and_fast_terms_are_elastic() {
    let slips = |equilibrium: f64, terms: &[(f64, f64)]| {
        let mut mass = SteppedDrawn::new(pressed(equilibrium, terms, 0.4, 1.0), SUSPENSION, 0.75, 1e-7);
        mass.draw(0.1);
        changes(&mut mass, 60.0)
    };
    let right = slips(1.0, &[]);
    for other in [slips(0.3, &[(0.7, 1e7)]), slips(1.0, &[(5.0, 1e-7)])] {
        assert_eq!(right.len(), other.len());
        for (right, other) in right.iter().zip(&other) {
            let off = (right.state.time / other.state.time - 1.0).abs();
            assert!(off < 1e-4 && (right.force / other.force - 1.0).abs() < 1e-4, "{right:?} {other:?}");
        }
    }
}

/// A slow drive and a soft spring: the contact slips at μ_s times the force it has relaxed to, jumps by 2(μ_s − μ_k)F/k and
/// is at rest π√(m/k) later, up to the speed of the drive over that of the slip.
#[test]
fn slow_slips_follow_the_force_as_it_relaxes() {
    let suspension = Suspension { mass: 1.0, stiffness: 0.01, damping: 0.0 };
    let terms = [(0.6, 300.0)];
    let mut mass = SteppedDrawn::new(pressed(0.4, &terms, 0.4, 1e-6), suspension, 0.75, 1e-5);
    let drawn = 1e-3;
    mass.draw(drawn);
    let moments = changes(&mut mass, 1500.0 * 40.0);
    assert!(moments.len() >= 6);
    for pair in moments.chunks_exact(2) {
        let (slip, stick) = (pair[0].state, pair[1].state);
        let force = 4.0 / 3.0 * (0.4 + 0.6 * (-slip.time / 300.0).exp());
        assert!((pair[0].force.abs() / (0.4 * force) - 1.0).abs() < 1e-3, "{:e} {force:e}", pair[0].force);
        let fall = 0.1 * force;
        let near = 2.0 * PI * drawn * 0.1 / fall + 2e-2;
        assert!(((stick.slide - slip.slide) / (2.0 * fall / 0.01) - 1.0).abs() < near, "{slip:?} {stick:?}");
        assert!(((stick.time - slip.time) / (10.0 * PI) - 1.0).abs() < near, "{slip:?} {stick:?}");
    }
}

/// What nobody draws stays where it is.
#[test]
fn a_mass_at_rest_rests() {
    let mut mass = SteppedDrawn::new(pressed(0.3, &[(0.7, 1.0)], 0.4, 0.5), SUSPENSION, 0.4, 1e-4);
    mass.draw(0.0);
    assert_eq!(mass.step(10.0).unwrap(), None);
    assert!(mass.state().slide.abs() < 1e-12 && mass.state().speed.abs() < 1e-12, "{:?}", mass.state());
}

proptest! {
    #![proptest_config(crate::laws::cases(8))]

    /// What is put in is there at the end, however the far end is drawn and the depth led: the steps are in balance, to
    /// 1e-9 of a step each.
    #[test]
    fn the_ledger_closes(
        motions in prop::collection::vec((-6i32..7, -2i32..3), 1..5),
        (time, left) in (-4i32..3, 4i32..11),
    ) {
        let bed = pressed(0.3, &[(0.7, 10f64.powi(time))], 0.4, 0.5);
        let begin = bed.state().stored.unwrap() + bed.state().dissipated.unwrap() + bed.relaxed();
        let mut mass = SteppedDrawn::new(bed, SUSPENSION, 0.1 * f64::from(left), 1e-4);
        let mut until = 0.0;
        for (speed, down) in motions {
            until += 10.0;
            mass.draw(0.05 * f64::from(speed));
            mass.lead(0.002 * f64::from(down));
            let mut before = mass.state().time;
            for moment in changes(&mut mass, until) {
                prop_assert!(moment.state.time >= before);
                before = moment.state.time;
            }
            prop_assert!(mass.state().time.total_cmp(&until).is_eq());
            prop_assert!(open(&mass, begin) < 1e-7, "{:e}", open(&mass, begin));
        }
    }
}
