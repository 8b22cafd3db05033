//! How deep, and how fast, a history goes.

use super::draft::Draft;
use crate::contact::adhesion::equilibrium::Control;
use crate::input::problem::Problem;
use crate::scene::history::EntryTraits;
use crate::scene::reach::{Beyond, Bound};
use crate::scene::stage::{Path, Stage};

/// Depths and forces beyond what the profile allows.
pub(super) fn too_deep(draft: &Draft<'_>) -> Vec<Problem> {
    let Some(bodies) = draft.joined() else { return Vec::new() };
    // How much of its way a spring takes up is known from the run.
    if draft.machine().is_some_and(|machine| machine.mass.is_none()) {
        return Vec::new();
    }
    // With adhesion or relaxation the force does not follow from the depth alone.
    let plain = draft.adheres() == Some(false) && bodies.relaxation.is_none();
    let modulus = plain.then_some(bodies.pair.normal);
    // Contact in several pieces is known on pixels, and nobody knows what a solver should be that is mended.
    let by_pixels = draft.chooses_solver() != Some(false);
    let bounds: Vec<Bound> =
        draft.bounds().iter().filter(|bound| !by_pixels || bound.beyond == Beyond::End).copied().collect();
    let (mut found, mut depth) = (Vec::new(), Some(0.0));
    for entry in draft.entries() {
        let target = entry.and_then(|entry| target(entry, depth));
        found.extend(target.and_then(|target| target.beyond(&bounds, modulus)));
        depth = entry.and_then(|entry| depth_after(entry, depth));
    }
    found
}

/// The greatest value an entry prescribes.
struct Demand<'t> {
    entry: &'t EntryTraits<'t>,
    /// Number of the stage.
    at: usize,
    control: Control,
    value: f64,
}

fn target<'t>(entry: &'t EntryTraits<'t>, before: Option<f64>) -> Option<Demand<'t>> {
    let value = |stage: &Stage| match stage.normal {
        Path::To(value) => Some(value),
        Path::Wave(wave) => before.map(|depth| depth + wave.amplitude),
        Path::Stay | Path::Steady { .. } | Path::UntilParted { .. } => None,
    };
    let values = entry.stages.iter().enumerate();
    let values =
        values.filter_map(|(at, stage)| Some(Demand { entry, at, control: stage.control?, value: value(stage)? }));
    values.max_by(|one, other| one.value.total_cmp(&other.value))
}

impl Demand<'_> {
    fn beyond(&self, bounds: &[Bound], modulus: Option<f64>) -> Option<Problem> {
        let problem = |bound: &Bound| {
            let place = format!("{}{}", self.entry.place(), self.entry.field);
            let (row, what) = (self.entry.row(self.at), self.in_words(bound, modulus)?);
            Some(Problem::new(place, format!("{row}{what} {}", bound.in_words())))
        };
        bounds.iter().find_map(problem)
    }

    /// The value, if it is beyond the bound.
    fn in_words(&self, bound: &Bound, modulus: Option<f64>) -> Option<String> {
        let value = self.value;
        match self.control {
            Control::Indentation => (value > bound.depth).then(|| format!("{value:e} m is deeper than")),
            Control::Force => {
                (value > 2.0 * modulus? * bound.load_integral).then(|| format!("{value:e} N presses deeper than"))
            }
        }
    }
}

/// The indentation after an entry, where it is known before the contact is computed.
fn depth_after(entry: &EntryTraits<'_>, before: Option<f64>) -> Option<f64> {
    let stage = entry.stages.last()?;
    match (stage.control, stage.normal) {
        (None, _) | (Some(Control::Indentation), Path::Stay) => before,
        (Some(Control::Indentation), path @ (Path::To(_) | Path::Steady { .. } | Path::Wave(_))) => {
            match (path, before) {
                (Path::To(depth), _) => Some(depth),
                (path, before) => before.map(|depth| path.at(depth, 1.0, stage.over)),
            }
        }
        (Some(Control::Indentation), Path::UntilParted { .. }) | (Some(Control::Force), _) => None,
    }
}

/// Every slide must go at a speed the table of the shear strength holds.
pub(super) fn too_fast(draft: &Draft<'_>) -> Vec<Problem> {
    let Some(curve) = draft.strength() else { return Vec::new() };
    // Where the last slide has led, unless it is mended.
    let mut at = Some(0.0);
    let mut wrong = |entry: Option<&EntryTraits<'_>>| {
        let Some(entry) = entry else {
            at = None;
            return None;
        };
        let stage = entry.stages.first().filter(|_| entry.is_slide())?;
        let Path::To(to) = stage.tangential else { return None };
        let way = (to - at.replace(to)?).abs();
        let error = curve.at(way / stage.over).err().filter(|_| way > 0.0)?;
        Some(Problem::new(entry.place(), error.to_string()))
    };
    draft.entries().filter_map(&mut wrong).collect()
}
