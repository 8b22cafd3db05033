//! A measured curve.

use crate::contact::adhesion::equilibrium::Control;

/// What was measured, row by row, in SI units.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// Times [s], rising; `None` if they were not measured.
    pub time: Option<Vec<f64>>,
    /// Depths [m], from any zero.
    pub depth: Vec<f64>,
    /// Forces [N], compression positive.
    pub force: Vec<f64>,
    /// Row of the file in which each line of values stands.
    pub rows: Vec<usize>,
}

impl Curve {
    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.depth.len()
    }

    /// Whether there is no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.depth.is_empty()
    }

    /// Whether all columns have a finite number per row, and the times rise.
    pub(super) fn checked(&self) -> Result<(), String> {
        let columns = [Some(&self.depth), Some(&self.force), self.time.as_ref()];
        let columns: Vec<&Vec<f64>> = columns.into_iter().flatten().collect();
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
        Ok(())
    }

    /// What was prescribed.
    #[must_use]
    pub fn driven(&self, control: Control) -> &[f64] {
        match control {
            Control::Indentation => &self.depth,
            Control::Force => &self.force,
        }
    }

    /// What answered.
    #[must_use]
    pub fn answered(&self, control: Control) -> &[f64] {
        match control {
            Control::Indentation => &self.force,
            Control::Force => &self.depth,
        }
    }

    /// Every so many points of the `used` ones that at most `most` are left, those at which the drive turns among them.
    #[must_use]
    pub fn thinned(&self, used: &[usize], control: Control, most: usize) -> Self {
        let drive = self.driven(control);
        let every = used.len().div_ceil(most.max(2)).max(1);
        let deepest = used.iter().copied().max_by(|&a, &b| drive[a].total_cmp(&drive[b]));
        let last = used.last().copied();
        let kept = |&(number, &at): &(usize, &usize)| number % every == 0 || Some(at) == deepest || Some(at) == last;
        let kept: Vec<usize> = used.iter().enumerate().filter(kept).map(|(_, &at)| at).collect();
        let of = |column: &[f64]| kept.iter().map(|&at| column[at]).collect();
        Self {
            time: self.time.as_deref().map(of),
            depth: of(&self.depth),
            force: of(&self.force),
            rows: kept.iter().map(|&at| self.rows[at]).collect(),
        }
    }
}
