//! The force of a body that relaxes, pressed in and taken away once, without a run.
//!
//! While the contact grows F(t) = ∫E*(t − s) dΦ(d(s)), Φ′(d) = 2a(d) (Lee & Radok 1960); on the way out the integral ends
//! at t₁(t), the time at which the contact first had its present radius, ∫_{t₁}^t E*(t − s) ḋ ds = 0 (Ting 1966). E*(t)
//! relaxation of the effective modulus [Pa], a contact radius [m]; the drive is straight between rows. Holds for a depth
//! that first rises and then falls, and constant ν.

use super::fading::{Fading, NODES};
use crate::material::Relaxation;
use crate::numerics::root;
use crate::shape::Profile;
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

/// A straight piece of the way in, from first touch on.
struct Piece {
    from: f64,
    to: f64,
    /// Depth at its beginning [m].
    depth: f64,
    /// ḋ [m/s].
    speed: f64,
    /// ∫e^{−(from − s)/τ} dΦ for each term, that of equilibrium first [m²].
    before: Vec<f64>,
    /// The same at its end.
    after: Vec<f64>,
}

/// The way in, ready to be looked back on.
struct Way<'w> {
    body: &'w Remembering<'w>,
    /// Rates 1/τ of the terms, zero first.
    rates: Vec<f64>,
    /// What a stretch of the usual length does to the memory.
    usual: Fading,
    /// Their moduli [Pa].
    moduli: Vec<f64>,
    pieces: Vec<Piece>,
    /// First touch [s].
    touch: f64,
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
        let turn = (0..depths.len()).max_by(|&a, &b| depths[a].total_cmp(&depths[b])).unwrap_or(0);
        let deepest = depths.get(turn).copied().unwrap_or(0.0) - contact;
        if deepest > 0.0 && self.profile.edge(deepest).is_none() {
            return Err(format!("the depth {deepest:e} m is beyond the end of the profile"));
        }
        let mut forces = vec![0.0; depths.len()];
        let Some(first) = depths[..=turn].iter().rposition(|&d| d <= contact).filter(|_| deepest > 0.0) else {
            return if deepest > 0.0 {
                Err("the data begin in contact: expected points before it".to_owned())
            } else {
                Ok(forces)
            };
        };
        let mut way = Way::of(self);
        for at in first..turn {
            way.goes(((times[at], depths[at] - contact), (times[at + 1], depths[at + 1] - contact)));
            forces[at + 1] = way.force_in();
        }
        way.goes_out(&times[turn..], &depths[turn..], &mut forces[turn..]);
        Ok(forces)
    }
}

impl<'w> Way<'w> {
    fn of(body: &'w Remembering<'w>) -> Self {
        let terms = &body.relaxation.terms;
        let rates: Vec<f64> = std::iter::once(0.0).chain(terms.iter().map(|term| 1.0 / term.1)).collect();
        let moduli = std::iter::once(body.relaxation.equilibrium).chain(terms.iter().map(|term| term.0)).collect();
        Self { body, usual: Fading::over(&rates, 0.0), rates, moduli, pieces: Vec::new(), touch: 0.0 }
    }

    /// Goes on straight from one time and depth to another.
    fn goes(&mut self, ((from, depth), (to, end)): ((f64, f64), (f64, f64))) {
        let speed = (end - depth) / (to - from);
        let before = match self.pieces.last() {
            Some(last) => last.after.clone(),
            None => vec![0.0; self.rates.len()],
        };
        let (mut from, mut depth) = (from, depth);
        if (to - from - self.usual.length).abs() > SAME * (to - from) {
            self.usual = Fading::over(&self.rates, to - from);
        }
        if self.pieces.is_empty() {
            (from, depth) = (from - depth / speed, 0.0);
            self.touch = from;
        }
        let mut piece = Piece { from, to, depth, speed, before, after: Vec::new() };
        piece.after = self.memory(&piece, to);
        self.pieces.push(piece);
    }

    /// ∫e^{−(t − s)/τ} dΦ up to the time `t` in a piece, for each term.
    fn memory(&self, piece: &Piece, t: f64) -> Vec<f64> {
        let mut memory = piece.before.clone();
        let (low, high) = (piece.from - self.touch, t - self.touch);
        let whole = t - piece.from;
        for (from, length) in stretches(low, high) {
            let own;
            let fading = if (length - self.usual.length).abs() <= SAME * length {
                &self.usual
            } else {
                own = Fading::over(&self.rates, length.min(whole));
                &own
            };
            let rate_at = |node: f64| {
                let depth = piece.depth + piece.speed * (from - low + length * node);
                2.0 * self.body.profile.edge(depth.max(0.0)).unwrap_or(0.0) * piece.speed
            };
            fading.pass(&mut memory, length, NODES.map(|(node, _)| rate_at(node)));
        }
        memory
    }

    fn force_in(&self) -> f64 {
        let Some(last) = self.pieces.last() else { return 0.0 };
        last.after.iter().zip(&self.moduli).map(|(sum, modulus)| sum * modulus).sum()
    }

    /// Forces on the way out, from the turn on; the first is there already.
    fn goes_out(&self, times: &[f64], depths: &[f64], forces: &mut [f64]) {
        let Some(last) = self.pieces.last() else { return };
        // ∫ e^{−(t − s)/τ} ḋ ds since the turn, and from a piece to the turn.
        let mut since = vec![0.0; self.rates.len()];
        let mut after = vec![0.0; self.rates.len()];
        let turn = last.to;
        let mut at = self.pieces.len() - 1;
        let mut old = self.faded(turn - self.pieces[at].to);
        let mut step = self.faded(0.0);
        let mut lasted = 0.0;
        for number in 1..times.len() {
            let (h, t) = (times[number] - times[number - 1], times[number]);
            if (h - lasted).abs() > SAME * h {
                (step, lasted) = (self.faded(h), h);
            }
            let speed = (depths[number] - depths[number - 1]) / h;
            for ((sum, rate), kept) in since.iter_mut().zip(&self.rates).zip(&step) {
                *sum = *sum * kept + speed * held(*rate, h);
            }
            // Moduli of what lies before the turn, as they are felt now.
            let felt: Vec<f64> =
                self.faded(t - turn).iter().zip(&self.moduli).map(|(kept, modulus)| kept * modulus).collect();
            let now: f64 = since.iter().zip(&self.moduli).map(|(sum, modulus)| sum * modulus).sum();
            let balance = |from: f64, piece: &Piece, after: &[f64], old: &[f64]| {
                let one = |((rate, felt), (after, old)): ((&f64, &f64), (&f64, &f64))| {
                    felt * (after + piece.speed * held(*rate, piece.to - from) * old)
                };
                now + self.rates.iter().zip(&felt).zip(after.iter().zip(old)).map(one).sum::<f64>()
            };
            while balance(self.pieces[at].from, &self.pieces[at], &after, &old) < 0.0 {
                let piece = &self.pieces[at];
                for ((sum, rate), old) in after.iter_mut().zip(&self.rates).zip(&old) {
                    *sum += piece.speed * held(*rate, piece.to - piece.from) * old;
                }
                if at == 0 {
                    // All springs are free.
                    return;
                }
                at -= 1;
                old = self.faded(turn - self.pieces[at].to);
            }
            let piece = &self.pieces[at];
            let grown = root::within(|s| -balance(s, piece, &after, &old), piece.from, piece.to);
            let memory = self.memory(piece, grown);
            let terms = memory.iter().zip(&self.moduli).zip(&self.rates);
            forces[number] = terms.map(|((sum, modulus), rate)| sum * modulus * (-rate * (t - grown)).exp()).sum();
        }
    }

    /// e^{−rt} of all rates.
    fn faded(&self, t: f64) -> Vec<f64> {
        self.rates.iter().map(|rate| (-rate * t).exp()).collect()
    }
}

/// Stretches of the way from one time after first touch to another [s], each with its length: short where the radius grows
/// like a root of the time.
fn stretches(low: f64, high: f64) -> impl Iterator<Item = (f64, f64)> {
    let from_touch = low <= TOUCH * high;
    let (ratio, start): (f64, f64) = if from_touch { (2.0, high * 2f64.powi(-HALVINGS)) } else { (FINE, low) };
    #[expect(clippy::cast_possible_truncation, reason = "at most some tens")]
    let count = ((high / start).ln() / ratio.ln()).ceil().max(1.0) as i32;
    let grow = (high / start).powf(1.0 / f64::from(count));
    let end = move |k: i32| if k == count { high } else { start * grow.powi(k) };
    let first = from_touch.then_some((low, start - low));
    first.into_iter().chain((0..count).map(move |k| (end(k), end(k + 1) - end(k))))
}

/// ∫₀^h e^{−rs} ds [s].
fn held(rate: f64, h: f64) -> f64 {
    if rate > 0.0 { -(-rate * h).exp_m1() / rate } else { h }
}
