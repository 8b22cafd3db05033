//! An adhesive wavy lens jumps from wave to wave: every jump is found, whatever the number of records.
//!
//! The reference is a scan of d(a) = a²/R + (π/2)hka·H₀(ka) − √(2πaw/E*) of its own, with the Struve
//! function from its integral: the stable path under a growing or falling depth is the running
//! maximum from the left or the running minimum from the right.

use proptest::prelude::*;
use springbed::contact::adhesion::line::{EdgeLine, Energy};
use springbed::contact::direct::{Jump, QuasiStatic};
use springbed::contact::foundation::Foundation;
use springbed::input::quantity::{Amplitude, Length};
use springbed::numerics::quadrature;
use springbed::shape::WavyParaboloid;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

/// Guduru's lens: R, amplitude, wavelength [m], E* [Pa], w [J/m²].
#[derive(Debug, Clone, Copy)]
struct Lens {
    radius: f64,
    amplitude: f64,
    wavelength: f64,
    modulus: f64,
    work: f64,
}

/// The lens of configs/wavy_lens.ron.
const LENS: Lens = Lens { radius: 0.02, amplitude: 0.2e-6, wavelength: 1e-4, modulus: 2e6 / 0.75, work: 0.05 };

impl Lens {
    fn shape(&self) -> WavyParaboloid {
        WavyParaboloid {
            radius: Length::new(self.radius).unwrap(),
            amplitude: Amplitude::new(self.amplitude).unwrap(),
            wavelength: Length::new(self.wavelength).unwrap(),
        }
    }

    /// d(a), with H₀(z) = (2/π)∫₀^{π/2} sin(z cos θ) dθ.
    fn depth(&self, a: f64) -> f64 {
        let z = TAU * a / self.wavelength;
        let integral = quadrature::equal_panels(|t| (z * t.cos()).sin(), (0.0, FRAC_PI_2), 20.0 / z.max(1.0));
        a * a / self.radius + self.amplitude * z * integral - (2.0 * PI * a * self.work / self.modulus).sqrt()
    }

    /// Depths at which the contact jumps on the way from first touch to the depth `to`.
    fn jumps_in(&self, to: f64) -> Vec<f64> {
        let steps = 2000.0;
        let mut jumps = vec![0.0];
        let (mut a, mut most, mut falling) = (0.0, 0.0f64, true);
        loop {
            a += self.wavelength / steps;
            let d = self.depth(a);
            if d > to {
                return jumps;
            }
            if d < most && !falling {
                jumps.push(most);
            }
            falling = d < most;
            most = most.max(d);
        }
    }

    /// Depths at which it jumps on the way out from the radius `a`.
    fn jumps_out(&self, from: f64) -> Vec<f64> {
        let step = self.wavelength / 2000.0;
        let (mut jumps, mut least, mut rising) = (Vec::new(), self.depth(from), false);
        let radii = std::iter::successors(Some(from - step), |a| Some(a - step)).take_while(|&a| a > 0.0);
        for d in radii.map(|a| self.depth(a)) {
            if d > least && !rising {
                jumps.push(least);
            }
            rising = d > least;
            least = least.min(d);
        }
        jumps
    }
}

/// Jumps on the way to `to` and out again, with `records` stops each way.
fn loop_of(lens: Lens, to: f64, records: u32) -> (Vec<Jump>, Vec<Jump>) {
    let shape = lens.shape();
    let line = EdgeLine::new(Foundation::new(Arc::new(shape.clone()), lens.modulus), lens.work);
    let mut contact = QuasiStatic::new(line);
    let mut ways = [(0.0, to), (to, contact.last_depth().unwrap())].map(|(from, to)| {
        let stop = |k| if k == records { to } else { from + (to - from) * f64::from(k) / f64::from(records) };
        (1..=records).flat_map(|k| contact.indent(stop(k)).unwrap()).collect::<Vec<_>>()
    });
    // Out of contact a hair below the last stable depth.
    let last = contact.last_depth().unwrap();
    ways[1].extend(contact.indent(last - 1e-9 * to).unwrap());
    (std::mem::take(&mut ways[0]), std::mem::take(&mut ways[1]))
}

fn lost(jumps: &(Vec<Jump>, Vec<Jump>)) -> f64 {
    jumps.0.iter().chain(&jumps.1).map(|jump| jump.dissipated).sum()
}

/// Sum of the energies on both sides of all jumps, by size.
fn stored(jumps: &(Vec<Jump>, Vec<Jump>)) -> f64 {
    let size = |energy: &Energy| energy.elastic - energy.surface;
    jumps.0.iter().chain(&jumps.1).map(|jump| size(&jump.stored.0) + size(&jump.stored.1)).sum()
}

#[test]
fn every_jump_is_found_whatever_the_number_of_records() {
    let fine = loop_of(LENS, 1e-5, 1000);
    for records in [1, 2, 3, 10, 77] {
        let coarse = loop_of(LENS, 1e-5, records);
        assert_eq!(coarse.0.len(), fine.0.len(), "{records} records on the way in");
        assert_eq!(coarse.1.len(), fine.1.len(), "{records} records on the way out");
        let pairs = coarse.0.iter().zip(&fine.0).chain(coarse.1.iter().zip(&fine.1));
        for (one, other) in pairs {
            // A root of the slope: d is flat there, so it keeps all its digits.
            assert!((one.before.indentation - other.before.indentation).abs() < 1e-15 * 1e-5, "{records} records");
            assert!((one.dissipated - other.dissipated).abs() < 1e-14 * stored(&fine), "{records} records");
        }
    }
}

/// Under a prescribed force too.
#[test]
fn every_jump_under_force_is_found_whatever_the_number_of_records() {
    let shape = LENS.shape();
    let run = |records: u32| {
        let line = EdgeLine::new(Foundation::new(Arc::new(shape.clone()), LENS.modulus), LENS.work);
        let mut contact = QuasiStatic::new(line);
        let mut way = |from: f64, to: f64| -> Vec<Jump> {
            let stop = |k| from + (to - from) * f64::from(k) / f64::from(records);
            (1..=records).flat_map(|k| contact.press(stop(k)).unwrap()).collect()
        };
        (way(0.0, 0.02), way(0.02, -0.02))
    };
    let fine = run(1000);
    assert!(fine.0.len() > 2 && fine.1.len() > 2, "{} {}", fine.0.len(), fine.1.len());
    for records in [1, 2, 10] {
        let coarse = run(records);
        assert_eq!((coarse.0.len(), coarse.1.len()), (fine.0.len(), fine.1.len()), "{records} records");
        assert!((lost(&coarse) - lost(&fine)).abs() < 1e-14 * stored(&fine), "{records} records");
    }
}

#[test]
fn the_jumps_are_those_of_a_scan_of_its_own() {
    let (into, out) = loop_of(LENS, 1e-5, 1);
    let right = LENS.jumps_in(1e-5);
    assert_eq!(into.len(), right.len());
    for (jump, right) in into.iter().zip(&right) {
        // Off by half a step the scan misses d″(step/2)²/2, at 2000 steps per wave and ka < 60 less than
        // 1e-5 of the amplitude.
        assert!((jump.before.indentation - right).abs() < 1e-5 * LENS.amplitude, "{jump:?} {right}");
    }
    let most = out[0].before.contact_radius.max(into.last().unwrap().after.unwrap().contact_radius) * 1.2;
    let right: Vec<f64> = LENS.jumps_out(most).into_iter().filter(|&d| d < 1e-5).collect();
    assert_eq!(out.len(), right.len());
    for (jump, right) in out.iter().zip(&right) {
        assert!((jump.before.indentation - right).abs() < 1e-5 * LENS.amplitude, "{jump:?} {right}");
    }
}

/// A fold of a hundredth of a wave, wherever it lies between the places at which the slope is looked at.
#[test]
fn a_small_fold_is_found() {
    for shift in 0..40 {
        let (radius, wavelength, adhesion) = (1.0, 1e-3, 10f64.powf(-1.8) * (1.0 + 2e-3 * f64::from(shift)));
        let amplitude = 10f64.sqrt() * (wavelength / TAU).powi(2) / radius;
        let work = (adhesion * wavelength * wavelength / radius).powi(2) / (TAU * wavelength);
        let lens = Lens { radius, amplitude, wavelength, modulus: 1.0, work };
        let to = wavelength * wavelength / radius;
        let (found, right) = (loop_of(lens, to, 1), lens.jumps_in(to));
        assert_eq!(found.0.len(), right.len(), "{adhesion}");
    }
}

proptest! {
    #![proptest_config(crate::laws::cases(24))]

    /// Any lens: the same jumps and the same loss in one stride as in many.
    #[test]
    fn one_stride_is_as_good_as_many(
        waviness in (-10i32..20).prop_map(|k| 10f64.powf(0.1 * f64::from(k))),
        adhesion in (-20i32..20).prop_map(|k| 10f64.powf(0.1 * f64::from(k))),
        waves in 1i32..25,
        records in 2u32..60,
    ) {
        // hk²R is the waviness; Δl at one wave over λ²/R the adhesion.
        let (radius, wavelength) = (1.0, 1e-3);
        let amplitude = waviness * (wavelength / TAU).powi(2) / radius;
        let work = (adhesion * wavelength * wavelength / radius).powi(2) / (TAU * wavelength);
        let lens = Lens { radius, amplitude, wavelength, modulus: 1.0, work };
        let to = (f64::from(waves) * wavelength).powi(2) / radius;
        let (coarse, fine) = (loop_of(lens, to, 1), loop_of(lens, to, records));
        prop_assert_eq!(coarse.0.len(), fine.0.len());
        prop_assert_eq!(coarse.1.len(), fine.1.len());
        // A loss is a difference of energies, each at rounding.
        let (one, other, stored) = (lost(&coarse), lost(&fine), stored(&fine));
        prop_assert!((one - other).abs() <= 1e-14 * stored, "{one} {other} of {stored}");
        let right = lens.jumps_in(to);
        // Pairs of turning points closer than the steps of the scan are not seen by it.
        prop_assert!(coarse.0.len() >= right.len(), "{} {}", coarse.0.len(), right.len());
        prop_assert!(coarse.0.len() <= right.len() + 1, "{} {}", coarse.0.len(), right.len());
    }
}

fn lens() -> QuasiStatic {
    QuasiStatic::new(EdgeLine::new(Foundation::new(Arc::new(LENS.shape()), LENS.modulus), LENS.work))
}

/// Led by a force and drawn back by the depth it is led back as if the depth had led it there: the waves passed under
/// one are known to the other.
#[test]
fn a_depth_takes_over_from_a_force() {
    let (mut pressed, mut indented) = (lens(), lens());
    pressed.press(5e-3).unwrap();
    indented.indent(pressed.present().balance.indentation).unwrap();
    for depth in [5e-6, 2e-6, 0.0, -2e-6, -3e-6] {
        let (one, other) = (pressed.indent(depth).unwrap(), indented.indent(depth).unwrap());
        let (a, b) = (pressed.present().balance, indented.present().balance);
        assert!((a.contact_radius / b.contact_radius - 1.0).abs() < 1e-9, "{depth}: {a:?} {b:?}");
        assert!(one.len() == other.len() && (a.force / b.force - 1.0).abs() < 1e-9, "{depth}: {a:?} {b:?}");
    }
    assert!((pressed.last_depth().unwrap() / indented.last_depth().unwrap() - 1.0).abs() < 1e-9);
}

/// A dead load that parts the bodies does the work of its pull up to the depth at which a slow retraction would part
/// them, so more is lost than in that retraction.
#[test]
fn a_dead_load_loses_more_than_a_retraction() {
    let mut pulled = lens();
    pulled.press(5e-3).unwrap();
    let before = pulled.dissipated();
    let jumps = pulled.press(-1.0).unwrap();
    let last = *jumps.last().unwrap();
    assert!(last.after.is_none() && jumps.iter().all(|jump| jump.dissipated > 0.0), "{jumps:?}");
    let mut retracted = lens();
    retracted.press(5e-3).unwrap();
    retracted.press(last.before.force * (1.0 - 1e-9)).unwrap();
    let held = retracted.dissipated();
    retracted.indent(-1e-3).unwrap();
    let (dead, slow) = (pulled.dissipated() - before, retracted.dissipated() - before);
    assert!(dead > slow && retracted.dissipated() > held, "{dead:e} {slow:e}");
}

/// Under a force the edge of a lens of rubber jumps from crest to crest, and the bodies part where the last one holds no more,
/// as on an elastic body, which is followed by its equilibria: whatever the accuracy, that is, wherever the pieces of
/// the force end.
#[cfg(feature = "text")]
#[test]
fn a_pull_parts_a_lens_of_rubber_behind_its_last_crest() {
    use springbed::prelude::*;
    let scene = |bodies: &str, edge: &str, accuracy: f64| {
        format!(
            "(shape: WavyParaboloid(radius: 0.02, amplitude: 2e-7, wavelength: 1e-4), bodies: ({bodies}, Rigid), steps: 5,
              adhesion: Jkr(work: 0.05{edge}), accuracy: {accuracy:e}, history: [Press(to: 5e-3, over: 1), Press(to: -7e-3, over: 1)])"
        )
    };
    let pull_off = |text: &str| {
        let plan = Notation::Ron.plan(text, &InMemory::default()).unwrap();
        run(&plan, Wanted::NOTHING).unwrap().number("pull_off_force_n").unwrap()
    };
    let elastic = pull_off(&scene("Elastic(shear: 3e5, poisson: 0.5)", "", 1e-6));
    let rubber = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, terms: [(modulus: 1e-3, time: 0.1)]))";
    for accuracy in [1e-2, 1e-3, 1e-4] {
        let seen = pull_off(&scene(rubber, ", edge: Relaxed", accuracy));
        assert!((seen / elastic - 1.0).abs() < 2.0 * accuracy, "{accuracy:e}: {seen:e} {elastic:e}");
    }
}
