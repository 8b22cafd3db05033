//! The error of pixels: the state of the largest force again on every second of them.

use super::series::Series;
use super::state::{Pressing, response};
use crate::halfspace::{HalfSpaceError, Prescribed, Solution, Start};
use crate::run::record::ErrorEstimate;
use crate::scene::plan::HalfSpacePlan;

/// How far two solutions are apart, as parts of the finer one.
struct Apart {
    /// In force or indentation, whichever is not prescribed.
    load: f64,
    area: f64,
    pressure: f64,
}

/// The difference between the grid and one of half as many pixels along each side.
///
/// Force and indentation of a smooth shape are of second order in the pixel, so that the difference is about three
/// times the error of the finer grid. Areas are of first order at best and scatter: their error is what counting whole
/// pixels adds along the edges, although that is taken off, or the difference if that is more.
pub(super) fn estimate(plan: &HalfSpacePlan, pressing: &Pressing<'_>, series: &Series<'_>) -> ErrorEstimate {
    let tolerance = pressing.settings.tolerance;
    let Some((prescribed, solution)) =
        series.largest.as_ref().map(|(prescribed, pressed)| (prescribed, &pressed.contact))
    else {
        return ErrorEstimate { relative: tolerance, basis: "the bodies never press on each other".to_owned() };
    };
    let (rows, columns) = solution.pressure.dim();
    match apart(plan, pressing, (*prescribed, solution)) {
        Ok(Apart { load, area, pressure }) => {
            let what = match prescribed {
                Prescribed::Indentation(_) => "force",
                Prescribed::Force(_) => "indentation",
            };
            let radii = series.states.iter().filter_map(|state| state.normal.contact_radius);
            let edge = of_edge(radii, pressing.heights.pixel, true);
            let few = if edge > 0.0 {
                format!("; an edge lies within half a pixel, {edge:.1e} of the largest radius")
            } else {
                String::new()
            };
            let basis = format!(
                "the largest load again on every second of {columns} × {rows} pixels: {what} {load:.1e} apart, peak pressure {pressure:.1e}; area {area:.1e}, from that and from what its edges add; residual of the solver {:.0e}{few}",
                solution.residual.max(tolerance)
            );
            ErrorEstimate { relative: load.max(area).max(edge).max(tolerance), basis }
        }
        Err(error) => ErrorEstimate {
            relative: 1.0,
            basis: format!("not known: on every second of {columns} × {rows} pixels there is no answer ({error})"),
        },
    }
}

/// Half a pixel, of the largest of the radii of contact \[m\]: what is known of an edge that is found by counting pixels.
/// Where it follows from Hertz' pressures it is known better, but of a contact no wider than two pixels.
pub(super) fn of_edge(radii: impl Iterator<Item = f64>, pixel: [f64; 2], hertzian: bool) -> f64 {
    let side = pixel[0].max(pixel[1]);
    let (mut least, mut largest) = (f64::INFINITY, 0.0_f64);
    for radius in radii.filter(|&radius| radius > 0.0) {
        (least, largest) = (least.min(radius), largest.max(radius));
    }
    let is_counted = !hertzian || least < side;
    if largest > 0.0 && is_counted { 0.5 * side / largest } else { 0.0 }
}

/// The larger of two estimates.
pub(super) fn larger(one: ErrorEstimate, other: ErrorEstimate) -> ErrorEstimate {
    if one.relative > other.relative { one } else { other }
}

fn apart(
    plan: &HalfSpacePlan,
    pressing: &Pressing<'_>,
    (prescribed, fine): (Prescribed, &Solution),
) -> Result<Apart, HalfSpaceError> {
    let thinned = pressing.heights.thinned();
    let response = response(plan, &thinned)?;
    let coarse = Pressing { heights: &thinned, response: &response, ..*pressing }.solve(prescribed, Start::Coarser)?;
    let depth = |solution: &Solution| solution.indentation - pressing.touch;
    let part = |of: f64, other: f64| if of > 0.0 { (other / of - 1.0).abs() } else { 1.0 };
    let load = match prescribed {
        Prescribed::Indentation(_) => part(fine.force(), coarse.force()),
        Prescribed::Force(_) => part(depth(fine), depth(&coarse)),
    };
    let area = part(fine.corrected_area(), coarse.corrected_area());
    let edges = part(fine.contact_area(), fine.corrected_area());
    let pressure = part(fine.peak_pressure(), coarse.peak_pressure());
    Ok(Apart { load, area: area.max(edges), pressure })
}
