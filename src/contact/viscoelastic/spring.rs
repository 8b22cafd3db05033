//! One spring: its exact motion under a point that moves at constant speed, and when it is free.
//!
//! A spring pressed by the indenter follows u̇ = v; with sᵢ the load of the Maxwell element i,
//! q = E∞u + Σ sᵢ + ηv and sᵢ(t) = sᵢ e^(−t/τᵢ) + Eᵢ v τᵢ (1 − e^(−t/τᵢ)). A free one has q = 0 and
//! u(t) = z₀ + Σ zₘ e^(−t/λₘ), every mode on its own. Two facts make the events safe to find. Since
//! q ≥ 0 in the past, all zₘ ≥ 0: u of a free spring is convex. And at q = 0 the load obeys
//! q̇ = E(0)(v − u̇_free) with u̇_free growing towards zero, so that at constant speed q changes its
//! sign at most once, from plus to minus: the sign at the end of a step tells whether the spring
//! was released in it.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::Spectrum;
//! use springbed::material::Relaxation;
//!
//! // A Maxwell element pressed at unit speed for its own time bears Eτ(1 − 1/e).
//! let spring = Spectrum::new(&Relaxation { equilibrium: 0.0, terms: vec![(1.0, 1.0)], viscosity: 0.0 });
//! let load = spring.load_after(0.0, &[0.0], 1.0, 1.0);
//! assert!((load - (1.0 - (-1.0f64).exp())).abs() < 1e-15);
//! ```

use super::Spectrum;
use crate::numerics::exponential::decay;
use crate::numerics::root;

/// A part of the history with constant speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Indentation at its beginning [m].
    pub start: f64,
    /// Speed [m/s].
    pub speed: f64,
    /// Duration [s].
    pub duration: f64,
}

impl Motion {
    /// Indentation [m] at the time `t` [s] after the beginning.
    #[must_use]
    pub fn depth(&self, t: f64) -> f64 {
        self.start + self.speed * t
    }

    /// Indentation [m] at the end.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.depth(self.duration)
    }

    /// The first `duration` [s] of the motion.
    #[must_use]
    pub fn lasting(&self, duration: f64) -> Self {
        Self { duration, ..*self }
    }

    /// What is left of the motion after the time `t` [s].
    #[must_use]
    pub fn after(&self, t: f64) -> Self {
        Self { start: self.depth(t), duration: self.duration - t, ..*self }
    }
}

/// Free spring: modes zₘ at a time of reference and the displacement z₀ that stays.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Free {
    /// Displacement [m] that never recovers (flow of a liquid).
    pub rest: f64,
    /// Modes zₘ [m].
    pub modes: Vec<f64>,
}

impl Free {
    /// Whether there is nothing left to recover.
    pub(super) fn is_at_rest(&self) -> bool {
        self.modes.iter().all(|z| z.abs() <= 0.0)
    }
}

/// A spring that has been touched.
#[derive(Debug, Clone, PartialEq)]
pub enum Spring {
    /// Under the indenter, with the element loads sᵢ [N/m].
    Pressed(Vec<f64>),
    /// Not under it.
    Free(Free),
}

/// A stretch of a spring's life without an event.
#[derive(Debug)]
pub enum Piece<'a> {
    /// Pressed: it starts from `u` and `s` and moves at `speed` for `duration`.
    Pressed {
        /// Displacement [m].
        u: f64,
        /// Element loads [N/m].
        s: &'a [f64],
        /// Speed [m/s].
        speed: f64,
        /// Duration [s].
        duration: f64,
    },
    /// Free for `duration`.
    Free {
        /// State at the beginning.
        free: &'a Free,
        /// Duration [s].
        duration: f64,
    },
}

impl Spring {
    /// A spring never touched.
    #[must_use]
    pub fn untouched(spectrum: &Spectrum) -> Self {
        Self::Free(Free { rest: 0.0, modes: vec![0.0; spectrum.modes().len()] })
    }

    /// Whether it is as it was before anything touched it.
    #[must_use]
    pub fn is_untouched(&self) -> bool {
        match self {
            Self::Pressed(_) => false,
            Self::Free(free) => free.rest.abs() <= 0.0 && free.is_at_rest(),
        }
    }

    /// The spring after a motion (displacements as this spring sees them), every event at its instant.
    ///
    /// At constant speed there are at most two: touched, then released. `watch` sees every piece.
    #[must_use]
    pub fn follow(self, spectrum: &Spectrum, motion: &Motion, watch: &mut impl FnMut(&Piece<'_>)) -> Self {
        match self {
            Self::Free(mut free) => {
                let touch = spectrum.touch(&free, motion);
                let duration = touch.unwrap_or(motion.duration);
                watch(&Piece::Free { free: &free, duration });
                spectrum.recover(&mut free, duration);
                if touch.is_none() {
                    return Self::Free(free);
                }
                let mut s = vec![0.0; spectrum.terms().len()];
                spectrum.loads_of_free(&free, &mut s);
                pressed(spectrum, s, &motion.after(duration), watch)
            }
            Self::Pressed(s) => pressed(spectrum, s, motion, watch),
        }
    }
}

fn pressed(spectrum: &Spectrum, s: Vec<f64>, motion: &Motion, watch: &mut impl FnMut(&Piece<'_>)) -> Spring {
    let release = spectrum.release(motion.start, &s, motion.speed, motion.duration);
    pressed_until(spectrum, s, (motion, release), watch)
}

/// A pressed spring after a motion in which it lets go at the time `release` [s], if it does.
pub(super) fn pressed_until(
    spectrum: &Spectrum,
    mut s: Vec<f64>,
    (motion, release): (&Motion, Option<f64>),
    watch: &mut impl FnMut(&Piece<'_>),
) -> Spring {
    let (u, speed) = (motion.start, motion.speed);
    let duration = release.unwrap_or(motion.duration);
    watch(&Piece::Pressed { u, s: &s, speed, duration });
    spectrum.press(&mut s, speed, duration);
    if release.is_none() {
        return Spring::Pressed(s);
    }
    let mut free = spectrum.let_go(motion.depth(duration), &s);
    let rest = motion.duration - duration;
    watch(&Piece::Free { free: &free, duration: rest });
    spectrum.recover(&mut free, rest);
    Spring::Free(free)
}

impl Spectrum {
    /// Line load q [N/m] of a pressed spring with displacement `u`, element loads `s`, speed `v`.
    pub fn load(&self, u: f64, s: &[f64], v: f64) -> f64 {
        self.equilibrium() * u + s.iter().sum::<f64>() + self.viscosity() * v
    }

    /// Line load q [N/m] of a pressed spring after the time `t` of a motion at the speed `v`.
    pub fn load_after(&self, u: f64, s: &[f64], v: f64, t: f64) -> f64 {
        self.load_faded((u, s, v), t, self.decays(t))
    }

    /// Of each term, what the time `t` leaves of its load, and what it loses.
    pub(super) fn decays(&self, t: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.terms().iter().map(move |term| decay(t / term.time))
    }

    /// [`load_after`](Self::load_after) with the `decays` of that time.
    pub(super) fn load_faded(
        &self,
        (u, s, v): (f64, &[f64], f64),
        t: f64,
        decays: impl Iterator<Item = (f64, f64)>,
    ) -> f64 {
        let moved = |((term, s), (kept, lost)): ((&super::Element, &f64), (f64, f64))| {
            kept * s + term.modulus * v * term.time * lost
        };
        let elements: f64 = self.terms().iter().zip(s).zip(decays).map(moved).sum();
        self.equilibrium() * (u + v * t) + elements + self.viscosity() * v
    }

    /// Element loads after the time `t` of a motion at the speed `v`, in place.
    pub fn press(&self, s: &mut [f64], v: f64, t: f64) {
        for (term, s) in self.terms().iter().zip(s) {
            let (kept, lost) = decay(t / term.time);
            *s = kept * *s + term.modulus * v * term.time * lost;
        }
    }

    /// q̇ [N/(m s)] of a pressed spring after the time `t` of a motion at the speed `v`.
    pub(super) fn load_rate(&self, s: &[f64], v: f64, t: f64) -> f64 {
        self.rate_faded((s, v), self.decays(t))
    }

    /// [`load_rate`](Self::load_rate) with the `decays` of that time.
    pub(super) fn rate_faded(&self, (s, v): (&[f64], f64), decays: impl Iterator<Item = (f64, f64)>) -> f64 {
        let fading =
            |((term, s), (kept, _)): ((&super::Element, &f64), (f64, f64))| (term.modulus * v - s / term.time) * kept;
        self.equilibrium() * v + self.terms().iter().zip(s).zip(decays).map(fading).sum::<f64>()
    }

    /// When a pressed spring at the displacement `u` lets go within `duration`; `None` if it does not.
    pub fn release(&self, u: f64, s: &[f64], v: f64, duration: f64) -> Option<f64> {
        self.release_near((u, s, v), duration, 0.0)
    }

    /// [`release`](Self::release), which is looked for from the time `near` [s] on: that of a neighbour is not far.
    pub(super) fn release_near(&self, (u, s, v): (f64, &[f64], f64), duration: f64, near: f64) -> Option<f64> {
        let load = |t: f64| self.load_after(u, s, v, t);
        let end = if v < 0.0 { load(duration) } else { 0.0 };
        if end >= 0.0 {
            return None;
        }
        let crossing = |low: f64| Some(self.crossing((u, s, v), (low, duration), near));
        if self.load(u, s, v) > 0.0 {
            return crossing(0.0);
        }
        // Pressed since this very instant: its load rises from zero before it falls.
        match (1..60).map(|k| duration * 0.5f64.powi(k)).find(|&t| load(t) > 0.0) {
            Some(pressed) => crossing(pressed),
            None => Some(0.0),
        }
    }

    /// The only root of q between a time when it is positive and one when it is negative: Newton's
    /// method from `near` on, halving the bracket whenever it would leave it or is slow.
    fn crossing(&self, (u, s, v): (f64, &[f64], f64), (mut low, mut high): (f64, f64), near: f64) -> f64 {
        let mut t = if low < near && near < high { near } else { low };
        let mut narrow = high - low;
        for trial in 0..200 {
            let q = self.load_after(u, s, v, t);
            *(if q > 0.0 { &mut low } else { &mut high }) = t;
            let mut next = t - q / self.load_rate(s, v, t);
            let slow = trial % 4 == 3 && high - low > 0.5 * narrow;
            if slow || !(low < next && next < high) {
                next = 0.5 * (low + high);
            }
            if trial % 4 == 3 {
                narrow = high - low;
            }
            if (next - t).abs() <= 2.0 * f64::EPSILON * t.abs() || q.abs() <= 0.0 {
                return t;
            }
            t = next;
        }
        t
    }

    /// A spring let go at the displacement `u`, where its elements carry `s` and it carries no load.
    #[must_use]
    pub fn let_go(&self, u: f64, s: &[f64]) -> Free {
        let constant = self.equilibrium() * u;
        let stretched = |((term, s), gap): ((&super::Element, &f64), &f64)| term.time * s * gap;
        let sum = |mode: &super::Mode| self.terms().iter().zip(s).zip(&mode.inverse_gaps).map(stretched).sum::<f64>();
        let modes: Vec<f64> = self.modes().iter().map(|mode| mode.compliance * (constant - sum(mode))).collect();
        Free { rest: u - modes.iter().sum::<f64>(), modes }
    }

    /// Of each mode, what the time `t` leaves of it.
    pub(super) fn fadings(&self, t: f64) -> impl Iterator<Item = f64> + '_ {
        self.modes().iter().map(move |mode| (-t / mode.time).exp())
    }

    /// Displacement u [m] of a free spring after the time `t`.
    pub fn recovered(&self, free: &Free, t: f64) -> f64 {
        if free.is_at_rest() { free.rest } else { self.recovered_faded(free, self.fadings(t)) }
    }

    /// [`recovered`](Self::recovered) with the `fadings` of that time.
    pub(super) fn recovered_faded(&self, free: &Free, fadings: impl Iterator<Item = f64>) -> f64 {
        free.rest + free.modes.iter().zip(fadings).map(|(z, kept)| z * kept).sum::<f64>()
    }

    /// Speed u̇ [m/s] of a free spring after the time `t`.
    pub fn recovery_speed(&self, free: &Free, t: f64) -> f64 {
        if free.is_at_rest() { 0.0 } else { self.speed_faded(free, self.fadings(t)) }
    }

    /// [`recovery_speed`](Self::recovery_speed) with the `fadings` of that time.
    pub(super) fn speed_faded(&self, free: &Free, fadings: impl Iterator<Item = f64>) -> f64 {
        let part = |((mode, z), kept): ((&super::Mode, &f64), f64)| -z / mode.time * kept;
        self.modes().iter().zip(&free.modes).zip(fadings).map(part).sum()
    }

    /// The modes of a free spring after the time `t`, in place.
    pub fn recover(&self, free: &mut Free, t: f64) {
        if free.is_at_rest() {
            return;
        }
        for (mode, z) in self.modes().iter().zip(&mut free.modes) {
            *z *= (-t / mode.time).exp();
        }
    }

    /// Element loads of a free spring: what a pressed one starts from.
    pub fn loads_of_free(&self, free: &Free, s: &mut [f64]) {
        if free.is_at_rest() {
            s.fill(0.0);
            return;
        }
        for (i, (term, s)) in self.terms().iter().zip(s).enumerate() {
            let part = |(mode, z): (&super::Mode, &f64)| z * mode.inverse_gaps[i];
            *s = -term.modulus * term.time * self.modes().iter().zip(&free.modes).map(part).sum::<f64>();
        }
    }

    /// When the indenter, at the displacement `motion.start` above this spring, catches up with it.
    pub fn touch(&self, free: &Free, motion: &Motion) -> Option<f64> {
        let gap = |t: f64| self.recovered(free, t) - motion.depth(t);
        if gap(0.0) <= 0.0 {
            return (self.recovery_speed(free, 0.0) < motion.speed).then_some(0.0);
        }
        if free.is_at_rest() {
            let time = (free.rest - motion.start) / motion.speed;
            return (motion.speed > 0.0 && time <= motion.duration).then_some(time);
        }
        if gap(motion.duration) <= 0.0 {
            return root::brent(gap, 0.0, motion.duration).ok();
        }
        if motion.speed >= 0.0 {
            return None;
        }
        // The gap is convex: where it is least it may have closed for a while.
        let least = self.narrowest(free, motion);
        if gap(least) <= 0.0 { root::brent(gap, 0.0, least).ok() } else { None }
    }

    /// The time in the motion at which a free spring is nearest to the indenter.
    pub fn narrowest(&self, free: &Free, motion: &Motion) -> f64 {
        let opening = |t: f64| self.recovery_speed(free, t) - motion.speed;
        if opening(0.0) >= 0.0 {
            return 0.0;
        }
        if opening(motion.duration) <= 0.0 {
            return motion.duration;
        }
        root::brent(opening, 0.0, motion.duration).unwrap_or(0.0)
    }
}
