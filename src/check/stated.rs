//! The error a scene states beside its true one, at several accuracies and by springs.

use super::attempt::{Attempt, Pairs, worst};
use super::row::{Computed, Row, Setting};
use super::sketch::Sketch;
use crate::run::record::Outcome;
use rayon::prelude::*;

/// A scene, and what of its results is known.
#[derive(Debug, Clone, Copy)]
pub struct Stated {
    /// The scene.
    pub scene: fn() -> Sketch,
    /// Its results beside the right ones.
    pub known: fn(&Outcome) -> Attempt<Pairs>,
    /// Relative errors it is asked for.
    pub asked: &'static [f64],
    /// Numbers of springs it is also run by, asked for 1e-6.
    pub springs: &'static [usize],
}

impl Stated {
    /// One row per accuracy and per bed, held to the error stated; in parallel, in order.
    #[must_use]
    pub fn rows(&self) -> Vec<Row> {
        let asked = self.asked.iter().map(|&asked| (asked, None));
        let all: Vec<_> = asked.chain(self.springs.iter().map(|&springs| (1e-6, Some(springs)))).collect();
        all.into_par_iter().map(|(asked, springs)| self.row(asked, springs)).collect()
    }

    fn row(&self, asked: f64, springs: Option<usize>) -> Row {
        let outcome = (self.scene)().accuracy(asked).springs(springs).run();
        let setting = Setting { accuracy: Some(asked), springs, ..Setting::FREE };
        match outcome {
            Ok(outcome) => {
                let row = Row::of((self.known)(&outcome).map(|pairs| worst(&pairs)));
                let solved = Computed { bytes: outcome.plan.state_bytes, ..Computed::default() };
                let setting = Setting { springs: Some(outcome.plan.springs).filter(|count| *count > 0), ..setting };
                let bound = Some(outcome.error_estimate.relative);
                Row { method: outcome.plan.solver, setting, bound, solved, ..row }
            }
            Err(why) => Row { setting, ..Row::of(Err(why)) },
        }
    }

    /// The largest part of the error stated that the true error uses.
    #[must_use]
    pub fn verdict(&self) -> Row {
        let rows = self.rows();
        if let Some(failed) = rows.iter().find(|row| row.why.is_some()) {
            return failed.clone();
        }
        let parts: Vec<_> = rows.iter().map(used).collect();
        Row { tried: rows.len(), ..Row::of(Ok(worst(&parts))) }
    }
}

/// True over stated error; an error of zero uses nothing.
fn used(row: &Row) -> (f64, f64) {
    let (error, stated) = (row.error.unwrap_or(f64::NAN), row.bound.unwrap_or(0.0));
    (if error <= 0.0 { 0.0 } else { error / stated }, 0.0)
}
