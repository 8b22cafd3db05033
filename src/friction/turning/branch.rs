//! The force on the way to the next turning point, of one piece.

use super::{TangentialMemory, Turn, on_side};
use crate::friction::load::NormalLoad;

/// The tangential force on a way along the surface at a constant depth, from where the memory is up to its next turning point.
///
/// On the way the springs below the depth h(u) stick and those above slip to the side ±1, while the piece of the memory that is
/// worn away has the slope σ: F_x = F_x₀ + 2μE*(±1 − σ)(N(h₀) − N(h(u))), h falling with the way by 1/m(1 ∓ σ). It is of one
/// analytic piece, also where it is continued beyond its ends: what follows a motion by smooth steps asks here, and looks
/// for the ends itself.
#[derive(Debug, Clone, Copy)]
pub struct Branch<'m> {
    memory: &'m TangentialMemory,
    /// Force [N] and load N [m²] where it begins.
    from: (f64, f64),
    /// Depth [m] below the indentation of the outermost spring that sticks, and its growth with the way.
    below: (f64, f64),
    /// 2μE*(±1 − σ) [Pa].
    weight: f64,
}

impl Branch<'_> {
    /// The force [N] after the way `way` [m], counted along the surface.
    #[must_use]
    pub fn force(&self, way: f64) -> f64 {
        let memory = self.memory;
        let place = memory.curve.place(memory.at.indentation, self.below.0 + self.below.1 * way);
        let load = place.map_or(f64::NAN, |place| memory.curve.load(place));
        self.from.0 + self.weight * (self.from.1 - load)
    }
}

/// A force F(w) = F₀ + S(1 − (1 − w/W)^p) along the way w, as that of a branch on a profile g ∝ xⁿ, p = 1 + 1/n.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerBranch {
    /// S [N].
    pub share: f64,
    /// W [m], the way at whose end the axis slips.
    pub whole: f64,
    /// p.
    pub exponent: f64,
}

impl Branch<'_> {
    /// The same as a power of the way that is left to the axis; `None` where the load is none of the depth.
    #[must_use]
    pub fn power(&self) -> Option<PowerBranch> {
        let exponent = 1.0 + self.memory.curve.profile.power()?.recip();
        let whole = (self.memory.at.indentation - self.below.0) / self.below.1;
        Some(PowerBranch { share: self.weight * self.from.1, whole, exponent })
    }
}

impl TangentialMemory {
    /// The force on the way in the direction `ahead`, 1 or −1; `None` of a contact that slips as a whole in that direction.
    #[must_use]
    pub fn branch(&self, ahead: f64) -> Option<Branch<'_>> {
        // A piece parallel to the side lies on it up to rounding: it has been worn away.
        let stands =
            |pair: &&[Turn]| ahead * self.reached(&pair[0], ahead) > self.least_way() && ahead * pair[1].slope < 1.0;
        let [inner, outer] = self.turns.windows(2).rev().find(stands)? else { return None };
        let seen = |turn: &Turn| self.seen(turn, self.at);
        let below = on_side(ahead, (seen(inner), seen(outer)), outer.slope);
        let place = self.curve.place(self.at.indentation, below)?;
        let from = (self.state().tangential_force, self.curve.load(place));
        let slipping = ahead - outer.slope;
        let below = (below, slipping.recip() / self.reach);
        Some(Branch { memory: self, from, below, weight: self.force(slipping) })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Grip, Pose};
    use super::*;
    use crate::input::quantity::Length;
    use crate::shape::{Paraboloid, Profile, RoundedPunch};
    use proptest::prelude::*;
    use std::sync::Arc;

    proptest! {
        #![proptest_config(crate::laws::cases(64))]

        /// Up to its next turning point it is the force of the memory, whatever was before.
        #[test]
        fn a_branch_is_the_force_of_the_memory(slides in prop::collection::vec(-100..=100i32, 0..8), part in 0..=100i32) {
            let length = |x: f64| Length::new(x).unwrap();
            let shapes: [Arc<dyn Profile>; 2] = [
                Arc::new(Paraboloid { radius: length(1.0) }),
                Arc::new(RoundedPunch { flat_radius: length(0.4), edge_radius: length(0.5) }),
            ];
            for profile in shapes {
                let grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient: 0.3 };
                let mut memory = TangentialMemory::new(profile, grip);
                memory.advance(Pose { indentation: 1.0, slide: 0.0 }).unwrap();
                for slide in &slides {
                    memory.advance(Pose { indentation: 1.0, slide: 0.009 * f64::from(*slide) * memory.reach }).unwrap();
                }
                for ahead in [1.0, -1.0] {
                    let Some(branch) = memory.branch(ahead) else { continue };
                    let way = 0.01 * f64::from(part) * (memory.next_corner(ahead).slide - memory.at.slide);
                    let force = memory.force_at(Pose { indentation: 1.0, slide: memory.at.slide + way }).unwrap();
                    prop_assert!((branch.force(way) - force).abs() < 1e-14 * memory.limit(), "{ahead} {:e} {force:e}", branch.force(way));
                    let Some(power) = branch.power() else { continue };
                    let left = (1.0 - way / power.whole).max(0.0);
                    let by_power = branch.force(0.0) + power.share * (1.0 - left.powf(power.exponent));
                    prop_assert!((by_power - force).abs() < 1e-14 * memory.limit(), "{ahead} {by_power:e} {force:e}");
                }
            }
        }
    }
}
