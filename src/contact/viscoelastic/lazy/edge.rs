//! Where the contact of a lazy bed ends, and what it carries there.

use super::Lazy;
use crate::contact::viscoelastic::layout::Edge;

impl Lazy {
    /// Whether the front closes over a dashpot, so that the load at the edge is not zero.
    fn closes_on_dashpot(&self) -> bool {
        self.spectrum.viscosity() * self.now.speed > 0.0
    }

    /// Force [N] between the border of the last pressed spring and the edge of a front that closes over a dashpot, by the
    /// loads of the last two led on to there: without it the force of such a contact is of first order in the springs.
    pub(in super::super) fn force_beside_edge(&self) -> f64 {
        let Some(last) = self.now.pressed.checked_sub(1).filter(|&last| last > 0 && self.closes_on_dashpot()) else {
            return 0.0;
        };
        let border = self.layout.place[last] + 0.25 * self.layout.weight[last];
        let edge = self.edge().place;
        let [inner, outer] = [last - 1, last].map(|j| (self.layout.place[j], self.line_load(j)));
        let slope = (outer.1 - inner.1) / (outer.0 - inner.0);
        2.0 * (edge - border) * (outer.1 + slope * (0.5 * (edge + border) - outer.0))
    }

    /// Force [N] of the part of a spring in which a front that closes may lie, by the loads of the last two led on to there: none
    /// where they fall to zero, as of bodies that relax slowly, and on those that relax before the next spring is met what
    /// the force may be off by.
    pub(in super::super) fn force_between_springs(&self) -> f64 {
        let gap = |j: usize| self.layout.height[j] + self.displacement(j) - self.now.depth;
        let closes = self.now.speed > 0.0 && !self.closes_on_dashpot();
        let last = self.now.pressed.checked_sub(1).filter(|&last| last > 0 && closes);
        let Some((last, edge)) = last.zip(self.layout.closing_edge(self.now.pressed, gap)) else { return 0.0 };
        let [inner, outer] = [last - 1, last].map(|j| (self.layout.place[j], self.line_load(j)));
        let slope = (outer.1 - inner.1) / (outer.0 - inner.0);
        0.5 * self.layout.weight[last] * (outer.1 + slope * (edge.place - outer.0)).abs()
    }

    /// Where the contact ends.
    pub(in super::super) fn edge(&self) -> Edge {
        let gap = |j: usize| self.layout.height[j] + self.displacement(j) - self.now.depth;
        let closing = self.closes_on_dashpot().then(|| self.layout.closing_edge(self.now.pressed, gap)).flatten();
        closing.unwrap_or_else(|| self.edge_by_loads())
    }

    fn edge_by_loads(&self) -> Edge {
        let gap_below = |j: usize| self.now.depth - self.layout.height[j] - self.displacement(j);
        self.layout.edge(self.now.pressed, |j| if self.is_pressed(j) { self.line_load(j) } else { gap_below(j) })
    }
}
