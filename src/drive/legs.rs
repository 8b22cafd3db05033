//! A stage of a contact that remembers, from leg to straight leg.

use super::course::Extent;
use super::force::{Stretch, depth_of};
use super::instants::{NotableInstant, Watch, looks};
use super::{Driver, Occurrence, Remainder};
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};
use crate::contact::state::Normal;

/// Mean difference of the contact's force from the prescribed one, in errors allowed, from which on it has jumped.
const JUMP: f64 = 4.0;

/// Part of a time by which rounding may delay what was seen to happen.
const LATEST: f64 = 1e-12;
/// Parts of a row of a table at which bodies that pull each other are looked at. An edge with a rate is known too coarsely
/// for the last two alone to tell that the pull has turned.
const ROW_THAT_PULLS: [f64; 5] = [1e-3, 0.5, 0.9, 0.999, 1.0];

/// A straight piece of the depth within a stage.
#[derive(Debug, Clone)]
pub(super) struct Leg {
    from: f64,
    to: f64,
    speed: f64,
    begin: f64,
    end: f64,
    watch: Option<Watch>,
    /// What a contact under a prescribed force has at its beginning.
    outset: Option<Outset>,
}

/// A contact at the beginning of a leg.
#[derive(Debug, Clone, Copy)]
struct Outset {
    /// Energy stored and lost [J].
    accounted: f64,
    joined: bool,
}

impl Leg {
    /// Depth [m] at the time `t` [s] of the stage.
    fn depth(&self, t: f64) -> f64 {
        if t >= self.end { self.to } else { self.from + self.speed * (t - self.begin) }
    }
}

impl Driver {
    /// The leg of a piece under a prescribed force that begins here.
    fn stretched(&self, contact: &dyn ContactModel, here: &Normal, Stretch { speed, until }: Stretch) -> Leg {
        let (from, begin) = (depth_of(contact), self.stage.now);
        let to = from + speed * (until - begin);
        let outset = Outset { accounted: here.accounted(), joined: contact.joined() };
        Leg { from, to, speed, begin, end: until, watch: None, outset: Some(outset) }
    }

    /// Through the legs of the stage up to the time `until` [s].
    pub(super) fn walk(
        &mut self,
        contact: &mut dyn ContactModel,
        until: f64,
        occurrences: &mut Vec<Occurrence>,
    ) -> Result<(), ContactError> {
        loop {
            self.walk_legs(contact, until, occurrences)?;
            self.parted &= !contact.joined();
            let Remainder::Force(force) = &self.stage.remainder else { break };
            if self.parted || !force.parted() {
                break;
            }
            occurrences.push(self.let_go(contact, force.now()));
            self.parted = true;
            // What is left of the stage passes for them all the same.
            let here = contact.state();
            self.stage.leg = self.next_leg(contact, &here)?;
        }
        Ok(())
    }

    /// Through the legs up to the time `until` [s], as long as the bodies are not to be let go.
    fn walk_legs(
        &mut self,
        contact: &mut dyn ContactModel,
        until: f64,
        occurrences: &mut Vec<Occurrence>,
    ) -> Result<(), ContactError> {
        while let Some(mut leg) = self.stage.leg.take() {
            let stop = until.min(leg.end);
            self.walk_leg(contact, &mut leg, stop, occurrences)?;
            if until < leg.end {
                self.stage.leg = Some(leg);
                break;
            }
            self.stage.now = leg.end;
            let here = contact.state();
            self.note_jump(&here, &leg);
            self.stage.leg = self.next_leg(contact, &here)?;
        }
        Ok(())
    }

    /// What the prescribed force has done on a leg that is over beyond what the contact took, if the contact jumped: it
    /// had another force on the way. Bodies that come together have met at no force, and their way until then is none.
    fn note_jump(&mut self, here: &Normal, leg: &Leg) {
        let (Some(outset), Remainder::Force(force)) = (leg.outset, &self.stage.remainder) else { return };
        let mean = 0.5 * (force.prescribed(leg.begin) + force.prescribed(leg.end));
        let way = if outset.joined { leg.to - leg.from } else { 0.0 };
        let lost = mean * way - (here.accounted() - outset.accounted);
        if lost > JUMP * self.accuracy * self.largest.max(here.in_balance()) * way.abs() {
            self.lost += lost;
        }
    }

    /// Along a leg up to the time `until` [s], from look to look.
    fn walk_leg(
        &mut self,
        contact: &mut dyn ContactModel,
        leg: &mut Leg,
        until: f64,
        occurrences: &mut Vec<Occurrence>,
    ) -> Result<(), ContactError> {
        loop {
            let look = leg.watch.as_ref().and_then(Watch::next_stop).map(|stop| leg.begin + stop);
            let stop = look.unwrap_or(until).min(until);
            while let Some(instant) = leg.watch.as_mut().and_then(|watch| watch.take_until(stop - leg.begin)) {
                let before = match instant.just_before {
                    Some(time) => {
                        let time = self.still_touching(contact, leg, leg.begin + time)?;
                        self.move_to(contact, leg, time)?;
                        Some(self.state(contact))
                    }
                    None => None,
                };
                let time = self.move_past(contact, leg, &instant, stop)?;
                let turns = instant.touching.is_none() && before.is_none();
                self.stage.at_speed = if turns { self.at_speed(contact, time)? } else { None };
                let after = self.state(contact);
                self.stage.at_speed = None;
                let before = before.unwrap_or(after);
                occurrences.push(Occurrence { time, before, after, tangential: contact.tangential() });
            }
            self.move_to(contact, leg, stop)?;
            match (look.is_some_and(|look| look <= stop), &mut leg.watch) {
                (true, Some(watch)) => watch.stop(contact)?,
                _ => return Ok(()),
            }
        }
    }

    /// The time `time` [s], or one before it by rounding, at which bodies that part after it still touch as seen from here: it was
    /// found by looking from a little earlier.
    fn still_touching(&self, contact: &mut dyn ContactModel, leg: &Leg, time: f64) -> Result<f64, ContactError> {
        let (now, sliding_speed) = (self.stage.now, self.stage.sliding_speed());
        let (mut stop, mut earlier) = (time, f64::EPSILON * time);
        while now < stop && earlier < LATEST * time {
            let (to, slide) = (leg.depth(stop), self.stage.slide_at(stop));
            let way = Straight { to, speed: leg.speed, slide, sliding_speed, duration: stop - now };
            if contact.look(&way)?.contact_radius > 0.0 {
                break;
            }
            stop = (stop - earlier).max(now);
            earlier *= 2.0;
        }
        Ok(stop)
    }

    /// On along a leg until an instant has passed, not beyond `stop` [s]; the time [s] it is then.
    ///
    /// It was found by looking from a little earlier: where bodies touch or part, rounding on the way here may
    /// delay it.
    fn move_past(
        &mut self,
        contact: &mut dyn ContactModel,
        leg: &Leg,
        instant: &NotableInstant,
        stop: f64,
    ) -> Result<f64, ContactError> {
        let mut time = (leg.begin + instant.time).min(stop);
        let mut later = f64::EPSILON * time;
        self.move_to(contact, leg, time)?;
        while let Some(touching) = instant.touching
            && later < LATEST * time
            && (contact.state().contact_radius > Some(0.0)) != touching
        {
            time = (time + later).min(stop);
            later *= 2.0;
            self.move_to(contact, leg, time)?;
        }
        Ok(time)
    }

    /// On along a leg to the time `time` [s], from corner to corner of the slide.
    fn move_to(&mut self, contact: &mut dyn ContactModel, leg: &Leg, time: f64) -> Result<(), ContactError> {
        while self.stage.now < time {
            let corner = self.stage.shaken.as_ref().map_or(time, |shaken| shaken.next_corner(self.stage.now));
            let stop = corner.min(time);
            let (slide, sliding_speed) = (self.stage.slide_at(stop), self.stage.sliding_speed());
            let duration = stop - self.stage.now;
            contact.follow(&Straight { to: leg.depth(stop), speed: leg.speed, slide, sliding_speed, duration })?;
            self.stage.now = stop;
        }
        Ok(())
    }

    /// The next leg of the stage, which begins in the state `here`, with a watch over what happens on it.
    pub(super) fn next_leg(
        &mut self,
        contact: &mut dyn ContactModel,
        here: &Normal,
    ) -> Result<Option<Leg>, ContactError> {
        let begin = self.stage.now;
        let depth = depth_of(contact);
        let (to, end) = match &mut self.stage.remainder {
            Remainder::Records | Remainder::Idle | Remainder::Done => return Ok(None),
            &mut Remainder::Straight(to) => {
                self.stage.remainder = Remainder::Done;
                (to, self.stage.course.over)
            }
            Remainder::Chords(chords) => match chords.next() {
                Some(chord) => chord,
                None => return Ok(None),
            },
            Remainder::Force(force) => match force.next(contact, here)? {
                Some(stretch) => return Ok(Some(self.stretched(contact, here, stretch))),
                None => return Ok(None),
            },
        };
        let speed = (to - depth) / (end - begin);
        let mut leg = Leg { from: depth, to, speed, begin, end, watch: None, outset: None };
        leg.watch = self.watch(contact, here, &leg)?;
        Ok(Some(leg))
    }

    /// The watch over a leg that begins here.
    fn watch(
        &mut self,
        contact: &mut dyn ContactModel,
        here: &Normal,
        leg: &Leg,
    ) -> Result<Option<Watch>, ContactError> {
        let duration = leg.end - leg.begin;
        let Some(spectrum) = contact.memory().filter(|_| duration > 0.0) else { return Ok(None) };
        let Remainder::Chords(chords) = &self.stage.remainder else {
            let times = match self.stage.course.extent {
                // A pull may turn in either half, and a row begin or end beyond its turn.
                Extent::Row if here.stored.surface < 0.0 => ROW_THAT_PULLS.map(|part| part * duration).to_vec(),
                Extent::Row => vec![0.5 * duration, duration],
                Extent::Entry => looks(duration, 1e20 * spectrum.instant()),
            };
            return Watch::new(contact, leg.speed, times).map(Some);
        };
        let mut watch = Watch::new(contact, leg.speed, vec![duration])?;
        // To the chords' own error the force of a path with corners turns at the corners.
        let Some(end) = watch.first_ahead() else { return Ok(Some(watch)) };
        self.cycle.watch(contact, here, chords, (leg.speed, duration, end))?;
        let before = self.stage.behind.replace(here.force);
        if before.is_some_and(|before| (here.force - before) * (here.force - end.force) > 0.0) {
            watch.note_beginning();
        }
        Ok(Some(watch))
    }
}
