//! Long and short tables, long histories.

use super::{Found, Trial, Whose};
use crate::check::closed_forms;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::input::quantity::{Length, Modulus, Poisson};
use crate::input::table::InMemory;
use crate::material::{Body, Elastic};
use crate::run::{self, Wanted};
use crate::scene::Scene;
use crate::scene::history::Entry;
use crate::shape::rough::Random;
use crate::shape::{Measured, Paraboloid, Profile, Shape};
use std::path::Path;
use std::sync::Arc;

pub(super) const TRIALS: &[Trial] = &[
    Trial {
        name: "profile table of a million rows",
        range: "a paraboloid in 10⁶ rows, contacts 10⁻⁴ … 0.9 of it",
        against: "Hertz",
        bound: 1e-9,
        reason: "heights are rounded to 2⁻⁵³ of themselves, slopes between neighbours to 10⁶ times that",
        whose: Whose::Ours,
        run: || measured(1_000_000),
    },
    Trial {
        name: "profile table of three rows",
        range: "a cone in three rows",
        against: "cone",
        bound: 1e-13,
        reason: "three points of a cone are the cone; a few dozen roundings",
        whose: Whose::Ours,
        run: three_rows,
    },
    Trial {
        name: "history of a million entries",
        range: "a table of 10⁶ random depths, then a last one",
        against: "Hertz at the end, no energy lost",
        bound: 1e-13,
        reason: "the state depends on the present depth alone",
        whose: Whose::Ours,
        run: history,
    },
];

fn contact<P: Profile + Clone + 'static>(profile: &P) -> QuasiStatic {
    QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(profile.clone()), 1.0), 0.0))
}

fn read(radii: &[f64], heights: &[f64]) -> Option<Measured> {
    let tables = InMemory::default().with("tip.csv", &[("radius_m", radii), ("height_m", heights)]);
    Measured::read(Path::new("tip.csv"), &tables).ok()
}

fn measured(rows: u32) -> Option<Found> {
    let mut found = Found::default();
    let radii: Vec<f64> = (0..rows).map(|k| f64::from(k) / f64::from(rows - 1)).collect();
    let heights: Vec<f64> = radii.iter().map(|r| 0.5 * r * r).collect();
    let profile = read(&radii, &heights)?;
    for a in [1e-4, 1e-3, 0.01, 0.1, 0.5, 0.9] {
        let mut contact = contact(&profile);
        contact.indent(a * a).ok()?;
        let right = closed_forms::hertz(1.0, a * a);
        found.pair(contact.present().balance.force, right.force);
        found.pair(contact.present().balance.contact_radius, right.radius);
    }
    Some(found)
}

fn three_rows() -> Option<Found> {
    let mut found = Found::default();
    let profile = read(&[0.0, 0.3, 1.0], &[0.0, 0.06, 0.2])?;
    for depth in [1e-12, 1e-3, 0.09, 0.1, 0.3] {
        let mut contact = contact(&profile);
        contact.indent(depth).ok()?;
        let right = closed_forms::cone(0.2, depth);
        found.pair(contact.present().balance.force, right.force);
        found.pair(contact.present().balance.contact_radius, right.radius);
    }
    Some(found)
}

fn history() -> Option<Found> {
    let mut found = Found::default();
    let mut random = Random::seeded(2);
    let count = 1_000_000u32;
    let times: Vec<f64> = (0..count).map(f64::from).collect();
    let mut depths: Vec<f64> = times.iter().map(|_| 1e-6 * random.phase()).collect();
    *depths.last_mut()? = 1e-6;
    let tables = InMemory::default().with("h.csv", &[("time_s", &times), ("indentation_m", &depths)]);
    let setup = scene()?.resolve(&tables).ok()?;
    let outcome = run::run(&setup, Wanted::NOTHING).ok()?;
    let last = outcome.records.last()?.normal;
    let right = closed_forms::hertz(0.01, 1e-6);
    found.pair(last.force, setup.pair.normal * right.force);
    found.error(last.dissipated.abs() / last.stored.stored());
    found.law(outcome.records.len() >= count as usize);
    Some(found)
}

fn scene() -> Option<Scene> {
    let steel = Elastic { young: Modulus::new(210e9).ok()?, poisson: Poisson::new(0.3).ok()?, yield_stress: None };
    Some(Scene {
        title: String::new(),
        shape: Shape::Paraboloid(Paraboloid { radius: Length::new(0.01).ok()? }),
        bodies: (Body::Elastic(steel), Body::Rigid),
        adhesion: None,
        friction: None,
        history: vec![Entry::Table("h.csv".into())],
        accuracy: None,
        springs: None,
        steps: None,
        plots: None,
    })
}
