//! What one spring sees of a profile that glides over it: a polygon, gone through from the front to the rear.

use crate::shape::Profile;

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
