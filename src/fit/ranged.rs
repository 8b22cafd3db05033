//! The force of a contact with an attraction of finite range, led through a row of depths, without a run.
//!
//! Along a stable branch the neck of one row is found from that of the row before it; where a branch ends the contact leaps,
//! as a run would have it.

use super::adhesive::{Followed, Jump};
use super::slopes::Slopes;
use crate::contact::adhesion::equilibrium::{Branches, Control, Equilibrium};
use crate::contact::adhesion::neck::{Felt, Neck};
use crate::contact::adhesion::range::RangeDisc;

/// A contact that attracts over a range.
#[derive(Debug, Clone)]
pub struct Ranged(RangeDisc);

/// How far a contact has come.
struct Way<'w> {
    disc: &'w RangeDisc,
    branches: Branches,
    /// Reach c [m].
    reach: f64,
    /// The neck, once the bodies touch.
    neck: Option<Neck>,
    jumps: Vec<Jump>,
    /// The row that came nearest to parting, and how far above it was [m].
    brink: Option<(usize, f64)>,
}

impl Ranged {
    /// The contact on `disc`; `None` if its profile has a kink.
    pub fn of(disc: RangeDisc) -> Option<Self> {
        disc.ground().profile().kink().is_none().then_some(Self(disc))
    }

    /// E* [Pa], work of adhesion [J/m²] and attractive stress [Pa].
    pub fn numbers(&self) -> Vec<f64> {
        vec![self.0.ground().modulus(), self.0.work(), self.0.stress()]
    }

    /// The contact at the depths `depths` [m] in their order, first touch at `contact`.
    ///
    /// # Errors
    /// The contact cannot be followed.
    pub fn followed(&self, depths: &[f64], contact: f64) -> Result<Followed, String> {
        let disc = &self.0;
        let branches = Branches::new(disc, Control::Indentation).map_err(|error| error.to_string())?;
        let (reach, jumps) = (disc.start(), Vec::new());
        let mut way = Way { disc, branches, reach, neck: None, jumps, brink: None };
        let states = depths.iter().enumerate().map(|(row, d)| way.comes_to(row, (d - contact, contact)));
        let states = states.collect::<Result<Vec<Felt>, String>>()?;
        way.ends(contact);
        let slope = |at: usize| states.iter().map(|state| state.slopes[at]).collect::<Vec<f64>>();
        let touch = states.iter().map(|state| -state.slopes[3]).collect();
        let slopes = Slopes { numbers: vec![slope(0), slope(1), slope(2)], touch };
        Ok(Followed { forces: states.iter().map(|state| state.force).collect(), slopes, jumps: way.jumps })
    }
}

impl Way<'_> {
    /// The state at the depth `d` [m] of a row.
    fn comes_to(&mut self, row: usize, (d, contact): (f64, f64)) -> Result<Felt, String> {
        let apart = self.reach <= self.disc.start();
        if apart && d < self.disc.value(Control::Indentation, self.disc.start()) {
            return Ok(APART);
        }
        match self.stays(d) {
            Some(neck) => (self.reach, self.neck) = (neck.reach, Some(neck)),
            None => self.leaps(row, (d, contact))?,
        }
        if let [Some((_, least)), _] = self.branches.ends(self.reach)
            && self.reach > self.disc.start()
            && self.brink.is_none_or(|(_, before)| d - least < before)
        {
            self.brink = Some((row, d - least));
        }
        Ok(match self.neck {
            Some(neck) => self.disc.felt(neck),
            None if self.reach <= self.disc.start() => APART,
            None => self.disc.felt_before_touch(self.reach),
        })
    }

    /// The neck at the depth `d` [m] on the present branch; `None` beyond its ends.
    fn stays(&self, d: f64) -> Option<Neck> {
        let [low, high] = self.branches.ends(self.reach);
        let neck = self.neck.filter(|_| low.is_none_or(|low| low.1 <= d) && high.is_none_or(|high| d <= high.1))?;
        let next = self.disc.neck_near(neck, d)?;
        let on = low.is_none_or(|low| low.0 <= next.reach) && high.is_none_or(|high| next.reach <= high.0);
        on.then_some(next)
    }

    /// Goes on as a run would.
    fn leaps(&mut self, row: usize, (d, contact): (f64, f64)) -> Result<(), String> {
        let (reach, leaps) = self.branches.follow(self.disc, self.reach, d).map_err(|error| error.to_string())?;
        (self.reach, self.neck) = (reach, self.disc.neck_at(reach));
        for leap in leaps {
            let height = self.disc.value(Control::Force, leap.from) - self.disc.value(Control::Force, leap.to);
            self.jumps.push(Jump { row, height: height.abs(), at: Some(contact + leap.at) });
            self.brink = None;
        }
        Ok(())
    }

    /// Tells the row on the brink of parting.
    fn ends(&mut self, contact: f64) {
        let Some((row, _)) = self.brink else { return };
        let [Some((reach, least)), _] = self.branches.ends(self.reach) else { return };
        if reach <= self.disc.start() {
            return;
        }
        let height = self.disc.value(Control::Force, reach).abs();
        self.jumps.push(Jump { row: row + 1, height, at: Some(contact + least) });
    }
}

/// Bodies that do not feel each other.
const APART: Felt = Felt { force: 0.0, slopes: [0.0; 4] };
