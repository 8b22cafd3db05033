//! Relaxation spectra from storage and loss moduli over frequency.
//!
//! G′(ω) = G∞ + Σ g_k ω²τ_k²/(1 + ω²τ_k²), G″(ω) = Σ g_k ωτ_k/(1 + ω²τ_k²) with times τ_k [s] on a logarithmic grid and moduli
//! g_k ≥ 0 [Pa] that are sought for (Lawson & Hanson 1974). Second differences of the spectrum, each modulus relative to
//! |G*| at its frequency, are kept small by as much as foretells left-out data best (generalised cross validation,
//! Golub, Heath & Wahba 1979).
//!
//! # Examples
//! ```
//! use springbed::fit::prony::Moduli;
//!
//! // G∞ = 1 Pa and 10 Pa with 0.1 s, ten frequencies per decade.
//! let frequency: Vec<f64> = (0..40).map(|k| 0.01 * 10f64.powf(0.1 * f64::from(k))).collect();
//! let x = |f: f64| std::f64::consts::TAU * f * 0.1;
//! let storage = frequency.iter().map(|&f| 1.0 + 10.0 * x(f).powi(2) / (1.0 + x(f).powi(2))).collect();
//! let loss = frequency.iter().map(|&f| 10.0 * x(f) / (1.0 + x(f).powi(2))).collect();
//! let spectrum = Moduli { frequency, storage, loss }.spectrum()?;
//! // One time is spread over its neighbours on the grid: half a percent.
//! let (storage, loss) = spectrum.at(1.0);
//! assert!((storage / (1.0 + 10.0 * x(1.0).powi(2) / (1.0 + x(1.0).powi(2))) - 1.0).abs() < 5e-3);
//! assert!((loss / (10.0 * x(1.0) / (1.0 + x(1.0).powi(2))) - 1.0).abs() < 5e-3);
//! # Ok::<(), springbed::fit::FitError>(())
//! ```

use super::FitError;
use nalgebra::{DMatrix, DVector};
use ndarray::{Array1, Array2};
use std::f64::consts::TAU;

/// Storage and loss moduli that were measured.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Moduli {
    /// Frequencies [Hz].
    pub frequency: Vec<f64>,
    /// Storage moduli G′ [Pa].
    pub storage: Vec<f64>,
    /// Loss moduli G″ [Pa].
    pub loss: Vec<f64>,
}

/// A relaxation spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// G∞ [Pa].
    pub equilibrium: f64,
    /// Modulus g [Pa] and time τ [s] of each term, times rising.
    pub terms: Vec<(f64, f64)>,
    /// Root of the mean square of the relative residuals.
    pub deviation: f64,
    /// How strongly it was smoothed: weight of second differences beside relative residuals.
    pub smoothing: f64,
}

/// Terms per decade of time.
const PER_DECADE: f64 = 4.0;
/// Decades by which the times go beyond the frequencies on each side.
const BEYOND: f64 = 0.5;
/// Smoothings tried: ten per power of ten would be no better.
const SMOOTHINGS: [f64; 10] = [1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3];
/// Part of |G*| below which a modulus is not weighed relative to itself.
const SMALL: f64 = 1e-2;
/// Points it takes.
const LEAST: usize = 4;

impl Spectrum {
    /// G′ and G″ [Pa] at the frequency `frequency` [Hz].
    #[must_use]
    pub fn at(&self, frequency: f64) -> (f64, f64) {
        let parts = self.terms.iter().map(|&(modulus, time)| {
            let (storage, loss) = kernel(frequency, time);
            (modulus * storage, modulus * loss)
        });
        parts.fold((self.equilibrium, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1))
    }
}

/// Shares ω²τ²/(1 + ω²τ²) and ωτ/(1 + ω²τ²).
fn kernel(frequency: f64, time: f64) -> (f64, f64) {
    let x = TAU * frequency * time;
    (x / (x + 1.0 / x), 1.0 / (x + 1.0 / x))
}

/// A problem of moduli: A x = b with relative residuals, x in units of |G*|.
#[derive(Clone)]
pub(super) struct System {
    times: Vec<f64>,
    /// |G*| at the frequency of each unknown, that of equilibrium first.
    sizes: Vec<f64>,
    matrix: DMatrix<f64>,
    right: Vec<f64>,
}

impl Moduli {
    /// The spectrum that explains the moduli.
    ///
    /// # Errors
    /// There are too few points, or one is not above zero.
    pub fn spectrum(&self) -> Result<Spectrum, FitError> {
        self.checked()?;
        let system = System::of(self);
        let pressed = system.pressed();
        let tried = SMOOTHINGS.iter().map(|&smoothing| (smoothing, pressed.solved(&system, smoothing)));
        let best = tried.min_by(|a, b| a.1.foretold.total_cmp(&b.1.foretold));
        let (smoothing, solved) = best.ok_or_else(|| FitError::Data("there is nothing to smooth".to_owned()))?;
        let moduli: Vec<f64> = solved.x.iter().zip(&system.sizes).map(|(x, size)| x * size).collect();
        let terms = moduli[1..].iter().copied().zip(system.times.iter().copied()).filter(|term| term.0 > 0.0);
        Ok(Spectrum { equilibrium: moduli[0], terms: terms.collect(), deviation: solved.deviation, smoothing })
    }

    fn checked(&self) -> Result<(), FitError> {
        let count = self.frequency.len();
        if count < LEAST || self.storage.len() != count || self.loss.len() != count {
            let what = format!("{count} frequencies with their moduli: expected at least {LEAST}");
            return Err(FitError::Data(what));
        }
        let all = self.frequency.iter().chain(&self.storage).chain(&self.loss);
        match all.into_iter().find(|value| !(**value > 0.0 && value.is_finite())) {
            None => Ok(()),
            Some(value) => {
                Err(FitError::Data(format!("{value:?} among frequencies and moduli: expected numbers above zero")))
            }
        }
    }

    fn size(&self, at: usize) -> f64 {
        self.storage[at].hypot(self.loss[at])
    }

    /// What both moduli of a point are multiplied by: relative to themselves, or to a part of |G*| where they are smaller.
    pub(super) fn weights(&self, at: usize) -> (f64, f64) {
        let weight = |value: f64| 1.0 / value.max(SMALL * self.size(at));
        (weight(self.storage[at]), weight(self.loss[at]))
    }

    /// |G*| [Pa] of the point whose frequency is nearest to `frequency` [Hz].
    fn size_near(&self, frequency: f64) -> f64 {
        let far = |at: &usize| (self.frequency[*at] / frequency).ln().abs();
        let nearest = (0..self.frequency.len()).min_by(|a, b| far(a).total_cmp(&far(b)));
        nearest.map_or(1.0, |at| self.size(at))
    }
}

/// What comes of a smoothing.
struct Solved {
    x: Vec<f64>,
    deviation: f64,
    /// Mean square by which a point left out would be missed.
    foretold: f64,
}

impl System {
    pub(super) fn of(moduli: &Moduli) -> Self {
        let ends = moduli.frequency.iter().fold((f64::MAX, 0.0f64), |(low, high), &f| (low.min(f), high.max(f)));
        let (first, last) = ((1.0 / (TAU * ends.1)).log10() - BEYOND, (1.0 / (TAU * ends.0)).log10() + BEYOND);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few decades of finite numbers")]
        let count = ((last - first) * PER_DECADE).ceil() as usize + 1;
        let times: Vec<f64> =
            (0..count).map(|k| 10f64.powf(first + (last - first) * k as f64 / (count - 1) as f64)).collect();
        let sizes: Vec<f64> = std::iter::once(moduli.size_near(ends.0))
            .chain(times.iter().map(|time| moduli.size_near(1.0 / (TAU * time))))
            .collect();
        Self { times, sizes, matrix: DMatrix::zeros(0, 0), right: Vec::new() }.at(moduli)
    }

    /// The same times for moduli at other frequencies.
    pub(super) fn at(&self, moduli: &Moduli) -> Self {
        let points = moduli.frequency.len();
        let matrix = self.table(moduli, (1.0, 0.0), kernel);
        let storage = (0..points).map(|at| moduli.storage[at] * moduli.weights(at).0);
        let loss = (0..points).map(|at| moduli.loss[at] * moduli.weights(at).1);
        Self { times: self.times.clone(), sizes: self.sizes.clone(), matrix, right: storage.chain(loss).collect() }
    }

    /// Slopes of the matrix in ln f.
    pub(super) fn growth(&self, moduli: &Moduli) -> DMatrix<f64> {
        self.table(moduli, (0.0, 0.0), |frequency, time| {
            let (storage, loss) = kernel(frequency, time);
            (2.0 * loss * loss, loss * (1.0 - 2.0 * storage))
        })
    }

    /// What each term gives to both moduli of each point, weighted; that of equilibrium first.
    fn table(&self, moduli: &Moduli, equilibrium: (f64, f64), of: fn(f64, f64) -> (f64, f64)) -> DMatrix<f64> {
        let points = moduli.frequency.len();
        DMatrix::from_fn(2 * points, self.sizes.len(), |row, column| {
            let at = row % points;
            let (storage, loss) = match column.checked_sub(1) {
                None => equilibrium,
                Some(term) => of(moduli.frequency[at], self.times[term]),
            };
            let weights = moduli.weights(at);
            (if row < points { storage * weights.0 } else { loss * weights.1 }) * self.sizes[column]
        })
    }

    /// What the smoothed spectrum leaves, its bends below, and the slopes of that in the shifts of groups of rows, the
    /// spectrum projected out.
    pub(super) fn left(
        &self,
        smoothing: f64,
        growth: &DMatrix<f64>,
        groups: &[Vec<bool>],
    ) -> (DVector<f64>, DMatrix<f64>) {
        let x = DVector::from_vec(self.solved(smoothing).x);
        let (rows, columns) = self.matrix.shape();
        let bends = columns.saturating_sub(3);
        let entry = |row: usize, column: usize| {
            if row < rows { self.matrix[(row, column)] } else { smoothing * self.bend(row - rows, column) }
        };
        let whole = DMatrix::from_fn(rows + bends, columns, entry);
        let right = DVector::from_fn(rows + bends, |row, _| self.right.get(row).copied().unwrap_or(0.0));
        let kept: Vec<usize> = (0..columns).filter(|&column| x[column] > 0.0).collect();
        let basis = whole.select_columns(&kept).qr().q();
        let moved = growth * &x;
        let mut slopes = DMatrix::from_fn(rows + bends, groups.len(), |row, group| {
            if row < rows && groups[group][row] { -moved[row] } else { 0.0 }
        });
        slopes -= &basis * (basis.transpose() * &slopes);
        (right - whole * x, slopes)
    }

    /// Second differences of the terms; that of equilibrium is free.
    fn bend(&self, row: usize, column: usize) -> f64 {
        match column.wrapping_sub(row + 1) {
            0 | 2 => 1.0,
            1 => -2.0,
            _ => 0.0,
        }
    }

    fn solved(&self, smoothing: f64) -> Solved {
        self.pressed().solved(self, smoothing)
    }

    /// The same problem in as few rows as it has unknowns.
    fn pressed(&self) -> Pressed {
        let qr = self.matrix.clone().qr();
        let right = qr.q().transpose() * DVector::from_column_slice(&self.right);
        Pressed { matrix: qr.r(), right, normal: self.matrix.transpose() * &self.matrix }
    }
}

/// A system QR x = b as R x = Qᵀb: what is left differs by what no x can reach.
struct Pressed {
    /// R.
    matrix: DMatrix<f64>,
    /// Qᵀb.
    right: DVector<f64>,
    /// AᵀA.
    normal: DMatrix<f64>,
}

impl Pressed {
    fn solved(&self, system: &System, smoothing: f64) -> Solved {
        let (rows, columns) = self.matrix.shape();
        let bends = columns.saturating_sub(3);
        let whole = Array2::from_shape_fn((rows + bends, columns), |(row, column)| {
            if row < rows { self.matrix[(row, column)] } else { smoothing * system.bend(row - rows, column) }
        });
        let right = Array1::from_shape_fn(rows + bends, |row| if row < rows { self.right[row] } else { 0.0 });
        let (x, _) = nnls::nnls(whole.view(), right.view());
        let x = DVector::from_vec(x.to_vec());
        let squares = (DVector::from_column_slice(&system.right) - &system.matrix * &x).norm_squared();
        let count = system.right.len() as f64;
        let free = (count - self.freedom((system, x.as_slice()), smoothing)).max(1.0);
        let foretold = squares * count / (free * free);
        Solved { x: x.as_slice().to_vec(), deviation: (squares / count).sqrt(), foretold }
    }

    /// Effective number of parameters: tr A(AᵀA + λ²DᵀD)⁻¹Aᵀ over the terms above zero.
    fn freedom(&self, (system, x): (&System, &[f64]), smoothing: f64) -> f64 {
        let kept: Vec<usize> = (0..x.len()).filter(|&column| x[column] > 0.0).collect();
        if kept.is_empty() {
            return 0.0;
        }
        let bends = system.sizes.len().saturating_sub(3);
        let bend = DMatrix::from_fn(bends, kept.len(), |row, column| smoothing * system.bend(row, kept[column]));
        let normal = self.normal.select_rows(&kept).select_columns(&kept);
        let whole = &normal + bend.transpose() * &bend;
        whole.cholesky().map_or(kept.len() as f64, |root| root.solve(&normal).trace())
    }
}
