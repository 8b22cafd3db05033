//! Plane contacts of a half-plane: a wave, and a wavy parabola while its contact is in one piece.

mod connectivity;
mod error;
mod wave;
mod wavy;
mod westergaard;

pub use connectivity::{
    Connection, ConnectivityError, PlaneContact, WavyParabola, flat_punch_load, single_harmonic_load,
};
pub use error::PlaneError;
pub use wave::WaveContact;
pub use wavy::WavyContact;
pub use westergaard::{GrossSliding, Westergaard};
