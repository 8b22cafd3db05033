//! Ramps and rests: a value is reached at a constant rate, or kept.

use crate::contact::adhesion::equilibrium::Control;
use crate::input::quantity::{Displacement, Duration, Force, Speed};
use crate::scene::stage::{Path, Stage};
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
}

impl Hold {
    pub(super) fn stage(&self, control: Control, rest: Stage) -> Stage {
        Stage { control: Some(control), over: self.over.si(), ..rest }
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
