//! Kalker's exact theory of small creepages on a round contact, and a curve of traction that begins with it.
//!
//! T = C₁₁Ga²ξ (Kalker 1967), with the coefficient C₁₁(ν) of a/b = 1 from the table in Kalker, *Three-dimensional elastic
//! bodies in rolling contact* (1990), appendix E: 3.40, 4.12 and 5.20 at ν = 0, ¼ and ½. Between them 1/C₁₁, which is all but
//! linear in ν, is laid through all three; the three digits of the table are all there is. G and ν are those of two
//! bodies together, 1/G = ½(1/G₁ + 1/G₂) and ν/G = ½(ν₁/G₁ + ν₂/G₂); they follow from the effective
//! moduli, E* = G/(1 − ν) and G* = 2G/(2 − ν).
//!
//! # Examples
//! ```
//! use springbed::friction::rolling::kalker;
//!
//! assert!((kalker::longitudinal(0.25).unwrap() - 4.12).abs() < 1e-14);
//! assert!(kalker::longitudinal(-0.1).is_none());
//! ```

use super::{CreepLaw, RollingContact};
use crate::friction::Grip;

/// C₁₁ of a round contact at Poisson's ratios 0, ¼ and ½.
const TABLE: [f64; 3] = [3.40, 4.12, 5.20];

/// The coefficient C₁₁ at Poisson's ratio `poisson` from 0 to ½; `None` outside of the table.
#[must_use]
pub fn longitudinal(poisson: f64) -> Option<f64> {
    let rounded = 1e-9;
    if !(-rounded..=0.5 + rounded).contains(&poisson) {
        return None;
    }
    let [first, middle, last] = TABLE.map(f64::recip);
    let t = 4.0 * poisson;
    let compliance = first + t * (middle - first) + 0.5 * t * (t - 1.0) * (last - 2.0 * middle + first);
    Some(compliance.recip())
}

/// Shear modulus G [Pa] and Poisson's ratio ν of both bodies together.
#[must_use]
pub fn together(grip: &Grip) -> (f64, f64) {
    // E*/G* = (2 − ν)/(2 − 2ν).
    let ratio = grip.normal_modulus / grip.tangential_modulus;
    let poisson = 2.0 * (ratio - 1.0) / (2.0 * ratio - 1.0);
    ((1.0 - poisson) * grip.normal_modulus, poisson)
}

/// C₁₁ of the bed: its creep stiffness 2G*a² over Ga², 4/(2 − ν).
#[must_use]
pub fn longitudinal_of_bed(grip: &Grip) -> f64 {
    let (_, poisson) = together(grip);
    4.0 / (2.0 - poisson)
}

/// The cube of Vermeulen & Johnson with Kalker's beginning, ξₛ = 3μP/(C₁₁Ga²)
/// (Shen, Hedrick & Elkins 1983); `None` outside of Kalker's table.
///
/// Exact at small creepages and at μP; between them it has the form of the cube, not of the exact theory.
#[must_use]
pub fn law(contact: &RollingContact) -> Option<CreepLaw> {
    let (shear, poisson) = together(&contact.grip);
    let stiffness = longitudinal(poisson)? * shear * contact.half_width.powi(2);
    Some(CreepLaw { limit: contact.limit(), full_slip: 3.0 * contact.limit() / stiffness, order: 3 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::{Modulus, Poisson};
    use crate::input::table::InMemory;
    use crate::material::{Body, Elastic, joined};
    use proptest::prelude::*;

    fn body(young: f64, poisson: f64) -> Body {
        let (young, poisson) = (Modulus::new(young).unwrap(), Poisson::new(poisson).unwrap());
        Body::Elastic(Elastic { young, poisson, yield_stress: None })
    }

    proptest! {
        /// G and ν of Kalker's own formulas, from the moduli of the pair. Bound: roundings, and those of ν again as E*/G*
        /// approaches 1.
        #[test]
        fn bodies_together(e in 1u16..=1000, n in 0i32..=10, rigid in any::<bool>()) {
            let (young, poisson) = (f64::from(e) * 1e8, 0.05 * f64::from(n));
            let first = body(young, poisson);
            let other = if rigid { Body::Rigid } else { first.clone() };
            let pair = joined(&(first, other), &InMemory::default(), None).unwrap().unwrap().pair;
            let grip = Grip { normal_modulus: pair.normal, tangential_modulus: pair.tangential, coefficient: 0.3 };
            let right = 0.5 * young / (1.0 + poisson) * if rigid { 2.0 } else { 1.0 };
            let (shear, found) = together(&grip);
            prop_assert!((shear / right - 1.0).abs() < 1e-13 && (found - poisson).abs() < 1e-14, "{} {}", shear, found);
            let bed = 2.0 * grip.tangential_modulus / shear;
            prop_assert!((longitudinal_of_bed(&grip) / bed - 1.0).abs() < 1e-13);
        }

        /// C₁₁ grows with ν, and the bed always lies below it.
        #[test]
        fn the_bed_is_too_compliant(n in 0i32..500) {
            let at = |n: i32| longitudinal(0.001 * f64::from(n)).unwrap();
            prop_assert!(at(n + 1) > at(n));
            let bed = 4.0 / (2.0 - 0.001 * f64::from(n));
            prop_assert!((0.5..0.6).contains(&(bed / at(n))));
        }
    }

    #[test]
    fn the_table_is_met_and_left_nowhere() {
        for (poisson, right) in [(0.0, 3.40), (0.25, 4.12), (0.5, 5.20)] {
            assert!((longitudinal(poisson).unwrap() / right - 1.0).abs() < 1e-14);
        }
        assert_eq!((longitudinal(-0.01), longitudinal(0.51), longitudinal(f64::NAN)), (None, None, None));
    }
}
