//! The force and the edge after a motion outwards, at a cost that does not grow with the springs let go in it.

use super::{Event, Lazy};
use crate::contact::viscoelastic::layout::NODES;
use crate::contact::viscoelastic::spring::Motion;
use crate::contact::viscoelastic::totals::{Numbers, Totals};

impl Lazy {
    /// Moves at constant `speed` [m/s] for `duration` [s], and follows of the springs let go in it those alone by which the
    /// edge is found: the others, and what was done and stored, are not to be asked for.
    pub(super) fn end_at(&mut self, speed: f64, duration: f64) {
        let motion = Motion { start: self.now.depth, speed, duration };
        let pressed = self.now.pressed;
        if speed >= 0.0 {
            return self.reach_out(&motion);
        }
        if pressed < self.now.touched && self.touched_in(pressed, &motion).is_some() {
            return self.advance(speed, duration);
        }
        let kept = self.kept(&motion);
        let beside_edge = (kept..pressed).take(NODES);
        let released: Vec<Event> = beside_edge.map(|j| self.event(j, self.spring(j), &self.seen(j, &motion))).collect();
        self.let_go_beyond(kept);
        self.evolve(&motion);
        released.into_iter().for_each(|event| self.replace(event, duration));
    }

    /// A motion inwards; of the springs touched for the first time those alone are kept by which the edge is found.
    fn reach_out(&mut self, motion: &Motion) {
        let touched = self.touched_again(motion);
        let first = self.touched_first(touched.len(), motion);
        self.evolve(motion);
        touched.into_iter().for_each(|event| self.replace(event, motion.duration));
        let beside_edge = first.end.saturating_sub(NODES);
        for j in first {
            let touch = self.touch_first(j, motion);
            if j >= beside_edge {
                self.keep(&touch);
            }
        }
    }

    /// How many springs are still pressed at the end of a motion outwards: from the edge inwards all are let go up to there.
    fn kept(&self, motion: &Motion) -> usize {
        let (mut kept, mut gone, mut width) = (0, self.now.pressed, 1);
        while kept < gone {
            let asked = if kept == 0 { gone.saturating_sub(width) } else { kept + (gone - kept) / 2 };
            if self.is_let_go(asked, motion) {
                (gone, width) = (asked, 2 * width);
            } else {
                kept = asked + 1;
            }
        }
        kept
    }

    fn is_let_go(&self, j: usize, motion: &Motion) -> bool {
        let loads: Numbers = self.loads(j).collect();
        self.spectrum.load_after(self.seen(j, motion).start, &loads, motion.speed, motion.duration) < 0.0
    }

    /// Takes the springs from the one `kept` on out of the sums over the pressed ones, by whichever are fewer.
    fn let_go_beyond(&mut self, kept: usize) {
        let pressed = self.now.pressed;
        let (mut totals, fewer, sign) = if kept < pressed - kept {
            (Totals::new(&self.spectrum), 0..kept, 1.0)
        } else {
            (self.now.totals.clone(), kept..pressed, -1.0)
        };
        self.add_pressed(&mut totals, fewer, sign);
        (self.now.totals, self.now.pressed) = (totals, kept);
    }
}
