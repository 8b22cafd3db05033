//! Scenes of bodies that roll with traction.

use springbed::check::matrix::{Kept, Variation, cells};
use springbed::input::table::InMemory;
use springbed::run::record::Outcome;
use springbed::run::unit::Unit;
use springbed::run::{self, Wanted};
use springbed::scene::Scene;

const STEEL: &str = "Elastic(young: 210e9, poisson: 0.3), Elastic(young: 210e9, poisson: 0.3)";
const FRICTION: &str = "friction: Coulomb(coefficient: 0.3),";
const ROLLER: &str = "Cylinder(radius: 1e-2, datum: 2e-2, width: 2e-2)";
const BALL: &str = "Paraboloid(radius: 1e-2)";

fn scene(shape: &str, bodies: &str, parts: &str, history: &str) -> String {
    format!("(shape: {shape}, bodies: ({bodies}), {parts} history: [{history}])")
}

fn tried(text: &str) -> Result<Outcome, String> {
    let plan =
        Scene::from_ron(text).unwrap().resolve(&InMemory::default()).unwrap_or_else(|problems| panic!("{problems:?}"));
    run::run(&plan, Wanted::NOTHING).map_err(|error| error.to_string())
}

fn ran(text: &str) -> Outcome {
    tried(text).unwrap()
}

fn refused(text: &str) -> String {
    let problems = Scene::from_ron(text).unwrap().resolve(&InMemory::default()).err().unwrap_or_default();
    problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

fn number(outcome: &Outcome, name: &str) -> f64 {
    outcome.number(name).unwrap_or_else(|| panic!("no {name} in {:?}", outcome.results))
}

fn column(outcome: &Outcome, table: &str, name: &str) -> Vec<f64> {
    let table = outcome.table(table).unwrap_or_else(|| panic!("no table {table}"));
    table.column(name).unwrap_or_else(|| panic!("no column {name}")).numbers().iter().copied().flatten().collect()
}

/// A row of the list is what its value alone gives, to the bit.
#[test]
fn a_list_is_each_value_by_itself() {
    for shape in [ROLLER, BALL] {
        let rolled = |asked: &str| {
            ran(&scene(shape, STEEL, FRICTION, &format!("Press(to: 100, over: 1), Roll(speed: 2, {asked})")))
        };
        let list = rolled("creepage: [-1e-4, 1e-3, \"2 %\"]");
        assert!(list.number("creepage").is_none() && list.number("full_slip_creepage").is_some());
        for (row, creepage) in ["-1e-4", "1e-3", "0.02"].into_iter().enumerate() {
            let alone = rolled(&format!("creepage: {creepage}"));
            for name in ["creepage", "tangential_force_n", "stick_width_m", "friction_power_w"] {
                let (quantity, _) = Unit::of_name(name);
                let in_list = column(&list, "tractions", quantity)[row];
                assert_eq!(number(&alone, name).to_bits(), in_list.to_bits(), "{name}");
            }
        }
        // Braking is driving the other way.
        let (one, other) = (rolled("creepage: 1e-3"), rolled("creepage: -1e-3"));
        assert_eq!(number(&one, "tangential_force_n").to_bits(), (-number(&other, "tangential_force_n")).to_bits());
        assert_eq!(number(&one, "friction_power_w").to_bits(), number(&other, "friction_power_w").to_bits());
    }
}

/// Whether the depth or the force is held, and whether the creepage or the traction is prescribed.
#[test]
fn what_is_prescribed_does_not_count() {
    for shape in [ROLLER, BALL] {
        let by_force = ran(&scene(shape, STEEL, FRICTION, "Press(to: 100, over: 1), Roll(speed: 2, creepage: 1e-4)"));
        let depth = number(&by_force, "final_indentation_m");
        let history = format!("Indent(to: {depth:e}, over: 1), Roll(speed: 2, creepage: 1e-4)");
        let by_depth = ran(&scene(shape, STEEL, FRICTION, &history));
        let traction = number(&by_force, "tangential_force_n");
        assert!((number(&by_depth, "tangential_force_n") / traction - 1.0).abs() < 1e-9);
        let history = format!("Press(to: 100, over: 1), HoldForce(over: 1), Roll(speed: 2, traction: {traction:e})");
        let pulled = ran(&scene(shape, STEEL, FRICTION, &history));
        assert!((number(&pulled, "creepage") / 1e-4 - 1.0).abs() < 1e-9);
    }
}

/// Without a width all is per metre: twice the width under twice the force creeps alike.
#[test]
fn a_width_scales_the_forces() {
    let history = |force: f64| format!("Press(to: {force:e}, over: 1), Roll(speed: 2, creepage: [1e-4, 1e-3])");
    let wide = ran(&scene(ROLLER, STEEL, FRICTION, &history(2e3)));
    let per_metre = ran(&scene("Cylinder(radius: 1e-2, datum: 2e-2)", STEEL, FRICTION, &history(1e5)));
    for (name, factor) in [("tangential_force", 0.02), ("friction_power", 0.02), ("stick_width", 1.0)] {
        let pairs = column(&wide, "tractions", name).into_iter().zip(column(&per_metre, "tractions", name));
        assert!(pairs.into_iter().all(|(one, other)| (one / (factor * other) - 1.0).abs() < 1e-9), "{name}");
    }
}

/// A ball tells how far its bed is from Kalker, and its error is no less.
#[test]
fn the_deficit_of_a_ball_is_told() {
    let rolled = |shape: &str, poisson: f64| {
        let steel = format!("Elastic(young: 210e9, poisson: {poisson}), Elastic(young: 210e9, poisson: {poisson})");
        ran(&scene(shape, &steel, FRICTION, "Press(to: 100, over: 1), Roll(speed: 2, creepage: 1e-5)"))
    };
    let ball = rolled(BALL, 0.25);
    let said = ball.warnings.join("; ");
    assert!(said.contains("2.29, 45 % below Kalker's C11 = 4.12") && said.contains("not of strips"), "{said}");
    let ratio = number(&ball, "creep_stiffness_n") / number(&ball, "kalker_creep_stiffness_n");
    assert!((ball.error_estimate.relative - (1.0 - ratio)).abs() < 1e-12 && ball.error_estimate.basis.contains("C11"));
    assert!(number(&ball, "tangential_force_n") < number(&ball, "kalker_tangential_force_n"));
    // Outside of Kalker's table there is nothing to set beside it, and that is said too.
    let auxetic = rolled(BALL, -0.2);
    assert!(auxetic.number("kalker_creep_stiffness_n").is_none() && auxetic.warnings.join("; ").contains("some half"));
    let roller = rolled(ROLLER, 0.25);
    assert!(roller.error_estimate.relative < 1e-9 && roller.warnings.is_empty(), "{:?}", roller.warnings);
}

/// Two spheres are the ball of their effective radius.
#[test]
fn two_spheres_roll_on_each_other() {
    let history = "Press(to: 10, over: 1), Roll(speed: 2, creepage: [1e-4, 1e-3])";
    let two = ran(&scene("Spheres(radius_1: 2e-2, radius_2: 2e-2)", STEEL, FRICTION, history));
    let one = ran(&scene(BALL, STEEL, FRICTION, history));
    assert_eq!(column(&two, "tractions", "tangential_force"), column(&one, "tractions", "tangential_force"));
}

/// Without friction nothing is transmitted; no creepage is free rolling, and sticks everywhere.
#[test]
fn limits() {
    let rolled = |friction: f64, creepage: f64| {
        let friction = format!("friction: Coulomb(coefficient: {friction}),");
        let history = format!("Press(to: 100, over: 1), Roll(speed: 2, creepage: {creepage:e})");
        ran(&scene(ROLLER, STEEL, &friction, &history))
    };
    let smooth = rolled(0.0, 1e-3);
    assert!(number(&smooth, "tangential_force_n").abs() <= 0.0 && number(&smooth, "friction_power_w").abs() <= 0.0);
    let free = rolled(0.3, 0.0);
    assert!(number(&free, "tangential_force_n").abs() <= 0.0);
    let contact = 2.0 * number(&free, "final_contact_radius_m");
    assert_eq!(number(&free, "stick_width_m").to_bits(), contact.to_bits());
    // Friction without end sticks: T = 2G*a²ξ on the bed, (π/2)E*Waξ = 2PRξ/a of the roller.
    let stuck = number(&rolled(1e9, 1e-4), "tangential_force_n");
    assert!((stuck / (2.0 * 100.0 * 1e-2 * 1e-4 / (0.5 * contact)) - 1.0).abs() < 1e-6);
}

#[test]
fn what_cannot_roll_with_traction_is_told_why() {
    let rolled = |shape: &str, bodies: &str, parts: &str, roll: &str| {
        refused(&scene(shape, bodies, parts, &format!("Press(to: 100, over: 1), {roll}")))
    };
    let creep = "Roll(speed: 2, creepage: 1e-3)";
    let rubber = "Rigid, Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 3e6, time: 0.01)]))";
    assert_eq!(rolled(BALL, STEEL, FRICTION, creep), "");
    for (shape, bodies, parts, roll, why) in [
        (BALL, STEEL, "", creep, "needs friction"),
        (BALL, STEEL, "friction: Pressure(shear: 1e6, slope: 0.1),", creep, "under Coulomb's law alone"),
        (BALL, rubber, FRICTION, creep, "a Viscoelastic body"),
        ("Cone(slope: 0.1)", STEEL, FRICTION, creep, "of a Cone cannot be computed"),
        (BALL, STEEL, FRICTION, "Roll(speed: 2, creepage: 1e-3, traction: 1)", "one follows from the other"),
        (BALL, STEEL, FRICTION, "Roll(speed: 2, creepage: [])", "is an empty list"),
        (BALL, STEEL, FRICTION, "Roll(speed: 2, creepage: 1e-3, over: 1)", "expected no `over`"),
        (BALL, STEEL, FRICTION, "Roll(speed: [1, 2], creepage: 1e-3)", "expected one speed"),
        (BALL, STEEL, FRICTION, "Glide(speed: 2, creepage: 1e-3)", "expected Roll"),
        (BALL, STEEL, FRICTION, "Roll(speed: 2)", "or a creepage or traction"),
        (BALL, STEEL, FRICTION, "Slide(to: 1e-6, over: 1), Roll(speed: 2, creepage: 1e-3)", "Slide beside a Roll"),
        (BALL, STEEL, FRICTION, "Roll(speed: 2, creepage: 1e-3), Hold(over: 1)", "behind which nothing can follow"),
    ] {
        let said = rolled(shape, bodies, parts, roll);
        assert!(said.contains(why) && said.contains("Roll") && said.contains("expected"), "{roll}: {said}");
    }
    let wear = format!("{FRICTION} wear: Archard(coefficient: 1e-15),");
    assert!(rolled(BALL, STEEL, &wear, creep).contains("Archard wear"));
    let plots = |plot: &str| rolled(BALL, STEEL, &format!("{FRICTION} plots: [{plot}],"), creep);
    assert_eq!(plots("Traction, Force, Radius, Pressure"), "");
    assert!(plots("Resistance").contains("without a traction") && plots("Stick").contains("slides along no way"));
    // What the load cannot hold is known from the run.
    let beyond = tried(&scene(BALL, STEEL, FRICTION, "Press(to: 100, over: 1), Roll(speed: 2, traction: 31)"));
    assert!(beyond.unwrap_err().contains("more than friction holds"));
    let apart = "Press(to: 100, over: 1), Retract(speed: 1e-6), Roll(speed: 2, creepage: 1e-3)";
    assert!(tried(&scene(BALL, STEEL, FRICTION, apart)).unwrap_err().contains("not in contact"));
}

/// Of all combinations of the matrix those that roll with traction keep every law that speaks of them.
#[test]
fn combinations_keep_the_laws() {
    let cells = cells().into_iter().filter(|cell| cell.names()[4] == "traction");
    let kept: Vec<Kept> = cells.flat_map(|cell| cell.laws(&Variation::default(), 0.4)).collect();
    // Ball and lying cylinder, one body elastic or both.
    assert!(kept.len() >= 12, "{kept:?}");
    assert!(kept.iter().all(|kept| kept.failure.is_none()), "{kept:?}");
}
