//! Named results of a run.

use super::compose;
use super::curves::sliding;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::state::{Normal, Tangential};
use crate::friction::peeling::{Prescribed, ShearedAdhesion, TangentialLoad};
use crate::run::named::Named;
use crate::run::record::{Field, Record};
use crate::run::unit::Unit;
use crate::scene::law::{ContactLaw, FrictionLaw};
use crate::scene::plan::{RoundPlan, Shared};

/// The results the scene has, in a fixed order; `contact` is who computes a round contact.
#[must_use]
pub fn named(contact: Option<&ContactLaw>, records: &[Record], fields: &Pressures<'_>) -> Vec<Named> {
    let mut results = largest(contact, records, fields);
    if let (Some(first), Some(last)) = (records.first(), records.last()) {
        results.extend(last_state(contact, first, last));
    }
    results
}

/// What is known of the pressures of a scene.
#[derive(Debug, Clone, Copy)]
pub struct Pressures<'r> {
    /// Over the radius, at the ends of the entries and at the largest depth.
    pub fields: &'r [Field],
    /// The largest [Pa] at the greatest force between them, where it was looked for.
    pub at_greatest_force: Option<f64>,
}

/// The largest of everything.
fn largest(contact: Option<&ContactLaw>, records: &[Record], pressures: &Pressures<'_>) -> Vec<Named> {
    let forces = || records.iter().map(|record| record.normal.force);
    let most = |of: fn(&Record) -> Option<f64>| records.iter().filter_map(of).reduce(f64::max);
    let intensity = pressures.fields.iter().filter_map(|field| pressures.intensity(field));
    let intensity = intensity.max_by(|x, y| x.abs().total_cmp(&y.abs()));
    let adheres = contact.is_some_and(|contact| contact.bodies().adheres());
    let found = [
        ("largest_force", Unit::NEWTON, forces().reduce(f64::max)),
        ("largest_indentation", Unit::METRE, most(|record| record.normal.indentation)),
        ("largest_contact_radius", Unit::METRE, most(|record| record.normal.contact_radius)),
        ("peak_pressure", Unit::PASCAL, pressures.peak()),
        ("largest_stress_intensity", Unit::PASCAL_ROOT_METRE, intensity),
        ("jump_in_force", Unit::NEWTON, jump_in(records).filter(|_| adheres)),
        ("pull_off_force", Unit::NEWTON, pull_off(records).filter(|_| adheres)),
    ];
    known(&found)
}

/// Force [N] with which the bodies, apart until then, jump into contact, if they pull each other.
fn jump_in(records: &[Record]) -> Option<f64> {
    let apart = |record: &Record| record.normal.contact_radius.is_none_or(|a| a <= 0.0);
    let jump = records.windows(2).find(|pair| apart(&pair[0]) && !apart(&pair[1]))?;
    let same = jump[1].normal.indentation == jump[0].normal.indentation;
    Some(jump[1].normal.force).filter(|force| same && *force < 0.0)
}

/// Relative change of a force below which it eases by rounding: that of a liquid drawn out at a speed stays as it is.
const ROUNDED: f64 = 1e-12;

/// The least force [N] on the way out, if it is a pull and has been passed: the bodies have parted, or are drawn
/// further apart under a weaker one.
pub(super) fn pull_off(records: &[Record]) -> Option<f64> {
    let depth = |record: &Record| record.normal.indentation.unwrap_or(f64::NEG_INFINITY);
    let radius = |record: &Record| record.normal.contact_radius.unwrap_or(0.0);
    let passed = |pair: &&[Record]| {
        let out = depth(&pair[1]) < depth(&pair[0]) || radius(&pair[1]) < radius(&pair[0]);
        let [force, next] = [pair[0].normal.force, pair[1].normal.force];
        out && depth(&pair[1]) <= depth(&pair[0]) && next - force > ROUNDED * force.abs()
    };
    let least = records.windows(2).filter(passed).map(|pair| pair[0].normal.force).reduce(f64::min);
    least.filter(|least| *least < 0.0)
}

/// Work done so far, and the last state.
fn last_state(contact: Option<&ContactLaw>, first: &Record, last: &Record) -> Vec<Named> {
    let normal = &last.normal;
    let (stored, initial) = (normal.stored.stored(), first.normal.stored.stored());
    let elastic = contact.is_some_and(|contact| contact.bodies().adheres() && contact.bodies().relaxation().is_none());
    let found = [
        ("work", Unit::JOULE, Some(stored - initial + normal.dissipated)),
        ("dissipated", Unit::JOULE, Some(normal.dissipated)),
        ("final_time", Unit::SECOND, Some(last.time)),
        ("final_indentation", Unit::METRE, normal.indentation),
        ("final_force", Unit::NEWTON, Some(normal.force)),
        ("final_contact_radius", Unit::METRE, normal.contact_radius),
        ("final_stored_elastic", Unit::JOULE, Some(normal.stored.elastic)),
        ("final_stored_surface", Unit::JOULE, elastic.then_some(normal.stored.surface)),
    ];
    known(&found)
}

/// Those numbers that exist.
fn known(found: &[(&'static str, Unit, Option<f64>)]) -> Vec<Named> {
    let named = |&(quantity, unit, number): &(_, _, Option<f64>)| Some(Named::number(quantity, unit, number?));
    found.iter().filter_map(named).collect()
}

/// What friction adds.
#[must_use]
pub fn of_friction(plan: &RoundPlan, records: &[Record]) -> Vec<Named> {
    let gross = plan.friction.as_ref().and_then(FrictionLaw::interface).is_some();
    let mut results = of_sliding(plan, records, gross);
    results.extend(peeled(plan, records));
    results
}

/// What friction adds to a contact, whoever computes it; `gross` if it slides as a whole.
#[must_use]
pub fn of_sliding(shared: &Shared, records: &[Record], gross: bool) -> Vec<Named> {
    let Some((state, last)) = records.last().and_then(|record| Some((record, record.tangential?))) else {
        return Vec::new();
    };
    let force = records.iter().filter_map(|record| Some(record.tangential?.force.abs()));
    // Of a contact that is no disc the sticking part is an area.
    let radius = (state.pixels.is_none() || state.normal.contact_radius.is_some()).then_some(last.stick_radius);
    let found = [
        ("largest_tangential_force", Unit::NEWTON, Some(force.fold(0.0, f64::max))),
        ("final_slide", Unit::METRE, Some(last.slide)),
        ("final_tangential_force", Unit::NEWTON, Some(last.force)),
        ("final_stick_radius", Unit::METRE, radius),
        ("final_stick_area", Unit::SQUARE_METRE, state.stick_area()),
        (
            "final_tangential_stiffness",
            Unit::NEWTON_PER_METRE,
            Some(last.stiffness).filter(|stiffness| stiffness.is_finite()),
        ),
        ("final_stored_tangential", Unit::JOULE, last.stored),
        ("friction_dissipated", Unit::JOULE, last.dissipated),
        ("dissipated_per_cycle", Unit::JOULE, per_cycle(shared, records)),
        ("friction_coefficient", Unit::ONE, coefficient(records).filter(|_| gross)),
    ];
    known(&found)
}

/// F_x/F of the last slide.
fn coefficient(records: &[Record]) -> Option<f64> {
    records.iter().rev().find_map(sliding::slid).map(|(_, coefficient)| coefficient)
}

/// What sliding does to an adhesive contact: A/A_JKR at the last slide and at its least, what is left
/// without adhesion, and the tangential force at which the edge would jump under that force.
fn peeled(plan: &RoundPlan, records: &[Record]) -> Vec<Named> {
    let ratio = |record: &Record| record.tangential.and_then(|state| state.area_ratio);
    let last = records.iter().rev().find_map(ratio);
    let sheared = records.iter().filter(|record| ratio(record).is_some());
    let least = sheared.min_by(|x, y| ratio(x).unwrap_or(1.0).total_cmp(&ratio(y).unwrap_or(1.0)));
    let (Some(contact), Some(last), Some(least)) = (compose::sheared(plan), last, least) else { return Vec::new() };
    let (force, radius) = (least.normal.force, least.normal.contact_radius.unwrap_or(0.0));
    let rest = contact.under(force, TangentialLoad::Force(0.0)).map(|state| state.contact_radius);
    let hertz = if let (Ok(plain), Ok(rest)) = (contact.plain_radius(force), rest) {
        Some((plain / rest).powi(2))
    } else {
        None
    };
    let critical = contact.critical(force);
    let found = [
        ("area_ratio", Unit::ONE, Some(last)),
        ("least_area_ratio", Unit::ONE, ratio(least)),
        ("hertz_area_ratio", Unit::ONE, hertz),
        ("critical_tangential_force", Unit::NEWTON, critical.as_ref().ok().map(|state| state.tangential_force)),
    ];
    if let Some(FrictionLaw::Stuck { .. }) = &plan.friction {
        let gone = records.iter().any(|record| record.tangential.is_some_and(|state| gave_way(&state)));
        let results = known(&found).into_iter().chain(last_stuck(plan, &contact, records));
        return results.chain([Named::answer("peels", gone)]).collect();
    }
    let peels = critical.map(|state| Named::answer("peels", radius <= state.contact_radius));
    known(&found).into_iter().chain(peels).collect()
}

/// Whether the edge of a contact that sticks has given way.
fn gave_way(state: &Tangential) -> bool {
    state.area_ratio.is_some() && state.stick_radius <= 0.0
}

/// Force [N] and displacement [m] at which the edge of a contact that sticks gives way, with what is prescribed at the first slide.
fn last_stuck(plan: &RoundPlan, contact: &ShearedAdhesion, records: &[Record]) -> Vec<Named> {
    let slid = records.windows(2).find(|pair| pair[1].tangential.is_some_and(|state| state.area_ratio.is_some()));
    let Some([rest, _]) = slid else { return Vec::new() };
    let control =
        plan.stages.iter().take_while(|stage| stage.entry <= rest.entry).filter_map(|stage| stage.control).last();
    let Normal { indentation, force, contact_radius, .. } = rest.normal;
    let (Some(control), Some(depth), Some(radius)) = (control, indentation, contact_radius) else { return Vec::new() };
    let value = if control == Control::Indentation { depth } else { force };
    let last = contact.last_stuck(Prescribed { control, value }, radius);
    known(&[
        ("peel_force", Unit::NEWTON, Some(last.tangential_force)),
        ("peel_slide", Unit::METRE, Some(last.slide)),
        ("peel_radius", Unit::METRE, Some(last.contact_radius)),
    ])
}

/// Energy [J] lost from one turning point of the last `Shake` to the next but one: a closed loop.
fn per_cycle(plan: &Shared, records: &[Record]) -> Option<f64> {
    let entry = plan.stages.iter().rev().find(|stage| stage.tangential.is_wave())?.entry;
    let shaken = records.iter().filter(|record| record.entry == entry).filter_map(|record| record.tangential);
    let shaken: Vec<Tangential> = shaken.collect();
    let turns = |three: &&[Tangential]| (three[1].slide - three[0].slide) * (three[2].slide - three[1].slide) < 0.0;
    let lost: Vec<f64> = shaken.windows(3).filter(turns).filter_map(|three| three[1].dissipated).collect();
    match lost[..] {
        [.., first, _, last] => Some(last - first),
        _ => None,
    }
}

/// Part of the largest pressure anywhere that an edge without load may seem to carry, by rounding.
const ROUNDING: f64 = 1e-12;

impl Pressures<'_> {
    /// The largest of all, finite or not.
    fn largest(&self) -> Option<f64> {
        self.fields.iter().filter_map(|field| field.peak).chain(self.at_greatest_force).reduce(f64::max)
    }

    /// Stress intensity [Pa √m] of the edge of a field, beyond the rounding of the loads the springs have carried:
    /// those of a liquid fall by many decades, their rounding does not.
    fn intensity(&self, field: &Field) -> Option<f64> {
        let rounding = ROUNDING * self.largest().unwrap_or(0.0) * field.contact_radius.sqrt();
        field.stress_intensity.filter(|intensity| intensity.abs() > rounding)
    }

    /// The largest pressure [Pa], if it is finite: a sharp edge or apex has none.
    fn peak(&self) -> Option<f64> {
        let compressed = |field: &Field| self.intensity(field).is_none_or(|intensity| intensity > 0.0);
        let known = |field: &Field| field.rows.first().is_some_and(|row| row.pressure.is_some());
        let finite = self.fields.iter().all(|field| compressed(field) && known(field));
        self.largest().filter(|_| finite)
    }
}
