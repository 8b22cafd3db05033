//! Contacts of bodies that remember: how they are composed, and what their loops say.

use super::follow::Run;
use super::named::Named;
use super::unit::Unit;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::creep::Creep;
use crate::contact::model::ContactModel;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::attraction::Attraction;
use crate::contact::viscoelastic::continuous::ContinuousContact;
use crate::contact::viscoelastic::growing::GrowingBed;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::memory::Memory;
use crate::drive::impact::{Projectile, StruckHalfSpace};
use crate::drive::machine::{GRAVITY, Suspension};
use crate::material::Relaxation;
use crate::scene::history::{MachineEntry, MachineMotion};
use crate::scene::law::{GRADE, HeldEdge};
use crate::scene::plan::RoundPlan;
use crate::scene::stage::Path;
use std::f64::consts::TAU;
use std::sync::Arc;

/// The continuous bed of a scene, bodies just touching: for a depth in few straight pieces.
pub fn continuous(plan: &RoundPlan, relaxation: &Relaxation, edge: Option<&HeldEdge>) -> Box<dyn ContactModel> {
    let spectrum = Arc::new(Spectrum::new(relaxation));
    let attraction = edge.map(|edge| edge.attraction(&spectrum).to_accuracy(plan.accuracy()));
    bed(plan, spectrum, attraction)
}

/// The bed of `count` springs of a scene, bodies just touching: for an oscillation and a prescribed force, which
/// need hundreds of straight pieces, each of which would leave a strip behind in the continuous bed.
pub fn springs(plan: &RoundPlan, relaxation: &Relaxation, count: usize) -> Box<dyn ContactModel> {
    let (spectrum, profile) = (Arc::new(Spectrum::new(relaxation)), plan.profile.clone());
    let reach = reach(plan, &spectrum);
    let layout = Layout::graded(profile.as_ref(), (GRADE * reach, reach), count);
    Box::new(GrowingBed::new(spectrum, profile, layout))
}

/// The contact of an adhesive scene whose edge obeys a rate law, followed [`FINER`] times as well.
pub fn refined(plan: &RoundPlan, relaxation: &Relaxation, edge: &HeldEdge) -> Box<dyn ContactModel> {
    let spectrum = Arc::new(Spectrum::new(relaxation));
    let attraction = edge.attraction(&spectrum).to_accuracy(plan.accuracy() / FINER).in_steps(STEPS.recip());
    bed(plan, spectrum, Some(attraction))
}

fn bed(plan: &RoundPlan, spectrum: Arc<Spectrum>, attraction: Option<Attraction>) -> Box<dyn ContactModel> {
    let bed = Memory::new(spectrum, plan.profile.clone());
    let bed = if attraction.is_some() && plan.machine.is_none() && plan.is_curved() {
        bed.in_pieces(plan.accuracy())
    } else {
        bed
    };
    Box::new(ContinuousContact::new(attraction.into_iter().fold(bed, Memory::with)))
}

/// How much better the edge is followed to tell the error.
const FINER: f64 = 16.0;

/// Fewest steps of a motion in which it is followed then.
const STEPS: f64 = 4.0;

/// A radius [m] the contact of a scene does not outgrow: of its largest depth, or of the creep under its
/// largest force over all its time.
pub(super) fn reach(plan: &RoundPlan, spectrum: &Arc<Spectrum>) -> f64 {
    let (mut depth, mut force, mut time) = (0f64, 0f64, 0.0);
    let mut before = 0.0;
    for stage in &plan.stages {
        time += stage.over;
        match (stage.control, stage.normal) {
            (Some(Control::Force), Path::To(to)) => force = force.max(to),
            (Some(Control::Indentation), Path::To(to)) => (before, depth) = (to, depth.max(to)),
            (_, Path::Wave(wave)) => depth = depth.max(before.max(depth) + wave.amplitude),
            (_, Path::To(_) | Path::Stay | Path::Steady { .. } | Path::UntilParted { .. }) => {}
        }
    }
    time += plan.machine.iter().flat_map(|law| &law.motions).map(|motion| motion.over).sum::<f64>();
    depth = depth.max(struck(plan, spectrum, depth));
    let creep = Creep::new(spectrum.clone(), plan.profile.clone()).after(force, 0.0).after(force, time);
    let deepest = depth.max(creep.indentation().unwrap_or(0.0));
    plan.profile.edge(deepest).filter(|&reach| reach > 0.0).unwrap_or_else(|| plan.profile.scale())
}

/// How deep the mass of a machine goes [m] that swings or falls onto a contact led to the depth `depth` [m].
fn struck(plan: &RoundPlan, spectrum: &Arc<Spectrum>, depth: f64) -> f64 {
    let Some(law) = &plan.machine else { return 0.0 };
    let Suspension { mass, .. } = law.suspension;
    let deep = |motion: &MachineEntry| match motion.motion {
        MachineMotion::Drive { .. } => 0.0,
        MachineMotion::Ring { amplitude } => depth + amplitude.abs(),
        MachineMotion::Fall { height } => {
            let ground = StruckHalfSpace { spectrum: spectrum.clone(), profile: plan.profile.clone() };
            ground.depth_scale(&Projectile { mass, speed: (2.0 * GRAVITY * height).sqrt() }).unwrap_or(0.0)
        }
    };
    law.motions.iter().map(deep).fold(0.0, f64::max)
}

/// Named results of a viscoelastic contact alone: the moduli of the last loop, and what is expected of
/// the same contact if its edge stood still.
pub fn results(plan: &RoundPlan, run: &Run) -> Vec<Named> {
    let (Some(found), Some(relaxation)) = (run.last_loop(), plan.contact.bodies().relaxation()) else {
        return Vec::new();
    };
    let (spectrum, omega) = (Spectrum::new(relaxation), TAU * found.frequency);
    let expected = (spectrum.storage(omega), spectrum.loss(omega));
    let all = [
        ("storage_modulus", Unit::PASCAL, found.storage),
        ("loss_modulus", Unit::PASCAL, found.loss),
        ("loss_tangent", Unit::ONE, found.loss / found.storage),
        ("expected_storage_modulus", Unit::PASCAL, expected.0),
        ("expected_loss_modulus", Unit::PASCAL, expected.1),
        ("expected_loss_tangent", Unit::ONE, expected.1 / expected.0),
    ];
    all.into_iter().map(|(quantity, unit, value)| Named::number(quantity, unit, value)).collect()
}

/// What a user must know of the comparison of a loop with the moduli.
pub fn remark(run: &Run) -> Option<String> {
    let found = run.last_loop()?;
    Some(format!(
        "storage and loss are those of the effective modulus E* from the first harmonics of the last cycle at its mean contact radius; they are compared with E*′(ω) and E*″(ω), which a contact has whose edge stands still: the edge of this one moves by {:.2} % of the radius",
        100.0 * found.swing
    ))
}
