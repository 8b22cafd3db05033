//! What is measured on a cantilever: depths that have the noise of the force in them, and a virtual deflection.
//!
//! The depth d_m = z − F_m/k is made of the way z of the piezo and the force F_m = F(d) + n on a cantilever of the stiffness
//! k [N/m]. The noise n is in it too, d_m = d − n/k, so that F_m − F(d_m) is n(1 + F′/k), and what the model answers at d_m has
//! a shape that follows the noise: against noise before first touch good scenes would be rejected. The noise that was found
//! is taken off the depths, and the residual at d counts 1/(1 + F′/k): that is the search for the F(z) that is nearest to the
//! forces over the way of the piezo, which has no noise (Gauss & Newton).
//!
//! While a piezo moves by z the spot on the detector moves by sz though nothing is touched. What is measured are the force
//! F_m = F(d) + ksz and the depth d_m = d − sz, with z = d_m + F_m/k: in contact
//! too, where a tilt of the force alone would leave the depths wrong. s is found as the baseline is, by the column
//! z(k + dF/dd) of all that it moves, and the curve is made straight by it until nothing is left of it (Gauss & Newton).

use super::answer::Fit;
use super::curve::{Curve, Readings};
use super::frame::VIRTUAL;
use super::given::Doubt;
use super::{FitError, Options, Question};
use crate::input::table::Tables;
use crate::scene::fit::{Baseline, Drive, FirstTouch};

/// The most times a curve is made straight, and the number of the first that may be the last: the noise is known by then.
const ROUNDS: usize = 24;
const LEAST: usize = 2;
const TO_AND_FRO: &str = "the virtual deflection goes to and fro within its standard error: first touch is hardly told in noise so much alike";
/// Rounds that go the whole way.
const WHOLE: usize = 5;
/// Part of its standard error, and the size, to which s is found.
const CLOSE: (f64, f64) = (1e-3, 1e-12);

/// Whether there is a cantilever, and first touch is free, where a virtual deflection is asked for.
pub(super) fn checked(options: &Options, led: Drive) -> Result<(), FitError> {
    if options.baseline != Baseline::Virtual {
        return Ok(());
    }
    let lacks = match (options.spring, led, options.contact) {
        (None, ..) => "the stiffness of the cantilever: expected --spring \"0.05 N/m\" too",
        (_, Drive::Force | Drive::Speed | Drive::Slide, _) => "a depth that drives: expected drive: Depth",
        (.., FirstTouch::Zero) => "a first touch that is free: expected contact: Free",
        (Some(_), Drive::Depth, FirstTouch::Free) => return Ok(()),
    };
    Err(FitError::Free(format!("a virtual deflection needs {lacks}")))
}

impl Curve {
    /// Way of the piezo [m] at each point.
    fn piezo(&self, spring: f64) -> Vec<f64> {
        let [depth, force] = self.readings.both();
        depth.iter().zip(force).map(|(depth, force)| depth + force / spring).collect()
    }

    /// The curve without the virtual deflection `part` of the way of the piezo.
    fn straight(&self, spring: f64, part: f64) -> Self {
        let piezo = self.piezo(spring);
        let moved = |column: &[f64], by: f64| column.iter().zip(&piezo).map(|(value, z)| value + by * z).collect();
        let [depth, force] = self.readings.both();
        let readings = Readings::Indentation { depth: moved(depth, part), force: moved(force, -spring * part) };
        Self { readings, ..self.clone() }
    }
}

/// A cantilever of which it is known how stiff the contact is.
pub(super) struct Bent {
    /// Column of its virtual deflection.
    pub column: Vec<f64>,
    /// Roots of the weights of its points.
    pub weights: Vec<f64>,
    /// Noise of the forces as far as it is known [N].
    noise: Vec<f64>,
}

/// Least part of 1 + F′/k that counts: a contact that weakens by the stiffness of the cantilever jumps.
const UNSTABLE: f64 = 0.1;

impl Bent {
    /// Of the stiffness `spring` [N/m] and the ways `piezo` [m]; nothing is touched yet.
    fn free(spring: f64, piezo: &[f64]) -> Self {
        let column = piezo.iter().map(|z| z * spring).collect();
        Self { column, weights: vec![1.0; piezo.len()], noise: vec![0.0; piezo.len()] }
    }

    /// Of the slopes `touch` = −F′ [N/m] of the force in first touch, and the noise that was found.
    fn touching((spring, piezo): (f64, &[f64]), touch: &[f64], noise: Vec<f64>) -> Self {
        let weight = |touch: &f64| (1.0 - touch / spring).abs().max(UNSTABLE).recip();
        let column = piezo.iter().zip(touch).map(|(z, touch)| z * (spring - touch)).collect();
        Self { column, weights: touch.iter().map(weight).collect(), noise }
    }

    /// The way from this one to the next, `share` of it.
    fn towards(&self, share: f64, next: Self) -> Self {
        let mixed = |before: &[f64], next: &[f64]| {
            before.iter().zip(next).map(|(before, next)| before + share * (next - before)).collect()
        };
        Self {
            column: next.column,
            weights: mixed(&self.weights, &next.weights),
            noise: mixed(&self.noise, &next.noise),
        }
    }

    /// The curve with the noise taken off its depths, and forces beside which as much is left as their weights want.
    fn quiet(&self, spring: f64, curve: &Curve) -> Curve {
        let [depth, force] = curve.readings.both();
        let depth = depth.iter().zip(&self.noise).map(|(depth, noise)| depth + noise / spring).collect();
        let more = self.noise.iter().zip(&self.weights).map(|(noise, weight)| noise * (weight.recip() - 1.0));
        let force = force.iter().zip(more).map(|(force, more)| force + more).collect();
        Curve { readings: Readings::Indentation { depth, force }, ..curve.clone() }
    }

    /// The noise of the forces that a fit of a quiet curve leaves [N].
    fn left(&self, quiet: &Curve, fit: &Fit) -> Vec<f64> {
        let rest = quiet.answered(Drive::Depth).iter().zip(&fit.model).map(|(force, model)| force - model);
        rest.zip(&self.weights).map(|(rest, weight)| rest * weight).collect()
    }
}

impl Question {
    /// The fit of a curve that was measured on a cantilever.
    pub(super) fn on_cantilever(
        &self,
        (curve, doubts): (&Curve, &[Doubt]),
        tables: &dyn Tables,
        spring: f64,
    ) -> Result<Fit, FitError> {
        let piezo = curve.piezo(spring);
        let mut part = 0.0;
        let mut bent = Bent::free(spring, &piezo);
        for round in 0..ROUNDS {
            let quiet = bent.quiet(spring, &curve.straight(spring, part));
            let (fit, touch) = self.fit_along((&quiet, doubts), tables, Some(&bent))?;
            let left = fit.parameter(VIRTUAL).map_or((0.0, 0.0), |one| (one.value, one.standard_error.unwrap_or(0.0)));
            let noise = bent.left(&quiet, &fit);
            if left.0.abs() <= CLOSE.1.max(CLOSE.0 * left.1) && round >= LEAST {
                return Ok(fit.bent(curve, &noise, part));
            }
            if round + 1 == ROUNDS && left.0.abs() <= left.1 {
                let mut fit = fit.bent(curve, &noise, part);
                fit.notes.push(TO_AND_FRO.to_owned());
                return Ok(fit);
            }
            // Noise that is alike over many rows may throw first touch to and fro.
            let share = if round < WHOLE { 1.0 } else { 0.5 };
            part += share * left.0;
            bent = bent.towards(share, Bent::touching((spring, &piezo), &touch, noise));
        }
        Err(FitError::Data("the virtual deflection comes to no end: expected baseline: Linear".to_owned()))
    }
}

impl Fit {
    /// The fit as it lies in the curve as it was measured.
    fn bent(mut self, curve: &Curve, noise: &[f64], part: f64) -> Self {
        for one in self.parameters.iter_mut().filter(|one| one.path == VIRTUAL) {
            one.value += part;
            one.low = one.low.map(|low| low + part);
            one.high = one.high.map(|high| high + part);
        }
        self.model = curve.answered(Drive::Depth).iter().zip(noise).map(|(force, noise)| force - noise).collect();
        let squares: f64 = self.used.iter().map(|&at| noise[at].powi(2)).sum();
        self.deviation = (squares / self.used.len() as f64).sqrt();
        self
    }
}
