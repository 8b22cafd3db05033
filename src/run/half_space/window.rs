//! How wide a window the contact of a tip needs.

use super::SimulationError;
use super::heights::{Heights, of_tip};
use super::response;
use super::series::{Depth, Series};
use super::state::{Pressing, State};
use crate::contact::adhesion::equilibrium::Control;
use crate::scene::law::{ElasticAdhesion, PixelFriction};
use crate::scene::plan::{HalfSpacePlan, PixelledIndenter};
use crate::scene::stage::{Path, Spaced};
use crate::shape::{PlacedTip, Profile, Rim};

/// Side of the window in largest distances of the contact from the tip.
const WINDOW: f64 = 3.0;
/// Pixels along a window that is tried.
const TRIED: usize = 64;
/// Pixels of the contact from its tip to its edge that tell where that is.
const ENOUGH: f64 = 8.0;
/// Windows tried before the last is taken.
const TRIES: usize = 24;
/// Records of each stage while windows are tried on bodies that remember or attract each other, whose edges depend on the
/// steps they are come to in: a window depends on the motion, and not on how many records of it are asked for.
const RECORDS: usize = 8;
/// Most records of all stages together, if that is not less than one each.
const MOST_RECORDS: usize = 128;
/// Halvings and doublings of a radius.
const OCTAVES: i32 = 200;

/// Sides of the window along x and y [m] for the whole history of a tip.
pub(super) fn of_history(plan: &HalfSpacePlan) -> Result<[f64; 2], SimulationError> {
    if let Some(side) = plan.window {
        return Ok([side; 2]);
    }
    let relaxed = relaxed(plan);
    let guess = guessed(plan);
    let mut sides = along(&plan.indenter, guess).map(|radius| 4.0 * radius);
    for _ in 0..TRIES {
        let Some(heights) = of_tip(&plan.indenter, [TRIED; 2], sides) else { break };
        let mut states = tried(plan, &heights)?;
        if let Some(relaxed) = &relaxed {
            states.extend(tried(relaxed, &heights)?);
        }
        let meets = states.iter().any(|state| state.meets_border);
        let extent = states.iter().fold([0.0_f64; 2], |[x, y], state| [x.max(state.extent[0]), y.max(state.extent[1])]);
        if extent[0] <= 0.0 && !states.iter().any(|state| state.count > 0) {
            break;
        }
        let edge = [0, 1].map(|axis| extent[axis] + 0.5 * heights.pixel[axis]);
        let fine = [0, 1].iter().all(|&axis| edge[axis] >= ENOUGH * heights.pixel[axis]);
        let next = [0, 1].map(|axis| if meets { 2.0 * sides[axis] } else { WINDOW * edge[axis] });
        sides = next;
        if !meets && fine {
            break;
        }
    }
    Ok(sides)
}

/// The same history of bodies that have relaxed, on which a contact that glides slowly is wider.
fn relaxed(plan: &HalfSpacePlan) -> Option<HalfSpacePlan> {
    let modulus = plan.travel.as_ref()?.relaxation.equilibrium;
    let mut slow = HalfSpacePlan { relaxation: None, travel: None, ..plan.clone() };
    slow.shared.pair.normal = modulus;
    Some(slow)
}

fn tried(plan: &HalfSpacePlan, heights: &Heights) -> Result<Vec<State>, SimulationError> {
    // Shear changes the edge of a contact by less than the window is wider.
    let coupled = matches!(plan.friction, Some(PixelFriction::Coupled { .. }));
    let bare = coupled.then(|| HalfSpacePlan { friction: None, ..plan.clone() });
    let plan = bare.as_ref().unwrap_or(plan);
    let stepped = (plan.relaxation.is_some() || plan.attraction != ElasticAdhesion::None).then(|| stepped(plan));
    let plan = stepped.as_ref().unwrap_or(plan);
    let response = response(plan, heights)?;
    let pressing = Pressing::of(plan, heights, &response);
    let mut series = Series::new(plan, pressing, Depth::Outline, 1);
    series.follow(&|_| ())?;
    Ok(series.states)
}

/// The same history in steps that do not depend on the records asked for.
fn stepped(plan: &HalfSpacePlan) -> HalfSpacePlan {
    let mut stepped = plan.clone();
    let records = (MOST_RECORDS / plan.stages.len().max(1)).clamp(1, RECORDS);
    for stage in &mut stepped.shared.stages {
        (stage.records, stage.spacing) = (records, Spaced::Evenly);
    }
    stepped
}

/// A radius [m] of the order of the largest contact's, or a distance that holds all tips.
fn guessed(plan: &HalfSpacePlan) -> f64 {
    match &plan.indenter {
        PixelledIndenter::Smooth(profile) | PixelledIndenter::Ellipsoid(_, profile) => {
            radius_under(plan, profile.as_ref())
        }
        PixelledIndenter::Tips(tips) => {
            let reach =
                |tip: &PlacedTip| tip.at[0].abs().max(tip.at[1].abs()) + radius_under(plan, tip.profile.as_ref());
            tips.iter().map(reach).fold(0.0, f64::max)
        }
        PixelledIndenter::Rough(surface, _) => 0.5 * surface.length(),
    }
}

/// A radius [m] of the order of that of the largest contact of a tip alone.
fn radius_under(plan: &HalfSpacePlan, profile: &dyn Profile) -> f64 {
    if let Rim::Wall(radius) = profile.rim() {
        return radius;
    }
    let values = |control: Control| {
        let of = plan.stages.iter().filter(move |stage| stage.control == Some(control));
        let value = |path: Path| match path {
            Path::To(value) => value,
            Path::Wave(wave) => wave.amplitude,
            Path::Stay | Path::Steady { .. } | Path::UntilParted { .. } => 0.0,
        };
        of.map(move |stage| value(stage.normal)).fold(0.0, f64::max)
    };
    let (depth, force) = (values(Control::Indentation), values(Control::Force));
    let by_depth = radius_where(profile, |r| profile.height(r) >= depth);
    let by_force = radius_where(profile, |r| 2.0 * plan.pair.normal * profile.load_integral(r) >= force);
    let none = |value: f64, radius: f64| if value > 0.0 { radius } else { 0.0 };
    let radius = none(depth, by_depth).max(none(force, by_force));
    if radius > 0.0 { radius } else { profile.scale() }
}

/// The smallest of the radii scale·2ᵏ [m] at which `reached` holds, up to the end of the profile.
fn radius_where(profile: &dyn Profile, reached: impl Fn(f64) -> bool) -> f64 {
    let end = profile.rim().radius();
    let mut radius = profile.scale().min(end);
    for _ in 0..OCTAVES {
        if !reached(0.5 * radius) {
            break;
        }
        radius *= 0.5;
    }
    for _ in 0..OCTAVES {
        if reached(radius) || 2.0 * radius > end {
            break;
        }
        radius *= 2.0;
    }
    radius
}

/// The same along x and y: at one height an ellipsoid is as wide as the root of its radius of curvature.
fn along(indenter: &PixelledIndenter, radius: f64) -> [f64; 2] {
    match indenter {
        PixelledIndenter::Smooth(_) | PixelledIndenter::Tips(_) | PixelledIndenter::Rough(..) => [radius; 2],
        PixelledIndenter::Ellipsoid([x, y], _) => {
            let ratio = (x / y).sqrt().sqrt();
            [radius * ratio, radius / ratio]
        }
    }
}
