//! Plane contacts of a half-plane: a wave, and a wavy parabola while its contact is in one piece.

mod connectivity;
mod westergaard;

pub use connectivity::{
    Connection, ConnectivityError, PlaneContact, WavyParabola, flat_punch_load, single_harmonic_load,
};
pub use westergaard::{GrossSliding, Westergaard};
