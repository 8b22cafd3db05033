//! What happens on a straight piece of the depth: the force turns, the bodies touch or part.

use super::force::ahead;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Glance, Parting};
use crate::numerics::extremum;
use std::collections::VecDeque;

/// Something that happens at an instant of a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NotableInstant {
    /// Time since the beginning of the piece [s].
    pub time: f64,
    /// The last time before it [s], where the state changes suddenly.
    pub just_before: Option<f64>,
    /// Whether the bodies touch from then on, where that changes.
    pub touching: Option<bool>,
}

/// A look at the contact at a time since the beginning of the piece [s].
#[derive(Debug, Clone, Copy)]
struct Glimpse {
    time: f64,
    seen: Glance,
}

impl Glimpse {
    fn joined(&self) -> bool {
        self.seen.contact_radius > 0.0
    }
}

/// Relative change of the force below which a turn is rounding.
const NOISE: f64 = 1e-12;
/// What happens before this part of a look is the beginning, where there is a record already; a turn behind all but this part
/// of a pull is its end.
const BEGINNING: f64 = 1e-12;
/// Parts of a time, and multiples of a doubt, within which a parting may lie from where it was found.
const NEAR: [(f64, f64); 4] = [(1e-15, 1.0), (1e-13, 8.0), (1e-10, 64.0), (1e-7, 512.0)];
/// Part of what is left of the way behind a turn at which the search for the next one begins.
const BESIDE: f64 = 1e-6;
/// Most turns of the force before bodies part.
const MOST_TURNS: usize = 4;
/// Looks at the pull before bodies part, each half as far from there as the last and, in the first half, each twice as far
/// from the beginning, and how often a look beyond is drawn back half the way to where they still touch.
const FIRST_LOOKS: i32 = 6;
const LAST_LOOKS: i32 = 32;
const HALVINGS: u32 = 40;
/// Looks at equal distances in a whole entry.
const EVEN: i32 = 24;
/// Looks per decade towards the beginning of a piece, where the fast elements relax.
const PER_DECADE: i32 = 2;

/// The last time [s] between two at which all is as at the first of them, and the first at which it is not: to rounding, or
/// as near as the contact that says when that is (`known`) can tell.
///
/// # Errors
/// The contact cannot be looked at.
pub fn last_of(
    mut as_before: impl FnMut(f64) -> Result<bool, ContactError>,
    (mut low, mut high): (f64, f64),
    known: Option<Parting>,
) -> Result<(f64, f64), ContactError> {
    let (time, doubt) = known.map_or((0.0, 0.0), |parting| (parting.time, parting.doubt));
    for apart in known.iter().flat_map(|_| NEAR.map(|(part, times)| part * time + times * doubt)) {
        for time in [time - apart, time + apart] {
            if low < time && time < high {
                *(if as_before(time)? { &mut low } else { &mut high }) = time;
            }
        }
        if high - low <= 4.0 * apart {
            break;
        }
    }
    while high - low > 4.0 * doubt && low < 0.5 * (low + high) && 0.5 * (low + high) < high {
        let middle = 0.5 * (low + high);
        *(if as_before(middle)? { &mut low } else { &mut high }) = middle;
    }
    Ok((low, high))
}

/// Times at which a piece is looked at, whatever the records; `fastest` is the shortest time of the material [s].
pub fn looks(duration: f64, fastest: f64) -> Vec<f64> {
    let first = (0.1 * fastest / duration).clamp(1e-18, 1.0);
    let decades = (1..).map(|k| 10f64.powf(-f64::from(k) / f64::from(PER_DECADE))).take_while(|&part| part >= first);
    let mut parts: Vec<f64> = decades.filter(|&part| part < 1.0 / f64::from(EVEN)).collect();
    parts.reverse();
    parts.extend((1..EVEN).map(|k| f64::from(k) / f64::from(EVEN)));
    // A pull may turn just before the bodies part.
    parts.extend((3..=12).map(|k| 1.0 - 10f64.powf(-0.5 * f64::from(k))));
    parts.push(1.0);
    parts.into_iter().map(|part| part * duration).collect()
}

/// A watch over a piece, walked from look to look: at each of them the next two intervals are known.
#[derive(Debug, Clone)]
pub struct Watch {
    speed: f64,
    /// Looks to come [s].
    times: VecDeque<f64>,
    /// Where the contact is, and the looks ahead of it that have been made.
    seen: VecDeque<Glimpse>,
    found: VecDeque<NotableInstant>,
}

impl Watch {
    /// A watch over the piece at the speed `speed` [m/s] that begins here, looked at at `times` [s].
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn new(contact: &mut dyn ContactModel, speed: f64, times: Vec<f64>) -> Result<Self, ContactError> {
        let mut watch = Self { speed, times: times.into(), seen: VecDeque::new(), found: VecDeque::new() };
        let state = contact.state();
        let here = Glance { force: state.force, contact_radius: state.contact_radius.unwrap_or(0.0) };
        watch.seen.push_back(Glimpse { time: 0.0, seen: here });
        watch.look_ahead(contact)?;
        watch.search(contact)?;
        Ok(watch)
    }

    /// The time [s] of the next look at which the contact has to stop; `None` where nothing is left to be found from there.
    pub fn next_stop(&self) -> Option<f64> {
        let next = self.seen.get(1)?;
        // The next three looks are searched already: beyond them bodies would have to touch or part.
        let is_searched = self.times.is_empty() && self.seen.get(2).is_none_or(|last| last.joined() == next.joined());
        (!is_searched).then_some(next.time)
    }

    /// The contact has come to the next stop.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn stop(&mut self, contact: &mut dyn ContactModel) -> Result<(), ContactError> {
        self.seen.pop_front();
        self.look_ahead(contact)?;
        self.search(contact)
    }

    /// The next instant not after `time` [s].
    pub fn take_until(&mut self, time: f64) -> Option<NotableInstant> {
        if self.found.front()?.time <= time { self.found.pop_front() } else { None }
    }

    /// The contact at the first look ahead.
    pub fn first_ahead(&self) -> Option<Glance> {
        self.seen.get(1).map(|glimpse| glimpse.seen)
    }

    /// Adds the beginning of the piece to what happens on it.
    pub fn note_beginning(&mut self) {
        self.found.push_front(NotableInstant { time: 0.0, just_before: None, touching: None });
    }

    /// Looks two intervals ahead.
    fn look_ahead(&mut self, contact: &mut dyn ContactModel) -> Result<(), ContactError> {
        while self.seen.len() < 3
            && let Some(time) = self.times.pop_front()
        {
            let glimpse = Glimpse { time, seen: self.see(contact, time)? };
            self.seen.push_back(glimpse);
        }
        Ok(())
    }

    /// The contact at the time `time` [s] of the piece.
    fn see(&self, contact: &mut dyn ContactModel, time: f64) -> Result<Glance, ContactError> {
        let now = self.seen.front().map_or(0.0, |glimpse| glimpse.time);
        contact.look(&ahead(contact, self.speed, time - now))
    }

    fn search(&mut self, contact: &mut dyn ContactModel) -> Result<(), ContactError> {
        let Some(next) = self.seen.get(1).copied() else { return Ok(()) };
        let here = self.seen[0];
        if here.joined() != next.joined()
            && let Some(edge) = self.edge_of_contact(contact, here, next)?
        {
            let end = edge.just_before.unwrap_or(edge.time);
            self.find_turns_before_parting(contact, here, end)?;
            self.found.push_back(edge);
        }
        if let Some(last) = self.seen.get(2).copied()
            && here.joined()
            && next.joined()
        {
            if last.joined() {
                self.found.extend(self.turn(contact, [here, next, last])?);
            } else {
                let end = self.still_joined(contact, next, last)?;
                self.find_turns_before_parting(contact, here, end)?;
            }
        }
        self.found.make_contiguous().sort_by(|one, other| one.time.total_cmp(&other.time));
        Ok(())
    }

    /// A time [s] between a look at bodies that touch and one at bodies that do not at which they still do, roughly the
    /// last.
    fn still_joined(
        &self,
        contact: &mut dyn ContactModel,
        joined: Glimpse,
        apart: Glimpse,
    ) -> Result<f64, ContactError> {
        let mut time = apart.time;
        for _ in 0..HALVINGS {
            time = 0.5 * (joined.time + time);
            if self.see(contact, time)?.contact_radius > 0.0 {
                return Ok(time);
            }
        }
        Ok(joined.time)
    }

    /// Finds the turns of the force between the look `here` and the last time `end` [s] at which the bodies still touch.
    fn find_turns_before_parting(
        &mut self,
        contact: &mut dyn ContactModel,
        here: Glimpse,
        end: f64,
    ) -> Result<(), ContactError> {
        for _ in 0..MOST_TURNS {
            let here = self.past_found(contact, here, end)?;
            let Some(turn) = self.turn_before_parting(contact, here, end)? else { break };
            // A pull that is greatest at its end parts the bodies there.
            if turn.time >= end * (1.0 - BEGINNING) {
                break;
            }
            self.found.push_back(turn);
        }
        Ok(())
    }

    /// A look at the bodies beside the last turn found between the look `here` and the time `end` [s], if there is one: a dashpot
    /// that is turned round has the force turn three times.
    fn past_found(&self, contact: &mut dyn ContactModel, here: Glimpse, end: f64) -> Result<Glimpse, ContactError> {
        let between = |time: &f64| here.time < *time && *time < end;
        let Some(turn) = self.found.iter().map(|instant| instant.time).filter(between).reduce(f64::max) else {
            return Ok(here);
        };
        let time = turn + BESIDE * (end - turn);
        Ok(Glimpse { time, seen: self.see(contact, time)? })
    }

    /// The first turn of the force between the look `here` and the last time `end` [s] at which the bodies still touch.
    fn turn_before_parting(
        &self,
        contact: &mut dyn ContactModel,
        here: Glimpse,
        end: f64,
    ) -> Result<Option<NotableInstant>, ContactError> {
        if !here.joined() {
            return Ok(None);
        }
        let early = (2..=FIRST_LOOKS).rev().map(|k| 0.5f64.powi(k));
        let late = (1..=LAST_LOOKS).map(|k| 1.0 - 0.5f64.powi(k));
        let mut three = [here; 3];
        for part in early.chain(late).chain([1.0]) {
            let time = here.time + part * (end - here.time);
            three = [three[1], three[2], Glimpse { time, seen: self.see(contact, time)? }];
            if three[0].time < three[1].time && three[2].joined() {
                let turn = self.turn(contact, three)?;
                let eases = three.windows(2).all(|pair| pair[0].seen.force < pair[1].seen.force);
                if turn.is_some() || (eases && part > 0.5) {
                    return Ok(turn);
                }
            }
        }
        Ok(None)
    }

    /// The instant between two looks at which the bodies touch or part.
    fn edge_of_contact(
        &self,
        contact: &mut dyn ContactModel,
        before: Glimpse,
        after: Glimpse,
    ) -> Result<Option<NotableInstant>, ContactError> {
        let joined = before.joined();
        let (mut low, mut high) = (before.time, after.time);
        if low <= 0.0 && (self.see(contact, BEGINNING * high)?.contact_radius > 0.0) != joined {
            return Ok(None);
        }
        let way = ahead(contact, self.speed, high - before.time);
        let parting = if joined { contact.parting(&way)? } else { None };
        let known = parting.map(|parting| Parting { time: before.time + parting.time, ..parting });
        (low, high) =
            last_of(|time| Ok((self.see(contact, time)?.contact_radius > 0.0) == joined), (low, high), known)?;
        let torn = parting.is_some_and(|parting| parting.suddenly);
        Ok(Some(NotableInstant { time: high, just_before: torn.then_some(low), touching: Some(!joined) }))
    }

    /// The turn of the force among three looks.
    fn turn(
        &self,
        contact: &mut dyn ContactModel,
        three: [Glimpse; 3],
    ) -> Result<Option<NotableInstant>, ContactError> {
        let [first, middle, last] = three.map(|glimpse| glimpse.seen.force);
        let most = middle.abs().max(first.abs()).max(last.abs());
        let (noise, doubt) = (NOISE * most, contact.doubt() * most);
        let sign = if middle > first { 1.0 } else { -1.0 };
        let over = [first, last].map(|other| sign * (middle - other));
        if over[0].min(over[1]) < doubt || over[0].max(over[1]) <= noise {
            return Ok(None);
        }
        let force = |time: f64| Ok::<_, ContactError>(sign * self.see(contact, time)?.force);
        let peak = extremum::search(force, three[0].time, three[1].time, three[2].time)?;
        Ok(Some(NotableInstant { time: peak.place, just_before: None, touching: None }))
    }
}
