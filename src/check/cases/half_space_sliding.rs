//! Stick and slip on pixels, beside the bed of a ball and beside Mindlin's compliances of ellipses.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, elastic, si};
use crate::contact::elliptic::EllipticHertz;
use crate::contact::state::Tangential;
use crate::run::record::Record;
use crate::scene::solver::{HalfSpace, Tractions};
use crate::shape::{Ellipsoid, FlatPunch, Shape};
use std::f64::consts::PI;
use std::num::NonZeroUsize;

pub(super) const CASES: &[Case] = &[
    Case::new("half-space/Cattaneo and Mindlin on 128²", Proof::Order, 1.0, "slid, let go and slid back: a turning point is two depths of which a force misses at most (Δ/a)²/8: 1.5 times that of the largest, stored and lost energy four times as much; printed as the part of the bound used").weak("one ball and history").by(cattaneo),
    Case::new("half-space/stick and slip under an ellipse", Proof::Order, 1.0, "Hertz' ellipse along both axes, T = μF(1 − (1 − u/u_s)^{3/2}) with Mindlin's compliances; to ((Δ/b)² + Δ/50b) of μF, for ⟨cos²φ⟩ feels the edge; printed as the part of the bound used").weak("radii 1 to 0.25 and one grid").by(slid_ellipse),
    Case::new("half-space/a punch that sticks while it is pressed", Proof::Other, 5e-3, "F = 2aE*d ln(3 − 4ν)/(1 − 2ν), ν = 0 (Mossakovskii 1963), with the a of the pixels: half of what its edge misses on 20² (Spence 1968 has slip at the edge alone)").weak("one ν and grid").by(stuck_punch),
];

/// A punch on a body of ν = 0, pressures and shear found together, μ = 5.
fn stuck_punch() -> Attempt<Pairs> {
    let solver = HalfSpace {
        grid: NonZeroUsize::new(40),
        window: Some(si(2.5)?),
        tractions: Some(Tractions::Coupled),
        ..HalfSpace::default()
    };
    let scene = Sketch::of(Ok(Shape::FlatPunch(FlatPunch { radius: si(1.0)? }))).body(elastic(1.0, 0.0));
    let pressed = scene.coulomb(5.0).steps(2).half_space(solver).indent(0.01, 1.0).run()?;
    let state = pressed.records.last().map(|record| record.normal).ok_or("no record")?;
    let a = state.contact_radius.ok_or("no contact")?;
    Ok(vec![(state.force / (2.0 * a * 0.01), 3.0_f64.ln())])
}

/// A ball, R = E* = 1, a = 0.1, pressed and slid to and fro, beside the bed.
fn cattaneo() -> Attempt<Pairs> {
    let square = 0.125 * (3.0 / 128.0_f64).powi(2);
    let scene = || {
        let turned = Sketch::of(ball(1.0)).coulomb(0.5).steps(6).indent(0.01, 1.0).slide(0.004);
        turned.indent(0.008, 1.0).slide(-0.002).slide(0.001)
    };
    let [pixels, bed] = [scene().pixels(128).run()?, scene().run()?];
    let mut pairs = Pairs::new();
    let mut compared = |times: f64, of: fn(&Tangential) -> f64| {
        let of = |record: &Record| record.tangential.as_ref().map_or(0.0, of);
        let largest = bed.records.iter().map(|record| of(record).abs()).fold(f64::MIN_POSITIVE, f64::max);
        let part = |(one, other): (&Record, &Record)| ((of(one) - of(other)) / (largest * times * square), 0.0);
        pairs.extend(pixels.records.iter().zip(&bed.records).map(part));
    };
    compared(1.5, |state| state.force);
    compared(6.0, |state| state.stored.unwrap_or(0.0));
    compared(6.0, |state| state.dissipated.unwrap_or(0.0));
    Ok(pairs)
}

/// Ellipses, E* = 1, slid along their axes.
fn slid_ellipse() -> Attempt<Pairs> {
    let (grid, coefficient, along) = (128, 0.5, 2.0 * (1.0 - 0.3) / (2.0 - 0.3));
    let mut pairs = Pairs::new();
    for [x, y] in [[1.0, 0.25], [0.25, 1.0]] {
        let shape = Ok(Shape::Ellipsoid(Ellipsoid { radius_x: si(x)?, radius_y: si(y)? }));
        let scene = Sketch::of(shape).body(elastic(0.91, 0.3)).coulomb(coefficient).steps(4).pixels(grid);
        let slid = scene.press(1e-3, 1.0).slide(0.003).run()?;
        let [major, minor] = EllipticHertz::at_force([x, y], 1.0, 1e-3)?.semi_axes;
        let cosine = if x > y { lying(major, minor) } else { lying(minor, major) };
        let compliance = (1.0 + (1.0 - along) * (1.0 - 2.0 * cosine)) / along;
        let pixel = 3.0 / grid as f64;
        let bound = pixel * pixel + 0.02 * pixel;
        for record in slid.records.iter().filter(|record| record.time > 1.0) {
            let Some((state, depth)) = record.tangential.zip(record.normal.indentation) else { continue };
            let part = 1.0 - (1.0 - state.slide / (coefficient * compliance * depth)).max(0.0).powf(1.5);
            pairs.push(((state.force / (coefficient * record.normal.force) - part) / bound, 0.0));
        }
    }
    Ok(pairs)
}

/// ⟨cos²φ⟩ over the waves of an ellipse with these semi-axes, the waves at φ weighted by 1/√(a²cos²φ + b²sin²φ).
fn lying(a: f64, b: f64) -> f64 {
    let angles = (0..2000).map(|k| (f64::from(k) + 0.5) * PI / 2000.0);
    let weighed = angles.map(|phi| (phi.cos().powi(2), (a * phi.cos()).hypot(b * phi.sin()).recip()));
    let (along, all) = weighed.fold((0.0, 0.0), |(along, all), (part, weight)| (along + part * weight, all + weight));
    along / all
}
