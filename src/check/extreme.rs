//! Many contacts over a range of values, each against its exact answer or a law.

use super::attempt::Attempt;

/// Contacts over a range of values.
#[derive(Debug, Clone, Copy)]
pub struct Extreme {
    /// Range of values.
    pub range: &'static str,
    /// Exact answer or law they are held against.
    pub against: &'static str,
    /// Tries them all.
    pub tried: fn() -> Attempt<Tally>,
}

/// What trying many contacts gave.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tally {
    /// Largest error.
    pub worst: f64,
    /// Contacts tried.
    pub tried: usize,
    /// Contacts in which a law was broken.
    pub broken: usize,
}

impl Tally {
    /// One more contact with its error.
    pub fn error(&mut self, error: f64) {
        self.tried += 1;
        self.worst = if error > self.worst || error.is_nan() { error } else { self.worst };
    }

    /// One more contact with a value and the right one.
    pub fn pair(&mut self, value: f64, right: f64) {
        self.error((value / right - 1.0).abs());
    }

    /// More contacts with values and the right ones.
    pub fn pairs(&mut self, pairs: &[(f64, f64)]) {
        pairs.iter().for_each(|&(value, right)| self.pair(value, right));
    }

    /// One more contact in which a law holds or not.
    pub fn law(&mut self, holds: bool) {
        self.tried += 1;
        self.broken += usize::from(!holds);
    }
}

/// Powers 10^(low), 10^(low + step), … up to 10^high.
pub fn powers(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> + Clone {
    #[expect(clippy::cast_possible_truncation, reason = "a few hundred steps")]
    let count = ((high - low) / step + 1e-9).floor() as i32;
    (0..=count).map(move |k| 10f64.powf(low + step * f64::from(k)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::row::Row;

    #[test]
    fn a_range_without_answer_or_beyond_a_law_is_told() {
        let of = |tried| Row { bound: Some(0.1), ..Row::over(Extreme { range: "", against: "", tried }) };
        assert!(of(|| Ok(Tally { worst: 0.1, tried: 1, broken: 0 })).passed());
        assert!(!of(|| Ok(Tally { worst: 0.0, tried: 1, broken: 1 })).passed());
        assert_eq!(of(|| Ok(Tally::default())).why.unwrap(), "nothing was tried");
        assert_eq!(of(|| Err("no contact".into())).why.unwrap(), "no contact");
    }

    #[test]
    fn powers_reach_both_ends() {
        let all: Vec<f64> = powers(-9.0, 3.0, 2.0).collect();
        assert!(all.len() == 7 && (all[0] / 1e-9 - 1.0).abs() < 1e-14 && (all[6] / 1e3 - 1.0).abs() < 1e-14);
    }
}
