//! A fit: data and model, and what is left.

use crate::app::export::Fitted;
use crate::app::figure::{Axis, Figure, Guide, Hue, Line, Mark, Marks, Panel, Series};
use crate::contact::adhesion::equilibrium::Control;
use crate::fit::prony::{Moduli, Spectrum};

/// Points drawn of each of the ways.
const DRAWN: usize = 400;

/// Data, model, first touch, and what is left of the points that count.
#[must_use]
pub fn fit_figure(fitted: &Fitted) -> Figure {
    let Fitted { curve, fit, .. } = fitted;
    let response = curve.answered(fit.control);
    let (x, axis) = abscissa(fitted);
    let answer = || match fit.control {
        Control::Indentation => Axis::linear("force F", "N"),
        Control::Force => Axis::linear("indentation d", "m"),
    };
    let every = curve.len().div_ceil(DRAWN).max(1);
    let drawn = |of: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
        fit.used.iter().step_by(every).map(|&at| (x[at], of(at))).collect()
    };
    let measured = Series::new("measured", drawn(&|at| response[at])).colour(Hue::Sky).line(Line::Absent);
    let model: Vec<(f64, f64)> = fit.used.iter().map(|&at| (x[at], fit.model[at])).collect();
    let model = Series::new("model", model).colour(Hue::Black).line(Line::Solid);
    let mut curves = Panel::new(axis.clone(), answer()).with(measured.marks(Marks::As(Mark::Disc))).with(model);
    let rest = Series::new("measured − model", drawn(&|at| response[at] - fit.model[at]));
    let rest = rest.colour(Hue::Sky).line(Line::Absent).marks(Marks::As(Mark::Disc));
    let mut left = Panel::new(axis, Axis { label: "residual".to_owned(), ..answer() }).with(rest);
    left = left.guide(Guide::horizontal(0.0, ""));
    if let Some(touch) = fit.parameter("contact_point").filter(|_| fit.control == Control::Indentation) {
        curves = curves.guide(Guide::vertical(touch.value, "first touch"));
        left = left.guide(Guide::vertical(touch.value, ""));
    }
    for note in &fit.notes {
        left = left.note(note.clone());
    }
    Figure::new(fitted.scene.title.clone()).with(curves).with(left)
}

/// What the data are drawn over: the depth, or the time under a force.
fn abscissa(fitted: &Fitted) -> (&[f64], Axis) {
    let Fitted { curve, fit, .. } = fitted;
    match (fit.control, &curve.time) {
        (Control::Force, Some(time)) => (time, Axis::linear("time t", "s")),
        (Control::Force, None) => (&curve.force, Axis::linear("force F", "N")),
        (Control::Indentation, _) => (&curve.depth, Axis::linear("depth z, as measured", "m")),
    }
}

/// Moduli over frequency, measured and of the spectrum.
#[must_use]
pub fn spectrum_figure(moduli: &Moduli, spectrum: &Spectrum) -> Figure {
    let points = |values: &[f64]| moduli.frequency.iter().copied().zip(values.iter().copied()).collect::<Vec<_>>();
    let model = |of: fn((f64, f64)) -> f64| moduli.frequency.iter().map(move |&f| (f, of(spectrum.at(f))));
    let marks = |label: &str, values: &[f64], hue: Hue, mark: Mark| {
        Series::new(label, points(values)).colour(hue).line(Line::Absent).marks(Marks::As(mark))
    };
    let panel = Panel::new(Axis::log("frequency f", "Hz"), Axis::log("modulus", "Pa"))
        .with(marks("storage, measured", &moduli.storage, Hue::Sky, Mark::Disc))
        .with(marks("loss, measured", &moduli.loss, Hue::Orange, Mark::Square))
        .with(Series::new("storage", model(|both| both.0)).colour(Hue::Blue).line(Line::Solid))
        .with(Series::new("loss", model(|both| both.1)).colour(Hue::Vermillion).line(Line::Dashed));
    let terms = spectrum.terms.iter().map(|&(modulus, time)| (time, modulus));
    let lines = Panel::new(Axis::log("relaxation time τ", "s"), Axis::log("modulus of the term", "Pa"))
        .with(Series::new("", terms).colour(Hue::Black).line(Line::Dotted).marks(Marks::As(Mark::Disc)));
    Figure::new("Relaxation spectrum").with(panel).with(lines)
}
