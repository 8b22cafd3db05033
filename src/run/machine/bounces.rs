//! The bounces of a mass that has fallen, one by one.

use crate::drive::machine::MassState;
use crate::run::table::{Column, Table};
use crate::run::unit::Unit;

/// A bounce.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bounce {
    /// When the bodies touch [s].
    touch: f64,
    /// Speed then [m/s].
    speed: f64,
    /// When they part [s], and the speed then [m/s]; `None` of a mass that stays.
    end: Option<(f64, f64)>,
    depth: f64,
    force: f64,
}

const COLUMNS: [Column<Bounce>; 8] = [
    Column::new("touch_time", Unit::SECOND, "time of touch", |bounce| Some(bounce.touch)),
    Column::new("part_time", Unit::SECOND, "time of parting", |bounce| Some(bounce.end?.0)),
    Column::new("contact_time", Unit::SECOND, "contact time", |bounce| Some(bounce.end?.0 - bounce.touch)),
    Column::new("speed", Unit::METRE_PER_SECOND, "speed v", |bounce| Some(bounce.speed)),
    Column::new("rebound_speed", Unit::METRE_PER_SECOND, "speed of rebound", |bounce| Some(bounce.end?.1)),
    Column::new("restitution", Unit::ONE, "restitution e", |bounce| Some(bounce.end?.1 / bounce.speed)),
    Column::new("greatest_depth", Unit::METRE, "greatest depth", |bounce| Some(bounce.depth)),
    Column::new("largest_force", Unit::NEWTON, "largest force", |bounce| Some(bounce.force)),
];

impl Bounce {
    pub(super) fn new(begin: f64, state: &MassState) -> Self {
        Self { touch: begin + state.time, speed: state.speed, end: None, depth: 0.0, force: 0.0 }
    }

    pub(super) fn ends(&mut self, begin: f64, state: &MassState) {
        self.end = Some((begin + state.time, -state.speed));
    }

    pub(super) fn turns(&mut self, state: &MassState, force: f64) {
        (self.depth, self.force) = (self.depth.max(state.depth), self.force.max(force));
    }
}

/// All of them, one row each.
pub(super) fn table(bounces: &[Bounce]) -> Table {
    Table::new("bounces").with(&COLUMNS, bounces.iter())
}
