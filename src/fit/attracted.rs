//! The force of Hertz's contact under an attraction outside it, led through a row of depths, without a run.
//!
//! The bodies hold each other wherever the depth is not below first touch: F = (4/3)E*√R d^{3/2} − 2πwR.

use super::adhesive::{Followed, Jump};
use super::slopes::Slopes;
use crate::contact::adhesion::dmt::DmtBall;
use crate::contact::adhesion::equilibrium::Control;

/// A ball that is attracted outside its contact.
#[derive(Debug, Clone)]
pub struct Attracted(pub DmtBall);

impl Attracted {
    /// E* [Pa] and the work of adhesion [J/m²].
    pub fn numbers(&self) -> Vec<f64> {
        vec![self.0.ground().modulus(), self.0.work()]
    }

    /// The contact at the depths `depths` [m] in their order, first touch at `contact`.
    pub fn followed(&self, depths: &[f64], contact: f64) -> Followed {
        let states: Vec<[f64; 4]> = depths.iter().map(|d| self.state(d - contact)).collect();
        let of = |at: usize| states.iter().map(|state| state[at]).collect::<Vec<f64>>();
        let joined = |d: &f64| *d >= contact;
        let leap = |row: usize| Jump { row, height: self.0.attraction(), at: Some(contact) };
        let first = depths.first().filter(|d| joined(d)).map(|_| leap(0));
        let pairs = depths.windows(2).enumerate();
        let leaps = pairs.filter(|(_, pair)| joined(&pair[0]) != joined(&pair[1])).map(|(row, _)| leap(row + 1));
        let jumps = first.into_iter().chain(leaps).collect();
        Followed { forces: of(0), slopes: Slopes { numbers: vec![of(1), of(2)], touch: of(3) }, jumps }
    }

    /// Force [N] at the depth `d` [m], and its slopes in E*, in the work and in first touch.
    fn state(&self, d: f64) -> [f64; 4] {
        let Some(state) = self.0.brought(false, (Control::Indentation, d), 0.0) else { return [0.0; 4] };
        let ground = self.0.ground();
        let (hertz, pull) = (state.force + self.0.attraction(), self.0.attraction());
        [state.force, hertz / ground.modulus(), -pull / self.0.work(), -ground.stiffness(state.contact_radius)]
    }
}

#[cfg(test)]
mod tests {
    use crate::fit::{Curve, Options, Question};
    use crate::input::table::InMemory;
    use crate::scene::Scene;
    use std::f64::consts::PI;

    /// E* = 74 GPa, R = 10 nm, w = 50 mJ/m²: modulus, work and first touch are found from a curve in and out.
    #[test]
    fn the_work_of_a_hard_tip_is_found_from_its_curve() {
        let (modulus, radius, work, touch) = (74e9, 1e-8_f64, 0.05, 3e-10);
        let depth: Vec<f64> =
            (0..200).map(|k| 1e-12 * f64::from(if k < 100 { 10 * k } else { 10 * (199 - k) })).collect();
        let force = |d: &f64| {
            let d = d - touch;
            let hertz = 4.0 / 3.0 * modulus * radius.sqrt() * d.max(0.0).powf(1.5);
            if d >= 0.0 { hertz - 2.0 * PI * work * radius } else { 0.0 }
        };
        let force = depth.iter().map(force).collect();
        let curve = Curve::of_depths(depth, force);
        let scene = Scene::from_ron(
            r#"(shape: Paraboloid(radius: "10 nm"), bodies: (Elastic(young: "60 GPa", poisson: 0), Rigid),
                adhesion: Dmt(work: "20 mJ/m^2"), history: [Indent(to: "1 nm", over: 1), Retract(speed: 1e-9)])"#,
        )
        .unwrap();
        let free = ["bodies.0.young=1 GPa..1 TPa", "adhesion.work=1e-3..1"];
        let fit = Question::new(&scene, &free, Options::default()).unwrap().fit(&curve, &InMemory::default()).unwrap();
        let found = |name| fit.parameter(name).unwrap().value;
        assert!((fit.parameters[0].value / modulus - 1.0).abs() < 1e-6, "{:e}", fit.parameters[0].value);
        assert!((fit.parameters[1].value / work - 1.0).abs() < 1e-6, "{:e}", fit.parameters[1].value);
        assert!((found("contact_point") / touch - 1.0).abs() < 1e-6);
    }
}
