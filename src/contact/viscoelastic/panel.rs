//! A stretch of the continuous bed whose springs are known at a few places and smooth between them.
//!
//! The springs of a panel joined and left the indenter in the same motions. What each carried when the last of
//! these had ended is kept at the nodes of Gauss and Legendre; since then all of them have moved alike, which is
//! two numbers per Maxwell element, whatever the number of motions. Between the nodes the polynomial through them
//! tells, and a sum over the panel is the sum over its nodes.

use super::Spectrum;
use super::alike::Alike;
use super::spring::{Free, Spring};
use super::totals::{Numbers, Totals};
use crate::numerics::quadrature;
use smallvec::smallvec;
use std::sync::{Arc, LazyLock};

/// Nodes of a panel: polynomials of degree fifteen.
const NODES: usize = 16;
/// What rounding leaves of the last coefficients of a polynomial, relative to the greatest value.
const ROUNDING: f64 = 2e-14;
/// What the work of the springs that join or leave may miss, as a part of it or of all that was done before.
const COUNTED: f64 = 1e-12;
/// Most panels of one stretch beyond those its borders ask for: the worst are halved first, and what the others miss
/// is part of the estimate.
const MOST_PANELS: usize = 512;

/// Nodes on [−1, 1], their weights, those of the barycentric formula, and the last two Legendre coefficients.
struct NodeRule {
    nodes: [f64; NODES],
    weights: [f64; NODES],
    barycentric: [f64; NODES],
    last: [[f64; NODES]; 2],
}

static RULE: LazyLock<NodeRule> = LazyLock::new(|| {
    let pairs: [(f64, f64); NODES] = std::array::from_fn(|k| quadrature::node_and_weight(NODES, k));
    let sign = |k: usize| if k.is_multiple_of(2) { 1.0 } else { -1.0 };
    NodeRule {
        nodes: pairs.map(|(x, _)| x),
        weights: pairs.map(|(_, w)| w),
        // Wang & Xiang 2012: (−1)ᵏ √((1 − xₖ²) wₖ).
        barycentric: std::array::from_fn(|k| {
            let (x, w) = pairs[k];
            sign(k) * ((1.0 - x * x) * w).sqrt()
        }),
        last: [NODES - 2, NODES - 1].map(|degree| pairs.map(|(x, w)| (to_f64(degree) + 0.5) * w * legendre(degree, x))),
    }
});

#[expect(clippy::cast_precision_loss, reason = "a degree below the number of nodes")]
fn to_f64(degree: usize) -> f64 {
    degree as f64
}

fn legendre(degree: usize, x: f64) -> f64 {
    let next = |(before, p): (f64, f64), k: usize| {
        let n = to_f64(k);
        (p, ((2.0 * n + 1.0) * x * p - n * before) / (n + 1.0))
    };
    (1..degree).fold((1.0, x), next).1
}

/// A spring at the end of a motion, and ∫ q dt [N s/m] over it.
pub(super) struct Lived {
    pub spring: Spring,
    pub impulse: f64,
}

/// Springs between two distances from the axis [m].
#[derive(Debug, Clone)]
pub(super) struct Panel {
    pub inner: f64,
    pub outer: f64,
    pub held: bool,
    /// What its springs share with those of the same past, of which they are a smooth function together; zero where
    /// they share nothing.
    pub past: u64,
    /// Whether the springs are known, not their sums alone; those held by no element have no states.
    is_known: bool,
    /// Node by node: element loads [N/m] of springs held; modes and rest [m] of free ones.
    states: Arc<[f64]>,
    /// Element loads [N/m] from the motion since then, alike for all springs held.
    memory: Numbers,
    /// What is left of the states since then.
    kept: Numbers,
    /// Sums over the panel, of both halves of the bed.
    totals: Totals,
    /// What the polynomial misses of a state [N/m] or [m].
    missed: f64,
    /// The same without what it has been let miss of corners: those are gone, and what is left of the springs is told.
    uneven: f64,
    /// The greatest of the states [N/m] or [m].
    greatest: f64,
}

/// The states of springs as numbers in a row.
fn numbers<'s>(springs: impl IntoIterator<Item = &'s Spring>) -> Vec<f64> {
    let mut row = Vec::new();
    for spring in springs {
        match spring {
            Spring::Pressed(loads) => row.extend_from_slice(loads),
            Spring::Free(free) => row.extend(free.modes.iter().chain([&free.rest])),
        }
    }
    row
}

/// Places of the nodes and what is integrated at each: 2 dx.
fn nodes(inner: f64, outer: f64) -> impl Iterator<Item = (f64, f64)> {
    let half = 0.5 * (outer - inner);
    RULE.nodes.iter().zip(&RULE.weights).map(move |(node, w)| (inner + half * (1.0 + node), 2.0 * half * w))
}

/// Springs that may become a panel, at its nodes.
struct PanelDraft {
    inner: f64,
    outer: f64,
    springs: Vec<Lived>,
    /// Their states as numbers in a row.
    states: Vec<f64>,
    /// Greatest number of a state.
    greatest: f64,
    /// The last coefficients of the polynomials, and what they miss at the ends.
    tail: f64,
    /// ∫ |∫ q dt| dx [N s] over the panel, and what the last coefficients say of it.
    impulse: [f64; 2],
}

impl PanelDraft {
    fn new(inner: f64, outer: f64, lived: &dyn Fn(f64) -> Lived) -> Self {
        let springs: Vec<Lived> = nodes(inner, outer).map(|(x, _)| lived(x)).collect();
        let states = numbers(springs.iter().map(|lived| &lived.spring));
        let greatest = states.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let dim = states.len() / NODES;
        let mut tail = 0f64;
        for j in 0..dim {
            for row in &RULE.last {
                let coefficient: f64 = row.iter().zip(states.chunks_exact(dim)).map(|(r, state)| r * state[j]).sum();
                tail = tail.max(coefficient.abs());
            }
        }
        // On this side of the borders: beyond them springs have another past.
        let within = (16.0 * f64::EPSILON * outer).min(0.25 * (outer - inner));
        for (end, at) in [(inner + within, -1.0), (outer - within, 1.0)] {
            let there = numbers([&lived(end).spring]);
            for (seen, value) in interpolated(&states, at).iter().zip(&there) {
                // The polynomial grows towards its ends: it is no better there than a hundredth of this.
                tail = tail.max(0.01 * (seen - value).abs());
            }
        }
        let impulse = impulse_and_tail(&springs).map(|value| value * (outer - inner));
        Self { inner, outer, springs, states, greatest, tail, impulse }
    }

    fn is_smooth(&self, greatest: f64, grain: Grain) -> bool {
        let part = (self.outer - self.inner) / self.outer;
        self.tail <= (ROUNDING * greatest).max(grain.floor) || self.tail * part <= grain.tolerance * greatest
    }

    /// Whether halving it leads nowhere; `impulse` [N s] is what its own is counted against.
    fn is_final(&self, (greatest, impulse): (f64, f64), grain: Grain) -> bool {
        let middle = 0.5 * (self.inner + self.outer);
        let counted = self.impulse[1] <= COUNTED * impulse;
        counted && self.is_smooth(greatest, grain) || middle <= self.inner || middle >= self.outer
    }

    fn halves(&self, lived: &dyn Fn(f64) -> Lived) -> [Self; 2] {
        let middle = 0.5 * (self.inner + self.outer);
        [Self::new(self.inner, middle, lived), Self::new(middle, self.outer, lived)]
    }

    fn finished(self, spectrum: &Spectrum, speed: f64) -> (Panel, f64) {
        let (mut totals, mut work) = (Totals::new(spectrum), 0.0);
        for (lived, (_, w)) in self.springs.iter().zip(nodes(self.inner, self.outer)) {
            totals.add(&lived.spring, w);
            work += w * speed * lived.impulse;
        }
        let held = self.springs.iter().all(|lived| matches!(lived.spring, Spring::Pressed(_)));
        let states: Arc<[f64]> = self.states.into();
        let dim = states.len() / NODES;
        let panel = Panel {
            inner: self.inner,
            outer: self.outer,
            held,
            past: 0,
            is_known: true,
            memory: smallvec![0.0; dim],
            kept: smallvec![1.0; dim],
            totals,
            missed: self.tail,
            uneven: self.tail,
            greatest: self.greatest,
            states,
        };
        (panel, work)
    }
}

/// The mean of |∫ q dt| [N s/m] of springs at the nodes, and the greater of the last two coefficients.
fn impulse_and_tail(springs: &[Lived]) -> [f64; 2] {
    let mean = RULE.weights.iter().zip(springs).map(|(w, lived)| 0.5 * w * lived.impulse.abs()).sum();
    let last = |row: &[f64; NODES]| row.iter().zip(springs).map(|(r, lived)| r * lived.impulse).sum::<f64>().abs();
    [mean, RULE.last.iter().map(last).fold(0.0, f64::max)]
}

/// What the nodes have of the polynomial at −1 ≤ y ≤ 1.
fn shares(y: f64) -> [f64; NODES] {
    let rule = &*RULE;
    let weights: [f64; NODES] = std::array::from_fn(|k| rule.barycentric[k] / (y - rule.nodes[k]));
    let all = weights.iter().sum::<f64>();
    if all.is_finite() {
        let part = all.recip();
        return weights.map(|weight| weight * part);
    }
    // At a node itself.
    weights.map(|weight| if weight.is_finite() { 0.0 } else { 1.0 })
}

/// The states between the nodes, at −1 ≤ y ≤ 1.
fn interpolated(states: &[f64], y: f64) -> Vec<f64> {
    let dim = states.len() / NODES;
    let mut sum = vec![0.0; dim];
    for (share, row) in shares(y).iter().zip(states.chunks_exact(dim.max(1))) {
        sum.iter_mut().zip(row).for_each(|(sum, value)| *sum += share * value);
    }
    sum
}

/// One number of the springs of a panel, at one instant.
#[derive(Debug, Clone)]
pub(super) struct Strip {
    inner: f64,
    pub outer: f64,
    values: [f64; NODES],
}

impl Strip {
    /// Its value at the distance `x` from the axis.
    pub(super) fn at(&self, x: f64) -> f64 {
        let y = (2.0 * x - self.inner - self.outer) / (self.outer - self.inner);
        shares(y.clamp(-1.0, 1.0)).iter().zip(&self.values).map(|(share, value)| share * value).sum()
    }
}

/// How well polynomials tell the springs of panels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grain {
    /// Loads [N/m] or displacements [m] far below do not count.
    pub scale: f64,
    /// What a polynomial may miss, relative to the greatest state and to the part of the radius it covers.
    pub tolerance: f64,
    /// ∫ F dt [N s] beside which that of the springs is counted.
    pub impulse: f64,
    /// What rounding leaves of a state, however small it is: [N/m] or [m].
    pub floor: f64,
}

/// Panels of springs between `borders`, which `lived` tells at the end of a motion at the speed v, and the work
/// v ∫ F dt [J] done on them. They are halved until smooth, the worst first.
pub(super) fn panels(
    spectrum: &Spectrum,
    borders: &[f64],
    speed: f64,
    grain: Grain,
    lived: &dyn Fn(f64) -> Lived,
) -> (Vec<Panel>, f64) {
    let mut drafts: Vec<PanelDraft> = borders.windows(2).map(|pair| PanelDraft::new(pair[0], pair[1], lived)).collect();
    let greatest = drafts.iter().fold(grain.scale, |most: f64, draft| most.max(draft.greatest));
    let impulse = grain.impulse + drafts.iter().map(|draft| draft.impulse[0]).sum::<f64>();
    let most = MOST_PANELS + drafts.len();
    let mut done = Vec::new();
    while !drafts.is_empty() {
        let (ready, rough): (Vec<_>, Vec<_>) =
            drafts.into_iter().partition(|draft| draft.is_final((greatest, impulse), grain));
        done.extend(ready);
        let spare = most.saturating_sub(done.len() + rough.len());
        drafts = rough;
        if spare < drafts.len() {
            drafts.sort_by(|a, b| b.tail.total_cmp(&a.tail));
            done.extend(drafts.split_off(spare));
        }
        drafts = drafts.into_iter().flat_map(|draft| draft.halves(lived)).collect();
    }
    done.sort_by(|a, b| a.inner.total_cmp(&b.inner));
    let finish = |draft: PanelDraft| PanelDraft { greatest, ..draft }.finished(spectrum, speed);
    let (panels, works): (Vec<_>, Vec<_>) = done.into_iter().map(finish).unzip();
    (panels, works.iter().sum())
}

impl Panel {
    /// Free springs of which nothing is known.
    pub(super) fn unknown(spectrum: &Spectrum, inner: f64, outer: f64) -> Self {
        let (totals, states) = (Totals::new(spectrum), Arc::new([]));
        let (memory, kept) = (Numbers::new(), Numbers::new());
        let (missed, uneven, greatest) = (0.0, 0.0, 0.0);
        Self {
            inner,
            outer,
            held: false,
            past: 0,
            is_known: false,
            states,
            memory,
            kept,
            totals,
            missed,
            uneven,
            greatest,
        }
    }

    /// Panels side by side, all held or all free, as one of which only the sums are known; `None` of none.
    pub(super) fn sum_of(spectrum: &Spectrum, panels: &[Self]) -> Option<Self> {
        let (first, last) = (panels.first()?, panels.last()?);
        let mut sum = Self { held: first.held, ..Self::unknown(spectrum, first.inner, last.outer) };
        panels.iter().for_each(|panel| sum.totals.join(&panel.totals));
        Some(sum)
    }

    /// Whether its springs are not known one by one.
    pub(super) fn is_sum(&self) -> bool {
        !self.is_known
    }

    /// The spring at the distance `x` from the axis, now.
    pub(super) fn spring(&self, x: f64) -> Spring {
        let y = (2.0 * x - self.inner - self.outer) / (self.outer - self.inner);
        let mut values = interpolated(&self.states, y.clamp(-1.0, 1.0));
        let since = self.kept.iter().zip(&self.memory);
        values.iter_mut().zip(since).for_each(|(value, (kept, memory))| *value = *value * kept + memory);
        if self.held {
            return Spring::Pressed(values);
        }
        let rest = values.pop().unwrap_or(0.0);
        Spring::Free(Free { rest, modes: values })
    }

    /// A number of its springs as they are now, linear in their states.
    pub(super) fn strip(&self, of: impl Fn(&Spring) -> f64) -> Strip {
        let places: Vec<f64> = nodes(self.inner, self.outer).map(|(x, _)| x).collect();
        let values = std::array::from_fn(|k| of(&self.spring(places[k])));
        Strip { inner: self.inner, outer: self.outer, values }
    }

    /// The part of the panel from `inner` to `outer`.
    pub(super) fn part(&self, spectrum: &Spectrum, inner: f64, outer: f64) -> Self {
        let here = |x: f64| Lived { spring: self.spring(x), impulse: 0.0 };
        let springs: Vec<Lived> = nodes(inner, outer).map(|(x, _)| here(x)).collect();
        let (greatest, tail) = (self.greatest * self.left(), self.missed * self.left());
        let states = numbers(springs.iter().map(|lived| &lived.spring));
        let draft = PanelDraft { inner, outer, springs, states, greatest, tail, impulse: [0.0; 2] };
        Self { past: self.past, uneven: self.uneven * self.left(), ..draft.finished(spectrum, 0.0).0 }
    }

    /// Whether its springs and those of the next panel are of one past.
    pub(super) fn goes_on_in(&self, next: &Self) -> bool {
        self.past > 0 && self.past == next.past && self.held == next.held
    }

    /// One panel for two, if one polynomial tells both; it may miss as much of a corner between them as the `tolerance`.
    pub(super) fn joined_with(&self, next: &Self, spectrum: &Spectrum, tolerance: f64) -> Option<Self> {
        if self.held != next.held || self.is_sum() || next.is_sum() {
            return None;
        }
        let lived = |x: f64| Lived { spring: if x < next.inner { self } else { next }.spring(x), impulse: 0.0 };
        let draft = PanelDraft::new(self.inner, next.outer, &lived);
        let greatest = draft.greatest.max(self.greatest * self.left()).max(next.greatest * next.left());
        let seam = |x: f64| {
            let one = interpolated(&draft.states, (2.0 * x - self.inner - next.outer) / (next.outer - self.inner));
            let both = numbers([&lived(x).spring]);
            one.iter().zip(&both).all(|(one, both)| (one - both).abs() <= (4.0 * ROUNDING).max(tolerance) * greatest)
        };
        let ends =
            [self.inner, 0.5 * (self.inner + self.outer), next.inner, 0.5 * (next.inner + next.outer), next.outer];
        let missed = self.missed.max(next.missed).max(draft.tail);
        let uneven = self.uneven.max(next.uneven).max(draft.tail.min(2.0 * ROUNDING * greatest));
        let smooth = draft.tail <= (2.0 * ROUNDING).max(tolerance) * greatest && ends.into_iter().all(seam);
        let past = if self.past == next.past { self.past } else { 0 };
        smooth.then(|| Self { past, missed, uneven, greatest, ..draft.finished(spectrum, 0.0).0 })
    }

    /// What is integrated over the springs held: 2 dx [m].
    fn weight(&self) -> f64 {
        if self.held { 2.0 * (self.outer - self.inner) } else { 0.0 }
    }

    /// Work of the Maxwell elements [J] in a motion in which nothing happens to the springs.
    pub(super) fn work(&self, motion: &Alike) -> f64 {
        motion.speed * motion.impulse(&self.totals.loads, self.weight())
    }

    /// A motion in which nothing happens to the springs.
    pub(super) fn pass(&mut self, motion: &Alike) {
        self.totals.evolve(motion, self.weight());
        if self.held {
            motion.press(&mut self.memory);
            self.kept.iter_mut().zip(&motion.elements).for_each(|(kept, fading)| *kept *= fading.kept);
        } else {
            self.kept.iter_mut().zip(&motion.modes).for_each(|(kept, mode)| *kept *= mode);
        }
    }

    /// ∫ Σ sᵢ 2 dx [N] over springs held.
    pub(super) fn load(&self) -> f64 {
        self.totals.loads.iter().sum()
    }

    /// What is left of what there was when the panel was made.
    fn left(&self) -> f64 {
        self.kept.iter().fold(0.0, |most: f64, kept| most.max(*kept))
    }

    /// What the polynomials miss of that [N].
    pub(super) fn missed(&self) -> f64 {
        2.0 * (self.outer - self.inner) * self.missed * self.left()
    }

    /// How far the load [N/m] or displacement [m] of a spring may be off.
    pub(super) fn doubt(&self) -> f64 {
        4.0 * (self.uneven + ROUNDING * self.greatest) * self.left()
    }

    /// Energy in the Maxwell elements, or in the free springs [J].
    pub(super) fn stored(&self, spectrum: &Spectrum) -> f64 {
        self.totals.stored(spectrum)
    }

    /// Bytes of state.
    pub(super) fn bytes(&self) -> usize {
        size_of::<f64>() * (self.states.len() + 5 * self.kept.len() + 8)
    }
}
