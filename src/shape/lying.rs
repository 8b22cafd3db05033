//! A section long across, on a half-plane, as the profile of a bed.
//!
//! A flat strip of half width X and width W has on a half-plane a finite stiffness K(X), once it is said what is at
//! rest: a place at the distance L, K = πE*W/(2 ln(2L/X)), or the mean plane of a row of strips at the distance λ,
//! K = −πE*W/(2 ln sin(πX/λ)). A contact that grows is a row of such strips, so that it is a bed: springs at the
//! places x = K/2E*, of the stiffness 2E* dx, under the profile g(x) = d(X(x)). With y = πW/2x and S = e^(−y/2) both
//! are one: the lying cylinder is X = 2LS with h = L²/R, the wave X = (λ/π) arcsin S with its amplitude h, and
//!
//! g = h(1 + y)e^(−y), ∫(g(a) − g) dx = (πWh/2)e^(−y), f = 2he^(−y).
//!
//! The bed knows nothing of all this: force, energy, memory, friction and the edge under adhesion are those of
//! a profile g(x). What is told of a contact, its half width X, its pressure and its surface, is told from here.

use super::{PlaneWave, Profile, Rim};
use crate::numerics::panelled::PanelledCurve;
use crate::numerics::quadrature;
use crate::shape::plane::Cylinder;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A section on the half-plane, see the module.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lying {
    /// h [m].
    height: f64,
    /// Half the place X at S = 1 [m] of a cylinder, λ/2π of a wave.
    reach: f64,
    /// Width W across the section [m].
    width: f64,
    /// Whether the section is one period of a wave.
    periodic: bool,
    /// The least y.
    least: f64,
}

/// The least y of a cylinder, X = 0.45 L: its contact is to be small against L.
const WIDEST: f64 = 3.0;
/// The least y of a wave: what stays open is then 3e-7 of its length, and the contact counts as full.
const CLOSED: f64 = 1e-12;
/// The least y of a wave that is followed while it is open: to 0.99 of the load of full contact.
const OPEN: f64 = 1e-2;
/// Part of the reach of a pressure beside which no panels are laid: there q − q(r) is rounding, over the square of the way.
const NEAREST: f64 = 1e-3;
/// Beyond this y nothing is left of e^(−y).
const NOTHING: f64 = 700.0;

impl From<&Cylinder> for Lying {
    fn from(cylinder: &Cylinder) -> Self {
        let (radius, datum) = (cylinder.radius.si(), cylinder.datum.si());
        Self { height: datum * (datum / radius), reach: datum, width: cylinder.width(), periodic: false, least: WIDEST }
    }
}

impl From<&PlaneWave> for Lying {
    fn from(wave: &PlaneWave) -> Self {
        let reach = wave.wavelength.si() / TAU;
        Self { height: wave.amplitude.si(), reach, width: wave.width(), periodic: true, least: CLOSED }
    }
}

impl Lying {
    /// The same, a wave to its full contact no more: springs that are laid out one by one, that remember or slip, have
    /// no end where the wave lies flat.
    #[must_use]
    pub fn kept_open(self) -> Self {
        Self { least: self.least.max(OPEN), ..self }
    }

    /// Whether the section can lie flat.
    fn closes(&self) -> bool {
        self.periodic && self.least <= CLOSED
    }

    /// y = πW/2x.
    fn exponent(&self, x: f64) -> f64 {
        FRAC_PI_2 * self.width / x
    }

    /// x [m] from y.
    fn at_exponent(&self, y: f64) -> f64 {
        FRAC_PI_2 * self.width / y
    }

    /// Whether a wave lies flat under a bed that ends at the place `x`.
    fn is_closed(&self, x: f64) -> bool {
        self.closes() && self.exponent(x) <= CLOSED * (1.0 + 1e-9)
    }

    /// S at the place `x`.
    fn share(&self, x: f64) -> f64 {
        (-0.5 * self.exponent(x)).exp()
    }

    /// cos(πX/λ) of a wave where S = e^(−y/2), 1 of a cylinder.
    fn cosine(&self, y: f64) -> f64 {
        if self.periodic { (-(-y).exp_m1()).max(0.0).sqrt() } else { 1.0 }
    }

    /// √(S(a)² − S(r)²) of two exponents.
    fn between(outer: f64, inner: f64) -> f64 {
        (-outer).exp().sqrt() * (-(outer - inner).exp_m1()).max(0.0).sqrt()
    }

    /// Displacement at S(r) = `share` under a strip that ends at the place `a` and sinks by one.
    fn beside_strip(&self, share: f64, a: f64) -> f64 {
        let strip = self.share(a);
        let root = ((share - strip).max(0.0) * (share + strip)).sqrt();
        -(share + root).ln() * 4.0 * a / (PI * self.width)
    }
}

impl Profile for Lying {
    fn height(&self, r: f64) -> f64 {
        2.0 * self.height * (-self.exponent(r)).exp()
    }

    /// Of a wave it reaches h where the contact is closed and not before: a force is lost by the root of the last
    /// rounding of a depth.
    fn reduced(&self, x: f64) -> f64 {
        let y = self.exponent(x);
        let most = if self.closes() && !self.is_closed(x) { 1.0 - f64::EPSILON } else { 1.0 };
        if y < NOTHING { self.height * ((1.0 + y) * (-y).exp()).min(most) } else { 0.0 }
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        let y = self.exponent(x);
        if y < NOTHING { self.height * y * y * (-y).exp() / x } else { 0.0 }
    }

    fn load_integral(&self, a: f64) -> f64 {
        FRAC_PI_2 * self.width * self.height * (-self.exponent(a)).exp()
    }

    fn energy_integral(&self, a: f64) -> f64 {
        let y = self.exponent(a);
        if y < NOTHING { PI * self.width * (self.height * (-y).exp()).powi(2) * (0.25 + 0.5 * y) } else { 0.0 }
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        let (inner, outer) = (self.exponent(r), self.exponent(a));
        self.height / self.reach * self.cosine(inner) * Self::between(outer, inner)
    }

    /// hS(a)²[1 − 2S/(S + √(S² − S(a)²)) − 2 ln(S + √(S² − S(a)²))].
    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        let (place, edge) = (self.share(r), self.share(a));
        let sum = place + ((place - edge).max(0.0) * (place + edge)).sqrt();
        self.height * edge * edge * (1.0 - 2.0 * place / sum - 2.0 * sum.ln())
    }

    /// By Newton from below on y − ln(1 + y) = ln(h/d), which is convex.
    fn edge(&self, d: f64) -> Option<f64> {
        if d <= 0.0 {
            return Some(0.0);
        }
        let (end, log) = (self.rim().radius(), (self.height / d).ln());
        if d >= self.reduced(end) {
            return Some(end).filter(|_| self.closes() || d <= self.reduced(end));
        }
        let mut y = log + (1.0 + log + (2.0 * log).sqrt()).ln();
        for _ in 0..MOST_STEPS {
            let step = (y - y.ln_1p() - log) * (1.0 + y) / y;
            y -= step;
            if step.abs() <= f64::EPSILON * y {
                break;
            }
        }
        Some(self.at_exponent(y).min(end))
    }

    fn rim(&self) -> Rim {
        let end = self.at_exponent(self.least);
        if self.closes() { Rim::Wall(end) } else { Rim::End(end) }
    }

    /// Where S² = e^(−20).
    fn scale(&self) -> f64 {
        self.at_exponent(20.0)
    }

    fn breaks(&self, a: f64) -> Vec<f64> {
        // e^(−y) falls by e² from panel to panel.
        let y = self.exponent(a);
        let near_closed = std::iter::successors(Some(4.0 * y), |y| Some(4.0 * y)).take_while(|y| *y < 1.0);
        let mut breaks: Vec<f64> = near_closed.map(|y| self.at_exponent(y)).collect();
        breaks.extend((1..=20).map(|k| self.at_exponent(y + 2.0 * f64::from(k))));
        breaks.reverse();
        breaks
    }

    fn is_plane(&self) -> bool {
        true
    }

    fn contact_radius(&self, x: f64) -> f64 {
        match self.share(x) {
            share if !self.periodic => 2.0 * self.reach * share,
            _ if self.is_closed(x) => PI * self.reach,
            share => 2.0 * self.reach * share.asin(),
        }
    }

    fn place(&self, radius: f64) -> f64 {
        let half = 0.5 * radius / self.reach;
        let share = if self.periodic { half.sin().abs() } else { half };
        match self.rim() {
            Rim::Wall(end) if share >= 1.0 => end,
            _ if share >= 1.0 => f64::INFINITY,
            Rim::Wall(end) => self.at_exponent(-2.0 * share.ln()).min(end),
            Rim::End(_) | Rim::None => self.at_exponent(-2.0 * share.ln()),
        }
    }

    fn contact_area(&self, x: f64) -> f64 {
        2.0 * self.width * self.contact_radius(x)
    }

    fn contact_area_slope(&self, x: f64) -> f64 {
        let y = self.exponent(x);
        if y < 2.0 * NOTHING { 2.0 * self.width * self.reach * self.share(x) * y / (x * self.cosine(y)) } else { 0.0 }
    }

    fn contact_area_bend(&self, x: f64) -> f64 {
        let y = self.exponent(x);
        let wave = if self.periodic { 0.5 * y / y.exp_m1() } else { 0.0 };
        0.5 * y - 2.0 + wave
    }

    fn ring(&self, _radius: f64) -> f64 {
        2.0 * self.width
    }

    /// Of two lines of load −(4/π) ln(x/L), of two rows of them −(4/π) ln(2 sin(πx/λ)).
    fn under_middle(&self, radius: f64) -> f64 {
        let half = 0.5 * radius / self.reach;
        -4.0 / PI * if self.periodic { 2.0 * half.sin() } else { 2.0 * half }.ln()
    }

    fn edge_pressure(&self, r: f64, a: f64) -> f64 {
        let (inner, outer) = (self.exponent(r), self.exponent(a));
        a * self.cosine(inner) / (PI * self.reach * self.width * Self::between(outer, inner))
    }

    fn edge_surface(&self, r: f64, a: f64) -> f64 {
        self.beside_strip(self.share(r), a)
    }

    /// With T² = S² − S(r)²: p = (cos/πWℓ)[a q(r)/T(a) + ∫(q − q(r))(2x/S²y − x/T²) dT].
    fn pressure_of(&self, load: &PanelledCurve<'_>, r: f64) -> f64 {
        let ends = load.ends();
        let Some(&a) = ends.last() else { return 0.0 };
        if r >= a {
            return 0.0;
        }
        let (here, inner, least) = (load.at(r), self.exponent(r), self.share(r));
        let to_t = |x: f64| Self::between(self.exponent(x), inner);
        let breaks = ends.iter().copied().chain(self.breaks(a)).filter(|&x| x > r && x < a).map(to_t);
        let mut breaks: Vec<f64> = breaks.filter(|&t| t > NEAREST * to_t(a)).collect();
        breaks.sort_by(f64::total_cmp);
        let at = |t: f64| {
            let share = least.hypot(t);
            let y = -2.0 * share.ln();
            let x = self.at_exponent(y);
            (load.at(x) - here) * (2.0 * x / (share * share * y) - x / (t * t))
        };
        let sum = a * here / to_t(a) + quadrature::panels(at, (0.0, to_t(a)), &breaks);
        self.cosine(inner) * sum / (PI * self.width * self.reach)
    }

    /// u = ∫ v ∂φ/∂x dx, φ the displacement at `r` under a strip that ends at x and sinks by one.
    fn surface_of(&self, displacement: &PanelledCurve<'_>, r: f64) -> f64 {
        let ends = displacement.ends();
        let Some(&last) = ends.last() else { return 0.0 };
        let (place, y) = (self.share(r), self.exponent(r));
        // x = r sin θ takes the root at r away; far from the edge nothing is left of e^(−y).
        let angle = |x: f64| if x < r { (x / r).asin() } else { FRAC_PI_2 };
        let mut breaks: Vec<f64> = ends.iter().copied().chain(self.breaks(r)).map(angle).collect();
        breaks.sort_by(f64::total_cmp);
        let at = |theta: f64| {
            let (x, half) = (r * theta.sin(), 0.5 * (FRAC_PI_2 - theta));
            // 1/sin θ − 1 without cancellation.
            let beyond = y * 2.0 * half.sin().powi(2) / theta.sin();
            let root = place * (-(-beyond).exp_m1()).sqrt();
            let share = place * (-0.5 * beyond).exp();
            let steep = if root > 0.0 { 0.5 * share * share * (y + beyond) / (root * (place + root)) } else { 0.0 };
            displacement.at(x) * (steep - (place + root).ln()) * r * theta.cos()
        };
        4.0 / (PI * self.width) * quadrature::panels(at, (0.0, angle(last)), &breaks)
    }
}

/// Newton on a convex function doubles its digits: from one to all in five.
const MOST_STEPS: usize = 40;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::Length;
    use proptest::prelude::*;

    fn length(si: f64) -> Length {
        Length::new(si).unwrap()
    }

    fn cylinder() -> Lying {
        Lying::from(&Cylinder { radius: length(2.0), datum: length(3.0), width: Some(length(0.7)) })
    }

    fn wave() -> Lying {
        Lying::from(&PlaneWave { amplitude: length(0.01), wavelength: length(1.3), width: Some(length(0.7)) })
    }

    /// Plain integrals over the strips, each of its own half width X: dF = K dd with K of the module.
    #[test]
    fn the_bed_is_the_row_of_strips() {
        let (radius, datum, width) = (2.0, 3.0, 0.7);
        for a in [1e-6, 1e-3, 0.1, 0.5] {
            let (bed, force) = (cylinder(), 0.25 * PI * width * a * a / radius);
            let (place, depth) = (bed.place(a), 0.5 * a * a / radius * ((2.0 * datum / a).ln() + 0.5));
            assert!((bed.contact_radius(place) / a - 1.0).abs() < 1e-14);
            assert!((2.0 * bed.load_integral(place) / force - 1.0).abs() < 1e-13, "{a}");
            assert!((bed.reduced(place) / depth - 1.0).abs() < 1e-13, "{a}");
            assert!((2.0 * place / (0.5 * PI * width / (2.0 * datum / a).ln()) - 1.0).abs() < 1e-14);
            assert!((bed.height(place) / (0.5 * a * a / radius) - 1.0).abs() < 1e-13);
            // Johnson, eq. 4.45: p₀ = E*a/2R.
            assert!((bed.pressure_integral(0.0, place) / (0.5 * a / radius) - 1.0).abs() < 1e-13);
        }
        let (amplitude, wavelength) = (0.01, 1.3);
        for a in [1e-6, 1e-3, 0.1, 0.5, 0.64] {
            let (bed, sine) = (wave(), (PI * a / wavelength).sin());
            let place = bed.place(a);
            // Westergaard: p̄ = (πE*Δ/λ) sin².
            let force = PI * amplitude / wavelength * sine * sine * wavelength * width;
            assert!((bed.contact_radius(place) / a - 1.0).abs() < 1e-13);
            assert!((2.0 * bed.load_integral(place) / force - 1.0).abs() < 1e-13, "{a}");
            let peak = 2.0 * PI * amplitude / wavelength * sine;
            assert!((bed.pressure_integral(0.0, place) / peak - 1.0).abs() < 1e-13);
            let x = bed.place(0.7 * a);
            let rest = (sine * sine - (0.7 * PI * a / wavelength).sin().powi(2)).sqrt();
            let inside = 2.0 * PI * amplitude / wavelength * (0.7 * PI * a / wavelength).cos() * rest;
            assert!((bed.pressure_integral(x, place) / inside - 1.0).abs() < 1e-12, "{a}");
        }
    }

    proptest! {
        /// The closed forms are those of any profile, by quadrature and by differences.
        #[test]
        fn closed_forms_are_the_integrals(k in 1i32..90, of_wave: bool, j in 0i32..99) {
            let bed = if of_wave { wave() } else { cylinder() };
            let a = bed.at_exponent(if of_wave { 0.2 } else { 3.0 } + 0.5 * f64::from(k));
            let near = |one: f64, other: f64, bound: f64| (one / other - 1.0).abs() < bound;
            let below = |f: &dyn Fn(f64) -> f64| quadrature::panels(f, (0.0, a), &bed.breaks(a));
            prop_assert!(near(below(&|x| x * bed.reduced_slope(x)), bed.load_integral(a), 1e-11));
            prop_assert!(near(below(&|x| 2.0 * bed.reduced_slope(x) * bed.load_integral(x)), bed.energy_integral(a), 1e-11));
            prop_assert!(near(below(&|x| bed.reduced_slope(x)), bed.reduced(a), 1e-11));
            prop_assert!(near(below(&|x| bed.contact_area_slope(x)), bed.contact_area(a), 1e-7));
            prop_assert!(near(bed.edge(bed.reduced(a)).unwrap(), a, 1e-12));
            let h = 1e-5;
            let slopes = (bed.contact_area_slope(a * (1.0 + h)) / bed.contact_area_slope(a * (1.0 - h))).ln() / (2.0 * h);
            prop_assert!((slopes - bed.contact_area_bend(a)).abs() < 1e-5 * (1.0 + slopes.abs()), "{slopes}");
            // Any load: that of the elastic bed and one more at the edge, known to its rounding.
            let rounded = |x: f64| 1.0 + 1e-15 * (x.to_bits() % 8) as f64;
            let r = bed.place(0.01 * f64::from(j) * bed.contact_radius(a));
            let load = PanelledCurve::new(|x: f64| rounded(x) * (1.3 * bed.reduced(a) - bed.reduced(x)), vec![a]);
            let exact = bed.pressure_integral(r, a) + 0.3 * bed.reduced(a) * bed.edge_pressure(r, a);
            let found = bed.pressure_of(&load, r);
            prop_assert!(near(found, exact, 1e-6), "{}", found / exact);
        }

        /// The surface beside the contact: by springs, and touching the indenter at the edge.
        #[test]
        fn the_surface_is_that_of_the_springs(k in 1i32..50, of_wave: bool, j in 1i32..99) {
            let bed = if of_wave { wave() } else { cylinder() };
            let a = bed.at_exponent(if of_wave { 1.0 } else { 6.0 } + 0.5 * f64::from(k));
            let radius = bed.contact_radius(a);
            let far = if of_wave { 0.65 } else { 3.0 * radius };
            let r = bed.place(radius + 0.01 * f64::from(j) * (far - radius));
            let springs = |x: f64| if x < a { 1.3 * bed.reduced(a) - bed.reduced(x) } else { 0.0 };
            let exact = bed.displacement_integral(r, a) + 0.3 * bed.reduced(a) * bed.edge_surface(r, a);
            let found = bed.surface_of(&PanelledCurve::new(springs, vec![a]), r);
            prop_assert!((found - exact).abs() < 1e-6 * bed.reduced(a), "{found} {exact}");
            let at_edge = bed.reduced(a) - bed.height(a);
            prop_assert!((bed.displacement_integral(a, a) / at_edge - 1.0).abs() < 1e-10);
            prop_assert!((bed.edge_surface(a, a) - 1.0).abs() < 1e-13);
        }
    }
}
