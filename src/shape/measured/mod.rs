//! Profile measured as a table of radius and height.

mod abel;
mod samples;
mod smoothed;

use super::{Moved, Profile, Rim};
use crate::input::table::{Columns, TableError, Tables};
use crate::numerics::monotone::{FEWEST as FEWEST_ROWS, Interpolant};
use crate::numerics::root;
use samples::Samples;
use std::path::Path;

/// A measured profile: heights f at rising radii r, joined by a monotone piecewise cubic.
///
/// The reduced profile is exact for the cubic, to rounding: over each piece the square-root kernel is
/// integrated with r = x sin θ, far pieces in blocks, in a time that grows with the logarithm of the
/// number of rows. Energy, pressure and displacement are quadratures over stored values: at
/// rounding for up to 2 048 rows, beyond it as good as 2 048 panels of 12 nodes. Points of a cone or of
/// a paraboloid give that shape back. The profile ends at the last row.
#[derive(Debug, Clone)]
pub struct Measured {
    samples: Samples,
    feature: Option<f64>,
    fall: Option<f64>,
    moved: Option<Moved>,
}

impl Measured {
    /// Reads the columns `radius_m` and `height_m` of a table.
    ///
    /// # Errors
    /// The table cannot be read; fewer than three rows; the first radius is not 0; radii that do not
    /// rise or heights that fall: with the row of the file.
    pub fn read(path: &Path, tables: &dyn Tables) -> Result<Self, TableError> {
        let Columns { values, rows } = tables.columns(path, &["radius_m", "height_m"])?;
        let [radii, heights] = <[Vec<f64>; 2]>::try_from(values)
            .map_err(|_| TableError::whole(path, "expected the columns radius_m and height_m"))?;
        check((&radii, &heights), &rows).map_err(|fault| told(path, fault))?;
        Ok(Self::joined(radii, heights))
    }

    /// Reads the same columns, whose heights may fall by noise, and makes them rise so that the contact stays a circle.
    ///
    /// # Errors
    /// As of [`read`](Self::read), but for heights that fall: those that do not rise from the first row to the last.
    pub fn smooth(path: &Path, tables: &dyn Tables) -> Result<Self, TableError> {
        let Columns { values, rows } = tables.columns(path, &["radius_m", "height_m"])?;
        let [radii, heights] = <[Vec<f64>; 2]>::try_from(values)
            .map_err(|_| TableError::whole(path, "expected the columns radius_m and height_m"))?;
        rising_radii(&radii, &rows).map_err(|fault| told(path, fault))?;
        let (found, moved) = smoothed::smoothed(&radii, &heights);
        if found[found.len() - 1] <= found[0] {
            return Err(TableError::whole(path, "the heights do not rise: expected a flank from the apex outwards"));
        }
        // Where g′ falls between rows though their secants rise, it is the cubic that does.
        Ok(Self { moved: Some(moved), fall: None, ..Self::joined(radii, found) })
    }

    fn joined(radii: Vec<f64>, heights: Vec<f64>) -> Self {
        let samples = Samples::new(Interpolant::new(radii, heights));
        let (feature, fall) = (feature(&samples), first_fall(&samples));
        Self { samples, feature, fall, moved: None }
    }
}

/// What is wrong, and in which row of the file.
type Wrong = (Option<usize>, String);

fn told(path: &Path, (row, message): Wrong) -> TableError {
    match row {
        Some(row) => TableError::at(path, row, message),
        None => TableError::whole(path, message),
    }
}

/// What is wrong with the radii.
fn rising_radii(radii: &[f64], rows: &[usize]) -> Result<(), Wrong> {
    if radii.len() < FEWEST_ROWS {
        return Err((None, format!("{} rows of numbers: expected at least {FEWEST_ROWS}", radii.len())));
    }
    if radii[0].abs() > 0.0 {
        let message =
            format!("radius_m = {:?}: expected 0 in the first row: one flank, from the apex outwards", radii[0]);
        return Err((rows.first().copied(), message));
    }
    for (i, &row) in rows.iter().enumerate().skip(1) {
        let (before, radius) = (radii[i - 1], radii[i]);
        if radius <= before {
            return Err((Some(row), format!("radius_m = {radius:?} after {before:?}: expected rising radii")));
        }
    }
    Ok(())
}

/// What is wrong with the columns.
fn check((radii, heights): (&[f64], &[f64]), rows: &[usize]) -> Result<(), Wrong> {
    rising_radii(radii, rows)?;
    for (i, &row) in rows.iter().enumerate().skip(1) {
        let (before, height) = (heights[i - 1], heights[i]);
        if height < before {
            let message = format!(
                "height_m = {height:?} after {before:?}: expected heights that do not fall, or SmoothTable(…) of heights with noise"
            );
            return Err((Some(row), message));
        }
    }
    if heights[heights.len() - 1] <= heights[0] {
        return Err((None, "all heights are the same: use FlatPunch(radius: …)".to_owned()));
    }
    Ok(())
}

/// `None` if g′√x never falls, so that adhesion gives one turning point only.
fn feature(samples: &Samples) -> Option<f64> {
    let mut before = 0.0;
    for (x, slope) in samples.slopes() {
        let now = slope * x.sqrt();
        if now < before * (1.0 - ROUGH) {
            return Some(samples.finest());
        }
        before = now;
    }
    None
}

/// Relative change that counts as a fall and not as rounding of the heights.
const ROUGH: f64 = 1e-9;

/// The radius at which g′ first becomes negative.
fn first_fall(samples: &Samples) -> Option<f64> {
    let largest = samples.slopes().map(|(_, slope)| slope.abs()).fold(0.0, f64::max);
    let mut before = 0.0;
    for (x, slope) in samples.slopes() {
        if slope < -ROUGH * largest {
            return Some(root::within(|x| -samples.at(x).slope, before, x));
        }
        before = x;
    }
    None
}

impl Profile for Measured {
    fn height(&self, r: f64) -> f64 {
        self.samples.interpolant().height(r)
    }

    fn reduced(&self, x: f64) -> f64 {
        if x > self.samples.end() { f64::INFINITY } else { x * self.samples.at(x).reduced }
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        if x > self.samples.end() { f64::INFINITY } else { self.samples.at(x).slope }
    }

    fn load_integral(&self, a: f64) -> f64 {
        self.samples.at(a).load
    }

    fn energy_integral(&self, a: f64) -> f64 {
        self.samples.energy(a)
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        self.samples.pressure(r, a)
    }

    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        self.samples.displacement(r, a)
    }

    fn edge(&self, d: f64) -> Option<f64> {
        if d <= 0.0 {
            return Some(self.flat_radius());
        }
        let (low, high) = self.samples.bracket(d)?;
        Some(root::within(|x| self.reduced(x) - d, low, high))
    }

    fn flat_radius(&self) -> f64 {
        self.samples.interpolant().flat()
    }

    fn rim(&self) -> Rim {
        Rim::End(self.samples.end())
    }

    fn scale(&self) -> f64 {
        self.samples.end()
    }

    fn feature(&self) -> Option<f64> {
        self.feature
    }

    fn first_fall(&self) -> Option<f64> {
        self.fall
    }

    fn moved(&self) -> Option<Moved> {
        self.moved
    }

    fn breaks(&self, a: f64) -> Vec<f64> {
        self.samples.ends(a)
    }

    /// Twice the largest difference to every other row at a few radii up to `a`: a cubic of second order at least errs
    /// by a third of it, but differences pass zero.
    fn sampling_error(&self, a: f64) -> f64 {
        let Some(coarse) = self.samples.interpolant().coarser().map(Samples::new) else { return 1.0 };
        let difference = |a: f64| {
            let (depth, load) = (self.reduced(a), self.load_integral(a));
            let (low, high) = coarse.bracket(depth).filter(|_| load > 0.0)?;
            let edge = root::within(|x| x * coarse.at(x).reduced - depth, low, high);
            Some((coarse.at(edge).load / load - 1.0).abs().max((edge / a - 1.0).abs()))
        };
        let radii = (0..6).map(|k| a * (1.0 - 0.02 * f64::from(k)));
        radii.filter_map(difference).reduce(f64::max).map_or(0.0, |error| (2.0 * error).min(1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::table::InMemory;
    use crate::shape::tests::laws::{metres, plain};
    use crate::shape::{Cone, Paraboloid, Sphere};
    use proptest::prelude::*;

    fn measured(radii: &[f64], height: impl Fn(f64) -> f64) -> Measured {
        let heights: Vec<f64> = radii.iter().map(|&r| height(r)).collect();
        let tables = InMemory::default().with("tip.csv", &[("radius_m", radii), ("height_m", &heights)]);
        Measured::read(Path::new("tip.csv"), &tables).unwrap()
    }

    fn even(count: u32) -> Vec<f64> {
        (0..count).map(|k| f64::from(k) / f64::from(count - 1)).collect()
    }

    /// Number of even steps as fine as the finest.
    fn rows(radii: &[f64]) -> f64 {
        radii.windows(2).map(|r| 1.0 / (r[1] - r[0])).fold(1.0, f64::max)
    }

    #[track_caller]
    fn near(value: f64, exact: f64, bound: f64) {
        assert!((value / exact - 1.0).abs() < bound, "{value:e} for {exact:e}: {:e}", value / exact - 1.0);
    }

    #[track_caller]
    fn same(table: &Measured, exact: &dyn Profile, rows: f64) {
        // Rounded heights over n even steps h: f″ is off by 2⁻⁵³f/h², and ∫f″√(x−r) over one piece by
        // h^{1/2} of it. Integrals see f′ only.
        let (bound, rough) = (1e-14 * (20.0 + rows), 1e-12 + 16.0 * f64::EPSILON * rows.powf(1.5));
        for a in [1e-3, 0.03, 0.2, 0.25, 0.4711, 0.9, 1.0] {
            near(table.height(a), exact.height(a), bound);
            near(table.reduced(a), exact.reduced(a), bound);
            near(table.reduced_slope(a), exact.reduced_slope(a), rough);
            near(table.load_integral(a), exact.load_integral(a), bound);
            near(table.energy_integral(a), exact.energy_integral(a), bound);
            near(table.edge(exact.reduced(a)).unwrap_or(1.0), a, bound);
            near(table.displacement_integral(a, a), exact.displacement_integral(a, a), bound);
            near(table.displacement_integral(1.7 * a, a), exact.displacement_integral(1.7 * a, a), bound);
            for part in [1e-3, 0.2, 0.5, 0.99] {
                near(table.pressure_integral(part * a, a), exact.pressure_integral(part * a, a), rough.max(1e-11));
            }
        }
    }

    #[test]
    fn points_of_a_cone_give_the_cone() {
        let cone = Cone { slope: plain(0.3) };
        for radii in [vec![0.0, 0.1, 1.0], vec![0.0, 0.6, 1.0], even(4), even(50), even(1000)] {
            let table = measured(&radii, |r| 0.3 * r);
            same(&table, &cone, rows(&radii));
            assert_eq!(table.first_fall(), None);
            assert_eq!(table.feature(), None);
        }
    }

    #[test]
    fn points_of_a_paraboloid_give_the_paraboloid() {
        let ball = Paraboloid { radius: metres(1.5) };
        for radii in [vec![0.0, 0.1, 1.0], vec![0.0, 0.6, 1.0], even(4), even(50), even(700)] {
            let table = measured(&radii, |r| r * r / 3.0);
            same(&table, &ball, rows(&radii));
            near(table.pressure_integral(0.0, 0.5), ball.pressure_integral(0.0, 0.5), 1e-11);
        }
    }

    #[test]
    fn points_of_a_sphere_converge_with_the_second_order_of_the_slopes() {
        let ball = Sphere { radius: metres(1.5) };
        let load = |count| measured(&even(count), |r| ball.height(r)).load_integral(0.9);
        let error = |count| (load(count) / ball.load_integral(0.9) - 1.0).abs();
        for count in [41, 81, 161] {
            // f′ at the points is off by h²f‴/6, f‴ = 3R²r/(R²−r²)^{5/2} ≤ 2.2/R² up to 0.9.
            let h = 1.0 / f64::from(count - 1);
            assert!(error(count) < 2.2 / 1.5 * h * h / 6.0, "{count}: {:e}", error(count));
        }
    }

    /// The blocks against the plain sum over all pieces.
    #[test]
    fn blocks_agree_with_the_plain_sum() {
        let mut radii = vec![0.0];
        let mut step = 1e-6;
        for k in 0..3000u32 {
            step *= if k % 7 == 0 { 1.9 } else { 0.9 };
            radii.push(radii[radii.len() - 1] + step);
        }
        let wavy = |r: f64| r * r + 0.05 * r * (1.0 - (3.0 * r.ln_1p()).cos());
        let heights: Vec<f64> = radii.iter().map(|&r| wavy(r)).collect();
        let interpolant = Interpolant::new(radii.clone(), heights);
        let blocks = abel::Abel::new(&interpolant);
        for k in [1, 5, 33, 64, 100, 999, 1500, 2999] {
            let x = 0.3 * radii[k] + 0.7 * radii[k + 1];
            let (fast, plain) = (blocks.at(&interpolant, x), abel::plain(&interpolant, x));
            near(fast.reduced, plain.reduced, 1e-13);
            near(fast.load, plain.load, 1e-13);
            near(fast.slope, plain.slope, 1e-11);
        }
    }

    /// A million rows: read once, then a hundred states with force, energy and pressure.
    #[test]
    #[ignore = "takes a second; run with --release to see the time"]
    fn a_million_rows_stay_usable() {
        let ball = Paraboloid { radius: metres(1.5) };
        let radii = even(1_000_001);
        let start = std::time::Instant::now();
        let table = measured(&radii, |r| r * r / 3.0);
        let ready = start.elapsed();
        for k in 1..=100 {
            let a = 0.01 * f64::from(k);
            let edge = table.edge(ball.reduced(a)).unwrap_or(1.0);
            near(edge, a, 1e-9);
            near(table.load_integral(edge), ball.load_integral(a), 1e-9);
            near(table.energy_integral(edge), ball.energy_integral(a), 1e-9);
        }
        let states = start.elapsed() - ready;
        for k in 0..100 {
            let r = 0.009 * f64::from(k);
            near(table.pressure_integral(r, 0.9), ball.pressure_integral(r, 0.9), 1e-7);
        }
        let pressures = start.elapsed() - ready - states;
        println!("ready {ready:?}, 100 states {states:?}, 100 pressures {pressures:?}");
    }

    fn smooth(radii: &[f64], heights: &[f64]) -> Measured {
        let tables = InMemory::default().with("tip.csv", &[("radius_m", radii), ("height_m", heights)]);
        Measured::smooth(Path::new("tip.csv"), &tables).unwrap()
    }

    /// What rises as it should stays as it is.
    #[test]
    fn a_clean_profile_is_not_moved() {
        for height in [|r: f64| r * r / 3.0, |r: f64| 0.3 * r, |r: f64| 2.0 - (4.0 - r * r).sqrt()] {
            let radii = even(200);
            let heights: Vec<f64> = radii.iter().map(|&r| height(r)).collect();
            let moved = smooth(&radii, &heights).moved().unwrap();
            assert!(moved.largest < 1e-14, "{moved:?}");
        }
    }

    proptest! {
        /// A paraboloid with even noise of ±1 % of its height: the contact stays a circle, and the profile comes nearer to
        /// the paraboloid than the measurement was.
        #[test]
        fn noise_is_taken_off(draws in prop::collection::vec(-1000i32..1000, 201)) {
            let radii = even(201);
            let noise: Vec<f64> = draws.iter().map(|draw| 1e-5 / 3.0 * f64::from(*draw)).collect();
            let heights: Vec<f64> = radii.iter().zip(&noise).map(|(r, noise)| r * r / 3.0 + noise).collect();
            let table = smooth(&radii, &heights);
            let depth = |k: u32| table.reduced(f64::from(k) / 200.0);
            // Where it is level it is so to the rounding of its height.
            prop_assert!((1..=200).all(|k| depth(k - 1) <= depth(k) + f64::EPSILON * depth(200)));
            // Heights count from their own zero.
            let square = |off: &dyn Fn(usize) -> f64| {
                let mean = (0..201).map(off).sum::<f64>() / 201.0;
                (0..201).map(|k| (off(k) - mean).powi(2)).sum::<f64>()
            };
            let left = square(&|k| table.height(radii[k]) - radii[k] * radii[k] / 3.0);
            prop_assert!(left < 0.25 * square(&|k| noise[k]), "{left}");
        }
    }

    #[test]
    fn a_terrace_breaks_the_connection() {
        let table = measured(&even(101), |r| if r < 0.5 { 0.2 * r } else { 0.1 + (r - 0.7).max(0.0) });
        let end = table.first_fall().unwrap();
        assert!(end > 0.49 && end < 0.53, "{end}");
        assert!(table.feature().is_some());
    }

    #[test]
    fn a_flat_in_the_middle_is_the_flat_radius() {
        let table = measured(&even(11), |r| (r - 0.3).max(0.0));
        near(table.edge(0.0).unwrap(), 0.3, 1e-15);
    }

    /// A ball in few rows: the error stated is above the true one and falls with the square of the spacing.
    #[test]
    fn what_lies_between_the_rows_is_stated() {
        let ball = Sphere { radius: metres(1.0) };
        let mut before = f64::INFINITY;
        for count in [8_u32, 24, 72, 216] {
            let radii: Vec<f64> = (0..=count).map(|k| 0.95 * f64::from(k) / f64::from(count)).collect();
            let measured = measured(&radii, |r| ball.height(r));
            for a in [0.3, 0.6, 0.9] {
                let edge = ball.edge(measured.reduced(a)).unwrap();
                let force = (measured.load_integral(a) / ball.load_integral(edge) - 1.0).abs();
                let (real, stated) = (force.max((a / edge - 1.0).abs()), measured.sampling_error(a));
                assert!(real <= stated, "{count} rows, {a}: {real:e} {stated:e}");
            }
            let stated = measured.sampling_error(0.6);
            assert!(stated < before / 3.0, "{count} rows: {stated:e} after {before:e}");
            before = stated;
        }
        let paraboloid = measured(&[0.0, 1.0, 2.0, 3.0, 4.0], |r| 0.5 * r * r);
        assert!(paraboloid.sampling_error(2.5) < 1e-14, "points of a paraboloid give it back");
    }

    #[test]
    fn errors_name_the_row_of_the_file() {
        let message = |radii: &[f64], heights: &[f64]| {
            let tables = InMemory::default().with("tip.csv", &[("radius_m", radii), ("height_m", heights)]);
            Measured::read(Path::new("tip.csv"), &tables).unwrap_err().to_string()
        };
        assert_eq!(message(&[0.0, 1.0], &[0.0, 1.0]), "tip.csv: 2 rows of numbers: expected at least 3");
        let text = message(&[0.1, 1.0, 2.0], &[0.0; 3]);
        assert_eq!(
            text,
            "tip.csv, row 2: radius_m = 0.1: expected 0 in the first row: one flank, from the apex outwards"
        );
        let text = message(&[0.0, 1.0, 1.0], &[0.0; 3]);
        assert_eq!(text, "tip.csv, row 4: radius_m = 1.0 after 1.0: expected rising radii");
        let text = message(&[0.0, 1.0, 2.0], &[0.0, 2.0, 1.0]);
        assert_eq!(
            text,
            "tip.csv, row 4: height_m = 1.0 after 2.0: expected heights that do not fall, or SmoothTable(…) of heights with noise"
        );
        let text = message(&[0.0, 1.0, 2.0], &[1.0; 3]);
        assert_eq!(text, "tip.csv: all heights are the same: use FlatPunch(radius: …)");
    }
}
