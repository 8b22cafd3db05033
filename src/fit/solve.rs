//! The parameters at which a model is nearest to a curve.

use super::curve::Curve;
use super::frame::{Frame, dot};
use super::model::{Answer, Model, Sloped};
use crate::scene::fit::Drive;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};

/// Values of all that is free.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// Free values of the scene [SI units].
    pub values: Vec<f64>,
    /// First touch [unit of the drive].
    pub contact: f64,
}

/// Where a search came to.
#[derive(Debug, Clone)]
pub struct Found {
    /// The place.
    pub place: Place,
    /// What the model answers there.
    pub answer: Answer,
    /// Sum of squares of what is left, made white.
    pub squares: f64,
    /// Whether the search ended by itself.
    pub converged: bool,
}

/// A model, a curve and a frame to hold them against each other.
#[derive(Clone, Copy)]
pub struct Task<'t> {
    /// The model.
    pub model: Model<'t>,
    /// The frame.
    pub frame: &'t Frame,
    /// Whether first touch is free.
    pub touch: bool,
    /// Steps of natural parameters by which slopes are taken.
    pub step: f64,
    /// Numbers of parameters that are kept, first touch last.
    pub kept: [Option<usize>; 2],
    /// A parameter with all others of whose kind all forces grow in one ratio, if there is one.
    pub scaling: Option<usize>,
}

impl Task<'_> {
    fn curve(&self) -> &Curve {
        self.model.curve
    }

    fn led(&self) -> Drive {
        self.model.led
    }

    /// Length of the way of the drive.
    #[must_use]
    pub fn span(&self) -> f64 {
        let drive = self.curve().driven(self.led());
        let (low, high) = drive.iter().fold((f64::MAX, f64::MIN), |(low, high), &d| (low.min(d), high.max(d)));
        (high - low).max(f64::MIN_POSITIVE)
    }

    /// Number of free parameters, first touch among them.
    #[must_use]
    pub fn count(&self) -> usize {
        self.model.free.len() + usize::from(self.touch)
    }

    /// The answer at a place.
    ///
    /// # Errors
    /// The scene cannot be computed there.
    pub fn answer(&self, place: &Place) -> Result<Answer, String> {
        self.model.answer(&place.values, place.contact)
    }

    /// What the answer leaves of the used points.
    #[must_use]
    pub fn rest(&self, answer: &Answer) -> Vec<f64> {
        let measured = self.curve().answered(self.led());
        self.frame.used.iter().map(|&at| measured[at] - answer.response[at]).collect()
    }

    /// What is left, white and without the baseline.
    #[must_use]
    pub fn residual(&self, answer: &Answer) -> Vec<f64> {
        self.frame.reduced(&self.rest(answer))
    }

    /// Slopes of the answer in the natural parameters, first touch last, at all points; none of what is kept.
    ///
    /// # Errors
    /// The scene cannot be computed beside the place.
    pub fn slopes(&self, place: &Place, answer: &Answer) -> Result<Vec<Vec<f64>>, String> {
        let known = self.model.slopes((&place.values, place.contact), answer)?;
        let free = 0..self.model.free.len();
        let nothing = || Ok(Vec::new());
        let mut slopes = free
            .map(
                |number| {
                    if self.keeps(number) { nothing() } else { self.slope(number, place, (answer, known.as_ref())) }
                },
            )
            .collect::<Result<Vec<Vec<f64>>, String>>()?;
        if self.touch {
            slopes.push(match known {
                Some(known) => known.slopes.touch,
                None => self.slope_of_touch(place, answer)?,
            });
        }
        Ok(slopes)
    }

    fn slope(
        &self,
        number: usize,
        place: &Place,
        (answer, known): (&Answer, Option<&Sloped>),
    ) -> Result<Vec<f64>, String> {
        let free = &self.model.free[number];
        let (natural, (low, high)) = (free.natural(place.values[number]), free.ends());
        let step = if free.is_ratio() { self.step } else { self.step * (high - low) };
        let step = if natural + step > high { -step } else { step };
        let mut beside = place.clone();
        beside.values[number] = free.value(natural + step);
        let changes = known.and_then(|known| Some((known, self.model.changes(known, &beside.values, place.contact)?)));
        if let Some((known, changes)) = changes {
            return Ok(summed(&known.slopes.numbers, &changes, (step, answer.response.len())));
        }
        let beside = self.answer(&beside)?;
        Ok(beside.response.iter().zip(&answer.response).map(|(beside, here)| (beside - here) / step).collect())
    }

    /// Slope of the answer in first touch at all points, by a difference.
    ///
    /// # Errors
    /// The scene cannot be computed beside the place.
    pub fn slope_of_touch(&self, place: &Place, answer: &Answer) -> Result<Vec<f64>, String> {
        let step = self.step * self.span();
        let beside = self.answer(&Place { contact: place.contact + step, ..place.clone() })?;
        Ok(beside.response.iter().zip(&answer.response).map(|(beside, here)| (beside - here) / step).collect())
    }

    /// The nearest place, searched from `start` on (Levenberg 1944, Marquardt 1963); a ratio in which all forces grow is
    /// projected out (Golub & Pereyra 1973, with the slopes of Kaufman 1975).
    ///
    /// # Errors
    /// The scene cannot be computed at the start.
    pub fn solved(&self, start: &Place, tolerance: f64) -> Result<Found, String> {
        let Some(number) = self.scaling.filter(|_| self.kept == [None; 2]) else {
            let task = Task { scaling: None, ..*self };
            return task.searched(start, tolerance).map(|search| search.0.found(search.1));
        };
        let (search, ended) = Task { kept: [Some(number), None], ..*self }.searched(start, tolerance)?;
        let place = self.scaled(&search.place, search.left.factor);
        if let Some(place) = place.clone().filter(|_| self.is_inside(&search.place)) {
            let answer = self.answer(&place)?;
            let squares = squares(&self.residual(&answer));
            return Ok(Found { place, answer, squares, converged: ended });
        }
        // An end of a range is met.
        Task { scaling: None, ..*self }.solved(&place.unwrap_or(search.place), tolerance)
    }

    /// Whether no parameter is at an end of its range.
    fn is_inside(&self, place: &Place) -> bool {
        self.model.free.iter().zip(&place.values).all(|(free, &value)| {
            let ((low, high), here) = (free.ends(), free.natural(value));
            (here - low).min(high - here) > NEAR_END * (high - low)
        })
    }

    /// What an answer leaves, in the best ratio if one is projected out.
    fn left(&self, answer: &Answer) -> Left {
        if self.scaling.is_none() {
            return Left { rest: self.residual(answer), factor: 1.0, along: None };
        }
        let mut along = self.frame.reduced(&self.frame.chosen(&answer.response));
        let measured = self.frame.reduced(&self.frame.chosen(self.curve().answered(self.led())));
        let size = squares(&along).sqrt();
        if size <= 0.0 {
            return Left { rest: measured, factor: 1.0, along: None };
        }
        along.iter_mut().for_each(|x| *x /= size);
        let part = dot(&along, &measured);
        let rest = measured.iter().zip(&along).map(|(y, x)| y - part * x).collect();
        Left { rest, factor: part / size, along: Some(along) }
    }

    /// The best ratio of the answer at a place, and the sum of squares in it; none if it is no ratio.
    pub fn best_ratio(&self, answer: &Answer) -> Option<(f64, f64)> {
        let left = self.scaling.map(|_| self.left(answer))?;
        (left.factor > 0.0).then(|| (left.factor, squares(&left.rest)))
    }

    /// The place with all that forces grow with times `factor`; `None` outside of the ranges.
    pub fn scaled(&self, place: &Place, factor: f64) -> Option<Place> {
        let of = |(free, &value): (&super::Free, &f64)| {
            let value = if free.scales_force() { value * factor } else { value };
            (free.low..=free.high).contains(&value).then_some(value)
        };
        let values = self.model.free.iter().zip(&place.values).map(of).collect::<Option<Vec<f64>>>()?;
        Some(Place { values, contact: place.contact })
    }

    /// Unbounded coordinates: an arc whose sine goes from end to end of a range; first touch in parts of the way.
    fn coordinates(&self, place: &Place) -> DVector<f64> {
        let free = self.model.free.iter().zip(&place.values).map(|(free, &value)| {
            let (low, high) = free.ends();
            (2.0 * (free.natural(value) - low) / (high - low) - 1.0).clamp(-INSIDE, INSIDE).asin()
        });
        let all = free.chain(self.touch.then(|| place.contact / self.span()));
        DVector::from_iterator(self.moving(), all.enumerate().filter(|&(at, _)| !self.keeps(at)).map(|(_, x)| x))
    }

    fn keeps(&self, at: usize) -> bool {
        self.kept.contains(&Some(at))
    }

    fn moving(&self) -> usize {
        (0..self.count()).filter(|&at| !self.keeps(at)).count()
    }

    /// The place of coordinates; what is kept stays as in `like`.
    fn place(&self, coordinates: &DVector<f64>, like: &Place) -> Place {
        let mut place = like.clone();
        let moving = (0..self.count()).filter(|&at| !self.keeps(at));
        for (at, &x) in moving.zip(coordinates) {
            match self.model.free.get(at) {
                Some(free) => {
                    let (low, high) = free.ends();
                    place.values[at] =
                        free.value(low + 0.5 * (high - low) * (1.0 + x.sin())).clamp(free.low, free.high);
                }
                None => place.contact = x * self.span(),
            }
        }
        place
    }
}

impl<'t> Task<'t> {
    /// The search, and whether it ended by itself.
    fn searched(self, start: &Place, tolerance: f64) -> Result<(Search<'t>, bool), String> {
        let answer = self.answer(start)?;
        let left = self.left(&answer);
        let size = squares(&left.rest).sqrt();
        let away = vec![1e3 * size.max(f64::MIN_POSITIVE) / (left.rest.len() as f64).sqrt(); left.rest.len()];
        let search = Search { task: self, here: self.coordinates(start), place: start.clone(), answer, left, away };
        if self.moving() == 0 {
            return Ok((search, true));
        }
        // However roughly squares are asked for, errors of parameters may be small parts of them.
        let rule = LevenbergMarquardt::new().with_ftol(tolerance).with_xtol(tolerance.min(CLOSE)).with_gtol(1e-14);
        let rule = rule.with_patience(12);
        let (search, report) = rule.minimize(search);
        Ok((search, report.termination.was_successful()))
    }
}

/// Σ x².
fn squares(values: &[f64]) -> f64 {
    dot(values, values)
}

/// Σ slopes times changes, over a step.
fn summed(slopes: &[Vec<f64>], changes: &[f64], (step, count): (f64, usize)) -> Vec<f64> {
    let mut sum = vec![0.0; count];
    for (slope, change) in slopes.iter().zip(changes).filter(|(_, change)| change.abs() > 0.0) {
        let rate = change / step;
        sum.iter_mut().zip(slope).for_each(|(sum, slope)| *sum += rate * slope);
    }
    sum
}

/// Largest relative change of the parameters at which a search ends.
const CLOSE: f64 = 1e-8;
/// Part of a range from its ends within which a parameter may be held by them.
const NEAR_END: f64 = 1e-4;
/// How far from the ends of its range, as a part of half of it, a parameter starts.
const INSIDE: f64 = 1.0 - 1e-6;

/// What an answer leaves.
struct Left {
    /// What is left, white and without the baseline.
    rest: Vec<f64>,
    /// Ratio in which the answer counts.
    factor: f64,
    /// The answer, white, without the baseline, and of length one, where its ratio was projected out.
    along: Option<Vec<f64>>,
}

/// A search under way.
struct Search<'t> {
    task: Task<'t>,
    here: DVector<f64>,
    place: Place,
    answer: Answer,
    left: Left,
    /// What is said of a place at which the scene cannot be computed.
    away: Vec<f64>,
}

impl Search<'_> {
    fn found(self, converged: bool) -> Found {
        let squares = squares(&self.left.rest);
        Found { place: self.place, answer: self.answer, squares, converged }
    }

    /// A column of the slopes of what is left.
    fn column(&self, slope: &[f64], rate: f64) -> DVector<f64> {
        let mut column = self.task.frame.reduced(&self.task.frame.chosen(slope));
        let rate = -rate * self.left.factor;
        column.iter_mut().for_each(|value| *value *= rate);
        if let Some(along) = &self.left.along {
            let part = dot(along, &column);
            column.iter_mut().zip(along).for_each(|(value, x)| *value -= part * x);
        }
        DVector::from_vec(column)
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Search<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        self.here.copy_from(x);
        self.place = self.task.place(x, &self.place);
        match self.task.answer(&self.place) {
            Ok(answer) => {
                self.left = self.task.left(&answer);
                self.answer = answer;
            }
            Err(_) => self.left.rest.clone_from(&self.away),
        }
    }

    fn params(&self) -> DVector<f64> {
        self.here.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(DVector::from_column_slice(&self.left.rest))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let Task { model, .. } = self.task;
        let slopes = self.task.slopes(&self.place, &self.answer).ok()?;
        let moving = slopes.into_iter().enumerate().filter(|&(at, _)| !self.task.keeps(at));
        let columns = moving.zip(&self.here).map(|((at, slope), x)| {
            let rate = match model.free.get(at) {
                Some(free) => 0.5 * (free.ends().1 - free.ends().0) * x.cos(),
                None => self.task.span(),
            };
            self.column(&slope, rate)
        });
        Some(DMatrix::from_columns(&columns.collect::<Vec<_>>()))
    }
}
