//! Stresses below a flat punch (Sneddon 1946), of which every axisymmetric contact is a sum.
//!
//! A line load of one over 0 ≤ x < b is the pressure 1/(π√(b²−r²)) of a flat punch. With ζ = z − ib and
//! ρ = √(r² + ζ²) its stresses are imaginary parts of elementary functions (Johnson 1985, §3.8).
//!
//! # Examples
//! ```
//! use springbed::contact::punch::Point;
//! use std::f64::consts::FRAC_1_PI;
//!
//! // Far below a flat punch under the load 2b the stress is that of a point load, σ_zz = −3F/2πz².
//! let deep = Point { radius: 0.0, depth: 100.0, poisson: 0.3 }.under_punch(1.0);
//! assert!((deep.axial / (-1.5 * FRAC_1_PI * 2.0 / 1e4) - 1.0).abs() < 1e-3);
//! ```

use crate::numerics::complex::Complex;
use std::f64::consts::FRAC_1_PI;
use std::ops::{Add, Mul};

/// Stresses at a point below the surface [Pa], tension positive.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stresses {
    /// Radial stress σ_rr.
    pub radial: f64,
    /// Hoop stress σ_θθ.
    pub hoop: f64,
    /// Axial stress σ_zz.
    pub axial: f64,
    /// Shear stress τ_rz.
    pub shear: f64,
}

impl Stresses {
    /// Equivalent stress of von Mises [Pa].
    #[must_use]
    pub fn von_mises(&self) -> f64 {
        let differences = [self.radial - self.hoop, self.hoop - self.axial, self.axial - self.radial];
        (0.5 * differences.map(|part| part * part).iter().sum::<f64>() + 3.0 * self.shear * self.shear).sqrt()
    }

    /// Largest shear stress [Pa], half the difference of the greatest and the least principal stress.
    #[must_use]
    pub fn largest_shear(&self) -> f64 {
        let middle = 0.5 * (self.radial + self.axial);
        let swing = (0.5 * (self.radial - self.axial)).hypot(self.shear);
        let (least, greatest) = (self.hoop.min(middle - swing), self.hoop.max(middle + swing));
        0.5 * (greatest - least)
    }
}

impl Add for Stresses {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            radial: self.radial + other.radial,
            hoop: self.hoop + other.hoop,
            axial: self.axial + other.axial,
            shear: self.shear + other.shear,
        }
    }
}

impl Mul<Stresses> for f64 {
    type Output = Stresses;
    fn mul(self, stress: Stresses) -> Stresses {
        Stresses {
            radial: self * stress.radial,
            hoop: self * stress.hoop,
            axial: self * stress.axial,
            shear: self * stress.shear,
        }
    }
}

/// A place below the surface of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Distance r from the axis [m].
    pub radius: f64,
    /// Depth z > 0 [m].
    pub depth: f64,
    /// Poisson's ratio ν of the body.
    pub poisson: f64,
}

impl Point {
    /// Stresses [Pa] here under the line load one [N/m] over 0 ≤ x < `b` [m].
    #[must_use]
    pub fn under_punch(&self, b: f64) -> Stresses {
        let (zeta, inverse, near) = self.inverses(b);
        let cube = inverse * inverse * inverse;
        self.stress(
            inverse.im,
            self.depth * (zeta * cube).im,
            (1.0 - 2.0 * self.poisson) * near.im - self.depth * (inverse * near).im,
            self.depth * self.radius * cube.im,
        )
    }

    /// Stresses [Pa/m] here under a line load of one newton at x = `b` [m]: their derivative.
    #[must_use]
    pub fn under_line(&self, b: f64) -> Stresses {
        let (zeta, inverse, near) = self.inverses(b);
        let cube = inverse * inverse * inverse;
        let fifth = cube * inverse * inverse;
        let bend = 3.0 * (zeta * zeta * fifth).re - cube.re;
        self.stress(
            (zeta * cube).re,
            self.depth * bend,
            (1.0 - 2.0 * self.poisson) * (inverse * near).re - self.depth * cube.re,
            3.0 * self.depth * self.radius * (zeta * fifth).re,
        )
    }

    /// Stresses σ_xx, σ_yy, σ_zz and τ_xz [Pa] here, at x = r and y = 0, where the load of
    /// [`under_punch`](Self::under_punch) does not press but drags along x.
    ///
    /// Cerruti's point load by its potentials (Johnson 1985, §3.2 and eq. 3.8) at the complex depth ζ, as the pressure
    /// is Boussinesq's (Hamilton 1983 for the sphere). With V = 1/ρ, F = ln(ρ+ζ) and Φ = ζ ln(ρ+ζ) − ρ, each
    /// integrated once over ζ: σ_xx = [2V_x − 2νΦ_xyy + z(V_xz + F_xyy)]/π, σ_yy = [2ν(V_x + Φ_xyy) − zF_xyy]/π,
    /// σ_zz = −zV_xz/π, τ_xz = (V_z − zV_xx)/π.
    #[must_use]
    pub fn under_dragged_punch(&self, b: f64) -> Stresses {
        let (zeta, inverse, near) = self.inverses(b);
        let (cube, spread) = (inverse * inverse * inverse, inverse * near);
        let (r, z) = (self.radius, self.depth);
        let (slope, bend) = (-r * spread.im, r * cube.im);
        let (across, across_deep) = (0.5 * r * (near * near).im, -r * (spread * near).im);
        let shear = -inverse.im - z * (spread - zeta * cube).im;
        let poisson = self.poisson;
        FRAC_1_PI
            * Stresses {
                radial: 2.0 * (slope - poisson * across) + z * (bend + across_deep),
                hoop: 2.0 * poisson * (slope + across) - z * across_deep,
                axial: -z * bend,
                shear,
            }
    }

    /// ζ, 1/ρ and 1/(ρ+ζ) for the distance `b`: lengths whose squares are numbers need no guarded roots.
    fn inverses(&self, b: f64) -> (Complex, Complex, Complex) {
        let (r, z) = (self.radius, self.depth);
        let (re, im) = ((r - b) * (r + b) + z * z, -2.0 * b * z);
        let size = (re * re + im * im).sqrt();
        let half = (0.5 * (size + re.abs())).sqrt();
        let other = 0.5 * im / half;
        let rho = if re >= 0.0 {
            Complex { re: half, im: other }
        } else {
            Complex { re: other.abs(), im: half.copysign(im) }
        };
        let zeta = Complex { re: z, im: -b };
        let sum = rho + zeta;
        (zeta, rho.conjugate() * size.recip(), sum.conjugate() * sum.square().recip())
    }

    /// The stresses from the transforms ∫J₀, z∫kJ₀, ∫J₁/r and z∫kJ₁ of the pressure.
    fn stress(&self, even: f64, bent: f64, spread: f64, shear: f64) -> Stresses {
        FRAC_1_PI
            * Stresses {
                radial: bent - even + spread,
                hoop: -2.0 * self.poisson * even - spread,
                axial: -even - bent,
                shear: -shear,
            }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Mean pressure one, by Boussinesq's point loads and quadrature.
    #[test]
    fn flat_punch_off_the_axis() {
        let point = Point { radius: 0.5, depth: 0.5, poisson: 0.3 };
        let stress = 0.5 * PI * point.under_punch(1.0);
        for (found, exact) in [
            (stress.radial, -0.196_653_226_654),
            (stress.hoop, -0.226_827_927_495),
            (stress.axial, -0.622_363_469_300),
            (stress.shear, -0.009_495_785_578),
        ] {
            assert!((found - exact).abs() < 2e-12, "{found} {exact}");
        }
    }

    /// Pure shear turned by any angle, and one axis alone.
    #[test]
    fn the_largest_shear_does_not_depend_on_the_axes() {
        for k in 0..8 {
            let (sine, cosine) = (0.4 * f64::from(k)).sin_cos();
            let turned = Stresses { radial: 3.0 * sine, axial: -3.0 * sine, shear: 3.0 * cosine, hoop: 0.0 };
            assert!((turned.largest_shear() - 3.0).abs() < 1e-14);
            assert!((turned.von_mises() - 27f64.sqrt()).abs() < 1e-14);
        }
        let pulled = Stresses { hoop: -2.0, ..Stresses::default() };
        assert!((pulled.largest_shear() - 1.0).abs() < 1e-15 && (pulled.von_mises() - 2.0).abs() < 1e-15);
    }

    #[test]
    fn lines_are_the_derivative_of_punches() {
        for (radius, depth) in [(0.0, 0.3), (0.2, 0.7), (1.4, 0.1)] {
            let point = Point { radius, depth, poisson: 0.3 };
            for b in [0.1, 0.8, 2.0] {
                let h = 1e-5;
                let slope = (0.5 / h) * (point.under_punch(b + h) + -1.0 * point.under_punch(b - h));
                let off = slope + -1.0 * point.under_line(b);
                for part in [off.radial, off.hoop, off.axial, off.shear] {
                    assert!(part.abs() < 1e-5, "{radius} {depth} {b} {part:e}");
                }
            }
        }
    }
}
