//! Numbers in, numbers out: the mapping, the beds and the models they carry.
//!
//! Modules stand in the order of use: each one may use only those above it.

pub mod problem;
pub mod table;
pub mod quantity;
pub mod root;
pub mod quadrature;
pub mod special;
pub mod rough;
pub mod plane;
pub mod shape;
pub mod material;
pub mod viscoelastic;
pub mod adhesion;
pub mod quasistatic;
pub mod bed;
pub mod friction;
pub mod impact;
pub mod history;
pub mod reach;
pub mod scene;
pub mod surface;
pub mod setup;
pub mod record;
pub mod stress;
pub mod stage;
pub mod plan;
pub mod simulation;
