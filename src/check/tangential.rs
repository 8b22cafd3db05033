//! Closed forms of tangential contact: Cattaneo–Mindlin, Mindlin–Deresiewicz, Savkoor–Briggs,
//! Coulomb–Orowan sliding, oblique impact in gross slip.

use super::closed_forms;
use std::f64::consts::PI;

/// A paraboloid under a constant normal load, with Coulomb friction.
///
/// F_x/(μF) = 1 − (1 − u/u_s)^{3/2} = 1 − (c/a)³ on first loading, u_s = μE*d/G*: the displacement at
/// which all slips (Popov, Contact Mechanics and Friction, eqs. 8.32–8.38).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CattaneoMindlin {
    /// Normal force F [N].
    pub force: f64,
    /// Contact radius a [m].
    pub contact_radius: f64,
    /// Effective tangential modulus G* [Pa].
    pub tangential_modulus: f64,
    /// Coefficient of friction μ.
    pub coefficient: f64,
}

impl CattaneoMindlin {
    /// A ball with R = E* = 1 at the indentation `depth` [m].
    #[must_use]
    pub fn on_ball(depth: f64, tangential_modulus: f64, coefficient: f64) -> Self {
        let hertz = closed_forms::hertz(1.0, depth);
        Self { force: hertz.force, contact_radius: hertz.radius, tangential_modulus, coefficient }
    }

    /// Largest tangential force μF [N].
    #[must_use]
    pub fn limit(&self) -> f64 {
        self.coefficient * self.force
    }

    /// u_s = 3μF/(4G*a) [m], at which the whole contact slips.
    #[must_use]
    pub fn reach(&self) -> f64 {
        0.75 * self.limit() / (self.tangential_modulus * self.contact_radius)
    }

    /// Tangential force F_x [N] on first loading to the displacement `slide` [m].
    #[must_use]
    pub fn tangential_force(&self, slide: f64) -> f64 {
        let part = (slide.abs() / self.reach()).min(1.0);
        -self.limit() * (1.5 * (-part).ln_1p()).exp_m1() * slide.signum()
    }

    /// Stick radius c [m] on first loading to the displacement `slide` [m].
    #[must_use]
    pub fn stick_radius(&self, slide: f64) -> f64 {
        self.contact_radius * (1.0 - slide.abs() / self.reach()).max(0.0).sqrt()
    }

    /// Shear stress τ [Pa] at the radius `r` [m] on first loading to the stick radius `c` [m].
    #[must_use]
    pub fn shear_stress(&self, r: f64, c: f64) -> f64 {
        let a = self.contact_radius;
        let bowl = |edge: f64| if r < edge { ((edge - r) * (edge + r)).sqrt() } else { 0.0 };
        1.5 * self.limit() / (PI * a * a * a) * (bowl(a) - bowl(c))
    }

    /// Force [N] on the way from the turning point `turn` [m] to `slide` [m] in a symmetric cycle
    /// (Masing: the first loading curve, doubled).
    #[must_use]
    pub fn masing(&self, turn: f64, slide: f64) -> f64 {
        self.tangential_force(turn) + 2.0 * self.tangential_force(0.5 * (slide - turn))
    }

    /// Energy [J] lost in a symmetric cycle between ±`amplitude` [m], up to gross slip.
    ///
    /// W = (18/5)(μ²F²/(G*a)){1 − (1−L)^{5/3} − (5L/6)[1 + (1−L)^{2/3}]}, L = F_x/(μF) (Johnson 1985,
    /// eq. 7.58). With q = c/a = (1−L)^{1/3} the bracket is (1−q)³(1+3q+q²)/6, which loses no digits:
    /// W → (18/5)(μ²F²/(G*a))·(5/6)(L/3)³ at small amplitude. Beyond it each slide adds μF.
    #[must_use]
    pub fn loss_per_cycle(&self, amplitude: f64) -> f64 {
        let part = amplitude.abs() / self.reach();
        let within = part.min(1.0);
        // 1 − q with q = √(1 − part).
        let q = (1.0 - within).sqrt();
        let gap = within / (1.0 + q);
        let bracket = gap.powi(3) * (1.0 + q * (3.0 + q)) / 6.0;
        let scale = 3.6 * self.limit() * self.limit() / (self.tangential_modulus * self.contact_radius);
        scale * bracket + 4.0 * self.limit() * self.reach() * (part - within)
    }
}

/// Adhesive contact of a paraboloid under a tangential force (Savkoor & Briggs 1977; Persson et al.
/// 2008, eqs. 10–14).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SavkoorBriggs {
    /// Radius of curvature R [m].
    pub radius: f64,
    /// Effective modulus E* [Pa].
    pub modulus: f64,
    /// Work of adhesion w [J/m²].
    pub work: f64,
    /// α, see [`ShearedAdhesion`](crate::friction::peeling::ShearedAdhesion).
    pub ratio: f64,
}

impl SavkoorBriggs {
    /// F_a = (3/2)πwR [N].
    #[must_use]
    pub fn adhesion_force(&self) -> f64 {
        1.5 * PI * self.work * self.radius
    }

    /// Contact radius [m] under the forces `force`, `tangential` [N] (eq. 10); NaN beyond eq. 11.
    #[must_use]
    pub fn contact_radius(&self, force: f64, tangential: f64) -> f64 {
        let own = self.adhesion_force();
        let root = (own * (force + own) - 0.25 * tangential * tangential / self.ratio).sqrt();
        (0.75 * self.radius / self.modulus * (2.0 * own + force + 2.0 * root)).cbrt()
    }

    /// Tangential force [N] at which peeling ends (eq. 11).
    #[must_use]
    pub fn critical_force(&self, force: f64) -> f64 {
        let own = self.adhesion_force();
        2.0 * (self.ratio * own * (force + own)).sqrt()
    }

    /// (a/a_H)³ from the ratios F_a/F and F_x/F (eq. 13; eq. 14 without shear).
    #[must_use]
    pub fn cube_over_hertz(ratio: f64, adhesion: f64, tangential: f64) -> f64 {
        1.0 + 2.0 * adhesion + 2.0 * (adhesion * (1.0 + adhesion) - 0.25 * tangential * tangential / ratio).sqrt()
    }
}

/// Friction force [N] of a paraboloid sliding with τ = min(μp, τ_max) (Ceglie et al., eq. 6, on
/// Hertz's pressure): μF while μp₀ ≤ τ_max, else πa²τ_max(1 − s²/3) with s = τ_max/(μp₀).
///
/// `force` F and `contact_radius` a as of Hertz, p₀ = 3F/(2πa²).
#[must_use]
pub fn orowan_on_hertz(force: f64, contact_radius: f64, (coefficient, limit): (f64, f64)) -> f64 {
    let area = PI * contact_radius * contact_radius;
    let s = limit / (coefficient * 1.5 * force / area);
    if s >= 1.0 { coefficient * force } else { area * limit * (1.0 - s * s / 3.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::line::EdgeLine;
    use crate::contact::foundation::Foundation;
    use crate::contact::loaded::Loaded;
    use crate::friction::peeling::{ShearedAdhesion, TangentialLoad};
    use crate::friction::sliding::sliding_force;
    use crate::friction::{CoulombBed, CoulombOrowan, Grip, Pose, TangentialMemory};
    use crate::input::quantity::{Length, Modulus, Ratio};
    use crate::shape::{Paraboloid, Profile};
    use proptest::prelude::*;
    use std::num::NonZeroUsize;
    use std::sync::Arc;

    const GRIP: Grip = Grip { normal_modulus: 2.0, tangential_modulus: 1.5, coefficient: 0.3 };

    fn lens() -> Paraboloid {
        Paraboloid { radius: Length::new(1.0).unwrap() }
    }

    fn ground(shape: &Paraboloid, modulus: f64) -> Foundation {
        Foundation::new(Arc::new(shape.clone()), modulus)
    }

    /// The contact of a lens pressed to unit depth.
    fn mindlin() -> CattaneoMindlin {
        CattaneoMindlin { force: 8.0 / 3.0, contact_radius: 1.0, tangential_modulus: 1.5, coefficient: 0.3 }
    }

    fn at(slide: f64) -> Pose {
        Pose { indentation: 1.0, slide }
    }

    proptest! {
        /// F_x, c and τ(r) on first loading; amplitudes from 10⁻¹² of the reach to gross slip.
        #[test]
        fn first_loading(k in 0i32..125) {
            let (shape, exact) = (lens(), mindlin());
            let slide = exact.reach() * 10f64.powf(-12.0 + 0.1 * f64::from(k));
            let mut memory = TangentialMemory::new(Arc::new(shape.clone()), GRIP);
            memory.advance(at(0.0)).unwrap();
            memory.advance(at(slide)).unwrap();
            let state = memory.state();
            prop_assert!((state.tangential_force / exact.tangential_force(slide) - 1.0).abs() < 1e-13);
            let c = exact.stick_radius(slide);
            prop_assert!((state.stick_radius - c).abs() < 1e-15 + 1e-15 / c.max(1e-8));
            let radii = [0.0, 0.3, 0.5, 0.9, 0.999, 1.0, 1.1];
            for (r, stress) in radii.iter().zip(memory.shear_stress(&radii)) {
                prop_assert!((stress - exact.shear_stress(*r, state.stick_radius)).abs() < 1e-14);
            }
        }

        /// Symmetric cycles: loss against the closed form over 12 decades of amplitude, cycle by cycle,
        /// and the branches by Masing's rule.
        #[test]
        fn cycles(k in 0i32..125) {
            let (shape, exact) = (lens(), mindlin());
            let amplitude = exact.reach() * 10f64.powf(-12.0 + 0.1 * f64::from(k));
            let mut memory = TangentialMemory::new(Arc::new(shape.clone()), GRIP);
            memory.advance(at(0.0)).unwrap();
            memory.advance(at(amplitude)).unwrap();
            for _ in 0..3 {
                let before = memory.state().dissipated;
                for part in [0.5, 0.0, -0.7, -1.0, -0.3, 0.8, 1.0] {
                    memory.advance(at(part * amplitude)).unwrap();
                }
                let lost = memory.state().dissipated - before;
                // The ledger adds up 10⁻³⁶ like any other number: rounding of the sum of three cycles.
                prop_assert!((lost / exact.loss_per_cycle(amplitude) - 1.0).abs() < 1e-12, "{}", lost / exact.loss_per_cycle(amplitude) - 1.0);
            }
            for slide in [0.6, 0.1, -0.5].map(|part| part * amplitude) {
                memory.advance(at(slide)).unwrap();
                let force = memory.state().tangential_force;
                prop_assert!((force - exact.masing(amplitude, slide)).abs() < 1e-13 * exact.tangential_force(amplitude));
            }
        }

        /// Eqs. 10 and 11 over 12 decades of F_a/F, both signs of F, any part of the critical force.
        #[test]
        fn a_paraboloid_follows_the_closed_form(k in -60i32..60, sign in 0..2, part in 0u32..1000) {
            let shape = Paraboloid { radius: Length::new(1.0).unwrap() };
            let contact = ShearedAdhesion { line: EdgeLine::new(ground(&shape, 1.0), 1.0), ratio: 0.7 };
            let exact = SavkoorBriggs { radius: 1.0, modulus: 1.0, work: 1.0, ratio: 0.7 };
            let size = exact.adhesion_force() * 10f64.powf(0.1 * f64::from(k));
            let force = if sign == 0 { size } else { -size.min(0.99 * exact.adhesion_force()) };
            let critical = contact.critical(force).unwrap();
            prop_assert!((critical.tangential_force / exact.critical_force(force) - 1.0).abs() < 1e-11);
            // Near the jump a depends on the root of a difference: the force is kept 0.1 % below it.
            let shear = 0.999e-3 * f64::from(part) * exact.critical_force(force);
            let a = contact.under(force, TangentialLoad::Force(shear)).unwrap().contact_radius;
            prop_assert!((a / exact.contact_radius(force, shear) - 1.0).abs() < 1e-10, "{a}");
        }
    }

    /// 10⁶ random reversals leave no drift: a last gross slip wipes the memory, and the state is the
    /// one of a contact that has never been shaken, to the last bit.
    #[test]
    fn a_million_reversals_leave_nothing() {
        let (shape, exact) = (lens(), mindlin());
        let mut memory = TangentialMemory::new(Arc::new(shape.clone()), GRIP);
        memory.advance(at(0.0)).unwrap();
        let mut fresh = memory.clone();
        let mut random = 1u64;
        let mut most = 0;
        for _ in 0..1_000_000 {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let part = f64::from(u32::try_from(random >> 32).unwrap()) / f64::from(u32::MAX) - 0.5;
            memory.advance(at(1.9 * part * exact.reach())).unwrap();
            most = most.max(memory.turning_points());
        }
        for slide in [-5.0, 0.1] {
            memory.advance(at(slide)).unwrap();
            fresh.advance(at(slide)).unwrap();
        }
        let (state, other) = (memory.state(), fresh.state());
        assert!((state.tangential_force - other.tangential_force).abs() <= 0.0);
        assert!((state.stick_radius - other.stick_radius).abs() <= 0.0);
        assert!(most < 64, "{most}");
    }

    /// 10⁶ random turns of depth and slide, parting now and then: every spring is where the plain bed,
    /// which forgets roundings at every step, has it.
    #[test]
    fn a_million_turns_of_depth_and_slide_do_not_drift() {
        let (shape, springs, radius) = (lens(), 48u32, 1.1);
        let mut memory = TangentialMemory::new(Arc::new(shape.clone()), GRIP);
        let mut bed = CoulombBed::new(&shape, GRIP, NonZeroUsize::new(48).unwrap(), radius).unwrap();
        let mut random = 7u64;
        let mut draw = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(random >> 32).unwrap()) / f64::from(u32::MAX)
        };
        let mut most = 0;
        for _ in 0..1_000_000 {
            let to = Pose { indentation: 1.2 * draw() - 0.01, slide: 1.2 * GRIP.reach() * (draw() - 0.5) };
            memory.advance(to).unwrap();
            bed.advance(&[to]);
            most = most.max(memory.turning_points());
        }
        for (k, v) in (0..springs).zip(bed.displacements()) {
            let place = (f64::from(k) + 0.5) * radius / f64::from(springs);
            // Both are differences of slides of the order of the reach, a few roundings each.
            assert!((memory.displacement(place) - v).abs() < 1e-14 * GRIP.reach(), "{k}: {v}");
        }
        assert!(most < 64, "{most}");
    }

    #[test]
    fn the_bracket_of_the_loss_is_the_published_one() {
        let exact = mindlin();
        for k in 1..=10 {
            let part = 0.1 * f64::from(k);
            let l = exact.tangential_force(part * exact.reach()) / exact.limit();
            let bracket = 1.0 - (1.0 - l).powf(5.0 / 3.0) - 5.0 * l / 6.0 * (1.0 + (1.0 - l).powf(2.0 / 3.0));
            let scale = 3.6 * exact.limit().powi(2) / 1.5;
            assert!((exact.loss_per_cycle(part * exact.reach()) / (scale * bracket) - 1.0).abs() < 1e-11);
        }
        // Small amplitude: the cube, (18/5)(5/6)(L/3)³ with L = (3/2) u/u_s.
        let small = exact.loss_per_cycle(1e-9 * exact.reach()) / 1e-27;
        let cube = 3.0 * (0.5f64).powi(3) * exact.limit().powi(2) / 1.5;
        assert!((small / cube - 1.0).abs() < 1e-8);
    }

    #[test]
    fn persson_equations_13_and_14() {
        let exact = SavkoorBriggs { radius: 2.5e-3, modulus: 6.4e6, work: 0.042, ratio: 2.0 / 3.0 };
        let (force, own) = (0.048, exact.adhesion_force());
        let hertz = 0.75 * 2.5e-3 * force / 6.4e6;
        for part in [0.0, 0.3, 0.9, 0.999] {
            let shear = part * exact.critical_force(force);
            let cube = SavkoorBriggs::cube_over_hertz(exact.ratio, own / force, shear / force);
            assert!((exact.contact_radius(force, shear).powi(3) / hertz / cube - 1.0).abs() < 1e-12);
        }
        assert!((own - 5.0e-4).abs() < 0.06e-4);
    }

    #[test]
    fn orowan_friction_of_a_lens() {
        let shape = lens();
        let pressed = Loaded::elastic(ground(&shape, 2.0), 0.8, 0.0);
        let force = 4.0 * shape.load_integral(0.8);
        for k in -30..30 {
            let (coefficient, limit) = (0.4, 10f64.powf(0.1 * f64::from(k)));
            let law = CoulombOrowan {
                coefficient: Ratio::new(coefficient).unwrap(),
                shear_limit: Modulus::new(limit).unwrap(),
            };
            let exact = orowan_on_hertz(force, 0.8, (coefficient, limit));
            assert!((sliding_force(&pressed, &law) / exact - 1.0).abs() < 1e-12, "{k}");
        }
    }
}
