//! Viscoelastic contacts: Ting's triangle and creep.

use super::{Answer, Effort, Method, Setting, Study};
use crate::check::ting::Triangle;
use crate::check::usual;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::direct::Direct;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::lazy::Lazy;
use crate::contact::viscoelastic::memory::Memory;
use crate::input::quantity::Length;
use crate::material::Relaxation;
use crate::shape::Paraboloid;
use std::sync::Arc;

const SPEED: f64 = 0.01;
/// Radius of half the bed: a little beyond the largest contact, 0.1.
const REACH: f64 = 0.11;
/// Springs of the explicit Euler bed.
const EULER_SPRINGS: usize = 1000;
/// Forces on the way in and as many on the way out.
const RECORDS: u32 = 10;
/// Time between two records [s].
const PAUSE: f64 = 0.1;

/// A ball with R = 1 driven by 0.01 and back, E* = 0.4 + 3.6e^{−t/0.2}: forces in and out.
pub(super) fn ting(effort: Effort) -> Option<Study> {
    let exact = Triangle { relaxation: solid(), radius: 1.0, speed: SPEED, turn: 1.0 };
    let values = (1..=2 * RECORDS).map(|k| exact.at(f64::from(k) * PAUSE).0).collect();
    let mut methods = vec![Method::new("continuous bed", Setting::FREE, || {
        let (spectrum, ball) = (Arc::new(Spectrum::new(&solid())), Arc::new(ball()?));
        Some(move || continuous(&spectrum, &ball))
    })];
    methods.extend(effort.decades(2, 6).map(|count| {
        Method::new("lazy bed", Setting::springs(count), move || {
            let bed = Lazy::new(Arc::new(Spectrum::new(&solid())), Layout::uniform(&ball()?, REACH, count));
            Some(move || lazy(bed.clone()))
        })
    }));
    methods.extend(effort.decades(2, 5).map(|count| {
        Method::new("direct bed", Setting::springs(count), move || {
            let bed = Direct::new(Arc::new(Spectrum::new(&solid())), Layout::uniform(&ball()?, REACH, count));
            Some(move || direct(bed.clone()))
        })
    }));
    methods.extend(effort.decades(2, 6).map(euler));
    Some(Study {
        case: "ting",
        about: "a ball driven into a standard linear solid and back: forces in and out".to_owned(),
        quantity: "force",
        reference: "Ting's integral".to_owned(),
        orders: &[1.0, 2.0],
        exact: Answer { values, ..Answer::default() },
        methods,
    })
}

fn solid() -> Relaxation {
    Relaxation { equilibrium: 0.4, terms: vec![(3.6, 0.2)], viscosity: 0.0 }
}

fn ball() -> Option<Paraboloid> {
    Some(Paraboloid { radius: Length::new(1.0).ok()? })
}

fn continuous(spectrum: &Arc<Spectrum>, ball: &Arc<Paraboloid>) -> Option<Answer> {
    let mut bed = Memory::new(spectrum.clone(), ball.clone());
    let mut values = Vec::new();
    for speed in [SPEED, -SPEED] {
        for k in 1..=RECORDS {
            values.push(bed.force_after(speed, f64::from(k) * PAUSE).ok()?.0);
        }
        bed.advance(speed, 1.0).ok()?;
    }
    Some(Answer { values, bytes: size_of::<Memory>(), ..Answer::default() })
}

/// Speeds of all records.
fn speeds() -> impl Iterator<Item = f64> {
    (0..2 * RECORDS).map(|k| if k < RECORDS { SPEED } else { -SPEED })
}

fn lazy(mut bed: Lazy) -> Option<Answer> {
    let values = speeds().map(|speed| {
        bed.advance(speed, PAUSE);
        bed.force()
    });
    Some(Answer { values: values.collect(), bytes: bed.bytes(), ..Answer::default() })
}

fn direct(mut bed: Direct) -> Option<Answer> {
    let values = speeds().map(|speed| {
        bed.advance(speed, PAUSE);
        bed.force()
    });
    Some(Answer { values: values.collect(), bytes: bed.bytes(), ..Answer::default() })
}

/// The usual way: every spring in every step.
fn euler(steps: usize) -> Method {
    let setting = Setting { springs: Some(EULER_SPRINGS), steps: Some(steps), grid: None };
    Method::new("explicit Euler", setting, move || {
        let layout = Layout::uniform(&ball()?, REACH, EULER_SPRINGS);
        let width = 0.5 * layout.weight.first()?;
        let time = move |k: usize| 2.0 * as_f64(k) / as_f64(steps);
        let depths: Vec<f64> = (1..=steps).map(|k| SPEED * (1.0 - (1.0 - time(k)).abs())).collect();
        let step = time(1);
        Some(move || {
            let forces = usual::explicit_euler(&solid(), (&layout.height, width), &depths, step);
            let every = steps / (2 * RECORDS as usize);
            let values = forces.iter().skip(every - 1).step_by(every).copied().collect();
            Some(Answer { values, bytes: 3 * size_of::<f64>() * EULER_SPRINGS, ..Answer::default() })
        })
    })
}

#[expect(clippy::cast_precision_loss, reason = "steps are far below 2^53")]
fn as_f64(n: usize) -> f64 {
    n as f64
}
