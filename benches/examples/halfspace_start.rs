//! What a good start saves: iterations of the half-space solver on the Hertz contact from nothing, from a coarser grid and from
//! the pressure of the spring bed: `cargo run --release -p benches --example halfspace_start -- 128 256 512`.
use ndarray::Array2;
use springbed::contact::foundation::Foundation;
use springbed::contact::model::Loading;
use springbed::contact::springs::SpringBed;
use springbed::halfspace::{Boundary, HalfSpaceError, Prescribed, PressedMap, Settings, Start, solve};
use springbed::input::quantity::{Length, QuantityError};
use springbed::shape::Paraboloid;
use std::sync::Arc;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("| grid | from nothing | from a coarser grid | from the spring bed |\n|---|---|---|---|");
    for n in std::env::args().skip(1).filter_map(|word| word.parse::<usize>().ok()) {
        let [nothing, coarser, bed] = iterations(n)?;
        println!("| {n}² | {nothing} | {coarser} | {bed} |");
    }
    Ok(())
}

/// Iterations on the finest grid to a residual of 1e-8, window of three contact radii.
fn iterations(n: usize) -> Result<[usize; 3], HalfSpaceError> {
    let (depth, radius) = (0.01, 0.1);
    let pixel = 3.0 * radius / n as f64;
    let place = |index: usize| (index as f64 - (n / 2) as f64) * pixel;
    let distance = |(row, column): (usize, usize)| place(row).hypot(place(column));
    let heights = Array2::from_shape_fn((n, n), |at| 0.5 * distance(at).powi(2));
    let problem = PressedMap {
        heights: heights.view(),
        pixel: [pixel; 2],
        modulus: 1.0,
        boundary: Boundary::Free,
        control: Prescribed::Indentation(depth),
    };
    let rings = bed_pressure(depth, 1.1 * radius).unwrap_or_default();
    let sample = |at| rings.get(rings.partition_point(|ring| ring.0 < distance(at))).map_or(0.0, |ring| ring.1);
    let start = Array2::from_shape_fn((n, n), sample);
    let count = |start: Start<'_>| Ok(solve(&problem, start, &Settings::default())?.iterations);
    Ok([count(Start::Nothing)?, count(Start::Coarser)?, count(Start::Pressure(start.view()))?])
}

/// Pressure of a bed of 4096 springs at 4097 radii out to `reach` [m], with the radii.
fn bed_pressure(depth: f64, reach: f64) -> Result<Vec<(f64, f64)>, QuantityError> {
    let ball = Paraboloid { radius: Length::new(1.0)? };
    let mut bed = SpringBed::new(Foundation::new(Arc::new(ball.clone()), 1.0), 4096, reach, 0.0);
    bed.indent(depth);
    let loads = bed.spring_loads();
    let radii = (0..=4096).map(|k| reach * f64::from(k) / 4096.0);
    Ok(radii.map(|r| (r, loads.pressure(r).unwrap_or(0.0).max(0.0))).collect())
}
