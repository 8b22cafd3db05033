//! The force of a body that relaxes, pressed in and taken away once, without a run.
//!
//! While the contact grows F(t) = ∫E*(t − s) dΦ(d(s)), Φ′(d) = 2a(d) (Lee & Radok 1960); on the way out the integral ends
//! at t₁(t), the time at which the contact first had its present radius, ∫_{t₁}^t E*(t − s) ḋ ds = 0 (Ting 1966). E*(t)
//! relaxation of the effective modulus [Pa], a contact radius [m]; the drive is straight between rows. Holds for a depth
//! that first rises and then falls, and constant ν.

use super::fading::{Fading, NODES, Passing};
use super::slopes::{Number, Sloped, Slopes};
use crate::material::Relaxation;
use crate::numerics::root;
use crate::shape::Profile;
use std::ops::Range;
use std::sync::Arc;

/// A body that relaxes under an indenter.
pub struct Remembering<'r> {
    /// The indenter.
    pub profile: &'r dyn Profile,
    /// E*(t), without viscosity.
    pub relaxation: Arc<Relaxation>,
}

/// Lengths that differ by less, relatively, are one.
const SAME: f64 = 1e-11;
/// Part of the time since first touch below which a piece begins with it, and how often it is halved towards it.
const TOUCH: f64 = 1e-6;
const HALVINGS: i32 = 20;
/// Ratio of the ends of a stretch in time since first touch: polynomials of degree four are off by less than 1e-6 there.
const FINE: f64 = 1.25;
/// What has faded by e^{−60} is not felt.
const GONE: f64 = 60.0;
/// The most steps of Newton's rule, which squares the error, before the root is bracketed instead.
const STEPS: usize = 30;

/// A straight piece of the way in, from first touch on.
struct Piece {
    from: f64,
    to: f64,
    /// Depth at its beginning [m].
    depth: f64,
    /// ḋ [m/s].
    speed: f64,
}

/// The way in, ready to be looked back on; with the slopes that its numbers carry.
struct Way<'w, N> {
    body: &'w Remembering<'w>,
    /// Rates 1/τ of the terms, zero first.
    rates: Vec<N>,
    /// Their moduli [Pa].
    moduli: Vec<f64>,
    /// What a stretch of the usual length does to the memory.
    usual: Fading<N>,
    pieces: Vec<Piece>,
    /// ∫e^{−(from − s)/τ} dΦ for each term, that of equilibrium first [m²], at the beginning of each piece in turn.
    before: Vec<N>,
    /// The same at the end of the last.
    memory: Vec<N>,
    /// First touch [s].
    touch: f64,
}

/// A contact at one time.
struct State<'s, N> {
    /// ∫₀^{t₁} e^{−(t − s)/τ} dΦ for each term [m²].
    felt: &'s [N],
    /// ∫_{t₁}^t e^{−(t − s)/τ} ḋ ds for each term [m].
    since: &'s [N],
    /// Contact radius [m].
    radius: f64,
    /// t − t₁ [s].
    elapsed: f64,
}

/// Whether the depths rise from first touch to the largest and fall from there on.
#[must_use]
pub fn goes_in_once(depths: &[f64], contact: f64) -> bool {
    let turn = (0..depths.len()).max_by(|&a, &b| depths[a].total_cmp(&depths[b])).unwrap_or(0);
    let first = depths[..=turn].iter().rposition(|&d| d <= contact).unwrap_or(0);
    depths[first..=turn].windows(2).all(|pair| pair[1] >= pair[0])
        && depths[turn..].windows(2).all(|pair| pair[1] <= pair[0])
}

impl Remembering<'_> {
    /// Forces [N] at the times `times` [s] and depths `depths` [m], first touch at `contact`.
    ///
    /// # Errors
    /// A depth is beyond the end of the profile.
    pub fn followed(&self, times: &[f64], depths: &[f64], contact: f64) -> Result<Vec<f64>, String> {
        let mut forces = vec![0.0; depths.len()];
        self.led((times, depths), contact, |row, state: State<'_, f64>, way| {
            forces[row] = state.felt.iter().zip(&way.moduli).map(|(sum, modulus)| sum * modulus).sum();
        })?;
        Ok(forces)
    }

    /// The numbers of E*(t): the moduli, that of equilibrium first [Pa], then the times of the terms [s].
    pub fn numbers(&self) -> Vec<f64> {
        let (moduli, times): (Vec<f64>, Vec<f64>) = self.relaxation.terms.iter().copied().unzip();
        [vec![self.relaxation.equilibrium], moduli, times].concat()
    }

    /// Slopes of the forces in all [numbers](Self::numbers), and in first touch.
    ///
    /// On the way out t₁ goes with them: from ∫_{t₁}^t E* ḋ ds = 0 what it adds to the slope of F is 2a(t₁) times the slope
    /// of that integral.
    ///
    /// # Errors
    /// A depth is beyond the end of the profile.
    pub fn slopes(&self, times: &[f64], depths: &[f64], contact: f64) -> Result<Slopes, String> {
        let terms = self.relaxation.terms.len();
        let mut slopes =
            Slopes { numbers: vec![vec![0.0; depths.len()]; 2 * terms + 1], touch: vec![0.0; depths.len()] };
        self.led((times, depths), contact, |row, state: State<'_, Sloped>, way| {
            let (mut relaxed, mut touch) = (0.0, 0.0);
            for (k, (felt, since)) in state.felt.iter().zip(state.since).enumerate() {
                let (modulus, rate) = (way.moduli[k], way.rates[k].value());
                slopes.numbers[k][row] = felt.value + 2.0 * state.radius * since.value;
                relaxed += modulus * (-rate * state.elapsed).exp();
                touch += modulus * rate * felt.by_speed;
                if k > 0 {
                    let by_rate = modulus * (felt.by_rate + 2.0 * state.radius * since.by_rate);
                    slopes.numbers[terms + k][row] = -by_rate * rate * rate;
                }
            }
            // By parts: −∫E* 2da = −2a E*(t − t₁) + ∫2a Σg/τ e^{−(t − s)/τ} ds.
            slopes.touch[row] = touch - 2.0 * state.radius * relaxed;
        })?;
        Ok(slopes)
    }

    /// Leads the contact through a curve and tells its state at each row at which there is one.
    fn led<N: Number>(
        &self,
        (times, depths): (&[f64], &[f64]),
        contact: f64,
        mut told: impl FnMut(usize, State<'_, N>, &Way<'_, N>),
    ) -> Result<(), String> {
        let turn = (0..depths.len()).max_by(|&a, &b| depths[a].total_cmp(&depths[b])).unwrap_or(0);
        let deepest = depths.get(turn).copied().unwrap_or(0.0) - contact;
        if deepest <= 0.0 {
            return Ok(());
        }
        if self.profile.edge(deepest).is_none() {
            return Err(format!("the depth {deepest:e} m is beyond the end of the profile"));
        }
        let first = depths[..=turn].iter().rposition(|&d| d <= contact);
        let first = first.ok_or("the data begin in contact: expected points before it")?;
        let mut way: Way<'_, N> = Way::of(self);
        let nothing = vec![N::constant(0.0); way.rates.len()];
        for at in first..turn {
            let depth = depths[at + 1] - contact;
            way.goes(((times[at], depths[at] - contact), (times[at + 1], depth)));
            let radius = self.radius(depth);
            told(at + 1, State { felt: &way.memory, since: &nothing, radius, elapsed: 0.0 }, &way);
        }
        way.goes_out(&times[turn..], &depths[turn..], |row, state| told(turn + row, state, &way));
        Ok(())
    }

    /// a(d) [m].
    fn radius(&self, depth: f64) -> f64 {
        self.profile.edge(depth.max(0.0)).unwrap_or(0.0)
    }
}

impl<'w, N: Number> Way<'w, N> {
    fn of(body: &'w Remembering<'w>) -> Self {
        let terms = &body.relaxation.terms;
        let rates: Vec<N> = std::iter::once(0.0).chain(terms.iter().map(|term| 1.0 / term.1)).map(N::rate).collect();
        let moduli = std::iter::once(body.relaxation.equilibrium).chain(terms.iter().map(|term| term.0)).collect();
        let memory = vec![N::constant(0.0); rates.len()];
        let usual = Fading::over(&rates, 0.0);
        Self { body, usual, rates, moduli, pieces: Vec::new(), before: Vec::new(), memory, touch: 0.0 }
    }

    /// Goes on straight from one time and depth to another.
    fn goes(&mut self, ((from, depth), (to, end)): ((f64, f64), (f64, f64))) {
        let speed = (end - depth) / (to - from);
        let (mut from, mut depth) = (from, depth);
        if (to - from - self.usual.length).abs() > SAME * (to - from) {
            self.usual = Fading::over(&self.rates, to - from);
        }
        if self.pieces.is_empty() {
            (from, depth) = (from - depth / speed, 0.0);
            self.touch = from;
        }
        let piece = Piece { from, to, depth, speed };
        self.before.extend_from_slice(&self.memory);
        let mut memory = std::mem::take(&mut self.memory);
        self.remember(&piece, (to, to), &mut memory);
        self.memory = memory;
        self.pieces.push(piece);
    }

    /// Takes ∫e^{−(t − s)/τ} dΦ of each term that is still felt at the time `now` from the beginning of a piece to the
    /// time `t` in it.
    fn remember(&self, piece: &Piece, (t, now): (f64, f64), memory: &mut [N]) {
        let (low, high) = (piece.from - self.touch, t - self.touch);
        let speed = N::speed(piece.speed);
        for (from, length) in stretches(low, high) {
            let depth = |node: f64| piece.depth + piece.speed * (from - low + length * node);
            let values = NODES.map(|(node, _)| 2.0 * self.body.radius(depth(node)));
            if (length - self.usual.length).abs() <= SAME * length {
                self.usual.pass(memory, values, speed);
                continue;
            }
            let passing = Passing::new(length, values);
            let felt = memory.iter_mut().zip(&self.rates).filter(|(_, rate)| rate.value() * (now - t) <= GONE);
            felt.for_each(|(sum, rate)| *sum = passing.after(*rate, *sum, speed));
        }
    }

    /// The memories at the beginning of piece `at`.
    fn memories(&self, at: usize) -> Range<usize> {
        at * self.rates.len()..(at + 1) * self.rates.len()
    }

    /// Tells the states on the way out, from the row behind the turn on.
    fn goes_out(&self, times: &[f64], depths: &[f64], mut told: impl FnMut(usize, State<'_, N>)) {
        let Some(mut back) = Back::of(self) else { return };
        let turn = back.turn;
        // ∫ e^{−(t − s)/τ} ḋ ds since the turn.
        let mut since = vec![N::constant(0.0); self.rates.len()];
        let (mut kept, mut held, mut lasted) = (since.clone(), since.clone(), 0.0);
        let mut felt = since.clone();
        for row in 1..times.len() {
            let (h, t) = (times[row] - times[row - 1], times[row]);
            if (h - lasted).abs() > SAME * h {
                lasted = h;
                kept = self.rates.iter().map(|rate| rate.faded(h)).collect();
                held = self.rates.iter().map(|rate| rate.held(h)).collect();
            }
            let speed = (depths[row] - depths[row - 1]) / h;
            for ((sum, kept), held) in since.iter_mut().zip(&kept).zip(&held) {
                *sum = *sum * *kept + *held * speed;
            }
            let Some(grown) = back.grown(self, t, &since) else { return };
            let piece = &self.pieces[back.at];
            self.recalled((back.at, grown), t, &mut felt);
            let whole = if N::SLOPES { back.whole(self, (t - turn, grown), &since) } else { Vec::new() };
            let radius = self.body.radius(piece.depth + piece.speed * (grown - piece.from));
            told(row, State { felt: &felt, since: &whole, radius, elapsed: t - grown });
        }
    }

    /// ∫₀^{t₁} e^{−(t − s)/τ} dΦ of each term that is still felt, with t₁ in piece `at`.
    fn recalled(&self, (at, grown): (usize, f64), t: f64, felt: &mut [N]) {
        let piece = &self.pieces[at];
        felt.copy_from_slice(&self.before[self.memories(at)]);
        self.remember(piece, (grown, t), felt);
        for (sum, rate) in felt.iter_mut().zip(&self.rates) {
            *sum = if rate.value() * (t - grown) > GONE { N::constant(0.0) } else { *sum * rate.faded(t - grown) };
        }
    }
}

/// A look back from the way out to the time t₁ on the way in at which the contact had the same radius.
struct Back<N> {
    /// The piece that holds it.
    at: usize,
    /// When the way out began [s].
    turn: f64,
    /// Per term what is left at the turn of the end of the piece.
    old: Vec<N>,
    /// ∫ e^{−(turn − s)/τ} ḋ ds from the end of the piece to the turn.
    after: Vec<N>,
    /// (1 − e^{−h/τ})τ and e^{−h/τ} over a piece of this length, the last one that was passed.
    whole: (f64, Vec<N>, Vec<N>),
}

impl<N: Number> Back<N> {
    /// At the turn; `None` without a way in.
    fn of(way: &Way<'_, N>) -> Option<Self> {
        let at = way.pieces.len().checked_sub(1)?;
        let (one, none) = (vec![N::constant(1.0); way.rates.len()], vec![N::constant(0.0); way.rates.len()]);
        Some(Self { at, turn: way.pieces[at].to, old: one, after: none, whole: (0.0, Vec::new(), Vec::new()) })
    }

    /// t₁ at the time `t`, back to the piece that holds it; `None` once all springs are free.
    fn grown(&mut self, way: &Way<'_, N>, t: f64, since: &[N]) -> Option<f64> {
        let faded = |k: usize| way.moduli[k] * (-way.rates[k].value() * (t - self.turn)).exp();
        // Moduli of what lies before the turn, as they are felt now.
        let felt: Vec<f64> = (0..way.rates.len()).map(faded).collect();
        let now: f64 = since.iter().zip(&way.moduli).map(|(sum, modulus)| sum.value() * modulus).sum();
        loop {
            let piece = &way.pieces[self.at];
            self.measure(way, piece.to - piece.from);
            let later: f64 = self.after.iter().zip(&felt).map(|(after, felt)| after.value() * felt).sum();
            let parts: Vec<f64> =
                self.old.iter().zip(&felt).map(|(old, felt)| piece.speed * old.value() * felt).collect();
            let held: f64 = self.whole.1.iter().zip(&parts).map(|(held, part)| held.value() * part).sum();
            if now + later + held >= 0.0 {
                return Some(piece.to - balanced(&way.rates, &parts, (now + later, piece.to - piece.from)));
            }
            for k in 0..way.rates.len() {
                self.after[k] = self.after[k] + self.whole.1[k] * self.old[k] * piece.speed;
                self.old[k] = self.old[k] * self.whole.2[k];
            }
            self.at = self.at.checked_sub(1)?;
        }
    }

    /// What a piece of the length `length` [s] holds and keeps.
    fn measure(&mut self, way: &Way<'_, N>, length: f64) {
        if (length - self.whole.0).abs() > SAME * length {
            let held = way.rates.iter().map(|rate| rate.held(length)).collect();
            self.whole = (length, held, way.rates.iter().map(|rate| rate.faded(length)).collect());
        }
    }

    /// ∫_{t₁}^t e^{−(t − s)/τ} ḋ ds of each term, t₁ = `grown`, `elapsed` behind the turn.
    fn whole(&self, way: &Way<'_, N>, (elapsed, grown): (f64, f64), since: &[N]) -> Vec<N> {
        let piece = &way.pieces[self.at];
        let one = |k: usize| {
            let rate = way.rates[k];
            let before = self.after[k] + rate.held(piece.to - grown) * self.old[k] * piece.speed;
            since[k] + rate.faded(elapsed) * before
        };
        (0..way.rates.len()).map(one).collect()
    }
}

/// The time y in (0, `length`) at which `base` + Σ part ∫₀^y e^{−rs} ds, which is negative at 0 and bends downwards, vanishes:
/// Newton's rule comes to it from below and misses it by half of the bend over the slope times the square of its step.
fn balanced<N: Number>(rates: &[N], parts: &[f64], (base, length): (f64, f64)) -> f64 {
    let at = |y: f64| {
        let terms = rates.iter().zip(parts).map(|(rate, part)| {
            let rate = rate.value();
            let lost = -(-rate * y).exp_m1();
            let slope = part * (1.0 - lost);
            [part * if rate > 0.0 { lost / rate } else { y }, slope, rate * slope]
        });
        terms.fold([base, 0.0, 0.0], |sum, term| [sum[0] + term[0], sum[1] + term[1], sum[2] + term[2]])
    };
    let mut y = 0.0;
    for _ in 0..STEPS {
        let [off, slope, bend] = at(y);
        let step = -off / slope;
        if !(step.is_finite() && y + step <= length) {
            break;
        }
        y += step;
        if step <= 0.0 || 0.5 * bend / slope * step * step <= f64::EPSILON * length {
            return y;
        }
    }
    root::within(|y| at(y)[0], 0.0, length)
}

/// Stretches of the way from one time after first touch to another [s], each with its length: short where the radius grows
/// like a root of the time.
fn stretches(low: f64, high: f64) -> impl Iterator<Item = (f64, f64)> {
    let from_touch = low <= TOUCH * high;
    let (ratio, start): (f64, f64) = if from_touch { (2.0, high * 2f64.powi(-HALVINGS)) } else { (FINE, low) };
    #[expect(clippy::cast_possible_truncation, reason = "at most some tens")]
    let count = if high <= ratio * start { 1 } else { ((high / start).ln() / ratio.ln()).ceil().max(1.0) as i32 };
    let grow = if count == 1 { 1.0 } else { (high / start).powf(1.0 / f64::from(count)) };
    let end = move |k: i32| if k == count { high } else { start * grow.powi(k) };
    let first = from_touch.then_some((low, start - low));
    first.into_iter().chain((0..count).map(move |k| (end(k), end(k + 1) - end(k))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;

    /// Against central differences of the forces, in, in hold and out, terms faster than a row among them: h²/6 of third
    /// slopes, and 1e-13 of the force over h.
    #[test]
    fn slopes_are_those_of_differences() {
        let ball = Paraboloid { radius: Length::new(1.0).unwrap() };
        let time: Vec<f64> = (0..60).map(|k| 0.05 * f64::from(k)).collect();
        let depth: Vec<f64> = time.iter().map(|t| if *t < 1.0 { *t } else { (2.4 - t).min(1.0) }).collect();
        let here = [1.0, 2.0, 0.5, 3.0, 0.2, 4.0, 1e-3];
        let body = |numbers: &[f64]| {
            let terms = (0..3).map(|k| (numbers[1 + k], numbers[4 + k])).collect();
            let relaxation = Relaxation { equilibrium: numbers[0], terms, viscosity: 0.0 };
            Remembering { profile: &ball, relaxation: Arc::new(relaxation) }
        };
        let (contact, h) = (0.13, 1e-4);
        let slopes = body(&here).slopes(&time, &depth, contact).unwrap();
        let largest = body(&here).followed(&time, &depth, contact).unwrap().into_iter().fold(0.0, f64::max);
        let check = |found: &[f64], [low, high]: [Vec<f64>; 2], step: f64, name: &str| {
            for (row, slope) in found.iter().enumerate() {
                let by = (high[row] - low[row]) / (2.0 * step);
                // Next to the row at which the bodies part one of the two may have none.
                if low[row] > 0.0 && high[row] > 0.0 {
                    assert!((slope - by).abs() < 1e-6 * (by.abs() + largest / step * h), "{name} {row}: {slope} {by}");
                }
            }
        };
        for (number, slope) in slopes.numbers.iter().enumerate() {
            let step = h * here[number];
            let moved = [-step, step].map(|by| {
                let mut numbers = here;
                numbers[number] += by;
                body(&numbers).followed(&time, &depth, contact).unwrap()
            });
            check(slope, moved, step, &number.to_string());
        }
        let moved = [-h, h].map(|by| body(&here).followed(&time, &depth, contact + 0.1 * by).unwrap());
        check(&slopes.touch, moved, 0.1 * h, "touch");
    }
}
