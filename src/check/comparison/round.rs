//! Round contacts: direct path and springs, in one state or through the history, and the half-space.

use super::{Candidate, Compared, Contest, Known, closed, found, largest};
use crate::check::case::Attempt;
use crate::check::row::{Computed, Found, Setting};
use crate::check::study::Method;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::Foundation;
use crate::contact::model::{ContactModel, Loading, Straight};
use crate::contact::springs::{SpringBed, reach_for};
use crate::numerics::extremum;
use crate::run::record::Record;
use crate::run::{self, SimulationError, Wanted};
use crate::scene::law::ElasticAdhesion;
use crate::scene::plan::{Plan, SceneSettings};
use crate::scene::solver::{HalfSpace, SolverChoice, Tractions};
use crate::shape::Shape;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Numbers of springs of the classical bed.
const SPRINGS: [usize; 6] = [32, 128, 512, 2048, 8192, 32768];
/// Places at which the largest pressure is looked for before it is refined.
const PLACES: u32 = 64;

/// What is to be computed.
struct Scenario {
    /// The scene, without springs.
    plan: Plan,
    /// The state of the largest force, by the direct path.
    most: Found,
    /// Its indentation [m], if the state follows from that alone.
    depth: Option<f64>,
    /// Where that state has its largest pressure [m]; `None` where it is singular or not known.
    peak_at: Option<f64>,
}

/// Largest differences of forces, of the largest of their kind, and the largest tangential force [N].
struct Apart {
    normal: f64,
    tangential: f64,
    largest: f64,
}

pub(super) fn contest(plan: Plan, most: &Record) -> Contest {
    let scenario = Arc::new(Scenario::of(plan, most));
    let mut notes = scenario.notes();
    let known = scenario.depth.map_or(Ok(None), |depth| closed::form(&scenario.plan, depth));
    let exact = known.unwrap_or_else(|why| {
        notes.push(format!("closed form: {why}"));
        None
    });
    let mut methods = vec![Method::of("direct", Setting::FREE, &scenario, |own| own.direct())];
    // What cannot be computed on springs, such as an attraction at a distance, says so once.
    match scenario.springs(SPRINGS[0]) {
        Ok(_) => methods
            .extend(SPRINGS.map(|n| Method::of("springs", Setting::springs(n), &scenario, move |own| own.springs(n)))),
        Err(why) => notes.push(format!("springs: {why}")),
    }
    let mut candidates = vec![Candidate { at: 0, name: "direct path, exact for this model".to_owned() }];
    for (name, method) in scenario.grids() {
        candidates.insert(0, Candidate { at: methods.len(), name });
        methods.push(method);
    }
    // Pixels that go through a history are held against the direct path, and do not judge it.
    methods.extend(scenario.histories());
    let exact = exact.map(|(name, state)| Known { name: name.to_owned(), state });
    let pressure = Some(Candidate { at: 0, name: "direct path".to_owned() });
    Contest { compared: Compared::Round, methods, exact, candidates, pressure, members: 1, notes }
}

impl Scenario {
    /// The state of a record, replayed if it follows from its indentation.
    fn of(plan: Plan, most: &Record) -> Self {
        let mut scenario = Self { plan, most: found(most), depth: None, peak_at: None };
        if scenario.plan.relaxation().is_some() {
            return scenario;
        }
        // With adhesion a state may hang on the way to it.
        let Some(depth) = most.normal.indentation else { return scenario };
        if let Ok(contact) = pressed(&scenario.plan, depth) {
            let apart = (contact.state().force - most.normal.force).abs();
            scenario.depth = (apart <= 1e-9 * most.normal.force.abs()).then_some(depth);
            scenario.peak_at = (!is_sharp(&scenario.plan.scene.shape)).then(|| peak_at(&contact)).flatten();
        }
        scenario
    }

    /// What is left out of the scene.
    fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.is_followed() {
            notes.extend(self.on_pixels(super::PAST_GRIDS[0], None).err().map(|why| format!("half-space: {why}")));
        }
        if self.plan.has_friction() {
            notes.extend(self.of_friction());
        }
        notes.extend(super::WITHOUT.map(str::to_owned));
        if self.depth.is_none() {
            notes.push(
                "the state depends on its past: times are those of the whole history, and pressures are not compared"
                    .to_owned(),
            );
        }
        notes
    }

    /// What friction is on pixels, and what it does to the normal contact where both are found together.
    fn of_friction(&self) -> Vec<String> {
        let why = |why| format!("friction on the half-space: {why}");
        let similar = self.plan.pair.coupling.abs() <= 1e-9;
        let left = if similar { "which friction does not change here" } else { "as it is without friction" };
        let apart =
            |tractions, grid| Ok::<_, Box<dyn std::error::Error + Send + Sync>>((grid, self.apart(tractions, grid)?));
        let alone = apart(Tractions::Independent, super::PAST_GRIDS[2]).map(|(grid, Apart { tangential, largest, .. })| {
            format!(
                "friction on the half-space: followed through the history on {grid}² pixels, tangential forces are at most {tangential:.1e} of the largest, {largest:.4e} N, from those of the direct path"
            )
        });
        let together = (!similar).then(|| {
            apart(Tractions::Coupled, super::PAST_GRIDS[1]).map(|(grid, Apart { normal, tangential, .. })| {
                format!(
                    "pressures and shear found together on {grid}² pixels (β = {:.3}): normal forces are at most {normal:.1e}, tangential ones {tangential:.1e} of the largest from those of the direct path, which takes them for independent",
                    self.plan.pair.coupling
                )
            })
        });
        let told = [Some(alone), together].into_iter().flatten().map(|told| told.unwrap_or_else(why));
        std::iter::once(format!("friction: rows compare the normal contact, {left}")).chain(told).collect()
    }

    /// How far the forces of the history are from those of pixels that follow it.
    fn apart(&self, tractions: Tractions, grid: usize) -> Attempt<Apart> {
        let pixels = run::run(&self.on_pixels(grid, Some(tractions))?, Wanted::NOTHING)?;
        let own = run::run(&self.plan, Wanted::NOTHING)?;
        let (mut off, mut most) = ([0.0_f64; 2], [f64::MIN_POSITIVE; 2]);
        for record in &pixels.records {
            let same = own.records.iter().find(|own| (own.entry, own.time) == (record.entry, record.time));
            let forces = |record: &Record| Some([record.normal.force, record.tangential_force()?]);
            let Some((one, other)) = same.and_then(forces).zip(forces(record)) else { continue };
            for k in 0..2 {
                off[k] = off[k].max((one[k] - other[k]).abs());
                most[k] = most[k].max(one[k].abs()).max(other[k].abs());
            }
        }
        let [normal, tangential] = [off[0] / most[0], off[1] / most[1]];
        Ok(Apart { normal, tangential, largest: most[1] })
    }

    fn direct(&self) -> Attempt<Computed> {
        let found = match self.depth {
            None => most_pressed(&self.plan)?,
            Some(depth) => {
                let contact = pressed(&self.plan, depth)?;
                let normal = contact.state();
                Found {
                    force_n: Some(normal.force),
                    contact_radius_m: normal.contact_radius.map(|place| contact_radius(&self.plan, place)),
                    peak_pressure_pa: self
                        .peak_at
                        .and_then(|r| Some(contact.loaded().pressure(r)).filter(|p| p.is_finite())),
                    ..self.most
                }
            }
        };
        Ok(Computed { found, bytes: self.plan.parts().state_bytes, ..Computed::default() })
    }

    fn springs(&self, springs: usize) -> Attempt<Computed> {
        let found = match self.depth {
            None => most_pressed(&self.on_springs(springs)?)?,
            Some(depth) => self.bed(springs, depth)?,
        };
        Ok(Computed { found, bytes: 16 * springs, ..Computed::default() })
    }

    fn bed(&self, springs: usize, depth: f64) -> Attempt<Found> {
        let (ground, adhesion) = elastic(&self.plan)?;
        let reach = reach_for(ground.profile(), ground.profile().place(self.most.contact_radius_m.unwrap_or(0.0)));
        let work = adhesion.work_at_edge().ok_or("springs carry no attraction at a distance")?;
        let mut bed = SpringBed::new(ground, springs, reach, work);
        bed.indent(depth);
        Ok(Found {
            force_n: Some(bed.force()),
            contact_radius_m: Some(contact_radius(&self.plan, bed.contact_radius())),
            peak_pressure_pa: self.peak_at.and_then(|r| bed.spring_loads().pressure(r)),
            ..self.most
        })
    }

    /// The scene on a number of springs.
    fn on_springs(&self, springs: usize) -> Result<Plan, SimulationError> {
        Ok(self.plan.with(SceneSettings { springs: NonZeroUsize::new(springs), ..self.plan.settings() })?)
    }

    /// Whether the half-space must go through the whole history, as a scene of its own: for its past, or for what lies
    /// beneath.
    fn is_followed(&self) -> bool {
        let (one, other) = &self.plan.scene.bodies;
        self.plan.adheres() || self.plan.relaxation().is_some() || one.is_uneven() || other.is_uneven()
    }

    /// The scene on the pixels of the half-space.
    fn on_pixels(&self, grid: usize, tractions: Option<Tractions>) -> Result<Plan, SimulationError> {
        let asked = HalfSpace { grid: NonZeroUsize::new(grid), tractions, ..HalfSpace::default() };
        let solver = Some(SolverChoice::HalfSpace(asked));
        Ok(self.plan.with(SceneSettings { springs: None, solver, ..self.plan.settings() })?)
    }

    /// The history on the half-space, where pixels must follow it and can.
    fn histories(self: &Arc<Self>) -> Vec<Method> {
        if !self.is_followed() || self.on_pixels(super::PAST_GRIDS[0], None).is_err() {
            return Vec::new();
        }
        let history = |own: &Self, grid| {
            let plan = own.on_pixels(grid, None)?;
            Ok(Computed { found: most_pressed(&plan)?, bytes: plan.parts().state_bytes, ..Computed::default() })
        };
        super::PAST_GRIDS
            .map(|grid| Method::of("half-space", Setting::grid(grid), self, move |own| history(own, grid)))
            .into()
    }

    #[cfg(not(feature = "half-space"))]
    fn grids(self: &Arc<Self>) -> Vec<(String, Method)> {
        Vec::new()
    }

    /// The half-space on all grids, if it can compute the state, and what it is called where it is right.
    #[cfg(feature = "half-space")]
    fn grids(self: &Arc<Self>) -> Vec<(String, Method)> {
        // Of sections the half-space has no twin.
        let mapped = self.plan.profile().is_some_and(crate::shape::Profile::is_mapped);
        let round = !self.is_followed() && !mapped;
        let Some(depth) = self.depth.filter(|_| round) else { return Vec::new() };
        let method = |grid| Method::of("half-space", Setting::grid(grid), self, move |own| own.pixels(grid, depth));
        super::GRIDS.map(|grid| (format!("half-space on {grid}² pixels, the finest grid"), method(grid))).into()
    }

    /// The state on the full half-space.
    #[cfg(feature = "half-space")]
    fn pixels(&self, grid: usize, depth: f64) -> Attempt<Computed> {
        let solved = super::pixels::pressed(&self.plan, self.most.contact_radius_m.unwrap_or(0.0), depth, grid)?;
        let peak_pressure_pa = solved.found.peak_pressure_pa.filter(|_| self.peak_at.is_some());
        Ok(Computed { found: Found { peak_pressure_pa, ..solved.found }, ..solved })
    }
}

/// The radius or half width [m] of a contact whose bed ends at a place [m].
fn contact_radius(plan: &Plan, place: f64) -> f64 {
    plan.profile().map_or(place, |profile| profile.contact_radius(place))
}

/// The state of the largest force after the whole history.
fn most_pressed(plan: &Plan) -> Attempt<Found> {
    let outcome = run::run(plan, Wanted::NOTHING)?;
    Ok(found(largest(&outcome.records).ok_or("the history has no record")?))
}

/// What a scene on the direct path is made of.
fn elastic(plan: &Plan) -> Attempt<(Foundation, ElasticAdhesion)> {
    Ok(plan.ground().zip(plan.direct()).ok_or("the direct path computes elastic round contacts")?)
}

/// The contact pressed to an indentation [m] from first touch.
fn pressed(plan: &Plan, to: f64) -> Attempt<QuasiStatic> {
    let (ground, adhesion) = elastic(plan)?;
    let mut contact = run::direct(ground, adhesion)?;
    contact.follow(&Straight::between(0.0, to, 0.0))?;
    Ok(contact)
}

/// Whether the pressure of a shape is singular somewhere under compression: at an apex or an edge.
fn is_sharp(shape: &Shape) -> bool {
    let pointed = |shape: &Shape| matches!(shape, Shape::Power(power) if power.exponent.si() <= 1.0);
    pointed(shape)
        || matches!(
            shape,
            Shape::Cone(_) | Shape::FlatPunch(_) | Shape::TruncatedCone(_) | Shape::TruncatedParaboloid(_)
        )
}

/// Where the pressure is largest [m].
fn peak_at(contact: &QuasiStatic) -> Option<f64> {
    let a = contact.state().contact_radius?;
    let place = |k: u32| a * f64::from(k) / f64::from(PLACES);
    let pressure = |r: f64| contact.loaded().pressure(r);
    let best = (0..PLACES).max_by(|&i, &j| pressure(place(i)).total_cmp(&pressure(place(j))))?;
    if best == 0 {
        return pressure(0.0).is_finite().then_some(0.0);
    }
    Some(extremum::greatest(pressure, place(best - 1), place(best + 1)).place)
}
