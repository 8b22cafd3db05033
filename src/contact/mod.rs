//! Normal contacts: the direct path, beds of springs, viscoelastic beds, plane and rough contacts.

pub mod adhesion;
pub mod direct;
pub mod elliptic;
pub mod foundation;
pub mod plane;
pub mod springs;
pub mod state;
pub mod stress;
pub mod viscoelastic;
