//! How much a kernel does in a second, and how that grows with springs, terms, records and threads.
//!
//! # Examples
//! ```
//! use springbed::check::speed::{kernels, rows};
//! use std::time::Duration;
//!
//! // The first kernel, run once.
//! let rows = rows(&kernels()[..1], Duration::ZERO, |_| ());
//! assert!(rows[0].method == "Hertz state" && rows[0].times.is_some());
//! ```

use super::case::Attempt;
use super::contacts::{jkr, paraboloid};
use super::row::{Computed, Row, Setting};
use super::study::Method;
use crate::contact::viscoelastic::direct::Direct;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::lazy::Lazy;
use crate::contact::viscoelastic::memory::Memory;
use crate::friction::oblique::{Ball, BallMotion, SOLID};
use crate::friction::{CoulombBed, Grip, Pose, TangentialMemory};
use crate::material::{Relaxation, Spectrum};
use rayon::prelude::*;
use std::hint::black_box;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::time::Duration;

/// A kernel to be timed.
pub struct Kernel {
    method: Method<()>,
    /// What its time is compared with: the kernel just before it.
    beside: Option<&'static str>,
}

impl Kernel {
    fn new<R: FnMut() -> Attempt<()> + 'static>(
        name: &'static str,
        counted: &'static str,
        size: usize,
        prepare: impl Fn() -> Attempt<R> + 'static,
    ) -> Self {
        let setting = Setting { counted: Some((counted, size)), ..Setting::FREE };
        Self { method: Method::new(name, setting, prepare), beside: None }
    }

    fn beside(self, other: &'static str) -> Self {
        Self { beside: Some(other), ..self }
    }

    fn row(&self, budget: Duration) -> Row {
        self.method.row(budget, |()| Computed::default())
    }
}

/// All kernels; those compared with another stand just behind it.
#[must_use]
pub fn kernels() -> Vec<Kernel> {
    let mut kernels = vec![state("Hertz state", 0.0), state("JKR state", 1.0)];
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
    kernels.push(scenes("10 000 adhesive curves, 1 thread", 1));
    kernels.push(scenes("10 000 adhesive curves, 2 threads", 2).beside("the same on 1 thread"));
    kernels
}

/// Times the kernels in order; `done` is told the share that is behind.
pub fn rows(kernels: &[Kernel], budget: Duration, mut done: impl FnMut(f64)) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for kernel in kernels {
        let row = kernel.row(budget);
        let times = rows.last().and_then(|before| Some(row.times?.warm / before.times?.warm));
        rows.push(Row { beside: kernel.beside.zip(times), ..row });
        #[expect(clippy::cast_precision_loss, reason = "few kernels")]
        done(rows.len() as f64 / kernels.len() as f64);
    }
    rows
}

/// A force that is a number.
fn number(force: f64) -> Attempt<()> {
    if force.is_nan() { Err("the force is no number".into()) } else { Ok(()) }
}

/// Depth in, force and radius out.
fn state(name: &'static str, work: f64) -> Kernel {
    Kernel::new(name, "states", 1, move || {
        let ball = paraboloid(1.0)?;
        Ok(move || {
            let mut contact = jkr(ball.clone(), 1.0, work);
            contact.indent(black_box(0.5))?;
            number(black_box(contact.present().balance.force))
        })
    })
}

/// BallMotion and retraction of an adhesive ball.
fn curve(records: u32) -> Kernel {
    Kernel::new("JKR curve", "records", records as usize, move || {
        let ball = paraboloid(1.0)?;
        let part = |k: u32| 1.0 - 2.0 * f64::from(k) / f64::from(records);
        let depths: Vec<f64> = (0..records).map(|k| 1.0 - 2.5 * part(k).abs()).collect();
        Ok(move || {
            let mut contact = jkr(ball.clone(), 1.0, 1.0);
            depths.iter().try_for_each(|&depth| {
                contact.indent(depth)?;
                number(contact.present().balance.force)
            })
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
    Kernel::new("Ting triangle, 100 forces", "terms", usize::from(terms), move || {
        let (spectrum, ball) = (spectrum(i32::from(terms)), paraboloid(1.0)?);
        Ok(move || {
            let mut bed = Memory::new(spectrum.clone(), ball.clone());
            for speed in [0.01, -0.01] {
                for k in 1..=50 {
                    bed.force_after(speed, f64::from(k) / 50.0)?;
                }
                bed.advance(speed, 1.0)?;
            }
            Ok(())
        })
    })
}

/// A step in which nothing is touched or released, ten terms.
fn lazy(springs: usize) -> Kernel {
    Kernel::new("lazy bed, a step with 10 terms", "springs", springs, move || {
        let mut bed = Lazy::new(spectrum(10), Layout::uniform(paraboloid(1.0)?.as_ref(), 1.0, springs));
        bed.advance(1e-4, 1.0);
        let mut speed = 1e-9;
        Ok(move || {
            speed = -speed;
            bed.advance(black_box(speed), 1e-3);
            number(black_box(bed.force()))
        })
    })
}

/// Every spring and term updated.
fn direct(springs: usize) -> Kernel {
    Kernel::new("direct bed, a step with 10 terms", "springs and terms", 10 * springs, move || {
        let mut bed = Direct::new(spectrum(10), Layout::uniform(paraboloid(1.0)?.as_ref(), 0.1, springs));
        bed.advance(0.011, 1.0);
        let mut speed = 1e-9;
        Ok(move || {
            speed = -speed;
            bed.advance(black_box(speed), 1e-3);
            Ok(())
        })
    })
}

fn copy(springs: usize) -> Kernel {
    Kernel::new("copy of numbers", "numbers", 10 * springs, move || {
        let (from, mut to) = (vec![1.0f64; 10 * springs], vec![0.0f64; 10 * springs]);
        Ok(move || {
            to.copy_from_slice(black_box(&from));
            black_box(&to);
            Ok(())
        })
    })
}

const GRIP: Grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient: 0.3 };

fn shaken(records: u32) -> Vec<Pose> {
    (0..records).map(|k| Pose { indentation: 1.0, slide: 0.25 * (0.02 * f64::from(k)).sin() }).collect()
}

/// A loop by turning points.
fn fretting(records: u32) -> Kernel {
    Kernel::new("fretting loop, turning points", "records", records as usize, move || {
        let (ball, path) = (paraboloid(1.0)?, shaken(records));
        Ok(move || {
            let mut memory = TangentialMemory::new(ball.clone(), GRIP);
            path.iter().try_for_each(|&to| {
                memory.advance(to)?;
                number(memory.state().tangential_force)
            })
        })
    })
}

/// A loop of 100 records by springs.
fn coulomb() -> Kernel {
    Kernel::new("fretting loop, bed of 100 000 springs", "records", 100, move || {
        let (path, springs) = (shaken(100), NonZeroUsize::new(100_000).ok_or("no springs")?);
        let bed = CoulombBed::new(paraboloid(1.0)?.as_ref(), GRIP, springs, 1.1)?;
        Ok(move || bed.clone().advance(black_box(&path)).into_iter().try_for_each(number))
    })
}

/// Angles of incidence from the normal to 88°.
fn oblique() -> Kernel {
    Kernel::new("oblique impacts", "angles", 100, || {
        let grip = Grip { normal_modulus: 115e9, tangential_modulus: 95e9, coefficient: 0.1 };
        let ball = Ball { grip, radius: 5e-3, mass: 4e-3, gyration: SOLID };
        let flight = |k: i32| {
            let (sine, cosine) = (0.89 * f64::from(k)).to_radians().sin_cos();
            BallMotion { normal_speed: cosine, tangential_speed: sine, spin: 0.0 }
        };
        let flights: Vec<BallMotion> = (0..100).map(flight).collect();
        Ok(move || {
            black_box(ball.hits(black_box(&flights), 1e-6)?);
            Ok(())
        })
    })
}

/// Hertz on the full half-space.
#[cfg(feature = "half-space")]
fn grid(n: u16) -> Kernel {
    use crate::halfspace::{Boundary, Prescribed, PressedMap, Settings, Start, solve};
    let side = usize::from(n);
    Kernel::new("half-space, Hertz", "pixels", side * side, move || {
        let pixel = 0.3 / f64::from(n);
        #[expect(clippy::cast_precision_loss, reason = "grids are far below 2^53")]
        let place = move |index: usize| (index as f64 - 0.5 * f64::from(n)) * pixel;
        let height = |(row, column)| 0.5 * (place(row).powi(2) + place(column).powi(2));
        let heights = ndarray::Array2::from_shape_fn((side, side), height);
        Ok(move || {
            let (boundary, control) = (Boundary::Free, Prescribed::Indentation(0.01));
            let problem = PressedMap { heights: heights.view(), pixel: [pixel; 2], modulus: 1.0, boundary, control };
            number(solve(&problem, Start::Coarser, &Settings::default())?.force())
        })
    })
}

/// Ten thousand curves of ten records each, on a number of threads.
fn scenes(name: &'static str, threads: usize) -> Kernel {
    Kernel::new(name, "curves", 10_000, move || {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
        let ball = paraboloid(1.0)?;
        let one = move |k: u32| {
            let mut contact = jkr(ball.clone(), 1.0, 0.5 + f64::from(k) * 1e-4);
            (0..10).try_for_each(|step| contact.indent(0.2 * f64::from(step)).map(|_| ()))
        };
        Ok(move || Ok(pool.install(|| (0..10_000u32).into_par_iter().try_for_each(&one))?))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kernel_runs_and_ratios_belong_to_the_kernel_before() {
        let mut small = kernels();
        small.retain(|kernel| kernel.method.setting.counted.is_some_and(|(_, size)| size <= 1000));
        let rows = rows(&small, Duration::ZERO, |_| ());
        assert!(rows.len() > 8 && rows.iter().all(|row| row.times.is_some_and(|times| times.warm > 0.0)), "{rows:#?}");
        let kernel = || Kernel::new("", "", 2, || Ok(|| Ok(())));
        let rows = super::rows(&[kernel(), kernel().beside("the first")], Duration::ZERO, |_| ());
        let [first, second] = [0, 1].map(|at: usize| rows[at].times.unwrap().warm);
        assert!(rows[0].beside.is_none());
        assert!((rows[1].beside.unwrap().1 * first / second - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_kernel_that_fails_says_why() {
        let kernel = Kernel::new("", "", 2, || Ok(|| number(f64::NAN)));
        assert_eq!(kernel.row(Duration::ZERO).why.unwrap(), "the force is no number");
    }
}
