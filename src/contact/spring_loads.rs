//! Pressure and surface of a bed of springs, from the loads and displacements of the springs.
//!
//! # Examples
//! ```
//! use springbed::contact::model::Loading;
//! use springbed::contact::springs::SpringBed;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Pressure read off a bed: Hertz' 2E*a/πR on the axis, R = E* = a = 1.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let mut bed = SpringBed::new(ground, 1000, 1.1, 0.0);
//! bed.indent(1.0);
//! let peak = bed.spring_loads().pressure(0.0).unwrap();
//! assert!((peak / std::f64::consts::FRAC_2_PI - 1.0).abs() < 1e-2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::loaded::Loaded;
use super::model::Loading;
use crate::numerics::panelled::PanelledCurve;
use crate::shape::Profile;
use std::f64::consts::FRAC_1_PI;
use std::sync::Arc;

/// Springs that are looked at one by one; of a larger bed neighbours are put together.
const MOST: usize = 4096;
/// Panels over which the loads are summed for stresses below the surface.
const PANELS: u32 = 16;

/// One spring, or a few neighbours put together.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SeenSpring {
    /// Distance from the axis [m].
    pub place: f64,
    /// Line load q [N/m].
    pub load: f64,
    /// Width of both halves of the bed, 2Δx [m].
    pub weight: f64,
    /// Displacement u [m] into the body.
    pub displacement: f64,
}

/// The springs of a bed at one instant, as a value.
///
/// p(r) is the inverse transform of the line loads joined by straight lines, with the edge load for the
/// singular term; u_z(r) = (1/π) Σ 2Δx u/√(r²−x²) outside the contact, d − f(r) in it (Popov & Heß 2015, eqs.
/// 3.37 and 3.40). A radius costs at most a few thousand springs, whatever the bed has.
#[derive(Debug)]
pub struct SpringLoads {
    springs: Vec<SeenSpring>,
    contact_radius: f64,
    edge_load: f64,
    depth: f64,
    profile: Arc<dyn Profile>,
}

impl SpringLoads {
    /// The springs touched so far, `count` of them by their number from the axis outwards, under `profile` at the
    /// depth `depth` [m].
    pub fn new(profile: Arc<dyn Profile>, depth: f64, count: usize, spring: impl Fn(usize) -> SeenSpring) -> Self {
        let block = count.div_ceil(MOST).max(1);
        let springs = (0..count).step_by(block).map(|first| together((first..count.min(first + block)).map(&spring)));
        Self { springs: springs.collect(), contact_radius: 0.0, edge_load: 0.0, depth, profile }
    }

    /// The same with the edge of the contact at the radius `radius` [m], where the line load is `load` [N/m].
    #[must_use]
    pub fn with_edge(self, radius: f64, load: f64) -> Self {
        Self { contact_radius: radius, edge_load: load, ..self }
    }
}

/// Neighbours as one spring: their widths summed, the rest averaged.
fn together(springs: impl ExactSizeIterator<Item = SeenSpring>) -> SeenSpring {
    let count = springs.len() as f64;
    let sum = springs.fold(SeenSpring::default(), |sum, spring| SeenSpring {
        place: sum.place + spring.place,
        load: sum.load + spring.load,
        weight: sum.weight + spring.weight,
        displacement: sum.displacement + spring.displacement,
    });
    SeenSpring {
        place: sum.place / count,
        load: sum.load / count,
        weight: sum.weight,
        displacement: sum.displacement / count,
    }
}

/// Value at `x` of points joined by straight lines, that of the first before it.
fn between(points: &[[f64; 2]], x: f64) -> f64 {
    let k = points.partition_point(|point| point[0] < x);
    match (k.checked_sub(1).map(|k| points[k]), points.get(k)) {
        (Some([x0, y0]), Some(&[x1, y1])) => y0 + (y1 - y0) * (x - x0) / (x1 - x0),
        (None, Some(point)) => point[1],
        (Some(_), None) | (None, None) => 0.0,
    }
}

impl Loading for SpringLoads {
    fn contact_radius(&self) -> f64 {
        self.contact_radius
    }

    fn pressure(&self, r: f64) -> Option<f64> {
        let a = self.contact_radius;
        if r >= a {
            return Some(0.0);
        }
        if self.profile.is_mapped() {
            return self.loaded().map(|loaded| loaded.pressure(r)).filter(|pressure| pressure.is_finite());
        }
        // On the axis itself the transform is the limit of a small radius.
        let r = r.max(1e-6 * self.springs.first().map_or(a, |spring| spring.weight));
        let loads = self.springs.iter().map(|spring| (spring.place, spring.load)).filter(|load| load.0 < a);
        let (mut sum, mut last) = (0.0, None);
        for (x, q) in loads.chain([(a, self.edge_load)]) {
            if let Some((x0, q0)) = last.filter(|_: &(f64, f64)| x > r) {
                sum -= (q - q0) / (x - x0) * ((x / r).acosh() - (x0 / r).max(1.0).acosh());
            }
            last = Some((x, q));
        }
        let singular = if self.edge_load.abs() > 0.0 { self.edge_load / ((a - r) * (a + r)).sqrt() } else { 0.0 };
        Some(FRAC_1_PI * (sum + singular)).filter(|pressure| pressure.is_finite())
    }

    fn surface(&self, r: f64) -> Option<f64> {
        if r <= self.contact_radius {
            return Some(self.depth - self.profile.height(r));
        }
        if self.profile.is_mapped() {
            return self.loaded().map(|loaded| loaded.surface(r));
        }
        let part = |spring: &SeenSpring| {
            spring.weight * spring.displacement / ((r - spring.place) * (r + spring.place)).sqrt()
        };
        let inside = self.springs.iter().take_while(|spring| spring.place < r);
        Some(FRAC_1_PI * inside.map(part).sum::<f64>()).filter(|displacement| displacement.is_finite())
    }

    fn loaded(&self) -> Option<Loaded> {
        let a = self.contact_radius;
        let inside = self.springs.iter().filter(|spring| spring.place < a);
        let loads: Vec<[f64; 2]> =
            inside.map(|spring| [spring.place, spring.load]).chain([[a, self.edge_load]]).collect();
        let ends = (1..=PANELS).map(|k| a * f64::from(k) / f64::from(PANELS)).collect();
        let raised: Vec<[f64; 2]> = self.springs.iter().map(|spring| [spring.place, spring.displacement]).collect();
        let all = self.springs.last().map(|spring| spring.place).into_iter().collect();
        let (load, displacement) = (
            PanelledCurve::new(move |x| between(&loads, x), ends),
            PanelledCurve::new(move |x| between(&raised, x), all),
        );
        Some(Loaded::remembered(self.profile.clone(), self.depth, load, displacement))
    }
}
