//! Many elements of scattered heights: sums over those that are joined.

use super::element::{Carried, Element, Hold, Summit};
use crate::contact::adhesion::line::Energy;
use crate::numerics::normal::{Below, density};
use crate::numerics::quadrature;
use std::f64::consts::PI;

/// Elements whose heights are scattered normally: N φ(z/σ)/σ of them per height z below the mean plane.
///
/// Those are joined that lie above the edge e, z < e, pressed in by d − z: every sum is N ∫_{−∞}^e X(d − z) φ(z/σ) dz/σ.
/// Of springs in closed form, F = Nk[(d − e)Φ + σ(φ + tΦ)] at t = e/σ; of summits by Gauss's rule over their radii,
/// where both the branch and its turning point are smooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bed {
    /// Number N of the elements; springs are told as one that stands for all.
    pub number: f64,
    /// Standard deviation σ [m] of the heights.
    pub deviation: f64,
    /// What they are.
    pub element: Element,
}

/// Sums over the elements that are joined.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sums {
    /// Force [N].
    pub force: f64,
    /// Stiffness [N/m] while none joins or leaves.
    pub stiffness: f64,
    /// Stored energy [J].
    pub stored: Energy,
    /// Share of the elements.
    pub share: f64,
    /// Area of contact [m²] of summits.
    pub area: Option<f64>,
}

/// Deviations beyond which no element is: one in 10¹⁵ is.
pub const REACH: f64 = 8.0;
/// Exponent beyond which a part of the density is no more than rounding.
const GONE: f64 = 80.0;
/// Panels of 32 nodes over the radii: over the widest of them the heights change by less than a deviation.
const PANELS: u32 = 24;

impl Bed {
    /// How far an element holds.
    #[must_use]
    pub fn hold(&self) -> Hold {
        self.element.hold()
    }

    /// The sums at the depth `d` [m] over the elements above the edge `e` [m].
    #[must_use]
    pub fn sums(&self, d: f64, e: f64) -> Sums {
        if e <= -REACH * self.deviation {
            return Sums { area: self.summit().map(|_| 0.0), ..Sums::default() };
        }
        match self.element {
            Element::Spring(spring) => {
                let Below { share, first, second } = Below::of(e / self.deviation);
                let (edge, sigma) = (d - e, self.deviation);
                let square = edge * edge * share + 2.0 * edge * sigma * first + sigma * sigma * second;
                let k = self.number * spring.stiffness;
                let stored = Energy { elastic: 0.5 * k * square, surface: -self.number * spring.work * share };
                Sums { force: k * (edge * share + sigma * first), stiffness: k * share, stored, share, area: None }
            }
            Element::Summit(summit) => self.over_radii(&summit, (d, e)),
        }
    }

    /// The summits, if it is these.
    fn summit(&self) -> Option<Summit> {
        match self.element {
            Element::Spring(_) => None,
            Element::Summit(summit) => Some(summit),
        }
    }

    /// Sums over the radii a, from that of the edge to that of the highest summit.
    fn over_radii(&self, summit: &Summit, (d, e): (f64, f64)) -> Sums {
        let t = e / self.deviation;
        let highest = -self.deviation * (t.min(0.0).powi(2) + GONE).sqrt();
        let lowest = e.min(self.deviation * (REACH + 2.0));
        let radius = |z: f64| summit.contact_radius((d - z).max(-self.hold().leaves));
        let (low, high) = (radius(lowest), radius(highest));
        let mut sums = Sums { share: Below::of(t).share, area: Some(0.0), ..Sums::default() };
        let half = 0.5 * (high - low) / f64::from(PANELS);
        for panel in 0..PANELS {
            let middle = low + half * f64::from(2 * panel + 1);
            for &(x, weight) in quadrature::nodes() {
                let weight = half * weight * self.number / self.deviation;
                self.add(summit, (d, middle + half * x), weight, &mut sums);
            }
        }
        sums
    }

    fn add(&self, summit: &Summit, (d, a): (f64, f64), weight: f64, sums: &mut Sums) {
        let weight = weight * density((d - summit.depth(a)) / self.deviation);
        let Carried { force, stored } = summit.carried(a);
        let heights = weight * summit.depth_growth(a);
        sums.force += heights * force;
        sums.stiffness += weight * summit.force_growth(a);
        sums.stored.elastic += heights * stored.elastic;
        sums.stored.surface += heights * stored.surface;
        sums.area = sums.area.map(|area| area + heights * PI * a * a);
    }

    /// dF/dd [N/m] as the edge, `e` [m], goes along with the depth, `e` − `stretch`.
    #[must_use]
    pub fn slope(&self, e: f64, stretch: f64) -> f64 {
        let edge = self.number * self.element.carried(-stretch).force / self.deviation * density(e / self.deviation);
        self.sums(e - stretch, e).stiffness + edge
    }

    /// Elements [1] between two edges [m].
    #[must_use]
    pub fn between(&self, from: f64, to: f64) -> f64 {
        let share = |e: f64| Below::of(e / self.deviation).share;
        self.number * (share(to) - share(from)).abs()
    }
}
