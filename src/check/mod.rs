//! What is right, and how well the program hits it.

pub mod theory;
pub mod case;
pub mod cases;
pub mod validity;
