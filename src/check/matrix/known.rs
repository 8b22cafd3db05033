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
    let offs = [("force", 0), ("contact radius", 1)];
    let apart = apart(whole, &fine)?;
    let beyond = offs.iter().find(|(_, k)| apart[*k] > said || apart[*k].is_nan());
    beyond.map(|&(what, k)| {
        format!("the {what} is off by {:e}, and it says {:e}", apart[k], whole.error_estimate.relative)
    })
}

/// How far a scene is from the same at a finer accuracy, in force or radius; `None` if their records differ in number.
pub(super) fn beside_finer(written: &Written, whole: &Outcome) -> Result<Option<f64>, String> {
    let fine = outcome(&written.finer_solved(FINE))?;
    Ok(apart(whole, &fine).map(|[force, radius]| force.max(radius)))
}

/// Largest differences of forces and of radii at the same times, of the largest.
fn apart(whole: &Outcome, fine: &Outcome) -> Option<[f64; 2]> {
    let largest = Largest::of(fine);
    if whole.records.len() != fine.records.len() {
        return None;
    }
    // What changes within the rounding of its time, as a pull-off that no sound would follow, is told by chance.
    let close = |pair: &[Record]| at_once(&pair[0], &pair[1]) && (pair[0].time - pair[1].time).abs() > 0.0;
    let by_chance = |at: usize| fine.records[at.saturating_sub(1)..].windows(2).take(2).any(close);
    let numbered = || whole.records.iter().zip(&fine.records).enumerate();
    let pairs = || numbered().filter(|(at, (one, two))| at_once(one, two) && !by_chance(*at)).map(|(_, pair)| pair);
    let force = pairs().map(|(one, two)| one.normal.force - two.normal.force);
    // Where bodies have just met, upon a dent it may be, rounding decides how far they touch.
    let apart = |record: &Record| record.normal.contact_radius.is_none_or(|radius| radius <= 0.0);
    let met = |record: &Record| record.normal.force.abs() <= ROUNDING * largest.force;
    let radii = pairs().scan(true, |was_apart, (one, two)| {
        let told = !(std::mem::replace(was_apart, apart(one)) && met(one) && met(two));
        Some((told, one.normal.contact_radius.zip(two.normal.contact_radius)))
    });
    let radius = radii.filter_map(|(told, radii)| radii.filter(|_| told)).map(|(one, two)| one - two);
    let most = |offs: &mut dyn Iterator<Item = f64>, scale: f64| {
        let worst = |most: f64, off: f64| if off > most || off.is_nan() { off } else { most };
        // Of nothing at all nothing is off.
        offs.map(f64::abs).fold(0.0, worst) / scale.max(f64::MIN_POSITIVE)
    };
    Some([most(&mut { force }, largest.tellable_force()), most(&mut { radius }, largest.radius)])
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

    /// How far force and depth of the records are from the closed form at their radii, relative.
    pub(super) fn off(&self, whole: &Outcome) -> f64 {
        whole.records.iter().filter_map(|record| self.off_at(record, whole)).fold(0.0, f64::max)
    }

    fn off_at(&self, record: &Record, whole: &Outcome) -> Option<f64> {
        let largest = Largest::of(whole);
        // Of a ball that no force holds pressures and attraction are in balance.
        let balance = 4.0 * self.modulus * largest.radius.powi(3) / (3.0 * self.radius);
        let scale = (self.pressed(largest.radius).0.abs() + largest.force).max(balance);
        let a = record.normal.contact_radius.filter(|&a| a > 0.0)?;
        let (force, depth) = self.pressed(a);
        let off = (record.normal.force - force).abs() / scale;
        let shallow = (record.normal.indentation? - depth).abs() / (a * a / self.radius + depth.abs());
        Some(if off.is_nan() { off } else { shallow.max(off) })
    }

    /// How the records miss the closed form by more than is said.
    pub(super) fn missed(&self, whole: &Outcome) -> Option<String> {
        // The force rises with the radius, and faster than it: an error of the radius tells three times.
        let said = 3.0 * whole.error_estimate.relative + ROUNDING;
        let offs = whole.records.iter().filter_map(|record| Some((record, self.off_at(record, whole)?)));
        let mut missed = offs.filter(|(_, off)| *off > said || off.is_nan());
        missed.next().map(|(record, off)| {
            format!("at a = {:?} force or depth are off the closed form by {off:e}", record.normal.contact_radius)
        })
    }
}
