//! Looks at a bed of many panels.

use super::super::laws::unit_ball;
use super::*;
use crate::material::Relaxation;

type Law = fn(&Spectrum) -> Option<Attraction>;

/// What may hold an edge.
const LAWS: [Law; 4] = [
    |_| None,
    |spectrum| Some(Attraction::relaxed(1e-5, spectrum)),
    |spectrum| Some(Attraction::relaxed(1e-5, spectrum).closing(2e-6)),
    |spectrum| Some(Attraction::instantaneous(1e-5, spectrum)),
];

/// A bed led through `count` pieces of alternating speed, each with panels of its own: pressed, and drawn back a little.
fn led(attraction: Law, count: u32) -> Memory {
    let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(2.0, 0.1), (0.5, 3.0)], viscosity: 0.0 };
    let spectrum = Arc::new(Spectrum::new(&relaxation));
    let mut bed = Memory::new(spectrum.clone(), Arc::new(unit_ball()));
    bed.attraction = attraction(&spectrum);
    let pieces = [(1.0, count), (-0.3, count / 2)];
    for (way, k) in pieces.into_iter().flat_map(|(way, count)| (0..count).map(move |k| (way, k))) {
        let speed = way * 0.02 * (1.0 + 0.3 * f64::from(k % 7));
        bed.advance(speed, 1.0 / f64::from(count)).unwrap();
    }
    bed
}

/// A look sees what the bed comes to, however many panels it passes: none, a few, all of them as the bodies part, or those
/// let go before as it closes again. Bound: rounding of sums of as many panels.
#[test]
fn a_look_sees_what_the_bed_comes_to() {
    for law in LAWS {
        let bed = led(law, 240);
        assert!(bed.panels.len() > 4 * NEAR, "{}", bed.panels.len());
        let (force, radius) = (bed.force().abs(), bed.radius());
        for (way, duration) in [(1e-7, 1e-3), (-1e-6, 1e-3), (-1e-3, 0.1), (2e-2, 1.0), (-1e-2, 3.0), (-0.1, 1e-6)] {
            let (seen, seen_radius) = bed.force_after(way / duration, duration).unwrap();
            let come = bed.after(way / duration, duration).unwrap();
            assert!((seen - come.force()).abs() < 1e-11 * force, "{way}: {seen:e} {:e}", come.force());
            assert!((seen_radius - come.radius()).abs() < 1e-10 * radius, "{way}: {seen_radius:e} {:e}", come.radius());
        }
    }
}

/// Led in pieces whose speeds differ by little, as they do where a force is followed, the bed keeps few panels and what it
/// comes to: pressed, drawn back a little, pressed again and drawn off. Speeds differ by a few millionths. Bounds: a corner of
/// 3e-8 of the loads, 3e-2 N/m over 0.1 m, does 2e-10 N to the force and, as the load at the edge falls by about 1 N/m per metre,
/// 1e-9 m to the radius; of as many corners as there are pieces fifty to a hundred may add up.
#[test]
fn corners_of_small_pieces_leave_no_trace() {
    const BOUND: f64 = 1e-6;
    for law in LAWS {
        let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(2.0, 0.1), (0.5, 3.0)], viscosity: 0.0 };
        let spectrum = Arc::new(Spectrum::new(&relaxation));
        let mut exact = Memory::new(spectrum.clone(), Arc::new(unit_ball()));
        exact.attraction = law(&spectrum);
        let mut rounded = exact.clone().in_pieces(BOUND);
        let mut most = 0;
        for (way, count) in [(0.01, 300), (-0.004, 200), (0.002, 100), (-0.02, 300)] {
            for k in 0..count {
                let speed = way * (1.0 + 1e-6 * f64::from(k % 7));
                for bed in [&mut exact, &mut rounded] {
                    bed.advance(speed, 1.0 / f64::from(count)).unwrap();
                }
                most = most.max(exact.panels.len());
                assert!((rounded.force() - exact.force()).abs() < BOUND * 1e-2, "{way} {k}: {:e}", exact.force());
                assert!((rounded.radius() - exact.radius()).abs() < BOUND * 0.1, "{way} {k}: {:e}", exact.radius());
            }
            assert!(rounded.panels.len() < 30, "{way}: {}", rounded.panels.len());
        }
        assert!(most > 200, "{most}");
        let (one, two) = (rounded.ledger(), exact.ledger());
        assert!((one.dissipated - two.dissipated).abs() < BOUND * 1e-4, "{:e} {:e}", one.dissipated, two.dissipated);
    }
}
