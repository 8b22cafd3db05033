//! What lies under the patches of a rough line that adheres: gaps, and when springs close and open.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::rough::{AdhesiveRough, EdgeWorks};
//!
//! // A spring alone, E*Δx = 2, goes where its energy is that of its surface: ½·2·Δl² = wπ(Δx/2)².
//! let works = EdgeWorks { opening: 1.0, closing: 1.0 };
//! let mut spring = AdhesiveRough::of_gaps(&[0.0], 1.0, 2.0, works)?;
//! spring.follow(&Straight::between(0.0, 0.0, 1.0))?;
//! let last = spring.last_depth().unwrap()?;
//! assert!((last + (std::f64::consts::PI / 4.0).sqrt()).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::bed::number;
use crate::shape::rough::{RoughError, positive};
use std::f64::consts::PI;
use std::ops::Range;

/// Work of adhesion [J/m²] of an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgeWorks {
    /// What opening it takes.
    pub opening: f64,
    /// What closing it gives, at most as much.
    pub closing: f64,
}

/// A depth [m] at which a spring closes, or opens in the patch with the ends `ends`; in the order of the depths.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turn {
    pub(super) depth: f64,
    pub(super) spring: usize,
    pub(super) ends: (usize, usize),
}

impl PartialEq for Turn {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Turn {}

impl PartialOrd for Turn {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Turn {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.depth.total_cmp(&other.depth).then(self.spring.cmp(&other.spring))
    }
}

/// What is under the patches and stays as it is.
#[derive(Debug)]
pub(super) struct Ground {
    /// Gaps along the line above its first touch [m]; infinite where no spring stands.
    pub(super) gaps: Vec<f64>,
    /// The springs in the order of their gaps.
    pub(super) order: Vec<usize>,
    greatest: Greatest,
    /// Stiffness of a spring, E*Δx [N/m].
    pub(super) stiffness: f64,
    /// Energy [J] of a closed spring that is a patch alone, w π(Δx/2)², where it opens and where it closes.
    opening: f64,
    pub(super) closing: f64,
    /// Springs a patch may reach.
    pub(super) within: Range<usize>,
    /// Length of the line [m].
    pub(super) length: f64,
}

impl Ground {
    /// Springs of a width Δx [m] and a stiffness E*Δx [N/m] under gaps [m] along a line.
    ///
    /// # Errors
    /// No gap that is finite, one that is NaN; a width or a stiffness that is not positive.
    pub(super) fn new(gaps: &[f64], width: f64, stiffness: f64, works: EdgeWorks) -> Result<Self, RoughError> {
        let (width, stiffness) = (positive("width of a spring", width)?, positive("spring stiffness", stiffness)?);
        if let Some(column) = gaps.iter().position(|g| g.is_nan() || *g == f64::NEG_INFINITY) {
            return Err(RoughError::Height { row: 1, column: column + 1, value: gaps[column] });
        }
        let mut order: Vec<_> = (0..gaps.len()).filter(|&spring| gaps[spring].is_finite()).collect();
        order.sort_by(|&one, &other| gaps[one].total_cmp(&gaps[other]));
        positive("number of springs", number(order.len()))?;
        let least = gaps[order[0]];
        let alone = 0.25 * PI * width * width;
        let gaps: Vec<_> = gaps.iter().map(|gap| gap - least).collect();
        Ok(Self {
            greatest: Greatest::new(&gaps),
            order,
            stiffness,
            opening: works.opening * alone,
            closing: works.closing * alone,
            within: 0..gaps.len(),
            length: width * number(gaps.len()),
            gaps,
        })
    }

    /// Elongation [m] whose energy is that of the surface by which a patch is more than what it has `beside` one of its
    /// springs: ½E*Δx Δl² = w π(Δx/2)² [(m + n + 1)² − m² − n²].
    fn elongation(&self, alone: f64, beside: (usize, usize)) -> f64 {
        (2.0 * alone * more(beside) / self.stiffness).sqrt()
    }

    /// Depth [m] at which a spring closes between patches of so many springs.
    pub(super) fn closes_at(&self, spring: usize, beside: (usize, usize)) -> f64 {
        self.gaps[spring] - self.elongation(self.closing, beside)
    }

    /// The spring of a patch that opens first, and when.
    pub(super) fn first_to_open(&self, ends: (usize, usize)) -> Turn {
        let depth =
            |spring: usize| self.gaps[spring] - self.elongation(self.opening, (spring - ends.0, ends.1 - spring));
        let turn = |spring: usize| Turn { depth: depth(spring), spring, ends };
        let mut first = turn(ends.0).max(turn(ends.1));
        // What the springs of a stretch hold is least at its ends.
        let most = |(from, to): (usize, usize), gap: f64| {
            let hold = |spring: usize| self.gaps[spring] - depth(spring);
            gap - hold(from).min(hold(to))
        };
        self.greatest.visit(ends, &mut |stretch, gap| {
            let worth = most(stretch, gap) > first.depth;
            if worth && stretch.0 == stretch.1 {
                first = first.max(turn(stretch.0));
            }
            worth
        });
        first
    }
}

/// (m + n + 1)² − m² − n².
pub(super) fn more((m, n): (usize, usize)) -> f64 {
    1.0 + 2.0 * (number(m) + number(n) + number(m) * number(n))
}

/// The greatest gap of every stretch of a line that is halved again and again.
#[derive(Debug)]
struct Greatest {
    /// Of the whole, of its halves, of their halves, …; the springs themselves, their number filled up to a power of
    /// two, are last.
    gaps: Vec<f64>,
}

impl Greatest {
    fn new(gaps: &[f64]) -> Self {
        let springs = gaps.len().next_power_of_two();
        let mut tree = vec![f64::NEG_INFINITY; 2 * springs];
        tree[springs..springs + gaps.len()].copy_from_slice(gaps);
        for node in (1..springs).rev() {
            tree[node] = tree[2 * node].max(tree[2 * node + 1]);
        }
        Self { gaps: tree }
    }

    /// Shows the stretches within `(from, to)`, with their greatest gap [m], from the whole to the single springs as
    /// long as `look` asks for more.
    fn visit(&self, within: (usize, usize), look: &mut dyn FnMut((usize, usize), f64) -> bool) {
        self.descend(1, self.gaps.len() / 2, within, look);
    }

    fn descend(
        &self,
        node: usize,
        springs: usize,
        within: (usize, usize),
        look: &mut dyn FnMut((usize, usize), f64) -> bool,
    ) {
        let level = self.gaps.len() / 2 / springs;
        let from = (node - level) * springs;
        let stretch = (from.max(within.0), (from + springs - 1).min(within.1));
        if stretch.0 > stretch.1 || !look(stretch, self.gaps[node]) || springs == 1 {
            return;
        }
        self.descend(2 * node, springs / 2, within, look);
        self.descend(2 * node + 1, springs / 2, within, look);
    }
}
