//! Patches of a line: runs of neighbouring springs that hold.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::rough::{AdhesiveRough, EdgeWorks};
//!
//! // Two summits under springs of 1 N/m over a valley: two patches, which the springs between them make one.
//! let works = EdgeWorks { opening: 0.1, closing: 0.1 };
//! let mut line = AdhesiveRough::of_gaps(&[0.0, 9.0, 0.0], 1.0, 1.0, works)?;
//! line.follow(&Straight::between(0.0, 1.0, 1.0))?;
//! assert_eq!((line.state().stiffness, line.patches()), (2.0, 2));
//! line.follow(&Straight::between(1.0, 9.0, 1.0))?;
//! assert_eq!((line.state().stiffness, line.patches()), (3.0, 1));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

/// A spring that does not hold.
const FREE: usize = usize::MAX;

/// Which springs of a line hold, as runs of neighbours.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Patches {
    /// At either end of a patch its other end; [`FREE`] where no patch is, anything inside one.
    other: Vec<usize>,
}

impl Patches {
    /// A line of `springs` free springs.
    pub(super) fn new(springs: usize) -> Self {
        Self { other: vec![FREE; springs] }
    }

    /// Whether a spring holds.
    pub(super) fn holds(&self, spring: usize) -> bool {
        self.other[spring] != FREE
    }

    /// Lengths, in springs, of the patches before and behind a free spring.
    pub(super) fn beside(&self, spring: usize) -> (usize, usize) {
        let before = spring.checked_sub(1).map_or(0, |last| self.length_to(last));
        let behind = if spring + 1 < self.other.len() { self.length_to(spring + 1) } else { 0 };
        (before, behind)
    }

    /// Length of the patch that ends at a spring; zero where none does.
    pub(super) fn length_to(&self, end: usize) -> usize {
        if self.holds(end) { self.other[end].abs_diff(end) + 1 } else { 0 }
    }

    /// Lets a free spring hold; the first and the last spring of its patch.
    pub(super) fn close(&mut self, spring: usize) -> (usize, usize) {
        let (before, behind) = self.beside(spring);
        let (first, last) = (spring - before, spring + behind);
        self.other[spring] = spring;
        (self.other[first], self.other[last]) = (last, first);
        (first, last)
    }

    /// Whether a patch has these ends.
    pub(super) fn are_ends(&self, (first, last): (usize, usize)) -> bool {
        let free =
            |spring: Option<usize>| spring.is_none_or(|spring| self.other.get(spring).is_none_or(|at| *at == FREE));
        self.other[first] == last && self.other[last] == first && free(first.checked_sub(1)) && free(Some(last + 1))
    }

    /// Lets a spring of the patch with the ends `ends` go; the ends of what is left before and behind it.
    pub(super) fn open(&mut self, spring: usize, ends: (usize, usize)) -> [Option<(usize, usize)>; 2] {
        self.other[spring] = FREE;
        let before = (ends.0 < spring).then(|| (ends.0, spring - 1));
        let behind = (ends.1 > spring).then_some((spring + 1, ends.1));
        for (first, last) in [before, behind].into_iter().flatten() {
            (self.other[first], self.other[last]) = (last, first);
        }
        [before, behind]
    }

    /// The first and the last spring of every patch.
    pub(super) fn all(&self) -> impl Iterator<Item = (usize, usize)> {
        let mut from = 0;
        std::iter::from_fn(move || {
            let first = (from..self.other.len()).find(|&spring| self.holds(spring))?;
            from = self.other[first] + 1;
            Some((first, self.other[first]))
        })
    }
}
