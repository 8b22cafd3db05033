//! Adhesion under shear: peeling of an adhesive contact by a tangential load.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::friction::peeling::{ShearedAdhesion, TangentialLoad, UNIFORM};
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // An adhesive ball, R = E* = w = 1, with nothing on it: shear makes its contact smaller than JKR's a³ = 9π/2.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let lens = ShearedAdhesion { line: EdgeLine::new(ground, 1.0), ratio: UNIFORM };
//! let rest = lens.under(0.0, TangentialLoad::Force(0.0))?.contact_radius;
//! assert!((rest.powi(3) / (4.5 * std::f64::consts::PI) - 1.0).abs() < 1e-12);
//! assert!(lens.under(0.0, TangentialLoad::Force(1.0))?.contact_radius < rest);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::FrictionError;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::adhesion::line::EdgeLine;
use crate::numerics::root::{bracket_upwards, brent, within};
use crate::shape::{Profile, Rim};
use std::f64::consts::PI;

/// Places between two radii at which an equilibrium is looked for.
const PLACES: u32 = 1024;
/// Part of the contact without shear down to which it is looked for where all of it gives way.
const LEAST: f64 = 1e-6;

/// α of a contact that sticks everywhere against a rigid body: G*/E* = 2(1−ν)/(2−ν).
///
/// ν is Poisson's ratio (Persson et al. 2008, eq. B.3). Check: 2/3 at ν = 1/2.
#[must_use]
pub fn stuck_ratio(poisson: f64) -> f64 {
    2.0 * (1.0 - poisson) / (2.0 - poisson)
}

/// α of a contact under uniform shear stress: (1−ν)/(2(A + Bν)) with A = 16/(3π²), B = −A/2.
///
/// The mean displacement of a uniformly loaded circle is 16/(3π) a p × its modulus, which gives A and
/// B in closed form; Persson et al. 2008, eq. B.2, have them rounded, A ≈ 0.55, B ≈ −0.28 (their
/// α ≈ 0.67 for ν = 1/2 is that of the stuck contact). Smaller than
/// [`stuck_ratio`] by 3π²/32 = 0.925. Check: 0.6169 at ν = 1/2.
#[must_use]
pub fn uniform_ratio(poisson: f64) -> f64 {
    UNIFORM * stuck_ratio(poisson)
}

/// Tangential stiffness of a contact under uniform stress over that of a stuck one, for any pair: 3π²/32.
pub const UNIFORM: f64 = 3.0 * PI * PI / 32.0;

/// Tangential load of an adhesive contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TangentialLoad {
    /// Tangential force F_x [N], whatever the area.
    Force(f64),
    /// Shear stress τ [Pa], the force growing with the area: F_x = πa²τ.
    Stress(f64),
}

/// Adhesive contact under a tangential load (Savkoor & Briggs 1977).
///
/// The edge is in equilibrium where E*Δl² + X = 2πaw, with Δl the elongation of the edge springs,
/// d = g(a) − Δl, F = 2E*(N(a) − aΔl), and X = F_x²/(4αE*a²) the share of the tangential load,
/// αE*u_x² in terms of the displacement (Persson et al. 2008, eqs. 5–9, there for a paraboloid).
/// a contact radius [m], w work of adhesion [J/m²], E* effective modulus [Pa], α ratio of the
/// tangential stiffness to 2E*a ([`stuck_ratio`], [`uniform_ratio`], or G*/E*).
///
/// Under forces the contact peels steadily until the critical tangential force and then jumps. The
/// condition of the jump, ∂F/∂a = 0, is Δl = 3πw/(E*g′(a)) for every profile.
/// Under a prescribed stress it shrinks without a jump until Δl = 0, the contact without adhesion.
/// Slip at the edge before peeling is left out. Valid for profiles with growing g.
#[derive(Debug, Clone)]
pub struct ShearedAdhesion {
    /// The contact without shear.
    pub line: EdgeLine,
    /// α = tangential stiffness/(2E*a).
    pub ratio: f64,
}

/// Equilibrium of a sheared adhesive contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sheared {
    /// Contact radius a [m].
    pub contact_radius: f64,
    /// Indentation d [m].
    pub indentation: f64,
    /// Tangential force F_x [N].
    pub tangential_force: f64,
    /// Tangential displacement u_x = F_x/(2αE*a) [m].
    pub slide: f64,
}

/// What is prescribed along the normal, and its value: a depth [m] or a force [N].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prescribed {
    /// What it is.
    pub control: Control,
    /// Its value.
    pub value: f64,
}

/// A contact that sticks everywhere, at a prescribed displacement u_x.
///
/// Every radius a carries αu² = X(a) with X = 2πaw/E* − e(a)² and e the elongation of the edge springs that depth or force
/// ask for, g(a) − d or (N(a) − F/2E*)/a. From the contact without shear, X = 0, the edge peels inwards as long as X grows
/// that way; at its maximum all of the contact gives way. Source: Savkoor & Briggs 1977; Persson et al. 2008, eq. 5.
/// Check: R = E* = w = α = 1 at d = 0 gives way at a = (π/2)^{1/3}, u² = (3/2)πa.
impl ShearedAdhesion {
    /// The state at the displacement u_x = `slide` [m], at most that of the state `last`, of a contact of the radius `rest` [m] without shear.
    #[must_use]
    pub fn stuck(&self, under: Prescribed, (last, rest): (Sheared, f64), slide: f64) -> Sheared {
        let share = |a: f64| self.ratio * slide * slide - self.room(under, a);
        self.at_radius(within(share, last.contact_radius, rest), under, slide)
    }

    /// The last state before all of a contact of the radius `rest` [m] gives way.
    #[must_use]
    pub fn last_stuck(&self, under: Prescribed, rest: f64) -> Sheared {
        let at = |k: u32| rest * LEAST.powf(f64::from(k) / f64::from(PLACES));
        let growth = |a: f64| {
            let (stretch, slope) = self.stretch(under, a);
            PI * self.line.work() / self.modulus() - stretch * slope
        };
        let a = match (self.wall().filter(|b| rest >= *b), (1..=PLACES).find(|&k| growth(at(k)) >= 0.0)) {
            (Some(wall), _) => wall,
            (None, Some(k)) => within(|a| -growth(a), at(k), at(k - 1)),
            (None, None) => rest,
        };
        let slide = (self.room(under, a).max(0.0) / self.ratio).sqrt();
        self.at_radius(a, under, slide)
    }

    /// What is left of the contact where its edge has given way; it slides freely. At a depth at which nothing presses the
    /// bodies, nothing is: the radius is zero.
    ///
    /// # Errors
    /// No force presses the bodies: they part, for good. The profile ends before the force is reached.
    pub fn without_edge(&self, under: Prescribed) -> Result<Sheared, FrictionError> {
        let Prescribed { control, value } = under;
        let a = match control {
            Control::Force if value <= 0.0 => None,
            Control::Indentation if value <= 0.0 => Some(0.0),
            Control::Indentation => self.profile().edge(value).or(self.wall()),
            Control::Force => Some(self.plain_radius(value).or_else(|beyond| self.wall().ok_or(beyond))?),
        };
        let parted = match control {
            Control::Indentation => FrictionError::PeeledAt { depth: value },
            Control::Force => FrictionError::Peeled { force: value },
        };
        Ok(self.at_radius(a.ok_or(parted)?, under, 0.0))
    }

    /// The contact of the radius `a` [m] displaced by `slide` [m].
    #[must_use]
    pub fn at_radius(&self, a: f64, under: Prescribed, slide: f64) -> Sheared {
        let indentation = match under.control {
            Control::Indentation => under.value,
            Control::Force => self.profile().reduced(a) - self.elongation(a, under.value),
        };
        Sheared { contact_radius: a, indentation, tangential_force: self.tangential_stiffness(a) * slide, slide }
    }

    /// Normal force of a state [N].
    #[must_use]
    pub fn force_of(&self, state: &Sheared) -> f64 {
        self.line.under_wall(state.contact_radius, state.indentation).force
    }

    /// 2αE*a [N/m].
    #[must_use]
    pub fn tangential_stiffness(&self, a: f64) -> f64 {
        2.0 * self.ratio * self.modulus() * a
    }

    /// X(a) [m²].
    fn room(&self, under: Prescribed, a: f64) -> f64 {
        let stretch = self.stretch(under, a).0;
        2.0 * PI * a * (self.line.work() / self.modulus()) - stretch * stretch
    }

    /// How far the springs at the edge are pulled [m], not at all where a wall presses them, and its slope over the radius.
    fn stretch(&self, under: Prescribed, a: f64) -> (f64, f64) {
        let slope = self.profile().reduced_slope(a);
        let (stretch, slope) = match under.control {
            Control::Indentation => (self.profile().reduced(a) - under.value, slope),
            Control::Force => {
                let stretch = self.elongation(a, under.value);
                (stretch, slope - stretch / a)
            }
        };
        if stretch > 0.0 { (stretch, slope) } else { (0.0, 0.0) }
    }
}

impl ShearedAdhesion {
    fn profile(&self) -> &dyn Profile {
        self.line.ground().profile()
    }

    fn modulus(&self) -> f64 {
        self.line.ground().modulus()
    }

    /// Contact radius [m] under the normal force `force` [N] without adhesion; zero without a load.
    ///
    /// # Errors
    /// The profile ends before the force is reached.
    pub fn plain_radius(&self, force: f64) -> Result<f64, FrictionError> {
        if force <= 0.0 {
            return Ok(self.profile().flat_radius());
        }
        self.grow(|a| 2.0 * self.modulus() * self.profile().load_integral(a) - force, force)
    }

    /// Radius [m] at which the contact jumps, and the tangential force [N] that brings it there.
    ///
    /// # Errors
    /// The bodies part under the normal force alone; the profile ends first.
    pub fn critical(&self, force: f64) -> Result<Sheared, FrictionError> {
        if let Some(b) = self.wall() {
            return self.with_share(b, force, self.edge_limit(b) - self.edge_energy(b, force));
        }
        let elongation = |a: f64| 3.0 * PI * (self.line.work() / self.modulus()) / self.profile().reduced_slope(a);
        let load = |a: f64| 2.0 * self.modulus() * (self.profile().load_integral(a) - a * elongation(a));
        let a = self.grow(|a| load(a) - force, force)?;
        self.with_share(a, force, self.edge_limit(a) - self.modulus() * elongation(a).powi(2))
    }

    /// Equilibrium under the normal force `force` [N] and a tangential load.
    ///
    /// # Errors
    /// The bodies part under the normal force alone; the tangential force is above the critical one,
    /// the stress above that of the contact without adhesion; the profile ends first.
    pub fn under(&self, force: f64, shear: TangentialLoad) -> Result<Sheared, FrictionError> {
        let share = |a: f64| match shear {
            TangentialLoad::Force(tangential) => (tangential / a).powi(2) / (4.0 * self.ratio * self.modulus()),
            TangentialLoad::Stress(stress) => (PI * stress * a).powi(2) / (4.0 * self.ratio * self.modulus()),
        };
        let excess = |a: f64| self.edge_energy(a, force) + share(a) - self.edge_limit(a);
        let least = match shear {
            TangentialLoad::Force(_) => self.critical(force)?.contact_radius,
            TangentialLoad::Stress(_) => self.plain_radius(force)?.max(f64::MIN_POSITIVE),
        };
        if excess(least) > 0.0 {
            return Err(FrictionError::Peeled { force });
        }
        let a = if self.wall().is_some() { least } else { self.grow_from(least, excess, force)? };
        let tangential = match shear {
            TangentialLoad::Force(tangential) => tangential,
            TangentialLoad::Stress(stress) => PI * a * a * stress,
        };
        self.with_force(a, force, tangential)
    }

    /// Area of contact over the area without shear, A/A_JKR, under the normal force `force` [N].
    ///
    /// Where the adhesive contact has peeled, the contact without adhesion is left (Persson et al.
    /// 2008, fig. 10: the drop from JKR to Hertz).
    /// Check: PDMS, E* = 6.4 MPa, R = 2.5 mm, w = 0.042 J/m², F = 0.048 N drops to 0.874.
    ///
    /// # Errors
    /// The bodies part under the normal force alone; the profile ends first.
    pub fn area_ratio(&self, force: f64, shear: TangentialLoad) -> Result<f64, FrictionError> {
        let rest = self.under(force, TangentialLoad::Force(0.0))?.contact_radius;
        let radius = match self.under(force, shear) {
            Ok(sheared) => sheared.contact_radius,
            Err(FrictionError::Peeled { .. }) => self.plain_radius(force)?,
            Err(error) => return Err(error),
        };
        Ok((radius / rest).powi(2))
    }

    /// Equilibrium under the normal force `force` [N] and a uniform shear stress `stress` [Pa]; where the
    /// edge has peeled, the contact without adhesion, which carries on under the stress.
    ///
    /// # Errors
    /// The bodies part under the normal force alone, or peel with nothing that presses them; the
    /// profile ends first.
    pub fn under_stress(&self, force: f64, stress: f64) -> Result<Sheared, FrictionError> {
        self.under(force, TangentialLoad::Force(0.0))?;
        match self.under(force, TangentialLoad::Stress(stress)) {
            Err(FrictionError::Peeled { .. }) if force > 0.0 => {
                let a = self.plain_radius(force)?;
                self.with_force(a, force, PI * a * a * stress)
            }
            found => found,
        }
    }

    /// Equilibrium at the indentation `depth` [m] under the uniform shear stress `stress` [Pa], reached
    /// from the radius `rest` [m] the contact has without it: the first one inwards from there.
    ///
    /// Where no edge is left to hold, the contact without adhesion remains if the bodies are pressed.
    ///
    /// # Errors
    /// The contact peels altogether, and nothing presses the bodies.
    pub fn at_depth(&self, depth: f64, stress: f64, rest: f64) -> Result<Sheared, FrictionError> {
        let scale = (PI * stress).powi(2) / (4.0 * self.ratio * self.modulus());
        let edge = |a: f64| self.profile().reduced(a) - depth;
        let excess = |a: f64| self.modulus() * edge(a).powi(2) + scale * a * a - self.edge_limit(a);
        let plain = if depth > 0.0 { self.profile().edge(depth) } else { None };
        let least = plain.unwrap_or(1e-6 * rest).min(rest);
        let held = self.first_inside(excess, (least, rest));
        let a = held.or(plain).ok_or(FrictionError::PeeledAt { depth })?;
        let tangential_force = PI * a * a * stress;
        let slide = tangential_force / (2.0 * self.ratio * self.modulus() * a);
        Ok(Sheared { contact_radius: a, indentation: depth, tangential_force, slide })
    }

    /// The first zero of `excess` on the way from `rest` inwards to `least`.
    fn first_inside(&self, excess: impl Fn(f64) -> f64, (least, rest): (f64, f64)) -> Option<f64> {
        let at = |k: u32| rest * (least / rest).powf(f64::from(k) / f64::from(PLACES));
        let k = (1..=PLACES).find(|&k| excess(at(k)) <= 0.0)?;
        let (inner, outer) = (at(k), at(k - 1));
        if excess(outer) <= 0.0 { Some(outer) } else { brent(&excess, inner, outer).ok() }
    }

    /// E*Δl² [N/m] with the elongation the normal force asks for.
    fn edge_energy(&self, a: f64, force: f64) -> f64 {
        let elongation = self.elongation(a, force);
        self.modulus() * elongation * elongation
    }

    /// How far the springs at the edge are pulled [m] under the force `force` [N].
    fn elongation(&self, a: f64, force: f64) -> f64 {
        (self.profile().load_integral(a) - 0.5 * force / self.modulus()) / a
    }

    /// 2πaw [N/m].
    fn edge_limit(&self, a: f64) -> f64 {
        2.0 * PI * a * self.line.work()
    }

    fn wall(&self) -> Option<f64> {
        match self.profile().rim() {
            Rim::Wall(b) => Some(b),
            Rim::None | Rim::End(_) => None,
        }
    }

    fn with_share(&self, a: f64, force: f64, share: f64) -> Result<Sheared, FrictionError> {
        // The share of the tangential load is what the normal load leaves; rounding of a sum of terms ≤ 2πaw.
        if share < -8.0 * f64::EPSILON * self.edge_limit(a) {
            return Err(FrictionError::Parted { force });
        }
        self.with_force(a, force, 2.0 * a * (self.ratio * self.modulus() * share.max(0.0)).sqrt())
    }

    fn with_force(&self, a: f64, force: f64, tangential_force: f64) -> Result<Sheared, FrictionError> {
        Ok(Sheared {
            contact_radius: a,
            indentation: self.profile().reduced(a) - self.elongation(a, force),
            tangential_force,
            slide: tangential_force / (2.0 * self.ratio * self.modulus() * a),
        })
    }

    /// The zero of a function that grows with the radius and is negative at small ones.
    fn grow(&self, residual: impl Fn(f64) -> f64, force: f64) -> Result<f64, FrictionError> {
        let mut low = self.profile().scale();
        while residual(low) > 0.0 && low > f64::MIN_POSITIVE {
            low *= 0.125;
        }
        self.grow_from(low, residual, force)
    }

    fn grow_from(&self, low: f64, residual: impl Fn(f64) -> f64, force: f64) -> Result<f64, FrictionError> {
        let limit = self.profile().rim().radius().min(f64::MAX.sqrt());
        let bracket = bracket_upwards(&residual, low, 2.0 * low, limit);
        let (low, high) = bracket.ok_or(FrictionError::ForceBeyondProfile { force })?;
        brent(&residual, low, high).map_err(|_| FrictionError::Parted { force })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::foundation::Foundation;
    use crate::input::quantity::{Length, Positive};
    use crate::shape::{Paraboloid, Power};
    use std::sync::Arc;

    fn sheared<P: Profile + Clone + 'static>(shape: &P, (modulus, work): (f64, f64), ratio: f64) -> ShearedAdhesion {
        let ground = Foundation::new(Arc::new(shape.clone()), modulus);
        ShearedAdhesion { line: EdgeLine::new(ground, work), ratio }
    }

    #[test]
    fn above_the_critical_force_the_contact_has_peeled() {
        let shape = Power { coefficient: Positive::new(1.0).unwrap(), exponent: Positive::new(3.0).unwrap() };
        let contact = sheared(&shape, (1.0, 0.1), 0.7);
        let critical = contact.critical(0.1).unwrap();
        let under = |part: f64| contact.under(0.1, TangentialLoad::Force(part * critical.tangential_force));
        assert!(under(1.0 - 1e-9).is_ok());
        assert_eq!(under(1.0 + 1e-9), Err(FrictionError::Peeled { force: 0.1 }));
    }

    /// Bodies that are not pressed part: at a depth with nothing in contact, under a force for good.
    #[test]
    fn nothing_is_left_where_nothing_presses() {
        let contact = sheared(&Paraboloid { radius: Length::new(1.0).unwrap() }, (1.0, 1.0), 1.0);
        let left = |control, value| contact.without_edge(Prescribed { control, value });
        let apart = left(Control::Indentation, -0.1).unwrap();
        assert_eq!((apart.contact_radius, apart.indentation, apart.tangential_force), (0.0, -0.1, 0.0));
        assert!(contact.force_of(&apart).abs() <= 0.0);
        assert_eq!(left(Control::Force, 0.0), Err(FrictionError::Peeled { force: 0.0 }));
    }

    /// The energy balance by finite differences: at given displacements U_el − wπa² has zero slope.
    #[test]
    fn the_edge_releases_the_work_of_adhesion() {
        let shape = Power { coefficient: Positive::new(0.8).unwrap(), exponent: Positive::new(2.4).unwrap() };
        let contact = sheared(&shape, (1.3, 0.2), 0.7);
        let state = contact.under(0.3, TangentialLoad::Force(0.2)).unwrap();
        let energy = |a: f64| {
            let edge = state.indentation - shape.reduced(a);
            let normal = shape.energy_integral(a) + 2.0 * edge * shape.load_integral(a) + a * edge * edge;
            1.3 * normal + 0.7 * 1.3 * a * state.slide.powi(2) - 0.2 * PI * a * a
        };
        let (a, h) = (state.contact_radius, 1e-5);
        let slope = (energy(a * (1.0 + h)) - energy(a * (1.0 - h))) / (2.0 * h);
        // Central difference: h² times the third derivative, of the order of the energy.
        assert!(slope.abs() < 1e-8 * energy(a).abs(), "{slope:e}");
    }

    /// Under a growing stress the lens shrinks steadily to the Hertzian area, at τ² = 8αE*w/(πa).
    #[test]
    fn stress_brings_the_lens_to_hertz_without_a_jump() {
        let shape = Paraboloid { radius: Length::new(2.5e-3).unwrap() };
        let contact = sheared(&shape, (6.4e6, 0.042), uniform_ratio(0.5));
        let hertz = contact.plain_radius(0.048).unwrap();
        let last = (8.0 * contact.ratio * contact.modulus() * contact.line.work() / (PI * hertz)).sqrt();
        let mut before = 1.0 + 1e-15;
        for k in 0..=1000 {
            let ratio = contact.area_ratio(0.048, TangentialLoad::Stress(1e-3 * f64::from(k) * last)).unwrap();
            assert!(ratio < before && before - ratio < 1e-2, "{k} {ratio}");
            before = ratio + 1e-15;
        }
        assert!((before - 0.8736).abs() < 1e-4);
    }

    #[test]
    fn the_lens_of_figure_10() {
        let shape = Paraboloid { radius: Length::new(2.5e-3).unwrap() };
        let modulus = 4.8e6 / 0.75;
        let contact = sheared(&shape, (modulus, 0.042), stuck_ratio(0.5));
        let hertz = contact.plain_radius(0.048).unwrap();
        let rest = contact.under(0.048, TangentialLoad::Force(0.0)).unwrap().contact_radius;
        let last = contact.critical(0.048).unwrap().contact_radius;
        // The article's rounded numbers: 2.4e-4 m, 1.07 (from √1.14), 1.007 for (1 + 2F_a/F)^{1/3}.
        assert!((hertz - 2.4e-4).abs() < 0.05e-4);
        assert!((rest / hertz - 1.07).abs() < 0.005);
        assert!((last / hertz - 1.007).abs() < 0.0005);
    }
}
