//! Friction through whole scenes: laws that hold for every history, and limits.

use proptest::prelude::*;
use springbed::contact::adhesion::{Adhesion, Jkr};
use springbed::friction::{Coulomb, CoulombOrowan, Friction, PressureLaw, Strength};
use springbed::input::quantity::{
    Amplitude, Displacement, Duration, Force, Frequency, Length, Modulus, Poisson, Positive, Ratio, Speed, Stress,
    Viscosity, WorkOfAdhesion,
};
use springbed::input::table::InMemory;
use springbed::material::{Body, Elastic, Shear, Term, Terms, Viscoelastic};
use springbed::run::record::{Outcome, Record};
use springbed::run::{self, Wanted};
use springbed::scene::Scene;
use springbed::scene::history::{Entry, Indent, Oscillate, Press, Retract, Slide};
use springbed::shape::{Cone, Paraboloid, RoundedPunch, Shape};
use std::num::NonZeroUsize;

/// G*/E* of rubber on a rigid body.
const RATIO: f64 = 2.0 / 3.0;

fn shapes() -> [Shape; 3] {
    let length = |x: f64| Length::new(x).unwrap();
    [
        Shape::Paraboloid(Paraboloid { radius: length(1.0) }),
        Shape::Cone(Cone { slope: Positive::new(0.7).unwrap() }),
        Shape::RoundedPunch(RoundedPunch { flat_radius: length(0.4), edge_radius: length(0.5) }),
    ]
}

fn ball() -> Shape {
    let [ball, ..] = shapes();
    ball
}

fn coulomb(coefficient: f64) -> Friction {
    Friction::Coulomb(Coulomb { coefficient: Ratio::new(coefficient).unwrap() })
}

/// E* = 1 and G* = 2/3.
fn scene(shape: Shape, friction: Friction, history: Vec<Entry>) -> Scene {
    let rubber =
        Elastic { young: Modulus::new(0.75).unwrap(), poisson: Poisson::new(0.5).unwrap(), yield_stress: None };
    Scene {
        title: String::new(),
        shape,
        bodies: (Body::Elastic(rubber), Body::Rigid),
        adhesion: None,
        friction: Some(friction),
        history,
        accuracy: None,
        springs: None,
        steps: NonZeroUsize::new(5),
        plots: None,
        wear: None,
        machine: None,
        sweep: None,
        fit: None,
        solver: None,
    }
}

fn run_with(scene: Scene, tables: &InMemory) -> Outcome {
    run::run(&scene.resolve(tables).unwrap(), Wanted::NOTHING).unwrap()
}

fn run(scene: Scene) -> Outcome {
    run_with(scene, &InMemory::default())
}

fn indent(to: f64) -> Entry {
    Entry::Indent(Indent { to: Displacement::new(to).unwrap(), over: Duration::new(1.0).unwrap() })
}

fn press(to: f64) -> Entry {
    Entry::Press(Press { to: Force::new(to).unwrap(), over: Duration::new(1.0).unwrap() })
}

fn slide(to: f64) -> Entry {
    Entry::Slide(Slide { to: Displacement::new(to).unwrap(), over: Duration::new(1.0).unwrap() })
}

fn shake(amplitude: f64, cycles: f64) -> Entry {
    Entry::Shake(Oscillate {
        amplitude: Amplitude::new(amplitude).unwrap(),
        frequency: Frequency::new(1.0).unwrap(),
        cycles: Positive::new(cycles).unwrap(),
    })
}

fn force(record: &Record) -> f64 {
    record.tangential.unwrap().force
}

fn last(outcome: &Outcome) -> Record {
    *outcome.records.last().unwrap()
}

/// A table of knots: load (depth or force) and slide, from integers.
fn table(column: &str, knots: &[(i32, i32)], reach: f64) -> InMemory {
    let time: Vec<f64> = (0..knots.len()).map(|k| k as f64).collect();
    let load: Vec<f64> = knots.iter().map(|knot| 0.1 * f64::from(knot.0)).collect();
    let slide: Vec<f64> = knots.iter().map(|knot| 0.1 * f64::from(knot.1) * reach).collect();
    InMemory::default().with("h.csv", &[("time_s", &time), (column, &load), ("slide_m", &slide)])
}

fn knots() -> impl Strategy<Value = Vec<(i32, i32)>> {
    prop::collection::vec((0i32..12, -30i32..30), 2..16)
}

proptest! {
    #![proptest_config(crate::laws::cases(48))]

    /// Load and slide vary together in any way, parting and touching again: |F_x| ≤ μF, energy is only
    /// ever lost, and mirrored slides give the mirrored force, to the last bit.
    #[test]
    fn laws_of_coulomb_friction(knots in knots(), by_force in 0..2, k in -60i32..60) {
        let coefficient = 10f64.powf(0.1 * f64::from(k));
        let column = ["indentation_m", "force_n"][by_force as usize];
        let mirrored: Vec<(i32, i32)> = knots.iter().map(|knot| (knot.0, -knot.1)).collect();
        for shape in shapes() {
            let run = |knots: &[(i32, i32)]| {
                let scene = scene(shape.clone(), coulomb(coefficient), vec![Entry::Table("h.csv".into())]);
                run_with(scene, &table(column, knots, coefficient / RATIO))
            };
            let (outcome, mirror) = (run(&knots), run(&mirrored));
            let mut lost = 0.0;
            for (record, other) in outcome.records.iter().zip(&mirror.records) {
                let limit = coefficient * record.normal.force;
                // A rounding of the largest load: increments are added up over the memory.
                prop_assert!(force(record).abs() <= limit + 1e-14 * coefficient, "{} {limit}", force(record));
                prop_assert!((force(record) + force(other)).abs() <= 0.0);
                let state = record.tangential.unwrap();
                let dissipated = state.dissipated.unwrap();
                prop_assert!(dissipated >= lost && state.stored.unwrap() >= 0.0);
                // Both radii are roots for a depth, found on two ways.
                let radius = record.normal.contact_radius.unwrap();
                prop_assert!(state.stick_radius <= radius * (1.0 + 4e-15), "{} {radius}", state.stick_radius);
                lost = dissipated;
            }
        }
    }

    /// The bed of springs is within its bound μE*dΔx of the memory, and loses the same energy.
    #[test]
    fn the_bed_of_springs_is_the_twin(knots in knots(), k in -20i32..20) {
        let coefficient = 10f64.powf(0.1 * f64::from(k));
        let tables = table("indentation_m", &knots, coefficient / RATIO);
        prop_assume!(knots.iter().any(|knot| knot.0 > 0));
        for shape in shapes() {
            let memory = scene(shape, coulomb(coefficient), vec![Entry::Table("h.csv".into())]);
            let springs = Scene { springs: NonZeroUsize::new(400), ..memory.clone() };
            let (memory, springs) = (run_with(memory, &tables), run_with(springs, &tables));
            let largest = memory.number("largest_contact_radius_m").unwrap();
            let width = (1.0 + 1.0 / 16.0) * largest / 400.0;
            // Bodies that only touch may be one record or two: the last at each time counts.
            let last_at = |outcome: &Outcome| -> Vec<Record> {
                let together = outcome.records.chunk_by(|one, next| one.time.to_bits() == next.time.to_bits());
                together.filter_map(|records| records.last().copied()).collect()
            };
            let (exact, bed) = (last_at(&memory), last_at(&springs));
            prop_assert_eq!(exact.len(), bed.len());
            for (exact, bed) in exact.iter().zip(&bed) {
                let bound = coefficient * exact.normal.indentation.unwrap().max(0.0) * width;
                let rounding = 1e-14 * coefficient;
                prop_assert!((force(exact) - force(bed)).abs() <= bound * (1.0 + 1e-9) + rounding, "{} {} {bound:e}", force(exact), force(bed));
            }
            // Each spring's loss is exact, so that the sum is off by half a cell of its variation: at most
            // twice the greatest loss per length, μE*d times the way of all slides.
            // The first row is slid to from zero.
            let first = knots[0].1.abs();
            let way: i32 = first + knots.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs()).sum::<i32>();
            let bound = 2.0 * coefficient * 1.1 * 0.1 * f64::from(way) * coefficient / RATIO * width;
            let lost = [&memory, &springs].map(|outcome| outcome.number("friction_dissipated_j").unwrap());
            prop_assert!((lost[0] - lost[1]).abs() <= bound + 1e-14, "{lost:?} {bound}");
        }
    }
}

/// Without friction no force; with very much of it the contact sticks, F_x = 2G*a u, for depth and
/// force alike.
#[test]
fn no_friction_and_no_slip_are_limits() {
    for shape in shapes() {
        for hold in [indent(0.5), press(0.5)] {
            let history = || vec![hold.clone(), slide(0.01)];
            let smooth = last(&run(scene(shape.clone(), coulomb(0.0), history())));
            assert!(force(&smooth).abs() <= 0.0 && smooth.tangential.unwrap().dissipated.unwrap().abs() <= 0.0);
            let stuck = last(&run(scene(shape.clone(), coulomb(1e12), history())));
            let right = 2.0 * RATIO * stuck.normal.contact_radius.unwrap() * 0.01;
            // The annulus of depth u/m = 10⁻¹⁴ slips all the same.
            assert!((force(&stuck) / right - 1.0).abs() < 1e-13, "{}", force(&stuck) / right);
            assert!((smooth.normal.force - stuck.normal.force).abs() <= 0.0, "friction changed the normal force");
        }
    }
}

/// Over twelve decades of μ and of the amplitude the loss of a loop is the closed form's cube at small
/// amplitude: W = (3/8)·… found here as W ∝ amplitude³ from one decade to the next.
#[test]
fn small_loops_lose_by_the_cube_of_the_amplitude() {
    for exponent in [-6, -3, 0, 3, 6] {
        let coefficient = 10f64.powi(exponent);
        let reach = coefficient / RATIO;
        let lost = |part: f64| {
            let shaken = scene(ball(), coulomb(coefficient), vec![indent(1.0), shake(part * reach, 3.0)]);
            run(shaken).number("dissipated_per_cycle_j").unwrap()
        };
        for decade in [-12, -9, -6] {
            let small = 10f64.powi(decade);
            // The next term of the series is of the relative order of the amplitude.
            let ratio = lost(2.0 * small) / lost(small) / 8.0;
            assert!((ratio - 1.0).abs() < 4.0 * small + 1e-9, "μ = {coefficient:e}, {small:e}: {ratio}");
        }
    }
}

/// A turning point between two records is not missed: one record per cycle loses what 64 do.
#[test]
fn turning_points_between_records_count() {
    let shaken = |steps: usize| {
        let scene = scene(ball(), coulomb(0.3), vec![indent(1.0), shake(0.2, 3.25)]);
        run(Scene { steps: NonZeroUsize::new(steps), ..scene })
    };
    let (coarse, fine) = (shaken(3), shaken(256));
    for name in ["friction_dissipated_j", "final_tangential_force_n", "dissipated_per_cycle_j"] {
        let [few, many] = [&coarse, &fine].map(|outcome| outcome.number(name).unwrap());
        // Losses of the same slips, added up in other portions.
        assert!((few / many - 1.0).abs() < 1e-12, "{name}: {few} {many}");
    }
}

/// The dashpots of a body pull along the surface against the way it slides under a force that has just been eased, back and as
/// it is shaken: the tangential force over the way, and the normal one over the depth, is what is stored and lost. Bound: what
/// the trapezoidal rule misses where the force along the surface jumps as the way turns, half a record each time.
#[cfg(feature = "text")]
#[test]
fn dashpots_pull_against_the_slide_under_a_force() {
    let shear = "(equilibrium: 5.6e10, terms: [(modulus: 1.8e9, time: 1.8e4)], viscosity: 1.8e11)";
    let body = format!("Viscoelastic(poisson: 0.5, shear: {shear})");
    for way in ["Slide(to: -7e-7, over: 18)", "Shake(amplitude: 8e-7, frequency: 0.02, cycles: 2)"] {
        let text = format!(
            "(shape: Paraboloid(radius: 9e-3), bodies: ({body}, Rigid), friction: Coulomb(coefficient: 0.3), steps: 200, \
             history: [Press(to: 90, over: 56), HoldForce(over: 30), Slide(to: 1.4e-6, over: 56), \
             Press(to: 80, over: 18), {way}])"
        );
        let outcome = run(Scene::from_ron(&text).unwrap());
        let held = outcome.records.iter().filter(|record| record.entry > 1).collect::<Vec<_>>();
        let accounted = |record: &Record| {
            let along = record.tangential.unwrap();
            record.normal.stored.stored() + record.normal.dissipated + along.stored.unwrap() + along.dissipated.unwrap()
        };
        let (mut open, mut work): (f64, f64) = (0.0, 0.0);
        for pair in held.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let [one, two] = [from, to].map(|record| record.tangential.unwrap());
            let down = to.normal.indentation.unwrap() - from.normal.indentation.unwrap();
            let put_in = 0.5 * (one.force + two.force) * (two.slide - one.slide);
            work += put_in.abs();
            open += put_in + 0.5 * (from.normal.force + to.normal.force) * down - accounted(to) + accounted(from);
        }
        assert!(work > 0.0 && open.abs() < 0.02 * work, "{way}: open by {open:e} J of {work:e} J");
    }
}

/// A contact that has parted forgets: pressed again it is as fresh.
#[test]
fn parting_wipes_the_memory() {
    let again = vec![indent(0.5), slide(0.1), slide(-0.3), indent(-0.1), slide(0.2), press(0.4), slide(0.25)];
    let fresh = vec![press(0.4), slide(0.05)];
    let (again, fresh) = (run(scene(ball(), coulomb(0.3), again)), run(scene(ball(), coulomb(0.3), fresh)));
    // The slide 0.25 − 0.2 has lost a rounding.
    assert!((force(&last(&again)) / force(&last(&fresh)) - 1.0).abs() < 1e-14);
    let apart: Vec<&Record> = again.records.iter().filter(|record| record.entry == 4).collect();
    assert!(apart.iter().all(|record| force(record).abs() <= 0.0));
    let retracted = run(scene(
        ball(),
        coulomb(0.3),
        vec![indent(0.5), slide(0.1), Entry::Retract(Retract { speed: Speed::new(0.1).unwrap() })],
    ));
    assert!(force(&last(&retracted)).abs() <= 0.0);
}

/// The force of gross sliding acts against the slide, whichever way, and a contact that stands keeps
/// what its load can hold.
#[test]
fn sliding_turns_and_stands() {
    let law = CoulombOrowan { coefficient: Ratio::new(0.5).unwrap(), shear_limit: Modulus::new(0.1).unwrap() };
    let history = vec![press(1.0), slide(1.0), slide(-1.0), press(0.1), press(2.0)];
    let outcome = run(scene(ball(), Friction::CoulombOrowan(law), history));
    let of = |entry: usize| outcome.records.iter().rfind(|record| record.entry == entry).map(force).unwrap();
    assert!(of(0).abs() <= 0.0 && of(1) > 0.0);
    assert!((of(1) + of(2)).abs() <= 0.0);
    assert!(of(3) > of(2) && of(3) < 0.0 && of(3) >= -0.5 * 0.1 * (1.0 + 1e-12));
    assert!((of(4) - of(3)).abs() <= 0.0, "a standing contact gained tangential force");
}

/// No cap is Coulomb sliding and no slope the uniform stress: F_x = μF and F_x = πa²τ.
#[test]
fn sliding_laws_have_their_limits() {
    for shape in shapes() {
        let orowan = CoulombOrowan { coefficient: Ratio::new(0.5).unwrap(), shear_limit: Modulus::new(1e12).unwrap() };
        let capless = last(&run(scene(shape.clone(), Friction::CoulombOrowan(orowan), vec![press(1.0), slide(1.0)])));
        // The pressure of a cone is infinite at its apex: its integral is known to 10⁻⁹.
        assert!((force(&capless) / 0.5 - 1.0).abs() < 1e-8, "{}", force(&capless));
        let law = PressureLaw { shear: Strength::Constant(Stress::new(0.2).unwrap()), slope: Ratio::new(0.0).unwrap() };
        let uniform = last(&run(scene(shape.clone(), Friction::Pressure(law), vec![press(1.0), slide(1.0)])));
        let area = std::f64::consts::PI * uniform.normal.contact_radius.unwrap().powi(2);
        assert!((force(&uniform) / (0.2 * area) - 1.0).abs() < 1e-12);
    }
}

fn sheared(stress: f64, history: Vec<Entry>) -> Outcome {
    let law = PressureLaw { shear: Strength::Constant(Stress::new(stress).unwrap()), slope: Ratio::new(0.0).unwrap() };
    let adhesion = Adhesion::Jkr(Jkr { work: WorkOfAdhesion::new(0.1).unwrap(), closing: None, edge: None });
    run(Scene { adhesion: Some(adhesion), ..scene(ball(), Friction::Pressure(law), history) })
}

/// An adhesive contact is the same under depth and under force: the one that slides at the depth of the
/// other has its force and area. Without shear it is that of JKR, and let go it is again.
#[test]
fn a_sheared_contact_is_in_equilibrium_under_depth_and_force() {
    for stress in [1e-3, 0.1, 0.2] {
        let pressed = last(&sheared(stress, vec![press(1.0), slide(1.0)]));
        let depth = pressed.normal.indentation.unwrap();
        let held = last(&sheared(stress, vec![indent(depth), slide(1.0)]));
        // The pull-off side of JKR is far: the conditioning of depth and force is of the order of one.
        assert!((held.normal.force - 1.0).abs() < 1e-12, "{stress}: {}", held.normal.force);
        let radii = [pressed, held].map(|record| record.normal.contact_radius.unwrap());
        assert!((radii[0] / radii[1] - 1.0).abs() < 1e-12);
    }
    let rest = last(&sheared(0.1, vec![press(1.0)]));
    let faint = last(&sheared(0.0, vec![press(1.0), slide(1.0)]));
    assert!((faint.normal.contact_radius.unwrap() / rest.normal.contact_radius.unwrap() - 1.0).abs() < 1e-12);
    let released = last(&sheared(0.1, vec![press(1.0), slide(1.0), press(2.0), press(1.0)]));
    assert!((released.normal.contact_radius.unwrap() / rest.normal.contact_radius.unwrap() - 1.0).abs() < 1e-12);
    assert!(force(&released).abs() <= 0.0);
}

/// A body that relaxes by the terms given; E*(0) = 1 and G*/E* as for the rubber above.
fn relaxing(equilibrium: f64, terms: &[(f64, f64)], friction: Friction, history: Vec<Entry>) -> Scene {
    let term = |&(modulus, time): &(f64, f64)| Term {
        modulus: Stress::new(0.25 * modulus).unwrap(),
        time: Duration::new(time).unwrap(),
    };
    let shear = Shear {
        equilibrium: Stress::new(0.25 * equilibrium).unwrap(),
        terms: Terms::List(terms.iter().map(term).collect()),
        viscosity: Viscosity::default(),
        power_law: None,
    };
    let body = Viscoelastic { poisson: Poisson::new(0.5).unwrap(), shear, temperature: None, shift: None };
    Scene { bodies: (Body::Viscoelastic(body), Body::Rigid), ..scene(ball(), friction, history) }
}

/// A Prony term without weight leaves the elastic contact, within the bound of the bed, μE*dΔx.
#[test]
fn a_term_of_no_weight_is_elastic() {
    let history = || vec![indent(0.5), slide(0.1), indent(0.3), slide(-0.05), indent(0.6), slide(0.3), indent(-0.1)];
    let relaxing = run(relaxing(1.0, &[(0.0, 0.3)], coulomb(0.3), history()));
    let elastic = run(scene(ball(), coulomb(0.3), history()));
    let ends = |outcome: &Outcome| -> Vec<Record> {
        (0..7).map(|entry| *outcome.records.iter().rfind(|record| record.entry == entry).unwrap()).collect()
    };
    let width = 0.6f64.sqrt() / 1000.0;
    for (soft, hard) in ends(&relaxing).iter().zip(&ends(&elastic)) {
        let bound = 0.3 * hard.normal.indentation.unwrap().max(0.0) * width;
        assert!((force(soft) - force(hard)).abs() <= bound + 1e-12, "{} {}", force(soft), force(hard));
        // The bound of the force over the whole way, under the largest load.
        let lost = |record: &Record| record.tangential.unwrap().dissipated.unwrap();
        assert!((lost(soft) - lost(hard)).abs() <= 0.3 * 0.6 * width * 0.6, "{} {}", lost(soft), lost(hard));
    }
    assert!(force(&ends(&elastic)[5]) > 0.1, "the history does not load the contact");
}

/// Forces, slides under a force and a shake: each a curve in time of depth or slide.
fn curves() -> Vec<Entry> {
    vec![press(0.4), slide(0.1), press(0.25), slide(-0.05), press(0.45), shake(0.04, 1.5), slide(0.3), press(0.1)]
}

fn ends(outcome: &Outcome, entries: usize) -> Vec<Record> {
    (0..entries).map(|entry| *outcome.records.iter().rfind(|record| record.entry == entry).unwrap()).collect()
}

/// A term without weight leaves the elastic contact under a prescribed force and a shake too. Bound: what is stated, of
/// the largest friction and of what it takes over the largest way.
#[test]
fn a_term_of_no_weight_is_elastic_on_curves() {
    let relaxing = run(relaxing(1.0, &[(0.0, 0.3)], coulomb(0.3), curves()));
    let elastic = run(scene(ball(), coulomb(0.3), curves()));
    let (stated, most) = (relaxing.error_estimate.relative, 0.3 * 0.45);
    assert!(stated < 3e-3, "{stated:e}");
    for (soft, hard) in ends(&relaxing, 8).iter().zip(&ends(&elastic, 8)) {
        assert!((force(soft) - force(hard)).abs() <= stated * most, "{} {}", force(soft), force(hard));
        let lost = |record: &Record| record.tangential.unwrap().dissipated.unwrap();
        assert!((lost(soft) - lost(hard)).abs() <= stated * most * 0.7, "{} {}", lost(soft), lost(hard));
    }
    assert!(force(&ends(&elastic, 8)[6]) > 0.1, "the history does not load the contact");
}

/// An entry cut in two is the same entry. Bound: four of the errors of a chord, 1e-6 of the largest force; a bed of
/// springs that slip in the same order adds only rounding.
#[test]
fn a_cut_changes_nothing_under_a_force() {
    let terms = [(0.5, 0.4), (0.2, 5.0)];
    let part =
        |to: f64, over: f64| Entry::Press(Press { to: Force::new(to).unwrap(), over: Duration::new(over).unwrap() });
    let along = |to: f64, over: f64| {
        Entry::Slide(Slide { to: Displacement::new(to).unwrap(), over: Duration::new(over).unwrap() })
    };
    let whole = vec![part(0.4, 1.0), along(0.1, 1.0), part(0.2, 1.0), along(-0.1, 1.0)];
    let cut = vec![
        part(0.12, 0.3),
        part(0.4, 0.7),
        along(0.06, 0.6),
        along(0.1, 0.4),
        part(0.3, 0.5),
        part(0.2, 0.5),
        along(0.0, 0.5),
        along(-0.1, 0.5),
    ];
    let one = last(&run(relaxing(0.3, &terms, coulomb(0.3), whole)));
    let two = last(&run(relaxing(0.3, &terms, coulomb(0.3), cut)));
    assert!((force(&one) - force(&two)).abs() <= 4e-6 * 0.3 * 0.4, "{} {}", force(&one), force(&two));
    let lost = |record: &Record| record.tangential.unwrap().dissipated.unwrap();
    assert!((lost(&one) - lost(&two)).abs() <= 4e-6 * 0.3 * 0.4 * 0.2, "{} {}", lost(&one), lost(&two));
}

/// A table of the motion is the motion: both follow the force within 1e-6 of the largest.
#[test]
fn a_table_of_forces_is_the_same_motion() {
    let terms = [(0.5, 0.4), (0.2, 5.0)];
    let motion = vec![press(0.4), slide(0.1), press(0.2), slide(-0.1)];
    let rows = ([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 0.4, 0.4, 0.2, 0.2], [0.0, 0.0, 0.1, 0.1, -0.1]);
    let table = InMemory::default().with("h.csv", &[("time_s", &rows.0), ("force_n", &rows.1), ("slide_m", &rows.2)]);
    let entries = last(&run(relaxing(0.3, &terms, coulomb(0.3), motion)));
    let read = relaxing(0.3, &terms, coulomb(0.3), vec![Entry::Table("h.csv".into())]);
    let read = last(&run_with(read, &table));
    assert!((force(&entries) - force(&read)).abs() <= 4e-6 * 0.3 * 0.4, "{} {}", force(&entries), force(&read));
}

/// ∫F dd + ∫F_x du is stored, relaxed or rubbed away. Bound: the trapezoids of a thousand records an entry, (π/1000)²
/// of the work along the surface at the shake and what they miss of F ∝ d^{3/2} at the first touch.
#[test]
fn the_ledger_of_friction_closes_under_a_force() {
    let history = vec![press(0.4), slide(0.1), press(0.2), shake(0.1, 1.0), press(0.3)];
    let scene =
        Scene { steps: NonZeroUsize::new(1000), ..relaxing(0.3, &[(0.5, 0.4), (0.2, 5.0)], coulomb(0.3), history) };
    let outcome = run(scene);
    let pairs = outcome.records.iter().zip(&outcome.records[1..]);
    let work: f64 = pairs
        .map(|(one, two)| {
            let (down, along) = (|r: &Record| r.normal.indentation.unwrap(), |r: &Record| r.tangential.unwrap().slide);
            let normal = 0.5 * (one.normal.force + two.normal.force) * (down(two) - down(one));
            normal + 0.5 * (force(one) + force(two)) * (along(two) - along(one))
        })
        .sum();
    let end = last(&outcome);
    let (normal, along) = (end.normal, end.tangential.unwrap());
    let accounted = normal.stored.stored() + normal.dissipated + along.stored.unwrap() + along.dissipated.unwrap();
    assert!((work / accounted - 1.0).abs() < 3e-5, "{work:e} {accounted:e}");
}

/// In gross sliding F_x = μF(t) while F relaxes; the normal contact is another solver than the bed.
#[test]
fn gross_sliding_of_a_relaxing_body_follows_its_force() {
    let history = vec![indent(0.5), slide(1.0), slide(2.0), slide(3.0), indent(0.4), slide(2.0)];
    let outcome = run(relaxing(0.2, &[(0.8, 0.3)], coulomb(0.3), history));
    let sliding = outcome.records.iter().filter(|record| [2, 3].contains(&record.entry));
    let mut compared = 0;
    for record in sliding {
        let bound = 0.3 * 0.5 * 0.5f64.sqrt() / 1000.0;
        assert!((force(record) - 0.3 * record.normal.force).abs() <= bound, "{}", force(record));
        assert!(record.tangential.unwrap().stick_radius <= 0.0);
        compared += 1;
    }
    assert!(compared >= 10);
    assert!(force(&last(&outcome)) < 0.0, "sliding back pulls forwards");
}

/// Steel on rubber breaks elastic similarity: the scene says by how much.
#[test]
fn a_mismatch_of_the_bodies_is_told() {
    let body = |young: f64, poisson: f64| {
        let (young, poisson) = (Modulus::new(young).unwrap(), Poisson::new(poisson).unwrap());
        Body::Elastic(Elastic { young, poisson, yield_stress: None })
    };
    let told = |bodies: (Body, Body)| {
        let scene = Scene { bodies, ..scene(ball(), coulomb(0.3), vec![indent(0.01), slide(1e-3)]) };
        let plan = scene.resolve(&InMemory::default()).unwrap();
        let outcome = run::run(&plan, Wanted::NOTHING).unwrap();
        outcome.warnings.into_iter().find(|warning| warning.contains("elastic similarity"))
    };
    // Dundurs' β of ν = 0.1 on a rigid body is (1 − 2ν)/(2(1 − ν)) = 0.444.
    assert!(told((body(1.0, 0.1), Body::Rigid)).is_some_and(|warning| warning.contains("β = 0.444")));
    assert!(told((body(1.0, 0.3), body(1.0, 0.3))).is_none());
    assert!(told((body(1.0, 0.5), Body::Rigid)).is_none());
}
