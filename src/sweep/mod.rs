//! One scene with many values: a grid of parameters, or values side by side, each combination a row.
//!
//! # Examples
//! ```
//! use springbed::prelude::*;
//! use springbed::scene::Scene;
//! use springbed::sweep::{Arrangement, Curves, Part, Sweep};
//!
//! // Two moduli times three depths on a ball of 10 mm.
//! let scene = Scene::from_ron(r#"(shape: Paraboloid(radius: "10 mm"), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: "1 um", over: 1)])"#)?;
//! let set = [("bodies.0.young", "[1 MPa, 8 MPa]"), ("history.0.to", "1um..4um:3log")];
//! let set = set.map(|(path, values)| (path.to_owned(), values.parse().unwrap()));
//! let sweep = Sweep::new(&scene, &set, Arrangement::Grid)?;
//! assert_eq!(sweep.rows(), 6);
//! let rows: Vec<_> = Part::WHOLE.rows(6).map(|number| sweep.row(number, &InMemory::default(), Curves::Absent)).collect();
//! let force = |row: usize| rows[row].number("largest_force_n").unwrap();
//! // F = 4/3 E* √R d^(3/2): eight times over the modulus, eight times over four times the depth.
//! assert!((force(3) / force(0) - 8.0).abs() < 1e-12 && (force(2) / force(0) - 8.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axis;
mod part;
mod row;
mod table;

pub use axis::Axis;
pub use part::Part;
pub use row::{Curves, Row};
pub use table::table;

use crate::input::problem::Problem;
use crate::input::values::Values;
use crate::scene::Scene;
use crate::scene::swept::{Setting, Swept};
use crate::text::place::{Places, Value};
use serde::{Deserialize, Serialize};

/// Most rows of a sweep.
const MOST: usize = 10_000_000;

/// Most curves of a family in one figure.
const FAMILY: usize = 7;

/// How the values of several axes go together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
pub enum Arrangement {
    /// Every value with every other; the last axis runs fastest.
    Grid,
    /// The first values of all axes, then the second ones, and so on.
    Zip,
}

/// A scene and the values some of its places are to take.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    places: Places,
    axes: Vec<Axis>,
    arrangement: Arrangement,
    rows: usize,
}

impl Sweep {
    /// A sweep of `scene` over the values `set` of some paths.
    ///
    /// Values are set in the scene as it is resolved: a body given by its shear modulus has `young` there.
    ///
    /// # Errors
    /// A path that leads nowhere, or twice to one place; a value that cannot stand there; values side by side of which
    /// there are not as many of each; more than 10 million rows.
    pub fn new(scene: &Scene, set: &[(String, Values)], arrangement: Arrangement) -> Result<Self, Problem> {
        let places = base(scene)?;
        let mut axes: Vec<Axis> = Vec::with_capacity(set.len());
        for (path, values) in set {
            if axes.iter().any(|axis| axis.path == *path) {
                return Err(Problem::new(path, "is set twice: expected its values in one list"));
            }
            axes.push(Axis::new(&places, path, values)?);
        }
        let rows = rows(&axes, arrangement)?;
        Ok(Self { places, axes, arrangement, rows })
    }

    /// The sweep that a scene writes, if it does.
    #[must_use]
    pub fn written(scene: &Scene) -> Option<Result<Self, Problem>> {
        let Swept { set, zip } = scene.sweep.as_ref()?;
        let set: Vec<(String, Values)> =
            set.iter().map(|Setting { path, values }| (path.clone(), values.clone())).collect();
        Some(Self::new(scene, &set, if *zip { Arrangement::Zip } else { Arrangement::Grid }))
    }

    /// A sweep over values that have been read already.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub fn over(scene: &Scene, axes: Vec<Axis>, arrangement: Arrangement) -> Result<Self, Problem> {
        let rows = rows(&axes, arrangement)?;
        Ok(Self { places: base(scene)?, axes, arrangement, rows })
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// What is varied.
    #[must_use]
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// How the axes go together.
    #[must_use]
    pub fn arrangement(&self) -> Arrangement {
        self.arrangement
    }

    /// For each axis the number of its value in a row.
    #[must_use]
    pub fn picks(&self, row: usize) -> Vec<usize> {
        match self.arrangement {
            Arrangement::Zip => vec![row; self.axes.len()],
            Arrangement::Grid => {
                let mut rest = row;
                let pick = |axis: &Axis| {
                    let pick = rest % axis.values.len();
                    rest /= axis.values.len();
                    pick
                };
                let mut picks: Vec<usize> = self.axes.iter().rev().map(pick).collect();
                picks.reverse();
                picks
            }
        }
    }

    /// The values of a row, axis by axis.
    #[must_use]
    pub fn values(&self, row: usize) -> Vec<&Value> {
        self.axes.iter().zip(self.picks(row)).filter_map(|(axis, pick)| axis.values.get(pick)).collect()
    }

    /// Whether the figure of the sweep shows the curve of a row: at most seven rows, evenly spread over the first
    /// axis with the others in their middle, or over all rows that lie side by side.
    #[must_use]
    pub fn curves(&self, row: usize) -> Curves {
        let count = self.axes.first().map_or(0, |axis| axis.values.len());
        let shown = self.picks(row).first().is_some_and(|&pick| is_among(pick, count));
        if shown && self.is_in_the_middle(row, &[0]) { Curves::Kept } else { Curves::Absent }
    }

    /// Whether all axes of a grid but those `beside` have the middle of their values in a row; side by side there is
    /// nothing to hold fixed.
    #[must_use]
    pub fn is_in_the_middle(&self, row: usize, beside: &[usize]) -> bool {
        let axes = self.axes.iter().zip(self.picks(row)).enumerate();
        let middle =
            |(at, (axis, pick)): (usize, (&Axis, usize))| beside.contains(&at) || pick == axis.values.len() / 2;
        self.arrangement == Arrangement::Zip || axes.into_iter().all(middle)
    }

    /// The scene of a row.
    ///
    /// # Errors
    /// Its values cannot stand together.
    pub fn scene(&self, row: usize) -> Result<Scene, Problem> {
        let values = self.axes.iter().zip(self.values(row));
        let set: Vec<(&str, Value)> = values.map(|(axis, value)| (axis.path.as_str(), value.clone())).collect();
        self.places.with(&set)
    }
}

/// The places of a scene without the sweep it writes.
fn base(scene: &Scene) -> Result<Places, Problem> {
    Places::of(&Scene { sweep: None, ..scene.clone() })
}

/// Whether `number` is one of [`FAMILY`] numbers spread evenly over `count`, both ends included.
fn is_among(number: usize, count: usize) -> bool {
    count <= FAMILY || (0..FAMILY).any(|member| member * (count - 1) / (FAMILY - 1) == number)
}

fn rows(axes: &[Axis], arrangement: Arrangement) -> Result<usize, Problem> {
    let counts = || axes.iter().map(|axis| axis.values.len());
    let count = match (arrangement, axes.first()) {
        (_, None) => return Err(Problem::new("sweep", "varies nothing: expected a path with its values")),
        (Arrangement::Grid, _) => counts().try_fold(1, usize::checked_mul),
        (Arrangement::Zip, Some(first)) => {
            if let Some(other) = axes.iter().find(|axis| axis.values.len() != first.values.len()) {
                let message = format!(
                    "has {} values and {} has {}: side by side expected as many of each",
                    other.values.len(),
                    first.path,
                    first.values.len()
                );
                return Err(Problem::new(&other.path, message));
            }
            counts().next()
        }
    };
    let too_many = || Problem::new("sweep", format!("has more than {MOST} rows: expected fewer values"));
    count.filter(|&count| count <= MOST).ok_or_else(too_many)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::table::InMemory;

    const SCENE: &str = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
        adhesion: Jkr(work: 0.1), history: [Indent(to: 1, over: 1)])"#;

    fn sweep(set: &[(&str, &str)], arrangement: Arrangement) -> Result<Sweep, String> {
        let set: Vec<(String, Values)> =
            set.iter().map(|(path, values)| ((*path).to_owned(), values.parse().unwrap())).collect();
        Sweep::new(&Scene::from_ron(SCENE).unwrap(), &set, arrangement).map_err(|problem| problem.to_string())
    }

    #[test]
    fn the_last_axis_of_a_grid_runs_fastest() {
        let set = [("bodies.0.young", "[1, 2]"), ("adhesion.work", "[3, 4, 5]")];
        let grid = sweep(&set, Arrangement::Grid).unwrap();
        assert_eq!(grid.rows(), 6);
        let rows: Vec<Vec<f64>> =
            (0..6).map(|row| grid.values(row).iter().map(|value| value.as_f64().unwrap()).collect()).collect();
        assert_eq!(rows, [[1.0, 3.0], [1.0, 4.0], [1.0, 5.0], [2.0, 3.0], [2.0, 4.0], [2.0, 5.0]]);
        let zip = sweep(&[("bodies.0.young", "[1, 2]"), ("adhesion.work", "[3, 4]")], Arrangement::Zip).unwrap();
        assert_eq!((zip.rows(), zip.picks(1)), (2, vec![1, 1]));
    }

    #[test]
    fn a_wrong_sweep_is_refused_with_its_place() {
        let grid = |set: &[(&str, &str)]| sweep(set, Arrangement::Grid).unwrap_err();
        assert!(grid(&[("bodies.0.yung", "[1,2]")]).contains("did you mean `young`?"));
        assert!(grid(&[("adhesion.work", "1kg")]).contains("adhesion.work: \"1kg\" has the unit \"kg\""));
        assert!(grid(&[("adhesion.work", "1mJ..2mJ:3")]).contains("has the unit \"mJ\""));
        assert!(grid(&[("adhesion.work", "0..1:3log")]).contains("expected ends above zero"));
        assert!(grid(&[("title", "a..b:3")]).contains("title: a range needs numbers"));
        assert!(grid(&[("adhesion.work", "1"), ("adhesion.work", "2")]).contains("is set twice"));
        assert!(grid(&[]).contains("varies nothing"));
        let many = "1..2:100000";
        assert!(grid(&[("adhesion.work", many), ("bodies.0.young", many)]).contains("more than 10000000 rows"));
        let zip = sweep(&[("bodies.0.young", "[1, 2]"), ("adhesion.work", "[3]")], Arrangement::Zip).unwrap_err();
        assert_eq!(zip, "adhesion.work: has 1 values and bodies.0.young has 2: side by side expected as many of each");
    }

    /// A row is what the scene itself gives, to the bit; one that cannot be computed says why.
    #[test]
    fn a_row_is_its_scene() {
        use crate::run::{Wanted, run};
        let set = [("bodies.0.young", "1..3:3"), ("springs", "10..1000:3log"), ("adhesion.work", "[0, 0.3]")];
        let sweep = sweep(&set, Arrangement::Grid).unwrap();
        assert_eq!(sweep.axes()[1].values, [10, 100, 1000].map(Value::from));
        for number in 0..sweep.rows() {
            let row = sweep.row(number, &InMemory::default(), Curves::Absent);
            let plan = sweep.scene(number).unwrap().resolve(&InMemory::default()).unwrap();
            let outcome = run(&plan, Wanted { fields: true, ..Wanted::NOTHING }).unwrap();
            assert_eq!(row.failure, None);
            assert_eq!(row.results.len(), outcome.results.len());
            for (name, value) in &row.results {
                assert_eq!(value.as_f64(), outcome.number(name), "{name}");
            }
        }
    }

    #[test]
    fn a_row_that_cannot_be_computed_says_why() {
        let wavy = SCENE.replace("Paraboloid(radius: 1)", "WavyParaboloid(radius: 1, amplitude: 1e-9, wavelength: 1)");
        let wavy = wavy.replace("Jkr(work: 0.1)", "Maugis(work: 0.1, stress: 1)");
        let set = [("shape.amplitude".to_owned(), "[1e-9, 2e-9]".parse().unwrap())];
        let sweep = Sweep::new(&Scene::from_ron(&wavy).unwrap(), &set, Arrangement::Grid).unwrap();
        let row = sweep.row(1, &InMemory::default(), Curves::Absent);
        assert!(row.results.is_empty() && row.failure.is_some());
    }
}
