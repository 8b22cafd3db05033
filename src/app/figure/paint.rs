//! A panel on the canvas.

use plotters::style::text_anchor::HPos;
use plotters::style::{BLACK, RGBColor};

use super::canvas::{Canvas, Dot, Pen, Type, Weight};
use super::contour::{self, BAR, BAR_AT, Bar, Layers};
use super::dash::{dashes, head, length};
use super::guide::{self, Ruled};
use super::heat::{AWAY, Heat, STEPS, WIDE, colour};
use super::legend::{self, Legend, Placed, SAMPLE, Sample, text_at};
use super::look::{Line, Look, pattern};
use super::mark::mark;
use super::panel::{HEADING, INDENT, Key, LEGEND_AT, NOTE, Sheet, Shown};
use super::range::AxisRange;
use super::{Arrow, Scale, text, ticks};

const GRID: Pen = Pen { colour: RGBColor(228, 228, 228), width: 0.7 };
const ZERO: Pen = Pen { colour: RGBColor(150, 150, 150), width: 0.9 };
const FRAME: Pen = Pen { colour: RGBColor(60, 60, 60), width: 1.0 };
/// Where a quantity of two signs vanishes.
const NOUGHT: Pen = Pen { colour: BLACK, width: 1.8 };
/// About an area of one colour.
const OUTLINE: Pen = Pen { colour: RGBColor(70, 70, 70), width: 0.5 };
const GUIDE: Pen = Pen { colour: RGBColor(105, 105, 105), width: 1.1 };
/// Ink and gap of a guide in px.
const GUIDE_DASHES: [f64; 2] = [3.0, 2.0];
/// Px by which cells of colour overlap.
const SEAM: f64 = 0.4;
/// Font size of axis labels in px.
const CAPTION: f64 = 12.0;

/// Draws a panel with the upper left corner of its frame at the origin.
pub(super) fn sheet(canvas: &mut Canvas, sheet: &Sheet) {
    match (&sheet.layers, &sheet.heat) {
        (Some(layers), _) => contours(canvas, layers, sheet.size),
        (None, Some(heat)) => cells(canvas, heat, sheet.size),
        (None, None) => {
            sheet.areas.iter().for_each(|(outline, colour)| canvas.polygon(outline, *colour));
            grid(canvas, sheet);
            zero_lines(canvas, sheet);
        }
    }
    sheet.guides.iter().for_each(|g| ruled(canvas, g));
    frame(canvas, sheet.size);
    for shown in &sheet.curves {
        lines(canvas, shown);
        arrow(canvas, shown, 0.65);
    }
    sheet.curves.iter().for_each(|s| marks(canvas, s));
    axes(canvas, sheet);
    match &sheet.key {
        Key::Below(legend) => key(canvas, legend, (-INDENT, sheet.size.1 + LEGEND_AT)),
        Key::Beside(legend) => key(canvas, legend, (sheet.size.0 + 18.0, 0.0)),
    }
    heading(canvas, sheet);
    captions(canvas, sheet);
    notes(canvas, sheet);
}

/// Areas of one colour with a fine line about each, and their bar beside the frame.
fn contours(canvas: &mut Canvas, layers: &Layers, size: Dot) {
    canvas.rectangle((0.0, 0.0), size, layers.ground);
    for (outline, colour) in &layers.areas {
        canvas.polygon(outline, *colour);
        canvas.path(outline, OUTLINE);
    }
    layers.zero.iter().for_each(|line| canvas.path(line, NOUGHT));
    bar(canvas, &layers.bar, size);
}

fn bar(canvas: &mut Canvas, bar: &Bar, (w, h): Dot) {
    let (left, right) = (w + BAR_AT, w + BAR_AT + BAR);
    let mut low = h;
    for (end, colour) in &bar.bands {
        let high = h - end * h;
        canvas.rectangle((left, high), (right, low), *colour);
        low = high;
    }
    let corners = [(left, 0.0), (right, 0.0), (right, h), (left, h), (left, 0.0), (right, 0.0)];
    canvas.path(&corners, FRAME);
    for tick in bar.ruler.ticks.iter().filter(|tick| !tick.label.is_empty()) {
        let y = h - tick.at * h;
        canvas.path(&[(left, y), (right + 3.5, y)], OUTLINE);
        written(canvas, (right + 7.0, y + 1.0), &tick.label, regular(ticks::SIZE, BLACK, HPos::Left));
    }
    let (label, size) = contour::caption(bar, h);
    if !label.is_empty() {
        let at = (right + 9.0 + bar.ruler.widest() + 13.0, 0.5 * h);
        canvas.upward_text(at, &label, regular(size, BLACK, HPos::Center));
    }
}

/// Cells, and the scale of their colours right of the frame.
fn cells(canvas: &mut Canvas, heat: &Heat, (w, h): Dot) {
    for cell in &heat.cells {
        // Neighbours overlap by a hair, so that no seam shows; the later one covers it.
        let (from, to) = ((cell.from.0, cell.from.1 - SEAM), (cell.to.0 + SEAM, cell.to.1));
        canvas.rectangle((from.0, from.1.max(0.0)), (to.0.min(w), to.1), cell.colour);
    }
    let (left, right) = (w + AWAY, w + AWAY + WIDE);
    for step in 0..STEPS {
        let at = |step: u32| f64::from(step) / f64::from(STEPS);
        let (top, bottom) = (h - h * at(step + 1), h - h * at(step));
        canvas.rectangle((left, (top - SEAM).max(0.0)), (right, bottom), colour(at(step) + 0.5 / f64::from(STEPS)));
    }
    for tick in heat.ruler.ticks.iter().filter(|tick| !tick.label.is_empty()) {
        let y = h - tick.at * h;
        canvas.path(&[(right, y), (right + 4.0, y)], FRAME);
        canvas.text((right + 7.0, y + 1.0), &tick.label, regular(ticks::SIZE, BLACK, HPos::Left));
    }
    let (label, size) = text::fit(&heat.ruler.caption, CAPTION, h);
    if !label.is_empty() {
        let at = (right + 7.0 + heat.ruler.widest() + 12.0, 0.5 * h);
        canvas.upward_text(at, &label, regular(size, BLACK, HPos::Center));
    }
}

fn grid(canvas: &mut Canvas, sheet: &Sheet) {
    let (w, h) = sheet.size;
    for tick in sheet.x.ticks.iter().filter(|t| !t.label.is_empty()) {
        canvas.path(&[(tick.at * w, 0.0), (tick.at * w, h)], GRID);
    }
    for tick in sheet.y.ticks.iter().filter(|t| !t.label.is_empty()) {
        let y = h - tick.at * h;
        canvas.path(&[(0.0, y), (w, y)], GRID);
    }
}

fn zero_lines(canvas: &mut Canvas, sheet: &Sheet) {
    let (w, h) = sheet.size;
    if let Some(x) = zero(&sheet.x.range) {
        canvas.path(&[(x * w, 0.0), (x * w, h)], ZERO);
    }
    if let Some(y) = zero(&sheet.y.range) {
        canvas.path(&[(0.0, h - y * h), (w, h - y * h)], ZERO);
    }
}

/// Fraction of zero inside a linear axis.
fn zero(range: &AxisRange) -> Option<f64> {
    let at = range.place(0.0).filter(|_| range.scale == Scale::Linear);
    at.filter(|at| (0.002..=0.998).contains(at))
}

fn frame(canvas: &mut Canvas, (w, h): Dot) {
    let corners = [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h), (0.0, 0.0), (w, 0.0)];
    canvas.path(&corners, FRAME);
}

fn ruled(canvas: &mut Canvas, guide: &Ruled) {
    for piece in dashes(&guide.line, &GUIDE_DASHES) {
        if piece.len() > 1 {
            canvas.path(&piece, GUIDE);
        }
    }
    if let Some(corners) = head(&guide.line, length(&guide.line)).filter(|_| guide.jump) {
        canvas.polygon(&corners, GUIDE.colour);
    }
    if let Some((at, name)) = &guide.name {
        canvas.text(*at, name, regular(guide::SIZE, RGBColor(70, 70, 70), HPos::Left));
    }
}

fn regular(size: f64, colour: RGBColor, anchor: HPos) -> Type {
    Type { size, colour, weight: Weight::Regular, anchor }
}

fn lines(canvas: &mut Canvas, shown: &Shown) {
    let look = shown.look;
    if look.line != Line::Absent {
        for piece in &shown.curve.pieces {
            stroke(canvas, piece, look);
        }
        let dots = shown.curve.lonely.iter();
        dots.for_each(|dot| canvas.disc(*dot, look.width + 1.0, look.colour));
    }
}

fn stroke(canvas: &mut Canvas, path: &[Dot], look: Look) {
    let pen = Pen { colour: look.colour, width: look.width };
    for dash in dashes(path, pattern(look.line)) {
        if dash.len() > 1 {
            canvas.path(&dash, pen);
        }
    }
}

/// Arrow head on the longest piece, at a fraction of its length.
fn arrow(canvas: &mut Canvas, shown: &Shown, at: f64) {
    let by_length = |a: &&Vec<Dot>, b: &&Vec<Dot>| length(a).total_cmp(&length(b));
    let longest = shown.curve.pieces.iter().max_by(by_length);
    let piece = longest.filter(|p| shown.arrow == Arrow::Forward && length(p) > 30.0);
    if let Some(corners) = piece.and_then(|p| head(p, at * length(p))) {
        canvas.polygon(&corners, shown.look.colour);
    }
}

fn marks(canvas: &mut Canvas, shown: &Shown) {
    if let Some(shape) = shown.look.mark {
        let dots = shown.curve.marked.iter();
        dots.for_each(|dot| mark(canvas, *dot, shape, shown.look.colour));
    }
}

fn axes(canvas: &mut Canvas, sheet: &Sheet) {
    let (w, h) = sheet.size;
    for tick in &sheet.x.ticks {
        let x = tick.at * w;
        let long = if tick.label.is_empty() { 2.5 } else { 4.5 };
        canvas.path(&[(x, h), (x, h + long)], FRAME);
        let kind = regular(ticks::SIZE, BLACK, HPos::Center);
        written(canvas, (x, h + 12.5), &tick.label, kind);
    }
    for tick in &sheet.y.ticks {
        let y = h - tick.at * h;
        let long = if tick.label.is_empty() { 2.5 } else { 4.5 };
        canvas.path(&[(0.0, y), (-long, y)], FRAME);
        let kind = regular(ticks::SIZE, BLACK, HPos::Right);
        written(canvas, (-8.0, y + 1.0), &tick.label, kind);
    }
}

fn written(canvas: &mut Canvas, at: Dot, text: &str, kind: Type) {
    if !text.is_empty() {
        canvas.text(at, text, kind);
    }
}

fn key(canvas: &mut Canvas, legend: &Legend, at: Dot) {
    let home = canvas.origin;
    canvas.origin = (home.0 + at.0, home.1 + at.1);
    for entry in &legend.entries {
        sample(canvas, entry);
        for (number, line) in (0..).zip(&entry.lines) {
            canvas.text(text_at(entry, number), line, regular(legend::SIZE, BLACK, HPos::Left));
        }
    }
    canvas.origin = home;
}

fn sample(canvas: &mut Canvas, entry: &Placed) {
    let (x, y) = entry.at;
    let path = [(x, y), (x + SAMPLE, y)];
    match entry.sample {
        Sample::Guide => dashes(&path, &GUIDE_DASHES).iter().for_each(|p| canvas.path(p, GUIDE)),
        Sample::Series(look) => {
            if look.line != Line::Absent {
                stroke(canvas, &path, look);
            }
            if let Some(shape) = look.mark {
                mark(canvas, (x + 0.5 * SAMPLE, y), shape, look.colour);
            }
        }
    }
}

fn heading(canvas: &mut Canvas, sheet: &Sheet) {
    let kind = Type { weight: Weight::Bold, ..regular(HEADING, BLACK, HPos::Center) };
    let mut y = 10.0 - sheet.above();
    for line in &sheet.heading {
        canvas.text((0.5 * sheet.size.0, y), line, kind);
        y += 17.0;
    }
}

fn captions(canvas: &mut Canvas, sheet: &Sheet) {
    let (w, h) = sheet.size;
    let (label, size) = text::fit(&sheet.x.caption, CAPTION, w + INDENT);
    written(canvas, (0.5 * w, h + 30.0), &label, regular(size, BLACK, HPos::Center));
    let (label, size) = text::fit(&sheet.y.caption, CAPTION, h);
    if !label.is_empty() {
        let at = (-sheet.y.widest() - 22.0, 0.5 * h);
        canvas.upward_text(at, &label, regular(size, BLACK, HPos::Center));
    }
}

fn notes(canvas: &mut Canvas, sheet: &Sheet) {
    let mut y = sheet.size.1 + sheet.notes_at() + 6.0;
    for line in &sheet.notes {
        canvas.text((-INDENT, y), line, regular(NOTE, RGBColor(80, 80, 80), HPos::Left));
        y += 14.0;
    }
}
