//! A layered body as a bed: stiffness and resolvent of a flat punch, tabulated over its radius.

use super::Ground;
use super::line_load::LineLoad;
use super::punches::Punches;
use super::wide;
use crate::material::Stack;
use crate::numerics::{legendre, quadrature};
use crate::shape::Profile;
use std::collections::VecDeque;
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, FRAC_PI_2};
use std::sync::atomic::Ordering::Relaxed;
use std::sync::atomic::{AtomicBool, AtomicU64};
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

/// Places and weights along each side of a rectangle that is smaller than a layer, and along larger ones.
static RULES: LazyLock<[Vec<(f64, f64)>; 2]> =
    LazyLock::new(|| [4, 16].map(|count| (0..count).map(|k| quadrature::node_and_weight(count, k)).collect()));

/// Relative error of stiffness and depth at most, on bases over twelve decades of the modulus.
pub(super) const TABLES: f64 = 1e-10;

/// Two bodies of which at least one has layers, pressed together.
///
/// Lengths within are in thicknesses of the thinnest top layer, moduli E* that of the two bodies as if they ended
/// nowhere below their tops.
#[derive(Debug)]
pub struct Layers {
    unit: f64,
    punches: Arc<Punches>,
    /// Displacements of springs and the line load that goes with them, the last that were asked for.
    last: Mutex<VecDeque<(LineLoad, Arc<LineLoad>)>>,
    /// The last measure asked for and its radius.
    found: LastFound,
    /// Whether punches wider than those by the integral equation were asked for.
    beyond: AtomicBool,
}

/// An argument and its value, the last that were found, for each is asked for several times in turn.
///
/// What one thread writes while another reads is told by the first word, the exclusive or of both.
#[derive(Debug, Default)]
struct LastFound([AtomicU64; 2]);

impl LastFound {
    fn get_or(&self, argument: f64, find: impl FnOnce() -> f64) -> f64 {
        let [both, value] = self.0.each_ref().map(|word| word.load(Relaxed));
        if both ^ value == argument.to_bits() {
            return f64::from_bits(value);
        }
        let found = find();
        self.0[0].store(argument.to_bits() ^ found.to_bits(), Relaxed);
        self.0[1].store(found.to_bits(), Relaxed);
        found
    }
}

impl Layers {
    /// The layers of two bodies with their shares in the compliance of their tops, E*/E*ᵢ; a body without layers has
    /// none to be named.
    #[must_use]
    pub fn new(parts: Vec<(f64, Stack)>) -> Self {
        let tops = parts.iter().filter_map(|(_, stack)| stack.sheets.first());
        let unit = tops.map(|top| top.thickness).fold(f64::INFINITY, f64::min);
        let (last, found, beyond) = (Mutex::default(), LastFound::default(), AtomicBool::default());
        Self { unit, punches: Punches::on(&parts, unit), last, found, beyond }
    }

    /// Takes note of a radius `a` that is asked for, in thicknesses.
    fn asked_for(&self, a: f64) {
        if a > self.punches.widest() {
            self.beyond.store(true, Relaxed);
        }
    }

    /// Number of octaves that are known for a radius `a`, in thicknesses.
    fn count(&self, a: f64) -> usize {
        self.asked_for(a);
        self.punches.count(a)
    }

    /// The radius `a` [m] in thicknesses, of a contact wider than any that is known that of the widest one, and how many
    /// times wider it is: from there on everything goes on as a power, by which searches find back.
    fn known(&self, a: f64) -> (f64, f64) {
        let thin = a / self.unit;
        let end = self.punches.interval(self.count(thin) - 1).1;
        if thin > end { (end, thin / end) } else { (thin, 1.0) }
    }

    /// The radius `a` [m] in thicknesses, at most that of the widest punch by the integral equation.
    fn within(&self, a: f64) -> f64 {
        (a / self.unit).min(self.punches.widest())
    }
}

/// `ratio` to a power that is not asked for where the ratio is one.
fn raised(ratio: f64, power: impl FnOnce() -> f64) -> f64 {
    if ratio > 1.0 { ratio.powf(power()) } else { 1.0 }
}

/// Borders near the edge at `a` of panels that see a kernel one thickness wide.
fn toward_edge(a: f64) -> Vec<f64> {
    let mut distances: Vec<f64> = std::iter::successors(Some(1.0), |d| Some(2.0 * d)).take_while(|&d| d < a).collect();
    distances.reverse();
    distances.into_iter().map(|distance| a - distance).collect()
}

fn merged(mut one: Vec<f64>, other: Vec<f64>) -> Vec<f64> {
    one.extend(other);
    one.sort_by(f64::total_cmp);
    one
}

impl Ground for Layers {
    fn scale(&self) -> Option<f64> {
        Some(self.unit)
    }

    fn end(&self, profile: &dyn Profile, asked: f64) -> f64 {
        let is_square = profile.is_square() && asked > self.fields_end();
        let octaves = if is_square { self.count(f64::INFINITY) } else { self.punches.solved() };
        self.unit * self.punches.interval(octaves - 1).1
    }

    fn fields_end(&self) -> f64 {
        self.unit * self.punches.widest()
    }

    fn table_error(&self) -> f64 {
        let is_wide = self.beyond.load(Relaxed) && self.punches.wide().is_some();
        if is_wide { wide::ERROR } else { TABLES }
    }

    fn measure(&self, a: f64) -> f64 {
        let (known, beyond) = self.known(a);
        let Some(octave) = self.punches.about(known) else { return a };
        self.unit * known * octave.measure.at(known) * raised(beyond, || octave.growth(known))
    }

    fn radius(&self, s: f64) -> f64 {
        if s.is_infinite() { s } else { self.found.get_or(s, || self.radius_at(s)) }
    }

    fn density(&self, a: f64) -> f64 {
        let (known, beyond) = self.known(a);
        let Some(octave) = self.punches.about(known) else { return 1.0 };
        octave.edge.at(known).powi(2) * raised(beyond, || octave.growth(known) - 1.0)
    }

    fn growth(&self, a: f64) -> f64 {
        let (known, _) = self.known(a);
        self.punches.about(known).map_or(1.0, |octave| octave.growth(known))
    }

    fn density_growth(&self, a: f64) -> f64 {
        let (known, beyond) = self.known(a);
        let Some(octave) = self.punches.about(known) else { return 0.0 };
        if beyond > 1.0 {
            return octave.growth(known) - 1.0;
        }
        let (edge, slope) = octave.edge.with_slope(known);
        2.0 * known * slope / edge
    }

    /// d_e = g(a) − ∫Γ(g(a) − g(ξ))dξ/q₁(a): what an edge without a load needs of the other places; of g = x²/R by
    /// `Octave::square`.
    fn depth_share(&self, profile: &dyn Profile, a: f64) -> f64 {
        if profile.is_square() {
            return self.punches.square(self.known(a).0);
        }
        let thin = self.within(a);
        let a = thin * self.unit;
        let Some(octave) = self.punches.about(thin) else { return 1.0 };
        let (resolvent, high) = (self.punches.resolvent(thin), profile.reduced(a));
        let breaks = profile.breaks(a).into_iter().map(|x| x / self.unit).collect();
        let lower = |x: [f64; quadrature::NODES]| {
            let taken = legendre::even_sums(&resolvent, x.map(|x| x / thin));
            std::array::from_fn(|k| taken[k] * (1.0 - profile.reduced(x[k] * self.unit) / high))
        };
        1.0 - quadrature::panels_at_once(lower, (0.0, thin), &merged(breaks, toward_edge(thin))) / octave.edge.at(thin)
    }

    /// By the pairs q₁ = P₂ₘ(x/a), πa p₁ = P₂ₘ(√(1−r²/a²))/(P₂ₘ(0)√(1−r²/a²)).
    fn edge_pressure(&self, root: f64, a: f64) -> f64 {
        let thin = self.within(a);
        let Some(octave) = self.punches.about(thin) else { return 0.0 };
        let height = root / a;
        let load = octave.load(thin).into_iter().zip(legendre::inverses_in_the_middle());
        let raised: Vec<f64> = load.map(|(c, inverse)| c * inverse).collect();
        FRAC_1_PI * legendre::even_sum(&raised, height) / root
    }

    fn pressure(&self, springs: &dyn Fn(f64) -> f64, ends: &[f64], r: f64) -> f64 {
        let load = self.line_load(springs, ends);
        let (a, r) = (load.end(), r / self.unit);
        if r >= a {
            return 0.0;
        }
        let here = load.at(r);
        let to_s = |x: f64| ((x - r) * (x + r)).sqrt();
        let breaks: Vec<f64> = load.borders.iter().filter(|&&x| x > r && x < a).map(|&x| to_s(x)).collect();
        let fall = |s: f64| (here - load.at(r.hypot(s))) / (s * s);
        FRAC_1_PI * (here / to_s(a) + quadrature::panels(fall, (0.0, to_s(a)), &breaks)) / self.unit
    }

    /// u(r) = (2/π)∫₀^r U dx/√(r²−x²), U the displacement of the homogeneous bed under the line load: outside the contact
    /// −∫K q dξ.
    fn surface(&self, springs: &dyn Fn(f64) -> f64, ends: &[f64], r: f64) -> f64 {
        let load = self.line_load(springs, ends);
        let (a, r) = (load.end(), r / self.unit);
        let angle = |x: f64| if x < r { (x / r).asin() } else { FRAC_PI_2 };
        let mut breaks: Vec<f64> = load.borders.iter().map(|&x| angle(x)).collect();
        let beyond = (1..).map(|k: i32| a + f64::from(k)).take_while(|&x| x < r && breaks.len() < MOST_BREAKS);
        breaks.extend(beyond.map(angle).collect::<Vec<_>>());
        let displaced = |x: f64| (if x <= a { load.at(x) } else { 0.0 }) - load.taken(&self.punches.kernel, x);
        FRAC_2_PI * quadrature::panels(|theta| displaced(r * theta.sin()), (0.0, FRAC_PI_2), &breaks)
    }

    fn wave(&self, k: f64) -> f64 {
        let Punches { kernel, compression, .. } = &*self.punches;
        if k > 0.0 { 2.0 * (1.0 - kernel.lacking(k * self.unit)).max(0.0) / k } else { self.unit * compression }
    }

    /// What a half-space gives without (1/π)∫∫∫(1 − M)J₀(kr)dk dA, which changes over a layer's thickness only.
    fn under_rectangle(&self, away: [f64; 2], sides: [f64; 2], endless: f64) -> f64 {
        let [small, large] = &*RULES;
        let rule = if sides[0].max(sides[1]) > self.unit { large } else { small };
        let along = |axis: usize, at: f64| (away[axis] + 0.5 * sides[axis] * at) / self.unit;
        let row = |&(y, down): &(f64, f64)| {
            let lacking =
                |&(x, across): &(f64, f64)| across * self.punches.kernel.around(along(0, x).hypot(along(1, y)));
            0.25 * down * rule.iter().map(lacking).sum::<f64>()
        };
        let area = sides[0] * (sides[1] / self.unit);
        endless - FRAC_1_PI * area * rule.iter().map(row).sum::<f64>()
    }
}

/// Line loads that are kept.
const KEPT: usize = 4;
/// Most borders of panels of a surface.
const MOST_BREAKS: usize = 40;

impl Layers {
    /// The radius [m] at which the measure is `s` [m].
    fn radius_at(&self, s: f64) -> f64 {
        let thin = s / self.unit;
        match self.punches.reaching(thin) {
            Some(octave) => {
                let radius = octave.radius(thin);
                self.asked_for(radius);
                self.unit * radius
            }
            None => {
                let end = self.unit * self.punches.interval(self.count(f64::INFINITY) - 1).1;
                end * (s / self.measure(end)).powf(self.growth(end).recip())
            }
        }
    }

    /// The line load of springs displaced by `springs`: v(x)q₁(x; x) + ∫_x^a v(b)q₁(b; b)Γ(x; b) db. The last ones are
    /// kept, for they are asked for at many radii.
    fn line_load(&self, springs: &dyn Fn(f64) -> f64, ends: &[f64]) -> Arc<LineLoad> {
        let a = ends.last().map_or(0.0, |end| end / self.unit);
        let mut borders = merged(ends.iter().map(|end| end / self.unit).collect(), toward_edge(a));
        borders.dedup();
        let displaced = LineLoad::of(&borders, |b| springs(b * self.unit));
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, load)) = last.iter().find(|(known, _)| *known == displaced) {
            return load.clone();
        }
        let edge = |b: f64| self.punches.about(b).map_or(1.0, |octave| octave.edge.at(b));
        let series: Vec<Vec<f64>> = displaced.nodes().map(|(b, _)| self.punches.resolvent(b)).collect();
        let weights: Vec<(f64, f64)> =
            displaced.nodes().zip(displaced.values()).map(|((b, weight), v)| (b, weight * v * edge(b))).collect();
        let load = LineLoad::of(&borders, |x| {
            let high = borders.iter().copied().find(|&border| border > x).unwrap_or(a);
            let beyond = weights.iter().zip(&series).filter(|((b, _), _)| *b > high);
            let far: f64 = beyond.map(|((b, weight), series)| weight * legendre::even_sum(series, x / b)).sum();
            let grown = |b: f64| displaced.at(b) * edge(b) * legendre::even_sum(&self.punches.resolvent(b), x / b);
            displaced.at(x) * edge(x) + quadrature::panel(grown, x, high) + far
        });
        let load = Arc::new(load);
        last.truncate(KEPT - 1);
        last.push_front((displaced, load.clone()));
        load
    }
}
