//! Curves read off the records of a scene, and the theory beside them.

pub mod between;
pub mod branches;
pub mod sliding;
