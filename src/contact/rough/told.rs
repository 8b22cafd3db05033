//! What is told of the jumps of a rough line that adheres.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::rough::{AdhesiveRough, EdgeWorks};
//!
//! // However many springs go one by one: the bodies join, and on the way out there is the pull-off.
//! let works = EdgeWorks { opening: 0.1, closing: 0.1 };
//! let mut line = AdhesiveRough::of_gaps(&[3.0, 1.0, 0.0, 2.0], 1.0, 1.0, works)?;
//! assert_eq!(line.follow(&Straight::between(0.0, 4.0, 1.0))?.len(), 1);
//! let way_out = line.follow(&Straight::between(4.0, -4.0, 1.0))?;
//! assert!(way_out[0].before.force < 0.0 && way_out.last().unwrap().after.force == 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::contact::model::Event;
use crate::contact::state::Normal;

/// A jump at a depth: what it was before and after.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jump {
    pub(super) before: Normal,
    pub(super) after: Normal,
}

/// What is told of the jumps of a motion: where the bodies join, where the force is least, where they part.
#[derive(Debug, Default)]
pub(super) struct Told {
    under: Option<Normal>,
    joined: Option<Jump>,
    least: Option<Jump>,
    pub(super) parted: Option<Jump>,
}

impl Told {
    /// A jump begins, or goes on.
    pub(super) fn change(&mut self, state: impl FnOnce() -> Normal) {
        self.under.get_or_insert_with(state);
    }

    /// A jump, if there was one, is over.
    pub(super) fn rest(&mut self, state: impl FnOnce() -> Normal) {
        let Some(before) = self.under.take() else { return };
        let jump = Jump { before, after: state() };
        if before.stiffness <= 0.0 {
            self.joined = Some(jump);
        } else if self.least.is_none_or(|least| before.force < least.before.force) {
            self.least = Some(jump);
        }
        if jump.after.stiffness <= 0.0 {
            self.parted = Some(jump);
        }
    }

    /// The jumps of a motion whose depth is given, in order; the least force is told if it is below that at both ends,
    /// `least_at_ends` [N].
    pub(super) fn by_depth(self, least_at_ends: f64) -> Vec<Event> {
        let pull = self.least.filter(|jump| jump.before.force < least_at_ends.min(0.0) && self.joined.is_none());
        let parted = self.parted.filter(|parted| pull.is_none_or(|pull| pull.before != parted.before));
        let event = |jump: Jump| Event {
            at: jump.before.indentation.unwrap_or(0.0),
            before: jump.before,
            after: jump.after,
            tangential: None,
        };
        self.joined.into_iter().chain(pull).chain(parted).map(event).collect()
    }

    /// The jumps of a motion whose force is given, in order: where it cannot be held any more the bodies part.
    pub(super) fn by_force(self) -> Vec<Event> {
        let event = |before: Normal, after: Normal| Event { at: before.force, before, after, tangential: None };
        let parted = self.parted.map(|parted| {
            let after = Normal { indentation: None, ..parted.after };
            event(self.least.unwrap_or(parted).before, after)
        });
        let joined = self.joined.map(|jump| event(jump.before, jump.after));
        joined.into_iter().chain(parted).collect()
    }
}
