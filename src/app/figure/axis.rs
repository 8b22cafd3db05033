//! Axes of a panel made ready: range, ticks, caption.

use super::range::{AxisRange, usable};
use super::ticks::{Along, SIZE, Tick, ticks};
use super::{Axis, Guide, Panel, text, unit};

/// An axis with its ticks.
#[derive(Clone, Debug)]
pub(super) struct Ruler {
    pub(super) range: AxisRange,
    pub(super) ticks: Vec<Tick>,
    pub(super) caption: String,
}

impl Ruler {
    fn new(axis: &Axis, mut range: AxisRange, mut ticks: Vec<Tick>) -> Self {
        if axis.falling {
            range.falling = true;
            ticks.iter_mut().for_each(|tick| tick.at = 1.0 - tick.at);
        }
        let caption = unit::caption(&axis.label, &axis.unit, range.exponent);
        Self { range, ticks, caption }
    }

    /// A ruler of its own that runs upwards over `length` px, around the data between two ends.
    pub(super) fn upward(axis: &Axis, data: Option<(f64, f64)>, length: f64) -> Self {
        let range = AxisRange::new(axis, data);
        Self::new(axis, range, ticks(&range, Along::Y, length))
    }

    /// Width of the widest tick label in px.
    pub(super) fn widest(&self) -> f64 {
        let widths = self.ticks.iter().map(|t| text::width(&t.label, SIZE));
        widths.fold(0.0, f64::max)
    }

    /// Px by which the last label stands out beyond an axis of `length` px.
    pub(super) fn overhang(&self, length: f64) -> f64 {
        let beyond = |t: &Tick| (t.at - 1.0) * length + 0.5 * text::width(&t.label, SIZE);
        self.ticks.iter().map(beyond).fold(0.0, f64::max)
    }
}

/// Horizontal and vertical axis of a panel of `size` px.
pub(super) fn rulers(panel: &Panel, size: (f64, f64)) -> (Ruler, Ruler) {
    let (mut x, mut y) = ends(panel);
    if let Some(contours) = &panel.contours {
        for end in [0, 1] {
            x = contours.end(&contours.x, end).map_or(x, |value| join(x, value));
            y = contours.end(&contours.y, end).map_or(y, |value| join(y, value));
        }
    }
    let x = AxisRange::new(&panel.x, x.map(|e| widened(e, guided(panel, &panel.x, Along::X))));
    let y = AxisRange::new(&panel.y, y.map(|e| widened(e, guided(panel, &panel.y, Along::Y))));
    (Ruler::new(&panel.x, x, ticks(&x, Along::X, size.0)), Ruler::new(&panel.y, y, ticks(&y, Along::Y, size.1)))
}

type Ends = Option<(f64, f64)>;

/// Least and largest x and y of the points shown.
fn ends(panel: &Panel) -> (Ends, Ends) {
    let points = panel.series.iter().flat_map(|s| s.points.iter().flatten());
    let shown = points.filter(|p| inside(&panel.x, p.0) && inside(&panel.y, p.1));
    shown.fold((None, None), |(x, y), p| (join(x, p.0), join(y, p.1)))
}

/// Whether a value is neither a gap nor beyond the limits asked for.
fn inside(axis: &Axis, value: f64) -> bool {
    usable(axis.scale, value)
        && axis.limits.0.is_none_or(|lo| value >= lo)
        && axis.limits.1.is_none_or(|hi| value <= hi)
}

fn join(ends: Ends, value: f64) -> Ends {
    let (lo, hi) = ends.unwrap_or((value, value));
    Some((lo.min(value), hi.max(value)))
}

/// Ends that include the guides not farther away than half the span.
fn widened(ends: (f64, f64), guides: impl Iterator<Item = f64>) -> (f64, f64) {
    let far = 0.5 * ends.1 - 0.5 * ends.0;
    let near = guides.filter(|v| *v >= ends.0 - far && *v <= ends.1 + far);
    near.fold(ends, |(lo, hi), v| (lo.min(v), hi.max(v)))
}

/// Values the guides stand at, of those along one axis.
fn guided<'p>(panel: &'p Panel, axis: &'p Axis, along: Along) -> impl Iterator<Item = f64> + 'p {
    let values = panel.guides.iter().flat_map(move |guide| match (guide, along) {
        (Guide::Vertical { at, .. }, Along::X) | (Guide::Horizontal { at, .. }, Along::Y) => vec![*at],
        (Guide::Jump { from, to }, Along::X) => vec![from.0, to.0],
        (Guide::Jump { from, to }, Along::Y) => vec![from.1, to.1],
        _ => Vec::new(),
    });
    values.filter(|value| inside(axis, *value))
}
