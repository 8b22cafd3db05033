//! Steps of a contact that adheres: where it jumps is looked for between records, until what is lost is known.

use super::super::ledger::{Entry, Ledger, Open, Stand};
use super::super::pixels::Past;
use super::super::pressed::Pressed;
use super::super::state::State;
use super::{Depth, Goal, Series};
use crate::contact::adhesion::equilibrium::Control;
use crate::halfspace::Prescribed;
use crate::run::SimulationError;

/// Most times a step is halved, as it may reach far beyond the range of what attracts, and fewest around what seems a jump.
const MOST_HALVINGS: u32 = 24;
/// Most of a step in which bodies are torn apart, by far less, it may be, than the force that is asked for.
const MOST_TEARINGS: u32 = 48;
const LEAST_HALVINGS: u32 = 3;
/// Part of the accuracy asked for that a jump may leave open of the energies, and the least that pixels tell.
const LEFT_OPEN: f64 = 0.1;
const LEAST_OPEN: f64 = 1e-4;
/// Part of the force that tears bodies apart to which it is found.
const TORN: f64 = 1e-5;
/// Part of what the trapezoid misses over a step below which what it misses over half of it is smooth.
const SMOOTH: f64 = 0.25;
/// Multiple of what a jump may leave open that a step may which is taken for smooth.
const SHORT: f64 = 8.0;

/// A step, or a part of it.
#[derive(Clone, Copy)]
struct Part<'s> {
    goal: Goal,
    /// The contact where it begins, unless that is at a record.
    start: Option<&'s Pressed>,
    /// Whether it ends where the step does.
    is_last: bool,
    halvings: u32,
    /// What the trapezoid missed over both halves, if it is one and no jump is seen in them [J].
    missed: f64,
}

/// The contact at the end of a step, and what it leaves to the next.
#[derive(Clone)]
struct Reached {
    pressed: Option<Pressed>,
    past: Past,
}

impl Goal {
    /// Both halves of the step.
    fn halves(self) -> [Self; 2] {
        let (middle, over) = (0.5 * (self.from + self.value), 0.5 * self.over);
        [Self { value: middle, over, time: self.time - over, ..self }, Self { from: middle, over, ..self }]
    }

    /// Gives a state the last digits of what is prescribed.
    pub(super) fn round(self, state: &mut State) {
        match self.control {
            Control::Indentation => state.normal.indentation = Some(self.value),
            Control::Force if state.parted => {}
            Control::Force => state.normal.force = self.value,
        }
    }
}

impl Series<'_> {
    pub(super) fn prescribed(&self, goal: Goal) -> Prescribed {
        match goal.control {
            Control::Indentation => Prescribed::Indentation(self.pressing.touch + goal.value),
            Control::Force => Prescribed::Force(goal.value),
        }
    }

    /// The contact at the end of a step; `None` where the force pulls more than the bodies do.
    pub(super) fn led(&mut self, goal: Goal) -> Result<Option<Pressed>, SimulationError> {
        self.part(Part { goal, start: None, is_last: true, halvings: 0, missed: 0.0 }, None)
    }

    /// A step that leaves more open than is asked for is gone in two, for a jump in it loses what the force does between
    /// where it was and where it is found.
    fn part(&mut self, part: Part<'_>, known: Option<Reached>) -> Result<Option<Pressed>, SimulationError> {
        let is_known = self.pixels.knows_losses() && part.goal.control == Control::Indentation;
        let before = (self.seeks() && !is_known).then(|| (self.pixels.past(), self.ledger));
        let pressed = self.reach(part.goal, known)?;
        self.least = pressed.as_ref().map_or(self.least, |pressed| self.least.min(pressed.force()));
        if self.pixels.attraction().is_none() {
            return Ok(pressed);
        }
        let apart = || Stand::Apart(self.pixels.accounted_apart());
        let stand = pressed.as_ref().map_or_else(apart, |pressed| Stand::Together(self.entry(pressed)));
        if is_known {
            self.ledger.stands(stand);
            return Ok(pressed);
        }
        let from = (part.goal.control == Control::Indentation).then_some(part.goal.from);
        let Open { open, missing } = self.ledger.step(stand, from);
        let Some(before) = before else { return Ok(pressed) };
        let lost = before.1.lost();
        let limit = (LEFT_OPEN * self.plan.accuracy()).max(LEAST_OPEN);
        // Over half of a smooth step the trapezoid misses an eighth; beside a long one a small jump would not be seen.
        let is_short = !self.ledger.counts(open, SHORT * limit);
        let is_smooth = is_short && missing <= open && missing.abs() < SMOOTH * part.missed;
        // Slopes before and in a step may agree by chance.
        let is_seen_once =
            missing.abs() > open && part.halvings < LEAST_HALVINGS && self.ledger.counts(missing.abs(), limit);
        // The force that tears the bodies apart lies between the last they held and this one.
        let step = (part.goal.value - part.goal.from).abs();
        let is_torn = pressed.is_none() && before.1.is_together() && step > TORN * part.goal.value.abs();
        let is_open = is_seen_once || is_torn || self.ledger.counts(open, limit) && !is_smooth;
        let most = if is_torn { MOST_TEARINGS } else { MOST_HALVINGS };
        if is_open && part.halvings < most {
            let (end, after) = (Reached { pressed: pressed.clone(), past: self.pixels.past() }, self.ledger);
            let (told, known) = (self.jumps.len(), self.pixels.keeps_its_branch().then(|| end.clone()));
            self.go_back(before);
            // What a jump loses is nothing that the trapezoid misses.
            let missed = if missing > open { 0.0 } else { missing.abs() };
            if let Ok(pressed) = self.in_two(Part { missed, ..part }, known) {
                return Ok(pressed);
            }
            // Nearest to a jump pixels may not settle: then the step is known as far as it was before.
            self.jumps.truncate(told);
            self.go_back((end.past, after));
        }
        if self.ledger.counts(self.ledger.lost() - lost, limit) {
            self.jumped(part, pressed.as_ref(), lost)?;
        }
        Ok(pressed)
    }

    /// The contact at the end of a step, where it is not known already.
    fn reach(&mut self, goal: Goal, known: Option<Reached>) -> Result<Option<Pressed>, SimulationError> {
        if let Some(Reached { pressed, past }) = known {
            self.pixels.go_back(past);
            return Ok(pressed);
        }
        let advanced = self.pixels.advance(self.prescribed(goal), (goal.over, goal.slide));
        advanced.map_err(|error| self.refused(goal.entry, &error))
    }

    /// Whether jumps are looked for between records.
    fn seeks(&self) -> bool {
        self.depth != Depth::Outline && self.pixels.attraction().is_some()
    }

    fn go_back(&mut self, (past, ledger): (Past, Ledger)) {
        self.pixels.go_back(past);
        self.ledger = ledger;
    }

    fn in_two(&mut self, part: Part<'_>, known: Option<Reached>) -> Result<Option<Pressed>, SimulationError> {
        let [one, two] = part.goal.halves();
        let halvings = part.halvings + 1;
        let middle = self.part(Part { goal: one, is_last: false, halvings, ..part }, None)?;
        self.part(Part { goal: two, start: middle.as_ref(), halvings, ..part }, known)
    }

    /// Keeps the contact on both sides of a jump that is not told by records.
    fn jumped(&mut self, part: Part<'_>, end: Option<&Pressed>, lost: f64) -> Result<(), SimulationError> {
        if !matches!(self.depth, Depth::Whole { told: true, .. }) || self.rubbing.is_some() {
            return Ok(());
        }
        let goal = part.goal;
        let start = Goal { value: goal.from, time: goal.time - goal.over, ..goal };
        let end = end.filter(|_| !part.is_last);
        for (goal, pressed, lost) in [(start, part.start, lost), (goal, end, self.ledger.lost())] {
            if let Some(pressed) = pressed {
                let mut state = self.told(goal.entry, pressed, lost)?;
                goal.round(&mut state);
                self.jumps.push((goal.entry, goal.time, state));
            }
        }
        Ok(())
    }

    /// What the ledger is told of a contact.
    fn entry(&self, pressed: &Pressed) -> Entry {
        let depth = pressed.contact.indentation - self.pressing.touch;
        Entry { force: pressed.force(), depth, accounted: pressed.stored.stored() + pressed.dissipated }
    }
}
