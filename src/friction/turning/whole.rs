//! A contact that slips as a whole: where it comes to that, and what its springs carry then.

use super::{TangentialMemory, Turn};
use crate::friction::FrictionError;
use crate::friction::load::{NormalLoad, SpringDepth};

/// Two displacements closer than this part of the one that slips the contact as a whole are one.
const CORNER: f64 = 1e-13;
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Where a motion along the surface meets a turning point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Tangential displacement [m].
    pub slide: f64,
    /// Whether the contact slips as a whole behind it.
    pub is_last: bool,
}

impl TangentialMemory {
    /// The nearest tangential displacement [m] beyond the present one, `ahead` 1 or −1, at which the memory loses a turning
    /// point: there the stiffness has a kink, and behind the last one the contact slips as a whole.
    ///
    /// A vertex at the depth h that has slipped by s is reached by the slip at s ± m(d − h).
    #[must_use]
    pub fn next_corner(&self, ahead: f64) -> Corner {
        let reached = |turn: &Turn| self.reached(turn, ahead);
        let beyond = self.turns.iter().rev().map(reached).find(|way| ahead * way > self.least_way());
        let last = self.turns.first().map_or(0.0, reached);
        let way = beyond.unwrap_or(last);
        Corner { slide: self.at.slide + way, is_last: ahead * way >= ahead * last }
    }

    /// The way [m] along the surface at whose end the slip from the side `ahead` reaches a vertex.
    pub(super) fn reached(&self, turn: &Turn, ahead: f64) -> f64 {
        let below = turn.place.below(self.at.indentation);
        (turn.slide - turn.behind) + ahead * self.reach * below - self.at.slide
    }

    /// A way [m] below which a vertex has been reached: where displacements agree to rounding.
    pub(super) fn least_way(&self) -> f64 {
        (CORNER * self.reach * self.at.indentation).max(ROUNDING * self.at.slide.abs())
    }

    /// The tangential displacement [m] at which the contact slips as a whole in the direction `ahead`, 1 or −1.
    #[must_use]
    pub fn last_corner(&self, ahead: f64) -> f64 {
        let axis = self.turns.first().map_or(self.at.slide, |axis| axis.slide - axis.behind);
        axis + ahead * self.reach * self.at.indentation
    }

    /// Friction [N] at which the contact slips as a whole, and the displacement of its axis then [m].
    fn whole(&self) -> (f64, f64) {
        let edge = self.place(self.at.indentation, 0.0);
        let load = edge.map_or(0.0, |edge| self.curve.increment((SpringDepth::AXIS, edge)));
        (self.force(load), self.reach * self.at.indentation)
    }

    /// Friction μF [N] at which the contact slips as a whole.
    #[must_use]
    pub fn limit(&self) -> f64 {
        self.whole().0
    }

    /// Stiffness 2G*a [N/m] along the surface of the contact that sticks everywhere.
    #[must_use]
    pub fn stuck(&self) -> f64 {
        2.0 * self.grip.tangential_modulus * self.contact_radius
    }

    /// Tangential displacement μdE*/G* [m] from no load to where the contact slips as a whole.
    #[must_use]
    pub fn slip_reach(&self) -> f64 {
        self.whole().1
    }

    /// Lets all springs slip until each carries the part `part` (from −1 to 1) of the load at which it slips, at the
    /// present displacement, from which displacements are counted from now on; the energy this sets free is lost.
    ///
    /// # Errors
    /// The indentation leaves the profile.
    pub fn give_way(&mut self, part: f64) -> Result<(), FrictionError> {
        if self.turns.is_empty() || self.reach <= 0.0 {
            return Ok(());
        }
        let before = self.stored();
        self.at.slide = 0.0;
        let axis = self.axis(part * self.reach * self.at.indentation);
        let place = self.place(self.at.indentation, 0.0)?;
        let sum = part * self.curve.increment((axis.place, place));
        self.turns = vec![axis, Turn { place, slide: 0.0, behind: 0.0, slope: part, sum }];
        self.stick = SpringDepth::AXIS;
        self.dissipated += (before - self.stored()).max(0.0);
        Ok(())
    }

    /// The work [J] of the friction all springs carry along the way `way` [m] that the contact slides as a whole.
    ///
    /// Nothing depends on where it is: the memory stays at its displacement.
    pub fn rub(&mut self, way: f64) {
        self.dissipated += (self.state().tangential_force * way).abs();
    }
}
