//! What comes from outside, checked: quantities with their units, tables by name, problems with their place.

pub mod problem;
pub mod quantity;
pub mod table;
