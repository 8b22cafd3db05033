//! Where the mapping of an axisymmetric profile is exact.

use crate::shape::Profile;

/// A range of contact radii in which the contact is one full circle and the mapping exact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExactRange {
    /// Contact radii [m] from and to.
    pub radius: (f64, f64),
    /// Indentations g(a) [m] at the two ends.
    pub indentation: (f64, f64),
    /// Load integrals N(a) [m²] at the two ends; the force is 2E*N.
    pub load_integral: (f64, f64),
}

/// Ranges of contact radii up to `limit` [m] in which a full circle of contact without adhesion is the true solution.
///
/// True means: pressure (E*/π)∫_r^a g′ dx/√(x²−r²) ≥ 0 at every r inside, and gap (2/π)∫_a^r (g − d) dx/√(r²−x²) ≥ 0 outside, for which
/// g > g(a) beyond a is sufficient and is what is asked here. Checked on `steps` radii; the ends are to limit/steps.
#[must_use]
pub fn exact_ranges(profile: &dyn Profile, limit: f64, steps: u32) -> Vec<ExactRange> {
    let steps = steps.max(2);
    let place = |k: u32| limit * f64::from(k) / f64::from(steps);
    let depths: Vec<f64> = (0..=steps).map(|k| profile.reduced(place(k))).collect();
    let mut lowest_beyond = f64::INFINITY;
    let mut exact = vec![false; depths.len()];
    for k in (1..=steps).rev() {
        let at = k as usize;
        exact[at] = depths[at] <= lowest_beyond && presses(profile, place(k));
        lowest_beyond = lowest_beyond.min(depths[at]);
    }
    let range = |(first, last): (u32, u32)| {
        let (a, b) = (place(first), place(last));
        ExactRange {
            radius: (a, b),
            indentation: (depths[first as usize], depths[last as usize]),
            load_integral: (profile.load_integral(a), profile.load_integral(b)),
        }
    };
    runs(&exact).into_iter().map(range).collect()
}

/// Whether the pressure of a contact of this radius is nowhere negative, at so many places.
fn presses(profile: &dyn Profile, radius: f64) -> bool {
    const PLACES: u32 = 64;
    let inside = |k: u32| radius * (f64::from(k) + 0.5) / f64::from(PLACES);
    (0..PLACES).all(|k| profile.pressure_integral(inside(k), radius) >= 0.0)
}

/// First and last index of every run of true.
fn runs(flags: &[bool]) -> Vec<(u32, u32)> {
    let mut found: Vec<(u32, u32)> = Vec::new();
    for (k, _) in (0u32..).zip(flags).filter(|(_, flag)| **flag) {
        match found.last_mut() {
            Some(run) if run.1 + 1 == k => run.1 = k,
            _ => found.push((k, k)),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{quadrature, root};

    /// x²/R with a wave of slope: g′ = 2x/R + A sin(κx), which is what a waviness gives but for its phase.
    #[derive(Debug)]
    struct Wavy {
        amplitude: f64,
    }

    impl Profile for Wavy {
        fn height(&self, r: f64) -> f64 {
            crate::shape::height_by_integral(|x| self.reduced(x), r, &[])
        }
        fn reduced(&self, x: f64) -> f64 {
            x * x + self.amplitude * (1.0 - (20.0 * x).cos()) / 20.0
        }
        fn reduced_slope(&self, x: f64) -> f64 {
            2.0 * x + self.amplitude * (20.0 * x).sin()
        }
        fn load_integral(&self, a: f64) -> f64 {
            let breaks: Vec<_> = (1..8).map(|k| a * f64::from(k) / 8.0).collect();
            quadrature::panels(|x| x * self.reduced_slope(x), (0.0, a), &breaks)
        }
        fn scale(&self) -> f64 {
            1.0
        }
    }

    #[test]
    fn a_rising_profile_is_exact_throughout() {
        let gentle = Wavy { amplitude: 0.05 };
        let ranges = exact_ranges(&gentle, 1.0, 200);
        assert_eq!(ranges.len(), 1);
        assert!((ranges[0].radius.1 - 1.0).abs() < 1e-15);
    }

    /// g′ first vanishes past π/20 where the sine turns negative: 2x = −A sin 20x.
    #[test]
    fn a_wave_splits_the_range_at_its_first_fall() {
        let wavy = Wavy { amplitude: 1.0 };
        let fall = root::brent(|x| wavy.reduced_slope(x), 0.1, 0.2).unwrap();
        assert!(fall > std::f64::consts::PI / 20.0 && wavy.reduced_slope(fall).abs() < 1e-12);
        let ranges = exact_ranges(&wavy, 1.0, 400);
        assert!(ranges.len() > 1, "{ranges:?}");
        // A full circle at radius a needs g below g(a) nowhere outside: the first range ends before the fall.
        assert!(ranges[0].radius.1 < fall);
        for pair in ranges.windows(2) {
            assert!(pair[1].load_integral.0 > pair[0].load_integral.1);
        }
    }
}
