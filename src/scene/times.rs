//! The times that matter in a scene: from well below its shortest step to its end.

use super::Scene;
use crate::contact::adhesion::equilibrium::Control;
use crate::material::Times;
use crate::scene::history::{EntryTraits, MotionTable, space};
use crate::scene::stage::{Extent, Path, Stage};
use std::num::NonZeroUsize;

/// Part of the shortest step between records down to which bodies are asked: what happens within a step, such as first
/// touch, is felt at its end.
const WITHIN: f64 = 0.1;
/// Times of what is known before it that a retraction from a depth that is not known may take.
const AWAY: f64 = 30.0;

/// The times of a history of which the tables are read; `None` where it moves by itself, as an impact or a machine does, or
/// in no time.
pub(super) fn of(scene: &Scene, motions: &[Option<MotionTable>]) -> Option<Times> {
    let steps = scene.steps.map(NonZeroUsize::get);
    let numbered = scene.history.iter().zip(motions).enumerate();
    let mut entries: Vec<EntryTraits<'_>> =
        numbered.map(|(number, (entry, motion))| entry.traits(number, motion.as_ref(), steps)).collect();
    space(scene, &mut entries);
    if entries.iter().any(moves_by_itself) {
        return None;
    }
    let mut seen = Seen { shortest: f64::MAX, longest: 0.0, depth: Some(0.0) };
    for entry in &entries {
        entry.stages.iter().enumerate().for_each(|(row, stage)| seen.goes(stage, row));
    }
    let accuracy = scene.accuracy.map_or(1e-6, |accuracy| accuracy.si());
    let Seen { shortest, longest, .. } = seen;
    (longest > 0.0 && shortest <= longest).then_some(Times { shortest: WITHIN * shortest, longest, accuracy })
}

/// Whether how long it takes is known only behind it, or from the size of the contact.
pub(super) fn moves_by_itself(entry: &EntryTraits<'_>) -> bool {
    entry.impact.is_some() || entry.machine.is_some() || entry.glide.is_some()
}

/// What has been seen of a history.
struct Seen {
    shortest: f64,
    longest: f64,
    /// The present depth [m], where it is known before the run.
    depth: Option<f64>,
}

impl Seen {
    fn goes(&mut self, stage: &Stage, row: usize) {
        let over = match (stage.normal, self.depth) {
            (Path::UntilParted { speed }, Some(depth)) => depth.max(0.0) / speed,
            (Path::UntilParted { .. }, None) => AWAY * self.longest,
            (Path::To(_) | Path::Stay | Path::Steady { .. } | Path::Wave(_), _) => stage.over,
        };
        self.longest += over;
        // What stands in the first row of a table is there at once.
        let at_once = stage.extent == Extent::Row && row == 0;
        if over > 0.0 && !at_once {
            self.shortest = self.shortest.min(Stage { over, ..*stage }.first());
        }
        match (stage.control, stage.normal) {
            (Some(Control::Indentation), Path::To(depth)) => self.depth = Some(depth),
            (Some(Control::Force), _) => self.depth = None,
            (_, Path::UntilParted { .. }) => self.depth = Some(0.0),
            (Some(Control::Indentation) | None, Path::To(_) | Path::Stay | Path::Steady { .. } | Path::Wave(_)) => {}
        }
    }
}
