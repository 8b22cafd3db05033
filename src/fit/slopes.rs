//! Numbers that carry their slopes along.
//!
//! What follows from a rate r [1/s] of a relaxation, and from the speed ḋ [m/s] of an indenter, is computed once, with its
//! slopes in both beside it (forward differentiation by the chain rule), or without them.

use std::ops::{Add, Mul};

/// Slopes of a response in the numbers that it follows from, one per point of the curve.
#[derive(Debug, Clone, Default)]
pub struct Slopes {
    /// In the numbers of the bodies, in their order [unit of the response over theirs].
    pub numbers: Vec<Vec<f64>>,
    /// In first touch [N/m].
    pub touch: Vec<f64>,
}

/// A number that follows from a rate and a speed.
pub trait Number: Copy + Add<Output = Self> + Mul<Output = Self> + Mul<f64, Output = Self> {
    /// Whether slopes are carried.
    const SLOPES: bool;

    /// A number that follows from neither.
    fn constant(value: f64) -> Self;

    /// A rate.
    fn rate(value: f64) -> Self;

    /// A speed.
    fn speed(value: f64) -> Self;

    /// The number itself.
    fn value(self) -> f64;

    /// What follows from it: its value and its slope in this number.
    fn then(self, value: f64, slope: f64) -> Self;

    /// e^{−rh} of the rate r over the time `h`.
    fn faded(self, h: f64) -> Self {
        let kept = (-self.value() * h).exp();
        self.then(kept, -h * kept)
    }

    /// ∫₀^h e^{−rs} ds of the rate r.
    fn held(self, h: f64) -> Self {
        let y = self.value() * h;
        let parts = held(y);
        self.then(h * parts, if Self::SLOPES { h * h * held_slope(y, parts) } else { 0.0 })
    }
}

/// (1 − e^{−y})/y.
#[must_use]
pub fn held(y: f64) -> f64 {
    if y > 0.0 { -(-y).exp_m1() / y } else { 1.0 }
}

/// The slope of it, (e^{−y} − (1 − e^{−y})/y)/y; below `SMALL` by its series −½ + y/3 − y²/8 + …, (−1)^k k y^{k−1}/(k + 1)!.
fn held_slope(y: f64, held: f64) -> f64 {
    const SMALL: f64 = 0.1;
    if y > SMALL {
        return ((-y).exp() - held) / y;
    }
    let (mut sum, mut power) = (0.0, -1.0);
    for k in 1..10 {
        let k = f64::from(k);
        power /= k;
        sum += power * k / (k + 1.0);
        power *= -y;
    }
    sum
}

impl Number for f64 {
    const SLOPES: bool = false;

    fn constant(value: f64) -> Self {
        value
    }

    fn rate(value: f64) -> Self {
        value
    }

    fn speed(value: f64) -> Self {
        value
    }

    fn value(self) -> f64 {
        self
    }

    fn then(self, value: f64, _slope: f64) -> Self {
        value
    }
}

/// A number with its slopes.
#[derive(Debug, Clone, Copy)]
pub struct Sloped {
    /// The number itself.
    pub value: f64,
    /// Slope in the rate.
    pub by_rate: f64,
    /// Slope in the speed.
    pub by_speed: f64,
}

impl Add for Sloped {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            by_rate: self.by_rate + other.by_rate,
            by_speed: self.by_speed + other.by_speed,
        }
    }
}

impl Mul for Sloped {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            by_rate: self.value * other.by_rate + self.by_rate * other.value,
            by_speed: self.value * other.by_speed + self.by_speed * other.value,
        }
    }
}

impl Mul<f64> for Sloped {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self.then(self.value * factor, factor)
    }
}

impl Number for Sloped {
    const SLOPES: bool = true;

    fn constant(value: f64) -> Self {
        Self { value, by_rate: 0.0, by_speed: 0.0 }
    }

    fn rate(value: f64) -> Self {
        Self { value, by_rate: 1.0, by_speed: 0.0 }
    }

    fn speed(value: f64) -> Self {
        Self { value, by_rate: 0.0, by_speed: 1.0 }
    }

    fn value(self) -> f64 {
        self.value
    }

    fn then(self, value: f64, slope: f64) -> Self {
        Self { value, by_rate: slope * self.by_rate, by_speed: slope * self.by_speed }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against central differences, at rates from slow to fast: h²/6 of third slopes and rounding over 2h.
    #[test]
    fn slopes_are_those_of_differences() {
        for y in [0.02, 0.09, 0.11, 0.19, 0.21, 0.5, 3.0, 40.0] {
            let h = 1e-5 * f64::max(y, 1e-2);
            for of in [Number::held, Number::faded] as [fn(Sloped, f64) -> Sloped; 2] {
                let at = |rate: f64| of(Sloped::rate(rate), 2.0);
                let rate = 0.5 * y;
                let slope = (at(rate + h).value - at(rate - h).value) / (2.0 * h);
                assert!((at(rate).by_rate - slope).abs() < 1e-8 * (1.0 + slope.abs()), "{y} {slope}");
            }
        }
        // What does not fade: h − rh²/2 of the time h.
        let still = Sloped::rate(0.0).held(2.0);
        assert!((still.value - 2.0).abs() < 1e-15 && (still.by_rate + 2.0).abs() < 1e-15, "{still:?}");
    }
}
