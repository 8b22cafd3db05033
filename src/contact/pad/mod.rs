//! Pads of scattered heights, whose springs or summits join and let go one by one.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::pad::{Bed, Element, Pad, Spring};
//!
//! // Springs of one stiffness in all, heights of the deviation 1, that hold up to a stretch of 2.
//! let spring = Spring { stiffness: 1.0, work: 2.0, closing: 0.0 };
//! let mut pad = Pad::new(Bed { number: 1.0, deviation: 1.0, element: Element::Spring(spring) });
//! // Pressed to the mean plane, F = kσ/√(2π); drawn back by the stretch at which they break, all that touched still hold.
//! pad.follow(&Straight::between(pad.indentation().unwrap(), 0.0, 1.0))?;
//! assert!((pad.state().force - 0.398_942_280_401_432_7).abs() < 1e-15);
//! pad.follow(&Straight::between(0.0, -2.0, 1.0))?;
//! assert!((pad.state().force - (0.398_942_280_401_432_7 - 1.0)).abs() < 1e-15);
//! # Ok::<(), springbed::contact::error::ContactError>(())
//! ```

mod bed;
mod element;
mod path;

pub use bed::{Bed, REACH, Sums};
pub use element::{Carried, Element, Hold, Spring, Summit};

use super::error::ContactError;
use super::model::{ContactModel, Event, Glance, Loading, Pull, Straight};
use super::state::{Joined, Normal};
use path::Path;

/// A pad that is led: its elements above an edge are joined, and the edge is all that it remembers.
///
/// An element at the height z below the mean plane joins where d − z comes to −s₁ and leaves where it goes to −s₂: those
/// with z < e are joined, and e stays between d + s₁ and d + s₂, moved by no more than it must. s₁ = 0 of
/// what attaches as it touches.
#[derive(Debug, Clone)]
pub struct Pad {
    bed: Bed,
    /// Depth d [m] of the mean plane.
    depth: f64,
    /// Edge e [m].
    edge: f64,
    /// Energy lost so far [J].
    lost: f64,
    /// Whether a force has drawn the bodies apart, to where no depth is known.
    away: bool,
}

impl Pad {
    /// A pad that just touches.
    #[must_use]
    pub fn new(bed: Bed) -> Self {
        let edge = -REACH * bed.deviation;
        Self { bed, depth: edge - bed.hold().joins, edge, lost: 0.0, away: false }
    }

    /// The elements and their heights.
    #[must_use]
    pub fn bed(&self) -> &Bed {
        &self.bed
    }

    /// The pad at the depth `d` [m], what joins and leaves on the way accounted for.
    fn to(&mut self, d: f64) {
        let Hold { joins, leaves } = self.bed.hold();
        let edge = self.edge.clamp(d + joins, d + leaves);
        let crossed = if edge > self.edge {
            // What joins falls from nothing to what it then has stored.
            -self.bed.element.carried(-joins).stored.stored()
        } else {
            self.bed.element.carried(-leaves).stored.stored()
        };
        self.lost += crossed * self.bed.between(self.edge, edge);
        (self.depth, self.edge, self.away) = (d, edge, false);
    }

    /// The ways from here.
    fn path(&self) -> Path {
        Path::new(self.bed, self.edge)
    }

    /// The depth [m] on the way to the depth `to` [m] at which the force is least, if it turns on it.
    fn turn(&self, to: f64) -> Option<f64> {
        let path = self.path();
        if to < self.depth {
            return path.least_below(self.depth).filter(|&turn| turn > to);
        }
        let turn = path.joined_from();
        (to > turn && turn > path.joining() + path.width()).then_some(turn)
    }
}

/// Under a prescribed force.
impl Pad {
    /// Leads it to the force `force` [N]; the jumps on the way there.
    fn under(&mut self, force: f64) -> Vec<Event> {
        if self.away && force <= 0.0 {
            return Vec::new();
        }
        if force > self.state().force { self.pressed(force) } else { self.pulled(force) }
    }

    /// Under more than before: elements that pull as they join do so all at once.
    fn pressed(&mut self, force: f64) -> Vec<Event> {
        let (path, mut jumps) = (self.path(), Vec::new());
        let steady = path.grows_from(self.depth, path.joining().max(self.depth));
        if steady > self.depth {
            let before = self.state();
            self.to(self.beyond(steady, before.force));
            jumps.push(self.jumped(before));
        }
        let (path, joined) = (self.path(), self.path().joined_from());
        if path.force(path.joining()) < force && joined > path.joining() + path.width() {
            self.to(path.joining());
            let before = self.state();
            self.to(path.above(joined, before.force));
            jumps.push(self.jumped(before));
        }
        self.to(self.beyond(self.depth, force));
        jumps
    }

    /// The first depth [m] that carries `force` [N] above the depth `low` [m] from which on the force grows.
    fn beyond(&self, low: f64, force: f64) -> f64 {
        let path = self.path();
        let joined = path.joined_from().max(low);
        if path.force(path.joining()) >= force && path.joining() > low {
            path.between((low, path.joining()), force)
        } else if path.force(joined) >= force {
            // By less than depths are told from each other.
            path.between((path.joining().max(low), joined), force)
        } else {
            path.above(joined, force)
        }
    }

    /// Under less than before, until it parts.
    fn pulled(&mut self, force: f64) -> Vec<Event> {
        let path = self.path();
        let end = path.end().min(self.depth);
        // What holds so little that it never pulls goes to its end.
        let turn = path.least_below(self.depth).unwrap_or(if path.gives_way(self.depth) { self.depth } else { end });
        if path.force(turn) <= force {
            self.to(path.between((turn, self.depth), force));
            return Vec::new();
        }
        self.to(turn);
        let before = self.state();
        self.to(end);
        self.away = true;
        vec![self.jumped(before)]
    }

    /// A jump from the state `before` under its force, which does more work than the pad takes: the rest is lost.
    fn jumped(&mut self, before: Normal) -> Event {
        let after = self.state();
        let way = self.depth - before.indentation.unwrap_or(self.depth);
        let taken = after.stored.stored() + after.dissipated - before.stored.stored() - before.dissipated;
        self.lost += before.force * way - taken;
        Event { at: before.force, before, after: self.state(), tangential: None }
    }
}

impl ContactModel for Pad {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        let turn = self.turn(piece.to).map(|depth| {
            self.to(depth);
            let state = self.state();
            Event { at: depth, before: state, after: state, tangential: None }
        });
        self.to(piece.to);
        Ok(turn.into_iter().collect())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let mut probe = self.clone();
        probe.to(piece.to);
        // There is no radius; what is asked of it is whether the bodies touch.
        let contact_radius = if probe.joined() { 1.0 } else { 0.0 };
        Ok(Glance { force: probe.state().force, contact_radius })
    }

    fn state(&self) -> Normal {
        let Sums { force, stiffness, stored, .. } = self.bed.sums(self.depth, self.edge);
        let indentation = (!self.away).then_some(self.depth);
        Normal { indentation, force, contact_radius: None, stiffness, stored, dissipated: self.lost }
    }

    fn joined(&self) -> bool {
        self.edge > -REACH * self.bed.deviation
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    fn pieces(&self) -> Option<Joined> {
        let Sums { share, area, .. } = self.bed.sums(self.depth, self.edge);
        Some(Joined { share, area })
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        Some(Ok(self.under(pull.force)))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        Some(Ok(self.path().end()))
    }
}

#[cfg(test)]
mod tests;
