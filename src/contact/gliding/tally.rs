//! What a spring has been through, added up.

use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::ledger::{Ledger, impulse};
use crate::contact::viscoelastic::spring::Piece;
use crate::numerics::exponential::decay;

/// Sums over the way of one spring, per unit length of the bed.
#[derive(Debug, Clone, Default)]
pub(super) struct Tally {
    /// ∫ f dt [N s/m].
    pub impulse: f64,
    /// Work ∫ f du done on it [J/m].
    pub work: f64,
    /// Energy turned into heat [J/m], a sum of positive terms.
    pub heat: f64,
    /// Time for which it was pressed [s].
    pub pressed: f64,
    /// ∫ u̇² dt [m²/s] over that time.
    pub squares: f64,
    /// Time that has passed [s].
    pub time: f64,
    /// When it was first touched [s].
    pub touched: Option<f64>,
    /// When it was last let go, or is still pressed [s].
    pub released: Option<f64>,
    /// What a spring needs that is to come back to where it was.
    pub diary: Option<Diary>,
}

/// A stretch of the life of a spring, with its duration [s].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Episode {
    /// Under the profile.
    Pressed(f64),
    /// Not under it.
    Free(f64),
}

/// When a spring was pressed and when it was free, and what its elements have carried.
#[derive(Debug, Clone, Default)]
pub(super) struct Diary {
    pub episodes: Vec<Episode>,
    /// ∫ sᵢ dt while it was pressed [N s/m].
    loads: Vec<f64>,
    /// ∫ zₘ dt while it was free [m s].
    modes: Vec<f64>,
}

impl Diary {
    pub fn of(spectrum: &Spectrum) -> Self {
        let (loads, modes) = (vec![0.0; spectrum.terms().len()], vec![0.0; spectrum.modes().len()]);
        Self { episodes: Vec::new(), loads, modes }
    }

    /// ∫ sᵢ dt [N s/m] over all.
    pub fn integrals(&self, spectrum: &Spectrum) -> Vec<f64> {
        let free = |i: usize| {
            let parts = spectrum.modes().iter().zip(&self.modes).map(|(mode, z)| z * mode.inverse_gaps[i]);
            parts.sum::<f64>()
        };
        let terms = spectrum.terms().iter().zip(&self.loads).enumerate();
        terms.map(|(i, (term, pressed))| pressed - term.modulus * term.time * free(i)).collect()
    }

    /// Adds to the integral of the load of element `element`.
    pub fn load(&mut self, element: usize, integral: f64) {
        self.loads[element] += integral;
    }

    /// Adds to the integral of mode `mode`.
    pub fn mode(&mut self, mode: usize, integral: f64) {
        self.modes[mode] += integral;
    }

    fn pressed(&mut self, more: f64) {
        match self.episodes.last_mut() {
            Some(Episode::Pressed(duration)) => *duration += more,
            Some(Episode::Free(_)) | None => self.episodes.push(Episode::Pressed(more)),
        }
    }

    fn free(&mut self, more: f64) {
        match self.episodes.last_mut() {
            Some(Episode::Free(duration)) => *duration += more,
            Some(Episode::Pressed(_)) | None => self.episodes.push(Episode::Free(more)),
        }
    }

    fn note(&mut self, spectrum: &Spectrum, piece: &Piece<'_>) {
        match *piece {
            Piece::Pressed { s, speed, duration, .. } => {
                for (i, (term, s)) in spectrum.terms().iter().zip(s).enumerate() {
                    self.load(i, impulse(term, *s, speed, duration));
                }
            }
            Piece::Free { free, duration } => {
                for (m, (mode, z)) in spectrum.modes().iter().zip(&free.modes).enumerate() {
                    self.mode(m, mode.time * decay(duration / mode.time).1 * z);
                }
            }
        }
    }
}

impl Tally {
    /// Adds a piece at the speed u̇ with its impulse and heat.
    pub fn press(&mut self, (speed, duration): (f64, f64), (impulse, heat): (f64, f64)) {
        self.touched = self.touched.or(Some(self.time));
        if let Some(diary) = &mut self.diary {
            diary.pressed(duration);
        }
        self.time += duration;
        self.released = Some(self.time);
        self.impulse += impulse;
        self.pressed += duration;
        self.squares += speed * speed * duration;
        self.work += speed * impulse;
        self.heat += heat;
    }

    /// Root mean square of u̇ [m/s] while it was pressed.
    pub fn rms_speed(&self) -> Option<f64> {
        (self.pressed > 0.0).then(|| (self.squares / self.pressed).sqrt())
    }

    /// Adds a piece of recovery with its heat.
    pub fn free(&mut self, duration: f64, heat: f64) {
        if let Some(diary) = &mut self.diary {
            diary.free(duration);
        }
        self.time += duration;
        self.heat += heat;
    }

    /// Adds a piece of whatever kind.
    pub fn note(&mut self, spectrum: &Spectrum, piece: &Piece<'_>) {
        let mut ledger = Ledger::default();
        spectrum.account(piece, &mut ledger);
        if let Some(diary) = &mut self.diary {
            diary.note(spectrum, piece);
        }
        match *piece {
            Piece::Pressed { speed, duration, .. } => {
                self.press((speed, duration), (spectrum.impulse(piece), ledger.dissipated));
            }
            Piece::Free { duration, .. } => self.free(duration, ledger.dissipated),
        }
    }
}
