//! How often a law is tried: `PROPTEST_CASES=25600 cargo test --release` tries every law a hundred times as often.

use proptest::prelude::ProptestConfig;

/// Cases of proptest where no number is asked for.
const USUAL: u32 = 256;

/// `count` random inputs, or as many times more as `PROPTEST_CASES` is beyond 256.
pub(crate) fn cases(count: u32) -> ProptestConfig {
    let asked = ProptestConfig::default();
    let scaled = |number: u32| (u64::from(number) * u64::from(asked.cases) / u64::from(USUAL)).max(1);
    ProptestConfig {
        cases: u32::try_from(scaled(count)).unwrap(),
        max_global_rejects: u32::try_from(scaled(asked.max_global_rejects)).unwrap(),
        ..asked
    }
}
