//! Pressure under a mass while the contact grows.

use super::Flight;
use super::piece::MotionPiece;
use crate::contact::loaded::Loaded;
use crate::numerics::panelled::PanelledCurve;

/// Times at which the pressure is looked at.
const LOOKS: u32 = 12;

impl Flight {
    /// Largest pressure [Pa] on the axis while the contact grows; `None` where a sharp edge or tip, or a
    /// dashpot at the edge, has an infinite one.
    #[must_use]
    pub fn peak_pressure(&self) -> Option<f64> {
        let profile = self.model.profile.as_ref();
        let deepest = self.deepest_radius();
        let infinite = self.model.spectrum.viscosity() > 0.0 || profile.flat_radius() > 0.0 || profile.kink().is_some();
        if infinite || !profile.pressure_integral(0.0, deepest).is_finite() {
            return None;
        }
        let turn = self.loading.last()?.end();
        let at = |k: u32| self.pressure(turn * f64::from(k) / f64::from(LOOKS), 0.0);
        let seen: Vec<f64> = (0..=LOOKS).map(at).collect();
        let best = (0..seen.len()).max_by(|&i, &j| seen[i].total_cmp(&seen[j]))?;
        let (Some(before), Some(after)) = (best.checked_sub(1).map(|i| seen[i]), seen.get(best + 1)) else {
            return Some(seen[best]);
        };
        let bend = before - 2.0 * seen[best] + after;
        Some(if bend < 0.0 { seen[best] - 0.125 * (after - before).powi(2) / bend } else { seen[best] })
    }

    /// Contact radius [m] at the greatest depth.
    #[must_use]
    pub fn deepest_radius(&self) -> f64 {
        let depth = self.loading.last().map_or(0.0, |piece| piece.depth(1.0));
        self.model.edge(depth).unwrap_or(0.0)
    }

    /// Time of the greatest depth [s].
    #[must_use]
    pub fn turn(&self) -> f64 {
        self.loading.last().map_or(0.0, MotionPiece::end)
    }

    /// Pressure [Pa] at the radius `r` and the time `t` up to the greatest depth.
    #[must_use]
    pub fn pressure(&self, t: f64, r: f64) -> f64 {
        let Some((load, ends)) = self.loads(t) else { return 0.0 };
        self.model.profile.pressure_of(&PanelledCurve::new(load, ends), r)
    }

    /// The contact at the greatest depth, under its load.
    #[must_use]
    pub fn loaded(&self) -> Option<Loaded> {
        let (_, ends) = self.loads(self.turn())?;
        let depth = self.loading.last()?.depth(1.0);
        let flight = self.clone();
        let load = move |x: f64| flight.loads(flight.turn()).map_or(0.0, |(load, _)| load(x));
        let pressed = {
            let profile = self.model.profile.clone();
            move |x: f64| depth - profile.reduced(x)
        };
        let displacement = PanelledCurve::new(pressed, ends.clone());
        Some(Loaded::remembered(self.model.profile.clone(), depth, PanelledCurve::new(load, ends), displacement))
    }

    /// The line load [N/m] at the time `t` over the distance from the axis, and the borders of its panels.
    fn loads(&self, t: f64) -> Option<(impl Fn(f64) -> f64, Vec<f64>)> {
        let piece = self.piece_at(t)?;
        let theta = piece.part(t);
        let a = self.model.edge(piece.depth(theta)).ok()?;
        let memory = piece.memory(&self.model.spectrum, theta);
        let mut ends = vec![0.0];
        ends.extend(self.model.profile.breaks(a).into_iter().filter(|&x| x > 0.0 && x < a));
        ends.extend([0.5, 0.9, 0.99].map(|part| part * a));
        ends.push(a);
        ends.sort_by(f64::total_cmp);
        let (depth, speed) = (piece.depth(theta), piece.speed(theta));
        Some((move |x: f64| self.line_load(x, (t, depth, speed), &memory), ends))
    }

    /// Line load [N/m] at the distance `x` from the axis.
    fn line_load(&self, x: f64, (time, depth, speed): (f64, f64, f64), memory: &[f64]) -> f64 {
        let spectrum = &self.model.spectrum;
        let (touched, height) = super::law::touch_of(&self.model, &self.loading, x);
        let Some(piece) = super::piece::at(&self.loading, touched) else { return 0.0 };
        let before = piece.memory(spectrum, piece.part(touched));
        let element = |(k, term): (usize, &crate::contact::viscoelastic::Element)| {
            memory[k] - (-(time - touched) / term.time).exp() * before[k]
        };
        let elements: f64 = spectrum.terms().iter().enumerate().map(element).sum();
        spectrum.equilibrium() * (depth - height) + elements + spectrum.viscosity() * speed
    }
}
