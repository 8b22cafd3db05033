//! Guarded search for the greatest value of a function: Brent's method for extrema.
//!
//! # Examples
//! ```
//! use springbed::numerics::extremum;
//!
//! let peak = extremum::greatest(|x: f64| x * (-x).exp(), 0.0, 5.0);
//! assert!((peak.place - 1.0).abs() < 1e-7 && (peak.value - (-1.0f64).exp()).abs() < 1e-15);
//! ```

/// Where a function is greatest, and how great.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Argument.
    pub place: f64,
    /// Value there.
    pub value: f64,
}

impl Peak {
    /// The greater of two.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if other.value > self.value { other } else { self }
    }
}

/// The top of the parabola through three places of growing argument, if the middle one is the greatest of them.
///
/// With the divided differences s = [x₁, x₂] and b = [x₁, x₂, x₃] its slope at x₂ is t = s + b (x₂ − x₁), and its top y₂ − t²/4b.
/// Check: through (0, 0), (1, 3) and (4, 0) it is 4, at 2.
#[must_use]
pub fn top_through([first, second, third]: [Peak; 3]) -> Option<Peak> {
    if !(second.value > first.value && second.value > third.value) {
        return None;
    }
    let slope = |one: Peak, two: Peak| (two.value - one.value) / (two.place - one.place);
    let rising = slope(first, second);
    let bend = (slope(second, third) - rising) / (third.place - first.place);
    let tilt = rising + bend * (second.place - first.place);
    let beyond = -0.5 * tilt / bend;
    Some(Peak { place: second.place + beyond, value: second.value + 0.5 * tilt * beyond })
}

/// The greatest value of a function with one hump between `low` and `high`.
///
/// Brent's method (Brent 1973, ch. 5): the top of a parabola through the three best places, guarded by the
/// golden section; 10 to 15 evaluations for a smooth hump, 48 for a corner. The place is found to 1e-10 of
/// the interval, or to where the function cannot tell two places apart: a smooth top to the root of its rounding.
/// Check: 1 − (x − 1/3)² between 0 and 1 is greatest at 1/3.
pub fn greatest(mut function: impl FnMut(f64) -> f64, low: f64, high: f64) -> Peak {
    let start = low + GOLDEN * (high - low);
    match search(|x| Ok::<_, std::convert::Infallible>(function(x)), low, start, high) {
        Ok(peak) => peak,
        Err(never) => match never {},
    }
}

/// The same from a place `start` known to be high, of a function that may fail.
///
/// # Errors
/// The first error of the function ends the search.
pub fn search<E>(mut function: impl FnMut(f64) -> Result<f64, E>, low: f64, start: f64, high: f64) -> Result<Peak, E> {
    let first = Peak { place: start, value: function(start)? };
    let mut seen = Seen { low, high, best: first, second: first, third: first };
    let fine = 1e-10 * (high - low);
    let (mut step, mut step_before) = (0.0_f64, 0.0_f64);
    for _ in 0..MOST_EVALUATIONS {
        let tolerance = fine + 2.0 * f64::EPSILON * seen.best.place.abs();
        if (seen.best.place - seen.middle()).abs() + 0.5 * (seen.high - seen.low) <= 2.0 * tolerance {
            break;
        }
        (step, step_before) = match seen.parabola(tolerance).filter(|top| top.abs() < 0.5 * step_before.abs()) {
            Some(top) => (top, step),
            None => (GOLDEN * seen.wider(), seen.wider()),
        };
        let place = seen.best.place + if step.abs() >= tolerance { step } else { tolerance.copysign(step) };
        seen.learn(Peak { place, value: function(place)? });
    }
    Ok(seen.best)
}

/// The highest of the tops a function has between ascending places at which it is looked at, above both its neighbours;
/// `None` if it has none.
///
/// # Errors
/// The first error of the function ends the search.
pub fn turn<E>(mut function: impl FnMut(f64) -> Result<f64, E>, places: &[f64]) -> Result<Option<Peak>, E> {
    let values = places.iter().map(|&place| function(place)).collect::<Result<Vec<f64>, E>>()?;
    let tops = values.windows(3).zip(places.windows(3)).filter(|(three, _)| three[1] > three[0].max(three[2]));
    match tops.max_by(|(one, _), (other, _)| one[1].total_cmp(&other[1])) {
        Some((_, around)) => search(function, around[0], around[1], around[2]).map(Some),
        None => Ok(None),
    }
}

/// A place between `low` and `high` at which a function with one hump is not negative.
///
/// The search for its top ends at the first such place; `None` if the top is negative.
pub fn reaches_zero(mut function: impl FnMut(f64) -> f64, low: f64, high: f64) -> Option<f64> {
    let below = |x: f64| match function(x) {
        value if value >= 0.0 => Err(x),
        value => Ok(value),
    };
    search(below, low, low + GOLDEN * (high - low), high).err()
}

/// (3 − √5)/2.
const GOLDEN: f64 = 0.381_966_011_250_105_15;
/// More than the golden section alone needs: 0.618⁴⁸ = 1e-10, and as much again for tops hidden by rounding.
const MOST_EVALUATIONS: usize = 100;

/// The interval that holds the top, and the three best places.
struct Seen {
    low: f64,
    high: f64,
    best: Peak,
    second: Peak,
    third: Peak,
}

impl Seen {
    fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// From the best place to the farther end.
    fn wider(&self) -> f64 {
        if self.best.place < self.middle() { self.high - self.best.place } else { self.low - self.best.place }
    }

    /// Step to the top of the parabola through the three best places, if it lies inside.
    fn parabola(&self, tolerance: f64) -> Option<f64> {
        let x = self.best.place;
        let left = (x - self.second.place) * (self.third.value - self.best.value);
        let right = (x - self.third.place) * (self.second.value - self.best.value);
        let step = -0.5 * ((x - self.second.place) * left - (x - self.third.place) * right) / (left - right);
        let (after_low, before_high) = (x + step - self.low, self.high - x - step);
        if !step.is_finite() || after_low <= 0.0 || before_high <= 0.0 {
            return None;
        }
        let near_end = after_low.min(before_high) < 2.0 * tolerance;
        Some(if near_end { tolerance.copysign(self.middle() - x) } else { step })
    }

    fn learn(&mut self, new: Peak) {
        let better = new.value >= self.best.value;
        let (inside, outside) = if better { (new, self.best) } else { (self.best, new) };
        *(if outside.place < inside.place { &mut self.low } else { &mut self.high }) = outside.place;
        if better {
            (self.third, self.second, self.best) = (self.second, self.best, new);
        } else if new.value >= self.second.value || self.second.place.total_cmp(&self.best.place).is_eq() {
            (self.third, self.second) = (self.second, new);
        } else if new.value >= self.third.value || !self.three() {
            self.third = new;
        }
    }

    /// Whether the third place is one of its own.
    fn three(&self) -> bool {
        let same = |one: Peak, other: Peak| one.place.total_cmp(&other.place).is_eq();
        !same(self.third, self.best) && !same(self.third, self.second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_top_lies_between_three_places() {
        let three = |values: [f64; 3]| [0, 1, 2].map(|i| Peak { place: [0.0, 1.0, 4.0][i], value: values[i] });
        assert_eq!(top_through(three([0.0, 3.0, 0.0])), Some(Peak { place: 2.0, value: 4.0 }));
        for outside in [[0.0, 3.0, 3.0], [3.0, 3.0, 0.0], [1.0, 0.0, 1.0], [0.0; 3]] {
            assert_eq!(top_through(three(outside)), None);
        }
    }

    #[test]
    fn a_parabola_takes_few_evaluations() {
        let mut count = 0;
        let hump = |x: f64| {
            count += 1;
            1.0 - (x - 1.0 / 3.0).powi(2)
        };
        let peak = greatest(hump, 0.0, 1.0);
        assert!((peak.place - 1.0 / 3.0).abs() < 2e-8 && peak.value >= 1.0 - f64::EPSILON, "{peak:?}");
        assert!(count <= 40, "{count}");
    }

    #[test]
    fn an_error_ends_the_search() {
        assert_eq!(search(Err, 0.0, 0.25, 1.0), Err(0.25));
    }

    #[test]
    fn a_top_at_an_end_is_found() {
        assert!(greatest(|x| x, 0.0, 3.0).place > 3.0 * (1.0 - 1e-9));
        assert!(greatest(|x| -x, 0.0, 3.0).place < 3e-9);
    }

    /// The higher of two tops, though an end is higher still; none of what only rises.
    #[test]
    fn a_turn_is_a_top_between_the_ends() {
        let places: Vec<f64> = (0..=20).map(f64::from).collect();
        let waves = |x: f64| Ok::<_, ()>((0.5 * x).sin() * (0.05 * x).exp() + if x > 19.5 { 9.0 } else { 0.0 });
        let top = turn(waves, &places).unwrap().unwrap();
        // tan(x/2) = −10 beyond one wave.
        let right = 2.0 * (3.0 * std::f64::consts::PI - 10f64.atan());
        assert!((top.place - right).abs() < 1e-6, "{top:?} {right}");
        assert_eq!(turn(Ok::<_, ()>, &places), Ok(None));
        assert_eq!(turn(|x| if x > 3.0 { Err(x) } else { Ok(x) }, &places), Err(4.0));
    }

    proptest! {
        /// Corners and smooth tops of any steepness on either side.
        #[test]
        fn the_top_is_found(top in 0.001f64..0.999, left in 0.01f64..100.0, right in 0.01f64..100.0, power in 1i32..4) {
            let side = |x: f64| if x < top { left * (top - x) } else { right * (x - top) };
            let peak = greatest(|x| -side(x).powi(power), 0.0, 1.0);
            prop_assert!((peak.place - top).abs() < 4e-10 || peak.value > -1e-20, "{peak:?}");
        }

        /// A stretch above zero as narrow as a billionth of the interval is found, and none if there is none.
        #[test]
        fn narrow_stretches_are_found(top in 0.001f64..0.999, width in -9.0f64..-1.0) {
            let hump = |x: f64| 10f64.powf(width) - (x - top).abs();
            prop_assert!(reaches_zero(hump, 0.0, 1.0).is_some_and(|x| hump(x) >= 0.0));
            prop_assert_eq!(reaches_zero(|x| hump(x) - 1.0, 0.0, 1.0), None);
        }
    }
}
