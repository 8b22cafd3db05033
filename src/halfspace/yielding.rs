//! A surface that yields, under a prescribed force: the depth at which it carries that.

use super::{HalfSpaceError, Prescribed, PressedMap, Settings, Solution, Start, SurfaceResponse, solved};
use crate::numerics::root;

/// Most doublings of the way beyond the depth of an elastic surface.
const DOUBLINGS: usize = 60;

/// The state under `force` \[N\] of a surface whose elastic contact `elastic` is above the hardness somewhere.
///
/// The force grows with the depth, and where the surface yields it is softer: the root lies beyond the elastic depth.
pub(super) fn under_force(
    response: &SurfaceResponse,
    (problem, force): (&PressedMap<'_>, f64),
    elastic: Solution,
    settings: &Settings,
) -> Result<Solution, HalfSpaceError> {
    let area = problem.pixel[0] * problem.pixel[1];
    let most = response.hardness() * area * problem.heights.len() as f64;
    if force >= most {
        let wanted = "less than the hardness times the area of the window";
        return Err(HalfSpaceError::Parameter { name: "force", value: force, wanted });
    }
    let mut last = elastic;
    let at = |depth: f64, last: &mut Solution| -> Result<f64, HalfSpaceError> {
        let control = Prescribed::Indentation(depth);
        *last = solved(
            &PressedMap { control, ..*problem },
            Start::Pressure(last.pressure.view()),
            (settings, Some(response)),
        )?;
        Ok(last.force() / force - 1.0)
    };
    let low = last.indentation;
    let lowest = problem.heights.iter().copied().fold(f64::INFINITY, f64::min);
    let (mut beneath, mut step) = (low, 0.25 * (low - lowest).max(f64::MIN_POSITIVE));
    let mut high = low + step;
    for _ in 0..DOUBLINGS {
        if at(high, &mut last)? >= 0.0 {
            break;
        }
        beneath = high;
        step *= 2.0;
        high += step;
    }
    let mut failed = None;
    let depth = root::within(
        |depth| match at(depth, &mut last) {
            Ok(misfit) => misfit,
            Err(error) => {
                failed.get_or_insert(error);
                0.0
            }
        },
        beneath,
        high,
    );
    match failed {
        Some(error) => Err(error),
        None => at(depth, &mut last).map(|_| last),
    }
}
