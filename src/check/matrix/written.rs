//! The scenes of the combinations as they are written, with any numbers.
//!
//! # Examples
//! ```
//! use springbed::check::matrix::{Variation, cells};
//!
//! // Half as deep, ten times as slow, no adhesion to speak of.
//! let variation = Variation { depth: 0.5, time: 10.0, work: 1e-9, ..Variation::default() };
//! let kept = cells()[0].laws(&variation, 0.3);
//! assert!(kept.iter().all(|kept| kept.failure.is_none()), "{kept:?}");
//! ```

use super::choices::{ADHESIONS, BODIES, DRIVES, FINER_PIXELS, FRICTIONS, Lead, MAUGIS, RELAXING, SHAPES};
use super::led::{Leg, Row, Scales, history, machine, slid_at_last};
use super::variation::{Units, Variation};
use crate::input::table::InMemory;
use crate::scene::plan::Plan;
use crate::text::{Notation, TextError};

/// Relative error the scenes aim at.
pub(super) const ACCURACY: f64 = 1e-3;

/// A scene of a combination as it is written.
#[derive(Debug, Clone)]
pub(super) struct Written {
    pub(super) shape: String,
    pub(super) solver: &'static str,
    templates: [&'static str; 2],
    bodies: [String; 2],
    pub(super) adhesion: String,
    friction: String,
    machine: String,
    pub(super) history: Vec<Leg>,
    /// Records of an entry.
    steps: u32,
    accuracy: f64,
    units: Units,
    /// The unit of its force.
    pub(super) force: &'static str,
    on_pixels: bool,
    bridge: Option<String>,
}

/// The scene of a combination; `None` where it is no combination of its own.
pub(super) fn written(
    [shape, bodies, adhesion, friction, drive]: [usize; 5],
    variation: &Variation,
) -> Option<Written> {
    let (pressed, bodies, adhesion, lead) = (&SHAPES[shape], &BODIES[bodies], &ADHESIONS[adhesion], DRIVES[drive].1);
    let slides = friction > 0;
    let (adhesion, _) = if bodies.relaxes { adhesion.relaxing } else { adhesion.elastic }?;
    if (lead == Lead::Oblique && !slides) || (lead == Lead::Impact && slides) {
        return None;
    }
    let Variation { units, turns, series, .. } = variation;
    let scales = Scales::new(pressed, !adhesion.is_empty(), variation);
    let mut templates = bodies.texts;
    if lead == Lead::Glide {
        // What glides carries the shape, and the ground is the body that remembers.
        templates.reverse();
    }
    Some(Written {
        shape: units.fill(pressed.text),
        solver: pressed.solver,
        templates,
        bodies: templates.map(|text| body(text, series, units)),
        adhesion: attraction(adhesion, variation),
        friction: units.fill(FRICTIONS[friction].text),
        machine: machine(lead, &scales),
        history: if FRICTIONS[friction].name == "stuck" {
            slid_at_last(lead, &scales, turns)
        } else {
            history(lead, slides, &scales, turns)
        },
        steps: 4,
        accuracy: ACCURACY,
        units: *units,
        force: pressed.force_unit(),
        on_pixels: pressed.is_on_pixels(),
        bridge: adhesion.contains("Capillary").then(|| attraction(MAUGIS, variation)),
    })
}

/// A body with its series.
fn body(template: &str, series: &[String; 2], units: &Units) -> String {
    units.fill(&template.replace("{0}", &series[0]).replace("{1}", &series[1]))
}

/// An attraction with its numbers.
fn attraction(template: &str, variation: &Variation) -> String {
    let units = &variation.units;
    let work = 0.02 * variation.work;
    // Of a range w/σ₀.
    let stress = 2e4 * variation.stress;
    let tension = 0.5 * work;
    let values = [
        ("WORK", work * units.of("J/m2")),
        ("CLOSING", 0.5 * work * units.of("J/m2")),
        ("STRESS", stress * units.of("Pa")),
        ("RANGE", work / stress * units.of("m")),
        ("TENSION", tension * units.of("N/m")),
        ("KELVIN", tension / stress * units.of("m")),
        ("SPEED", 1e-4 * units.of("m/s")),
    ];
    values.iter().fold(template.to_owned(), |text, (name, value)| text.replace(name, &format!("{value:e}")))
}

impl Written {
    /// The scene as text.
    pub(super) fn text(&self) -> String {
        format!(
            "(shape: {}, bodies: ({}, {}), {} {} {} {} steps: {}, accuracy: {:e}, history: [{}])",
            self.shape,
            self.bodies[0],
            self.bodies[1],
            self.adhesion,
            self.friction,
            self.machine,
            self.solver,
            self.steps,
            self.accuracy,
            self.history.iter().map(Leg::text).collect::<Vec<_>>().join(", ")
        )
    }

    /// The scene as text with the rows of its table.
    pub(super) fn told(&self) -> String {
        let rows = self.history.iter().find_map(|leg| if let Leg::Rows(rows) = leg { Some(rows) } else { None });
        rows.map_or_else(|| self.text(), |rows| format!("{} with rows {rows:?}", self.text()))
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

    /// The same scene with every straight way cut in two, at the part `part` of its time; the first depth or force leads on
    /// from where it begins [m, N].
    pub(super) fn cut(&self, part: f64, [depth, force]: [f64; 2]) -> Self {
        let mut at = [("Indent", depth), ("Press", force), ("Slide", 0.0)];
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
                &Leg::Held { name, over } => {
                    legs.extend([part, 1.0 - part].map(|part| Leg::Held { name, over: part * over }));
                }
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
            leg @ (Leg::Ramp { .. } | Leg::Held { .. } | Leg::Whole(_)) => leg.clone(),
        });
        Self { history: history.collect(), steps, ..self }
    }

    /// The same scene with the bodies swapped.
    pub(super) fn swapped(&self) -> Self {
        let [one, other] = self.bodies.clone();
        Self { bodies: [other, one], ..self.clone() }
    }

    /// The same depths as a table, from `begin` [m] on; `None` where they are not all prescribed.
    pub(super) fn in_rows(&self, begin: f64) -> Option<Self> {
        let mut rows = vec![[0.0, begin, 0.0]];
        for leg in &self.history {
            let [time, depth, slide] = *rows.last()?;
            rows.push(match *leg {
                Leg::Ramp { name: "Indent", to, over } => [time + over, to, slide],
                Leg::Ramp { name: "Slide", to, over } => [time + over, depth, to],
                Leg::Held { name: "Hold", over } => [time + over, depth, slide],
                Leg::Ramp { .. } | Leg::Held { .. } | Leg::Rows(_) | Leg::Whole(_) => return None,
            });
        }
        Some(Self { history: vec![Leg::Rows(rows)], ..self.clone() })
    }

    /// The scene whose bodies have the weight `weight` in their Prony terms, and the elastic scene it has for a limit.
    pub(super) fn nearly_elastic(&self, weight: f64) -> [Self; 2] {
        let with = |text: &str| {
            self.templates.map(|old| RELAXING.iter().fold(old.to_owned(), |old, of| old.replace(of, text)))
        };
        let terms = format!("equilibrium: <1e6 Pa>, terms: [(modulus: <{:e} Pa>, time: <1 s>)]", 1e6 * weight);
        let filled = |bodies: [String; 2]| bodies.map(|text| self.units.fill(&text));
        let relaxing = filled(with(&format!("Viscoelastic(poisson: 0.5, shear: ({terms}))")));
        let relaxing = Self { bodies: relaxing, ..self.clone() };
        let bodies = filled(with("Elastic(young: <3e6 Pa>, poisson: 0.5)"));
        let adhesion = [", edge: Relaxed", ", edge: Instantaneous"];
        let adhesion = adhesion.iter().fold(self.adhesion.clone(), |text, edge| text.replace(edge, ""));
        [relaxing, Self { bodies, adhesion, ..self.clone() }]
    }

    /// The same scene at a finer accuracy, or on more pixels.
    pub(super) fn finer_solved(&self, accuracy: f64) -> Self {
        if self.on_pixels {
            return Self { solver: FINER_PIXELS, ..self.clone() };
        }
        Self { accuracy, ..self.clone() }
    }

    /// Whether it is solved on pixels.
    pub(super) fn is_on_pixels(&self) -> bool {
        self.on_pixels
    }

    /// The same scene with the attraction of the work and the stress of its bridge of liquid, if it has one.
    pub(super) fn as_maugis(&self) -> Option<Self> {
        Some(Self { adhesion: self.bridge.clone()?, bridge: None, ..self.clone() })
    }

    /// Whether a mass strikes.
    pub(super) fn strikes(&self) -> bool {
        self.history.iter().any(|leg| matches!(leg, Leg::Whole(text) if text.starts_with("Impact")))
    }

    /// Whether weight acts on a mass, which has units of its own.
    pub(super) fn falls(&self) -> bool {
        self.history.iter().any(|leg| matches!(leg, Leg::Whole(text) if text.starts_with("Fall")))
    }

    /// Whether a body moves along over a bed that may remember.
    pub(super) fn moves_along(&self) -> bool {
        let moves = |text: &str| text.starts_with("Glide") || text.starts_with("Roll");
        self.history.iter().any(|leg| matches!(leg, Leg::Whole(text) if moves(text)))
    }

    /// Whether something is worn off.
    pub(super) fn wears(&self) -> bool {
        self.friction.contains("wear")
    }

    /// Whether one of the bodies relaxes.
    pub(super) fn relaxes(&self) -> bool {
        self.bodies.iter().any(|body| body.contains("Viscoelastic"))
    }
}
