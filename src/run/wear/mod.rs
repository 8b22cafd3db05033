//! A history of a contact that wears.
//!
//! Up to the first way slid in contact it is the history of the same scene without wear, to the last bit; from there on the
//! bodies are led by [`Wearing`].

mod profiles;
mod worn;

use super::follow::{Run, follow};
use super::record::{ErrorEstimate, Field, Outcome, Record};
use super::results::{self, Pressures};
use super::unit::Unit;
use super::{SimulationError, Solved, Wanted, compose, error, run_unworn};
use crate::contact::adhesion::equilibrium::Control;
use crate::run::named::Named;
use crate::scene::law::{FrictionLaw, WearLaw};
use crate::scene::parts::Parts;
use crate::scene::plan::RoundPlan;
use crate::scene::stage::{Path, Stage};
use crate::wear::{Load, Start, Wearing, Worn};
use worn::WornRun;

/// Forces that agree to this part are one.
const SAME: f64 = 1e-9;

/// Leads a round contact that wears through its history.
///
/// # Errors
/// The contact would leave its profile.
pub(super) fn run(plan: &RoundPlan, law: WearLaw, wanted: Wanted) -> Result<Solved, SimulationError> {
    match first_rub(plan, wanted)? {
        Some(begin) if law.coefficient > 0.0 => worn(plan, law, begin, wanted),
        Some(_) | None => unworn(plan, wanted),
    }
}

/// The scene without wear, with columns of nothing worn.
fn unworn(plan: &RoundPlan, wanted: Wanted) -> Result<Solved, SimulationError> {
    let mut solved = run_unworn(plan, wanted)?;
    let outcome = &mut solved.outcome;
    outcome.records.iter_mut().for_each(|record| record.worn = Some(Worn::default()));
    outcome.results.extend(of_wear(&outcome.records));
    Ok(solved)
}

/// Where wear begins.
struct Beginning {
    /// Number of the first stage in which bodies in contact rub.
    first: usize,
    /// The run up to it.
    before: Run,
    /// Its last record.
    last: Record,
}

fn first_rub(plan: &RoundPlan, wanted: Wanted) -> Result<Option<Beginning>, SimulationError> {
    let rubs = |stage: &Stage| stage.tangential != Path::Stay;
    for (first, _) in plan.stages.iter().enumerate().filter(|(_, stage)| rubs(stage)) {
        let mut shared = plan.shared.clone();
        shared.stages.truncate(first);
        let before = follow(&shared, compose::contact(plan, wanted)?, wanted)?;
        let last = before.records.last().copied().filter(|record| record.normal.contact_radius > Some(0.0));
        if let Some(last) = last {
            return Ok(Some(Beginning { first, before, last }));
        }
    }
    Ok(None)
}

/// The history with wear, and its worn part again on half the cells for the error.
fn worn(plan: &RoundPlan, law: WearLaw, begin: Beginning, wanted: Wanted) -> Result<Solved, SimulationError> {
    let led = |cells: usize, wanted: Wanted| {
        let wearing = wearing(plan, WearLaw { cells, ..law }, &begin);
        let mut run = WornRun::new(plan, &begin, wearing);
        run.wanted = wanted;
        run.followed(begin.first)
    };
    let run = led(law.cells, wanted)?;
    let coarse = led(law.cells / 2, Wanted { fields: false, ..wanted })?;
    let error_estimate = estimate(plan, &begin, (&run, &coarse));
    let parts = Parts { springs: run.wearing.cells(), state_bytes: run.wearing.bytes(), ..plan.parts() };
    let before = begin.before;
    let unrubbed = before.records.iter().map(|record| Record { worn: Some(Worn::default()), ..*record });
    let records: Vec<Record> = unrubbed.chain(run.records).collect();
    let fields: Vec<Field> = before.fields.into_iter().chain(run.fields).collect();
    let pressures = Pressures { fields: &fields, at_greatest_force: None };
    let mut results = results::named(Some(&plan.contact), &records, &pressures);
    results.extend(results::of_friction(plan, &records));
    results.extend(of_wear(&records));
    let outcome = Outcome {
        map: None,
        results,
        error_estimate,
        plan: parts,
        tables: vec![profiles::table(run.profiles)],
        warnings: before.notes.into_iter().chain(run.notes).collect(),
        records,
        fields,
    };
    // The unworn contact is the hardest pressed, unless it is pressed harder later.
    let largest = outcome.records.iter().map(|record| record.normal.force).fold(0.0, f64::max);
    let carried = before.carried.filter(|_| largest <= begin.last.normal.force * (1.0 + SAME));
    Ok(Solved { outcome, carried })
}

/// How far two worn runs are apart, one on half the cells of the other.
fn estimate(plan: &RoundPlan, begin: &Beginning, (run, coarse): (&WornRun<'_>, &WornRun<'_>)) -> ErrorEstimate {
    let relative = apart(&run.records, &coarse.records).max(error::estimate(plan, &begin.before).relative);
    let basis = format!(
        "worn bed of {} cells in {} steps: how far force, depth, radius and worn depth are from those on half the cells",
        run.wearing.cells(),
        run.wearing.steps()
    );
    ErrorEstimate { relative, basis }
}

/// The contact as wear begins.
fn wearing(plan: &RoundPlan, law: WearLaw, begin: &Beginning) -> Wearing {
    let state = begin.last.normal;
    let depth = state.indentation.unwrap_or(0.0);
    let start = Start {
        contact_radius: state.contact_radius.unwrap_or(0.0),
        stick: stick(plan, &plan.stages[begin.first], depth),
        cells: law.cells,
    };
    Wearing::new(plan.profile.clone(), plan.pair.normal, law.coefficient, start)
}

/// The radius [m] inside which a contact sticks that is shaken: a spring that is compressed by amplitude/m.
fn stick(plan: &RoundPlan, stage: &Stage, depth: f64) -> Option<f64> {
    let Path::Wave(wave) = stage.tangential else { return None };
    let reach = plan.grip(coefficient(plan)).reach();
    let at_edge = depth - wave.amplitude / reach;
    if at_edge > 0.0 { plan.profile.edge(at_edge) } else { None }
}

/// Coefficient of Coulomb friction.
fn coefficient(plan: &RoundPlan) -> f64 {
    plan.friction.as_ref().and_then(FrictionLaw::coulomb).unwrap_or(0.0)
}

/// What is prescribed of a state.
fn load_of(control: Control, record: &Record) -> Load {
    match control {
        Control::Indentation => Load::Indentation(record.normal.indentation.unwrap_or(0.0)),
        Control::Force => Load::Force(record.normal.force),
    }
}

/// The largest difference of the records of two runs through the same history, each as a part of its largest.
fn apart(one: &[Record], other: &[Record]) -> f64 {
    let of: [fn(&Record) -> f64; 4] = [
        |record| record.normal.force,
        |record| record.normal.indentation.unwrap_or(0.0),
        |record| record.normal.contact_radius.unwrap_or(0.0),
        |record| record.worn.map_or(0.0, |worn| worn.depth),
    ];
    let off = |of: fn(&Record) -> f64| {
        let largest = one.iter().map(|record| of(record).abs()).fold(f64::MIN_POSITIVE, f64::max);
        let differ = one.iter().zip(other).map(|(one, other)| (of(one) - of(other)).abs()).fold(0.0, f64::max);
        differ / largest
    };
    of.into_iter().map(off).fold(0.0, f64::max)
}

/// What wear adds to the results.
fn of_wear(records: &[Record]) -> Vec<Named> {
    let Some(worn) = records.last().and_then(|record| record.worn) else { return Vec::new() };
    vec![
        Named::number("worn_volume", Unit::CUBIC_METRE, worn.volume),
        Named::number("wear_depth", Unit::METRE, worn.depth),
    ]
}
