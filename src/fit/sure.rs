//! How sure all that was fitted is.

use super::free::Free;
use super::noise::{Judged, Moments, student};
use super::solve::{Found, Task};
use super::unsure::Unsure;
use crate::scene::fit::Drive;
use nalgebra::{DMatrix, SymmetricEigen};

/// What a search left.
#[derive(Clone, Copy)]
pub struct Left<'l> {
    /// What was searched, in the frame of the noise.
    pub task: Task<'l>,
    /// Where the search came to.
    pub found: &'l Found,
    /// All that is fitted: slopes in natural parameters, first touch, the baseline; one value per used point.
    pub columns: &'l [Vec<f64>],
    /// What is left of the used points without the baseline.
    pub off: &'l [f64],
    /// Names of the columns.
    pub names: &'l [String],
}

/// Errors of the columns, those at an end of their range kept there.
pub struct Sure {
    /// Numbers of the columns that are not kept.
    moving: Vec<usize>,
    judged: Judged,
    /// Whether the data tell all of them.
    tell: bool,
    unsure: Option<Unsure>,
    freedom: f64,
}

/// Least eigenvalue of the correlated normal matrix below which a direction is not told by the data.
const BLIND: f64 = 1e-12;
/// Part of half of a range within which a parameter sits at its end.
const AT_END: f64 = 1e-5;

impl Sure {
    /// From what was left.
    #[must_use]
    pub fn of(left: &Left<'_>) -> Self {
        let Left { task, found, columns, off, .. } = left;
        let ends: Vec<bool> =
            task.model.free.iter().zip(&found.place.values).map(|(free, &value)| at_end(free, value)).collect();
        let moving: Vec<usize> = (0..columns.len()).filter(|&at| !ends.get(at).copied().unwrap_or(false)).collect();
        let chosen: Vec<Vec<f64>> = moving.iter().map(|&at| columns[at].clone()).collect();
        let moments = Moments::of(task.frame, &chosen, off);
        let judged = moments.judged(task.frame.correlation);
        let tell = judged.inverse.is_some() && blind(&judged.normal).is_empty();
        let by_row = task.model.led != Drive::Speed;
        let unsure = if tell && by_row { Unsure::of(&moments) } else { None };
        let freedom = off.len().saturating_sub(moving.len()).max(1) as f64;
        Self { moving, judged, tell, unsure, freedom }
    }

    /// Number of columns that are not kept.
    #[must_use]
    pub fn count(&self) -> usize {
        self.moving.len()
    }

    /// Degrees of freedom of what is left.
    #[must_use]
    pub fn freedom(&self) -> f64 {
        self.freedom
    }

    /// Variance of the noise that is new in each row.
    #[must_use]
    pub fn variance(&self) -> f64 {
        self.judged.variance
    }

    /// Whether the column `at` sits at an end of its range.
    #[must_use]
    pub fn is_kept(&self, at: usize) -> bool {
        self.place_of(at).is_none()
    }

    /// Whether the data tell the column `at`.
    #[must_use]
    pub fn knows(&self, at: usize) -> bool {
        self.tell && !self.is_kept(at)
    }

    fn place_of(&self, at: usize) -> Option<usize> {
        self.moving.iter().position(|&other| other == at)
    }

    /// Covariance of two columns at the most likely correlation; none of what is not known.
    #[must_use]
    pub fn covariance(&self, j: usize, k: usize) -> f64 {
        match (self.judged.inverse.as_ref().filter(|_| self.tell), self.place_of(j), self.place_of(k)) {
            (Some(inverse), Some(j), Some(k)) => self.judged.variance * inverse[(j, k)],
            _ => 0.0,
        }
    }

    /// Standard error of the column `at`, and half of its 95 % interval.
    #[must_use]
    pub fn error_and_reach(&self, at: usize) -> (f64, f64) {
        let plain = self.covariance(at, at).sqrt();
        let sure = self.unsure.as_ref().zip(self.place_of(at));
        sure.map_or((plain, student(self.freedom) * plain), |(unsure, at)| unsure.error_and_reach(at))
    }

    /// By how much its interval is wider than that of the most likely correlation.
    #[must_use]
    pub fn wider(&self, at: usize) -> f64 {
        self.error_and_reach(at).1 / (student(self.freedom) * self.covariance(at, at).sqrt())
    }

    /// Root of the mean square of what is left, `off`.
    #[must_use]
    pub fn deviation(&self, off: &[f64]) -> f64 {
        (off.iter().map(|x| x * x).sum::<f64>() / self.freedom).sqrt()
    }

    /// What is said of columns the data cannot tell.
    #[must_use]
    pub fn blind(&self, names: &[String]) -> Vec<String> {
        let blind = blind(&self.judged.normal);
        let alike: Vec<&str> = blind.iter().filter_map(|&at| names.get(self.moving[at]).map(String::as_str)).collect();
        match &alike[..] {
            [] => Vec::new(),
            [one] => vec![format!("the data say nothing of {one}")],
            _ => {
                vec![format!("the data cannot tell {} apart: only a combination of them is known", alike.join(" and "))]
            }
        }
    }
}

fn at_end(free: &Free, value: f64) -> bool {
    let ((low, high), here) = (free.ends(), free.natural(value));
    (here - low).min(high - here) < AT_END * 0.5 * (high - low)
}

/// Columns that take part in a direction the data do not tell.
fn blind(normal: &DMatrix<f64>) -> Vec<usize> {
    if normal.nrows() == 0 {
        return Vec::new();
    }
    let eigen = SymmetricEigen::new(normal.clone());
    let Some((least, value)) = eigen.eigenvalues.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1)) else {
        return Vec::new();
    };
    if *value > BLIND {
        return Vec::new();
    }
    let direction = eigen.eigenvectors.column(least);
    (0..normal.nrows()).filter(|&at| direction[at].abs() > 0.1).collect()
}
