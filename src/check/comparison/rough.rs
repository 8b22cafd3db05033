//! Rough shapes: the bed of a line beside the half-space under the surface itself.

#[cfg(feature = "half-space")]
use super::rough_full::grids;
use super::{Comparison, Fineness, Measured, Method, Row, State, row, timed};
use crate::check::theory;
use crate::contact::rough::RoughBed;
use crate::scene::plan::Plan;
use crate::scene::surface::Surface;
use crate::shape::rough::{RoughError, RoughLine};

/// Springs of the line.
const POINTS: [usize; 5] = [1024, 4096, 16384, 65536, 262_144];
/// Most members of an ensemble that are compared: the half-space takes its time for each.
const MEMBERS: usize = 4;
/// Stiffness is the difference quotient down to this share of the force.
const BELOW: f64 = 0.9;

/// What is compared: the state under a force.
pub(super) struct Rough<'s> {
    pub(super) setup: &'s Plan,
    pub(super) surface: &'s Surface,
    /// Normal force [N].
    pub(super) force: f64,
}

/// Compares the methods under the force [N] of the scene; `done` is told the share behind.
pub(super) fn compare(rough: &Rough<'_>, done: &dyn Fn(f64)) -> Comparison {
    let (mut rows, mut notes) = (Vec::new(), notes(rough));
    let all: Vec<Fineness> = rough.fineness(&mut notes);
    let work: f64 = all.iter().map(|&(_, springs, grid)| super::cost(springs, grid)).sum();
    let mut behind = 0.0;
    for fineness in all {
        match rough.measured(fineness) {
            Ok(measured) => rows.push(row(fineness, &measured)),
            Err(note) => notes.push(note),
        }
        behind += super::cost(fineness.1, fineness.2);
        done(behind / work);
    }
    let (reference, state) = reference(&mut rows, rough.force);
    notes.extend(theory::in_words(rough.setup, rough.force, state.stiffness_n_per_m.unwrap_or(0.0)));
    Comparison { reference, state, rows, notes }
}

fn notes(rough: &Rough<'_>) -> Vec<String> {
    let mut notes = vec![
        "the state is that of the largest force; indentation counts from first touch".to_owned(),
        "the line of the springs is another random surface of the same spectrum: single surfaces scatter by tens of per cent, and the share of springs in contact is not the contact area".to_owned(),
    ];
    if rough.surface.seeds.len() > MEMBERS {
        notes.push(format!("means over the first {MEMBERS} of {} seeds", rough.surface.seeds.len()));
    }
    notes
}

#[cfg(not(feature = "half-space"))]
fn grids(_: &Rough<'_>) -> Result<Vec<usize>, String> {
    Err(super::NO_HALF_SPACE.to_owned())
}

/// The finest grid, else the finest bed; fills in the errors.
fn reference(rows: &mut [Row], force: f64) -> (String, State) {
    let fineness = |row: &Row| (row.grid.unwrap_or(0), row.springs.unwrap_or(0));
    let Some(own) = (0..rows.len()).max_by_key(|&at| fineness(&rows[at])) else {
        return ("none".to_owned(), State { force_n: force, ..State::default() });
    };
    let state = rows[own].state;
    for (_, row) in rows.iter_mut().enumerate().filter(|(at, _)| *at != own) {
        let error = |of: fn(&State) -> Option<f64>| Some(of(&row.state)? / of(&state)? - 1.0);
        row.indentation_error = error(|state| Some(state.indentation_m));
        row.stiffness_error = error(|state| state.stiffness_n_per_m);
        row.pressure_error = error(|state| state.peak_pressure_pa);
    }
    let name = match (rows[own].grid, rows[own].springs) {
        (Some(grid), _) => format!("half-space on {grid}² pixels, the finest grid"),
        (_, springs) => format!("bed of {} springs, the finest", springs.unwrap_or(0)),
    };
    (name, state)
}

impl Rough<'_> {
    /// The seeds compared.
    pub(super) fn seeds(&self) -> &[u64] {
        &self.surface.seeds[..self.surface.seeds.len().min(MEMBERS)]
    }

    fn fineness(&self, notes: &mut Vec<String>) -> Vec<Fineness> {
        let least = 2 * (self.surface.rings.variances().len() - 1);
        let springs = POINTS.into_iter().filter(|&points| points >= least);
        let mut all: Vec<Fineness> = springs.map(|points| (Method::Springs, Some(points), None)).collect();
        match grids(self) {
            Ok(grids) => all.extend(grids.into_iter().map(|grid| (Method::HalfSpace, None, Some(grid)))),
            Err(note) => notes.push(note),
        }
        if all.is_empty() {
            notes.push(format!("no bed of at most {} springs carries the shortest wave", POINTS[POINTS.len() - 1]));
        }
        all
    }

    fn measured(&self, (_, springs, grid): Fineness) -> Result<Measured, String> {
        match (springs, grid) {
            #[cfg(feature = "half-space")]
            (None, Some(grid)) => super::rough_full::measured(self, grid),
            _ => self.springs(springs.unwrap_or(self.surface.points)),
        }
    }

    fn springs(&self, points: usize) -> Result<Measured, String> {
        let (states, time) = timed(|| self.seeds().iter().map(|&seed| self.pressed(seed, points)).collect());
        let states: Result<Vec<State>, RoughError> = states;
        let states = states.map_err(|error| format!("{points} springs: {error}"))?;
        let bytes = 24 * points as u64;
        Ok(Measured { state: mean(&states), time: time / states.len() as f64, bytes, iterations: None })
    }

    fn pressed(&self, seed: u64, points: usize) -> Result<State, RoughError> {
        let line = RoughLine::new(&self.surface.rings, seed);
        let bed = RoughBed::under(&line, points, self.setup.pair.normal, |x| {
            self.setup.profile().map_or(0.0, |base| base.reduced(x))
        })?;
        let depth = |force: f64| bed.at_force(force).indentation;
        Ok(self.state([depth(BELOW * self.force), depth(self.force)], bed.first_touch()))
    }

    /// The state from the indentations at nine tenths of the force and at the force.
    pub(super) fn state(&self, [below, here]: [f64; 2], touch: f64) -> State {
        State {
            indentation_m: here - touch,
            force_n: self.force,
            stiffness_n_per_m: Some((1.0 - BELOW) * self.force / (here - below)),
            ..State::default()
        }
    }

    /// Forces at which the state is looked at [N].
    #[cfg(feature = "half-space")]
    pub(super) fn forces(&self) -> [f64; 2] {
        [BELOW * self.force, self.force]
    }
}

/// The mean of the members.
pub(super) fn mean(states: &[State]) -> State {
    let mean = |of: &dyn Fn(&State) -> f64| states.iter().map(of).sum::<f64>() / states.len() as f64;
    let known = |of: fn(&State) -> Option<f64>| {
        states.iter().all(|state| of(state).is_some()).then(|| mean(&|state| of(state).unwrap_or(f64::NAN)))
    };
    State {
        indentation_m: mean(&|state| state.indentation_m),
        force_n: mean(&|state| state.force_n),
        contact_radius_m: None,
        peak_pressure_pa: known(|state| state.peak_pressure_pa),
        stiffness_n_per_m: known(|state| state.stiffness_n_per_m),
        area_fraction: known(|state| state.area_fraction),
    }
}
