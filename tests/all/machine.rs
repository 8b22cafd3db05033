//! Contacts in a machine, from scenes.

use springbed::prelude::*;
use springbed::run::record::Outcome;
use springbed::scene::plan::Plan;
use springbed::text::Notation;

fn planned(text: &str) -> Plan {
    Notation::Ron.plan(text, &InMemory::default()).unwrap_or_else(|errors| panic!("{text}: {errors:?}"))
}

fn outcome(text: &str) -> Outcome {
    run(&planned(text), Wanted::NOTHING).unwrap()
}

/// A ball of steel with the machine and the history of `rest`.
fn steel(rest: &str) -> String {
    format!("(shape: Paraboloid(radius: \"5 mm\"), bodies: (Elastic(young: \"210 GPa\", poisson: 0.3), Rigid), {rest})")
}

/// The same of a polymer.
fn polymer(rest: &str) -> String {
    steel(rest).replace("210 GPa", "3 GPa")
}

fn times(outcome: &Outcome, table: &str, column: &str) -> Vec<f64> {
    let column = outcome.table(table).and_then(|table| table.column(column)).unwrap();
    column.numbers().iter().copied().flatten().collect()
}

/// The number of records is a matter of the figure.
#[test]
fn records_do_not_change_bounces() {
    let fall = |steps: usize| {
        let text =
            steel(&format!("machine: (mass: \"4 g\"), history: [Fall(height: \"10 cm\", over: 1)], steps: {steps}"));
        times(&outcome(&text), "bounces", "touch_time")
    };
    let (few, many) = (fall(1), fall(777));
    assert!(few.len() == 4 && many.len() == 4);
    for (one, other) in few.iter().zip(&many) {
        assert!((one / other - 1.0).abs() < 1e-10, "{one:e} {other:e}");
    }
}

const DRIVEN: &str = "friction: StaticKinetic(static: 0.5, kinetic: 0.3), \
    machine: (mass: \"50 g\", stiffness: \"50 kN/m\", damping: \"2 N s/m\"), ";

/// A drive that is cut into entries is the same drive.
#[test]
fn cutting_a_drive_changes_nothing() {
    // With the weaker damper the mass swings two hundred times between slips, and the loops of its memory with it.
    for (damping, most) in [("2 N s/m", 0.3), ("0.5 N s/m", 0.1)] {
        let drive = |entries: &str, steps: usize| {
            let entries = format!("{DRIVEN} history: [Press(to: 2, over: 1), {entries}], steps: {steps}");
            outcome(&polymer(&entries).replace("2 N s/m", damping))
        };
        let whole = drive(&format!("Drive(speed: \"2.7 mm/s\", over: {most})"), 50);
        let (one, other) = (0.4113 * most, most - 0.4113 * most);
        let cut = format!("Drive(speed: \"2.7 mm/s\", over: {one}), Drive(speed: \"2.7 mm/s\", over: {other})");
        let cut = drive(&cut, 333);
        let (one, other) = (times(&whole, "slips", "start_time"), times(&cut, "slips", "start_time"));
        assert!(one.len() > 3 && one.len() == other.len(), "{} {}", one.len(), other.len());
        for (one, other) in one.iter().zip(&other) {
            assert!((one / other - 1.0).abs() < 1e-10, "{one:e} {other:e}");
        }
        assert!(whole.number("energy_error").unwrap() < 1e-10);
    }
}

/// However far the contact has slid, each slip is like the one before.
#[test]
fn many_slips_are_alike() {
    let text =
        polymer(&format!("{DRIVEN} history: [Press(to: 2, over: 1), Drive(speed: \"2.7 mm/s\", over: 10)], steps: 10"));
    let outcome = outcome(&text);
    let starts = times(&outcome, "slips", "start_time");
    assert!(starts.len() > 1000 && outcome.number("energy_error").unwrap() < 1e-10, "{}", starts.len());
    let periods: Vec<f64> = starts[500..].windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(periods.iter().all(|period| (period / periods[0] - 1.0).abs() < 1e-8), "{periods:?}");
}

/// Coulomb's law has no fall: the mass creeps, and slides steadily, drawn by μF.
#[test]
fn a_coulomb_contact_creeps_and_then_slides() {
    let text = steel(
        "friction: Coulomb(coefficient: 0.3), machine: (mass: \"1 g\", stiffness: \"1 kN/m\", damping: \"1 N s/m\"), \
         history: [Press(to: 2, over: 1), Drive(speed: \"1 mm/s\", over: 2)], steps: 100",
    );
    let outcome = outcome(&text);
    let last = outcome.records.last().unwrap();
    let machine = last.machine.unwrap();
    assert_eq!(outcome.table("slips").unwrap().rows(), 1);
    assert!((machine.speed / 1e-3 - 1.0).abs() < 1e-9 && (machine.spring_force - 0.601).abs() < 1e-9, "{machine:?}");
    let creeps = outcome.records.iter().filter(|record| record.time > 1.3 && record.time < 1.5);
    let creeping = creeps.filter(|record| record.tangential.unwrap().stick_radius > 0.0).count();
    assert!(creeping > 5);
}

/// Where the mass is drawn to and fro it goes on from where it is; a drive that stands still lets it rest.
#[test]
fn a_drive_may_turn_and_stop() {
    let text = polymer(&format!(
        "{DRIVEN} history: [Press(to: 2, over: 1), Slide(to: 0, over: 1), Drive(speed: \"1 mm/s\", over: 0.1), \
         Drive(speed: \"-2 mm/s\", over: 0.2), Drive(speed: 0, over: 1)], steps: 200"
    ));
    let text = text.replace("StaticKinetic(static: 0.5, kinetic: 0.3)", "Coulomb(coefficient: 0.3)");
    let outcome = outcome(&text);
    let last = outcome.records.last().unwrap();
    assert!((last.machine.unwrap().drawn.unwrap() + 3e-4).abs() < 1e-15, "{last:?}");
    assert!(last.machine.unwrap().speed.abs() < 1e-9 && outcome.number("energy_error").unwrap() < 1e-10, "{last:?}");
}

/// A ball on rubber loses at every bounce, lies in the end, and its energy is told.
#[test]
fn a_ball_on_rubber_comes_to_lie() {
    let text = "(shape: Paraboloid(radius: \"5 mm\"), bodies: (Rigid, Viscoelastic(poisson: 0.5, \
        shear: (equilibrium: \"1 MPa\", terms: [(modulus: \"2 MPa\", time: \"1 ms\")]))), machine: (mass: \"4 g\"), \
        history: [Fall(height: \"5 cm\", over: 3)], accuracy: 1e-2, steps: 100)";
    let outcome = outcome(text);
    let rebounds = times(&outcome, "bounces", "restitution");
    assert!(rebounds.len() > 2 && rebounds.iter().all(|&rebound| rebound > 0.0 && rebound < 1.0), "{rebounds:?}");
    assert!(outcome.number("rest_time_s").unwrap() < 3.0);
    assert!(outcome.number("energy_error").unwrap() < 1e-3 && outcome.error_estimate.relative < 5e-2, "{outcome:?}");
}

/// A body with a dashpot is left at once: a mass that falls onto it rebounds as one that strikes it, whose weight is next to
/// nothing beside the force.
#[test]
fn a_mass_falls_on_a_body_with_a_dashpot() {
    let damped = |machine: &str, history: &str| {
        outcome(&format!(
            "(shape: Paraboloid(radius: 5e-3), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e9, viscosity: 3e3)), Rigid), {machine} history: [{history}], steps: 20)"
        ))
    };
    let fallen = damped("machine: (mass: 4e-3),", "Fall(height: 0.05, over: 0.3)");
    let struck = damped("", &format!("Impact(mass: 4e-3, speed: {:e})", (2.0 * 9.806_65 * 0.05f64).sqrt()));
    let touches = times(&fallen, "bounces", "touch_time");
    assert!((touches[0] - (0.1 / 9.806_65f64).sqrt()).abs() < 1e-6, "{touches:?}");
    // Up and down again at the speed of the rebound.
    let flight = (touches[1] - touches[0]) * 0.5 * 9.806_65;
    let rebound = struck.number("rebound_speed_m_per_s").unwrap();
    assert!((flight / rebound - 1.0).abs() < 1e-2, "{flight} {rebound}");
}

/// A soft bead, R = 5 mm, E* = 4/3 MPa, w = 50 mJ/m², in the machine and the history of `rest`.
fn sticky(rest: &str) -> Outcome {
    outcome(&format!(
        "(shape: Paraboloid(radius: 5e-3), bodies: (Elastic(young: 1e6, poisson: 0.5), Rigid), adhesion: Jkr(work: 0.05), {rest})"
    ))
}

/// Work to part the bead from first touch, 7.092196 (w⁵R⁴/E*²)^{1/3}, and the stretch at which it parts,
/// 3/4 (π²w²R/E*²)^{1/3} [J, m].
fn parting() -> (f64, f64) {
    let (w, r, e) = (0.05f64, 5e-3f64, 4e6 / 3.0);
    let stretch = 0.75 * (std::f64::consts::PI.powi(2) * w * w * r / (e * e)).cbrt();
    (7.092_196 * (w.powi(5) * r.powi(4) / (e * e)).cbrt(), stretch)
}

/// An adhesive bead that falls fast bounces with what the jumps leave of its energy, and one that falls slowly stays.
#[test]
fn an_adhesive_bead_bounces_or_stays() {
    let (lost, stretch) = parting();
    let mass = 5e-6;
    let critical = 2.0 * lost / mass;
    let fall = |height: f64| {
        sticky(&format!(
            "machine: (mass: {mass}), history: [Fall(height: {height:e}, over: 0.05)], accuracy: 1e-3, steps: 20"
        ))
    };
    let high = 4.0 * critical / (2.0 * 9.80665);
    let outcome = fall(high);
    let (speeds, rebounds) = (times(&outcome, "bounces", "speed"), times(&outcome, "bounces", "rebound_speed"));
    assert!(!rebounds.is_empty(), "{outcome:?}");
    for (speed, rebound) in speeds.iter().zip(&rebounds) {
        // As it parts it is higher by the stretch than where it touched.
        let right = speed * speed - critical - 2.0 * 9.80665 * stretch;
        assert!((rebound * rebound / right - 1.0).abs() < 2e-3, "{speed} {rebound} {right}");
    }
    assert!(outcome.number("energy_error").unwrap() < 1e-3, "{:?}", outcome.number("energy_error"));
    assert!(times(&fall(0.8 * critical / (2.0 * 9.80665)), "bounces", "rebound_speed").is_empty());
}

/// About a load an adhesive contact swings with dF/dd of its own way, softer than with an edge that stands still; drawn too
/// far it snaps off.
#[test]
fn an_adhesive_contact_rings_and_snaps_off() {
    let load = 2e-3;
    let ring = |amplitude: &str| {
        sticky(&format!(
            "machine: (mass: 5e-4), history: [Press(to: {load}, over: 1), Ring(amplitude: {amplitude}, over: 0.1)], accuracy: 1e-3, steps: 20"
        ))
    };
    let depth = |force: f64| {
        sticky(&format!("history: [Press(to: {force:e}, over: 1)]")).number("final_indentation_m").unwrap()
    };
    let step = 1e-5;
    let stiffness = 2.0 * step / (depth(load + step) - depth(load - step));
    let right = (stiffness / 5e-4).sqrt() / std::f64::consts::TAU;
    let found = ring("1e-7").number("frequency_hz").unwrap();
    assert!((found / right - 1.0).abs() < 1e-3, "{found} {right}");
    let far = ring("1e-4");
    let last = far.records.iter().map(|record| record.normal.dissipated).fold(0.0, f64::max);
    assert!(
        last > 0.0 && far.records.iter().any(|record| record.normal.force.abs() <= 0.0 && record.machine.is_some())
    );
}

/// A punch of granite under rate and state, with what the friction, the machine and the history say.
fn granite(friction: &str, machine: &str, history: &str) -> String {
    format!(
        "(shape: FlatPunch(radius: \"10 mm\"), bodies: (Elastic(young: \"60 GPa\", poisson: 0.25), Rigid), \
         friction: RateState(coefficient: 0.6, {friction}, distance: \"10 um\", speed: \"1 um/s\"), \
         machine: ({machine}), history: [Press(to: \"1 kN\", over: 1), {history}])"
    )
}

const WEAKENS: &str = "direct: 0.01, evolution: 0.015";
const SOFT: &str = "mass: 1, stiffness: \"300 kN/m\", damping: \"2 kN s/m\"";

/// Where a drive of rate and state is cut or recorded changes nothing, to the last bit.
#[test]
fn cuts_of_a_drive_with_rate_and_state_change_no_bit() {
    let slips = |history: &str, steps: usize| {
        let text = granite(WEAKENS, SOFT, history).replace(")])", &format!(")], steps: {steps})"));
        let outcome = outcome(&text);
        (times(&outcome, "slips", "start_time"), times(&outcome, "slips", "jump"), outcome.records.last().copied())
    };
    let whole = slips("Drive(speed: \"10 um/s\", over: 256)", 10);
    let cut = slips("Drive(speed: \"10 um/s\", over: 64), Drive(speed: \"10 um/s\", over: 192)", 64);
    assert!(whole.0.len() > 1 && (&whole.0, &whole.1) == (&cut.0, &cut.1), "{:?} {:?}", whole.0, cut.0);
    let (one, other) = (whole.2.unwrap(), cut.2.unwrap());
    assert_eq!((one.tangential, one.machine), (other.tangential, other.machine));
}

/// Above the critical stiffness a drive comes to slide steadily, below it never.
#[test]
fn a_stiff_spring_slides_steadily_and_a_soft_one_does_not() {
    let run = |law: &str, stiffness: &str| {
        let machine = SOFT.replace("300 kN/m", stiffness).replace("2 kN s/m", "200 N s/m");
        outcome(&granite(&format!("{WEAKENS}{law}"), &machine, "Drive(speed: \"10 um/s\", over: 400)"))
    };
    for law in ["", ", law: Slip"] {
        let (steady, broken) = (run(law, "900 kN/m"), run(law, "440 kN/m"));
        let right = 600.0 - 5.0 * 10f64.ln();
        assert!((steady.number("final_tangential_force_n").unwrap() / right - 1.0).abs() < 1e-6, "{law}");
        let speeds = |outcome: &Outcome| {
            let late = outcome.records.iter().filter(|record| record.time > 300.0);
            late.map(|record| record.machine.unwrap().rated.unwrap().speed).fold(0.0, f64::max)
        };
        assert!((speeds(&steady) / 1e-5 - 1.0).abs() < 1e-6 && speeds(&broken) > 1e-3, "{law}: {:e}", speeds(&broken));
        let critical = broken.number("critical_stiffness_n_per_m").unwrap();
        assert!(critical > 500e3 && critical < 501e3, "{critical}");
    }
}

/// Without a direct effect and one of the state the friction is Coulomb's, to the last bit.
#[test]
fn rate_and_state_without_effects_is_coulomb() {
    let rated = granite("direct: 0, evolution: 0", SOFT, "Drive(speed: \"10 um/s\", over: 300)");
    let begin = rated.find("RateState(").unwrap();
    let end = rated.find(", machine").unwrap();
    let coulomb = format!("{}Coulomb(coefficient: 0.6){}", &rated[..begin], &rated[end..]);
    assert_eq!(outcome(&rated).records, outcome(&coulomb).records);
}

/// A contact that has lain slips later by the ageing law, and no later by the slip law.
#[test]
fn a_contact_that_has_lain_holds_more() {
    let held = |law: &str, hold: &str| {
        let history = format!("{hold}Drive(speed: \"10 um/s\", over: 260)");
        outcome(&granite(&format!("{WEAKENS}{law}"), SOFT, &history)).number("largest_tangential_force_n").unwrap()
    };
    let hold = "HoldForce(over: 10000), ";
    assert!(held("", hold) > held("", "") + 10.0);
    assert!((held(", law: Slip", hold) - held(", law: Slip", "")).abs() < 1e-9);
    assert!((held(", law: Slip, state: 10011", hold) - held(", law: Slip, state: 10011", "")).abs() < 1e-9);
}

/// Friction that grows with the speed has no critical stiffness; a contact that lets go by itself is an error that says so.
#[test]
fn contacts_beyond_the_threshold_are_told() {
    let strengthens = outcome(&granite("direct: 0.015, evolution: 0.01", SOFT, "Drive(speed: \"10 um/s\", over: 100)"));
    assert!(strengthens.number("critical_stiffness_n_per_m").is_none());
    let text = granite(WEAKENS, SOFT, "Drive(speed: \"10 um/s\", over: 1000)").replace("60 GPa", "30 MPa");
    let error = run(&planned(&text), Wanted::NOTHING).unwrap_err().to_string();
    assert!(error.contains("history[1]") && error.contains("rupture"), "{error}");
}

/// A mass comes down on a liquid whose memory is short and creeps: where it begins to, the forces are a little out of balance,
/// and the jump into balance takes less time than the rounding of the time of the motion. To the accuracy asked for and
/// the inertia that is left out.
#[test]
fn a_mass_creeps_into_a_liquid_of_short_memory() {
    let end = |accuracy: f64| {
        let outcome = outcome(&format!(
            "(shape: Paraboloid(radius: 1.5811388300841897e-4), bodies: (Viscoelastic(poisson: 0.5, shear: (terms: \
             [(modulus: 1.778279410038923e7, time: 1e-5), (modulus: 5.623413251903491e8, time: 3.1622776601683797e-7)])), \
             Elastic(young: 1.1246826503806981e8, poisson: 0.5)), machine: (mass: 2.8117066259517456e-6), steps: 4, \
             accuracy: {accuracy:e}, history: [Fall(height: 1e-5, over: 2e-2)])"
        ));
        outcome.records.last().and_then(|record| record.normal.indentation).unwrap()
    };
    let (coarse, fine) = (end(1e-3), end(1e-6));
    assert!((coarse / fine - 1.0).abs() < 2e-3, "{coarse:e} {fine:e}");
}
