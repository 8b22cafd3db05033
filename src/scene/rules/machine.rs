//! A machine and its motions against the other parts.

use super::draft::Draft;
use super::parts::not_round;
use crate::contact::adhesion::Range;
use crate::friction::Friction;
use crate::input::problem::Problem;
use crate::material::Body;
use crate::scene::history::{EntryTraits, MachineMotion};
use crate::scene::mended::Look;
use crate::scene::stage::Path;
use crate::shape::Family;

pub(super) fn refused(path: &str, what: impl Into<String>) -> Option<Problem> {
    Some(Problem::new(path, what))
}

pub(super) fn refused_entry(entry: &EntryTraits<'_>, what: impl Into<String>) -> Option<Problem> {
    refused(&entry.place(), what)
}

/// The name of a motion with the machine behind it, as a message begins with it.
const MACHINE: &str = "a machine";

pub(super) fn without_motion(draft: &Draft<'_>) -> Option<Problem> {
    (draft.has_machine()? && !draft.is_driven()?).then_some(())?;
    draft.machine()?.mass?;
    refused(
        "machine",
        "moves nothing, for the history leads the contact by itself: expected Drive(speed: …, over: …), Ring(amplitude: …, over: …) or Fall(height: …, over: …) in the history, no mass for a spring by whose far end the history leads the contact, or no machine",
    )
}

pub(super) fn without_machine(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.machine?;
    if draft.has_machine()? && draft.machine().is_none_or(|machine| machine.mass.is_some()) {
        return None;
    }
    refused_entry(
        entry,
        format!("{} needs a mass to be moved: expected machine: (mass: …, stiffness: …, damping: …)", entry.name),
    )
}

/// Springs and dampers that make no sense for a motion.
pub(super) fn suspension(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let (machine, motion) = (draft.machine()?, entry.machine?.motion);
    let stiff = machine.stiffness() > 0.0;
    match motion {
        MachineMotion::Drive { .. } if !stiff => refused(
            "machine.stiffness",
            format!("{} draws the mass by its spring: expected a stiffness above zero", entry.name),
        ),
        MachineMotion::Fall { .. } if stiff => refused(
            "machine.stiffness",
            format!("a spring would hold the mass that {} lets go: expected stiffness: 0", entry.name),
        ),
        MachineMotion::Drive { .. } | MachineMotion::Ring { .. } | MachineMotion::Fall { .. } => None,
    }
}

pub(super) fn on_shape(draft: &Draft<'_>) -> Option<Problem> {
    let shape = draft.shape().filter(|_| draft.has_machine() == Some(true))?;
    let why = match shape.family() {
        Family::Round if !shape.is_plane() => return None,
        Family::Round => {
            "how deep a section goes depends on the size of its bodies, and so does the stiffness a mass feels"
        }
        Family::Line(_) | Family::Map(..) => {
            "springs of a rough line touch one by one, at each of which the force has a kink"
        }
        Family::Tips(_) => "tips side by side turn the body as they slip",
        Family::Wavy(_) => "a series of the half-plane has no depth",
        Family::Pad(_) => "its force has a kink where springs begin to join or to let go",
    };
    let shape = not_round(shape).unwrap_or_else(|| format!("a {}", shape.name()));
    refused("machine", format!("on {shape} cannot be computed, for {why}: expected a round shape"))
}

pub(super) fn of_bodies(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let motion = entry.machine?.motion;
    let (one, two) = draft.bodies(Look::Kind)?;
    let either = |of: fn(&Body) -> bool| of(one) || of(two);
    let why = if either(|body| matches!(body, Body::Plastic(_))) {
        "the dent that a blow leaves has another shape for the next: expected Elastic bodies"
    } else if motion.is_along()
        && matches!(draft.friction(Look::Kind), Some(Friction::RateState(_)))
        && either(|body| matches!(body, Body::Viscoelastic(_)))
    {
        "one state of a contact that slips as a whole knows nothing of a force and a stiffness that relax: expected Elastic bodies, or StaticKinetic(…)"
    } else {
        return None;
    };
    let name = if matches!(one, Body::Plastic(_) | Body::Viscoelastic(_)) { one } else { two }.name();
    refused_entry(entry, format!("{} with a {name} body cannot be computed, for {why}", entry.name))
}

/// A mass is let go where it has been put at once, and a dashpot lets nothing be put deeper at once.
pub(super) fn ring_on_dashpot(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let MachineMotion::Ring { amplitude } = entry.machine?.motion else { return None };
    if amplitude <= 0.0 || draft.relaxation()?.viscosity <= 0.0 {
        return None;
    }
    refused_entry(
        entry,
        format!(
            "{} begins deeper than the contact by its amplitude, {amplitude:e} m, and a viscosity lets nothing give at once: expected an amplitude below zero, which lifts the mass, or no viscosity",
            entry.name
        ),
    )
}

pub(super) fn under_adhesion(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let motion = entry.machine?.motion;
    let adhesion = draft.adhesion(Look::Kind)?.traits();
    let pinned = draft.adhesion(Look::Whole).is_some_and(|adhesion| adhesion.traits().closing.is_some());
    let why = match motion {
        MachineMotion::Drive { .. } | MachineMotion::Ring { .. } | MachineMotion::Fall { .. }
            if adhesion.range == Range::Outside =>
        {
            "its force sets in at once where the bodies touch, within a step of the mass"
        }
        MachineMotion::Drive { .. } => "the springs of an adhesive edge are pulled and have no limit μq",
        MachineMotion::Ring { .. } | MachineMotion::Fall { .. } => match adhesion.range {
            Range::Outside | Range::Finite(_) | Range::Fading(_) => {
                "an attraction across the gap acts on the mass before the bodies touch"
            }
            Range::Vanishing(_) if draft.pair_relaxes()? => {
                "the edge of a body that relaxes joins and leaves within a step of the mass: expected Elastic bodies, or an Impact"
            }
            Range::Vanishing(_) if pinned => {
                "an edge that stands still between two works leaves it within a step of the mass"
            }
            Range::Vanishing(_) => return None,
        },
    };
    refused_entry(
        entry,
        format!("{} with {} adhesion cannot be computed, for {why}: expected no adhesion", entry.name, adhesion.name),
    )
}

pub(super) fn friction(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.machine.filter(|machine| machine.motion.is_along())?;
    if !draft.rubs()? {
        return refused_entry(
            entry,
            format!(
                "{} needs friction, for without one nothing holds the mass: expected a friction such as StaticKinetic(static: 0.4, kinetic: 0.3)",
                entry.name
            ),
        );
    }
    let friction = draft.friction(Look::Kind)?;
    match friction {
        Friction::Coulomb(_) | Friction::StaticKinetic(_) | Friction::RateState(_) => None,
        Friction::Stuck => refused_entry(
            entry,
            format!(
                "{} with Stuck cannot be computed, for it tells of no friction once the edge has given way: expected Coulomb(…) or StaticKinetic(…), or Slide(…)",
                entry.name
            ),
        ),
        Friction::CoulombOrowan(_) | Friction::Pressure(_) => refused_entry(
            entry,
            format!(
                "{} with {} friction cannot be computed, for it is a law of gross sliding that knows no stick: expected Coulomb(…) or StaticKinetic(…)",
                entry.name,
                friction.name()
            ),
        ),
    }
}

pub(super) fn with_wear(draft: &Draft<'_>) -> Option<Problem> {
    let (name, true) = (draft.wear()?, draft.has_machine()?) else { return None };
    refused(
        "machine",
        format!(
            "with {name} wear cannot be computed, for a profile that is worn off changes the stiffness between two slips: expected no wear, or no machine"
        ),
    )
}

pub(super) fn on_springs(draft: &Draft<'_>) -> Option<Problem> {
    draft.has_machine()?.then_some(())?;
    draft.springs()?;
    // Along the surface bodies that relax have springs in any case.
    if draft.drives()? && draft.pair_relaxes()? {
        return None;
    }
    refused(
        "springs",
        "with a machine cannot be computed, for each spring that touches makes a kink in the motion: leave springs out",
    )
}

pub(super) fn on_pixels(draft: &Draft<'_>) -> Option<Problem> {
    draft.has_machine()?.then_some(())?;
    draft.half_space(Look::Kind)?;
    refused(
        "machine",
        "with solver: HalfSpace cannot be computed, for a motion asks for its force thousands of times: expected no solver, or no machine",
    )
}

/// What a motion can stand behind.
pub(super) fn in_history(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let motion = entry.machine?.motion;
    let (name, last) = (entry.name, draft.length()?.checked_sub(1)?);
    match motion {
        MachineMotion::Fall { .. } if last > 0 => {
            refused_entry(entry, format!("{name} stands beside {last} other entries: expected it alone in the history"))
        }
        MachineMotion::Ring { .. } if entry.number != last => refused_entry(
            entry,
            format!("{name} leaves a mass that still swings: expected it at the end of the history"),
        ),
        MachineMotion::Drive { .. } | MachineMotion::Ring { .. } if entry.number == 0 => refused_entry(
            entry,
            format!("the bodies only touch at the start: expected an Indent or Press before {name}"),
        ),
        MachineMotion::Drive { .. } | MachineMotion::Ring { .. } | MachineMotion::Fall { .. } => None,
    }
}

/// What leads the contact by itself cannot stand behind a machine, nor can what parts it or moves it along.
pub(super) fn beside(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let first = draft.firsts().machine?;
    if entry.machine.is_some() {
        return None;
    }
    let what = match () {
        () if entry.impact.is_some() || entry.glide.is_some() => "is a motion of its own",
        () if entry.number > first.number => "leads the contact while the mass still moves",
        () if entry.stages.iter().any(|stage| matches!(stage.normal, Path::UntilParted { .. })) => {
            "parts the bodies, and the machine needs them in contact"
        }
        () => return None,
    };
    refused_entry(
        entry,
        format!(
            "{} {what}, which {MACHINE} cannot stand with: expected Indent, Press, Hold, HoldForce or Slide before {}",
            entry.name, first.name
        ),
    )
}
