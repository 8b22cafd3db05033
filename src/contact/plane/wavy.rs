//! A wavy parabola pressed on the half-plane, while its contact is in one piece.

use super::{PlaneContact, WavyParabola};
use crate::contact::adhesion::line::Energy;
use crate::contact::error::{ContactError, PlaneError};
use crate::contact::model::{ContactModel, Event, Glance, Loading, Pull, Straight};
use crate::contact::state::Normal;
use crate::shape::PlaneWavy;
use std::f64::consts::PI;

/// A wavy parabola under a force; the force alone decides its contact, the depth follows with the datum.
#[derive(Debug, Clone)]
pub struct WavyContact {
    shape: PlaneWavy,
    modulus: f64,
    /// Load per width [N/m].
    load: f64,
    /// The contact while it is in one piece.
    piece: Option<PlaneContact>,
}

impl WavyContact {
    /// The shape over a half-plane of the modulus E* [Pa], just touching.
    #[must_use]
    pub fn new(shape: PlaneWavy, modulus: f64) -> Self {
        Self { shape, modulus, load: 0.0, piece: None }
    }

    fn under(&mut self, force: f64) -> Result<Vec<Event>, ContactError> {
        self.load = force / self.shape.width();
        let slope = |x: f64| self.shape.ripple_slope(x);
        let parabola = WavyParabola { modulus: self.modulus, radius: self.shape.radius.si(), slope: &slope };
        self.piece = if self.load > 0.0 { parabola.symmetric(self.load).map_err(PlaneError::from)? } else { None };
        match &self.piece {
            Some(piece) if piece.half_width >= self.shape.datum.si() => {
                Err(PlaneError::Datum { half_width: piece.half_width }.into())
            }
            _ => Ok(Vec::new()),
        }
    }

    /// The state under a force [N]; `None` where the contact is not in one piece, or beyond the datum.
    #[must_use]
    pub fn state_under(&mut self, force: f64) -> Option<Normal> {
        self.under(force).ok()?;
        self.piece.is_some().then(|| self.state())
    }

    /// Height of the section [m].
    fn height(&self, x: f64) -> f64 {
        0.5 * x * x / self.shape.radius.si() + self.shape.ripple(x)
    }

    /// Means of the height over the contact: with the weight of a flat punch [m], and with the pressure [N].
    fn means(&self, piece: &PlaneContact) -> (f64, f64) {
        let nodes = 4 * piece.series().len();
        let (mut flat, mut pressed) = (0.0, 0.0);
        for j in 0..nodes {
            let (sine, cosine) = (PI * (j as f64 + 0.5) / nodes as f64).sin_cos();
            let x = piece.half_width * cosine;
            let height = self.height(x) / nodes as f64;
            flat += height;
            pressed += PI * piece.half_width * height * sine * piece.pressure(x);
        }
        (flat, pressed)
    }

    /// ln(2D/c), D the datum.
    fn distance(&self, piece: &PlaneContact) -> f64 {
        (2.0 * self.shape.datum.si() / piece.half_width).ln()
    }
}

impl ContactModel for WavyContact {
    fn follow(&mut self, _piece: &Straight) -> Result<Vec<Event>, ContactError> {
        Err(PlaneError::ByForce.into())
    }

    fn look(&mut self, _piece: &Straight) -> Result<Glance, ContactError> {
        Err(PlaneError::ByForce.into())
    }

    /// d = ⟨h⟩ + (2P/πE*) ln(2D/c), ⟨h⟩ the mean with the weight of a flat punch, for ln|x − s| has the mean ln(c/2) with it.
    fn state(&self) -> Normal {
        let (width, force) = (self.shape.width(), self.load * self.shape.width());
        let Some(piece) = &self.piece else {
            let contact_radius = (self.load <= 0.0).then_some(0.0);
            return Normal { indentation: contact_radius, force, contact_radius, ..Normal::default() };
        };
        let (flat, pressed) = self.means(piece);
        let depth = flat + 2.0 * self.load / (PI * self.modulus) * self.distance(piece);
        Normal {
            indentation: Some(depth),
            force,
            contact_radius: Some(piece.half_width),
            stiffness: width * PI * self.modulus / (2.0 * self.distance(piece)),
            stored: Energy { elastic: 0.5 * width * (self.load * depth - pressed), surface: 0.0 },
            dissipated: 0.0,
        }
    }

    fn joined(&self) -> bool {
        self.piece.is_some()
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        let piece = self.piece.clone()?;
        Some(Box::new(piece))
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        Some(self.under(pull.force))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        Some(Ok(0.0))
    }
}

impl Loading for PlaneContact {
    fn contact_radius(&self) -> f64 {
        self.half_width
    }

    fn pressure(&self, x: f64) -> Option<f64> {
        Some(Self::pressure(self, x))
    }
}
