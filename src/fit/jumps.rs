//! Rows on a jump of the model.
//!
//! Where adhesive bodies snap together or part the model jumps, and just before they part its slopes grow without bound. A
//! row there says on which side of the jump it was measured, not how far it is off: one row on the wrong side pulls the
//! parameters away, and one on the brink seems to know them to many digits. Such rows are left out, as many as lie within
//! a row's distance of the jump or within what is not known of its place, and those beside it that were measured on its
//! other side, so that the jump of the model is free to go where the rest of the curve wants it.

use super::curve::Curve;
use super::frame::Frame;
use super::solve::{Found, Place, Task};
use super::{SPARE, answer, noise::Moments};

/// Rounds in which the jumps of the model find their place.
const ROUNDS: usize = 12;
/// Part of the way of the drive beyond which no row is said to be on a jump, however little is known of its place.
const FARTHEST: f64 = 0.05;
/// Standard deviations of the place of a jump within which a row is on it.
const SURE: f64 = 3.0;

/// The frame without the rows that lie on a jump, and the answer in it, searched from `found` on.
///
/// # Errors
/// The scene cannot be computed.
pub fn left_out(task: &Task<'_>, mut found: Found, tolerance: f64) -> Result<(Frame, Found), String> {
    let mut frame = task.frame.clone();
    for _ in 0..ROUNDS {
        if found.answer.jumps.is_empty() {
            break;
        }
        let rows = on_jumps(&Task { frame: &frame, ..*task }, &found)?;
        let kept: Vec<usize> = (0..task.frame.len()).filter(|&n| !rows.contains(&task.frame.used[n])).collect();
        let next = task.frame.part(&kept);
        let enough = next.len() >= task.count() + next.columns().len() + SPARE;
        if !enough || next.used == frame.used {
            break;
        }
        frame = next;
        found = Task { frame: &frame, ..*task }.solved(&found.place, tolerance)?;
    }
    Ok((frame, found))
}

/// What is said of points that were left out.
#[must_use]
pub fn told(curve: &Curve, on_jumps: &[usize]) -> Option<String> {
    /// The most rows that are named.
    const NAMED: usize = 8;
    let rows: Vec<String> = on_jumps.iter().take(NAMED).map(|&at| curve.rows[at].to_string()).collect();
    let more = if on_jumps.len() > NAMED { ", …" } else { "" };
    let count = on_jumps.len();
    let plural = if count == 1 { "row" } else { "rows" };
    (count > 0).then(|| {
        format!(
            "{count} {plural} left out ({}{more}): the model jumps there, for the bodies snap together or part, and a row on a jump says nothing of how far it is off",
            rows.join(", ")
        )
    })
}

/// The rows on jumps of an answer, in order.
fn on_jumps(task: &Task<'_>, found: &Found) -> Result<Vec<usize>, String> {
    let drive = task.model.curve.driven(task.model.led);
    let measured = task.model.curve.answered(task.model.led);
    let baseline = task.frame.baseline(&task.rest(&found.answer));
    let response = &found.answer.response;
    let usual = usual_step(drive);
    let doubts = doubts(task, found)?;
    let mut rows = Vec::new();
    for (jump, doubt) in found.answer.jumps.iter().zip(doubts) {
        let (before, row) = (jump.row.saturating_sub(1), jump.row.min(drive.len() - 1));
        let at = jump.at.unwrap_or(0.5 * (drive[before] + drive[row]));
        let reach = usual.max((drive[row] - drive[before]).abs()).max(doubt).min(FARTHEST * task.span());
        let off = |row: usize| measured[row] - response[row] - answer::baseline_at(task, &baseline, row);
        // What is off by more than half of the jump was measured on its other side.
        let near = |row: &usize| (drive[*row] - at).abs() <= reach || off(*row).abs() > 0.5 * jump.height;
        rows.extend((0..jump.row).rev().take_while(near));
        rows.extend((jump.row..drive.len()).take_while(near));
    }
    rows.sort_unstable();
    rows.dedup();
    Ok(rows)
}

/// The median of the steps between rows.
fn usual_step(drive: &[f64]) -> f64 {
    let mut steps: Vec<f64> =
        drive.windows(2).map(|pair| (pair[1] - pair[0]).abs()).filter(|step| *step > 0.0).collect();
    steps.sort_by(f64::total_cmp);
    steps.get(steps.len() / 2).copied().unwrap_or(0.0)
}

/// Per jump what is not known of its place, from the covariance of the parameters; zero where its place is not told.
fn doubts(task: &Task<'_>, found: &Found) -> Result<Vec<f64>, String> {
    let columns = answer::columns(task, found)?;
    let judged = Moments::of(task.frame, &columns, &task.rest(&found.answer)).judged(task.frame.correlation);
    let Some(inverse) = judged.inverse else { return Ok(vec![0.0; found.answer.jumps.len()]) };
    let count = task.count();
    let beside: Vec<(f64, Vec<Option<f64>>)> =
        (0..count).map(|number| places_beside(task, found, number)).collect::<Result<_, String>>()?;
    let doubt = |(at, jump): (usize, &super::adhesive::Jump)| {
        let slope = |(step, places): &(f64, Vec<Option<f64>>)| {
            let moved = places.get(at).copied().flatten().zip(jump.at);
            moved.map_or(0.0, |(moved, here)| (moved - here) / step)
        };
        let slopes: Vec<f64> = beside.iter().map(slope).collect();
        let pairs = (0..count).flat_map(|j| (0..count).map(move |k| (j, k)));
        let square: f64 = pairs.map(|(j, k)| slopes[j] * slopes[k] * inverse[(j, k)]).sum();
        SURE * (judged.variance * square.max(0.0)).sqrt()
    };
    Ok(found.answer.jumps.iter().enumerate().map(doubt).collect())
}

/// Where the jumps are with parameter `number` moved by a small step of its natural scale, and that step.
fn places_beside(task: &Task<'_>, found: &Found, number: usize) -> Result<(f64, Vec<Option<f64>>), String> {
    let mut place: Place = found.place.clone();
    let step = match task.model.free.get(number) {
        Some(free) => {
            let natural = free.natural(place.values[number]);
            let (low, high) = free.ends();
            let size = if free.is_ratio() { task.step } else { task.step * (high - low) };
            let step = if natural + size > high { -size } else { size };
            place.values[number] = free.value(natural + step);
            step
        }
        None => {
            let step = task.step * task.span();
            place.contact += step;
            step
        }
    };
    let answer = task.answer(&place)?;
    Ok((step, answer.jumps.iter().map(|jump| jump.at).collect()))
}
