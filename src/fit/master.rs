//! One curve of moduli from several temperatures: shift factors, and the law of Williams, Landel & Ferry through them.
//!
//! All relaxation times of a thermorheologically simple material go with one factor a_T, so that G*(ω, T) = G*(a_T ω, T_r).
//! First each temperature is laid over its neighbour, then all shifts are searched for together so that one smooth
//! spectrum explains all moduli (the spectrum is projected out: Kaufman 1975). C₁ and C₂ of
//! log₁₀ a_T = −C₁(T − T_r)/(C₂ + T − T_r) (J. Am. Chem. Soc. 77, 3701, 1955, eq. 20) follow by least squares.
//! On request moduli are shifted too, by b_T = T/T_r (Ferry 1980, *Viscoelastic Properties of Polymers*, ch. 11; the density
//! as constant), as those of networks are whose stiffness is one of entropy.

use super::FitError;
use super::prony::{Moduli, Spectrum, System};
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};
use std::f64::consts::LN_10;

/// Moduli over frequency at several temperatures.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sweeps {
    /// The moduli.
    pub moduli: Moduli,
    /// Temperatures [K], one per frequency.
    pub temperature: Vec<f64>,
    /// Whether the moduli go with the temperature, b_T = T/T_r.
    pub entropic: bool,
}

/// A master curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Master {
    /// Reference temperature T_r [K].
    pub reference: f64,
    /// Temperatures [K], rising, and log₁₀ a_T of each.
    pub shifts: Vec<(f64, f64)>,
    /// Standard errors of log₁₀ a_T, in the same order, by what one spectrum leaves of all moduli; zero at the reference.
    pub errors: Vec<f64>,
    /// b_T of each, in the same order: one where the moduli do not go with the temperature.
    pub vertical: Vec<f64>,
    /// C₁ and C₂ [K] of Williams, Landel & Ferry; `None` where the shifts have no such law.
    pub wlf: Option<(f64, f64)>,
    /// The moduli, over b_T if they go with the temperature, over reduced frequencies a_T f.
    pub reduced: Moduli,
    /// The spectrum at the reference temperature.
    pub spectrum: Spectrum,
}

impl Master {
    /// log₁₀ a_T of the law at the temperature `t` [K]; `None` without a law.
    #[must_use]
    pub fn law(&self, t: f64) -> Option<f64> {
        let by = t - self.reference;
        self.wlf.map(|(c1, c2)| 0.0 - c1 * by / (c2 + by))
    }
}

/// Temperatures nearer than this [K] are one.
const APART: f64 = 1.0;
/// Shifts tried between neighbours, and steps by which the best is refined.
const TRIED: usize = 240;
const REFINED: usize = 50;
/// Points of neighbours that must lie over each other.
const OVER: usize = 3;
/// Relative change at which the search ends.
const TOLERANCE: f64 = 1e-10;

impl Sweeps {
    /// Whether there is more than one temperature.
    #[must_use]
    pub fn differ(&self) -> bool {
        self.groups().1.len() > 1
    }

    /// The master curve at the measured temperature nearest to `reference` [K]; at the middle one if that is `None`.
    ///
    /// # Errors
    /// There are too few points or temperatures; neighbours do not overlap.
    pub fn master(&self, reference: Option<f64>) -> Result<Master, FitError> {
        if self.temperature.len() != self.moduli.frequency.len() {
            return Err(FitError::Data("there is not one temperature per frequency".to_owned()));
        }
        if let Some(bad) = self.temperature.iter().find(|t| !(**t > 0.0 && t.is_finite())) {
            return Err(FitError::Data(format!("a temperature of {bad:?} K: expected one above zero")));
        }
        let (groups, means) = self.groups();
        if means.len() < 2 {
            return Err(FitError::Data("all moduli are of one temperature: expected several".to_owned()));
        }
        let far = |at: &usize| reference.map_or(0.0, |wanted| (means[*at] - wanted).abs());
        let nearest = (0..means.len()).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0);
        let zero = if reference.is_some() { nearest } else { means.len() / 2 };
        let level = if self.entropic { self.levelled(&groups, &means, means[zero]) } else { self.clone() };
        let logs = level.laid(&groups, means.len(), zero)?;
        let (logs, errors) = level.searched(&groups, logs, zero)?;
        let reduced = level.shifted(&groups, &logs);
        let spectrum = reduced.spectrum()?;
        let shifts: Vec<(f64, f64)> = means.iter().copied().zip(logs.iter().map(|log| log / LN_10)).collect();
        let factor = |t: &f64| if self.entropic { t / means[zero] } else { 1.0 };
        let (vertical, wlf) = (means.iter().map(factor).collect(), wlf(&shifts, means[zero]));
        Ok(Master { reference: means[zero], wlf, shifts, errors, vertical, reduced, spectrum })
    }

    /// Moduli over b_T, as they would be at the temperature `reference` [K].
    fn levelled(&self, groups: &[usize], means: &[f64], reference: f64) -> Self {
        let over = |moduli: &[f64]| {
            moduli.iter().zip(groups).map(|(modulus, &group)| modulus * (reference / means[group])).collect()
        };
        let (storage, loss) = (over(&self.moduli.storage), over(&self.moduli.loss));
        Self { moduli: Moduli { storage, loss, ..self.moduli.clone() }, ..self.clone() }
    }

    /// The number of the temperature of each point, and the temperatures, rising.
    fn groups(&self) -> (Vec<usize>, Vec<f64>) {
        let mut order: Vec<usize> = (0..self.temperature.len()).collect();
        order.sort_by(|&a, &b| self.temperature[a].total_cmp(&self.temperature[b]));
        let mut groups = vec![0; order.len()];
        let mut members: Vec<Vec<f64>> = Vec::new();
        for at in order {
            let here = self.temperature[at];
            match members.last_mut().filter(|group| group.last().is_some_and(|last| here - last < APART)) {
                Some(group) => group.push(here),
                None => members.push(vec![here]),
            }
            groups[at] = members.len() - 1;
        }
        let mean = |group: &Vec<f64>| group.iter().sum::<f64>() / group.len() as f64;
        (groups, members.iter().map(mean).collect())
    }

    /// Frequencies times their factors, ln a_T by the number of the temperature.
    fn shifted(&self, groups: &[usize], logs: &[f64]) -> Moduli {
        let frequency = self.moduli.frequency.iter().zip(groups).map(|(f, &group)| f * logs[group].exp());
        Moduli { frequency: frequency.collect(), ..self.moduli.clone() }
    }

    /// ln f, ln G′ and ln G″ of a temperature, by rising frequency.
    fn curve(&self, groups: &[usize], group: usize) -> Vec<[f64; 3]> {
        let Moduli { frequency, storage, loss } = &self.moduli;
        let members = (0..groups.len()).filter(|&at| groups[at] == group);
        let mut curve: Vec<[f64; 3]> =
            members.map(|at| [frequency[at].ln(), storage[at].ln(), loss[at].ln()]).collect();
        curve.sort_by(|a, b| a[0].total_cmp(&b[0]));
        curve
    }

    /// ln a_T of all temperatures, each laid over its neighbour on the side of the reference.
    fn laid(&self, groups: &[usize], count: usize, zero: usize) -> Result<Vec<f64>, FitError> {
        let mut logs = vec![0.0; count];
        let up = (zero + 1..count).map(|at| (at, at - 1));
        let down = (0..zero).rev().map(|at| (at, at + 1));
        for (at, beside) in up.chain(down) {
            let (here, known) = (self.curve(groups, at), self.curve(groups, beside));
            let by = overlap(&here, &known).ok_or_else(|| {
                FitError::Data(format!(
                    "the moduli of the temperatures number {at} and {beside} have nothing in common: expected curves that overlap"
                ))
            })?;
            logs[at] = logs[beside] + by;
        }
        Ok(logs)
    }

    /// ln a_T with which one spectrum explains all moduli best, and the standard errors of log₁₀ a_T.
    fn searched(&self, groups: &[usize], logs: Vec<f64>, zero: usize) -> Result<(Vec<f64>, Vec<f64>), FitError> {
        let laid = self.shifted(groups, &logs);
        let smoothing = laid.spectrum()?.smoothing;
        let moving: Vec<usize> = (0..logs.len()).filter(|&at| at != zero).collect();
        let here = DVector::from_iterator(moving.len(), moving.iter().map(|&at| logs[at]));
        let mut search =
            Search { sweeps: self, groups, plain: System::of(&laid), smoothing, moving, logs, here, state: None };
        search.look();
        let rule = LevenbergMarquardt::new().with_ftol(TOLERANCE).with_xtol(TOLERANCE).with_gtol(1e-14);
        let mut search = rule.with_patience(20).minimize(search).0;
        search.look();
        let errors = search.errors();
        Ok((search.logs, errors))
    }
}

/// How far the curve `here` has to be moved along ln f to lie over `known`.
fn overlap(here: &[[f64; 3]], known: &[[f64; 3]]) -> Option<f64> {
    let (low, high) = (known.first()?[0] - here.last()?[0], known.last()?[0] - here.first()?[0]);
    let miss = |by: f64| {
        let apart: Vec<f64> = here
            .iter()
            .filter_map(|point| {
                between(known, point[0] + by).map(|at| (at[1] - point[1]).powi(2) + (at[2] - point[2]).powi(2))
            })
            .collect();
        let enough = apart.len() >= OVER.min(here.len());
        enough.then(|| apart.iter().sum::<f64>() / apart.len() as f64)
    };
    let step = (high - low) / TRIED as f64;
    let tried = (0..=TRIED).filter_map(|k| Some((miss(low + step * k as f64)?, low + step * k as f64)));
    let (mut least, mut best) = tried.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let mut step = 0.5 * step;
    for _ in 0..REFINED {
        for by in [best - step, best + step] {
            if let Some(found) = miss(by).filter(|found| *found < least) {
                (least, best) = (found, by);
            }
        }
        step *= 0.7;
    }
    Some(best)
}

/// A curve at ln f, straight between its points; `None` beyond its ends.
fn between(curve: &[[f64; 3]], x: f64) -> Option<[f64; 3]> {
    let after = curve.partition_point(|point| point[0] < x);
    let (a, b) = (curve.get(after.checked_sub(1)?)?, curve.get(after)?);
    let share = (x - a[0]) / (b[0] - a[0]);
    Some([x, a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])])
}

/// C₁ and C₂ by least squares of log a (C₂ + ΔT) = −C₁ΔT; `None` where they have not the signs of a law.
fn wlf(shifts: &[(f64, f64)], reference: f64) -> Option<(f64, f64)> {
    let rows: Vec<(f64, f64, f64)> =
        shifts.iter().map(|&(t, log)| (t - reference, log)).map(|(by, log)| (by, log, -log * by)).collect();
    let sum = |of: fn(&(f64, f64, f64)) -> f64| rows.iter().map(of).sum::<f64>();
    let (aa, ab, bb) = (sum(|r| r.0 * r.0), sum(|r| r.0 * r.1), sum(|r| r.1 * r.1));
    let (ay, by) = (sum(|r| r.0 * r.2), sum(|r| r.1 * r.2));
    let whole = aa * bb - ab * ab;
    let (c1, c2) = ((ay * bb - by * ab) / whole, (aa * by - ab * ay) / whole);
    let lowest = shifts.first()?.0 - reference;
    (shifts.len() > 2 && c1 > 0.0 && c2 + lowest > 0.0 && c2.is_finite()).then_some((c1, c2))
}

/// A search for shifts under way.
struct Search<'s> {
    sweeps: &'s Sweeps,
    groups: &'s [usize],
    /// The system of the first guess: its times stay.
    plain: System,
    smoothing: f64,
    /// Temperatures whose shifts are sought for.
    moving: Vec<usize>,
    logs: Vec<f64>,
    here: DVector<f64>,
    state: Option<(DVector<f64>, DMatrix<f64>)>,
}

impl Search<'_> {
    /// Standard errors of log₁₀ a_T: of the slopes J the inverse of JᵀJ, times the mean square of what is left of the moduli.
    fn errors(&self) -> Vec<f64> {
        let mut errors = vec![0.0; self.logs.len()];
        let Some((rest, slopes)) = &self.state else { return errors };
        let rows = 2 * self.groups.len();
        let squares: f64 = rest.iter().take(rows).map(|x| x * x).sum();
        let variance = squares / rows.saturating_sub(self.moving.len()).max(1) as f64;
        if let Some(root) = (slopes.transpose() * slopes).cholesky() {
            let inverse = root.inverse();
            for (at, &group) in self.moving.iter().enumerate() {
                errors[group] = (variance * inverse[(at, at)]).sqrt() / LN_10;
            }
        }
        errors
    }

    /// What is left at the present shifts, and its slopes.
    fn look(&mut self) {
        let moduli = self.sweeps.shifted(self.groups, &self.logs);
        let system = self.plain.at(&moduli);
        let points = moduli.frequency.len();
        let groups = self
            .moving
            .iter()
            .map(|&group| (0..2 * points).map(|row| self.groups[row % points] == group).collect::<Vec<bool>>());
        self.state = Some(system.left(self.smoothing, &system.growth(&moduli), &groups.collect::<Vec<_>>()));
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Search<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        self.here.copy_from(x);
        for (&group, &log) in self.moving.iter().zip(x) {
            self.logs[group] = log;
        }
        self.look();
    }

    fn params(&self) -> DVector<f64> {
        self.here.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        self.state.as_ref().map(|(rest, _)| rest.clone())
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        self.state.as_ref().map(|(_, slopes)| slopes.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Five temperatures of a material of known spectrum and shift.
    fn sweeps(noise: f64) -> (Sweeps, impl Fn(f64) -> f64) {
        let log = |t: f64| -8.86 * (t - 300.0) / (101.6 + t - 300.0);
        let terms = (0..14).map(|k| (1e8 * 0.35f64.powi(k), 10f64.powf(-7.0 + 0.8 * f64::from(k)))).collect();
        let truth = Spectrum { equilibrium: 2e5, terms, deviation: 0.0, smoothing: 0.0 };
        let mut all = Sweeps::default();
        for (number, t) in [260.0, 280.0, 300.0, 320.0, 340.0].into_iter().enumerate() {
            for k in 0..24 {
                let f = 0.01 * 10f64.powf(0.17 * f64::from(k));
                let (storage, loss) = truth.at(f * 10f64.powf(log(t)));
                let odd = |n: usize| 1.0 + noise * ((n * n) as f64 * 0.7 + n as f64).sin();
                let at = 24 * number + usize::try_from(k).unwrap();
                all.moduli.frequency.push(f);
                all.moduli.storage.push(storage * odd(at));
                all.moduli.loss.push(loss * odd(at + 500));
                all.temperature.push(t + 0.1 * f64::from(k % 3 - 1));
            }
        }
        (all, log)
    }

    #[test]
    fn shifts_and_their_law_are_recovered() {
        for (noise, bound) in [(0.0, 0.01), (0.01, 0.03)] {
            let (all, log) = sweeps(noise);
            let master = all.master(Some(298.0)).unwrap();
            assert!((master.reference - 300.0).abs() < 0.1);
            for (&(t, found), error) in master.shifts.iter().zip(&master.errors) {
                assert!((found - log(t)).abs() < bound, "{t} {found} {}", log(t));
                // Four of them, and what a spectrum on a grid of times leaves without noise.
                assert!((found - log(t)).abs() < 4.0 * error + 2e-3 || noise <= 0.0, "{t} {found} {error}");
                assert!((*error > 0.0) == ((t - master.reference).abs() > 0.1) && *error < bound, "{t} {error}");
            }
            let (c1, c2) = master.wlf.unwrap();
            assert!((c1 / 8.86 - 1.0).abs() < 4.0 * bound && (c2 / 101.6 - 1.0).abs() < 4.0 * bound, "{c1} {c2}");
            assert!(master.spectrum.deviation < 1.2 * noise.max(2e-3), "{}", master.spectrum.deviation);
        }
    }

    /// A network whose moduli go with the temperature: without b_T a spectrum misses them by per cents.
    #[test]
    fn moduli_that_go_with_the_temperature_are_levelled() {
        let (mut all, log) = sweeps(0.0);
        let b: Vec<f64> = all.temperature.iter().map(|t| (20.0 * (t / 20.0).round()) / 300.0).collect();
        let Moduli { storage, loss, .. } = &mut all.moduli;
        storage.iter_mut().chain(loss).zip(b.iter().chain(&b)).for_each(|(modulus, b)| *modulus *= b);
        let plain = all.master(Some(300.0)).unwrap();
        let levelled = Sweeps { entropic: true, ..all }.master(Some(300.0)).unwrap();
        // As of moduli that do not go with it.
        assert!(levelled.spectrum.deviation < 2.4e-3, "{}", levelled.spectrum.deviation);
        assert!(plain.spectrum.deviation > 5.0 * levelled.spectrum.deviation, "{}", plain.spectrum.deviation);
        assert!(plain.vertical.iter().all(|factor| (factor - 1.0).abs() <= 0.0));
        for (&(t, found), factor) in levelled.shifts.iter().zip(&levelled.vertical) {
            assert!((factor / (t / 300.0) - 1.0).abs() < 1e-3, "{t} {factor}");
            assert!((found - log(t)).abs() < 0.01, "{t} {found} {}", log(t));
        }
    }

    #[test]
    fn what_makes_no_curve_is_refused() {
        let (all, _) = sweeps(0.0);
        let one = Sweeps { temperature: vec![300.0; 120], ..all.clone() };
        assert!(one.master(None).unwrap_err().to_string().contains("one temperature"));
        let cold = Sweeps { temperature: vec![-3.0; 120], ..all };
        assert!(cold.master(None).unwrap_err().to_string().contains("above zero"));
    }
}
