//! Free room inside a panel: where a label covers no curve.

use super::canvas::Dot;
use super::dash::{along, length};

/// Side of a cell in px.
const CELL: f64 = 6.0;
/// Cells searched around a label for its distance to the next curve.
const REACH: usize = 6;

/// A rectangle in px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Area {
    pub(super) from: Dot,
    pub(super) to: Dot,
}

/// Cells of a panel that something passes through.
#[derive(Clone, Debug)]
pub(super) struct Clearance {
    size: Dot,
    columns: usize,
    rows: usize,
    taken: Vec<bool>,
}

impl Clearance {
    /// An empty panel.
    pub(super) fn new(size: Dot) -> Self {
        let (columns, rows) = (cell(size.0) + 1, cell(size.1) + 1);
        Self { size, columns, rows, taken: vec![false; columns * rows] }
    }

    /// Takes the cells under a path.
    pub(super) fn take_path(&mut self, path: &[Dot]) {
        for pair in path.windows(2) {
            let reach = length(pair);
            let mut at = 0.0;
            while at < reach {
                along(pair, at).into_iter().for_each(|dot| self.take(dot));
                at += 0.7 * CELL;
            }
        }
        path.last().into_iter().for_each(|dot| self.take(*dot));
    }

    /// Takes the cell at a place.
    pub(super) fn take(&mut self, dot: Dot) {
        let at = cell(dot.1).min(self.rows - 1) * self.columns + cell(dot.0).min(self.columns - 1);
        self.taken[at] = true;
    }

    /// Takes all cells of an area.
    pub(super) fn take_area(&mut self, area: Area) {
        for row in cell(area.from.1)..=cell(area.to.1).min(self.rows - 1) {
            for column in cell(area.from.0)..=cell(area.to.0).min(self.columns - 1) {
                self.taken[row * self.columns + column] = true;
            }
        }
    }

    /// The first of the areas with the most room around it; none if every one is taken or sticks out.
    pub(super) fn freest(&self, areas: impl Iterator<Item = Area>) -> Option<Area> {
        let mut best: Option<(usize, Area)> = None;
        for area in areas {
            let room = self.room(area);
            if room > best.map_or(0, |b| b.0) {
                best = Some((room, area));
            }
        }
        best.map(|b| b.1)
    }

    /// Number of free rings of cells around an area, plus one; 0 if it is not free.
    fn room(&self, area: Area) -> usize {
        let inside = area.from.0 >= 2.0
            && area.from.1 >= 2.0
            && area.to.0 <= self.size.0 - 2.0
            && area.to.1 <= self.size.1 - 2.0;
        if !inside {
            return 0;
        }
        (0..REACH).find(|ring| !self.free(area, *ring)).unwrap_or(REACH)
    }

    fn free(&self, area: Area, ring: usize) -> bool {
        let rows = cell(area.from.1).saturating_sub(ring)..=(cell(area.to.1) + ring).min(self.rows - 1);
        let first = cell(area.from.0).saturating_sub(ring);
        let last = (cell(area.to.0) + ring).min(self.columns - 1);
        rows.map(|row| row * self.columns).all(|row| self.taken[row + first..=row + last].iter().all(|t| !t))
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates at 0; panels are small")]
fn cell(px: f64) -> usize {
    (px / CELL) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(x: f64, y: f64) -> Area {
        Area { from: (x, y), to: (x + 40.0, y + 12.0) }
    }

    #[test]
    fn a_label_keeps_away_from_curves() {
        let mut clearance = Clearance::new((200.0, 100.0));
        clearance.take_path(&[(0.0, 100.0), (200.0, 0.0)]);
        let places = [area(80.0, 45.0), area(60.0, 10.0), area(10.0, 10.0)];
        assert_eq!(clearance.freest(places.into_iter()), Some(area(10.0, 10.0)));
        assert_eq!(clearance.freest([area(80.0, 45.0), area(170.0, 80.0)].into_iter()), None);
    }
}
