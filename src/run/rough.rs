//! Rough shapes: the bed of a rough line, one member of an ensemble after the other.

use super::compose;
use super::ensemble::{self, Ensemble};
use super::follow::follow;
use super::gliding;
use super::named::Named;
use super::record::{ErrorEstimate, Outcome, Record};
use super::unit::Unit;
use super::{SimulationError, Wanted};
use crate::contact::gliding::SteadyState;
use crate::contact::rough::VALIDITY;
use crate::contact::state::Normal;
use crate::scene::plan::RoughPlan;
use crate::scene::surface::Surface;
use crate::shape::rough::{RoughError, RoughLine, Scatter};
use rayon::prelude::*;

/// Runs a scene with a rough shape, all members of its ensemble in parallel; `done` is told the share behind.
pub(super) fn run(plan: &RoughPlan, done: &(dyn Fn(f64) + Sync)) -> Result<Outcome, SimulationError> {
    let surface = &plan.surface;
    let count = surface.seeds.len();
    let members = members(surface, done, |seed| member(plan, seed))?;
    let glides: Vec<Vec<SteadyState>> = members[..count].iter().map(|member| member.glides.clone()).collect();
    let glides = gliding::mean(&glides);
    let dents = plan.hardness.and_then(|_| members[..count].iter().map(|member| member.parts_at).collect());
    let (all, pulls): (Vec<_>, Vec<_>) = members.into_iter().map(|member| (member.records, member.pulls)).unzip();
    let members = &all[..count];
    let ensemble = Ensemble::of(members);
    let records = ensemble::mean(members);
    let mut results = named(surface, &records, ensemble.as_ref());
    if plan.works.is_some() {
        results.extend(pulled(&pulls[..count], records.last()));
    }
    results.extend(dented(dents));
    results.extend(gliding::results(plan.travel.as_ref(), &records, &glides));
    results.extend(gliding::results_of_rough(plan.travel.as_ref(), &gliding::rubbing(plan, &glides)));
    Ok(Outcome {
        map: None,
        results,
        records,
        fields: Vec::new(),
        tables: ensemble.iter().map(Ensemble::table).chain(gliding::table_beside_theory(plan, &glides)).collect(),
        error_estimate: estimate(&all, count),
        warnings: remarks(plan),
        plan: plan.parts(),
    })
}

/// What `member` finds for the seeds of a surface, and for those of surfaces like a single one.
pub(super) fn members<M: Send>(
    surface: &Surface,
    done: &(dyn Fn(f64) + Sync),
    member: impl Fn(u64) -> Result<M, SimulationError> + Sync,
) -> Result<Vec<M>, SimulationError> {
    let seeds = [&surface.seeds[..], &like(&surface.seeds)].concat();
    let behind = std::sync::atomic::AtomicUsize::new(0);
    let member = |&seed: &u64| {
        let member = member(seed);
        let behind = behind.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1;
        done(behind as f64 / seeds.len() as f64);
        member
    };
    let members: Vec<Result<M, SimulationError>> = seeds.par_iter().map(member).collect();
    members.into_iter().collect()
}

/// A surface that cannot be made.
pub(super) fn without_surface(seed: u64, error: &RoughError) -> SimulationError {
    SimulationError::Refused(format!("shape, seed {seed}: {error}"))
}

/// What the method is good for.
pub(super) fn remarks(plan: &RoughPlan) -> Vec<String> {
    let adheres =
        "adhesion holds the patches of the line as it holds round contacts (Heß): nothing exact stands beside it";
    let yields = "each patch of the line bears the hardness on the circle it is wide: nothing exact stands beside it";
    let rules = [plan.works.map(|_| adheres), plan.hardness.map(|_| yields)].into_iter().flatten().map(str::to_owned);
    [format!("{VALIDITY}; indentation counts from first touch")].into_iter().chain(rules).collect()
}

/// What is known of one surface.
struct Member {
    records: Vec<Record>,
    pulls: Pulls,
    /// Depth at which the bodies would part [m].
    parts_at: Option<f64>,
    /// Steady states, of a surface of the scene itself.
    glides: Vec<SteadyState>,
}

/// Forces [N] of sudden changes.
#[derive(Clone, Copy)]
struct Pulls {
    /// With which the bodies jump into contact.
    jump_in: Option<f64>,
    /// At which most patches have held on the way out.
    pull_off: Option<f64>,
}

impl Pulls {
    fn of(jumps: &[(Normal, Normal)]) -> Self {
        let apart = |normal: &Normal| normal.stiffness <= 0.0;
        let joined = jumps.iter().find(|(before, after)| apart(before) && !apart(after));
        // Patches that join pull more afterwards, those that let go less.
        let let_go = jumps.iter().filter(|(before, after)| before.force < after.force);
        let least = let_go.map(|(before, _)| before.force).reduce(f64::min);
        let pull = |force: &f64| *force < 0.0;
        Self { jump_in: joined.map(|(_, after)| after.force).filter(pull), pull_off: least.filter(pull) }
    }
}

fn member(plan: &RoughPlan, seed: u64) -> Result<Member, SimulationError> {
    let contact = compose::rough(plan, seed).map_err(|error| without_surface(seed, &error))?;
    let run = follow(plan, contact, Wanted { instants: false, ..Wanted::NOTHING })?;
    let (pulls, parts_at) = (Pulls::of(run.jumps()), run.parts_at());
    let glides = if plan.surface.seeds.contains(&seed) {
        gliding::steady_line(plan, &RoughLine::new(&plan.surface.rings, seed), &run.records)?
    } else {
        Vec::new()
    };
    Ok(Member { records: run.records, pulls, parts_at, glides })
}

/// The depth at which bodies that have yielded part, the mean over the members, and how much it scatters.
fn dented(depths: Option<Vec<f64>>) -> Vec<Named> {
    let Some(depths) = depths else { return Vec::new() };
    let Some(scatter) = Scatter::of(&depths) else { return Vec::new() };
    let deviation = (depths.len() > 1).then_some(("residual_depth_deviation", scatter.deviation));
    let named = |(name, depth): (&'static str, f64)| Named::number(name, Unit::METRE, depth);
    [("residual_depth", scatter.mean)].into_iter().chain(deviation).map(named).collect()
}

/// The results of adhesion: forces are means over the members, if all have one.
fn pulled(pulls: &[Pulls], last: Option<&Record>) -> Vec<Named> {
    let of = |of: fn(&Pulls) -> Option<f64>| {
        let forces = pulls.iter().map(of).collect::<Option<Vec<_>>>()?;
        Scatter::of(&forces)
    };
    let (jump_in, pull_off) = (of(|pulls| pulls.jump_in), of(|pulls| pulls.pull_off));
    let deviation = pull_off.filter(|_| pulls.len() > 1).map(|force| force.deviation);
    let found = [
        ("jump_in_force", Unit::NEWTON, jump_in.map(|force| force.mean)),
        ("pull_off_force", Unit::NEWTON, pull_off.map(|force| force.mean)),
        ("pull_off_force_deviation", Unit::NEWTON, deviation),
        ("final_stored_surface", Unit::JOULE, last.map(|record| record.normal.stored.surface)),
    ];
    let named = |(name, unit, number): (&'static str, Unit, Option<f64>)| Some(Named::number(name, unit, number?));
    found.into_iter().filter_map(named).collect()
}

/// The named results, those of an ensemble with their deviation.
fn named(surface: &Surface, records: &[Record], ensemble: Option<&Ensemble>) -> Vec<Named> {
    let largest = |of: fn(&Record) -> f64| records.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    let depth = |record: &Record| record.normal.indentation.unwrap_or(f64::NEG_INFINITY);
    let mut results = vec![
        Named::number("largest_force", Unit::NEWTON, largest(|record| record.normal.force)),
        Named::number("largest_indentation", Unit::METRE, largest(depth)),
        Named::number("largest_stiffness", Unit::NEWTON_PER_METRE, largest(|record| record.normal.stiffness)),
        Named::number("largest_stored_elastic", Unit::JOULE, largest(|record| record.normal.stored.elastic)),
    ];
    let (of_surface, peak_to_valley) = of_surface(surface);
    results.extend(of_surface);
    let rubs = records.iter().any(|record| record.tangential.is_some());
    if let Some(last) = records.last().filter(|last| rubs || last.normal.dissipated > 0.0) {
        results.push(Named::number("dissipated", Unit::JOULE, last.normal.dissipated));
    }
    if let Some(last) = records.last().and_then(|record| record.tangential) {
        let tangential = |record: &Record| record.tangential.map_or(0.0, |state| state.force.abs());
        results.push(Named::number("largest_tangential_force", Unit::NEWTON, largest(tangential)));
        results.push(Named::number("friction_dissipated", Unit::JOULE, last.dissipated.unwrap_or(0.0)));
    }
    results.extend(peak_to_valley);
    results.extend(ensemble.iter().flat_map(|ensemble| ensemble.results()));
    results
}

/// The roughness itself: height, slope and curvature; the peak to valley height of a map.
pub(super) fn of_surface(surface: &Surface) -> ([Named; 3], Option<Named>) {
    let roughness = surface.roughness();
    let squares = [
        Named::number("rms_height", Unit::METRE, roughness.rms_height),
        Named::number("rms_slope", Unit::ONE, roughness.rms_slope),
        Named::number("rms_curvature", Unit::PER_METRE, roughness.rms_curvature),
    ];
    (squares, roughness.peak_to_valley.map(|height| Named::number("peak_to_valley", Unit::METRE, height)))
}

/// Surfaces like a single one, by which its scatter is known: few, for each costs as much.
const LIKE: u64 = 4;
/// Error of the stiffness of the bed against the full half-space over H = 0.2 to 0.9.
const BESIDE_HALF_SPACE: f64 = 0.2;

/// Seeds of surfaces like the one of a single seed; none beside an ensemble.
fn like(seeds: &[u64]) -> Vec<u64> {
    match seeds {
        [one] => (1..=LIKE).map(|k| one.wrapping_add(k)).collect(),
        _ => Vec::new(),
    }
}

/// The error of the method, or of `count` surfaces that stand for all their like: three standard deviations of the
/// depth, force or stiffness of `all` surfaces computed, of a mean those of the mean.
pub(super) fn estimate(all: &[Vec<Record>], count: usize) -> ErrorEstimate {
    let scatter = 3.0 * Ensemble::of(all).map_or(0.0, |all| all.relative_deviation()) / (count as f64).sqrt();
    if scatter > BESIDE_HALF_SPACE {
        let basis = format!(
            "approximate: three standard deviations of the depth, force or stiffness of {count} of the surfaces of this spectrum, from {}",
            all.len()
        );
        return ErrorEstimate { relative: scatter, basis };
    }
    ErrorEstimate {
        relative: BESIDE_HALF_SPACE,
        basis: "approximate: stiffness against the full half-space over H = 0.2 to 0.9; sums of the bed are exact to rounding".to_owned(),
    }
}
