//! Figures for print and talks: values in, SVG text out; no physics, no files.
//!
//! ```
//! use springbed::app::figure::{Axis, Figure, Panel, Series};
//!
//! let force = (0..=100).map(|i| f64::from(i) * 1e-8).map(|d| (d, 3.0e10 * (0.01 * d * d * d).sqrt()));
//! let panel = Panel::new(Axis::linear("indentation d", "m"), Axis::linear("force F", "N"))
//!     .with(Series::new("approach", force).arrow());
//! let svg = Figure::new("Steel ball on a rigid flat").with(panel).svg();
//! assert!(svg.contains("indentation d (µm)"));
//! ```

mod area;
mod axis;
mod canvas;
mod clearance;
mod contour;
mod curve;
mod dash;
mod guide;
mod heat;
mod layout;
mod legend;
mod look;
mod mark;
mod merge;
mod paint;
mod panel;
mod range;
mod text;
mod thin;
mod ticks;
mod unit;

use super::medium::Medium;
pub use area::{Area, Shade};
pub use contour::{Colours, Contours};
pub use look::{Hue, Line, Mark, Marks};

/// A titled grid of panels.
///
/// One, two or three panels stand in a row, four in two rows of two, more in rows of three.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Heading of the whole figure, wrapped to its width; may be empty.
    pub title: String,
    /// Panels, row by row.
    pub panels: Vec<Panel>,
}

impl Figure {
    /// A figure without panels.
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), panels: Vec::new() }
    }

    /// The figure with one more panel.
    #[must_use]
    pub fn with(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// The figure as an SVG document for a screen; the same figure gives the same bytes.
    #[must_use]
    pub fn svg(&self) -> String {
        self.drawn(Medium::Screen)
    }

    /// The figure as an SVG document for a sheet.
    #[must_use]
    pub fn drawn(&self, medium: Medium) -> String {
        layout::draw(self, medium)
    }
}

/// One pair of axes with its curves, guides and legend.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Heading of the panel; may be empty.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Filled contours below everything else, with a bar of their colours beside the frame.
    pub contours: Option<Contours>,
    /// Filled areas under everything but contours and cells, the later over the earlier.
    pub areas: Vec<Area>,
    /// Curves; those later in the legend are drawn over the earlier ones.
    pub series: Vec<Series>,
    /// Reference lines under the curves.
    pub guides: Vec<Guide>,
    /// Remarks printed below the panel, wrapped to its width.
    pub notes: Vec<String>,
    /// Cells of colour under the curves, if any.
    pub cells: Option<Cells>,
    /// Width of the frame over its height, where both axes are to have one scale.
    pub ratio: Option<f64>,
}

/// A number for every pair of two others, shown by colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// Values along the horizontal axis, rising, at least two.
    pub x: Vec<f64>,
    /// Values along the vertical axis, rising, at least two.
    pub y: Vec<f64>,
    /// What is shown: all y of the first x, then those of the second; one that is missing stays white.
    pub values: Vec<Option<f64>>,
    /// What it is, and the spacing of its colours.
    pub of: Axis,
}

impl Panel {
    /// A panel without curves.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Self {
        let (contours, cells, areas) = (None, None, Vec::new());
        let (series, guides, notes) = (Vec::new(), Vec::new(), Vec::new());
        Self { title: String::new(), x, y, contours, areas, series, guides, notes, cells, ratio: None }
    }

    /// The panel under a heading.
    #[must_use]
    pub fn titled(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// The panel over filled contours.
    #[must_use]
    pub fn over(mut self, contours: Contours) -> Self {
        self.contours = Some(contours);
        self
    }

    /// The panel with one more filled area.
    #[must_use]
    pub fn filled(mut self, area: Area) -> Self {
        self.areas.push(area);
        self
    }

    /// The panel with one more curve.
    #[must_use]
    pub fn with(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// The panel with cells of colour; its axes end where they do.
    #[must_use]
    pub fn cells(mut self, cells: Cells) -> Self {
        for (axis, values) in [(&mut self.x, &cells.x), (&mut self.y, &cells.y)] {
            let edges = heat::edges(values, axis.scale);
            axis.limits = (edges.first().copied(), edges.last().copied());
        }
        self.cells = Some(cells);
        self
    }

    /// The panel in a frame of this width over its height.
    #[must_use]
    pub fn ratio(mut self, ratio: f64) -> Self {
        self.ratio = Some(ratio);
        self
    }

    /// The panel with one more guide.
    #[must_use]
    pub fn guide(mut self, guide: Guide) -> Self {
        self.guides.push(guide);
        self
    }

    /// The panel with one more remark below it.
    #[must_use]
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.notes.push(note.into());
        self
    }
}

/// Spacing of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps; the prefix of the unit follows the data.
    #[default]
    Linear,
    /// Equal ratios; zero and negative values are left out as gaps.
    Log,
}

/// A quantity along an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis {
    /// Name and symbol, such as `force F`.
    pub label: String,
    /// SI unit without prefix, such as `N`, `Pa`, `J/m^2`; `1` for a pure number.
    pub unit: String,
    /// Spacing.
    pub scale: Scale,
    /// Least and largest value shown; `None` follows the data.
    pub limits: (Option<f64>, Option<f64>),
    /// Whether the values grow downwards or to the left, as depths do.
    pub falling: bool,
}

impl Axis {
    /// An axis with equal steps.
    pub fn linear(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { label: label.into(), unit: unit.into(), ..Self::default() }
    }

    /// An axis with equal ratios.
    pub fn log(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { scale: Scale::Log, ..Self::linear(label, unit) }
    }

    /// The axis with its values growing downwards or to the left.
    #[must_use]
    pub fn falling(mut self) -> Self {
        self.falling = true;
        self
    }

    /// The axis starting at `least`; what lies below is cut off.
    #[must_use]
    pub fn from(mut self, least: f64) -> Self {
        self.limits.0 = Some(least);
        self
    }

    /// The axis ending at `largest`; what lies above is cut off.
    #[must_use]
    pub fn to(mut self, largest: f64) -> Self {
        self.limits.1 = Some(largest);
        self
    }
}

/// Points in SI units; one that is missing interrupts the line.
pub type Points = Vec<Option<(f64, f64)>>;

/// A curve or a cloud of points.
///
/// Series of one panel with the same label share one look and one entry of the legend.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Entry in the legend; none if empty.
    pub label: String,
    /// Points in SI units; one that is missing, or not finite, interrupts the line.
    pub points: Points,
    /// How the points are shown.
    pub style: Style,
}

impl Series {
    /// A line in the next free look, of points all of which are there or of points that may be missing.
    pub fn new(label: impl Into<String>, points: impl IntoIterator<Item = impl Into<Option<(f64, f64)>>>) -> Self {
        Self { label: label.into(), points: points.into_iter().map(Into::into).collect(), style: Style::default() }
    }

    /// The series in a colour of its own.
    #[must_use]
    pub fn colour(mut self, colour: Hue) -> Self {
        self.style.colour = Some(colour);
        self
    }

    /// The series with a line of its own.
    #[must_use]
    pub fn line(mut self, line: Line) -> Self {
        self.style.line = Some(line);
        self
    }

    /// The series with a mark at its points.
    #[must_use]
    pub fn marks(mut self, marks: Marks) -> Self {
        self.style.marks = marks;
        self
    }

    /// The series with a line as fine as many of them side by side need it.
    #[must_use]
    pub fn fine(mut self) -> Self {
        self.style.stroke = Stroke::Fine;
        self
    }

    /// The series with an arrow head telling the order of its points.
    #[must_use]
    pub fn arrow(mut self) -> Self {
        self.style.arrow = Arrow::Forward;
        self
    }
}

/// How a series is shown; what is `None` follows from its place in the legend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// Colour of line and marks.
    pub colour: Option<Hue>,
    /// Pattern of the line.
    pub line: Option<Line>,
    /// Marks at the points.
    pub marks: Marks,
    /// Width of the line.
    pub stroke: Stroke,
    /// Arrow head on the line.
    pub arrow: Arrow,
}

/// Width of a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stroke {
    /// That of a curve.
    #[default]
    Usual,
    /// That of one of many parts drawn side by side.
    Fine,
}

/// Arrow head on a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Arrow {
    /// No arrow head.
    #[default]
    Absent,
    /// One head in the order of the points.
    Forward,
}

/// A reference line, drawn thin and grey below the curves.
#[derive(Clone, Debug, PartialEq)]
pub enum Guide {
    /// Line of constant y.
    Horizontal {
        /// Value of y.
        at: f64,
        /// Name beside the line; may be empty.
        label: String,
    },
    /// Line of constant x.
    Vertical {
        /// Value of x.
        at: f64,
        /// Name beside the line; may be empty.
        label: String,
    },
    /// Short line y ∝ xⁿ put where the panel is free; needs two logarithmic axes.
    Slope {
        /// Exponent n.
        exponent: f64,
        /// Name beside the line, such as `slope −2`.
        label: String,
    },
    /// Dotted arrow from one point to another, such as a jump into contact.
    Jump {
        /// Point before.
        from: (f64, f64),
        /// Point after.
        to: (f64, f64),
    },
}

impl Guide {
    /// Line of constant y with a name.
    pub fn horizontal(at: f64, label: impl Into<String>) -> Self {
        let label = label.into();
        Self::Horizontal { at, label }
    }

    /// Line of constant x with a name.
    pub fn vertical(at: f64, label: impl Into<String>) -> Self {
        let label = label.into();
        Self::Vertical { at, label }
    }

    /// Reference slope y ∝ xⁿ with a name.
    pub fn slope(exponent: f64, label: impl Into<String>) -> Self {
        let label = label.into();
        Self::Slope { exponent, label }
    }
}

#[cfg(test)]
mod tests;
