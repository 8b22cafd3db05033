//! The scenes of the combinations as they are written, with any numbers.
//!
//! # Examples
//! ```
//! use springbed::check::matrix::{Variation, cells};
//!
//! // Half as deep, ten times as slow, no adhesion to speak of.
//! let variation = Variation { depth: 0.5, time: 10.0, work: 1e-9 };
//! let kept = cells()[0].laws(&variation, 0.3);
//! assert!(kept.iter().all(|kept| kept.failure.is_none()), "{kept:?}");
//! ```

use super::choices::{ADHESIONS, BODIES, DRIVES, FRICTIONS, Lead, OTHER, PressedShape, RELAXING, SHAPES};
use crate::input::table::InMemory;
use crate::scene::plan::Plan;
use crate::text::{Notation, TextError};

/// Relative error the scenes aim at.
pub(super) const ACCURACY: f64 = 1e-3;

/// Other numbers than those of the matrix, as multiples of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variation {
    /// Of depths and forces.
    pub depth: f64,
    /// Of times.
    pub time: f64,
    /// Of works of adhesion.
    pub work: f64,
}

impl Default for Variation {
    fn default() -> Self {
        Self { depth: 1.0, time: 1.0, work: 1.0 }
    }
}

impl Variation {
    /// The variation with a number, and a part of a way at which to cut; neighbours in number are far apart (Weyl).
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "numbers of scenes are small")]
    pub fn numbered(number: u64) -> (Self, f64) {
        let part = |irrational: f64| (number as f64 * irrational).fract();
        let between = |low: f64, high: f64, irrational: f64| 10f64.powf(low + (high - low) * part(irrational));
        let variation = Self {
            depth: between(-1.0, 0.3, 2f64.sqrt()),
            time: between(-3.0, 3.0, 3f64.sqrt()),
            work: between(-2.0, 0.5, 5f64.sqrt()),
        };
        (variation, 0.05 + 0.9 * part(7f64.sqrt()))
    }
}

/// A row of a history in a table: time [s], depth and slide [m].
pub(super) type Row = [f64; 3];

/// An entry of a history.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Leg {
    /// A straight way of a depth [m], a force [N] or a slide [m] to `to` in `over` seconds.
    Ramp { name: &'static str, to: f64, over: f64 },
    /// A force held for so many seconds.
    Held(f64),
    /// A table of so many columns.
    Rows(Vec<Row>),
    /// An entry that is not cut.
    Whole(String),
}

/// A scene of a combination as it is written.
#[derive(Debug, Clone)]
pub(super) struct Written {
    pub(super) shape: &'static str,
    pub(super) bodies: [String; 2],
    pub(super) adhesion: String,
    pub(super) friction: &'static str,
    pub(super) history: Vec<Leg>,
    /// Records of an entry.
    pub(super) steps: u32,
}

/// The scene of a combination; `None` where it is no combination of its own.
pub(super) fn written(
    [shape, bodies, adhesion, friction, drive]: [usize; 5],
    variation: &Variation,
) -> Option<Written> {
    let (pressed, bodies, adhesion, lead) = (&SHAPES[shape], &BODIES[bodies], &ADHESIONS[adhesion], DRIVES[drive].1);
    let slides = friction > 0;
    let adhesion = if bodies.relaxes { adhesion.relaxing } else { adhesion.elastic }?;
    if (lead == Lead::Oblique && !slides) || (lead == Lead::Impact && slides) {
        return None;
    }
    let work = 0.02 * variation.work;
    Some(Written {
        shape: pressed.shape.text,
        bodies: bodies.texts.map(str::to_owned),
        adhesion: adhesion.replace("WORK", &format!("{work:e}")).replace("CLOSING", &format!("{:e}", 0.5 * work)),
        friction: FRICTIONS[friction].text,
        history: history(lead, pressed, slides, variation),
        steps: 4,
    })
}

fn history(lead: Lead, pressed: &PressedShape, slides: bool, variation: &Variation) -> Vec<Leg> {
    let (depth, force, over) = (variation.depth * pressed.depth, variation.depth * pressed.force, variation.time);
    let slide = slides.then_some(Leg::Ramp { name: "Slide", to: 1e-6 * variation.depth, over });
    let ramp = |name: &'static str, to: f64| Leg::Ramp { name, to, over };
    let (up, frequency) = (ramp("Indent", depth), 1.0 / over);
    let legs = |first: Leg, last: Leg| [Some(first), slide.clone(), Some(last)].into_iter().flatten().collect();
    match lead {
        Lead::Depth => legs(up, ramp("Indent", 1e-3 * depth)),
        Lead::Force => legs(ramp("Press", force), Leg::Held(over)),
        // Where the depth starts from is what the force has made of it.
        Lead::ForceThenDepth => legs(ramp("Press", force), Leg::Whole(ramp("Indent", 0.3 * depth).text())),
        Lead::Sine if slides => {
            let amplitude = 1e-7 * variation.depth;
            vec![up, Leg::Whole(format!("Shake(amplitude: {amplitude:e}, frequency: {frequency:e}, cycles: 1)"))]
        }
        Lead::Sine => {
            let amplitude = 1e-3 * depth;
            vec![up, Leg::Whole(format!("Oscillate(amplitude: {amplitude:e}, frequency: {frequency:e}, cycles: 1)"))]
        }
        Lead::Rows => vec![Leg::Rows(rows(depth, slides, variation))],
        Lead::Retraction => legs(up, Leg::Whole(format!("Retract(speed: {:e})", depth / over))),
        Lead::Impact => vec![Leg::Whole("Impact(mass: 1e-3, speed: 0.05)".to_owned())],
        Lead::Oblique => vec![Leg::Whole("Impact(mass: 1e-3, speed: 0.05, angle: \"30 deg\")".to_owned())],
    }
}

/// The table of a history: up, along where there is friction, and down.
fn rows(depth: f64, slides: bool, variation: &Variation) -> Vec<Row> {
    let slide = if slides { 1e-7 * variation.depth } else { 0.0 };
    let over = variation.time;
    vec![[0.0, 0.0, 0.0], [over, depth, 0.0], [2.0 * over, depth, slide], [3.0 * over, 0.5 * depth, slide]]
}

impl Leg {
    fn text(&self) -> String {
        match self {
            Self::Ramp { name, to, over } => format!("{name}(to: {to:e}, over: {over:e})"),
            Self::Held(over) => format!("HoldForce(over: {over:e})"),
            Self::Rows(_) => "Table(\"rows.csv\")".to_owned(),
            Self::Whole(text) => text.clone(),
        }
    }
}

impl Written {
    /// The scene as text.
    pub(super) fn text(&self) -> String {
        format!(
            "(shape: {}, bodies: ({}, {}), {} {} steps: {}, accuracy: {ACCURACY:e}, history: [{}])",
            self.shape,
            self.bodies[0],
            self.bodies[1],
            self.adhesion,
            self.friction,
            self.steps,
            self.history.iter().map(Leg::text).collect::<Vec<_>>().join(", ")
        )
    }

    /// The plan.
    pub(super) fn plan(&self) -> Result<Plan, Vec<TextError>> {
        Notation::Ron.plan(&self.text(), &self.tables())
    }

    fn tables(&self) -> InMemory {
        let rows = self.history.iter().find_map(|leg| if let Leg::Rows(rows) = leg { Some(rows) } else { None });
        let Some(rows) = rows else { return InMemory::default() };
        let column = |k: usize| rows.iter().map(|row| row[k]).collect::<Vec<_>>();
        let (times, depths, slides) = (column(0), column(1), column(2));
        let columns: [(&str, &[f64]); 3] = [("time_s", &times), ("indentation_m", &depths), ("slide_m", &slides)];
        InMemory::default().with("rows.csv", if self.friction.is_empty() { &columns[..2] } else { &columns[..] })
    }

    /// The same scene with every straight way cut in two, at the part `part` of its time.
    pub(super) fn cut(&self, part: f64) -> Self {
        let mut at = [("Indent", 0.0), ("Press", 0.0), ("Slide", 0.0)];
        let mut legs = Vec::new();
        for leg in &self.history {
            match leg {
                &Leg::Ramp { name, to, over } => {
                    let mut from = 0.0;
                    for entry in at.iter_mut().filter(|entry| entry.0 == name) {
                        from = std::mem::replace(&mut entry.1, to);
                    }
                    legs.push(Leg::Ramp { name, to: from + part * (to - from), over: part * over });
                    legs.push(Leg::Ramp { name, to, over: (1.0 - part) * over });
                }
                Leg::Held(over) => legs.extend([Leg::Held(part * over), Leg::Held((1.0 - part) * over)]),
                Leg::Rows(rows) => {
                    let between = |pair: &[Row]| {
                        let at = std::array::from_fn(|k| pair[0][k] + part * (pair[1][k] - pair[0][k]));
                        [at, pair[1]]
                    };
                    let more = rows.windows(2).flat_map(between);
                    legs.push(Leg::Rows(rows[..1].iter().copied().chain(more).collect()));
                }
                Leg::Whole(_) => legs.push(leg.clone()),
            }
        }
        Self { history: legs, ..self.clone() }
    }

    /// The same scene with so many records of every entry, or rows between those of its table.
    pub(super) fn finer(self, steps: u32) -> Self {
        let between = |rows: &[Row]| {
            let part = |k: u32| f64::from(k) / f64::from(steps);
            let at = |pair: &[Row], k: u32| std::array::from_fn(|c| pair[0][c] + part(k) * (pair[1][c] - pair[0][c]));
            let more = rows.windows(2).flat_map(|pair| (1..=steps).map(|k| at(pair, k)).collect::<Vec<_>>());
            rows[..1].iter().copied().chain(more).collect()
        };
        let history = self.history.iter().map(|leg| match leg {
            Leg::Rows(rows) => Leg::Rows(between(rows)),
            leg @ (Leg::Ramp { .. } | Leg::Held(_) | Leg::Whole(_)) => leg.clone(),
        });
        Self { history: history.collect(), steps, ..self }
    }

    /// The same scene with the bodies swapped.
    pub(super) fn swapped(&self) -> Self {
        let [one, other] = self.bodies.clone();
        Self { bodies: [other, one], ..self.clone() }
    }

    /// The same depths as a table; `None` where they are not all prescribed.
    pub(super) fn in_rows(&self) -> Option<Self> {
        let mut rows = vec![[0.0; 3]];
        for leg in &self.history {
            let &Leg::Ramp { name, to, over } = leg else { return None };
            let [time, depth, slide] = *rows.last()?;
            rows.push(match name {
                "Indent" => [time + over, to, slide],
                "Slide" => [time + over, depth, to],
                _ => return None,
            });
        }
        Some(Self { history: vec![Leg::Rows(rows)], ..self.clone() })
    }

    /// The scene whose bodies have the weight `weight` in their Prony terms, and the elastic scene it has for a limit.
    pub(super) fn nearly_elastic(&self, weight: f64) -> [Self; 2] {
        let with = |body: &str| self.bodies.each_ref().map(|text| text.replace(RELAXING, body).replace(OTHER, body));
        let terms = format!("equilibrium: 1e6, terms: [(modulus: {:e}, time: 1)]", 1e6 * weight);
        let relaxing = with(&format!("Viscoelastic(poisson: 0.5, shear: ({terms}))"));
        let relaxing = Self { bodies: relaxing, ..self.clone() };
        let bodies = with("Elastic(young: 3e6, poisson: 0.5)");
        let adhesion = [", edge: Relaxed", ", edge: Instantaneous"];
        let adhesion = adhesion.iter().fold(self.adhesion.clone(), |text, edge| text.replace(edge, ""));
        [relaxing, Self { bodies, adhesion, ..self.clone() }]
    }

    /// Whether a mass strikes.
    pub(super) fn strikes(&self) -> bool {
        self.history.iter().any(|leg| matches!(leg, Leg::Whole(text) if text.starts_with("Impact")))
    }

    /// Whether one of the bodies relaxes.
    pub(super) fn relaxes(&self) -> bool {
        self.bodies.iter().any(|body| body.contains("Viscoelastic"))
    }
}
