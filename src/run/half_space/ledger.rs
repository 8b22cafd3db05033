//! What the jumps of bodies that adhere lose.

/// Work done on bodies that adhere, held against the energy that is accounted for.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ledger {
    last: Option<Entry>,
    /// dF/dd [N/m] of the last step.
    slope: Option<f64>,
    /// Energy lost in jumps so far [J].
    lost: f64,
}

/// A state: its force [N], its depth [m], and its energy stored, or lost otherwise, so far [J].
#[derive(Debug, Clone, Copy)]
pub(super) struct Entry {
    pub(super) force: f64,
    pub(super) depth: f64,
    pub(super) accounted: f64,
}

/// Multiple of Δd²|Δ(dF/dd)| that the trapezoid leaves open: it misses Δd³F″/12 of a smooth force, three times less.
const OPEN: f64 = 0.25;

impl Ledger {
    /// Energy lost in jumps so far [J], with a state more.
    ///
    /// On a smooth way the work ∫F dd is the energy gained, and nothing is lost, however long the steps. What the
    /// trapezoid finds beyond that is a loss where it is more than the trapezoid may miss, by the change of the slope
    /// from step to step: a jump under a prescribed depth is known to the first order of the step it lies in, and one
    /// too small for its step is not told.
    pub(super) fn lost(&mut self, now: Option<Entry>) -> f64 {
        self.slope = match (self.last, now) {
            (Some(last), Some(now)) if (now.depth - last.depth).abs() > 0.0 => Some(self.step(last, now)),
            (Some(_), Some(_)) => self.slope,
            (_, None) | (None, _) => None,
        };
        self.last = now;
        self.lost
    }

    /// Adds what a step loses; its slope [N/m].
    fn step(&mut self, last: Entry, now: Entry) -> f64 {
        let way = now.depth - last.depth;
        let slope = (now.force - last.force) / way;
        let missing = 0.5 * (last.force + now.force) * way - (now.accounted - last.accounted);
        let open = OPEN * way * way * (slope - self.slope.unwrap_or(-slope)).abs();
        self.lost += if missing > open { missing } else { 0.0 };
        slope
    }
}
