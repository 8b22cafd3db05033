//! What the jumps of bodies that adhere lose.

/// Work done on bodies that adhere, by which what their jumps lose is known.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ledger {
    /// Force [N] and depth [m] of the last state.
    last: Option<(f64, f64)>,
    work: f64,
    lost: f64,
}

impl Ledger {
    /// Energy lost so far [J], of which `stored` [J] is left; the work is summed by the trapezoid, so that a jump under a
    /// prescribed depth is known to the first order of the way between two records.
    pub(super) fn lost(&mut self, force: f64, depth: Option<f64>, stored: f64) -> f64 {
        if let (Some((before, from)), Some(to)) = (self.last, depth) {
            self.work += 0.5 * (before + force) * (to - from);
        }
        self.last = depth.map(|depth| (force, depth));
        self.lost = self.lost.max(self.work - stored);
        self.lost
    }
}
