//! Plane shapes: the closed form or series beside the half-plane solver.

use super::{Comparison, ComparisonError, Measured, Method, Row, State, row, state_of, timed};
use crate::check::one_piece::largest_force;
#[cfg(feature = "half-space")]
use crate::halfspace::{PlaneBoundary, PlaneProblem, PlaneSolution, Prescribed, Settings, solve_plane};
use crate::run::{self, Wanted};
use crate::scene::plan::Plan;
use crate::scene::plan::SceneSettings;
#[cfg(feature = "half-space")]
use crate::shape::Shape;
use std::num::NonZeroUsize;

/// Strips of the half-plane.
#[cfg(feature = "half-space")]
const STRIPS: [usize; 6] = [128, 512, 2048, 8192, 32768, 131_072];

/// Compares the methods under the largest force of a plane scene; `done` is told the share behind.
pub(super) fn compare(setup: &Plan, done: &dyn Fn(f64)) -> Result<Comparison, ComparisonError> {
    let outcome = run::run(setup, Wanted::NOTHING)?;
    let force = largest_force(setup, &outcome);
    if force <= 0.0 {
        return Err(ComparisonError::NoContact);
    }
    let (mut rows, mut notes) = (Vec::new(), Vec::new());
    match direct(setup, force) {
        Some(measured) => rows.push(row((Method::Direct, None, None), &measured)),
        None => notes.push("the contact is not in one piece: only the half-plane solver has it".to_owned()),
    }
    rows.extend(half_plane(setup, force, done));
    if !cfg!(feature = "half-space") {
        notes.push(super::NO_HALF_SPACE.to_owned());
    }
    notes.push("compared under the largest force; radius is half of the width of all contact together".to_owned());
    let Some(own) = (0..rows.len()).rev().find(|&at| rows[at].method == Method::Direct).or(rows.len().checked_sub(1))
    else {
        return Err(ComparisonError::NoContact);
    };
    let state = rows[own].state;
    for (_, row) in rows.iter_mut().enumerate().filter(|(at, _)| *at != own) {
        fill_in(row, &state);
    }
    let reference = match rows[own].grid {
        None => "closed form or series of the half-plane".to_owned(),
        Some(strips) => format!("half-plane on {strips} strips, the finest"),
    };
    Ok(Comparison { reference, state, rows, notes })
}

fn fill_in(row: &mut Row, right: &State) {
    let error = |of: fn(&State) -> Option<f64>| Some(of(&row.state)? / of(right)? - 1.0);
    let errors = [
        error(|state| state.contact_radius_m),
        error(|state| state.peak_pressure_pa),
        error(|state| Some(state.indentation_m)),
    ];
    [row.radius_error, row.pressure_error, row.indentation_error] = errors;
}

/// The state under the force by the closed form, in one record.
fn direct(setup: &Plan, force: f64) -> Option<Measured> {
    let setup = setup.with(SceneSettings { steps: NonZeroUsize::new(1), ..setup.settings() }).ok()?;
    let fields = Wanted { fields: true, ..Wanted::NOTHING };
    let outcome = run::run(&setup, fields).ok()?;
    let (_, time) = timed(|| run::run(&setup, Wanted::NOTHING));
    let most = outcome.records.iter().max_by(|a, b| a.normal.force.total_cmp(&b.normal.force))?;
    if most.normal.force < force * (1.0 - 1e-12) {
        return None;
    }
    let state = State { peak_pressure_pa: outcome.number("peak_pressure_pa"), ..state_of(most) };
    Some(Measured { state, time, bytes: outcome.plan.state_bytes as u64, iterations: None })
}

#[cfg(not(feature = "half-space"))]
fn half_plane(_: &Plan, _: f64, _: &dyn Fn(f64)) -> Vec<Row> {
    Vec::new()
}

#[cfg(feature = "half-space")]
fn half_plane(setup: &Plan, force: f64, done: &dyn Fn(f64)) -> Vec<Row> {
    let mut rows = Vec::new();
    for (k, strips) in STRIPS.into_iter().enumerate() {
        let (solution, time) = timed(|| solved(setup, force, strips));
        if let Some(solution) = solution {
            // Eleven vectors and the kernel of a padded line.
            let measured = Measured {
                state: state(&solution, force),
                time,
                bytes: 8 * 16 * strips as u64,
                iterations: Some(solution.iterations),
            };
            rows.push(row((Method::HalfPlane, None, Some(strips)), &measured));
        }
        done((k + 1) as f64 / STRIPS.len() as f64);
    }
    rows
}

#[cfg(feature = "half-space")]
fn state(solution: &PlaneSolution, force: f64) -> State {
    State {
        indentation_m: solution.indentation,
        force_n: force,
        contact_radius_m: Some(0.5 * solution.contact_width()),
        peak_pressure_pa: Some(solution.peak_pressure()),
        ..State::default()
    }
}

/// The half-plane under a force [N]; `None` if the solver refuses.
#[cfg(feature = "half-space")]
fn solved(setup: &Plan, force: f64, strips: usize) -> Option<PlaneSolution> {
    let modulus = setup.pair.normal;
    let (window, boundary, width, height): (f64, _, f64, Box<dyn Fn(f64) -> f64>) = match &setup.scene.shape {
        Shape::PlaneWave(wave) => {
            let (amplitude, k) = (wave.amplitude.si(), std::f64::consts::PI / wave.wavelength.si());
            let height = move |x: f64| 2.0 * amplitude * (k * x).sin().powi(2);
            (wave.wavelength.si(), PlaneBoundary::Periodic, wave.width(), Box::new(height))
        }
        Shape::PlaneWavy(wavy) => {
            let radius = wavy.radius.si();
            let hertz = 2.0 * (force / wavy.width() * radius / (std::f64::consts::PI * modulus)).sqrt();
            // Waves widen the contact, by what their slope adds to that of the parabola.
            let window = 3.0 * (hertz + radius * wavy.rms_slope());
            let datum = wavy.datum.si();
            let height = move |x: f64| 0.5 * x * x / radius + wavy.ripple(x);
            (window.min(datum), PlaneBoundary::Free { datum }, wavy.width(), Box::new(height))
        }
        _ => return None,
    };
    let step = window / strips as f64;
    let place = |i: usize| (i as f64 - (strips / 2) as f64) * step;
    let heights = ndarray::Array1::from_shape_fn(strips, |i| height(place(i)));
    let problem =
        PlaneProblem { heights: heights.view(), step, modulus, boundary, control: Prescribed::Force(force / width) };
    solve_plane(&problem, None, &Settings::default()).ok()
}
