//! The cylinder that rolls with traction (Carter, Proc. R. Soc. A 112, 151, 1926; Johnson 1985, section 8.3).
//!
//! Of elastically similar half-planes a load along the surface and one across it move the surface by the same law. From
//! the shear stress μp of a contact that slips is taken that of a smaller one at its leading edge,
//!
//! > τ(x) = (μE*/2R)[√(a² − x²) − √(b² − (x − a + b)²)],   b = a√(1 − T/μP),
//!
//! so that nothing slips where the second root exists, a − 2b < x < a. The creepage is ξ = (μ/R)(a − b), and behind the stick zone the speed of slip is v(μ/R)√((a − x)(a − 2b − x)).
//!
//! # Examples
//! ```
//! use springbed::friction::Grip;
//! use springbed::friction::rolling::{RollingContact, carter};
//!
//! // Slip everywhere from the creepage μa/R on, whatever the moduli.
//! let grip = Grip { normal_modulus: 115e9, tangential_modulus: 115e9, coefficient: 0.3 };
//! let contact = RollingContact { grip, radius: 0.5, half_width: 5e-3, force: 1000.0 };
//! let law = carter::law(&contact);
//! assert!((law.limit - 300.0).abs() < 1e-12);
//! assert!((law.full_slip - 0.3 * 5e-3 / 0.5).abs() < 1e-15);
//! ```

use super::{CreepLaw, RollingContact, RollingPlace, places};

/// The traction curve, ξₛ = μa/R and n = 2.
///
/// The width and the moduli enter by P and a alone. Valid for half-planes of elastically similar bodies with a ≪ R.
#[must_use]
pub fn law(contact: &RollingContact) -> CreepLaw {
    let full_slip = contact.grip.coefficient * contact.half_width / contact.radius;
    CreepLaw { limit: contact.limit(), full_slip, order: 2 }
}

/// Pressure, shear stress and slip over the contact at a creepage, rolling at the speed `speed` v [m/s].
#[must_use]
pub fn profile(contact: &RollingContact, creepage: f64, speed: f64) -> Vec<RollingPlace> {
    let (a, radius, friction) = (contact.half_width, contact.radius, contact.grip.coefficient);
    let slips = law(contact).slipping(creepage);
    let border = a * (2.0 * slips - 1.0);
    let scale = 0.5 * contact.grip.normal_modulus / radius;
    let at = |place: f64| {
        let (ahead, behind) = (a - place, a + place);
        let normal = scale * (ahead * behind).max(0.0).sqrt();
        let (tangential, slip) = if slips >= 1.0 {
            (friction * normal, creepage.abs() - friction * place / radius)
        } else if place < border {
            (friction * normal, friction / radius * (ahead * (border - place)).sqrt())
        } else {
            // √(a + x) − √(x − a + 2b), without cancellation.
            let roots = behind.sqrt() + (place - border).sqrt();
            let difference = if roots > 0.0 { 2.0 * a * slips / roots } else { 0.0 };
            (friction * scale * ahead.max(0.0).sqrt() * difference, 0.0)
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
    use std::f64::consts::PI;

    fn contact(coefficient: f64, half_width: f64) -> RollingContact {
        let grip = Grip { normal_modulus: 2.0, tangential_modulus: 2.0, coefficient };
        let (radius, modulus) = (3.0, grip.normal_modulus);
        RollingContact { grip, radius, half_width, force: 0.25 * PI * modulus * half_width.powi(2) / radius }
    }

    /// ∫ of what is linear between the places, which are as dense at the edges as cosines.
    fn integral(places: &[RollingPlace], of: impl Fn(&RollingPlace) -> f64) -> f64 {
        let piece = |pair: &[RollingPlace]| 0.5 * (pair[1].place - pair[0].place) * (of(&pair[0]) + of(&pair[1]));
        places.windows(2).map(piece).sum()
    }

    proptest! {
        /// The stress carries the traction, and its power on what slips is what the creep takes, Tξv. Bound: trapezia of
        /// 32 cosine pieces err by some π²/(4·32²) of an integral of the order of μP, and as much of that of the power.
        #[test]
        fn stress_carries_the_traction_and_slip_takes_the_power(m in 1u8..=100, k in 1u8..=150, sign in any::<bool>()) {
            let contact = contact(f64::from(m) / 100.0, 0.1);
            let law = law(&contact);
            let creepage = law.full_slip * f64::from(k) / 100.0 * if sign { 1.0 } else { -1.0 };
            let (profile, speed) = (profile(&contact, creepage, 7.0), 7.0);
            let traction = integral(&profile, |place| place.tangential);
            prop_assert!((traction - law.traction(creepage)).abs() < 3e-3 * law.limit);
            let power = integral(&profile, |place| place.tangential * place.slip);
            let right = law.traction(creepage) * creepage * speed;
            prop_assert!((power - right).abs() < 3e-3 * law.limit * creepage.abs() * speed, "{power} {right}");
        }
    }

    /// Where it sticks the strain of both surfaces makes up for the creepage, elsewhere what is left slips: from the stress
    /// on 40 000 strips, each with its logarithm. Bound: a stress that is constant over a strip of the width h errs by
    /// some h/a of itself; the places are far from where it begins like a root.
    #[test]
    fn strips_under_the_stress_are_strained_by_the_creepage() {
        let (contact, slips, strips) = (contact(0.4, 0.1), 0.3, 40_000);
        let (a, modulus) = (contact.half_width, contact.grip.normal_modulus);
        let creepage = slips * law(&contact).full_slip;
        let (width, border, b) = (2.0 * a / f64::from(strips), a * (2.0 * slips - 1.0), a * (1.0 - slips));
        let root = |square: f64| square.max(0.0).sqrt();
        let stress = |x: f64| 0.4 * modulus / 6.0 * (root(a * a - x * x) - root(b * b - (x - a + b).powi(2)));
        let centre = |k: i32| -a + width * (f64::from(k) + 0.5);
        let log = |d: f64| if d.abs() < 0.1 * width { 0.0 } else { d * d.abs().ln() };
        // Mean strain −(2/πE*) ∫ q/(x − s) ds over the strip around x.
        let strain = |x: f64| {
            let of = |k: i32| {
                let d = x - centre(k);
                stress(centre(k)) * (log(d + width) - 2.0 * log(d) + log(d - width))
            };
            -2.0 / (PI * modulus * width) * (0..strips).map(of).sum::<f64>()
        };
        for k in [2_000, 4_000, 10_000, 14_000, 20_000, 30_000, 38_000] {
            let (x, found) = (centre(k), creepage + strain(centre(k)));
            let right = if x < border { 0.4 / 3.0 * ((a - x) * (border - x)).sqrt() } else { 0.0 };
            assert!((found - right).abs() < 1e-4 * creepage, "{x}: {found} {right}");
        }
    }
}
