//! Legends outside the frame.

use super::canvas::Dot;
use super::look::{Look, look};
use super::{Panel, text};

/// Font size in px.
pub(super) const SIZE: f64 = 11.0;
/// Height of a line in px.
pub(super) const LINE: f64 = 15.0;
/// Width of the sample of a line in px.
pub(super) const SAMPLE: f64 = 30.0;
const BEFORE_TEXT: f64 = 6.0;
const BETWEEN: f64 = 16.0;
/// Widest label of a legend beside the frame in px.
const WIDEST: f64 = 190.0;

/// What stands before a label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sample {
    Series(Look),
    Guide,
}

/// A sample with its label.
#[derive(Clone, Debug)]
pub(super) struct LegendEntry {
    pub(super) label: String,
    pub(super) sample: Sample,
}

/// An entry in its place.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    /// Left middle of the first line.
    pub(super) at: Dot,
    pub(super) sample: Sample,
    pub(super) lines: Vec<String>,
}

/// Entries in their places, and the px they take.
#[derive(Clone, Debug, Default)]
pub(super) struct Legend {
    pub(super) entries: Vec<Placed>,
    pub(super) size: Dot,
}

/// One entry for every label of the series, then the guides whose names found no place.
pub(super) fn entries(panel: &Panel, homeless: impl Iterator<Item = String>) -> Vec<LegendEntry> {
    let mut entries: Vec<LegendEntry> = Vec::new();
    for (i, series) in panel.series.iter().enumerate() {
        let label = text::clean(&series.label);
        if !label.trim().is_empty() && entries.iter().all(|e| e.label != label) {
            let sample = Sample::Series(look(panel, i));
            entries.push(LegendEntry { label, sample });
        }
    }
    let guide = |label| LegendEntry { label, sample: Sample::Guide };
    entries.extend(homeless.map(guide));
    entries
}

/// Legend below the frame, `room` px wide.
pub(super) fn below(entries: Vec<LegendEntry>, room: f64) -> Legend {
    let widths: Vec<f64> = entries.iter().map(|e| wide(e, room)).collect();
    let widest = widths.iter().copied().fold(0.0, f64::max);
    let one_row = widths.iter().sum::<f64>() <= room + BETWEEN;
    let mut legend = Legend::default();
    let mut at = (0.0, 0.5 * LINE);
    let mut tallest = 0.0;
    for (entry, own) in entries.into_iter().zip(widths) {
        let step = if one_row { own } else { widest };
        if at.0 > 0.0 && at.0 + step > room + BETWEEN {
            at = (0.0, at.1 + tallest);
            tallest = 0.0;
        }
        let height = legend.push(entry, at, room);
        tallest = f64::max(tallest, height);
        legend.size = (room, at.1 - 0.5 * LINE + tallest);
        at.0 += step;
    }
    legend
}

/// Legend beside the frame.
pub(super) fn beside(entries: Vec<LegendEntry>) -> Legend {
    let widths = entries.iter().map(|e| wide(e, WIDEST));
    let widest = widths.fold(0.0, f64::max);
    let mut legend = Legend::default();
    let mut y = 0.5 * LINE;
    for entry in entries {
        y += legend.push(entry, (0.0, y), WIDEST) + 3.0;
        legend.size = (widest, y - 0.5 * LINE);
    }
    legend
}

/// Px an entry takes in a row, with the gap to the next.
fn wide(entry: &LegendEntry, room: f64) -> f64 {
    let head = SAMPLE + BEFORE_TEXT;
    (head + text::width(&entry.label, SIZE)).min(room) + BETWEEN
}

impl Legend {
    /// Adds an entry wrapped to `room` px; its height.
    fn push(&mut self, entry: LegendEntry, at: Dot, room: f64) -> f64 {
        let lines = text::wrap(&entry.label, SIZE, room - SAMPLE - BEFORE_TEXT);
        let height = LINE * f64::from(u32::try_from(lines.len()).unwrap_or(1));
        let sample = entry.sample;
        self.entries.push(Placed { at, sample, lines });
        height
    }
}

/// Left middle of line `number` of the text of an entry.
pub(super) fn text_at(entry: &Placed, number: u32) -> Dot {
    let (x, y) = entry.at;
    (x + SAMPLE + BEFORE_TEXT, y + LINE * f64::from(number))
}
