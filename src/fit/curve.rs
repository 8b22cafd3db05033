//! A measured curve.

use crate::scene::fit::Drive;

/// What was measured, row by row, in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Times [s], rising; `None` if they were not measured.
    pub time: Option<Vec<f64>>,
    /// The two columns.
    pub readings: Readings,
    /// Row of the file in which each line of values stands.
    pub rows: Vec<usize>,
}

/// Two columns of values that were measured together.
#[derive(Debug, Clone, PartialEq)]
pub enum Readings {
    /// Of a body that is pressed in.
    Indentation {
        /// Depths [m], from any zero.
        depth: Vec<f64>,
        /// Forces [N], compression positive.
        force: Vec<f64>,
    },
    /// Of impacts, one per row.
    Impacts {
        /// Speeds before [m/s].
        speed: Vec<f64>,
        /// Speeds after over those before.
        restitution: Vec<f64>,
    },
    /// Of a body that is moved along.
    Slides {
        /// Tangential displacements [m], from any zero.
        slide: Vec<f64>,
        /// Tangential forces [N].
        force: Vec<f64>,
    },
}

impl Readings {
    /// The columns `first` and `second` of what is driven by `led`: depth and force, speed and restitution, or slide and
    /// tangential force.
    #[must_use]
    pub fn of(led: Drive, [first, second]: [Vec<f64>; 2]) -> Self {
        match led {
            Drive::Depth | Drive::Force => Self::Indentation { depth: first, force: second },
            Drive::Speed => Self::Impacts { speed: first, restitution: second },
            Drive::Slide => Self::Slides { slide: first, force: second },
        }
    }

    /// Both columns.
    #[must_use]
    pub fn both(&self) -> [&Vec<f64>; 2] {
        match self {
            Self::Indentation { depth, force } => [depth, force],
            Self::Impacts { speed, restitution } => [speed, restitution],
            Self::Slides { slide, force } => [slide, force],
        }
    }

    /// Both columns, changed by `change`.
    fn each(&self, change: impl Fn(&[f64]) -> Vec<f64>) -> Self {
        let [first, second] = self.both().map(|column| change(column));
        let led = match self {
            Self::Indentation { .. } => Drive::Depth,
            Self::Impacts { .. } => Drive::Speed,
            Self::Slides { .. } => Drive::Slide,
        };
        Self::of(led, [first, second])
    }

    /// Whether they are of what `led` drives.
    fn fits(&self, led: Drive) -> bool {
        match self {
            Self::Indentation { .. } => matches!(led, Drive::Depth | Drive::Force),
            Self::Impacts { .. } => led == Drive::Speed,
            Self::Slides { .. } => led == Drive::Slide,
        }
    }

    fn in_words(&self) -> &'static str {
        match self {
            Self::Indentation { .. } => "depths and forces",
            Self::Impacts { .. } => "speeds and restitutions",
            Self::Slides { .. } => "slides and tangential forces",
        }
    }
}

impl Curve {
    /// Depths [m] and forces [N], which were not timed.
    #[must_use]
    pub fn of_depths(depth: Vec<f64>, force: Vec<f64>) -> Self {
        Self { rows: (0..depth.len()).collect(), time: None, readings: Readings::Indentation { depth, force } }
    }

    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.readings.both()[0].len()
    }

    /// Whether there is no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether all columns have a finite number per row, the times rise, and all of it is of what `led` drives.
    pub(super) fn checked(&self, led: Drive) -> Result<(), String> {
        let columns: Vec<&Vec<f64>> = self.readings.both().into_iter().chain(self.time.as_ref()).collect();
        if columns.iter().any(|column| column.len() != self.rows.len()) {
            return Err("the columns have not as many values as there are rows: expected one per row".to_owned());
        }
        if columns.iter().any(|column| column.iter().any(|value| !value.is_finite())) {
            return Err("a value is not finite: expected numbers only".to_owned());
        }
        let time = self.time.as_deref().unwrap_or(&[]);
        if time.windows(2).any(|pair| pair[1] <= pair[0]) {
            return Err("the times do not rise: expected each later than the one before".to_owned());
        }
        if !self.readings.fits(led) {
            let (here, right) = (self.readings.in_words(), Readings::of(led, Default::default()).in_words());
            return Err(format!("the data are {here}: expected {right}"));
        }
        match &self.readings {
            Readings::Impacts { speed, .. } if speed.iter().any(|speed| *speed <= 0.0) => {
                Err("a speed is not above zero: expected speeds of approach".to_owned())
            }
            Readings::Impacts { .. } | Readings::Indentation { .. } | Readings::Slides { .. } => Ok(()),
        }
    }

    /// What was prescribed.
    #[must_use]
    pub fn driven(&self, led: Drive) -> &[f64] {
        let [first, second] = self.readings.both();
        if led == Drive::Force { second } else { first }
    }

    /// What answered.
    #[must_use]
    pub fn answered(&self, led: Drive) -> &[f64] {
        let [first, second] = self.readings.both();
        if led == Drive::Force { first } else { second }
    }

    /// The same with other values of what answered.
    #[must_use]
    pub fn answering(&self, led: Drive, answers: Vec<f64>) -> Self {
        let drive = self.driven(led).to_vec();
        let columns = if led == Drive::Force { [answers, drive] } else { [drive, answers] };
        Self { readings: Readings::of(led, columns), ..self.clone() }
    }

    /// Every so many points of the `used` ones that at most `most` are left, those at which the drive turns among them.
    #[must_use]
    pub fn thinned(&self, used: &[usize], led: Drive, most: usize) -> Self {
        let drive = self.driven(led);
        let every = used.len().div_ceil(most.max(2)).max(1);
        let mut kept = if led == Drive::Slide { turning(drive, used, 2 * every) } else { Vec::new() };
        if kept.is_empty() {
            kept.extend(used.iter().copied().step_by(every));
            kept.extend(used.iter().copied().max_by(|&a, &b| drive[a].total_cmp(&drive[b])));
        }
        kept.extend(used.last());
        kept.sort_unstable();
        kept.dedup();
        let of = |column: &[f64]| kept.iter().map(|&at| column[at]).collect::<Vec<f64>>();
        Self {
            time: self.time.as_deref().map(of),
            readings: self.readings.each(of),
            rows: kept.iter().map(|&at| self.rows[at]).collect(),
        }
    }
}

/// The first of the `used` points, and of every `count` of them the least and the largest drive: a loop that is thinned so
/// turns where it did.
fn turning(drive: &[f64], used: &[usize], count: usize) -> Vec<usize> {
    let ends = used.chunks(count).flat_map(|chunk| {
        let least = chunk.iter().copied().min_by(|&a, &b| drive[a].total_cmp(&drive[b]));
        let largest = chunk.iter().copied().max_by(|&a, &b| drive[a].total_cmp(&drive[b]));
        least.into_iter().chain(largest)
    });
    used.first().copied().into_iter().chain(ends).collect()
}
