//! Contacts in a machine, run as whole scenes, against closed forms.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, beside, elastic, ends, relaxing, result, si};
use crate::drive::machine::{Carried, DrawnMass, GRAVITY, RatedMass, Suspension, Threshold, threshold};
use crate::friction::RateState;
use crate::material::Relaxation;
use crate::run::record::Outcome;
use crate::shape::{FlatPunch, Shape};
use std::f64::consts::{PI, TAU};

pub(super) const CASES: &[Case] = &[
    Case::new("machine/small swing", Proof::Bound, 1e-9, "ω² = (k + 2E*a)/m up to the square of the amplitude, 1e-5 of the depth, and its rounding")
        .weak("the frequency; one preload")
        .by(swing),
    Case::new("machine/damped swing", Proof::Rounding, 1e-9, "on a punch the contact is a spring: ζ = c/(2√(Km)), f = √(1 − ζ²)√(K/m)/2π")
        .weak("linear")
        .by(damped),
    Case::new("machine/elastic bounces", Proof::Bound, 1e-8, "flights of 2v/g and contacts of 2.943275 x₀/v, the weight being 5e-5 of the force of a blow that lasts 1e-4 of a flight")
        .weak("no losses")
        .by(bounces),
    Case::new("machine/stick and slip", Proof::Bound, 1e-5, "jumps of 2(μ_s − μ_k)F/k in π√(m/k), up to the speed of the drive over that of the slip, 1e-6")
        .weak("a limit; the motion between two slips is left out, for it dies down there")
        .by(slips),
    Case::new("machine/slips of a punch", Proof::Rounding, 1e-9, "what sticks is a spring: the spring is drawn out to μ_s F where the swing of the mass has died down")
        .weak("overdamped")
        .by(punch),
    Case::new("machine/slips of a punch on rubber", Proof::Rounding, 1e-9, "each slip begins at μ_s times the force it has relaxed to, F = 2b[E∞d + Σ Eᵢvτᵢ(1 − e^(−1/τᵢ))e^(−(t − 1)/τᵢ)]; both by springs exact in time")
        .weak("the force of a slip, not when it begins")
        .by(punch_on_rubber),
    Case::new("machine/the ledger of stick and slip", Proof::Rounding, 1e-10, "work of the drive = kinetic + spring + contact + friction + damper, some 1e4 steps of 1e-13")
        .weak("one scene; the property tests take any")
        .by(ledger),
    Case::new("machine/a ball comes to lie on rubber", Proof::Order, 1e-3, "in the end it lies at the depth that carries its weight, E∞, within the swing that counts as lying")
        .weak("the state it comes to, not the way there")
        .by(lies),
    Case::new("machine/rate and state: steady sliding", Proof::Rounding, 1e-9, "μ = μ* + (a − b) ln(V/V*) and θ = D_c/V, the reach of junctions backwards being 1e-50; what is left of the start has died down")
        .weak("above the critical stiffness")
        .by(steady),
    Case::new("machine/rate and state: where steady sliding is lost", Proof::Rounding, 1e-12, "rigid contact: k_c = F(b − a)/D_c·(1 + mV²/(F a D_c)), ω = (V/D_c)√((b − a)/a), and the contact in series: 1/k_c − 1/2G*a (Ruina 1983; Rice & Ruina 1983)")
        .weak("formulas against formulas; the case below measures it")
        .by(threshold_of_scene),
    Case::new("machine/rate and state: growth at the threshold", Proof::Bound, 2e-5, "a disturbance of 1e-6 of the state neither grows nor dies in ten periods, and keeps ω: up to its square, and some 1e3 steps of 1e-13 against it")
        .weak("one contact; the tests measure growth on both sides, under both laws, with inertia and drag")
        .by(at_threshold),
    Case::new("machine/rate and state: hold and slide", Proof::Bound, 1e-6, "at rest θ = θ₀ + t under the ageing law, the load of the start being zero")
        .weak("before the slide; the slides are those of the other cases")
        .by(ages),
    Case::new("machine/rate and state: the ledger", Proof::Order, 1e-7, "work of the drive = kinetic + spring + contact + friction + damper, each step to 1e-7 of what changes the speed of slip by a factor of e")
        .weak("one scene; the property tests take any machine")
        .by(rated_ledger),
    Case::new("machine/rate and state: Coulomb's limit", Proof::Bound, 1e-5, "a = 1e-6, b = 0: all sticks up to μ*F and slides there, up to a ln(V/V*)/μ* = 4e-6")
        .weak("a limit; a = b = 0 is computed as Coulomb's law")
        .by(coulomb_limit),
];

/// A ball with R = E* = 1 under F = 4/3, d = a = 1.
fn pressed() -> Sketch {
    Sketch::of(ball(1.0)).press(4.0 / 3.0, 1.0).steps(20)
}

fn swing() -> Attempt<Pairs> {
    let mut pairs = Vec::new();
    for stiffness in [0.0, 3.0] {
        let scene = pressed().machine(0.5, stiffness, 0.0).ring(1e-5, 60.0);
        pairs.extend(beside(&scene.run()?, &[("frequency_hz", ((stiffness + 2.0) / 0.5).sqrt() / TAU)])?);
    }
    Ok(pairs)
}

fn flat() -> Attempt<Shape> {
    Ok(Shape::FlatPunch(FlatPunch { radius: si(1.0)? }))
}

fn damped() -> Attempt<Pairs> {
    let (stiffness, damping): (f64, f64) = (3.0, 0.2);
    let scene = Sketch::of(flat()).press(2.0, 1.0).steps(20).machine(0.5, stiffness, damping).ring(0.1, 20.0);
    let whole = stiffness + 2.0;
    let ratio = 0.5 * damping / (whole * 0.5f64).sqrt();
    let frequency = (1.0 - ratio * ratio).sqrt() * (whole / 0.5).sqrt() / TAU;
    beside(&scene.run()?, &[("frequency_hz", frequency), ("damping_ratio", ratio)])
}

/// A column of a table of the outcome.
fn column(outcome: &Outcome, table: &str, name: &str) -> Attempt<Vec<f64>> {
    let column = outcome.table(table).and_then(|table| table.column(name)).ok_or("the scene has no such table")?;
    Ok(column.numbers().iter().copied().flatten().collect())
}

fn bounces() -> Attempt<Pairs> {
    let (radius, mass, height) = (5e-3, 4e-3, 0.1);
    let scene = Sketch::of(ball(radius)).body(elastic(210e9, 0.3)).machine(mass, 0.0, 0.0).fall(height, 2.0).steps(20);
    let modulus = 210e9 / (1.0 - 0.09);
    let speed = (2.0 * GRAVITY * height).sqrt();
    let deepest = (15.0 * mass * speed * speed / (16.0 * modulus * radius.sqrt())).powf(0.4);
    let contact = 2.943_275_184_324_705 * deepest / speed;
    let touches = column(&scene.run()?, "bounces", "touch_time")?;
    let right = |k: usize| speed / GRAVITY + (k as f64) * (2.0 * speed / GRAVITY + contact);
    Ok(touches.iter().enumerate().map(|(k, &touch)| (touch, right(k))).collect())
}

fn slips() -> Attempt<Pairs> {
    let (stiffness, drawn) = (0.01, 1e-6);
    let (held, fall): (f64, f64) = (0.4 * 4.0 / 3.0, 0.1 * 4.0 / 3.0);
    let scene = pressed().static_kinetic(0.4, 0.3).machine(1.0, stiffness, 0.0);
    let outcome = scene.drive(drawn, 1.1 * held / (stiffness * drawn)).run()?;
    beside(&outcome, &[("slip_jump_m", 2.0 * fall / stiffness), ("slip_time_s", PI / stiffness.sqrt())])
}

fn punch() -> Attempt<Pairs> {
    // G* = 2/3: m d = μd E*/G* = 0.6 at the first slip, μF = 0.8.
    let (stiffness, damping, drawn) = (0.5, 4.0, 1e-2);
    let scene = Sketch::of(flat()).indent(1.0, 1.0).steps(20).coulomb(0.4).machine(1.0, stiffness, damping);
    let outcome = scene.drive(drawn, 300.0).run()?;
    // Steady creep behind the start: c k V/K of drag, K = k + 2G*, and the lag cK⁻¹ of the spring.
    let whole = stiffness + 4.0 / 3.0;
    let along = stiffness * drawn / whole;
    let right = 0.6 / along + damping / whole;
    Ok(vec![(result(&outcome, "first_slip_time_s")? - 1.0, right)])
}

fn punch_on_rubber() -> Attempt<Pairs> {
    let rubber = Relaxation { equilibrium: 0.4, terms: vec![(0.5, 3.0), (0.3, 40.0)], viscosity: 0.0 };
    let scene = Sketch::of(flat()).ground(relaxing(&rubber)).indent(1.0, 1.0).steps(20).static_kinetic(0.4, 0.2);
    let outcome = scene.machine(1.0, 0.05, 0.1).drive(0.3, 80.0).run()?;
    let (starts, forces) = (column(&outcome, "slips", "start_time")?, column(&outcome, "slips", "static_force")?);
    let left =
        |time: f64, (modulus, tau): &(f64, f64)| modulus * tau * -(-1.0 / tau).exp_m1() * (-(time - 1.0) / tau).exp();
    let right = |time: f64| 0.8 * (0.4 + rubber.terms.iter().map(|term| left(time, term)).sum::<f64>());
    Ok(starts.iter().zip(&forces).map(|(&time, &force)| (force, right(time))).collect())
}

fn ledger() -> Attempt<Pairs> {
    let scene = pressed().static_kinetic(0.4, 0.2).machine(1.0, 0.02, 0.05).drive(0.2, 1500.0).drive(-0.1, 500.0);
    Ok(vec![(1.0 + result(&scene.run()?, "energy_error")?, 1.0)])
}

/// Friction 0.6 at 1e-2 m/s over a distance of 0.1 m.
fn rated(direct: f64, evolution: f64) -> Attempt<RateState> {
    Ok(RateState {
        coefficient: si(0.6)?,
        direct: si(direct)?,
        evolution: si(evolution)?,
        distance: si(0.1)?,
        speed: si(1e-2)?,
        law: None,
        state: None,
    })
}

/// The scene of a punch under F = 2 on which a machine of a stiffness draws at 2e-2 m/s; 2G*a = 4/3.
fn drawn_punch((law, stiffness): (RateState, f64), (mass, damping): (f64, f64)) -> Attempt<Sketch> {
    Ok(Sketch::of(flat()).indent(1.0, 1.0).steps(20).rate_state(law).machine(mass, stiffness, damping))
}

fn steady() -> Attempt<Pairs> {
    let law = rated(0.01, 0.013)?;
    let scene = drawn_punch((law, 0.5), (1e-3, 0.1))?.accuracy(1e-9).drive(2e-2, 2000.0);
    let outcome = scene.run()?;
    let last = outcome.records.last().and_then(|record| record.machine?.rated).ok_or("no state")?;
    let right = 0.6 - 0.003 * 2f64.ln();
    let told = beside(&outcome, &[("steady_friction_coefficient", right), ("final_tangential_force_n", 2.0 * right)])?;
    Ok(told.into_iter().chain([(last.state, 5.0), (last.speed, 2e-2)]).collect())
}

fn threshold_of_scene() -> Attempt<Pairs> {
    let (speed, mass): (f64, f64) = (2e-2, 3.0);
    let outcome = drawn_punch((rated(0.01, 0.015)?, 0.3), (mass, 0.0))?.drive(speed, 1.0).run()?;
    let fall: f64 = 2.0 * 0.005 / 0.1;
    let rate = speed / 0.1;
    let inertia = mass * rate * rate * 0.5;
    let right = (fall.recip() - 0.75).recip() + inertia;
    beside(&outcome, &[("critical_stiffness_n_per_m", right), ("critical_frequency_hz", rate * 0.5f64.sqrt() / TAU)])
}

fn at_threshold() -> Attempt<Pairs> {
    let (law, speed) = (rated(0.01, 0.015)?, 2e-2);
    let carried = Carried { force: 2.0, stiffness: 4.0 / 3.0 };
    let free = Suspension { mass: 0.5, stiffness: 0.0, damping: 0.02 };
    let Threshold::At { stiffness, pulse, .. } = threshold(&law, speed, (&free, carried)) else {
        return Err("there is no threshold".into());
    };
    let mut mass = RatedMass::sliding(Suspension { stiffness, ..free }, &law, (carried, 1e-13), (speed, 1e-6));
    let period = TAU / pulse;
    let mut offs = Vec::new();
    // The rest of the disturbance has died down after some periods.
    for quarters in [20.0, 21.0, 60.0, 61.0] {
        while mass.step(0.25 * quarters * period)?.is_some() {}
        offs.push(mass.tangential().force - carried.force * law.steady(speed));
    }
    let size = offs[0].hypot(offs[1]);
    Ok(vec![(1.0 + (offs[2] - offs[0]) / size, 1.0), (1.0 + (offs[3] - offs[1]) / size, 1.0)])
}

fn ages() -> Attempt<Pairs> {
    let law = RateState { state: Some(si(3.0)?), ..rated(0.01, 0.015)? };
    let outcome = drawn_punch((law, 0.3), (1.0, 0.1))?.hold(6.0).drive(0.0, 93.0).run()?;
    let last = outcome.records.last().and_then(|record| record.machine?.rated).ok_or("no state")?;
    Ok(vec![(last.state, 3.0 + 1.0 + 6.0 + 93.0)])
}

fn rated_ledger() -> Attempt<Pairs> {
    let outcome = drawn_punch((rated(0.01, 0.015)?, 0.04), (0.02, 0.05))?.drive(0.1, 400.0).drive(-0.1, 400.0).run()?;
    Ok(vec![(1.0 + result(&outcome, "energy_error")?, 1.0)])
}

fn coulomb_limit() -> Attempt<Pairs> {
    let (speed, stiffness, damping): (f64, f64, f64) = (1e-3, 0.1, 1.0);
    let scene = drawn_punch((rated(1e-6, 0.0)?, stiffness), (1e-4, damping))?;
    // Springs in series, the mass between them going on at a steady speed.
    let give = stiffness.recip() + 0.75;
    let lag = damping * 0.75 * speed / give / stiffness;
    let slides = 1.2 * give / speed + lag / speed;
    let outcome = scene.drive(speed, 0.999 * slides).drive(speed, slides).run()?;
    let forces: Vec<f64> = ends(&outcome).filter_map(|record| Some(record.tangential?.force)).collect();
    let [.., stuck, slid] = forces[..] else { return Err("two drives have two ends".into()) };
    Ok(vec![(stuck, (0.999 * slides * speed - lag) / give), (slid, 1.2)])
}

fn lies() -> Attempt<Pairs> {
    let rubber = Relaxation { equilibrium: 1e6, terms: vec![(3e6, 2e-3)], viscosity: 0.0 };
    let (radius, mass) = (5e-3, 4e-3);
    let scene = Sketch::of(ball(radius)).ground(relaxing(&rubber)).accuracy(1e-2);
    let outcome = scene.machine(mass, 0.0, 0.0).fall(0.02, 3.0).steps(20).run()?;
    let depth: f64 = (0.75 * mass * GRAVITY / (1e6 * radius.sqrt())).powf(2.0 / 3.0);
    beside(&outcome, &[("final_force_n", mass * GRAVITY), ("final_indentation_m", depth)])
}
