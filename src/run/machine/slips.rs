//! The slips of a contact that is drawn along, one by one.

use crate::drive::machine::{DrawnMoment, Turnover};
use crate::run::named::Named;
use crate::run::table::{Column, Table};
use crate::run::unit::Unit;

/// A slip of the contact as a whole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SlipEvent {
    /// When it begins [s].
    pub start: f64,
    /// Displacement of the mass then [m].
    from: f64,
    /// Force of friction just before [N].
    force: f64,
    /// When it ends [s], and the displacement then [m]; `None` of one that goes on.
    end: Option<(f64, f64)>,
    /// Greatest speed of the contact [m/s], if it is told.
    fastest: Option<f64>,
}

const COLUMNS: [Column<SlipEvent>; 6] = [
    Column::new("start_time", Unit::SECOND, "start of the slip", |slip| Some(slip.start)),
    Column::new("end_time", Unit::SECOND, "end of the slip", |slip| Some(slip.end?.0)),
    Column::new("slip_time", Unit::SECOND, "duration of the slip", SlipEvent::duration),
    Column::new("start_slide", Unit::METRE, "displacement before", |slip| Some(slip.from)),
    Column::new("jump", Unit::METRE, "jump", SlipEvent::jump),
    Column::new("static_force", Unit::NEWTON, "friction before", |slip| Some(slip.force)),
];

/// The column of contacts with rate and state.
const FASTEST: [Column<SlipEvent>; 1] =
    [Column::new("largest_slip_speed", Unit::METRE_PER_SECOND, "largest speed of slip", |slip| slip.fastest)];

impl SlipEvent {
    fn duration(&self) -> Option<f64> {
        Some(self.end?.0 - self.start)
    }

    fn jump(&self) -> Option<f64> {
        Some(self.end?.1 - self.from)
    }
}

/// Takes a change between stick and slip, `begin` [s] the beginning of the motion, into the list, with the speed [m/s] of a
/// contact with rate and state.
pub(super) fn note(slips: &mut Vec<SlipEvent>, begin: f64, (moment, speed): (&DrawnMoment, Option<f64>)) {
    let (time, slide) = (begin + moment.state.time, moment.state.slide);
    match (moment.what, slips.last_mut()) {
        (Turnover::Slips, _) => {
            slips.push(SlipEvent { start: time, from: slide, force: moment.force, end: None, fastest: None });
        }
        (Turnover::Sticks, Some(slip)) => slip.end = Some((time, slide)),
        // A slip that swings has more than one.
        (Turnover::Fastest, Some(slip)) => slip.fastest = slip.fastest.into_iter().chain(speed).reduce(f64::max),
        (Turnover::Sticks | Turnover::Fastest, None) => {}
    }
}

/// All of them, one row each.
pub(super) fn table(slips: &[SlipEvent]) -> Table {
    let table = Table::new("slips").with(&COLUMNS, slips.iter());
    let told = slips.iter().any(|slip| slip.fastest.is_some());
    if told { table.with(&FASTEST, slips.iter()) } else { table }
}

/// How many there are, and how long and far the last ended one goes, with the time from the one before.
pub(super) fn results(slips: &[SlipEvent]) -> Vec<Named> {
    let ended: Vec<&SlipEvent> = slips.iter().filter(|slip| slip.end.is_some()).collect();
    let last = ended.last();
    let period = match ended[..] {
        [.., one, last] => Some(last.start - one.start),
        _ => None,
    };
    let found = [
        ("first_slip_time", Unit::SECOND, slips.first().map(|slip| slip.start)),
        ("stick_slip_period", Unit::SECOND, period),
        ("slip_time", Unit::SECOND, last.and_then(|slip| slip.duration())),
        ("slip_jump", Unit::METRE, last.and_then(|slip| slip.jump())),
        ("largest_slip_speed", Unit::METRE_PER_SECOND, slips.iter().filter_map(|slip| slip.fastest).reduce(f64::max)),
    ];
    let numbers = found.into_iter().filter_map(|(name, unit, number)| Some(Named::number(name, unit, number?)));
    std::iter::once(Named::count("slips", slips.len())).chain(numbers).collect()
}
