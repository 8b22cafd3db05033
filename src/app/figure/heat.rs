//! Cells of colour under a pair of axes, with the scale of their colours beside the frame.

use super::axis::Ruler;
use super::canvas::Dot;
use super::curve::Map;
use super::range::usable;
use super::{Axis, Cells, Scale};
use plotters::style::RGBColor;

/// Px between the frame and the scale of colours.
pub(super) const AWAY: f64 = 14.0;
/// Width of the scale of colours in px.
pub(super) const WIDE: f64 = 12.0;
/// Steps of the scale of colours.
pub(super) const STEPS: u32 = 64;

/// A cell in px.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    pub(super) from: Dot,
    pub(super) to: Dot,
    pub(super) colour: RGBColor,
}

/// Cells in px and the ruler of their colours.
#[derive(Clone, Debug)]
pub(super) struct Heat {
    pub(super) cells: Vec<Cell>,
    pub(super) ruler: Ruler,
}

impl Heat {
    /// The cells inside a frame.
    pub(super) fn new(cells: &Cells, axes: (&Axis, &Axis), map: &Map) -> Self {
        let shown = cells.values.iter().flatten().copied().filter(|value| usable(cells.of.scale, *value));
        let ends = shown.fold(None, |ends: Option<(f64, f64)>, value| {
            let (lo, hi) = ends.unwrap_or((value, value));
            Some((lo.min(value), hi.max(value)))
        });
        let limits = ends.filter(|(lo, hi)| lo < hi).map_or((None, None), |(lo, hi)| (Some(lo), Some(hi)));
        let ruler = Ruler::upward(&Axis { limits, ..cells.of.clone() }, ends, map.size.1);
        let (xs, ys) = (edges(&cells.x, axes.0.scale), edges(&cells.y, axes.1.scale));
        let mut drawn = Vec::new();
        for (column, x) in xs.windows(2).enumerate() {
            for (row, y) in ys.windows(2).enumerate() {
                let value = cells.values.get(column * cells.y.len() + row).copied().flatten();
                let place = value.and_then(|value| ruler.range.place(value));
                if let (Some(at), Some(from), Some(to)) = (place, map.place((x[0], y[1])), map.place((x[1], y[0]))) {
                    drawn.push(Cell { from, to, colour: step_of(at) });
                }
            }
        }
        // Cells of one colour follow each other, and are one path on the sheet.
        drawn.sort_by_key(|cell: &Cell| (cell.colour.0, cell.colour.1, cell.colour.2));
        Self { cells: drawn, ruler }
    }
}

/// The colour of the step of the scale that a fraction of it lies in.
fn step_of(at: f64) -> RGBColor {
    let steps = f64::from(STEPS);
    colour(((at * steps).floor().clamp(0.0, steps - 1.0) + 0.5) / steps)
}

/// Ends of the cells around rising values: midway between neighbours, as far beyond the outer ones.
pub(super) fn edges(values: &[f64], scale: Scale) -> Vec<f64> {
    let to = |value: f64| if scale == Scale::Log { value.log10() } else { value };
    let back = |place: f64| if scale == Scale::Log { 10f64.powf(place) } else { place };
    let [first, .., last] = values else { return Vec::new() };
    let half = |pair: &[f64]| 0.5 * (to(pair[1]) - to(pair[0]));
    let mut edges: Vec<f64> = values.windows(2).map(|pair| back(to(pair[0]) + half(pair))).collect();
    edges.insert(0, back(to(*first) - half(&values[..2])));
    edges.push(back(to(*last) + half(&values[values.len() - 2..])));
    edges
}

/// Colours of even lightness steps from dark blue to yellow, apart in grey and for the colour-blind.
const COLOURS: [(u8, u8, u8); 8] = [
    (0, 32, 76),
    (23, 58, 109),
    (66, 84, 107),
    (97, 108, 112),
    (128, 133, 120),
    (166, 160, 113),
    (209, 190, 93),
    (255, 233, 69),
];

/// The colour at a fraction of the scale.
pub(super) fn colour(at: f64) -> RGBColor {
    #[expect(clippy::cast_precision_loss, reason = "a few colours")]
    let place = at.clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the last but one")]
    let below = (place.floor() as usize).min(COLOURS.len() - 2);
    #[expect(clippy::cast_precision_loss, reason = "a few colours")]
    let share = place - below as f64;
    let (one, next) = (COLOURS[below], COLOURS[below + 1]);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between two bytes")]
    let mixed = |one: u8, next: u8| (f64::from(one) + share * (f64::from(next) - f64::from(one))).round() as u8;
    RGBColor(mixed(one.0, next.0), mixed(one.1, next.1), mixed(one.2, next.2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_meet_midway_between_their_values() {
        assert_eq!(edges(&[1.0, 2.0, 4.0], Scale::Linear), [0.5, 1.5, 3.0, 5.0]);
        let log = edges(&[1.0, 100.0], Scale::Log);
        assert!(log.iter().zip([0.1, 10.0, 1000.0]).all(|(found, right)| (found / right - 1.0).abs() < 1e-12));
        assert!(edges(&[1.0], Scale::Linear).is_empty());
    }

    /// Rec. 709 luma rises from end to end, so that a print in grey tells more from less.
    #[test]
    fn lightness_rises_with_the_value() {
        let luma = |c: RGBColor| 0.2126 * f64::from(c.0) + 0.7152 * f64::from(c.1) + 0.0722 * f64::from(c.2);
        let lights: Vec<f64> = (0..=100).map(|i| luma(colour(f64::from(i) / 100.0))).collect();
        assert!(lights.windows(2).all(|pair| pair[1] >= pair[0]) && lights[100] - lights[0] > 150.0);
    }
}
