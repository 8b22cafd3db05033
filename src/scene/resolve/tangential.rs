//! Who computes what goes along the surface.

use super::super::law::{FrictionLaw, Interface, Start, Travel};
use super::super::plan::Shared;
use super::contact::{elastic, lasting};
use crate::friction::{Friction, Slip};
use std::num::NonZeroUsize;

/// Springs of the friction of viscoelastic bodies unless the scene says otherwise.
const FRICTION_SPRINGS: NonZeroUsize = NonZeroUsize::MIN.saturating_add(999);

/// What is left of the friction that sets a contact sliding once it slides as a whole.
pub(super) fn left(friction: Option<&Friction>) -> f64 {
    match friction {
        Some(Friction::StaticKinetic(law)) if law.r#static.si() > 0.0 => law.kinetic.si() / law.r#static.si(),
        Some(
            Friction::StaticKinetic(_)
            | Friction::Coulomb(_)
            | Friction::RateState(_)
            | Friction::Stuck
            | Friction::CoulombOrowan(_)
            | Friction::Pressure(_),
        )
        | None => 1.0,
    }
}

/// The motion along the surface with which a history ends.
pub(super) fn travel(shared: &Shared) -> Option<Travel> {
    let entries = shared.scene.history.iter().enumerate().rev();
    let mut glides = entries.filter_map(|(entry, of)| Some((entry, of.traits(entry, None, None).glide?)));
    let (entry, (glide, motion)) = glides.next()?;
    Some(Travel {
        entry,
        speeds: glide.speed.iter().map(|speed| speed.si()).collect(),
        motion,
        relaxation: lasting(shared),
        start: if glide.is_steady() { Start::LeftOut } else { Start::Followed },
    })
}

pub(super) fn tangential(shared: &Shared, friction: &Friction) -> FrictionLaw {
    let springs = shared.scene.springs;
    let coefficient = match friction.slip() {
        Slip::Local(coefficient) => coefficient,
        Slip::Gross => return gross(shared, friction),
        Slip::Nowhere => {
            let work = elastic(shared.scene.adhesion.as_ref()).work_at_edge().unwrap_or(0.0);
            return FrictionLaw::Stuck { work };
        }
    };
    if let Friction::RateState(law) = friction
        && !law.is_coulomb()
    {
        return FrictionLaw::RateState(law.clone());
    }
    match (shared.read.relaxation.clone(), springs) {
        (None, None) => FrictionLaw::Memory { coefficient },
        (None, Some(count)) => FrictionLaw::Springs { coefficient, count },
        (Some(relaxation), asked) => {
            FrictionLaw::Viscoelastic { coefficient, count: asked.unwrap_or(FRICTION_SPRINGS), relaxation }
        }
    }
}

pub(super) fn gross(shared: &Shared, friction: &Friction) -> FrictionLaw {
    let interface = interface(shared, friction);
    match elastic(shared.scene.adhesion.as_ref()).work_at_edge().filter(|_| shared.scene.adhesion.is_some()) {
        Some(work) => FrictionLaw::Peeling { interface, work },
        None => FrictionLaw::Sliding(interface),
    }
}

/// A friction that slips as a whole, with its table.
pub(super) fn interface(shared: &Shared, friction: &Friction) -> Interface {
    Interface { friction: friction.clone(), strength: shared.read.strength.clone() }
}
