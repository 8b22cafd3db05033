//! A sine cut into chords.

use super::course::Wave;
use std::f64::consts::TAU;

/// Chords of d₀ + A sin 2πft; their ends do not depend on the records.
///
/// A chord over the angle α leaves its arc by A(1 − cos(α/2)) ≈ Aα²/8.
#[derive(Debug, Clone, Copy)]
pub struct Chords {
    center: f64,
    wave: Wave,
    /// End of the stage [s].
    end: f64,
    per_cycle: f64,
    next: f64,
}

/// A time is at a corner that is nearer than this part of a chord.
const SAME: f64 = 1e-9;
/// Depth, in amplitudes, from which on it is of no account: the loop of a small amplitude is resolved too.
const SMALL: f64 = 50.0;
/// Fewest chords per cycle.
const FEWEST: f64 = 16.0;
/// Most chords per cycle.
const MOST: f64 = 16384.0;

impl Chords {
    /// Chords that leave the sine by at most `accuracy` of the depth, and by fifty times that of the amplitude.
    pub fn new(center: f64, wave: Wave, end: f64, accuracy: f64) -> Self {
        let angle = (8.0 * accuracy * (center.abs() / wave.amplitude).clamp(1.0, SMALL)).sqrt();
        let per_cycle = 4.0 * (0.25 * (TAU / angle).clamp(FEWEST, MOST)).ceil();
        Self { center, wave, end, per_cycle, next: 1.0 }
    }

    /// Frequency [Hz].
    pub fn frequency(&self) -> f64 {
        self.wave.frequency
    }

    /// The value at the time `t` [s], on the chord there.
    pub fn at(&self, t: f64) -> f64 {
        let width = self.width();
        let corner = (t / width + SAME).floor();
        let (from, to) = (self.wave.at(corner * width), self.wave.at((corner + 1.0) * width));
        self.center + from + (t / width - corner) * (to - from)
    }

    /// The time [s] of the next corner after the time `t` [s].
    pub fn next_corner(&self, t: f64) -> f64 {
        ((t / self.width() + SAME).floor() + 1.0) * self.width()
    }

    /// The speed [m/s] of the chord that goes up to the time `t` [s], or beyond it.
    pub fn speed_until(&self, t: f64) -> f64 {
        let width = self.width();
        let corner = ((t / width - SAME).ceil() - 1.0).max(0.0);
        (self.wave.at((corner + 1.0) * width) - self.wave.at(corner * width)) / width
    }

    /// Duration of a chord [s].
    fn width(&self) -> f64 {
        (self.per_cycle * self.wave.frequency).recip()
    }

    /// The time since the beginning of the last whole cycle at which the chord handed out last begins, and
    /// whether it is the first of them; `None` before.
    pub fn in_last_cycle(&self) -> Option<(f64, bool)> {
        let all = self.end * self.wave.frequency * self.per_cycle;
        let first = ((all + 1e-6).floor() - self.per_cycle).max(0.0);
        let this = self.next - 2.0;
        let inside = this >= first && this < first + self.per_cycle && first + self.per_cycle <= all + 1e-6;
        inside.then(|| ((this - first) / (self.per_cycle * self.wave.frequency), this <= first))
    }
}

impl Iterator for Chords {
    type Item = (f64, f64);

    /// Depth [m] and time [s] of the end of the next chord.
    fn next(&mut self) -> Option<(f64, f64)> {
        let width = 1.0 / (self.per_cycle * self.wave.frequency);
        let since = (self.next - 1.0) * width;
        if since >= self.end * (1.0 - 1e-12) {
            return None;
        }
        let until = self.next * width;
        let until = if until >= self.end * (1.0 - 1e-12) { self.end } else { until };
        self.next += 1.0;
        Some((self.center + self.wave.at(until), until))
    }
}
