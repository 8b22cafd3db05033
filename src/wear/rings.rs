//! Cells of the bed and rings of the surface, and the matrix that leads from one to the other.

use crate::shape::{Profile, Rim};
use std::f64::consts::{FRAC_PI_2, PI};

/// Place of the border of a ring in a cell: 1 − a, where a is the zero of ζ(−½, a) between ½ and 1.
const PLACE: f64 = 0.343_063_678_600_825;
/// Cells per radius are as many times finer at a wall, where the pressure has a root.
const AT_WALL: f64 = 1.5;

/// Where wear begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    /// Contact radius a [m].
    pub contact_radius: f64,
    /// Radius [m] inside which the contact sticks, if it is shaken.
    pub stick: Option<f64>,
    /// Cells per contact radius.
    pub cells: usize,
}

/// The borders of cells and rings, without end where the profile has none.
#[derive(Debug, Clone)]
struct Borders {
    /// Those of the cells up to the last place that must be one, and whether the border of a ring stands there too.
    first: Vec<(f64, bool)>,
    /// Width of a cell over its place beyond them.
    growth: f64,
    /// Where the profile ends [m].
    end: f64,
}

impl Borders {
    fn new(profile: &dyn Profile, start: Start) -> Self {
        let (a, growth) = (start.contact_radius, 1.0 / start.cells as f64);
        let wall = matches!(profile.rim(), Rim::Wall(b) if b <= a * (1.0 + 1e-12));
        let end = profile.rim().radius();
        let last = if wall { end } else { a };
        let stick = start.stick.filter(|&c| c > 1e-3 * a && c < (1.0 - 1e-3) * a);
        let bends = [profile.flat_radius(), profile.kink().unwrap_or(0.0)];
        let near = |x: f64, place: f64| (x - place).abs() < 0.3 * growth * a;
        let others = [0.0, last, stick.unwrap_or(0.0)];
        let inside = |x: &f64| *x < last && !others.iter().any(|&place| near(*x, place));
        let mut places: Vec<(f64, bool)> = bends.into_iter().filter(inside).map(|x| (x, false)).collect();
        places.extend(stick.map(|c| (c, true)));
        places.push((last, wall));
        places.sort_by(|x, y| x.0.total_cmp(&y.0));
        places.dedup_by(|next, kept| near(next.0, kept.0) && !next.1);
        let mut first = vec![(0.0, true)];
        for (at, place) in places.iter().enumerate() {
            let from = first.last().map_or(0.0, |border| border.0);
            let narrow = wall && at + 1 == places.len();
            stretch(&mut first, (from, *place), growth * a, narrow);
        }
        Self { first, growth, end }
    }

    /// The border after the first `count`, and whether that of a ring stands there; `None` beyond the end.
    fn at(&self, count: usize, before: f64) -> Option<(f64, bool)> {
        match self.first.get(count) {
            Some(&border) => Some(border),
            None if before >= self.end => None,
            None => {
                let next = before * (1.0 + self.growth);
                Some(if next >= self.end { (self.end, true) } else { (next, false) })
            }
        }
    }
}

/// Adds cells of about the width `width` up to a place, `narrow`ing towards it as the cosine of an angle does.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand cells")]
fn stretch(borders: &mut Vec<(f64, bool)>, (from, (to, crisp)): (f64, (f64, bool)), width: f64, narrow: bool) {
    let density = if narrow { AT_WALL } else { 1.0 };
    let count = (density * (to - from) / width).round().max(1.0) as usize;
    let part = |k: usize| {
        let t = k as f64 / count as f64;
        if narrow { (FRAC_PI_2 * t).sin() } else { t }
    };
    borders.extend((1..count).map(|k| (from + (to - from) * part(k), false)));
    borders.push((to, crisp));
}

/// Cells of the bed, rings of the surface, and the matrix M between them.
#[derive(Debug, Clone)]
pub struct Rings {
    borders: Borders,
    /// Borders of the cells [m].
    cells: Vec<f64>,
    /// Borders of the rings [m].
    rings: Vec<f64>,
    /// Areas of the rings [m²].
    areas: Vec<f64>,
    /// Rows of M [m], one after the other: the row i has i + 1 numbers.
    matrix: Vec<f64>,
    /// Whether the profile ends with the last cell.
    ended: bool,
}

impl Rings {
    /// As many as the contact covers, and a few more.
    pub fn new(profile: &dyn Profile, start: Start) -> Self {
        let borders = Borders::new(profile, start);
        let (cells, rings) = (vec![0.0], vec![0.0]);
        let mut all = Self { borders, cells, rings, areas: Vec::new(), matrix: Vec::new(), ended: false };
        while !all.ended && all.outer() <= start.contact_radius * (1.0 + 6.0 * all.borders.growth) {
            all.grow();
        }
        all
    }

    /// One more cell and its ring; nothing where the profile ends.
    pub fn grow(&mut self) {
        let Some((x, crisp)) = self.borders.at(self.cells.len(), self.outer()) else {
            self.ended = true;
            return;
        };
        let inner = self.outer();
        self.cells.push(x);
        let next = self.borders.at(self.cells.len(), x);
        self.ended = next.is_none();
        let ring = match next {
            Some((next, _)) if !crisp => x + PLACE * (next - x),
            Some(_) | None => x,
        };
        let within = self.rings[self.rings.len() - 1];
        self.rings.push(ring);
        self.areas.push(PI * (ring - within) * (ring + within));
        let fall = |r: f64| root(x, r) - root(inner, r);
        let falls: Vec<f64> = self.rings.iter().map(|&r| fall(r)).collect();
        self.matrix.extend(falls.windows(2).map(|pair| pair[0] - pair[1]));
    }

    /// Number of cells, and of rings.
    pub fn len(&self) -> usize {
        self.areas.len()
    }

    /// Whether the profile ends with the last cell.
    pub fn ended(&self) -> bool {
        self.ended
    }

    /// Outer border of the last cell [m].
    pub fn outer(&self) -> f64 {
        self.cells[self.cells.len() - 1]
    }

    /// Borders of the cells [m].
    pub fn cells(&self) -> &[f64] {
        &self.cells
    }

    /// Borders of the rings [m].
    pub fn rings(&self) -> &[f64] {
        &self.rings
    }

    /// Areas of the rings [m²].
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Width of the cell `i` [m].
    pub fn width(&self, i: usize) -> f64 {
        self.cells[i + 1] - self.cells[i]
    }

    /// The row of the cell `i`: M_ij [m] of the rings up to its own.
    pub fn row(&self, i: usize) -> &[f64] {
        let from = i * (i + 1) / 2;
        &self.matrix[from..=from + i]
    }

    /// Forces of the rings [N] under the line loads `loads` q [N/m] of the cells from the axis outwards:
    /// F_j = 2 Σ_i M_ij q_i.
    pub fn forces(&self, loads: &[f64], forces: &mut [f64]) {
        forces.fill(0.0);
        for (i, load) in loads.iter().enumerate().filter(|(_, load)| load.abs() > 0.0) {
            let twice = 2.0 * load;
            for (force, m) in forces.iter_mut().zip(self.row(i)) {
                *force += twice * m;
            }
        }
    }

    /// Mean of Δg [m] over the cell `i` under the worn depths `worn` [m] of the rings.
    pub fn raised(&self, i: usize, worn: &[f64]) -> f64 {
        dot(self.row(i), worn) / self.width(i)
    }

    /// Bytes of all.
    pub fn bytes(&self) -> usize {
        size_of::<f64>() * (self.matrix.len() + self.cells.len() + self.rings.len() + self.areas.len())
    }
}

/// Sum of products over as many as both have, in four lanes: the same on any machine.
pub fn dot(one: &[f64], other: &[f64]) -> f64 {
    let count = one.len().min(other.len());
    let (ones, one_rest) = one[..count].as_chunks::<4>();
    let (others, other_rest) = other[..count].as_chunks::<4>();
    let mut lanes = [0.0; 4];
    for (x, y) in ones.iter().zip(others) {
        for k in 0..4 {
            lanes[k] += x[k] * y[k];
        }
    }
    let rest: f64 = one_rest.iter().zip(other_rest).map(|(x, y)| x * y).sum();
    (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]) + rest
}

/// √(x² − r²)₊.
fn root(x: f64, r: f64) -> f64 {
    if x > r { ((x - r) * (x + r)).sqrt() } else { 0.0 }
}
