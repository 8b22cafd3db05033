//! The edge of a contact that is known by means over cells.
//!
//! How far the springs are below the depth, u = d − g, passes zero at the edge a: as C(a − x)^β inside and as −C′(x − a)^β
//! outside. β is one as wear begins, and tends to ½ as the pressure becomes uniform. It and C follow from the cells just
//! inside, C′ from those just outside, and the place of a in its cell from the mean of u over that: what a tenth of a
//! cell is known to, where a line through the means would be off by half of one.

use crate::numerics::root;

/// Means over cells of how far springs are below the depth.
struct Means<'m> {
    /// Borders of the cells.
    borders: &'m [f64],
    below: &'m [f64],
}

/// Radius of the edge, from the borders of the cells and the means of d − g over them, the last touched one being `last`
/// and not the last of all.
pub fn edge(borders: &[f64], below: &[f64], last: usize) -> f64 {
    let means = Means { borders, below };
    means.by_power(last).unwrap_or_else(|| means.by_line(last))
}

impl Means<'_> {
    fn middle(&self, i: usize) -> f64 {
        0.5 * (self.borders[i] + self.borders[i + 1])
    }

    /// Where the line through the means on both sides passes zero.
    fn by_line(&self, last: usize) -> f64 {
        let (inside, outside) = (self.below[last], self.below[last + 1]);
        self.middle(last) + inside / (inside - outside) * (self.middle(last + 1) - self.middle(last))
    }

    /// By the power laws of both sides; `None` where the means do not fall as they do.
    fn by_power(&self, last: usize) -> Option<f64> {
        let inner = last.checked_sub(3)?;
        let around = self.below.get(inner..=last + 3)?;
        if around.windows(2).any(|pair| pair[1] >= pair[0]) {
            return None;
        }
        let exponent = self.exponent(last - 1);
        let inside = self.steepness((last - 2, last - 1), exponent);
        let outside = self.steepness((last + 2, last + 3), exponent);
        self.place(last + 1, (inside, outside), exponent).or_else(|| self.place(last, (inside, outside), exponent))
    }

    /// The β with which u^{1/β} is a line through three cells, the outermost being `outer`.
    fn exponent(&self, outer: usize) -> f64 {
        let bend = |exponent: f64| {
            let value = |i: usize| self.below[i].powf(exponent.recip());
            let slope = |i: usize| (value(i) - value(i + 1)) / (self.middle(i + 1) - self.middle(i));
            slope(outer - 1) - slope(outer - 2)
        };
        let (low, high) = (0.5, 1.0);
        root::brent(bend, low, high).unwrap_or(if bend(low).abs() < bend(high).abs() { low } else { high })
    }

    /// C of the power law through two cells on one side.
    fn steepness(&self, (one, other): (usize, usize), exponent: f64) -> f64 {
        let value = |i: usize| self.below[i].abs().powf(exponent.recip());
        ((value(one) - value(other)).abs() / (self.middle(other) - self.middle(one))).powf(exponent)
    }

    /// The edge in the cell `i`, if its mean is one of an edge inside it.
    fn place(&self, i: usize, (inside, outside): (f64, f64), exponent: f64) -> Option<f64> {
        let (from, width) = (self.borders[i], self.borders[i + 1] - self.borders[i]);
        let scale = width.powf(exponent) / (exponent + 1.0);
        let mean = |part: f64| {
            let power = |part: f64| part.powf(exponent + 1.0);
            scale * (inside * power(part) - outside * power(1.0 - part)) - self.below[i]
        };
        if mean(1.0) < 0.0 {
            return Some(from + width);
        }
        root::brent(mean, 0.0, 1.0).ok().map(|part| from + width * part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::quadrature;

    /// Means of known curves, and the places of their edges.
    #[test]
    fn edges_are_found_within_their_cells() {
        for exponent in [0.5, 0.7, 1.0] {
            for ratio in [0.5, 1.0, 4.0] {
                for at in [0.02, 0.25, 0.5, 0.77, 0.98] {
                    let a = 0.6 + 0.02 * at;
                    let curve = |x: f64| {
                        if x < a { (a - x).powf(exponent) } else { -ratio * (x - a).powf(exponent) }
                    };
                    let borders: Vec<f64> = (0..=50).map(|k| 0.02 * f64::from(k)).collect();
                    let mean = |pair: &[f64]| {
                        let whole = if pair[0] < a && a < pair[1] {
                            quadrature::panel_with_root_ends(|t, _| curve(pair[0] + t), a - pair[0])
                                + quadrature::panel_with_root_ends(|t, _| curve(a + t), pair[1] - a)
                        } else {
                            quadrature::panel(curve, pair[0], pair[1])
                        };
                        whole / (pair[1] - pair[0])
                    };
                    let below: Vec<f64> = borders.windows(2).map(mean).collect();
                    let last = below.iter().rposition(|&u| u > 0.0).unwrap();
                    let off = (edge(&borders, &below, last) - a).abs() / 0.02;
                    assert!(off < 0.1, "{exponent} {ratio} {at}: {off}");
                }
            }
        }
    }
}
