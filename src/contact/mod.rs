//! Normal contacts: the direct path, beds of springs, viscoelastic beds, plane and rough contacts.

pub mod adhesion;
pub mod creep;
pub mod direct;
pub mod elliptic;
mod elastic;
pub mod foundation;
pub mod error;
pub mod loaded;
pub mod model;
pub mod plane;
pub mod punch;
pub mod rough;
pub mod spring_loads;
pub mod springs;
pub mod state;
pub mod stress;
pub mod viscoelastic;
