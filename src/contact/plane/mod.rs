//! Plane contacts of a half-plane: a wave in closed form, and a wavy parabola while its contact is in one piece.
//!
//! # Examples
//! ```
//! use springbed::contact::plane::Westergaard;
//!
//! // A wave of amplitude h and length λ lies flat from the mean pressure πE*h/λ on; at half of it a = λ/4.
//! let wave = Westergaard { modulus: 1e9, amplitude: 1e-6, wavelength: 1e-3 };
//! let full = wave.full_contact_pressure();
//! assert!((full / (std::f64::consts::PI * 1e6) - 1.0).abs() < 1e-15);
//! assert!((wave.half_width(0.5 * full) / 0.25e-3 - 1.0).abs() < 1e-14);
//! ```

mod connectivity;
mod wavy;
mod westergaard;

pub use connectivity::{Connection, PlaneContact, WavyParabola, flat_punch_load, single_harmonic_load};
pub use wavy::WavyContact;
pub use westergaard::{GrossSliding, Westergaard};
