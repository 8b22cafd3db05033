//! How long a layered contact takes to set up, and then for a state and for a curve:
//! `cargo run --release -p benches --example ground_times`.
//!
//! A ball on a layer that can hardly be compressed, bonded to a rigid base, on a stiff film on a soft base, on a graded
//! body; the median of repeats, one thread. No two layers are alike, for what is known of one serves the next.

use springbed::ground::{Ground, Grounded, Layers, PowerLaw};
use springbed::input::quantity::{GradingExponent, Length, Modulus, Poisson};
use springbed::material::{Graded, Joint, Sheet, Stack};
use springbed::prelude::*;
use springbed::shape::{Paraboloid, Profile};
use std::error::Error;
use std::hint::black_box;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Instant;

/// Repeats of which the median is told.
const REPEATS: usize = 15;
/// States over which one is timed.
const STATES: u32 = 2000;

fn median(mut work: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..REPEATS)
        .map(|_| {
            let began = Instant::now();
            work();
            began.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[REPEATS / 2]
}

/// How many layers there were.
static MADE: AtomicU32 = AtomicU32::new(0);

fn layers(base: Option<f64>) -> Layers {
    let poisson = 0.5 - 1e-9 * f64::from(MADE.fetch_add(1, Ordering::Relaxed) + 1);
    let sheet = Sheet { shear: 1.0, poisson, thickness: 1.0, joint: Joint::Bonded };
    let base = base.map(|shear| Sheet { shear, thickness: f64::INFINITY, ..sheet });
    Layers::new(vec![(1.0, Stack { sheets: vec![sheet], base })])
}

fn graded() -> Result<PowerLaw, Box<dyn Error>> {
    Ok(PowerLaw::from(&Graded {
        young: Modulus::new(1.0)?,
        depth: Length::new(1.0)?,
        exponent: GradingExponent::new(0.3)?,
        poisson: Poisson::new(0.3)?,
    }))
}

fn told(name: &str, shape: &Arc<dyn Profile>, widths: &[f64], ground: &dyn Fn() -> Arc<dyn Ground>) {
    for &width in widths {
        let touched = || {
            let bed = Grounded::new(shape.clone(), ground());
            let place = bed.place(width);
            black_box((bed.reduced(place), bed.load_integral(place)));
            (bed, place)
        };
        let setup = median(|| {
            black_box(touched());
        });
        let (bed, place) = touched();
        let state = median(|| {
            for k in 0..STATES {
                let here = place * (0.5 + 0.5 * f64::from(k) / f64::from(STATES));
                black_box((bed.reduced(here), bed.load_integral(here), bed.contact_radius(here)));
            }
        });
        println!(
            "{name:32} a = {width:4} h: set-up {:8.3} ms, state {:6.3} us",
            1e3 * setup,
            1e6 * state / f64::from(STATES)
        );
    }
}

fn curve(name: &str, bodies: &str) -> Result<(), Box<dyn Error>> {
    let text = format!(
        "(shape: Paraboloid(radius: \"10 um\"), bodies: ({bodies}, Rigid), history: [Indent(to: \"1 um\", over: 1)], steps: 1000)"
    );
    let plan = Notation::Ron.plan(&text, &InMemory::default()).map_err(|errors| errors[0].to_string())?;
    run(&plan, Wanted::NOTHING)?;
    let time = median(|| {
        black_box(run(&plan, Wanted::NOTHING).is_ok());
    });
    let whole = median(|| {
        let plan = Notation::Ron.plan(&text, &InMemory::default());
        black_box(plan.is_ok_and(|plan| run(&plan, Wanted::NOTHING).is_ok()));
    });
    println!("{name:32} 1000 records: {:8.3} ms, with the scene read {:8.3} ms", 1e3 * time, 1e3 * whole);
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let asked: Vec<f64> = std::env::args().skip(1).filter_map(|width| width.parse().ok()).collect();
    let widths = if asked.is_empty() { vec![0.1, 1.0, 10.0, 60.0] } else { asked };
    let ball: Arc<dyn Profile> = Arc::new(Paraboloid { radius: Length::new(10.0)? });
    told("layer on a rigid base", &ball, &widths, &|| Arc::new(layers(None)));
    told("layer on a base 100 times softer", &ball, &widths, &|| Arc::new(layers(Some(0.01))));
    let graded = graded()?;
    told("graded", &ball, &widths, &|| Arc::new(graded));
    curve("half-space", "Elastic(young: 1e4, poisson: 0.5)")?;
    let gel = "Elastic(young: 1e4, poisson: 0.5), thickness: \"5 um\"";
    curve("layer on a rigid base", &format!("Layered(layers: [(body: {gel})], base: Rigid)"))?;
    let soft = "Elastic(young: 1e2, poisson: 0.3)";
    curve("layer on a base 100 times softer", &format!("Layered(layers: [(body: {gel})], base: {soft})"))?;
    curve("graded", "Graded(young: 1e4, depth: \"5 um\", exponent: 0.3, poisson: 0.3)")
}
