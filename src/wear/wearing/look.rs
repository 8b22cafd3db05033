//! What is seen of a contact that wears.

use super::super::rubbing::{Rubbed, Rubbing};
use super::super::seen::Seen;
use super::{Ring, TOTALS, Wearing, Worn};
use crate::contact::adhesion::line::Energy;
use crate::contact::model::Loading;
use crate::contact::state::Normal;

impl Wearing {
    /// What has been worn off.
    #[must_use]
    pub fn worn(&self) -> Worn {
        let depths = &self.state[TOTALS..];
        let volume = depths.iter().zip(self.bed.rings.areas()).map(|(depth, area)| depth * area).sum();
        Worn { volume, depth: depths.iter().copied().fold(0.0, f64::max) }
    }

    /// ∫∫ p ds dA [N m], ∫F ds of a contact that slides as a whole: the worn volume is k_w times it.
    #[must_use]
    pub fn rubbed(&self) -> f64 {
        self.state[0]
    }

    /// Energy [J] friction has taken so far, per coefficient of friction.
    #[must_use]
    pub fn friction(&self) -> f64 {
        self.state[2]
    }

    /// State of the normal contact; what is lost is the work of the pressure on what is worn off.
    #[must_use]
    pub fn normal(&self) -> Normal {
        let radius = self.bed.contact_radius(&self.pressed);
        Normal {
            indentation: Some(self.pressed.depth),
            force: self.bed.force(&self.pressed),
            contact_radius: Some(radius),
            stiffness: 2.0 * self.bed.modulus() * radius,
            stored: Energy { elastic: self.bed.energy(&self.pressed), surface: 0.0 },
            dissipated: self.state[1],
        }
    }

    /// The rings of the surface from the axis outwards.
    #[must_use]
    pub fn surface(&self) -> Vec<Ring> {
        let rings = &self.bed.rings;
        let mut forces = vec![0.0; rings.len()];
        rings.forces(&self.pressed.loads, &mut forces);
        let ring = |j: usize| {
            let radius = 0.5 * (rings.rings()[j] + rings.rings()[j + 1]);
            let worn = self.state[TOTALS + j];
            Ring {
                radius,
                height: self.bed.profile().height(radius) + worn,
                worn,
                pressure: forces[j] / rings.areas()[j],
            }
        };
        (0..rings.len()).map(ring).collect()
    }

    /// The load as the bodies are pressed now, with the shear of the springs, to be looked at.
    #[must_use]
    pub fn loading(&self, springs: &Rubbing) -> impl Loading + '_ {
        let shear = springs.loads(self.pressed.loads.len());
        Seen::new((&self.bed, &self.pressed), &self.state[TOTALS..], &shear)
    }

    /// The indentation [m] of the first touch.
    #[must_use]
    pub fn touch(&self) -> f64 {
        self.pressed.reduced.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Whether the contact is one piece.
    #[must_use]
    pub fn is_in_one_piece(&self) -> bool {
        self.bed.is_in_one_piece(&self.pressed)
    }

    /// Springs after a straight slide by `way` [m] as the bodies are pressed now, and their state.
    #[must_use]
    pub fn rub(&self, springs: &Rubbing, way: f64) -> (Rubbing, Rubbed) {
        springs.led(&self.bed, &self.pressed, way)
    }

    /// The slide [m] to the side of `way` after which nothing sticks.
    #[must_use]
    pub fn onset(&self, springs: &Rubbing, way: f64) -> f64 {
        springs.onset(&self.pressed, way)
    }

    /// Number of cells.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.bed.rings.len()
    }

    /// Steps taken so far.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Bytes of state.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + self.bed.rings.bytes() + self.slips.bytes() + 8 * self.state.len()
    }
}
