//! The reduced profile on panels, for integrals over it.

use super::abel::{Abel, Sums};
use crate::numerics::monotone::Interpolant;
use crate::numerics::quadrature;
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI};
use std::sync::LazyLock;

/// Nodes per panel.
const NODES: usize = 12;
/// Most panels; beyond as many points a panel holds several of them.
const MOST_PANELS: usize = 2048;

/// Nodes t² and weights 2t dt on [0, 1]: they take away the root with which g′ starts at a point.
static RULE: LazyLock<[(f64, f64); NODES]> = LazyLock::new(|| {
    std::array::from_fn(|k| {
        let (node, weight) = quadrature::node_and_weight(NODES, k);
        let t = 0.5 * (1.0 + node);
        (t * t, t * weight)
    })
});

/// A panel between measured radii.
#[derive(Debug, Clone)]
struct NodedPanel {
    start: f64,
    end: f64,
    /// g at the end of the panel [m].
    reduced: f64,
    /// ∫2g′N dx from 0 to the start of the panel [m³].
    energy: f64,
    slopes: [f64; NODES],
}

impl NodedPanel {
    fn length(&self) -> f64 {
        self.end - self.start
    }

    fn over(&self, kernel: impl Fn(f64) -> f64) -> f64 {
        let terms = RULE
            .iter()
            .zip(&self.slopes)
            .map(|(&(t, weight), slope)| weight * slope * kernel(self.start + self.length() * t));
        self.length() * terms.sum::<f64>()
    }
}

/// ∫ h over `[from, to]` by the nodes that take away a root at `from`.
fn with_root(h: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    (to - from) * RULE.iter().map(|&(t, weight)| weight * h(from + (to - from) * t)).sum::<f64>()
}

/// A measured profile's reduced form: exact values anywhere, stored ones for integrals.
#[derive(Debug, Clone)]
pub(super) struct Samples {
    interpolant: Interpolant,
    abel: Abel,
    panels: Vec<NodedPanel>,
}

impl Samples {
    /// Samples of the interpolant.
    pub(super) fn new(interpolant: Interpolant) -> Self {
        let abel = Abel::new(&interpolant);
        let mut samples = Self { interpolant, abel, panels: Vec::new() };
        let ends = samples.panel_ends();
        let mut energy = 0.0;
        samples.panels = ends
            .windows(2)
            .map(|ends| {
                let panel = samples.sample(ends[0], ends[1], energy);
                energy = panel.1;
                panel.0
            })
            .collect();
        samples
    }

    fn panel_ends(&self) -> Vec<f64> {
        let radii = self.interpolant.radii();
        let stride = self.interpolant.pieces().div_ceil(MOST_PANELS);
        let mut ends: Vec<f64> = radii.iter().step_by(stride).copied().collect();
        if !self.interpolant.pieces().is_multiple_of(stride) {
            ends.push(self.end());
        }
        ends
    }

    /// The panel and the energy integral at its end.
    fn sample(&self, start: f64, end: f64, energy: f64) -> (NodedPanel, f64) {
        let mut slopes = [0.0; NODES];
        let mut stored = 0.0;
        for (slope, &(t, weight)) in slopes.iter_mut().zip(RULE.iter()) {
            let sums = self.at(start + (end - start) * t);
            *slope = sums.slope;
            stored += weight * 2.0 * sums.slope * sums.load;
        }
        let reduced = end * self.at(end).reduced;
        (NodedPanel { start, end, reduced, energy, slopes }, energy + (end - start) * stored)
    }

    /// The interpolant.
    pub(super) fn interpolant(&self) -> &Interpolant {
        &self.interpolant
    }

    /// The last measured radius.
    pub(super) fn end(&self) -> f64 {
        self.interpolant.radii()[self.interpolant.pieces()]
    }

    /// The three integrals at `x`.
    pub(super) fn at(&self, x: f64) -> Sums {
        self.abel.at(&self.interpolant, x)
    }

    /// ∫₀^a 2g′N dx.
    pub(super) fn energy(&self, a: f64) -> f64 {
        let Some(panel) = self.panels.get(self.panels.partition_point(|panel| panel.end < a)) else {
            return f64::INFINITY;
        };
        let density = |x: f64| {
            let sums = self.at(x);
            2.0 * sums.slope * sums.load
        };
        panel.energy + with_root(density, panel.start, a)
    }

    /// (1/π)∫_r^a g′ dx/√(x²−r²).
    pub(super) fn pressure(&self, r: f64, a: f64) -> f64 {
        if r <= 0.0 && self.interpolant.apex_slope() > 0.0 {
            return f64::INFINITY;
        }
        // At the apex of a smooth tip the pressure is even in r: this near it is that of the apex.
        let r = r.max(1e-8 * self.panels[0].end);
        let inside = self.panels.iter().filter(|panel| panel.end > r && panel.start < a);
        let parts = inside.map(|panel| {
            if panel.end <= a && panel.start - r >= panel.length() {
                return panel.over(|x| 1.0 / ((x - r) * (x + r)).sqrt());
            }
            self.pressure_from(r, panel.start.max(r), panel.end.min(a))
        });
        FRAC_1_PI * parts.sum::<f64>()
    }

    /// The part near r: x = r cosh u.
    fn pressure_from(&self, r: f64, from: f64, to: f64) -> f64 {
        let angle = |x: f64| super::super::kernel::arcosh_of_ratio(x, r);
        let slope = |u: f64| self.at((r * u.cosh()).clamp(from, to)).slope;
        let (low, high) = (angle(from), angle(to));
        // One step for the root at the start of the panel, panels of moderate length after it.
        let first = high.min(low + 2.0);
        with_root(slope, low, first)
            + if high > first { quadrature::equal_panels(slope, (first, high), 3.0) } else { 0.0 }
    }

    /// (2/π)∫₀^a g′ arcsin(x/r) dx for r ≥ a.
    pub(super) fn displacement(&self, r: f64, a: f64) -> f64 {
        let angle = |x: f64| x.atan2(((r - x).max(0.0) * (r + x)).sqrt());
        let inside = self.panels.iter().filter(|panel| panel.start < a);
        let parts = inside.map(|panel| {
            if panel.end <= a && r - panel.end >= panel.length() {
                return panel.over(angle);
            }
            let turned = |theta: f64| self.at((r * theta.sin()).min(a)).slope * theta * r * theta.cos();
            with_root(turned, angle(panel.start), angle(panel.end.min(a)))
        });
        FRAC_2_PI * parts.sum::<f64>()
    }

    /// A bracket of the radius with g = `d`, by the stored values.
    pub(super) fn bracket(&self, d: f64) -> Option<(f64, f64)> {
        let panel = self.panels.get(self.panels.partition_point(|panel| panel.reduced < d))?;
        Some((panel.start, panel.end))
    }

    /// All stored slopes g′ with their radii, ascending.
    pub(super) fn slopes(&self) -> impl Iterator<Item = (f64, f64)> {
        self.panels.iter().flat_map(|panel| {
            RULE.iter().zip(&panel.slopes).map(|(&(t, _), &slope)| (panel.start + panel.length() * t, slope))
        })
    }

    /// Ends of the panels below `a`.
    pub(super) fn ends(&self, a: f64) -> Vec<f64> {
        self.panels.iter().map(|panel| panel.end).take_while(|&end| end < a).collect()
    }

    /// Shortest panel, but not below a twice as fine an even division.
    pub(super) fn finest(&self) -> f64 {
        let shortest = self.panels.iter().map(NodedPanel::length).fold(f64::INFINITY, f64::min);
        #[expect(clippy::cast_precision_loss, reason = "a few thousand panels")]
        shortest.max(0.5 * self.end() / MOST_PANELS as f64)
    }
}
