//! Bodies that roll steadily with traction: their traction curves, and what is named of them.

use super::SimulationError;
use super::gliding::last_of;
use super::named::Named;
use super::record::{ErrorEstimate, Record};
use super::table::{Column, Table};
use super::unit::Unit;
use crate::friction::rolling::{CreepLaw, RollingContact, RollingPlace, kalker};
use crate::scene::plan::RoundPlan;
use crate::scene::tractive::{Prescribed, RollingBody, TractiveRolling};

/// A body that rolls, at all that is prescribed of it.
#[derive(Debug, Clone)]
pub struct Rolled {
    body: RollingBody,
    contact: RollingContact,
    speed: f64,
    law: CreepLaw,
    /// The curve with Kalker's coefficient, of a ball within his table.
    exact: Option<CreepLaw>,
    states: Vec<RollingState>,
}

/// Steady rolling at one creepage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingState {
    /// Creepage ξ.
    pub creepage: f64,
    /// Tangential force T [N].
    pub traction: f64,
    /// Part of what friction can hold, T/(μP), up to 1.
    pub share: f64,
    /// Tangential over normal force T/P.
    pub coefficient: f64,
    /// Width of the stick zone [m] in the direction of rolling; of a ball that of its bed.
    pub stick_width: f64,
    /// Power that slip takes Tξv [W].
    pub power: f64,
    /// Tangential force [N] by Kalker's coefficient.
    pub exact: Option<f64>,
}

const COLUMNS: [Column<RollingState>; 6] = [
    Column::new("creepage", Unit::ONE, "creepage ξ", |state| Some(state.creepage)),
    Column::new("tangential_force", Unit::NEWTON, "tangential force T", |state| Some(state.traction)),
    Column::new("traction_coefficient", Unit::ONE, "traction coefficient T/P", |state| Some(state.coefficient)),
    Column::new("friction_share", Unit::ONE, "share of friction T/μP", |state| Some(state.share)),
    Column::new("stick_width", Unit::METRE, "width of stick", |state| Some(state.stick_width)),
    Column::new("friction_power", Unit::WATT, "power of slip", |state| Some(state.power)),
];

const KALKER: Column<RollingState> =
    Column::new("kalker_tangential_force", Unit::NEWTON, "tangential force T", |state| state.exact);

/// A place of the contact at a creepage.
type Placed = (f64, RollingPlace);

const PLACES: [Column<Placed>; 2] = [
    Column::new("creepage", Unit::ONE, "creepage ξ", |(creepage, _)| Some(*creepage)),
    Column::new("place", Unit::METRE, "place, rolling to the right", |(_, at)| Some(at.place)),
];

const OF_CYLINDER: [Column<Placed>; 4] = [
    Column::new("pressure", Unit::PASCAL, "pressure p", |(_, at)| Some(at.normal)),
    Column::new("shear_stress", Unit::PASCAL, "shear stress τ", |(_, at)| Some(at.tangential)),
    SLIP,
    Column::new("heat_flux", Unit::WATT_PER_SQUARE_METRE, "heat of slip", |(_, at)| Some(at.tangential * at.slip)),
];

const OF_BALL: [Column<Placed>; 3] = [
    Column::new("line_load", Unit::NEWTON_PER_METRE, "line load of the bed", |(_, at)| Some(at.normal)),
    Column::new("tangential_line_load", Unit::NEWTON_PER_METRE, "tangential line load of the bed", |(_, at)| {
        Some(at.tangential)
    }),
    SLIP,
];

const SLIP: Column<Placed> =
    Column::new("slip_speed", Unit::METRE_PER_SECOND, "speed of slip", |(_, at)| Some(at.slip));

/// The steady rolling with which a history ends, if it does.
///
/// # Errors
/// The bodies are not in contact, or a traction is more than friction can hold.
pub fn steady(plan: &RoundPlan, records: &[Record]) -> Result<Option<Rolled>, SimulationError> {
    let Some(rolling) = &plan.rolling else { return Ok(None) };
    let refused = |what: String| SimulationError::Refused(format!("history[{}]: {what}", rolling.entry));
    let held = last_of(records, rolling.entry).map(|record| record.normal);
    let pressed = held.filter(|state| state.force > 0.0);
    let (Some(force), Some(half_width)) =
        (pressed.map(|state| state.force), pressed.and_then(|state| state.contact_radius))
    else {
        return Err(refused(
            "the bodies are not in contact: expected an Indent or Press into contact before".to_owned(),
        ));
    };
    let contact = RollingContact { grip: rolling.grip, radius: rolling.body.radius(), half_width, force };
    Rolled::new(rolling, contact).map(Some).map_err(refused)
}

impl Rolled {
    fn new(rolling: &TractiveRolling, contact: RollingContact) -> Result<Self, String> {
        let law = rolling.body.law(&contact);
        let exact = match rolling.body {
            RollingBody::Cylinder { .. } => None,
            RollingBody::Ball { .. } => kalker::law(&contact),
        };
        let beyond = |traction: f64| {
            format!(
                "a traction of {traction:?} N is more than friction holds, μP = {:?} N: expected less, or a creepage",
                law.limit
            )
        };
        let creepages = match &rolling.asked {
            Prescribed::Creepages(creepages) => creepages.clone(),
            Prescribed::Tractions(tractions) => {
                let creepage = |&traction: &f64| law.creepage(traction).ok_or_else(|| beyond(traction));
                tractions.iter().map(creepage).collect::<Result<_, _>>()?
            }
        };
        let mut rolled = Self { body: rolling.body, contact, speed: rolling.speed, law, exact, states: Vec::new() };
        rolled.states = creepages.into_iter().map(|creepage| rolled.at(creepage)).collect();
        Ok(rolled)
    }

    fn at(&self, creepage: f64) -> RollingState {
        let (traction, contact) = (self.law.traction(creepage), &self.contact);
        RollingState {
            creepage,
            traction,
            share: if self.law.limit > 0.0 { traction.abs() / self.law.limit } else { 1.0 },
            coefficient: traction / contact.force,
            stick_width: 2.0 * contact.half_width * (1.0 - self.law.slipping(creepage)),
            power: traction * creepage * self.speed,
            exact: self.exact.map(|law| law.traction(creepage)),
        }
    }

    /// The traction curve, one row per value prescribed.
    fn curve(&self) -> Table {
        let table = Table::new("tractions").with(&COLUMNS, self.states.iter());
        if self.exact.is_some() { table.with(&[KALKER], self.states.iter()) } else { table }
    }

    /// What the places of the contact carry, creepage by creepage.
    fn places(&self) -> Table {
        let of = |state: &RollingState| {
            let creepage = state.creepage;
            let places = self.body.profile(&self.contact, creepage, self.speed);
            places.into_iter().map(move |place| (creepage, place))
        };
        let rows: Vec<Placed> = self.states.iter().flat_map(of).collect();
        let table = Table::new("rolling").with(&PLACES, rows.iter());
        match self.body {
            RollingBody::Cylinder { .. } => table.with(&OF_CYLINDER, rows.iter()),
            RollingBody::Ball { .. } => table.with(&OF_BALL, rows.iter()),
        }
    }

    /// The traction curve, and the contact at each of its points.
    #[must_use]
    pub fn tables(&self) -> Vec<Table> {
        vec![self.curve(), self.places()]
    }

    /// The named results: the curve's own numbers, and the state where there is one.
    #[must_use]
    pub fn results(&self) -> Vec<Named> {
        let of_curve = [
            ("largest_traction", Unit::NEWTON, Some(self.law.limit)),
            ("full_slip_creepage", Unit::ONE, Some(self.law.full_slip)),
            ("creep_stiffness", Unit::NEWTON, Some(self.law.stiffness())),
            ("kalker_creep_stiffness", Unit::NEWTON, self.exact.map(|law| law.stiffness())),
        ];
        let known = of_curve.into_iter().filter_map(|(name, unit, number)| {
            Some(Named::number(name, unit, number.filter(|number| number.is_finite())?))
        });
        let [state] = self.states.as_slice() else { return known.collect() };
        known.chain(COLUMNS.iter().chain([&KALKER]).filter_map(|column| column.named(state))).collect()
    }

    /// Relative error of the creep stiffness of a ball's bed.
    fn deficit(&self) -> Option<f64> {
        let exact = self.exact?.stiffness();
        let deficit = 1.0 - self.law.stiffness() / exact;
        deficit.is_finite().then_some(deficit)
    }

    /// What a bed says of a ball that creeps.
    #[must_use]
    pub fn remark(&self) -> Option<String> {
        let RollingBody::Ball { .. } = self.body else { return None };
        let bed = "the creep of a ball is that of one line of springs along its way, not of strips, and springs do not feel the traction of each other; stresses below the surface are those of the pressure alone";
        let (_, poisson) = kalker::together(&self.contact.grip);
        let own = kalker::longitudinal_of_bed(&self.contact.grip);
        Some(match (kalker::longitudinal(poisson), self.deficit()) {
            (Some(exact), Some(deficit)) => format!(
                "{bed}: its creep coefficient is {own:.2}, {:.0} % below Kalker's C11 = {exact:.2} (a/b = 1, ν = {poisson:.2}), and its limit μP is right; kalker_… is the cube of the same form with Kalker's C11 (Shen, Hedrick & Elkins 1983)",
                100.0 * deficit
            ),
            _ => format!("{bed}: its creep coefficient is {own:.2}, some half of the exact one; its limit μP is right"),
        })
    }

    /// The estimate, unless the creep is known less well.
    #[must_use]
    pub fn at_least(&self, estimate: ErrorEstimate) -> ErrorEstimate {
        match self.deficit() {
            Some(relative) if relative > estimate.relative => ErrorEstimate {
                relative,
                basis: "tangential force of a ball that creeps little: the bed against Kalker's coefficient C11"
                    .to_owned(),
            },
            _ => estimate,
        }
    }
}
