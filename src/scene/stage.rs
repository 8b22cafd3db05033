//! A history as a row of stages: what is prescribed, from when to when, and where records stand.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::equilibrium::Control;
//! use springbed::scene::stage::{Path, Stage, Wave};
//!
//! // Records stand at equal times, and where a wave turns.
//! let wave = Path::Wave(Wave { amplitude: 1e-9, frequency: 1.0 });
//! let stage = Stage { normal: wave, over: 1.0, ..Stage::rest(0, 2) };
//! assert_eq!(stage.parts(), [0.25, 0.5, 0.75, 1.0]);
//! assert!(stage.is_curved() && stage.control == Some(Control::Indentation) && stage.force().is_none());
//! ```

use crate::contact::adhesion::equilibrium::Control;
pub use crate::drive::course::{Extent, Path, Wave};

/// A part of the history in which everything moves along one path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stage {
    /// Number of the history entry.
    pub entry: usize,
    /// What is prescribed; `None` keeps what was prescribed before.
    pub control: Option<Control>,
    /// How it moves.
    pub normal: Path,
    /// How the tangential displacement moves.
    pub tangential: Path,
    /// Duration [s]; not known beforehand for a retraction.
    pub over: f64,
    /// Number of records.
    pub records: usize,
    /// Where they stand.
    pub spacing: Spaced,
    /// How much of the history it is.
    pub extent: Extent,
}

/// Where the records of a stage stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spaced {
    /// At equal times.
    Evenly,
    /// At equal steps of ln(1 + t/t₀): evenly up to the time t₀ = `from` [s] in the stage, by equal ratios beyond.
    ByDecades {
        /// t₀ [s].
        from: f64,
    },
}

impl Spaced {
    /// The part of a stage of the duration `over` [s] that has passed at the part `count` of its records.
    ///
    /// t = t₀((1 + T/t₀)^c − 1). Check: T/t₀ = 99 and half of the records are at 9/99 of the stage.
    #[must_use]
    pub fn part(self, count: f64, over: f64) -> f64 {
        match self {
            Self::Evenly => count,
            Self::ByDecades { from } => (count * (over / from).ln_1p()).exp_m1() * (from / over),
        }
    }
}

/// Two records closer than this part of a stage are one.
const SAME: f64 = 1e-12;

impl Stage {
    /// A stage of the entry `entry` in which the depth stays and no time passes.
    #[must_use]
    pub fn rest(entry: usize, records: usize) -> Self {
        let (normal, tangential) = (Path::Stay, Path::Stay);
        Self {
            entry,
            control: Some(Control::Indentation),
            normal,
            tangential,
            over: 0.0,
            records,
            spacing: Spaced::Evenly,
            extent: Extent::Entry,
        }
    }

    /// Whether depth or slide is a curve in time: under a prescribed force, and in a wave.
    #[must_use]
    pub fn is_curved(&self) -> bool {
        self.control == Some(Control::Force) || self.normal.is_wave() || self.tangential.is_wave()
    }

    /// The force it goes to [N], where one is prescribed.
    #[must_use]
    pub fn force(&self) -> Option<f64> {
        match (self.control?, self.normal) {
            (Control::Force, Path::To(force)) => Some(force),
            (Control::Force, Path::Stay | Path::Steady { .. } | Path::Wave(_) | Path::UntilParted { .. })
            | (Control::Indentation, _) => None,
        }
    }

    /// The tangential displacement it slides to in one way [m].
    #[must_use]
    pub fn slide(&self) -> Option<f64> {
        match self.tangential {
            Path::To(slide) => Some(slide),
            Path::Stay | Path::Steady { .. } | Path::Wave(_) | Path::UntilParted { .. } => None,
        }
    }

    /// The time of the first record that is asked for [s].
    #[must_use]
    pub fn first(&self) -> f64 {
        self.over * self.spacing.part((self.records.max(1) as f64).recip(), self.over)
    }

    /// The parts of the stage, up to 1, at which records stand: those asked for, and where a path turns.
    #[must_use]
    pub fn parts(&self) -> Vec<f64> {
        let part = |k: usize| self.spacing.part(k as f64 / self.records as f64, self.over);
        let even = (1..=self.records).map(|k| if k == self.records { 1.0 } else { part(k) });
        let mut parts: Vec<f64> = self.tangential.turns(self.over);
        parts.extend(self.normal.turns(self.over));
        parts.extend(even);
        parts.sort_by(f64::total_cmp);
        // The end stays as it is, and of two others the first.
        let near = |kept: f64| if self.spacing == Spaced::Evenly { SAME } else { SAME * kept };
        parts.dedup_by(|next, kept| *next < 1.0 && *next - *kept < near(*kept));
        parts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_have_equal_ratios_and_their_beginning_equal_steps() {
        let stage = Stage { over: 1e6, spacing: Spaced::ByDecades { from: 1e-3 }, ..Stage::rest(0, 90) };
        let parts = stage.parts();
        assert!(parts.len() == 90 && parts[89] >= 1.0 && parts.is_sorted());
        assert!((stage.first() / 1e6 / parts[0] - 1.0).abs() < 1e-12);
        // Nine decades in ninety steps: each is a tenth of a decade of t₀ + t.
        let since = |k: usize| 1e-3 + 1e6 * parts[k];
        assert!((2..89).all(|k| ((since(k) / since(k - 1)).log10() - 0.1).abs() < 1e-8));
        // Decades below what is one at equal times are there too.
        let long = Stage { over: 1e6, spacing: Spaced::ByDecades { from: 1e-12 }, ..Stage::rest(0, 180) };
        assert_eq!(long.parts().len(), 180);
        // A stage short against t₀ is even.
        let short = Stage { over: 1e-9, spacing: Spaced::ByDecades { from: 1.0 }, ..Stage::rest(0, 4) };
        assert!(short.parts().iter().zip([0.25, 0.5, 0.75, 1.0]).all(|(part, even)| (part - even).abs() < 1e-9));
    }
}
