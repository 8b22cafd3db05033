//! The one place that talks to the drawing library.
//!
//! The library rounds coordinates to whole numbers, so everything is drawn ten times larger and
//! shown ten times smaller: px outside, tenths of a px inside.

use plotters::prelude::{DrawingBackend, IntoFont, RGBColor, SVGBackend, ShapeStyle, TextStyle};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontStyle, FontTransform};

use super::merge::merged;
use super::text;

/// A place in px, y downwards.
pub(super) type Dot = (f64, f64);

/// Units of the drawing library per px.
const FINE: f64 = 10.0;
/// The library takes the font size as line height; this ratio is its own.
const LINE_HEIGHT: f64 = 1.24;

/// Ink of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pen {
    pub(super) colour: RGBColor,
    /// Width in px.
    pub(super) width: f64,
}

/// How a text stands.
#[derive(Clone, Copy)]
pub(super) struct Type {
    /// Font size in px.
    pub(super) size: f64,
    pub(super) colour: RGBColor,
    pub(super) weight: Weight,
    /// Side of the text that is at the place given.
    pub(super) anchor: HPos,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Weight {
    Regular,
    Bold,
}

/// A sheet to draw on.
pub(super) struct Canvas<'a> {
    sheet: SVGBackend<'a>,
    /// Place on the sheet of what is called (0, 0).
    pub(super) origin: Dot,
}

/// A sheet of paper or of a screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    /// Width and height in px.
    pub(super) size: Dot,
    /// Width in mm, if it has one.
    pub(super) millimetres: Option<f64>,
}

impl Extent {
    /// Width and height as SVG has them.
    fn written(self) -> (String, String) {
        let (w, h) = self.size;
        match self.millimetres {
            Some(wide) => (format!("{wide}mm"), format!("{:.2}mm", wide * h / w)),
            None => (whole(w).to_string(), whole(h).to_string()),
        }
    }
}

/// SVG document with a title for those who cannot see it.
pub(super) fn document(sheet: Extent, title: &str, draw: impl FnOnce(&mut Canvas)) -> String {
    let mut svg = String::with_capacity(1 << 15);
    let extent = (whole(sheet.size.0 * FINE).unsigned_abs(), whole(sheet.size.1 * FINE).unsigned_abs());
    let mut canvas = Canvas { sheet: SVGBackend::with_string(&mut svg, extent), origin: (0.0, 0.0) };
    draw(&mut canvas);
    drop(canvas);
    dress(&svg, sheet, title)
}

/// Document with the size shown, what all elements share said once, and a title.
fn dress(svg: &str, sheet: Extent, title: &str) -> String {
    let body = svg.split_once('\n').map_or("", |(_, body)| body);
    let body = body
        .replace(" opacity=\"1\"", "")
        .replace(" fill=\"none\"", "")
        .replace(" font-family=\"sans-serif\"", "")
        .replace(" \"/>", "\"/>");
    let body = merged(&lowered(&body));
    let (w, h) = sheet.written();
    let (fine_w, fine_h) = (whole(sheet.size.0 * FINE), whole(sheet.size.1 * FINE));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{w}\" height=\"{h}\" \
         viewBox=\"0 0 {fine_w} {fine_h}\" fill=\"none\" stroke-linejoin=\"round\" \
         font-family=\"sans-serif\">\n<title>{}</title>\n{body}",
        escaped(&text::clean(title)),
    )
}

/// The indices of stresses, `σ_zz`, set lower and smaller.
fn lowered(body: &str) -> String {
    let mut parts = body.split('_');
    let mut out = parts.next().unwrap_or("").to_owned();
    for part in parts {
        let length: usize = part.chars().take(2).take_while(|c| INDICES.contains(*c)).map(char::len_utf8).sum();
        let (index, rest) = part.split_at(length);
        if out.ends_with(['σ', 'τ']) && !index.is_empty() {
            out.push_str(&format!("<tspan dy=\"0.25em\" font-size=\"0.75em\">{index}</tspan>"));
            // What follows is back on the line.
            let back = if rest.trim_start().starts_with('<') { rest.to_owned() } else { raised(rest) };
            out.push_str(&back);
        } else {
            out.push('_');
            out.push_str(part);
        }
    }
    out
}

/// Names of the axes of stresses.
const INDICES: &str = "xyzrtθ";

/// The rest of a text behind an index, on the line of what stands before it.
fn raised(rest: &str) -> String {
    let end = rest.find('<').unwrap_or(rest.len());
    // A blank at the beginning of an element is none.
    let text = rest[..end].trim_end_matches('\n').replacen(' ', "\u{a0}", 1);
    format!("<tspan dy=\"-0.1875em\">{text}</tspan>{}", &rest[end..])
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[expect(clippy::cast_possible_truncation, reason = "the cast saturates and turns NaN into 0")]
fn whole(value: f64) -> i32 {
    value.round() as i32
}

/// Writing into a string does not fail; the errors of the library are those of files and fonts.
fn drawn<E>(_always_ok: Result<(), E>) {}

impl Canvas<'_> {
    fn fine(&self, dot: Dot) -> (i32, i32) {
        let (x, y) = (self.origin.0 + dot.0, self.origin.1 + dot.1);
        (whole(x * FINE), whole(y * FINE))
    }

    fn fines(&self, path: &[Dot]) -> Vec<(i32, i32)> {
        path.iter().map(|dot| self.fine(*dot)).collect()
    }

    /// Connected straight lines.
    pub(super) fn path(&mut self, path: &[Dot], pen: Pen) {
        let style = ShapeStyle {
            color: pen.colour.to_rgba(),
            filled: false,
            stroke_width: whole(pen.width * FINE).unsigned_abs(),
        };
        let path = self.fines(path);
        drawn(self.sheet.draw_path(path, &style));
    }

    /// Filled polygon.
    pub(super) fn polygon(&mut self, corners: &[Dot], colour: RGBColor) {
        let corners = self.fines(corners);
        drawn(self.sheet.fill_polygon(corners, &colour));
    }

    /// Filled circle.
    pub(super) fn disc(&mut self, centre: Dot, radius: f64, colour: RGBColor) {
        let centre = self.fine(centre);
        let radius = whole(radius * FINE).unsigned_abs();
        drawn(self.sheet.draw_circle(centre, radius, &colour, true));
    }

    /// Filled rectangle from its upper left to its lower right corner.
    pub(super) fn rectangle(&mut self, from: Dot, to: Dot, colour: RGBColor) {
        let (from, to) = (self.fine(from), self.fine(to));
        drawn(self.sheet.draw_rect(from, to, &colour, true));
    }

    /// One line of text, centred vertically on the place.
    pub(super) fn text(&mut self, at: Dot, text: &str, kind: Type) {
        self.write(at, text, kind, FontTransform::None);
    }

    /// One line of text running upwards, centred horizontally on the place.
    pub(super) fn upward_text(&mut self, at: Dot, text: &str, kind: Type) {
        self.write(at, text, kind, FontTransform::Rotate270);
    }

    fn write(&mut self, at: Dot, text: &str, kind: Type, turn: FontTransform) {
        let weight = match kind.weight {
            Weight::Regular => FontStyle::Normal,
            Weight::Bold => FontStyle::Bold,
        };
        let font = ("sans-serif", kind.size * FINE * LINE_HEIGHT).into_font();
        let font = font.style(weight).transform(turn);
        let style = TextStyle::from(font).color(&kind.colour).pos(Pos::new(kind.anchor, VPos::Center));
        let at = self.fine(at);
        drawn(self.sheet.draw_text(text, &style, at));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_of_stresses_are_set_lower_and_names_of_files_are_not() {
        assert_eq!(lowered("<text>my_lens_zz.ron</text>"), "<text>my_lens_zz.ron</text>");
        assert_eq!(
            lowered("<text>axial σ_zz</text>"),
            "<text>axial σ<tspan dy=\"0.25em\" font-size=\"0.75em\">zz</tspan></text>"
        );
        assert!(
            lowered("<text>hoop σ_θθ, a = 1</text>")
                .ends_with("θθ</tspan><tspan dy=\"-0.1875em\">,\u{a0}a = 1</tspan></text>")
        );
    }
}
