//! The loop of Cattaneo and Mindlin.

use super::{Answer, Effort, Method, Setting, Study};
use crate::check::closed_forms;
use crate::check::tangential::CattaneoMindlin;
use crate::friction::{CoulombBed, Grip, Pose, TangentialMemory};
use crate::input::quantity::Length;
use crate::shape::Paraboloid;
use std::num::NonZeroUsize;
use std::sync::Arc;

const GRIP: Grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 0.3 };
const DEPTH: f64 = 0.01;
/// Records of a quarter of the loop.
const QUARTER: i32 = 40;

/// A ball under d/R = 0.01 sheared to 90 % of gross slip and to and fro: tangential forces.
pub(super) fn mindlin_loop(effort: Effort) -> Option<Study> {
    let hertz = closed_forms::hertz(1.0, DEPTH);
    let exact = CattaneoMindlin {
        force: hertz.force,
        contact_radius: hertz.radius,
        tangential_modulus: GRIP.tangential_modulus,
        coefficient: GRIP.coefficient,
    };
    let reach = hertz.radius;
    let amplitude = exact.reach() * (1.0 - 0.1f64.powf(2.0 / 3.0));
    let values = slides(amplitude).enumerate().map(|(k, slide)| match k {
        0..40 => exact.tangential_force(slide),
        40..120 => exact.masing(amplitude, slide),
        _ => exact.masing(-amplitude, slide),
    });
    let exact_values = values.collect();
    let path: Vec<Pose> = slides(amplitude).map(|slide| Pose { indentation: DEPTH, slide }).collect();
    let turning = path.clone();
    let mut methods = vec![Method::new("turning points", Setting::FREE, move || {
        let (ball, path) = (ball()?, turning.clone());
        Some(move || memory(&ball, &path))
    })];
    methods.extend(effort.decades(2, 6).map(|count| {
        let path = path.clone();
        Method::new("bed of Coulomb springs", Setting::springs(count), move || {
            let path = path.clone();
            let bed = CoulombBed::new(&ball()?, GRIP, NonZeroUsize::new(count)?, 1.1 * reach).ok()?;
            Some(move || springs(bed.clone(), &path))
        })
    }));
    Some(Study {
        case: "mindlin",
        about: "a ball pressed and sheared to and fro, 200 records: tangential forces".to_owned(),
        quantity: "tangential force",
        reference: "closed form of Cattaneo and Mindlin, turned by Masing's rule".to_owned(),
        orders: &[1.0, 2.0],
        exact: Answer { values: exact_values, ..Answer::default() },
        methods,
    })
}

/// From zero to the amplitude, to its negative and back again.
fn slides(amplitude: f64) -> impl Iterator<Item = f64> {
    let part = move |k: i32| amplitude * f64::from(k) / f64::from(QUARTER);
    (1..=QUARTER).chain((-QUARTER..QUARTER).rev()).chain(1 - QUARTER..=QUARTER).map(part)
}

fn ball() -> Option<Paraboloid> {
    Some(Paraboloid { radius: Length::new(1.0).ok()? })
}

fn memory(ball: &Paraboloid, path: &[Pose]) -> Option<Answer> {
    let mut memory = TangentialMemory::new(Arc::new(ball.clone()), GRIP);
    memory.advance(Pose { indentation: DEPTH, slide: 0.0 }).ok()?;
    let values: Option<Vec<f64>> =
        path.iter().map(|&to| memory.advance(to).ok().map(|()| memory.state().tangential_force)).collect();
    Some(Answer { values: values?, bytes: size_of::<TangentialMemory>(), ..Answer::default() })
}

fn springs(mut bed: CoulombBed, path: &[Pose]) -> Option<Answer> {
    bed.advance(&[Pose { indentation: DEPTH, slide: 0.0 }]);
    let values = bed.advance(path);
    Some(Answer { values, bytes: 2 * size_of::<f64>() * bed.depths().len(), ..Answer::default() })
}
