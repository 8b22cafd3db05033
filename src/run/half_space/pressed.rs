//! A contact on pixels, solved.

use crate::contact::adhesion::line::Energy;
use crate::contact::state::Tangential;
use crate::halfspace::Solution;
use ndarray::Array2;

/// A contact solved: what presses and what pulls.
#[derive(Debug, Clone)]
pub(super) struct Pressed {
    /// The pressures that keep the bodies from overlapping, never negative, and the displacement under all there is.
    pub(super) contact: Solution,
    /// Attractive stress \[Pa\].
    pub(super) pull: Option<Array2<f64>>,
    /// Attractive stress \[Pa\] above which a pixel is held.
    pub(super) faint: f64,
    /// Gap \[m\] over the surface and what has been dented of it.
    pub(super) gap: Array2<f64>,
    /// Energy stored, and lost so far in the bodies \[J\].
    pub(super) stored: Energy,
    pub(super) dissipated: f64,
    /// What shear has come to that is found together with the pressures.
    pub(super) dragged: Option<Box<Dragged>>,
}

/// Shear that is found together with pressures.
#[derive(Debug, Clone)]
pub(super) struct Dragged {
    /// What it comes to.
    pub(super) tangential: Tangential,
    /// Shear stress \[Pa\] along x.
    pub(super) shear: Array2<f64>,
}

impl Pressed {
    /// Elastic bodies without adhesion, `gap` \[m\] apart.
    pub(super) fn elastic(contact: Solution, gap: Array2<f64>) -> Self {
        let elastic = 0.5 * area(contact.pixel) * (&contact.pressure * &contact.displacement).sum();
        Self {
            contact,
            pull: None,
            faint: 0.0,
            gap,
            stored: Energy { elastic, surface: 0.0 },
            dissipated: 0.0,
            dragged: None,
        }
    }

    /// Pressure on each pixel \[Pa\], pulling ones negative.
    pub(super) fn pressure(&self) -> Array2<f64> {
        match &self.pull {
            Some(pull) => &self.contact.pressure - pull,
            None => self.contact.pressure.clone(),
        }
    }

    /// Force \[N\].
    pub(super) fn force(&self) -> f64 {
        self.contact.force() - self.pull.as_ref().map_or(0.0, |pull| pull.sum() * area(self.contact.pixel))
    }

    /// Largest pressure \[Pa\].
    pub(super) fn peak_pressure(&self) -> f64 {
        match &self.pull {
            Some(_) => self.pressure().iter().copied().fold(0.0, f64::max),
            None => self.contact.peak_pressure(),
        }
    }

    /// Whether nothing presses and nothing pulls.
    pub(super) fn parted(&self) -> bool {
        let pulls = self.pull.iter().flatten().any(|&pull| pull > 0.0);
        !pulls && self.contact.contact_pixels() == 0
    }
}

/// Area of a pixel \[m²\].
pub(super) fn area([width, height]: [f64; 2]) -> f64 {
    width * height
}
