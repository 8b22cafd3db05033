//! Relaxation and retardation of one spring: the same material seen from the strain and from the load.

use super::secular::{self, Pole, Zero};
use crate::material::Relaxation;

/// Relaxation spectrum E*(t) = E∞ + Σ Eᵢ e^(−t/τᵢ) with its exact retardation spectrum
/// J(t) = 1/E(0) + Σ Jₘ (1 − e^(−t/λₘ)) (+ t/η₀ for a liquid).
///
/// E∞, Eᵢ are moduli [Pa], τᵢ relaxation times [s], λₘ retardation times [s], Jₘ compliances [1/Pa],
/// η₀ = η + Σ Eᵢτᵢ the viscosity of a liquid [Pa s]. The times interlace, τ₁ < λ₁ < τ₂ < … (Gross
/// 1953, *Mathematical Structure of the Theories of Viscoelasticity*, ch. 5). A parallel dashpot η
/// takes away the instantaneous compliance 1/E(0) and brings one more, short, retardation time.
/// Terms of equal time are merged; terms of zero modulus or zero time are dropped, so that a series
/// of such terms is exactly the elastic spring.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    equilibrium: f64,
    viscosity: f64,
    terms: Vec<Element>,
    modes: Vec<Mode>,
}

/// One Maxwell element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Element {
    /// Modulus Eᵢ [Pa].
    pub modulus: f64,
    /// Relaxation time τᵢ [s].
    pub time: f64,
}

/// One retardation mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Retardation time λₘ [s].
    pub time: f64,
    /// Compliance Jₘ [1/Pa].
    pub compliance: f64,
    /// 1 / (λₘ − τᵢ) for every term i [1/s], free of cancellation.
    pub(crate) inverse_gaps: Vec<f64>,
}

impl Spectrum {
    /// The spectrum of a relaxation function.
    #[must_use]
    pub fn new(relaxation: &Relaxation) -> Self {
        Self::of(relaxation.equilibrium, relaxation.viscosity, merged(&relaxation.terms))
    }

    /// A material of modulus `modulus` [Pa] that remembers nothing.
    #[must_use]
    pub fn elastic(modulus: f64) -> Self {
        Self::of(modulus, 0.0, Vec::new())
    }

    fn of(equilibrium: f64, viscosity: f64, terms: Vec<Element>) -> Self {
        let poles = poles(&terms, viscosity);
        let dashpot = poles.len() - terms.len();
        let zeros = secular::roots(&poles, equilibrium);
        let compliances = secular::compliances(&poles, equilibrium, &zeros);
        let mode = |(zero, compliance): (&Zero, f64)| Mode {
            time: zero.value(&poles),
            compliance,
            inverse_gaps: zero.gaps(&poles).skip(dashpot).map(f64::recip).collect(),
        };
        let modes = zeros.iter().zip(compliances).map(mode).collect();
        Self { equilibrium, viscosity, terms, modes }
    }

    /// This material in series with another: the pair of two half-spaces, as a Prony series again.
    ///
    /// 1/E'(p) = 1/E₁(p) + 1/E₂(p): in the rate P = −p this sum has a pole at each 1/λₘ of both and, of a liquid,
    /// one at zero; its zeros, which stand between them, are the new 1/τᵢ and its residues there the new moduli.
    /// Exact for all spectra.
    /// Check: one Maxwell element (E, τ) with an elastic body E₂ gives the time τ (E + E₂)/E₂; two equal bodies
    /// give half the moduli at the same times.
    #[must_use]
    pub fn in_series_with(&self, other: &Self) -> Self {
        let (modes, fluidity) = ([&self.modes[..], &other.modes[..]].concat(), self.fluidity() + other.fluidity());
        let rates: Vec<(f64, f64)> =
            modes.iter().map(|mode| (mode.compliance / mode.time, mode.time.recip())).collect();
        let retarded = merged(&rates).into_iter().map(|pole| Pole { time: pole.time, weight: pole.modulus });
        let flow = (fluidity > 0.0).then_some(Pole { time: 0.0, weight: fluidity });
        let poles: Vec<Pole> = flow.into_iter().chain(retarded).collect();
        let floor = self.glass_compliance() + other.glass_compliance();
        let zeros = secular::roots(&poles, floor);
        let moduli = secular::compliances(&poles, floor, &zeros);
        let term = |(zero, modulus): (&Zero, f64)| (modulus, zero.value(&poles).recip());
        let terms: Vec<_> = zeros.iter().zip(moduli).map(term).collect();
        Self::of(
            together(self.equilibrium, other.equilibrium),
            together(self.viscosity, other.viscosity),
            merged(&terms),
        )
    }

    /// E∞ [Pa].
    #[must_use]
    pub fn equilibrium(&self) -> f64 {
        self.equilibrium
    }

    /// Viscosity η of the parallel dashpot [Pa s].
    #[must_use]
    pub fn viscosity(&self) -> f64 {
        self.viscosity
    }

    /// Maxwell elements in ascending order of their times.
    #[must_use]
    pub fn terms(&self) -> &[Element] {
        &self.terms
    }

    /// Retardation modes in ascending order of their times.
    #[must_use]
    pub fn modes(&self) -> &[Mode] {
        &self.modes
    }

    /// E*(0) [Pa], the dashpot apart.
    #[must_use]
    pub fn instantaneous(&self) -> f64 {
        self.equilibrium + self.terms.iter().map(|term| term.modulus).sum::<f64>()
    }

    /// E*(t) [Pa] at the time `t` ≥ 0 [s].
    #[must_use]
    pub fn relaxation(&self, t: f64) -> f64 {
        self.equilibrium + self.terms.iter().map(|term| term.modulus * (-t / term.time).exp()).sum::<f64>()
    }

    /// Storage modulus E′(ω) = E∞ + Σ Eᵢ ω²τᵢ²/(1+ω²τᵢ²) [Pa] at the angular frequency `omega` [rad/s].
    #[must_use]
    pub fn storage(&self, omega: f64) -> f64 {
        let part = |term: &Element| term.modulus / (1.0 + (omega * term.time).powi(-2));
        self.equilibrium + self.terms.iter().map(part).sum::<f64>()
    }

    /// Loss modulus E″(ω) = ωη + Σ Eᵢ ωτᵢ/(1+ω²τᵢ²) [Pa] at the angular frequency `omega` [rad/s].
    #[must_use]
    pub fn loss(&self, omega: f64) -> f64 {
        let part = |term: &Element| {
            let x = omega * term.time;
            term.modulus / (x + x.recip())
        };
        self.viscosity * omega + self.terms.iter().map(part).sum::<f64>()
    }

    /// Creep compliance J(t) [1/Pa] at the time `t` ≥ 0 [s] after a step of the load.
    #[must_use]
    pub fn creep(&self, t: f64) -> f64 {
        let retarded = |mode: &Mode| -mode.compliance * (-t / mode.time).exp_m1();
        self.glass_compliance() + t * self.fluidity() + self.modes.iter().map(retarded).sum::<f64>()
    }

    /// 1/E*(0) [1/Pa]; zero behind a parallel dashpot, which does not give at once.
    #[must_use]
    pub fn glass_compliance(&self) -> f64 {
        if self.viscosity > 0.0 { 0.0 } else { self.instantaneous().recip() }
    }

    /// 1/η₀ [1/(Pa s)], the rate at which a liquid flows in the end; zero for a solid.
    #[must_use]
    pub fn fluidity(&self) -> f64 {
        if self.equilibrium > 0.0 {
            return 0.0;
        }
        let flow = self.viscosity + self.terms.iter().map(|term| term.modulus * term.time).sum::<f64>();
        if flow > 0.0 { flow.recip() } else { 0.0 }
    }

    /// A time [s] in which nothing relaxes to the last bit: how long a jump is made to last. A dashpot alone has no time of
    /// its own, and goes no way that counts in this one.
    #[must_use]
    pub fn instant(&self) -> f64 {
        let retarded = self.modes.first().map_or(f64::INFINITY, |mode| mode.time);
        let shortest = self.shortest_time().min(retarded);
        match (shortest.is_finite(), self.viscosity > 0.0) {
            (true, _) => 1e-20 * shortest,
            (false, true) => 1e-30,
            (false, false) => 1.0,
        }
    }

    /// The relaxation function this is the spectrum of.
    #[must_use]
    pub fn relaxation_function(&self) -> Relaxation {
        let terms = self.terms.iter().map(|term| (term.modulus, term.time)).collect();
        Relaxation { equilibrium: self.equilibrium, terms, viscosity: self.viscosity }
    }

    /// Shortest relaxation time [s]; infinite for an elastic spring.
    #[must_use]
    pub fn shortest_time(&self) -> f64 {
        self.terms.first().map_or(f64::INFINITY, |term| term.time)
    }
}

/// Two in series, of which either may be none.
fn together(one: f64, two: f64) -> f64 {
    let (soft, stiff) = (one.min(two), one.max(two));
    if soft > 0.0 { soft / (1.0 + soft / stiff) } else { 0.0 }
}

/// Terms in ascending order, equal times merged, terms without effect dropped.
fn merged(terms: &[(f64, f64)]) -> Vec<Element> {
    let mut sorted: Vec<(f64, f64)> = terms.iter().copied().filter(|&(e, tau)| e > 0.0 && tau > 0.0).collect();
    sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut merged: Vec<Element> = Vec::with_capacity(sorted.len());
    for (modulus, time) in sorted {
        match merged.last_mut() {
            Some(last) if last.time.total_cmp(&time).is_eq() => last.modulus += modulus,
            _ => merged.push(Element { modulus, time }),
        }
    }
    merged
}

/// Poles of E(p): one per Maxwell element, and one at time zero for the dashpot.
fn poles(terms: &[Element], viscosity: f64) -> Vec<Pole> {
    let dashpot = (viscosity > 0.0).then_some(Pole { time: 0.0, weight: viscosity });
    let elements = terms.iter().map(|term| Pole { time: term.time, weight: term.modulus * term.time });
    dashpot.into_iter().chain(elements).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::viscoelastic::laws::{Recipe, recipe, recipe_or_dashpot};
    use proptest::prelude::*;

    /// E(p) = E∞ + ηp + Σ Eᵢ pτᵢ/(1+pτᵢ), the operational modulus.
    fn operational(spectrum: &Spectrum, p: f64) -> f64 {
        let part = |term: &Element| term.modulus / (1.0 + (p * term.time).recip());
        spectrum.equilibrium() + spectrum.viscosity() * p + spectrum.terms().iter().map(part).sum::<f64>()
    }

    /// The operational compliance from the modes.
    fn compliance(spectrum: &Spectrum, p: f64) -> f64 {
        let part = |mode: &Mode| mode.compliance / (1.0 + p * mode.time);
        spectrum.glass_compliance() + spectrum.fluidity() / p + spectrum.modes().iter().map(part).sum::<f64>()
    }

    /// Bound: the zeros and residues of either way, from relaxation to creep and back.
    fn adds_compliances(one: &Spectrum, two: &Spectrum, p: f64) -> Result<(), TestCaseError> {
        let pair = operational(&one.in_series_with(two), p);
        let expected = (operational(one, p).recip() + operational(two, p).recip()).recip();
        prop_assert!((pair / expected - 1.0).abs() < 1e-12, "{pair:e} {expected:e}");
        Ok(())
    }

    #[test]
    fn one_maxwell_element_by_hand() {
        // Standard solid: λ = τ E(0)/E∞, J₁ = 1/E∞ − 1/E(0).
        let spectrum = Spectrum::new(&Relaxation { equilibrium: 2.0, terms: vec![(6.0, 0.5)], viscosity: 0.0 });
        let mode = &spectrum.modes()[0];
        assert!((mode.time - 2.0).abs() < 1e-15 && (mode.compliance - 0.375).abs() < 1e-16, "{mode:?}");
        let pair = spectrum.in_series_with(&Spectrum::elastic(8.0));
        assert!((pair.equilibrium() - 1.6).abs() < 1e-15);
        assert!((pair.instantaneous() - 4.0).abs() < 1e-15);
        assert!((pair.terms()[0].time - 0.5 * 16.0 / 10.0).abs() < 1e-15);
    }

    #[test]
    fn terms_without_effect_are_elastic_to_the_last_bit() {
        let with = Relaxation { equilibrium: 0.3, terms: vec![(0.0, 1.0), (5.0, 0.0)], viscosity: 0.0 };
        let without = Relaxation { equilibrium: 0.3, terms: vec![], viscosity: 0.0 };
        assert_eq!(Spectrum::new(&with), Spectrum::new(&without));
    }

    #[test]
    fn equal_times_are_one_term() {
        let twice = Relaxation { equilibrium: 0.3, terms: vec![(1.0, 2.0), (1.0, 1.0), (3.0, 2.0)], viscosity: 0.0 };
        let once = Relaxation { equilibrium: 0.3, terms: vec![(1.0, 1.0), (4.0, 2.0)], viscosity: 0.0 };
        assert_eq!(Spectrum::new(&twice), Spectrum::new(&once));
    }

    /// Polyisobutylene, 30 terms over 18 decades (`configs/polyisobutylene_prony.csv`).
    fn polyisobutylene() -> Spectrum {
        let table = include_str!("../../configs/polyisobutylene_prony.csv");
        let number = |text: &str| text.trim().parse::<f64>().unwrap();
        let rows = table.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
        let terms = rows.map(|row| row.split_once(',').unwrap()).map(|(tau, g)| (number(g), number(tau))).collect();
        Spectrum::new(&Relaxation { equilibrium: 0.0, terms, viscosity: 0.0 })
    }

    #[test]
    fn a_real_liquid_over_forty_decades() {
        let spectrum = polyisobutylene();
        assert_eq!((spectrum.terms().len(), spectrum.modes().len()), (30, 29));
        for k in -200..200 {
            let p = 10f64.powf(0.1 * f64::from(k));
            let product = operational(&spectrum, p) * compliance(&spectrum, p);
            assert!((product - 1.0).abs() < 1e-12, "{p:e}: {product:e}");
        }
    }

    /// |E(p)·p J(p) − 1| at its greatest over forty decades of p.
    fn inverts(recipe: &Recipe) -> f64 {
        let spectrum = Spectrum::new(&recipe.relaxation());
        let off = |p: f64| (operational(&spectrum, p) * compliance(&spectrum, p) - 1.0).abs();
        (-200..200).map(|k| off(10f64.powf(0.1 * f64::from(k)))).fold(0.0, f64::max)
    }

    /// One zero on either side of a pole, 1e-5 of its time away: their sum is known better than each.
    #[test]
    fn two_zeros_about_a_pole_of_small_weight() {
        let recipe = Recipe { equilibrium: None, terms: vec![(48, 1), (-51, -99)], viscosity: Some(-51) };
        assert!(inverts(&recipe) < 1e-14);
    }

    /// Of a liquid, E₁τ₁ = E₂τ₂: the zero stands in the middle between the poles.
    #[test]
    fn a_zero_halfway_between_two_poles() {
        for (equal, viscosity) in [((-11, 13), None), ((-60, 62), None), ((-15, 23), Some(8))] {
            let recipe = Recipe { equilibrium: None, terms: vec![equal, (equal.0 - 49, equal.1 + 49)], viscosity };
            assert!(inverts(&recipe) < 1e-14, "{recipe:?}");
        }
    }

    proptest! {
        /// E(p)·p J(p) = 1 over all decades: both sides are sums of positive terms, so the bound is
        /// the rounding of 2 × 30 terms, of 30 quotients in each and of the zeros.
        #[test]
        fn retardation_inverts_relaxation(recipe in recipe_or_dashpot(30), k in -200i32..200) {
            let spectrum = Spectrum::new(&recipe.relaxation());
            let p = 10f64.powf(0.1 * f64::from(k));
            let product = operational(&spectrum, p) * compliance(&spectrum, p);
            prop_assert!((product - 1.0).abs() < 3e-14, "{product:e} {spectrum:?}");
        }

        #[test]
        fn times_interlace(recipe in recipe(30)) {
            let spectrum = Spectrum::new(&Recipe { viscosity: None, ..recipe }.relaxation());
            for (k, mode) in spectrum.modes().iter().enumerate() {
                prop_assert!(mode.time >= spectrum.terms()[k].time && mode.compliance > 0.0);
                prop_assert!(spectrum.terms().get(k + 1).is_none_or(|next| mode.time <= next.time));
            }
        }

        /// 1/E'(p) = 1/E(p) + 1/E_e.
        #[test]
        fn an_elastic_partner_adds_its_compliance(recipe in recipe(20), k in -200i32..200, e in -60i32..60) {
            let elastic = Spectrum::elastic(10f64.powf(0.1 * f64::from(e)));
            adds_compliances(&Spectrum::new(&recipe.relaxation()), &elastic, 10f64.powf(0.1 * f64::from(k)))?;
        }

        /// 1/E'(p) = 1/E₁(p) + 1/E₂(p), whichever comes first.
        #[test]
        fn two_bodies_add_their_compliances(one in recipe(12), two in recipe(12), k in -200i32..200) {
            let (one, two) = (Spectrum::new(&one.relaxation()), Spectrum::new(&two.relaxation()));
            adds_compliances(&one, &two, 10f64.powf(0.1 * f64::from(k)))?;
            prop_assert_eq!(one.in_series_with(&two), two.in_series_with(&one));
        }

        /// Two equal bodies are one of half the modulus.
        #[test]
        fn equal_bodies_halve_the_moduli(recipe in recipe(12), k in -200i32..200) {
            let (one, p) = (Spectrum::new(&recipe.relaxation()), 10f64.powf(0.1 * f64::from(k)));
            let both = one.in_series_with(&one);
            prop_assert_eq!(both.terms().len(), one.terms().len());
            prop_assert!((2.0 * operational(&both, p) / operational(&one, p) - 1.0).abs() < 1e-13);
        }
    }
}
