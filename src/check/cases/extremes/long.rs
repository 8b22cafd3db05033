//! Long and short tables, long histories.

use super::case;
use crate::check::case::{Attempt, Case};
use crate::check::closed_forms::{self, ClosedForm};
use crate::check::contacts::indented;
use crate::check::extreme::{Extreme, Tally};
use crate::check::sketch::{Sketch, ball, elastic};
use crate::input::table::InMemory;
use crate::shape::Measured;
use crate::shape::rough::Random;
use std::path::Path;
use std::sync::Arc;

pub(super) const CASES: &[Case] = &[
    case(
        "extremes/profile table of a million rows",
        Extreme {
            range: "a paraboloid in 10⁶ rows, contacts 10⁻⁴ … 0.9 of it", against: "Hertz", tried: million_rows
        },
        1e-9,
        "heights are rounded to 2⁻⁵³ of themselves, slopes between neighbours to 10⁶ times that",
    ),
    case(
        "extremes/profile table of three rows",
        Extreme { range: "a cone in three rows", against: "cone", tried: three_rows },
        1e-13,
        "three points of a cone are the cone; a few dozen roundings",
    ),
    case(
        "extremes/history of a million entries",
        Extreme {
            range: "a table of 10⁶ random depths, then a last one",
            against: "Hertz at the end, no energy lost",
            tried: history,
        },
        1e-13,
        "the state depends on the present depth alone",
    ),
];

/// A profile given by a table, pressed to depths, beside the closed form.
fn measured(radii: &[f64], heights: &[f64], depths: &[f64], right: fn(f64) -> ClosedForm) -> Attempt<Tally> {
    let mut tally = Tally::default();
    let tables = InMemory::default().with("tip.csv", &[("radius_m", radii), ("height_m", heights)]);
    let profile = Arc::new(Measured::read(Path::new("tip.csv"), &tables)?);
    for &depth in depths {
        let (balance, right) = (indented(profile.clone(), 1.0, depth)?.present().balance, right(depth));
        tally.pair(balance.force, right.force);
        tally.pair(balance.contact_radius, right.radius);
    }
    Ok(tally)
}

fn million_rows() -> Attempt<Tally> {
    let radii: Vec<f64> = (0..1_000_000).map(|k| f64::from(k) / 999_999.0).collect();
    let heights: Vec<f64> = radii.iter().map(|r| 0.5 * r * r).collect();
    let depths = [1e-4, 1e-3, 0.01, 0.1, 0.5, 0.9].map(|a| a * a);
    measured(&radii, &heights, &depths, |depth| closed_forms::hertz(1.0, depth))
}

fn three_rows() -> Attempt<Tally> {
    let depths = [1e-12, 1e-3, 0.09, 0.1, 0.3];
    measured(&[0.0, 0.3, 1.0], &[0.0, 0.06, 0.2], &depths, |depth| closed_forms::cone(0.2, depth))
}

fn history() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let mut random = Random::seeded(2);
    let count = 1_000_000u32;
    let times: Vec<f64> = (0..count).map(f64::from).collect();
    let mut depths: Vec<f64> = times.iter().skip(1).map(|_| 1e-6 * random.phase()).collect();
    depths.push(1e-6);
    let columns: [(&str, &[f64]); 2] = [("time_s", &times), ("indentation_m", &depths)];
    let outcome = Sketch::of(ball(0.01)).body(elastic(210e9, 0.3)).table(&columns).run()?;
    let last = outcome.records.last().ok_or("no record")?.normal;
    tally.pair(last.force, 210e9 / 0.91 * closed_forms::hertz(0.01, 1e-6).force);
    tally.error(last.dissipated.abs() / last.stored.stored());
    tally.law(outcome.records.len() >= count as usize);
    Ok(tally)
}
