//! Rough shapes: spectra, rough lines and surfaces, measured height maps, and their spring bed.
//!
//! A surface with isotropic random roughness is known by its power spectrum C(q). The spring bed takes
//! its one-dimensional equivalent, a line with C₁D = π q C(q), which keeps rms height and rms slope
//! (Popov & Heß 2015, ch. 10). The bed answers force and stiffness against approach, approximately; it says
//! nothing about the real contact area (Lyashenko, Pastewka & Persson 2013).
//!
//! # Examples
//! ```
//! use springbed::shape::rough::{Rings, RoughLine, RoughnessSpectrum};
//!
//! // A self-affine spectrum, and the line that stands for the surface: the same rms height for every seed.
//! let spectrum = RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)])?;
//! let line = RoughLine::new(&Rings::of(&spectrum, 1.0, 64)?, 7);
//! let mean_square = line.heights(64)?.iter().map(|z| z * z).sum::<f64>() / 64.0;
//! assert!((mean_square.sqrt() / spectrum.rms_height() - 1.0).abs() < 1e-12);
//! # Ok::<(), springbed::shape::rough::RoughError>(())
//! ```

mod ensemble;
mod error;
mod fourier;
mod height_map;
mod line;
pub(crate) mod random;
mod rings;
mod self_affine;
mod source;
mod spectrum;
mod surface;
mod treatment;

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
pub use treatment::{filled, levelled, without_outliers};
