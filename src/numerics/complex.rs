//! Complex numbers, rounded the same on every machine.
//!
//! # Examples
//! ```
//! use springbed::numerics::complex::Complex;
//!
//! let i = Complex { re: 0.0, im: 1.0 };
//! assert_eq!(i * i, Complex::from(-1.0));
//! assert_eq!((i * i).sqrt(), i);
//! ```

use std::ops::{Add, Mul, Sub};

/// A complex number.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Complex {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
}

impl Complex {
    /// r e^{iφ} of the size `size` and the angle `angle` [rad].
    #[must_use]
    pub fn polar(size: f64, angle: f64) -> Self {
        Self { re: size * libm::cos(angle), im: size * libm::sin(angle) }
    }

    /// The conjugate.
    #[must_use]
    pub fn conjugate(self) -> Self {
        Self { im: -self.im, ..self }
    }

    /// 1/z.
    #[must_use]
    pub fn inverse(self) -> Self {
        let size = self.re.hypot(self.im);
        Self { re: self.re / size / size, im: -self.im / size / size }
    }

    /// |z|².
    #[must_use]
    pub fn square(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    /// The root with a positive real part; of a number below zero the one above the real axis.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let size = self.re.hypot(self.im);
        let half = (0.5 * (size + self.re.abs())).sqrt();
        let other = 0.5 * self.im / half;
        if self.re >= 0.0 { Self { re: half, im: other } } else { Self { re: other.abs(), im: half.copysign(self.im) } }
    }
}

impl From<f64> for Complex {
    fn from(re: f64) -> Self {
        Self { re, im: 0.0 }
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl Mul<f64> for Complex {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { re: self.re * factor, im: self.im * factor }
    }
}
