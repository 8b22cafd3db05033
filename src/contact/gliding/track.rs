//! What one spring sees of a profile that glides over it: a polygon, gone through from the front to the rear.

use crate::contact::error::{ContactError, LineTooShort};
use crate::shape::Profile;
use std::ops::Range;

/// A polygon of depths d − g(ξ) over the way, in the order in which a spring meets them.
#[derive(Debug, Clone)]
pub(super) struct Track {
    /// Place of its beginning, from the middle of the body in the direction of its motion [m].
    pub front: f64,
    /// Ways [m] from each corner to the next.
    pub steps: Vec<f64>,
    /// Depths [m] at the corners: one more.
    pub depths: Vec<f64>,
}

impl Track {
    /// The chords of a round profile pressed by `depth` [m], `count` of them on either side; `None` if the contact would
    /// outgrow it.
    pub fn of_profile(profile: &dyn Profile, depth: f64, count: usize) -> Option<Self> {
        let front = profile.edge(depth)?;
        let half = match profile.kink().filter(|kink| *kink < front) {
            None => even(front, count),
            Some(kink) => beside(kink, front, count),
        };
        let mut at = 0.0;
        let mut inside: Vec<f64> = vec![depth - profile.reduced(0.0)];
        for step in &half {
            at += step;
            inside.push(depth - profile.reduced(at));
        }
        // At the edge the depth is zero, whatever its rounding.
        inside.pop();
        inside.push(0.0);
        Some(Self {
            front,
            steps: half.iter().rev().chain(&half).copied().collect(),
            depths: inside.iter().rev().chain(&inside[1..]).copied().collect(),
        })
    }
}

/// Steps of one width from the middle to the edge: one duration stands for all.
fn even(edge: f64, count: usize) -> Vec<f64> {
    vec![edge / count as f64; count]
}

/// Steps from the middle to the edge that are finer on both sides of a kink, beyond which the profile rises like a root.
fn beside(kink: f64, edge: f64, count: usize) -> Vec<f64> {
    let half = count.div_ceil(2);
    let square = |k: usize| (k as f64 / half as f64).powi(2);
    let graded = |k: usize| square(k + 1) - square(k);
    let inner = (0..half).rev().map(|k| kink * graded(k));
    inner.chain((0..half).map(|k| (edge - kink) * graded(k))).collect()
}

/// A rough line that glides, in the order in which a spring meets it.
#[derive(Debug, Clone)]
pub struct GlidingLine {
    /// Gaps [m] above the first touch.
    gaps: Vec<f64>,
    step: f64,
    extent: Extent,
}

/// How far a line reaches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extent {
    /// It comes again and again.
    Periodic,
    /// It has two ends, which must not touch.
    Single,
}

impl GlidingLine {
    /// A line that comes again and again, of gaps [m] at points that are `step` [m] apart, in the direction of its motion.
    #[must_use]
    pub fn periodic(gaps: &[f64], step: f64) -> Self {
        let lowest = gaps.iter().enumerate().min_by(|one, other| one.1.total_cmp(other.1));
        let (at, lowest) = lowest.map_or((0, 0.0), |(at, gap)| (at, *gap));
        // From the first point that touches backwards, and once around.
        let met = gaps[..=at.min(gaps.len().saturating_sub(1))].iter().rev().chain(gaps[at..].iter().rev());
        Self { gaps: met.map(|gap| gap - lowest).collect(), step, extent: Extent::Periodic }
    }

    /// A line with two ends, such as one on a ball.
    #[must_use]
    pub fn single(gaps: &[f64], step: f64) -> Self {
        let lowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        Self { gaps: gaps.iter().rev().map(|gap| gap - lowest).collect(), step, extent: Extent::Single }
    }

    /// Whether it comes again and again.
    #[must_use]
    pub fn is_periodic(&self) -> bool {
        self.extent == Extent::Periodic
    }

    /// Points [m] apart.
    pub(super) fn step(&self) -> f64 {
        self.step
    }

    /// How many points it has, of a line that comes again those of one period.
    pub(super) fn corners(&self) -> usize {
        self.gaps.len() - usize::from(self.is_periodic())
    }

    /// Gap [m] of the k-th point in the direction of the motion; of a line with two ends infinite beyond them.
    pub(super) fn gap(&self, corner: i64) -> f64 {
        let last = self.gaps.len().saturating_sub(1);
        let met = i64::try_from(last).ok().map(|last| last - corner);
        let met = match self.extent {
            Extent::Periodic => met.map(|met| met.rem_euclid(i64::try_from(last).unwrap_or(1).max(1))),
            Extent::Single => met,
        };
        met.and_then(|met| usize::try_from(met).ok())
            .and_then(|met| self.gaps.get(met))
            .copied()
            .unwrap_or(f64::INFINITY)
    }

    /// The chords under which a spring can be touched at `depth` [m], by their lower corners, with `margin` more on either side of a
    /// line with two ends.
    pub(super) fn chords_below(&self, depth: f64, margin: usize) -> Result<Range<i64>, ContactError> {
        let (corners, touched) = (self.corners(), |gap: &f64| *gap < depth);
        let signed = |corner: usize| i64::try_from(corner).unwrap_or(i64::MAX);
        if self.is_periodic() {
            return Ok(0..signed(corners));
        }
        let last = corners.saturating_sub(1);
        // Gaps are kept from the front to the rear.
        let (Some(front), Some(rear)) = (self.gaps.iter().position(touched), self.gaps.iter().rposition(touched))
        else {
            return Ok(0..0);
        };
        if front == 0 || rear == last {
            return Err(self.too_short(depth));
        }
        Ok(signed((last - rear).saturating_sub(margin))..signed((last - front + margin).min(last)))
    }

    fn too_short(&self, indentation: f64) -> ContactError {
        LineTooShort { indentation, length: self.step * (self.gaps.len() as f64 - 1.0) }.into()
    }

    /// Largest gap [m].
    pub(super) fn height(&self) -> f64 {
        self.gaps.iter().copied().fold(0.0, f64::max)
    }

    /// The line pressed by `depth` [m] from its first touch.
    pub(super) fn track(&self, depth: f64) -> Result<Track, ContactError> {
        let depths: Vec<f64> = self.gaps.iter().map(|gap| depth - gap).collect();
        let steps = vec![self.step; depths.len().saturating_sub(1)];
        let touches = |end: Option<&f64>| end.is_none_or(|end| *end >= 0.0);
        if self.extent == Extent::Single && (touches(depths.first()) || touches(depths.last())) {
            return Err(self.too_short(depth));
        }
        Ok(Track { front: 0.0, steps, depths })
    }
}
