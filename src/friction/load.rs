//! The normal load as a function of the depth, in increments that lose no digits.
//!
//! Friction asks for the part of the load, of the energy and of the pressure that lies between two
//! depths; fretting at an amplitude of 10⁻¹² of the depth asks for it between two depths that agree
//! in twelve digits. A narrow slice is therefore integrated over the depth, a wide one is the
//! difference of the closed forms of the profile.
//!
//! # Examples
//! ```
//! use springbed::friction::load::{Carried, LinearProduct, NormalLoad, Slice, SpringDepth};
//! use springbed::friction::{Grip, Pose, TangentialMemory};
//!
//! // A contact known by its stiffness, force and energy alone: here 2E*b, 2E*bd and E*bd² of a punch.
//! struct Punch(f64);
//!
//! impl Punch {
//!     fn carried(&self, at: SpringDepth) -> Carried {
//!         Carried { radius: self.0, load: self.0 * at.depth(), energy: self.0 * at.depth().powi(2) }
//!     }
//! }
//!
//! impl NormalLoad for Punch {
//!     fn place(&self, reference: f64, below: f64) -> Option<SpringDepth> {
//!         Some(SpringDepth::new((reference, below), self.0))
//!     }
//!     fn increment(&self, (lower, upper): Slice) -> f64 {
//!         self.carried(upper).load - self.carried(lower).load
//!     }
//!     fn integral(&self, (lower, upper): Slice, product: LinearProduct) -> f64 {
//!         Carried::integral(&self.carried(lower), &self.carried(upper), lower.rise(upper), product)
//!     }
//! }
//!
//! // Pressed to d = 0.2 and slid by 0.07, short of μE*d/G* = 0.075: it sticks, F_x = 2G*bu.
//! let grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient: 0.3 };
//! let mut contact = TangentialMemory::over(Punch(0.5), grip);
//! contact.advance(Pose { indentation: 0.2, slide: 0.0 })?;
//! contact.advance(Pose { indentation: 0.2, slide: 0.07 })?;
//! assert!((contact.state().tangential_force - 2.0 * 0.8 * 0.5 * 0.07).abs() < 1e-16);
//! # Ok::<(), springbed::friction::FrictionError>(())
//! ```

use crate::numerics::quadrature::node_and_weight;
use crate::shape::{Profile, Rim};
use std::sync::Arc;
use std::sync::LazyLock;

/// Nodes of the rule for narrow slices. In a slice of at most half the depth x(h) is analytic inside
/// an ellipse with half-axes 3 and √8 (the nearest singularity is the apex), so the error falls as
/// (3 + √8)⁻²ⁿ: rounding at n = 10.
const NODES: usize = 10;

/// Pairs (node, weight) on [0, 1].
static RULE: LazyLock<[(f64, f64); NODES]> = LazyLock::new(|| {
    std::array::from_fn(|k| {
        let (x, w) = node_and_weight(NODES, k);
        (0.5 + 0.5 * x, 0.5 * w)
    })
});

/// A slice above this fraction of its depth is taken as a difference, with at most 1/this units of
/// rounding more than the closed form.
const NARROW: f64 = 0.125;

/// The place of a spring in the bed: the depth h = g(x) at which it is touched, kept as a
/// difference so that springs near the edge keep their digits.
#[derive(Debug, Clone, Copy)]
pub struct SpringDepth {
    reference: f64,
    below: f64,
    /// Distance x of the spring from the axis [m]; of a contact that is not round, that of the round one of its stiffness.
    pub radius: f64,
}

impl SpringDepth {
    /// The axis, where contact begins.
    pub const AXIS: Self = Self { reference: 0.0, below: 0.0, radius: 0.0 };

    /// The spring at the distance `radius` [m], touched at the depth `reference` − `below` [m].
    #[must_use]
    pub fn new((reference, below): (f64, f64), radius: f64) -> Self {
        Self { reference, below, radius }
    }

    /// Depth h [m] at which the spring is touched.
    #[must_use]
    pub fn depth(self) -> f64 {
        self.reference - self.below
    }

    /// d − h [m] at the indentation `d` [m].
    pub fn below(self, d: f64) -> f64 {
        (d - self.reference) + self.below
    }

    /// How much deeper `upper` is touched [m].
    #[must_use]
    pub fn rise(self, upper: Self) -> f64 {
        self.below(upper.reference) - upper.below
    }
}

/// A slice of the bed between two places, `lower` nearer to the axis.
pub type Slice = (SpringDepth, SpringDepth);

/// Product of two factors linear in the depth, each by its values at the lower and upper place.
#[derive(Debug, Clone, Copy)]
pub struct LinearProduct {
    /// First factor.
    pub first: (f64, f64),
    /// Second factor.
    pub second: (f64, f64),
}

impl LinearProduct {
    /// Value at the fraction `t` of the slice, counted from the upper place downwards.
    fn at(self, t: f64) -> f64 {
        let linear = |(lower, upper): (f64, f64)| upper + t * (lower - upper);
        linear(self.first) * linear(self.second)
    }

    /// ∫ P dx over springs of the width `width` \[m\] whose places grow evenly with the depth.
    #[must_use]
    pub fn over(self, width: f64) -> f64 {
        let (a, b) = (self.first, self.second);
        width * (a.1 * b.1 + 0.5 * (a.1 * (b.0 - b.1) + (a.0 - a.1) * b.1) + (a.0 - a.1) * (b.0 - b.1) / 3.0)
    }

    /// The same product on the part of the slice below the fraction `t`.
    fn below(self, t: f64) -> Self {
        let cut = |(lower, upper): (f64, f64)| (lower, upper + t * (lower - upper));
        Self { first: cut(self.first), second: cut(self.second) }
    }
}

/// How the normal load grows with the depth, which is all that Coulomb's friction asks of a contact: F(d) = 2E* ∫₀^d a(h) dh.
pub trait NormalLoad {
    /// The place touched at the depth `reference` − `below` [m]; `None` where no contact is that deep.
    fn place(&self, reference: f64, below: f64) -> Option<SpringDepth>;

    /// ∫ a(h) dh over the slice [m²]; 2E* times it is the increment of the normal force.
    fn increment(&self, slice: Slice) -> f64;

    /// ∫ P dx over the springs of the slice [m times that of P], P a product of linear functions of the depth.
    fn integral(&self, slice: Slice, product: LinearProduct) -> f64;
}

/// What a contact carries at the depth h = g(x).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Carried {
    /// x [m], its stiffness over 2E*.
    pub radius: f64,
    /// ∫₀ˣ (h − g) dx [m²], its force over 2E*.
    pub load: f64,
    /// ∫₀ˣ (h − g)² dx [m³], its elastic energy over E*.
    pub energy: f64,
}

impl Carried {
    /// ∫ P dx over the springs between two depths `rise` [m] apart, from the moments ∫ zᵏ dx, z the depth below the upper
    /// one: ∫₀ˣ (d − g) dx = y x + N(x) and ∫₀ˣ (d − g)² dx = y² x + 2yN(x) + M(x), y = d − g(x).
    #[must_use]
    pub fn integral(lower: &Self, upper: &Self, rise: f64, product: LinearProduct) -> f64 {
        let width = upper.radius - lower.radius;
        if rise <= 0.0 {
            return product.at(1.0) * width;
        }
        let first = (upper.load - lower.load - rise * lower.radius) / rise;
        let second = (upper.energy - lower.energy - rise * (rise * lower.radius + 2.0 * lower.load)) / (rise * rise);
        let (a, b) = (product.first, product.second);
        let (slope_a, slope_b) = (a.0 - a.1, b.0 - b.1);
        a.1 * b.1 * width + (a.1 * slope_b + slope_a * b.1) * first + slope_a * slope_b * second
    }
}

/// The load of a round contact, from its profile.
#[derive(Debug, Clone)]
pub struct LoadCurve {
    /// The profile.
    pub profile: Arc<dyn Profile>,
    wall: f64,
}

impl NormalLoad for LoadCurve {
    fn place(&self, reference: f64, below: f64) -> Option<SpringDepth> {
        let depth = reference - below;
        let radius = if depth > 0.0 { self.profile.edge(depth)? } else { 0.0 };
        Some(SpringDepth { reference, below, radius })
    }

    fn increment(&self, (lower, upper): Slice) -> f64 {
        let rise = lower.rise(upper);
        if lower.depth() >= self.wall {
            return rise * upper.radius;
        }
        if self.is_narrow((lower, upper)) {
            return rise * self.mean((lower, upper), |_, x| x);
        }
        self.load(upper) - self.load(lower)
    }

    fn integral(&self, (lower, upper): Slice, product: LinearProduct) -> f64 {
        let rise = lower.rise(upper);
        if lower.depth() > self.wall {
            return 0.0;
        }
        if upper.depth() > self.wall {
            let top = SpringDepth { reference: self.wall, below: 0.0, radius: upper.radius };
            let t = if rise > 0.0 { top.rise(upper) / rise } else { 0.0 };
            return self.wide((lower, top), product.below(t));
        }
        if self.is_narrow((lower, upper)) {
            let sum = self.mean((lower, upper), |t, x| product.at(t) / self.profile.reduced_slope(x));
            if sum.is_finite() {
                return rise * sum;
            }
        }
        self.wide((lower, upper), product)
    }
}

impl LoadCurve {
    /// The curve of a profile.
    pub fn new(profile: Arc<dyn Profile>) -> Self {
        let wall = match profile.rim() {
            Rim::Wall(b) => profile.reduced(b),
            Rim::None | Rim::End(_) => f64::INFINITY,
        };
        Self { profile, wall }
    }

    /// The radius and depth of a vertical wall, if the indentation `d` [m] reaches above it.
    pub fn wall_below(&self, d: f64) -> Option<SpringDepth> {
        (d >= self.wall).then_some(())?;
        Some(SpringDepth { reference: self.wall, below: 0.0, radius: self.profile.edge(d)? })
    }

    /// ∫₀^h a dh up to the depth h of a place [m²].
    pub fn load(&self, at: SpringDepth) -> f64 {
        self.profile.load_integral(at.radius) + at.radius * (at.depth() - self.wall).max(0.0)
    }

    /// The integral from what the profile carries at both places.
    fn wide(&self, (lower, upper): Slice, product: LinearProduct) -> f64 {
        let carried = |at: SpringDepth| Carried {
            radius: at.radius,
            load: self.profile.load_integral(at.radius),
            energy: self.profile.energy_integral(at.radius),
        };
        Carried::integral(&carried(lower), &carried(upper), lower.rise(upper), product)
    }

    /// (1/π) ∫ g′(x) dx/√(x²−r²) over the springs of the slice beyond `r` [1]: its share of the
    /// pressure at `r`, divided by E*.
    pub fn pressure(&self, r: f64, (lower, upper): Slice) -> f64 {
        // A cone has no pressure at its apex; the slice has, and moves by (r/x)² = 10⁻¹⁸.
        let r = r.max(1e-9 * lower.radius);
        if upper.radius <= r || lower.depth() >= self.wall {
            return 0.0;
        }
        let clear = upper.radius - lower.radius <= 0.5 * (lower.radius - r);
        if clear && upper.depth() <= self.wall && self.is_narrow((lower, upper)) {
            let kernel = |_, x: f64| self.profile.edge_pressure(r, x);
            return lower.rise(upper) * self.mean((lower, upper), kernel);
        }
        let inner = if lower.radius > r { self.profile.pressure_integral(r, lower.radius) } else { 0.0 };
        self.profile.pressure_integral(r, upper.radius) - inner
    }

    fn is_narrow(&self, (lower, upper): Slice) -> bool {
        let calm = self.profile.feature().is_none_or(|length| upper.radius - lower.radius <= 0.25 * length);
        // From nothing on no slice is narrow, whatever the rounding of places far above leaves of its rise.
        let rise = lower.rise(upper).max(upper.depth() - lower.depth());
        calm && rise <= NARROW * upper.depth() && upper.depth() <= self.wall
    }

    /// ∫₀¹ f(t, x(t)) dt, t the fraction of the slice counted from the upper place downwards.
    fn mean(&self, (lower, upper): Slice, f: impl Fn(f64, f64) -> f64) -> f64 {
        let (rise, depth) = (lower.rise(upper), upper.depth());
        let radius = |t: f64| {
            let x = self.profile.edge(depth - t * rise).unwrap_or(upper.radius);
            x.clamp(lower.radius.min(upper.radius), upper.radius)
        };
        let panel = |from: f64, to: f64| {
            let at = |t: f64| f(t, radius(t));
            (to - from) * RULE.iter().map(|&(x, w)| w * at(from + x * (to - from))).sum::<f64>()
        };
        let (mut from, mut sum) = (0.0, 0.0);
        for x in self.profile.breaks(upper.radius).into_iter().rev() {
            if x > lower.radius && x < upper.radius {
                let to = ((depth - self.profile.reduced(x)) / rise).clamp(from, 1.0);
                sum += panel(from, to);
                from = to;
            }
        }
        sum + panel(from, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::{Length, Positive};
    use crate::shape::{Cone, Paraboloid, Power};

    fn parabola() -> Paraboloid {
        Paraboloid { radius: Length::new(1.0).unwrap() }
    }

    #[test]
    fn narrow_and_wide_slices_are_exact() {
        // N(h) = (2/3) h^{3/2}: the increment below d = 1 is (2/3)(1 − (1−y)^{3/2}).
        let shape = parabola();
        let curve = LoadCurve::new(Arc::new(shape.clone()));
        let upper = curve.place(1.0, 0.0).unwrap();
        for k in 0..=160 {
            let y = 10f64.powf(-0.1 * f64::from(k));
            let lower = curve.place(1.0, y).unwrap();
            let exact = -2.0 / 3.0 * (1.5 * (-y).ln_1p()).exp_m1();
            assert!((curve.increment((lower, upper)) / exact - 1.0).abs() < 2e-14, "{y:e}");
        }
    }

    #[test]
    fn moments_of_a_cone_are_exact() {
        // x = h·2/π for unit slope: ∫ z² dx = (2/π) y³/3 for a slice of height y.
        let shape = Cone { slope: Positive::new(1.0).unwrap() };
        let curve = LoadCurve::new(Arc::new(shape.clone()));
        let upper = curve.place(1.0, 0.0).unwrap();
        for k in 0..=140 {
            let y = 10f64.powf(-0.1 * f64::from(k));
            let lower = curve.place(1.0, y).unwrap();
            let square = LinearProduct { first: (y, 0.0), second: (y, 0.0) };
            let exact = std::f64::consts::FRAC_2_PI * y.powi(3) / 3.0;
            let error = curve.integral((lower, upper), square) / exact - 1.0;
            // Wide slices cancel down to y³ ≥ NARROW³ = 2·10⁻³.
            assert!(error.abs() < 1e-12, "{y:e} {error:e}");
        }
    }

    #[test]
    fn moments_of_a_power_agree_across_the_switch() {
        let shape = Power { coefficient: Positive::new(1.0).unwrap(), exponent: Positive::new(2.5).unwrap() };
        let curve = LoadCurve::new(Arc::new(shape.clone()));
        let upper = curve.place(1.0, 0.0).unwrap();
        let lower = curve.place(1.0, 0.99 * NARROW).unwrap();
        let product = LinearProduct { first: (1.0, 0.25), second: (0.5, 2.0) };
        let narrow = curve.integral((lower, upper), product);
        assert!((curve.wide((lower, upper), product) / narrow - 1.0).abs() < 1e-12);
    }

    #[test]
    fn pressure_slices_add_up() {
        let shape = parabola();
        let curve = LoadCurve::new(Arc::new(shape.clone()));
        let places: Vec<SpringDepth> = [1.0, 0.7, 0.1, 1e-3, 1e-9, 0.0].map(|y| curve.place(1.0, y).unwrap()).to_vec();
        for r in [0.0, 0.3, 0.9, 0.999, 1.0] {
            let sum: f64 = places.windows(2).map(|w| curve.pressure(r, (w[0], w[1]))).sum();
            assert!((sum - shape.pressure_integral(r, 1.0)).abs() < 1e-14, "{r}");
        }
    }
}
