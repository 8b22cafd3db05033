//! Panels in rows and columns: under a title on a screen, with letters on paper.

use super::canvas::{Canvas, Dot, Extent, Type, Weight, document};
use super::panel::{Company, Sheet};
use super::{Figure, Panel, paint, text};
use crate::app::medium::Medium;
use plotters::style::text_anchor::HPos;
use plotters::style::{BLACK, WHITE};

/// Font size of the title in px.
const TITLE: f64 = 15.0;
/// Height of a line of the title in px.
const TITLE_LINE: f64 = 20.0;
/// Blank rim of the figure in px.
const RIM: f64 = 8.0;
/// Blank between panels in px.
const BETWEEN: f64 = 10.0;
/// Width of a figure without panels in px.
const BARE: f64 = 400.0;
/// Px in a millimetre of paper: letters of 10 to 12 px are then printed with 6.5 to 7.8 pt, lines of 0.7 to 2.2 px
/// with 0.5 to 1.4 pt.
const PX_PER_MM: f64 = 72.0 / 25.4 / 0.65;

/// The figure as SVG.
pub(super) fn draw(figure: &Figure, medium: Medium) -> String {
    let arranged = match medium.millimetres() {
        None => on_screen(figure),
        Some(millimetres) => on_paper(figure, millimetres * PX_PER_MM),
    };
    let Arranged { sheets, plan } = arranged;
    let extent = Extent { size: plan.size, millimetres: medium.millimetres() };
    document(extent, &figure.title, |canvas| {
        canvas.rectangle((0.0, 0.0), plan.size, WHITE);
        title(canvas, &plan);
        for (sheet, at) in sheets.iter().zip(&plan.places) {
            canvas.origin = *at;
            paint::sheet(canvas, sheet);
        }
    })
}

/// Panels made ready, and their places.
struct Arranged {
    sheets: Vec<Sheet>,
    plan: PixelPlan,
}

fn on_screen(figure: &Figure) -> Arranged {
    let (columns, size) = grid(figure.panels.len());
    let company = if figure.panels.len() == 1 { Company::Alone } else { Company::Together };
    let mut sheets: Vec<Sheet> = figure.panels.iter().map(|panel| Sheet::new(panel, size, company)).collect();
    let rows = balanced(sheets.len(), columns);
    let width = widest(&sheets, &rows).1;
    let (mut short, mut panels) = (&mut sheets[..], &figure.panels[..]);
    for row in &rows {
        let (own, others) = short.split_at_mut(*row);
        let (drawn, left) = panels.split_at(*row);
        if *row < columns {
            widen(own, drawn, width);
        }
        (short, panels) = (others, left);
    }
    let plan = PixelPlan::new(&figure.title, &sheets, &rows);
    Arranged { sheets, plan }
}

/// Panels in each row: rows differ by one panel at most, the fuller ones first.
fn balanced(panels: usize, columns: usize) -> Vec<usize> {
    let rows = panels.div_ceil(columns);
    (0..rows).map(|row| panels / rows + usize::from(row < panels % rows)).collect()
}

/// Widens the frames of a row to `width` px, those that do not have a shape of their own: nothing beside them is left
/// empty.
fn widen(sheets: &mut [Sheet], panels: &[Panel], width: f64) {
    let free = |panel: &Panel| panel.ratio.is_none() && panel.contours.is_none();
    let count = count(panels.iter().filter(|panel| free(panel)).count());
    for _ in 0..WIDENED {
        let lacking = width - stack(&shares(sheets), RIM).1;
        if count < 1.0 || lacking.abs() < 1.0 {
            return;
        }
        for (sheet, panel) in sheets.iter_mut().zip(panels).filter(|(_, panel)| free(panel)) {
            let size = (sheet.size.0 + lacking / count, sheet.size.1);
            *sheet = Sheet::new(panel, size, Company::Together);
        }
    }
}

/// Turns in which frames are widened: labels of a wider one may be wider.
const WIDENED: usize = 3;

/// Panels over a width given in px; the caption of a figure in print is elsewhere.
fn on_paper(figure: &Figure, width: f64) -> Arranged {
    let columns = if width > TWO_COLUMNS { figure.panels.len().clamp(1, 2) } else { 1 };
    let panels: Vec<Panel> = lettered(&figure.panels);
    let sheets = fitted(&panels, width, columns);
    let rows: Vec<usize> = sheets.chunks(columns).map(<[Sheet]>::len).collect();
    let mut plan = PixelPlan::new("", &sheets, &rows);
    let blank = 0.5 * (width - plan.size.0).max(0.0);
    plan.places.iter_mut().for_each(|place| place.0 += blank);
    plan.size.0 = width;
    Arranged { sheets, plan }
}

/// Px from which two panels stand side by side on paper.
const TWO_COLUMNS: f64 = 500.0;

/// The panels with (a), (b), … before their headings, if there are several.
fn lettered(panels: &[Panel]) -> Vec<Panel> {
    if panels.len() < 2 || panels.len() > 52 {
        return panels.to_owned();
    }
    let lettered = |(letter, panel): (char, &Panel)| {
        let title = format!("({letter}) {}", panel.title).trim_end().to_owned();
        Panel { title, ..panel.clone() }
    };
    ('a'..='z').chain('A'..='Z').zip(panels).map(lettered).collect()
}

/// Panels whose frames are as wide as the room beside their labels allows, which itself follows from their width.
fn fitted(panels: &[Panel], width: f64, columns: usize) -> Vec<Sheet> {
    let share = width / count(columns);
    // Four panels below each other are still no higher than a page.
    let height = match (columns, panels.len()) {
        (1, _) if width > TWO_COLUMNS => 0.5,
        (1, 3..) => 0.6,
        _ => 0.75,
    };
    let sheets = |frame: f64| -> Vec<Sheet> {
        let size = (frame, height * frame);
        panels.iter().map(|panel| Sheet::new(panel, size, Company::Together)).collect()
    };
    let mut frame = share - 90.0;
    let mut found = sheets(frame);
    for turn in 0..TURNS {
        let excess = stack(&column_sizes(&found, columns), RIM).1 - width;
        if (-1.0..=0.0).contains(&excess) || excess < 0.0 && turn > TURNS / 2 {
            break;
        }
        frame = (frame - excess.ceil() / count(columns)).clamp(NARROWEST, share);
        found = sheets(frame);
    }
    found
}

/// Turns in which the width of frames is found; in the second half it only shrinks.
const TURNS: usize = 16;
/// Narrowest frame on paper in px.
const NARROWEST: f64 = 60.0;

#[expect(clippy::cast_precision_loss, reason = "a few")]
fn count(columns: usize) -> f64 {
    columns as f64
}

/// Number of columns and size of a frame in px.
fn grid(panels: usize) -> (usize, Dot) {
    match panels {
        0 | 1 => (1, (460.0, 330.0)),
        2 | 4 => (2, (330.0, 245.0)),
        _ => (3, (285.0, 220.0)),
    }
}

/// Px of everything.
struct PixelPlan {
    title: Vec<String>,
    /// Upper left corners of the frames.
    places: Vec<Dot>,
    size: Dot,
}

impl PixelPlan {
    fn new(title: &str, sheets: &[Sheet], rows: &[usize]) -> Self {
        let (columns, width) = widest(sheets, rows);
        let width = if sheets.is_empty() { BARE } else { width };
        let title = text::wrap(&text::clean(title), TITLE * text::BOLD, width - 4.0 * RIM);
        let lines = f64::from(u32::try_from(title.len()).unwrap_or(0));
        let split = split(sheets, rows);
        let (tops, height) = stack(&row_sizes(&split), RIM + TITLE_LINE * lines + if lines > 0.0 { 4.0 } else { 0.0 });
        let places = split.iter().zip(tops).flat_map(|(row, top)| {
            let lefts = if row.len() == columns.len() { columns.clone() } else { centred(row, width) };
            lefts.into_iter().map(move |left| (left, top)).collect::<Vec<Dot>>()
        });
        let places = places.take(sheets.len()).collect();
        Self { title, places, size: (width, height) }
    }
}

/// The sheets of each row.
fn split<'s>(mut sheets: &'s [Sheet], rows: &[usize]) -> Vec<&'s [Sheet]> {
    let row = |count: &usize| {
        let (row, left) = sheets.split_at(*count);
        sheets = left;
        row
    };
    rows.iter().map(row).collect()
}

/// Left ends of the frames of the fullest rows, and the right end of the widest row.
fn widest(sheets: &[Sheet], rows: &[usize]) -> (Vec<f64>, f64) {
    let split = split(sheets, rows);
    let most = rows.iter().copied().max().unwrap_or(0);
    let full: Vec<Sheet> = split.iter().filter(|row| row.len() == most).flat_map(|row| row.iter().cloned()).collect();
    let (lefts, width) = stack(&column_sizes(&full, most.max(1)), RIM);
    let others = split.iter().filter(|row| row.len() < most).map(|row| stack(&shares(row), RIM).1);
    (lefts, others.fold(width, f64::max))
}

/// Left ends of the frames of a row in the middle of `width` px.
fn centred(row: &[Sheet], width: f64) -> Vec<f64> {
    let blank = 0.5 * (width - stack(&shares(row), RIM).1).max(0.0);
    stack(&shares(row), RIM).0.into_iter().map(|left| (left + blank).round()).collect()
}

fn shares(row: &[Sheet]) -> Vec<Share> {
    row.iter().map(|sheet| (sheet.left(), sheet.size.0, sheet.right())).collect()
}

/// Room before a frame, the frame, room after it.
type Share = (f64, f64, f64);

fn column_sizes(sheets: &[Sheet], columns: usize) -> Vec<Share> {
    let column = |c: usize| sheets.iter().skip(c).step_by(columns);
    let shares = (0..columns.min(sheets.len())).map(|c| {
        let widths = column(c).map(|s| (s.left(), s.size.0, s.right()));
        widths.fold((0.0, 0.0, 0.0), larger)
    });
    shares.collect()
}

fn row_sizes(rows: &[&[Sheet]]) -> Vec<Share> {
    let row = |row: &&[Sheet]| {
        let heights = row.iter().map(|s| (s.above(), s.size.1, s.below()));
        heights.fold((0.0, 0.0, 0.0), larger)
    };
    rows.iter().map(row).collect()
}

fn larger(a: Share, b: Share) -> Share {
    (a.0.max(b.0), a.1.max(b.1), a.2.max(b.2))
}

/// Starts of the frames and the end of everything, from `start` on.
fn stack(shares: &[Share], start: f64) -> (Vec<f64>, f64) {
    let mut end = start;
    let mut starts = Vec::new();
    for (before, frame, after) in shares {
        let gap = if starts.is_empty() { 0.0 } else { BETWEEN };
        starts.push((end + gap + before).round());
        end += gap + before + frame + after;
    }
    (starts, (end + RIM).ceil())
}

fn title(canvas: &mut Canvas, plan: &PixelPlan) {
    let kind = Type { size: TITLE, colour: BLACK, weight: Weight::Bold, anchor: HPos::Center };
    let mut y = RIM + 0.55 * TITLE_LINE;
    for line in &plan.title {
        canvas.text((0.5 * plan.size.0, y), line, kind);
        y += TITLE_LINE;
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Axis, Series};
    use super::*;

    #[test]
    fn rows_differ_by_one_panel() {
        assert_eq!(balanced(7, 3), [3, 2, 2]);
        assert_eq!(balanced(5, 3), [3, 2]);
        assert_eq!(balanced(4, 2), [2, 2]);
        assert!(balanced(0, 1).is_empty());
    }

    #[test]
    fn a_short_row_is_as_wide_as_the_others() {
        let panel =
            Panel::new(Axis::linear("x", "m"), Axis::linear("y", "N")).with(Series::new("", [(0.0, 0.0), (1.0, 1.0)]));
        let figure = (0..5).fold(Figure::new("five"), |figure, _| figure.with(panel.clone()));
        let Arranged { sheets, plan } = on_screen(&figure);
        let right = |k: usize| plan.places[k].0 + sheets[k].size.0;
        assert!((right(2) - right(4)).abs() < 4.0 && sheets[4].size.0 > 1.3 * sheets[0].size.0, "{:?}", plan.places);
        assert!(plan.places[3].1 > plan.places[0].1 && (plan.places[3].0 - plan.places[0].0).abs() < 1.0);
    }
}
