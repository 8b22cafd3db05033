//! What a uniformly sheared pixel does to the surface, beside what a pressed one does.

use std::f64::consts::FRAC_1_PI;

/// Integrals over a rectangle of area 1 whose centre is away by (X, Y) from the place looked at, each over π
/// (Love 1929; Johnson 1985, § 3.2 and 3.6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sheared {
    /// ∫∫ X²/r³ dA.
    pub(super) along: f64,
    /// ∫∫ XY/r³ dA.
    pub(super) across: f64,
    /// ∫∫ X/r² dA and ∫∫ Y/r² dA.
    pub(super) lifted: [f64; 2],
}

/// Distance in sides beyond which four points of Gauss along each side are exact to rounding: what they leave falls with
/// the eighth power of half a side over the distance.
const FAR: f64 = 32.0;

/// Points and weights of Gauss' rule on −½…½.
const GAUSS: [(f64, f64); 4] = [
    (-0.430_568_155_797_026_3, 0.173_927_422_568_726_9),
    (-0.169_990_521_792_428_1, 0.326_072_577_431_273_1),
    (0.169_990_521_792_428_1, 0.326_072_577_431_273_1),
    (0.430_568_155_797_026_3, 0.173_927_422_568_726_9),
];

impl Sheared {
    /// Of a rectangle of the sides `[along x, along y]`, at (x, y) from its centre, both at least zero and no corner of it.
    pub(super) fn at([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Self {
        let given = if x.hypot(y) > FAR * width.max(height) {
            Self::by_points([x, y], [width, height])
        } else {
            Self::closed([x, y], [width, height])
        };
        Self {
            along: FRAC_1_PI * given.along,
            across: FRAC_1_PI * given.across,
            lifted: given.lifted.map(|part| FRAC_1_PI * part),
        }
    }

    fn by_points([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Self {
        let mut sum = Self { along: 0.0, across: 0.0, lifted: [0.0; 2] };
        for (s, along_x) in GAUSS {
            for (t, along_y) in GAUSS {
                let (x, y) = (x - s * width, y - t * height);
                let square = x * x + y * y;
                let weight = width * height * along_x * along_y / square;
                sum.along += weight * x * x / square.sqrt();
                sum.across += weight * x * y / square.sqrt();
                sum.lifted[0] += weight * x;
                sum.lifted[1] += weight * y;
            }
        }
        sum
    }

    /// Differences of Y ln(X + r), −r, ½Y ln r² + X atan(Y/X) and the like between the corners.
    fn closed([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Self {
        let sides = [[x - 0.5 * width, x + 0.5 * width], [y - 0.5 * height, y + 0.5 * height]];
        let corners = |of: &dyn Fn(f64, f64) -> f64| {
            let [[left, right], [lower, upper]] = sides;
            (of(right, upper) - of(left, upper)) - (of(right, lower) - of(left, lower))
        };
        Self {
            along: corners(&|x, y| y * (x / y.abs()).asinh()),
            across: corners(&|x, y| -x.hypot(y)),
            lifted: [corners(&lifted), corners(&|x, y| lifted(y, x))],
        }
    }
}

/// ∫∫ X/r² dX dY without bounds, but for what a difference along X takes off.
fn lifted(x: f64, y: f64) -> f64 {
    y * x.hypot(y).ln() + x * (y / x).atan()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nine pixels are one of three times their sides, near and far and across the change of formula. Lengths scale: what
    /// falls as 1/r grows with the side, an integral over an area.
    #[test]
    fn pixels_add_up_to_a_larger_one() {
        for sides in [[1.0, 1.0], [0.7, 1.0 / 0.7]] {
            for (x, y) in [(0.0, 0.0), (3.0, 0.0), (0.0, 6.0), (6.0, 9.0), (30.0, 12.0), (45.0, 45.0), (240.0, 3.0)] {
                let large = Sheared::at([x * sides[0], y * sides[1]], sides.map(|side| 3.0 * side));
                let mut sum = [0.0; 4];
                for k in 0..9_u8 {
                    let at = [(x + f64::from(k % 3) - 1.0) * sides[0], (y + f64::from(k / 3) - 1.0) * sides[1]];
                    let small = Sheared::at(at.map(f64::abs), sides);
                    let [sx, sy] = at.map(f64::signum);
                    let parts = [small.along, sx * sy * small.across, sx * small.lifted[0], sy * small.lifted[1]];
                    sum.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
                }
                for (small, whole) in sum.into_iter().zip([large.along, large.across, large.lifted[0], large.lifted[1]])
                {
                    // Corners of the order of 32 sides cancel to 1/32 of one.
                    assert!((small - whole).abs() < 1e-12, "{x} {y}: {small} {whole}");
                }
            }
        }
    }

    /// A square sheared at its own centre is moved along by half of what a pressure moves it down, X² + Y² = r²; nothing is
    /// lifted: Johnson 1985, eq. 3.25.
    #[test]
    fn square_under_itself() {
        let own = Sheared::at([0.0; 2], [1.0; 2]);
        let pressed = 4.0 * FRAC_1_PI * (1.0 + 2.0_f64.sqrt()).ln();
        assert!((own.along / (0.5 * pressed) - 1.0).abs() < 1e-15);
        assert!(own.across.abs() < 1e-16 && own.lifted.iter().all(|part| part.abs() < 1e-16));
    }
}
