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
    let low = elastic.indentation;
    let lowest = problem.heights.iter().copied().fold(f64::INFINITY, f64::min);
    let mut pressed = Pressed {
        last: elastic,
        at: |depth, start: &Solution| {
            let mut deep = *problem;
            deep.control = Prescribed::Indentation(depth);
            solved(&deep, Start::Pressure(start.pressure.view()), (settings, Some(response)))
        },
        force,
    };
    let bracket = pressed.bracket(low, 0.25 * (low - lowest).max(f64::MIN_POSITIVE))?;
    let mut failed = None;
    let depth = root::within(
        |depth| {
            pressed.misfit(depth).unwrap_or_else(|error| {
                failed.get_or_insert(error);
                0.0
            })
        },
        bracket[0],
        bracket[1],
    );
    match failed {
        Some(error) => Err(error),
        None => pressed.misfit(depth).map(|_| pressed.last),
    }
}

/// The surface at depths that are tried one after another: each starts from the pressures of the one before.
struct Pressed<At> {
    at: At,
    force: f64,
    last: Solution,
}

impl<At: Fn(f64, &Solution) -> Result<Solution, HalfSpaceError>> Pressed<At> {
    /// What the force at a depth \[m\] is too large by, relative.
    fn misfit(&mut self, depth: f64) -> Result<f64, HalfSpaceError> {
        self.last = (self.at)(depth, &self.last)?;
        Ok(self.last.force() / self.force - 1.0)
    }

    /// Two depths \[m\] with the wanted one between them, from one that is too shallow on.
    fn bracket(&mut self, low: f64, step: f64) -> Result<[f64; 2], HalfSpaceError> {
        let (mut beneath, mut step, mut high) = (low, step, low + step);
        for _ in 0..DOUBLINGS {
            if self.misfit(high)? >= 0.0 {
                break;
            }
            beneath = high;
            step *= 2.0;
            high += step;
        }
        Ok([beneath, high])
    }
}
