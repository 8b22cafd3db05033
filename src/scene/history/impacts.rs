//! Which impacts can be followed, whatever the numbers.

use super::{Entry, Impact};
use crate::contact::adhesion::{Adhesion, Edge};
use crate::input::problem::Problem;
use crate::shape::Shape;

/// What the other parts of a scene are.
#[derive(Debug, Clone, Copy)]
pub struct Parts<'s> {
    /// Shape of the indenter.
    pub shape: &'s Shape,
    /// Adhesion.
    pub adhesion: Option<&'s Adhesion>,
    /// Whether one of the bodies is viscoelastic.
    pub relaxes: bool,
    /// Whether the scene asks for a bed of springs.
    pub springs: bool,
}

/// What is wrong with the impacts of a history.
#[must_use]
pub fn problems(history: &[Entry], parts: Parts<'_>) -> Vec<Problem> {
    let found = history.iter().enumerate().filter_map(|(index, entry)| {
        let Entry::Impact(impact) = entry else { return None };
        Some((index, impact.problem(parts)?))
    });
    let what = |(index, message)| Problem::new(format!("history[{index}]"), message);
    found.map(what).collect()
}

impl Impact {
    fn problem(&self, parts: Parts<'_>) -> Option<String> {
        if parts.springs {
            return Some(
                "Impact with springs cannot be computed, for an impact is followed without springs: leave springs out"
                    .to_owned(),
            );
        }
        if let Shape::RoughLine(_) | Shape::HeightMap(..) = parts.shape {
            return Some(format!("Impact of a {} cannot be computed: expected a smooth shape", parts.shape.name()));
        }
        if let (true, Some(Adhesion::Jkr(jkr))) = (parts.relaxes, parts.adhesion)
            && let Some(Edge::Rate(_)) = jkr.edge
        {
            return Some(
                "Impact with an edge: Rate(…) cannot be computed: expected edge: Relaxed or Instantaneous".to_owned(),
            );
        }
        if !self.is_oblique() {
            return None;
        }
        if parts.relaxes {
            return Some("an oblique Impact of a Viscoelastic body cannot be computed: expected Elastic bodies, or no angle and spin".to_owned());
        }
        let ball = matches!(parts.shape, Shape::Paraboloid(_));
        (!ball).then(|| {
            format!(
                "an oblique Impact of a {} cannot be computed, for only a ball is known to turn as it slips: expected Paraboloid(radius: …), or no angle and spin",
                parts.shape.name()
            )
        })
    }
}
