//! A fit: data and model, and what is left.

use crate::app::export::Fitted;
use crate::app::figure::{Axis, Colours, Contours, Figure, Guide, Hue, Line, Mark, Marks, Panel, Series};
use crate::fit::prony::{Moduli, Spectrum};
use crate::fit::{Map, Master};
use crate::scene::fit::Drive;

/// Points drawn of each of the ways.
const DRAWN: usize = 400;

/// Data, model, first touch, and what is left of the points that count.
#[must_use]
pub fn fit_figure(fitted: &Fitted) -> Figure {
    let Fitted { curve, fit, .. } = fitted;
    let response = curve.answered(fit.led);
    let (x, axis) = abscissa(fitted);
    let answer = || answer(fit.led);
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
    if let Some(touch) = fit.parameter("contact_point").filter(|_| fit.led == Drive::Depth) {
        curves = curves.guide(Guide::vertical(touch.value, "first touch"));
        left = left.guide(Guide::vertical(touch.value, ""));
    }
    for note in &fit.notes {
        left = left.note(note.clone());
    }
    Figure::new(fitted.scene.title.clone()).with(curves).with(left)
}

/// Lines of models beside each other, apart in grey.
const STYLES: [(Hue, Line); 6] = [
    (Hue::Black, Line::Solid),
    (Hue::Vermillion, Line::Dashed),
    (Hue::Blue, Line::Dotted),
    (Hue::Orange, Line::Solid),
    (Hue::Black, Line::Dashed),
    (Hue::Vermillion, Line::Dotted),
];

/// Measured data, the models that were compared, and what each of them leaves.
#[must_use]
pub fn models_figure(fitted: &Fitted) -> Figure {
    let (x, axis) = abscissa(fitted);
    let led = fitted.fit.led;
    let response = fitted.curve.answered(led);
    let every = fitted.curve.len().div_ceil(DRAWN).max(1);
    let measured = (0..fitted.curve.len()).step_by(every).map(|at| (x[at], response[at])).collect::<Vec<_>>();
    let measured = Series::new("measured", measured).colour(Hue::Sky).line(Line::Absent);
    let mut curves = Panel::new(axis.clone(), answer(led)).with(measured.marks(Marks::As(Mark::Disc)));
    let mut left = Panel::new(axis, Axis { label: "residual, mean of neighbours".to_owned(), ..answer(led) });
    let answered = fitted.models.iter().filter_map(|model| Some((model, model.answer.as_ref().ok()?)));
    for ((model, one), (hue, line)) in answered.zip(STYLES.into_iter().cycle()) {
        let drawn = |of: &dyn Fn(usize) -> f64| one.fit.used.iter().map(|&at| (x[at], of(at))).collect::<Vec<_>>();
        let beyond = model.standing.map_or(f64::NAN, |standing| standing.beyond_best);
        let label = format!("{}, ΔBIC {beyond:.1}", model.name);
        curves = curves.with(Series::new(label, drawn(&|at| one.fit.model[at])).colour(hue).line(line));
        let rest = one.fit.used.iter().map(|&at| (x[at], response[at] - one.fit.model[at])).collect::<Vec<_>>();
        left = left.with(Series::new("", means(&rest)).colour(hue).line(line));
    }
    Figure::new(fitted.scene.title.clone()).with(curves).with(left.guide(Guide::horizontal(0.0, "")))
}

/// Means over neighbours, few enough that models are told apart.
fn means(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mean = |chunk: &[(f64, f64)]| {
        let sum = chunk.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0, sum.1 + point.1));
        (sum.0 / chunk.len() as f64, sum.1 / chunk.len() as f64)
    };
    points.chunks(points.len().div_ceil(MEANS).max(1)).map(mean).collect()
}

/// Means drawn of what a model leaves.
const MEANS: usize = 60;

/// The confidence over two parameters up to 95 %, and the answer.
#[must_use]
pub fn map_figure(fitted: &Fitted, map: &Map) -> Figure {
    let axis = |at: usize, values: &[f64]| Axis {
        limits: (values.first().copied(), values.last().copied()),
        ..Axis::linear(map.paths[at].clone(), map.units[at])
    };
    // Rows of the contours have the same y.
    let values = (0..map.y.len()).flat_map(|row| (0..map.x.len()).map(move |column| column * map.y.len() + row));
    let values = values.map(|at| map.rise[at].map(|rise| map.confidence(rise))).collect();
    let shown = Axis { limits: (Some(0.0), Some(CONFIDENT)), ..Axis::linear("confidence of the pair", "") };
    let contours = Contours { x: map.x.clone(), y: map.y.clone(), values, axis: shown, colours: Colours::Rising };
    let here = |path: &str| fitted.fit.parameter(path).map_or(f64::NAN, |one| one.value);
    let found = Series::new("found", [(here(&map.paths[0]), here(&map.paths[1]))]).colour(Hue::Vermillion);
    let found = found.line(Line::Absent).marks(Marks::As(Mark::Square));
    Figure::new(fitted.scene.title.clone())
        .with(Panel::new(axis(0, &map.x), axis(1, &map.y)).over(contours).with(found))
}

/// Confidence of the outermost region drawn.
const CONFIDENT: f64 = 0.95;

fn answer(led: Drive) -> Axis {
    match led {
        Drive::Depth => Axis::linear("force F", "N"),
        Drive::Force => Axis::linear("indentation d", "m"),
        Drive::Speed => Axis::linear("restitution e", ""),
        Drive::Slide => Axis::linear("tangential force Fₓ", "N"),
    }
}

/// What the data are drawn over: what drives, or the time under a force.
fn abscissa(fitted: &Fitted) -> (&[f64], Axis) {
    let Fitted { curve, fit, .. } = fitted;
    let drive = curve.driven(fit.led);
    match (fit.led, &curve.time) {
        (Drive::Force, Some(time)) => (time, Axis::linear("time t", "s")),
        (Drive::Force, None) => (drive, Axis::linear("force F", "N")),
        (Drive::Depth, _) => (drive, Axis::linear("depth z, as measured", "m")),
        (Drive::Speed, _) => (drive, Axis::log("speed v", "m/s")),
        (Drive::Slide, _) => (drive, Axis::linear("slide uₓ, as measured", "m")),
    }
}

/// Moduli over frequency, measured and of the spectrum.
#[must_use]
pub fn spectrum_figure(moduli: &Moduli, spectrum: &Spectrum, master: Option<&Master>) -> Figure {
    let points = |values: &[f64]| moduli.frequency.iter().copied().zip(values.iter().copied()).collect::<Vec<_>>();
    let mut rising = moduli.frequency.clone();
    rising.sort_by(f64::total_cmp);
    let model = |of: fn((f64, f64)) -> f64| rising.iter().map(|&f| (f, of(spectrum.at(f)))).collect::<Vec<_>>();
    let frequency = if master.is_some() { "reduced frequency a_T f" } else { "frequency f" };
    let marks = |label: &str, values: &[f64], hue: Hue, mark: Mark| {
        Series::new(label, points(values)).colour(hue).line(Line::Absent).marks(Marks::As(mark))
    };
    let panel = Panel::new(Axis::log(frequency, "Hz"), Axis::log("modulus", "Pa"))
        .with(marks("storage, measured", &moduli.storage, Hue::Sky, Mark::Disc))
        .with(marks("loss, measured", &moduli.loss, Hue::Orange, Mark::Square))
        .with(Series::new("storage", model(|both| both.0)).colour(Hue::Blue).line(Line::Solid))
        .with(Series::new("loss", model(|both| both.1)).colour(Hue::Vermillion).line(Line::Dashed));
    let terms = spectrum.terms.iter().map(|&(modulus, time)| (time, modulus));
    let lines = Panel::new(Axis::log("relaxation time τ", "s"), Axis::log("modulus of the term", "Pa"))
        .with(Series::new("", terms).colour(Hue::Black).line(Line::Dotted).marks(Marks::As(Mark::Disc)));
    let figure = Figure::new("Relaxation spectrum").with(panel).with(lines);
    master.map(shifts_panel).into_iter().fold(figure, Figure::with)
}

/// Shifts over the temperature, and their law.
fn shifts_panel(master: &Master) -> Panel {
    let found = Series::new("found", master.shifts.clone()).colour(Hue::Sky).line(Line::Absent);
    let panel = Panel::new(Axis::linear("temperature T", "K"), Axis::linear("log₁₀ a_T", ""));
    let panel = panel.with(found.marks(Marks::As(Mark::Disc)));
    let ends = master.shifts.first().zip(master.shifts.last()).map_or((0.0, 0.0), |(first, last)| (first.0, last.0));
    let at = |k: usize| ends.0 + (ends.1 - ends.0) * k as f64 / LAW as f64;
    let law: Vec<(f64, f64)> = (0..=LAW).filter_map(|k| Some((at(k), master.law(at(k))?))).collect();
    if law.is_empty() { panel } else { panel.with(Series::new("Williams, Landel & Ferry", law).colour(Hue::Black)) }
}

/// Points drawn of a law.
const LAW: usize = 80;
