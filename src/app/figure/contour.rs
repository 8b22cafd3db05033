//! Filled contours of a quantity over two others, and the bar that tells their colours.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use super::axis::Ruler;
use super::canvas::Dot;
use super::curve::Map;
use super::{Axis, text, thin, ticks};

/// A quantity given at the points of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Contours {
    /// Places of the columns on the horizontal axis, ascending, in SI units.
    pub x: Vec<f64>,
    /// Places of the rows on the vertical axis, ascending, in SI units.
    pub y: Vec<f64>,
    /// Values row by row; what is missing counts as beyond the largest shown.
    pub values: Vec<Option<f64>>,
    /// The quantity; a limit of its axis cuts it off.
    pub axis: Axis,
    /// How its values are told by colours.
    pub colours: Colours,
}

/// How values are told by colours; more is told from less in grey too.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colours {
    /// The darker the more.
    #[default]
    Rising,
    /// Blue below zero, and the darker the further below; yellow above it, and the lighter the further above. The
    /// contour of zero is a thick line.
    AboutZero,
}

impl Contours {
    /// First or last of some places.
    pub(super) fn end(&self, places: &[f64], end: usize) -> Option<f64> {
        if end == 0 { places.first().copied() } else { places.last().copied() }
    }

    /// Least and largest value.
    fn range(&self) -> Option<(f64, f64)> {
        let values = self.values.iter().flatten().filter(|value| value.is_finite());
        values.fold(None, |range: Option<(f64, f64)>, &value| {
            let (low, high) = range.unwrap_or((value, value));
            Some((low.min(value), high.max(value)))
        })
    }
}

/// Contours in px: areas to be drawn one over the other, and their bar.
#[derive(Clone, Debug)]
pub(super) struct Layers {
    /// Colour below the first level.
    pub(super) ground: RGBColor,
    pub(super) areas: Vec<(Vec<Dot>, RGBColor)>,
    /// The contour of zero of a quantity of two signs.
    pub(super) zero: Vec<Vec<Dot>>,
    pub(super) bar: Bar,
}

/// The bar of colours beside the frame.
#[derive(Clone, Debug)]
pub(super) struct Bar {
    pub(super) ruler: Ruler,
    /// Fractions of the bar at which its bands end, and their colours, from below.
    pub(super) bands: Vec<(f64, RGBColor)>,
}

/// Px from the frame to the bar, and its width.
pub(super) const BAR_AT: f64 = 16.0;
pub(super) const BAR: f64 = 13.0;

impl Bar {
    /// Px right of the frame it takes.
    pub(super) fn right(&self) -> f64 {
        BAR_AT + BAR + 9.0 + self.ruler.widest() + 24.0
    }
}

/// The contours inside a frame; none without values.
pub(super) fn layers(contours: &Contours, map: &Map) -> Option<Layers> {
    let ruler = Ruler::upward(&contours.axis, Some(contours.range()?), map.size.1);
    let inner = levels(&ruler);
    let ends: Vec<f64> = inner.iter().copied().chain([1.0]).collect();
    let nought = ruler.range.place(0.0).unwrap_or(0.0);
    let colour = |band: usize| match contours.colours {
        Colours::Rising => shade(band as f64 / inner.len().max(1) as f64),
        Colours::AboutZero => about(signed(middle(&inner, band), nought)),
    };
    let bands = ends.iter().enumerate().map(|(band, &end)| (end, colour(band))).collect();
    let grid = Grid::new(contours, &ruler, map)?;
    let mut loops: Vec<(f64, Vec<Dot>, RGBColor)> = Vec::new();
    for (band, &level) in inner.iter().enumerate() {
        for outline in grid.outlines(level) {
            let area = area(&outline);
            let colour = colour(if area > 0.0 { band + 1 } else { band });
            loops.push((area.abs(), outline.iter().map(|place| grid.px(*place)).collect(), colour));
        }
    }
    // What lies inside another outline is smaller: drawn later it is seen.
    loops.sort_by(|x, y| y.0.total_cmp(&x.0));
    let areas = loops.into_iter().filter_map(|(_, outline, colour)| Some((thinned(outline)?, colour))).collect();
    let zero = match contours.colours {
        Colours::Rising => Vec::new(),
        Colours::AboutZero => within(&grid, nought, map.size),
    };
    Some(Layers { ground: colour(0), areas, zero, bar: Bar { ruler, bands } })
}

/// Where between two levels the band `band` has its middle.
fn middle(levels: &[f64], band: usize) -> f64 {
    let below = band.checked_sub(1).map_or(0.0, |below| levels[below]);
    0.5 * (below + levels.get(band).copied().unwrap_or(1.0))
}

/// How far a fraction of the bar lies from that of zero, over the farther end.
fn signed(at: f64, nought: f64) -> f64 {
    (at - nought) / nought.abs().max((1.0 - nought).abs())
}

/// The lines along which the fraction `level` of the bar is reached inside the frame; the frame itself is none.
fn within(grid: &Grid, level: f64, size: Dot) -> Vec<Vec<Dot>> {
    if !(1e-6..1.0 - 1e-6).contains(&level) {
        return Vec::new();
    }
    let along = |a: f64, b: f64, end: f64| a.min(b) <= RIM || a.max(b) >= end - RIM;
    let is_frame = |a: &Dot, b: &Dot| {
        (a.0 - b.0).abs() <= RIM && along(a.0, b.0, size.0) || (a.1 - b.1).abs() <= RIM && along(a.1, b.1, size.1)
    };
    let mut lines = Vec::new();
    for outline in grid.outlines(level) {
        let dots: Vec<Dot> = outline.iter().map(|place| grid.px(*place)).collect();
        lines.extend(dots.chunk_by(|a, b| !is_frame(a, b)).filter(|line| line.len() > 1).map(<[Dot]>::to_vec));
    }
    thin::thin(&lines)
}

/// Px from the frame within which a line counts as part of it.
const RIM: f64 = 1e-3;

/// Fewer bands than these are halved.
const FEW: usize = 6;

/// Fractions of the bar at which one colour gives way to the next: its ticks, and as many between them as it takes.
fn levels(ruler: &Ruler) -> Vec<f64> {
    let mut ticks: Vec<f64> = ruler.ticks.iter().filter(|tick| !tick.label.is_empty()).map(|tick| tick.at).collect();
    while let [first, second, ..] = ticks[..] {
        if ticks.len() > FEW {
            break;
        }
        let step = 0.5 * (second - first);
        let halfway = ticks.iter().flat_map(|&at| [at, at + step]);
        ticks = halfway.filter(|&at| at < 1.0 + step).collect();
    }
    ticks.into_iter().filter(|at| (1e-6..1.0 - 1e-6).contains(at)).collect()
}

fn thinned(outline: Vec<Dot>) -> Option<Vec<Dot>> {
    thin::thin(&[outline]).into_iter().next().filter(|outline| outline.len() > 2)
}

/// Light to dark over the hues, so that it reads in grey too.
fn shade(part: f64) -> RGBColor {
    const STOPS: [[f64; 3]; 5] =
        [[250.0, 250.0, 238.0], [199.0, 224.0, 180.0], [88.0, 178.0, 172.0], [34.0, 104.0, 158.0], [20.0, 30.0, 84.0]];
    let along = part.clamp(0.0, 1.0) * 4.0;
    let mut colour = STOPS[4];
    for (k, pair) in STOPS.windows(2).enumerate() {
        let rest = along - k as f64;
        if (0.0..1.0).contains(&rest) {
            colour = std::array::from_fn(|c| pair[0][c] + rest * (pair[1][c] - pair[0][c]));
        }
    }
    let [r, g, b] = colour.map(byte);
    RGBColor(r, g, b)
}

/// Dark blue at −1, yellow at 1, and lighter all the way; at zero the hue changes.
fn about(at: f64) -> RGBColor {
    const BELOW: [[f64; 3]; 3] = [[10.0, 26.0, 84.0], [56.0, 108.0, 176.0], [168.0, 203.0, 231.0]];
    const ABOVE: [[f64; 3]; 3] = [[244.0, 194.0, 112.0], [251.0, 222.0, 146.0], [255.0, 250.0, 206.0]];
    let (stops, along) = if at < 0.0 { (BELOW, 2.0 * (1.0 + at)) } else { (ABOVE, 2.0 * at) };
    let along = along.clamp(0.0, 2.0);
    let (low, rest) = if along < 1.0 { (0, along) } else { (1, along - 1.0) };
    let [r, g, b] = std::array::from_fn(|c| byte(stops[low][c] + rest * (stops[low + 1][c] - stops[low][c])));
    RGBColor(r, g, b)
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
fn byte(value: f64) -> u8 {
    value.round().clamp(0.0, 255.0) as u8
}

/// Values on a grid of px, with a rim of nothing about it.
struct Grid {
    columns: usize,
    rows: usize,
    x: Vec<f64>,
    y: Vec<f64>,
    /// Fractions of the bar, of the points inside the rim.
    values: Vec<f64>,
}

/// A place on the grid in columns and rows.
type Place = (f64, f64);
/// An edge of the grid: the numbers of its two points in ascending order.
type Edge = (usize, usize);

impl Grid {
    fn new(contours: &Contours, ruler: &Ruler, map: &Map) -> Option<Self> {
        let (columns, rows) = (contours.x.len(), contours.y.len());
        if columns < 2 || rows < 2 || contours.values.len() != columns * rows {
            return None;
        }
        let x: Option<Vec<f64>> = contours.x.iter().map(|&x| Some(map.x.range.place(x)? * map.size.0)).collect();
        let y: Option<Vec<f64>> =
            contours.y.iter().map(|&y| Some((1.0 - map.y.range.place(y)?) * map.size.1)).collect();
        // Far above the bar an outline would lie at the points that are below.
        let value = |value: &Option<f64>| value.and_then(|value| ruler.range.place(value)).unwrap_or(1.1).min(1.1);
        Some(Self { columns, rows, x: x?, y: y?, values: contours.values.iter().map(value).collect() })
    }

    /// Column and row of a point inside the rim; of one of the rim those nearest to it and `false`.
    fn point(&self, number: usize) -> ((usize, usize), bool) {
        let (row, column) = (number / (self.columns + 2), number % (self.columns + 2));
        let place = (column.clamp(1, self.columns) - 1, row.clamp(1, self.rows) - 1);
        (place, (place.0 + 1, place.1 + 1) == (column, row))
    }

    /// Value of a point; none of the rim.
    fn value(&self, number: usize) -> Option<f64> {
        let ((column, row), inner) = self.point(number);
        inner.then(|| self.values[row * self.columns + column])
    }

    /// Where the level lies on an edge: at the inner point where the other is of the rim.
    fn crossing(&self, (one, other): Edge, level: f64) -> Place {
        let part = match (self.value(one), self.value(other)) {
            (Some(first), Some(second)) => ((level - first) / (second - first)).clamp(0.0, 1.0),
            (Some(_), None) => 0.0,
            (None, _) => 1.0,
        };
        let ((c0, r0), (c1, r1)) = (self.point(one).0, self.point(other).0);
        let between = |from: usize, to: usize| from as f64 + part * (to as f64 - from as f64);
        (between(c0, c1), between(r0, r1))
    }

    /// The closed outlines of all that is at or above a level, which lies to their left: about it they run towards
    /// positive areas, about holes in it towards negative ones.
    fn outlines(&self, level: f64) -> Vec<Vec<Place>> {
        let mut next: BTreeMap<Edge, Edge> = BTreeMap::new();
        let width = self.columns + 2;
        let above = |point: usize| self.value(point).is_some_and(|value| value >= level);
        for row in 0..=self.rows {
            for column in 0..=self.columns {
                let corner = row * width + column;
                for triangle in [[corner, corner + 1, corner + width + 1], [corner, corner + width + 1, corner + width]]
                {
                    let turn = triangle.map(above);
                    let edge = |k: usize| {
                        let (one, other) = (triangle[k], triangle[(k + 1) % 3]);
                        (one.min(other), one.max(other))
                    };
                    let changes = |from: bool| (0..3).find(|&k| turn[k] == from && turn[(k + 1) % 3] != from);
                    if let (Some(leaves), Some(enters)) = (changes(true), changes(false)) {
                        next.insert(edge(leaves), edge(enters));
                    }
                }
            }
        }
        let mut outlines = Vec::new();
        while let Some((first, mut at)) = next.pop_first() {
            let mut outline = vec![self.crossing(first, level)];
            while at != first {
                outline.push(self.crossing(at, level));
                let Some(following) = next.remove(&at) else { break };
                at = following;
            }
            outline.push(outline[0]);
            outlines.push(outline);
        }
        outlines
    }

    /// Px of a place.
    fn px(&self, (column, row): Place) -> Dot {
        (between(&self.x, column), between(&self.y, row))
    }
}

/// Value between the points of a list.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "places on the grid are not negative")]
fn between(list: &[f64], at: f64) -> f64 {
    let k = (at as usize).min(list.len().saturating_sub(2));
    list[k] + (at - k as f64) * (list[k + 1] - list[k])
}

/// Twice the area inside an outline that is closed, positive if it runs from columns to rows.
fn area(outline: &[Place]) -> f64 {
    outline.windows(2).map(|pair| pair[0].0 * pair[1].1 - pair[1].0 * pair[0].1).sum()
}

/// The caption of the bar and its font size.
pub(super) fn caption(bar: &Bar, height: f64) -> (String, f64) {
    text::fit(&bar.ruler.caption, ticks::SIZE + 1.0, height)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(columns: usize, rows: usize, value: impl Fn(f64, f64) -> f64) -> Grid {
        let places = |count: usize| (0..count).map(|k| k as f64).collect::<Vec<_>>();
        let (x, y) = (places(columns), places(rows));
        let values = y.iter().flat_map(|&y| x.iter().map(move |&x| (x, y))).map(|(x, y)| value(x, y)).collect();
        Grid { columns, rows, x, y, values }
    }

    /// A hill whose foot leaves the grid: the area above a level is that of the circle, to the square of a cell; a pit in
    /// it runs the other way.
    #[test]
    fn outlines_hold_the_area_above_a_level() {
        let hill = grid(41, 31, |x, y| 1.0 - (x - 20.0).hypot(y - 15.0) / 20.0);
        let [outline] = &hill.outlines(0.5)[..] else { panic!() };
        assert!((0.5 * area(outline) / (100.0 * std::f64::consts::PI) - 1.0).abs() < 0.01);
        let pit = grid(41, 31, |x, y| (x - 20.0).hypot(y - 15.0) / 20.0);
        let areas: Vec<f64> = pit.outlines(0.5).iter().map(|outline| 0.5 * area(outline)).collect();
        assert_eq!(areas.len(), 2);
        assert!((areas.iter().sum::<f64>() / (1200.0 - 100.0 * std::f64::consts::PI) - 1.0).abs() < 0.01);
        assert!(areas.iter().any(|&area| area < 0.0));
    }

    #[test]
    fn all_above_is_the_whole_grid_and_all_below_nothing() {
        let flat = grid(5, 4, |_, _| 0.3);
        assert!(flat.outlines(0.4).is_empty());
        let [outline] = &flat.outlines(0.3)[..] else { panic!() };
        assert!((0.5 * area(outline) - 12.0).abs() < 1e-12);
    }

    /// About zero a print in grey tells more from less too.
    #[test]
    fn about_zero_colours_grow_lighter() {
        let grey = |at: f64| {
            let RGBColor(r, g, b) = about(at);
            0.299 * f64::from(r) + 0.587 * f64::from(g) + 0.114 * f64::from(b)
        };
        let greys: Vec<f64> = (-10..=10).map(|k| grey(0.1 * f64::from(k))).collect();
        assert!(greys.windows(2).all(|pair| pair[1] - pair[0] > 2.0), "{greys:?}");
        let RGBColor(r, _, b) = about(-1e-9);
        assert!(b > r, "blue below zero");
        let RGBColor(r, _, b) = about(0.0);
        assert!(r > b, "yellow above");
    }

    /// The contour of zero of a tilted plane crosses the frame once and does not follow it.
    #[test]
    fn the_contour_of_zero_is_not_the_frame() {
        let tilted = grid(11, 6, |x, _| 0.1 * x);
        let lines = within(&tilted, 0.45, (10.0, 5.0));
        let [line] = &lines[..] else { panic!("{lines:?}") };
        assert!(line.iter().all(|dot| (dot.0 - 4.5).abs() < 1e-9), "{line:?}");
    }

    #[test]
    fn colours_grow_darker() {
        let grey = |part: f64| {
            let RGBColor(r, g, b) = shade(part);
            0.299 * f64::from(r) + 0.587 * f64::from(g) + 0.114 * f64::from(b)
        };
        let shades: Vec<f64> = (0..=10).map(|k| grey(0.1 * f64::from(k))).collect();
        assert!(shades.windows(2).all(|pair| pair[0] - pair[1] > 5.0), "{shades:?}");
    }
}
