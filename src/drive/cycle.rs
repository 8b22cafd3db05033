//! Storage and loss from the loop of an oscillation.

use super::chords::Chords;
use super::force::ahead;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Glance};
use crate::contact::state::Normal;
use std::f64::consts::TAU;

/// What the loop of an oscillation says of the material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loop {
    /// Frequency [Hz].
    pub frequency: f64,
    /// Storage modulus [Pa]: in-phase stiffness over twice the mean contact radius.
    pub storage: f64,
    /// Loss modulus [Pa].
    pub loss: f64,
    /// Largest less smallest contact radius of the loop, relative to the mean.
    pub swing: f64,
}

/// The first harmonics of force and depth over the last cycle, taken along the chords themselves: the
/// ratio of the two does not know that the path has corners.
#[derive(Debug, Clone, Copy, Default)]
pub struct Cycle {
    frequency: f64,
    /// ∫ F e^(iωt) dt, ∫ d e^(iωt) dt, as sine and cosine parts.
    force: [f64; 2],
    depth: [f64; 2],
    /// ∫ a dt and ∫ dt.
    radius: f64,
    /// Smallest and largest contact radius [m].
    radii: (f64, f64),
    time: f64,
    /// Force at the beginning and the end: what drifts is not part of the loop.
    ends: (f64, f64),
}

impl Cycle {
    /// Adds the chord of `duration` [s] at the speed `speed` [m/s] that lies ahead of the state `start`, and at whose end the
    /// contact is `end`, if it belongs to the last cycle: by Simpson's rule.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn watch(
        &mut self,
        contact: &mut dyn ContactModel,
        start: &Normal,
        chords: &Chords,
        (speed, duration, end): (f64, f64, Glance),
    ) -> Result<(), ContactError> {
        let Some((since, first)) = chords.in_last_cycle() else { return Ok(()) };
        if first {
            *self = Self {
                frequency: chords.frequency(),
                ends: (start.force, 0.0),
                radii: (f64::INFINITY, 0.0),
                ..Self::default()
            };
        }
        let here = Glance { force: start.force, contact_radius: start.contact_radius.unwrap_or(0.0) };
        let middle = contact.look(&ahead(contact, speed, 0.5 * duration))?;
        for (part, weight, seen) in [(0.0, 1.0, here), (0.5, 4.0, middle), (1.0, 1.0, end)] {
            let time = part * duration;
            let depth = start.indentation.unwrap_or(0.0) + speed * time;
            self.add((since + time, weight / 6.0 * duration), depth, &seen);
        }
        self.ends.1 = end.force;
        Ok(())
    }

    fn add(&mut self, (time, weight): (f64, f64), depth: f64, seen: &Glance) {
        let radius = seen.contact_radius;
        let (sine, cosine) = (TAU * self.frequency * time).sin_cos();
        for (k, wave) in [sine, cosine].into_iter().enumerate() {
            self.force[k] += weight * wave * seen.force;
            self.depth[k] += weight * wave * depth;
        }
        self.radii = (self.radii.0.min(radius), self.radii.1.max(radius));
        self.radius += weight * radius;
        self.time += weight;
    }

    /// The last whole loop: the complex stiffness over twice the mean contact radius.
    pub fn moduli(&self) -> Option<Loop> {
        if self.time * self.frequency < 1.0 - 1e-9 || self.radius <= 0.0 {
            return None;
        }
        // ∫ t sin ωt dt over a cycle is −T²/2π: the part of a straight drift.
        let drift = (self.ends.1 - self.ends.0) / self.time * self.time * self.time / TAU;
        let ([f1, f2], [d1, d2]) = ([self.force[0] + drift, self.force[1]], self.depth);
        let (square, mean) = (d1 * d1 + d2 * d2, self.radius / self.time);
        Some(Loop {
            frequency: self.frequency,
            storage: (f1 * d1 + f2 * d2) / square / (2.0 * mean),
            loss: (f2 * d1 - f1 * d2) / square / (2.0 * mean),
            swing: (self.radii.1 - self.radii.0) / mean,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// F = 3 sin ωt + 2 cos ωt + a drift, d = sin ωt: storage 3/2a, loss 2/2a.
    #[test]
    fn a_drift_is_no_loss() {
        let mut cycle = Cycle { frequency: 0.5, ends: (0.0, 1.0), ..Cycle::default() };
        for k in 0..2000 {
            let t = (f64::from(k) + 0.5) * 1e-3;
            let (sine, cosine) = (PI * t).sin_cos();
            let seen = Glance { force: 3.0 * sine + 2.0 * cosine + 0.5 * t, contact_radius: 0.25 };
            cycle.add((t, 1e-3), sine, &seen);
        }
        let Loop { storage, loss, .. } = cycle.moduli().unwrap();
        assert!((storage - 6.0).abs() < 1e-5 && (loss - 4.0).abs() < 1e-5, "{storage} {loss}");
    }
}
