//! Whether the contact of a rough parabola with an elastic half-plane is in one piece.

use crate::contact::error::ConnectivityError;
use crate::numerics::root;
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

/// Whether a contact is in one piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Connection {
    /// In one piece, and the sufficient condition of Kudish et al. 2.18 says so.
    Sure,
    /// In one piece by the pressure and the gap themselves; the sufficient condition is too strict to tell.
    InOnePiece,
    /// Not in one piece: pressure would be negative somewhere inside.
    OpensInside,
    /// Not in one piece: the roughness touches beyond the ends.
    TouchesOutside,
}

impl Connection {
    /// Whether the contact is in one piece.
    #[must_use]
    pub fn in_one_piece(self) -> bool {
        matches!(self, Self::Sure | Self::InOnePiece)
    }
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
    /// The contact of a given half width [m] on a convex profile: m/R + ξ₀ = 0 and P = (πE*c/4)(c/R + ξ₁) (Kudish et al. 2.13).
    ///
    /// On a profile that is not convex one of several centres.
    ///
    /// # Errors
    /// The roughness is not resolved; no centre balances the contact.
    pub fn of_half_width(&self, half_width: f64) -> Result<PlaneContact, ConnectivityError> {
        let reach = self.radius * self.steepest(half_width) + f64::MIN_POSITIVE;
        self.balanced(half_width, (-reach, reach), &self.resolving(half_width)?)
    }

    /// The contact of a half width whose centre lies in a window.
    fn balanced(
        &self,
        half_width: f64,
        (from, to): (f64, f64),
        cosines: &Cosines,
    ) -> Result<PlaneContact, ConnectivityError> {
        let centre = root::brent(|m| self.imbalance(m, half_width, cosines), from, to)?;
        let series = cosines.series(|u| (self.slope)(centre + half_width * u));
        let parabola = half_width / self.radius;
        let load = FRAC_PI_4 * self.modulus * half_width * (parabola + series[1]);
        Ok(PlaneContact { centre, half_width, load, scale: (0.5 * self.modulus, parabola), series })
    }

    /// m/R + ξ₀, the mean slope under a contact about m weighted by 1/√(1−u²).
    fn imbalance(&self, m: f64, half_width: f64, cosines: &Cosines) -> f64 {
        m / self.radius + cosines.mean(|u| (self.slope)(m + half_width * u))
    }

    /// All contacts found that carry a load per width [N/m] and are balanced, whether they press everywhere or not.
    ///
    /// At most one of them has positive pressure inside and an open gap outside; it is then the solution.
    ///
    /// # Errors
    /// The roughness is not resolved.
    pub fn candidates(&self, load: f64) -> Result<Vec<PlaneContact>, ConnectivityError> {
        let hertz = 2.0 * (load * self.radius / (PI * self.modulus)).sqrt();
        let steep = self.radius * self.steepest(2.0 * hertz);
        // |ξ₁| ≤ (4/π) max|φ′|, so the half width is within a known distance of Hertz's; it may be far smaller on a crest.
        let (low, high) = (1e-2 * hertz, (hertz + 1.3 * steep) * (1.0 + 1e-9));
        let cosines = self.resolving(high)?;
        let window = steep * (1.0 + 1e-9) + f64::MIN_POSITIVE;
        let (mut found, mut before): (Vec<PlaneContact>, Vec<PlaneContact>) = (Vec::new(), Vec::new());
        for k in 0..=WIDTHS {
            let c = low * (high / low).powf(f64::from(k) / f64::from(WIDTHS));
            let here = self.balanced_in(c, window, &cosines);
            for contact in &here {
                let nearest = before.iter().min_by(|a, b| contact.away(a).total_cmp(&contact.away(b)));
                found.extend(nearest.and_then(|other| self.between([other, contact], load, &cosines)));
            }
            before = here;
        }
        Ok(found)
    }

    /// Every balanced contact of a half width with its centre within a window about the origin.
    fn balanced_in(&self, half_width: f64, window: f64, cosines: &Cosines) -> Vec<PlaneContact> {
        let place = |k: i32| window * f64::from(k) / f64::from(CENTRES);
        let values: Vec<_> = (-CENTRES..=CENTRES).map(|k| self.imbalance(place(k), half_width, cosines)).collect();
        let changes = values.windows(2).zip(-CENTRES..).filter(|(v, _)| v[0] <= 0.0 && v[1] > 0.0);
        changes.filter_map(|(_, k)| self.balanced(half_width, (place(k), place(k + 1)), cosines).ok()).collect()
    }

    /// The contact with exactly the load between two of neighbouring half widths on one branch, if it lies between them.
    fn between(&self, [a, b]: [&PlaneContact; 2], load: f64, cosines: &Cosines) -> Option<PlaneContact> {
        if (a.load - load) * (b.load - load) > 0.0 {
            return None;
        }
        let margin = a.away(b) + 1e-3 * b.half_width;
        let window = (a.centre.min(b.centre) - margin, a.centre.max(b.centre) + margin);
        let at = |c: f64| self.balanced(c, window, cosines);
        let excess = |c: f64| at(c).map_or(f64::NAN, |contact| contact.load - load);
        at(root::brent(excess, a.half_width, b.half_width).ok()?).ok()
    }

    /// The contact of a symmetric profile under a load per width [N/m] if it is in one piece; its centre is the origin.
    ///
    /// # Errors
    /// The roughness is not resolved.
    pub fn symmetric(&self, load: f64) -> Result<Option<PlaneContact>, ConnectivityError> {
        let hertz = 2.0 * (load * self.radius / (PI * self.modulus)).sqrt();
        let (low, high) = (1e-3 * hertz, (hertz + 1.3 * self.radius * self.steepest(2.0 * hertz)) * (1.0 + 1e-9));
        let cosines = self.resolving(high)?;
        let widths = (0..=SYMMETRIC).map(|k| low * (high / low).powf(f64::from(k) / f64::from(SYMMETRIC)));
        let excess = |c: f64| self.centred_load(c, &cosines) - load;
        let loads: Vec<_> = widths.map(|c| (c, excess(c))).collect();
        let crossings = loads.windows(2).filter(|pair| pair[0].1 <= 0.0 && pair[1].1 > 0.0);
        let roots = crossings.filter_map(|pair| root::brent(excess, pair[0].0, pair[1].0).ok());
        let mut contacts = roots.map(|c| self.centred(c, &cosines));
        Ok(contacts.find(|contact| contact.presses_everywhere() && !self.touches_outside(contact, 3.0 * high)))
    }

    /// P = (πE*c/4)(c/R + ξ₁) of a contact about the origin [N/m] (Kudish et al. 2.13).
    fn centred_load(&self, half_width: f64, cosines: &Cosines) -> f64 {
        let first = 2.0 * cosines.mean(|u| (self.slope)(half_width * u) * u);
        FRAC_PI_4 * self.modulus * half_width * (half_width / self.radius + first)
    }

    /// The contact about the origin of a symmetric profile.
    fn centred(&self, half_width: f64, cosines: &Cosines) -> PlaneContact {
        let series = cosines.series(|u| (self.slope)(half_width * u));
        let parabola = half_width / self.radius;
        let load = self.centred_load(half_width, cosines);
        PlaneContact { centre: 0.0, half_width, load, scale: (0.5 * self.modulus, parabola), series }
    }

    /// The contact under a load per width [N/m]: among the candidates the one that presses everywhere, else the widest.
    ///
    /// # Errors
    /// The roughness is not resolved; no balanced contact carries the load.
    pub fn under(&self, load: f64) -> Result<PlaneContact, ConnectivityError> {
        let mut all = self.candidates(load)?;
        let best = all.iter().rposition(PlaneContact::presses_everywhere).or_else(|| all.len().checked_sub(1));
        best.map(|at| all.swap_remove(at)).ok_or(ConnectivityError::NoContact)
    }

    /// Whether the contact under a load per width [N/m] is in one piece, the gap looked at out to `reach` [m] on either side.
    ///
    /// The condition of Kudish et al. 2.18 makes the pressure positive inside; that the roughness stays clear outside is their premise
    /// and is checked here.
    ///
    /// # Errors
    /// The roughness is not resolved; no contact in one piece carries the load.
    pub fn verdict(&self, load: f64, reach: f64) -> Result<Connection, ConnectivityError> {
        let mut all = self.candidates(load)?;
        all.retain(PlaneContact::presses_everywhere);
        let clear = all.iter().find(|contact| !self.touches_outside(contact, reach));
        Ok(match clear {
            Some(contact) if contact.surely_connected() => Connection::Sure,
            Some(_) => Connection::InOnePiece,
            None if all.is_empty() => Connection::OpensInside,
            None => Connection::TouchesOutside,
        })
    }

    /// Whether the gap closes again between an end of the contact and `reach` [m] from the origin.
    fn touches_outside(&self, contact: &PlaneContact, reach: f64) -> bool {
        let closes = |side: f64| {
            let end = contact.centre + side * contact.half_width;
            let steps = 64 * contact.series.len();
            #[expect(clippy::cast_precision_loss, reason = "far fewer than 2^53 steps")]
            let step = (reach - side * end).max(0.0) / steps as f64;
            let mut gap = 0.0;
            (1..=steps).any(|k| {
                #[expect(clippy::cast_precision_loss, reason = "far fewer than 2^53 steps")]
                let x = end + side * step * (k as f64 - 0.5);
                gap += step * side * contact.gap_slope(x, (self.slope)(x));
                gap < 0.0
            })
        };
        closes(1.0) || closes(-1.0)
    }

    /// The least load per width [N/m] in a range from which on, up to its end, the contact is in one piece; `None` if it is not at the end.
    ///
    /// `steps` loads evenly spaced in the logarithm are tried from the end down and the last change refined. With `Connection::Sure`
    /// as `wanted` this is the least load of the sufficient condition, with `Connection::InOnePiece` the true one. For waves of
    /// fixed length the sufficient condition fails again at large loads, as more waves enter the contact: choose the end with care.
    pub fn least_load(&self, (from, to): (f64, f64), reach: f64, wanted: Connection) -> Option<f64> {
        let holds = |load: f64| {
            self.verdict(load, reach)
                .is_ok_and(|v| v == Connection::Sure || (v == wanted && wanted == Connection::InOnePiece))
        };
        let step = (to / from).powf(1.0 / f64::from(LOADS));
        let load = |k: u32| from * step.powf(f64::from(k));
        let mut least = None;
        for k in (0..=LOADS).rev() {
            if !holds(load(k)) {
                break;
            }
            least = Some(load(k));
        }
        let (mut holds_at, mut fails) = (least?, least? / step);
        if fails < from {
            return least;
        }
        for _ in 0..30 {
            let middle = (fails * holds_at).sqrt();
            *(if holds(middle) { &mut holds_at } else { &mut fails }) = middle;
        }
        Some(holds_at)
    }

    /// Upper estimate of |φ′| over three half widths on either side.
    fn steepest(&self, half_width: f64) -> f64 {
        let at = |k: i32| (self.slope)(3.0 * half_width * f64::from(k) / 2048.0).abs();
        1.1 * (-2048..=2048).map(at).fold(0.0, f64::max)
    }

    /// Nodes that resolve the slope over a contact about the origin.
    fn resolving(&self, half_width: f64) -> Result<Cosines, ConnectivityError> {
        let mut terms = 32;
        while terms <= MOST_TERMS {
            let cosines = Cosines::of(terms);
            let series = cosines.series(|u| (self.slope)(half_width * u));
            let largest = series.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            if series[3 * terms / 4..].iter().all(|x| x.abs() <= 1e-13 * largest) {
                return Ok(cosines);
            }
            terms *= 2;
        }
        Err(ConnectivityError::NotResolved { terms: MOST_TERMS, half_width })
    }
}

const MOST_TERMS: usize = 1024;
/// Half widths, and centres on either side of the origin, tried in search of the contact.
const WIDTHS: u32 = 40;
const CENTRES: i32 = 60;
/// Half widths tried in search of a symmetric contact.
const SYMMETRIC: u32 = 200;
/// Loads tried in search of the least one.
const LOADS: u32 = 40;

impl PlaneContact {
    fn away(&self, other: &Self) -> f64 {
        (self.centre - other.centre).abs()
    }

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

/// cos(πi/2n) for i < 4n, the cosines of every Chebyshev sum over n nodes.
#[derive(Debug, Clone)]
struct Cosines(Vec<f64>);

impl Cosines {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand nodes")]
    fn of(nodes: usize) -> Self {
        Self((0..4 * nodes).map(|i| (FRAC_PI_2 * i as f64 / nodes as f64).cos()).collect())
    }

    fn nodes(&self) -> usize {
        self.0.len() / 4
    }

    /// The mean of a function over the nodes, its coefficient of T₀.
    #[expect(clippy::cast_precision_loss, reason = "a few thousand nodes")]
    fn mean(&self, f: impl Fn(f64) -> f64) -> f64 {
        (0..self.nodes()).map(|j| f(self.0[2 * j + 1])).sum::<f64>() / self.nodes() as f64
    }

    /// Chebyshev coefficients of a function on [−1, 1]; exact for polynomials of lower degree than the nodes.
    #[expect(clippy::cast_precision_loss, reason = "a few thousand nodes")]
    fn series(&self, f: impl Fn(f64) -> f64) -> Vec<f64> {
        let values: Vec<_> = (0..self.nodes()).map(|j| f(self.0[2 * j + 1])).collect();
        let coefficient = |k: usize| {
            let term = |(j, v): (usize, &f64)| v * self.0[k * (2 * j + 1) % self.0.len()];
            let sum: f64 = values.iter().enumerate().map(term).sum();
            sum * (if k == 0 { 1.0 } else { 2.0 }) / self.nodes() as f64
        };
        (0..self.nodes()).map(coefficient).collect()
    }
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
        // Waves 7 times as curved as the parabola: light loads rest on one crest, heavier ones on several.
        let slope = |x: f64| 1.5e-2 * (x / 2e-4).sin();
        let (rough, reach) = (wavy(&slope), 4e-3);
        let exact = rough.least_load((40.0, 1e4), reach, Connection::InOnePiece).unwrap();
        assert!(rough.verdict(1.0001 * exact, reach).unwrap().in_one_piece());
        assert!(!rough.verdict(0.9999 * exact, reach).unwrap().in_one_piece());
        let sure = rough.least_load((40.0, 3.0 * exact), reach, Connection::Sure);
        assert!(sure.is_none_or(|sure| sure >= exact * (1.0 - 1e-9)), "{exact} {sure:?}");
    }

    /// A light load sits on one crest in one piece; a heavier one reaches the next crests, which only the gap outside tells.
    #[test]
    fn the_next_crest_is_seen() {
        // Crests of the indenter (least gap) at 0 and ±2π·2e-4.
        let slope = |x: f64| 1.5e-2 * (x / 2e-4).sin();
        let rough = wavy(&slope);
        assert!(rough.verdict(0.01, 4e-3).unwrap().in_one_piece());
        let verdicts: Vec<_> = (0..12).map(|k| rough.verdict(5.0 * 1.8f64.powi(k), 4e-3).unwrap()).collect();
        assert!(
            verdicts[0].in_one_piece()
                && verdicts.contains(&Connection::TouchesOutside)
                && verdicts.contains(&Connection::OpensInside)
        );
        assert!(verdicts.last().unwrap().in_one_piece());
    }

    #[test]
    fn kinks_are_refused() {
        let error = wavy(&|x: f64| 1e-3 * (x - 1e-4).signum()).under(10.0).unwrap_err();
        assert!(matches!(error, ConnectivityError::NotResolved { .. }), "{error}");
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
