//! What a scene says of its own error, against what is right: closed forms, and the scene itself at a finer accuracy.

use super::ends::{Largest, outcome};
use super::written::Written;
use crate::run::record::{Outcome, Record};
use std::f64::consts::PI;

/// Accuracy of a scene that stands for the right answer, and rounding.
const FINE: f64 = 1e-6;
const ROUNDING: f64 = 1e-12;

/// How the error of a scene is more than it says, by the same scene at a finer accuracy; what jumps between two records
/// of one of them is left out.
pub(super) fn beyond_estimate(written: &Written, whole: &Outcome) -> Option<String> {
    // A patch of a few pixels is told to be none, whatever is stated beside it.
    if whole.warnings.iter().any(|warning| warning.contains("are not resolved")) {
        return None;
    }
    let fine = match outcome(&written.finer_solved(FINE)) {
        Ok(fine) => fine,
        Err(why) => return Some(why),
    };
    let said = whole.error_estimate.relative + fine.error_estimate.relative + ROUNDING;
    let largest = Largest::of(&fine);
    if whole.records.len() != fine.records.len() {
        return None;
    }
    let pairs = || whole.records.iter().zip(&fine.records).filter(|(one, two)| at_once(one, two));
    let force = pairs().map(|(one, two)| one.normal.force - two.normal.force);
    let radius = pairs().filter_map(|(one, two)| Some(one.normal.contact_radius? - two.normal.contact_radius?));
    let most = |offs: &mut dyn Iterator<Item = f64>| offs.map(f64::abs).fold(0.0, f64::max);
    let offs =
        [("force", most(&mut { force }), largest.force), ("contact radius", most(&mut { radius }), largest.radius)];
    let beyond = offs.iter().find(|(_, off, scale)| *off > said * scale || off.is_nan());
    beyond.map(|(what, off, scale)| {
        format!("the {what} is off by {:e}, and it says {:e}", off / scale, whole.error_estimate.relative)
    })
}

/// Whether two records are of the same time.
fn at_once(one: &Record, two: &Record) -> bool {
    (one.time - two.time).abs() <= ROUNDING * two.time.abs()
}

/// A ball on a half-space in closed form: radius [m], modulus E* [Pa], work of adhesion [J/m²] (Johnson, Kendall &
/// Roberts 1971; Hertz without work).
#[derive(Debug, Clone, Copy)]
pub(super) struct Ball {
    pub(super) radius: f64,
    pub(super) modulus: f64,
    pub(super) work: f64,
}

impl Ball {
    /// Force [N] and depth [m] of the contact of the radius a.
    fn pressed(&self, a: f64) -> (f64, f64) {
        let Self { radius, modulus, work } = *self;
        let stretched = (2.0 * PI * a * work / modulus).sqrt();
        let force = 4.0 * modulus * a.powi(3) / (3.0 * radius) - 2.0 * modulus * a * stretched;
        (force, a * a / radius - stretched)
    }

    /// How the records miss the closed form by more than is said.
    pub(super) fn missed(&self, whole: &Outcome) -> Option<String> {
        let largest = Largest::of(whole);
        // The force rises with the radius, and faster than it: an error of the radius tells three times.
        let said = 3.0 * whole.error_estimate.relative + ROUNDING;
        let scale = self.pressed(largest.radius).0.abs() + largest.force;
        whole.records.iter().find_map(|record| {
            let a = record.normal.contact_radius.filter(|&a| a > 0.0)?;
            let (force, depth) = self.pressed(a);
            let off = (record.normal.force - force).abs() / scale;
            let shallow = (record.normal.indentation? - depth).abs() / (a * a / self.radius + depth.abs());
            (!(off <= said && shallow <= said))
                .then(|| format!("at a = {a:e} the force is off the closed form by {off:e}, the depth by {shallow:e}"))
        })
    }
}
