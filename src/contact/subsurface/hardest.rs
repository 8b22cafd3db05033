//! The place below a contact at which it yields first.

use super::StressField;
use crate::numerics::extremum::{self, Peak};

/// Places on either side and depths at which the hardest place is looked for.
const LOOKS: i32 = 18;
/// How far out and down that is, in radii of the contact.
const FAR: f64 = 1.5;

/// Stresses that agree to this part are one.
const SAME: f64 = 1e-12;

/// A place below the surface and the stress of von Mises there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Distance r from the axis [m]; of a contact that slides its place x, of either sign.
    pub radius: f64,
    /// Depth z [m].
    pub depth: f64,
    /// Stress of von Mises [Pa].
    pub von_mises: f64,
}

impl StressField {
    /// Where the stress of von Mises is greatest; `None` where it has no bound, under a sharp edge or apex.
    ///
    /// Check: Hertz at ν = 0.3 has it on the axis at z = 0.480864 a, 0.6200410040 p₀; sliding with μ = 0.5 it is at
    /// the surface (Johnson 1985, §7.1(b)).
    #[must_use]
    pub fn hardest(&self) -> Option<Place> {
        if !self.bounded {
            return None;
        }
        let (row, column) = self.coarse()?;
        let across = |k: i32| f64::from(k.clamp(self.first(), LOOKS)) / f64::from(LOOKS) * FAR * self.scale;
        let down = |k: i32| (f64::from(k.clamp(0, LOOKS)) / f64::from(LOOKS)).powi(2) * FAR * self.scale;
        let along = |r: f64| self.highest(|z| self.von_mises(r, z), (down(row - 1), down(row), down(row + 1)));
        let best = self.highest(|r| along(r).value, (across(column - 1), across(column), across(column + 1)));
        let depth = along(best.place).place;
        Some(Place { radius: best.place, depth, von_mises: best.value }).filter(|place| place.von_mises.is_finite())
    }

    /// Stress of von Mises [Pa] at a place.
    fn von_mises(&self, r: f64, z: f64) -> f64 {
        self.at(r, z).von_mises()
    }

    /// First column of the places looked at: both sides if the contact slides.
    fn first(&self) -> i32 {
        if self.slides() { -LOOKS } else { 0 }
    }

    /// Row and column of the hardest of the places looked at.
    fn coarse(&self) -> Option<(i32, i32)> {
        let place = |(row, column): &(i32, i32)| {
            let part = |k: i32| f64::from(k) / f64::from(LOOKS);
            self.von_mises(part(*column) * FAR * self.scale, part(*row).powi(2) * FAR * self.scale)
        };
        let all = (0..=LOOKS).flat_map(|row| (self.first()..=LOOKS).map(move |column| (row, column)));
        all.map(|at| (place(&at), at)).max_by(|x, y| x.0.total_cmp(&y.0)).map(|(_, at)| at)
    }

    /// The top of a hump between two places, whether inside or at an end: at an end, the axis or the surface, if nothing
    /// is higher beyond rounding.
    fn highest(&self, of: impl Fn(f64) -> f64, (low, middle, high): (f64, f64, f64)) -> Peak {
        let at = |place: f64| Peak { place, value: of(place) };
        let inside = extremum::greatest(&of, low, high).max(at(middle));
        let end = at(low).max(at(high));
        if end.value >= inside.value * (1.0 - SAME) { end } else { inside }
    }
}
