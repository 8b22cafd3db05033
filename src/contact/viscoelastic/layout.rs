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

    /// Where the contact ends: the load of the last springs goes through zero between the last of the `pressed` springs
    /// and the next one, and there the gap under the free ones ends. `signs(j)` is the load [N/m] of a pressed spring,
    /// and of a free one the gap below the indenter [m], below zero.
    ///
    /// A contact that has just turned back has a load q(x) like √(a₀ − x) − c there, for the front came slower and
    /// slower; x as a function of q is smooth all the same, as both are smooth in the time of touch. So x(q) is led on
    /// to q = 0 by a polynomial through up to four springs, to h⁴, as many as agree with one fewer: beside a border of two
    /// pasts two are left. The doubt is what another number of them changes, and how far off the free springs tell the
    /// edge, with their own doubt, for only those of one past go on smoothly; where they are not of one, it is the way to the
    /// farther of the two springs between which the edge is.
    pub fn edge(&self, pressed: usize, signs: impl Fn(usize) -> f64) -> Edge {
        let Some(last) = pressed.checked_sub(1) else {
            // What touches within the first spring presses none.
            let touches = self.height.first().is_some_and(|height| signs(0) + height > 0.0);
            let within = self.place.first().filter(|_| touches);
            return Edge { place: 0.0, doubt: within.map_or(0.0, |&first| first) };
        };
        let inner = self.place[last];
        let outer = self.place.get(pressed).map_or(inner + 0.25 * self.weight[last], |&x| x);
        let spring = |j: usize| (signs(j), self.place[j]);
        let loads = rising((0..pressed).rev().map(spring));
        let [.., _, _] = loads[..] else {
            // Under a wall all springs are pressed alike up to it.
            let wall = pressed > 1 && pressed == self.len();
            return if wall { Edge { place: outer, doubt: 0.0 } } else { Edge { place: inner, doubt: outer - inner } };
        };
        let gaps = rising((pressed..self.len()).map(|j| (-signs(j), self.place[j])));
        let from_outside = (gaps.len() > 1).then(|| [0, 1].map(|fewer| led_to_zero(&gaps[..gaps.len() - fewer])));
        let led: Vec<f64> = (2..=loads.len()).map(|count| led_to_zero(&loads[..count])).collect();
        // Springs of one past agree the better the more they are; beside a border of two pasts fewer are right.
        let change = |k: usize| (led[k] - led[k - 1]).abs();
        let best = (1..led.len()).rev().min_by(|&j, &k| change(j).total_cmp(&change(k))).unwrap_or(0);
        let between = |place: f64| place.clamp(inner, outer);
        let agree = best > 0 && change(best) < AGREE * (outer - inner);
        let is_one_past = agree && led[best] > inner && led[best] < outer;
        let place = between(if is_one_past { led[best] } else { led[0] });
        let apart = |other: f64| (place - between(other)).abs();
        let inside = led.iter().map(|&other| apart(other)).fold(0.0, f64::max);
        let outside = from_outside.map_or(0.0, |[all, fewer]| apart(all) + (all - fewer).abs());
        let doubt = inside.max(outside);
        let farther = (place - inner).max(outer - place);
        let is_told = is_one_past && loads.len() == NODES && from_outside.is_some();
        Edge { place, doubt: if is_told { doubt.min(farther) } else { farther } }
    }
}

impl Layout {
    /// Where a contact ends whose loads do not go to zero there, as under a front that closes over a dashpot: where the gap
    /// of the free springs does, `gap(j)` [m]. `None` where too few are left.
    pub fn closing_edge(&self, pressed: usize, gap: impl Fn(usize) -> f64) -> Option<Edge> {
        let inner = self.place[pressed.checked_sub(1)?];
        let gaps = rising((pressed..self.len()).map(|j| (gap(j), self.place[j])));
        let [(_, outer), _, ..] = gaps[..] else { return None };
        let [place, other] = [0, 1].map(|fewer| led_to_zero(&gaps[..gaps.len() - fewer]).clamp(inner, outer));
        Some(Edge { place, doubt: (place - other).abs() })
    }
}

/// The springs nearest to an edge, as long as the value rises away from it.
fn rising(springs: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::with_capacity(NODES);
    for spring in springs.take(NODES) {
        if kept.last().is_some_and(|before| before.0 >= spring.0) {
            break;
        }
        kept.push(spring);
    }
    kept
}

/// Where a contact ends, as its springs tell.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Edge {
    /// Its distance from the axis [m].
    pub place: f64,
    /// By how much that may be off [m].
    pub doubt: f64,
}

/// Part of the way to the next spring to which springs of one past agree where the contact ends.
const AGREE: f64 = 0.1;
/// Springs at the edge by whose loads it is found.
pub(super) const NODES: usize = 4;

/// The polynomial x(q) through the points (q, x), at q = 0 (Neville).
fn led_to_zero(points: &[(f64, f64)]) -> f64 {
    let mut values: Vec<f64> = points.iter().map(|&(_, x)| x).collect();
    for order in 1..points.len() {
        for k in 0..points.len() - order {
            let (near, far) = (points[k].0, points[k + order].0);
            values[k] += near * (values[k] - values[k + 1]) / (far - near);
        }
    }
    values.first().copied().unwrap_or(0.0)
}

#[expect(clippy::cast_precision_loss, reason = "the number of springs is far below 2^53")]
fn as_f64(count: usize) -> f64 {
    count as f64
}
