//! Stresses below the surface and first yield, from the scene to the tables.

use springbed::input::table::InMemory;
use springbed::run::record::Outcome;
use springbed::run::{Wanted, run};
use springbed::text::Notation;
use std::f64::consts::PI;

const STRESSES: Wanted = Wanted { stresses: true, fields: true, ..Wanted::NOTHING };

fn outcome(text: &str) -> Outcome {
    let plan = Notation::Ron.plan(text, &InMemory::default()).unwrap_or_else(|errors| panic!("{errors:?}"));
    run(&plan, STRESSES).unwrap()
}

/// A ball of 10 mm on steel that yields at 1 GPa, with more to it.
fn ball(more: &str, history: &str) -> Outcome {
    outcome(&format!(
        "(shape: Paraboloid(radius: 0.01), bodies: (Elastic(young: 210e9, poisson: 0.3, yield_stress: 1e9), Rigid), {more} history: [{history}])"
    ))
}

/// Names of the columns of the map.
fn columns(outcome: &Outcome) -> Vec<String> {
    outcome.table("stress").unwrap().columns.iter().map(|column| column.name()).collect()
}

/// Pressed to the force of first yield the hardest place bears the yield stress, where it was said to.
#[test]
fn at_first_yield_the_hardest_place_bears_the_yield_stress() {
    for friction in ["", "friction: Coulomb(coefficient: 0.4),"] {
        let slide = if friction.is_empty() { "" } else { ", Slide(to: 1e-5, over: 1)" };
        let of = |force: f64| ball(friction, &format!("Press(to: {force:e}, over: 1){slide}"));
        let first = of(50.0);
        let number = |outcome: &Outcome, name: &str| outcome.number(name).unwrap();
        let there = of(number(&first, "first_yield_force_n"));
        assert!((number(&there, "von_mises_largest_pa") / 1e9 - 1.0).abs() < 1e-9, "{friction}");
        let depth = number(&there, "first_yield_depth_m");
        assert!(
            (number(&there, "von_mises_largest_depth_m") - depth).abs()
                < 1e-6 * number(&there, "stress_contact_radius_m")
        );
        assert!(
            (number(&there, "first_yield_indentation_m") / number(&there, "largest_indentation_m") - 1.0).abs() < 1e-9
        );
        let told = |outcome: &Outcome| outcome.warnings.iter().any(|told| told.contains("passes first yield"));
        assert!(told(&of(1.001 * number(&first, "first_yield_force_n"))));
        assert!(!told(&of(0.999 * number(&first, "first_yield_force_n"))));
    }
}

/// Hertz without friction is told over the radius, sliding over the place along it; at the trailing edge it is torn by
/// p₀[(1 − 2ν)/3 + πμ(4 + ν)/8], whichever way it slides.
#[test]
fn the_map_is_that_of_what_slides() {
    let still = ball("", "Press(to: 50, over: 1)");
    assert_eq!(
        columns(&still),
        ["radius_m", "depth_m", "sigma_rr_pa", "sigma_tt_pa", "sigma_zz_pa", "tau_rz_pa", "von_mises_pa"]
    );
    for way in [1.0, -1.0] {
        let history = format!("Press(to: 50, over: 1), Slide(to: {:e}, over: 1)", 1e-5 * way);
        let slides = ball("friction: Coulomb(coefficient: 0.4),", &history);
        assert_eq!(
            columns(&slides),
            ["place_m", "depth_m", "sigma_xx_pa", "sigma_yy_pa", "sigma_zz_pa", "tau_xz_pa", "von_mises_pa"]
        );
        let a = slides.number("stress_contact_radius_m").unwrap();
        let table = slides.table("stress").unwrap();
        let of = |quantity: &str| table.column(quantity).unwrap().numbers();
        let trailing = (0..table.rows())
            .find(|&k| (of("place")[k].unwrap() + way * a).abs() < 1e-9 * a && of("depth")[k].unwrap().abs() <= 0.0);
        let torn = 0.4 / 3.0 + PI * 0.4 * 4.3 / 8.0;
        let found = of("sigma_xx")[trailing.unwrap()].unwrap() / slides.number("peak_pressure_pa").unwrap();
        // σ leaves the edge with the root of the depth, 1e-9 a for the surface.
        assert!((found / torn - 1.0).abs() < 2e-4, "{found} {torn}");
    }
}

/// What sticks in part leaves its shear out of the map, and says so.
#[test]
fn partial_slip_is_left_out_and_said_so() {
    let friction = "friction: Coulomb(coefficient: 0.4),";
    let sticks = ball(friction, "Press(to: 50, over: 1), Slide(to: 1e-8, over: 1)");
    assert_eq!(columns(&sticks)[0], "radius_m");
    assert!(sticks.warnings.iter().any(|told| told.contains("those of the pressure alone")));
    let capped = ball(
        "friction: CoulombOrowan(coefficient: 0.4, shear_limit: 1e8),",
        "Press(to: 50, over: 1), Slide(to: 1e-5, over: 1)",
    );
    assert!(columns(&capped)[0] == "radius_m" && capped.warnings.iter().any(|told| told.contains("pressure alone")));
}

/// A sharp edge or tip has no hardest place, and the body yields at once.
#[test]
fn what_is_sharp_yields_at_once() {
    for shape in ["FlatPunch(radius: 1e-3)", "Cone(slope: 0.1)"] {
        let sharp = outcome(&format!(
            "(shape: {shape}, bodies: (Elastic(young: 210e9, poisson: 0.3, yield_stress: 1e9), Rigid), history: [Indent(to: 1e-6, over: 1)])"
        ));
        assert!(
            ["von_mises_largest_pa", "first_yield_force_n"].iter().all(|name| sharp.named(name).is_none()),
            "{shape}"
        );
        assert!(sharp.warnings.iter().any(|told| told.contains("at any load")), "{shape}: {:?}", sharp.warnings);
        assert!(sharp.table("stress").is_some_and(|table| table.rows() > 4000));
    }
}

/// A ball that yields: the loop of the force is the heat, and the dent stays.
#[test]
fn a_loop_of_a_ball_that_yields_is_heat() {
    let text = "(shape: Paraboloid(radius: 0.01), bodies: (Plastic(young: 210e9, poisson: 0.3, yield_stress: 1e9), Rigid), \
        steps: 4000, history: [Indent(to: 2e-5, over: 1), Indent(to: 0, over: 1), Indent(to: 2e-5, over: 1), Press(to: 0, over: 1)])";
    let plan = Notation::Ron.plan(text, &InMemory::default()).unwrap();
    let outcome = run(&plan, Wanted::NOTHING).unwrap();
    let work: f64 = outcome
        .records
        .windows(2)
        .map(|pair| {
            let [one, two] = [&pair[0].normal, &pair[1].normal];
            0.5 * (one.force + two.force) * (two.indentation.unwrap() - one.indentation.unwrap())
        })
        .sum();
    let heat = outcome.number("dissipated_j").unwrap();
    assert!((work / heat - 1.0).abs() < 1e-5, "{work} {heat}");
    let dent = outcome.number("residual_depth_m").unwrap();
    assert!(dent > 1e-5 && (outcome.number("final_indentation_m").unwrap() / dent - 1.0).abs() < 1e-12);
}
