//! Contacts much wider than layers on a rigid base, where the integral equation loses its digits.
//!
//! With M(t) → mtⁿ towards long waves, n = 1 of a layer that can be compressed and 3 of one that cannot, the springs are
//! q₁² → Aaⁿ, A = π/(2ⁿ m Γ((n + 1)/2)²), as of a body graded by that power. The border of the contact adds a length to its
//! radius and what bends there fades, so that q₁²/Aaⁿ is a smooth function of 1/a: the polynomial that is 1 at 1/a = 0
//! and meets punches of moderate radii is known on the whole way between. What is left of the reflection at the base,
//! e^(−2βa), is nothing from 10 thicknesses on.
//!
//! A layer that can hardly be compressed (ν a little below 1/2), or a stack much thicker than its topmost layer, turns from
//! one power to the other on its way: then a wider punch is not met, and nothing is told.

use super::kernel::Kernel;
use super::punch::{self, Punch};
use std::f64::consts::PI;

/// Relative error of stiffness and depth beyond the integral equation.
pub(super) const ERROR: f64 = 1e-8;
/// Punches that are met, their radii in thicknesses from the least on.
const MET: usize = 9;
const LEAST: f64 = 10.0;
const MOST: f64 = 64.0;
/// Radii that must be met as well; further out a layer that cannot be compressed leaves no digits to the equation.
const TRIED: [f64; 2] = [35.0, 72.0];
/// Wave numbers squared, times the thickness of the stack squared, from which the longest waves are led to the limit.
const LONG: (f64, f64) = (0.005, 0.05);
/// Part of M/t that is enough for a layer that can be compressed.
const ENOUGH: f64 = 1e-3;

/// What lies on a rigid base, lengths in thicknesses of the topmost layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Thin {
    /// Single bonded layers that cannot be compressed, M → mt³; m = 2/3 of one that is one thick.
    Squeezed(f64),
    /// Other layers, of that thickness together.
    Pressed(f64),
}

/// q₁² of wide punches.
#[derive(Debug, Clone)]
pub(super) struct Wide {
    power: i32,
    leading: f64,
    series: Newton,
}

impl Wide {
    /// Of layers on a rigid base; `None` if they are not known beyond their punches.
    pub(super) fn of(kernel: &Kernel, thin: Thin) -> Option<Self> {
        let (power, softness) = match thin {
            Thin::Squeezed(softness) => (3, softness),
            Thin::Pressed(thickness) => (1, longest(kernel, thickness)?),
        };
        // Γ(1) = Γ(2) = 1.
        let leading = PI / (f64::from(power).exp2() * softness);
        let density = |a: f64| Punch::new(kernel, a, &punch::rule(punch::count(a))).edge.powi(2);
        let rest = |u: f64| density(u.recip()) * u.powi(power) / leading;
        let nodes: Vec<f64> = nodes((MOST.recip(), LEAST.recip())).collect();
        let points = std::iter::once((0.0, 1.0)).chain(nodes.into_iter().map(|u| (u, rest(u)))).collect();
        let wide = Self { power, leading, series: Newton::through(points) };
        let is_met = |a: f64| (wide.density(a) / density(a) - 1.0).abs() < ERROR;
        TRIED.into_iter().all(is_met).then_some(wide)
    }

    /// q₁(a; a)² at the radius `a`.
    pub(super) fn density(&self, a: f64) -> f64 {
        self.leading * a.powi(self.power) * self.series.at(a.recip())
    }
}

/// m of M → mt, from waves longer than the layers are thick: M/t is even.
fn longest(kernel: &Kernel, thickness: f64) -> Option<f64> {
    let at = |square: f64| {
        let t = square.sqrt() / thickness;
        (square, (1.0 - kernel.lacking(t)) / t)
    };
    let points: Vec<(f64, f64)> = nodes(LONG).map(at).collect();
    let most = points.iter().fold(0.0f64, |most, point| most.max(point.1.abs()));
    Some(Newton::through(points).at(0.0)).filter(|softness| *softness > ENOUGH * most)
}

/// Chebyshev's nodes of an interval, those first that lie far apart, by which Newton's differences keep their digits.
fn nodes(interval: (f64, f64)) -> impl Iterator<Item = f64> {
    let nodes: Vec<f64> = crate::numerics::chebyshev::Chebyshev::nodes(MET, interval).collect();
    // Every fourth of nine, round and round: 0 4 8 3 7 2 6 1 5.
    (0..MET).filter_map(move |k| nodes.get(4 * k % MET).copied())
}

/// A polynomial by Newton's divided differences.
#[derive(Debug, Clone)]
struct Newton(Vec<(f64, f64)>);

impl Newton {
    /// Through points (x, y).
    fn through(mut points: Vec<(f64, f64)>) -> Self {
        for order in 1..points.len() {
            for k in (order..points.len()).rev() {
                points[k].1 = (points[k].1 - points[k - 1].1) / (points[k].0 - points[k - order].0);
            }
        }
        Self(points)
    }

    fn at(&self, x: f64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, &(node, difference)| sum * (x - node) + difference)
    }
}
