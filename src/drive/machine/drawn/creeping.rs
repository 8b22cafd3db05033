//! A mass that is drawn slowly while the contact sticks: it does not swing, but follows the balance of forces.

use super::super::Suspension;
use crate::contact::error::ContactError;
use crate::friction::{Pose, TangentialMemory};
use crate::numerics::chebyshev::Chebyshev;
use crate::numerics::root;

/// Paces of the mass before a slip, and before another corner of the memory, from which on its swing is followed again:
/// there the balance changes within a swing.
const BEFORE_SLIP: f64 = 50.0;
const BEFORE_CORNER: f64 = 40.0;
/// How much longer than that a creep has to last to be worth one.
const WORTH: f64 = 3.0;
/// Half the span of time in which inertia and drag are found, relative to the time left, and its most in paces.
const SPAN: f64 = 0.3;
const MOST_PACES: f64 = 40.0;
/// Nodes in that span, and corrections: each gains two orders in one over the paces left.
const NODES: usize = 12;
const CORRECTIONS: usize = 2;
/// Part of the way to a corner that is still before it.
const BEFORE: f64 = 1.0 - 1e-6;

/// A mass that creeps: of all its motions the one that does not swing, m ẍ + c ẋ + F_x(x) = k(X − x) with X at the steady speed V.
///
/// In powers of the time a swing takes over the time in which the balance changes: the balance F_x(x) = k(X − x) first, then
/// again with the inertia and the drag that the last one has. It is smooth up to the next corner of the memory.
#[derive(Debug, Clone)]
pub(super) struct Creep {
    suspension: Suspension,
    /// Speed V of the far end [m/s].
    drawn: f64,
    /// Displacement in the memory [m], extension of the spring [m] and time [s] at its beginning.
    from: (f64, f64, f64),
    memory: TangentialMemory,
    /// Where it goes, 1 or −1.
    ahead: f64,
    /// Displacement of the corner ahead [m], and the time at which the mass gets there [s].
    corner: (f64, f64),
    /// Time [s] at which swings are followed again.
    resumes: f64,
}

/// Time [s] in which a mass on the stiffness `stiffness` [N/m] gives way: a radian of its swing, and what drag adds.
fn pace(suspension: &Suspension, stiffness: f64) -> f64 {
    (suspension.mass / stiffness).sqrt() + suspension.damping / stiffness
}

impl Creep {
    /// What creeps on from the contact `memory`, the spring drawn out by `extension` [m] at the time `time` [s], its far
    /// end going on at `drawn` [m/s].
    ///
    /// # Errors
    /// The indentation leaves the profile.
    pub(super) fn new(
        (suspension, drawn): (Suspension, f64),
        memory: &TangentialMemory,
        (extension, time): (f64, f64),
    ) -> Result<Self, ContactError> {
        let Pose { indentation, slide } = memory.position();
        let pulled = suspension.stiffness * extension - memory.state().tangential_force;
        let ahead = 1f64.copysign(if drawn.abs() > 0.0 { drawn } else { pulled });
        let corner = memory.next_corner(ahead);
        let mut creep = Self {
            suspension,
            drawn,
            from: (slide, extension, time),
            memory: memory.clone(),
            ahead,
            corner: (corner.slide, f64::INFINITY),
            resumes: f64::INFINITY,
        };
        if drawn.abs() <= 0.0 {
            return Ok(creep);
        }
        let mut there = memory.clone();
        there.advance(Pose { indentation, slide: slide + BEFORE * (corner.slide - slide) })?;
        let (stiffness, contact) = (suspension.stiffness, there.state().stiffness);
        let force = memory.force_at(Pose { indentation, slide: corner.slide })?;
        let end = creep.arrival((corner.slide, force), contact);
        creep.corner = (corner.slide, end);
        let before = if corner.is_last { BEFORE_SLIP } else { BEFORE_CORNER };
        creep.resumes = end - before * pace(&suspension, if corner.is_last { stiffness } else { stiffness + contact });
        Ok(creep)
    }

    /// When [s] the contact carries the force `force` [N] at the displacement `slide` [m], its stiffness there `contact` [N/m].
    fn arrival(&self, (slide, force): (f64, f64), contact: f64) -> f64 {
        let Suspension { stiffness, damping, .. } = self.suspension;
        let (begin, extension, time) = self.from;
        let drag = damping * self.drawn * stiffness / (stiffness + contact);
        let left = (force + drag) / stiffness - extension + (slide - begin);
        time + (left / self.drawn).max(0.0)
    }

    /// Radians of the swing on the sticking contact from its beginning to the next slip.
    pub(super) fn swings(&self) -> f64 {
        if self.drawn.abs() <= 0.0 {
            return f64::INFINITY;
        }
        let slip = self.arrival((self.memory.last_corner(self.ahead), self.ahead * self.memory.limit()), 0.0);
        (slip - self.from.2) * ((self.suspension.stiffness + self.memory.stuck()) / self.suspension.mass).sqrt()
    }

    /// Whether it lasts long enough.
    pub(super) fn is_long(&self) -> bool {
        let (begin, end) = (self.from.2, self.corner.1);
        end.is_infinite() || end - begin > WORTH * (end - self.resumes)
    }

    /// Time [s] at which swings are followed again.
    pub(super) fn resumes(&self) -> f64 {
        self.resumes
    }

    /// Displacement in the memory [m] and speed [m/s] at the time `time` [s].
    pub(super) fn at(&self, time: f64) -> (f64, f64) {
        let left = (SPAN * (self.corner.1 - time)).min(MOST_PACES * pace(&self.suspension, self.suspension.stiffness));
        // Times since `time`: their digits are those of the span.
        let span = ((self.from.2 - time).max(-left), left);
        if span.0 >= span.1 {
            return (self.balance(time, (0.0, 0.0)), self.drawn);
        }
        let mut motion = Chebyshev::of(|since| self.balance(time, (since, 0.0)), NODES, span);
        for _ in 0..CORRECTIONS {
            let slowed = self.slowed(&motion, span);
            motion = Chebyshev::of(|since| self.balance(time, (since, slowed.at(since))), NODES, span);
        }
        (self.balance(time, (0.0, self.slowed(&motion, span).at(0.0))), motion.slope().at(0.0))
    }

    /// Inertia and drag m ẍ + c ẋ [N] of a motion.
    fn slowed(&self, motion: &Chebyshev, span: (f64, f64)) -> Chebyshev {
        let speed = motion.slope();
        let acceleration = speed.slope();
        let Suspension { mass, damping, .. } = self.suspension;
        Chebyshev::of(|since| mass * acceleration.at(since) + damping * speed.at(since), NODES, span)
    }

    /// Displacement [m] at which the spring balances the friction and the force `slowed` [N], the time `since` [s] after `time` [s].
    fn balance(&self, time: f64, (since, slowed): (f64, f64)) -> f64 {
        let (begin, extension, from) = self.from;
        let indentation = self.memory.position().indentation;
        let out = extension + (self.drawn * (time - from) + self.drawn * since);
        let branch = self.memory.branch(self.ahead);
        let over = |way: f64| {
            let force = match &branch {
                Some(branch) if way >= 0.0 => branch.force(way),
                Some(_) | None => self.memory.force_at(Pose { indentation, slide: begin + way }).unwrap_or(f64::NAN),
            };
            self.ahead * (self.suspension.stiffness * (out - way) - slowed - force)
        };
        // A mass that swings may be ahead of the balance.
        let back = self.memory.last_corner(-self.ahead) - begin;
        let (from, to) = if over(0.0) < 0.0 { (back, 0.0) } else { (0.0, self.corner.0 - begin) };
        // Rounding alone may leave no root before the corner.
        begin + root::brent(over, from, to).unwrap_or(to)
    }
}
