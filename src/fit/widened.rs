//! Intervals that hold for what is known only roughly too.

use super::Free;
use super::answer::{Fit, correlations};
use super::given::Carried;
use super::noise::NORMAL;

/// Part of a standard error from the noise beyond which what is given is spoken of.
const WORTH_SAYING: f64 = 1.0;

impl Fit {
    /// The fit with the intervals widened by what is known only roughly.
    #[must_use]
    pub(super) fn widened(mut self, free: &[Free], carried: Vec<Carried>) -> Self {
        if carried.is_empty() {
            return self;
        }
        let errors: Vec<f64> = self.parameters.iter().map(|one| one.standard_error.unwrap_or(0.0)).collect();
        let shifted = |j: usize, k: usize| carried.iter().map(|one| one.shifts[j] * one.shifts[k]).sum::<f64>();
        let covariance = |j: usize, k: usize| self.correlations[j][k] * errors[j] * errors[k] + shifted(j, k);
        self.correlations = correlations(errors.len(), &covariance);
        for (at, one) in self.parameters.iter_mut().enumerate() {
            let (spread, ratio) = (shifted(at, at).sqrt(), free.get(at).is_some_and(Free::is_ratio));
            one.low =
                one.low.and_then(|low| wider((one.value, low), spread, ratio)).filter(|&low| reached(free, at, low));
            one.high = one
                .high
                .and_then(|high| wider((one.value, high), spread, ratio))
                .filter(|&high| reached(free, at, high));
            one.standard_error = one.standard_error.map(|error| error.hypot(spread));
        }
        let notes: Vec<String> = carried.iter().filter_map(|one| one.told(&self, &errors)).collect();
        self.notes.extend(notes);
        self.carried = carried;
        self
    }
}

fn reached(free: &[Free], at: usize, end: f64) -> bool {
    free.get(at).is_none_or(|free| (free.low..=free.high).contains(&end))
}

/// The end of an interval, its distance from the value and that of a shift added by their squares; in ratios or as they
/// are.
fn wider((value, end): (f64, f64), spread: f64, ratio: bool) -> Option<f64> {
    if spread <= 0.0 {
        return Some(end);
    }
    let far = if ratio { (end / value).ln() } else { end - value };
    let also = NORMAL * if ratio { spread / value } else { spread };
    let far = far.signum() * far.hypot(also);
    let end = if ratio { value * far.exp() } else { value + far };
    end.is_finite().then_some(end)
}

impl Carried {
    /// The parameter of which most is due to what is given, where that is more than the noise.
    fn told(&self, fit: &Fit, errors: &[f64]) -> Option<String> {
        let share = |at: usize| self.shifts[at].abs() / errors[at].max(f64::MIN_POSITIVE);
        let most = (0..errors.len()).filter(|&at| errors[at] > 0.0).max_by(|&a, &b| share(a).total_cmp(&share(b)))?;
        let (one, given) = (&fit.parameters[most], &self.given);
        (share(most) > WORTH_SAYING).then(|| {
            format!(
                "{} is known to {:.3} %: that moves {} by {:.3} %, more than the noise does",
                given.path,
                100.0 * given.spread / given.value.abs(),
                one.path,
                100.0 * (self.shifts[most] / one.value).abs(),
            )
        })
    }
}
