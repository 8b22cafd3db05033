//! What a bed asks of a shape: its one-dimensional profile g(x), the integrals over it, and what is told of its contact.

use super::kernel;
use crate::numerics::panelled::{PanelledCurve, SmoothStretch};
use crate::numerics::{quadrature, root};
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, FRAC_PI_2, PI, TAU};

/// How far measured heights were moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moved {
    /// By the most [m].
    pub largest: f64,
    /// Root of the mean square [m].
    pub rms: f64,
}

/// The end of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rim {
    /// The profile goes on for ever.
    None,
    /// A vertical wall at this radius [m]: the contact cannot become larger (flat punch).
    Wall(f64),
    /// The profile is not defined beyond this radius [m] (equator of a sphere, end of a table).
    End(f64),
}

impl Rim {
    /// Radius [m] at which the profile ends; infinite if it goes on for ever.
    #[must_use]
    pub fn radius(self) -> f64 {
        match self {
            Self::None => f64::INFINITY,
            Self::Wall(end) | Self::End(end) => end,
        }
    }
}

/// An axisymmetric profile, ready for evaluation. Lengths in metres.
///
/// The contact of radius a with indentation d = g(a) carries F = 2E*∫₀^a (d − g) dx, which is
/// 2E*·[`load_integral`](Profile::load_integral): every quantity below is a sum of terms of one
/// sign for a profile with growing g, so none of them loses digits.
pub trait Profile: std::fmt::Debug + Send + Sync {
    /// Height f(r) [m] of the profile above its apex at the radius `r` [m].
    fn height(&self, r: f64) -> f64;

    /// One-dimensional profile g(x) [m] at `x` ≥ 0 [m].
    fn reduced(&self, x: f64) -> f64;

    /// Slope g′(x) of the one-dimensional profile at `x` ≥ 0 [m].
    fn reduced_slope(&self, x: f64) -> f64;

    /// N(a) = ∫₀^a x g′(x) dx = ∫₀^a (g(a) − g(x)) dx [m²]; the normal force is F = 2E*N.
    fn load_integral(&self, a: f64) -> f64 {
        quadrature::panels(|x| x * self.reduced_slope(x), (0.0, a), &self.breaks(a))
    }

    /// ∫₀^a (g(a) − g(x))² dx [m³]; the elastic energy is U = E* times it.
    fn energy_integral(&self, a: f64) -> f64 {
        quadrature::panels(|x| 2.0 * self.reduced_slope(x) * self.load_integral(x), (0.0, a), &self.breaks(a))
    }

    /// (1/π) ∫_r^a g′(x) dx/√(x²−r²) [1], the pressure of the regular part divided by E*, r < a.
    ///
    /// Infinite at the apex of a cone.
    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        // x = √(r² + s²) takes the root away: dx/√(x²−r²) = ds/x.
        let to_s = |x: f64| ((x - r) * (x + r)).sqrt();
        let breaks: Vec<f64> = self.breaks(a).into_iter().filter(|&x| x > r).map(to_s).collect();
        let at = |s: f64| {
            let x = r.hypot(s);
            self.reduced_slope(x) / x
        };
        FRAC_1_PI * quadrature::panels(at, (0.0, to_s(a)), &breaks)
    }

    /// (2/π) ∫₀^a (g(a) − g(x)) dx/√(r²−x²) [m], r ≥ a: the surface displacement outside the contact
    /// if the edge carries no load.
    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        // By parts ∫ g′(x) arcsin(x/r) dx, a sum of one sign; x = r sin θ takes the root at r away.
        let angle = |x: f64| x.atan2(((r - x).max(0.0) * (r + x)).sqrt());
        let breaks: Vec<f64> = self.breaks(a).into_iter().map(angle).collect();
        let at = |theta: f64| self.reduced_slope(r * theta.sin()) * theta * r * theta.cos();
        FRAC_2_PI * quadrature::panels(at, (0.0, angle(a)), &breaks)
    }

    /// The contact radius a [m] at the indentation `d` ≥ 0 [m] without adhesion: the largest a with
    /// g(a) = d; the flat radius at d = 0. `None` beyond the end of the profile.
    fn edge(&self, d: f64) -> Option<f64> {
        edge_by_search(self, d)
    }

    /// n of a profile that is a power g ∝ xⁿ of the radius all the way; `None` of others.
    fn power(&self) -> Option<f64> {
        None
    }

    /// Radius [m] up to which g = 0 (the flat of a truncated cone), else 0.
    fn flat_radius(&self) -> f64 {
        0.0
    }

    /// Where the profile ends.
    fn rim(&self) -> Rim {
        Rim::None
    }

    /// A radius [m] typical of the profile, from which searches start.
    fn scale(&self) -> f64;

    /// The shortest length [m] over which g′ may rise and fall again; `None` for a convex profile,
    /// whose g′ is monotone.
    fn feature(&self) -> Option<f64> {
        None
    }

    /// Radius [m] of an edge or of a change of law, about which g′ may rise and fall over any scale
    /// (truncated and rounded shapes); `None` where there is none.
    fn kink(&self) -> Option<f64> {
        None
    }

    /// Radius [m] at which g′ first becomes negative: a larger contact would not stay simply
    /// connected and the mapping would not be exact. `None` if that never happens.
    fn first_fall(&self) -> Option<f64> {
        None
    }

    /// How far measured heights were moved to make them rise; `None` of others.
    fn moved(&self) -> Option<Moved> {
        None
    }

    /// Relative error of force and radius at the contact radius `a` [m] for what is not known of the shape; zero of a
    /// shape given by a formula.
    fn sampling_error(&self, _a: f64) -> f64 {
        0.0
    }

    /// Relative error of depth and stiffness where they come of tables; zero of closed forms.
    fn table_error(&self) -> f64 {
        0.0
    }

    /// Places in (0, a) where g′ or one of its derivatives jumps or where a quadrature panel should
    /// end, ascending [m].
    fn breaks(&self, a: f64) -> Vec<f64> {
        self.kink().map_or_else(Vec::new, |b| kernel::OutsideKink(b).breaks(a))
    }

    /// Whether the contact is that of a section long across, see [`Lying`](super::Lying).
    fn is_plane(&self) -> bool {
        false
    }

    /// Whether places x in the bed are not radii: of a section, and over layers.
    fn is_mapped(&self) -> bool {
        self.is_plane()
    }

    /// The shape itself, where what lies below makes another profile of it.
    fn bare(&self) -> Option<&dyn Profile> {
        None
    }

    /// Whether g is x² times a number, up to any x.
    fn is_square(&self) -> bool {
        false
    }

    /// Radius [m] of the widest contact that is known of what lies below, looked for no further than `asked` [m].
    fn known_to(&self, _asked: f64) -> f64 {
        f64::INFINITY
    }

    /// Radius [m] of the widest contact whose pressure and surface are known of what lies below.
    fn fields_known_to(&self) -> f64 {
        f64::INFINITY
    }

    /// Radius, or half width of a section, [m] of a contact whose bed ends at the place `x` [m].
    fn contact_radius(&self, x: f64) -> f64 {
        x
    }

    /// Place x in the bed [m] that belongs to the radius, or half width, `radius` [m].
    fn place(&self, radius: f64) -> f64 {
        radius
    }

    /// Area A [m²] of a contact whose bed ends at the place `x` [m].
    fn contact_area(&self, x: f64) -> f64 {
        PI * x * x
    }

    /// A′(x) [m]: an edge pulled by Δl releases the energy E*Δl²/A′ per area.
    fn contact_area_slope(&self, x: f64) -> f64 {
        TAU * x
    }

    /// d ln A′/d ln x [1].
    fn contact_area_bend(&self, _x: f64) -> f64 {
        1.0
    }

    /// dA/dr [m], by which the area grows with the radius, or half width, `radius` [m].
    fn ring(&self, radius: f64) -> f64 {
        TAU * radius
    }

    /// Displacement [1] of the middle of the contact, times the modulus, under a stress of one at the radius `radius`
    /// [m], per radius: u(0) = (2/E*) ∫p dr.
    fn under_middle(&self, _radius: f64) -> f64 {
        2.0
    }

    /// Pressure [1/m] at the place `r` < `a` under an edge at `a` that carries the line load one.
    fn edge_pressure(&self, r: f64, a: f64) -> f64 {
        FRAC_1_PI / ((a - r) * (a + r)).sqrt()
    }

    /// Displacement [1] of the surface at the place `r` ≥ `a` under an edge at `a` displaced by one.
    fn edge_surface(&self, r: f64, a: f64) -> f64 {
        FRAC_2_PI * (a / r).min(1.0).asin()
    }

    /// Pressure [Pa] at the place `r` under the line load `load` q(x) [N/m], which is zero beyond its last panel.
    ///
    /// By parts, with x² = r² + s²: π p(r) = q(r)/√(a²−r²) + ∫ (q(r) − q(x))/s² ds.
    fn pressure_of(&self, load: &PanelledCurve<'_>, r: f64) -> f64 {
        let Some(&a) = load.ends().last() else { return 0.0 };
        if r >= a {
            return 0.0;
        }
        let here = load.at(r);
        let to_s = |x: f64| ((x - r) * (x + r)).sqrt();
        let part = |panel: SmoothStretch<'_>| {
            if panel.is_far_from(r) {
                return panel.sum(|x, q| x * (here - q) / to_s(x).powi(3));
            }
            let fall = |s: f64| (here - load.at(r.hypot(s))) / (s * s);
            quadrature::panel(fall, to_s(panel.low.max(r)), to_s(panel.high))
        };
        FRAC_1_PI * (here / to_s(a) + load.panels().filter(|panel| panel.high > r).map(part).sum::<f64>())
    }

    /// Displacement [m] of the surface at the place `r` [m] over springs displaced by `displacement` u(x) [m], those beyond
    /// its last panel not at all.
    ///
    /// u_z(r) = (2/π) ∫₀^r u(x) dx/√(r²−x²); x = r sin θ takes the root away. The transform knows no time: springs let
    /// go and still creeping back count with what is left of their displacement.
    fn surface_of(&self, displacement: &PanelledCurve<'_>, r: f64) -> f64 {
        let angle = |x: f64| if x < r { (x / r).asin() } else { FRAC_PI_2 };
        let part = |panel: SmoothStretch<'_>| {
            if panel.is_far_from(r) {
                return panel.sum(|x, u| u / ((r - x) * (r + x)).sqrt());
            }
            let turned = |theta: f64| displacement.at(r * theta.sin());
            quadrature::panel(turned, angle(panel.low), angle(panel.high))
        };
        FRAC_2_PI * displacement.panels().filter(|panel| panel.low < r).map(part).sum::<f64>()
    }
}

/// The largest a [m] with g(a) = `d` [m] of any profile, searched from its scale upwards; see [`Profile::edge`].
#[must_use]
pub fn edge_by_search(profile: &(impl Profile + ?Sized), d: f64) -> Option<f64> {
    let limit = match profile.rim() {
        Rim::None => f64::MAX,
        Rim::Wall(b) => {
            if profile.reduced(b) <= d {
                return Some(b);
            }
            b
        }
        Rim::End(end) => end,
    };
    let residual = |x: f64| profile.reduced(x) - d;
    let flat = profile.flat_radius();
    if d <= 0.0 {
        return Some(flat);
    }
    let start = profile.scale().min(limit);
    let (low, high) = root::bracket_upwards(residual, flat, start.max(2.0 * flat), limit)?;
    root::brent(residual, low, high).ok()
}

/// g(x) from f′(r) by the integral over θ, which has no singularity.
///
/// `slope` is f′(r); `breaks` are radii below `x` where f′ or a derivative of it jumps.
pub fn reduced_by_integral(slope: impl Fn(f64) -> f64, x: f64, breaks: &[f64]) -> f64 {
    let angles: Vec<f64> = breaks.iter().filter(|&&r| r > 0.0 && r < x).map(|&r| (r / x).asin()).collect();
    x * quadrature::panels(|theta| slope(x * theta.sin()), (0.0, FRAC_PI_2), &angles)
}

/// f(r) from g(x) by the inverse transform; `breaks` as for the forward one.
pub fn height_by_integral(reduced: impl Fn(f64) -> f64, r: f64, breaks: &[f64]) -> f64 {
    let angles: Vec<f64> = breaks.iter().filter(|&&x| x > 0.0 && x < r).map(|&x| (x / r).asin()).collect();
    FRAC_2_PI * quadrature::panels(|theta| reduced(r * theta.sin()), (0.0, FRAC_PI_2), &angles)
}
