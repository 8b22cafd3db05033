//! Where the springs of a bed stand.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::layout::Layout;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//!
//! let springs = Layout::uniform(&Paraboloid { radius: Length::new(1.0)? }, 0.2, 4);
//! assert!((springs.place[1] - 0.075).abs() < 1e-15);
//! // g(x) = x²/R, and both halves of the bed count.
//! assert!((springs.height[1] - 0.075 * 0.075).abs() < 1e-15);
//! assert!((springs.weight[1] - 0.1).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::shape::Profile;

/// Springs at the middle of cells, in ascending order of their distance from the axis.
///
/// Both halves of the bed move alike, so one half is kept, with the weight 2Δx.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// Distance x from the axis [m].
    pub place: Vec<f64>,
    /// Height g(x) of the indenter above each spring [m].
    pub height: Vec<f64>,
    /// Weight 2Δx [m].
    pub weight: Vec<f64>,
}

impl Layout {
    /// `count` springs of equal width up to `radius` [m]: the classical bed, F exact to order (Δx/a)².
    #[must_use]
    pub fn uniform(profile: &dyn Profile, radius: f64, count: usize) -> Self {
        let width = radius / as_f64(count);
        Self::new(profile, (0..=count).map(|k| as_f64(k) * width))
    }

    /// `count` springs up to `radius` [m], as wide as a fixed part of their distance beyond `fine` [m]:
    /// the same relative error for every size of contact above `fine`.
    #[must_use]
    pub fn graded(profile: &dyn Profile, (fine, radius): (f64, f64), count: usize) -> Self {
        // Cells X = fine·sinh(kβ): equal up to about `fine`, in geometric progression beyond.
        let step = (radius / fine).asinh() / as_f64(count);
        Self::new(profile, (0..=count).map(|k| fine * (as_f64(k) * step).sinh()))
    }

    /// Springs of the width Δx [m] under the heights `height` [m], which ascend: a rough line, its springs sorted. The
    /// place of a spring is half the length of the line that is touched before it.
    #[must_use]
    pub fn sorted(height: Vec<f64>, width: f64) -> Self {
        let place = (0..height.len()).map(|k| 0.5 * width * (as_f64(k) + 0.5)).collect();
        Self { place, weight: vec![width; height.len()], height }
    }

    fn new(profile: &dyn Profile, borders: impl Iterator<Item = f64> + Clone) -> Self {
        let cells = borders.clone().zip(borders.skip(1));
        let place: Vec<f64> = cells.clone().map(|(low, high)| 0.5 * (low + high)).collect();
        let height = place.iter().map(|&x| profile.reduced(x)).collect();
        Self { place, height, weight: cells.map(|(low, high)| 2.0 * (high - low)).collect() }
    }

    /// More springs, each cell as much wider than the one before as the last one was, up to `radius` [m].
    pub fn extend(&mut self, profile: &dyn Profile, radius: f64) {
        let [.., before, last] = self.weight[..] else { return };
        let (growth, mut width) = (last / before, 0.5 * last);
        let mut inner = self.place.last().map_or(0.0, |x| x + 0.5 * width);
        while inner < radius && width > 0.0 {
            width *= growth;
            self.place.push(inner + 0.5 * width);
            self.height.push(profile.reduced(inner + 0.5 * width));
            self.weight.push(2.0 * width);
            inner += width;
        }
    }

    /// Number of springs.
    #[must_use]
    pub fn len(&self) -> usize {
        self.place.len()
    }

    /// Whether there is no spring at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.place.is_empty()
    }

    /// Contact radius [m]: where the load of the last springs, `loads(j)`, goes through zero.
    ///
    /// Between the last of the `pressed` springs and the next one, to which it is limited.
    pub fn edge(&self, pressed: usize, loads: impl Fn(usize) -> f64) -> f64 {
        let Some(last) = pressed.checked_sub(1) else { return 0.0 };
        let border = |j: usize| self.place[j] + 0.25 * self.weight[j];
        let Some(inner) = last.checked_sub(1) else { return border(last) };
        let (q, fall) = (loads(last), loads(inner) - loads(last));
        let reach = q * (self.place[last] - self.place[inner]) / fall;
        let limit = self.place.get(pressed).map_or(border(last), |&x| x) - self.place[last];
        self.place[last] + if reach >= 0.0 { reach.min(limit) } else { 0.0 }
    }
}

#[expect(clippy::cast_precision_loss, reason = "the number of springs is far below 2^53")]
fn as_f64(count: usize) -> f64 {
    count as f64
}
