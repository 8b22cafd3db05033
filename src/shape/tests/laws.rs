//! Laws every profile obeys, and each shape against its exact numbers and limits.

use crate::input::quantity::{Amplitude, Length, Positive};
use crate::numerics::quadrature;
use crate::shape::*;
use proptest::prelude::*;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI, TAU};

pub(in crate::shape) fn metres(value: f64) -> Length {
    Length::new(value).unwrap()
}

pub(in crate::shape) fn plain(value: f64) -> Positive {
    Positive::new(value).unwrap()
}

fn sphere(radius: f64) -> Sphere {
    Sphere { radius: metres(radius) }
}

fn paraboloid(radius: f64) -> Paraboloid {
    Paraboloid { radius: metres(radius) }
}

fn power(coefficient: f64, exponent: f64) -> Power {
    Power { coefficient: plain(coefficient), exponent: plain(exponent) }
}

fn truncated_cone(flat_radius: f64, slope: f64) -> TruncatedCone {
    TruncatedCone { flat_radius: metres(flat_radius), slope: plain(slope) }
}

fn truncated_paraboloid(flat_radius: f64, radius: f64) -> TruncatedParaboloid {
    TruncatedParaboloid { flat_radius: metres(flat_radius), radius: metres(radius) }
}

fn rounded_cone(radius: f64, slope: f64) -> RoundedCone {
    RoundedCone { radius: metres(radius), slope: plain(slope) }
}

fn rounded_punch(flat_radius: f64, edge_radius: f64) -> RoundedPunch {
    RoundedPunch { flat_radius: metres(flat_radius), edge_radius: metres(edge_radius) }
}

fn wavy(radius: f64, amplitude: f64, wavelength: f64) -> WavyParaboloid {
    let amplitude = Amplitude::new(amplitude).unwrap();
    WavyParaboloid { radius: metres(radius), amplitude, wavelength: metres(wavelength) }
}

#[track_caller]
fn near(value: f64, exact: f64, bound: f64) {
    assert!((value / exact - 1.0).abs() < bound, "{value:e} instead of {exact:e}: {:e}", value / exact - 1.0);
}

/// A profile with a contact radius, the slope f′(r) and the radii at which f′ or f″ jumps.
struct Specimen {
    profile: Box<dyn Profile>,
    a: f64,
    slope: Box<dyn Fn(f64) -> f64>,
    jumps: Vec<f64>,
}

fn specimen(profile: impl Profile + 'static, a: f64, jumps: &[f64], slope: impl Fn(f64) -> f64 + 'static) -> Specimen {
    Specimen { profile: Box::new(profile), a, slope: Box::new(slope), jumps: jumps.to_vec() }
}

/// One of each, in and out of every kink.
fn specimens() -> Vec<Specimen> {
    let k = TAU / 0.25;
    let mut all = vec![
        specimen(paraboloid(2.0), 0.7, &[], |r| r / 2.0),
        specimen(sphere(1.0), 0.05, &[], |r| r / (1.0 - r * r).sqrt()),
        specimen(sphere(1.0), 0.6, &[], |r| r / (1.0 - r * r).sqrt()),
        specimen(sphere(1.0), 0.9, &[], |r| r / (1.0 - r * r).sqrt()),
        specimen(Cone { slope: plain(0.3) }, 0.7, &[], |_| 0.3),
        specimen(power(0.7, 3.0), 0.7, &[], |r| 2.1 * r * r),
        specimen(power(0.7, 4.0), 0.7, &[], |r| 2.8 * r.powi(3)),
        specimen(power(0.7, 2.0), 1e-3, &[], |r| 1.4 * r),
        specimen(wavy(1.0, 0.001, 0.25), 0.6, &[], move |r| r + 0.001 * k * (k * r).sin()),
        specimen(wavy(1.0, 0.001, 0.25), 3.0, &[], move |r| r + 0.001 * k * (k * r).sin()),
    ];
    for a in [0.3001, 0.31, 0.6, 4.0] {
        all.push(specimen(truncated_cone(0.3, 0.2), a, &[0.3], |r| if r < 0.3 { 0.0 } else { 0.2 }));
        all.push(specimen(truncated_paraboloid(0.3, 1.5), a, &[0.3], |r| if r < 0.3 { 0.0 } else { r / 1.5 }));
        all.push(specimen(rounded_cone(1.5, 0.2), a, &[0.3], |r| r.min(0.3) / 1.5));
        all.push(specimen(rounded_punch(0.3, 1.5), a, &[0.3], |r| (r - 0.3).max(0.0) / 1.5));
    }
    all.push(specimen(rounded_cone(1.5, 0.2), 0.2, &[0.3], |r| r.min(0.3) / 1.5));
    all
}

/// Breaks for quadrature of anything made of g′: the profile's own and those of its jumps.
fn breaks(specimen: &Specimen) -> Vec<f64> {
    let mut breaks = specimen.profile.breaks(specimen.a);
    breaks.sort_by(f64::total_cmp);
    breaks
}

/// ∫₀^a h(x) dx where h may have a root or an inverse root at the kink: x² = b² + q² beyond it.
fn integral(specimen: &Specimen, a: f64, h: impl Fn(f64) -> f64) -> f64 {
    let Some(b) = specimen.profile.kink().filter(|&b| b < a) else {
        return quadrature::panels(h, (0.0, a), &breaks(specimen));
    };
    let end = ((a - b) * (a + b)).sqrt();
    let mut scales: Vec<f64> = (0..8).map(|k| b * 0.1 * 4f64.powi(k)).collect();
    scales.retain(|&q| q < end);
    let beyond = |q: f64| h(b.hypot(q)) * q / b.hypot(q);
    quadrature::panel(&h, 0.0, b * (1.0 - f64::EPSILON)) + quadrature::panels(beyond, (0.0, end), &scales)
}

/// Bound for integrals over g′: the quadrature's own, and what the rounding of x = b + q²/2b does
/// to an inverse root at the first node q₁ = 1.4e-3 q: 2⁻⁵³ b²/(q₁q).
fn resolvable(specimen: &Specimen) -> f64 {
    let beyond = specimen.profile.kink().filter(|&b| b < specimen.a);
    let coarse = beyond.map_or(0.0, |b| b * b / ((specimen.a - b) * (specimen.a + b)));
    2e-12 + 1e-13 * coarse
}

/// 32 nodes leave 1e-14 of an analytic integrand; closed form and quadrature round independently.
const QUADRATURE: f64 = 2e-13;

#[test]
fn reduced_profile_is_the_transform_of_the_slope() {
    for case in specimens() {
        let mut breaks = breaks(&case);
        breaks.extend(&case.jumps);
        breaks.sort_by(f64::total_cmp);
        let integral = reduced_by_integral(&case.slope, case.a, &breaks);
        // f′ of a sphere has its own singularity near the equator.
        near(case.profile.reduced(case.a), integral, QUADRATURE);
    }
}

#[test]
fn height_is_the_inverse_transform() {
    for case in specimens() {
        let integral = height_by_integral(|x| case.profile.reduced(x), case.a, &breaks(&case));
        // Near a flat f is much smaller than the terms it comes from: a − b carries 1e-16·b/(a−b).
        near(case.profile.height(case.a), integral, 2e-12);
    }
}

#[test]
fn load_and_energy_are_the_integrals_of_the_slope() {
    for case in specimens() {
        let (profile, a) = (&case.profile, case.a);
        near(profile.load_integral(a), integral(&case, a, |x| x * profile.reduced_slope(x)), resolvable(&case));
        let energy = |x: f64| 2.0 * profile.reduced_slope(x) * profile.load_integral(x);
        near(profile.energy_integral(a), integral(&case, a, energy), resolvable(&case));
    }
}

#[test]
fn slope_integrates_to_the_profile() {
    for case in specimens() {
        let (profile, a) = (&case.profile, case.a);
        near(profile.reduced(a), integral(&case, a, |x| profile.reduced_slope(x)), resolvable(&case));
    }
}

/// u_z(a) = d − f(a): outside and inside meet at the edge of the contact.
#[test]
fn displacement_is_continuous_at_the_edge() {
    for case in specimens() {
        let (profile, a) = (&case.profile, case.a);
        let inside = profile.reduced(a) - profile.height(a);
        near(profile.displacement_integral(a, a), inside, QUADRATURE);
    }
}

/// Far away the contact is a point force: u_z → (2/π)N/r.
#[test]
fn displacement_far_away_is_that_of_a_point_force() {
    for case in specimens() {
        let (profile, a) = (&case.profile, case.a);
        let r = 1e6 * a;
        near(profile.displacement_integral(r, a), FRAC_2_PI * profile.load_integral(a) / r, 1e-12);
    }
}

/// ∫p dA = F: 2π∫p r dr = 2N in units of E*.
#[test]
fn pressure_adds_up_to_the_force() {
    for case in specimens() {
        let (profile, a) = (&case.profile, case.a);
        // r = a sin θ makes the root at the edge smooth; breaks close in on kinks from both sides.
        let mut angles: Vec<f64> = profile.breaks(a).iter().map(|&x| (x / a).asin()).collect();
        if let Some(b) = profile.kink() {
            angles.extend((1..23).map(|k| b * (1.0 - 4f64.powi(-k))).filter(|&r| r < a).map(|r| (r / a).asin()));
        }
        angles.extend((1..14).map(|k| 8f64.powi(-k)));
        angles.sort_by(f64::total_cmp);
        let ring = |theta: f64| {
            let r = a * theta.sin();
            let pressure = profile.pressure_integral(r, a);
            // A node that falls on the kink itself meets a logarithmic infinity of no weight.
            if pressure.is_finite() { pressure * r * a * theta.cos() } else { 0.0 }
        };
        let force = 2.0 * PI * quadrature::panels(ring, (0.0, FRAC_PI_2), &angles);
        near(force, 2.0 * profile.load_integral(a), 1e-11);
    }
}

#[test]
fn edge_inverts_the_profile() {
    for case in specimens() {
        let (profile, a) = (&case.profile, case.a);
        let found = profile.edge(profile.reduced(a)).unwrap();
        // A relative error ε of d moves a by ε d/(a g′).
        let condition = profile.reduced(a) / (a * profile.reduced_slope(a));
        near(found, a, 4.0 * f64::EPSILON * (1.0 + condition));
    }
}

#[test]
fn exact_numbers() {
    let punch = truncated_cone(0.3, 0.2);
    near(sphere(1.0).reduced(0.6), 0.415_888_308_335_967_2, 1e-15);
    near(2.0 * sphere(1.0).load_integral(0.6), 0.342_680_165_561_525_6, 1e-15);
    near(punch.reduced(0.6), 0.125_663_706_143_591_7, 1e-15);
    near(2.0 * punch.load_integral(0.6), 0.106_575_138_222_394_8, 1e-15);
    near(truncated_paraboloid(0.3, 1.0).reduced(0.6), 0.311_769_145_362_397_9, 1e-15);
    near(2.0 * truncated_paraboloid(0.3, 1.0).load_integral(0.6), 0.280_592_230_826_158_1, 1e-15);
    near(wavy(1.0, 0.01, 0.25).reduced(0.6), 0.418_075_937_086_176_2, 1e-15);
    near(rounded_cone(1.0, 0.3).reduced(0.6), 0.236_726_413_852_989_5, 2e-15);
    for (n, stretch) in [(0.5, 1.311_028_777_146), (2.5, 2.185_047_961_910)] {
        near(power::stretch(n), stretch, 1e-12);
    }
    for (n, stretch) in [(1.0, FRAC_PI_2), (2.0, 2.0), (3.0, 1.5 * FRAC_PI_2), (4.0, 8.0 / 3.0)] {
        near(power::stretch(n), stretch, 1e-15);
    }
}

#[test]
fn stretch_factors_obey_their_recursion() {
    // κₙ κₙ₋₁ = πn/2, across the change to Stirling's series.
    for n in [1.5, 10.0, 149.7, 150.4, 151.0, 1e3, 1e6] {
        near(power::stretch(n) * power::stretch(n - 1.0), FRAC_PI_2 * n, 1e-14);
    }
}

#[test]
fn a_paraboloid_without_waves_is_a_paraboloid_to_the_bit() {
    let (flat, plain) = (wavy(0.7, 0.0, 0.1), paraboloid(0.7));
    for k in -40..40 {
        let (a, r) = (10f64.powf(0.3 * f64::from(k)), 1.1 * 10f64.powf(0.3 * f64::from(k)));
        let all = |p: &dyn Profile| {
            let integrals = (p.pressure_integral(0.3 * a, a), p.displacement_integral(r, a), p.energy_integral(a));
            (p.height(a), p.reduced(a), p.reduced_slope(a), p.load_integral(a), p.edge(a), integrals)
        };
        assert_eq!(all(&flat), all(&plain));
    }
    assert_eq!(flat.first_fall(), None);
    assert_eq!(flat.feature(), None);
}

#[test]
fn waves_break_the_contact_where_the_reduced_slope_first_turns() {
    assert_eq!(wavy(1.0, 1e-4, 0.25).first_fall(), None);
    for (amplitude, wavelength) in [(0.01, 0.25), (0.005, 0.1), (0.02, 0.1), (1.0, 0.01)] {
        let shape = wavy(1.0, amplitude, wavelength);
        let end = shape.first_fall().unwrap();
        let slope = |x: f64| shape.reduced_slope(x * end);
        assert!(slope(1.0 + 1e-9) < 0.0 && slope(1.0 - 1e-9) > 0.0);
        assert!((1..1000).all(|k| slope(f64::from(k) / 1000.0) > 0.0));
    }
}

#[test]
fn truncated_shapes_without_a_flat_are_whole() {
    let (cone, ball) = (Cone { slope: plain(0.2) }, paraboloid(1.5));
    for a in [1e-3, 0.7, 1e4] {
        // g = t x arccos(b/x) = (π/2)tx − tb + …: first order in b/a, so b/a = 1e-17 is the limit.
        let b = 1e-17 * a;
        same(&truncated_cone(b, 0.2), &cone, a);
        same(&truncated_paraboloid(b, 1.5), &ball, a);
        same(&rounded_punch(b, 1.5), &ball, a);
        same(&rounded_cone(b / 0.2, 0.2), &cone, a);
        same(&rounded_cone(1.5, 1e3 * a), &ball, a);
    }
}

#[test]
fn a_power_of_one_is_the_cone_and_of_two_the_paraboloid() {
    for a in [1e-6, 0.7, 1e4] {
        same(&power(0.2, 1.0), &Cone { slope: plain(0.2) }, a);
        same(&power(1.0 / 3.0, 2.0), &paraboloid(1.5), a);
    }
}

#[test]
fn a_large_sphere_is_a_paraboloid() {
    for a in [1e-100_f64, 1e-9, 1.0] {
        // The next term is (a/R)²/3.
        same(&sphere(1e8 * a), &paraboloid(1e8 * a), a);
    }
}

/// Same values at the radius a and about it, to rounding of at most a few operations each.
#[track_caller]
fn same(one: &dyn Profile, other: &dyn Profile, a: f64) {
    near(one.reduced(a), other.reduced(a), 2e-15);
    near(one.reduced_slope(a), other.reduced_slope(a), 2e-15);
    near(one.load_integral(a), other.load_integral(a), 2e-15);
    near(one.height(a), other.height(a), 2e-15);
    near(one.edge(other.reduced(a)).unwrap(), a, 4e-15);
    near(one.displacement_integral(1.3 * a, a), other.displacement_integral(1.3 * a, a), 2e-14);
    near(one.pressure_integral(0.4 * a, a), other.pressure_integral(0.4 * a, a), 2e-14);
    near(one.energy_integral(a), other.energy_integral(a), 2e-14);
}

fn decades(low: i32, high: i32) -> impl Strategy<Value = f64> {
    (50 * low..=50 * high).prop_map(|k| 10f64.powf(0.02 * f64::from(k)))
}

/// The shapes with a kink at b: all lengths in proportion to b.
fn kinked(b: f64, slope: f64) -> [Box<dyn Profile>; 4] {
    let radius = b / slope;
    [
        Box::new(truncated_cone(b, slope)),
        Box::new(truncated_paraboloid(b, radius)),
        Box::new(rounded_punch(b, radius)),
        Box::new(rounded_cone(radius, slope)),
    ]
}

proptest! {
    #![proptest_config(crate::laws::cases(64))]

    /// Scaling of lengths over 12 decades: g as L, N and force as L², E as L³, pressure as 1. Rounding of
    /// a/b at the distance a − b from the kink counts (b/(a − b))-fold.
    #[test]
    fn similar_shapes_have_similar_contacts(b in decades(-9, 3), slope in decades(-6, 0), size in decades(-3, 6)) {
        for (one, unit) in kinked(b, slope).iter().zip(kinked(1.0, slope)) {
            let a = 1.0 + size;
            let bound = 1e-13 + 4.0 * f64::EPSILON / size;
            let (r, outside) = (0.7 * a, 1.3 * a);
            near(one.reduced(b * a), b * unit.reduced(a), bound);
            near(one.load_integral(b * a), b * b * unit.load_integral(a), bound);
            near(one.energy_integral(b * a), b * b * b * unit.energy_integral(a), bound);
            near(one.displacement_integral(b * outside, b * a), b * unit.displacement_integral(outside, a), bound);
            let kinks = (r - 1.0).abs();
            near(one.pressure_integral(b * r, b * a), unit.pressure_integral(r, a), bound + 1e-15 / kinks.max(1e-12));
        }
    }

    /// The surface is continuous at the edge, and the edge is where g reaches d.
    #[test]
    fn edge_and_surface_meet_over_decades(b in decades(-9, 3), slope in decades(-6, 0), size in decades(-10, 8)) {
        for profile in kinked(b, slope) {
            let a = b * (1.0 + size);
            let (g, f) = (profile.reduced(a), profile.height(a));
            near(profile.displacement_integral(a, a), g - f, 1e-12 + 4.0 * f64::EPSILON / size);
            let found = profile.edge(g).unwrap();
            let condition = g / (a * profile.reduced_slope(a));
            near(found, a, 8.0 * f64::EPSILON * (1.0 + condition));
        }
    }

    /// Sphere over 15 decades of a/R against its power series, F = E*R² Σ 4k/(4k²−1) s^{2k+1}.
    #[test]
    fn spheres_follow_their_series(radius in decades(-9, 3), s in decades(-15, -1)) {
        let a = s * radius;
        let series = |k: i32| 4.0 * f64::from(k) / (4.0 * f64::from(k * k) - 1.0) * s.powi(2 * (k - 1));
        let sum: f64 = (1..12).rev().map(series).sum();
        near(2.0 * sphere(radius).load_integral(a) / (radius * radius * s), sum * s * s, 1e-14);
        near(sphere(radius).edge(sphere(radius).reduced(a)).unwrap(), a, 4e-15);
    }
}
