//! The speed at which a contact meets a force.

use super::ahead;
use crate::contact::error::ContactError;
use crate::contact::model::ContactModel;
use crate::contact::state::Normal;
use crate::numerics::{extremum, root};
use std::cell::Cell;

/// A change of the depth, relative to it, that no force tells: its rounding.
pub(super) const UNSEEN: f64 = 4.0 * f64::EPSILON;
/// No speed is looked for beyond this [m/s].
const FASTEST: f64 = 1e290;
/// Times the pace and the first guess beyond which a speed leads over a jump.
const MUCH_FASTER: f64 = 16.0;

/// The speed at which a motion of the given duration ends with the force `force` [N]; `None` if the
/// bodies part before.
///
/// # Errors
/// The contact would outgrow the profile.
pub fn speed_to(contact: &mut dyn ContactModel, force: f64, duration: f64) -> Result<Option<f64>, ContactError> {
    let here = contact.state();
    let goal = Goal { force, within: 0.0, relative: 0.0, edges: EDGES, pace: f64::INFINITY };
    match goal.speed(contact, &here, duration)? {
        Found::Speed(speed) => Ok(Some(speed)),
        Found::Jump | Found::Parted => Ok(None),
    }
}

/// What a search for a speed comes to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Found {
    /// A speed [m/s] at which the force is met, or beside which it jumps.
    Speed(f64),
    /// None is nearly as slow as that: it leads over a jump.
    Jump,
    /// The bodies part before.
    Parted,
}

/// What a piece of the depth is to meet.
#[derive(Debug, Clone, Copy)]
pub(super) struct Goal {
    /// Force at its end [N].
    pub force: f64,
    /// By how much it may be missed [N].
    pub within: f64,
    /// Part of the speed to which it is found where the force jumps over the goal.
    pub relative: f64,
    /// Places at which the edge may come to rest on the way.
    pub edges: u32,
    /// A speed [m/s] of which many times as much leads over a jump.
    pub pace: f64,
}

impl Goal {
    /// The speed of such a piece of the duration `duration` [s] of a contact in the state `state`.
    pub(super) fn speed(
        self,
        contact: &mut dyn ContactModel,
        state: &Normal,
        duration: f64,
    ) -> Result<Found, ContactError> {
        let Self { force, within, relative, edges, pace } = self;
        let depth = state.indentation.unwrap_or(0.0);
        let damping = damping(contact, state.stiffness);
        let failed = Cell::new(None);
        // Force beyond the prescribed one, and whether the bodies still touch.
        let mut look = |speed: f64| match contact.look(&ahead(contact, speed, duration)) {
            Ok(seen) => (seen.force - force, seen.contact_radius > 0.0),
            Err(error) => {
                failed.set(Some(error));
                (f64::MAX, true)
            }
        };
        // A guess, widened until it brackets the root: the force grows with the speed.
        let (still, joined) = look(0.0);
        if still.abs() <= UNSEEN * state.stiffness * depth.abs() {
            return Ok(Found::Speed(0.0));
        }
        if still > 0.0 && !joined {
            // At rest they have parted by then.
            return failed.get().map_or(Ok(Found::Parted), Err);
        }
        let width = (first_way(state, still) / duration).min(still.abs() / damping).max(1e-300).copysign(-still);
        let fastest = (MUCH_FASTER * pace.abs().max(width.abs())).min(FASTEST);
        let ends = match bracket(&mut look, still, (width, fastest), edges) {
            Bracket::Ends(ends) => ends,
            Bracket::TooFast if fastest < FASTEST && failed.get().is_none() => return Ok(Found::Jump),
            Bracket::TooFast | Bracket::Parted => return failed.get().map_or(Ok(Found::Parted), Err),
        };
        let mut ends = ends.map(|(speed, off)| (speed, met(off, within)));
        ends.sort_by(|one, other| one.0.total_cmp(&other.0));
        let off = |speed| met(look(speed).0, within);
        let speed = root::brent_from(off, ends, relative).unwrap_or(width);
        // At the end of a profile the search ends where the force is not met, and beyond there is no contact; beside a jump,
        // where it is not met either, there is one.
        let outgrown = failed.take();
        if outgrown.is_some() && look(speed).0.abs() > within.max(MET * force.abs()) {
            look(speed + BEYOND.max(2.0 * relative) * speed.abs().copysign(width));
        }
        match outgrown.filter(|_| speed.abs() <= 0.0).or(failed.take()) {
            Some(error) => Err(error),
            None => Ok(Found::Speed(speed)),
        }
    }
}

/// What a search for two speeds between which the force is met comes to.
enum Bracket {
    /// The speeds [m/s], and what the force is too great by there [N].
    Ends([(f64, f64); 2]),
    /// None is so slow.
    TooFast,
    /// The bodies part before.
    Parted,
}

/// What the force is off by [N], nothing where that is within `within` [N].
fn met(off: f64, within: f64) -> f64 {
    if off.abs() > within { off } else { 0.0 }
}

/// By what the force of a contact of the stiffness `stiffness` [N/m] grows with its speed at once [N s/m], nearly: of its
/// dashpot, zero without.
pub(super) fn damping(contact: &dyn ContactModel, stiffness: f64) -> f64 {
    contact.memory().map_or(0.0, |spectrum| match (spectrum.viscosity(), spectrum.instantaneous()) {
        (viscosity, modulus) if viscosity > 0.0 && modulus > 0.0 => stiffness * viscosity / modulus,
        _ => 0.0,
    })
}

/// A first guess [m] of how far a contact moves to take the force `still` [N] too much or too little: that of its
/// stiffness, and where nothing attracts no more than a cone needs, for what is pressed grows stiffer. Bodies apart
/// have no stiffness but the way between them.
fn first_way(state: &Normal, still: f64) -> f64 {
    let (depth, attracts) = (state.indentation.unwrap_or(0.0).abs(), state.stored.surface < 0.0);
    let linear = still.abs() / state.stiffness;
    let way = if state.stiffness <= 0.0 {
        depth
    } else if attracts || depth <= 0.0 {
        linear
    } else {
        2.0 * linear / (1.0 + (1.0 + 2.0 * linear / depth).sqrt())
    };
    way.max(LEAST_WAY * depth).max(LEAST_DEPTH)
}

/// The least first guess, as a part of the depth and in metres.
const LEAST_WAY: f64 = 1e-12;
pub(super) const LEAST_DEPTH: f64 = 1e-21;

/// Part of a force by which a root may miss it.
const MET: f64 = 1e-9;
/// Part of a speed by which the end of a profile may lie beyond it.
const BEYOND: f64 = 1e-9;

/// Two speeds between which the force is met, and what it is too great by there [N], from zero on and widened from `width`
/// [m/s] to `fastest`; `still` is what it is too great by at rest [N].
///
/// A pull that has grown with the way and is smaller on the next has given way between: the edge has jumped, as over the
/// crest of a wave. It may have been strong enough before.
fn bracket(
    look: &mut impl FnMut(f64) -> (f64, bool),
    still: f64,
    (mut width, fastest): (f64, f64),
    edges: u32,
) -> Bracket {
    let (mut before, mut inner, mut grows) = ((0.0, still), (0.0, still), false);
    while width.abs() < fastest {
        let (residual, joined) = look(width);
        let parted = residual >= 0.0 && !joined && still > 0.0;
        if parted || (edges > 1 && grows && residual > inner.1) {
            // Parted, which meets no force too: the pull must be found before, if anywhere.
            let near = last_pull(look, inner, width, edges).map(|pull| [inner, pull]);
            let ends = near.or_else(|| strongest(look, (before.0, width), edges).map(|pull| [before, pull]));
            if parted || ends.is_some() {
                return ends.map_or(Bracket::Parted, Bracket::Ends);
            }
        }
        if (residual > 0.0) != (still > 0.0) {
            return Bracket::Ends([inner, (width, residual)]);
        }
        grows = still > 0.0 && residual < inner.1;
        (before, inner, width) = (inner, (width, residual), 2.0 * width);
    }
    Bracket::TooFast
}

/// A speed between two at which the pull is stronger than prescribed, and by how much [N], below zero: where it is strongest if
/// nowhere else, for the last speed looked at may lie beyond that. Where a shorter piece shows more none is looked for.
fn strongest(look: &mut impl FnMut(f64) -> (f64, bool), (slow, fast): (f64, f64), edges: u32) -> Option<(f64, f64)> {
    let pull = |speed: f64| -look(speed).0;
    let found = (edges > 1).then(|| extremum::reaches_zero(pull, slow.min(fast), slow.max(fast))).flatten()?;
    Some((found, look(found).0))
}

/// Speeds tried between one that keeps the bodies together and one that parts them. Where the pull is stronger than
/// prescribed for less than this, a shorter piece shows it.
const TRIES: u32 = 12;
/// Places of the edge that are tried, each as far as it holds, where there is no shorter piece to show them.
pub(super) const EDGES: u32 = 3;
/// By how much more than on the last step the pull may still grow on another as long.
const GROWS: f64 = 2.0;

/// A speed between one that keeps the bodies together and one that parts them, or lets the edge jump, at which the pull is
/// stronger than prescribed, and by how much [N], below zero; `held` is such a speed and what the pull lacks there [N].
///
/// The nearer to where it gives way, the slower the pull of a contact grows with the way: what it lacks tells that there
/// is none. Where it lacks more than nearer by, the edge has jumped; then its next place is tried as well.
fn last_pull(
    look: &mut impl FnMut(f64) -> (f64, bool),
    mut held: (f64, f64),
    end: f64,
    edges: u32,
) -> Option<(f64, f64)> {
    for _ in 0..edges {
        let (mut jumped, mut beyond) = (None, end);
        for _ in 0..TRIES {
            let middle = 0.5 * (held.0 + beyond);
            match look(middle) {
                (residual, true) if residual <= 0.0 => return Some((middle, residual)),
                (residual, true) if residual > held.1 && edges > 1 => {
                    jumped = jumped.or(Some((middle, residual)));
                    beyond = middle;
                }
                (residual, true) if residual > GROWS * (held.1 - residual) => break,
                (residual, true) => held = (middle, residual),
                (_, false) => beyond = middle,
            }
        }
        held = jumped?;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Speeds are looked for up to the fastest; the ends of what is found have been looked at.
    #[test]
    fn a_bracket_is_no_faster_than_it_may_be() {
        let mut look = |speed: f64| (speed - 100.0, true);
        assert!(matches!(bracket(&mut look, -100.0, (1.0, 16.0), 1), Bracket::TooFast));
        let Bracket::Ends(ends) = bracket(&mut look, -100.0, (1.0, FASTEST), 1) else { panic!("no ends") };
        assert_eq!(ends, [(64.0, -36.0), (128.0, 28.0)]);
    }
}
