//! Broken lines and arrow heads, measured along the curve.

use super::canvas::Dot;

/// Pieces of `path` inked by a pattern of lengths (ink, gap, …); the whole path if the pattern is empty.
pub(super) fn dashes(path: &[Dot], pattern: &[f64]) -> Vec<Vec<Dot>> {
    if pattern.is_empty() || path.len() < 2 {
        return vec![path.to_vec()];
    }
    let mut pencil = Pencil::new(pattern, path[0]);
    for pair in path.windows(2) {
        pencil.draw(pair[0], pair[1]);
    }
    pencil.finish()
}

struct Pencil<'a> {
    pattern: &'a [f64],
    /// Entry of the pattern in use; even entries are ink.
    entry: usize,
    /// Length left of it.
    left: f64,
    now: Vec<Dot>,
    done: Vec<Vec<Dot>>,
}

impl<'a> Pencil<'a> {
    fn new(pattern: &'a [f64], start: Dot) -> Self {
        Self { pattern, entry: 0, left: pattern[0], now: vec![start], done: Vec::new() }
    }

    fn draw(&mut self, from: Dot, to: Dot) {
        let length = distance(from, to);
        let mut at = 0.0;
        while length - at > self.left {
            at += self.left;
            self.turn(between(from, to, at / length));
        }
        self.left -= length - at;
        if self.inks() {
            self.now.push(to);
        }
    }

    fn inks(&self) -> bool {
        self.entry.is_multiple_of(2)
    }

    fn turn(&mut self, at: Dot) {
        if self.inks() {
            self.now.push(at);
            self.done.push(std::mem::take(&mut self.now));
        } else {
            self.now = vec![at];
        }
        self.entry = (self.entry + 1) % self.pattern.len();
        self.left = self.pattern[self.entry];
    }

    fn finish(mut self) -> Vec<Vec<Dot>> {
        if self.now.len() > 1 {
            self.done.push(self.now);
        }
        self.done
    }
}

/// Length of a path in px.
pub(super) fn length(path: &[Dot]) -> f64 {
    path.windows(2).map(|p| distance(p[0], p[1])).sum()
}

pub(super) fn distance(a: Dot, b: Dot) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

fn between(a: Dot, b: Dot, t: f64) -> Dot {
    (a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1))
}

/// Place at the arc length `at` px from the start of a path.
pub(super) fn along(path: &[Dot], at: f64) -> Option<Dot> {
    let mut left = at;
    for pair in path.windows(2) {
        let length = distance(pair[0], pair[1]);
        if left <= length && length > 0.0 {
            return Some(between(pair[0], pair[1], left / length));
        }
        left -= length;
    }
    path.last().copied()
}

/// Corners of an arrow head whose tip lies `at` px along the path; smaller where there is little room before it.
pub(super) fn head(path: &[Dot], at: f64) -> Option<[Dot; 4]> {
    let long = (0.7 * at).min(10.0);
    let (tip, tail) = (along(path, at)?, along(path, at - 0.9 * long)?);
    let reach = distance(tip, tail);
    if long < 1.0 || reach < 0.1 * long {
        return None;
    }
    let (u, v) = ((tip.0 - tail.0) / reach, (tip.1 - tail.1) / reach);
    let corner = |back: f64, side: f64| (tip.0 - long * (back * u + side * v), tip.1 - long * (back * v - side * u));
    Some([tip, corner(1.0, 0.45), corner(0.75, 0.0), corner(1.0, -0.45)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ink_has_its_share_of_the_length() {
        let path: Vec<Dot> = (0..=100).map(|i| (f64::from(i), 0.0)).collect();
        let pieces = dashes(&path, &[6.0, 4.0]);
        assert_eq!(pieces.len(), 10);
        let ink: f64 = pieces.iter().map(|p| length(p)).sum();
        assert!((ink - 60.0).abs() < 1e-9, "{ink}");
    }

    #[test]
    fn an_arrow_points_along_the_path() {
        let tip = head(&[(0.0, 0.0), (50.0, 0.0)], 30.0).map(|h| (h[0], h[2]));
        assert_eq!(tip, Some(((30.0, 0.0), (22.5, 0.0))));
    }
}
