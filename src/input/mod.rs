//! What comes from outside, checked: quantities with their units, tables by name, problems with their place.
//!
//! # Examples
//! ```
//! use springbed::input::quantity::Length;
//! use springbed::input::table::{InMemory, Tables};
//!
//! let radius: Length = "10 mm".parse()?;
//! assert_eq!(radius.si(), 0.01);
//! let tables = InMemory::default().with("tip.csv", &[("radius_m", &[0.0, 1e-6]), ("height_m", &[0.0, 1e-8])]);
//! assert_eq!(tables.names("tip.csv".as_ref())?, ["radius_m", "height_m"]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod problem;
pub mod quantity;
pub mod table;
pub mod values;
