//! One Hertz contact from the library alone: `cargo run --release --no-default-features --example library_hertz`.
//!
//! With a number it computes as many states, for counting instructions: `… --example library_hertz 100000`.

use springbed::contact::adhesion::line::EdgeLine;
use springbed::contact::direct::QuasiStatic;
use springbed::contact::foundation::Foundation;
use springbed::input::quantity::{Length, QuantityError};
use springbed::shape::Paraboloid;
use std::sync::Arc;

fn main() -> Result<(), QuantityError> {
    // Steel on a rigid flat: E* = 210 GPa/(1 − 0.3²).
    let modulus = 210e9 / (1.0 - 0.3f64.powi(2));
    let ball = Paraboloid { radius: Length::new(0.01)? };
    let states: u32 = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(1);
    let mut force = 0.0;
    for k in 1..=states {
        let mut contact = QuasiStatic::new(EdgeLine::new(Foundation::new(Arc::new(ball.clone()), modulus), 0.0));
        if contact.indent(1e-6 * f64::from(k) / f64::from(states)).is_ok() {
            force = contact.present().balance.force;
        }
    }
    println!("{force} N");
    Ok(())
}
