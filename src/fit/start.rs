//! Where a search starts: the best of a few places, looked at with a few of the points.

use super::curve::Curve;
use super::frame::dot;
use super::solve::{Place, Task};
use crate::scene::fit::Drive;

/// Places that are searched from.
const SEARCHED: usize = 3;
/// Draws of the parameters where an answer is cheap, and where it is not.
const DRAWS: (usize, usize) = (16, 8);
/// Parts of the way of the drive tried as first touch where an answer is cheap.
const TOUCHES: usize = 16;
/// The best of them, tried with all draws.
const KEPT: usize = 3;
/// Part of the largest force by which twice the moduli may miss twice the force.
const ALIKE: f64 = 1e-10;
/// Ratio to the value of the scene within which a parameter is drawn.
const NEAR: f64 = 1e3;
/// Part of the response that is more than the baseline, and in standard deviations of it.
const RISE: (f64, f64) = (1e-3, 5.0);

/// The places to search from, the best of the scene's own values first and then the best of all others: a draw that lies
/// nearer to the data may still lie in another valley. None if the scene cannot be computed at any.
#[must_use]
pub fn starts(task: &Task<'_>) -> Vec<Place> {
    let scene: Vec<f64> = task.model.free.iter().map(|free| free.start.clamp(free.low, free.high)).collect();
    let guess = if task.touch { first_touch(task.model.curve, task.model.led) } else { 0.0 };
    let cheap = task.model.is_cheap();
    let draws = match (free_ratios(task), cheap) {
        (0, _) => 1,
        (_, true) => DRAWS.0,
        (_, false) => DRAWS.1,
    };
    let at = |values: &[f64], contact: f64| tried_at(task, Place { values: values.to_vec(), contact });
    let mut tried: Vec<(f64, Place)> =
        touches(task, guess, cheap).into_iter().filter_map(|contact| at(&scene, contact)).collect();
    tried.sort_by(|a, b| a.0.total_cmp(&b.0));
    let own = tried.first().map(|(_, place)| place.clone());
    let best = tried.iter().take(KEPT).map(|(_, place)| place.contact);
    let touches: Vec<f64> = best.chain(task.touch.then_some(guess)).collect();
    for number in 1..draws {
        let values = drawn(task, number);
        tried.extend(touches.iter().filter_map(|&contact| at(&values, contact)));
    }
    tried.sort_by(|a, b| a.0.total_cmp(&b.0));
    let others = tried.into_iter().map(|(_, place)| place).filter(|place| Some(place) != own.as_ref());
    own.iter().cloned().chain(others).take(SEARCHED).collect()
}

/// How many parameters a factor of all forces leaves free.
fn free_ratios(task: &Task<'_>) -> usize {
    let free = task.model.free;
    let scales = matches!(task.model.led, Drive::Depth | Drive::Force);
    free.len() - usize::from(scales && free.iter().any(super::Free::scales_force))
}

/// The sum of squares at a place, all moduli scaled so that it is least.
fn tried_at(task: &Task<'_>, place: Place) -> Option<(f64, Place)> {
    let answer = task.answer(&place).ok()?;
    let exact = task.best_ratio(&answer);
    if let Some((squares, scaled)) = exact.and_then(|(factor, squares)| Some((squares, task.scaled(&place, factor)?))) {
        return Some((squares, scaled));
    }
    let here = task.residual(&answer);
    let model = task.frame.reduced(&task.frame.chosen(&answer.response));
    // Measured is model and what is left.
    let factor = 1.0 + dot(&model, &here) / dot(&model, &model);
    let scaled = scaled(task, &place, factor).and_then(|place| {
        let rest = task.residual(&task.answer(&place).ok()?);
        Some((dot(&rest, &rest), place))
    });
    Some((dot(&here, &here), place)).into_iter().chain(scaled).min_by(|a, b| a.0.total_cmp(&b.0))
}

/// A parameter with all others of whose kind all forces grow in one ratio: told by an answer with all of them doubled.
#[must_use]
pub fn scaling(task: &Task<'_>) -> Option<usize> {
    let number = task.model.free.iter().position(super::Free::scales_force)?;
    if task.model.led != Drive::Depth {
        return None;
    }
    let values: Vec<f64> = task.model.free.iter().map(|free| free.start.clamp(free.low, free.high)).collect();
    let doubled = task.model.free.iter().zip(&values).map(|(free, v)| if free.scales_force() { 2.0 * v } else { *v });
    let contact = if task.touch { first_touch(task.model.curve, task.model.led) } else { 0.0 };
    let twice = task.answer(&Place { values: doubled.collect(), contact }).ok()?.response;
    let once = task.answer(&Place { values, contact }).ok()?.response;
    let largest = once.iter().fold(0.0, |largest: f64, force| largest.max(force.abs()));
    let off = once.iter().zip(&twice).fold(0.0, |off: f64, (once, twice)| off.max((twice - 2.0 * once).abs()));
    (largest > 0.0 && off <= ALIKE * largest).then_some(number)
}

/// The place with all that forces grow with times `factor`, within the ranges; compliances under a force.
fn scaled(task: &Task<'_>, place: &Place, factor: f64) -> Option<Place> {
    let factor = match task.model.led {
        Drive::Depth => factor,
        Drive::Force => factor.recip(),
        // Neither a restitution nor what slips under a force grows with moduli.
        Drive::Speed | Drive::Slide => return None,
    };
    if !(factor.is_finite() && factor > 0.0) {
        return None;
    }
    let values =
        task.model.free.iter().zip(&place.values).map(|(free, &value)| {
            if free.scales_force() { (value * factor).clamp(free.low, free.high) } else { value }
        });
    Some(Place { values: values.collect(), contact: place.contact })
}

fn touches(task: &Task<'_>, guess: f64, cheap: bool) -> Vec<f64> {
    if !task.touch {
        return vec![0.0];
    }
    let drive = task.model.curve.driven(task.model.led);
    let low = drive.iter().copied().fold(f64::MAX, f64::min);
    let even = (0..TOUCHES).map(|k| low + task.span() * k as f64 / TOUCHES as f64);
    [guess, 0.0].into_iter().chain(even.filter(|_| cheap)).collect()
}

/// Where the response leaves the baseline on the way in.
fn first_touch(curve: &Curve, led: Drive) -> f64 {
    let (drive, response) = (curve.driven(led), curve.answered(led));
    let deepest = (0..drive.len()).max_by(|&a, &b| drive[a].total_cmp(&drive[b])).unwrap_or(0);
    let head = &response[..(deepest / 10).max(1)];
    let mean = head.iter().sum::<f64>() / head.len() as f64;
    let spread = (head.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / head.len() as f64).sqrt();
    let highest = response.iter().map(|x| (x - mean).abs()).fold(0.0, f64::max);
    let rise = (RISE.0 * highest).max(RISE.1 * spread);
    let touch = (0..=deepest).rev().find(|&at| (response[at] - mean).abs() <= rise);
    drive.get(touch.unwrap_or(0)).copied().unwrap_or(0.0)
}

/// The values of the draw `number`, spread evenly (Halton 1960).
fn drawn(task: &Task<'_>, number: usize) -> Vec<f64> {
    const BASES: [usize; 8] = [2, 3, 5, 7, 11, 13, 17, 19];
    let one = |(at, free): (usize, &super::Free)| {
        let part = inverse(number, BASES[at % BASES.len()]);
        let (low, high) = free.ends();
        if !free.is_ratio() {
            return free.between(part);
        }
        let (low, high) = (low.max(free.start.ln() - NEAR.ln()), high.min(free.start.ln() + NEAR.ln()));
        if low < high { (low + part * (high - low)).exp().clamp(free.low, free.high) } else { free.between(part) }
    };
    task.model.free.iter().enumerate().map(one).collect()
}

/// The digits of a number mirrored at the point.
fn inverse(mut number: usize, base: usize) -> f64 {
    let (mut part, mut digit) = (0.0, 1.0 / base as f64);
    while number > 0 {
        part += (number % base) as f64 * digit;
        number /= base;
        digit /= base as f64;
    }
    part
}
