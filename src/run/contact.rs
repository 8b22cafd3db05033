//! What the simulation asks of a normal contact, and the direct path and the bed of springs behind it.

use crate::contact::adhesion::equilibrium::{Balance, BranchError, Control};
use crate::contact::adhesion::line::Energy;
use crate::contact::direct::{Jump, QuasiStatic};
use crate::contact::springs::SpringBed;
use crate::contact::state::Normal;
use crate::contact::viscoelastic::memory::BedError;
use crate::drive::impact::ImpactError;
use crate::friction::FrictionError;
use crate::scene::stage::{Extent, Path};

/// Why a contact cannot follow what is prescribed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// No equilibrium of the elastic contact.
    #[error(transparent)]
    Branch(#[from] BranchError),
    /// The viscoelastic bed ends.
    #[error(transparent)]
    Bed(#[from] BedError),
    /// The plane contact cannot follow.
    #[error(transparent)]
    Plane(#[from] super::plane::PlaneError),
    /// The contact grows out of a rough line.
    #[error(transparent)]
    Line(#[from] super::rough::LineTooShort),
    /// A jump of the depth against a dashpot.
    #[error(
        "a jump to the depth {to:e} m would need an infinite force, for the viscosity lets nothing give at once: expected time_s of the first row above zero, or no viscosity"
    )]
    Jump {
        /// Depth after the jump [m].
        to: f64,
    },
    /// An impact leaves what can be followed.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// No state of the tangential contact.
    #[error(transparent)]
    Friction(#[from] FrictionError),
}

/// When something happens during a stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Moment {
    /// As the prescribed quantity passes this value.
    Value(f64),
    /// At this time [s] since the beginning of the stage.
    Time(f64),
}

/// What happens between two records, a sudden change or a turn, with the state on both sides.
#[derive(Debug, Clone, Copy)]
pub struct Event {
    /// When.
    pub at: Moment,
    /// State just before.
    pub before: Normal,
    /// State just after.
    pub after: Normal,
}

/// A stage as the contact sees it: all of it is known when it begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// What is prescribed.
    pub control: Control,
    /// How it moves; never until the bodies part, which is a depth by then.
    pub path: Path,
    /// Duration [s]; zero for a jump.
    pub over: f64,
    /// Whether the stage is one of many of a table.
    pub extent: Extent,
}

/// What the loop of an oscillation says of the material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loop {
    /// Frequency [Hz].
    pub frequency: f64,
    /// Storage modulus [Pa]: in-phase stiffness over twice the mean contact radius.
    pub storage: f64,
    /// Loss modulus [Pa].
    pub loss: f64,
    /// Largest less smallest contact radius of the loop, relative to the mean.
    pub swing: f64,
}

/// A normal contact that can be driven by depth or force.
pub trait NormalContact {
    /// Begins a stage, for a contact in which the way between records counts.
    ///
    /// # Errors
    /// The contact cannot follow.
    fn begin(&mut self, _drive: &Drive) -> Result<(), ContactError> {
        Ok(())
    }

    /// Moves to the value `to` of the prescribed quantity, at the time `until` [s] since the beginning
    /// of the stage; returns what happens on the way.
    ///
    /// # Errors
    /// The contact cannot follow.
    fn advance(&mut self, control: Control, to: f64, until: f64) -> Result<Vec<Event>, ContactError>;

    /// Present state.
    fn state(&self) -> Normal;

    /// Depth [m] at which a retraction from here at the speed `speed` [m/s] parts the bodies.
    ///
    /// # Errors
    /// The contact cannot follow.
    fn last_depth(&self, speed: f64) -> Result<f64, ContactError>;

    /// Parts the bodies at the last depth of a retraction; returns the jump.
    ///
    /// # Errors
    /// The contact cannot follow.
    fn part(&mut self) -> Result<Vec<Event>, ContactError> {
        let last = self.state().indentation.unwrap_or(0.0);
        self.advance(Control::Indentation, last.next_down(), 0.0)
    }

    /// Error of the present force [N], where the contact can tell; else a bound is known beforehand.
    fn force_error(&self) -> Option<f64> {
        None
    }

    /// Bytes of state, where they are only known from the run.
    fn bytes(&self) -> usize {
        0
    }

    /// Number of springs.
    fn springs(&self) -> usize {
        0
    }

    /// The last cycle of the last oscillation, where the contact remembers.
    fn last_loop(&self) -> Option<Loop> {
        None
    }

    /// Pressure at the radius r [Pa]; `None` where it is singular.
    fn pressure(&self, r: f64) -> Option<f64>;

    /// Surface displacement at the radius r [m]; `None` where the method gives none.
    fn surface(&self, r: f64) -> Option<f64>;

    /// Stress intensity at the edge [Pa √m], if the edge is singular.
    fn stress_intensity(&self) -> Option<f64>;

    /// Whether the bodies touch or attract each other.
    fn joined(&self) -> bool;

    /// Radius up to which the bodies act on each other [m].
    fn reach(&self) -> f64;

    /// The contact as it is, to be looked at later.
    fn snapshot(&self) -> Box<dyn NormalContact + '_>;
}

/// The state of the direct path with the equilibrium `balance`, at which it has lost `dissipated` [J].
fn normal(contact: &QuasiStatic, balance: &Balance, (stored, dissipated): (Energy, f64)) -> Normal {
    Normal {
        indentation: (!balance.indentation.is_nan()).then_some(balance.indentation),
        force: balance.force,
        contact_radius: Some(balance.contact_radius),
        stiffness: contact.stiffness_at(balance.contact_radius),
        stored,
        dissipated,
    }
}

/// The jumps of a motion, before which `lost` [J] had been lost; under a prescribed depth also the states
/// between them at which the force turns: pull-off is no matter of records.
struct Course<'c> {
    contact: &'c mut QuasiStatic,
    lost: f64,
    events: Vec<Event>,
}

impl Course<'_> {
    fn turns(&mut self, from: f64, to: f64) -> Result<(), ContactError> {
        for balance in self.contact.force_turns(from, to)? {
            let state = normal(self.contact, &balance, (self.contact.energy_at(&balance), self.lost));
            self.events.push(Event { at: Moment::Value(balance.indentation), before: state, after: state });
        }
        Ok(())
    }

    fn jump(&mut self, jump: &Jump) {
        let before = normal(self.contact, &jump.before, (jump.stored.0, self.lost));
        self.lost += jump.dissipated;
        let by_depth = jump.control == Control::Indentation;
        let at = if by_depth { jump.before.indentation } else { jump.before.force };
        let indentation = if by_depth { at } else { f64::NAN };
        let parted = Balance { contact_radius: 0.0, reach: 0.0, indentation, force: 0.0 };
        let after = normal(self.contact, &jump.after.unwrap_or(parted), (jump.stored.1, self.lost));
        self.events.push(Event { at: Moment::Value(at), before, after });
    }
}

impl NormalContact for QuasiStatic {
    fn advance(&mut self, control: Control, to: f64, _until: f64) -> Result<Vec<Event>, ContactError> {
        let (mut from, lost) = (self.present().balance.reach, self.dissipated());
        let by_depth = control == Control::Indentation;
        let jumps = if by_depth { self.indent(to)? } else { self.press(to)? };
        let end = self.present().balance.reach;
        let mut course = Course { contact: self, lost, events: Vec::new() };
        for jump in &jumps {
            if by_depth {
                course.turns(from, jump.before.reach)?;
                from = jump.after.map_or(0.0, |balance| balance.reach);
            }
            course.jump(jump);
        }
        if by_depth {
            course.turns(from, end)?;
        }
        Ok(course.events)
    }

    fn state(&self) -> Normal {
        normal(self, &self.present().balance, (self.energy(), self.dissipated()))
    }

    fn last_depth(&self, _speed: f64) -> Result<f64, ContactError> {
        Ok(self.last_depth()?)
    }

    fn pressure(&self, r: f64) -> Option<f64> {
        Some(self.pressure(r)).filter(|pressure| pressure.is_finite())
    }

    fn surface(&self, r: f64) -> Option<f64> {
        Some(self.surface(r))
    }

    fn stress_intensity(&self) -> Option<f64> {
        Some(self.stress_intensity()).filter(|intensity| intensity.abs() > 0.0)
    }

    fn joined(&self) -> bool {
        self.present().joined
    }

    fn reach(&self) -> f64 {
        self.present().balance.reach
    }

    fn snapshot(&self) -> Box<dyn NormalContact + '_> {
        Box::new(self.clone())
    }
}

/// The bed of springs; `parted` while a prescribed force keeps the bodies apart.
#[derive(Debug, Clone)]
pub struct Springs {
    bed: SpringBed,
    parted: bool,
}

impl Springs {
    /// A bed whose bodies just touch.
    #[must_use]
    pub fn new(bed: SpringBed) -> Self {
        Self { bed, parted: false }
    }
}

impl NormalContact for Springs {
    fn advance(&mut self, control: Control, to: f64, _until: f64) -> Result<Vec<Event>, ContactError> {
        let turn = if control == Control::Indentation { self.bed.least_force_above(to) } else { None };
        let turn = turn.map(|depth| {
            self.bed.indent(depth);
            let state = self.state();
            Event { at: Moment::Value(depth), before: state, after: state }
        });
        self.parted = !self.bed.follow(control, to) && to < 0.0;
        Ok(turn.into_iter().collect())
    }

    fn state(&self) -> Normal {
        let a = self.bed.contact_radius();
        let stored = Energy { elastic: self.bed.elastic_energy(), surface: self.bed.surface_energy() };
        Normal {
            indentation: (!self.parted).then_some(self.bed.indentation()),
            force: self.bed.force(),
            contact_radius: Some(a),
            stiffness: self.bed.stiffness(),
            stored,
            dissipated: self.bed.work() - stored.stored(),
        }
    }

    fn last_depth(&self, _speed: f64) -> Result<f64, ContactError> {
        Ok(self.bed.last_depth())
    }

    fn part(&mut self) -> Result<Vec<Event>, ContactError> {
        let before = self.state();
        let last = before.indentation.unwrap_or(0.0);
        self.advance(Control::Indentation, last.next_down(), 0.0)?;
        let after = Normal { indentation: before.indentation, ..self.state() };
        Ok(vec![Event { at: Moment::Value(last), before, after }])
    }

    fn pressure(&self, r: f64) -> Option<f64> {
        Some(self.bed.pressure(r)).filter(|pressure| pressure.is_finite())
    }

    fn surface(&self, r: f64) -> Option<f64> {
        (r > self.bed.contact_radius()).then(|| self.bed.surface(r))
    }

    fn stress_intensity(&self) -> Option<f64> {
        None
    }

    fn joined(&self) -> bool {
        self.bed.contact_radius() > 0.0
    }

    fn reach(&self) -> f64 {
        self.bed.contact_radius()
    }

    fn snapshot(&self) -> Box<dyn NormalContact + '_> {
        Box::new(self.clone())
    }
}
