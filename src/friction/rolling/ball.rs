//! A ball that rolls with traction, on one line of independent springs (Popov & Heß 2015, ch. 6).
//!
//! The line is that of the method of dimensionality reduction, laid in the direction of rolling: it is not cut into strips
//! across. A spring touched at the leading edge a sticks to both bodies and is strained by the creepage, q_x = G*ξ(a − x),
//! until that is μ times what presses it, μE*(a² − x²)/R; from there to the trailing edge it slips. So it sticks
//! where x > −a + ξRG*/(μE*), and
//!
//! > T/(μP) = 1 − (1 − |ξ|/ξₛ)³,   ξₛ = 2μ(E*/G*) a/R.
//!
//! That is the cube of Vermeulen & Johnson (1964), but the bed is too compliant: a spring does not feel the traction of
//! those beside it, which strain the half-space along the surface. At small creepages T = 2G*a²ξ = 4/(2 − ν) Ga²ξ, where
//! Kalker's exact theory has C₁₁Ga²ξ: 2.00 against 3.40 at ν = 0, 2.67 against 5.20 at ν = ½. The limit μP is
//! the same. See [`super::kalker`] for the curve of the same form with the exact beginning.
//!
//! # Examples
//! ```
//! use springbed::friction::Grip;
//! use springbed::friction::rolling::{RollingContact, ball};
//!
//! // Slip everywhere from the creepage 2μ(E*/G*)a/R on.
//! let grip = Grip { normal_modulus: 115e9, tangential_modulus: 92e9, coefficient: 0.3 };
//! let contact = RollingContact { grip, radius: 0.5, half_width: 5e-3, force: 1000.0 };
//! let law = ball::law(&contact);
//! assert!((law.limit - 300.0).abs() < 1e-12);
//! assert!((law.full_slip - 2.0 * 0.3 * (115.0 / 92.0) * 5e-3 / 0.5).abs() < 1e-15);
//! ```

use super::{CreepLaw, RollingContact, RollingPlace, places};

/// The traction curve of the bed, ξₛ = 2μ(E*/G*)a/R and n = 3.
#[must_use]
pub fn law(contact: &RollingContact) -> CreepLaw {
    let full_slip = 2.0 * contact.grip.reach() * contact.half_width / contact.radius;
    CreepLaw { limit: contact.limit(), full_slip, order: 3 }
}

/// Line loads and slip over the bed at a creepage, rolling at the speed `speed` v [m/s].
#[must_use]
pub fn profile(contact: &RollingContact, creepage: f64, speed: f64) -> Vec<RollingPlace> {
    let (a, grip) = (contact.half_width, contact.grip);
    let border = a * (2.0 * law(contact).slipping(creepage) - 1.0);
    let at = |place: f64| {
        let normal = grip.normal_modulus / contact.radius * (a - place) * (a + place);
        let (tangential, slip) = if place < border || border >= a {
            (grip.coefficient * normal, creepage.abs() - 2.0 * grip.reach() * place / contact.radius)
        } else {
            (grip.tangential_modulus * creepage.abs() * (a - place), 0.0)
        };
        RollingPlace {
            place,
            normal,
            tangential: tangential.copysign(creepage),
            slip: (speed * slip).copysign(creepage),
        }
    };
    places(a, border).into_iter().map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::Grip;
    use proptest::prelude::*;

    fn contact(coefficient: f64, tangential_modulus: f64) -> RollingContact {
        let grip = Grip { normal_modulus: 2.0, tangential_modulus, coefficient };
        let (radius, half_width) = (3.0, 0.1f64);
        RollingContact { grip, radius, half_width, force: 4.0 / 3.0 * 2.0 * half_width.powi(3) / radius }
    }

    /// The springs one by one, each led from the leading edge to the trailing one in steps of a spring.
    fn rolled(contact: &RollingContact, creepage: f64, springs: u32) -> (f64, f64) {
        let (a, grip) = (contact.half_width, contact.grip);
        let width = 2.0 * a / f64::from(springs);
        let (mut strain, mut traction, mut slipped) = (0.0f64, 0.0, 0.0);
        for spring in 0..springs {
            let x = a - width * (f64::from(spring) + 0.5);
            let normal = grip.normal_modulus / contact.radius * (a * a - x * x);
            strain += creepage * if spring == 0 { 0.5 * width } else { width };
            let held = grip.coefficient * normal / grip.tangential_modulus;
            let slip = (strain - held).max(0.0);
            strain -= slip;
            traction += grip.tangential_modulus * strain * width;
            slipped += grip.tangential_modulus * strain * slip;
        }
        (traction, slipped)
    }

    proptest! {
        /// Bound: a spring on either side of the border of stick, and one that the last slip leaves at the trailing edge.
        #[test]
        fn springs_led_one_by_one_give_the_cube(m in 1u8..=100, g in 50u8..=100, k in 1u8..=150) {
            let contact = contact(f64::from(m) / 100.0, f64::from(g) / 50.0);
            let law = law(&contact);
            let creepage = law.full_slip * f64::from(k) / 100.0;
            let (traction, work) = rolled(&contact, creepage, 4000);
            let right = law.traction(creepage);
            prop_assert!((traction - right).abs() < 1e-3 * law.limit, "{traction} {right}");
            // Work of slip per way of rolling: the power Tξv over the speed.
            prop_assert!((work - right * creepage).abs() < 4e-3 * law.limit * law.full_slip, "{work}");
        }

        /// Stick to rounding where nothing slips: T = 2G*a²ξ(1 − s + s²/3) with the part s = ξ/ξₛ that slips.
        #[test]
        fn small_creepages_are_linear(m in 1u8..=100, g in 50u8..=100, k in 1i32..=12) {
            let contact = contact(f64::from(m) / 100.0, f64::from(g) / 50.0);
            let (law, s) = (law(&contact), 10f64.powi(-k));
            let stiffness = 2.0 * contact.grip.tangential_modulus * contact.half_width.powi(2);
            prop_assert!((law.stiffness() / stiffness - 1.0).abs() < 1e-14);
            let creepage = s * law.full_slip;
            let right = stiffness * creepage * (1.0 - s + s * s / 3.0);
            prop_assert!((law.traction(creepage) / right - 1.0).abs() < 1e-13);
            let back = law.creepage(law.traction(creepage)).unwrap();
            prop_assert!((back / creepage - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn beyond_the_full_slip_all_is_carried_by_friction() {
        let contact = contact(0.3, 1.5);
        let law = law(&contact);
        for part in [1.0, 1.5, 1e6] {
            assert_eq!(law.traction(part * law.full_slip).to_bits(), law.limit.to_bits());
            assert_eq!(law.traction(-part * law.full_slip).to_bits(), (-law.limit).to_bits());
        }
        assert_eq!(law.creepage(1.01 * law.limit), None);
        assert!((law.creepage(law.limit).unwrap() / law.full_slip - 1.0).abs() < 1e-15);
        let slippery = RollingContact { grip: Grip { coefficient: 0.0, ..contact.grip }, ..contact };
        assert_eq!(super::law(&slippery).traction(0.1).to_bits(), 0f64.to_bits());
        assert_eq!(super::law(&slippery).creepage(0.0), Some(0.0));
    }
}
