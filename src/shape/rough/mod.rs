//! Rough shapes: spectra, rough lines and surfaces, measured height maps, and their spring bed.
//!
//! A surface with isotropic random roughness is known by its power spectrum C(q). The spring bed takes
//! its one-dimensional equivalent, a line with C₁D = π q C(q), which keeps rms height and rms slope
//! (Popov & Heß 2015, ch. 10). The bed answers force and stiffness against approach, approximately; it says
//! nothing about the real contact area (Lyashenko, Pastewka & Persson 2013).

mod ensemble;
mod error;
mod fourier;
mod height_map;
mod line;
mod random;
mod rings;
mod self_affine;
mod source;
mod spectrum;
mod surface;

pub use ensemble::{Scatter, ensemble};
pub use error::RoughError;
pub(crate) use error::positive;
pub use height_map::{Border, HeightMap, Roughness};
pub use line::RoughLine;
pub use random::Random;
pub use rings::Rings;
pub use self_affine::SelfAffine;
pub use source::{SourceError, SpectrumSource};
pub use spectrum::RoughnessSpectrum;
pub use surface::rough_surface;
