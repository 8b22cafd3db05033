//! A layered body as a bed: stiffness and resolvent of a flat punch, tabulated over its radius.

use super::Ground;
use super::kernel::Kernel;
use super::line_load::LineLoad;
use super::octave::Octave;
use super::wide::{self, Thin, Wide};
use crate::material::{Joint, Stack};
use crate::numerics::{legendre, quadrature};
use crate::shape::Profile;
use std::collections::VecDeque;
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, FRAC_PI_2};
use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::{Arc, LazyLock, Mutex, OnceLock, PoisonError};

/// Upper border of the first octave, in thicknesses, where what lies below is not much softer.
const FIRST: f64 = 0.25;
/// Octaves of the radius from there on by the integral equation: up to 64 thicknesses of the top layer.
const OCTAVES: u32 = 9;
/// Octaves beyond them on a rigid base: up to a million thicknesses.
const WIDER: usize = 14;
/// Most octaves below: a radius of 1e-15 thicknesses.
const FINER: u32 = 48;

/// Places and weights along each side of a rectangle that is smaller than a layer, and along larger ones.
static RULES: LazyLock<[Vec<(f64, f64)>; 2]> =
    LazyLock::new(|| [4, 16].map(|count| (0..count).map(|k| quadrature::node_and_weight(count, k)).collect()));

/// Shares of bodies that add up to one are wrong by less.
const WHOLE: f64 = 1e-12;

/// Relative error of stiffness and depth at most, on bases over twelve decades of the modulus.
pub(super) const TABLES: f64 = 1e-10;

/// Two bodies of which at least one has layers, pressed together.
///
/// Lengths within are in thicknesses of the thinnest top layer, moduli E* that of the two bodies as if they ended
/// nowhere below their tops.
#[derive(Debug)]
pub struct Layers {
    unit: f64,
    kernel: Kernel,
    /// E* times what the whole gives per uniform pressure [m]; infinite where it does so without an end.
    compression: f64,
    /// Upper border of the first octave, in thicknesses.
    first: f64,
    /// Octaves by the integral equation, and those beyond.
    octaves: Vec<OnceLock<Octave>>,
    /// The layers, if nothing gives below them.
    thin: Option<Thin>,
    wide: OnceLock<Option<Wide>>,
    /// Displacements of springs and the line load that goes with them, the last that were asked for.
    last: Mutex<VecDeque<(LineLoad, Arc<LineLoad>)>>,
    /// The last measure asked for and its radius.
    found: LastFound,
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

/// What lies on a rigid base, if all of it does: under p = cos kx a bonded layer that cannot be compressed gives
/// by k²h³/3G.
fn thin(parts: &[(f64, Stack)], unit: f64) -> Option<Thin> {
    if parts.iter().any(|(_, stack)| stack.base.is_some()) {
        return None;
    }
    let squeezed = |(share, stack): &(f64, Stack)| match stack.sheets.as_slice() {
        [one] if one.poisson >= 0.5 && one.joint == Joint::Bonded => Some(share * (one.thickness / unit).powi(3)),
        _ => None,
    };
    let softness = parts.iter().map(squeezed).sum::<Option<f64>>();
    let thickness = |stack: &Stack| stack.sheets.iter().map(|sheet| sheet.thickness / unit).sum::<f64>();
    let thickest = parts.iter().map(|(_, stack)| thickness(stack)).fold(0.0, f64::max);
    Some(softness.map_or(Thin::Pressed(thickest), |softness| Thin::Squeezed(2.0 / 3.0 * softness)))
}

impl Layers {
    /// The layers of two bodies with their shares in the compliance of their tops, E*/E*ᵢ; a body without layers has
    /// none to be named.
    #[must_use]
    pub fn new(parts: Vec<(f64, Stack)>) -> Self {
        let tops = parts.iter().filter_map(|(_, stack)| stack.sheets.first());
        let unit = tops.map(|top| top.thickness).fold(f64::INFINITY, f64::min);
        let least = parts.iter().map(|(_, stack)| stack.least_wave_number()).fold(f64::INFINITY, f64::min);
        let compression = parts.iter().map(|(share, stack)| share * stack.compression()).sum::<f64>();
        // What a body without layers gives has no end.
        let whole = parts.iter().map(|(share, _)| share).sum::<f64>() > 1.0 - WHOLE;
        let thin = thin(&parts, unit);
        let lacking = move |t: f64| parts.iter().map(|(share, stack)| share * stack.lacking(t / unit)).sum();
        let kernel = Kernel::new(lacking, least * unit);
        // Small punches have s = a/(1 − K(0, 0)a): a stiff layer on a soft base bends below far smaller ones.
        let bent = kernel.between(0.0, 0.0).abs();
        let finer = (0..FINER).find(|&n| bent * FIRST <= f64::from(n).exp2()).unwrap_or(FINER);
        Self {
            unit,
            kernel,
            compression: if whole { compression } else { f64::INFINITY },
            first: FIRST / f64::from(finer).exp2(),
            octaves: vec![OnceLock::new(); (OCTAVES + finer) as usize + WIDER],
            thin: thin.filter(|_| whole),
            wide: OnceLock::new(),
            last: Mutex::default(),
            found: LastFound::default(),
        }
    }

    /// Borders of an octave, in thicknesses.
    fn interval(&self, octave: usize) -> (f64, f64) {
        let high = self.first * (octave as f64).exp2();
        (if octave == 0 { 0.0 } else { 0.5 * high }, high)
    }

    /// Number of octaves by the integral equation.
    fn solved(&self) -> usize {
        self.octaves.len() - WIDER
    }

    /// Radius of the widest punch by the integral equation, in thicknesses.
    fn widest(&self) -> f64 {
        self.interval(self.solved() - 1).1
    }

    /// Punches beyond them, if they are known.
    fn wide(&self) -> Option<&Wide> {
        self.wide.get_or_init(|| Wide::of(&self.kernel, self.thin?)).as_ref()
    }

    fn kept(&self, octave: usize) -> Option<&Octave> {
        let kept = self.octaves.get(octave)?;
        let wide = if octave < self.solved() { None } else { Some(self.wide()?) };
        let interval = self.interval(octave);
        let Some(wide) = wide else { return Some(kept.get_or_init(|| Octave::solved(&self.kernel, interval))) };
        let before = self.kept(octave - 1)?.end;
        Some(kept.get_or_init(|| Octave::grown(|a| wide.density(a), interval, before)))
    }

    /// Number of octaves that are known for a radius `a`, in thicknesses.
    fn count(&self, a: f64) -> usize {
        if a > self.widest() && self.wide().is_some() { self.octaves.len() } else { self.solved() }
    }

    /// Number of the octave of the radius `a` in thicknesses; of the last one for what lies beyond.
    fn number(&self, a: f64) -> usize {
        let last = self.count(a).saturating_sub(1);
        (0..last).find(|&octave| a <= self.interval(octave).1).unwrap_or(last)
    }

    fn about(&self, a: f64) -> Option<&Octave> {
        self.kept(self.number(a))
    }

    /// The radius `a` [m] in thicknesses, of a contact wider than any that is known that of the widest one, and how many
    /// times wider it is: from there on everything goes on as a power, by which searches find back.
    fn known(&self, a: f64) -> (f64, f64) {
        let thin = a / self.unit;
        let end = self.interval(self.count(thin) - 1).1;
        if thin > end { (end, thin / end) } else { (thin, 1.0) }
    }

    /// The radius `a` [m] in thicknesses, at most that of the widest punch by the integral equation.
    fn within(&self, a: f64) -> f64 {
        (a / self.unit).min(self.widest())
    }

    /// Γ(x; a) per thickness, as a sum of P₂ₘ(x/a).
    fn resolvent(&self, a: f64) -> Vec<f64> {
        self.about(a.min(self.widest())).map_or_else(Vec::new, |octave| octave.resolvent(a))
    }

    /// d_e/g of g = x² at the radius `a` in thicknesses.
    fn square(&self, a: f64) -> f64 {
        let number = self.number(a);
        // From the least octave up, so that none asks down a long way.
        (0..=number)
            .try_fold((None, 0.0), |(_, before), octave| {
                let (share, end) = self.kept(octave)?.square(|| before);
                Some((Some(share), *end))
            })
            .and_then(|(share, _)| share)
            .map_or(1.0, |share| share.at(a))
    }
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
        let octaves = if is_square { self.count(f64::INFINITY) } else { self.solved() };
        self.unit * self.interval(octaves - 1).1
    }

    fn fields_end(&self) -> f64 {
        self.unit * self.widest()
    }

    fn table_error(&self) -> f64 {
        let is_wide = self.wide.get().is_some_and(Option::is_some);
        if is_wide { wide::ERROR } else { TABLES }
    }

    fn measure(&self, a: f64) -> f64 {
        let (known, beyond) = self.known(a);
        self.about(known)
            .map_or(a, |octave| self.unit * known * octave.measure.at(known) * beyond.powf(octave.growth(known)))
    }

    fn radius(&self, s: f64) -> f64 {
        if s.is_infinite() { s } else { self.found.get_or(s, || self.radius_at(s)) }
    }

    fn density(&self, a: f64) -> f64 {
        let (known, beyond) = self.known(a);
        self.about(known).map_or(1.0, |octave| octave.edge.at(known).powi(2) * beyond.powf(octave.growth(known) - 1.0))
    }

    fn growth(&self, a: f64) -> f64 {
        let (known, _) = self.known(a);
        self.about(known).map_or(1.0, |octave| octave.growth(known))
    }

    fn density_growth(&self, a: f64) -> f64 {
        let (known, beyond) = self.known(a);
        let Some(octave) = self.about(known) else { return 0.0 };
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
            return self.square(self.known(a).0);
        }
        let thin = self.within(a);
        let a = thin * self.unit;
        let Some(octave) = self.about(thin) else { return 1.0 };
        let (resolvent, high) = (self.resolvent(thin), profile.reduced(a));
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
        let Some(octave) = self.about(thin) else { return 0.0 };
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
        let displaced = |x: f64| (if x <= a { load.at(x) } else { 0.0 }) - load.taken(&self.kernel, x);
        FRAC_2_PI * quadrature::panels(|theta| displaced(r * theta.sin()), (0.0, FRAC_PI_2), &breaks)
    }

    fn wave(&self, k: f64) -> f64 {
        if k > 0.0 { 2.0 * (1.0 - self.kernel.lacking(k * self.unit)).max(0.0) / k } else { self.compression }
    }

    /// What a half-space gives without (1/π)∫∫∫(1 − M)J₀(kr)dk dA, which changes over a layer's thickness only.
    fn under_rectangle(&self, away: [f64; 2], sides: [f64; 2], endless: f64) -> f64 {
        let [small, large] = &*RULES;
        let rule = if sides[0].max(sides[1]) > self.unit { large } else { small };
        let along = |axis: usize, at: f64| (away[axis] + 0.5 * sides[axis] * at) / self.unit;
        let row = |&(y, down): &(f64, f64)| {
            let lacking = |&(x, across): &(f64, f64)| across * self.kernel.around(along(0, x).hypot(along(1, y)));
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
        match (0..self.octaves.len()).map_while(|octave| self.kept(octave)).find(|kept| thin <= kept.end) {
            Some(octave) => self.unit * octave.radius(thin),
            None => {
                let end = self.unit * self.interval(self.count(f64::INFINITY) - 1).1;
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
        let edge = |b: f64| self.about(b).map_or(1.0, |octave| octave.edge.at(b));
        let series: Vec<Vec<f64>> = displaced.nodes().map(|(b, _)| self.resolvent(b)).collect();
        let weights: Vec<(f64, f64)> =
            displaced.nodes().zip(displaced.values()).map(|((b, weight), v)| (b, weight * v * edge(b))).collect();
        let load = LineLoad::of(&borders, |x| {
            let high = borders.iter().copied().find(|&border| border > x).unwrap_or(a);
            let beyond = weights.iter().zip(&series).filter(|((b, _), _)| *b > high);
            let far: f64 = beyond.map(|((b, weight), series)| weight * legendre::even_sum(series, x / b)).sum();
            let grown = |b: f64| displaced.at(b) * edge(b) * legendre::even_sum(&self.resolvent(b), x / b);
            displaced.at(x) * edge(x) + quadrature::panel(grown, x, high) + far
        });
        let load = Arc::new(load);
        last.truncate(KEPT - 1);
        last.push_front((displaced, load.clone()));
        load
    }
}
