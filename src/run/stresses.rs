//! Stresses below the surface of a contact at its greatest force: the map, the hardest place, first yield.

use super::named::Named;
use super::table::{Column, Table};
use super::unit::Unit;
use crate::contact::loaded::Loaded;
use crate::contact::punch::Stresses;
use crate::contact::state::{Normal, Tangential};
use crate::contact::subsurface::{FirstYield, Place, StressField};
use crate::material::Body;
use crate::scene::law::{Bodies, ElasticAdhesion};
use crate::scene::plan::{Plan, Shared};
use crate::shape::Shape;
use rayon::prelude::*;

/// How far down and out the map goes, in radii of the contact.
const DOWN: f64 = 1.5;
const OUT: f64 = 2.0;
/// How far to either side it goes of a contact that slides.
const ASIDE: f64 = 1.5;
/// Points of the map per radius of the contact.
const PER_RADIUS: f64 = 40.0;
/// Forces that agree to this part are one: of states under it the one that rubs hardest counts.
pub(super) const SAME: f64 = 1e-9;

/// What a contact carries at its greatest force.
#[derive(Debug, Clone)]
pub(super) struct Carried {
    pub loaded: Loaded,
    /// Tangential over normal force where nothing sticks, else zero.
    slip: f64,
    /// Normal and tangential force [N].
    force: (f64, f64),
}

impl Carried {
    /// The load of the contact in a state.
    pub fn new(loaded: Loaded, normal: &Normal, tangential: Option<Tangential>) -> Self {
        let rubs = tangential.map_or(0.0, |state| state.force);
        let slips = tangential.is_some_and(|state| state.stick_radius <= 0.0) && normal.force > 0.0;
        let slip = if slips { rubs / normal.force } else { 0.0 };
        Self { loaded, slip, force: (normal.force, rubs) }
    }

    /// The load of an impact at its greatest depth, without friction.
    pub fn without_friction(loaded: Loaded) -> Self {
        let force = (loaded.force(), 0.0);
        Self { loaded, slip: 0.0, force }
    }

    /// Whether a state is harder: of the greater force, or of the same and the greater rub.
    pub fn is_below(&self, normal: &Normal, tangential: Option<Tangential>) -> bool {
        let same = SAME * self.force.0.abs();
        let rubs = tangential.map_or(0.0, |state| state.force.abs());
        normal.force > self.force.0 + same || normal.force >= self.force.0 - same && rubs > self.force.1.abs()
    }

    /// Shear traction over pressure of a contact that slides as a whole under Coulomb's law.
    fn drag(&self, plan: &Plan) -> f64 {
        let coulomb = plan.round().and_then(|round| round.friction.as_ref()?.coulomb());
        coulomb.map_or(0.0, |_| self.slip)
    }
}

/// The bodies that can deform, with their names; two equal ones bear the same and are one.
fn bodies(shared: &Shared) -> Vec<(&'static str, &Body)> {
    let (one, other) = &shared.scene.bodies;
    let both = if one == other { vec![("", one)] } else { vec![("body 1: ", one), ("body 2: ", other)] };
    both.into_iter().filter(|(_, body)| body.poisson().is_some()).collect()
}

/// The fields of the bodies that can deform.
fn fields(plan: &Plan, carried: &Carried) -> impl Iterator<Item = StressField> {
    let drag = carried.drag(plan);
    bodies(plan).into_iter().filter_map(move |(_, body)| Some(carried.loaded.field(body.poisson()?).dragged(drag)))
}

/// The hardest place of all, where the stress has a bound.
fn hardest(plan: &Plan, carried: &Carried) -> Option<Place> {
    let places: Option<Vec<Place>> = fields(plan, carried).map(|field| field.hardest()).collect();
    places?.into_iter().max_by(|x, y| x.von_mises.total_cmp(&y.von_mises))
}

/// Whether the bodies are round, so that the field is theirs: below an ellipse lies another one.
fn is_round(plan: &Plan) -> bool {
    !matches!(plan.scene.shape, Shape::Ellipsoid(_))
}

/// Whether the stresses of a plan cost next to nothing to keep: the direct path knows its load at any time.
pub(super) fn are_at_hand(plan: &Plan) -> bool {
    let elastic = elastic(plan).is_some() && plan.scene.springs.is_none();
    elastic && plan.profile().is_some_and(|profile| !profile.is_mapped()) && is_round(plan)
}

/// The attraction of elastic bodies under a round indenter.
fn elastic(plan: &Plan) -> Option<ElasticAdhesion> {
    let bodies = match plan {
        Plan::Round(plan) => plan.contact.bodies(),
        Plan::Impact(plan) => plan.law.bodies(),
        Plan::Plane(_) | Plan::Rough(_) | Plan::RoughImpact(_) | Plan::Pad(_) | Plan::HalfSpace(_) => return None,
    };
    match bodies {
        Bodies::Elastic(adhesion) => Some(adhesion),
        Bodies::Viscoelastic(..) | Bodies::Plastic(_) => None,
    }
}

/// The hardest place, and the load under which a body yields first.
pub(super) fn results(plan: &Plan, carried: &Carried) -> Vec<Named> {
    if !is_round(plan) {
        return Vec::new();
    }
    let place = |place: Place| {
        [
            Named::number("von_mises_largest", Unit::PASCAL, place.von_mises),
            Named::number("von_mises_largest_radius", Unit::METRE, place.radius),
            Named::number("von_mises_largest_depth", Unit::METRE, place.depth),
        ]
    };
    let yielded = |first: FirstYield| {
        [
            Named::number("first_yield_force", Unit::NEWTON, first.force),
            Named::number("first_yield_indentation", Unit::METRE, first.indentation),
            Named::number("first_yield_depth", Unit::METRE, first.place.depth),
        ]
    };
    let hardest = hardest(plan, carried).into_iter().flat_map(place);
    hardest.chain(first_yield(plan, carried).into_iter().flat_map(yielded)).collect()
}

/// First yield of the body that yields first, in an elastic contact without adhesion.
fn first_yield(plan: &Plan, carried: &Carried) -> Option<FirstYield> {
    elastic(plan).filter(|adhesion| *adhesion == ElasticAdhesion::None)?;
    let ground = match plan {
        Plan::Round(plan) => plan.ground(),
        Plan::Impact(plan) => plan.ground(),
        Plan::Plane(_) | Plan::Rough(_) | Plan::RoughImpact(_) | Plan::Pad(_) | Plan::HalfSpace(_) => return None,
    };
    let drag = carried.drag(plan);
    let first = |body: &Body| FirstYield::of(&ground, body.poisson()?, body.yield_stress()?, drag);
    let all = bodies(plan).into_iter().filter_map(|(_, body)| first(body));
    all.min_by(|x, y| x.force.total_cmp(&y.force))
}

/// Where the stress passes first yield.
pub(super) fn warnings(plan: &Plan, carried: &Carried) -> Vec<String> {
    let told = |(name, body): (&str, &Body)| Some(format!("{name}{}", yielding(plan, carried, body)?));
    bodies(plan).into_iter().filter_map(told).collect()
}

fn yielding(plan: &Plan, carried: &Carried, body: &Body) -> Option<String> {
    let (poisson, limit) = (body.poisson()?, body.yield_stress()?);
    let loaded = &carried.loaded;
    let (a, mean) = (loaded.contact_radius(), loaded.mean_pressure());
    if a > 0.0 && loaded.profile().pressure_integral(0.0, a).is_infinite() {
        return Some(format!(
            "the tip is a point: the elastic stress below it has no bound, so the body yields there at any load, above {limit:.3e} Pa; mean pressure {mean:.3e} Pa"
        ));
    }
    let field = loaded.field(poisson).dragged(carried.drag(plan));
    // What pulls at an edge is a crack of the interface; below it the axis is judged.
    let on_axis = || {
        let row = loaded.hardest(poisson).filter(|_| loaded.edge_load() < 0.0)?;
        Some(Place { radius: 0.0, depth: row.depth, von_mises: 2.0 * row.shear })
    };
    let Some(worst) = field.hardest().or_else(on_axis) else {
        return (a > 0.0).then(|| {
            format!(
                "an edge is sharp: the elastic stress there has no bound, so the body yields there at any load, above {limit:.3e} Pa; mean pressure {mean:.3e} Pa"
            )
        });
    };
    (a > 0.0 && worst.von_mises > limit).then(|| {
        format!(
            "the stress passes first yield: von Mises {:.3e} Pa at the depth {:.2} a, {:.2} a from the axis, yield stress {limit:.3e} Pa, mean pressure {mean:.3e} Pa",
            worst.von_mises,
            worst.depth / a,
            worst.radius.abs() / a,
        )
    })
}

/// What the map leaves out of the friction of a scene.
pub(super) fn remark(plan: &Plan, carried: &Carried) -> Option<String> {
    let rubs = carried.force.1.abs() > 0.0 && carried.drag(plan).abs() <= 0.0;
    rubs.then(|| {
        "the stresses below the surface are those of the pressure alone: a shear traction is added where all of the contact slips under Coulomb friction".to_owned()
    })
}

/// A row of the map: the place, and the stresses there if they are finite.
type Row = ((f64, f64), Option<Stresses>);

const ROUND: [Column<Row>; 7] = [
    Column::new("radius", Unit::METRE, "radius r", |row| Some(row.0.0)),
    Column::new("depth", Unit::METRE, "depth z", |row| Some(row.0.1)),
    Column::new("sigma_rr", Unit::PASCAL, "radial σ_rr", |row| Some(row.1?.radial)),
    Column::new("sigma_tt", Unit::PASCAL, "hoop σ_θθ", |row| Some(row.1?.hoop)),
    Column::new("sigma_zz", Unit::PASCAL, "axial σ_zz", |row| Some(row.1?.axial)),
    Column::new("tau_rz", Unit::PASCAL, "shear τ_rz", |row| Some(row.1?.shear)),
    VON_MISES,
];
/// Along the sliding, through the axis.
const SLIDING: [Column<Row>; 7] = [
    Column { quantity: "place", label: "place x along the sliding", ..ROUND[0] },
    ROUND[1],
    Column { quantity: "sigma_xx", label: "along σ_xx", ..ROUND[2] },
    Column { quantity: "sigma_yy", label: "across σ_yy", ..ROUND[3] },
    ROUND[4],
    Column { quantity: "tau_xz", label: "shear τ_xz", ..ROUND[5] },
    VON_MISES,
];
const VON_MISES: Column<Row> =
    Column::new("von_mises", Unit::PASCAL, "von Mises stress", |row| Some(row.1?.von_mises()));

/// The map of stresses in the first body that can deform, depth by depth.
///
/// Under a contact that slides as a whole it is the plane y = 0 along the sliding.
#[expect(clippy::cast_possible_truncation, reason = "few points")]
pub(super) fn table(plan: &Plan, carried: &Carried) -> Option<Table> {
    let field = fields(plan, carried).next()?;
    let a = carried.loaded.contact_radius();
    let unit = if a > 0.0 { a } else { field.scale() };
    let count = |radii: f64| (radii * PER_RADIUS).round() as i32;
    let across = if field.slides() { -count(ASIDE)..=count(ASIDE) } else { 0..=count(OUT) };
    let place = |k: i32| unit * f64::from(k) / PER_RADIUS;
    let places = (0..=count(DOWN)).flat_map(|row| across.clone().map(move |column| (place(column), place(row))));
    let places: Vec<(f64, f64)> = places.collect();
    let bounded = |(r, z): (f64, f64)| z > 0.0 || carried.loaded.pressure(r.abs()).is_finite();
    let row = |(r, z): (f64, f64)| ((r, z), bounded((r, z)).then(|| field.at(r, z)));
    let rows: Vec<Row> = places.into_par_iter().map(row).collect();
    Some(Table::new("stress").with(if field.slides() { &SLIDING } else { &ROUND }, rows.iter()))
}

/// The radius [m] of the contact of the map, whose unit it is.
pub(super) fn unit(carried: &Carried) -> Named {
    Named::number("stress_contact_radius", Unit::METRE, carried.loaded.contact_radius())
}
