//! Scenes of bodies that glide and roll over bodies that remember.

use springbed::input::table::InMemory;
use springbed::run::record::Outcome;
use springbed::run::{self, Wanted};
use springbed::scene::Scene;

const RUBBER: &str = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 3e6, time: 0.01), (modulus: 1e6, time: 1)]))";

fn scene(shape: &str, bodies: &str, parts: &str, history: &str) -> String {
    format!("(shape: {shape}, bodies: ({bodies}), {parts} history: [{history}])")
}

fn ran(text: &str) -> Outcome {
    let plan =
        Scene::from_ron(text).unwrap().resolve(&InMemory::default()).unwrap_or_else(|problems| panic!("{problems:?}"));
    run::run(&plan, Wanted::NOTHING).unwrap()
}

fn on_rubber(history: &str, parts: &str) -> Outcome {
    ran(&scene("Paraboloid(radius: 5e-3)", &format!("Rigid, {RUBBER}"), parts, history))
}

/// What is wrong with a scene, in one line.
fn refused(text: &str) -> String {
    let problems = Scene::from_ron(text).unwrap().resolve(&InMemory::default()).err().unwrap_or_default();
    problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

fn number(outcome: &Outcome, name: &str) -> f64 {
    outcome.number(name).unwrap_or_else(|| panic!("no {name} in {:?}", outcome.results))
}

/// A row of the list is what the speed alone gives, to the bit; the largest is named.
#[test]
fn a_list_of_speeds_is_each_speed_by_itself() {
    let list = on_rubber("Press(to: 0.1, over: 1), Glide(speed: [1e-3, 1e-2, 0.1])", "");
    let table = list.table("glides").unwrap();
    let column = |name: &str| table.column(name).unwrap().numbers().to_vec();
    for (row, speed) in ["1e-3", "1e-2", "0.1"].into_iter().enumerate() {
        let alone = on_rubber(&format!("Press(to: 0.1, over: 1), Glide(speed: {speed})"), "");
        assert_eq!(alone.number("resistance_coefficient"), column("resistance_coefficient")[row]);
        assert_eq!(alone.number("tangential_force_n"), column("tangential_force")[row]);
        assert_eq!(alone.number("trailing_edge_m"), column("trailing_edge")[row]);
    }
    let largest = column("resistance_coefficient").into_iter().flatten().fold(0.0, f64::max);
    assert_eq!(list.number("largest_resistance_coefficient").map(f64::to_bits), Some(largest.to_bits()));
    // A force is held: each row carries it.
    assert!(column("force").into_iter().flatten().all(|force| (force / 0.1 - 1.0).abs() < 1e-9));
}

/// How many records there are, and where they stand, changes nothing: depths go in straight pieces.
#[test]
fn records_do_not_count() {
    let history =
        "Indent(to: 1e-5, over: 0.1), Glide(speed: 1e-2, over: 0.02), Hold(over: 0.05), Glide(speed: 2e-2, over: 0.02)";
    let few = on_rubber(history, "steps: 1, accuracy: 1e-4,");
    for steps in [2, 3, 50] {
        let many = on_rubber(history, &format!("steps: {steps}, accuracy: 1e-4,"));
        for name in ["tangential_force_n", "final_force_n", "dissipated_j", "resistance_coefficient"] {
            let (one, other) = (number(&few, name), number(&many, name));
            assert!((one / other - 1.0).abs() < 1e-8, "{steps} {name}: {one:e} {other:e}");
        }
    }
    let columns: Vec<String> = few.record_table().columns.iter().map(|column| column.name()).collect();
    for name in ["slide_m", "tangential_force_n", "leading_edge_m", "trailing_edge_m"] {
        assert!(columns.iter().any(|column| column == name), "{columns:?}");
    }
}

/// Under a force the start comes to the steady state too, and the force is met at every record.
#[test]
fn a_start_under_a_force_comes_to_the_steady_state() {
    let outcome = on_rubber("Press(to: 0.1, over: 1), Glide(speed: 2e-2, over: 0.2)", "accuracy: 1e-5, steps: 10,");
    let (last, steady) =
        (number(&outcome, "resistance_coefficient"), number(&outcome, "steady_resistance_coefficient"));
    assert!((last / steady - 1.0).abs() < 5e-3, "{last} {steady}");
    let held = outcome.records.iter().filter(|record| record.time >= 1.0);
    assert!(
        held.clone().count() == 11 && held.into_iter().all(|record| (record.normal.force / 0.1 - 1.0).abs() < 1e-9)
    );
}

/// Bodies that remember nothing do not resist: zero to the bit in the steady state, to rounding on the bed.
#[test]
fn elastic_bodies_do_not_resist() {
    let steel = "Rigid, Elastic(young: 1e6, poisson: 0.5)";
    let steady = ran(&scene("Paraboloid(radius: 5e-3)", steel, "", "Press(to: 0.1, over: 1), Glide(speed: [1e-3, 1])"));
    assert_eq!(steady.number("largest_resistance_coefficient").map(f64::to_bits), Some(0));
    let history = "Indent(to: 1e-5, over: 1), Glide(speed: 1e-3, over: 1)";
    let bed = ran(&scene("Paraboloid(radius: 5e-3)", steel, "accuracy: 1e-4,", history));
    assert!(number(&bed, "largest_tangential_force_n") < 1e-12 * number(&bed, "largest_force_n"));
    assert!(number(&bed, "dissipated_j").abs() < 1e-12 * number(&bed, "work_j"));
}

/// What rolls may itself relax, and which of the two it is does not matter; an elastic partner adds its compliance.
#[test]
fn of_two_that_roll_either_may_relax() {
    let history = "Press(to: 0.1, over: 1), Roll(speed: [1e-3, 1e-2, 0.1])";
    let rolled = |bodies: &str| ran(&scene("Paraboloid(radius: 5e-3)", bodies, "", history)).table("glides").cloned();
    assert_eq!(rolled(&format!("Rigid, {RUBBER}")), rolled(&format!("{RUBBER}, Rigid")));
    let stiff = rolled(&format!("Elastic(young: 1e7, poisson: 0.5), {RUBBER}"));
    assert!(stiff.is_some() && stiff != rolled(&format!("Rigid, {RUBBER}")));
}

#[test]
fn what_cannot_glide_is_told_why() {
    let ball = "Paraboloid(radius: 5e-3)";
    let gliding = |shape: &str, bodies: &str, parts: &str| {
        refused(&scene(shape, bodies, parts, "Indent(to: 1e-5, over: 1), Glide(speed: 1)"))
    };
    let ground = format!("Rigid, {RUBBER}");
    assert_eq!(gliding(ball, &ground, ""), "");
    let said = gliding(ball, &format!("{RUBBER}, Rigid"), "");
    assert!(
        said.contains("Glide with Viscoelastic") && said.contains("the same points of it stay in contact"),
        "{said}"
    );
    let said = gliding("FlatPunch(radius: 1e-3)", &ground, "");
    assert!(said.contains("Glide of a FlatPunch") && said.contains("wall"), "{said}");
    let said = gliding("Cylinder(radius: 1e-2, datum: 1e-2)", &ground, "");
    assert!(said.contains("stand for strips"), "{said}");
    let said = gliding(ball, &ground, "adhesion: Jkr(work: 0.05, edge: Relaxed),");
    assert!(said.contains("Glide with Jkr adhesion"), "{said}");
    let said = gliding(ball, &ground, "friction: Coulomb(coefficient: 0.3),");
    assert!(said.contains("Glide with Coulomb friction"), "{said}");
    let layered = "Rigid, Layered(layers: [(body: Elastic(young: 1e6, poisson: 0.5), thickness: 1e-4)], base: Rigid, bond: Bonded)";
    let said = gliding(ball, layered, "");
    assert!(said.contains("Glide with Layered") && said.contains("stand for radii"), "{said}");
    let said = gliding(ball, "Rigid, Plastic(young: 1e9, poisson: 0.3, yield_stress: 1e6)", "");
    assert!(said.contains("groove"), "{said}");
    let dashpot = "Rigid, Viscoelastic(poisson: 0.5, shear: (equilibrium: 1, terms: [], viscosity: 1))";
    let said = gliding("TruncatedCone(flat_radius: 1e-3, slope: 0.1)", dashpot, "");
    assert!(said.contains("infinitely fast"), "{said}");
}

#[test]
fn a_history_in_which_nothing_can_glide_is_told_why() {
    let history = |entries: &str| refused(&scene("Paraboloid(radius: 5e-3)", &format!("Rigid, {RUBBER}"), "", entries));
    assert!(history("Glide(speed: 1)").contains("the bodies only touch at the start"));
    assert!(history("Indent(to: 1e-5, over: 1), Glide(speed: [])").contains("is an empty list"));
    assert!(history("Indent(to: 1e-5, over: 1), Glide(speed: [1, 2], over: 1)").contains("2 speeds"));
    let said = history("Indent(to: 1e-5, over: 1), Glide(speed: 1), Hold(over: 1)");
    assert!(said.contains("without a duration is the steady state"), "{said}");
    let said = history("Indent(to: 1e-5, over: 1), Glide(speed: 1, over: 1), Retract(speed: 1)");
    assert!(said.contains("Retract beside Glide"), "{said}");
    let said = history("Indent(to: 1e-5, over: 1), Glide(speed: 1, over: 1), Roll(speed: 1)");
    assert!(said.contains("Roll beside Glide"), "{said}");
    let cone = scene("Cone(slope: 0.1)", &format!("Rigid, {RUBBER}"), "", "Indent(to: 1e-5, over: 1), Roll(speed: 1)");
    assert!(refused(&cone).contains("only a ball"));
}

/// Williams, Landel & Ferry: at the temperature T a speed v does what v·a_T does at the reference, where a_T multiplies
/// all times.
#[test]
fn a_temperature_shifts_the_speed() {
    let rubber = |more: &str| {
        format!(
            "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 3e6, time: 0.01)], viscosity: 2), {more})"
        )
    };
    let glided = |rubber: &str, speed: f64| {
        let history = format!("Indent(to: 1e-5, over: 1), Glide(speed: {speed:e})");
        number(
            &ran(&scene("Paraboloid(radius: 5e-3)", &format!("Rigid, {rubber}"), "", &history)),
            "resistance_coefficient",
        )
    };
    let warm = rubber("temperature: \"60 degC\", shift: Wlf(c1: 8.86, c2: \"101.6 K\", reference: \"20 degC\")");
    let factor = 10f64.powf(-8.86 * 40.0 / 141.6);
    for speed in [1e-3, 0.1, 10.0] {
        let (shifted, plain) = (glided(&warm, speed), glided(&rubber(""), speed * factor));
        assert!((shifted / plain - 1.0).abs() < 1e-9, "{shifted} {plain}");
    }
    // At the reference nothing changes, to the bit.
    let same = rubber("temperature: \"20 degC\", shift: Wlf(c1: 8.86, c2: 101.6, reference: 293.15)");
    assert_eq!(glided(&same, 0.1).to_bits(), glided(&rubber(""), 0.1).to_bits());
}

/// Measured shifts shift as the law they come from; beyond them nothing is known.
#[test]
fn a_table_of_shifts_is_its_law() {
    let rows: Vec<f64> = (0..7).map(|k| 283.15 + 10.0 * f64::from(k)).collect();
    let law = |t: f64| -8.86 * (t - 293.15) / (101.6 + (t - 293.15));
    let shifts: Vec<f64> = rows.iter().map(|&t| law(t)).collect();
    let tables = InMemory::default().with("shift.csv", &[("temperature_k", &rows), ("log10_shift", &shifts)]);
    let resolved = |temperature: &str, shift: &str| {
        let body =
            RUBBER.replace("poisson: 0.5,", &format!("poisson: 0.5, temperature: {temperature}, shift: {shift},"));
        let text = scene(
            "Paraboloid(radius: 5e-3)",
            &format!("Rigid, {body}"),
            "",
            "Press(to: 0.1, over: 1), Glide(speed: 0.01)",
        );
        Scene::from_ron(&text).unwrap().resolve(&tables)
    };
    let coefficient = |shift: &str| {
        let plan = resolved("\"60 degC\"", shift).unwrap_or_else(|problems| panic!("{problems:?}"));
        number(&run::run(&plan, Wanted::NOTHING).unwrap(), "resistance_coefficient")
    };
    let (table, wlf) =
        (coefficient("Table(\"shift.csv\")"), coefficient("Wlf(c1: 8.86, c2: 101.6, reference: 293.15)"));
    assert!((table / wlf - 1.0).abs() < 1e-10, "{table} {wlf}");
    let problems = resolved("\"80 degC\"", "Table(\"shift.csv\")").err().unwrap();
    assert!(problems[0].to_string().contains("from 283.15 to 343.15 K"), "{problems:?}");
}

/// A rough line glides in the steady state: slowly and fast without resistance, at rest under its force.
#[test]
fn a_rough_line_glides() {
    let line = "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-6, long: 2e-4, short: 4e-6), length: 2e-4, points: 512, seeds: 2)";
    let text = |history: &str| scene(line, &format!("Rigid, {RUBBER}"), "accuracy: 1e-4,", history);
    let outcome = ran(&text("Press(to: 4e-3, over: 1), Glide(speed: [1e-10, 1e-5, 1e-3, 1e-1, 1e4])"));
    let table = outcome.table("glides").unwrap();
    let of = |name: &str| -> Vec<f64> { table.column(name).unwrap().numbers().iter().copied().flatten().collect() };
    let (coefficients, forces, depths) = (of("resistance_coefficient"), of("force"), of("indentation"));
    assert!(forces.iter().all(|force| (force / 4e-3 - 1.0).abs() < 1e-9), "{forces:?}");
    assert!(coefficients[0] < 1e-4 && coefficients[4] < 1e-4, "{coefficients:?}");
    let largest = coefficients.iter().copied().fold(0.0, f64::max);
    let slope = number(&outcome, "rms_slope");
    assert!(largest > 0.02 * slope && largest < 2.0 * slope, "{largest} beside a slope of {slope}");
    // The faster, the stiffer.
    assert!(depths.windows(2).all(|pair| pair[1] <= pair[0] * (1.0 + 1e-9)), "{depths:?}");
    assert!(table.column("leading_edge").unwrap().numbers().iter().all(Option::is_none));
    // The heat is the power of the resistance over the nominal area; what touches is about as steep as all of it.
    let (heats, resistances, slopes) = (of("heat_per_area"), of("tangential_force"), of("contact_rms_slope"));
    for ((heat, resistance), speed) in heats.iter().zip(&resistances).zip([1e-10, 1e-5, 1e-3, 1e-1, 1e4]) {
        assert!((heat * 2e-4 * 2e-4 / (resistance * speed) - 1.0).abs() < 1e-12, "{heat}");
    }
    assert!(slopes.iter().all(|of| *of > 0.5 * slope && *of < 2.0 * slope), "{slopes:?} {slope}");
    assert!(
        (number(&outcome, "largest_heat_per_area_w_per_m2") / heats.iter().copied().fold(0.0, f64::max) - 1.0).abs()
            < 1e-14
    );
    let alone = ran(&text("Press(to: 4e-3, over: 1), Glide(speed: 1e-3)"));
    assert!((number(&alone, "heat_per_area_w_per_m2") / heats[2] - 1.0).abs() < 1e-6);
    // Persson's theory stands beside it: small at both ends too.
    let theory = of("persson_coefficient");
    assert!(theory[0] < 1e-4 && theory[4] < 1e-4 && theory[2] > 0.02 * slope && theory[2] < 2.0 * slope, "{theory:?}");
    let said = refused(&text("Press(to: 4e-3, over: 1), Roll(speed: 1e-3)"));
    assert!(said.contains("lays each of its heights on one place"), "{said}");
    let liquid = text("Press(to: 4e-3, over: 1), Glide(speed: 1e-3)").replace("equilibrium: 1e6", "equilibrium: 0");
    assert!(refused(&liquid).contains("ironed flat"));
}

/// On a ball the line is gone over once; without roughness it is the ball.
#[test]
fn a_line_on_a_ball_of_vanishing_roughness_is_the_ball() {
    let line = "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-13, long: 1e-3, short: 1e-4), length: 2e-3, points: 4000, base: Some(Paraboloid(radius: 5e-3)))";
    let history = "Indent(to: 1e-5, over: 1), Glide(speed: [1e-3, 1e-1])";
    let (rough, smooth) = (scene(line, &format!("Rigid, {RUBBER}"), "", history), on_rubber(history, ""));
    let rough = ran(&rough);
    for name in ["resistance_coefficient", "force"] {
        let of = |outcome: &Outcome| outcome.table("glides").unwrap().column(name).unwrap().numbers().to_vec();
        for (one, other) in of(&rough).into_iter().zip(of(&smooth)) {
            // Springs of a 450th of the contact.
            assert!((one.unwrap() / other.unwrap() - 1.0).abs() < 1e-4, "{name}: {one:?} {other:?}");
        }
    }
}

const ROUGH: &str = "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-6, long: 2e-4, short: 1e-5), length: 2e-4, points: 128, seeds: 3)";

/// Rough ground set gliding from rest comes to the steady state of the same scene, the mean of its members too, under a force
/// as at a depth; the records do not matter.
#[test]
fn a_rough_line_is_set_gliding() {
    // The pasts of 1 s are left out: twenty of them would be a thousand waves.
    let rubber = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 3e6, time: 0.01)]))";
    // At a depth to what is left of the past, a mean over the last chord of the line; a force is met by a depth that sways as the
    // springs pass its corners, of second order in their width.
    for (first, within) in [("Indent(to: 2e-6, over: 0.1)", 1e-12), ("Press(to: 2e-3, over: 0.1)", 1e-2)] {
        let run = |parts: &str| {
            let history = format!("{first}, Glide(speed: 1e-3, over: 1)");
            ran(&scene(ROUGH, &format!("Rigid, {rubber}"), &format!("accuracy: 1e-4, {parts}"), &history))
        };
        let (one, many) = (run("steps: 2,"), run("steps: 40,"));
        let resistance = number(&one, "tangential_force_n");
        let off = number(&one, "steady_tangential_force_n") / resistance - 1.0;
        assert!(off.abs() < within, "{first} {off:e}");
        let off = number(&many, "tangential_force_n") / resistance - 1.0;
        // Pieces of the depth begin at records: to the accuracy.
        assert!(off.abs() < within.min(1e-3), "{first} {off:e}");
        let off = number(&one, "steady_resistance_coefficient") / number(&one, "resistance_coefficient") - 1.0;
        assert!(off.abs() < 2e-2, "{first} {off:e}");
    }
}
