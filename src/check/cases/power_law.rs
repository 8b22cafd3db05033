//! Bodies that relax by a power of time, run as whole scenes, against the closed forms.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::power_law::PowerTriangle;
use crate::check::sketch::{Sketch, ball, ends, relaxing_by_power, si};
use crate::run::record::{Outcome, Record};
use crate::shape::{Cone, Shape};
use std::f64::consts::PI;

const SERIES: &str = "the series is within a tenth of the accuracy of 1e-6 at all times of the scene, and the force is an integral over it with weights of one sign; on the way out the end of the integral is off by as much";

pub(super) const CASES: &[Case] = &[
    Case::new("power law/triangle of a paraboloid", Proof::Bound, 1e-6, SERIES)
        .weak("relative to the greatest force; one exponent")
        .by(|| triangle(paraboloid(0.2), ball(1.0))),
    Case::new("power law/triangle of a cone", Proof::Bound, 1e-6, SERIES)
        .weak("relative to the greatest force; one exponent")
        .by(|| triangle(cone(0.4), si(SLOPE).map(|slope| Shape::Cone(Cone { slope })))),
    Case::new("power law/ramp and hold", Proof::Bound, 1e-6, SERIES)
        .weak("relative to the force itself; a paraboloid")
        .by(ramp_and_hold),
    Case::new(
        "power law/creep under a force",
        Proof::Bound,
        3e-4,
        "chords within 1e-4 of the depth, springs for half of it and the series for a tenth",
    )
    .weak("a paraboloid; force that does not fall")
    .by(creep),
];

const SPEED: f64 = 0.01;
const SLOPE: f64 = 0.1;

fn paraboloid(exponent: f64) -> PowerTriangle {
    PowerTriangle { scale: 4.0 * 4.0 / 3.0, power: 1.5, exponent, speed: SPEED, turn: 1.0 }
}

fn cone(exponent: f64) -> PowerTriangle {
    PowerTriangle { scale: 4.0 * 2.0 / (PI * SLOPE), power: 2.0, exponent, speed: SPEED, turn: 1.0 }
}

fn triangle(exact: PowerTriangle, shape: Attempt<Shape>) -> Attempt<Pairs> {
    let body = relaxing_by_power(exact.exponent);
    let outcome = Sketch::of(shape).body(body).steps(10).indent(SPEED, 1.0).indent(0.0, 1.0).run()?;
    let largest = outcome.records.iter().map(|record| record.normal.force).fold(0.0, f64::max);
    Ok(pairs(&outcome, |record| ((record.normal.force - exact.force(record.time)) / largest, 0.0)))
}

fn pairs(outcome: &Outcome, pair: impl Fn(&Record) -> (f64, f64)) -> Pairs {
    outcome.records[1..].iter().map(pair).collect()
}

/// The end of the way in is a hundredth of the whole before the first record of the hold.
fn ramp_and_hold() -> Attempt<Pairs> {
    let exact = paraboloid(0.3);
    let outcome = Sketch::of(ball(1.0)).body(relaxing_by_power(0.3)).steps(10).indent(SPEED, 1.0).hold(99.0).run()?;
    Ok(pairs(&outcome, |record| (record.normal.force, exact.driven(record.time, record.time.min(1.0)))))
}

/// d^{3/2} = (3/4√R) ∫J dF with J = sin(πβ)/(πβ) t^β/E₀ (Gross 1953): under a ramp of T and then a constant force the
/// integral is (t^{1+β} − (t − T)^{1+β})/(1 + β).
fn creep() -> Attempt<Pairs> {
    let (beta, force, ramp) = (0.25, 1e-3, 1.0);
    let sketch = Sketch::of(ball(1.0)).body(relaxing_by_power(beta)).accuracy(1e-4).steps(5);
    let outcome = sketch.press(force, ramp).hold_force(10.0).run()?;
    let gone = |t: f64| t.max(0.0).powf(1.0 + beta) / (1.0 + beta);
    let compliance = (PI * beta).sin() / (PI * beta) / 4.0;
    let pair = |record: &Record| {
        let depth = record.normal.indentation.ok_or("no indentation")?;
        let rate = force / ramp * (gone(record.time) - gone(record.time - ramp));
        Ok((depth, (0.75 * compliance * rate).powf(2.0 / 3.0)))
    };
    ends(&outcome).map(pair).collect()
}
