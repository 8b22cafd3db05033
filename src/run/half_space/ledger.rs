//! What the jumps of bodies that adhere lose.

/// Work done on bodies that adhere, held against the energy that is accounted for.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ledger {
    last: Option<Entry>,
    /// dF/dd [N/m] of the last step.
    slope: Option<f64>,
    /// Energy lost in jumps so far [J].
    lost: f64,
    /// The largest energy known of [J].
    largest: f64,
}

/// A state: its force [N], its depth [m], and its energy stored, or lost otherwise, so far [J].
#[derive(Debug, Clone, Copy)]
pub(super) struct Entry {
    pub(super) force: f64,
    pub(super) depth: f64,
    pub(super) accounted: f64,
}

/// What a step leaves open [J].
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Open {
    /// How far a jump in it may be off.
    pub(super) open: f64,
    /// What the trapezoid finds beyond the energy gained.
    pub(super) missing: f64,
}

/// Multiple of Δd²|Δ(dF/dd)| that the trapezoid leaves open: it misses Δd³F″/12 of a smooth force, three times less.
const OPEN: f64 = 0.25;

impl Ledger {
    /// One whose jumps are counted beside an energy \[J\].
    pub(super) fn beside(energy: f64) -> Self {
        Self { largest: energy, ..Self::default() }
    }

    /// Energy lost in jumps so far [J].
    pub(super) fn lost(&self) -> f64 {
        self.lost
    }

    /// Adds what a step that ends with `now` loses, and tells what it leaves open; nothing where bodies part or come.
    ///
    /// On a smooth way the work ∫F dd is the energy gained, and nothing is lost, however long the steps. What the
    /// trapezoid finds beyond that is a loss where it is more than the trapezoid may miss, by the change of the slope
    /// from step to step: a jump under a prescribed depth is known to the first order of the step it lies in, and one
    /// too small for its step is not told.
    pub(super) fn step(&mut self, now: Option<Entry>) -> Open {
        let (Some(last), Some(now)) = (self.last, now) else {
            (self.slope, self.last) = (None, now);
            return Open::default();
        };
        self.last = Some(now);
        let way = now.depth - last.depth;
        if way.abs() <= 0.0 {
            return Open::default();
        }
        let slope = (now.force - last.force) / way;
        let missing = 0.5 * (last.force + now.force) * way - (now.accounted - last.accounted);
        let open = OPEN * way * way * (slope - self.slope.unwrap_or(-slope)).abs();
        self.slope = Some(slope);
        self.lost += if missing > open { missing } else { 0.0 };
        self.largest = self.largest.max(now.accounted.abs()).max(self.lost);
        Open { open, missing }
    }

    /// Whether an energy \[J\] is more than a part `part` of the largest known of.
    pub(super) fn counts(&self, energy: f64, part: f64) -> bool {
        energy > part * self.largest
    }
}
