//! A layered body as a bed: stiffness and resolvent of a flat punch, tabulated over its radius.

use super::Ground;
use super::kernel::Kernel;
use super::line_load::LineLoad;
use super::punch::{self, Punch};
use crate::material::Stack;
use crate::numerics::chebyshev::Chebyshev;
use crate::numerics::quadrature;
use crate::numerics::{legendre, root};
use crate::shape::Profile;
use std::collections::VecDeque;
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, FRAC_PI_2};
use std::sync::{Arc, LazyLock, Mutex, OnceLock, PoisonError};

/// Nodes per octave of the radius.
const NODES: usize = 20;
/// Upper border of the first octave, in thicknesses, where what lies below is not much softer.
const FIRST: f64 = 0.25;
/// Octaves of the radius from there on: up to 64 thicknesses of the top layer.
const OCTAVES: u32 = 9;
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
    octaves: Vec<OnceLock<Octave>>,
    /// Displacements of springs and the line load that goes with them, the last that were asked for.
    last: Mutex<VecDeque<(LineLoad, Arc<LineLoad>)>>,
}

/// Punches of the radii of one octave.
#[derive(Debug, Clone)]
struct Octave {
    /// s(a)/a over a.
    measure: Chebyshev,
    /// a(s)/s over s.
    radius: Chebyshev,
    /// s at its end.
    end: f64,
    /// q₁(a; a) over a.
    edge: Chebyshev,
    /// Coefficients of q₁(x; a) over a.
    load: Vec<Chebyshev>,
    /// Coefficients of Γ(x; a) over a.
    resolvent: Vec<Chebyshev>,
}

impl Octave {
    /// d ln s/d ln a at the radius `a`.
    fn growth(&self, a: f64) -> f64 {
        self.edge.at(a).powi(2) / self.measure.at(a)
    }
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
            octaves: vec![OnceLock::new(); (OCTAVES + finer) as usize],
            last: Mutex::default(),
        }
    }

    /// Borders of an octave, in thicknesses.
    fn interval(&self, octave: usize) -> (f64, f64) {
        let high = self.first * (octave as f64).exp2();
        (if octave == 0 { 0.0 } else { 0.5 * high }, high)
    }

    /// Radius of the widest punch, in thicknesses.
    fn widest(&self) -> f64 {
        self.interval(self.octaves.len() - 1).1
    }

    fn kept(&self, octave: usize) -> Option<&Octave> {
        Some(self.octaves.get(octave)?.get_or_init(|| self.octave(octave)))
    }

    fn octave(&self, octave: usize) -> Octave {
        let interval = self.interval(octave);
        let radii: Vec<f64> = Chebyshev::nodes(NODES, interval).collect();
        let rule = punch::rule(punch::count(interval.1));
        let punches: Vec<Punch> = radii.iter().map(|&a| Punch::new(&self.kernel, a, &rule)).collect();
        let over = |of: &dyn Fn(&Punch, f64) -> f64| {
            let values: Vec<f64> = punches.iter().zip(&radii).map(|(punch, &a)| of(punch, a)).collect();
            Chebyshev::met(&values, interval)
        };
        let series = |of: fn(&Punch) -> &Vec<f64>| -> Vec<Chebyshev> {
            (0..rule.nodes().len()).map(|m| over(&|punch, _| of(punch).get(m).copied().unwrap_or(0.0))).collect()
        };
        let measure = over(&|punch, a| punch.measure / a);
        let (low, high) = interval;
        let ends = (low * measure.at(low), high * measure.at(high));
        let inverse = |s: f64| root::within(|a| a * measure.at(a) - s, low, high) / s;
        Octave {
            end: ends.1,
            radius: Chebyshev::of(inverse, NODES, ends),
            edge: over(&|punch, _| punch.edge),
            load: series(|punch| &punch.load),
            resolvent: series(|punch| &punch.resolvent),
            measure,
        }
    }

    /// The octave of the radius `a` in thicknesses; the last one for what lies beyond.
    fn about(&self, a: f64) -> Option<&Octave> {
        let last = self.octaves.len().saturating_sub(1);
        self.kept((0..last).find(|&octave| a <= self.interval(octave).1).unwrap_or(last))
    }

    /// The radius `a` [m] in thicknesses, of a contact wider than any that is known that of the widest one, and how many
    /// times wider it is: from there on everything goes on as a power, by which searches find back.
    fn known(&self, a: f64) -> (f64, f64) {
        let (thin, end) = (a / self.unit, self.widest());
        if thin > end { (end, thin / end) } else { (thin, 1.0) }
    }

    /// Γ(x; a) per thickness, as a sum of P₂ₘ(x/a).
    fn resolvent(&self, a: f64) -> Vec<f64> {
        self.about(a).map_or_else(Vec::new, |octave| coefficients(&octave.resolvent, a))
    }
}

/// The coefficients of a punch of the radius `a`.
fn coefficients(series: &[Chebyshev], a: f64) -> Vec<f64> {
    series.iter().map(|coefficient| coefficient.at(a)).collect()
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

    fn end(&self) -> f64 {
        self.unit * self.widest()
    }

    fn table_error(&self) -> f64 {
        TABLES
    }

    fn measure(&self, a: f64) -> f64 {
        let (known, beyond) = self.known(a);
        self.about(known)
            .map_or(a, |octave| self.unit * known * octave.measure.at(known) * beyond.powf(octave.growth(known)))
    }

    fn radius(&self, s: f64) -> f64 {
        if s.is_infinite() {
            return s;
        }
        let thin = s / self.unit;
        let last = self.octaves.len().saturating_sub(1);
        match (0..=last).filter_map(|octave| self.kept(octave)).find(|kept| thin <= kept.end) {
            // One step of Newton doubles the digits of the table, whose function is a root where the layer is thin.
            Some(octave) => {
                let a = thin * octave.radius.at(thin);
                self.unit * (a - (a * octave.measure.at(a) - thin) / octave.edge.at(a).powi(2))
            }
            None => {
                let end = self.end();
                end * (s / self.measure(end)).powf(self.growth(end).recip())
            }
        }
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

    /// d_e = g(a) − ∫Γ(g(a) − g(ξ))dξ/q₁(a): what an edge without a load needs of the other places.
    fn depth_share(&self, profile: &dyn Profile, a: f64) -> f64 {
        let (thin, _) = self.known(a);
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
        let (thin, _) = self.known(a);
        let Some(octave) = self.about(thin) else { return 0.0 };
        let height = root / a;
        let load = coefficients(&octave.load, thin).into_iter().zip(legendre::inverses_in_the_middle());
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
