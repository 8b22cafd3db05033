//! Rough lines on beds of independent springs: elastic, relaxing, adhesive, yielding.
//!
//! # Examples
//! ```
//! use springbed::contact::rough::RoughBed;
//!
//! // Three springs of 2 N/m under gaps of 0, 1 and 3 m: at a depth of 2 two of them carry 2·(2 + 1) N.
//! let bed = RoughBed::new(&[1.0, 0.0, 3.0], 2.0)?;
//! let state = bed.at_indentation(2.0);
//! assert_eq!((state.force, state.stiffness), (6.0, 4.0));
//! assert_eq!(bed.at_force(6.0).indentation, 2.0);
//! # Ok::<(), springbed::shape::rough::RoughError>(())
//! ```

mod adhesive;
mod bed;
mod dents;
mod elastic;
mod ends;
mod gliding;
mod ground;
mod patches;
mod persson;
mod relaxing;
mod told;
mod yielding;

pub use adhesive::AdhesiveRough;
pub use bed::{BedState, RoughBed};
pub use elastic::RoughContact;
pub use gliding::gliding_line;
pub use ground::EdgeWorks;
pub use persson::PerssonGlide;
pub use relaxing::RelaxingRough;
pub use yielding::YieldingRough;

/// What a rough bed is good for, to be shown beside its results.
pub const VALIDITY: &str = "approximate: force and stiffness of a rough line stand for those of the isotropic surface; its contact length does not give the real contact area";
