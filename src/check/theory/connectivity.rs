//! Whether the contact of a rough parabola with an elastic half-plane is in one piece.

use crate::physics::root::{self, RootError};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// A parabola x²/2R with a deviation φ(x) from it, pressed on an elastic half-plane by a load per width.
///
/// The gap before loading is x²/2R + φ(x) (Kudish et al., sections 1 and 2, in their dimensional form; their E′ = E*).
/// φ must be three times differentiable. Plane strain, small slopes, no friction, no adhesion.
pub struct WavyParabola<'a> {
    /// Effective modulus E* [Pa].
    pub modulus: f64,
    /// Radius of curvature R [m] of the parabola.
    pub radius: f64,
    /// Slope φ′(x) of the deviation.
    pub slope: &'a (dyn Fn(f64) -> f64 + Sync),
}

/// Why no contact was found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ConnectivityError {
    /// The deviation is too rough for the Chebyshev series.
    #[error(
        "slope of the roughness is not resolved by {terms} Chebyshev terms over the contact of half width {half_width:e} m: it has kinks or too short waves"
    )]
    NotResolved {
        /// Terms tried.
        terms: usize,
        /// Half width of the contact [m].
        half_width: f64,
    },
    /// No half width carries the load, or no centre balances the contact.
    #[error("no contact in one piece carries this load: {0}")]
    NoContact(#[from] RootError),
}

/// A contact in one piece of half width c about a centre m; x = m + c u.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneContact {
    /// Centre m [m]; the end points are m ± c (Kudish et al. 2.14).
    pub centre: f64,
    /// Half width c [m].
    pub half_width: f64,
    /// Load per width P [N/m].
    pub load: f64,
    /// E*/2 [Pa] and c/R, the scale of the pressure and the share of the parabola.
    scale: (f64, f64),
    /// ξ_k, Chebyshev coefficients of φ′(m + c u).
    series: Vec<f64>,
}

impl WavyParabola<'_> {
    /// The contact of a given half width [m]: m/R + ξ₀ = 0 and P = (πE*c/4)(c/R + ξ₁) (Kudish et al. 2.13).
    ///
    /// # Errors
    /// The roughness is not resolved; no centre balances the contact.
    pub fn of_half_width(&self, half_width: f64) -> Result<PlaneContact, ConnectivityError> {
        let terms = self.terms(half_width)?;
        let balance = |m: f64| m / self.radius + chebyshev(|u| (self.slope)(m + half_width * u), 1, terms)[0];
        let reach = self.radius * self.steepest(half_width) + f64::MIN_POSITIVE;
        let centre = root::brent(balance, -reach, reach)?;
        let series = chebyshev(|u| (self.slope)(centre + half_width * u), terms, terms);
        let parabola = half_width / self.radius;
        let load = FRAC_PI_4 * self.modulus * half_width * (parabola + series[1]);
        Ok(PlaneContact { centre, half_width, load, scale: (0.5 * self.modulus, parabola), series })
    }

    /// The contact under a load per width [N/m].
    ///
    /// # Errors
    /// The roughness is not resolved; no contact in one piece carries the load.
    pub fn under(&self, load: f64) -> Result<PlaneContact, ConnectivityError> {
        let hertz = self.hertz_half_width(load);
        let excess = |c: f64| self.of_half_width(c).map_or(f64::NAN, |contact| contact.load - load);
        // |ξ₁| ≤ (4/π) max|φ′|, so the half width is within a known distance of Hertz's.
        let spread = 2.0 * self.radius * self.steepest(2.0 * hertz);
        let (low, high) = ((hertz - spread).max(1e-3 * hertz), hertz + spread + 1e-9 * hertz);
        let half_width = root::brent(excess, low, high)?;
        self.of_half_width(half_width)
    }

    /// The least load per width [N/m] in a range, out of `steps` loads evenly spaced in the logarithm and then refined, at which `holds`
    /// is true of the contact; `None` if it is nowhere true.
    ///
    /// With [`PlaneContact::surely_connected`] this is the least load of the sufficient condition. For waves of fixed length that
    /// condition fails again at large loads, as more waves enter the contact; the true one does not.
    pub fn least_load(&self, (from, to): (f64, f64), steps: u32, holds: impl Fn(&PlaneContact) -> bool) -> Option<f64> {
        let at = |load: f64| self.under(load).is_ok_and(|contact| holds(&contact));
        let step = (to / from).powf(1.0 / f64::from(steps.max(1)));
        let first = (0..=steps).map(|k| from * step.powf(f64::from(k))).find(|&load| at(load))?;
        let (mut fails, mut holds_at) = (first / step, first);
        for _ in 0..40 {
            let middle = (fails * holds_at).sqrt();
            if at(middle) {
                holds_at = middle;
            } else {
                fails = middle;
            }
        }
        Some(holds_at)
    }

    /// Half width of Hertz' line contact, c² = 4PR/(πE*).
    fn hertz_half_width(&self, load: f64) -> f64 {
        2.0 * (load * self.radius / (PI * self.modulus)).sqrt()
    }

    /// Upper estimate of |φ′| over three half widths on either side.
    fn steepest(&self, half_width: f64) -> f64 {
        let at = |k: i32| (self.slope)(3.0 * half_width * f64::from(k) / 2048.0).abs();
        1.1 * (-2048..=2048).map(at).fold(0.0, f64::max)
    }

    /// Terms that resolve the slope over a contact about the origin.
    fn terms(&self, half_width: f64) -> Result<usize, ConnectivityError> {
        let mut terms = 32;
        while terms <= MOST_TERMS {
            let series = chebyshev(|u| (self.slope)(half_width * u), terms, terms);
            let largest = series.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            if series[3 * terms / 4..].iter().all(|x| x.abs() <= 1e-13 * largest) {
                return Ok(terms);
            }
            terms *= 2;
        }
        Err(ConnectivityError::NotResolved { terms: MOST_TERMS, half_width })
    }
}

const MOST_TERMS: usize = 2048;

impl PlaneContact {
    /// Pressure [Pa] at x [m], p = (E*/2)√(1−u²)[c/R + Σ_{k≥1} ξ_k U_{k−1}(u)] (Kudish et al. 2.12); zero outside.
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        let u = (x - self.centre) / self.half_width;
        if u.abs() >= 1.0 { 0.0 } else { self.scale.0 * (1.0 - u * u).sqrt() * self.bracket(u.acos()) }
    }

    /// c/R + Σ_{k≥1} ξ_k sin(kθ)/sin θ, u = cos θ.
    fn bracket(&self, theta: f64) -> f64 {
        let cosine = theta.cos();
        let (mut here, mut before) = (0.0, 0.0);
        for &xi in self.series.iter().skip(1).rev() {
            (here, before) = (xi + 2.0 * cosine * here - before, here);
        }
        self.scale.1 + here
    }

    /// Slope of the gap outside the contact at x [m]: (x/R + φ′)(x) − Σ over all terms of ξ_k (|u| − √(u²−1))^k, signed.
    ///
    /// `roughness` is φ′(x). Zero or of the wrong sign at the edge where the true contact reaches further.
    #[must_use]
    pub fn gap_slope(&self, x: f64, roughness: f64) -> f64 {
        let u = (x - self.centre) / self.half_width;
        if u.abs() <= 1.0 {
            return 0.0;
        }
        let fall = u.signum() / (u.abs() + (u * u - 1.0).sqrt());
        let mut series = 0.0;
        for &xi in self.series.iter().skip(1).rev() {
            series = fall * (xi + series);
        }
        let parabola = self.scale.1 * (u - fall) - self.series[0];
        parabola + roughness - series
    }

    /// Left side of the sufficient condition over its right side, (ξ₁ + Σ k|ξ_k|) πE*c/(4P); below 1 the contact is in one piece.
    ///
    /// This is ω(ξ₁ + Σ k|ξ_k|)/2 of Kudish et al. 2.18, sufficient, not necessary.
    #[must_use]
    pub fn roughness_measure(&self) -> f64 {
        let weighted: f64 = (0u32..).zip(&self.series).map(|(k, xi)| f64::from(k) * xi.abs()).sum();
        (self.series[1] + weighted) / (self.scale.1 + self.series[1])
    }

    /// Whether the sufficient condition holds.
    #[must_use]
    pub fn surely_connected(&self) -> bool {
        self.scale.1 + self.series[1] > 0.0 && self.roughness_measure() < 1.0
    }

    /// Whether the pressure of the one-piece solution is positive everywhere inside: exact but for contact outside the ends.
    #[must_use]
    pub fn presses_everywhere(&self) -> bool {
        let steps = u32::try_from(8 * self.series.len()).unwrap_or(u32::MAX);
        (0..=steps).all(|j| self.bracket(PI * f64::from(j) / f64::from(steps)) > 0.0)
    }

    /// The coefficients ξ_k of φ′ over the contact.
    #[must_use]
    pub fn series(&self) -> &[f64] {
        &self.series
    }
}

/// First `count` Chebyshev coefficients of a function on [−1, 1] from `nodes` nodes; exact for polynomials of lower degree.
fn chebyshev(f: impl Fn(f64) -> f64, count: usize, nodes: usize) -> Vec<f64> {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand nodes")]
    let n = nodes as f64;
    #[expect(clippy::cast_precision_loss, reason = "indices below 8 times the nodes")]
    let cosine = |index: usize| (FRAC_PI_2 * (index % (4 * nodes)) as f64 / n).cos();
    let table: Vec<_> = (0..4 * nodes).map(cosine).collect();
    let values: Vec<_> = (0..nodes).map(|j| f(table[2 * j + 1])).collect();
    let coefficient = |k: usize| {
        let sum: f64 = values.iter().enumerate().map(|(j, v)| v * table[k * (2 * j + 1) % (4 * nodes)]).sum();
        sum * (if k == 0 { 1.0 } else { 2.0 }) / n
    };
    (0..count).map(coefficient).collect()
}

/// Least load per width that flattens one harmonic φ′ = A T_k(x/b) on a parabola, P = k²A²πE*R/4 [N/m] for small A (Kudish et al. 2.23).
///
/// A is a slope, k odd and above 1. Equality with the exact condition for A < 0, where the ends of the contact are the last to press.
#[must_use]
pub fn single_harmonic_load(harmonic: u32, slope: f64, (modulus, radius): (f64, f64)) -> f64 {
    FRAC_PI_4 * (f64::from(harmonic) * slope).powi(2) * modulus * radius
}

/// Least load per width that flattens φ = A T_k(x/a) under a flat punch of half width a, P = k|A|πE*/2 [N/m] (Kudish et al. 2.24).
///
/// A is a height [m]; the half width does not enter. Here the condition is exact: p√(a²−x²) = P/π − (kE*A/2) cos(kθ).
#[must_use]
pub fn flat_punch_load(harmonic: u32, height: f64, modulus: f64) -> f64 {
    FRAC_PI_2 * f64::from(harmonic) * height.abs() * modulus
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODULUS: f64 = 1e7;
    const RADIUS: f64 = 0.1;

    fn wavy(slope: &(dyn Fn(f64) -> f64 + Sync)) -> WavyParabola<'_> {
        WavyParabola { modulus: MODULUS, radius: RADIUS, slope }
    }

    /// Without roughness: Hertz' line contact c² = 4PR/(πE*), p₀ = E*c/2R.
    #[test]
    fn a_smooth_parabola_is_hertz() {
        let contact = wavy(&|_| 0.0).under(100.0).unwrap();
        let c = (4.0 * 100.0 * RADIUS / (PI * MODULUS)).sqrt();
        assert!((contact.half_width / c - 1.0).abs() < 1e-14);
        assert!((contact.pressure(0.0) / (0.5 * MODULUS * c / RADIUS) - 1.0).abs() < 1e-14);
        assert!(contact.surely_connected() && contact.presses_everywhere() && contact.roughness_measure() <= 0.0);
    }

    /// The pressure bends the half-plane to the slope of the indenter: x/R + φ′ = (2/πE*) PV∫ p dt/(x − t). The integral is
    /// taken by the mid-point rule in θ, t = cos θ, read half-way between its nodes, which is exact for trigonometric
    /// polynomials: nothing here uses the series.
    #[test]
    fn the_pressure_bends_the_half_plane_to_the_indenter() {
        let slope = |x: f64| 2e-3 * (x / 4e-4 + 0.3).sin() + 1e-3 * (x / 1e-4).cos();
        let rough = wavy(&slope);
        let contact = rough.under(200.0).unwrap();
        let (m, c, n) = (contact.centre, contact.half_width, 400);
        let angle = |j: f64| PI * j / f64::from(n);
        for i in 1..n {
            let x = m + c * angle(f64::from(i)).cos();
            let sum: f64 = (0..n)
                .map(|j| {
                    let theta = angle(f64::from(j) + 0.5);
                    let t = m + c * theta.cos();
                    contact.pressure(t) * theta.sin() * c / (x - t)
                })
                .sum();
            let bent = 2.0 / (PI * MODULUS) * sum * PI / f64::from(n);
            let wanted = x / RADIUS + slope(x);
            assert!((bent - wanted).abs() < 1e-11, "{x}: {bent} {wanted}");
        }
        let load: f64 = (0..n)
            .map(|j| contact.pressure(m + c * angle(f64::from(j) + 0.5).cos()) * angle(f64::from(j) + 0.5).sin())
            .sum();
        assert!((load * c * PI / f64::from(n) / 200.0 - 1.0).abs() < 1e-12);
    }

    /// The gap opens as the square of the distance from the end, and far away it is the bare shape less P/x.
    #[test]
    fn the_gap_opens_outside() {
        let slope = |x: f64| 1e-3 * (x / 4e-4 + 0.3).sin();
        let contact = wavy(&slope).under(200.0).unwrap();
        let end = contact.centre + contact.half_width;
        assert!(contact.gap_slope(end * 1.000_001, slope(end * 1.000_001)) > 0.0);
        let far = 1e3 * end;
        let bare = far / RADIUS + slope(far) - 2.0 * 200.0 / (PI * MODULUS * (far - contact.centre));
        // The next term of the multipole series is (c/x)² smaller.
        assert!((contact.gap_slope(far, slope(far)) - bare).abs() < 1e-5 * 2.0 * 200.0 / (PI * MODULUS * far));
        assert!(contact.gap_slope(-end * 1.01 + 2.0 * contact.centre, slope(-end)) < 0.0);
    }

    /// φ′ = A T₅(x/b) fixed to the contact: the ends press last if A < 0, and the sufficient condition is the exact one.
    #[test]
    fn a_single_harmonic_has_its_closed_least_load() {
        let (k, slope) = (5, -1e-3);
        let least = single_harmonic_load(k, slope, (MODULUS, RADIUS));
        for (factor, whole) in [(0.999, false), (1.001, true)] {
            let b = (4.0 * factor * least * RADIUS / (PI * MODULUS)).sqrt();
            let harmonic = |x: f64| slope * (5.0 * (x / b).clamp(-1.0, 1.0).acos()).cos();
            let contact = wavy(&harmonic).of_half_width(b).unwrap();
            assert_eq!((contact.surely_connected(), contact.presses_everywhere()), (whole, whole), "{factor}");
            assert!((contact.load / (factor * least) - 1.0).abs() < 1e-12);
        }
    }

    /// The sufficient condition is never true where the exact one is false.
    #[test]
    fn the_sufficient_condition_is_safe() {
        for j in 1..60 {
            let amplitude = 1e-4 * f64::from(j);
            let slope = move |x: f64| amplitude * (x / 2e-4 + 0.1 * f64::from(j)).sin();
            let contact = wavy(&slope).of_half_width(8e-4).unwrap();
            assert!(!contact.surely_connected() || contact.presses_everywhere(), "{j}");
        }
    }

    #[test]
    fn the_least_load_is_where_the_verdict_changes() {
        let slope = |x: f64| 4e-4 * (x / 2e-4).sin();
        let rough = wavy(&slope);
        let sure = rough.least_load((1.0, 1e4), 60, PlaneContact::surely_connected).unwrap();
        let exact = rough.least_load((1.0, 1e4), 60, PlaneContact::presses_everywhere).unwrap();
        assert!(exact <= sure, "{exact} {sure}");
        assert!(rough.under(1.0001 * sure).unwrap().surely_connected());
        assert!(rough.under(1.0001 * exact).unwrap().presses_everywhere());
    }

    #[test]
    fn kinks_are_refused() {
        let error = wavy(&|x: f64| 1e-3 * (x - 1e-4).signum()).under(10.0).unwrap_err();
        assert!(matches!(error, ConnectivityError::NotResolved { .. } | ConnectivityError::NoContact(_)), "{error}");
    }

    /// Flat punch: p√(a²−x²) = P/π − (kE*A/2) cos kθ touches zero at P = k|A|πE*/2. The seal of the paper: E 9 MPa, ν 0.4,
    /// A = Rt/2 = 0.2 µm, k = 297: E* = 10.714 MPa, P = 999.7 N/m; k = 5 needs 16.8 N/m.
    #[test]
    fn the_flat_seal_needs_its_load() {
        let modulus = 9e6 / (1.0 - 0.4 * 0.4);
        assert!((flat_punch_load(297, 0.2e-6, modulus) - 999.7).abs() < 0.05);
        assert!((flat_punch_load(5, 0.2e-6, modulus) - 16.83).abs() < 0.005);
    }
}
