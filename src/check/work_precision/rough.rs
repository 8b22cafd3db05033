//! A rough line on a ball.

use super::{Answer, Effort, Method, Setting, Study};
use crate::contact::rough::RoughBed;
use crate::input::quantity::{Hurst, Length};
use crate::shape::rough::{Rings, RoughLine, SelfAffine};

/// Springs of the reference.
const FINEST: usize = 1 << 21;
/// Curvature radius, period and modulus are one.
const DEPTHS: [f64; 4] = [0.002, 0.005, 0.01, 0.02];

/// A self-affine line, H = 0.8, rms height 10⁻³, on a ball: forces at four depths.
pub(super) fn line(effort: Effort) -> Option<Study> {
    let exact = forces(&bed(FINEST)?);
    let finest = if effort == Effort::Brief { 8 } else { 10 };
    let methods = (0..=finest).map(|k| {
        let count = 256usize << k;
        Method::new("sorted springs", Setting::springs(count), move || {
            let line = line_of()?;
            Some(move || Some(forces(&under(&line, count)?)))
        })
    });
    Some(Study {
        case: "rough",
        about: "a rough line on a ball: forces at four depths, the bed sorted in each run".to_owned(),
        quantity: "force",
        reference: "the same line under 2²¹ springs".to_owned(),
        orders: &[1.0, 2.0],
        exact,
        methods: methods.collect(),
    })
}

fn line_of() -> Option<RoughLine> {
    let spectrum = SelfAffine {
        hurst: Hurst::new(0.8).ok()?,
        rms: Some(Length::new(1e-3).ok()?),
        amplitude: None,
        long: Length::new(0.25).ok()?,
        roll_off: None,
        short: Length::new(0.01).ok()?,
    };
    Some(RoughLine::new(&Rings::of(&spectrum.spectrum().ok()?, 1.0, 256).ok()?, 1))
}

fn bed(count: usize) -> Option<RoughBed> {
    under(&line_of()?, count)
}

fn under(line: &RoughLine, count: usize) -> Option<RoughBed> {
    RoughBed::under(line, count, 1.0, |x| x * x).ok()
}

fn forces(bed: &RoughBed) -> Answer {
    let values = DEPTHS.iter().map(|&depth| bed.at_indentation(depth).force).collect();
    Answer { values, bytes: 3 * size_of::<f64>() * bed.springs(), ..Answer::default() }
}
