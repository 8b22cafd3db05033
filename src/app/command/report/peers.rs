//! What other programs need for the same cases, measured before.

use crate::app::console::Failure;
use serde::{Deserialize, Serialize};

/// One measurement of another program.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub struct Peer {
    /// Case of ours.
    pub case: String,
    /// The other program.
    pub code: String,
    /// How fine it worked.
    pub setting: String,
    /// Relative error.
    pub error: f64,
    /// Time [s].
    pub time_s: f64,
    /// How and where it was measured.
    pub source: String,
}

const TABLE: &str = include_str!("peers.csv");

/// All measurements.
///
/// # Errors
/// The table does not hold what it should.
pub fn all() -> Result<Vec<Peer>, Failure> {
    csv::Reader::from_reader(TABLE.as_bytes()).deserialize().collect::<Result<_, _>>().map_err(Failure::failed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::cases;
    use crate::check::study::Thoroughness;

    #[test]
    fn every_measurement_belongs_to_a_case_and_names_its_source() {
        let studies = cases::studies(Thoroughness::Brief).unwrap();
        for peer in all().unwrap() {
            assert!(studies.iter().any(|study| study.case == peer.case), "{peer:?}");
            assert!(peer.error > 0.0 && peer.time_s > 0.0 && !peer.source.is_empty(), "{peer:?}");
        }
    }
}
