//! Plane shapes: the closed form or series beside the half-plane solver.

use super::{Candidate, Compared, Contest, found, largest};
use crate::check::case::Attempt;
use crate::check::row::{Computed, Found, Setting};
use crate::check::study::Method;
use crate::run::{self, SimulationError, Wanted};
use crate::scene::plan::{Plan, SceneSettings};
use std::num::NonZeroUsize;
use std::sync::Arc;

/// The methods under the largest force of a plane scene.
pub(super) fn contest(plan: &Plan, force: f64) -> Result<Contest, SimulationError> {
    // The state under the force by the closed form, in one record.
    let one = Arc::new(plan.with(SceneSettings { steps: NonZeroUsize::new(1), ..plan.settings() })?);
    let direct = Method::new("direct", Setting::FREE, move || {
        let (plan, pressure) = (one.clone(), pressure(&one)?);
        Ok(move || direct(&plan, force, pressure))
    });
    let mut methods = vec![direct];
    let mut candidates = vec![Candidate { at: 0, name: "closed form or series of the half-plane".to_owned() }];
    for (name, method) in strips::methods(plan, force) {
        candidates.insert(1, Candidate { at: methods.len(), name });
        methods.push(method);
    }
    let under = "compared under the largest force; radius is half of the width of all contact together";
    let notes = super::WITHOUT.into_iter().chain([under]).map(str::to_owned).collect();
    Ok(Contest { compared: Compared::Plane, methods, exact: None, candidates, pressure: None, members: 1, notes })
}

/// Largest pressure [Pa].
fn pressure(plan: &Plan) -> Attempt<Option<f64>> {
    let outcome = run::run(plan, Wanted { fields: true, ..Wanted::NOTHING })?;
    Ok(outcome.number("peak_pressure_pa"))
}

fn direct(plan: &Plan, force: f64, peak_pressure_pa: Option<f64>) -> Attempt<Computed> {
    let outcome = run::run(plan, Wanted::NOTHING)?;
    let most = largest(&outcome.records).filter(|most| most.normal.force >= force * (1.0 - 1e-12));
    let most = most.ok_or("the contact is not in one piece: only the half-plane solver has it")?;
    let found = Found { peak_pressure_pa, ..found(most) };
    Ok(Computed { found, bytes: outcome.plan.state_bytes, ..Computed::default() })
}

/// No half-plane in strips.
#[cfg(not(feature = "half-space"))]
mod strips {
    pub(super) fn methods(_: &super::Plan, _: f64) -> Vec<(String, super::Method)> {
        Vec::new()
    }
}

/// The half-plane in strips.
#[cfg(feature = "half-space")]
mod strips {
    use super::{Attempt, Computed, Found, Method, Plan, Setting};
    use crate::halfspace::{PlaneBoundary, PlaneProblem, Prescribed, Settings, solve_plane};
    use crate::shape::{Cylinder, PlaneWave, PlaneWavy, Shape};
    use ndarray::Array1;
    use std::f64::consts::PI;

    /// Strips of the half-plane.
    const STRIPS: [usize; 6] = [128, 512, 2048, 8192, 32768, 131_072];

    /// The half-plane on all numbers of strips, and what it is called where it is right.
    pub(super) fn methods(plan: &Plan, force: f64) -> Vec<(String, Method)> {
        let method =
            |strips| Method::of("half-plane", Setting::grid(strips), plan, move |plan| solved(plan, force, strips));
        STRIPS.map(|strips| (format!("half-plane on {strips} strips, the finest"), method(strips))).into()
    }

    /// What the strips are pressed by.
    struct PressedSection {
        boundary: PlaneBoundary,
        /// Width of the window [m].
        window: f64,
        /// Width across the section [m].
        width: f64,
        heights: Box<dyn Fn(f64) -> f64>,
    }

    fn wave(wave: &PlaneWave) -> PressedSection {
        let (amplitude, k) = (wave.amplitude.si(), PI / wave.wavelength.si());
        let heights = Box::new(move |x: f64| 2.0 * amplitude * (k * x).sin().powi(2));
        let (window, width) = (wave.wavelength.si(), wave.width());
        PressedSection { boundary: PlaneBoundary::Periodic, window, width, heights }
    }

    fn lying(cylinder: &Cylinder, modulus: f64, force: f64) -> PressedSection {
        let Cylinder { radius, datum, width } = cylinder.clone();
        wavy(&PlaneWavy { radius, waves: Vec::new(), datum, width }, modulus, force)
    }

    fn wavy(wavy: &PlaneWavy, modulus: f64, force: f64) -> PressedSection {
        let (radius, width, datum) = (wavy.radius.si(), wavy.width(), wavy.datum.si());
        let hertz = 2.0 * (force / width * radius / (PI * modulus)).sqrt();
        // Waves widen the contact, by what their slope adds to that of the parabola.
        let window = 3.0 * (hertz + radius * wavy.rms_slope());
        let wavy = wavy.clone();
        let heights = Box::new(move |x: f64| 0.5 * x * x / radius + wavy.ripple(x));
        PressedSection { boundary: PlaneBoundary::Free { datum }, window: window.min(datum), width, heights }
    }

    fn solved(plan: &Plan, force: f64, strips: usize) -> Attempt<Computed> {
        let modulus = plan.pair.normal;
        let shape = &plan.scene.shape;
        let pressed = if let Shape::PlaneWave(shape) = shape {
            wave(shape)
        } else if let Shape::PlaneWavy(shape) = shape {
            wavy(shape, modulus, force)
        } else if let Shape::Cylinder(shape) = shape {
            lying(shape, modulus, force)
        } else {
            return Err(format!("{} is not long across", shape.name()).into());
        };
        let step = pressed.window / strips as f64;
        let place = |i: usize| (i as f64 - (strips / 2) as f64) * step;
        let heights = Array1::from_shape_fn(strips, |i| (pressed.heights)(place(i)));
        let control = Prescribed::Force(force / pressed.width);
        let problem = PlaneProblem { heights: heights.view(), step, modulus, boundary: pressed.boundary, control };
        let solution = solve_plane(&problem, None, &Settings::default())?;
        let found = Found {
            indentation_m: Some(solution.indentation),
            force_n: Some(force),
            contact_radius_m: Some(0.5 * solution.contact_width()),
            peak_pressure_pa: Some(solution.peak_pressure()),
            ..Found::default()
        };
        // Eleven vectors and the kernel of a padded line.
        Ok(Computed { found, bytes: 8 * 16 * strips, iterations: Some(solution.iterations), ..Computed::default() })
    }
}
