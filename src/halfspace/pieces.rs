//! Connected pieces of a set of pixels: patches of contact, and the gap that leaks.

use super::Boundary;
use ndarray::Array2;

/// What the connected pieces of a set of pixels come to; pixels are joined over their sides, not over corners.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Pieces {
    /// How many there are.
    pub count: usize,
    /// Whether one of them leads from a border to the opposite one; where everything repeats, on for ever.
    pub percolates: bool,
}

/// The connected pieces of a set of pixels.
///
/// ```
/// use ndarray::array;
/// use springbed::halfspace::{Boundary, pieces};
///
/// let set = array![[true, false, true], [false, false, true], [true, false, true]];
/// let free = pieces(&set, Boundary::Free);
/// assert_eq!((free.count, free.percolates), (3, true));
/// // Where it repeats, the corners lie beside each other and beside the column.
/// assert_eq!(pieces(&set, Boundary::Periodic).count, 1);
/// ```
#[must_use]
pub fn pieces(set: &Array2<bool>, boundary: Boundary) -> Pieces {
    let mut search = Search { set, boundary, seen: Array2::from_elem(set.dim(), None) };
    let mut found = Pieces::default();
    for ((row, column), &inside) in set.indexed_iter() {
        if inside && search.seen[[row, column]].is_none() {
            found.count += 1;
            found.percolates |= search.piece([row, column]);
        }
    }
    found
}

/// A pixel, and how often the way to it has gone round along the rows and the columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Visit {
    at: [usize; 2],
    turns: [i32; 2],
}

struct Search<'s> {
    set: &'s Array2<bool>,
    boundary: Boundary,
    /// Turns of the way to the pixels seen.
    seen: Array2<Option<[i32; 2]>>,
}

impl Search<'_> {
    /// Goes through the piece that holds the pixel `start`; whether it percolates.
    fn piece(&mut self, start: [usize; 2]) -> bool {
        let first = Visit { at: start, turns: [0; 2] };
        let (mut stack, mut percolates) = (vec![first], false);
        let mut touched = [[false; 2]; 2];
        self.seen[start] = Some(first.turns);
        while let Some(visit) = stack.pop() {
            for (axis, borders) in touched.iter_mut().enumerate() {
                borders[0] |= visit.at[axis] == 0;
                borders[1] |= visit.at[axis] + 1 == self.side(axis);
                for ahead in [false, true] {
                    let Some(next) = self.beside(visit, axis, ahead).filter(|next| self.set[next.at]) else { continue };
                    match self.seen[next.at] {
                        None => {
                            self.seen[next.at] = Some(next.turns);
                            stack.push(next);
                        }
                        // By another way round the same pixel.
                        Some(turns) => percolates |= turns != next.turns,
                    }
                }
            }
        }
        percolates || self.boundary == Boundary::Free && touched.contains(&[true; 2])
    }

    fn side(&self, axis: usize) -> usize {
        let (rows, columns) = self.set.dim();
        [rows, columns][axis]
    }

    /// The pixel next to another along an axis, if there is one.
    fn beside(&self, visit: Visit, axis: usize, ahead: bool) -> Option<Visit> {
        let (mut next, last) = (visit, self.side(axis) - 1);
        match (ahead, visit.at[axis]) {
            (true, at) if at < last => next.at[axis] = at + 1,
            (false, at) if at > 0 => next.at[axis] = at - 1,
            _ if self.boundary == Boundary::Free => return None,
            (true, _) => (next.at[axis], next.turns[axis]) = (0, visit.turns[axis] + 1),
            (false, _) => (next.at[axis], next.turns[axis]) = (last, visit.turns[axis] - 1),
        }
        Some(next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(rows: &[&str]) -> Array2<bool> {
        let columns = rows[0].len();
        Array2::from_shape_fn((rows.len(), columns), |(row, column)| rows[row].as_bytes()[column] == b'#')
    }

    #[test]
    fn pieces_are_joined_over_sides_only() {
        let set = drawn(&["#..", ".#.", "..#"]);
        assert_eq!(pieces(&set, Boundary::Free), Pieces { count: 3, percolates: false });
        assert_eq!(pieces(&drawn(&["..."]), Boundary::Free), Pieces::default());
    }

    /// A stair that closes on itself beyond the corner goes on for ever; one that stops short does not.
    #[test]
    fn a_piece_goes_on_where_everything_repeats() {
        let stair = drawn(&["##..", ".##.", "..##", "#..#"]);
        assert_eq!(pieces(&stair, Boundary::Periodic), Pieces { count: 1, percolates: true });
        assert!(pieces(&stair, Boundary::Free).percolates);
        let short = drawn(&["##..", ".##.", "..#.", "#..."]);
        assert!(!pieces(&short, Boundary::Periodic).percolates);
        assert!(pieces(&drawn(&["....", "####"]), Boundary::Periodic).percolates);
        // Across the border, but not round.
        assert_eq!(pieces(&drawn(&["#..#", "...."]), Boundary::Periodic), Pieces { count: 1, percolates: false });
    }
}
