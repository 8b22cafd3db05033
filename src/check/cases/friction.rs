//! Tangential contacts with closed answers, run as whole scenes on rubber: E* = 1 and G* = 2/3, elastically similar.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::closed_forms;
use crate::check::sketch::{Sketch, ball, beside, elastic, ends, result, si};
use crate::check::tangential::{CattaneoMindlin, SavkoorBriggs, orowan_on_hertz};
use crate::contact::state::Tangential;
use crate::friction::{CoulombOrowan, Friction, PressureLaw, Strength};
use crate::run::record::{Outcome, Record};
use crate::shape::{Cone, Profile, RoundedPunch, Shape};
use std::f64::consts::PI;

const ROUNDING: &str = "closed forms through a whole scene, a few dozen roundings";

pub(super) const CASES: &[Case] = &[
    Case::new("friction/Cattaneo–Mindlin lens", Proof::Rounding, 1e-13, ROUNDING)
        .weak("first loading at constant depth")
        .by(lens_first_loading),
    Case::new(
        "friction/stick and slip under a lens",
        Proof::Rounding,
        1e-13,
        "a difference of two bowls, relative to the largest stress",
    )
    .weak("first loading at constant depth")
    .by(lens_stress),
    Case::new(
        "friction/cone",
        Proof::Rounding,
        1e-12,
        "the pressure of a cone is an area cosine: cancellation near the edge of stick",
    )
    .weak("first loading at constant depth")
    .by(cone),
    Case::new(
        "friction/punch with a rounded edge",
        Proof::Rounding,
        1e-12,
        "the closed form in the angle loses φ⁻² digits at φ = 0.3, and differences of it one more",
    )
    .weak("no closed form of τ(r): its integral over the contact is F_x")
    .by(rounded_punch),
    Case::new(
        "friction/Mindlin–Deresiewicz loop",
        Proof::Rounding,
        1e-12,
        "the loss of a cycle is a difference of two sums over ten cycles of 64 steps, each rounded",
    )
    .weak("paraboloid at constant depth, amplitudes from 10⁻⁶ of gross slip to twice it")
    .by(loops),
    Case::new("friction/load taken off a sheared lens", Proof::Rounding, 1e-12, ROUNDING)
        .weak("after one slide: F_x = μ[F(d) − F(d − u/m)] at every depth")
        .by(unloaded),
    Case::new(
        "friction/slide and force grow together",
        Proof::Bound,
        1e-6,
        "the depth under a force is a curve, followed to the accuracy of the scene",
    )
    .weak("stick only: F_x = ∫2G*a du with a = (3RF/4E*)^{1/3}")
    .by(growing_together),
    Case::new(
        "friction/bed of springs",
        Proof::Bound,
        1.0,
        "|F_bed − F| ≤ μE*dΔx, half a cell of the variation; printed as the part of the bound used",
    )
    .weak("one history of two slides")
    .by(bed),
    Case::new(
        "friction/area drop of a sheared lens",
        Proof::Rounding,
        1e-11,
        "eqs. 10, 13 and 14 of Persson et al. 2008 at the force the scene gives; a root of a root",
    )
    .weak("uniform stress, a paraboloid")
    .by(area_drop),
    Case::new("friction/peeling force of a lens", Proof::Rounding, 1e-12, "eq. 11 of Persson et al. 2008")
        .weak("a paraboloid")
        .by(peeling_force),
    Case::new(
        "friction/lens that sticks",
        Proof::Rounding,
        1e-11,
        "a³ of Savkoor & Briggs at the forces the scene gives, with α = 2(1−ν)/(2−ν); a root of a root",
    )
    .weak("a paraboloid, below the greatest tangential force")
    .by(stuck_lens),
    Case::new(
        "friction/drop to Hertz",
        Proof::Bound,
        5e-3,
        "A_H/A_JKR ≈ 0.87 in figure 10 of Persson et al. 2008 has two digits",
    )
    .weak("a rounded number")
    .by(drop_to_hertz),
    Case::new(
        "friction/Coulomb–Orowan slider",
        Proof::Rounding,
        1e-12,
        "a quadrature with its panels cut at the corners of the law",
    )
    .weak("paraboloid: πa²τ(1 − s²/3)")
    .by(orowan),
];

const TANGENTIAL: f64 = 2.0 / 3.0;
const COEFFICIENT: f64 = 0.3;
/// m = μE*/G*.
const REACH: f64 = COEFFICIENT / TANGENTIAL;

/// Under Coulomb's law with μ = 0.3, four records per entry.
fn rubbing(shape: Attempt<Shape>) -> Sketch {
    Sketch::of(shape).coulomb(COEFFICIENT).steps(4)
}

/// A lens pressed by its radius of curvature.
fn lens() -> Sketch {
    rubbing(ball(1.0)).indent(1.0, 1.0)
}

fn tangential(record: &Record) -> Attempt<Tangential> {
    record.tangential.ok_or_else(|| "the scene has no friction".into())
}

const MINDLIN: CattaneoMindlin =
    CattaneoMindlin { force: 4.0 / 3.0, contact_radius: 1.0, tangential_modulus: TANGENTIAL, coefficient: COEFFICIENT };

/// To parts of the reach, up to gross slip.
fn lens_first_loading() -> Attempt<Pairs> {
    let parts = [1e-12, 1e-6, 0.01, 0.3, 0.75, 0.99, 1.5];
    let outcome = parts.iter().fold(lens(), |lens, part| lens.slide(part * REACH)).fields()?;
    let mut pairs = Vec::new();
    for (record, part) in ends(&outcome).skip(1).zip(parts) {
        let state = tangential(record)?;
        pairs.push((state.force, MINDLIN.tangential_force(part * REACH)));
        // c near the axis comes from the small depth that is left: (c/a)² is exact to rounding.
        pairs.push((1.0 + state.stick_radius.powi(2), 1.0 + MINDLIN.stick_radius(part * REACH).powi(2)));
        pairs.push((state.stiffness, 2.0 * TANGENTIAL * state.stick_radius));
    }
    Ok(pairs)
}

/// Deviations of the last field's τ(r) from `right`, relative to the largest stress.
fn stress_errors(outcome: &Outcome, right: impl Fn(f64) -> f64) -> Attempt<Pairs> {
    let field = outcome.fields.last().ok_or("the scene has no field")?;
    let inside = field.rows.iter().filter(|row| row.radius < field.contact_radius * (1.0 - 1e-9));
    let known = inside.filter_map(|row| Some((row.shear?, right(row.radius))));
    let pairs: Pairs = known.filter(|pair| pair.1.is_finite()).collect();
    let most = pairs.iter().map(|pair| pair.1.abs()).fold(0.0, f64::max);
    if pairs.len() <= 63 {
        return Err(format!("only {} radii in the contact", pairs.len()).into());
    }
    Ok(pairs.iter().map(|(value, right)| ((value - right) / most, 0.0)).collect())
}

fn lens_stress() -> Attempt<Pairs> {
    let mut errors = Vec::new();
    // No border of stick at a radius of the field: there the root turns a rounding into 10⁻⁸.
    for part in [0.3, 0.77, 1.5] {
        let outcome = lens().slide(part * REACH).fields()?;
        let c = MINDLIN.stick_radius(part * REACH);
        errors.extend(stress_errors(&outcome, |r| MINDLIN.shear_stress(r, c))?);
    }
    Ok(errors)
}

/// F_x = μ[F(d) − F(g(c))] and u_x = m(d − g(c)); τ = μ[p(r; a) − p(r; c)].
fn cone() -> Attempt<Pairs> {
    let slope = 0.2;
    let shape = Cone { slope: si(slope)? };
    let whole = closed_forms::cone(slope, 1.0);
    let stuck = closed_forms::cone(slope, shape.reduced(0.4 * whole.radius));
    let pressed = rubbing(Ok(Shape::Cone(shape))).indent(1.0, 1.0);
    let outcome = pressed.slide(REACH * (1.0 - stuck.indentation)).fields()?;
    let pressure = |a: f64, r: f64| if r < a { closed_forms::cone_pressure(slope, a, r) } else { 0.0 };
    let stress = stress_errors(&outcome, |r| COEFFICIENT * (pressure(whole.radius, r) - pressure(stuck.radius, r)))?;
    let force = COEFFICIENT * (whole.force - stuck.force);
    let named = beside(&outcome, &[("final_tangential_force_n", force), ("final_stick_radius_m", stuck.radius)])?;
    Ok([named, stress].concat())
}

fn rounded_punch() -> Attempt<Pairs> {
    let shape = RoundedPunch { flat_radius: si(0.3)?, edge_radius: si(1.7)? };
    let at = |angle: f64| closed_forms::rounded_punch(0.3, 1.7, angle);
    let whole = at(1.1);
    let mut pairs = Vec::new();
    for stuck in [0.3, 0.7, 1.0].map(at) {
        let pressed = rubbing(Ok(Shape::RoundedPunch(shape.clone()))).indent(whole.indentation, 1.0);
        let outcome = pressed.slide(REACH * (whole.indentation - stuck.indentation)).fields()?;
        let force = COEFFICIENT * (whole.force - stuck.force);
        let right = [("final_tangential_force_n", force), ("final_stick_radius_m", stuck.radius)];
        pairs.extend(beside(&outcome, &right)?);
    }
    Ok(pairs)
}

fn loops() -> Attempt<Pairs> {
    let lost = |part: f64| {
        let outcome = lens().shake(part * REACH, 1.0, 10.0).run()?;
        Ok((result(&outcome, "dissipated_per_cycle_j")?, MINDLIN.loss_per_cycle(part * REACH)))
    };
    [1e-6, 1e-3, 0.1, 0.5, 0.9, 1.0, 2.0].into_iter().map(lost).collect()
}

/// What sticks after the slide u keeps v = u, and what has slipped follows its limit m(d − g) down.
fn unloaded() -> Attempt<Pairs> {
    let slid = 0.4;
    let load = |depth: f64| if depth > 0.0 { closed_forms::hertz(1.0, depth).force } else { 0.0 };
    let outcome = lens().slide(slid * REACH).indent(0.1, 1.0).steps(9).run()?;
    let pair = |record: &Record| {
        let depth = record.normal.indentation.ok_or("the bodies have parted")?;
        Ok((tangential(record)?.force, COEFFICIENT * (load(depth) - load(depth - slid))))
    };
    outcome.records.iter().filter(|record| record.entry == 2).map(pair).collect()
}

/// A table in which the force rises to 1 while the body slides too little to slip: F_x = ¾·2G*a u.
fn growing_together() -> Attempt<Pairs> {
    let slid = 1e-3;
    let columns: [(&str, &[f64]); 3] = [("time_s", &[0.0, 1.0]), ("force_n", &[0.0, 1.0]), ("slide_m", &[0.0, slid])];
    let outcome = rubbing(ball(1.0)).table(&columns).run()?;
    beside(&outcome, &[("final_tangential_force_n", 0.75 * 2.0 * TANGENTIAL * 0.75f64.cbrt() * slid)])
}

fn bed() -> Attempt<Pairs> {
    let run = |springs| lens().slide(0.8 * REACH).slide(-0.3 * REACH).springs(springs).run();
    let springs = 500u16;
    let (exact, bed) = (run(None)?, run(Some(usize::from(springs)))?);
    let width = (1.0 + 1.0 / 16.0) / f64::from(springs);
    let used = |(exact, bed): (&Record, &Record)| {
        let allowed = COEFFICIENT * exact.normal.indentation.ok_or("the bodies have parted")? * width;
        Ok(((tangential(exact)?.force - tangential(bed)?.force) / allowed.max(f64::MIN_POSITIVE), 0.0))
    };
    exact.records.iter().zip(&bed.records).skip(1).map(used).collect()
}

/// The PDMS lens of Persson et al. 2008, section 4; α of a uniform stress at ν = 1/2, written out, is π²/16.
const PDMS: SavkoorBriggs = SavkoorBriggs { radius: 2.5e-3, modulus: 6.4e6, work: 0.042, ratio: PI * PI / 16.0 };
const LOAD: f64 = 0.048;

fn sheared_lens(stress: f64) -> Attempt<Outcome> {
    let law = || Ok(Friction::Pressure(PressureLaw { shear: Strength::Constant(si(stress)?), slope: si(0.0)? }));
    let lens = Sketch::of(ball(PDMS.radius)).body(elastic(4.8e6, 0.5)).jkr(PDMS.work, None).friction(law());
    lens.press(LOAD, 1.0).slide(1e-6).steps(4).run()
}

fn area_drop() -> Attempt<Pairs> {
    let hertz = 0.75 * PDMS.radius * LOAD / PDMS.modulus;
    let cube = |shear: f64| SavkoorBriggs::cube_over_hertz(PDMS.ratio, PDMS.adhesion_force() / LOAD, shear / LOAD);
    let mut pairs = Vec::new();
    for stress in [0.0, 1e3, 1e4, 3e4, 4e4] {
        let outcome = sheared_lens(stress)?;
        let a = result(&outcome, "final_contact_radius_m")?;
        let shear = result(&outcome, "final_tangential_force_n")?;
        pairs.push((a.powi(3) / hertz, cube(shear)));
        let right = [
            ("final_contact_radius_m", PDMS.contact_radius(LOAD, shear)),
            ("area_ratio", (cube(shear) / cube(0.0)).powf(2.0 / 3.0)),
            ("final_tangential_force_n", PI * a * a * stress),
            ("final_force_n", LOAD),
        ];
        pairs.extend(beside(&outcome, &right)?);
    }
    Ok(pairs)
}

/// The same lens, held fast: α = 2/3 at ν = 1/2.
fn stuck_lens() -> Attempt<Pairs> {
    let right = SavkoorBriggs { ratio: 2.0 / 3.0, ..PDMS };
    let lens = || Sketch::of(ball(PDMS.radius)).body(elastic(4.8e6, 0.5)).jkr(PDMS.work, None);
    let slid = |slide: f64| lens().friction(Ok(Friction::Stuck)).press(LOAD, 1.0).slide(slide).steps(4).run();
    let most = 0.5 * result(&slid(1e-9)?, "peel_slide_m")?;
    let mut pairs = Vec::new();
    for part in [0.1, 0.5, 1.0] {
        let outcome = slid(part * most)?;
        let (a, shear) = (result(&outcome, "final_contact_radius_m")?, result(&outcome, "final_tangential_force_n")?);
        pairs.push((a, right.contact_radius(LOAD, shear)));
        pairs.push((shear, 4.0 / 3.0 * PDMS.modulus * a * part * most));
    }
    Ok(pairs)
}

fn peeling_force() -> Attempt<Pairs> {
    beside(&sheared_lens(3e4)?, &[("critical_tangential_force_n", PDMS.critical_force(LOAD))])
}

fn drop_to_hertz() -> Attempt<Pairs> {
    beside(&sheared_lens(1e5)?, &[("area_ratio", 0.87), ("hertz_area_ratio", 0.87)])
}

fn orowan() -> Attempt<Pairs> {
    let mut pairs = Vec::new();
    for cap in [1e-3, 0.03, 0.2, 10.0] {
        let law = CoulombOrowan { coefficient: si(COEFFICIENT)?, shear_limit: si(cap)? };
        let outcome = lens().friction(Ok(Friction::CoulombOrowan(law))).slide(-1.0).run()?;
        let right = orowan_on_hertz(4.0 / 3.0, 1.0, (COEFFICIENT, cap));
        let named = [
            ("final_tangential_force_n", -right),
            ("friction_dissipated_j", right),
            ("friction_coefficient", 0.75 * right),
        ];
        pairs.extend(beside(&outcome, &named)?);
    }
    Ok(pairs)
}
