//! Viscoelastic beds, exact in time.
//!
//! Every spring is E∞, any number of Maxwell elements and a dashpot in parallel. While the indenter
//! moves at constant speed the spring's load is known in closed form, so a history of straight
//! pieces has no error of time stepping. Three beds share the [`spring`](mod@spring): the
//! [`direct`] one updates every spring in every step; the [`lazy`] one does work only for the springs
//! touched or released.

pub mod attraction;
pub mod continuous;
pub mod direct;
pub mod growing;
#[cfg(test)]
pub(crate) mod laws;
pub mod layout;
pub(crate) mod front;
pub mod lazy;
pub mod ledger;
pub mod memory;
mod loaded;
mod panel;
pub mod spring;
mod totals;

pub use crate::material::{Element, Mode, Spectrum};
pub use spring::Motion;
