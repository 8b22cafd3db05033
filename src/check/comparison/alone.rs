//! Contacts that only pixels can follow: the half-space on one grid after the other.

use super::{Candidate, Compared, Contest, GRIDS};
use crate::check::case::Attempt;
use crate::check::row::{Computed, Found, Setting};
use crate::check::study::Method;
use crate::run::half_space;
use crate::scene::plan::HalfSpacePlan;
use std::sync::Arc;

/// The grids under the force [N]; `why` tells what keeps the others out.
pub(super) fn contest(plan: &HalfSpacePlan, force: f64, why: &str) -> Contest {
    let plan = Arc::new(plan.clone());
    let (mut methods, mut candidates) = (Vec::new(), Vec::new());
    for grid in GRIDS {
        candidates.insert(
            0,
            Candidate { at: methods.len(), name: format!("half-space on {grid} pixels a side, the finest grid") },
        );
        methods.push(Method::of("half-space", Setting::grid(grid), &plan, move |plan| under(plan, grid, force)));
    }
    let notes =
        vec![format!("direct path and springs: {why}"), "compared under the largest force of the scene".to_owned()];
    Contest { compared: Compared::Rough, methods, exact: None, candidates, pressure: None, members: 1, notes }
}

fn under(plan: &HalfSpacePlan, grid: usize, force: f64) -> Attempt<Computed> {
    let solved = half_space::under(&plan.on(grid), force)?;
    let (normal, pixels) = (solved.normal, solved.pixels);
    let found = Found {
        indentation_m: normal.indentation,
        force_n: Some(force),
        contact_radius_m: None,
        peak_pressure_pa: Some(pixels.peak_pressure),
        stiffness_n_per_m: Some(normal.stiffness),
        area_fraction: Some(pixels.area_fraction).filter(|_| plan.surface().is_some()),
    };
    Ok(Computed {
        found,
        bytes: usize::try_from(solved.bytes)?,
        iterations: Some(solved.iterations),
        ..Computed::default()
    })
}
