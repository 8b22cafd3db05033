//! The indenter and its one-dimensional equivalent; the moduli of a viscoelastic body.

use super::curve::marked;
use crate::app::figure::{Axis, Hue, Mark, Marks, Panel, Series};
use crate::contact::viscoelastic::Spectrum;
use crate::material::Relaxation;
use crate::run::record::Outcome;
use crate::scene::plan::Plan;
use crate::scene::stage::Path;
use crate::shape::{Profile, Rim};
use std::f64::consts::TAU;

const POINTS: usize = 400;

/// f(r) and g(x) over the radius, out to a little beyond the largest contact; of a section over the half width at which
/// a spring is touched.
pub fn profile(profile: &dyn Profile, outcome: &Outcome, across: Axis) -> Panel {
    let largest = outcome.records.iter().filter_map(|record| record.normal.contact_radius).fold(0.0, f64::max);
    let wanted = if largest > 0.0 { 1.25 * largest } else { profile.contact_radius(profile.scale()) };
    let reach = wanted.min(profile.contact_radius(profile.rim().radius()));
    let at = |k: usize| reach * (k as f64 / POINTS as f64);
    let of = |height: &dyn Fn(f64) -> f64| (0..=POINTS).map(|k| (at(k), height(at(k)))).collect::<Vec<_>>();
    let below = if profile.bare().is_some() { "depth d(a) of touch" } else { "equivalent g(x)" };
    let panel = Panel::new(across, Axis::linear("height", "m"))
        .with(Series::new("profile f(r)", of(&|r| profile.height(profile.place(r)))))
        .with(Series::new(below, of(&|x| profile.reduced(profile.place(x)))));
    if matches!(profile.rim(), Rim::Wall(_)) {
        panel.note("Beyond the radius of the punch both rise vertically.")
    } else {
        panel
    }
}

/// Relaxation and storage and loss moduli over the decades of the spectrum, with those that the last loop was found to
/// have.
pub fn moduli(relaxation: &Relaxation, plan: &Plan, outcome: &Outcome) -> Panel {
    let wave = plan.stages.iter().rev().find_map(|stage| match stage.normal {
        Path::Wave(wave) => Some(wave),
        _ => None,
    });
    let found = |name| Some((TAU * wave?.frequency, outcome.number(name)?));
    let mark = |label, name, shape| {
        let series = marked(label, [found(name)?], Marks::As(shape));
        Some(series.colour(Hue::Vermillion))
    };
    let storage = mark("E′ of the last loop", "storage_modulus_pa", Mark::Ring);
    let loss = mark("E″ of the last loop", "loss_modulus_pa", Mark::Square);
    storage.into_iter().chain(loss).fold(spectrum(relaxation), Panel::with)
}

/// Relaxation and storage and loss moduli over the decades of the spectrum.
fn spectrum(relaxation: &Relaxation) -> Panel {
    let lag = relaxation.viscosity / relaxation.equilibrium.max(f64::MIN_POSITIVE);
    let times = relaxation.terms.iter().map(|term| term.1).chain([lag]);
    let times = times.filter(|time| *time > 0.0 && time.is_finite());
    let (least, most) =
        times.fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), time| (least.min(time), most.max(time)));
    let (low, high) = if most > 0.0 { ((0.01 / most).log10(), (100.0 / least).log10()) } else { (-3.0, 3.0) };
    let rate = |k: usize| 10f64.powf(low + (high - low) * k as f64 / POINTS as f64);
    let of = |modulus: &dyn Fn(f64) -> f64| (0..=POINTS).map(|k| (rate(k), modulus(rate(k)))).collect::<Vec<_>>();
    // What is left of a liquid after its longest time falls without end.
    let spectrum = Spectrum::new(relaxation);
    let floor = (0..=POINTS).map(|k| spectrum.storage(rate(k)).max(spectrum.loss(rate(k))));
    let floor = 1e-3 * floor.fold(f64::INFINITY, f64::min);
    let modulus = if floor > 0.0 { Axis::log("modulus", "Pa").from(floor) } else { Axis::log("modulus", "Pa") };
    Panel::new(Axis::log("angular frequency ω, 1/t", "1/s"), modulus)
        .with(Series::new("relaxation E*(t = 1/ω)", of(&|rate| spectrum.relaxation(1.0 / rate))))
        .with(Series::new("storage E′(ω)", of(&|rate| spectrum.storage(rate))))
        .with(Series::new("loss E″(ω)", of(&|rate| spectrum.loss(rate))))
        .note(format!("Angular frequency ω = {:.4} × frequency.", TAU))
}
