//! The energy that slipping springs lose in one straight step.
//!
//! A spring that slips the way ℓ under a limit that goes from m y₀ to m y₁ loses G*m²ℓ (y₀ + y₁)/2,
//! y the depth of the spring below the indentation. ℓ and y are linear functions of the depth at
//! which the spring was touched, so the loss of a piece of the memory is a sum of moments, and
//! every term of it is positive.

use super::load::{LinearProduct, NormalLoad, SpringDepth};

/// A vertex of the memory as a new position sees it; displacements are divided by m = μE*/G*.
#[derive(Debug, Clone, Copy)]
pub struct Node {
    /// The spring.
    pub place: SpringDepth,
    /// Its depth y [m] below the new indentation; negative if it has been left.
    pub below: f64,
    /// Its tangential displacement if it had stuck [m].
    pub displacement: f64,
}

impl Node {
    /// Whether the spring sticks.
    pub fn is_inside(&self) -> bool {
        self.displacement.abs() <= self.below
    }

    /// Slope of the chord to the new position; zero of a step of no length.
    pub fn chord(&self) -> f64 {
        if self.below > 0.0 { self.displacement / self.below } else { 0.0 }
    }
}

/// A straight step: its depth and its slide, the latter divided by m, and the edge it leads to.
#[derive(Debug, Clone, Copy)]
pub struct SlideStep {
    /// Growth of the indentation [m].
    pub depth: f64,
    /// Slide divided by m [m].
    pub slide: f64,
    /// The new edge.
    pub edge: SpringDepth,
}

impl SlideStep {
    /// Growth of y per unit of slip towards `side`.
    fn growth(self, side: f64) -> f64 {
        let ratio = self.depth / (side * self.slide - self.depth);
        if ratio.is_finite() { ratio } else { 0.0 }
    }
}

/// ∫ ℓ (y₀ + y₁)/2 dx [m³] over the springs between two vertices, all of which slip.
pub fn slip_work(curve: &impl NormalLoad, (lower, upper): (Node, Node), motion: SlideStep) -> f64 {
    if upper.below < 0.0 && lower.below > 0.0 {
        let edge = between(lower, upper, upper.below / (upper.below - lower.below), motion.edge);
        return held(curve, (lower, edge), motion) + left(curve, (edge, upper), motion);
    }
    // A contact that does not shrink leaves no spring; one at its very edge carries nothing.
    let work = if lower.below > 0.0 || motion.depth >= 0.0 { held } else { left };
    work(curve, (lower, upper), motion)
}

/// Springs still in contact after the step.
fn held(curve: &impl NormalLoad, (lower, upper): (Node, Node), motion: SlideStep) -> f64 {
    let side = (lower.displacement + upper.displacement).signum();
    let growth = motion.growth(side);
    let way = |node: Node| (side * node.displacement - node.below).max(0.0);
    let limit = |node: Node| (node.below - 0.5 * growth * way(node)).max(0.5 * node.below);
    let product = LinearProduct { first: (way(lower), way(upper)), second: (limit(lower), limit(upper)) };
    curve.integral((lower.place, upper.place), product)
}

/// Springs that have lost contact in the step; at the last they carried nothing.
fn left(curve: &impl NormalLoad, (lower, upper): (Node, Node), motion: SlideStep) -> f64 {
    let chord = motion.slide / motion.depth;
    let way = |node: Node| node.displacement - chord * node.below;
    let ways = (way(lower), way(upper));
    if ways.0 * ways.1 < 0.0 {
        let fraction = ways.1 / (ways.1 - ways.0);
        let below = upper.below + fraction * (lower.below - upper.below);
        let Some(place) = curve.place(motion.edge.depth(), below) else { return 0.0 };
        let middle = between(lower, upper, fraction, place);
        return left_one_way(curve, (lower, middle), (ways.0, 0.0), motion)
            + left_one_way(curve, (middle, upper), (0.0, ways.1), motion);
    }
    left_one_way(curve, (lower, upper), ways, motion)
}

fn left_one_way(curve: &impl NormalLoad, (lower, upper): (Node, Node), ways: (f64, f64), motion: SlideStep) -> f64 {
    let growth = motion.growth((ways.0 + ways.1).signum());
    let product = LinearProduct { first: ways, second: ways };
    (-0.5 * growth).max(0.0) * curve.integral((lower.place, upper.place), product)
}

/// The spring a fraction of the way from `upper` to `lower`, at a place already known.
fn between(lower: Node, upper: Node, fraction: f64, place: SpringDepth) -> Node {
    let mix = |lower: f64, upper: f64| upper + fraction * (lower - upper);
    Node { place, below: mix(lower.below, upper.below), displacement: mix(lower.displacement, upper.displacement) }
}
