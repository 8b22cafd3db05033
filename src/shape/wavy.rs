//! Paraboloid with concentric waves.

use super::{Paraboloid, Profile};
use crate::input::quantity::{Amplitude, Length};
use crate::numerics::quadrature;
use crate::numerics::root;
use crate::numerics::special::{struve, struve_load};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Wavy paraboloid f(r) = r²/2R + h(1 − cos kr), g(x) = x²/R + (π/2) h k x H₀(kx).
///
/// R is the radius of curvature without waves [m], h their amplitude [m], λ the wavelength [m],
/// k = 2π/λ, H₀ the Struve function (Guduru 2007; Popov & Heß 2015, ch. 4). Exact while g grows;
/// with adhesion every wave can hold a stable branch of its own and the contact is taken to be
/// connected, as in Guduru's solution. Check: R = 1, h = 0.01, λ = 0.25 gives
/// g(0.6) = 0.4180759370861762.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct WavyParaboloid {
    /// Radius of curvature without waves.
    pub radius: Length,
    /// Amplitude of the waves, half of the height from trough to crest.
    pub amplitude: Amplitude,
    /// Wavelength.
    pub wavelength: Length,
}

impl WavyParaboloid {
    fn smooth(&self) -> Paraboloid {
        Paraboloid { radius: self.radius }
    }

    fn is_wavy(&self) -> bool {
        self.amplitude.si() > 0.0
    }

    /// A quantity linear in f: that of the paraboloid and, if there are any, that of the waves.
    fn sum(&self, quantity: impl Fn(&dyn Profile) -> f64) -> f64 {
        let smooth = quantity(&self.smooth());
        if self.is_wavy() { smooth + quantity(&Waves(self)) } else { smooth }
    }

    /// k = 2π/λ.
    fn wave_number(&self) -> f64 {
        TAU / self.wavelength.si()
    }

    /// (π/2) h k.
    fn steepness(&self) -> f64 {
        FRAC_PI_2 * self.amplitude.si() * self.wave_number()
    }

    /// Rk·g′ = 2z + (π/2)hRk²·[H₀ + zH₋₁] at z = kx.
    fn scaled_slope(&self, z: f64) -> f64 {
        let value = struve(z);
        2.0 * z + self.waviness() * (value.zero + z * value.minus_one)
    }

    /// d/dz of it: 2 + (π/2)hRk²·[H₋₁ + 2/π − zH₀], by the differential equation of H₀.
    fn scaled_curvature(&self, z: f64) -> f64 {
        let value = struve(z);
        2.0 + self.waviness() * (value.minus_one + 1.0 / FRAC_PI_2 - z * value.zero)
    }

    /// (π/2)hRk².
    fn waviness(&self) -> f64 {
        self.steepness() * self.wave_number() * self.radius.si()
    }
}

/// Beyond twice as many waves the far ones are no longer resolved by quadratures.
const MOST_PANELS: usize = 500_000;

/// Step in kx of the search for a falling g: a sixteenth of a wave.
const STEP: f64 = TAU / 16.0;

/// The waves alone, f = h(1 − cos kr): every integral of the sum is a sum of integrals.
#[derive(Debug)]
struct Waves<'s>(&'s WavyParaboloid);

impl Profile for Waves<'_> {
    fn height(&self, r: f64) -> f64 {
        let half = (0.5 * self.0.wave_number() * r).sin();
        2.0 * self.0.amplitude.si() * half * half
    }

    fn reduced(&self, x: f64) -> f64 {
        self.0.steepness() * x * struve(self.0.wave_number() * x).zero
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        let z = self.0.wave_number() * x;
        let value = struve(z);
        self.0.steepness() * (value.zero + z * value.minus_one)
    }

    fn load_integral(&self, a: f64) -> f64 {
        // ∫ zH₀ dz = zH₁
        let k = self.0.wave_number();
        self.0.steepness() * a * (struve_load(k * a) / k)
    }

    fn scale(&self) -> f64 {
        self.0.wavelength.si()
    }

    fn breaks(&self, a: f64) -> Vec<f64> {
        // Two waves fit a panel of 32 nodes to rounding, products of two included.
        let step = 2.0 * self.0.wavelength.si();
        std::iter::successors(Some(step), |x| Some(x + step)).take_while(|&x| x < a).take(MOST_PANELS).collect()
    }
}

impl Profile for WavyParaboloid {
    fn height(&self, r: f64) -> f64 {
        self.sum(|part| part.height(r))
    }

    fn reduced(&self, x: f64) -> f64 {
        self.sum(|part| part.reduced(x))
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        self.sum(|part| part.reduced_slope(x))
    }

    fn load_integral(&self, a: f64) -> f64 {
        self.sum(|part| part.load_integral(a))
    }

    fn energy_integral(&self, a: f64) -> f64 {
        let (smooth, waves) = (self.smooth(), Waves(self));
        if !self.is_wavy() {
            return smooth.energy_integral(a);
        }
        let cross = |x: f64| {
            let (slope, load) = (waves.reduced_slope(x), waves.load_integral(x));
            2.0 * (slope * (smooth.load_integral(x) + load) + smooth.reduced_slope(x) * load)
        };
        smooth.energy_integral(a) + quadrature::panels(cross, (0.0, a), &self.breaks(a))
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        self.sum(|part| part.pressure_integral(r, a))
    }

    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        self.sum(|part| part.displacement_integral(r, a))
    }

    fn edge(&self, d: f64) -> Option<f64> {
        // The waves add at most a little and seldom take away: start at the paraboloid's edge.
        let most = self.smooth().edge(d)?;
        if !self.is_wavy() || d <= 0.0 {
            return Some(most);
        }
        let residual = |x: f64| self.reduced(x) - d;
        let (low, high) = root::bracket_upwards(residual, 0.0, most, f64::MAX)?;
        Some(root::within(residual, low, high))
    }

    fn scale(&self) -> f64 {
        self.radius.si().min(self.wavelength.si())
    }

    fn feature(&self) -> Option<f64> {
        self.is_wavy().then_some(self.wavelength.si())
    }

    fn first_fall(&self) -> Option<f64> {
        // |H₀ + zH₋₁| stays below 1 + 1.2√z, so beyond z = last the waves cannot turn g′ round.
        let strength = self.waviness();
        let last = (strength + 1.0).powi(2);
        let mut low = 0.0;
        while low <= last {
            let high = low + STEP;
            let curvature = |z: f64| self.scaled_curvature(z);
            if curvature(low) < 0.0 && curvature(high) >= 0.0 {
                let bottom = root::within(curvature, low, high);
                if self.scaled_slope(bottom) < 0.0 {
                    let from = (bottom - 0.5 * TAU).max(0.0);
                    return Some(root::within(|z| -self.scaled_slope(z), from, bottom) / self.wave_number());
                }
            }
            low = high;
        }
        None
    }

    fn breaks(&self, a: f64) -> Vec<f64> {
        if self.is_wavy() { Waves(self).breaks(a) } else { Vec::new() }
    }
}
