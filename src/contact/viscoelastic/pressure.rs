//! Pressure from the line loads of any bed.

use crate::numerics::quadrature;
use std::f64::consts::FRAC_1_PI;

/// p(r) = (1/π) ∫_r^a (−q′) dx/√(x²−r²) + q(a)/(π√(a²−r²)) [Pa] (Popov & Heß 2015, eq. 3.37).
///
/// By parts, so that only q itself is needed: with x² = r² + s²,
/// π p(r) = q(r)/√(a²−r²) + ∫ (q(r) − q(x))/s² ds. `load` is q(x) [N/m]; `ends` are the borders of
/// panels on which q is smooth, the last of them the contact radius a [m]. Zero outside.
pub fn inverse(load: &impl Fn(f64) -> f64, ends: &[f64], r: f64) -> f64 {
    let Some(&a) = ends.last() else { return 0.0 };
    if r >= a {
        return 0.0;
    }
    let here = load(r);
    let to_s = |x: f64| ((x - r) * (x + r)).sqrt();
    let breaks: Vec<f64> = ends.iter().filter(|&&x| x > r && x < a).map(|&x| to_s(x)).collect();
    let fall = |s: f64| (here - load(r.hypot(s))) / (s * s);
    FRAC_1_PI * (here / to_s(a) + quadrature::panels(fall, (0.0, to_s(a)), &breaks))
}
