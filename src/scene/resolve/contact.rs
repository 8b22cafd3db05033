//! Who computes a contact that stays where it is.

use super::super::law::{ContactLaw, ElasticAdhesion, HeldEdge, SpringCount};
use super::super::plan::Shared;
use crate::contact::adhesion::{Adhesion, AdhesionTraits, EdgeRule, Range};
use crate::contact::plastic::YieldingBall;
use crate::contact::rough::EdgeWorks;
use crate::material::{Body, Relaxation};
use std::num::NonZeroUsize;
use std::sync::Arc;

/// E*(t) of the bodies, elastic ones included.
pub(super) fn lasting(shared: &Shared) -> Arc<Relaxation> {
    shared.read.relaxation.clone().unwrap_or_else(|| Arc::new(unrelaxed(shared)))
}

/// Who computes a contact that stays where it is.
pub(super) fn resting(shared: &Shared) -> ContactLaw {
    let scene = &shared.scene;
    let adhesion = scene.adhesion.as_ref();
    match (shared.read.relaxation.clone(), scene.springs) {
        (None, None) => match (yielding(shared), pinned(adhesion)) {
            (Some(ball), _) => ContactLaw::Plastic(ball),
            (None, Some(edge)) => ContactLaw::Continuous { relaxation: Arc::new(unrelaxed(shared)), edge: Some(edge) },
            (None, None) => ContactLaw::Direct(elastic(adhesion)),
        },
        (None, Some(count)) => ContactLaw::Springs { count, work: adhesion.map(|adhesion| adhesion.traits().work) },
        (Some(relaxation), asked) => viscoelastic(shared, relaxation, asked),
    }
}

/// Largest pressure [Pa] that both bodies bear, if one of them yields.
pub(super) fn hardness(shared: &Shared) -> Option<f64> {
    let (one, other) = &shared.scene.bodies;
    [one, other].into_iter().filter_map(Body::hardness).reduce(f64::min)
}

/// The ball of bodies that yield, the softer one first.
pub(super) fn yielding(shared: &Shared) -> Option<YieldingBall> {
    let weaker = hardness(shared)?;
    let radius = shared.scene.shape.tip_radius()?;
    Some(YieldingBall { radius, modulus: shared.pair.normal, limit: weaker })
}

pub(super) fn elastic(adhesion: Option<&Adhesion>) -> ElasticAdhesion {
    let Some(AdhesionTraits { work, range, .. }) = adhesion.map(Adhesion::traits) else { return ElasticAdhesion::None };
    match range {
        Range::Vanishing(_) => ElasticAdhesion::Vanishing { work },
        Range::Outside => ElasticAdhesion::Outside { work },
        Range::Finite(stress) => ElasticAdhesion::Finite { work, stress },
        Range::Fading(range) => ElasticAdhesion::Fading { work, range },
    }
}

/// Turns of the depth from which on springs cost less than the strips of the continuous bed, the square of which is paid.
const MANY_TURNS: usize = 128;

/// The continuous bed, unless springs are asked for or the depth goes in very many pieces without adhesion.
pub(super) fn viscoelastic(shared: &Shared, relaxation: Arc<Relaxation>, asked: Option<NonZeroUsize>) -> ContactLaw {
    let edge = held_edge(shared.scene.adhesion.as_ref());
    let takes_many = shared.is_curved() || shared.scene.machine.is_some() || shared.turns() > MANY_TURNS;
    let needed = (edge.is_none() && takes_many).then(|| SpringCount::of_accuracy(shared.accuracy()));
    match asked.map(SpringCount::Asked).or(needed) {
        Some(count) => ContactLaw::ViscoelasticSprings { relaxation, count },
        None => ContactLaw::Continuous { relaxation, edge },
    }
}

pub(super) fn held_edge(adhesion: Option<&Adhesion>) -> Option<HeldEdge> {
    let AdhesionTraits { work, closing, range, .. } = adhesion?.traits();
    match range {
        Range::Vanishing(edge) => {
            edge.map(|edge| HeldEdge { work, closing: closing.unwrap_or(work), edge: edge.clone() })
        }
        Range::Outside | Range::Finite(_) | Range::Fading(_) => None,
    }
}

/// The edge of elastic bodies that closes with less work than it opens with: it depends on what has been.
pub(super) fn pinned(adhesion: Option<&Adhesion>) -> Option<HeldEdge> {
    let AdhesionTraits { work, closing, .. } = adhesion?.traits();
    closing.map(|closing| HeldEdge { work, closing, edge: EdgeRule::Relaxed })
}

/// What the edges of a rough contact take and give.
pub(super) fn works(adhesion: &Adhesion) -> EdgeWorks {
    let AdhesionTraits { work, closing, .. } = adhesion.traits();
    EdgeWorks { opening: work, closing: closing.unwrap_or(work) }
}

/// Elastic bodies as bodies that remember nothing.
pub(super) fn unrelaxed(shared: &Shared) -> Relaxation {
    Relaxation { equilibrium: shared.pair.normal, terms: Vec::new(), viscosity: 0.0 }
}
