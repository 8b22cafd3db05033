//! Fewer vertices, same picture.

use super::canvas::Dot;
use super::dash::distance;

/// Vertices a series may have before its picture is coarsened.
const BUDGET: usize = 1000;
/// Vertices straightened together.
const BLOCK: usize = 512;
/// Deviation in px that no eye sees.
const UNSEEN: f64 = 0.06;

/// Pieces of a curve with about a thousand vertices at most; ends and extremes are kept.
pub(super) fn thin(pieces: &[Vec<Dot>]) -> Vec<Vec<Dot>> {
    let mut fewer = Vec::new();
    for grain in [1.0, 2.0, 4.0, 8.0] {
        fewer = coarse(pieces, grain);
        if count(&fewer) <= BUDGET {
            return fewer;
        }
        fewer = once(&fewer);
        if count(&fewer) <= BUDGET {
            return fewer;
        }
    }
    fewer
}

fn count(pieces: &[Vec<Dot>]) -> usize {
    pieces.iter().map(Vec::len).sum()
}

fn coarse(pieces: &[Vec<Dot>], grain: f64) -> Vec<Vec<Dot>> {
    let fewer = pieces.iter().map(|p| columns(p, grain));
    fewer.map(|p| straight(&p, UNSEEN * grain)).collect()
}

/// First, lowest, highest and last vertex of every stay in a column of `width` px.
fn columns(path: &[Dot], width: f64) -> Vec<Dot> {
    if path.len() < 200 {
        return path.to_vec();
    }
    let column = |dot: &Dot| (dot.0 / width).floor();
    let stays = path.chunk_by(|a, b| column(a).total_cmp(&column(b)).is_eq());
    let mut kept = Vec::new();
    stays.for_each(|stay| outline(stay, &mut kept));
    kept
}

fn outline(stay: &[Dot], kept: &mut Vec<Dot>) {
    if stay.len() <= 4 {
        return kept.extend(stay);
    }
    let by_height = |a: &usize, b: &usize| stay[*a].1.total_cmp(&stay[*b].1);
    let low = (0..stay.len()).min_by(by_height).unwrap_or(0);
    let high = (0..stay.len()).max_by(by_height).unwrap_or(0);
    let corners = [0, low.min(high), low.max(high), stay.len() - 1];
    kept.extend(corners.map(|i| stay[i]));
}

/// Path without the vertices that lie within `slack` px of the line between the kept ones,
/// block by block so that the time grows no faster than the path.
fn straight(path: &[Dot], slack: f64) -> Vec<Dot> {
    let blocks = path.chunks(BLOCK);
    blocks.flat_map(|block| straight_block(block, slack)).collect()
}

/// Method of Douglas & Peucker 1973.
fn straight_block(path: &[Dot], slack: f64) -> Vec<Dot> {
    let last = path.len().saturating_sub(1);
    let mut kept = vec![0, last];
    let mut open = vec![(0, last)];
    while let Some((a, b)) = open.pop() {
        if let Some(corner) = farthest(path, (a, b), slack) {
            kept.push(corner);
            open.extend([(a, corner), (corner, b)]);
        }
    }
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().filter_map(|i| path.get(i).copied()).collect()
}

/// Vertex between two others that deviates most from their chord, if more than `slack`.
fn farthest(path: &[Dot], (a, b): (usize, usize), slack: f64) -> Option<usize> {
    let mut worst = (slack * slack, None);
    for (i, dot) in path.iter().enumerate().take(b).skip(a + 1) {
        let off = square_deviation(*dot, path[a], path[b]);
        if off > worst.0 {
            worst = (off, Some(i));
        }
    }
    worst.1
}

/// Squared distance of a point from the segment between two others.
fn square_deviation(p: Dot, a: Dot, b: Dot) -> f64 {
    let (u, v) = (b.0 - a.0, b.1 - a.1);
    let (x, y) = (p.0 - a.0, p.1 - a.1);
    let t = (x * u + y * v) / (u * u + v * v).max(f64::MIN_POSITIVE);
    let t = t.clamp(0.0, 1.0);
    (x - t * u).powi(2) + (y - t * v).powi(2)
}

/// Pieces made of the segments that ink something new: loops run a thousand times are drawn once.
fn once(pieces: &[Vec<Dot>]) -> Vec<Vec<Dot>> {
    let mut paper = Paper::new(pieces);
    let mut out = Vec::new();
    for piece in pieces {
        let fresh: Vec<bool> = piece.windows(2).map(|p| paper.ink(p[0], p[1])).collect();
        out.extend(kept_runs(piece, &fresh));
    }
    out
}

/// Square px and whether they have been inked.
struct Paper {
    columns: usize,
    inked: Vec<bool>,
}

impl Paper {
    /// Blank paper that holds all pieces, which lie at positive places.
    fn new(pieces: &[Vec<Dot>]) -> Self {
        let dots = || pieces.iter().flatten();
        let columns = cell(dots().fold(0.0, |most, d| d.0.max(most))) + 1;
        let rows = cell(dots().fold(0.0, |most, d| d.1.max(most))) + 1;
        Self { columns, inked: vec![false; columns * rows] }
    }

    /// Inks a segment; whether it enters a px not inked before.
    fn ink(&mut self, a: Dot, b: Dot) -> bool {
        let steps = distance(a, b).ceil().max(1.0);
        let (mut i, mut fresh) = (0.0, false);
        while i <= steps {
            let t = i / steps;
            let dot = (a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1));
            let at = cell(dot.1) * self.columns + cell(dot.0);
            if let Some(px) = self.inked.get_mut(at) {
                fresh |= !std::mem::replace(px, true);
            }
            i += 1.0;
        }
        fresh
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "places in a panel, clipped to its frame")]
fn cell(px: f64) -> usize {
    px as usize
}

/// Runs of vertices joined by segments that are kept.
fn kept_runs(piece: &[Dot], kept: &[bool]) -> Vec<Vec<Dot>> {
    let mut runs: Vec<Vec<Dot>> = Vec::new();
    let mut joined = false;
    for (pair, keep) in piece.windows(2).zip(kept) {
        match runs.last_mut() {
            Some(run) if *keep && joined => run.push(pair[1]),
            _ if *keep => runs.push(pair.to_vec()),
            _ => {}
        }
        joined = *keep;
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_curve_keeps_its_shape() {
        let path: Vec<Dot> =
            (0..=10_000).map(|i| f64::from(i) * 0.03).map(|x| (x, 250.0 * (x / 300.0).powf(1.5))).collect();
        let thinned = thin(std::slice::from_ref(&path));
        assert!(count(&thinned) < 60);
        let off = |p: &Dot| {
            let near = thinned[0].windows(2).map(|w| square_deviation(*p, w[0], w[1]).sqrt());
            near.fold(f64::INFINITY, f64::min)
        };
        // column extremes and chords each deviate by no more than UNSEEN
        assert!(path.iter().all(|p| off(p) < 2.0 * UNSEEN));
    }

    #[test]
    fn spikes_survive() {
        let mut path: Vec<Dot> = (0..50_000).map(|i| (f64::from(i) * 0.006, 100.0)).collect();
        path[31_415].1 = 7.0;
        path[31_417].1 = 190.0;
        let thinned = thin(&[path]).concat();
        assert!(thinned.iter().any(|p| p.1 < 7.5) && thinned.iter().any(|p| p.1 > 189.5));
    }

    #[test]
    fn a_loop_run_many_times_is_drawn_once() {
        let turn = |i: i32| f64::from(i) * 0.01;
        let path = (0..200_000).map(|i| (150.0 + 140.0 * turn(i).cos(), 120.0 + 110.0 * turn(i).sin()));
        assert!(count(&thin(&[path.collect()])) <= 3 * BUDGET);
    }

    #[test]
    fn noise_stays_within_the_budget() {
        let path = (0..100_000).map(|i| (f64::from(i) * 0.003, f64::from((i * 7919) % 251)));
        assert!(count(&thin(&[path.collect()])) <= BUDGET);
    }

    #[test]
    fn nothing_stays_nothing() {
        assert!(thin(&[Vec::new()]).concat().is_empty());
    }
}
