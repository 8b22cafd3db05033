//! Whole stages, against closed forms and against other cuts of the same way.

use super::course::Wave;
use super::*;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::continuous::ContinuousContact;
use crate::contact::viscoelastic::growing::GrowingBed;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::memory::Memory;
use crate::input::quantity::Length;
use crate::material::Relaxation;
use crate::shape::{FlatPunch, Paraboloid, Profile};
use std::f64::consts::TAU;
use std::sync::Arc;

fn by_depth(normal: Path, over: f64) -> Course {
    let (control, tangential) = (Control::Indentation, Path::Stay);
    Course { control, normal, tangential, over, extent: Extent::Entry }
}

/// A flat punch is linear: F = F₀ + 2bA(E′ sin ωt + E″ cos ωt) once the start is forgotten.
#[test]
fn oscillation_gives_storage_and_loss() {
    let terms = vec![(3.0, 0.05), (2.0, 0.4)];
    let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.02 }));
    let punch: Arc<dyn Profile> = Arc::new(FlatPunch { radius: Length::new(0.5).unwrap() });
    let layout = Layout::uniform(punch.as_ref(), 0.5, 10);
    let mut bed = GrowingBed::new(spectrum.clone(), punch, layout);
    let mut driver = Driver::new(&bed, 1e-7);
    for course in [by_depth(Path::To(1.0), 1.0), by_depth(Path::Stay, 100.0)] {
        driver.begin(&mut bed, course, 0.0).unwrap();
        driver.advance(&mut bed, 1.0).unwrap();
    }
    let wave = Wave { amplitude: 0.01, frequency: 1.0 };
    driver.begin(&mut bed, by_depth(Path::Wave(wave), 10.0), 0.0).unwrap();
    for k in 1..=400 {
        let t = f64::from(k) / 40.0;
        driver.advance(&mut bed, t / 10.0).unwrap();
        let part = 0.01 * (spectrum.storage(TAU) * (TAU * t).sin() + spectrum.loss(TAU) * (TAU * t).cos());
        let off = driver.state(&bed).force - 1.0 - part;
        assert!(k <= 360 || off.abs() < 6.0 * 1e-7, "{t}: {off}");
    }
    let found = driver.last_loop().unwrap();
    assert!((found.storage / spectrum.storage(TAU) - 1.0).abs() < 1e-3, "{found:?}");
}

/// A Kelvin–Voigt ball shaken while it is pressed: where the sine turns, the force is Hertz's to the accuracy, however far the
/// chords before and behind are from standing still. What turns on the way is told at the speed of the sine too.
#[test]
fn a_dashpot_does_nothing_where_a_sine_turns() {
    let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity: 0.3 }));
    let ball: Arc<dyn Profile> = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
    let wave = Wave { amplitude: 0.1, frequency: 1.0 };
    let shaken = |accuracy: f64| {
        let mut contact = ContinuousContact::new(Memory::new(spectrum.clone(), ball.clone()));
        let mut driver = Driver::new(&contact, accuracy);
        driver.begin(&mut contact, by_depth(Path::To(0.2), 1.0), 0.0).unwrap();
        driver.advance(&mut contact, 1.0).unwrap();
        driver.begin(&mut contact, by_depth(Path::Wave(wave), 1.0), 0.0).unwrap();
        let turns = driver.advance(&mut contact, 0.25).unwrap();
        (turns[0].after.force, driver.state(&contact).force)
    };
    let hertz = 4.0 / 3.0 * 0.3f64.powf(1.5);
    for accuracy in [1e-3, 1e-5] {
        let (highest, turned) = shaken(accuracy);
        assert!((turned / hertz - 1.0).abs() < 2.0 * accuracy, "{accuracy}: {turned} {hertz}");
        let exact = shaken(1e-7).0;
        assert!((highest / exact - 1.0).abs() < accuracy.max(1e-5), "{accuracy}: {highest} {exact}");
    }
}

/// A Kelvin–Voigt body let go by a force comes up as e^{−t/τ} under an indenter that carries nothing, wherever that is looked
/// at; with what it is led through afterwards nothing is left of where it was held.
#[test]
fn a_surface_comes_up_by_itself_at_no_force() {
    const TAU: f64 = 0.1;
    let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity: TAU }));
    let ball: Arc<dyn Profile> = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
    let by_force = |normal, over| Course { control: Control::Force, ..by_depth(normal, over) };
    // However often the two seconds are cut into entries, and an entry into records.
    let led = |(entries, records): (u32, u32)| {
        let mut contact = ContinuousContact::new(Memory::new(spectrum.clone(), ball.clone()));
        let mut driver = Driver::new(&contact, 1e-6);
        for course in [by_force(Path::To(1e-3), 1.0), by_force(Path::To(0.0), 0.01)] {
            driver.begin(&mut contact, course, 0.0).unwrap();
            driver.advance(&mut contact, 1.0).unwrap();
        }
        let start = driver.state(&contact).indentation.unwrap();
        for entry in 0..entries {
            driver.begin(&mut contact, by_force(Path::Stay, 2.0 / f64::from(entries)), 0.0).unwrap();
            for k in 1..=records {
                let part = f64::from(k) / f64::from(records);
                driver.advance(&mut contact, part).unwrap();
                let state = driver.state(&contact);
                assert!(state.force <= 1e-11, "{state:?}");
                let time = 2.0 * (f64::from(entry) + part) / f64::from(entries);
                let (depth, right) = (state.indentation.unwrap(), start * (-time / TAU).exp());
                // The indenter is put down to a force of 1e-9 of the largest one, and began from one.
                assert!((depth / right - 1.0).abs() < 1e-7 + 1e-12 * start / right, "{time}: {depth:e} {right:e}");
            }
        }
        driver.begin(&mut contact, by_force(Path::To(1e-3), 1.0), 0.0).unwrap();
        driver.advance(&mut contact, 1.0).unwrap();
        driver.state(&contact)
    };
    let few = led((1, 2));
    let off = |one: Option<f64>, other: Option<f64>| (one.unwrap() / other.unwrap() - 1.0).abs();
    for many in [led((1, 40)), led((7, 3)), led((40, 1))] {
        assert!(off(few.indentation, many.indentation) < 1e-9 && off(few.contact_radius, many.contact_radius) < 1e-6);
    }
}

/// A ramp cut anywhere into entries, and however many records there are: the same contact, to rounding.
#[test]
fn neither_cuts_nor_records_change_a_contact() {
    let terms = vec![(3.0, 0.3), (2.0, 5.0)];
    let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.0 }));
    let ball: Arc<dyn Profile> = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
    let layout = Layout::graded(ball.as_ref(), (1e-3, 0.1), 500);
    let springs = GrowingBed::new(spectrum.clone(), ball.clone(), layout);
    let continuous = ContinuousContact::new(Memory::new(spectrum, ball));
    let contacts: [Box<dyn ContactModel>; 2] = [Box::new(springs), Box::new(continuous)];
    for contact in contacts {
        let led = |cuts: u32, records: u32| {
            let (mut contact, mut driver) = (contact.copy(), Driver::new(contact.as_ref(), 1e-6));
            for (from, to) in [(0.0, 0.01), (0.01, 0.004), (0.004, 0.009)] {
                for cut in 1..=cuts {
                    let depth = from + (to - from) * f64::from(cut) / f64::from(cuts);
                    let over = 1.0 / f64::from(cuts);
                    driver.begin(contact.as_mut(), by_depth(Path::To(depth), over), 0.0).unwrap();
                    for k in 1..=records {
                        driver.advance(contact.as_mut(), f64::from(k) / f64::from(records)).unwrap();
                    }
                }
            }
            contact.state()
        };
        let once = led(1, 1);
        for (cuts, records) in [(1, 97), (7, 1), (5, 13)] {
            let often = led(cuts, records);
            assert!((often.force / once.force - 1.0).abs() < 1e-12, "{cuts} {records}: {often:?} {once:?}");
            let (a, b) = (often.contact_radius.unwrap(), once.contact_radius.unwrap());
            assert!((a / b - 1.0).abs() < 1e-12, "{cuts} {records}: {often:?} {once:?}");
        }
    }
}
