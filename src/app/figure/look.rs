//! Looks that stay apart in colour, in grey and for the colour-blind.

use plotters::style::RGBColor;

use super::{Panel, Series, Stroke};

/// Colour-blind-safe colours (Okabe & Ito 2008) in an order of alternating lightness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hue {
    /// Dark blue.
    Blue,
    /// Light orange.
    Orange,
    /// Black.
    Black,
    /// Reddish orange.
    Vermillion,
    /// Light blue.
    Sky,
    /// Bluish green.
    Green,
    /// Reddish purple.
    Purple,
    /// Medium grey.
    Grey,
}

/// Pattern of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// Unbroken.
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Dash, dot.
    DashDot,
    /// Long dashes.
    LongDash,
    /// Dash, dot, dot.
    DashDotDot,
    /// No line, marks only.
    Absent,
}

/// Marks at the points of a series.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Marks {
    /// No marks.
    #[default]
    Absent,
    /// The mark that belongs to the place in the legend.
    Numbered,
    /// A mark of the caller's choice.
    As(Mark),
}

/// Shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Small filled circle: a knot of the line.
    Point,
    /// Filled circle.
    Disc,
    /// Open square.
    Square,
    /// Filled triangle.
    Triangle,
    /// Open diamond.
    Diamond,
    /// Filled square.
    Block,
    /// Open circle.
    Ring,
    /// Diagonal cross.
    Cross,
    /// Upright cross.
    Plus,
}

const COLOURS: [Hue; 8] =
    [Hue::Blue, Hue::Orange, Hue::Black, Hue::Vermillion, Hue::Sky, Hue::Green, Hue::Purple, Hue::Grey];

const LINES: [Line; 6] = [Line::Solid, Line::Dashed, Line::DashDot, Line::Dotted, Line::LongDash, Line::DashDotDot];

const MARKS: [Mark; 8] =
    [Mark::Disc, Mark::Square, Mark::Triangle, Mark::Diamond, Mark::Block, Mark::Ring, Mark::Cross, Mark::Plus];

/// A style with nothing left open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look {
    /// Place in the legend; also the order of drawing.
    pub(super) number: usize,
    pub(super) colour: RGBColor,
    pub(super) line: Line,
    pub(super) width: f64,
    pub(super) mark: Option<Mark>,
}

/// Look of the series `index` of a panel.
pub(super) fn look(panel: &Panel, index: usize) -> Look {
    let number = number(panel, index);
    let style = panel.series.get(index).map(|s| s.style).unwrap_or_default();
    let mark = match style.marks {
        Marks::Absent => None,
        Marks::Numbered => pick(&MARKS, number),
        Marks::As(mark) => Some(mark),
    };
    let colour = style.colour.or(pick(&COLOURS, number));
    let line = style.line.or(pick(&LINES, number));
    Look {
        number,
        colour: rgb(colour.unwrap_or(Hue::Black)),
        line: line.unwrap_or(Line::Solid),
        width: width(panel, number, style.stroke),
        mark,
    }
}

/// Px; a line over cells is fine, lest it hide them.
fn width(panel: &Panel, number: usize, stroke: Stroke) -> f64 {
    match (&panel.cells, stroke, number) {
        (Some(_), _, _) | (None, Stroke::Fine, _) => 0.9,
        (None, Stroke::Usual, 0) => 2.2,
        (None, Stroke::Usual, _) => 1.8,
    }
}

fn pick<T: Copy>(all: &[T], number: usize) -> Option<T> {
    all.get(number % all.len()).copied()
}

/// Place in the legend: series with the same label share it.
fn number(panel: &Panel, index: usize) -> usize {
    let first = |s: &Series| panel.series.iter().position(|t| t.label == s.label);
    let before = panel.series.iter().enumerate().take(index + 1);
    let own = panel.series.get(index).and_then(first).unwrap_or(index);
    let distinct = before.filter(|(i, s)| *i <= own && first(s) == Some(*i));
    distinct.count().saturating_sub(1)
}

fn rgb(colour: Hue) -> RGBColor {
    match colour {
        Hue::Blue => RGBColor(0, 114, 178),
        Hue::Orange => RGBColor(230, 159, 0),
        Hue::Black => RGBColor(0, 0, 0),
        Hue::Vermillion => RGBColor(213, 94, 0),
        Hue::Sky => RGBColor(86, 180, 233),
        Hue::Green => RGBColor(0, 158, 115),
        Hue::Purple => RGBColor(204, 121, 167),
        Hue::Grey => RGBColor(110, 110, 110),
    }
}

/// Lengths of ink and gap in px, by turns; empty for an unbroken line.
pub(super) fn pattern(line: Line) -> &'static [f64] {
    match line {
        Line::Solid | Line::Absent => &[],
        Line::Dashed => &[7.0, 4.0],
        Line::Dotted => &[2.0, 2.5],
        Line::DashDot => &[9.0, 3.0, 2.0, 3.0],
        Line::LongDash => &[14.0, 4.0],
        Line::DashDotDot => &[9.0, 3.0, 2.0, 3.0, 2.0, 3.0],
    }
}

#[cfg(test)]
mod tests {
    use super::super::Axis;
    use super::*;

    #[test]
    fn series_with_one_label_share_one_look() {
        let axis = Axis::linear("", "1");
        let mut panel = Panel::new(axis.clone(), axis);
        for label in ["approach", "retract", "approach", "hold"] {
            panel = panel.with(Series::new(label, [(0.0, 0.0); 0]));
        }
        let numbers: Vec<usize> = (0..4).map(|i| number(&panel, i)).collect();
        assert_eq!(numbers, [0, 1, 0, 2]);
        assert_eq!(look(&panel, 0), look(&panel, 2));
    }

    #[test]
    fn neighbours_in_the_legend_differ_in_grey() {
        let grey = |c: &Hue| {
            let RGBColor(r, g, b) = rgb(*c);
            0.299 * f64::from(r) + 0.587 * f64::from(g) + 0.114 * f64::from(b)
        };
        // a tenth of the full scale is told apart at a glance on paper
        assert!(COLOURS.windows(2).all(|p| (grey(&p[0]) - grey(&p[1])).abs() > 25.5));
    }
}
