//! Whether steady sliding under friction of rate and state lasts, or breaks up into stick and slip.
//!
//! A contact of stiffness κ that carries the force F slides steadily at V, drawn by a mass m on a spring k and a damper c. Of a
//! disturbance exp(pt) of the slip the friction changes by (F p/V)[a − b/(1 + pD_c/V)] and the force of machine and contact by
//! −K(p), 1/K = 1/κ + 1/(m p² + c p + k); both laws of the state agree there (Ruina 1983; Rice & Ruina, *J. Appl. Mech.* **50**
//! (1983) 343). Steady sliding is lost where their sum vanishes at p = iω. Without damping that is at ω = (V/D_c)√((b − a)/a)
//! and k = k_c + mω², 1/k_c = D_c/F(b − a) − 1/κ: rigid bodies have F(b − a)/D_c · [1 + mV²/(F a D_c)]. With one ω² is the root
//! of a quadratic equation.
//!
//! # Examples
//! ```
//! use springbed::drive::machine::{Carried, Suspension, Threshold, threshold};
//! use springbed::friction::RateState;
//! use springbed::input::quantity::{Length, Ratio, Speed};
//!
//! let ratio = |value: f64| Ratio::new(value);
//! let law = RateState {
//!     coefficient: ratio(0.6)?, direct: ratio(0.01)?, evolution: ratio(0.015)?,
//!     distance: Length::new(1e-5)?, speed: Speed::new(1e-6)?, law: None, state: None,
//! };
//! // 100 N on a contact far stiffer than that: k_c = 100 · 0.005/10 µm, and ω = 0.1 √½ 1/s.
//! let suspension = Suspension { mass: 1e-9, stiffness: 1e5, damping: 0.0 };
//! let Threshold::At { stiffness, pulse, .. } = threshold(&law, 1e-6, (&suspension, Carried { force: 100.0, stiffness: 1e15 })) else {
//!     return Err("no threshold".into());
//! };
//! assert!((stiffness / 5e4 - 1.0).abs() < 1e-9 && (pulse / 0.1 / 0.5f64.sqrt() - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::Suspension;
use crate::friction::RateState;

/// What a contact carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carried {
    /// Normal force F [N].
    pub force: f64,
    /// Stiffness κ [N/m] along the surface of the contact that sticks, 2G*a.
    pub stiffness: f64,
}

/// Below which stiffness steady sliding is lost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Threshold {
    /// No spring is too soft: friction grows with the speed of steady sliding, or the damper outweighs its fall.
    Never,
    /// No spring is stiff enough: the contact itself gives more than D_c/F(b − a).
    Always,
    /// Below a stiffness of the spring.
    At {
        /// Critical stiffness k [N/m].
        stiffness: f64,
        /// Angular frequency ω [rad/s] of the motion there.
        pulse: f64,
        /// Stiffness [N/m] below which the damper, held by a soft contact, keeps sliding steady again; zero where it does not.
        held: f64,
    },
}

impl Threshold {
    /// Whether steady sliding lasts with a spring of the stiffness `stiffness` [N/m].
    #[must_use]
    pub fn is_steady(&self, stiffness: f64) -> bool {
        match self {
            Self::Never => true,
            Self::Always => false,
            Self::At { stiffness: critical, held, .. } => stiffness > *critical || stiffness < *held,
        }
    }
}

/// Threshold of steady sliding at the speed `speed` [m/s], above zero, of a contact under `carried` in a machine; its own stiffness does not enter.
#[must_use]
pub fn threshold(law: &RateState, speed: f64, (machine, carried): (&Suspension, Carried)) -> Threshold {
    let ((a, b), Carried { force, stiffness: contact }) = (law.effects(speed), carried);
    let (drag, distance) = (machine.damping * speed / force, law.distance.si());
    // Displacements of the contact over D_c, for a change of the friction by one.
    let give = force / distance / contact;
    if give * (b - a) >= 1.0 {
        return Threshold::Always;
    }
    // (F/D_c)(re − i im) is the friction over the slip, and K at the threshold.
    let at = |square: f64| {
        let omega = square.sqrt();
        let (re, im) = (b * square / (1.0 + square), omega * (a - b / (1.0 + square)));
        let size = re * re + im * im;
        let (soft, late) = (re / size - give, im / size);
        let spring = force / distance * soft / (soft * soft + late * late);
        let pulse = omega * speed / distance;
        (spring + machine.mass * pulse * pulse, pulse)
    };
    let mut found: Vec<(f64, f64)> = squares((a, b), (drag, give)).map(at).filter(|at| at.0 > 0.0).collect();
    found.sort_by(|one, other| one.0.total_cmp(&other.0));
    match found[..] {
        [] => Threshold::Never,
        [.., (stiffness, pulse)] => {
            let held = if found.len() > 1 { found[0].0 } else { 0.0 };
            Threshold::At { stiffness, pulse, held }
        }
    }
}

/// The roots (ωD_c/V)² above zero of what machine and friction lose in a period, a quadratic polynomial.
///
/// One where friction falls by more than the drag grows; of less, two or none.
fn squares((a, b): (f64, f64), (drag, give): (f64, f64)) -> impl Iterator<Item = f64> {
    let (apart, constant) = (give * (b - a), b - a - drag);
    let linear = -a - drag * (1.0 - 2.0 * give * b + apart * apart);
    let quadratic = -drag * (give * a) * (give * a);
    let root = (linear * linear - 4.0 * quadratic * constant).sqrt();
    let sum = -0.5 * (linear + root.copysign(linear));
    // Without a real root none of them is a number.
    [sum / quadratic, constant / sum].into_iter().filter(|square| *square > 0.0 && square.is_finite())
}
