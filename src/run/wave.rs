//! What is told of a wave beside its records.

use super::named::Named;
use super::unit::Unit;
use crate::contact::plane::Westergaard;
use crate::friction::Friction;
use crate::run::record::Record;
use crate::scene::plan::RoundPlan;
use crate::shape::Shape;

/// Mean pressures and slope of a wave; under the plain elastic contact its force of gross sliding too.
pub fn results(plan: &RoundPlan, records: &[Record]) -> Vec<Named> {
    let Shape::PlaneWave(shape) = &plan.scene.shape else { return Vec::new() };
    let (amplitude, wavelength) = (shape.amplitude.si(), shape.wavelength.si());
    let wave = Westergaard { modulus: plan.pair.normal, amplitude, wavelength };
    let area = wavelength * shape.width();
    let largest = records.iter().map(|record| record.normal.force).fold(0.0, f64::max) / area;
    let mut results = vec![
        Named::number("largest_mean_pressure", Unit::PASCAL, largest),
        Named::number("rms_slope", Unit::ONE, shape.rms_slope()),
    ];
    let plain = !plan.contact.bodies().adheres() && plan.contact.bodies().relaxation().is_none();
    if plain {
        results.push(Named::number("full_contact_pressure", Unit::PASCAL, wave.full_contact_pressure()));
    }
    if let Some(law) = plan.scene.friction.as_ref().filter(|_| plain).and_then(capped) {
        let sliding = wave.sliding(largest, law);
        results.push(Named::number("gross_sliding_force", Unit::NEWTON, sliding.mean_shear * area));
        results.push(Named::number("capped_half_width", Unit::METRE, sliding.capped_half_width));
    }
    results
}

/// What a user must know of an adhesive wave that has closed.
pub fn remark(plan: &RoundPlan, records: &[Record]) -> Option<String> {
    let Shape::PlaneWave(_) = &plan.scene.shape else { return None };
    let closed = records.iter().any(|record| record.normal.stiffness.is_infinite());
    (closed && plan.contact.bodies().adheres()).then(|| {
        "the wave has closed under adhesion: without a flaw no pull opens it again (Johnson 1995), and a depth that goes back opens it from a flaw without width; a real one opens from its largest flaw, at another force".to_owned()
    })
}

/// Coefficient and cap [Pa] of a friction.
fn capped(friction: &Friction) -> Option<(f64, f64)> {
    match friction {
        Friction::Coulomb(law) => Some((law.coefficient.si(), f64::MAX)),
        Friction::StaticKinetic(law) => Some((law.r#static.si(), f64::MAX)),
        Friction::RateState(law) => Some((law.coefficient.si(), f64::MAX)),
        Friction::CoulombOrowan(law) => Some((law.coefficient.si(), law.shear_limit.si())),
        Friction::Stuck | Friction::Pressure(_) => None,
    }
}
