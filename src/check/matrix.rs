//! The matrix of all combinations: which shape, bodies, adhesion, friction and drive are computed together, by whom,
//! and why the others are not.
//!
//! # Examples
//! ```
//! use springbed::check::matrix::{Verdict, cells};
//!
//! // A rough line on rubber is computed at a prescribed depth.
//! let rough = cells().into_iter().find(|cell| cell.names() == ["rough line", "viscoelastic", "none", "none", "depth"]);
//! assert!(matches!(rough.unwrap().verdict, Verdict::Computed { solver: "rough viscoelastic bed" }));
//! ```

use crate::input::table::InMemory;
use crate::run::record::Outcome;
use crate::run::{self, SimulationError, Wanted};
use crate::scene::plan::Plan;
use crate::text::{Notation, TextError};
use rayon::prelude::*;

/// A value of one of the parts of a scene.
#[derive(Debug, PartialEq, Eq)]
struct Choice {
    /// What it is called in the matrix.
    name: &'static str,
    /// How a scene writes it.
    text: &'static str,
}

const fn choice(name: &'static str, text: &'static str) -> Choice {
    Choice { name, text }
}

/// Shapes, with a depth and a force that suit them.
#[derive(Debug, PartialEq, Eq)]
struct PressedShape {
    shape: Choice,
    depth: &'static str,
    force: &'static str,
}

const SHAPES: [PressedShape; 6] = [
    PressedShape { shape: choice("ball", "Paraboloid(radius: 5e-3)"), depth: "1e-5", force: "5e-3" },
    PressedShape {
        shape: choice("wavy ball", "WavyParaboloid(radius: 2e-2, amplitude: 1e-8, wavelength: 1e-4)"),
        depth: "1e-5",
        force: "1e-2",
    },
    PressedShape {
        shape: choice("ellipsoid", "Ellipsoid(radius_x: 5e-3, radius_y: 2e-3)"),
        depth: "1e-5",
        force: "5e-3",
    },
    PressedShape {
        shape: choice(
            "rough line",
            "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-6, long: 1e-4, short: 2e-6), length: 1e-4, points: 512)",
        ),
        depth: "1e-6",
        force: "1e-4",
    },
    PressedShape {
        shape: choice("plane wave", "PlaneWave(amplitude: 1e-5, wavelength: 1e-4)"),
        depth: "1e-6",
        force: "20",
    },
    PressedShape {
        shape: choice(
            "plane section",
            "PlaneWavy(radius: 5e-3, waves: [(amplitude: 2e-7, wavelength: 8e-4)], datum: 1e-2)",
        ),
        depth: "1e-6",
        force: "500",
    },
];

const ELASTIC: &str = "Elastic(young: 2e6, poisson: 0.5)";
const RELAXING: &str = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, terms: [(modulus: 5e5, time: 0.1), (modulus: 2e5, time: 3)]))";
const OTHER: &str = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 2e6, time: 1)]))";

/// Bodies: the first, the second, and whether they relax.
#[derive(Debug, PartialEq, Eq)]
struct TwoBodies {
    name: &'static str,
    texts: [&'static str; 2],
    relaxes: bool,
}

const BODIES: [TwoBodies; 5] = [
    TwoBodies { name: "elastic", texts: [ELASTIC, "Rigid"], relaxes: false },
    TwoBodies { name: "both elastic", texts: [ELASTIC, ELASTIC], relaxes: false },
    TwoBodies { name: "viscoelastic", texts: [RELAXING, "Rigid"], relaxes: true },
    TwoBodies { name: "viscoelastic on elastic", texts: [RELAXING, ELASTIC], relaxes: true },
    TwoBodies { name: "two viscoelastic", texts: [RELAXING, OTHER], relaxes: true },
];

/// Adhesion, as elastic bodies and as those that relax write it; `None` where it is nothing of its own.
#[derive(Debug, PartialEq, Eq)]
struct Attracting {
    name: &'static str,
    elastic: Option<&'static str>,
    relaxing: Option<&'static str>,
}

const fn attracting(name: &'static str, elastic: Option<&'static str>, relaxing: Option<&'static str>) -> Attracting {
    Attracting { name, elastic, relaxing }
}

const MAUGIS: Option<&str> = Some("adhesion: Maugis(work: 0.02, stress: 2e4),");

const ADHESIONS: [Attracting; 6] = [
    attracting("none", Some(""), Some("")),
    attracting("JKR", Some("adhesion: Jkr(work: 0.02),"), Some("adhesion: Jkr(work: 0.02, edge: Relaxed),")),
    attracting("JKR, instantaneous", None, Some("adhesion: Jkr(work: 0.02, edge: Instantaneous),")),
    attracting("JKR, rate", None, Some("adhesion: Jkr(work: 0.02, edge: Rate(speed: 1e-4, exponent: 0.5)),")),
    attracting(
        "JKR, closing",
        Some("adhesion: Jkr(work: 0.02, closing: 0.01),"),
        Some("adhesion: Jkr(work: 0.02, closing: 0.01, edge: Relaxed),"),
    ),
    attracting("Maugis", MAUGIS, MAUGIS),
];

const FRICTIONS: [Choice; 4] = [
    choice("none", ""),
    choice("Coulomb", "friction: Coulomb(coefficient: 0.3),"),
    choice("capped", "friction: CoulombOrowan(coefficient: 0.3, shear_limit: 1e4),"),
    choice("pressure law", "friction: Pressure(shear: 1e4, slope: 0.1),"),
];

/// How a contact is led; a slide or a shake goes with it where there is friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Lead {
    Depth,
    Force,
    Sine,
    Rows,
    Retraction,
    Impact,
    Oblique,
}

const DRIVES: [(&str, Lead); 7] = [
    ("depth", Lead::Depth),
    ("force", Lead::Force),
    ("sine", Lead::Sine),
    ("table", Lead::Rows),
    ("retraction", Lead::Retraction),
    ("impact", Lead::Impact),
    ("oblique", Lead::Oblique),
];

/// Names of the drives, the columns of the matrix.
#[must_use]
pub fn drives() -> [&'static str; 7] {
    DRIVES.map(|(name, _)| name)
}

/// A combination: the number of its shape, bodies, adhesion, friction and drive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cell {
    at: [usize; 5],
    /// What becomes of it.
    pub verdict: Verdict,
}

/// What becomes of a combination.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    /// It is computed.
    Computed {
        /// By whom.
        solver: &'static str,
    },
    /// It is refused.
    Refused {
        /// Why.
        why: String,
    },
}

/// Every combination that can be written, in the order of its parts.
#[must_use]
pub fn cells() -> Vec<Cell> {
    let all: Vec<[usize; 5]> = (0..SHAPES.len())
        .flat_map(|shape| (0..BODIES.len()).map(move |bodies| [shape, bodies]))
        .flat_map(|[shape, bodies]| (0..ADHESIONS.len()).map(move |adhesion| [shape, bodies, adhesion]))
        .flat_map(|[s, b, a]| (0..FRICTIONS.len()).map(move |friction| [s, b, a, friction]))
        .flat_map(|[s, b, a, f]| (0..DRIVES.len()).map(move |drive| [s, b, a, f, drive]))
        .collect();
    all.into_par_iter().filter_map(cell).collect()
}

fn cell(at: [usize; 5]) -> Option<Cell> {
    let verdict = match plan(at)? {
        Ok(plan) => Verdict::Computed { solver: plan.parts().solver },
        Err(errors) => {
            let why = errors.first().map(|error| reason(&error.message)).unwrap_or_default();
            Verdict::Refused { why }
        }
    };
    Some(Cell { at, verdict })
}

/// A message without its place and its advice.
fn reason(message: &str) -> String {
    let place = message.split_once(": ").filter(|(place, _)| !place.contains(' '));
    let words = place.map_or(message, |(_, words)| words);
    let words = words.split(": expected ").next().unwrap_or(words);
    let words = words.split("; expected ").next().unwrap_or(words);
    // What is said of the place itself needs its name: the friction, an entry of the history.
    let part = place.map_or("", |(place, _)| place.split('[').next().unwrap_or(place));
    if words.starts_with("with ") || words.starts_with("cannot ") {
        format!("{part} {words}")
    } else {
        words.to_owned()
    }
}

/// The plan of a combination; `None` where it is no combination of its own.
fn plan([shape, bodies, adhesion, friction, drive]: [usize; 5]) -> Option<Result<Plan, Vec<TextError>>> {
    let (pressed, bodies, adhesion, lead) = (&SHAPES[shape], &BODIES[bodies], &ADHESIONS[adhesion], DRIVES[drive].1);
    let slides = friction > 0;
    let adhesion = if bodies.relaxes { adhesion.relaxing } else { adhesion.elastic }?;
    if (lead == Lead::Oblique && !slides) || (lead == Lead::Impact && slides) {
        return None;
    }
    let text = format!(
        "(shape: {}, bodies: ({}, {}), {adhesion} {} steps: 4, accuracy: 1e-3, history: [{}])",
        pressed.shape.text,
        bodies.texts[0],
        bodies.texts[1],
        FRICTIONS[friction].text,
        history(lead, pressed, slides)
    );
    Some(Notation::Ron.plan(&text, &rows(pressed, slides)))
}

fn history(lead: Lead, pressed: &PressedShape, slides: bool) -> String {
    let PressedShape { depth, force, .. } = pressed;
    let slide = if slides { "Slide(to: 1e-6, over: 1), " } else { "" };
    match lead {
        Lead::Depth => format!("Indent(to: {depth}, over: 1), {slide} Indent(to: 1e-8, over: 1)"),
        Lead::Force => format!("Press(to: {force}, over: 1), {slide} HoldForce(over: 1)"),
        Lead::Sine if slides => {
            format!("Indent(to: {depth}, over: 1), Shake(amplitude: 1e-7, frequency: 1, cycles: 1)")
        }
        Lead::Sine => format!("Indent(to: {depth}, over: 1), Oscillate(amplitude: 1e-8, frequency: 1, cycles: 1)"),
        Lead::Rows => "Table(\"rows.csv\")".to_owned(),
        Lead::Retraction => format!("Indent(to: {depth}, over: 1), {slide} Retract(speed: 1e-5)"),
        Lead::Impact => "Impact(mass: 1e-3, speed: 0.05)".to_owned(),
        Lead::Oblique => "Impact(mass: 1e-3, speed: 0.05, angle: \"30 deg\")".to_owned(),
    }
}

/// The table of a history: up, along where there is friction, and down.
fn rows(pressed: &PressedShape, slides: bool) -> InMemory {
    let depth: f64 = pressed.depth.parse().unwrap_or(0.0);
    let (times, depths) = ([0.0, 1.0, 2.0, 3.0], [0.0, depth, depth, 0.5 * depth]);
    let slide = [0.0, 0.0, 1e-7, 1e-7];
    let columns: [(&str, &[f64]); 3] = [("time_s", &times), ("indentation_m", &depths), ("slide_m", &slide)];
    InMemory::default().with("rows.csv", if slides { &columns[..] } else { &columns[..2] })
}

impl Cell {
    /// Shape, bodies, adhesion, friction and drive.
    #[must_use]
    pub fn names(&self) -> [&'static str; 5] {
        let [shape, bodies, adhesion, friction, drive] = self.at;
        [
            SHAPES[shape].shape.name,
            BODIES[bodies].name,
            ADHESIONS[adhesion].name,
            FRICTIONS[friction].name,
            DRIVES[drive].0,
        ]
    }

    /// Computes its scene; `None` where it is refused.
    ///
    /// # Errors
    /// It cannot be computed after all.
    pub fn outcome(&self) -> Option<Result<Outcome, SimulationError>> {
        let Ok(plan) = plan(self.at)? else { return None };
        Some(run::run(&plan, Wanted::NOTHING))
    }
}

/// The matrix as text: a row for each shape, bodies, adhesion and friction, a column for each drive; a letter stands for
/// the solver, a number for the reason of a refusal.
#[must_use]
pub fn in_words(cells: &[Cell]) -> String {
    let (mut solvers, mut reasons) = (Vec::new(), Vec::new());
    let mut lines = vec![format!("{:<66}{}", "", drives().map(|drive| format!("{drive:<11}")).concat())];
    for row in cells.chunk_by(|one, next| one.at[..4] == next.at[..4]) {
        let of = |drive: usize| row.iter().find(|cell| cell.at[4] == drive);
        let marks = std::array::from_fn::<_, 7, _>(|drive| of(drive).map(|cell| cell.mark(&mut solvers, &mut reasons)));
        let [shape, bodies, adhesion, friction, _] = row[0].names();
        let marks = marks.map(|mark| format!("{:<11}", mark.unwrap_or_else(|| "-".to_owned()))).concat();
        lines.push(format!("{shape:<15}{bodies:<25}{adhesion:<20}{friction:<14}{marks}").trim_end().to_owned());
    }
    let computed = cells.iter().filter(|cell| matches!(cell.verdict, Verdict::Computed { .. })).count();
    lines.push(format!("\n{computed} of {} combinations are computed", cells.len()));
    lines.extend(solvers.iter().enumerate().map(|(k, solver)| format!("{}  {solver}", letter(k))));
    lines.extend(reasons.iter().enumerate().map(|(k, why)| format!("{}  {why}", k + 1)));
    lines.join("\n")
}

/// A, B, C, …
fn letter(k: usize) -> char {
    u8::try_from(k).map_or('?', |k| char::from(b'A'.saturating_add(k)))
}

/// The place of an entry in a list, which gets it if it has not.
fn place<T: PartialEq>(list: &mut Vec<T>, entry: T) -> usize {
    list.iter().position(|known| *known == entry).unwrap_or_else(|| {
        list.push(entry);
        list.len() - 1
    })
}

impl Cell {
    fn mark(&self, solvers: &mut Vec<&'static str>, reasons: &mut Vec<String>) -> String {
        match &self.verdict {
            Verdict::Computed { solver } => letter(place(solvers, *solver)).to_string(),
            Verdict::Refused { why } => (place(reasons, why.clone()) + 1).to_string(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One scene per cell: what the matrix promises runs, its numbers are numbers, and it states an error.
    #[test]
    fn every_cell_that_is_promised_runs() {
        let wrong = |cell: &Cell| {
            let why = match cell.outcome()? {
                Err(error) => error.to_string(),
                Ok(outcome) => {
                    let finite = outcome.records.iter().all(|record| {
                        let normal = &record.normal;
                        let tangential = record.tangential.map_or(0.0, |state| state.force);
                        [normal.force, normal.stored.stored(), normal.dissipated, tangential]
                            .iter()
                            .all(|x| x.is_finite())
                    });
                    if finite && outcome.error_estimate.relative > 0.0 {
                        return None;
                    }
                    format!("{:?}", outcome.error_estimate)
                }
            };
            Some(format!("{:?}: {why}", cell.names()))
        };
        let failed: Vec<String> = cells().par_iter().filter_map(wrong).collect();
        assert!(failed.is_empty(), "{failed:#?}");
    }
}
