//! Load histories, as a scene names them.
//!
//! # Examples
//! ```
//! use springbed::scene::history::{Entry, Indent};
//!
//! let press = Entry::Indent(Indent { to: "1 um".parse()?, over: "2 s".parse()? });
//! let traits = press.traits(3, None, None);
//! assert_eq!((traits.name, traits.place()), ("Indent", "history[3]".to_owned()));
//! assert!(traits.by_depth() && !traits.slides() && traits.stages[0].over == 2.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod glide;
mod impact;
mod list;
mod machine;
mod motion;
mod ramp;
mod wave;

pub use glide::{Glide, Motion};
pub use impact::Impact;
pub use machine::{Drive, Fall, MachineEntry, MachineMotion, Ring};
pub use motion::{Driven, MotionTable};
pub(in crate::scene) use ramp::space;
pub use ramp::{Hold, Indent, Press, Retract, Slide, Spacing};
pub use wave::Oscillate;

use crate::contact::adhesion::equilibrium::Control;
use crate::scene::stage::{Path, Stage};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// One entry of a history.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Entry {
    /// Moves to an indentation at constant speed.
    Indent(Indent),
    /// Moves to a normal force at constant rate.
    Press(Press),
    /// Keeps the depth.
    Hold(Hold),
    /// Keeps the normal force.
    HoldForce(Hold),
    /// Moves tangentially to a displacement at constant speed.
    Slide(Slide),
    /// Oscillates the depth about the present one.
    Oscillate(Oscillate),
    /// Oscillates the tangential displacement about the present one.
    Shake(Oscillate),
    /// Retracts at constant speed until the bodies part.
    Retract(Retract),
    /// Glides along the surface at constant speed; depth or force stays as it is.
    Glide(Glide),
    /// Rolls along the surface at constant speed; depth or force stays as it is.
    Roll(Glide),
    /// Draws on the far end of the tangential spring of a machine at constant speed.
    Drive(Drive),
    /// Lets the mass of a machine swing about the present depth.
    Ring(Ring),
    /// Lets the mass of a machine fall and bounce; the only entry of its history.
    Fall(Fall),
    /// A free impact; the only entry of its history.
    Impact(Impact),
    /// A table of time and indentation or force, next to the scene.
    Table(PathBuf),
    /// The same where the table has both, driven by its indentation.
    DepthTable(PathBuf),
    /// The same, driven by its force.
    ForceTable(PathBuf),
}

/// What an entry is, for all that must know: the rules read it, the stages are followed.
#[derive(Debug, Clone)]
pub struct EntryTraits<'e> {
    /// Its place in the history.
    pub number: usize,
    /// The name a scene gives it.
    pub name: &'static str,
    /// How it moves the bodies, in order; empty for an impact, which moves by itself.
    pub stages: Vec<Stage>,
    /// The field, with a point, that holds what it prescribes.
    pub field: &'static str,
    /// The table and the rows of its file, one per stage.
    pub table: Option<(&'e std::path::Path, &'e [usize])>,
    /// The impact, if it is one.
    pub impact: Option<&'e Impact>,
    /// The motion along the surface of a body that glides or rolls, if it is one.
    pub glide: Option<(&'e Glide, Motion)>,
    /// The motion of a machine, if it is one.
    pub machine: Option<MachineEntry>,
    /// Fewest records it can have.
    pub least_records: usize,
}

/// Records per ramp unless the scene says otherwise: a smooth curve on paper.
const RECORDS_PER_RAMP: usize = 100;

impl Entry {
    /// What the entry is: the one place that knows every kind.
    ///
    /// `number` is its place in the history, `motion` what its table holds, `steps` how many records the scene
    /// asks for per entry.
    #[must_use]
    pub fn traits<'e>(
        &'e self,
        number: usize,
        motion: Option<&'e MotionTable>,
        steps: Option<usize>,
    ) -> EntryTraits<'e> {
        let at = Numbered { number, steps };
        let rest = at.rest();
        match self {
            Self::Indent(indent) => at.moves("Indent", ".to", indent.stage(rest)),
            Self::Press(press) => at.moves("Press", ".to", press.stage(rest)),
            Self::Hold(hold) => at.moves("Hold", "", hold.stage(Control::Indentation, rest)),
            Self::HoldForce(hold) => at.moves("HoldForce", "", hold.stage(Control::Force, rest)),
            Self::Slide(slide) => at.moves("Slide", ".to", slide.stage(rest)),
            Self::Oscillate(wave) => at.waves("Oscillate", wave, wave.deep(rest)),
            Self::Shake(wave) => at.waves("Shake", wave, wave.along(rest)),
            Self::Retract(retract) => at.moves("Retract", "", retract.stage(rest)),
            Self::Glide(glide) => at.glides("Glide", glide, Motion::Glides),
            Self::Roll(glide) => at.glides("Roll", glide, Motion::Rolls),
            Self::Drive(drive) => at.driven("Drive", ".speed", drive.motion()),
            Self::Ring(ring) => at.driven("Ring", ".amplitude", ring.motion()),
            Self::Fall(fall) => at.driven("Fall", ".height", fall.motion()),
            Self::Impact(impact) => EntryTraits { impact: Some(impact), ..at.moves("Impact", "", None) },
            Self::Table(path) | Self::DepthTable(path) | Self::ForceTable(path) => EntryTraits {
                stages: motion.map_or_else(Vec::new, |motion| motion.stages(number)),
                table: motion.map(|motion| (path.as_path(), &motion.rows[..])),
                least_records: motion.map_or(1, |motion| motion.time.len()),
                ..at.moves("Table", "", None)
            },
        }
    }
}

/// The place of an entry in its history, and how many records the scene asks for per entry: what all kinds start from.
#[derive(Clone, Copy)]
struct Numbered {
    number: usize,
    steps: Option<usize>,
}

impl Numbered {
    fn rest(self) -> Stage {
        Stage::rest(self.number, self.steps.unwrap_or(RECORDS_PER_RAMP))
    }

    /// An entry of one stage or of none, that does nothing else.
    fn moves<'e>(self, name: &'static str, field: &'static str, stage: impl Into<Option<Stage>>) -> EntryTraits<'e> {
        EntryTraits {
            number: self.number,
            name,
            stages: stage.into().into_iter().collect(),
            field,
            table: None,
            impact: None,
            glide: None,
            machine: None,
            least_records: self.steps.unwrap_or(1),
        }
    }

    fn waves<'e>(self, name: &'static str, wave: &Oscillate, stage: Stage) -> EntryTraits<'e> {
        let records = self.steps.unwrap_or_else(|| wave.records());
        let least_records = wave.least_records(self.steps);
        EntryTraits { least_records, ..self.moves(name, ".amplitude", Stage { records, ..stage }) }
    }

    fn glides<'e>(self, name: &'static str, glide: &'e Glide, motion: Motion) -> EntryTraits<'e> {
        EntryTraits { glide: Some((glide, motion)), ..self.moves(name, ".speed", glide.stage(self.rest())) }
    }

    fn driven<'e>(
        self,
        name: &'static str,
        field: &'static str,
        (motion, over): (MachineMotion, f64),
    ) -> EntryTraits<'e> {
        let records = self.steps.unwrap_or(machine::RECORDS);
        let machine = Some(MachineEntry { entry: self.number, motion, over, records });
        EntryTraits { machine, ..self.moves(name, field, None) }
    }
}

impl Entry {
    /// The table of a motion, and what of it drives if that is said.
    #[must_use]
    pub fn table(&self) -> Option<(&std::path::Path, Option<Control>)> {
        match self {
            Self::Table(path) => Some((path.as_path(), None)),
            Self::DepthTable(path) => Some((path.as_path(), Some(Control::Indentation))),
            Self::ForceTable(path) => Some((path.as_path(), Some(Control::Force))),
            Self::Indent(_)
            | Self::Press(_)
            | Self::Hold(_)
            | Self::HoldForce(_)
            | Self::Slide(_)
            | Self::Oscillate(_)
            | Self::Shake(_)
            | Self::Retract(_)
            | Self::Glide(_)
            | Self::Roll(_)
            | Self::Drive(_)
            | Self::Ring(_)
            | Self::Fall(_)
            | Self::Impact(_) => None,
        }
    }
}

impl<'e> EntryTraits<'e> {
    /// The motion of a body that rolls or glides with a creepage or a tangential force prescribed.
    #[must_use]
    pub fn traction(&self) -> Option<(&'e Glide, Motion)> {
        self.glide.filter(|(glide, _)| glide.has_traction())
    }
}

impl EntryTraits<'_> {
    /// Its place in the scene.
    #[must_use]
    pub fn place(&self) -> String {
        format!("history[{}]", self.number)
    }

    /// Whether it moves the bodies along the surface.
    #[must_use]
    pub fn slides(&self) -> bool {
        let along = |stage: &Stage| match stage.tangential {
            Path::To(_) | Path::Wave(_) => true,
            // A body that glides feels the bed, not a friction.
            Path::Steady { .. } | Path::Stay | Path::UntilParted { .. } => false,
        };
        self.stages.iter().any(along) || self.impact.is_some_and(Impact::is_oblique)
    }

    /// Whether it slides one way, and nothing else moves.
    #[must_use]
    pub fn is_slide(&self) -> bool {
        let slide = |stage: &Stage| stage.control.is_none() && matches!(stage.tangential, Path::To(_));
        self.stages.iter().any(slide)
    }

    /// The row of its table that holds the stage `at`, as a message begins with it.
    #[must_use]
    pub fn row(&self, at: usize) -> String {
        self.table.map_or_else(String::new, |(path, rows)| format!("{}, row {}: ", path.display(), rows[at]))
    }

    /// Whether the normal force is prescribed.
    #[must_use]
    pub fn by_force(&self) -> bool {
        self.stages.iter().any(|stage| stage.control == Some(Control::Force))
    }

    /// Whether the depth is prescribed.
    #[must_use]
    pub fn by_depth(&self) -> bool {
        self.stages.iter().any(|stage| stage.control == Some(Control::Indentation))
    }

    /// Whether it parts the bodies.
    #[must_use]
    pub fn parts(&self) -> bool {
        self.stages.iter().any(|stage| matches!(stage.normal, Path::UntilParted { .. }))
    }
}
