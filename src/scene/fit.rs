//! What is to be found from measured curves, as written in a scene.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::scene::Scene;
//! use springbed::scene::fit::Baseline;
//!
//! let scene = Scene::from_ron(r#"(shape: Sphere(radius: "5 mm"), bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid),
//!     history: [Indent(to: "10 um", over: 1)],
//!     fit: (data: ["gel.csv"], free: ["bodies.0.young=1 kPa..1 GPa"], baseline: Linear))"#)?;
//! assert_eq!(scene.fit.unwrap().baseline, Baseline::Linear);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::input::quantity::SpringStiffness;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// What is free, and the data it is to be found from.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Measured {
    /// Data files, beside the scene.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub data: Vec<PathBuf>,
    /// Free parameters, each `PATH=LO..HI` or `PATH`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub free: Vec<String>,
    /// Columns of the data, such as `depth=z [nm], force=F [nN]`; by their names if empty.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub columns: String,
    /// Stiffness of the cantilever, for data of deflection and piezo.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<SpringStiffness>,
    /// Line under the response.
    #[serde(default)]
    pub baseline: Baseline,
    /// Where first touch is.
    #[serde(default)]
    pub contact: FirstTouch,
    /// What drives; what the history says if absent: an impact its speed, a last entry that slides its slide, else the first one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<Drive>,
    /// Ways that count.
    #[serde(default)]
    pub way: Way,
    /// Depths that count, as measured, `LO..HI`; forces where they drive. All if empty.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub range: String,
    /// How points far off count.
    #[serde(default)]
    pub loss: Loss,
    /// Numbers known with a standard error only, each `PATH=SPREAD`, such as `shape.radius=2 %`; `spring` is the cantilever.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub given: Vec<String>,
    /// Models that are compared, by names or as scene files; the scene as it is written if empty.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub models: Vec<String>,
    /// Two free parameters of which a map of the confidence is wanted, `PATH,PATH`; none if empty.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub map: String,
}

/// A line under the response that is no part of the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
pub enum Baseline {
    /// None: the zero of the response is known.
    Absent,
    /// A constant.
    #[default]
    Constant,
    /// A constant and a tilt, in proportion to the drive.
    Linear,
    /// A constant and a virtual deflection: a part of the deflection of a cantilever in proportion to the way of its piezo,
    /// which is in the force and in the depth.
    Virtual,
}

/// Where the bodies touch first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
pub enum FirstTouch {
    /// It is to be found.
    #[default]
    Free,
    /// At the zero of the depths.
    Zero,
}

/// What drives a measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
pub enum Drive {
    /// The depth; the force answers.
    Depth,
    /// The force; the depth answers.
    Force,
    /// The speed of an impact; its restitution answers.
    Speed,
    /// The tangential displacement; the tangential force answers.
    Slide,
}

/// Which way of a curve counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
pub enum Way {
    /// All of it.
    #[default]
    Both,
    /// Up to the largest drive.
    In,
    /// From there on.
    Out,
}

/// How the distance of a point from the model counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
pub enum Loss {
    /// By its square.
    #[default]
    Square,
    /// Far off by its size alone (Huber 1964).
    Robust,
}
