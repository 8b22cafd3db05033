//! Attraction of constant stress and finite range on any profile (Maugis & Dugdale).
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::range::RangeDisc;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Maugis: w = 1 at the stress σ₀ = 2 acts up to the gap w/σ₀.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let disc = RangeDisc::new(ground, 1.0, 2.0)?;
//! assert_eq!((disc.range(), disc.stress()), (0.5, 2.0));
//! assert!(disc.at(1.5).reach > disc.at(1.5).contact_radius);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::equilibrium::{Balance, Control, Equilibrium, Search};
use super::line::Energy;
use crate::contact::foundation::Foundation;
use crate::numerics::{quadrature, root};
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, FRAC_PI_2, PI};

/// Equilibrium of a contact with the attractive stress σ₀ up to the gap w/σ₀.
///
/// In the bed the stress is the line load −2σ₀√(c²−x²) out to the radius c, and q is continuous at
/// the edge of the contact, so d = g(a) − (2σ₀/E*)√(c²−a²) and
/// F = 2E*∫₀^a (d−g) dx − 4σ₀∫_a^c √(c²−x²) dx. The gap at c,
/// h(c) = (2/π)∫_a^c g′ arccos(x/c) dx + (4σ₀/πE*)[√(c²−a²) arccos(a/c) − (c−a)], is w/σ₀. For the
/// paraboloid these are the equations of Maugis 1992 (Popov & Heß 2015, ch. 4.7). Before the bodies
/// touch, a = 0, they attract each other over the radius c already. Symbols: a contact radius,
/// c radius of attraction [m], w work of adhesion [J/m²], σ₀ attractive stress [Pa], E* effective
/// modulus [Pa]. Check: λ = 1 parts at F = −1.600723 πwR.
#[derive(Debug, Clone)]
pub struct RangeDisc {
    ground: Foundation,
    work: f64,
    stress: f64,
    /// Radius c at which the bodies touch first.
    touch: f64,
    /// Decades above it within which the branch turns for the last time.
    decades: f64,
}

impl RangeDisc {
    /// A contact on `ground` with the work of adhesion w [J/m²] and the attractive stress σ₀ [Pa].
    ///
    /// # Errors
    /// No radius of attraction is found at which the bodies touch.
    pub fn new(ground: Foundation, work: f64, stress: f64) -> Result<Self, root::RootError> {
        let mut disc = Self { ground, work, stress, touch: 0.0, decades: 1.0 };
        let residual = |c: f64| disc.gap_without_contact(c) - disc.range();
        let (low, high) = root::bracket_upwards(residual, 0.0, disc.jkr_scale().min(disc.end()), disc.end().min(1e300))
            .unwrap_or((0.0, disc.end()));
        disc.touch = match root::brent(residual, low, high) {
            Err(root::RootError::NoSignChange { .. }) => high,
            found => found?,
        };
        disc.decades = 2.0 + (disc.short_range_turn() / disc.touch).max(1.0).log10();
        Ok(disc)
    }

    /// Radius at which the contact would turn if the range vanished: g′ = Δl/2a.
    fn short_range_turn(&self) -> f64 {
        let residual = |a: f64| {
            self.ground.profile().reduced_slope(a) - (0.5 * PI * self.work / (self.ground.modulus() * a)).sqrt()
        };
        root::bracket_upwards(residual, 0.0, self.touch, self.end().min(1e300)).map_or(self.touch, |found| found.1)
    }

    /// What the indenter is pressed into.
    #[must_use]
    pub fn ground(&self) -> &Foundation {
        &self.ground
    }

    /// Range of the attraction w/σ₀ [m].
    #[must_use]
    pub fn range(&self) -> f64 {
        self.work / self.stress
    }

    /// Attractive stress σ₀ [Pa].
    #[must_use]
    pub fn stress(&self) -> f64 {
        self.stress
    }

    /// Work of adhesion w [J/m²].
    #[must_use]
    pub fn work(&self) -> f64 {
        self.work
    }

    /// Radius c [m] of attraction at which the bodies touch first.
    #[must_use]
    pub fn touch(&self) -> f64 {
        self.touch
    }

    /// Displacement [m] of the surface at `r` ≥ a by the attraction in the ring a < x < c alone:
    /// −(4σ₀/πE*)∫_a^min(r,c) √(c²−x²) dx/√(r²−x²).
    #[must_use]
    pub fn pulled_up(&self, state: &Balance, r: f64) -> f64 {
        let (a, c) = (state.contact_radius, state.reach);
        let top = r.min(c);
        let kernel = |from_a: f64, to_top: f64| {
            let (x, low) = (a + from_a, if r < c { c - r } else { r - c });
            let (to_c, to_r) = if r < c { (to_top + low, to_top) } else { (to_top, to_top + low) };
            ((to_c * (c + x)) / (to_r * (r + x))).sqrt()
        };
        -FRAC_2_PI * self.ratio() * quadrature::panel_with_root_ends(kernel, top - a)
    }

    /// 2σ₀/E*.
    pub(super) fn ratio(&self) -> f64 {
        2.0 * self.stress / self.ground.modulus()
    }

    /// A length typical of the neck: the elongation limit of JKR on the profile's own scale.
    fn jkr_scale(&self) -> f64 {
        (self.work / self.ground.modulus()).sqrt() * self.ground.profile().scale().sqrt()
    }

    /// Gap at the rim c if the bodies just touch at the apex: f(c) − (2σ₀/E*)(2/π − 1)c.
    fn gap_without_contact(&self, c: f64) -> f64 {
        self.ground.profile().height(c) + self.ratio() * c * (1.0 - FRAC_2_PI)
    }

    /// The angle arccos(b/c) of a kink of the profile at b that the neck a < x < c holds or is near to.
    ///
    /// Above a kink g goes as √(x−b). Farther from it than its own width the neck does not feel that.
    fn corner(&self, c: f64, phi: f64) -> Option<f64> {
        let b = self.ground.profile().kink().filter(|&b| b > 0.0 && b < c)?;
        let a = c * phi.cos();
        (c - b > 2.0 * (a - b)).then(|| ((c - b) * (c + b)).sqrt().atan2(b))
    }

    /// ∫₀^φ k(c cos ψ, ψ) dψ with panels at the breaks of the profile.
    pub(super) fn over_neck(&self, c: f64, phi: f64, mut kernel: impl FnMut(f64, f64) -> f64) -> f64 {
        let angles = self.ground.profile().breaks(c).into_iter().map(|x| (x / c).min(1.0).acos());
        let mut breaks: Vec<f64> = angles.filter(|&at| at < phi).collect();
        breaks.reverse();
        let mut at = |psi: f64| kernel(c * psi.cos(), psi);
        let Some(corner) = self.corner(c, phi) else { return quadrature::panels(at, (0.0, phi), &breaks) };
        // ψ = corner − u² takes the root at the kink away.
        let to_u = |psi: f64| (corner - psi).max(0.0).sqrt();
        let near: Vec<f64> = breaks.iter().rev().map(|&psi| to_u(psi)).collect();
        let flank = quadrature::panels(|u| 2.0 * u * at(corner - u * u), (to_u(phi), corner.sqrt()), &near);
        if phi > corner { flank + quadrature::panels(at, (corner, phi), &breaks) } else { flank }
    }

    /// Gap h(c) for a = c cos φ.
    pub(super) fn gap(&self, c: f64, phi: f64) -> f64 {
        let profile = if self.corner(c, phi).is_some() {
            let edge = self.ground.profile().reduced(c * phi.cos());
            self.over_neck(c, phi, |x, _| self.ground.profile().reduced(x) - edge)
        } else {
            self.over_neck(c, phi, |x, psi| self.ground.profile().reduced_slope(x) * psi * c * psi.sin())
        };
        FRAC_2_PI * profile + self.gap_of_attraction(c, phi)
    }

    /// What the attraction adds to the gap: (4σ₀/πE*)[√(c²−a²) arccos(a/c) − (c−a)].
    fn gap_of_attraction(&self, c: f64, phi: f64) -> f64 {
        FRAC_2_PI * self.ratio() * c * (phi * phi.sin() - versine(phi))
    }

    /// g(a) of the edge a = c cos φ; near a kink from the gap w/σ₀ instead of the radius.
    ///
    /// There g changes by 1e-8 of itself when a changes in its last digit. From ∫(g(x) − g(a)) dψ over the
    /// neck, which the gap prescribes, g(a) follows to rounding.
    fn edge_height(&self, c: f64, phi: f64) -> f64 {
        if self.corner(c, phi).is_none() {
            return self.ground.profile().reduced(c * phi.cos());
        }
        let neck = self.over_neck(c, phi, |x, _| self.ground.profile().reduced(x));
        (neck - FRAC_PI_2 * (self.range() - self.gap_of_attraction(c, phi))) / phi
    }

    /// The neck angle φ = arccos(a/c) in contact.
    pub(super) fn neck(&self, c: f64) -> f64 {
        let residual = |phi: f64| self.gap(c, phi) - self.range();
        root::brent(residual, 0.0, FRAC_PI_2).unwrap_or(FRAC_PI_2)
    }

    /// The state whose attraction reaches to `c` [m].
    #[must_use]
    pub fn at(&self, c: f64) -> Balance {
        if c <= self.touch {
            return self.before_touch(c);
        }
        self.with_neck(c, self.neck(c))
    }

    fn before_touch(&self, c: f64) -> Balance {
        let indentation = self.ground.profile().height(c) - FRAC_2_PI * self.ratio() * c - self.range();
        Balance { contact_radius: 0.0, reach: c, indentation, force: -PI * self.stress * c * c }
    }

    fn with_neck(&self, c: f64, phi: f64) -> Balance {
        let (sine, cosine) = phi.sin_cos();
        let a = c * cosine;
        let edge = self.edge_height(c, phi);
        let indentation = edge - self.ratio() * c * sine;
        let attraction = 2.0 * self.stress * c * c * (sine * cosine + phi);
        // Zero but for the rounding of g near a kink, which N has too and which cancels.
        let rounding = a * (edge - self.ground.profile().reduced(a));
        let force = 2.0 * self.ground.modulus() * (self.ground.profile().load_integral(a) + rounding) - attraction;
        Balance { contact_radius: a, reach: c, indentation, force }
    }

    /// Energy of the state: elastic, and of the attracting surfaces −∫σ₀(w/σ₀ − gap) dA.
    #[must_use]
    pub fn energy(&self, state: &Balance) -> Energy {
        let (a, c) = (state.contact_radius, state.reach);
        let edge = state.indentation - self.ground.profile().reduced(a);
        let neck = ring_area(a, c);
        let (n, m) = (self.ground.profile().load_integral(a), self.ground.profile().energy_integral(a));
        let inside = self.ground.modulus() * (m + 2.0 * edge * n + a * edge * edge);
        let outside = 4.0 * self.stress / self.ground.modulus() * self.stress * neck;
        let phi = if c > 0.0 { (a / c).min(1.0).acos() } else { 0.0 };
        // ∫(g − d)√(c²−x²) dx over the neck, with √(c²−x²) dx = c² sin²ψ dψ.
        let lift = self.over_neck(c, phi, |x, psi| {
            (self.ground.profile().reduced(x) - state.indentation) * (c * psi.sin()).powi(2)
        });
        let gap_volume = 4.0 * lift - 4.0 * self.ratio() * neck;
        Energy { elastic: inside + outside, surface: self.stress * gap_volume - self.work * PI * c * c }
    }

    /// dφ/dc from the condition on the gap.
    fn neck_slope(&self, c: f64, phi: f64) -> f64 {
        let (sine, cosine) = phi.sin_cos();
        let a = c * cosine;
        let profile = self.over_neck(c, phi, |x, psi| self.ground.profile().reduced_slope(x) * psi.cos());
        let along_c = FRAC_2_PI * profile + FRAC_2_PI * self.ratio() * (phi / sine + cosine - 1.0);
        let along_a = -FRAC_2_PI * phi * (self.ground.profile().reduced_slope(a) + self.ratio() * cosine / sine);
        -along_c / along_a
    }
}

/// 1 − cos φ without cancellation.
pub(super) fn versine(phi: f64) -> f64 {
    2.0 * (0.5 * phi).sin().powi(2)
}

/// ∫_a^c (c²−x²) dx = (c−a)²(2c+a)/3.
fn ring_area(a: f64, c: f64) -> f64 {
    (c - a).powi(2) * (2.0 * c + a) / 3.0
}

impl Equilibrium for RangeDisc {
    fn value(&self, control: Control, c: f64) -> f64 {
        let state = self.at(c);
        match control {
            Control::Indentation => state.indentation,
            Control::Force => state.force,
        }
    }

    fn slope(&self, control: Control, c: f64) -> f64 {
        if c <= self.touch {
            let step = 1e-6 * c;
            return match control {
                Control::Indentation => {
                    (self.ground.profile().height(c + step) - self.ground.profile().height(c - step)) / (2.0 * step)
                        - FRAC_2_PI * self.ratio()
                }
                Control::Force => -2.0 * PI * self.stress * c,
            };
        }
        let phi = self.neck(c);
        let (sine, cosine) = phi.sin_cos();
        let a = c * cosine;
        let a_slope = self.neck_slope(c, phi);
        let d_slope = self.ground.profile().reduced_slope(a) * a_slope - self.ratio() * (1.0 - cosine * a_slope) / sine;
        match control {
            Control::Indentation => d_slope,
            Control::Force => 2.0 * self.ground.modulus() * a * d_slope - 4.0 * self.stress * c * phi,
        }
    }

    fn known(&self, _control: Control, _target: f64) -> Option<f64> {
        None
    }

    fn start(&self) -> f64 {
        0.0
    }

    fn end(&self) -> f64 {
        self.ground.profile().rim().radius()
    }

    fn scale(&self) -> f64 {
        self.touch
    }

    fn search(&self) -> Search {
        Search::Decades(4.0, self.decades)
    }
}

/// Pressure of the attraction [Pa] at `r` [m]: −(2σ₀/π) arctan √((c²−a²)/(a²−r²)) inside the contact,
/// −σ₀ in the ring a < r < c, nothing beyond.
#[must_use]
pub fn attraction(stress: f64, state: &Balance, r: f64) -> f64 {
    let (a, c) = (state.contact_radius, state.reach);
    if r >= c {
        return 0.0;
    }
    if r >= a {
        return -stress;
    }
    let (over, under) = ((c - a) * (c + a), (a - r) * (a + r));
    -2.0 * FRAC_1_PI * stress * (over / under).sqrt().atan()
}
