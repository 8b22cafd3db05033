//! The memory driven by forces instead of displacements.

use super::FrictionError;
use super::turning::{Position, TangentialMemory};
use crate::physics::root::brent;

/// Halvings after which a curved step is taken as straight.
const MOST_HALVINGS: u32 = 14;

impl TangentialMemory<'_> {
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
        let at = |way: f64| self.force_at(Position { indentation, slide: start + way });
        let (least, most) = (at(-far)?, at(far)?);
        if !(force > least && force < most) {
            return Err(FrictionError::GrossSlip { force, limit: most });
        }
        brent(|way| at(way).unwrap_or(f64::NAN) - force, -far, far)
            .map(|way| start + way)
            .map_err(|_| FrictionError::GrossSlip { force, limit: most })
    }

    /// Moves along a curve: the depth follows `depth`(t), t from 0 to 1, while the slide grows evenly
    /// to `slide` (as under a prescribed normal force).
    ///
    /// The curve is halved until its middle lies within `accuracy` (default 1e-6, from 1e-14 to 1e-2)
    /// of the depth from its chord; too small a value costs steps, too large a one bends the memory
    /// by that part of the depth. Only a contact that grows faster than it is slid remembers the
    /// curve; any other takes one step, which is exact for every monotone path.
    ///
    /// # Errors
    /// The indentation leaves the profile.
    pub fn advance_along(
        &mut self,
        depth: &dyn Fn(f64) -> f64,
        slide: f64,
        accuracy: f64,
    ) -> Result<(), FrictionError> {
        self.piece(&(depth, self.position().slide, slide, accuracy), (0.0, 1.0), MOST_HALVINGS)
    }

    fn piece(
        &mut self,
        path: &(&dyn Fn(f64) -> f64, f64, f64, f64),
        (from, to): (f64, f64),
        halvings: u32,
    ) -> Result<(), FrictionError> {
        let &(depth, start, end, accuracy) = path;
        let middle = 0.5 * (from + to);
        let bend = depth(middle) - 0.5 * (depth(from) + depth(to));
        if depth(to) <= depth(from) || halvings == 0 || bend.abs() <= accuracy * depth(to).abs() {
            return self.advance(Position { indentation: depth(to), slide: start + to * (end - start) });
        }
        self.piece(path, (from, middle), halvings - 1)?;
        self.piece(path, (middle, to), halvings - 1)
    }
}
