//! Numbers of a scene: its units, its ratios, the series of its bodies and the turns of its history.
//!
//! # Examples
//! ```
//! use springbed::check::matrix::Variation;
//!
//! // The same number draws the same scene; another one draws another.
//! let (one, part) = Variation::numbered(7);
//! assert_eq!((one.clone(), part), Variation::numbered(7));
//! assert!(one != Variation::numbered(8).0 && (1..=5).contains(&one.turns.len()));
//! ```

use super::choices::SERIES;
use crate::shape::rough::random::Random;

/// Units in which a scene is written, as multiples of those of the matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Units {
    /// Of lengths.
    pub length: f64,
    /// Of moduli.
    pub modulus: f64,
    /// Of times.
    pub time: f64,
}

impl Default for Units {
    fn default() -> Self {
        Self { length: 1.0, modulus: 1.0, time: 1.0 }
    }
}

impl Units {
    /// What a unit of the matrix is in these; one it does not know is none.
    pub(super) fn of(&self, unit: &str) -> f64 {
        let &Self { length, modulus, time } = self;
        let force = modulus * length * length;
        match unit {
            "m" => length,
            "Pa" => modulus,
            "s" => time,
            "m/s" => length / time,
            "N" => force,
            "N/m" | "J/m2" => modulus * length,
            "m2/N" => 1.0 / modulus,
            "N s/m" => force * time / length,
            "Pa s" => modulus * time,
            _ => f64::NAN,
        }
    }

    /// The number and its unit, such as `2 N`.
    pub(super) fn value(&self, text: &str) -> f64 {
        let inside = text.trim_matches(['<', '>']);
        let (number, unit) = inside.split_once(' ').unwrap_or((inside, ""));
        number.parse::<f64>().map_or(f64::NAN, |number| number * self.of(unit))
    }

    /// A text with its numbers `<…>` in these units.
    pub(super) fn fill(&self, text: &str) -> String {
        let mut parts = text.split(['<', '>']).enumerate();
        let plain = |(k, part): (usize, &str)| {
            if k % 2 == 0 { part.to_owned() } else { format!("{:e}", self.value(part)) }
        };
        parts.by_ref().map(plain).collect()
    }
}

/// A part of a history: where it leads to, how long it takes, and what follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// Depth or force, as a part of the largest; below zero it pulls.
    pub level: f64,
    /// Time it takes, as a multiple of the time of the scene.
    pub over: f64,
    /// How long it is held then, in the same way.
    pub hold: Option<f64>,
    /// Where it slides to, as a multiple of the slide of the scene.
    pub slide: f64,
}

/// Other numbers than those of the matrix, as multiples of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Variation {
    /// Units in which the scene is written.
    pub units: Units,
    /// Of depths and forces.
    pub depth: f64,
    /// Of times.
    pub time: f64,
    /// Of works of adhesion.
    pub work: f64,
    /// Of the stress of an attraction.
    pub stress: f64,
    /// Of the frequency, speed or amplitude of a motion.
    pub pace: f64,
    /// Series of the bodies that relax.
    pub series: [String; 2],
    /// Turns of the history; none for those of the matrix.
    pub turns: Vec<Turn>,
}

impl Default for Variation {
    fn default() -> Self {
        Self {
            units: Units::default(),
            depth: 1.0,
            time: 1.0,
            work: 1.0,
            stress: 1.0,
            pace: 1.0,
            series: SERIES.map(str::to_owned),
            turns: Vec::new(),
        }
    }
}

/// Draws whole numbers, so that scenes repeat everywhere to the last digit.
struct Dice(Random);

impl Dice {
    /// A whole number from `low` to `high`.
    #[expect(clippy::cast_possible_truncation, reason = "within the range of the ends")]
    fn whole(&mut self, low: i32, high: i32) -> i32 {
        low + (self.0.unit() * f64::from(high - low + 1)) as i32
    }

    /// One in so many.
    fn one_in(&mut self, many: i32) -> bool {
        self.whole(1, many) == 1
    }

    /// A power of ten from 10^low to 10^high, in quarters of a decade.
    fn decades(&mut self, low: i32, high: i32) -> f64 {
        10f64.powf(0.25 * f64::from(self.whole(4 * low, 4 * high)))
    }

    /// A series of 0 to 3 terms about moduli of 1 MPa and the time `time`, seldom of a liquid or beside a dashpot, still more
    /// seldom a dashpot alone.
    fn series(&mut self, time: f64) -> String {
        let terms = self.whole(0, 3);
        let viscosity = if self.one_in(6) { 1e6 * time * self.decades(-3, 1) } else { 0.0 };
        let is_liquid = (terms > 0 || viscosity > 0.0) && self.one_in(8);
        let equilibrium = if is_liquid { 0.0 } else { 1e6 * self.decades(-1, 1) };
        let term = |dice: &mut Self| {
            let (modulus, time) = (1e6 * dice.decades(-2, 1), time * dice.decades(-3, 3));
            format!("(modulus: <{modulus:e} Pa>, time: <{time:e} s>)")
        };
        let terms: Vec<String> = (0..terms).map(|_| term(self)).collect();
        let terms = terms.join(", ");
        format!("(equilibrium: <{equilibrium:e} Pa>, terms: [{terms}], viscosity: <{viscosity:e} Pa s>)")
    }

    fn turn(&mut self) -> Turn {
        Turn {
            level: 0.1 * f64::from(self.whole(-4, 10)),
            over: self.decades(-1, 1),
            hold: self.one_in(3).then(|| self.decades(-1, 1)),
            slide: 0.2 * f64::from(self.whole(-5, 5)),
        }
    }
}

impl Variation {
    /// The variation with a number, and a part of a way at which to cut.
    #[must_use]
    pub fn numbered(number: u64) -> (Self, f64) {
        let mut dice = Dice(Random::seeded(number));
        let time = dice.decades(-2, 2);
        let turns = dice.whole(1, 5);
        let units = Units { length: dice.decades(-4, 2), modulus: dice.decades(-3, 6), time: dice.decades(-6, 6) };
        let variation = Self {
            units,
            depth: dice.decades(-2, 0),
            time,
            work: dice.decades(-6, 0),
            stress: dice.decades(-2, 1),
            pace: dice.decades(-1, 1),
            series: [dice.series(time), dice.series(time)],
            turns: (0..turns).map(|_| dice.turn()).collect(),
        };
        (variation, 0.05 * f64::from(dice.whole(1, 19)))
    }

    /// The same scene in the units of the matrix.
    pub(super) fn in_plain_units(&self) -> Self {
        Self { units: Units::default(), ..self.clone() }
    }
}
