//! How much a kernel does in a second, and how that grows with springs, terms, records and threads.

use super::clock::quickest;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::direct::Direct;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::lazy::Lazy;
use crate::contact::viscoelastic::memory::Memory;
use crate::friction::oblique::{Ball, BallMotion, SOLID};
use crate::friction::{CoulombBed, Grip, Pose, TangentialMemory};
use crate::input::quantity::Length;
use crate::material::Relaxation;
use crate::shape::Paraboloid;
use rayon::prelude::*;
use serde::Serialize;
use std::hint::black_box;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Time of one kernel at one size.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The kernel.
    pub kernel: &'static str,
    /// What is counted, such as `springs`.
    pub counted: &'static str,
    /// How many of them.
    pub size: usize,
    /// Least time of one run [s].
    pub time_s: f64,
    /// Time of one of what is counted [s].
    pub each_s: f64,
    /// What the time is compared with, in the same run; empty if with nothing.
    pub beside: &'static str,
    /// Time over the time of that.
    pub ratio: Option<f64>,
}

/// A kernel to be timed.
pub struct Kernel {
    name: &'static str,
    counted: &'static str,
    size: usize,
    /// Name of what it is compared with: the kernel just before it.
    beside: &'static str,
    prepare: Box<dyn Fn() -> Option<Work>>,
}

type Work = Box<dyn FnMut() -> bool>;

/// Times the kernels in order; `done` is called after each. A kernel that fails has a NaN for its time.
pub fn rows(kernels: &[Kernel], budget: Duration, mut done: impl FnMut()) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for kernel in kernels {
        let before = rows.last().filter(|_| !kernel.beside.is_empty()).map(|row| row.time_s);
        rows.push(kernel.row(before, budget));
        done();
    }
    rows
}

impl Kernel {
    fn new<W: FnMut() -> bool + 'static>(
        (name, counted): (&'static str, &'static str),
        size: usize,
        prepare: impl Fn() -> Option<W> + 'static,
    ) -> Self {
        let prepare = Box::new(move || prepare().map(|work| Box::new(work) as Work));
        Self { name, counted, size, beside: "", prepare }
    }

    fn beside(mut self, other: &'static str) -> Self {
        self.beside = other;
        self
    }

    #[expect(clippy::cast_precision_loss, reason = "sizes are far below 2^53")]
    fn row(&self, before: Option<f64>, budget: Duration) -> Row {
        let time = (self.prepare)().map_or(f64::NAN, |mut work| {
            let start = Instant::now();
            if work() { quickest(&mut *work, start.elapsed(), budget) } else { f64::NAN }
        });
        Row {
            kernel: self.name,
            counted: self.counted,
            size: self.size,
            time_s: time,
            each_s: time / self.size as f64,
            beside: self.beside,
            ratio: before.map(|before| time / before),
        }
    }
}

/// All kernels; those compared with another stand just behind it.
#[must_use]
pub fn all() -> Vec<Kernel> {
    let mut kernels = vec![state(0.0, "Hertz state"), state(1.0, "JKR state")];
    kernels.extend([100, 1000, 10_000].map(curve));
    kernels.extend([1, 3, 10].map(ting));
    kernels.push(lazy(1000));
    kernels.push(lazy(1_000_000).beside("the same with 1000 springs"));
    for springs in [1000, 1_000_000] {
        kernels.push(copy(springs));
        kernels.push(direct(springs).beside("a copy of the same arrays"));
    }
    kernels.extend([1000, 10_000].map(fretting));
    kernels.push(coulomb());
    kernels.push(oblique());
    #[cfg(feature = "half-space")]
    kernels.extend([64, 128, 256].map(grid));
    kernels.push(scenes(1));
    kernels.push(scenes(2).beside("the same on 1 thread"));
    kernels
}

fn ball() -> Option<Paraboloid> {
    Some(Paraboloid { radius: Length::new(1.0).ok()? })
}

fn contact(ball: &Paraboloid, work: f64) -> QuasiStatic {
    QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(ball.clone()), 1.0), work))
}

/// Depth in, force and radius out.
fn state(work: f64, name: &'static str) -> Kernel {
    Kernel::new((name, "states"), 1, move || {
        let ball = ball()?;
        Some(move || {
            let mut contact = contact(&ball, work);
            contact.indent(black_box(0.5)).is_ok() && black_box(contact.present().balance.force).is_finite()
        })
    })
}

/// Approach and retraction of an adhesive ball.
fn curve(records: u32) -> Kernel {
    Kernel::new(("JKR curve", "records"), records as usize, move || {
        let ball = ball()?;
        let depths: Vec<f64> =
            (0..records).map(|k| 1.0 - 2.5 * (1.0 - 2.0 * f64::from(k) / f64::from(records)).abs()).collect();
        Some(move || {
            let mut contact = contact(&ball, 1.0);
            depths.iter().all(|&depth| contact.indent(depth).is_ok() && !contact.present().balance.force.is_nan())
        })
    })
}

/// `count` terms, one per decade around a second.
fn spectrum(count: i32) -> Arc<Spectrum> {
    let terms = (0..count).map(|k| (1.0 + f64::from(k), 10f64.powi(k - count / 2))).collect();
    Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.0 }))
}

/// A triangle by the continuous bed, 50 forces on the way in and 50 out.
fn ting(terms: u16) -> Kernel {
    Kernel::new(("Ting triangle, 100 forces", "terms"), usize::from(terms), move || {
        let (spectrum, ball) = (spectrum(i32::from(terms)), Arc::new(ball()?));
        Some(move || {
            let mut bed = Memory::new(spectrum.clone(), ball.clone());
            [0.01, -0.01].into_iter().all(|speed| {
                (1..=50).all(|k| bed.force_after(speed, f64::from(k) / 50.0).is_ok()) && bed.advance(speed, 1.0).is_ok()
            })
        })
    })
}

/// A step in which nothing is touched or released, ten terms.
fn lazy(springs: usize) -> Kernel {
    Kernel::new(("lazy bed, a step with 10 terms", "springs"), springs, move || {
        let mut bed = Lazy::new(spectrum(10), Layout::uniform(&ball()?, 1.0, springs));
        bed.advance(1e-4, 1.0);
        let mut speed = 1e-9;
        Some(move || {
            speed = -speed;
            bed.advance(black_box(speed), 1e-3);
            black_box(bed.force()).is_finite()
        })
    })
}

/// Every spring and term updated.
fn direct(springs: usize) -> Kernel {
    Kernel::new(("direct bed, a step with 10 terms", "springs and terms"), 10 * springs, move || {
        let mut bed = Direct::new(spectrum(10), Layout::uniform(&ball()?, 0.1, springs));
        bed.advance(0.011, 1.0);
        let mut speed = 1e-9;
        Some(move || {
            speed = -speed;
            bed.advance(black_box(speed), 1e-3);
            true
        })
    })
}

fn copy(springs: usize) -> Kernel {
    Kernel::new(("copy of numbers", "numbers"), 10 * springs, move || {
        let (from, mut to) = (vec![1.0f64; 10 * springs], vec![0.0f64; 10 * springs]);
        Some(move || {
            to.copy_from_slice(black_box(&from));
            black_box(&to);
            true
        })
    })
}

const GRIP: Grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient: 0.3 };

fn shaken(records: u32) -> Vec<Pose> {
    (0..records).map(|k| Pose { indentation: 1.0, slide: 0.25 * (0.02 * f64::from(k)).sin() }).collect()
}

/// A loop by turning points.
fn fretting(records: u32) -> Kernel {
    Kernel::new(("fretting loop, turning points", "records"), records as usize, move || {
        let (ball, path) = (ball()?, shaken(records));
        Some(move || {
            let mut memory = TangentialMemory::new(Arc::new(ball.clone()), GRIP);
            path.iter().all(|&to| memory.advance(to).is_ok() && memory.state().tangential_force.is_finite())
        })
    })
}

/// A loop of 100 records by springs.
fn coulomb() -> Kernel {
    let springs = 100_000;
    Kernel::new(("fretting loop, bed of 100 000 springs", "records"), 100, move || {
        let (path, ball) = (shaken(100), ball()?);
        let bed = CoulombBed::new(&ball, GRIP, NonZeroUsize::new(springs)?, 1.1).ok()?;
        Some(move || bed.clone().advance(black_box(&path)).iter().all(|force| force.is_finite()))
    })
}

/// Angles of incidence from the normal to 88°.
fn oblique() -> Kernel {
    Kernel::new(("oblique impacts", "angles"), 100, || {
        let grip = Grip { normal_modulus: 115e9, tangential_modulus: 95e9, coefficient: 0.1 };
        let ball = Ball { grip, radius: 5e-3, mass: 4e-3, gyration: SOLID };
        let flight = |k: i32| {
            let (sine, cosine) = (0.89 * f64::from(k)).to_radians().sin_cos();
            BallMotion { normal_speed: cosine, tangential_speed: sine, spin: 0.0 }
        };
        let flights: Vec<BallMotion> = (0..100).map(flight).collect();
        Some(move || ball.hits(black_box(&flights), 1e-6).is_ok())
    })
}

/// Hertz on the full half-space.
#[cfg(feature = "half-space")]
fn grid(n: u16) -> Kernel {
    use crate::halfspace::{Boundary, Prescribed, PressedMap, Settings, Start, solve};
    let pixels = usize::from(n) * usize::from(n);
    Kernel::new(("half-space, Hertz", "pixels"), pixels, move || {
        let pixel = 0.3 / f64::from(n);
        #[expect(clippy::cast_precision_loss, reason = "grids are far below 2^53")]
        let place = move |index: usize| (index as f64 - 0.5 * f64::from(n)) * pixel;
        let shape = (usize::from(n), usize::from(n));
        let heights =
            ndarray::Array2::from_shape_fn(shape, |(row, column)| 0.5 * (place(row).powi(2) + place(column).powi(2)));
        Some(move || {
            let problem = PressedMap {
                heights: heights.view(),
                pixel: [pixel; 2],
                modulus: 1.0,
                boundary: Boundary::Free,
                control: Prescribed::Indentation(0.01),
            };
            solve(&problem, Start::Coarser, &Settings::default()).is_ok()
        })
    })
}

/// Ten thousand curves of ten records each, on a number of threads.
fn scenes(threads: usize) -> Kernel {
    let name = if threads == 1 { "10 000 adhesive curves, 1 thread" } else { "10 000 adhesive curves, 2 threads" };
    Kernel::new((name, "curves"), 10_000, move || {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok()?;
        let ball = ball()?;
        let one = move |k: u32| {
            let mut contact = contact(&ball, 0.5 + f64::from(k) * 1e-4);
            (0..10).all(|step| contact.indent(0.2 * f64::from(step)).is_ok())
        };
        Some(move || pool.install(|| (0..10_000u32).into_par_iter().all(&one)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kernel_runs_and_ratios_belong_to_the_kernel_before() {
        let small: Vec<Kernel> = all().into_iter().filter(|kernel| kernel.size <= 1000).collect();
        let rows = rows(&small, Duration::ZERO, || ());
        assert!(rows.len() > 8 && rows.iter().all(|row| row.time_s > 0.0), "{rows:#?}");
        let kernel = |run: fn() -> bool| Kernel::new(("", ""), 2, move || Some(run));
        let pair = [kernel(|| true), kernel(|| true).beside("the first")];
        let rows = super::rows(&pair, Duration::ZERO, || ());
        assert!(
            rows[0].ratio.is_none() && (rows[1].ratio.unwrap() * rows[0].time_s / rows[1].time_s - 1.0).abs() < 1e-12
        );
        assert!(super::rows(&[kernel(|| false)], Duration::ZERO, || ())[0].time_s.is_nan());
    }
}
