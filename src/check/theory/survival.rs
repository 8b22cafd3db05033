//! Survival of a diffusing stress above a moving boundary.

use std::f64::consts::PI;

/// Shares of paths from `start` that have stayed above the boundary `edges[k]` up to `times[k]`, for ∂P/∂t = ∂²P/∂σ², P = 0 on the boundary.
///
/// Times rise from 0, edges are at or below zero, `start` at or above. While the boundary is at zero, or too far away to be met,
/// the image solution erf(D/2√t) is used, D the distance of the start from the boundary. From there on finite volumes in
/// η = σ/√t, which follow the boundary: u = P√t obeys u_{ln t} = ∂_η(u_η + ηu/2). Share-preserving, so that a small survival keeps
/// its relative accuracy (about 1e-3, second order in the cells).
pub(super) fn survival(start: f64, times: &[f64], edges: &[f64]) -> Vec<f64> {
    let begin = first_meeting(start, times, edges);
    let image = |k: usize| image_share(start - edges[k], times[k]);
    let mut shares: Vec<_> = (0..=begin.min(times.len() - 1)).map(image).collect();
    if begin + 1 < times.len() {
        let mut cells = Cells::new(start, times[begin], edges[begin]);
        let missing = shares[begin] / cells.share().max(f64::MIN_POSITIVE);
        for k in begin + 1..times.len() {
            cells.advance((times[k - 1], times[k]), edges[k]);
            shares.push((cells.share() * missing).min(shares[k - 1]));
        }
    }
    shares
}

/// Distance in standard deviations at which the boundary is still out of reach: Φ(−8) = 6e-16.
const REACH: f64 = 8.0;

/// Last step at which the image solution is exact: before the boundary leaves zero, or comes within reach.
fn first_meeting(start: f64, times: &[f64], edges: &[f64]) -> usize {
    let leaves = edges.iter().position(|b| *b < 0.0).unwrap_or(edges.len()).saturating_sub(1);
    let met = |k: usize| start - edges[k] < REACH * (2.0 * times[k]).sqrt();
    let near = (1..times.len()).find(|&k| met(k)).unwrap_or(times.len());
    leaves.max(near.saturating_sub(1)).max(1)
}

fn image_share(distance: f64, time: f64) -> f64 {
    if time > 0.0 { libm::erf(distance / (2.0 * time.sqrt())) } else { f64::from(u8::from(distance > 0.0)) }
}

const CELLS: usize = 240;
/// Largest step of ln t.
const STEP: f64 = 0.05;

/// Cells between the boundary and the far end of the distribution, in η.
struct Cells {
    contents: Vec<f64>,
    low: f64,
    high: f64,
}

impl Cells {
    /// The image solution at a time above zero.
    fn new(start: f64, time: f64, edge: f64) -> Self {
        let root = time.sqrt();
        let (low, high) = (followed(edge / root), start / root + 1.3 * REACH);
        let mut cells = Self { contents: Vec::new(), low, high };
        let distance = (start - edge) / root;
        let density = |i: usize| {
            let x = cells.place(i) - edge / root;
            (-0.25 * (x - distance).powi(2)).exp() * -(-x * distance).exp_m1() / (4.0 * PI).sqrt()
        };
        cells.contents = (0..CELLS).map(|i| density(i) * cells.width()).collect();
        cells
    }

    #[expect(clippy::cast_precision_loss, reason = "a few hundred cells")]
    fn width(&self) -> f64 {
        (self.high - self.low) / CELLS as f64
    }

    /// Centre of cell i.
    #[expect(clippy::cast_precision_loss, reason = "a few hundred cells")]
    fn place(&self, i: usize) -> f64 {
        self.low + self.width() * (i as f64 + 0.5)
    }

    fn share(&self) -> f64 {
        self.contents.iter().sum()
    }

    /// Moves on from one time to the next, the boundary at `edge` at the end.
    fn advance(&mut self, (from, to): (f64, f64), edge: f64) {
        let target = followed(edge / to.sqrt());
        let span = (to / from).ln();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few hundred steps")]
        let steps = (span / STEP).ceil().max(1.0) as u32;
        let (step, shift) = (span / f64::from(steps), (target - self.low) / f64::from(steps));
        for _ in 0..steps {
            self.step(step, shift / step);
        }
        self.low = target;
    }

    /// One Crank–Nicolson step of ln t with the boundary moving at `speed`.
    fn step(&mut self, step: f64, speed: f64) {
        let before = self.rates(speed);
        let mut wanted: Vec<_> = (0..CELLS).map(|i| self.contents[i] + 0.5 * step * self.rate(&before, i)).collect();
        self.low += speed * step;
        let after = self.rates(speed);
        let half = 0.5 * step;
        // (1 − half·rates) contents = wanted, a tridiagonal system solved by elimination from below.
        let mut upper = vec![0.0; CELLS];
        let (mut ratio, mut below) = (0.0, 0.0);
        for (i, (left, here, right)) in after.into_iter().enumerate() {
            let pivot = 1.0 - half * here + half * left * ratio;
            (ratio, below) = (-half * right / pivot, (wanted[i] + half * left * below) / pivot);
            (upper[i], wanted[i]) = (ratio, below);
        }
        for i in (0..CELLS - 1).rev() {
            wanted[i] -= upper[i] * wanted[i + 1];
        }
        self.contents = wanted;
    }

    fn rate(&self, rates: &[(f64, f64, f64)], i: usize) -> f64 {
        let (left, here, right) = rates[i];
        let at = |k: usize| self.contents.get(k).copied().unwrap_or(0.0);
        left * at(i.wrapping_sub(1)) + here * at(i) + right * at(i + 1)
    }

    /// Rates at which a cell gains from its left neighbour, itself and its right neighbour.
    #[expect(clippy::cast_precision_loss, reason = "a few hundred cells")]
    fn rates(&self, speed: f64) -> Vec<(f64, f64, f64)> {
        let width = self.width();
        let diffusion = 1.0 / (width * width);
        // Flow towards smaller η through face i: drift η/2 plus the face's own motion.
        let drift = |i: usize| {
            let y = i as f64 / CELLS as f64;
            0.5 * (0.5 * (self.low + (self.high - self.low) * y) + (1.0 - y) * speed) / width
        };
        let rate = |i: usize| {
            let (down, up) = (drift(i), drift(i + 1));
            let left = if i == 0 { 0.0 } else { diffusion - down };
            // At the boundary u = 0 lies half a width away and nothing drifts through it; nothing passes the far end.
            let lost_down = if i == 0 { 2.0 * diffusion } else { diffusion + down };
            let (lost_up, right) = if i + 1 == CELLS { (0.0, 0.0) } else { (diffusion - up, diffusion + up) };
            (left, -lost_down - lost_up, right)
        };
        (0..CELLS).map(rate).collect()
    }
}

/// Boundary followed by the cells: no further down than paths can reach.
fn followed(edge: f64) -> f64 {
    edge.max(-1.3 * REACH)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn normal(x: f64) -> f64 {
        0.5 * libm::erfc(-x / 2f64.sqrt())
    }

    /// b = −a − ct: Bachelier–Lévy, survival Φ((D + ct)/√2t) − e^{−cD} Φ((ct − D)/√2t), D = p + a.
    #[test]
    fn a_steady_boundary_has_its_closed_form() {
        for (p, a, c) in [(0.01, 0.1, 1.0), (1.0, 1.0, 0.3), (0.0, 0.3, 3.0), (0.0, 0.02, 0.1)] {
            let times: Vec<f64> = (0..200).map(|k| if k == 0 { 0.0 } else { 1e-5 * 1.07f64.powi(k) }).collect();
            let edges: Vec<f64> = times.iter().map(|t| -a - c * t).collect();
            let shares = survival(p, &times, &edges);
            for (t, share) in times.iter().zip(&shares).skip(1) {
                let (d, width) = (p + a, (2.0 * t).sqrt());
                let exact = normal((d + c * t) / width) - (-c * d).exp() * normal((c * t - d) / width);
                assert!((share / exact - 1.0).abs() < 2e-3, "{p} {a} {c} t = {t:e}: {share} {exact}");
            }
        }
    }

    /// The cells reproduce the image solution where a boundary that leaves zero by nothing makes them take over.
    #[test]
    fn a_boundary_at_rest_is_the_error_function() {
        let times: Vec<f64> = (0..100).map(|k| if k == 0 { 0.0 } else { 1e-6 * 1.2f64.powi(k) }).collect();
        let mut edges = vec![0.0; 100];
        edges[20..].fill(-1e-12);
        for (t, share) in times.iter().zip(survival(1e-4, &times, &edges)).skip(1) {
            let exact = libm::erf(1e-4 / (2.0 * t.sqrt()));
            assert!((share / exact - 1.0).abs() < 2e-3, "{t:e}: {share} {exact}");
        }
    }
}
