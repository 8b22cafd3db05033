//! Numbers in, numbers out: the mapping, the beds and the models they carry.
//!
//! Modules stand in the order of use: each one may use only those above it.

pub mod adhesion;
pub mod friction;
pub mod history;
pub mod material;
pub mod quadrature;
pub mod quantity;
pub mod quasistatic;
pub mod root;
pub mod rough;
pub mod scene;
pub mod shape;
pub mod table;
