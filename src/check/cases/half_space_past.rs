//! Pixels that remember, attract each other or yield, beside the beds that know the answer.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, elastic, relaxing, si};
use crate::contact::adhesion::{Adhesion, Exponential, Maugis};
use crate::material::{Body, Plastic, PlasticLimit, Relaxation, Winkler};
use crate::run::record::{Outcome, Record};
use crate::scene::solver::HalfSpace;
use std::f64::consts::{PI, TAU};
use std::num::NonZeroUsize;

/// Pixels along the window; from the tip to the edge of the contact it holds sixteen.
const GRID: usize = 48;
/// (Δ/a)²/8: every solver of pixels of constant pressure misses the force of a ball by at most so much.
const SQUARE: f64 = 1.0 / 2048.0;
/// What the steps of the time may miss.
const OF_TIME: f64 = 1e-4;

pub(super) const CASES: &[Case] = &[
    Case::new("half-space/Ting's history on pixels", Proof::Order, 1.0, "pressed, held and half withdrawn: beside the bed within (Δ/a)²/8 in the force, four times that in stored and lost energy, each with the 1e-4 that time steps may miss; of the largest, printed as the part of the bound used").weak("one ball and two relaxation times").by(ting),
    Case::new("half-space/creep on pixels", Proof::Order, 1.0, "the depth under a dead load, beside the bed, within (Δ/a)²/8 and 1e-4; of the largest, printed as the part of the bound used").weak("one ball and two relaxation times").by(creep),
    Case::new("half-space/Maugis on pixels", Proof::Other, 5e-3, "forces on the way in and out, of the largest, beside his closed form: the end of the attraction lies between pixels").weak("λ near 1; one grid").by(maugis),
    Case::new("half-space/what a constant attraction loses at first touch", Proof::Other, 7.5e-3, "a disc of the radius c = 8σ₀R/(πE*) is taken hold of at once: (2/3)σ₀²c³/E*, the work of σ₀ on what it lifts less what is stored; a jump is found to 1e-4 of the largest energy, here thirty times that").weak("one grid").by(first_touch),
    Case::new("half-space/Bradley's attraction that fades", Proof::Order, 1e-3, "a hard ball apart from a flat: F = −2πwR e^(d/ρ) under σ = (w/ρ)e^(−z/ρ) (Bradley 1932, Derjaguin 1934); a pixel of the width Δ sums that to (Δ²/Rρ)²/24, ρ/R = 1e-4 of a parabola leaves the rest").weak("one range and grid").by(fading),
    Case::new("half-space/JKR as the range shrinks with the pixel", Proof::Order, 1.0, "a ball under an attraction that fades lets go at JKR's 3πwR/2 and a part of it more that is inverse to Tabor's parameter μ = (Rw²/E*²ρ³)^⅓: 0.1/μ at μ = 0.65, and the same but for a seventh at 1.3; printed as the part of the bound used").weak("two ranges, each on its grid; the tenth is what is found").by(shrinking),
    Case::new("half-space/Maugis on springs of their own", Proof::Order, 1.0, "each place of a sheet is drawn in where the gap is δ, and lets go stretched by σ₀/k beyond it: forces on the way in and out, none in the end, and the loss σ₀²/2k of every jump, to twice ρ^⅔ of the pixels of a disc of ρ of them (Gauss' circle); printed as the part of the bound used").weak("a stretch within the range; one grid").by(sprung),
    Case::new("half-space/a body too hard to yield", Proof::Rounding, 1e-7, "is elastic, to the residual of the solver").weak("one ball").by(hard),
];

/// E*(t) = 1 + 2e^(−10t) + e^(−t/3) of a ball of R = 1.
fn gel() -> Attempt<Body> {
    relaxing(&Relaxation { equilibrium: 1.0, terms: vec![(2.0, 0.1), (1.0, 3.0)], viscosity: 0.0 })
}

/// The same scene on pixels and on the bed.
fn both(scene: impl Fn() -> Sketch) -> Attempt<[Outcome; 2]> {
    Ok([scene().pixels(GRID).run()?, scene().run()?])
}

/// What `of` tells of all records of the same instants, as parts of `bound` times the largest.
fn parts(outcomes: &[Outcome; 2], bound: f64, of: fn(&Record) -> f64) -> Pairs {
    let [pixels, bed] = outcomes;
    let largest = bed.records.iter().map(|record| of(record).abs()).fold(f64::MIN_POSITIVE, f64::max);
    let part = |found: &Record, right: &Record| ((of(found) - of(right)) / (largest * bound), 0.0);
    let same = |found: &Record| bed.records.iter().find(|right| (right.time - found.time).abs() < 1e-12);
    pixels.records.iter().filter_map(|found| Some(part(found, same(found)?))).collect()
}

fn force(record: &Record) -> f64 {
    record.normal.force
}

fn ting() -> Attempt<Pairs> {
    let outcomes = both(|| Sketch::of(ball(1.0)).body(gel()).steps(5).indent(0.01, 1.0).hold(1.0).indent(0.004, 1.0))?;
    let energy = 4.0 * SQUARE + OF_TIME;
    let mut pairs = parts(&outcomes, SQUARE + OF_TIME, force);
    pairs.extend(parts(&outcomes, energy, |record| record.normal.stored.stored()));
    pairs.extend(parts(&outcomes, energy, |record| record.normal.dissipated));
    Ok(pairs)
}

fn creep() -> Attempt<Pairs> {
    let outcomes = both(|| Sketch::of(ball(1.0)).body(gel()).steps(5).press(1e-3, 0.5).hold_force(5.0))?;
    Ok(parts(&outcomes, SQUARE + OF_TIME, |record| record.normal.indentation.unwrap_or(0.0)))
}

fn maugis() -> Attempt<Pairs> {
    let law = || Ok(Adhesion::Maugis(Maugis { work: si(1e-4)?, stress: si(0.03)? }));
    let outcomes = both(|| Sketch::of(ball(1.0)).adhesion(law()).steps(4).indent(0.01, 1.0).indent(0.0, 1.0))?;
    Ok(parts(&outcomes, 1.0, force))
}

/// A ball of R = 1 on springs of k = 10, pressed, drawn back until nothing but the attraction holds it, and apart.
fn sprung() -> Attempt<Pairs> {
    let (stiffness, stress, range, pixel) = (10.0, 0.02, 5e-3, 0.5 / 96.0);
    let (pressed, back, stretch) = (0.01, -0.004, stress / stiffness);
    let law = Adhesion::Maugis(Maugis { work: si(stress * range)?, stress: si(stress)? });
    let body = Body::Winkler(Winkler { modulus: si(1.0)?, thickness: si(1.0 / stiffness)? });
    let solver = HalfSpace { grid: NonZeroUsize::new(96), window: Some(si(0.5)?), ..HalfSpace::default() };
    let scene = Sketch::of(ball(1.0)).ground(Ok(body)).adhesion(Ok(law)).half_space(solver).steps(4);
    let outcome = scene.indent(pressed, 1.0).indent(back, 1.0).retract(1e-3).run()?;
    let end = |entry: usize| outcome.records.iter().rfind(|record| record.entry == entry).ok_or("no record");
    let (inmost, last, apart) = (end(0)?, end(1)?, end(2)?);
    // What touches, what has been drawn in, and what is held in the end, by the heights up to which it is.
    let (touching, joined, held) = (pressed + stretch, pressed + range, back + range + stretch);
    let pushed = TAU * stiffness * touching * (pressed - 0.5 * touching);
    let forces = [pushed - TAU * stress * (joined - touching), -TAU * stress * held];
    let snap = 0.5 * stress * stretch;
    let counted = |height: f64| 2.0 * ((2.0 * height).sqrt() / pixel).powf(2.0 / 3.0) * pixel * pixel;
    let part = |found: f64, right: f64, bound: f64| ((found - right) / bound, 0.0);
    Ok(vec![
        part(inmost.normal.force, forces[0], stress * counted(joined)),
        part(last.normal.force, forces[1], stress * counted(held)),
        part(
            last.normal.dissipated,
            TAU * snap * (2.0 * joined - held),
            snap * (2.0 * counted(joined) + counted(held)),
        ),
        part(apart.normal.force, 0.0, stress * pixel * pixel),
        part(apart.normal.dissipated, TAU * snap * 2.0 * joined, snap * 2.0 * counted(joined)),
    ])
}

/// A ball of R = 1 that comes within a range it is not lifted through.
fn first_touch() -> Attempt<Pairs> {
    let stress = 0.02;
    let law = Adhesion::Maugis(Maugis { work: si(1e-4)?, stress: si(stress)? });
    let solver = HalfSpace { grid: NonZeroUsize::new(96), window: Some(si(0.2)?), ..HalfSpace::default() };
    let outcome = Sketch::of(ball(1.0)).adhesion(Ok(law)).half_space(solver).steps(1).indent(1e-4, 1.0).run()?;
    let lost = 2.0 / 3.0 * stress * stress * (8.0 * stress / PI).powi(3);
    Ok(outcome.records.iter().take(1).map(|record| (record.normal.dissipated, lost)).collect())
}

/// A ball of R = 1, w = ρ = 1e-4, E* a million times what the attraction bends.
fn fading() -> Attempt<Pairs> {
    let (work, range) = (1e-4, 1e-4);
    let law = Adhesion::Exponential(Exponential { work: si(work)?, range: si(range)? });
    let solver = HalfSpace { grid: NonZeroUsize::new(64), window: Some(si(0.12)?), ..HalfSpace::default() };
    let scene = Sketch::of(ball(1.0)).body(elastic(1e6, 0.0)).adhesion(Ok(law)).half_space(solver).steps(10);
    let outcome = scene.indent(1e-9, 1.0).retract(1e-3).run()?;
    let apart = outcome.records.iter().filter_map(|record| {
        let depth = record.normal.indentation.filter(|depth| *depth < -1e-6 && *depth > -5.0 * range)?;
        Some((record.normal.force, -TAU * work * (depth / range).exp()))
    });
    Ok(apart.collect())
}

/// A ball of R = E* = 1 and w = 1e-4: the part by which the force at which it lets go is above JKR's, times μ.
fn shrinking() -> Attempt<Pairs> {
    const WORK: f64 = 1e-4;
    let of = |(range, grid): (f64, usize)| {
        let law = Adhesion::Exponential(Exponential { work: si(WORK)?, range: si(range)? });
        let scene = Sketch::of(ball(1.0)).adhesion(Ok(law)).pixels(grid).steps(20);
        let outcome = scene.indent(1e-3, 1.0).indent(-8e-3, 1.0).run()?;
        let pull = outcome.records.iter().map(|record| -record.normal.force).fold(0.0, f64::max);
        let tabor = (WORK * WORK).cbrt() / range;
        Ok((((pull / (1.5 * PI * WORK) - 1.0) * tabor / 0.1 - 1.0) * 7.0, 0.0))
    };
    [(1e-4 / 0.03, 48), (1e-4 / 0.06, 64)].into_iter().map(of).collect()
}

fn hard() -> Attempt<Pairs> {
    let body =
        || Ok(Body::Plastic(Plastic { young: si(0.75)?, poisson: si(0.5)?, limit: PlasticLimit::Hardness(si(1e6)?) }));
    let pressed = |scene: Sketch| scene.pixels(GRID).steps(3).press(1e-3, 1.0).press(0.0, 1.0).run();
    let outcomes = [pressed(Sketch::of(ball(1.0)).body(body()))?, pressed(Sketch::of(ball(1.0)))?];
    Ok(parts(&outcomes, 1.0, |record| record.normal.indentation.unwrap_or(0.0)))
}
