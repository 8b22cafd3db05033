//! What a spring has been through, added up.

use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::ledger::Ledger;
use crate::contact::viscoelastic::spring::Piece;

/// Sums over the way of one spring, per unit length of the bed.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Tally {
    /// ∫ f dt [N s/m].
    pub impulse: f64,
    /// Work ∫ f du done on it [J/m].
    pub work: f64,
    /// Energy turned into heat [J/m], a sum of positive terms.
    pub heat: f64,
    /// Time that has passed [s].
    pub time: f64,
    /// When it was first touched [s].
    pub touched: Option<f64>,
    /// When it was last let go, or is still pressed [s].
    pub released: Option<f64>,
}

impl Tally {
    /// Adds a piece with its impulse, work and heat.
    pub fn pressed(&mut self, duration: f64, (impulse, work, heat): (f64, f64, f64)) {
        self.touched = self.touched.or(Some(self.time));
        self.time += duration;
        self.released = Some(self.time);
        self.impulse += impulse;
        self.work += work;
        self.heat += heat;
    }

    /// Adds a piece of recovery with its heat.
    pub fn free(&mut self, duration: f64, heat: f64) {
        self.time += duration;
        self.heat += heat;
    }

    /// Adds a piece of whatever kind.
    pub fn note(&mut self, spectrum: &Spectrum, piece: &Piece<'_>) {
        let mut ledger = Ledger::default();
        spectrum.account(piece, &mut ledger);
        match *piece {
            Piece::Pressed { duration, .. } => {
                self.pressed(duration, (spectrum.impulse(piece), ledger.work, ledger.dissipated));
            }
            Piece::Free { duration, .. } => self.free(duration, ledger.dissipated),
        }
    }
}
