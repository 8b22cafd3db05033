//! A rough line on a ball.

use crate::check::case::Attempt;
use crate::check::row::{Computed, Setting};
use crate::check::sketch::si;
use crate::check::study::{Method, Study, Thoroughness};
use crate::contact::rough::RoughBed;
use crate::shape::rough::{Rings, RoughLine, SelfAffine};

/// Springs of the reference.
const FINEST: usize = 1 << 21;
/// Curvature radius, period and modulus are one.
const DEPTHS: [f64; 4] = [0.002, 0.005, 0.01, 0.02];

/// A self-affine line, H = 0.8, rms height 10⁻³, on a ball: forces at four depths.
pub fn line(effort: Thoroughness) -> Attempt<Study> {
    let finest = if effort == Thoroughness::Brief { 8 } else { 10 };
    let method = |k| {
        let count = 256usize << k;
        Method::new("sorted springs", Setting::springs(count), move || {
            let line = self_affine()?;
            Ok(move || forces(&line, count))
        })
    };
    Ok(Study {
        case: "rough",
        about: "a rough line on a ball: forces at four depths, the bed sorted in each run".to_owned(),
        quantity: "force",
        reference: "the same line under 2²¹ springs".to_owned(),
        exact: forces(&self_affine()?, FINEST)?,
        methods: (0..=finest).map(method).collect(),
    })
}

fn self_affine() -> Attempt<RoughLine> {
    let spectrum = SelfAffine {
        hurst: si(0.8)?,
        rms: Some(si(1e-3)?),
        amplitude: None,
        long: si(0.25)?,
        roll_off: None,
        short: si(0.01)?,
    };
    Ok(RoughLine::new(&Rings::of(&spectrum.spectrum()?, 1.0, 256)?, 1))
}

fn forces(line: &RoughLine, count: usize) -> Attempt<Computed> {
    let bed = RoughBed::under(line, count, 1.0, |x| x * x)?;
    let values = DEPTHS.iter().map(|&depth| bed.at_indentation(depth).force).collect();
    Ok(Computed { values, bytes: 3 * size_of::<f64>() * bed.springs(), ..Computed::default() })
}
