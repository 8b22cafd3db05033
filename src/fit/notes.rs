//! What a user must know of a fit, in words.

use super::Question;
use super::frame::Frame;
use super::free::Free;
use super::noise::Moments;
use super::solve::{Found, Task};
use super::sure::{Left, Sure};
use super::verdict::{self, Noise, Verdict};
use crate::scene::fit::Drive;

/// What the data say of the scene.
pub struct Heard {
    /// Noise before first touch.
    pub noise: Option<Noise>,
    /// What is left in contact against it.
    pub verdict: Option<Verdict>,
    /// How many standard deviations the shape of what is left is beyond the scatter of rows that were measured each by
    /// itself.
    shape: Option<f64>,
    /// Whether more is left than the scene is computed to.
    coarse: bool,
}

impl Heard {
    /// From what was left, of this deviation.
    #[must_use]
    pub fn of(question: &Question, left: &Left<'_>, deviation: f64) -> Self {
        let Left { task, found, columns, off, .. } = *left;
        let response = &found.answer.response;
        let floor = question.floor * response.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        let (touching, apart) = sides(task.frame, response);
        // Only before a touch there is nothing but noise.
        let pressed = matches!(question.led, Drive::Depth | Drive::Force);
        let noise = Noise::before(task.frame, off, &apart).filter(|_| pressed).map(|noise| noise.not_below(floor));
        let verdict = noise
            .filter(|_| touching.len() > columns.len() + 10)
            .map(|noise| Verdict::of(task.frame, (columns, off), &touching, noise));
        let coarse = deviation > floor;
        let alone = coarse && question.led == Drive::Speed;
        let drive = task.frame.chosen(task.model.curve.driven(question.led));
        let shape = alone.then(|| verdict::shape_of_scatter((&drive, &task.frame.weights), columns, off));
        Self { noise, verdict, shape, coarse }
    }

    /// Whether the data speak against the scene.
    #[must_use]
    pub fn rejects(&self) -> bool {
        self.verdict.is_some_and(|verdict| verdict.rejects()) || self.shape.is_some_and(verdict::is_no_chance)
    }

    /// The same in words.
    #[must_use]
    pub fn notes(&self, left: &Left<'_>) -> Vec<String> {
        let tilt = left.task.frame.columns().len() == 1 && tilted(left);
        let tilt = tilt.then(|| "the baseline before first touch is tilted: try --baseline linear".to_owned());
        self.against(left.task.frame).into_iter().chain(tilt).collect()
    }

    fn against(&self, frame: &Frame) -> Option<String> {
        match (self.verdict.filter(Verdict::rejects), self.shape.filter(|shape| verdict::is_no_chance(*shape))) {
            (Some(verdict), _) => Some(format!(
                "the data speak against the scene: in contact what is left is {:.3} times the noise before it and has a shape ({:.0} standard deviations)",
                verdict.chi2.sqrt(),
                verdict.size.max(verdict.shape),
            )),
            (None, Some(shape)) => Some(format!(
                "the data speak against the scene: what is left has a shape over the speed ({shape:.0} standard deviations beyond its scatter)"
            )),
            (None, None) if self.noise.is_none() && self.coarse && frame.correlation > ALIKE_ROWS => Some(format!(
                "neighbouring residuals are alike (correlation {:.3}): the noise is, or the scene is not quite right; the intervals are widened for it, but no noise before first touch is there to tell which",
                frame.correlation
            )),
            (None, None) => None,
        }
    }
}

/// Correlation of neighbouring residuals from which on it is spoken of.
const ALIKE_ROWS: f64 = 0.3;
/// Correlation of parameters from which on it is spoken of.
const ALIKE: f64 = 0.99;

/// Numbers of the used points in contact, and of those before and behind it.
fn sides(frame: &Frame, response: &[f64]) -> (Vec<usize>, Vec<usize>) {
    (0..frame.len()).partition(|&number| response[frame.used[number]].abs() > 0.0)
}

/// Whether the search came to no end.
pub fn search(found: &Found) -> Vec<String> {
    let note = "the search has not come to an end: the values are where it stopped";
    if found.converged { Vec::new() } else { vec![note.to_owned()] }
}

/// Parameters at the ends of their ranges.
pub fn ends(free: &[Free], values: &[f64], sure: &Sure) -> Vec<String> {
    let kept = free.iter().zip(values).enumerate().filter(|&(at, _)| sure.is_kept(at));
    let told = |(_, (free, value)): (usize, (&Free, &f64))| {
        format!("{} sits at the end of its range, {value:?} {}: widen it", free.path, free.unit)
    };
    kept.map(told).collect()
}

/// Parameters that are hardly told apart.
pub fn alike(names: &[String], correlations: &[Vec<f64>]) -> Vec<String> {
    let pairs = (0..names.len()).flat_map(|j| (0..j).map(move |k| (k, j)));
    let close = pairs.filter(|&(k, j)| correlations[k][j].abs() > ALIKE);
    let told = close.map(|(k, j)| {
        let correlation = correlations[k][j];
        format!("{} and {} are hardly told apart (correlation {correlation:.4})", names[k], names[j])
    });
    told.collect()
}

/// Standard errors from zero from which on a tilt before first touch is spoken of.
const TILTED: f64 = 5.0;

/// Whether what is left before first touch rises or falls with the drive.
fn tilted(left: &Left<'_>) -> bool {
    let Left { task: Task { model, frame, .. }, off, .. } = *left;
    let (_, apart) = sides(frame, &left.found.answer.response);
    if apart.len() < verdict::ENOUGH {
        return false;
    }
    let drive = model.curve.driven(model.led);
    let part = frame.part(&apart);
    let rest: Vec<f64> = apart.iter().map(|&number| off[number]).collect();
    let tilt: Vec<f64> = part.used.iter().map(|&at| drive[at]).collect();
    let judged = Moments::of(&part, &[vec![1.0; rest.len()], tilt.clone()], &rest).most_likely();
    let Some(inverse) = judged.inverse else { return false };
    let part = part.with(part.weights.clone(), judged.correlation);
    let (one, tilt, rest) = (part.whitened(&vec![1.0; rest.len()]), part.whitened(&tilt), part.whitened(&rest));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let slope = inverse[(1, 0)] * dot(&one, &rest) + inverse[(1, 1)] * dot(&tilt, &rest);
    slope.abs() > TILTED * (judged.variance * inverse[(1, 1)]).sqrt()
}
