//! Panels in rows and columns under a title.

use super::canvas::{Canvas, Dot, Type, Weight, document};
use super::panel::{Company, Sheet};
use super::{Figure, Panel, paint, text};
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

/// The figure as SVG.
pub(super) fn draw(figure: &Figure) -> String {
    let (columns, size) = grid(figure.panels.len());
    let company = if figure.panels.len() == 1 { Company::Alone } else { Company::Together };
    let sheet = |panel: &Panel| Sheet::new(panel, size, company);
    let sheets: Vec<Sheet> = figure.panels.iter().map(sheet).collect();
    let plan = PixelPlan::new(&figure.title, &sheets, columns);
    document(plan.size, &figure.title, |canvas| {
        canvas.rectangle((0.0, 0.0), plan.size, WHITE);
        title(canvas, &plan);
        for (sheet, at) in sheets.iter().zip(plan.places()) {
            canvas.origin = at;
            paint::sheet(canvas, sheet);
        }
    })
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
    /// Left end and frame of every column.
    columns: Vec<f64>,
    /// Top of the frames of every row.
    rows: Vec<f64>,
    panels: usize,
    size: Dot,
}

impl PixelPlan {
    fn new(title: &str, sheets: &[Sheet], columns: usize) -> Self {
        let (lefts, width) = stack(&column_sizes(sheets, columns), RIM);
        let width = if sheets.is_empty() { BARE } else { width };
        let title = text::wrap(&text::clean(title), TITLE * text::BOLD, width - 4.0 * RIM);
        let lines = f64::from(u32::try_from(title.len()).unwrap_or(0));
        let (tops, height) =
            stack(&row_sizes(sheets, columns), RIM + TITLE_LINE * lines + if lines > 0.0 { 4.0 } else { 0.0 });
        Self { title, columns: lefts, rows: tops, panels: sheets.len(), size: (width, height) }
    }

    /// Upper left corners of the frames.
    fn places(&self) -> impl Iterator<Item = Dot> {
        let rows = self.rows.iter();
        let all = rows.flat_map(|y| self.columns.iter().map(move |x| (*x, *y)));
        all.take(self.panels)
    }
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

fn row_sizes(sheets: &[Sheet], columns: usize) -> Vec<Share> {
    let row = |row: &[Sheet]| {
        let heights = row.iter().map(|s| (s.above(), s.size.1, s.below()));
        heights.fold((0.0, 0.0, 0.0), larger)
    };
    sheets.chunks(columns).map(row).collect()
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
