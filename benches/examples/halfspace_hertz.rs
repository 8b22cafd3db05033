//! Error, time and memory of the half-space solver on the Hertz contact: `cargo run --release -p benches --example halfspace_hertz 512 1024`.
use ndarray::Array2;
use springbed::halfspace::{Boundary, Prescribed, PressedMap, Settings, Start, solve};
use std::time::Instant;

fn main() {
    let (radius, depth) = (1.0, 0.01_f64);
    let contact = (radius * depth).sqrt();
    let force = 4.0 / 3.0 * contact * depth;
    println!("grid force_error radius_error peak_error iterations products residual cpu_s wall_s peak_mb");
    for n in std::env::args().skip(1).filter_map(|word| word.parse::<usize>().ok()) {
        let pixel = 3.0 * contact / n as f64;
        let heights = Array2::from_shape_fn((n, n), |(row, column)| {
            let place = |index: usize| (index as f64 - (n / 2) as f64) * pixel;
            (place(row).powi(2) + place(column).powi(2)) / (2.0 * radius)
        });
        let problem = PressedMap {
            heights: heights.view(),
            pixel: [pixel; 2],
            modulus: 1.0,
            boundary: Boundary::Free,
            control: Prescribed::Indentation(depth),
        };
        let (clock, begun) = (cpu_seconds(), Instant::now());
        let solved = solve(&problem, Start::Coarser, &Settings::default());
        let (busy, wall) = (cpu_seconds() - clock, begun.elapsed().as_secs_f64());
        match solved {
            Ok(solution) => println!(
                "{n} {:.3e} {:.3e} {:.3e} {} {} {:.2e} {busy:.3} {wall:.3} {:.0}",
                solution.force() / force - 1.0,
                solution.contact_radius() / contact - 1.0,
                solution.peak_pressure() * std::f64::consts::PI * radius / (2.0 * contact) - 1.0,
                solution.iterations,
                solution.products,
                solution.residual,
                peak_memory_mb()
            ),
            Err(error) => println!("{n} {error}"),
        }
    }
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
