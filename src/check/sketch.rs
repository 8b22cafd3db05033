//! Scenes in SI numbers, written as a scene file is: a shape on rubber, then entry by entry.

use super::attempt::{Attempt, Pairs};
use crate::contact::adhesion::{Adhesion, EdgeRule, Jkr};
use crate::drive::machine::Machine;
use crate::friction::{Coulomb, Friction, RateState, StaticKinetic};
use crate::input::quantity::{Dimension, Domain, Quantity};
use crate::input::table::InMemory;
use crate::material::{Body, Elastic, PowerLaw, Relaxation, Shear, Term, Terms, Viscoelastic};
use crate::run::record::{Outcome, Record};
use crate::run::{self, SimulationError, Wanted};
use crate::scene::Scene;
use crate::scene::history::{Drive, Entry, Fall, Glide, Hold, Impact, Indent, Oscillate, Press, Retract, Ring, Slide};
use crate::scene::plan::Plan;
use crate::scene::solver::{HalfSpace, SolverChoice};
use crate::shape::{Paraboloid, Shape};
use crate::wear::{Archard, Wear};
use std::num::NonZeroUsize;

/// A quantity by its number in SI units.
///
/// # Errors
/// The number makes no sense for the quantity.
pub fn si<D: Dimension, R: Domain>(value: f64) -> Attempt<Quantity<D, R>> {
    Ok(Quantity::new(value)?)
}

/// A paraboloid of a radius [m].
///
/// # Errors
/// No radius.
pub fn ball(radius: f64) -> Attempt<Shape> {
    Ok(Shape::Paraboloid(Paraboloid { radius: si(radius)? }))
}

/// An elastic body.
///
/// # Errors
/// No modulus [Pa] or ratio.
pub fn elastic(young: f64, poisson: f64) -> Attempt<Body> {
    Ok(Body::Elastic(Elastic { young: si(young)?, poisson: si(poisson)?, yield_stress: None }))
}

/// An incompressible body whose E*(t) = 4G(t) is `relaxation`.
///
/// # Errors
/// No modulus, time or viscosity.
pub fn relaxing(relaxation: &Relaxation) -> Attempt<Body> {
    let term = |&(modulus, time): &(f64, f64)| Ok(Term { modulus: si(0.25 * modulus)?, time: si(time)? });
    let terms = Terms::List(relaxation.terms.iter().map(term).collect::<Attempt<_>>()?);
    let (equilibrium, viscosity) = (si(0.25 * relaxation.equilibrium)?, si(0.25 * relaxation.viscosity)?);
    Ok(Body::Viscoelastic(Viscoelastic {
        poisson: si(0.5)?,
        shear: Shear { equilibrium, terms, viscosity, power_law: None },
        temperature: None,
        shift: None,
    }))
}

/// An incompressible body whose E*(t) = 4G(t) is 4 Pa at 1 s and falls by the power `exponent` β of time.
///
/// # Errors
/// No exponent.
pub fn relaxing_by_power(exponent: f64) -> Attempt<Body> {
    let law = PowerLaw { modulus: si(1.0)?, exponent: si(exponent)?, time: si(1.0)? };
    let shear = Shear { power_law: Some(law), ..Shear::default() };
    Ok(Body::Viscoelastic(Viscoelastic { poisson: si(0.5)?, shear, temperature: None, shift: None }))
}

/// A history being written; the first part that makes no sense is kept as the reason why it cannot be run.
pub struct Sketch {
    scene: Attempt<Scene>,
    tables: InMemory,
}

impl Sketch {
    /// A shape on rubber with E* = 1 and G* = 2/3; the other body is rigid.
    #[must_use]
    pub fn of(shape: Attempt<Shape>) -> Self {
        let scene = |shape| {
            let bodies = (elastic(0.75, 0.5)?, Body::Rigid);
            let (adhesion, friction, wear, machine) = (None, None, None, None);
            let (accuracy, springs, steps, plots, sweep) = (None, None, None, None, None);
            let (title, history) = (String::new(), Vec::new());
            Ok(Scene {
                title,
                shape,
                bodies,
                adhesion,
                friction,
                wear,
                machine,
                history,
                accuracy,
                springs,
                steps,
                plots,
                sweep,
                fit: None,
                solver: None,
            })
        };
        Self { scene: shape.and_then(scene), tables: InMemory::default() }
    }

    fn with(self, part: impl FnOnce(&mut Scene) -> Attempt<()>) -> Self {
        let scene = self.scene.and_then(|mut scene| part(&mut scene).map(|()| scene));
        Self { scene, ..self }
    }

    fn entry(self, entry: impl FnOnce() -> Attempt<Entry>) -> Self {
        self.with(|scene| entry().map(|entry| scene.history.push(entry)))
    }

    /// Another body in the place of the rubber.
    #[must_use]
    pub fn body(self, body: Attempt<Body>) -> Self {
        self.with(|scene| body.map(|body| scene.bodies.0 = body))
    }

    /// Another body in the place of the rigid one.
    #[must_use]
    pub fn other(self, body: Attempt<Body>) -> Self {
        self.with(|scene| body.map(|body| scene.bodies.1 = body))
    }

    /// A rigid indenter, and what it is pressed on in the place of the other body.
    #[must_use]
    pub fn ground(self, body: Attempt<Body>) -> Self {
        self.with(|scene| body.map(|body| scene.bodies = (Body::Rigid, body)))
    }

    /// A law of adhesion.
    #[must_use]
    pub fn adhesion(self, adhesion: Attempt<Adhesion>) -> Self {
        self.with(|scene| adhesion.map(|adhesion| scene.adhesion = Some(adhesion)))
    }

    /// Adhesion of vanishing range with a work [J/m²].
    #[must_use]
    pub fn jkr(self, work: f64, edge: Option<EdgeRule>) -> Self {
        self.adhesion(si(work).map(|work| Adhesion::Jkr(Jkr { work, closing: None, edge })))
    }

    /// A law of friction.
    #[must_use]
    pub fn friction(self, friction: Attempt<Friction>) -> Self {
        self.with(|scene| friction.map(|friction| scene.friction = Some(friction)))
    }

    /// Coulomb's law.
    #[must_use]
    pub fn coulomb(self, coefficient: f64) -> Self {
        self.friction(si(coefficient).map(|coefficient| Friction::Coulomb(Coulomb { coefficient })))
    }

    /// Archard's law of wear with the coefficient `coefficient` k_w [m²/N].
    #[must_use]
    pub fn archard(self, coefficient: f64) -> Self {
        let law = si(coefficient).map(|coefficient| Wear::Archard(Archard { coefficient }));
        self.with(|scene| law.map(|law| scene.wear = Some(law)))
    }

    /// Relative error to aim at.
    #[must_use]
    pub fn accuracy(self, accuracy: f64) -> Self {
        self.with(|scene| si(accuracy).map(|accuracy| scene.accuracy = Some(accuracy)))
    }

    /// Records per entry.
    #[must_use]
    pub fn steps(self, steps: usize) -> Self {
        self.with(|scene| {
            scene.steps = NonZeroUsize::new(steps);
            Ok(())
        })
    }

    /// Springs, if any are asked for.
    #[must_use]
    pub fn springs(self, springs: Option<usize>) -> Self {
        self.with(|scene| {
            scene.springs = springs.and_then(NonZeroUsize::new);
            Ok(())
        })
    }

    /// Pixels of a half-space along a side, in the place of springs.
    #[must_use]
    pub fn pixels(self, grid: usize) -> Self {
        self.half_space(HalfSpace { grid: NonZeroUsize::new(grid), ..HalfSpace::default() })
    }

    /// A half-space as described, in the place of springs.
    #[must_use]
    pub fn half_space(self, described: HalfSpace) -> Self {
        self.with(|scene| {
            scene.solver = Some(SolverChoice::HalfSpace(described));
            Ok(())
        })
    }

    /// To an indentation [m] in a time [s].
    #[must_use]
    pub fn indent(self, to: f64, over: f64) -> Self {
        self.entry(|| Ok(Entry::Indent(Indent { to: si(to)?, over: si(over)? })))
    }

    /// To a force [N] in a time [s].
    #[must_use]
    pub fn press(self, to: f64, over: f64) -> Self {
        self.entry(|| Ok(Entry::Press(Press { to: si(to)?, over: si(over)? })))
    }

    /// At the depth for a time [s].
    #[must_use]
    pub fn hold(self, over: f64) -> Self {
        self.entry(|| Ok(Entry::Hold(Hold { over: si(over)?, spacing: None })))
    }

    /// Under the force for a time [s].
    #[must_use]
    pub fn hold_force(self, over: f64) -> Self {
        self.entry(|| Ok(Entry::HoldForce(Hold { over: si(over)?, spacing: None })))
    }

    /// To a tangential displacement [m] in a second.
    #[must_use]
    pub fn slide(self, to: f64) -> Self {
        self.entry(|| Ok(Entry::Slide(Slide { to: si(to)?, over: si(1.0)? })))
    }

    /// The depth to and fro by an amplitude [m].
    #[must_use]
    pub fn oscillate(self, amplitude: f64, frequency: f64, cycles: f64) -> Self {
        self.entry(|| wave(amplitude, frequency, cycles).map(Entry::Oscillate))
    }

    /// The tangential displacement to and fro by an amplitude [m].
    #[must_use]
    pub fn shake(self, amplitude: f64, frequency: f64, cycles: f64) -> Self {
        self.entry(|| wave(amplitude, frequency, cycles).map(Entry::Shake))
    }

    /// Away at a speed [m/s].
    #[must_use]
    pub fn retract(self, speed: f64) -> Self {
        self.entry(|| Ok(Entry::Retract(Retract { speed: si(speed)? })))
    }

    /// Along the surface at a speed [m/s] for `over` [s], or as it is in the end.
    #[must_use]
    pub fn glide(self, speed: f64, over: Option<f64>) -> Self {
        self.entry(|| {
            let (speed, over) = (vec![si(speed)?], over.map(si).transpose()?);
            Ok(Entry::Glide(Glide { speed, over, creepage: None, traction: None }))
        })
    }

    /// Rolling steadily at a speed [m/s] with creepages.
    #[must_use]
    pub fn creep(self, speed: f64, creepages: &[f64]) -> Self {
        self.entry(|| {
            let creepage = Some(creepages.iter().map(|&creepage| si(creepage)).collect::<Attempt<_>>()?);
            Ok(Entry::Roll(Glide { speed: vec![si(speed)?], over: None, creepage, traction: None }))
        })
    }

    /// Rolling steadily at a speed [m/s] with tangential forces [N].
    #[must_use]
    pub fn pull(self, speed: f64, tractions: &[f64]) -> Self {
        self.entry(|| {
            let traction = Some(tractions.iter().map(|&traction| si(traction)).collect::<Attempt<_>>()?);
            Ok(Entry::Roll(Glide { speed: vec![si(speed)?], over: None, creepage: None, traction }))
        })
    }

    /// A machine with a mass [kg], a stiffness [N/m] and a damping [N s/m].
    #[must_use]
    pub fn machine(self, mass: f64, stiffness: f64, damping: f64) -> Self {
        self.with(|scene| {
            let (stiffness, damping) = (Some(si(stiffness)?), Some(si(damping)?));
            scene.machine = Some(Machine { mass: Some(si(mass)?), stiffness, damping });
            Ok(())
        })
    }

    /// The far end of its spring goes on at a speed [m/s] for `over` [s].
    #[must_use]
    pub fn drive(self, speed: f64, over: f64) -> Self {
        self.entry(|| Ok(Entry::Drive(Drive { speed: si(speed)?, over: si(over)? })))
    }

    /// Its mass is let go so much deeper [m], for `over` [s].
    #[must_use]
    pub fn ring(self, amplitude: f64, over: f64) -> Self {
        self.entry(|| Ok(Entry::Ring(Ring { amplitude: si(amplitude)?, over: si(over)? })))
    }

    /// Its mass falls from a height [m], for `over` [s] at most.
    #[must_use]
    pub fn fall(self, height: f64, over: f64) -> Self {
        self.entry(|| Ok(Entry::Fall(Fall { height: si(height)?, over: si(over)? })))
    }

    /// A friction that falls as the contact begins to slide.
    #[must_use]
    pub fn static_kinetic(self, held: f64, slides: f64) -> Self {
        self.friction(
            si(held)
                .and_then(|held| Ok(Friction::StaticKinetic(StaticKinetic { r#static: held, kinetic: si(slides)? }))),
        )
    }

    /// A friction of rate and state.
    #[must_use]
    pub fn rate_state(self, law: RateState) -> Self {
        self.friction(Ok(Friction::RateState(law)))
    }

    /// A free impact of 1 kg at a speed [m/s].
    #[must_use]
    pub fn impact(self, speed: f64) -> Self {
        self.entry(|| Ok(Entry::Impact(Impact { mass: si(1.0)?, speed: vec![si(speed)?], angle: None, spin: None })))
    }

    /// A free impact of 1 kg at a speed [m/s], an angle [rad] from the normal, and a spin [rad/s].
    #[must_use]
    pub fn oblique(self, speed: f64, angle: f64, spin: f64) -> Self {
        self.entry(|| {
            let (angle, spin) = (Some(si(angle)?), Some(si(spin)?));
            Ok(Entry::Impact(Impact { mass: si(1.0)?, speed: vec![si(speed)?], angle, spin }))
        })
    }

    /// A table of columns, as the next entry.
    #[must_use]
    pub fn table(self, columns: &[(&str, &[f64])]) -> Self {
        let sketch = self.entry(|| Ok(Entry::Table("history.csv".into())));
        Self { tables: sketch.tables.with("history.csv", columns), ..sketch }
    }

    /// The scene checked, ready to be run.
    ///
    /// # Errors
    /// A part makes no sense, or parts do not fit together.
    pub fn resolved(self) -> Attempt<Plan> {
        Ok(self.scene?.resolve(&self.tables).map_err(SimulationError::from)?)
    }

    /// Runs the scene.
    ///
    /// # Errors
    /// The scene makes no sense or cannot be followed.
    pub fn run(self) -> Attempt<Outcome> {
        Ok(run::run(&self.resolved()?, Wanted::NOTHING)?)
    }

    /// Runs the scene with its fields.
    ///
    /// # Errors
    /// As for [`Self::run`].
    pub fn fields(self) -> Attempt<Outcome> {
        Ok(run::run(&self.resolved()?, Wanted { fields: true, ..Wanted::NOTHING })?)
    }
}

fn wave(amplitude: f64, frequency: f64, cycles: f64) -> Attempt<Oscillate> {
    Ok(Oscillate { amplitude: si(amplitude)?, frequency: si(frequency)?, cycles: si(cycles)? })
}

/// The named result of an outcome.
///
/// # Errors
/// The scene has no such result.
pub fn result(outcome: &Outcome, name: &str) -> Attempt<f64> {
    outcome.number(name).ok_or_else(|| format!("the scene has no {name}").into())
}

/// Named results beside the right ones.
///
/// # Errors
/// The scene has no such result.
pub fn beside(outcome: &Outcome, right: &[(&str, f64)]) -> Attempt<Pairs> {
    right.iter().map(|&(name, right)| Ok((result(outcome, name)?, right))).collect()
}

/// Where each entry of the history has ended.
pub fn ends(outcome: &Outcome) -> impl Iterator<Item = &Record> {
    outcome.records.chunk_by(|one, next| one.entry == next.entry).filter_map(|entry| entry.last())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_run_says_why() {
        let said = |sketch: Sketch| sketch.run().unwrap_err().to_string();
        assert!(said(Sketch::of(ball(-1.0)).indent(1.0, 1.0)).contains("-1"));
        assert!(said(Sketch::of(ball(1.0)).indent(f64::NAN, 1.0).hold(1.0)).contains("NaN"));
        assert!(said(Sketch::of(ball(1.0)).slide(1.0)).contains("friction"));
        let outcome = Sketch::of(ball(1.0)).indent(0.01, 1.0).run().unwrap();
        assert!(result(&outcome, "restitution").unwrap_err().to_string().contains("restitution"));
    }
}
