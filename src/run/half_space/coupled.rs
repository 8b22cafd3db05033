//! Pressures and shear that change each other, on the way through a history.

use super::pressed::{Dragged, Pressed, area};
use super::rubbing::round;
use super::state::Pressing;
use crate::contact::adhesion::line::Energy;
use crate::contact::state::Tangential;
use crate::halfspace::{HalfSpaceError, Prescribed, RubbingMap, Settings};
use crate::scene::law::PixelFriction;
use crate::scene::plan::HalfSpacePlan;

/// Residual to which contact and shear are solved in each round, whatever accuracy is asked for: pixels leave far more.
const LOOSE: f64 = 1e-7;

/// A map that rubs.
pub(super) struct Coupled<'p> {
    map: RubbingMap<'p>,
}

impl<'p> Coupled<'p> {
    /// Fields of numbers that are kept: influences of both kinds, shear, displacements and bounds.
    pub(super) const FIELDS: usize = 32;

    /// That of a plan, if it asks for both together.
    pub(super) fn of(plan: &HalfSpacePlan, pressing: &Pressing<'p>) -> Option<Self> {
        let Some(PixelFriction::Coupled { coefficient }) = plan.friction else { return None };
        let settings = Settings { tolerance: pressing.settings.tolerance.max(LOOSE), ..pressing.settings };
        let (heights, place) = (&pressing.heights.values, (pressing.heights.pixel, pressing.boundary));
        Some(Self { map: RubbingMap::new(heights.view(), place, (plan.pair, coefficient), settings) })
    }

    /// Leads the map to what is prescribed and a slide \[m\].
    pub(super) fn advance(
        &mut self,
        pressing: &Pressing<'_>,
        prescribed: Prescribed,
        slide: f64,
    ) -> Result<Pressed, HalfSpaceError> {
        let state = self.map.advance(prescribed, [slide, 0.0])?;
        let [force, _] = state.force();
        let (contact, [shear, _]) = (state.contact, state.shear);
        let stuck = state.stuck.iter().filter(|stuck| **stuck).count() as f64;
        let tangential = Tangential {
            slide,
            force,
            stick_radius: round(stuck * area(contact.pixel)),
            stiffness: state.stiffness,
            stored: Some(state.stored),
            dissipated: Some(state.dissipated),
            area_ratio: None,
        };
        let (gap, elastic) = (pressing.gap(&contact), pressing.elastic(&contact.pressure, &contact.displacement));
        let stored = Energy { elastic, surface: 0.0 };
        let dragged = Some(Box::new(Dragged { tangential, shear }));
        Ok(Pressed { contact, pull: None, faint: 0.0, gap, stored, dissipated: 0.0, dragged })
    }
}
