//! The contact of a plan, composed of its parts in one place.

use super::follow::follow;
use super::{SimulationError, Wanted, fretting, viscoelastic};
use crate::contact::adhesion::dmt::DmtBall;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::Foundation;
use crate::contact::gliding::GlidingBed;
use crate::contact::mapped::MappedContact;
use crate::contact::model::ContactModel;
use crate::contact::plastic::PlasticContact;
use crate::contact::rough::{AdhesiveRough, RelaxingRough, RoughContact, YieldingRough, gliding_line};
use crate::contact::springs::{SpringBed, reach_for};
use crate::contact::viscoelastic::Spectrum;
use crate::friction::contact::{
    CoulombMemory, CoulombSprings, FrictionalContact, Peeling, SlidingContact, StuckEdge, TangentialContact,
    ViscoelasticFriction,
};
use crate::friction::peeling::{ShearedAdhesion, UNIFORM};
use crate::friction::{FrictionError, ViscoelasticBed};
use crate::material::Relaxation;
use crate::run::record::ErrorEstimate;
use crate::scene::law::{ContactLaw, ElasticAdhesion, FrictionLaw, MachineLaw, Travel};
use crate::scene::plan::{RoughPlan, RoundPlan, Shared};
use crate::scene::stage::{Path, Stage};
use crate::shape::rough::{RoughError, RoughLine};
use crate::shape::{Profile, Rim};
use std::num::NonZeroUsize;
use std::sync::Arc;

/// The contact of a plan, bodies just touching.
///
/// # Errors
/// The attraction has no contact; a bed would be wider than the profile.
pub fn contact(plan: &RoundPlan, wanted: Wanted) -> Result<Box<dyn ContactModel>, SimulationError> {
    let mut bed_radius = 0.0;
    let normal: Box<dyn ContactModel> = match &plan.contact {
        ContactLaw::Direct(adhesion) => {
            let contact = direct(plan.ground(), *adhesion)?;
            match plan.spring {
                Some(stiffness) => Box::new(arrived(contact.on_a_spring(stiffness), *adhesion)?),
                None => Box::new(contact),
            }
        }
        ContactLaw::Springs { count, work } => {
            bed_radius = radius_of_bed(plan, *work)?;
            Box::new(SpringBed::new(plan.ground(), count.get(), bed_radius, work.unwrap_or(0.0)))
        }
        ContactLaw::Plastic(ball) => Box::new(PlasticContact::new(*ball)),
        ContactLaw::Gliding { relaxation } => Box::new(gliding_bed(plan, relaxation)?),
        ContactLaw::Continuous { relaxation, edge } => viscoelastic::continuous(plan, relaxation, edge.as_ref()),
        ContactLaw::ViscoelasticSprings { relaxation, count } => viscoelastic::springs(plan, relaxation, count.get()),
    };
    let bed: Box<dyn ContactModel> = match &plan.friction {
        None => normal,
        Some(law) => {
            let friction = friction(plan, law, bed_radius, wanted);
            let friction = friction.map_err(|source| SimulationError::Refused(source.to_string()))?;
            Box::new(FrictionalContact::new(normal, friction))
        }
    };
    Ok(told(&plan.profile, bed))
}

/// Springs in half the largest contact of a body that moves along, for the accuracy of a scene.
pub(super) fn springs_of_gliding(plan: &Shared) -> f64 {
    (2.0 * plan.accuracy()).sqrt().recip().clamp(256.0, 2048.0).ceil()
}

/// Most springs of the way of a body that moves along.
const MOST_SPRINGS: f64 = 4e6;

/// The bed of springs of a body that moves along, just touching.
fn gliding_bed(plan: &RoundPlan, relaxation: &Relaxation) -> Result<GlidingBed, SimulationError> {
    let spectrum = Arc::new(Spectrum::new(relaxation));
    let width = viscoelastic::reach(plan, &spectrum) / springs_of_gliding(plan);
    let way = |stage: &Stage| if let Path::Steady { speed } = stage.tangential { speed * stage.over } else { 0.0 };
    let ways: f64 = plan.stages.iter().map(way).sum();
    if ways > MOST_SPRINGS * width {
        let what = format!(
            "history: a way of {ways:.3e} m goes over more than {MOST_SPRINGS:.0e} springs of the width {width:.1e} m: expected a shorter one, or no `over` for the steady state alone"
        );
        return Err(SimulationError::Refused(what));
    }
    Ok(GlidingBed::new(spectrum, plan.profile.clone(), (width, plan.accuracy())))
}

/// A contact that tells of itself in radii, or in the half widths of a section, whatever the places of its bed.
#[must_use]
pub fn told(profile: &Arc<dyn Profile>, bed: Box<dyn ContactModel>) -> Box<dyn ContactModel> {
    if profile.is_mapped() { Box::new(MappedContact::new(bed, profile.clone())) } else { bed }
}

/// The normal contact of a rough plan.
pub enum RoughNormal {
    /// Of elastic bodies.
    Elastic(RoughContact),
    /// Of elastic bodies that adhere.
    Adhesive(AdhesiveRough),
    /// Of bodies that relax.
    Relaxing(Box<RelaxingRough>),
    /// Of bodies that yield.
    Yielding(Box<YieldingRough>),
}

/// The normal contact of a rough plan with the surface of a seed, bodies just touching.
///
/// # Errors
/// The surface cannot be made.
pub fn rough_normal(plan: &RoughPlan, seed: u64) -> Result<RoughNormal, RoughError> {
    let (line, points, base) = (RoughLine::new(&plan.surface.rings, seed), plan.surface.points, plan.base.as_deref());
    let modulus = plan.pair.normal;
    Ok(match (&plan.relaxation, plan.works, plan.hardness) {
        (Some(relaxation), _, _) => {
            let spectrum = Arc::new(Spectrum::new(relaxation));
            RoughNormal::Relaxing(Box::new(RelaxingRough::new(&line, points, spectrum, base)?))
        }
        (None, Some(works), _) => RoughNormal::Adhesive(AdhesiveRough::new(&line, points, modulus, base, works)?),
        (None, None, Some(hardness)) => {
            RoughNormal::Yielding(Box::new(YieldingRough::new(&line, points, (modulus, hardness), base)?))
        }
        (None, None, None) => RoughNormal::Elastic(RoughContact::new(&line, points, modulus, base)?),
    })
}

/// The contact of a rough plan with the surface of a seed, bodies just touching.
///
/// # Errors
/// The surface cannot be made.
pub fn rough(plan: &RoughPlan, seed: u64) -> Result<Box<dyn ContactModel>, RoughError> {
    if let Some(travel) = plan.travel.as_ref().filter(|_| plan.moves_along()) {
        return Ok(Box::new(gliding_rough(plan, travel, seed)?));
    }
    let Some(coefficient) = plan.coefficient else {
        return Ok(match rough_normal(plan, seed)? {
            RoughNormal::Elastic(normal) => Box::new(normal),
            RoughNormal::Adhesive(normal) => Box::new(normal),
            RoughNormal::Relaxing(normal) => normal,
            RoughNormal::Yielding(normal) => normal,
        });
    };
    let grip = plan.grip(coefficient);
    Ok(match rough_normal(plan, seed)? {
        RoughNormal::Elastic(normal) => {
            let width = plan.surface.length() / plan.surface.points as f64;
            let friction = CoulombSprings::sorted(normal.bed().heights(), grip, width);
            let friction = friction.accurate_to(friction_accuracy(plan));
            Box::new(FrictionalContact::new(Box::new(normal), Box::new(friction)))
        }
        RoughNormal::Relaxing(normal) => {
            let bed = ViscoelasticBed::on(normal.layout().clone(), normal.shared_spectrum(), grip);
            let friction = ViscoelasticFriction::new(bed, grip.tangential_modulus);
            Box::new(FrictionalContact::new(normal, Box::new(friction)))
        }
        // Friction of patches that adhere or yield is refused.
        RoughNormal::Adhesive(normal) => Box::new(normal),
        RoughNormal::Yielding(normal) => normal,
    })
}

/// The bed of springs of a rough line that moves along, each with a past of its own.
fn gliding_rough(plan: &RoughPlan, travel: &Travel, seed: u64) -> Result<GlidingBed, RoughError> {
    let line = RoughLine::new(&plan.surface.rings, seed);
    let line = Arc::new(gliding_line(&line, plan.surface.points, plan.base.as_deref())?);
    Ok(GlidingBed::line(Arc::new(Spectrum::new(&travel.relaxation)), line, plan.accuracy()))
}

/// The direct path on a ground, bodies just touching.
///
/// # Errors
/// The attraction has no contact.
pub fn direct(ground: Foundation, adhesion: ElasticAdhesion) -> Result<QuasiStatic, SimulationError> {
    let contact = match adhesion {
        ElasticAdhesion::None => QuasiStatic::new(EdgeLine::new(ground, 0.0)),
        ElasticAdhesion::Vanishing { work } => QuasiStatic::new(EdgeLine::new(ground, work)),
        ElasticAdhesion::Outside { work } => QuasiStatic::new(DmtBall::new(ground, work)),
        ElasticAdhesion::Finite { work, stress } => {
            let disc = RangeDisc::new(ground, work, stress);
            QuasiStatic::new(disc.map_err(|error| SimulationError::Refused(error.to_string()))?)
        }
        ElasticAdhesion::Fading { .. } => {
            let what = "adhesion: what fades with the gap is followed on pixels only".to_owned();
            return Err(SimulationError::Refused(what));
        }
    };
    arrived(contact, adhesion)
}

/// Bodies that have come from far away: at d = 0 they attract each other already, unless the attraction has no range.
fn arrived(mut contact: QuasiStatic, adhesion: ElasticAdhesion) -> Result<QuasiStatic, SimulationError> {
    match adhesion {
        ElasticAdhesion::None | ElasticAdhesion::Vanishing { .. } => return Ok(contact),
        ElasticAdhesion::Outside { .. } | ElasticAdhesion::Finite { .. } | ElasticAdhesion::Fading { .. } => {}
    }
    contact.indent(0.0).map_err(|source| SimulationError::Contact { entry: 0, source: source.into() })?;
    Ok(contact.without_losses())
}

/// Half width [m] of a bed of springs that is just wide enough for the history, as the direct path finds it.
fn radius_of_bed(plan: &RoundPlan, work: Option<f64>) -> Result<f64, SimulationError> {
    let adhesion = work.map_or(ElasticAdhesion::None, |work| ElasticAdhesion::Vanishing { work });
    let run = follow(plan, Box::new(direct(plan.ground(), adhesion)?), Wanted::NOTHING)?;
    let largest = run.records.iter().filter_map(|record| record.normal.contact_radius).fold(0.0, f64::max);
    Ok(reach_for(plan.profile.as_ref(), largest))
}

/// The tangential part of a plan; `bed_radius` is the half width [m] of the bed of springs under the normal contact.
fn friction(
    plan: &RoundPlan,
    law: &FrictionLaw,
    bed_radius: f64,
    wanted: Wanted,
) -> Result<Box<dyn TangentialContact>, FrictionError> {
    Ok(match law {
        // Before the machine draws it a contact carries nothing along the surface.
        FrictionLaw::RateState(law) => {
            let grip = plan.grip(law.coefficient.si());
            Box::new(CoulombMemory::new(plan.profile.clone(), grip, friction_accuracy(plan)).keeping_its_path())
        }
        FrictionLaw::Memory { coefficient } => {
            let memory = CoulombMemory::new(plan.profile.clone(), plan.grip(*coefficient), friction_accuracy(plan));
            let driven = plan.machine.as_ref().is_some_and(MachineLaw::is_along);
            let kept = driven || wanted.fretting && fretting::is_fretting(plan);
            Box::new(if kept { memory.keeping_its_path() } else { memory })
        }
        FrictionLaw::Springs { coefficient, count } => {
            let bed = CoulombSprings::new(plan.profile.as_ref(), plan.grip(*coefficient), *count, bed_radius)?;
            Box::new(bed.accurate_to(friction_accuracy(plan)))
        }
        FrictionLaw::Viscoelastic { coefficient, count, relaxation } => {
            let (spectrum, grip) = (Arc::new(Spectrum::new(relaxation)), plan.grip(*coefficient));
            let radius = friction_radius(plan, &spectrum);
            let bed = ViscoelasticBed::new(plan.profile.as_ref(), spectrum, grip, *count, radius)?;
            Box::new(ViscoelasticFriction::new(bed, grip.tangential_modulus))
        }
        FrictionLaw::Sliding(interface) => Box::new(SlidingContact::new(plan.ground(), interface.clone())),
        FrictionLaw::Stuck { work } => Box::new(StuckEdge::new(peeled(plan, *work, 1.0))),
        FrictionLaw::Peeling { interface, work } => {
            Box::new(Peeling::new(peeled(plan, *work, UNIFORM), interface.clone()))
        }
    })
}

/// Radius [m] beyond which no spring is ever touched: that of the largest depth, or of the creep under the largest force.
fn friction_radius(plan: &RoundPlan, spectrum: &Arc<Spectrum>) -> f64 {
    let reach = viscoelastic::reach(plan, spectrum);
    if let Rim::Wall(end) = plan.profile.rim() { reach.min(end) } else { reach }
}

/// The adhesive contact of a plan under shear, for the work of adhesion `work` [J/m²]; its tangential stiffness is `share` of
/// that of a contact which sticks.
fn peeled(plan: &RoundPlan, work: f64, share: f64) -> ShearedAdhesion {
    let ratio = share * plan.pair.tangential / plan.pair.normal;
    ShearedAdhesion { line: EdgeLine::new(plan.ground(), work), ratio }
}

/// The adhesive contact of a plan that is peeled by shear; `None` where nothing peels.
#[must_use]
pub fn sheared(plan: &RoundPlan) -> Option<ShearedAdhesion> {
    match &plan.friction {
        Some(FrictionLaw::Stuck { work }) => Some(peeled(plan, *work, 1.0)),
        Some(FrictionLaw::Peeling { work, .. }) => Some(peeled(plan, *work, UNIFORM)),
        Some(
            FrictionLaw::Memory { .. }
            | FrictionLaw::Springs { .. }
            | FrictionLaw::Viscoelastic { .. }
            | FrictionLaw::RateState(_)
            | FrictionLaw::Sliding(_),
        )
        | None => None,
    }
}

/// How closely a curved path is followed by friction, as a part of the depth.
fn friction_accuracy(plan: &Shared) -> f64 {
    plan.accuracy().clamp(1e-12, 1e-2)
}

/// The error of the tangential contact, where it is not rounding; `place` is where the edge of the largest contact is in
/// the bed [m].
#[must_use]
pub fn friction_error(plan: &RoundPlan, law: &FrictionLaw, place: f64) -> Option<ErrorEstimate> {
    let springs = |count: NonZeroUsize, wider: f64| ErrorEstimate {
        relative: 17.0 / 16.0 * wider / count.get() as f64,
        basis: format!("bed of {count} springs: the tangential force within half a cell of its variation"),
    };
    match law {
        FrictionLaw::Springs { count, .. } => Some(springs(*count, 1.0)),
        FrictionLaw::Viscoelastic { count, relaxation, .. } => {
            let wider = friction_radius(plan, &Arc::new(Spectrum::new(relaxation))) / place;
            Some(springs(*count, if wider.is_finite() { wider.max(1.0) } else { 1.0 }))
        }
        FrictionLaw::Memory { .. } => {
            let curved = |stage: &Stage| stage.control == Some(Control::Force) && stage.tangential != Path::Stay;
            plan.stages.iter().any(curved).then(|| ErrorEstimate {
                relative: friction_accuracy(plan),
                basis: "memory of friction: the depth under a force is a curve, followed by chords to this part"
                    .to_owned(),
            })
        }
        FrictionLaw::RateState(_)
        | FrictionLaw::Sliding(_)
        | FrictionLaw::Stuck { .. }
        | FrictionLaw::Peeling { .. } => None,
    }
}
