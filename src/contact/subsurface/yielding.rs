//! The load under which an elastic contact yields first.

use super::Place;
use crate::contact::foundation::Foundation;
use crate::contact::loaded::Loaded;
use crate::numerics::root;
use crate::shape::Rim;

/// The state of an elastic contact in which a body yields first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstYield {
    /// Normal force [N].
    pub force: f64,
    /// Indentation d [m].
    pub indentation: f64,
    /// Contact radius [m].
    pub contact_radius: f64,
    /// Where below the surface.
    pub place: Place,
}

/// How near to the end of a profile it is looked for.
const END: f64 = 1.0 - 1e-9;

impl FirstYield {
    /// First yield by von Mises of a body of Poisson's ratio `poisson` and yield stress `limit` [Pa] in an elastic contact
    /// without adhesion; `drag` is the shear traction over the pressure of one that slides.
    ///
    /// `None` where the stress has no bound, so that the body yields under any load, and where the profile ends first.
    /// Check: a ball at ν = 0.3 yields at p₀ = 1.6127965630 Y.
    #[must_use]
    pub fn of(ground: &Foundation, poisson: f64, limit: f64, drag: f64) -> Option<Self> {
        let profile = ground.profile();
        let at = |a: f64| Loaded::elastic(ground.clone(), a, 0.0);
        let hardest = |a: f64| at(a).field(poisson).dragged(drag).hardest();
        let flat = profile.flat_radius();
        let end = match profile.rim() {
            Rim::None => f64::MAX,
            Rim::Wall(end) | Rim::End(end) => END * end,
        };
        let start = profile.scale().max(2.0 * flat).min(end);
        hardest(start)?;
        let above =
            |a: f64| if a <= flat { -1.0 } else { hardest(a).map_or(f64::NAN, |place| place.von_mises / limit - 1.0) };
        let (low, high) = root::bracket_upwards(above, flat, start, end)?;
        let contact_radius = root::brent(above, low, high).ok()?;
        let place = hardest(contact_radius)?;
        let indentation = profile.reduced(contact_radius);
        Some(Self { force: at(contact_radius).force(), indentation, contact_radius, place })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::Length;
    use crate::shape::{Cone, FlatPunch, Paraboloid, Profile, RoundedPunch};
    use std::f64::consts::{FRAC_2_PI, PI};
    use std::sync::Arc;

    fn length(metres: f64) -> Length {
        Length::new(metres).unwrap()
    }

    fn yields(profile: Arc<dyn Profile>, poisson: f64, drag: f64) -> Option<FirstYield> {
        FirstYield::of(&Foundation::new(profile, 1.0), poisson, 1e-2, drag)
    }

    /// p₀ = κY, F = π³R²p₀³/6E*², with κ of physics by 25 digits.
    #[test]
    fn a_ball_yields_at_a_known_pressure() {
        for (poisson, ratio) in [(0.3, 1.612_796_563_0), (0.5, 1.877_239_337_1), (0.25, 1.554_347_432_4)] {
            let first = yields(Arc::new(Paraboloid { radius: length(2.0) }), poisson, 0.0).unwrap();
            let peak: f64 = ratio * 1e-2;
            assert!((first.force / (PI.powi(3) * 4.0 * peak.powi(3) / 6.0) - 1.0).abs() < 5e-10, "{poisson}");
            assert!((first.contact_radius * FRAC_2_PI / 2.0 / peak - 1.0).abs() < 2e-10, "{poisson}");
        }
    }

    /// Sliding brings first yield to the surface, from μ ≈ 0.3 on (Johnson 1985, §7.1(b)).
    #[test]
    fn sliding_brings_first_yield_to_the_surface() {
        let ball = || Arc::new(Paraboloid { radius: length(1.0) });
        let [rest, slow, fast] = [0.0, 0.2, 0.5].map(|drag| yields(ball(), 0.3, drag).unwrap());
        assert!(rest.force > slow.force && slow.force > fast.force);
        assert!(slow.place.depth > 0.2 * slow.contact_radius && fast.place.depth < 1e-6 * fast.contact_radius);
    }

    /// A sharp edge or apex yields at once; a rounded one under its rim.
    #[test]
    fn sharp_shapes_yield_at_once() {
        assert!(yields(Arc::new(FlatPunch { radius: length(1.0) }), 0.3, 0.0).is_none());
        assert!(
            yields(Arc::new(Cone { slope: crate::input::quantity::Positive::new(0.1).unwrap() }), 0.3, 0.0).is_none()
        );
        let rounded = RoundedPunch { flat_radius: length(1.0), edge_radius: length(0.2) };
        let first = yields(Arc::new(rounded), 0.3, 0.0).unwrap();
        assert!(first.place.radius > 0.8 && first.contact_radius > 1.0, "{first:?}");
    }
}
