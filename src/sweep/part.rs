//! A share of the rows of a sweep, for one of many machines.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// Part K of N of the rows of a sweep, K from 1 to N.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Part {
    number: usize,
    of: usize,
}

impl Part {
    /// All rows.
    pub const WHOLE: Self = Self { number: 1, of: 1 };

    /// Its number K, from 1 on.
    #[must_use]
    pub fn number(self) -> usize {
        self.number
    }

    /// The number N of all parts.
    #[must_use]
    pub fn of(self) -> usize {
        self.of
    }

    /// Its rows of `rows` in all: parts differ by a row at most.
    #[must_use]
    pub fn rows(self, rows: usize) -> Range<usize> {
        let end = |parts: usize| rows / self.of * parts + (rows % self.of).min(parts);
        end(self.number - 1)..end(self.number)
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl FromStr for Part {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/').and_then(|(k, n)| Some((k.trim().parse().ok()?, n.trim().parse().ok()?)));
        match parts {
            Some((number, of)) if (1..=of).contains(&number) => Ok(Self { number, of }),
            _ => Err(format!("\"{text}\" is no part: expected K/N with K from 1 to N, such as 3/100")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_part_is_written_as_a_fraction() {
        assert_eq!("3/100".parse::<Part>().map(|part| part.to_string()), Ok("3/100".to_owned()));
        for wrong in ["0/3", "4/3", "3", "a/b", "1/0", "-1/2"] {
            assert!(wrong.parse::<Part>().unwrap_err().contains("expected K/N"));
        }
    }

    proptest! {
        /// Every row is in one part, in order, and parts are as large as each other.
        #[test]
        fn parts_make_the_whole(rows in 0_usize..1000, of in 1_usize..120) {
            let parts: Vec<_> = (1..=of).map(|number| Part { number, of }.rows(rows)).collect();
            let all: Vec<usize> = parts.iter().cloned().flatten().collect();
            prop_assert_eq!(all, (0..rows).collect::<Vec<_>>());
            let sizes = || parts.iter().map(ExactSizeIterator::len);
            prop_assert!(sizes().max().unwrap() - sizes().min().unwrap() <= 1);
        }
    }
}
