//! Ramps and rests: a value is reached at a constant rate, or kept.

use super::{Entry, EntryTraits};
use crate::contact::adhesion::equilibrium::Control;
use crate::input::quantity::{Displacement, Duration, Force, Speed};
use crate::scene::Scene;
use crate::scene::stage::{Path, Spaced, Stage};
use serde::{Deserialize, Serialize};

/// Ramp of the indentation.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Indent {
    /// Indentation at the end [m].
    pub to: Displacement,
    /// Duration [s].
    pub over: Duration,
}

impl Indent {
    pub(super) fn stage(&self, rest: Stage) -> Stage {
        Stage { normal: Path::To(self.to.si()), over: self.over.si(), ..rest }
    }
}

/// Ramp of the normal force.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Press {
    /// Normal force at the end [N].
    pub to: Force,
    /// Duration [s].
    pub over: Duration,
}

impl Press {
    pub(super) fn stage(&self, rest: Stage) -> Stage {
        let normal = Path::To(self.to.si());
        Stage { control: Some(Control::Force), normal, over: self.over.si(), ..rest }
    }
}

/// A time in which what was controlled stays.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Hold {
    /// Duration [s].
    pub over: Duration,
    /// Where its records stand; by decades where a body relaxes over more than two of them, evenly otherwise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spacing: Option<Spacing>,
}

/// Where the records of a rest stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
pub enum Spacing {
    /// At equal times.
    Even,
    /// At equal steps of ln(1 + t/t₀), with t₀ the duration of the motion before it.
    Log,
}

/// Durations of the motion before it over which a body that relaxes is not seen by equal times.
const DECADES: f64 = 100.0;
/// The same beyond which nothing is seen by any times.
const MOST_DECADES: f64 = 1e100;
/// Part of a rest from which on its decades count where nothing moved before it.
const AT_ONCE: f64 = 1e-6;

impl Hold {
    pub(super) fn stage(&self, control: Control, rest: Stage) -> Stage {
        Stage { control: Some(control), over: self.over.si(), ..rest }
    }

    /// Where its records stand behind a motion that took `before` [s], 0 if there was none.
    fn spaced(&self, before: f64, relaxes: bool) -> Spaced {
        let over = self.over.si();
        let decades =
            Spaced::ByDecades { from: if before > 0.0 { before.max(over / MOST_DECADES) } else { AT_ONCE * over } };
        match self.spacing {
            Some(Spacing::Log) => decades,
            None if relaxes && before > 0.0 && over > DECADES * before && over / before < MOST_DECADES => decades,
            Some(Spacing::Even) | None => Spaced::Evenly,
        }
    }
}

/// Lays the records of all rests of a history: each one knows how long the motion before it took.
pub(in crate::scene) fn space(scene: &Scene, entries: &mut [EntryTraits<'_>]) {
    let relaxes = scene.bodies.0.relaxes() || scene.bodies.1.relaxes();
    let mut before = 0.0;
    for (entry, traits) in scene.history.iter().zip(entries) {
        if let Entry::Hold(hold) | Entry::HoldForce(hold) = entry {
            traits.stages.iter_mut().for_each(|stage| stage.spacing = hold.spaced(before, relaxes));
        }
        before = traits.stages.last().map_or(before, |stage| stage.over);
    }
}

/// Ramp of the tangential displacement.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Slide {
    /// Tangential displacement at the end [m].
    pub to: Displacement,
    /// Duration [s].
    pub over: Duration,
}

impl Slide {
    pub(super) fn stage(&self, rest: Stage) -> Stage {
        Stage { control: None, tangential: Path::To(self.to.si()), over: self.over.si(), ..rest }
    }
}

/// Retraction until the bodies part.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Retract {
    /// Speed [m/s].
    pub speed: Speed,
}

impl Retract {
    pub(super) fn stage(&self, rest: Stage) -> Stage {
        Stage { normal: Path::UntilParted { speed: self.speed.si() }, ..rest }
    }
}
