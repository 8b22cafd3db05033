//! The virtual deflection of a cantilever.
//!
//! While a piezo moves by z the spot on the detector moves by sz though nothing is touched. What is measured are the force
//! F_m = F(d) + ksz and the depth d_m = d − sz, with the stiffness k of the cantilever [N/m] and z = d_m + F_m/k: in contact
//! too, where a tilt of the force alone would leave the depths wrong. s is found as the baseline is, by the column
//! z(k + dF/dd) of all that it moves, and the curve is made straight by it until nothing is left of it (Gauss & Newton).

use super::answer::Fit;
use super::curve::{Curve, Readings};
use super::frame::VIRTUAL;
use super::given::Doubt;
use super::{FitError, Options, Question};
use crate::input::table::Tables;
use crate::scene::fit::{Baseline, Drive, FirstTouch};

/// The most times a curve is made straight.
const ROUNDS: usize = 8;
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

impl Question {
    /// The fit of a curve and its virtual deflection.
    pub(super) fn straightened(
        &self,
        (curve, doubts): (&Curve, &[Doubt]),
        tables: &dyn Tables,
        spring: f64,
    ) -> Result<Fit, FitError> {
        let piezo = curve.piezo(spring);
        let mut part = 0.0;
        let mut column: Vec<f64> = piezo.iter().map(|z| z * spring).collect();
        for round in 0..ROUNDS {
            let straight = curve.straight(spring, part);
            let (fit, touch) = self.fit_along((&straight, doubts), tables, Some(&column))?;
            let left = fit.parameter(VIRTUAL).map_or((0.0, 0.0), |one| (one.value, one.standard_error.unwrap_or(0.0)));
            if left.0.abs() <= CLOSE.1.max(CLOSE.0 * left.1) && round > 0 {
                return Ok(fit.bent(&piezo, (spring, part)));
            }
            part += left.0;
            column = piezo.iter().zip(&touch).map(|(z, touch)| z * (spring - touch)).collect();
        }
        Err(FitError::Data("the virtual deflection comes to no end: expected baseline: Linear".to_owned()))
    }
}

impl Fit {
    /// The fit as it lies in the curve before it was made straight.
    fn bent(mut self, piezo: &[f64], (spring, part): (f64, f64)) -> Self {
        for one in self.parameters.iter_mut().filter(|one| one.path == VIRTUAL) {
            one.value += part;
            one.low = one.low.map(|low| low + part);
            one.high = one.high.map(|high| high + part);
        }
        self.model.iter_mut().zip(piezo).for_each(|(force, z)| *force += spring * part * z);
        self
    }
}
