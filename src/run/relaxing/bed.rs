//! What a simulation reads off a viscoelastic bed.

use crate::contact::viscoelastic::drive::{Bed, Springs};
use crate::contact::viscoelastic::memory::{BedError, Memory};

/// A bed with fields, an error and a size.
pub trait ReadBed: Bed {
    /// Pressure at the radius r [Pa].
    fn pressure(&self, r: f64) -> f64;

    /// Surface displacement at the radius r [m].
    fn surface(&self, r: f64) -> f64;

    /// Error of the force [N], where the bed can tell.
    fn force_error(&self) -> Option<f64>;

    /// When a motion parts the bodies by the attraction giving way [s].
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    fn parting(&self, speed: f64, duration: f64) -> Result<Option<f64>, BedError>;

    /// Takes the indenter away, however it is held.
    fn leave(&mut self);

    /// Bytes of state.
    fn bytes(&self) -> usize;

    /// Number of springs.
    fn springs(&self) -> usize;
}

impl ReadBed for Memory {
    fn pressure(&self, r: f64) -> f64 {
        Self::pressure(self, r)
    }

    fn surface(&self, r: f64) -> f64 {
        Self::surface(self, r)
    }

    fn force_error(&self) -> Option<f64> {
        Some(Self::force_error(self))
    }

    fn parting(&self, speed: f64, duration: f64) -> Result<Option<f64>, BedError> {
        Self::parting(self, speed, duration)
    }

    fn leave(&mut self) {
        Self::leave(self);
    }

    fn bytes(&self) -> usize {
        Self::bytes(self)
    }

    fn springs(&self) -> usize {
        0
    }
}

impl ReadBed for Springs {
    fn pressure(&self, r: f64) -> f64 {
        Self::pressure(self, r)
    }

    fn surface(&self, r: f64) -> f64 {
        Self::surface(self, r)
    }

    fn force_error(&self) -> Option<f64> {
        None
    }

    fn parting(&self, _speed: f64, _duration: f64) -> Result<Option<f64>, BedError> {
        Ok(None)
    }

    fn leave(&mut self) {
        let (away, instant) = (self.state().indentation.min(0.0) - 1.0, self.spectrum().instant());
        // Away from the surface no profile ends.
        let _ = self.reach(away, instant);
    }

    fn bytes(&self) -> usize {
        self.bed().bytes()
    }

    fn springs(&self) -> usize {
        self.bed().layout().len()
    }
}
