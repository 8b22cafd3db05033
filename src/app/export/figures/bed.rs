//! The bed of springs at an instant, and what its springs carry.

use crate::app::export::with_prefix;
use crate::app::figure::{Area, Axis, Guide, Hue, Line, Panel, Series, Shade};
use crate::run::bed::ROWS_PER_SPRING;
use crate::run::record::{Outcome, Record};
use crate::run::table::{Content, Table};

/// Turns of a spring as it is drawn.
const TURNS: usize = 6;
/// Half the width of a spring over the distance to the next.
const HALF_WIDTH: f64 = 0.34;
/// Parts of its length at which a spring is straight.
const STRAIGHT: f64 = 0.1;
/// Half the width of the picture over that of the bed in it.
const ASIDE: f64 = 1.025;
/// Part of a displacement by which rounding may part a spring from the profile that it touches.
const ROUNDING: f64 = 1e-9;

/// The springs and their loads, at every instant of the table.
pub fn panels(outcome: &Outcome) -> Vec<Panel> {
    let Some(table) = outcome.table("bed") else { return Vec::new() };
    let beds = beds(table).unwrap_or_default();
    let room = Room::of(&beds);
    let of_bed = |bed: &Bed| {
        let record = bed.record(outcome);
        let loads = bed.carries().then(|| bed.loads(&room, record));
        std::iter::once(bed.springs(&room, record)).chain(loads)
    };
    beds.iter().flat_map(of_bed).collect()
}

/// A place of the bed.
#[derive(Clone, Copy)]
struct Place {
    x: f64,
    profile: Option<f64>,
    displacement: f64,
    load: f64,
}

/// One instant of the table: places from the middle outwards.
struct Bed {
    label: String,
    time: f64,
    places: Vec<Place>,
}

/// How a spring is held.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Hold {
    Pressed,
    Pulled,
    LetGo,
    Untouched,
}

/// The instants of a table.
fn beds(table: &Table) -> Option<Vec<Bed>> {
    let Content::Words(labels) = &table.column("instant")?.cells else { return None };
    let numbers = |quantity| Some(table.column(quantity)?.numbers());
    let (times, xs, profiles) = (numbers("time")?, numbers("place")?, numbers("profile")?);
    let (displacements, loads) = (numbers("displacement")?, numbers("force_per_length")?);
    let mut beds: Vec<Bed> = Vec::new();
    for (k, label) in labels.iter().enumerate() {
        if beds.last().is_none_or(|bed| bed.label != *label) {
            beds.push(Bed { label: label.clone(), time: times[k]?, places: Vec::new() });
        }
        let place = Place { x: xs[k]?, profile: profiles[k], displacement: displacements[k]?, load: loads[k]? };
        beds.last_mut()?.places.push(place);
    }
    Some(beds)
}

/// The room of a picture: the same at all instants.
struct Room {
    /// Half its width [m].
    reach: f64,
    /// Length of a spring at rest [m].
    length: f64,
    /// Height over the undisturbed springs [m].
    top: f64,
}

impl Room {
    /// A spring at rest is twice as long as the largest displacement.
    fn of(beds: &[Bed]) -> Self {
        let places = || beds.iter().flat_map(|bed| &bed.places);
        let most = |of: fn(&Place) -> f64| places().map(of).fold(0.0, f64::max);
        let (pressed, pulled) = (most(|place| place.displacement), most(|place| -place.displacement));
        let length = (2.0 * pressed).max(1.5 * pulled);
        let lifted = beds.iter().filter_map(|bed| bed.places.first()?.profile).fold(0.0, f64::max);
        let top = (0.55 * length).max(1.25 * pulled).max((1.3 * lifted).min(length));
        Self { reach: ASIDE * most(|place| place.x), length, top }
    }

    fn across(&self) -> Axis {
        Axis::linear("place x", "m").from(-self.reach).to(self.reach)
    }
}

/// What is given from the middle outwards, on both sides from left to right.
fn mirrored(right: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let left = right.iter().rev().filter(|(x, _)| *x > 0.0).map(|&(x, y)| (-x, y));
    left.chain(right.iter().copied()).collect()
}

impl Place {
    /// How the spring at the place is held: in contact it ends at the profile.
    fn hold(&self) -> Hold {
        let apart = |profile: f64| (self.displacement + profile).abs() > ROUNDING * self.displacement.abs();
        if self.displacement.abs() <= 0.0 && self.load.abs() <= 0.0 {
            Hold::Untouched
        } else if self.profile.is_none_or(apart) {
            Hold::LetGo
        } else if self.load < 0.0 {
            Hold::Pulled
        } else {
            Hold::Pressed
        }
    }
}

impl Bed {
    /// The record of the instant: the one of the greatest force, or the last.
    fn record<'o>(&self, outcome: &'o Outcome) -> Option<&'o Record> {
        let mut there = outcome.records.iter().filter(|record| (record.time - self.time).abs() <= 0.0);
        if self.label == "end" {
            return there.next_back();
        }
        there.max_by(|one, other| one.normal.force.total_cmp(&other.normal.force))
    }

    /// Places of the springs that are drawn.
    fn drawn(&self) -> impl Iterator<Item = &Place> {
        self.places.iter().step_by(ROWS_PER_SPRING)
    }

    /// Whether any spring carries a load.
    fn carries(&self) -> bool {
        self.places.iter().any(|place| place.load.abs() > 0.0)
    }

    /// From one spring to the next [m].
    fn spacing(&self) -> f64 {
        self.places.get(ROWS_PER_SPRING).map_or(0.0, |place| place.x)
    }

    fn title(&self) -> String {
        format!("{}, t = {}", self.label, written(self.time, "s"))
    }

    /// The profile pressed into the springs.
    fn springs(&self, room: &Room, record: Option<&Record>) -> Panel {
        let base = -room.length;
        let height = Axis::linear("height z", "m").from(base * 1.12).to(room.top);
        let panel = Panel::new(room.across(), height).titled(self.title());
        let ground = vec![(-room.reach, 1.2 * base), (-room.reach, base), (room.reach, base), (room.reach, 1.2 * base)];
        let panel = panel.filled(Area { outline: ground, shade: Shade::Dark });
        let panel = self.indenter(panel, room);
        let holds = [Hold::Untouched, Hold::LetGo, Hold::Pressed, Hold::Pulled];
        let panel = holds.into_iter().fold(panel, |panel, hold| match self.coils(hold, base) {
            points if points.is_empty() => panel,
            points => panel.with(look(hold, points)),
        });
        let panel = panel.guide(Guide::horizontal(0.0, "undisturbed"));
        match record {
            Some(record) => marked(panel, record).note(self.told(record)),
            None => panel,
        }
    }

    /// The equivalent profile as a body above its line.
    fn indenter(&self, panel: Panel, room: &Room) -> Panel {
        let mut right: Vec<(f64, f64)> =
            self.places.iter().filter_map(|place| Some((place.x, place.profile?))).collect();
        let ends = self.places.iter().any(|place| place.profile.is_none());
        let wall = right.last().filter(|_| ends).map(|&(end, z)| (end, z.max(2.0 * room.top)));
        right.extend(wall);
        let line = Series::new("equivalent profile g(x) − d", mirrored(&right)).colour(Hue::Black).line(Line::Solid);
        right.extend(right.last().map(|&(end, _)| (end, 2.0 * room.top)));
        let outline = mirrored(&right);
        panel.filled(Area { outline, shade: Shade::Light }).with(line)
    }

    /// The springs that are held so, from the base up, one after the other.
    fn coils(&self, hold: Hold, base: f64) -> Vec<Option<(f64, f64)>> {
        let half = HALF_WIDTH * self.spacing();
        let held = self.drawn().filter(|place| place.hold() == hold);
        let both = held.flat_map(|place| [(place.x > 0.0).then_some(-place.x), Some(place.x)].map(|x| (x, place)));
        let coil = |(x, place): (Option<f64>, &Place)| {
            let turns = x.map(|x| coil(x, (base, -place.displacement), half));
            turns.into_iter().flatten().map(Some).chain([None]).collect::<Vec<_>>()
        };
        both.filter(|(x, _)| x.is_some()).flat_map(coil).collect()
    }

    fn told(&self, record: &Record) -> String {
        let of = |name: &str, value: Option<f64>| value.map(|value| format!("{name} = {}", written(value, "m")));
        let depth = of("d", record.normal.indentation);
        let edge = of("a", record.normal.contact_radius.filter(|&a| a > 0.0));
        let known: Vec<String> = depth.into_iter().chain(edge).collect();
        let arrow = record.normal.indentation.filter(|d| d.abs() > 0.0).map_or("", |_| " Arrow: d.");
        format!("{}.{arrow} Each spring stands for {} of the bed.", known.join(", "), self.stands_for(record))
    }

    /// The length of the bed that a spring stands for, in parts of the contact radius if it is one.
    fn stands_for(&self, record: &Record) -> String {
        let parts = record.normal.contact_radius.map_or(0.0, |a| a / self.spacing());
        if parts > 0.5 && (parts - parts.round()).abs() < 1e-6 {
            return format!("a/{parts:.0}");
        }
        written(self.spacing(), "m")
    }

    /// The force per length of the springs: what lies under the curve is the force.
    fn loads(&self, room: &Room, record: Option<&Record>) -> Panel {
        let edge = record.and_then(|record| record.normal.contact_radius).unwrap_or(0.0);
        let mut right: Vec<(f64, f64)> = Vec::new();
        for place in &self.places {
            if right.last().is_some_and(|last| last.0 <= edge && place.x > edge) {
                right.push((right[right.len() - 1].0, 0.0));
            }
            right.push((place.x, place.load));
        }
        let outline = mirrored(&right);
        let stem = |place: &Place| {
            let both = [-place.x, place.x].map(|x| [Some((x, place.load)), Some((x, 0.0)), None]);
            both.into_iter().flatten()
        };
        let stems: Vec<Option<(f64, f64)>> =
            self.drawn().filter(|place| place.load.abs() > 0.0).flat_map(stem).collect();
        let panel = Panel::new(room.across(), Axis::linear("force per length q", "N/m"))
            .titled(self.title())
            .filled(Area { outline: outline.clone(), shade: Shade::Medium })
            .with(Series::new("", outline).colour(Hue::Blue))
            .with(Series::new(" ", stems).colour(Hue::Black).line(Line::Solid).fine());
        let Some(record) = record else { return panel };
        let force = written(record.normal.force, "N");
        let pulls = self.places.iter().any(|place| place.hold() == Hold::Pulled);
        let told = if pulls { " Below zero the springs are pulled." } else { "" };
        edges(panel, record).note(format!("∫q dx = F = {force}.{told}"))
    }
}

/// How springs that are held so look: those never touched are dotted.
fn look(hold: Hold, points: Vec<Option<(f64, f64)>>) -> Series {
    let (label, hue, line) = match hold {
        Hold::Pressed => ("springs pressed", Hue::Blue, Line::Solid),
        Hold::Pulled => ("springs pulled", Hue::Vermillion, Line::Solid),
        Hold::LetGo => ("springs let go", Hue::Purple, Line::Solid),
        Hold::Untouched => ("springs not touched", Hue::Grey, Line::Dotted),
    };
    Series::new(label, points).colour(hue).line(line).fine()
}

/// A spring at the place `x` between two heights.
fn coil(x: f64, (base, top): (f64, f64), half: f64) -> Vec<(f64, f64)> {
    let at = |part: f64| base + part * (top - base);
    let corners = 2 * TURNS;
    let turn = |k: usize| {
        let part = STRAIGHT + (1.0 - 2.0 * STRAIGHT) * (k as f64 + 0.5) / corners as f64;
        (x + if k.is_multiple_of(2) { half } else { -half }, at(part))
    };
    let ends = [(x, at(0.0)), (x, at(STRAIGHT))];
    let turns = (0..corners).map(turn);
    ends.into_iter().chain(turns).chain([(x, at(1.0 - STRAIGHT)), (x, at(1.0))]).collect()
}

/// A number as it stands in print.
fn written(value: f64, unit: &str) -> String {
    with_prefix(value, unit).replace('-', "−")
}

/// The depth as an arrow and the edge as lines.
fn marked(panel: Panel, record: &Record) -> Panel {
    let depth = record.normal.indentation.filter(|d| d.abs() > 0.0);
    let panel = match depth {
        Some(d) => panel.guide(Guide::Jump { from: (0.0, 0.0), to: (0.0, -d) }),
        None => panel,
    };
    edges(panel, record)
}

/// Both edges of the contact.
fn edges(panel: Panel, record: &Record) -> Panel {
    match record.normal.contact_radius.filter(|&a| a > 0.0) {
        Some(a) => panel.guide(Guide::vertical(-a, "")).guide(Guide::vertical(a, "a")),
        None => panel,
    }
}
