//! Plane contacts of a half-plane: a wave, and a wavy parabola while its contact is in one piece.

mod connectivity;
mod wave;
mod wavy;
mod westergaard;

pub use connectivity::{Connection, PlaneContact, WavyParabola, flat_punch_load, single_harmonic_load};
pub use wave::WaveContact;
pub use wavy::WavyContact;
pub use westergaard::{GrossSliding, Westergaard};
