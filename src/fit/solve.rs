//! The parameters at which a model is nearest to a curve.

use super::curve::Curve;
use super::frame::Frame;
use super::model::{Answer, Model};
use crate::contact::adhesion::equilibrium::Control;
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
}

impl Task<'_> {
    fn curve(&self) -> &Curve {
        self.model.curve
    }

    fn control(&self) -> Control {
        self.model.control
    }

    /// Length of the way of the drive.
    #[must_use]
    pub fn span(&self) -> f64 {
        let drive = self.curve().driven(self.control());
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
        let measured = self.curve().answered(self.control());
        self.frame.used.iter().map(|&at| measured[at] - answer.response[at]).collect()
    }

    /// What is left, white and without the baseline.
    #[must_use]
    pub fn residual(&self, answer: &Answer) -> Vec<f64> {
        self.frame.reduced(&self.rest(answer))
    }

    /// Slopes of the answer in the natural parameters, first touch last, at all points.
    ///
    /// # Errors
    /// The scene cannot be computed beside the place.
    pub fn slopes(&self, place: &Place, answer: &Answer) -> Result<Vec<Vec<f64>>, String> {
        let mut slopes: Vec<Vec<f64>> = Vec::new();
        for number in 0..self.model.free.len() {
            slopes.push(self.slope(number, place, answer)?);
        }
        if self.touch {
            slopes.push(self.slope_of_touch(place, answer)?);
        }
        Ok(slopes)
    }

    fn slope(&self, number: usize, place: &Place, answer: &Answer) -> Result<Vec<f64>, String> {
        let free = &self.model.free[number];
        let (natural, (low, high)) = (free.natural(place.values[number]), free.ends());
        let step = if free.is_ratio() { self.step } else { self.step * (high - low) };
        let step = if natural + step > high { -step } else { step };
        let mut beside = place.clone();
        beside.values[number] = free.value(natural + step);
        let response = match self.model.scaled(answer, &beside.values) {
            Some(response) => response,
            None => self.answer(&beside)?.response,
        };
        Ok(response.iter().zip(&answer.response).map(|(beside, here)| (beside - here) / step).collect())
    }

    fn slope_of_touch(&self, place: &Place, answer: &Answer) -> Result<Vec<f64>, String> {
        if let Some(slope) = &answer.slope {
            return Ok(slope.iter().map(|slope| -slope).collect());
        }
        let step = self.step * self.span();
        let beside = self.answer(&Place { contact: place.contact + step, ..place.clone() })?;
        Ok(beside.response.iter().zip(&answer.response).map(|(beside, here)| (beside - here) / step).collect())
    }

    /// The nearest place, searched from `start` on (Levenberg 1944, Marquardt 1963).
    ///
    /// # Errors
    /// The scene cannot be computed at the start.
    pub fn solved(&self, start: &Place, tolerance: f64) -> Result<Found, String> {
        let answer = self.answer(start)?;
        let residual = self.residual(&answer);
        if self.moving() == 0 {
            let squares = residual.iter().map(|x| x * x).sum();
            return Ok(Found { place: start.clone(), answer, squares, converged: true });
        }
        let size = residual.iter().map(|x| x * x).sum::<f64>().sqrt();
        let away = vec![1e3 * size.max(f64::MIN_POSITIVE) / (residual.len() as f64).sqrt(); residual.len()];
        let search =
            Search { task: *self, here: self.coordinates(start), place: start.clone(), answer, residual, away };
        let rule =
            LevenbergMarquardt::new().with_ftol(tolerance).with_xtol(tolerance).with_gtol(1e-14).with_patience(12);
        let (search, report) = rule.minimize(search);
        let squares = search.residual.iter().map(|x| x * x).sum();
        Ok(Found {
            place: search.place,
            answer: search.answer,
            squares,
            converged: report.termination.was_successful(),
        })
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

/// How far from the ends of its range, as a part of half of it, a parameter starts.
const INSIDE: f64 = 1.0 - 1e-6;

/// A search under way.
struct Search<'t> {
    task: Task<'t>,
    here: DVector<f64>,
    place: Place,
    answer: Answer,
    residual: Vec<f64>,
    /// What is said of a place at which the scene cannot be computed.
    away: Vec<f64>,
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
                self.residual = self.task.residual(&answer);
                self.answer = answer;
            }
            Err(_) => self.residual.clone_from(&self.away),
        }
    }

    fn params(&self) -> DVector<f64> {
        self.here.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(DVector::from_column_slice(&self.residual))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let Task { frame, model, .. } = self.task;
        let slopes = self.task.slopes(&self.place, &self.answer).ok()?;
        let moving = slopes.into_iter().enumerate().filter(|&(at, _)| !self.task.keeps(at));
        let columns = moving.zip(&self.here).map(|((at, slope), x)| {
            let rate = match model.free.get(at) {
                Some(free) => 0.5 * (free.ends().1 - free.ends().0) * x.cos(),
                None => self.task.span(),
            };
            let column = frame.reduced(&frame.chosen(&slope));
            DVector::from_vec(column.into_iter().map(|value| -rate * value).collect())
        });
        Some(DMatrix::from_columns(&columns.collect::<Vec<_>>()))
    }
}
