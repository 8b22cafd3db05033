//! Abel's integral over a piecewise cubic, in a time that grows with the logarithm of its length.

use crate::numerics::monotone::{Cubic, Interpolant};
use crate::numerics::quadrature;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// ∫f′/√(x²−r²), ∫(rf′)′/√(x²−r²) and ∫r²f′/√(x²−r²) over [0, x].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Sums {
    /// g(x)/x.
    pub reduced: f64,
    /// g′(x).
    pub slope: f64,
    /// N(x).
    pub load: f64,
}

impl Sums {
    fn add(&mut self, weight: f64, (slope, growth): (f64, f64), r: f64) {
        self.reduced += weight * slope;
        self.slope += weight * growth;
        self.load += weight * slope * r * r;
    }
}

/// Points per block: 5.8^{−20} = 5e-16, the kernel's convergence at a distance of the block's length.
const POINTS: usize = 20;
/// Pieces in the smallest block.
const LEAF: usize = 32;

/// Chebyshev points on [−1, 1] and their barycentric weights.
static CHEBYSHEV: LazyLock<[(f64, f64); POINTS]> = LazyLock::new(|| {
    std::array::from_fn(|k| {
        let angle = PI * (f64::from(u32::try_from(k).unwrap_or(0)) + 0.5) / 20.0;
        (-angle.cos(), if k % 2 == 0 { angle.sin() } else { -angle.sin() })
    })
});

/// A Gauss–Legendre rule of N nodes.
fn rule<const N: usize>() -> [(f64, f64); N] {
    std::array::from_fn(|k| quadrature::node_and_weight(N, k))
}

/// For pieces much shorter than their distance.
static FEW: LazyLock<[(f64, f64); 4]> = LazyLock::new(rule);
/// For pieces as long as their distance, and for the trigonometric polynomials near x.
static MANY: LazyLock<[(f64, f64); 12]> = LazyLock::new(rule);

/// A run of pieces with the moments of f′ and (rf′)′ on its Chebyshev points.
///
/// Interpolating the kernel at the points makes each sum over the run a sum over 20 numbers.
#[derive(Debug, Clone)]
struct Block {
    pieces: (usize, usize),
    start: f64,
    end: f64,
    children: Option<(usize, usize)>,
    moments: [(f64, f64); POINTS],
}

impl Block {
    fn new(pieces: (usize, usize), interpolant: &Interpolant, children: Option<(usize, usize)>) -> Self {
        let (start, end) = (interpolant.radii()[pieces.0], interpolant.radii()[pieces.1]);
        Self { pieces, start, end, children, moments: [(0.0, 0.0); POINTS] }
    }

    fn point(&self, t: f64) -> f64 {
        0.5 * ((1.0 - t) * self.start + (1.0 + t) * self.end)
    }

    /// Spreads a weight of f′ and (rf′)′ at the radius `r` over the points.
    fn gather(&mut self, (slope, growth): (f64, f64), r: f64) {
        let t = ((r - self.start) - (self.end - r)) / (self.end - self.start);
        let mut shares = [0.0; POINTS];
        let mut sum = 0.0;
        for (share, &(point, weight)) in shares.iter_mut().zip(CHEBYSHEV.iter()) {
            let gap = t - point;
            // On a point its own share is everything: 1e-300 acts as an infinitesimal gap.
            *share = weight / if gap.abs() > 0.0 { gap } else { 1e-300 };
            sum += *share;
        }
        for (share, moment) in shares.iter().zip(&mut self.moments) {
            let share = share / sum;
            moment.0 += share * slope;
            moment.1 += share * growth;
        }
    }

    fn gather_piece(&mut self, piece: &Cubic) {
        let long = 16.0 * (piece.end - piece.start) > self.end - self.start;
        let rule: &[(f64, f64)] = if long { MANY.as_slice() } else { FEW.as_slice() };
        let half = 0.5 * (piece.end - piece.start);
        for &(node, weight) in rule {
            let r = piece.start + half * (1.0 + node);
            self.gather((half * weight * piece.slope(r), half * weight * piece.growth(r)), r);
        }
    }

    fn is_far_from(&self, x: f64) -> bool {
        x - self.end >= self.end - self.start
    }

    fn add_to(&self, sums: &mut Sums, x: f64) {
        for (&(point, _), &moment) in CHEBYSHEV.iter().zip(&self.moments) {
            let r = self.point(point);
            sums.add(1.0 / ((x - r) * (x + r)).sqrt(), moment, r);
        }
    }
}

/// The blocks over all pieces; the last one covers everything.
#[derive(Debug, Clone)]
pub(super) struct Abel {
    blocks: Vec<Block>,
}

impl Abel {
    /// Blocks for the pieces of an interpolant.
    pub(super) fn new(interpolant: &Interpolant) -> Self {
        let mut blocks = Vec::with_capacity(4 * interpolant.pieces() / LEAF + 1);
        build(&mut blocks, interpolant, (0, interpolant.pieces()));
        Self { blocks }
    }

    /// The three integrals at `x` > 0, `x` not beyond the last point.
    pub(super) fn at(&self, interpolant: &Interpolant, x: f64) -> Sums {
        let mut sums = Sums::default();
        self.visit(self.blocks.len() - 1, interpolant, x, &mut sums);
        sums
    }

    fn visit(&self, index: usize, interpolant: &Interpolant, x: f64, sums: &mut Sums) {
        let block = &self.blocks[index];
        if block.start >= x {
            return;
        }
        if block.is_far_from(x) {
            return block.add_to(sums, x);
        }
        if let Some((left, right)) = block.children {
            self.visit(left, interpolant, x, sums);
            return self.visit(right, interpolant, x, sums);
        }
        for piece in (block.pieces.0..block.pieces.1).map(|i| interpolant.piece(i)).take_while(|p| p.start < x) {
            add_piece(sums, &piece, x);
        }
    }
}

/// Builds the block over a range of pieces after its children and returns its index.
fn build(blocks: &mut Vec<Block>, interpolant: &Interpolant, pieces: (usize, usize)) -> usize {
    let block = if pieces.1 - pieces.0 <= LEAF {
        let mut block = Block::new(pieces, interpolant, None);
        (pieces.0..pieces.1).for_each(|i| block.gather_piece(&interpolant.piece(i)));
        block
    } else {
        let middle = usize::midpoint(pieces.0, pieces.1);
        let left = build(blocks, interpolant, (pieces.0, middle));
        let right = build(blocks, interpolant, (middle, pieces.1));
        let mut block = Block::new(pieces, interpolant, Some((left, right)));
        for child in [&blocks[left], &blocks[right]] {
            for (&(point, _), &moment) in CHEBYSHEV.iter().zip(&child.moments) {
                block.gather(moment, child.point(point));
            }
        }
        block
    };
    blocks.push(block);
    blocks.len() - 1
}

/// Adds what one piece contributes up to x.
///
/// Away from x the kernel is smooth in r; near it r = x sin θ makes the integrand a trigonometric
/// polynomial of degree two. Either way the rule is at rounding and no two large numbers are
/// subtracted.
fn add_piece(sums: &mut Sums, piece: &Cubic, x: f64) {
    if x - piece.end >= piece.end - piece.start {
        let half = 0.5 * (piece.end - piece.start);
        for &(node, weight) in MANY.iter() {
            let r = piece.start + half * (1.0 + node);
            let kernel = half * weight / ((x - r) * (x + r)).sqrt();
            sums.add(kernel, (piece.slope(r), piece.growth(r)), r);
        }
        return;
    }
    let end = piece.end.min(x);
    let from = piece.start.atan2(((x - piece.start) * (x + piece.start)).sqrt());
    let half = 0.5 * arc_between(x, piece.start, end);
    for &(node, weight) in MANY.iter() {
        let r = x * (from + half * (1.0 + node)).sin();
        sums.add(half * weight, (piece.slope(r), piece.growth(r)), r);
    }
}

/// arcsin(r₁/x) − arcsin(r₀/x) without the difference of the two.
fn arc_between(x: f64, start: f64, end: f64) -> f64 {
    let root = |r: f64| ((x - r) * (x + r)).max(0.0).sqrt();
    let (at_start, at_end) = (root(start), root(end));
    let sine = x * x * (end - start) * (end + start) / (end * at_start + start * at_end);
    sine.atan2(start * end + at_start * at_end)
}

/// The same by a plain sum over all pieces.
#[cfg(test)]
pub(super) fn plain(interpolant: &Interpolant, x: f64) -> Sums {
    let mut sums = Sums::default();
    let pieces = (0..interpolant.pieces()).map(|i| interpolant.piece(i));
    pieces.take_while(|piece| piece.start < x).for_each(|piece| add_piece(&mut sums, &piece, x));
    sums
}
