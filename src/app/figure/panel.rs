//! A panel made ready to be drawn: everything in px relative to its frame.

use plotters::style::RGBColor;

use super::area::filled;
use super::axis::{Ruler, rulers};
use super::canvas::Dot;
use super::clearance::Clearance;
use super::contour::{Layers, layers};
use super::curve::{DrawnCurve, Map, curve};
use super::guide::{Ruled, rule};
use super::heat::{AWAY, Heat, WIDE};
use super::legend::{self, Legend};
use super::look::{Look, look};
use super::{Arrow, Panel, text};

/// Font size of remarks in px.
pub(super) const NOTE: f64 = 10.0;
/// Font size of the heading of a panel in px.
pub(super) const HEADING: f64 = 12.0;
/// Px by which legend and remarks start left of the frame.
pub(super) const INDENT: f64 = 30.0;
/// Entries from which the legend of a panel standing alone is put beside it.
const MANY: usize = 5;

/// A curve with its look.
#[derive(Clone, Debug)]
pub(super) struct Shown {
    pub(super) curve: DrawnCurve,
    pub(super) look: Look,
    pub(super) arrow: Arrow,
}

/// Where the legend of a panel is.
#[derive(Clone, Debug)]
pub(super) enum Key {
    Below(Legend),
    Beside(Legend),
}

/// A panel in px.
#[derive(Clone, Debug)]
pub(super) struct Sheet {
    pub(super) size: Dot,
    pub(super) heading: Vec<String>,
    pub(super) x: Ruler,
    pub(super) y: Ruler,
    pub(super) layers: Option<Layers>,
    pub(super) areas: Vec<(Vec<Dot>, RGBColor)>,
    pub(super) curves: Vec<Shown>,
    pub(super) guides: Vec<Ruled>,
    pub(super) key: Key,
    pub(super) notes: Vec<String>,
    pub(super) heat: Option<Heat>,
}

/// Company of a panel on its figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Company {
    Alone,
    Together,
}

impl Sheet {
    /// The panel in a frame of `size` px.
    pub(super) fn new(panel: &Panel, size: Dot, company: Company) -> Self {
        let size = panel.ratio.map_or(size, |ratio| within(size, ratio));
        let (x, y) = rulers(panel, size);
        let map = Map { x: &x, y: &y, size };
        let layers = panel.contours.as_ref().and_then(|contours| layers(contours, &map));
        let curves = curves(panel, &map);
        let guides = guides(panel, &map, &curves);
        let key = key(panel, &guides, company, size.0 + INDENT);
        Self {
            size,
            heading: text::wrap(&text::clean(&panel.title), HEADING * text::BOLD, size.0),
            layers,
            areas: panel.areas.iter().map(|area| filled(area, &map)).collect(),
            curves,
            guides,
            key,
            notes: notes(panel, size.0 + INDENT),
            heat: panel.cells.as_ref().map(|cells| Heat::new(cells, (&panel.x, &panel.y), &map)),
            x,
            y,
        }
    }

    /// Px right of the frame.
    pub(super) fn right(&self) -> f64 {
        let legend = match &self.key {
            Key::Beside(legend) if !legend.entries.is_empty() => 18.0 + legend.size.0,
            _ => 0.0,
        };
        let bar = self.layers.as_ref().map_or(0.0, |layers| layers.bar.right());
        let scale = self.heat.as_ref().map_or(0.0, |heat| AWAY + WIDE + 8.0 + heat.ruler.widest() + 22.0);
        legend.max(bar).max(scale).max(self.x.overhang(self.size.0) + 4.0).max(14.0)
    }

    /// Px left of the frame.
    pub(super) fn left(&self) -> f64 {
        (self.y.widest() + 36.0).max(INDENT + 14.0)
    }

    /// Px above the frame.
    pub(super) fn above(&self) -> f64 {
        10.0 + 17.0 * count(&self.heading)
    }

    /// Px below the frame.
    pub(super) fn below(&self) -> f64 {
        self.notes_at() + 14.0 * count(&self.notes)
    }

    /// Px from the bottom of the frame to its remarks.
    pub(super) fn notes_at(&self) -> f64 {
        let legend = match &self.key {
            Key::Below(legend) if !legend.entries.is_empty() => legend.size.1 + 4.0,
            _ => 0.0,
        };
        LEGEND_AT + legend
    }
}

/// Narrowest frame as a part of the room there is.
const NARROWEST: f64 = 0.25;

/// The largest frame of a given width over its height within `size` px, and not too narrow to be read.
fn within((width, height): Dot, ratio: f64) -> Dot {
    let frame = if ratio < width / height { (height * ratio, height) } else { (width, width / ratio) };
    (frame.0.max(NARROWEST * width), frame.1.max(NARROWEST * height))
}

/// Px from the bottom of the frame to a legend below it.
pub(super) const LEGEND_AT: f64 = 44.0;

fn count(lines: &[String]) -> f64 {
    f64::from(u32::try_from(lines.len()).unwrap_or(0))
}

fn curves(panel: &Panel, map: &Map) -> Vec<Shown> {
    let shown = |(i, series)| Shown { curve: curve(series, map), look: look(panel, i), arrow: series.style.arrow };
    let mut all: Vec<Shown> = panel.series.iter().enumerate().map(shown).collect();
    // the first look is the widest and unbroken: drawn late it would hide a broken one
    all.sort_by_key(|shown| shown.look.number);
    all
}

fn guides(panel: &Panel, map: &Map, curves: &[Shown]) -> Vec<Ruled> {
    if panel.guides.is_empty() {
        return Vec::new();
    }
    let mut clearance = Clearance::new(map.size);
    for shown in curves {
        shown.curve.pieces.iter().for_each(|p| clearance.take_path(p));
        let dots = shown.curve.lonely.iter().chain(&shown.curve.marked);
        dots.for_each(|dot| clearance.take(*dot));
    }
    let ruled = panel.guides.iter().map(|guide| rule(guide, map, &mut clearance));
    ruled.collect()
}

fn key(panel: &Panel, guides: &[Ruled], company: Company, room: f64) -> Key {
    let homeless = guides.iter().filter_map(|g| g.homeless.clone());
    let entries = legend::entries(panel, homeless);
    if company == Company::Alone && entries.len() >= MANY {
        Key::Beside(legend::beside(entries))
    } else {
        Key::Below(legend::below(entries, room))
    }
}

fn notes(panel: &Panel, room: f64) -> Vec<String> {
    let notes = panel.notes.iter().map(|n| text::clean(n));
    notes.flat_map(|n| text::wrap(&n, NOTE, room)).collect()
}
