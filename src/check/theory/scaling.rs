//! Stiffness, plasticity and conductance of rough contacts.

/// Exponent of the stiffness–load law of self-affine surfaces at small load, k ∝ F^{1/(1+H)}.
///
/// H is the Hurst exponent; 0.5556 at H = 0.8 (Pohrt & Popov 2012; Popov & Heß 2015, ch. 10). Holds while the
/// contact is smaller than the longest wave and larger than the shortest.
#[must_use]
pub fn stiffness_exponent(hurst: f64) -> f64 {
    1.0 / (1.0 + hurst)
}

/// The law k/(E*L) = prefactor · (F/(E* h L))^exponent with h the rms height and L the side of the nominal area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StiffnessLaw {
    /// Exponent, to be held against 1/(1 + H).
    pub exponent: f64,
    /// Dimensionless prefactor.
    pub prefactor: f64,
}

impl StiffnessLaw {
    /// The law through points (force, stiffness) by least squares of logarithms; `None` for fewer than two.
    ///
    /// `scale` is (E* [Pa], rms height h [m], side L [m]).
    #[must_use]
    pub fn fitted(points: &[(f64, f64)], (modulus, height, side): (f64, f64, f64)) -> Option<Self> {
        let scaled = points.iter().map(|(f, k)| (f / (modulus * height * side), k / (modulus * side)));
        let (exponent, prefactor) = power_law_fit(&scaled.collect::<Vec<_>>())?;
        Some(Self { exponent, prefactor })
    }
}

/// Exponent and prefactor of y = prefactor·x^exponent by least squares of logarithms over points with x, y > 0.
///
/// `None` for fewer than two different x.
#[must_use]
pub fn power_law_fit(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let logs: Vec<_> = points.iter().filter(|p| p.0 > 0.0 && p.1 > 0.0).map(|p| (p.0.ln(), p.1.ln())).collect();
    #[expect(clippy::cast_precision_loss, reason = "points are far fewer than 2^53")]
    let n = logs.len() as f64;
    let mean = logs.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
    let spread: f64 = logs.iter().map(|p| (p.0 - mean.0).powi(2)).sum();
    let covariance: f64 = logs.iter().map(|p| (p.0 - mean.0) * (p.1 - mean.1)).sum();
    let exponent = covariance / spread;
    (logs.len() > 1 && exponent.is_finite()).then(|| (exponent, (mean.1 - exponent * mean.0).exp()))
}

/// Plasticity index Ψ = E*∇z/σ₀ (Popov, Contact Mechanics and Friction, eq. 7.20).
///
/// E* effective modulus [Pa], ∇z rms slope, σ₀ hardness [Pa]. Below about 2/3 summits stay elastic at any load.
#[must_use]
pub fn plasticity_index(modulus: f64, rms_slope: f64, hardness: f64) -> f64 {
    modulus * rms_slope / hardness
}

/// Electrical conductance 1/R_c = 2k/(E*(ρ₁ + ρ₂)) [1/Ω] of any contact (Barber 2003).
///
/// k normal stiffness [N/m], E* effective modulus [Pa], ρ₁ + ρ₂ sum of the specific resistances [Ω m]. With thermal
/// resistivities the same number is the thermal conductance [W/K]. Exact for smooth and rough contacts of half-spaces.
#[must_use]
pub fn contact_conductance(stiffness: f64, modulus: f64, resistivities: f64) -> f64 {
    2.0 * stiffness / (modulus * resistivities)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_is_found_again() {
        let points: Vec<_> = (1..20).map(|k| (f64::from(k), 3.0 * f64::from(k).powf(0.6))).collect();
        let (exponent, prefactor) = power_law_fit(&points).unwrap();
        assert!((exponent - 0.6).abs() < 1e-14 && (prefactor - 3.0).abs() < 1e-13);
        assert_eq!(power_law_fit(&[(1.0, 1.0)]), None);
        assert_eq!(power_law_fit(&[(1.0, 1.0), (1.0, 2.0)]), None);
        // Hertz: k = 2E*a, F = 4/3 E* a³/R: exponent 1/3, in units E* = h = L = 1, k = 6^{1/3} R^{1/3} F^{1/3}.
        let hertz: Vec<_> = (1..9).map(|a| (4.0 / 3.0 * f64::from(a).powi(3), 2.0 * f64::from(a))).collect();
        let law = StiffnessLaw::fitted(&hertz, (1.0, 1.0, 1.0)).unwrap();
        assert!((law.exponent - 1.0 / 3.0).abs() < 1e-14 && (law.prefactor - 6f64.cbrt()).abs() < 1e-13);
    }

    /// Holm: a spot of radius a between like bodies has conductance 2a/ρ each side in series, 2a/(ρ₁ + ρ₂)·2 = 4a/(ρ₁+ρ₂); k = 2E*a.
    #[test]
    fn a_circular_spot_conducts_as_holm_says() {
        let (a, modulus, resistivities) = (1e-4, 7e10, 3e-8);
        let conductance = contact_conductance(2.0 * modulus * a, modulus, resistivities);
        assert!((conductance / (4.0 * a / resistivities) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn the_limits_of_plasticity_and_of_the_exponent() {
        assert!((plasticity_index(2e11, 0.01, 3e9) - 2.0 / 3.0).abs() < 1e-15);
        assert!((stiffness_exponent(1.0) - 0.5).abs() < 1e-15);
    }
}
