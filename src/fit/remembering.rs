//! The force of a body that relaxes, pressed in and taken away once, without a run.
//!
//! While the contact grows F(t) = ∫E*(t − s) dΦ(d(s)), Φ′(d) = 2a(d) (Lee & Radok 1960); on the way out the integral ends
//! at t₁(t), the time at which the contact first had its present radius, ∫_{t₁}^t E*(t − s) ḋ ds = 0 (Ting 1966). E*(t)
//! relaxation of the effective modulus [Pa], a contact radius [m]; the drive is straight between rows. Holds for a depth
//! that first rises and then falls, and constant ν.

use crate::material::Relaxation;
use crate::numerics::root;
use crate::shape::Profile;

/// A body that relaxes under an indenter.
pub struct Remembering<'r> {
    /// The indenter.
    pub profile: &'r dyn Profile,
    /// E*(t), without viscosity.
    pub relaxation: &'r Relaxation,
}

/// Nodes and weights of Gauss and Legendre on (0, 1): five.
const NODES: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_6, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

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
}

/// The way in, ready to be looked back on.
struct Way<'w> {
    body: &'w Remembering<'w>,
    /// Rates 1/τ of the terms, zero first.
    rates: Vec<f64>,
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
        let rates = std::iter::once(0.0).chain(terms.iter().map(|term| 1.0 / term.1)).collect();
        let moduli = std::iter::once(body.relaxation.equilibrium).chain(terms.iter().map(|term| term.0)).collect();
        Self { body, rates, moduli, pieces: Vec::new(), touch: 0.0 }
    }

    /// Goes on straight from one time and depth to another.
    fn goes(&mut self, ((from, depth), (to, end)): ((f64, f64), (f64, f64))) {
        let speed = (end - depth) / (to - from);
        let before = match self.pieces.last() {
            Some(last) => self.memory(last, last.to),
            None => vec![0.0; self.rates.len()],
        };
        let (mut from, mut depth) = (from, depth);
        if self.pieces.is_empty() {
            (from, depth) = (from - depth / speed, 0.0);
            self.touch = from;
        }
        self.pieces.push(Piece { from, to, depth, speed, before });
    }

    /// ∫e^{−(t − s)/τ} dΦ up to the time `t` in a piece, for each term.
    fn memory(&self, piece: &Piece, t: f64) -> Vec<f64> {
        // s = touch + u² takes the root of the radius at first touch away.
        let (low, high) = ((piece.from - self.touch).max(0.0).sqrt(), (t - self.touch).max(0.0).sqrt());
        let mut memory: Vec<f64> =
            piece.before.iter().zip(&self.rates).map(|(sum, rate)| sum * (-rate * (t - piece.from)).exp()).collect();
        for (node, weight) in NODES {
            let u = low + (high - low) * node;
            let s = self.touch + u * u;
            let depth = piece.depth + piece.speed * (s - piece.from);
            let radius = self.body.profile.edge(depth.max(0.0)).unwrap_or(0.0);
            let part = weight * (high - low) * 2.0 * u * 2.0 * radius * piece.speed;
            for (sum, rate) in memory.iter_mut().zip(&self.rates) {
                *sum += part * (-rate * (t - s)).exp();
            }
        }
        memory
    }

    fn force_in(&self) -> f64 {
        let Some(last) = self.pieces.last() else { return 0.0 };
        self.memory(last, last.to).iter().zip(&self.moduli).map(|(sum, modulus)| sum * modulus).sum()
    }

    /// Forces on the way out, from the turn on; the first is there already.
    fn goes_out(&self, times: &[f64], depths: &[f64], forces: &mut [f64]) {
        let Some(last) = self.pieces.last() else { return };
        // ∫ e^{−(t − s)/τ} ḋ ds since the turn, and from a piece to the turn.
        let mut since = vec![0.0; self.rates.len()];
        let mut after = vec![0.0; self.rates.len()];
        let turn = last.to;
        let mut at = self.pieces.len() - 1;
        for number in 1..times.len() {
            let (before, t) = (times[number - 1], times[number]);
            let speed = (depths[number] - depths[number - 1]) / (t - before);
            for (sum, rate) in since.iter_mut().zip(&self.rates) {
                *sum = *sum * (-rate * (t - before)).exp() + speed * held(*rate, t - before);
            }
            let balance = |from: f64, piece: &Piece, after: &[f64]| {
                let one = |((rate, modulus), (since, after)): ((&f64, &f64), (&f64, &f64))| {
                    let piece = piece.speed * held(*rate, piece.to - from) * (-rate * (turn - piece.to)).exp();
                    modulus * (since + (after + piece) * (-rate * (t - turn)).exp())
                };
                self.rates.iter().zip(&self.moduli).zip(since.iter().zip(after)).map(one).sum::<f64>()
            };
            while balance(self.pieces[at].from, &self.pieces[at], &after) < 0.0 {
                let piece = &self.pieces[at];
                for (sum, rate) in after.iter_mut().zip(&self.rates) {
                    *sum += piece.speed * held(*rate, piece.to - piece.from) * (-rate * (turn - piece.to)).exp();
                }
                if at == 0 {
                    // All springs are free.
                    return;
                }
                at -= 1;
            }
            let piece = &self.pieces[at];
            let grown = root::within(|s| -balance(s, piece, &after), piece.from, piece.to);
            let memory = self.memory(piece, grown);
            let terms = memory.iter().zip(&self.moduli).zip(&self.rates);
            forces[number] = terms.map(|((sum, modulus), rate)| sum * modulus * (-rate * (t - grown)).exp()).sum();
        }
    }
}

/// ∫₀^h e^{−rs} ds [s].
fn held(rate: f64, h: f64) -> f64 {
    if rate > 0.0 { -(-rate * h).exp_m1() / rate } else { h }
}
