//! The fewest terms of a Prony series that explain moduli over frequency.
//!
//! For n = 1, 2, … terms moduli and times are searched for together, on logarithmic scales and from times spread evenly
//! over the smooth spectrum; n + 1 terms are worth it while they lower Akaike's criterion for small samples,
//! N ln(S/N) + 2p + 2p(p + 1)/(N − p − 1) with p = 2n + 1 (Hurvich & Tsai 1989).

use super::FitError;
use super::prony::{Moduli, Spectrum};
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};
use std::f64::consts::TAU;

/// How many terms a spectrum is to have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Terms {
    /// As many as the data are worth.
    Fewest,
    /// This many.
    Exactly(usize),
}

impl std::str::FromStr for Terms {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match (text, text.parse()) {
            ("fewest", _) => Ok(Self::Fewest),
            (_, Ok(count)) if (1..=MOST).contains(&count) => Ok(Self::Exactly(count)),
            _ => Err(format!("expected fewest, or a number from 1 to {MOST}")),
        }
    }
}

/// The most terms tried.
const MOST: usize = 24;
/// Numbers of terms tried in vain after which the search ends.
const IN_VAIN: usize = 2;
/// Relative residual beyond which no more is asked: digits of the data.
const EXACT: f64 = 1e-9;
/// Relative change at which a search ends.
const TOLERANCE: f64 = 1e-14;

impl Moduli {
    /// The spectrum of few terms that explains the moduli.
    ///
    /// # Errors
    /// As of [`spectrum`](Moduli::spectrum); more terms than the data can tell.
    pub fn spectrum_of(&self, terms: Terms) -> Result<Spectrum, FitError> {
        let smooth = self.spectrum()?;
        let most = (2 * self.frequency.len()).saturating_sub(3) / 2;
        match terms {
            Terms::Exactly(count) if count > most => {
                let what = format!("{count} terms of {} frequencies: expected at most {most}", self.frequency.len());
                Err(FitError::Data(what))
            }
            Terms::Exactly(count) => Ok(self.searched(&spread(&smooth, count), smooth.equilibrium)),
            Terms::Fewest => Ok(self.fewest(&smooth, most.min(MOST))),
        }
    }

    fn fewest(&self, smooth: &Spectrum, most: usize) -> Spectrum {
        let mut best: Option<(f64, Spectrum)> = None;
        let mut in_vain = 0;
        for count in 1..=most {
            let found = self.searched(&spread(smooth, count), smooth.equilibrium);
            let criterion = self.criterion(&found, count);
            let exact = found.deviation < EXACT;
            if best.as_ref().is_none_or(|(least, _)| criterion < *least) {
                (best, in_vain) = (Some((criterion, found)), 0);
            } else {
                in_vain += 1;
            }
            if exact || in_vain >= IN_VAIN {
                break;
            }
        }
        best.map_or_else(|| smooth.clone(), |(_, found)| found)
    }

    fn criterion(&self, found: &Spectrum, count: usize) -> f64 {
        let (points, free) = (2.0 * self.frequency.len() as f64, 2.0 * count as f64 + 1.0);
        let corrected = 2.0 * free * (1.0 + (free + 1.0) / (points - free - 1.0).max(0.5));
        2.0 * points * found.deviation.max(f64::MIN_POSITIVE).ln() + corrected
    }

    /// The spectrum nearest to the moduli, searched for from `terms` on.
    fn searched(&self, terms: &[(f64, f64)], equilibrium: f64) -> Spectrum {
        let size = terms.iter().map(|term| term.0).sum::<f64>() + equilibrium;
        let logs = terms.iter().flat_map(|&(modulus, time)| [modulus.max(1e-6 * size).ln(), time.ln()]);
        let here: Vec<f64> = std::iter::once(equilibrium.max(1e-9 * size).ln()).chain(logs).collect();
        let search = Search { moduli: self, here: DVector::from_vec(here) };
        let rule = LevenbergMarquardt::new().with_ftol(TOLERANCE).with_xtol(TOLERANCE).with_gtol(TOLERANCE);
        let (search, report) = rule.with_patience(60).minimize(search);
        let mut found = search.spectrum();
        found.deviation = (2.0 * report.objective_function / (2 * self.frequency.len()) as f64).sqrt();
        found
    }
}

/// `count` terms that share the moduli of a spectrum evenly, each in the middle of its share.
fn spread(smooth: &Spectrum, count: usize) -> Vec<(f64, f64)> {
    let weights: Vec<f64> = smooth.terms.iter().map(|&(modulus, _)| modulus.sqrt()).collect();
    let whole: f64 = weights.iter().sum();
    let mut shares = vec![(0.0, 0.0, 0.0); count];
    let mut before = 0.0;
    for (&(modulus, time), weight) in smooth.terms.iter().zip(&weights) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a part of a small number")]
        let at = (((before + 0.5 * weight) / whole * count as f64) as usize).min(count - 1);
        before += weight;
        let share = &mut shares[at];
        *share = (share.0 + modulus, share.1 + weight * time.ln(), share.2 + weight);
    }
    let ends =
        (smooth.terms.first().map_or(1.0, |term| term.1).ln(), smooth.terms.last().map_or(1.0, |term| term.1).ln());
    let middle = |at: usize| ends.0 + (ends.1 - ends.0) * (at as f64 + 0.5) / count as f64;
    let term = |(at, &(modulus, sum, weight)): (usize, &(f64, f64, f64))| {
        let time = if weight > 0.0 { sum / weight } else { middle(at) };
        (modulus, time.exp())
    };
    shares.iter().enumerate().map(term).collect()
}

/// ln G∞, and ln g and ln τ of each term.
struct Search<'m> {
    moduli: &'m Moduli,
    here: DVector<f64>,
}

impl Search<'_> {
    fn spectrum(&self) -> Spectrum {
        let mut terms: Vec<(f64, f64)> =
            self.here.as_slice()[1..].chunks(2).map(|pair| (pair[0].exp(), pair[1].exp())).collect();
        terms.sort_by(|a, b| a.1.total_cmp(&b.1));
        Spectrum { equilibrium: self.here[0].exp(), terms, deviation: 0.0, smoothing: 0.0 }
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Search<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        self.here.copy_from(x);
    }

    fn params(&self) -> DVector<f64> {
        self.here.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let (spectrum, moduli) = (self.spectrum(), self.moduli);
        let points = moduli.frequency.len();
        let model: Vec<(f64, f64)> = moduli.frequency.iter().map(|&f| spectrum.at(f)).collect();
        let rest = |row: usize| {
            let (at, (storage, loss)) = (row % points, moduli.weights(row % points));
            if row < points {
                storage * (moduli.storage[at] - model[at].0)
            } else {
                loss * (moduli.loss[at] - model[at].1)
            }
        };
        let rest = DVector::from_fn(2 * points, |row, _| rest(row));
        rest.iter().all(|value| value.is_finite()).then_some(rest)
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let (moduli, points) = (self.moduli, self.moduli.frequency.len());
        let entry = |row: usize, column: usize| {
            let at = row % points;
            let (storage, loss) = moduli.weights(at);
            let slope = match column.checked_sub(1) {
                None => (self.here[0].exp(), 0.0),
                Some(number) => {
                    let (modulus, time) = (self.here[1 + number / 2 * 2].exp(), self.here[2 + number / 2 * 2].exp());
                    let x = TAU * moduli.frequency[at] * time;
                    // x²/(1 + x²) and x/(1 + x²), and their slopes in ln x.
                    let (up, peak) = (x / (x + 1.0 / x), 1.0 / (x + 1.0 / x));
                    let rate = (2.0 * peak * peak, peak * (1.0 - 2.0 * up));
                    let of = if number % 2 == 0 { (up, peak) } else { rate };
                    (modulus * of.0, modulus * of.1)
                }
            };
            if row < points { -storage * slope.0 } else { -loss * slope.1 }
        };
        Some(DMatrix::from_fn(2 * points, self.here.len(), entry))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moduli(terms: &[(f64, f64)], equilibrium: f64, noise: impl Fn(usize) -> f64) -> Moduli {
        let truth = Spectrum { equilibrium, terms: terms.to_vec(), deviation: 0.0, smoothing: 0.0 };
        let frequency: Vec<f64> = (0..60).map(|k| 1e-3 * 10f64.powf(0.1 * f64::from(k))).collect();
        let (storage, loss): (Vec<f64>, Vec<f64>) = frequency.iter().map(|&f| truth.at(f)).unzip();
        let with = |values: Vec<f64>, from: usize| {
            values.into_iter().enumerate().map(|(at, value)| value * (1.0 + noise(at + from))).collect()
        };
        Moduli { storage: with(storage, 0), loss: with(loss, 60), frequency }
    }

    #[test]
    fn terms_without_noise_are_found_again() {
        let truth = [(1e6, 1e-3), (4e6, 0.02), (5e5, 0.6), (2e5, 10.0)];
        let found = moduli(&truth, 1e5, |_| 0.0).spectrum_of(Terms::Fewest).unwrap();
        assert_eq!(found.terms.len(), 4, "{found:?}");
        for (one, right) in found.terms.iter().zip(truth) {
            assert!((one.0 / right.0 - 1.0).abs() < 1e-6 && (one.1 / right.1 - 1.0).abs() < 1e-6, "{found:?}");
        }
        assert!((found.equilibrium / 1e5 - 1.0).abs() < 1e-6);
    }

    /// Noise of a per cent is not taken for terms, and what is found is as near as the noise lets it be.
    #[test]
    fn noise_is_not_taken_for_terms() {
        let truth = [(1e6, 1e-2), (3e5, 1.0)];
        let noise = |at: usize| 0.01 * ((at * at) as f64 * 0.7 + at as f64).sin();
        let data = moduli(&truth, 2e5, noise);
        let found = data.spectrum_of(Terms::Fewest).unwrap();
        assert_eq!(found.terms.len(), 2, "{found:?}");
        for (one, right) in found.terms.iter().zip(truth) {
            assert!((one.0 / right.0 - 1.0).abs() < 0.02 && (one.1 / right.1 - 1.0).abs() < 0.02, "{found:?}");
        }
        let three = data.spectrum_of(Terms::Exactly(3)).unwrap();
        assert!(three.terms.len() == 3 && three.deviation <= found.deviation * (1.0 + 1e-9), "{three:?}");
        assert!(data.spectrum_of(Terms::Exactly(59)).is_err());
    }
}
