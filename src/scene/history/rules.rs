//! Which histories can be followed, whatever the shape.

use super::{Driven, Entry, Impact, Motion};
use crate::friction::StrengthCurve;
use crate::input::problem::Problem;

/// What the other parts of the scene allow.
#[derive(Debug, Clone, Copy)]
pub struct Allowed {
    /// The name of the friction law, if there is one.
    pub friction: Option<&'static str>,
    /// What relaxes, if one of the bodies does.
    pub relaxing: Option<&'static str>,
    /// The name of the model of adhesion, if there is one.
    pub adhesion: Option<&'static str>,
    /// Records per entry, if the scene says how many.
    pub steps: Option<usize>,
}

/// Most records of a scene: beyond it the outputs alone would fill the memory.
const MOST_RECORDS: usize = 10_000_000;
/// Records per cycle of an oscillation, at most.
const PER_CYCLE: f64 = 64.0;

/// What is wrong with a history; `motions` holds the tables of its entries.
#[must_use]
pub fn problems(history: &[Entry], motions: &[Option<Motion>], allowed: Allowed) -> Vec<Problem> {
    if history.is_empty() {
        return vec![Problem::new(
            "history",
            "is empty: expected at least one entry such as Indent(to: \"1 um\", over: \"1 s\")",
        )];
    }
    let mut found = Vec::new();
    for (index, (entry, motion)) in history.iter().zip(motions).enumerate() {
        let at = format!("history[{index}]");
        found.extend(tangential(entry, motion.as_ref(), allowed, &at));
        found.extend(curved(entry, motion.as_ref(), allowed, &at));
        found.extend(pulled(entry, motion.as_ref(), allowed, &at));
        found.extend(of_impact(entry, (&at, history.len()), allowed));
        found.extend(nothing_to_part(history, index, allowed));
    }
    found.extend(too_many_records(history, motions, allowed.steps));
    found.extend(endless(history));
    found
}

fn name(entry: &Entry) -> &'static str {
    match entry {
        Entry::Indent(_) => "Indent",
        Entry::Press(_) => "Press",
        Entry::Hold(_) => "Hold",
        Entry::HoldForce(_) => "HoldForce",
        Entry::Slide(_) => "Slide",
        Entry::Oscillate(_) => "Oscillate",
        Entry::Shake(_) => "Shake",
        Entry::Retract(_) => "Retract",
        Entry::Impact(_) => "Impact",
        Entry::Table(_) => "Table with slide_m",
    }
}

/// Sliding needs a law of friction, and shaking one with sticking.
fn tangential(entry: &Entry, motion: Option<&Motion>, allowed: Allowed, at: &str) -> Option<Problem> {
    let slides = match entry {
        Entry::Slide(_) | Entry::Shake(_) => true,
        Entry::Impact(impact) => impact.is_oblique(),
        _ => motion.is_some_and(|motion| motion.slide.is_some()),
    };
    let name = if matches!(entry, Entry::Impact(_)) { "Impact with an angle or spin" } else { name(entry) };
    match allowed.friction {
        _ if !slides => None,
        None => Some(Problem::new(
            at,
            format!("{name} needs friction: expected a friction such as Coulomb(coefficient: 0.3)"),
        )),
        Some("Coulomb") => None,
        Some(law) if matches!(entry, Entry::Slide(_)) && law != "Coulomb" => None,
        Some(law) => Some(Problem::new(
            at,
            format!(
                "{name} with friction {law} cannot be computed, for {law} is a law of gross sliding: expected Coulomb(coefficient: …) or Slide(…)"
            ),
        )),
    }
}

/// Friction of bodies that relax is exact where depth and slide are straight in time.
fn curved(entry: &Entry, motion: Option<&Motion>, allowed: Allowed, at: &str) -> Option<Problem> {
    let (law, body) = allowed.friction.filter(|law| *law == "Coulomb").zip(allowed.relaxing)?;
    let driven = motion.map(|motion| &motion.control);
    let name = match (entry, driven) {
        (Entry::Press(_) | Entry::HoldForce(_) | Entry::Oscillate(_) | Entry::Shake(_), _) => name(entry),
        (Entry::Table(_), Some(Driven::Force(_))) => "Table with force_n",
        _ => return None,
    };
    Some(Problem::new(
        at,
        format!(
            "{name} with {law} friction of a {body} body cannot be computed, for depth or slide is a curve in time: expected Indent, Hold, Slide, Retract or a Table with indentation_m"
        ),
    ))
}

/// Every `Slide` must go at a speed the table of the shear strength holds.
#[must_use]
pub fn sliding_speeds(history: &[Entry], curve: &StrengthCurve) -> Vec<Problem> {
    let mut at = 0.0;
    let mut wrong = |(index, entry): (usize, &Entry)| {
        let Entry::Slide(slide) = entry else { return None };
        let way = (slide.to.si() - at).abs();
        at = slide.to.si();
        let error = curve.at(way / slide.over.si()).err().filter(|_| way > 0.0)?;
        Some(Problem::new(format!("history[{index}]"), error.to_string()))
    };
    history.iter().enumerate().filter_map(&mut wrong).collect()
}

/// A pull needs adhesion.
fn pulled(entry: &Entry, motion: Option<&Motion>, allowed: Allowed, at: &str) -> Option<Problem> {
    if allowed.adhesion.is_some() {
        return None;
    }
    let right = "without adhesion bodies cannot be pulled: expected a force of zero or above";
    match (entry, motion.map(|motion| &motion.control)) {
        (Entry::Press(press), _) if press.to.si() < 0.0 => {
            Some(Problem::new(format!("{at}.to"), format!("{:?} N is a pull, and {right}", press.to.si())))
        }
        (Entry::Table(path), Some(Driven::Force(force))) => {
            let (force, row) = force.iter().zip(&motion?.rows).find(|(force, _)| **force < 0.0)?;
            Some(Problem::new(at, format!("{}, row {row}: force_n: {force:?} is a pull, and {right}", path.display())))
        }
        _ => None,
    }
}

impl Impact {
    /// Angle of incidence from the normal [rad].
    #[must_use]
    pub fn incidence(&self) -> f64 {
        self.angle.map_or(0.0, |angle| angle.si())
    }

    /// Whether it has an angle or a spin.
    #[must_use]
    pub fn is_oblique(&self) -> bool {
        self.angle.is_some_and(|angle| angle.si() > 0.0) || self.spin.is_some_and(|spin| spin.si().abs() > 0.0)
    }
}

fn of_impact(entry: &Entry, (at, entries): (&str, usize), allowed: Allowed) -> Vec<Problem> {
    let Entry::Impact(impact) = entry else { return Vec::new() };
    let mut found = Vec::new();
    if entries > 1 {
        found.push(Problem::new(
            at,
            format!("Impact stands beside {} other entries: expected it alone in the history", entries - 1),
        ));
    }
    if impact.speed.is_empty() {
        found.push(Problem::new(
            format!("{at}.speed"),
            "is an empty list: expected at least one speed such as \"1 m/s\"",
        ));
    }
    if let (true, Some(model)) = (impact.is_oblique(), allowed.adhesion) {
        found.push(Problem::new(
            at,
            format!(
                "an oblique Impact with {model} adhesion cannot be computed: expected no adhesion, or no angle and spin"
            ),
        ));
    }
    found
}

/// A retraction needs bodies in contact.
fn nothing_to_part(history: &[Entry], index: usize, allowed: Allowed) -> Option<Problem> {
    let Entry::Retract(_) = history[index] else { return None };
    let before = index.checked_sub(1).map(|index| &history[index]);
    let why = match before {
        None if allowed.adhesion.is_none() => "the bodies only touch at the start",
        Some(Entry::Retract(_)) => "the entry before has parted the bodies",
        _ => return None,
    };
    Some(Problem::new(format!("history[{index}]"), format!("{why}: expected an Indent or Press before Retract")))
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a saturating cast is meant")]
fn records(entry: &Entry, motion: Option<&Motion>, steps: Option<usize>) -> usize {
    match (entry, motion) {
        (Entry::Oscillate(wave) | Entry::Shake(wave), _) => {
            let turns = (2.0 * wave.cycles.si()) as usize;
            steps.map_or((PER_CYCLE * wave.cycles.si()) as usize, |steps| steps.saturating_add(turns))
        }
        (Entry::Table(_), Some(motion)) => motion.time.len(),
        _ => steps.unwrap_or(1),
    }
}

fn too_many_records(history: &[Entry], motions: &[Option<Motion>], steps: Option<usize>) -> Option<Problem> {
    let mut sum = 0usize;
    for (index, (entry, motion)) in history.iter().zip(motions).enumerate() {
        sum = sum.saturating_add(records(entry, motion.as_ref(), steps));
        if sum > MOST_RECORDS {
            let path = if steps.is_some() { "steps".to_owned() } else { format!("history[{index}]") };
            return Some(Problem::new(
                path,
                format!(
                    "the history would have more than {MOST_RECORDS} records: expected fewer steps, cycles or entries"
                ),
            ));
        }
    }
    None
}

/// The duration of a history must be a number.
fn endless(history: &[Entry]) -> Option<Problem> {
    let over = |entry: &Entry| match entry {
        Entry::Indent(ramp) => ramp.over.si(),
        Entry::Press(ramp) => ramp.over.si(),
        Entry::Slide(ramp) => ramp.over.si(),
        Entry::Hold(hold) | Entry::HoldForce(hold) => hold.over.si(),
        Entry::Oscillate(wave) | Entry::Shake(wave) => wave.cycles.si() / wave.frequency.si(),
        Entry::Retract(_) | Entry::Impact(_) | Entry::Table(_) => 0.0,
    };
    let mut time = 0.0;
    let index = history.iter().position(|entry| {
        time += over(entry);
        f64::is_infinite(time)
    })?;
    Some(Problem::new(
        format!("history[{index}]"),
        "ends at a time too large to compute with: expected shorter entries",
    ))
}
