//! The frame in which residuals are small: which points count, how much, and what is taken off them.

use crate::scene::fit::Baseline;
use nalgebra::{DMatrix, DVector};

/// What the virtual deflection of a cantilever is called among the parameters, a pure number [m/m].
pub const VIRTUAL: &str = "virtual_deflection";

/// Points that count, their weights and their noise, and the baseline.
///
/// Noise of the correlation ρ between neighbours becomes white by e_i = r_i − ρr_{i−1} (Prais & Winsten 1954), over gaps by
/// the power of ρ that is left there; the
/// baseline is projected out, so that what is left depends on the parameters of the model alone (Golub & Pereyra 1973).
#[derive(Debug, Clone)]
pub struct Frame {
    /// Points that count, in order.
    pub used: Vec<usize>,
    /// Roots of their weights.
    pub weights: Vec<f64>,
    /// Correlation ρ of the noise of neighbours.
    pub correlation: f64,
    /// What the drive is divided by in the column of the tilt, or what stands in its place.
    pub largest: f64,
    /// Columns of the baseline, one value per used point.
    columns: Vec<Vec<f64>>,
    /// The same made white, orthonormal.
    basis: Vec<Vec<f64>>,
}

impl Frame {
    /// The frame of the points `used` of a curve driven by `drive`, of equal weights and white noise.
    #[must_use]
    pub fn new(drive: &[f64], used: Vec<usize>, baseline: Baseline) -> Self {
        let one = vec![1.0; used.len()];
        let largest = used.iter().map(|&at| drive[at].abs()).fold(f64::MIN_POSITIVE, f64::max);
        let tilt = || used.iter().map(|&at| drive[at] / largest).collect();
        let columns = match baseline {
            Baseline::Absent => Vec::new(),
            Baseline::Constant => vec![one.clone()],
            Baseline::Linear | Baseline::Virtual => vec![one.clone(), tilt()],
        };
        let frame = Self { weights: one, used, correlation: 0.0, largest, columns, basis: Vec::new() };
        frame.projected()
    }

    /// The same with other weights, given by their roots, and another correlation.
    #[must_use]
    pub fn with(&self, weights: Vec<f64>, correlation: f64) -> Self {
        Self { weights, correlation, ..self.clone() }.projected()
    }

    /// The same with the weights of points, given by their roots for all points of the curve.
    #[must_use]
    pub fn weighing(&self, roots: &[f64]) -> Self {
        self.with(self.chosen(roots), self.correlation)
    }

    /// The same with another second column of the baseline, given for all points of the curve.
    #[must_use]
    pub fn along(self, column: &[f64]) -> Self {
        let mut columns = self.columns.clone();
        let largest = self.used.iter().map(|&at| column[at].abs()).fold(f64::MIN_POSITIVE, f64::max);
        if let Some(second) = columns.get_mut(1) {
            *second = self.used.iter().map(|&at| column[at] / largest).collect();
        }
        Self { largest, columns, ..self }.projected()
    }

    fn projected(mut self) -> Self {
        self.basis = Vec::new();
        for column in self.columns.clone() {
            let mut white = self.whitened(&column);
            self.project(&mut white);
            let size = dot(&white, &white).sqrt();
            // A column that is a sum of those before has nothing of its own.
            if size > 1e-10 * (white.len() as f64).sqrt() {
                white.iter_mut().for_each(|x| *x /= size);
                self.basis.push(white);
            }
        }
        self
    }

    /// The frame of some of the used points, given by their numbers among them.
    #[must_use]
    pub fn part(&self, numbers: &[usize]) -> Self {
        let of = |column: &Vec<f64>| numbers.iter().map(|&number| column[number]).collect::<Vec<f64>>();
        let used = numbers.iter().map(|&number| self.used[number]).collect();
        let columns = self.columns.iter().map(of).collect();
        Self { used, weights: of(&self.weights), columns, ..self.clone() }.projected()
    }

    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.used.len()
    }

    /// Whether no point counts.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.used.is_empty()
    }

    /// Columns of the baseline, one value per used point.
    #[must_use]
    pub fn columns(&self) -> &[Vec<f64>] {
        &self.columns
    }

    /// The used ones of values given for all points.
    #[must_use]
    pub fn chosen(&self, all: &[f64]) -> Vec<f64> {
        self.used.iter().map(|&at| all[at]).collect()
    }

    /// Whether the used point `number` follows the one before it without a gap.
    #[must_use]
    pub fn follows(&self, number: usize) -> bool {
        number > 0 && self.used[number] == self.used[number - 1] + 1
    }

    /// Rows from the used point before the point `number` to it; one of the first.
    #[must_use]
    pub fn steps(&self, number: usize) -> i32 {
        let before = number.checked_sub(1).map_or(0, |before| self.used[before]);
        i32::try_from(self.used[number].saturating_sub(before)).unwrap_or(i32::MAX).max(1)
    }

    /// Values of the used points, weighted and made white.
    #[must_use]
    pub fn whitened(&self, values: &[f64]) -> Vec<f64> {
        let rho = self.correlation;
        let first = (1.0 - rho * rho).sqrt();
        let weighted: Vec<f64> = values.iter().zip(&self.weights).map(|(value, weight)| value * weight).collect();
        if rho.abs() <= 0.0 {
            return weighted;
        }
        let white = |number: usize| match number {
            0 => first * weighted[0],
            _ if self.follows(number) => weighted[number] - rho * weighted[number - 1],
            _ => {
                let steps = self.steps(number);
                (weighted[number] - rho.powi(steps) * weighted[number - 1]) / over_gap(steps, rho)
            }
        };
        (0..weighted.len()).map(white).collect()
    }

    /// Takes the baseline off white values.
    pub fn project(&self, white: &mut [f64]) {
        for column in &self.basis {
            let part = dot(column, white);
            white.iter_mut().zip(column).for_each(|(value, a)| *value -= part * a);
        }
    }

    /// Values of the used points, white and without the baseline.
    #[must_use]
    pub fn reduced(&self, values: &[f64]) -> Vec<f64> {
        let mut white = self.whitened(values);
        self.project(&mut white);
        white
    }

    /// The baseline under the residual `rest` of the used points: one coefficient per column.
    #[must_use]
    pub fn baseline(&self, rest: &[f64]) -> Vec<f64> {
        if self.columns.is_empty() {
            return Vec::new();
        }
        let columns: Vec<DVector<f64>> =
            self.columns.iter().map(|column| DVector::from_vec(self.whitened(column))).collect();
        let matrix = DMatrix::from_columns(&columns);
        let rest = DVector::from_vec(self.whitened(rest));
        let solved = matrix.svd(true, true).solve(&rest, 1e-10);
        solved.map_or_else(|_| vec![0.0; columns.len()], |found| found.as_slice().to_vec())
    }
}

/// Deviation of what comes new over a gap of `steps` rows in units of that of one: √((1 − ρ^{2g})/(1 − ρ²)).
#[must_use]
pub fn over_gap(steps: i32, rho: f64) -> f64 {
    ((1.0 - rho.powi(steps).powi(2)) / (1.0 - rho * rho)).sqrt()
}

/// Sums side by side, so that none waits for the one before it.
const SIDE_BY_SIDE: usize = 8;

/// Σ a b.
#[must_use]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let count = a.len().min(b.len());
    let whole = count - count % SIDE_BY_SIDE;
    let mut sums = [0.0; SIDE_BY_SIDE];
    for start in (0..whole).step_by(SIDE_BY_SIDE) {
        let (a, b) = (&a[start..start + SIDE_BY_SIDE], &b[start..start + SIDE_BY_SIDE]);
        for (k, sum) in sums.iter_mut().enumerate() {
            *sum += a[k] * b[k];
        }
    }
    sums.iter().sum::<f64>() + a[whole..count].iter().zip(&b[whole..count]).map(|(a, b)| a * b).sum::<f64>()
}
