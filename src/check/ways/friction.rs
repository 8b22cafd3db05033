//! The loop of Cattaneo and Mindlin.

use crate::check::case::Attempt;
use crate::check::contacts::paraboloid;
use crate::check::measured::DEPTH;
use crate::check::row::{Computed, Setting};
use crate::check::study::{Method, Study, Thoroughness};
use crate::check::tangential::CattaneoMindlin;
use crate::friction::{CoulombBed, Grip, Pose, TangentialMemory};
use crate::shape::Paraboloid;
use std::num::NonZeroUsize;
use std::sync::Arc;

const GRIP: Grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 0.3 };
/// Records of a quarter of the loop.
const QUARTER: i32 = 40;

/// A ball under d/R = 0.01 sheared to 90 % of gross slip and to and fro: tangential forces.
pub fn mindlin_loop(effort: Thoroughness) -> Attempt<Study> {
    let exact = CattaneoMindlin::on_ball(DEPTH, GRIP.tangential_modulus, GRIP.coefficient);
    let amplitude = exact.reach() * (1.0 - 0.1f64.powf(2.0 / 3.0));
    let right = |(k, slide)| match k {
        0..40 => exact.tangential_force(slide),
        40..120 => exact.masing(amplitude, slide),
        _ => exact.masing(-amplitude, slide),
    };
    Ok(Study {
        case: "mindlin",
        about: "a ball pressed and sheared to and fro, 200 records: tangential forces".to_owned(),
        quantity: "tangential force",
        reference: "closed form of Cattaneo and Mindlin, turned by Masing's rule".to_owned(),
        exact: Computed { values: slides(amplitude).enumerate().map(right).collect(), ..Computed::default() },
        methods: methods(&slides(amplitude).map(at).collect::<Vec<_>>(), exact.contact_radius, effort),
    })
}

fn methods(path: &[Pose], radius: f64, effort: Thoroughness) -> Vec<Method> {
    let turning = path.to_vec();
    let mut methods = vec![Method::new("turning points", Setting::FREE, move || {
        let (ball, path) = (paraboloid(1.0)?, turning.clone());
        Ok(move || memory(&ball, &path))
    })];
    methods.extend(effort.decades(2, 6).map(|count| {
        let path = path.to_vec();
        Method::new("bed of Coulomb springs", Setting::springs(count), move || {
            let (path, springs) = (path.clone(), NonZeroUsize::new(count).ok_or("no springs")?);
            let bed = CoulombBed::new(paraboloid(1.0)?.as_ref(), GRIP, springs, 1.1 * radius)?;
            Ok(move || Ok(sheared(bed.clone(), &path)))
        })
    }));
    methods
}

fn at(slide: f64) -> Pose {
    Pose { indentation: DEPTH, slide }
}

/// From zero to the amplitude, to its negative and back again.
fn slides(amplitude: f64) -> impl Iterator<Item = f64> {
    let part = move |k: i32| amplitude * f64::from(k) / f64::from(QUARTER);
    (1..=QUARTER).chain((-QUARTER..QUARTER).rev()).chain(1 - QUARTER..=QUARTER).map(part)
}

fn memory(ball: &Arc<Paraboloid>, path: &[Pose]) -> Attempt<Computed> {
    let mut memory = TangentialMemory::new(ball.clone(), GRIP);
    memory.advance(at(0.0))?;
    let mut values = Vec::with_capacity(path.len());
    for &to in path {
        memory.advance(to)?;
        values.push(memory.state().tangential_force);
    }
    Ok(Computed { values, bytes: size_of::<TangentialMemory>(), ..Computed::default() })
}

fn sheared(mut bed: CoulombBed, path: &[Pose]) -> Computed {
    bed.advance(&[at(0.0)]);
    let values = bed.advance(path);
    Computed { values, bytes: 2 * size_of::<f64>() * bed.depths().len(), ..Computed::default() }
}
