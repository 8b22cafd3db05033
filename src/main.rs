//! The program springbed.
fn main() {}
