//! The bed as the method is taught: its springs one by one at an instant.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//!
//! let text = r#"(shape: Paraboloid(radius: "10 mm"), bodies: (Elastic(young: "2 MPa", poisson: 0.5), Rigid),
//!     history: [Indent(to: "10 um", over: 1)], plots: [Bed])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! let outcome = run(&plan, Wanted { bed: true, ..Wanted::NOTHING })?;
//! assert!(outcome.table("bed").is_some());
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::follow::Run;
use super::table::{Column, Table};
use super::unit::Unit;
use crate::contact::loaded::Loaded;

/// Rows of the table from one spring that is drawn to the next.
pub const ROWS_PER_SPRING: usize = 8;
/// Springs drawn on each side of the middle, at least: twelve in the radius up to which springs are displaced.
const SPRINGS: f64 = 12.0 * OUT;
/// Part of the distance from one spring to the next below which an edge is too near to the middle to be drawn at a spring.
const NEAR: f64 = 0.6;
/// How far the picture goes, in radii up to which springs are displaced.
const OUT: f64 = 1.4;
/// Part of the largest displacement below which one is none, or the same as another.
const UNSEEN: f64 = 1e-3;

/// A bed at one time.
struct Instant {
    label: &'static str,
    time: f64,
    bed: Loaded,
}

/// A place of a bed.
struct Place {
    time: f64,
    /// Distance from the axis [m].
    place: f64,
    /// Height of the equivalent profile over the undisturbed springs, g(x) − d [m]; none beyond its end.
    profile: Option<f64>,
    /// Displacement of the springs [m].
    displacement: f64,
    /// Their force per length [N/m].
    load: f64,
}

const COLUMNS: [Column<Place>; 5] = [
    Column::new("time", Unit::SECOND, "time t", |row| Some(row.time)),
    Column::new("place", Unit::METRE, "place x", |row| Some(row.place)),
    Column::new("profile", Unit::METRE, "equivalent profile g(x) − d", |row| row.profile),
    Column::new("displacement", Unit::METRE, "displacement u of the springs", |row| Some(row.displacement)),
    Column::new("force_per_length", Unit::NEWTON_PER_METRE, "force per length q", |row| Some(row.load)),
];

/// The springs at the greatest force, and at the end if they still are, or again, displaced otherwise; one block of rows per
/// instant, named in the first column.
///
/// The bed is the same on both sides: 2∫₀ q dx = F over a block, u = d − g(x) up to the contact radius, which is one of its
/// places wherever it is not too small to be drawn. Every eighth place is that of a spring of the figure.
pub(super) fn table(run: &Run) -> Option<Table> {
    let shown = instants(run)?;
    let reach = OUT * shown.iter().map(|instant| instant.bed.displaced_to()).fold(0.0, f64::max);
    let rows: Vec<(&str, Place)> = shown.iter().flat_map(|instant| instant.rows(reach)).collect();
    let labels = rows.iter().map(|row| row.0.to_owned()).collect();
    Some(Table::new("bed").with_words("instant", labels).with(&COLUMNS, rows.iter().map(|row| &row.1)))
}

/// The instants worth a picture; `None` where it is not wanted, or the bodies never touch.
fn instants(run: &Run) -> Option<Vec<Instant>> {
    let (contact, time) = run.at_greatest_force().filter(|_| run.wanted().bed)?;
    let first = Instant { label: "largest force", time, bed: contact.bed()? };
    let end = run.contact.bed().map(|bed| Instant { label: "end", time: run.time(), bed });
    let end = end.filter(|end| first.is_unlike(end));
    Some(std::iter::once(first).chain(end).collect())
}

impl Instant {
    /// Whether another bed is displaced at all, and otherwise than this one.
    fn is_unlike(&self, other: &Self) -> bool {
        let reach = self.bed.displaced_to().max(other.bed.displaced_to());
        let places = places(self.bed.contact_radius(), reach);
        let largest = |of: &dyn Fn(f64) -> f64| places.iter().map(|&x| of(x).abs()).fold(0.0, f64::max);
        let (here, there) = (|x| self.bed.displacement(x), |x| other.bed.displacement(x));
        let seen = UNSEEN * largest(&here);
        largest(&there) > seen && largest(&|x| there(x) - here(x)) > seen
    }

    fn rows(&self, reach: f64) -> impl Iterator<Item = (&'static str, Place)> {
        let (bed, rim) = (&self.bed, self.bed.profile().rim().radius());
        let profile = move |x| (x <= rim).then(|| bed.profile().reduced(x) - bed.indentation());
        places(bed.contact_radius(), reach).into_iter().map(move |place| {
            let (displacement, load) = (bed.displacement(place), bed.line_load(place));
            (self.label, Place { time: self.time, place, profile: profile(place), displacement, load })
        })
    }
}

/// Evenly spaced places from the middle out to `reach` [m] or a little beyond; the edge `edge` [m] is the place of a spring unless it is
/// too near to the middle.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few hundred")]
fn places(edge: f64, reach: f64) -> Vec<f64> {
    let parts = SPRINGS * edge / reach;
    let inside = if parts > NEAR { (parts - 1e-9).ceil() } else { 0.0 };
    let spacing = if inside > 0.0 { edge / inside } else { reach / SPRINGS };
    let rows = ROWS_PER_SPRING as f64;
    let count = ((reach / spacing - 1e-9).ceil() * rows) as usize;
    let at_edge = (inside > 0.0).then_some((inside * rows) as usize);
    let place = |k: usize| if Some(k) == at_edge { edge } else { spacing * (k as f64 / rows) };
    (0..=count).map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The edge is one of the places to the last bit, and that of a spring.
    #[test]
    fn a_spring_stands_at_the_edge() {
        for edge in [1.0, 0.7, 0.1, 1.0 / 3.0, 0.06, 0.051] {
            let places = places(edge, 1.4);
            let at = places.iter().position(|&x| (x - edge).abs() <= 0.0).unwrap();
            assert!(at % ROWS_PER_SPRING == 0 && places.windows(2).all(|pair| pair[0] < pair[1]));
            let springs = 2 * (places.len() / ROWS_PER_SPRING) + 1;
            assert!((30..=60).contains(&springs) && *places.last().unwrap() >= 1.4, "{springs}");
        }
        assert!(places(1e-4, 1.0).len() == 17 * ROWS_PER_SPRING + 1 && places(0.0, 1.0)[0] <= 0.0);
    }
}
