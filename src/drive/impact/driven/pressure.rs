//! Pressure under a mass while the contact grows.

use super::Flight;
use super::collocation::{NODES, RADAU, rate, through_all};
use super::law::{Kinematics, touch_of};
use super::piece::{self, MotionPiece, MotionState};
use crate::contact::loaded::Loaded;
use crate::contact::model::Loading;
use crate::numerics::extremum::{self, Peak};
use crate::numerics::panelled::PanelledCurve;

/// Where in a piece the pressure is looked at, before its top is sought about the highest of them.
const LOOKS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];
/// Ages of springs, in relaxation times, between which their loads are followed on their own.
const LAYERS: [f64; 3] = [1.0, 6.0, 36.0];

impl Flight {
    /// Largest pressure [Pa]: on the axis while the contact grows, and anywhere at the greatest depth; `None` where a sharp
    /// edge or tip, or a dashpot at the edge, has an infinite one. On a paraboloid that is the largest of all, for the fresh
    /// springs under the edge carry no more at any time than those of the axis did at first, as long as the mass slows down.
    #[must_use]
    pub fn peak_pressure(&self) -> Option<f64> {
        let profile = self.model.profile.as_ref();
        let deepest = self.deepest_radius();
        let infinite = self.model.spectrum.viscosity() > 0.0 || profile.flat_radius() > 0.0 || profile.kink().is_some();
        if infinite || !profile.pressure_integral(0.0, deepest).is_finite() {
            return None;
        }
        let pieces = self.on_axis()?;
        let at = |t: f64| {
            let Some(piece) = piece::at(&pieces, t) else { return 0.0 };
            let (spectrum, theta) = (&self.model.spectrum, piece.part(t));
            spectrum.equilibrium() * piece.depth(theta) + piece.memory(spectrum, theta).iter().sum::<f64>()
        };
        let looks = pieces.iter().flat_map(|piece| LOOKS.map(|theta| piece.start.time + theta * piece.span));
        let seen: Vec<Peak> = looks.map(|place| Peak { place, value: at(place) }).collect();
        let best = (0..seen.len()).max_by(|&i, &j| seen[i].value.total_cmp(&seen[j].value))?;
        let (before, after) = (&seen[best.saturating_sub(1)], &seen[(best + 1).min(seen.len() - 1)]);
        let top = seen[best].max(extremum::greatest(at, before.place, after.place));
        let deepest = self.loaded().and_then(|loaded| Loading::peak(&loaded))?;
        // Near the first touch the curve is a root, which the polynomials only follow to the place of its top.
        Some(self.pressure(top.place, 0.0).max(deepest))
    }

    /// The pressure on the axis while the contact grows, as that of an elastic body per E* in the place of a depth:
    /// p(0, t) = ∫ E(t−s) dP(s), P the one at the radius of the time s (Radok 1957; Lee & Radok 1960).
    fn on_axis(&self) -> Option<Vec<MotionPiece>> {
        let (profile, spectrum) = (self.model.profile.as_ref(), &self.model.spectrum);
        let elastic = |depth: f64| {
            let a = self.model.edge(depth).ok()?;
            let over = depth - profile.reduced(a);
            let edge = if over > 0.0 { over * profile.edge_pressure(0.0, a) } else { 0.0 };
            Some(profile.pressure_integral(0.0, a) + edge)
        };
        let mut now = MotionState { memory: vec![0.0; spectrum.terms().len()], ..MotionState::default() };
        let risen = |piece: &MotionPiece| {
            let mut values = [0.0; NODES];
            for (value, theta) in values.iter_mut().zip(RADAU) {
                *value = elastic(piece.depth(theta))?;
            }
            let start = MotionState { time: piece.start.time, ..now.clone() };
            let velocity = rate(&through_all(now.depth, &values), piece.span);
            let risen = MotionPiece { start, velocity, ..piece.clone() };
            let memory = risen.memory(spectrum, 1.0);
            now = MotionState { depth: values[NODES - 1], memory, ..MotionState::default() };
            Some(risen)
        };
        self.loading.iter().map(risen).collect()
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
        let Some((piece, ends)) = self.piece_at(t).zip(self.panels(t)) else { return 0.0 };
        let (speed, memory) = (piece.speed(piece.part(t)), piece.memory(&self.model.spectrum, piece.part(t)));
        let now = Kinematics { time: t, depth: piece.depth(piece.part(t)), speed, memory: &memory };
        self.model.profile.pressure_of(&PanelledCurve::new(|x| self.line_load(x, &now), ends), r)
    }

    /// The contact at the greatest depth, under its load.
    #[must_use]
    pub fn loaded(&self) -> Option<Loaded> {
        let (piece, ends) = (self.loading.last()?, self.panels(self.turn())?);
        let (flight, profile) = (self.clone(), self.model.profile.clone());
        let (time, depth, memory) = (piece.end(), piece.depth(1.0), piece.memory(&self.model.spectrum, 1.0));
        let speed = piece.speed(1.0);
        let load = move |x: f64| flight.line_load(x, &Kinematics { time, depth, speed, memory: &memory });
        let displacement = PanelledCurve::new(move |x: f64| depth - profile.reduced(x), ends.clone());
        Some(Loaded::remembered(self.model.profile.clone(), depth, PanelledCurve::new(load, ends), displacement))
    }

    /// Borders [m] of panels on which the line load at the time `t` [s] is smooth: of the profile, and of what was touched
    /// within the last of each relaxation time.
    fn panels(&self, t: f64) -> Option<Vec<f64>> {
        let reach = |t: f64| {
            let piece = self.piece_at(t)?;
            self.model.edge(piece.depth(piece.part(t))).ok()
        };
        let a = reach(t)?;
        let ago = self.model.spectrum.terms().iter().flat_map(|term| LAYERS.map(|times| t - times * term.time));
        let layers: Vec<f64> = ago.filter(|&then| then > 0.0).filter_map(reach).collect();
        let breaks =
            self.model.profile.breaks(a).into_iter().chain([0.5, 0.9, 0.99].map(|part| part * a)).chain(layers);
        let mut ends: Vec<f64> = breaks.filter(|&x| x > 0.0 && x < a).chain([0.0, a]).collect();
        ends.sort_by(f64::total_cmp);
        Some(ends)
    }

    /// Line load [N/m] at the distance `x` from the axis.
    fn line_load(&self, x: f64, now: &Kinematics<'_>) -> f64 {
        let spectrum = &self.model.spectrum;
        let (touched, height) = touch_of(&self.model, &self.loading, x);
        let Some(piece) = piece::at(&self.loading, touched) else { return 0.0 };
        let before = piece.memory(spectrum, piece.part(touched));
        let kept = spectrum.terms().iter().zip(&before).map(|(term, h)| (-(now.time - touched) / term.time).exp() * h);
        let elements: f64 = now.memory.iter().zip(kept).map(|(h, kept)| h - kept).sum();
        spectrum.equilibrium() * (now.depth - height) + elements + spectrum.viscosity() * now.speed
    }
}
