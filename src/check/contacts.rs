//! The contacts of the library that cases press, set up in one place.

use super::case::Attempt;
use super::sketch::si;
use crate::contact::adhesion::dmt::DmtBall;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::Foundation;
use crate::shape::{Paraboloid, Profile};
use std::sync::Arc;

/// A paraboloid of a radius [m].
///
/// # Errors
/// No radius.
pub fn paraboloid(radius: f64) -> Attempt<Arc<Paraboloid>> {
    Ok(Arc::new(Paraboloid { radius: si(radius)? }))
}

/// A contact without adhesion.
#[must_use]
pub fn plain(profile: Arc<dyn Profile>, modulus: f64) -> QuasiStatic {
    jkr(profile, modulus, 0.0)
}

/// A contact with adhesion of vanishing range, of a work [J/m²].
#[must_use]
pub fn jkr(profile: Arc<dyn Profile>, modulus: f64, work: f64) -> QuasiStatic {
    QuasiStatic::new(EdgeLine::new(Foundation::new(profile, modulus), work))
}

/// A ball attracted outside its contact.
#[must_use]
pub fn dmt(profile: Arc<dyn Profile>, modulus: f64, work: f64) -> QuasiStatic {
    QuasiStatic::new(DmtBall::new(Foundation::new(profile, modulus), work))
}

/// A contact whose attraction is constant up to the range work/stress.
///
/// # Errors
/// The attraction has no contact.
pub fn maugis(profile: Arc<dyn Profile>, modulus: f64, work: f64, stress: f64) -> Attempt<QuasiStatic> {
    Ok(QuasiStatic::new(RangeDisc::new(Foundation::new(profile, modulus), work, stress)?))
}

/// A contact without adhesion at a depth [m].
///
/// # Errors
/// The depth leaves the profile.
pub fn indented(profile: Arc<dyn Profile>, modulus: f64, depth: f64) -> Attempt<QuasiStatic> {
    let mut contact = plain(profile, modulus);
    contact.indent(depth)?;
    Ok(contact)
}
