//! The memory driven by forces instead of displacements.

use super::FrictionError;
use super::turning::{Pose, TangentialMemory};
use crate::numerics::root::brent;

/// Halvings after which a curved step is taken as straight.
const MOST_HALVINGS: u32 = 24;

impl TangentialMemory {
    /// The slide u_x [m] at which a straight step to `indentation` ends with the tangential force
    /// `force` [N].
    ///
    /// F_x grows with the slide at the end of the step, so there is one, to the rounding of the step.
    ///
    /// # Errors
    /// The force is not below μF: no slide carries it, the contact slips as a whole; or the
    /// indentation leaves the profile.
    pub fn slide_under(&self, indentation: f64, force: f64) -> Result<f64, FrictionError> {
        let start = self.position().slide;
        // As far as every spring slips for certain: the present slip of each is within the present reach.
        let far = 2.0 * self.grip().reach() * (indentation.max(0.0) + self.position().indentation.max(0.0));
        let at = |way: f64| self.force_at(Pose { indentation, slide: start + way });
        let (least, most) = (at(-far)?, at(far)?);
        if !(force > least && force < most) {
            return Err(FrictionError::GrossSlip { force, limit: most });
        }
        brent(|way| at(way).unwrap_or(f64::NAN) - force, -far, far)
            .map(|way| start + way)
            .map_err(|_| FrictionError::GrossSlip { force, limit: most })
    }
}

/// The ends of the chords of a curve: the depth follows `depth`(t), t from 0 to 1, while the slide
/// grows evenly between the values `slides` [m].
///
/// The curve is halved until its middle lies within `accuracy` (default 1e-6, from 1e-12 to 1e-2)
/// of the greater end depth from its chord; too small a value costs steps as its inverse root, too
/// large a one shifts the memory by that part of the depth. Only a contact that grows while it is slid
/// remembers the curve; any other takes one step, which is exact for every monotone path.
#[must_use]
pub fn chords(depth: &dyn Fn(f64) -> f64, slides: (f64, f64), accuracy: f64) -> Vec<Pose> {
    let allowed = accuracy * depth(0.0).abs().max(depth(1.0).abs());
    let mut ends = Vec::new();
    DrivenCurve { depth, slides, allowed }.cut((0.0, 1.0), MOST_HALVINGS, &mut ends);
    ends
}

/// A curve and the bend [m] at which a piece of it counts as straight.
struct DrivenCurve<'d> {
    depth: &'d dyn Fn(f64) -> f64,
    slides: (f64, f64),
    allowed: f64,
}

impl DrivenCurve<'_> {
    fn cut(&self, (from, to): (f64, f64), halvings: u32, ends: &mut Vec<Pose>) {
        let depth = self.depth;
        let grows = depth(to) > depth(from) && (self.slides.1 - self.slides.0).abs() > 0.0;
        let middle = 0.5 * (from + to);
        let bent = || (depth(middle) - 0.5 * (depth(from) + depth(to))).abs() > self.allowed;
        if grows && halvings > 0 && bent() {
            self.cut((from, middle), halvings - 1, ends);
            self.cut((middle, to), halvings - 1, ends);
        } else {
            let slide = if to >= 1.0 { self.slides.1 } else { self.slides.0 + to * (self.slides.1 - self.slides.0) };
            ends.push(Pose { indentation: depth(to), slide });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::turning::Grip;
    use super::*;
    use crate::input::quantity::Length;
    use crate::shape::{Paraboloid, Profile};
    use proptest::prelude::*;
    use std::sync::Arc;

    const GRIP: Grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient: 0.4 };

    fn lens() -> Paraboloid {
        Paraboloid { radius: Length::new(1.0).unwrap() }
    }

    proptest! {
        #![proptest_config(crate::laws::cases(64))]

        /// Forces prescribed by integers come back as the forces of the slides found.
        #[test]
        fn the_slide_under_a_force_gives_the_force(history in prop::collection::vec((1i32..12, -99i32..100), 1..16)) {
            let shape = lens();
            let mut memory = TangentialMemory::new(Arc::new(shape.clone()), GRIP);
            memory.advance(Pose { indentation: 0.5, slide: 0.0 }).unwrap();
            for (depth, part) in history {
                let indentation = 0.1 * f64::from(depth);
                let limit = GRIP.coefficient * 2.0 * shape.load_integral(indentation.sqrt());
                let force = 0.01 * f64::from(part) * limit;
                let slide = memory.slide_under(indentation, force).unwrap();
                memory.advance(Pose { indentation, slide }).unwrap();
                // The slide is found to its rounding, of the order of the reach; the stiffness is at most 2G*a.
                prop_assert!((memory.state().tangential_force - force).abs() < 1e-14, "{force}");
            }
            let limit = GRIP.coefficient * 2.0 * shape.load_integral(1.0);
            let slips = memory.slide_under(1.0, 1.001 * limit).is_err();
            prop_assert!(slips);
        }
    }

    /// Normal force and slide grow together from zero, F_x = ∫2G*a du = 2G*a(F)·… : with d = t^{2/3},
    /// a = t^{1/3} and u = st the springs stick and F_x = 2G*s·(3/4).
    #[test]
    fn a_curved_path_is_followed_to_its_accuracy() {
        let (shape, slide) = (lens(), 0.1);
        let exact = 2.0 * GRIP.tangential_modulus * slide * 0.75;
        for accuracy in [1e-3, 1e-5, 1e-7] {
            let mut memory = TangentialMemory::new(Arc::new(shape.clone()), GRIP);
            let path = chords(&|t: f64| t.powf(2.0 / 3.0), (0.0, slide), accuracy);
            path.into_iter().for_each(|to| memory.advance(to).unwrap());
            let error = memory.state().tangential_force / exact - 1.0;
            // A depth wrong by ε shifts a = √d by ε/(2√d); over the path t^{2/3} that is (3/4)ε of the mean.
            assert!(error.abs() < accuracy, "{error:e}");
        }
    }
}
