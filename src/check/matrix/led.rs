//! Histories of the combinations as they are written: those of the matrix, and drawn ones.

use super::choices::{Lead, PressedShape};
use super::variation::{Turn, Variation};

/// A row of a history in a table: time [s], depth and slide [m].
pub(super) type Row = [f64; 3];

/// An entry of a history.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Leg {
    /// A straight way of a depth [m], a force [N] or a slide [m] to `to` in `over` seconds.
    Ramp { name: &'static str, to: f64, over: f64 },
    /// A depth or a force held for so many seconds.
    Held { name: &'static str, over: f64 },
    /// A table of so many columns.
    Rows(Vec<Row>),
    /// An entry that is not cut.
    Whole(String),
}

impl Leg {
    pub(super) fn text(&self) -> String {
        match self {
            Self::Ramp { name, to, over } => format!("{name}(to: {to:e}, over: {over:e})"),
            Self::Held { name, over } => format!("{name}(over: {over:e})"),
            Self::Rows(_) => "Table(\"rows.csv\")".to_owned(),
            Self::Whole(text) => text.clone(),
        }
    }
}

/// The scales of a history [m, N, s].
#[derive(Debug, Clone, Copy)]
pub(super) struct Scales {
    depth: f64,
    force: f64,
    over: f64,
    /// The slide of a straight way, and the smaller one of a shake or a table.
    slides: [f64; 2],
    /// Unit of mass [kg] and of speed [m/s].
    mass: f64,
    speed: f64,
    pace: f64,
    /// Least part of the depth or force that is asked for: below zero bodies that adhere are pulled.
    least: f64,
}

impl Scales {
    pub(super) fn new(pressed: &PressedShape, adheres: bool, variation: &Variation) -> Self {
        let Variation { units, depth, time, pace, .. } = variation;
        Self {
            depth: depth * units.value(pressed.depth),
            force: depth * units.value(pressed.force),
            over: time * units.time,
            slides: [1e-6, 1e-7].map(|slide| slide * depth * units.length),
            // Under a section a mass is one per length, as its force is.
            mass: units.of(pressed.force_unit()) * units.time * units.time / units.length,
            speed: units.of("m/s"),
            pace: *pace,
            least: if adheres { -1.0 } else { 0.0 },
        }
    }
}

fn ramp(name: &'static str, to: f64, over: f64) -> Leg {
    Leg::Ramp { name, to, over }
}

/// The history of a lead; a slide goes with it where there is friction.
pub(super) fn history(lead: Lead, slides: bool, scales: &Scales, turns: &[Turn]) -> Vec<Leg> {
    let &Scales { depth, force, over, .. } = scales;
    let slide = slides.then_some(ramp("Slide", scales.slides[0], over));
    let legs = |first: Leg, last: Leg| [Some(first), slide.clone(), Some(last)].into_iter().flatten().collect();
    let up = || {
        let drawn = drawn(turns, slides, scales);
        if drawn.is_empty() { vec![ramp("Indent", depth, over)] } else { drawn }
    };
    let then = |text: String| up().into_iter().chain([Leg::Whole(text)]).collect();
    let pressed = |text: String| vec![ramp("Press", force, over), Leg::Whole(text)];
    match lead {
        Lead::Depth if turns.is_empty() => legs(ramp("Indent", depth, over), ramp("Indent", 1e-3 * depth, over)),
        Lead::Depth => drawn(turns, slides, scales),
        Lead::Force if turns.is_empty() => legs(ramp("Press", force, over), Leg::Held { name: "HoldForce", over }),
        Lead::Force => drawn_forces(turns, slides, scales),
        // Where the depth starts from is what the force has made of it.
        Lead::ForceThenDepth => {
            let down = turns.last().map_or(0.3, |turn| turn.level.max(scales.least));
            legs(ramp("Press", force, over), Leg::Whole(ramp("Indent", down * depth, over).text()))
        }
        Lead::Sine => then(wave(slides, scales)),
        Lead::Rows => vec![Leg::Rows(rows(turns, slides, scales))],
        Lead::Retraction => {
            let leaves = Leg::Whole(format!("Retract(speed: {:e})", scales.pace * depth / over));
            legs(ramp("Indent", depth, over), leaves)
        }
        Lead::Impact | Lead::Oblique => {
            let angle = if lead == Lead::Oblique { ", angle: \"30 deg\"" } else { "" };
            // A faster one presses a wave flat.
            let (mass, speed) = (1e-3 * scales.mass, 0.05 * scales.pace.min(1.0) * scales.speed);
            vec![Leg::Whole(format!("Impact(mass: {mass:e}, speed: {speed:e}{angle})"))]
        }
        Lead::Glide => pressed(format!("Glide(speed: {:e})", 1e2 * scales.pace * depth / over)),
        Lead::Roll => pressed(format!("Roll(speed: {:e}, over: {over:e})", 1e2 * depth / over)),
        Lead::Traction => pressed(format!("Roll(speed: {:e}, creepage: 1e-3)", 1e2 * depth / over)),
        Lead::Drive => pressed(format!("Drive(speed: {:e}, over: {over:e})", 15.0 * depth / over)),
        Lead::Ring => pressed(format!("Ring(amplitude: {:e}, over: {over:e})", 1e-2 * scales.pace * depth)),
        Lead::Fall => {
            let (height, over) = (1e-4 * scales.pace, 0.02);
            vec![Leg::Whole(format!("Fall(height: {height:e}, over: {over:e})"))]
        }
    }
}

/// The history of a contact that is not to be moved while it is sheared: a slide behind the rest, short of where it gives way.
pub(super) fn slid_at_last(lead: Lead, scales: &Scales, turns: &[Turn]) -> Vec<Leg> {
    let slide = matches!(lead, Lead::Depth | Lead::Force | Lead::ForceThenDepth | Lead::Sine);
    let slide = slide.then(|| ramp("Slide", scales.slides[1], scales.over));
    history(lead, false, scales, turns).into_iter().chain(slide).collect()
}

/// A shake along the surface, or an oscillation of the depth.
fn wave(slides: bool, scales: &Scales) -> String {
    let frequency = scales.pace / scales.over;
    if slides {
        format!("Shake(amplitude: {:e}, frequency: {frequency:e}, cycles: 1)", scales.slides[1])
    } else {
        format!("Oscillate(amplitude: {:e}, frequency: {frequency:e}, cycles: 1)", 1e-3 * scales.depth)
    }
}

/// Depths up and down, with holds and slides.
fn drawn(turns: &[Turn], slides: bool, scales: &Scales) -> Vec<Leg> {
    let legs = turns.iter().flat_map(|turn| {
        let over = turn.over * scales.over;
        let to = scales.depth * turn.level.max(scales.least);
        let hold = turn.hold.map(|hold| Leg::Held { name: "Hold", over: hold * scales.over });
        let slide = slides.then(|| ramp("Slide", turn.slide * scales.slides[0], over));
        [Some(ramp("Indent", to, over)), hold, slide].into_iter().flatten()
    });
    legs.collect()
}

/// Forces up and down, with holds and slides.
fn drawn_forces(turns: &[Turn], slides: bool, scales: &Scales) -> Vec<Leg> {
    let legs = turns.iter().flat_map(|turn| {
        let over = turn.over * scales.over;
        let to = scales.force * turn.level.max(0.1 * scales.least);
        let hold = turn.hold.map(|hold| Leg::Held { name: "HoldForce", over: hold * scales.over });
        let slide = slides.then(|| ramp("Slide", turn.slide * scales.slides[0], over));
        [Some(ramp("Press", to, over)), hold, slide].into_iter().flatten()
    });
    legs.collect()
}

/// The table of a history: up, along where there is friction, and down; or what is drawn.
fn rows(turns: &[Turn], slides: bool, scales: &Scales) -> Vec<Row> {
    let &Scales { depth, over, slides: [far, near], .. } = scales;
    if turns.is_empty() {
        let slide = if slides { near } else { 0.0 };
        return vec![[0.0; 3], [over, depth, 0.0], [2.0 * over, depth, slide], [3.0 * over, 0.5 * depth, slide]];
    }
    let mut rows = vec![[0.0; 3]];
    for turn in turns {
        let [time, ..] = rows[rows.len() - 1];
        let (level, slide) = (depth * turn.level.max(scales.least), if slides { turn.slide * far } else { 0.0 });
        rows.push([time + turn.over * over, level, slide]);
    }
    rows
}

/// The machine of a lead, if it has one.
pub(super) fn machine(lead: Lead, scales: &Scales) -> String {
    let &Scales { depth, force, over, .. } = scales;
    let (time, stiffness) = (over / 30.0, force / depth);
    match lead {
        Lead::Drive => {
            let (mass, drawn) = (stiffness * time * time, 0.1 * stiffness);
            let damping = 0.3 * drawn * time;
            format!("machine: (mass: {mass:e}, stiffness: {drawn:e}, damping: {damping:e}),")
        }
        Lead::Ring => format!("machine: (mass: {:e}),", stiffness * time * time),
        Lead::Fall => format!("machine: (mass: {:e}),", 1e-2 * force),
        Lead::Depth
        | Lead::Force
        | Lead::ForceThenDepth
        | Lead::Sine
        | Lead::Rows
        | Lead::Retraction
        | Lead::Impact
        | Lead::Oblique
        | Lead::Glide
        | Lead::Roll
        | Lead::Traction => String::new(),
    }
}
