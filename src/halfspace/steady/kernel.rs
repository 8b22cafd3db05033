//! What a pressure that slides does to the ground, wave by wave or pixel by pixel.

use crate::ground::Ground;
use crate::halfspace::Boundary;
use crate::halfspace::grid::{Grid, mean_over_period};
use crate::halfspace::kernel::{Beneath, Rectangle};
use crate::halfspace::spectrum::spectrum_of_even_columns;
use crate::halfspace::transform::{Size, good_length};
use crate::material::Spectrum;
use crate::numerics::quadrature::{self, node_and_weight};
use rayon::prelude::*;
use realfft::num_complex::Complex;
use std::f64::consts::TAU;
use std::sync::{Arc, LazyLock};

/// How late the ground gives way, in the solver's units: E∞J(s) = J₀ + Σ Jₘ(1 − e^{−s/ℓₘ}), s the way since the load.
pub(super) struct Late {
    /// E∞J₀.
    at_once: f64,
    /// E∞Jₘ, and the way ℓₘ = vλₘ in units of the pixel.
    modes: Vec<(f64, f64)>,
}

impl Late {
    /// Of the `spectrum` at the `speed` \[m/s\], lengths in `unit` \[m\].
    pub(super) fn new(spectrum: &Spectrum, speed: f64, unit: f64) -> Self {
        let modulus = spectrum.equilibrium();
        let modes = spectrum.modes().iter().map(|mode| (modulus * mode.compliance, speed * mode.time / unit));
        Self { at_once: modulus * spectrum.glass_compliance(), modes: modes.collect() }
    }

    /// E∞/E*(−k_x v) of a wave of the wave number `kx` along the motion.
    fn compliance(&self, kx: f64) -> Complex<f64> {
        let late = |&(share, way): &(f64, f64)| share / Complex::new(1.0, -kx * way);
        self.modes.iter().map(late).fold(Complex::from(self.at_once), |sum, late| sum + late)
    }
}

/// Multipliers of a period: pressure → displacement, pressure → −∂u/∂ξ; and what a pixel gives under itself.
pub(super) struct Symbols {
    pub(super) period: Size,
    pub(super) influence: Vec<Complex<f64>>,
    pub(super) slope: Vec<Complex<f64>>,
    pub(super) compliance: f64,
}

/// Wave numbers along and across the motion over a quarter of the frequencies, column first.
fn waves(grid: &Grid, period: Size) -> impl Iterator<Item = (f64, f64)> {
    let step = [TAU / (grid.pixel[0] * period.columns as f64), TAU / (grid.pixel[1] * period.rows as f64)];
    let across = (0..=period.columns / 2).map(move |k| k as f64 * step[0]);
    across.flat_map(move |kx| (0..=period.rows / 2).map(move |k| (kx, k as f64 * step[1])))
}

/// What a wave of the pressure gives at rest; an endless one zero where everything would sink without an end.
fn at_rest(beneath: Option<Beneath<'_>>, q: f64) -> f64 {
    beneath.map_or_else(|| if q > 0.0 { 2.0 / q } else { 0.0 }, |beneath| beneath.wave(q))
}

/// What lies beneath, if it is no half-space, and the length \[m\] in which the solver measures.
#[derive(Clone, Copy)]
pub(super) struct Depths<'g> {
    pub(super) ground: Option<&'g Arc<dyn Ground>>,
    pub(super) unit: f64,
}

impl<'g> Depths<'g> {
    fn beneath(self) -> Option<Beneath<'g>> {
        self.ground.map(|ground| Beneath { ground: ground.as_ref(), unit: self.unit })
    }
}

/// Every wave by itself.
pub(super) fn periodic(grid: &Grid, late: &Late, depths: Depths<'_>) -> Symbols {
    let (period, beneath) = (grid.size, depths.beneath());
    let places: Vec<(f64, f64)> = waves(grid, period).collect();
    let given = |&(kx, ky): &(f64, f64)| late.compliance(kx) * at_rest(beneath, kx.hypot(ky));
    let influence: Vec<Complex<f64>> = places.par_iter().map(given).collect();
    // The shortest wave along the rows has no slope on its pixels.
    let sloping = (period.rows / 2 + 1) * period.columns.div_ceil(2);
    let turned = |(index, (given, (kx, _))): (usize, (&Complex<f64>, &(f64, f64)))| {
        if index < sloping { given * Complex::new(0.0, -kx) } else { Complex::default() }
    };
    let slope = influence.iter().zip(&places).enumerate().map(turned).collect();
    let rest: Vec<f64> = places.iter().map(|&(kx, ky)| at_rest(beneath, kx.hypot(ky))).collect();
    let compliance = mean_over_period(&rest, period);
    Symbols { period, influence, slope, compliance }
}

/// Roughly displacement → pressure, every wave by itself.
pub(super) fn inverse(grid: &Grid, late: &Late, (boundary, depths): (Boundary, Depths<'_>)) -> Vec<Complex<f64>> {
    let beneath = depths.beneath();
    let shortest = [grid.pixel[0] * grid.size.columns as f64, grid.pixel[1] * grid.size.rows as f64];
    // Of the wave without an end, about that of the window.
    let longest = match boundary {
        Boundary::Periodic => at_rest(beneath, TAU / shortest[0].max(shortest[1])),
        Boundary::Free => shortest[0].min(shortest[1]),
    };
    let given = |(kx, ky): (f64, f64)| {
        let rest = at_rest(beneath, kx.hypot(ky));
        (late.compliance(kx) * if rest > 0.0 { rest } else { longest }).inv()
    };
    waves(grid, grid.size).map(given).collect()
}

/// Nodes within a pixel: of the influence integrated over the way.
const NODES: usize = 12;

static RULE: LazyLock<[(f64, f64); NODES]> = LazyLock::new(|| {
    std::array::from_fn(|k| {
        let (x, w) = node_and_weight(NODES, k);
        (0.5 * (1.0 + x), 0.5 * w)
    })
});

/// Ways, in parts of ℓ, between which e^{−s/ℓ} is a polynomial to rounding, and beyond which nothing is left of it.
const FADING: [f64; 6] = [0.0, 4.0, 10.0, 18.0, 28.0, 40.0];
/// What is given while a pixel passes, in parts of what is given at once, up to which pixels are told apart by their middles.
const BENIGN: f64 = 4.0;
/// Ways, in pixels, below which what gives way late is better known from the slope of what gives way at once.
const SHORT: f64 = 1e-3;

/// ∫ of R(s) e^{−s/ℓ} ds/ℓ over the first `length` of the way.
fn stretch(given: &impl Fn(f64) -> f64, length: f64, way: f64) -> f64 {
    let panel = |from: f64, to: f64| {
        let term = |&(x, w): &(f64, f64)| {
            let s = from + (to - from) * x;
            w * given(s) * (-s / way).exp()
        };
        (to - from) / way * RULE.iter().map(term).sum::<f64>()
    };
    let borders = FADING.map(|part| (part * way).min(length));
    borders.windows(2).filter(|pair| pair[1] > pair[0]).map(|pair| panel(pair[0], pair[1])).sum()
}

/// The same over all that lies beyond `x`, where the influence falls like that of a point.
fn beyond(given: &impl Fn(f64) -> f64, x: f64, way: f64) -> f64 {
    let (mut from, mut sum) = (0.0, 0.0);
    while from < 40.0 * way {
        let to = from + (x + from).min(4.0 * way);
        sum += quadrature::panel(|s| given(x + s) * (-s / way).exp() / way, from, to);
        from = to;
    }
    sum
}

/// The influence of one pixel along a row, taken late over the way ℓ: K(x) = ∫₀^∞ R(x + s) e^{−s/ℓ} ds/ℓ, at the steps
/// −n..=n of the period 2n, from the back to the front.
pub(super) fn late_row(given: &impl Fn(f64) -> f64, n: usize, way: f64) -> Vec<f64> {
    if way <= 0.0 {
        return (0..=2 * n).map(|k| given((k as f64 - n as f64).abs())).collect();
    }
    let keeps = (-way.recip()).exp();
    let mut row = vec![0.0; 2 * n + 1];
    row[2 * n] = beyond(given, n as f64, way);
    for k in (0..2 * n).rev() {
        let x = k as f64 - n as f64;
        let at = |s: f64| given((x + s).abs());
        // The influence has corners at the borders of its own pixel.
        let near = stretch(&at, 0.5, way) + (-0.5 / way).exp() * stretch(&|s| at(0.5 + s), 0.5, way);
        row[k] = near + keeps * row[k + 1];
    }
    row
}

/// K half a pixel behind, at the steps −n..=n, where the load of each pixel before has passed by as a whole.
fn late_row_behind(given: &impl Fn(f64) -> f64, n: usize, way: f64) -> Vec<f64> {
    let at = |k: usize| move |s: f64| given((k as f64 - n as f64 - 0.5 + s).abs());
    let keeps = (-way.recip()).exp();
    let mut row = vec![0.0; 2 * n + 1];
    row[2 * n] = stretch(&at(2 * n), 0.5, way) + (-0.5 / way).exp() * beyond(given, n as f64, way);
    for k in (0..2 * n).rev() {
        row[k] = stretch(&at(k), 1.0, way) + keeps * row[k + 1];
    }
    row
}

/// How much of what gives way late over the way ℓ is looked at half a pixel behind: of the part that is left of it a pixel
/// later, as much as what is given while a pixel passes is more than [`BENIGN`] times what is given at once.
///
/// What gives way late is behind by a quarter of a turn from pixel to pixel, and pixels that take turns do next to nothing
/// in their middles; half a pixel behind they do. It is the choice of differences taken in the middle or against the wind
/// (Spalding 1972, Int. J. Numer. Methods Eng. 4, 551), and an error of less than half a pixel.
fn behind(late: &Late, along: f64, way: f64) -> f64 {
    let passing = |&(share, way): &(f64, f64)| if way > 0.0 { -share * (-along / way).exp_m1() } else { share };
    let passing: f64 = late.modes.iter().map(passing).sum();
    let more = 1.0 - BENIGN * late.at_once / passing;
    if way > 0.0 && more > 0.0 { more * (-way.recip()).exp() } else { 0.0 }
}

/// −dK/dx = (R − K)/ℓ \[per pixel\] at the place `x` of a row; where that is little of much, −∫ R′(x + s) e^{−s/ℓ} ds/ℓ.
fn falling((row, x): (usize, f64), (late, way): (f64, f64), rectangle: &Rectangle) -> f64 {
    if way > SHORT {
        return late / way;
    }
    let slope = |s: f64| (x + s).signum() * rectangle.slope_at_place(row as f64, (x + s).abs());
    if way > 0.0 { -stretch(&slope, 40.0 * way, way) } else { 0.0 }
}

/// A body that stands alone: pixel by pixel, zero-padded.
pub(super) fn free(grid: &Grid, late: &Late) -> Symbols {
    let size = grid.size;
    let period = Size { rows: 2 * good_length(size.rows), columns: 2 * good_length(size.columns) };
    let (n, rectangle) = (period.columns / 2, Rectangle::new(grid.pixel[0], grid.pixel[1]));
    let along = grid.pixel[0];
    let rows = period.rows / 2 + 1;
    let of_row = |row: usize| {
        let given = |column: f64| rectangle.at_place(row as f64, column);
        let (mut influence, mut slope) = (vec![0.0; period.columns], vec![0.0; period.columns]);
        let at = |k: usize| (k + period.columns - n) % period.columns;
        for k in 0..period.columns {
            influence[at(k)] = late.at_once * given((k as f64 - n as f64).abs());
        }
        for &(share, way) in &late.modes {
            let way = way / along;
            let taken = late_row(&given, n, way);
            let behind = behind(late, along, way);
            let later = if behind > 0.0 { late_row_behind(&given, n, way) } else { taken.clone() };
            for k in 0..period.columns {
                let rest = given((k as f64 - n as f64).abs());
                influence[at(k)] += share * ((1.0 - behind) * taken[k] + behind * later[k]);
                slope[at(k)] += share / along * falling((row, k as f64 - n as f64), (rest - taken[k], way), &rectangle);
            }
        }
        (influence, slope)
    };
    let (influence, slope): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (0..rows).into_par_iter().map(of_row).unzip();
    Symbols {
        period,
        compliance: rectangle.at_place(0.0, 0.0),
        influence: spectrum_of_even_columns(&influence.concat(), period),
        slope: spectrum_of_even_columns(&slope.concat(), period),
    }
}
