//! Shapes against laws, limits and numbers of many digits.

mod digits;
pub(super) mod laws;
