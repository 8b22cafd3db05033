//! One scene of a sweep, computed.

use super::Sweep;
use crate::input::table::Tables;
use crate::run::named::{Finding, Named};
use crate::run::record::{FORCE, INDENTATION, Outcome};
use crate::run::{Wanted, in_pieces, run};
use crate::text::place::Value;
use serde::{Deserialize, Serialize};

/// Most points of a curve that is kept.
const MOST_POINTS: usize = 2000;

/// Whether a row keeps its curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Curves {
    /// It does.
    Kept,
    /// It does not.
    Absent,
}

/// What came out of one scene of a sweep.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// Its number, from 0 on.
    pub number: usize,
    /// Named results in SI units, in a fixed order; empty if the scene could not be computed.
    pub results: Vec<(String, Value)>,
    /// Estimate of the relative error.
    pub error_estimate: Option<f64>,
    /// Physics a user must know.
    pub warnings: Vec<String>,
    /// Why the scene could not be computed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// Indentation [m] and force [N], if they were to be kept.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub curve: Vec<(f64, f64)>,
}

impl Row {
    /// The number with this name, if the row has it.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        self.value(name)?.as_f64()
    }

    /// The result with this name, if the row has it.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<&Value> {
        self.results.iter().find(|(known, _)| known == name).map(|(_, value)| value)
    }

    fn of(number: usize, outcome: Outcome, curves: Curves) -> Self {
        Self {
            number,
            results: outcome.results.iter().map(|named| (named.name(), value(named))).collect(),
            error_estimate: Some(outcome.error_estimate.relative).filter(|error| error.is_finite()),
            curve: if curves == Curves::Kept { curve(&outcome) } else { Vec::new() },
            warnings: outcome.warnings,
            failure: None,
        }
    }
}

impl Sweep {
    /// The row `number`, computed with the `tables` its scene names: the results are those of the scene alone.
    #[must_use]
    pub fn row(&self, number: usize, tables: &dyn Tables, curves: Curves) -> Row {
        let failed = |why: String| Row {
            number,
            results: Vec::new(),
            error_estimate: None,
            warnings: Vec::new(),
            failure: Some(why),
            curve: Vec::new(),
        };
        match self.outcome(number, tables) {
            Ok(outcome) => Row::of(number, outcome, curves),
            Err(why) => failed(why),
        }
    }

    fn outcome(&self, number: usize, tables: &dyn Tables) -> Result<Outcome, String> {
        let scene = self.scene(number).map_err(|problem| problem.to_string())?;
        let plan = scene.resolve(tables).map_err(|problems| {
            let all: Vec<String> = problems.iter().map(ToString::to_string).collect();
            all.join("; ")
        })?;
        let wanted = Wanted { fields: true, ..Wanted::NOTHING };
        let outcome = run(&plan, wanted).map_err(|error| error.to_string())?;
        in_pieces(&outcome).map_or(Ok(()), |why| Err(why.to_owned()))?;
        Ok(outcome)
    }
}

fn value(named: &Named) -> Value {
    match named.finding {
        Finding::Number(number) => Value::from(number),
        Finding::Answer(yes) => Value::from(yes),
        Finding::Count(count) => Value::from(count),
    }
}

/// Force over depth, every so many records of a long history.
fn curve(outcome: &Outcome) -> Vec<(f64, f64)> {
    let stride = outcome.records.len().div_ceil(MOST_POINTS).max(1);
    let point = |record| (INDENTATION.of)(record).zip((FORCE.of)(record));
    let points = outcome.records.iter().step_by(stride).filter_map(point);
    points.filter(|(depth, force)| depth.is_finite() && force.is_finite()).collect()
}
