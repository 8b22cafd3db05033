//! Curves of several scenes and of measured data in one figure.

use super::axis_of;
use super::curve::marked;
use crate::app::export::overlay::{COLUMNS, OVERLAID, Overlaid};
use crate::app::figure::{Figure, Marks, Panel, Points, Series};

/// Pairs of quantities that make a panel, where two curves at least have both: one over another.
const PANELS: [[&str; 2]; 4] = [
    ["indentation_m", "force_n"],
    ["indentation_m", "contact_radius_m"],
    ["time_s", "force_n"],
    ["slide_m", "tangential_force_n"],
];

/// One panel for each pair of quantities that the curves share; measured points are marks.
#[must_use]
pub fn overlay_figure(curves: &[Overlaid]) -> Figure {
    let at = |name: &str| OVERLAID.iter().position(|known| *known == name).unwrap_or(0);
    let panels = PANELS.iter().filter_map(|[x, y]| panel(curves, at(x), at(y)));
    panels.fold(Figure::default(), Figure::with)
}

fn panel(curves: &[Overlaid], x: usize, y: usize) -> Option<Panel> {
    let having: Vec<&Overlaid> =
        curves.iter().filter(|of| !of.columns[x].is_empty() && !of.columns[y].is_empty()).collect();
    if having.len() < curves.len().min(2) {
        return None;
    }
    let panel = Panel::new(axis_of(&COLUMNS[x]), axis_of(&COLUMNS[y]));
    Some(having.into_iter().fold(panel, |panel, of| panel.with(series(of, x, y))))
}

fn series(of: &Overlaid, x: usize, y: usize) -> Series {
    let points: Points = of.columns[x].iter().zip(&of.columns[y]).map(|(x, y)| x.zip(*y)).collect();
    if of.measured {
        marked(&of.label, points.into_iter().flatten(), Marks::Numbered)
    } else {
        Series::new(of.label.clone(), points)
    }
}
