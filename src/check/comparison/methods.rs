//! The methods: direct path and springs, in one state or through the history.

use super::{Fineness, Measured, Method, State, state_of, timed};
use crate::contact::adhesion::Adhesion;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::contact::model::{ContactModel, Loading, Straight};
use crate::contact::springs::{SpringBed, reach_for};
use crate::numerics::extremum;
use crate::run::record::Record;
use crate::run::{self, SimulationError, Wanted};
use crate::scene::law::ElasticAdhesion;
use crate::scene::plan::Plan;
use crate::scene::plan::SceneSettings;
use crate::shape::Shape;
use std::num::NonZeroUsize;

/// Places at which the largest pressure is looked for before it is refined.
const PLACES: u32 = 64;

/// What is to be computed.
pub(super) struct Scenario<'s> {
    /// The scene, without springs.
    pub(super) setup: &'s Plan,
    /// The state of the largest force, by the direct path.
    pub(super) most: State,
    /// Where that state has its largest pressure [m]; `None` where it is singular or not known.
    pub(super) peak_at: Option<f64>,
    /// Whether the state follows from its indentation alone.
    pub(super) replayed: bool,
}

impl<'s> Scenario<'s> {
    /// The state of a record, replayed if it follows from its indentation.
    pub(super) fn of(setup: &'s Plan, most: &Record) -> Self {
        let recorded = state_of(most);
        let mut scenario = Self { setup, most: recorded, peak_at: None, replayed: false };
        if setup.relaxation().is_some() {
            return scenario;
        }
        // With adhesion a state may hang on the way to it.
        if let Ok(contact) = pressed(setup, recorded.indentation_m) {
            let force = contact.state().force;
            scenario.replayed = (force - recorded.force_n).abs() <= 1e-9 * recorded.force_n.abs();
            scenario.peak_at = (!is_sharp(&setup.scene.shape)).then(|| peak_at(&contact)).flatten();
        }
        scenario
    }

    /// What the comparison does about the past.
    pub(super) fn note(&self) -> Option<String> {
        (!self.replayed).then(|| {
            "the state depends on its past: times are those of the whole history, and pressures are not compared"
                .to_owned()
        })
    }

    /// Whether the half-space can compute the state.
    #[cfg(feature = "half-space")]
    pub(super) fn is_plain(&self) -> bool {
        self.replayed && self.setup.scene.adhesion.is_none()
    }

    /// A row; `None` if the method cannot compute the scene, an error if it failed at this fineness.
    pub(super) fn measured(&self, (method, springs, grid): Fineness) -> Option<Result<Measured, String>> {
        match (method, springs, grid) {
            (Method::Direct, ..) => Some(self.direct()),
            (Method::Springs, Some(springs), _) => {
                // The bed cannot carry an attraction at a distance.
                (!matches!(self.setup.scene.adhesion, Some(Adhesion::Maugis(_)))).then(|| self.springs(springs))
            }
            #[cfg(feature = "half-space")]
            (Method::HalfSpace, _, Some(grid)) => self.is_plain().then(|| super::full::measured(self, grid)),
            _ => None,
        }
    }

    fn direct(&self) -> Result<Measured, String> {
        let (state, time) = timed(|| if self.replayed { self.direct_state() } else { self.history(None) });
        let bytes = self.setup.parts().state_bytes as u64;
        let state = state.map_err(|error| format!("direct: {error}"))?;
        Ok(Measured { state, time, bytes, iterations: None })
    }

    fn direct_state(&self) -> Result<State, SimulationError> {
        let contact = pressed(self.setup, self.most.indentation_m)?;
        let normal = contact.state();
        Ok(State {
            force_n: normal.force,
            contact_radius_m: normal.contact_radius,
            peak_pressure_pa: self.peak_at.and_then(|r| Loading::pressure(&&contact, r)),
            ..self.most
        })
    }

    fn springs(&self, springs: usize) -> Result<Measured, String> {
        let computed = || if self.replayed { self.bed_state(springs) } else { self.history(Some(springs)) };
        let (state, time) = timed(computed);
        let state = state.map_err(|error| format!("{springs} springs: {error}"))?;
        Ok(Measured { state, time, bytes: 16 * springs as u64, iterations: None })
    }

    fn bed_state(&self, springs: usize) -> Result<State, SimulationError> {
        let (ground, adhesion) = direct(self.setup)?;
        let reach = reach_for(ground.profile(), self.most.contact_radius_m.unwrap_or(0.0));
        let work = adhesion.work_at_edge().unwrap_or(0.0);
        let mut bed = SpringBed::new(ground.clone(), (springs, reach), work);
        bed.indent(self.most.indentation_m);
        Ok(State {
            force_n: bed.force(),
            contact_radius_m: Some(bed.contact_radius()),
            peak_pressure_pa: self.peak_at.and_then(|r| bed.spring_loads().pressure(r)),
            ..self.most
        })
    }

    /// The state of the largest force after the whole history.
    fn history(&self, springs: Option<usize>) -> Result<State, SimulationError> {
        let springs = springs.and_then(NonZeroUsize::new);
        let setup = self.setup.with(SceneSettings { springs, ..self.setup.settings() })?;
        let outcome = run::run(&setup, Wanted::NOTHING)?;
        let most = outcome.records.iter().max_by(|a, b| a.normal.force.total_cmp(&b.normal.force));
        Ok(most.map_or(self.most, state_of))
    }
}

/// What a scene on the direct path is made of.
fn direct(setup: &Plan) -> Result<(HalfSpace, ElasticAdhesion), SimulationError> {
    let parts = setup.ground().zip(setup.direct());
    parts.ok_or_else(|| SimulationError::Refused("the direct path computes elastic round contacts".to_owned()))
}

/// The contact pressed to an indentation [m] from first touch.
fn pressed(setup: &Plan, to: f64) -> Result<QuasiStatic, SimulationError> {
    let (ground, adhesion) = direct(setup)?;
    let mut contact = run::direct(ground, adhesion)?;
    let pressed = contact.follow(&Straight::between(0.0, to, 0.0));
    pressed.map_err(|source| SimulationError::Contact { entry: 0, source })?;
    Ok(contact)
}

/// Whether the pressure of a shape is singular somewhere under compression: at an apex or an edge.
fn is_sharp(shape: &Shape) -> bool {
    match shape {
        Shape::Power(power) => power.exponent.si() <= 1.0,
        Shape::Cone(_) | Shape::FlatPunch(_) | Shape::TruncatedCone(_) | Shape::TruncatedParaboloid(_) => true,
        _ => false,
    }
}

/// Where the pressure is largest [m].
fn peak_at(contact: &QuasiStatic) -> Option<f64> {
    let a = contact.state().contact_radius?;
    let place = |k: u32| a * f64::from(k) / f64::from(PLACES);
    let pressure = |r: f64| contact.pressure(r);
    let best = (0..PLACES).max_by(|&i, &j| pressure(place(i)).total_cmp(&pressure(place(j))))?;
    if best == 0 {
        return pressure(0.0).is_finite().then_some(0.0);
    }
    Some(extremum::greatest(pressure, place(best - 1), place(best + 1)).place)
}
