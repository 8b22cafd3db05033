//! Two bodies pressed together: their effective moduli, what they relax by, what lies below their surfaces.

use super::alone::{Alone, Known, Stiffness, in_series};
use super::elastic::Elastic;
use super::layered::Under;
use super::power_law::Times;
use super::viscoelastic::instantly_stiff;
use super::{Body, Relaxation, Spectrum, stacked};
use crate::input::problem::Problem;
use crate::input::table::Tables;
use serde::Serialize;

/// Effective moduli of a pair of bodies.
///
/// 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂ and 1/G* = (2−ν₁)/(4G₁) + (2−ν₂)/(4G₂), where a rigid body adds
/// nothing (Popov, Contact Mechanics and Friction, eqs. 5.26 and 8.22). Of a viscoelastic body the instantaneous moduli are meant,
/// of one that is a dashpot alone its viscosities [Pa s] in their place;
/// with a constant ν the ratio G*/E* = 2(1−ν)/(2−ν) holds at all times.
/// Check: E = 210 GPa, ν = 0.3 on a rigid body gives E* = 230.77 GPa and G* = 190.05 GPa.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Pair {
    /// E* [Pa], above zero.
    pub normal: f64,
    /// G* [Pa], above zero.
    pub tangential: f64,
    /// Dundurs' β = ½ [(1−2ν₁)/G₁ − (1−2ν₂)/G₂] / [(1−ν₁)/G₁ + (1−ν₂)/G₂] (Johnson 1985,
    /// eq. 5.3): normal and tangential contact are independent where it vanishes.
    pub coupling: f64,
}

impl Pair {
    /// The same pair in plane strain: a line load moves the surface along itself by the same law whether it presses or
    /// shears, G* = E* (Johnson 1985, eq. 2.25).
    #[must_use]
    pub fn long_across(self) -> Self {
        Self { tangential: self.normal, ..self }
    }
}

/// Two bodies that are pressed together.
#[derive(Debug, Clone, PartialEq)]
pub struct Joined {
    /// Effective moduli; instantaneous ones of a viscoelastic pair.
    pub pair: Pair,
    /// E*(t) if one of the bodies is viscoelastic.
    pub relaxation: Option<Relaxation>,
    /// What lies below the surfaces.
    pub under: Under,
}

/// What `bodies` are together; `None` for two rigid ones, which make no pair.
///
/// Each half-space is pressed in by its own 1/E*ᵢ(p) times the same pressure, whatever its ν: the sum is
/// exact for constant ν, in the normal direction and without friction.
///
/// A power law is known between `times`; `None` too where there is one, and no times.
///
/// # Errors
/// A table of terms is wrong, or a body has no modulus; all problems at once.
pub fn joined(
    bodies: &(Body, Body),
    tables: &dyn Tables,
    times: Option<Times>,
) -> Result<Option<Joined>, Vec<Problem>> {
    let known = Known { tables, times };
    let (one, two) = (alone(&bodies.0, "bodies.0", known), alone(&bodies.1, "bodies.1", known));
    let (one, two) = match (one, two) {
        (Ok(one), Ok(two)) => (one, two),
        (one, two) => return Err(one.err().into_iter().chain(two.err()).flatten().collect()),
    };
    if times.is_none() && [&bodies.0, &bodies.1].into_iter().any(|body| body.power_law().is_some()) {
        return Ok(None);
    }
    let pair = Pair::of(&one.stiffness, &two.stiffness);
    let (shares, _) = in_series(one.stiffness.normal, two.stiffness.normal);
    let under = Under::both(one.under, two.under, shares);
    let both = match (one.spectrum, two.spectrum) {
        (None, None) => return Ok(None),
        (Some(spectrum), None) | (None, Some(spectrum)) => spectrum,
        (Some(one), Some(two)) => one.in_series_with(&two),
    };
    if !bodies.0.relaxes() && !bodies.1.relaxes() {
        return Ok(Some(Joined { pair, relaxation: None, under }));
    }
    Ok(Some(Joined {
        pair: pair.as_stiff_as(both.instantaneous()),
        relaxation: Some(both.relaxation_function()),
        under,
    }))
}

fn alone(body: &Body, path: &str, known: Known<'_>) -> Result<Alone, Vec<Problem>> {
    let under = Under::HalfSpaces;
    Ok(match body {
        Body::Rigid => Alone { stiffness: Stiffness::RIGID, spectrum: None, under },
        Body::Elastic(body) => elastic(body),
        Body::Plastic(body) => elastic(&body.elastic()),
        Body::Viscoelastic(body) => {
            let relaxation = instantly_stiff(body, path, known).map_err(|problem| vec![problem])?;
            let modulus = relaxation.instantaneous();
            let at_once = if modulus > 0.0 { modulus } else { relaxation.viscosity };
            let stiffness = Stiffness::new(at_once, body.poisson.si());
            Alone { stiffness, spectrum: Some(Spectrum::new(&relaxation)), under }
        }
        Body::Layered(body) => stacked::layered(body, path, known)?,
        Body::Winkler(body) => stacked::winkler(body),
        Body::Graded(body) => stacked::graded(body),
    })
}

fn elastic(body: &Elastic) -> Alone {
    let spectrum = Some(Spectrum::elastic(body.plane_modulus()));
    Alone { stiffness: body.stiffness(), spectrum, under: Under::HalfSpaces }
}

impl Pair {
    fn of(one: &Stiffness, two: &Stiffness) -> Self {
        let (shares, normal) = in_series(one.normal, two.normal);
        let (_, tangential) = in_series(one.tangential, two.tangential);
        Self { normal, tangential, coupling: shares.0 * one.coupling - shares.1 * two.coupling }
    }

    /// The same with E* = `normal` [Pa], if it is above zero, and G* in its ratio to it.
    fn as_stiff_as(self, normal: f64) -> Self {
        if normal > 0.0 { Self { normal, tangential: normal * (self.tangential / self.normal), ..self } } else { self }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Shear, Term, Terms, Viscoelastic};
    use super::*;
    use crate::input::quantity::{Duration, Modulus, Poisson, Stress, Viscosity};
    use crate::input::table::InMemory;
    use proptest::prelude::*;

    fn elastic(young: f64, poisson: f64) -> Body {
        let (young, poisson) = (Modulus::new(young).unwrap(), Poisson::new(poisson).unwrap());
        Body::Elastic(Elastic { young, poisson, yield_stress: None })
    }

    fn of(one: Body, two: Body) -> Pair {
        joined(&(one, two), &InMemory::default(), None).unwrap().unwrap().pair
    }

    fn rubber(terms: Terms) -> Body {
        let shear =
            Shear { equilibrium: Stress::new(0.1).unwrap(), terms, viscosity: Viscosity::default(), power_law: None };
        Body::Viscoelastic(Viscoelastic { poisson: Poisson::new(0.5).unwrap(), shear, temperature: None, shift: None })
    }

    /// Bound: a handful of roundings.
    fn near(value: f64, right: f64) -> bool {
        (value - right).abs() <= 8.0 * f64::EPSILON * right.abs()
    }

    #[test]
    fn steel_on_a_rigid_body() {
        let steel = of(elastic(210e9, 0.3), Body::Rigid);
        assert!(near(steel.normal, 210e9 / 0.91) && near(steel.tangential, 210e9 / 0.91 * 1.4 / 1.7));
        assert!(near(steel.coupling, 0.2 / 0.7));
    }

    #[test]
    fn a_viscoelastic_body_relaxes_from_its_instantaneous_modulus() {
        let term = Term { modulus: Stress::new(0.9).unwrap(), time: Duration::new(0.2).unwrap() };
        let bodies = (Body::Rigid, rubber(Terms::List(vec![term])));
        let Joined { pair, relaxation, .. } = joined(&bodies, &InMemory::default(), None).unwrap().unwrap();
        let relaxation = relaxation.unwrap();
        assert!(near(pair.normal, 4.0) && near(relaxation.equilibrium, 0.4));
        assert_eq!(relaxation.terms, [(3.6, 0.2)]);
        assert!(near(pair.tangential / pair.normal, 2.0 / 3.0), "an incompressible body: α = 2(1−ν)/(2−ν)");
    }

    #[test]
    fn a_wrong_table_of_terms_names_its_row() {
        let tables = InMemory::default().with("p.csv", &[("time_s", &[1.0, 0.0]), ("modulus_pa", &[1.0, 1.0])]);
        let bodies = (rubber(Terms::Table("p.csv".into())), Body::Rigid);
        let problems = joined(&bodies, &tables, None).unwrap_err();
        assert_eq!(problems[0].path, "bodies.0.shear.terms");
        assert!(problems[0].message.starts_with("p.csv, row 3: time_s: 0.0 s is out of range"), "{}", problems[0]);
    }

    #[test]
    fn bodies_that_make_no_pair() {
        assert_eq!(joined(&(Body::Rigid, Body::Rigid), &InMemory::default(), None).unwrap(), None);
    }

    proptest! {
        /// Order does not matter, compliances add, and nothing overflows over 600 decades.
        #[test]
        fn compliances_add(k in -300i32..300, j in -300i32..300, n in -9i32..=5, m in -9i32..=5) {
            let (one, two) = (10f64.powi(k), 10f64.powi(j));
            let (first, second) = (elastic(one, 0.1 * f64::from(n)), elastic(two, 0.1 * f64::from(m)));
            let (ab, ba) = (of(first.clone(), second.clone()), of(second.clone(), first.clone()));
            prop_assert_eq!(ab.normal.to_bits(), ba.normal.to_bits());
            prop_assert_eq!(ab.tangential.to_bits(), ba.tangential.to_bits());
            let (a, b) = (of(first, Body::Rigid), of(second, Body::Rigid));
            let (soft, stiff) = if a.normal < b.normal { (a.normal, b.normal) } else { (b.normal, a.normal) };
            prop_assert!(near(ab.normal * (1.0 + soft / stiff), soft));
            prop_assert!(near((ab.coupling + ba.coupling) + 1.0, 1.0) && ab.coupling.abs() <= 0.75);
        }
    }
}
