//! What a drive asks of a contact, whatever it is made of.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::direct::QuasiStatic;
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Any contact is followed along straight pieces, and looked at ahead without being moved.
//! fn pressed(contact: &mut dyn ContactModel) -> Result<f64, springbed::contact::error::ContactError> {
//!     let ahead = contact.look(&Straight::between(0.0, 1.0, 1.0))?;
//!     contact.follow(&Straight::between(0.0, 0.25, 1.0))?;
//!     Ok(ahead.force / contact.state().force)
//! }
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let ratio = pressed(&mut QuasiStatic::new(EdgeLine::new(ground, 0.0)))?;
//! assert!((ratio - 8.0).abs() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::creep::Creep;
use super::error::ContactError;
use super::loaded::Loaded;
use super::state::{Gliding, Joined, Normal, Tangential};
use crate::material::Spectrum;
use crate::numerics::extremum;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// A straight piece of the motion: depth and tangential displacement go linearly with time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Straight {
    /// Depth d at its end [m].
    pub to: f64,
    /// Speed ḋ [m/s], which a dashpot feels even where the depth does not change in its last digit.
    pub speed: f64,
    /// Tangential displacement u_x at its end [m].
    pub slide: f64,
    /// Sliding speed u̇_x [m/s].
    pub sliding_speed: f64,
    /// Duration [s]; zero for a jump.
    pub duration: f64,
}

/// A ramp of the normal force during which the tangential displacement goes linearly with time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull {
    /// Normal force F at its end [N].
    pub force: f64,
    /// Tangential displacement u_x at its end [m].
    pub slide: f64,
    /// Sliding speed u̇_x [m/s].
    pub sliding_speed: f64,
    /// Duration [s].
    pub duration: f64,
}

/// What a look at a contact sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Glance {
    /// Normal force [N].
    pub force: f64,
    /// Contact radius [m].
    pub contact_radius: f64,
}

/// A sudden change or a turn of the force on the way, with the state on both sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Value of what is prescribed as it happens: depth [m] or force [N].
    pub at: f64,
    /// State just before.
    pub before: Normal,
    /// State just after.
    pub after: Normal,
    /// State of the tangential contact, where that is what changes suddenly.
    pub tangential: Option<Tangential>,
}

/// How bodies part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parting {
    /// Time since the beginning of the piece [s].
    pub time: f64,
    /// How far it may be off [s], beyond rounding: an edge that obeys a rate law is followed in steps.
    pub doubt: f64,
    /// Whether an attraction gives way, with a jump of the force.
    pub suddenly: bool,
}

/// What a contact takes, and how well it knows its force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Effort {
    /// Number of springs.
    pub springs: usize,
    /// Bytes of state.
    pub bytes: usize,
    /// Error of the present force [N], where the contact can tell.
    pub force_error: Option<f64>,
    /// Error of the present contact radius [m], where the contact can tell.
    pub radius_error: Option<f64>,
}

/// Radii at which the largest pressure is looked for, denser towards the edge.
const LOOKS: u32 = 48;

/// Pressure and surface of a contact at the present instant.
pub trait Loading {
    /// Contact radius [m].
    fn contact_radius(&self) -> f64;

    /// Radius up to which the bodies act on each other [m].
    fn reach(&self) -> f64 {
        self.contact_radius()
    }

    /// Pressure at the radius r [Pa]; `None` where it is singular.
    fn pressure(&self, r: f64) -> Option<f64>;

    /// Displacement of the surface at the radius r [m]; `None` where the method gives none.
    fn surface(&self, _r: f64) -> Option<f64> {
        None
    }

    /// Stress intensity K_I at the edge [Pa √m], if the edge is singular.
    fn stress_intensity(&self) -> Option<f64> {
        None
    }

    /// Shear stress τ [Pa] at the radii `radii` [m], if there is friction; `None` where it is singular or not known.
    fn shear(&self, radii: &[f64]) -> Vec<Option<f64>> {
        vec![None; radii.len()]
    }

    /// Largest pressure [Pa] over the radius; `None` where a sharp edge or tip has an infinite one.
    fn peak(&self) -> Option<f64> {
        if self.stress_intensity().is_some_and(|intensity| intensity < 0.0) {
            return None;
        }
        let radius = |k: u32| self.contact_radius() * (FRAC_PI_2 * f64::from(k) / f64::from(LOOKS)).sin();
        let seen = (0..LOOKS).map(|k| Some((radius(k), self.pressure(radius(k))?)));
        self.peak_among(&seen.collect::<Option<Vec<_>>>()?)
    }

    /// The top about the largest of the pressures [Pa] `seen` at radii [m] of the contact, ascending; beyond the last of them
    /// rounding may make an edge singular.
    fn peak_among(&self, seen: &[(f64, f64)]) -> Option<f64> {
        let best = (0..seen.len()).max_by(|&i, &j| seen[i].1.total_cmp(&seen[j].1))?;
        let Some(&[before, _, after]) = best.checked_sub(1).and_then(|before| seen.get(before..best + 2)) else {
            return Some(seen[best].1);
        };
        let at = |r: f64| self.pressure(r).unwrap_or(f64::NEG_INFINITY);
        Some(extremum::greatest(at, before.0, after.0).value.max(seen[best].1))
    }

    /// The load as a value of its own, with the stresses below the surface; `None` where the method gives none.
    fn loaded(&self) -> Option<Loaded> {
        None
    }
}

impl Loading for Loaded {
    fn contact_radius(&self) -> f64 {
        self.contact_radius()
    }

    fn reach(&self) -> f64 {
        self.reach()
    }

    fn pressure(&self, r: f64) -> Option<f64> {
        Some(self.pressure(r)).filter(|pressure| pressure.is_finite())
    }

    fn surface(&self, r: f64) -> Option<f64> {
        Some(self.surface(r)).filter(|displacement| displacement.is_finite())
    }

    fn stress_intensity(&self) -> Option<f64> {
        Some(self.stress_intensity()).filter(|intensity| intensity.abs() > 0.0)
    }

    fn loaded(&self) -> Option<Loaded> {
        Some(self.clone())
    }
}

/// Springs of friction that go along a normal motion without asking it, taken out of a contact.
pub trait TangentialBed: Send {
    /// Goes on at the normal and the tangential speed `speeds` [m/s] for `duration` [s]; the work ∫F_x du_x it takes [J].
    fn go(&mut self, speeds: (f64, f64), duration: f64) -> f64;

    /// The work [J] of going on so, and whether a spring would stick at the end; the bed stays as it is.
    fn look(&self, speeds: (f64, f64), duration: f64) -> (f64, bool);

    /// Present state.
    fn state(&self) -> Tangential;

    /// Energy [J] its springs have lost so far as they relax.
    fn relaxed(&self) -> f64;

    /// Displacement [m] at which the contact slides as a whole.
    fn gives_at(&self) -> f64;

    /// From now on friction is the part `part` of what it was; what springs carry above it they let go at once, which is
    /// lost.
    fn give_way(&mut self, part: f64);

    /// The springs as they are, on their own.
    fn copy(&self) -> Box<dyn TangentialBed>;
}

/// A contact: it follows straight pieces of (d, u_x) and can be looked at without being moved.
///
/// What a contact knows better than by being followed it says itself: the answer to a force that it finds at once
/// ([`press`](Self::press)), the depth at which a retraction parts it, the instant at which the bodies
/// part, its creep.
pub trait ContactModel: Send {
    /// Follows a straight piece; the jumps and turns on the way, in order.
    ///
    /// # Errors
    /// The contact cannot follow.
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError>;

    /// The contact as it would be at the end of a piece; it stays where it is.
    ///
    /// The cost grows neither with the number of springs nor with what lies behind.
    ///
    /// # Errors
    /// As of [`follow`](Self::follow).
    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError>;

    /// Present state of the normal contact.
    fn state(&self) -> Normal;

    /// Present indentation [m]; `None` where the state has none.
    fn indentation(&self) -> Option<f64> {
        self.state().indentation
    }

    /// What a prescribed depth leads [m]: the indenter, or the far end of a spring that carries it.
    fn position(&self) -> Option<f64> {
        self.indentation()
    }

    /// Whether the bodies touch or attract each other.
    fn joined(&self) -> bool;

    /// The load of the contact as it is now, to be looked at; `None` where the bodies are apart.
    fn loading(&self) -> Option<Box<dyn Loading + '_>>;

    /// The springs as they are now, those that have been let go included; `None` where the bodies are apart and no spring
    /// remembers, or where there is no bed.
    fn bed(&self) -> Option<Loaded> {
        self.loading()?.loaded()
    }

    /// The contact as it is, on its own.
    fn copy(&self) -> Box<dyn ContactModel>;

    /// Marks the present state, of which [`at_mark`](Self::at_mark) then makes a copy at less cost than one at every state;
    /// whether the contact can.
    fn mark(&mut self) -> bool {
        false
    }

    /// Forgets the mark.
    fn unmark(&mut self) {}

    /// The contact as it was when it was marked.
    fn at_mark(&self) -> Option<Box<dyn ContactModel>> {
        None
    }

    /// State of the tangential contact, if there is friction.
    fn tangential(&self) -> Option<Tangential> {
        None
    }

    /// Where a contact that glides over a bed with memory is, and what holds it back.
    fn gliding(&self) -> Option<Gliding> {
        None
    }

    /// What is joined of a contact in many pieces that stand for themselves.
    fn pieces(&self) -> Option<Joined> {
        None
    }

    /// The normal contact and the springs of friction as they are, each on its own, where the normal motion does not ask
    /// them.
    fn separate(&self) -> Option<(Box<dyn ContactModel>, Box<dyn TangentialBed>)> {
        None
    }

    /// State of the normal contact under the shear of the tangential one, where that changes it.
    fn sheared(&self) -> Normal {
        self.state()
    }

    /// Lets the tangential contact catch up with the normal one.
    ///
    /// # Errors
    /// There is no state of the tangential contact.
    fn settle(&mut self) -> Result<(), ContactError> {
        Ok(())
    }

    /// The straight steps the tangential contact has taken, if they were kept.
    fn path(&self) -> &[Pose] {
        &[]
    }

    /// The material of bodies that remember; `None` where the state depends on the present alone.
    fn memory(&self) -> Option<Arc<Spectrum>> {
        None
    }

    /// What the contact takes.
    fn effort(&self) -> Effort {
        Effort::default()
    }

    /// Moves to a force at once; `None` where it has to be found piece by piece.
    ///
    /// # Errors
    /// No state carries the force.
    fn press(&mut self, _pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        None
    }

    /// Depth [m] at which a retraction parts the bodies, where that depends on the present alone.
    ///
    /// # Errors
    /// The contact cannot follow.
    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        None
    }

    /// Part of its force by which two looks may differ that are as good as at one time: of an edge that is followed in steps.
    fn doubt(&self) -> f64 {
        0.0
    }

    /// When in a piece the bodies part, of a contact that knows it.
    ///
    /// # Errors
    /// The contact cannot follow.
    fn parting(&self, _piece: &Straight) -> Result<Option<Parting>, ContactError> {
        Ok(None)
    }

    /// The exact answer to a force that never falls, of a contact not touched before.
    fn creep(&self) -> Option<Creep> {
        None
    }

    /// Takes the indenter away at once, whatever holds it; the depth [m] at which the bodies part, where they are held and
    /// it is known.
    fn leave(&mut self) -> Option<f64> {
        None
    }
}

impl Clone for Box<dyn ContactModel> {
    fn clone(&self) -> Self {
        self.copy()
    }
}

/// Where the indenter is: indentation and tangential displacement [m].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pose {
    /// Indentation d [m]; not above zero where the bodies are apart.
    pub indentation: f64,
    /// Tangential displacement u_x [m].
    pub slide: f64,
}

/// Deviation of a joint from the line through both ends, in roundings of the depth, up to which two pieces are one.
const ROUNDINGS: f64 = 16.0;
/// Relative difference of the speeds up to which two pieces are one.
const SAME_SPEED: f64 = 1e-9;

impl Straight {
    /// The piece from the depth `from` [m] to the depth `to` [m] in `duration` [s], nothing sliding.
    #[must_use]
    pub fn between(from: f64, to: f64, duration: f64) -> Self {
        let speed = if duration > 0.0 { (to - from) / duration } else { 0.0 };
        Self { to, speed, slide: 0.0, sliding_speed: 0.0, duration }
    }

    /// This piece, begun at `start`, and the `next` one as one piece, if they lie on one line to rounding.
    ///
    /// A history cut anywhere is then the same history.
    #[must_use]
    pub fn joined_to(&self, start: Pose, next: &Self) -> Option<Self> {
        let duration = self.duration + next.duration;
        let part = self.duration / duration;
        let straight = |from: f64, joint: f64, to: f64| {
            let off = (from + part * (to - from) - joint).abs();
            off <= ROUNDINGS * f64::EPSILON * from.abs().max(joint.abs()).max(to.abs())
        };
        let fastest = self.speed.abs().max(next.speed.abs());
        let one = self.duration > 0.0
            && next.duration > 0.0
            && (self.speed - next.speed).abs() <= SAME_SPEED * fastest
            && straight(start.indentation, self.to, next.to)
            && straight(start.slide, self.slide, next.slide);
        let speed = next.speed + part * (self.speed - next.speed);
        one.then_some(Self { duration, speed, ..*next })
    }
}
