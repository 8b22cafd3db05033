//! Impacts on viscoelastic bodies.

use super::table::ImpactRow;
use super::{Followed, RECORDS, failed};
use crate::contact::model::Loading;
use crate::contact::viscoelastic::Spectrum;
use crate::drive::impact::{Flight, Projectile, StruckHalfSpace};
use crate::material::Relaxation;
use crate::run::record::{Field, FieldRow};
use crate::run::{SimulationError, Wanted};
use crate::scene::plan::ImpactPlan;
use crate::shape::Profile;
use std::f64::consts::FRAC_PI_2;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Radii at which the pressure is given, denser towards the edge.
const RADII: u32 = 64;

/// Follows an impact; records and fields only where `wanted`.
///
/// # Errors
/// The contact would outgrow the profile, or comes to no end.
pub fn follow(
    plan: &ImpactPlan,
    relaxation: &Relaxation,
    impact: Projectile,
    wanted: Option<Wanted>,
) -> Result<Followed, SimulationError> {
    let ground = StruckHalfSpace { spectrum: Arc::new(Spectrum::new(relaxation)), profile: plan.profile.clone() };
    let flight = ground.flight(&impact, plan.accuracy()).map_err(failed)?;
    let peak_pressure = flight.peak_pressure();
    let row = ImpactRow { speed: impact.speed, rebound: flight.rebound(), oblique: None, peak_pressure };
    let records = plan.scene.steps.map_or(RECORDS, NonZeroUsize::get);
    let moments = if wanted.is_some() { flight.moments(records) } else { Vec::new() };
    let shown = peak_pressure.is_some() && wanted.is_some_and(|wanted| wanted.fields);
    let field = shown.then(|| field_of(&flight, plan.profile.as_ref()));
    let loaded = wanted.filter(|wanted| wanted.stresses).and_then(|_| flight.loaded());
    let radius = flight.deepest_radius();
    Ok(Followed { row, moments, radius, field, loaded, bytes: flight.bytes() })
}

/// The pressure at the greatest depth, where none is infinite.
fn field_of(flight: &Flight, profile: &dyn Profile) -> Field {
    let (time, a) = (flight.turn(), profile.contact_radius(flight.deepest_radius()));
    let row = |k: u32| {
        let radius = a * (FRAC_PI_2 * f64::from(k) / f64::from(RADII)).sin();
        let pressure = Some(flight.pressure(time, profile.place(radius)));
        FieldRow { radius, pressure, displacement: None, shear: None }
    };
    let rows = (0..=RADII).map(row).collect();
    let (label, peak) = ("greatest depth".to_owned(), flight.loaded().and_then(|loaded| Loading::peak(&loaded)));
    Field { label, time, contact_radius: a, stress_intensity: None, peak, rows }
}
