//! A portable source of random phases.

/// A xoshiro256++ generator, seeded through SplitMix64 (Blackman & Vigna 2021).
///
/// Integer arithmetic only: the same seed gives the same numbers on every machine and in every
/// version of the program. Period 2²⁵⁶ − 1. Not for secrets.
#[derive(Debug, Clone)]
pub struct Random {
    state: [u64; 4],
}

impl Random {
    /// The generator of a seed; neighbouring seeds give unrelated streams.
    #[must_use]
    pub fn seeded(seed: u64) -> Self {
        let mut counter = seed;
        Self { state: std::array::from_fn(|_| split_mix(&mut counter)) }
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        let s = &mut self.state;
        let result = s[0].wrapping_add(s[3]).rotate_left(23).wrapping_add(s[0]);
        let shifted = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= shifted;
        s[3] = s[3].rotate_left(45);
        result
    }

    /// A number in `[0, 1)`, a whole multiple of 2⁻⁵³, each equally likely.
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit an f64 exactly")]
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A phase in `[0, 2π)` [rad].
    pub fn phase(&mut self) -> f64 {
        std::f64::consts::TAU * self.unit()
    }
}

/// One step of SplitMix64 (Steele, Lea & Flood 2014).
fn split_mix(counter: &mut u64) -> u64 {
    *counter = counter.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut z = *counter;
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published first outputs: SplitMix64 of seed 0, and xoshiro256++ of the state 1, 2, 3, 4.
    #[test]
    fn published_streams_are_reproduced() {
        let mut counter = 0;
        assert_eq!(split_mix(&mut counter), 0xE220_A839_7B1D_CDAF);
        assert_eq!(split_mix(&mut counter), 0x6E78_9E6A_A1B9_65F4);
        let mut random = Random { state: [1, 2, 3, 4] };
        assert_eq!([random.bits(), random.bits(), random.bits()], [41_943_041, 58_720_359, 3_588_806_011_781_223]);
    }

    /// Mean 1/2 and variance 1/12 within five standard errors of 10⁵ draws.
    #[test]
    fn the_unit_interval_is_filled_evenly() {
        let mut random = Random::seeded(7);
        let n = 100_000;
        let (mut mean, mut square) = (0.0, 0.0);
        for _ in 0..n {
            let u = random.unit();
            assert!((0.0..1.0).contains(&u));
            mean += u / f64::from(n);
            square += (u - 0.5) * (u - 0.5) / f64::from(n);
        }
        assert!((mean - 0.5).abs() < 5.0 * (1.0f64 / 12.0 / f64::from(n)).sqrt(), "{mean}");
        assert!((square - 1.0 / 12.0).abs() < 5.0 * (1.0f64 / 180.0 / f64::from(n)).sqrt(), "{square}");
    }
}
