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
}

const COLUMNS: [Column<SlipEvent>; 6] = [
    Column::new("start_time", Unit::SECOND, "start of the slip", |slip| Some(slip.start)),
    Column::new("end_time", Unit::SECOND, "end of the slip", |slip| Some(slip.end?.0)),
    Column::new("slip_time", Unit::SECOND, "duration of the slip", SlipEvent::duration),
    Column::new("start_slide", Unit::METRE, "displacement before", |slip| Some(slip.from)),
    Column::new("jump", Unit::METRE, "jump", SlipEvent::jump),
    Column::new("static_force", Unit::NEWTON, "friction before", |slip| Some(slip.force)),
];

impl SlipEvent {
    fn duration(&self) -> Option<f64> {
        Some(self.end?.0 - self.start)
    }

    fn jump(&self) -> Option<f64> {
        Some(self.end?.1 - self.from)
    }
}

/// Takes a change between stick and slip, `begin` [s] the beginning of the motion, into the list.
pub(super) fn note(slips: &mut Vec<SlipEvent>, begin: f64, moment: &DrawnMoment) {
    let (time, slide) = (begin + moment.state.time, moment.state.slide);
    match (moment.what, slips.last_mut()) {
        (Turnover::Slips, _) => slips.push(SlipEvent { start: time, from: slide, force: moment.force, end: None }),
        (Turnover::Sticks, Some(slip)) => slip.end = Some((time, slide)),
        (Turnover::Sticks, None) => {}
    }
}

/// All of them, one row each.
pub(super) fn table(slips: &[SlipEvent]) -> Table {
    Table::new("slips").with(&COLUMNS, slips.iter())
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
    ];
    let numbers = found.into_iter().filter_map(|(name, unit, number)| Some(Named::number(name, unit, number?)));
    std::iter::once(Named::count("slips", slips.len())).chain(numbers).collect()
}
