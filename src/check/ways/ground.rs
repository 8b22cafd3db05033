//! Layers: one state of the bed, and what the usual series say of it.

use crate::check::case::Attempt;
use crate::check::closed_forms;
use crate::check::contacts::{indented, paraboloid};
use crate::check::row::{Computed, Found, Setting};
use crate::check::study::{Method, Study, Thoroughness};
use crate::check::theory::{film_weight, gel_series};
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::Foundation;
use crate::contact::springs::SpringBed;
use crate::ground::{Grounded, Layers};
use crate::material::{Joint, Sheet, Stack};
use crate::shape::Profile;
use std::sync::Arc;

/// g = x²/10 on layers with h = E* = 1.
const RADIUS: f64 = 10.0;
/// Depth and force of an incompressible layer bonded to a rigid base at a = h, from the integral equation solved apart.
const GEL: [f64; 2] = [0.055_941_548_556, 0.188_066_689_92];
/// The same of a film ten times as stiff as its base, ν = 0.3, at a = h.
const FILM: [f64; 2] = [0.230_283_021_78, 0.079_231_674_852];

/// An incompressible layer bonded to a rigid base under a contact as wide as it is thick.
pub fn gel(effort: Thoroughness) -> Attempt<Study> {
    let sheet = Sheet { shear: 1.0, poisson: 0.5, thickness: 1.0, joint: Joint::Bonded };
    let chi = (RADIUS * GEL[0]).sqrt();
    let series = Method::of("series (Dimitriadis)", Setting::FREE, &chi, |chi| hertz(GEL[0], gel_series(*chi)));
    let about =
        "a ball on an incompressible layer bonded to a rigid base, as wide as it is thick: force and contact radius";
    study(("layer", about), (Stack { sheets: vec![sheet], base: None }, GEL), (series, effort))
}

/// A film ten times as stiff as its base.
pub fn film(effort: Thoroughness) -> Attempt<Study> {
    let sheet = |shear: f64| Sheet { shear, poisson: 0.3, thickness: 1.0, joint: Joint::Bonded };
    let ratio = (RADIUS * FILM[0]).sqrt();
    let weighed = Method::of("weights (Gao, Chiu & Lee)", Setting::FREE, &ratio, |ratio| {
        let share = film_weight(*ratio, 0.3);
        hertz(FILM[0], share + 0.1 * (1.0 - share))
    });
    let about = "a ball on a film ten times as stiff as its base, as wide as it is thick: force and contact radius";
    study(("film", about), (Stack { sheets: vec![sheet(1.0)], base: Some(sheet(0.1)) }, FILM), (weighed, effort))
}

fn study(
    (case, about): (&'static str, &str),
    (stack, [depth, force]): (Stack, [f64; 2]),
    (usual, effort): (Method, Thoroughness),
) -> Attempt<Study> {
    let bed: Arc<dyn Profile> = Arc::new(Grounded::new(paraboloid(RADIUS)?, Arc::new(Layers::new(vec![(1.0, stack)]))));
    let mut methods = vec![Method::of("direct path", Setting::FREE, &bed, move |bed| direct(bed.clone(), depth))];
    // No whole number of springs fits the contact: their sum has its usual error.
    let reach = std::f64::consts::FRAC_PI_2.sqrt() * bed.place(1.0);
    methods.extend(effort.decades(1, 5).map(|count| {
        let bed = bed.clone();
        let prepare = move || {
            let springs = SpringBed::new(Foundation::new(bed.clone(), 1.0), count, reach, 0.0);
            let bed = bed.clone();
            Ok(move || Ok(pressed(springs.clone(), bed.as_ref(), depth)))
        };
        Method::new("springs", Setting::springs(count), prepare)
    }));
    methods.push(usual);
    Ok(Study {
        case,
        about: about.to_owned(),
        quantity: "force",
        reference: "the integral equation solved apart, 11 digits".to_owned(),
        exact: solved(force, Some(1.0)),
        methods,
    })
}

fn solved(force: f64, radius: Option<f64>) -> Computed {
    let found = Found { contact_radius_m: radius, ..Found::default() };
    Computed { values: vec![force], found, ..Computed::default() }
}

/// What a series says that multiplies the force of Hertz.
fn hertz(depth: f64, factor: f64) -> Attempt<Computed> {
    Ok(solved(factor * closed_forms::hertz(RADIUS, depth).force, None))
}

fn direct(bed: Arc<dyn Profile>, depth: f64) -> Attempt<Computed> {
    let contact = indented(bed.clone(), 1.0, depth)?;
    let balance = contact.present().balance;
    let bytes = size_of::<QuasiStatic>();
    Ok(Computed { bytes, ..solved(balance.force, Some(bed.contact_radius(balance.contact_radius))) })
}

fn pressed(mut springs: SpringBed, bed: &dyn Profile, depth: f64) -> Computed {
    springs.indent(depth);
    let radius = bed.contact_radius(springs.contact_radius());
    Computed { bytes: springs.bytes(), ..solved(springs.force(), Some(radius)) }
}
