//! Minimal residuals over the pixels in contact (Saad & Schultz 1986, SIAM J. Sci. Stat. Comput. 7, 856).
//!
//! What slides fast over a ground that gives way late alone answers almost as a turn of a quarter does: it gains next to
//! nothing along its own residual, and directions sought there come to a halt. What the last direction did leads on.

use crate::halfspace::vector::{dot, scale, update};

/// Directions of one cycle, and what has been found of them.
pub(super) struct Subspace {
    /// Orthogonal, of length one.
    basis: Vec<Vec<f64>>,
    /// Columns of the triangle that the turns leave.
    triangle: Vec<Vec<f64>>,
    /// Cosine and sine of each turn.
    turns: Vec<[f64; 2]>,
    /// The residual in the basis; its last entry is what is left.
    left: Vec<f64>,
}

impl Subspace {
    /// Around a residual; `None` if there is none.
    pub(super) fn around(residual: Vec<f64>) -> Option<Self> {
        let length = dot(&residual, &residual).sqrt();
        (length > 0.0 && length.is_finite()).then(|| {
            let basis = vec![scaled(residual, length.recip())];
            Self { basis, triangle: Vec::new(), turns: Vec::new(), left: vec![length] }
        })
    }

    /// The direction to be tried next.
    pub(super) fn next(&self) -> &[f64] {
        self.basis.last().map_or(&[], Vec::as_slice)
    }

    /// Length of what would be left of the residual.
    pub(super) fn rest(&self) -> f64 {
        self.signed_rest().abs()
    }

    /// Takes what the direction tried last does; whether there is another one.
    pub(super) fn take(&mut self, mut effect: Vec<f64>) -> bool {
        let whole = dot(&effect, &effect).sqrt();
        let mut column: Vec<f64> = Vec::new();
        for direction in &self.basis {
            let share = dot(&effect, direction);
            update(&mut effect, direction, |value, part| *value -= share * part);
            column.push(share);
        }
        let beyond = dot(&effect, &effect).sqrt();
        let mut below = beyond;
        for (k, [cosine, sine]) in self.turns.iter().enumerate() {
            let [above, next] = [column[k], column[k + 1]];
            (column[k], column[k + 1]) = (cosine * above + sine * next, cosine * next - sine * above);
        }
        let Some(last) = column.last_mut() else { return false };
        let length = last.hypot(below);
        if !(length > 0.0 && length.is_finite()) {
            return false;
        }
        let [cosine, sine] = [*last / length, below / length];
        (*last, below) = (length, self.signed_rest());
        let count = self.left.len();
        self.left[count - 1] = cosine * below;
        self.left.push(-sine * below);
        self.turns.push([cosine, sine]);
        self.triangle.push(column);
        let goes_on = beyond > f64::EPSILON * whole;
        if goes_on {
            self.basis.push(scaled(effect, beyond.recip()));
        }
        goes_on
    }

    fn signed_rest(&self) -> f64 {
        self.left.last().copied().unwrap_or_default()
    }

    /// The sum of directions whose effects leave the least of the residual.
    pub(super) fn best(&self) -> Vec<f64> {
        let mut shares = self.left[..self.triangle.len()].to_vec();
        for (k, column) in self.triangle.iter().enumerate().rev() {
            shares[k] /= column[k];
            for above in 0..k {
                shares[above] -= shares[k] * column[above];
            }
        }
        let mut sum = vec![0.0; self.next().len()];
        for (direction, &share) in self.basis.iter().zip(&shares) {
            update(&mut sum, direction, |value, part| *value += share * part);
        }
        sum
    }
}

fn scaled(mut values: Vec<f64>, by: f64) -> Vec<f64> {
    scale(&mut values, by);
    values
}
