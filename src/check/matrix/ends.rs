//! What two runs of the same scene have in common.

use super::written::Written;
use crate::run::record::{Outcome, Record};
use crate::run::{self, Wanted};

/// What is compared of two runs.
pub(super) struct Ends {
    force: f64,
    depth: f64,
    stored: f64,
    dissipated: f64,
    along: f64,
    /// What parts the bodies, or all but does, if a pull has been passed; on pixels it is one of the records alone.
    pull: Option<f64>,
    largest: Largest,
}

/// The largest force [N], depth [m] and energy [J] of a scene.
#[derive(Clone, Copy)]
pub(super) struct Largest {
    pub(super) force: f64,
    /// Forces [N] that hold each other in balance in a contact that adheres.
    balanced: f64,
    pub(super) depth: f64,
    pub(super) energy: f64,
    pub(super) radius: f64,
}

/// What the speeds of some hundred steps of an impact, each found to 1e-9, leave of the pull that ends it.
const STEPPED: f64 = 1e-6;
/// Part of the largest depth and force that rounding may leave of none.
const ROUNDED: f64 = 1e-12;
/// Part of the forces in balance beside which a force is none.
const LEAST: f64 = 1e-3;

impl Largest {
    /// Force [N] of the order of those which hold each other in balance in a contact that adheres under no load.
    fn balance(&self) -> f64 {
        let told = if self.radius > 0.0 { self.energy / self.radius } else { 0.0 };
        self.balanced.max(told)
    }

    /// The largest force [N], or that beside which one is none.
    pub(super) fn tellable_force(&self) -> f64 {
        self.force.max(LEAST * self.balance())
    }

    pub(super) fn of(outcome: &Outcome) -> Self {
        let largest = |of: &dyn Fn(&Record) -> f64| outcome.records.iter().map(|r| of(r).abs()).fold(0.0, f64::max);
        // The blow of an impact may fall between its records.
        let told = |name| outcome.number(name).unwrap_or(0.0);
        Self {
            force: largest(&|record| record.normal.force).max(told("largest_force_n")),
            balanced: largest(&|record| record.normal.in_balance()),
            depth: largest(&|record| record.normal.indentation.unwrap_or(0.0)).max(told("largest_indentation_m")),
            energy: largest(&|record| record.normal.stored.elastic)
                + largest(&|record| record.normal.stored.surface)
                + largest(&|record| record.normal.dissipated),
            radius: largest(&|record| record.normal.contact_radius.unwrap_or(0.0)),
        }
    }
}

impl Ends {
    pub(super) fn of(outcome: &Outcome) -> Option<Self> {
        let record = outcome.records.last()?;
        Some(Self {
            force: record.normal.force,
            depth: record.normal.indentation.unwrap_or(0.0),
            stored: record.normal.stored.stored(),
            dissipated: record.normal.dissipated,
            along: record.tangential_force().unwrap_or(0.0),
            pull: outcome.number("pull_off_force_n").filter(|_| record.pixels.is_none()),
            largest: Largest::of(outcome),
        })
    }

    /// The same in units of force [N] and length [m].
    pub(super) fn over(&self, force: f64, length: f64) -> Self {
        let Largest { force: most, balanced, depth, energy, radius } = self.largest;
        let work = force * length;
        Self {
            force: self.force / force,
            depth: self.depth / length,
            stored: self.stored / work,
            dissipated: self.dissipated / work,
            along: self.along / force,
            pull: self.pull.map(|pull| pull / force),
            largest: Largest {
                force: most / force,
                balanced: balanced / force,
                depth: depth / length,
                energy: energy / work,
                radius: radius / length,
            },
        }
    }

    /// Whether the way ends where undented bodies touch, and which of them are joined then.
    fn at_touch(&self) -> Option<bool> {
        let touches = self.depth.abs() <= ROUNDED * self.largest.depth;
        touches.then(|| self.force.abs() > ROUNDED * self.largest.tellable_force())
    }

    /// How the end of another way differs beyond `bound`, if it does. Of bodies that end as they touch rounding, and what
    /// is left of a dent, decides whether they have met again.
    pub(super) fn differ(&self, other: &Self, bound: f64) -> Option<String> {
        if self.at_touch().zip(other.at_touch()).is_some_and(|(one, two)| one != two) {
            return None;
        }
        let largest = &self.largest;
        let (pull, other_pull) = self.pull.zip(other.pull).unwrap_or_default();
        let pairs = [
            ("force", self.force, other.force, largest.tellable_force()),
            ("depth", self.depth, other.depth, largest.depth),
            ("stored", self.stored, other.stored, largest.energy),
            ("dissipated", self.dissipated, other.dissipated, largest.energy),
            (
                "pull-off force",
                pull,
                other_pull,
                largest.tellable_force().max(pull.abs()) * (bound.max(STEPPED) / bound),
            ),
            ("tangential force", self.along, other.along, largest.tellable_force().max(self.along.abs())),
        ];
        let off = pairs.iter().find(|(_, one, two, scale)| {
            let off = (one - two).abs();
            off.is_nan() || off > bound * scale.max(f64::MIN_POSITIVE)
        });
        off.map(|(what, one, two, scale)| format!("{what} {one:e}, {two:e}: off by {:e}", (one - two).abs() / scale))
    }
}

/// The outcome of a scene; what is wrong if it has none.
pub(super) fn outcome(written: &Written) -> Result<Outcome, String> {
    computed(written, Wanted::NOTHING)
}

/// The same with the instants between its records at which the contact jumps or its force turns.
pub(super) fn outcome_with_instants(written: &Written) -> Result<Outcome, String> {
    computed(written, Wanted { instants: true, ..Wanted::NOTHING })
}

fn computed(written: &Written, wanted: Wanted) -> Result<Outcome, String> {
    let plan = written.plan().map_err(|errors| errors[0].message.clone())?;
    run::run(&plan, wanted).map_err(|error| error.to_string())
}

/// How the end of another scene differs by more than either is `known`, if it does.
pub(super) fn compared(whole: &Outcome, other: &Written, known: &dyn Fn(&Outcome) -> f64) -> Option<String> {
    let other = match outcome(other) {
        Ok(other) => other,
        Err(why) => return Some(why),
    };
    Ends::of(whole)?.differ(&Ends::of(&other)?, known(whole).max(known(&other)))
}
