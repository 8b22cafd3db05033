//! The place below a contact at which it yields first.

use super::StressField;
use crate::numerics::extremum::{self, Peak};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2};

/// Places from the axis outwards and depths at which the hardest place is looked for.
const LOOKS: u32 = 18;
/// How far out and down that is, in radii of the contact.
const FAR: f64 = 1.5;

/// Stresses that agree to this part are one.
const SAME: f64 = 1e-12;

/// Places beside an edge, as parts of its radius.
const BESIDE: [f64; 7] = [-0.06, -0.03, -0.01, 0.0, 0.01, 0.03, 0.06];
/// Parts of the way to the next place at which a hump about the axis is to fall.
const AWAY: [f64; 4] = [0.01, 0.1, 0.3, 1.0];
/// Part of the greatest stress seen from which on a top may hide the hardest place, and how many such tops are climbed.
const WORTH: f64 = 0.75;
const TOPS: usize = 4;

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
        self.hertzian().map(|pressure| self.below_hertz(pressure)).or_else(|| self.searched())
    }

    /// The pressure p₀ [Pa] in the middle of a contact at rest whose springs carry q′ = −πp₀x/a: that of Hertz.
    fn hertzian(&self) -> Option<f64> {
        let [piece] = self.pieces.as_slice() else { return None };
        let is_alone = !self.slides() && self.ring.is_none() && self.edge.1.abs() <= 0.0;
        Some(FRAC_1_PI * piece.proportional().filter(|_| is_alone)? * self.edge.0)
    }

    /// The hardest place under Hertz's pressure, on the axis at any ν ≥ 0, where (Johnson 1985, eq. 3.45)
    /// σ_rr − σ_zz = p₀(3/(2(1+ζ²)) − (1+ν)(1 − ζ arccot ζ)), ζ = z/a.
    fn below_hertz(&self, pressure: f64) -> Place {
        let stress = |zeta: f64| {
            1.5 / (1.0 + zeta * zeta) - (1.0 + self.poisson) * (1.0 - zeta * (FRAC_PI_2 - libm::atan(zeta)))
        };
        let top = extremum::greatest(stress, 0.0, 1.0);
        Place { radius: 0.0, depth: top.place * self.edge.0 * self.scale, von_mises: pressure * top.value }
    }

    /// The hardest place of any field: the best of a net of places and the tops between them.
    fn searched(&self) -> Option<Place> {
        let (across, down) = (self.columns(), self.rows());
        let seen: Vec<Vec<f64>> =
            down.iter().map(|&z| across.iter().map(|&r| self.von_mises(r, z)).collect()).collect();
        let beside = |list: &[f64], k: usize| (list[k.saturating_sub(1)], list[k], list[(k + 1).min(list.len() - 1)]);
        let refined = tops(&seen).into_iter().map(|(row, column)| {
            if let Some(place) =
                self.on_the_axis(beside(&down, row), (across[column], across[(column + 1) % across.len()]))
            {
                return place;
            }
            let along = |r: f64| self.highest(|z| self.von_mises(r, z), beside(&down, row));
            let best = self.highest(|r| along(r).value, beside(&across, column));
            Place { radius: best.place, depth: along(best.place).place, von_mises: best.value }
        });
        refined.filter(|place| place.von_mises.is_finite()).max_by(|x, y| x.von_mises.total_cmp(&y.von_mises))
    }

    /// The top of a hump about the axis between three depths, if it is there: the stress is even in r, so that what is
    /// greatest along the axis and falls beside it is a top. `radii` are that of the column and the next one.
    fn on_the_axis(&self, depths: (f64, f64, f64), radii: (f64, f64)) -> Option<Place> {
        if self.slides() || radii.0 > 0.0 {
            return None;
        }
        let best = self.highest(|z| self.von_mises(0.0, z), depths);
        let falls = |part: &f64| self.von_mises(part * radii.1, best.place) <= best.value * (1.0 + SAME);
        AWAY.iter().all(falls).then_some(Place { radius: 0.0, depth: best.place, von_mises: best.value })
    }

    /// Stress of von Mises [Pa] at a place.
    fn von_mises(&self, r: f64, z: f64) -> f64 {
        self.at(r, z).von_mises()
    }

    /// Places looked at [m]: equally far apart, closer beside the edge of the contact and of what acts on it; on both sides
    /// if the contact slides.
    fn columns(&self) -> Vec<f64> {
        let equal = (0..=LOOKS).map(|k| FAR * f64::from(k) / f64::from(LOOKS));
        let edges = [self.edge.0, 1.0].into_iter().flat_map(|edge| BESIDE.map(|part| edge * (1.0 + part)));
        let mut one: Vec<f64> = equal.chain(edges).map(|place| place * self.scale).collect();
        if self.slides() {
            one.extend(one.clone().into_iter().map(|place| -place));
        }
        one.sort_by(f64::total_cmp);
        one.dedup_by(|x, y| (*x - *y).abs() <= SAME * self.scale);
        one
    }

    /// Depths looked at [m], closer towards the surface.
    fn rows(&self) -> Vec<f64> {
        (0..=LOOKS).map(|k| (f64::from(k) / f64::from(LOOKS)).powi(2) * FAR * self.scale).collect()
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

/// Row and column of the places that are no less hard than those beside them, the hardest first.
fn tops(seen: &[Vec<f64>]) -> Vec<(usize, usize)> {
    let value = |row: usize, column: usize| seen.get(row).and_then(|row| row.get(column)).copied();
    let mut tops: Vec<(f64, (usize, usize))> = Vec::new();
    for (row, line) in seen.iter().enumerate() {
        for (column, &here) in line.iter().enumerate() {
            let beside = [
                value(row.wrapping_sub(1), column),
                value(row + 1, column),
                value(row, column.wrapping_sub(1)),
                value(row, column + 1),
            ];
            if beside.into_iter().flatten().all(|other| here >= other) {
                tops.push((here, (row, column)));
            }
        }
    }
    tops.sort_by(|x, y| y.0.total_cmp(&x.0));
    let worth = tops.first().map_or(0.0, |top| WORTH * top.0);
    tops.into_iter().filter(|top| top.0 >= worth).take(TOPS).map(|(_, at)| at).collect()
}

#[cfg(test)]
mod tests {
    use crate::contact::foundation::Foundation;
    use crate::contact::loaded::Loaded;
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use proptest::prelude::*;
    use std::sync::Arc;

    proptest! {
        /// Hertz's place is that of the search over his field.
        #[test]
        fn hertz_is_what_the_search_finds(poisson in 0i32..=50, depth in -60i32..60) {
            let ball = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
            let a = f64::from(depth).exp2();
            let field = Loaded::elastic(Foundation::new(ball, 3.0), a, 0.0).field(0.01 * f64::from(poisson));
            prop_assert!(field.hertzian().is_some(), "{field:?}");
            let (known, searched) = (field.hardest().unwrap(), field.searched().unwrap());
            prop_assert!((known.von_mises / searched.von_mises - 1.0).abs() < 1e-11, "{known:?} {searched:?}");
            // A flat top tells its place to the root of rounding.
            prop_assert!((known.depth - searched.depth).abs() < 1e-6 * a && searched.radius < 1e-6 * a);
        }
    }
}
