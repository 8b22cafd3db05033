//! Curves of a panel in px: gaps, clipping to the frame, thinning.

use super::axis::Ruler;
use super::canvas::Dot;
use super::{Series, thin};

/// A series as it appears inside a frame of given size.
#[derive(Clone, Debug, Default)]
pub(super) struct DrawnCurve {
    /// Connected lines.
    pub(super) pieces: Vec<Vec<Dot>>,
    /// Points without neighbours, which no line would show.
    pub(super) lonely: Vec<Dot>,
    /// Points inside the frame that carry marks.
    pub(super) marked: Vec<Dot>,
}

/// Turns values into px: the origin is the upper left corner of the frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Map<'a> {
    pub(super) x: &'a Ruler,
    pub(super) y: &'a Ruler,
    pub(super) size: Dot,
}

impl Map<'_> {
    /// Place of a point; none for a gap.
    pub(super) fn place(&self, point: (f64, f64)) -> Option<Dot> {
        let x = self.x.range.place(point.0)? * self.size.0;
        let y = (1.0 - self.y.range.place(point.1)?) * self.size.1;
        Some((x, y))
    }

    /// Whether a place is inside the frame, to a rounding.
    pub(super) fn holds(&self, dot: &Dot) -> bool {
        let slack = 1e-6;
        (-slack..=self.size.0 + slack).contains(&dot.0) && (-slack..=self.size.1 + slack).contains(&dot.1)
    }
}

/// The series inside the frame.
pub(super) fn curve(series: &Series, map: &Map) -> DrawnCurve {
    let places: Vec<Option<Dot>> = series.points.iter().map(|point| map.place((*point)?)).collect();
    let runs = places.split(Option::is_none);
    let runs: Vec<Vec<Dot>> = runs.map(|run| run.iter().flatten().copied().collect()).collect();
    let pieces: Vec<Vec<Dot>> = runs.iter().flat_map(|run| clip(run, map.size)).collect();
    DrawnCurve {
        pieces: thin::thin(&pieces),
        lonely: runs.iter().filter_map(|run| point(run)).filter(|d| map.holds(d)).collect(),
        marked: spaced(places.into_iter().flatten().filter(|d| map.holds(d)).collect()),
    }
}

/// The place of a run that stays within a px: it would be invisible as a line.
fn point(run: &[Dot]) -> Option<Dot> {
    let first = *run.first()?;
    let near = |d: &Dot| (d.0 - first.0).abs() < 1.0 && (d.1 - first.1).abs() < 1.0;
    run.iter().all(near).then_some(first)
}

/// Points thinned out to 14 px where they are too many to be told apart.
fn spaced(points: Vec<Dot>) -> Vec<Dot> {
    if points.len() <= 40 {
        return points;
    }
    let mut kept: Vec<Dot> = Vec::new();
    for p in points {
        if kept.last().is_none_or(|q| (p.0 - q.0).hypot(p.1 - q.1) >= 14.0) {
            kept.push(p);
        }
    }
    kept
}

/// Parts of a path inside the frame.
fn clip(path: &[Dot], size: Dot) -> Vec<Vec<Dot>> {
    let mut pieces: Vec<Vec<Dot>> = Vec::new();
    let mut joined = false;
    for pair in path.windows(2) {
        let Some((from, to)) = segment(pair[0], pair[1], size) else {
            joined = false;
            continue;
        };
        match pieces.last_mut() {
            Some(piece) if joined => piece.push(to.0),
            _ => pieces.push(vec![from, to.0]),
        }
        joined = to.1 >= 1.0;
    }
    pieces
}

/// Part of a segment inside the frame: its start, its end and the fraction of the segment at its end
/// (Liang & Barsky 1984).
fn segment(a: Dot, b: Dot, size: Dot) -> Option<(Dot, (Dot, f64))> {
    let (u, v) = (b.0 - a.0, b.1 - a.1);
    let walls = [(-u, a.0), (u, size.0 - a.0), (-v, a.1), (v, size.1 - a.1)];
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    for (outward, room) in walls {
        if outward.abs() > 0.0 {
            let t = room / outward;
            (enter, leave) = if outward < 0.0 { (enter.max(t), leave) } else { (enter, leave.min(t)) };
        } else if room < 0.0 {
            return None;
        }
    }
    let at = |t: f64| if t >= 1.0 { b } else { (a.0 + t * u, a.1 + t * v) };
    (enter <= leave).then(|| (at(enter), (at(leave), leave)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_leaves_the_frame_is_cut_at_it() {
        let path = [(-10.0, 5.0), (5.0, 5.0), (5.0, 30.0), (8.0, 30.0), (8.0, 5.0)];
        let pieces = clip(&path, (10.0, 10.0));
        assert_eq!(pieces, [vec![(0.0, 5.0), (5.0, 5.0), (5.0, 10.0)], vec![(8.0, 10.0), (8.0, 5.0)]]);
    }

    #[test]
    fn a_path_inside_is_untouched() {
        let path = vec![(1.0, 1.0), (2.0, 3.0), (2.0, 3.0), (9.0, 10.0)];
        assert_eq!(clip(&path, (10.0, 10.0)), [path]);
    }
}
