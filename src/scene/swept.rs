//! A sweep as a scene writes it.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::scene::Scene;
//!
//! let scene = Scene::from_ron(r#"(shape: Cone(slope: 0.1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)],
//!     sweep: (set: [(path: "bodies.0.young", values: "1kPa..1MPa:50log"), (path: "shape.slope", values: "[0.1, 0.2]")]))"#)?;
//! let swept = scene.sweep.unwrap();
//! assert!(swept.set.len() == 2 && !swept.zip);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::input::values::Values;
use serde::{Deserialize, Serialize};

/// Values that places of a scene are to take.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Swept {
    /// The places with their values.
    pub set: Vec<Setting>,
    /// Whether the values of all places stand side by side; otherwise every one goes with every other.
    #[serde(default)]
    pub zip: bool,
}

/// A place of a scene and the values it is to take.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Setting {
    /// Path of the place, such as `bodies.0.young` or `history.1.to`.
    pub path: String,
    /// `v`, `[a,b,c]`, `LO..HI:N` or `LO..HI:Nlog`; a number in SI units or with its unit.
    pub values: Values,
}
