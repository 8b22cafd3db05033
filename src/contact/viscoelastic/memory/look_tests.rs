//! Looks at a bed of many panels.

use super::super::laws::unit_ball;
use super::*;
use crate::material::Relaxation;

/// A bed led through `count` pieces of alternating speed, each with panels of its own: pressed, and drawn back a little.
fn led(attraction: fn(&Spectrum) -> Option<Attraction>, count: u32) -> Memory {
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
    let laws: [fn(&Spectrum) -> Option<Attraction>; 4] = [
        |_| None,
        |spectrum| Some(Attraction::relaxed(1e-5, spectrum)),
        |spectrum| Some(Attraction::relaxed(1e-5, spectrum).closing(2e-6)),
        |spectrum| Some(Attraction::instantaneous(1e-5, spectrum)),
    ];
    for law in laws {
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
