//! Real contact area with adhesion of a randomly rough surface, after Persson.

use super::greenwood_williamson::laplace_moment;
use super::pressure_field::area_fraction;
use super::survival::survival;
use crate::shape::rough::RoughnessSpectrum;
use std::f64::consts::{FRAC_2_SQRT_PI, PI, SQRT_2, TAU};

/// A rough surface on an elastic half-space that stick with a work of adhesion.
///
/// Theory of Persson 2002 as used in Persson et al. 2008, section 2. Seen with waves up to q, the contact pressure diffuses,
/// ∂P/∂t = ∂²P/∂σ² with t = E*² s²(q)/8 and s(q) the rms slope of these waves, and is lost at the detachment stress
/// σ = −σ_a(q), σ_a = √(γ_eff(q) E* q), that of a crack of radius π/2q. The effective energy follows from
/// γ_eff(q) A*(q) = w A*(q₁) − U_el(q), with A* the true surface of the contact seen up to q and
/// U_el = (πE*/2) ∫_q^{q₁} q² C A/A₀ dq the energy of the shorter waves; below zero it is zero. The numerical factor in σ_a is of order one
/// in the theory; areas and the moduli at which regions change inherit that uncertainty. On approach and pull-off
/// surfaces differ; the branch taken here is the one reached from full contact.
#[derive(Debug, Clone, Copy)]
pub struct AdhesiveRoughness<'a> {
    /// Power spectrum of the surface.
    pub spectrum: &'a RoughnessSpectrum,
    /// Effective modulus E* [Pa].
    pub modulus: f64,
    /// Work of adhesion w of flat surfaces [J/m²].
    pub work: f64,
}

/// The contact at one nominal pressure, seen at all magnifications.
#[derive(Debug, Clone, PartialEq)]
pub struct AdhesiveContact {
    /// Wavevectors q [rad/m] up to which roughness is seen, from the longest wave to the shortest.
    pub wavevectors: Vec<f64>,
    /// Area in contact over nominal area when seen up to q.
    pub area_fractions: Vec<f64>,
    /// Effective work of adhesion γ_eff(q) [J/m²] per area of contact; the first is that of the macroscopic contact.
    pub effective_work: Vec<f64>,
}

/// How the real area depends on the load (Persson et al. 2008, figure 6).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Region {
    /// Proportional to the load within a tenth: stiff bodies, E > E₂.
    Linear,
    /// Not proportional, but zero at zero load: E₁ < E < E₂.
    Nonlinear,
    /// Not zero at zero load; a force is needed to part the bodies: E < E₁.
    Sticking,
}

/// The effective energy did not settle, which happens next to a jump between two branches.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "the effective work of adhesion did not settle at a pressure of {pressure:e} Pa: last change {change:e} of the work of adhesion"
)]
pub struct NotSettled {
    /// Nominal pressure [Pa].
    pub pressure: f64,
    /// Last relative change.
    pub change: f64,
}

/// Steps of the logarithm of q.
const WAVES: usize = 200;
/// Damped iterations of the effective energy and the relative change at which they stop.
const ITERATIONS: usize = 400;
const SETTLED: f64 = 1e-7;

impl AdhesiveRoughness<'_> {
    /// The contact at a nominal pressure [Pa], zero or above.
    ///
    /// # Errors
    /// The effective energy does not settle.
    pub fn at(&self, pressure: f64) -> Result<AdhesiveContact, NotSettled> {
        self.resolved(pressure, WAVES)
    }

    fn resolved(&self, pressure: f64, steps: usize) -> Result<AdhesiveContact, NotSettled> {
        let waves = Waves::of(self.spectrum, steps);
        let mut work = vec![self.work; waves.edges.len()];
        let mut change = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let areas = self.areas(&waves, &work, pressure);
            let next = self.effective(&waves, &areas);
            change = work.iter().zip(&next).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()))
                / self.work.max(f64::MIN_POSITIVE);
            if change < SETTLED {
                let area_fractions = self.areas(&waves, &next, pressure);
                return Ok(AdhesiveContact { wavevectors: waves.edges, area_fractions, effective_work: next });
            }
            work.iter_mut().zip(&next).for_each(|(a, b)| *a = 0.5 * (*a + b));
        }
        Err(NotSettled { pressure, change })
    }

    /// Ratio of the real areas with and without adhesion at a pressure [Pa] in the linear region: the slope ratio of
    /// Persson et al. 2008, figure 7.
    ///
    /// # Errors
    /// The effective energy does not settle.
    pub fn slope_ratio(&self, pressure: f64) -> Result<f64, NotSettled> {
        Ok(self.at(pressure)?.real_area_fraction() / area_fraction(pressure, self.modulus, self.spectrum.rms_slope()))
    }

    /// How the area depends on the load up to a pressure [Pa].
    ///
    /// # Errors
    /// The effective energy does not settle.
    pub fn region(&self, largest_pressure: f64) -> Result<Region, NotSettled> {
        if self.at(0.0)?.real_area_fraction() > 0.0 {
            return Ok(Region::Sticking);
        }
        let per_pressure = |p: f64| Ok(self.at(p)?.real_area_fraction() / p);
        let (small, large) = (per_pressure(0.1 * largest_pressure)?, per_pressure(largest_pressure)?);
        Ok(if (large / small - 1.0).abs() < 0.1 { Region::Linear } else { Region::Nonlinear })
    }

    /// Area fraction at each edge: survival of the diffusing pressure above the falling detachment stress.
    fn areas(&self, waves: &Waves, work: &[f64], pressure: f64) -> Vec<f64> {
        let times: Vec<_> = waves.slopes.iter().map(|s| 0.125 * self.modulus * self.modulus * s).collect();
        let detachment = |(w, q): (&f64, &f64)| -(w * self.modulus * q).sqrt();
        let edges: Vec<_> = work.iter().zip(&waves.edges).map(detachment).collect();
        survival(pressure, &times, &edges)
    }

    /// γ_eff at each edge from the areas.
    fn effective(&self, waves: &Waves, areas: &[f64]) -> Vec<f64> {
        let last = areas.len() - 1;
        let surface = |k: usize| areas[k] * true_surface(waves.slopes[k].sqrt());
        let mut energy = 0.0;
        let mut effective = vec![self.work; areas.len()];
        for k in (0..last).rev() {
            energy += 0.5 * PI * self.modulus * waves.bends[k] * 0.5 * (areas[k] + areas[k + 1]);
            let bound = self.work * surface(last) - energy;
            effective[k] = if bound > 0.0 { bound / surface(k) } else { 0.0 };
        }
        effective
    }
}

impl AdhesiveContact {
    /// Real over nominal area, all waves seen.
    #[must_use]
    pub fn real_area_fraction(&self) -> f64 {
        self.area_fractions.last().copied().unwrap_or(0.0)
    }

    /// Macroscopic work of adhesion γ_eff [J/m²] per nominal area in contact; a pull-off force needs it above zero.
    #[must_use]
    pub fn macroscopic_work(&self) -> f64 {
        self.effective_work.first().copied().unwrap_or(0.0)
    }
}

/// Integrals of the spectrum on evenly spaced logarithms of q.
struct Waves {
    edges: Vec<f64>,
    /// Mean square slope of the waves up to each edge.
    slopes: Vec<f64>,
    /// ∫ q² C dq between neighbouring edges.
    bends: Vec<f64>,
}

impl Waves {
    #[expect(clippy::cast_precision_loss, reason = "a few hundred steps")]
    fn of(spectrum: &RoughnessSpectrum, steps: usize) -> Self {
        let (low, high) = spectrum.cut_offs();
        let octaves = (high / low).ln();
        let edges: Vec<_> = (0..=steps).map(|k| low * (octaves * k as f64 / steps as f64).exp()).collect();
        let between =
            |power: i32| edges.windows(2).map(|e| spectrum.power_moment(power, (e[0], e[1]))).collect::<Vec<_>>();
        let mut slopes = vec![0.0];
        for part in between(3) {
            slopes.push(slopes[slopes.len() - 1] + TAU * part);
        }
        let bends = between(2);
        Self { edges, slopes, bends }
    }
}

/// True over projected area of a Gaussian surface of rms slope s: ∫₀^∞ √(1 + s²x) e^{−x} dx = 1 + (√π s/2) e^{1/s²} erfc(1/s)
/// (Persson & Tosatti 2001).
fn true_surface(rms_slope: f64) -> f64 {
    if rms_slope <= 0.0 {
        return 1.0;
    }
    // e^{x²} erfc(x) = √(2/π) ∫ e^{−√2 x s − s²/2} ds, without overflow.
    let scaled = FRAC_2_SQRT_PI / SQRT_2 * laplace_moment(0.0, SQRT_2 / rms_slope);
    1.0 + 0.5 * PI.sqrt() * rms_slope * scaled
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::root;

    /// Six decades, H as given, true area 1.37 of the nominal one and rms height as in Persson et al. 2008, figure 1.
    fn figure_one(hurst: f64, rms: f64) -> RoughnessSpectrum {
        let slope = root::brent(|s| true_surface(s) - 1.37, 0.1, 3.0).unwrap();
        let shape =
            |q: f64| RoughnessSpectrum::table(&[(q, 1.0), (1e6 * q, 1e6f64.powf(-2.0 * (1.0 + hurst)))]).unwrap();
        // s/h of the shape is proportional to q.
        let unit = shape(1.0);
        let q = slope / rms / (unit.rms_slope() / unit.rms_height());
        let s = shape(q);
        s.scaled((rms / s.rms_height()).powi(2))
    }

    fn rough(spectrum: &RoughnessSpectrum, young: f64) -> AdhesiveRoughness<'_> {
        AdhesiveRoughness { spectrum, modulus: young / 0.75, work: 0.05 }
    }

    #[test]
    fn the_true_surface_has_its_limits() {
        assert!((true_surface(1e-4) - 1.0 - 0.5e-8).abs() < 1e-15);
        assert!((true_surface(1e4) / (0.5 * PI.sqrt() * 1e4) - 1.0).abs() < 1e-3);
        let direct = crate::numerics::quadrature::panels(
            |x: f64| (1.0 + x).sqrt() * (-x).exp(),
            (0.0, 40.0),
            &[1.0, 3.0, 8.0, 20.0],
        );
        assert!((true_surface(1.0) - direct).abs() < 1e-13);
    }

    /// Without adhesion the area is erf(√2p/E*s) at every magnification, to rounding: the boundary stays at zero.
    #[test]
    fn without_adhesion_the_area_is_the_error_function() {
        let spectrum = figure_one(0.8, 1.01e-6);
        let dry = AdhesiveRoughness { work: 0.0, ..rough(&spectrum, 15e6) };
        for pressure in [1e3, 1e5, 1e7] {
            let contact = dry.at(pressure).unwrap();
            let exact = area_fraction(pressure, dry.modulus, spectrum.rms_slope());
            assert!((contact.real_area_fraction() - exact).abs() < 1e-12, "{pressure}");
            assert!((dry.slope_ratio(pressure).unwrap() - 1.0).abs() < 1e-9);
        }
    }

    /// The three regions of figure 6 in their order, for both surfaces of figure 1 up to the 0.1 MPa of the paper.
    #[test]
    fn softer_bodies_pass_through_the_three_regions() {
        let (rough_08, rough_06) = (figure_one(0.8, 1.01e-6), figure_one(0.6, 0.66e-6));
        for (spectrum, young, region) in [
            (&rough_08, 1e6, Region::Sticking),
            (&rough_08, 3.5e6, Region::Nonlinear),
            (&rough_08, 15e6, Region::Linear),
            (&rough_06, 7e6, Region::Sticking),
            (&rough_06, 120e6, Region::Linear),
        ] {
            assert_eq!(rough(spectrum, young).region(1e5), Ok(region), "{young:e}");
        }
        // At zero load D_f = 2.2 is in contact over about 95 % when E ≈ 1 MPa, says the paper; the spectrum's long cut-off, which
        // it gives in a figure only, is taken from rms height and true area here, hence the width.
        let contact = rough(&rough_08, 1e6).at(0.0).unwrap();
        assert!((0.93..0.99).contains(&contact.real_area_fraction()), "{}", contact.real_area_fraction());
        assert!(contact.macroscopic_work() > 0.0 && contact.macroscopic_work() < 1.37 * 0.05);
    }

    /// The slope ratio of figure 7 rises as the body softens and is 1 for a stiff one; the area does not hang on the steps.
    #[test]
    fn the_slope_ratio_rises_as_the_body_softens() {
        let spectrum = figure_one(0.8, 1.01e-6);
        let ratios = [1e13, 5e8, 15e6].map(|young| rough(&spectrum, young).slope_ratio(1e3).unwrap());
        assert!(
            ratios[0] < 1.03 && ratios[0] > 1.0 && ratios[1] > 1.2 * ratios[0] && ratios[2] > 1.2 * ratios[1],
            "{ratios:?}"
        );
        let area = |steps| rough(&spectrum, 15e6).resolved(1e5, steps).unwrap().real_area_fraction();
        assert!((area(100) / area(200) - 1.0).abs() < 0.005);
    }
}
