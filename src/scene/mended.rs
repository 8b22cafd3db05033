//! Places of a scene that were mended so that the rest of it can be judged.
//!
//! # Examples
//! ```
//! use springbed::scene::mended::{Look, Mended};
//!
//! // A body with a wrong Poisson's ratio is known to be elastic; no more is known of it.
//! let mended = Mended::at(["bodies.0.poisson", "history[2]"]);
//! assert!(mended.knows("bodies.0", Look::Kind) && !mended.knows("bodies.0", Look::Whole));
//! assert!(mended.knows("history[1]", Look::Whole) && !mended.knows("history[2]", Look::Kind));
//! ```

/// Where a scene is not as its writer meant it, for something else stands there or nothing at all.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Mended {
    /// The places, step by step from the scene inwards.
    places: Vec<Vec<String>>,
}

/// How much of a part one looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// Whether it is there, and of which kind.
    Kind,
    /// All that is in it.
    Whole,
}

impl Mended {
    /// Mended at the given paths, such as `history[3].to` or `bodies.0.young`.
    pub fn at<P: AsRef<str>>(paths: impl IntoIterator<Item = P>) -> Self {
        let owned = |path: P| steps(path.as_ref()).map(str::to_owned).collect();
        Self { places: paths.into_iter().map(owned).collect() }
    }

    /// Whether nothing is mended.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// Whether what a look at `path` finds is what its writer meant.
    #[must_use]
    pub fn knows(&self, path: &str, look: Look) -> bool {
        !self.places.iter().any(|place| touches(place, path, look))
    }
}

/// Whether the mended `place` shows in a look at `path`: it holds the path, or a look at the whole finds it inside.
fn touches(place: &[String], path: &str, look: Look) -> bool {
    let same = place.iter().zip(steps(path)).all(|(one, other)| one == other);
    same && (look == Look::Whole || place.len() <= steps(path).count())
}

/// Names of fields and numbers of elements on the way to a path.
fn steps(path: &str) -> impl Iterator<Item = &str> {
    path.split(['.', '[', ']']).filter(|step| !step.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mended_whole_leaves_nothing_known() {
        let mended = Mended::at([""]);
        assert!(!mended.knows("plots[3]", Look::Kind) && !mended.knows("", Look::Kind));
        assert!(Mended::default().knows("", Look::Whole));
    }

    #[test]
    fn members_of_pairs_are_counted_as_those_of_lists() {
        let mended = Mended::at(["bodies[1].shear.terms"]);
        assert!(!mended.knows("bodies.1", Look::Whole) && mended.knows("bodies.1", Look::Kind));
        assert!(mended.knows("bodies.0", Look::Whole) && !mended.knows("bodies", Look::Whole));
        assert!(Mended::at(["history[12]"]).knows("history[1]", Look::Whole));
    }
}
