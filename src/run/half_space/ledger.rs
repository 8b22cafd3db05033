//! What the jumps of bodies that adhere lose.

/// Work done on bodies that adhere, held against the energy that is accounted for.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ledger {
    last: Option<Stand>,
    /// dF/dd [N/m] of the last step and the way [m] it led, if it led any.
    slope: Option<[f64; 2]>,
    /// Energy lost in jumps so far [J].
    lost: f64,
    /// The largest energy known of [J].
    largest: f64,
}

/// Where a step has led.
#[derive(Debug, Clone, Copy)]
pub(super) enum Stand {
    Together(Entry),
    /// The force has torn the bodies apart, with the energy stored or lost so far \[J\].
    Apart(f64),
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

    /// Whether the bodies hold together after the last step.
    pub(super) fn is_together(&self) -> bool {
        matches!(self.last, Some(Stand::Together(_)))
    }

    /// Energy lost in jumps so far [J].
    pub(super) fn lost(&self) -> f64 {
        self.lost
    }

    /// A step that ends with `now` and whose losses are accounted for.
    pub(super) fn stands(&mut self, now: Stand) {
        (self.last, self.slope) = (Some(now), None);
        let (Stand::Together(Entry { accounted, .. }) | Stand::Apart(accounted)) = now;
        self.largest = self.largest.max(accounted.abs());
    }

    /// Adds what a step that ends with `now` loses, and tells what it leaves open; where a force tears them
    /// apart, which takes what is missing, what they had stored.
    ///
    /// On a smooth way the work ∫F dd is the energy gained, and nothing is lost, however long the steps. What the
    /// trapezoid finds beyond that is a loss where it is more than the trapezoid may miss, by the change of the slope
    /// from step to step: a jump under a prescribed depth is known to the first order of the step it lies in, and one
    /// too small for its step is not told. What was apart comes together from the depth `from` \[m\], or under a force that
    /// has done next to nothing: what their attraction gives is lost.
    pub(super) fn step(&mut self, now: Stand, from: Option<f64>) -> Open {
        match (self.last.replace(now), now) {
            (Some(Stand::Together(last)), Stand::Together(now)) => self.moved(last, now, from.is_none()),
            (Some(Stand::Apart(accounted)), Stand::Together(now)) => self.joined(accounted, now, from),
            (Some(Stand::Together(last)), Stand::Apart(accounted)) => {
                self.slope = None;
                self.lost += (last.accounted - accounted).max(0.0);
                Open::default()
            }
            (Some(Stand::Apart(before)), Stand::Apart(accounted)) => {
                // Apart nothing is put in, wherever a search for what would hold them has begun.
                self.slope = None;
                self.lost += before - accounted;
                Open::default()
            }
            (None, _) => {
                self.slope = None;
                Open::default()
            }
        }
    }

    /// Bodies that were apart have come together.
    fn joined(&mut self, accounted: f64, now: Entry, from: Option<f64>) -> Open {
        let done = from.map_or(0.0, |from| 0.5 * now.force * (now.depth - from));
        let (open, missing) = (from.map_or(now.force * now.depth, |_| done).abs(), done - (now.accounted - accounted));
        self.slope = None;
        self.count(now, Open { open, missing })
    }

    /// Bodies that are together have moved, led by the depth or by the force, which then is at no time beyond its ends: so
    /// the trapezoid misses no more than the triangle over them, however far they jump.
    fn moved(&mut self, last: Entry, now: Entry, is_forced: bool) -> Open {
        let way = now.depth - last.depth;
        if way.abs() <= 0.0 {
            return Open::default();
        }
        let slope = (now.force - last.force) / way;
        let missing = 0.5 * (last.force + now.force) * way - (now.accounted - last.accounted);
        let most = if is_forced { 0.5 * (way * (now.force - last.force)).abs() } else { f64::INFINITY };
        // How steep it was on the way there tells nothing of the way back.
        let before = self.slope.filter(|[_, before]| before * way > 0.0).map_or(-slope, |[slope, _]| slope);
        let open = (OPEN * way * way * (slope - before).abs()).min(most);
        self.slope = Some([slope, way]);
        self.count(now, Open { open, missing })
    }

    /// Counts what is missing as lost where it is more than may be.
    fn count(&mut self, now: Entry, step: Open) -> Open {
        self.lost += if step.missing > step.open { step.missing } else { 0.0 };
        self.largest = self.largest.max(now.accounted.abs()).max(self.lost);
        step
    }

    /// Whether an energy \[J\] is more than a part `part` of the largest known of.
    pub(super) fn counts(&self, energy: f64, part: f64) -> bool {
        energy > part * self.largest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is torn apart with its springs stretched loses what these had stored.
    #[test]
    fn what_is_stored_is_lost_as_a_force_tears() {
        let mut ledger = Ledger::default();
        ledger.step(Stand::Together(Entry { force: -1.0, depth: -0.5, accounted: 3.0 }), None);
        for accounted in [0.25, 0.125] {
            ledger.step(Stand::Apart(accounted), None);
            assert!((ledger.lost() + accounted - 3.0).abs() < 1e-15);
        }
    }

    /// A slope that is on the way back what it was on the way there by chance hides no jump.
    #[test]
    fn a_way_there_tells_nothing_of_the_way_back() {
        let mut ledger = Ledger::default();
        let mut open = |depth: f64| {
            let entry = Entry { force: depth, depth, accounted: 0.5 * depth * depth };
            ledger.step(Stand::Together(entry), Some(0.0)).open
        };
        let [_, first, on, back, on_back] = [0.0, 1.0, 2.0, 1.0, 0.5].map(&mut open);
        assert!(first > 0.0 && on.abs() < 1e-15 && back >= first && on_back.abs() < 1e-15, "{first} {on} {back}");
    }

    /// What a force has torn apart and presses together again loses what the attraction gives; led by the depth, that less
    /// what is done on the way.
    #[test]
    fn bodies_that_come_together_lose_what_attracts_them() {
        let together = |force: f64, accounted: f64| Stand::Together(Entry { force, depth: 0.5, accounted });
        let lost = |from: Option<f64>| {
            let mut ledger = Ledger::default();
            for (stand, from) in [(together(-1.0, -3.0), None), (Stand::Apart(0.25), None), (together(0.5, -2.0), from)]
            {
                ledger.step(stand, from);
            }
            ledger.lost()
        };
        assert!((lost(None) - 2.25).abs() < 1e-15);
        assert!((lost(Some(0.25)) - 2.3125).abs() < 1e-15);
    }
}
