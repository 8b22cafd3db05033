//! Reference lines and the places of their names.

use super::canvas::Dot;
use super::clearance::{Area, Clearance};
use super::curve::Map;
use super::{Guide, Scale, text};

/// Font size of the names of guides in px.
pub(super) const SIZE: f64 = 10.5;
/// Height of a line of text in px.
const HEIGHT: f64 = 13.0;
/// Length of a reference slope in px.
const SLOPE: f64 = 64.0;
/// Blank between a reference slope and the frame in px.
const RIM: f64 = 9.0;

/// A guide inside the frame.
#[derive(Clone, Debug, Default)]
pub(super) struct Ruled {
    /// The line; empty if it would lie outside.
    pub(super) line: Vec<Dot>,
    /// The line ends in an arrow head.
    pub(super) jump: bool,
    /// Name and the left middle of its place.
    pub(super) name: Option<(Dot, String)>,
    /// Name for the legend, if the panel had no free place for it.
    pub(super) homeless: Option<String>,
}

/// The guide inside the frame; its name takes a free place.
pub(super) fn rule(guide: &Guide, map: &Map, clearance: &mut Clearance) -> Ruled {
    let (w, h) = map.size;
    match guide {
        Guide::Horizontal { at, label } if map.y.range.holds(*at) => {
            let y = h - map.y.range.place(*at).unwrap_or(0.0) * h;
            named(vec![(0.0, y), (w, y)], label, clearance)
        }
        Guide::Vertical { at, label } if map.x.range.holds(*at) => {
            let x = map.x.range.place(*at).unwrap_or(0.0) * w;
            named(vec![(x, h), (x, 0.0)], label, clearance)
        }
        Guide::Slope { exponent, label } => slope(direction(*exponent, map), label, map, clearance),
        Guide::Jump { from, to } => jump(map.place(*from), map.place(*to), map),
        _ => Ruled::default(),
    }
}

fn jump(from: Option<Dot>, to: Option<Dot>, map: &Map) -> Ruled {
    let ends = from.zip(to).filter(|(a, b)| map.holds(a) && map.holds(b));
    Ruled { line: ends.map_or(Vec::new(), |(a, b)| vec![a, b]), jump: true, ..Ruled::default() }
}

/// A line through the panel with its name beside it.
fn named(line: Vec<Dot>, label: &str, clearance: &mut Clearance) -> Ruled {
    let label = text::clean(label);
    if label.is_empty() {
        return Ruled { line, ..Ruled::default() };
    }
    let wide = text::width(&label, SIZE);
    let area = clearance.freest(beside(&line, wide));
    clearance.take_path(&line);
    if let Some(area) = area {
        clearance.take_area(area);
    }
    Ruled {
        line,
        jump: false,
        name: area.map(|a| (middle(a), label.clone())),
        homeless: area.is_none().then_some(label),
    }
}

fn middle(area: Area) -> Dot {
    (area.from.0, 0.5 * (area.from.1 + area.to.1))
}

/// Places for a text of `wide` px on both sides of a horizontal or vertical line.
fn beside(line: &[Dot], wide: f64) -> impl Iterator<Item = Area> {
    let (a, b) = (line[0], line[1]);
    let flat = (b.1 - a.1).abs() < (b.0 - a.0).abs();
    (0..20).map(move |i| {
        let t = 0.03 + 0.094 * f64::from(9 - i / 2);
        let second = i % 2 == 1;
        let from = match (flat, second) {
            (true, false) => (t * (b.0 - wide), a.1 - HEIGHT - 2.0),
            (true, true) => (t * (b.0 - wide), a.1 + 3.0),
            (false, false) => (a.0 + 5.0, (1.0 - t) * (a.1 - HEIGHT)),
            (false, true) => (a.0 - wide - 5.0, (1.0 - t) * (a.1 - HEIGHT)),
        };
        let to = (from.0 + wide, from.1 + HEIGHT);
        Area { from, to }
    })
}

/// Px to the right and down for a line of the exponent, of the length of a reference slope.
fn direction(exponent: f64, map: &Map) -> Option<Dot> {
    let both = map.x.range.scale == Scale::Log && map.y.range.scale == Scale::Log;
    let u = map.size.0 / (map.x.range.hi - map.x.range.lo);
    let v = -exponent * map.size.1 / (map.y.range.hi - map.y.range.lo);
    let length = u.hypot(v);
    (both && length.is_finite()).then(|| (SLOPE * u / length, SLOPE * v / length))
}

fn slope(direction: Option<Dot>, label: &str, map: &Map, clearance: &mut Clearance) -> Ruled {
    let Some((u, v)) = direction else {
        return Ruled::default();
    };
    let label = text::clean(label);
    let reach = (0.5 * u + 2.0).max(8.0 + text::width(&label, SIZE));
    let size = (0.5 * u + reach, v.abs().max(26.0));
    let Some(area) = clearance.freest(everywhere(map.size, size)) else {
        return Ruled::default();
    };
    clearance.take_area(area);
    let centre = (area.from.0 + 0.5 * u, 0.5 * (area.from.1 + area.to.1));
    let side = if v > 0.0 { -9.0 } else { 9.0 };
    Ruled {
        line: vec![(centre.0 - 0.5 * u, centre.1 - 0.5 * v), (centre.0 + 0.5 * u, centre.1 + 0.5 * v)],
        name: Some(((centre.0 + 8.0, centre.1 + side), label)),
        ..Ruled::default()
    }
}

/// Areas of a size all over the panel.
fn everywhere(panel: Dot, size: Dot) -> impl Iterator<Item = Area> {
    let spare = (panel.0 - size.0 - 2.0 * RIM, panel.1 - size.1 - 2.0 * RIM);
    (0..400).map(move |i| {
        let (row, column) = (f64::from(i / 20) / 19.0, f64::from(i % 20) / 19.0);
        let from = (RIM + (1.0 - column) * spare.0, RIM + row * spare.1);
        Area { from, to: (from.0 + size.0, from.1 + size.1) }
    })
}
