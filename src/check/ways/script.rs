//! The usual ways, as most scripts have them, to be measured beside ours.

use crate::material::Relaxation;

/// A motion in equal steps.
pub struct Steps {
    /// Depth after each step [m].
    pub depths: Vec<f64>,
    /// Length of a step [s].
    pub step: f64,
}

impl Steps {
    /// Forces [N] on a bed of a Prony material by explicit Euler steps: ṡᵢ = Eᵢu̇ − sᵢ/τᵢ with all on the
    /// right side taken at the beginning of the step, and no tension.
    ///
    /// `heights` are g at the springs, `width` is Δx, both halves together. Of first order; explodes for
    /// steps beyond 2τ.
    #[must_use]
    pub fn explicit_euler(&self, relaxation: &Relaxation, heights: &[f64], width: f64) -> Vec<f64> {
        let terms = &relaxation.terms;
        let mut loads = vec![0.0; heights.len() * terms.len()];
        let mut pressed = vec![0.0f64; heights.len()];
        let mut forces = Vec::with_capacity(self.depths.len());
        for depth in &self.depths {
            let mut sum = 0.0;
            for ((height, u), s) in heights.iter().zip(&mut pressed).zip(loads.chunks_exact_mut(terms.len())) {
                let gap = (depth - height).max(0.0);
                let rate = gap - *u;
                *u = gap;
                let mut load = relaxation.equilibrium * gap;
                for ((modulus, time), s) in terms.iter().zip(s) {
                    *s += modulus * rate - *s * self.step / time;
                    load += *s;
                }
                sum += if gap > 0.0 { load.max(0.0) } else { 0.0 };
            }
            forces.push(2.0 * width * sum);
        }
        forces
    }
}

/// Contact time [s] of a mass on a Hertz spring F = k d^{3/2} by velocity Verlet, as particle codes
/// have it: steps of `step` [s] until the bodies part, the last one shortened along a straight line.
#[must_use]
pub fn verlet_contact_time(stiffness: f64, mass: f64, speed: f64, step: f64) -> f64 {
    let acceleration = |d: f64| -stiffness / mass * d.max(0.0).powf(1.5);
    let (mut d, mut v, mut t) = (0.0f64, speed, 0.0);
    loop {
        let half = v + 0.5 * step * acceleration(d);
        let next = d + step * half;
        if next <= 0.0 || half.is_nan() {
            return t + step * d / (d - next);
        }
        v = half + 0.5 * step * acceleration(next);
        (d, t) = (next, t + step);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solid() -> Relaxation {
        Relaxation { equilibrium: 1.0, terms: vec![(3.0, 0.1)], viscosity: 0.0 }
    }

    /// A spring held after a step decays as 1 + 3(1 − h/τ)ⁿ; beyond h = 2τ it explodes.
    #[test]
    fn euler_decays_by_its_own_factor_and_explodes_beyond_two_relaxation_times() {
        let forces = Steps { depths: vec![1.0; 50], step: 0.01 }.explicit_euler(&solid(), &[0.0], 0.5);
        for (n, force) in (0..).zip(&forces) {
            assert!((force - 1.0 - 3.0 * 0.9f64.powi(n)).abs() < 1e-14);
        }
        let exploding = Steps { depths: vec![1.0; 50], step: 0.25 }.explicit_euler(&solid(), &[0.0], 0.5);
        assert!(exploding[49].max(exploding[48]) > 1e6);
    }

    /// 2.943275 x₀/v (Johnson 1985, eq. 11.23); of second order.
    #[test]
    fn verlet_is_of_second_order() {
        let depth = (15.0 / 16.0 * 4.0 / 3.0f64).powf(0.4);
        let error = |steps: f64| {
            (verlet_contact_time(1.0, 1.0, 1.0, depth / steps) / (2.943_275_184_324_705 * depth) - 1.0).abs()
        };
        assert!(error(1000.0) < 1e-4 && error(4000.0) < 0.2 * error(1000.0), "{} {}", error(1000.0), error(4000.0));
    }
}
