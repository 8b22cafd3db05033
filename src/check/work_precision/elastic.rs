//! Hertz and the cone: one state.

use super::{Answer, Effort, Method, Setting, Study};
use crate::check::closed_forms::{self, Contact};
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::contact::model::Loading;
use crate::contact::springs::{EdgeLocation, SpringBed};
use crate::input::quantity::{Length, Positive};
use crate::shape::{Cone, Paraboloid, Profile};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};
use std::sync::Arc;

/// Indentation over radius: small enough for the half-space, large enough for a window of pixels.
const DEPTH: f64 = 0.01;
const SLOPE: f64 = 0.1;

/// A ball with R = E* = 1 pressed in by d/R = 0.01.
pub(super) fn hertz(effort: Effort) -> Option<Study> {
    let ball = || Some(Paraboloid { radius: Length::new(1.0).ok()? });
    let exact = closed_forms::hertz(1.0, DEPTH);
    let mut study = study(ball, (effort, exact, Some(FRAC_2_PI * exact.radius)));
    study.case = "hertz";
    study.about = "a ball with d/R = 0.01: force, contact radius and pressure at the centre".to_owned();
    Some(study)
}

/// A cone of slope 0.1, E* = 1, pressed in by 0.01; the pressure at the apex is infinite.
pub(super) fn cone(effort: Effort) -> Option<Study> {
    let cone = || Some(Cone { slope: Positive::new(SLOPE).ok()? });
    let mut study = study(cone, (effort, closed_forms::cone(SLOPE, DEPTH), None));
    study.case = "cone";
    study.about = "a cone of slope 0.1: force and contact radius".to_owned();
    Some(study)
}

fn study<P: Profile + Clone + 'static>(
    shape: impl Fn() -> Option<P> + Copy + 'static,
    (effort, exact, pressure): (Effort, Contact, Option<f64>),
) -> Study {
    let wanted = pressure.is_some();
    let mut methods = vec![Method::new("direct path", Setting::FREE, move || {
        let profile = shape()?;
        Some(move || direct(&profile, wanted))
    })];
    for (name, location) in
        [("springs, edge between", EdgeLocation::BetweenSprings), ("springs, counted", EdgeLocation::AtSprings)]
    {
        methods.extend(effort.decades(1, 6).map(|count| {
            let prepare = move || {
                // No whole number of springs fits the contact: their sum has its usual error.
                let reach = FRAC_PI_2.sqrt() * exact.radius;
                let bed =
                    SpringBed::new(HalfSpace::new(Arc::new(shape()?), 1.0), (count, reach), 0.0).with_edge(location);
                Some(move || springs(bed.clone(), wanted))
            };
            Method::new(name, Setting::springs(count), prepare)
        }));
    }
    #[cfg(feature = "half-space")]
    methods.extend(super::grid::methods(
        move |r| shape().map_or(f64::NAN, |profile| profile.height(r)),
        (effort, DEPTH, exact.radius),
    ));
    let values = vec![exact.force];
    Study {
        case: "",
        about: "".to_owned(),
        quantity: "force",
        reference: "closed form".to_owned(),
        orders: &[1.0, 2.0],
        exact: Answer { values, radius: Some(exact.radius), pressure, ..Answer::default() },
        methods,
    }
}

fn direct<P: Profile + Clone + 'static>(profile: &P, pressure: bool) -> Option<Answer> {
    let mut contact = QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(profile.clone()), 1.0), 0.0));
    contact.indent(DEPTH).ok()?;
    let balance = contact.present().balance;
    Some(Answer {
        values: vec![balance.force],
        radius: Some(balance.contact_radius),
        pressure: pressure.then(|| contact.pressure(0.0)),
        bytes: size_of::<QuasiStatic>(),
        iterations: None,
    })
}

fn springs(mut bed: SpringBed, pressure: bool) -> Option<Answer> {
    bed.indent(DEPTH);
    Some(Answer {
        values: vec![bed.force()],
        radius: Some(bed.contact_radius()),
        pressure: if pressure { bed.spring_loads().pressure(0.0) } else { None },
        bytes: bed.bytes(),
        iterations: None,
    })
}
