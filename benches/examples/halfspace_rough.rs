//! Ten loads on a periodic self-affine surface, time and iterations:
//! `cargo run --release -p benches --example halfspace_rough -- 256 512` makes its own surfaces (Hurst exponent 0.8,
//! wave numbers from 4 to n/8 of 1/L, rms slope 0.1); `-- heights.npy` reads one (square, f64, period 1 m).
use ndarray::Array2;
use rustfft::{FftPlanner, num_complex::Complex};
use springbed::halfspace::{Boundary, Prescribed, PressedMap, Settings, Solution, Start, solve};
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("grid start cpu_s wall_s iterations_of_ten area_fractions peak_mb");
    for word in std::env::args().skip(1) {
        let heights = match word.parse::<usize>() {
            Ok(n) => self_affine(n),
            Err(_) => read(&word)?,
        };
        press(&heights, "coarser")?;
        press(&heights, "last load")?;
    }
    Ok(())
}

/// Ten pressures up to 0.005 E*, each started from a coarser grid or from the last one.
fn press(heights: &Array2<f64>, kind: &str) -> Result<(), Box<dyn std::error::Error>> {
    let settings = Settings { tolerance: 1e-6, ..Settings::default() };
    let (clock, begun) = (cpu_seconds(), Instant::now());
    let mut last: Option<Solution> = None;
    let (mut iterations, mut fractions) = (0, Vec::new());
    for load in 1..=10 {
        let control = Prescribed::Force(0.0005 * f64::from(load));
        let pixel = [1.0 / heights.nrows() as f64; 2];
        let problem =
            PressedMap { heights: heights.view(), pixel, modulus: 1.0, boundary: Boundary::Periodic, control };
        let start = match &last {
            Some(solution) if kind == "last load" => Start::Pressure(solution.pressure.view()),
            _ => Start::Coarser,
        };
        let solution = solve(&problem, start, &settings)?;
        iterations += solution.iterations;
        fractions.push(solution.area_fraction());
        last = Some(solution);
    }
    let (busy, wall) = (cpu_seconds() - clock, begun.elapsed().as_secs_f64());
    println!("{} {kind} {busy:.3} {wall:.3} {iterations} {fractions:.5?} {:.0}", heights.nrows(), peak_memory_mb());
    Ok(())
}

/// Random-phase surface of rms slope 0.1 and period 1.
fn self_affine(n: usize) -> Array2<f64> {
    let mut seed = 1_u64;
    let mut waves = vec![Complex::default(); n * n];
    let signed = |k: usize| if 2 * k > n { k as f64 - n as f64 } else { k as f64 };
    let mut slope = 0.0;
    for (index, wave) in waves.iter_mut().enumerate() {
        let q = signed(index / n).hypot(signed(index % n));
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if (4.0..=n as f64 / 8.0).contains(&q) {
            *wave =
                Complex::from_polar(q.powf(-1.8), std::f64::consts::TAU * (seed >> 11) as f64 / (1_u64 << 53) as f64);
            // The real part of the sum keeps half of the square of each wave.
            slope += 0.5 * (std::f64::consts::TAU * q * wave.norm()).powi(2);
        }
    }
    let plan = FftPlanner::new().plan_fft_inverse(n);
    plan.process(&mut waves);
    let mut turned = Array2::from_shape_fn((n, n), |(row, column)| waves[column * n + row]).into_raw_vec_and_offset().0;
    plan.process(&mut turned);
    Array2::from_shape_fn((n, n), |(row, column)| 0.1 / slope.sqrt() * turned[row * n + column].re)
}

/// Square matrix of a NumPy file of 64-bit floats, row after row.
fn read(path: &str) -> Result<Array2<f64>, Box<dyn std::error::Error>> {
    let bytes = std::fs::read(path)?;
    let start = 10 + usize::from(bytes[8]) + 256 * usize::from(bytes[9]);
    let values: Vec<f64> = bytes[start..].as_chunks().0.iter().map(|chunk| f64::from_le_bytes(*chunk)).collect();
    let n = values.len().isqrt();
    Ok(Array2::from_shape_vec((n, n), values)?)
}

/// Largest resident memory of this process so far [MB].
fn peak_memory_mb() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.trim().trim_end_matches("kB").trim().parse::<f64>().ok()).unwrap_or(f64::NAN) / 1024.0
}

/// Processor time of all threads of this process \[s\]; a shared machine does not change it much.
fn cpu_seconds() -> f64 {
    let threads = std::fs::read_dir("/proc/self/task").into_iter().flatten().flatten();
    let nanoseconds = threads.filter_map(|thread| {
        let text = std::fs::read_to_string(thread.path().join("schedstat")).ok()?;
        text.split(' ').next()?.parse::<f64>().ok()
    });
    nanoseconds.sum::<f64>() * 1e-9
}
