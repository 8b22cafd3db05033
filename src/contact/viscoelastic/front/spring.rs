//! Springs at the edge, and the instants at which they join or leave.

use super::super::Spectrum;
use super::super::spring::{Motion, Spring};
use super::Front;
use crate::numerics::{extremum, root};

/// A spring that may join or leave, as it is when the motion begins.
pub(super) struct EdgeSpring {
    pub(super) spring: Spring,
    pub(super) doubt: f64,
    /// The motion as it sees it.
    pub(super) seen: Motion,
    /// The lengths [m] of which its displacement is the difference.
    pub(super) lengths: f64,
    /// Line load [N/m] it withstands, or the distance [m] over which it is drawn.
    pub(super) limit: f64,
}

/// A time of a motion, and what the terms and modes of the spectrum have lost until then: the same of all springs.
pub(in super::super) struct Instant {
    /// Time since the beginning of the motion [s].
    time: f64,
    decays: Vec<(f64, f64)>,
    fadings: Vec<f64>,
}

impl Instant {
    pub(super) fn at(spectrum: &Spectrum, time: f64) -> Self {
        Self { time, decays: spectrum.decays(time).collect(), fadings: spectrum.fadings(time).collect() }
    }
}

/// Rounding of a limit, relative to what it is made of.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Times between which no spring's load changes much: halved from the end of a motion to well below the shortest
/// time in which a spring changes by itself.
pub(in super::super) fn instants(spectrum: &Spectrum, duration: f64) -> Vec<Instant> {
    let shortest = spectrum.modes().first().map_or(f64::INFINITY, |mode| mode.time).min(spectrum.shortest_time());
    let least = (0.125 * shortest).clamp(1e-18 * duration, 0.25 * duration);
    let mut times = vec![duration, 0.75 * duration];
    while times.last().is_some_and(|&t| t > least) {
        let half = 0.5 * times[times.len() - 2];
        times.push(half);
        times.push(0.75 * half);
    }
    times.pop();
    times.push(0.0);
    times.reverse();
    times.into_iter().map(|time| Instant::at(spectrum, time)).collect()
}

impl EdgeSpring {
    /// How far beyond its limit the spring is after the time `t`: positive once it has joined or left.
    pub(super) fn urge(&self, spectrum: &Spectrum, t: f64) -> f64 {
        match &self.spring {
            Spring::Pressed(s) => -spectrum.load_after(self.seen.start, s, self.seen.speed, t) - self.limit,
            Spring::Free(free) => self.seen.depth(t) - spectrum.recovered(free, t) + self.limit,
        }
    }

    /// The same at an instant whose decays are known.
    pub(super) fn urge_then(&self, spectrum: &Spectrum, at: &Instant) -> f64 {
        match &self.spring {
            Spring::Pressed(s) => {
                let decays = at.decays.iter().copied();
                -spectrum.load_faded((self.seen.start, s, self.seen.speed), at.time, decays) - self.limit
            }
            Spring::Free(free) => {
                let recovered = spectrum.recovered_faded(free, at.fadings.iter().copied());
                self.seen.depth(at.time) - recovered + self.limit
            }
        }
    }

    /// How fast it grows at an instant whose decays are known.
    fn rate_then(&self, spectrum: &Spectrum, at: &Instant) -> f64 {
        match &self.spring {
            Spring::Pressed(s) => -spectrum.rate_faded((s, self.seen.speed), at.decays.iter().copied()),
            Spring::Free(free) => self.seen.speed - spectrum.speed_faded(free, at.fadings.iter().copied()),
        }
    }

    /// How fast that grows.
    pub(super) fn urge_rate(&self, spectrum: &Spectrum, t: f64) -> f64 {
        match &self.spring {
            Spring::Pressed(s) => -spectrum.load_rate(s, self.seen.speed, t),
            Spring::Free(free) => self.seen.speed - spectrum.recovery_speed(free, t),
        }
    }

    /// What rounding leaves of it, and the doubt about the spring.
    pub(super) fn rounding(&self, spectrum: &Spectrum) -> f64 {
        self.own_rounding(spectrum) + self.doubt
    }

    /// What rounding leaves of it, the spring taken as it is told.
    pub(super) fn own_rounding(&self, spectrum: &Spectrum) -> f64 {
        let parts = match &self.spring {
            Spring::Pressed(s) => {
                let steady = spectrum.equilibrium() * self.lengths + (spectrum.viscosity() * self.seen.speed).abs();
                steady + s.iter().map(|s| s.abs()).sum::<f64>()
            }
            Spring::Free(free) => self.lengths + free.rest.abs() + free.modes.iter().map(|z| z.abs()).sum::<f64>(),
        };
        ROUNDING * (parts + self.limit)
    }
}

impl Front<'_> {
    /// The first time at which a spring is beyond its limit [s].
    pub(super) fn first(&self, candidate: &EdgeSpring) -> Option<f64> {
        if candidate.urge(self.spectrum, 0.0) >= 0.0 {
            return Some(0.0);
        }
        self.crossing(candidate, 0.0)
    }

    /// The first time at which the urge of a spring rises through `level` [s].
    pub(super) fn crossing(&self, candidate: &EdgeSpring, level: f64) -> Option<f64> {
        let urge = |t: f64| candidate.urge(self.spectrum, t) - level;
        let rate = |t: f64| candidate.urge_rate(self.spectrum, t);
        if let Spring::Free(free) = &candidate.spring
            && free.is_at_rest()
        {
            // Straight towards a spring that stands still.
            let at = -urge(0.0) / candidate.seen.speed;
            return (0.0..=self.motion.duration).contains(&at).then_some(at);
        }
        let (mut before, mut rising) = (0.0, rate(0.0) > 0.0);
        for at in &self.instants[1..] {
            let t = at.time;
            if candidate.urge_then(self.spectrum, at) - level >= 0.0 {
                return Some(root::within(urge, before, t));
            }
            let rises = candidate.rate_then(self.spectrum, at) > 0.0;
            if rising && !rises {
                // A top between the two: the limit may be reached there and only there.
                let top = root::brent(rate, before, t).unwrap_or(t);
                if urge(top) >= 0.0 {
                    return Some(root::within(urge, before, top));
                }
            }
            (before, rising) = (t, rises);
        }
        None
    }

    /// The greatest urge of a spring, and when [s].
    pub(super) fn top(&self, candidate: &EdgeSpring) -> extremum::Peak {
        let urge = |t: f64| candidate.urge(self.spectrum, t);
        let rate = |t: f64| candidate.urge_rate(self.spectrum, t);
        let at = |t: f64| extremum::Peak { place: t, value: urge(t) };
        let (mut best, mut before) = (at(0.0), (0.0, rate(0.0)));
        for instant in &self.instants[1..] {
            let t = instant.time;
            let now = (t, candidate.rate_then(self.spectrum, instant));
            if before.1 > 0.0 && now.1 <= 0.0 {
                best = best.max(at(root::brent(rate, before.0, t).unwrap_or(t)));
            }
            best = best.max(extremum::Peak { place: t, value: candidate.urge_then(self.spectrum, instant) });
            before = now;
        }
        best
    }
}
