//! Hertz and the cone: one state.

use super::EDGES;
use crate::check::case::Attempt;
use crate::check::closed_forms::{self, ClosedForm};
use crate::check::contacts::{indented, paraboloid};
use crate::check::measured::{DEPTH, SLOPE};
use crate::check::row::{Computed, Found, Setting};
use crate::check::sketch::si;
use crate::check::study::{Method, Study, Thoroughness};
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::Foundation;
use crate::contact::model::Loading;
use crate::contact::springs::SpringBed;
use crate::shape::{Cone, Profile};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};
use std::sync::Arc;

/// A ball with R = E* = 1 pressed in by d/R = 0.01.
pub fn hertz(effort: Thoroughness) -> Attempt<Study> {
    let exact = closed_forms::hertz(1.0, DEPTH);
    let pressure = Some(FRAC_2_PI * exact.radius);
    Ok(Study {
        case: "hertz",
        about: "a ball with d/R = 0.01: force, contact radius and pressure at the centre".to_owned(),
        quantity: "force",
        reference: "closed form".to_owned(),
        exact: solved(exact.force, exact.radius, pressure),
        methods: methods(&paraboloid(1.0)?, exact, effort),
    })
}

/// A cone of slope 0.1, E* = 1, pressed in by 0.01; the pressure at the apex is infinite.
pub fn cone(effort: Thoroughness) -> Attempt<Study> {
    let exact = closed_forms::cone(SLOPE, DEPTH);
    Ok(Study {
        case: "cone",
        about: "a cone of slope 0.1: force and contact radius".to_owned(),
        quantity: "force",
        reference: "closed form".to_owned(),
        exact: solved(exact.force, exact.radius, None),
        methods: methods(&Arc::new(Cone { slope: si(SLOPE)? }), exact, effort),
    })
}

fn solved(force: f64, radius: f64, pressure: Option<f64>) -> Computed {
    let found = Found { contact_radius_m: Some(radius), peak_pressure_pa: pressure, ..Found::default() };
    Computed { values: vec![force], found, ..Computed::default() }
}

fn methods<P: Profile + 'static>(shape: &Arc<P>, exact: ClosedForm, effort: Thoroughness) -> Vec<Method> {
    let mut methods = vec![Method::of("direct path", Setting::FREE, shape, |shape| direct(shape.clone()))];
    // No whole number of springs fits the contact: their sum has its usual error.
    let reach = FRAC_PI_2.sqrt() * exact.radius;
    for (name, location) in EDGES {
        let bed = |count| {
            let shape = shape.clone();
            let prepare = move || {
                let bed = SpringBed::new(Foundation::new(shape.clone(), 1.0), count, reach, 0.0).with_edge(location);
                Ok(move || Ok(springs(bed.clone())))
            };
            Method::new(name, Setting::springs(count), prepare)
        };
        methods.extend(effort.decades(1, 6).map(bed));
    }
    #[cfg(feature = "half-space")]
    methods.extend(super::grid::methods(shape, exact, effort));
    methods
}

fn direct(profile: Arc<dyn Profile>) -> Attempt<Computed> {
    let contact = indented(profile, 1.0, DEPTH)?;
    let balance = contact.present().balance;
    let bytes = size_of::<QuasiStatic>();
    Ok(Computed { bytes, ..solved(balance.force, balance.contact_radius, Some(contact.loaded().pressure(0.0))) })
}

fn springs(mut bed: SpringBed) -> Computed {
    bed.indent(DEPTH);
    Computed { bytes: bed.bytes(), ..solved(bed.force(), bed.contact_radius(), bed.spring_loads().pressure(0.0)) }
}
