//! Monotone piecewise cubic through points, measured or computed.

/// Piecewise cubic with a continuous slope, which rises nowhere where the points do not.
///
/// Slopes at the points are those of the parabola through three neighbours (second order; exact for a
/// cone and for a paraboloid, whatever the spacing), limited to three times the smaller of the
/// neighbouring secants (Fritsch & Carlson 1980, sufficient condition for monotony).
#[derive(Debug, Clone)]
pub struct Interpolant {
    radii: Vec<f64>,
    heights: Vec<f64>,
    slopes: Vec<f64>,
}

/// Fewest points that give a slope and its change.
pub const FEWEST: usize = 3;

/// One piece: f′(u) = m₀ + u(2c₂ + 3c₃u) with u = (r−r₀)/h in [0, 1].
#[derive(Debug, Clone, Copy)]
pub struct Cubic {
    /// Radius at its start [m].
    pub start: f64,
    /// Radius at its end [m].
    pub end: f64,
    first: f64,
    second: f64,
    third: f64,
}

impl Cubic {
    /// f′ at the radius `r`, held inside the piece.
    pub fn slope(&self, r: f64) -> f64 {
        let u = self.fraction(r);
        self.first + u * (2.0 * self.second + 3.0 * self.third * u)
    }

    /// (r f′)′ = f′ + r f″ at the radius `r`.
    pub fn growth(&self, r: f64) -> f64 {
        let u = self.fraction(r);
        self.slope(r) + r * (2.0 * self.second + 6.0 * self.third * u) / (self.end - self.start)
    }

    fn rise(&self, r: f64) -> f64 {
        let u = self.fraction(r);
        (r - self.start).max(0.0) * (self.first + u * (self.second + u * self.third))
    }

    fn fraction(&self, r: f64) -> f64 {
        ((r - self.start) / (self.end - self.start)).clamp(0.0, 1.0)
    }
}

impl Interpolant {
    /// The interpolant through every other point and the last; `None` where fewer than three are left.
    pub fn coarser(&self) -> Option<Self> {
        let last = self.radii.len() - 1;
        let every_other = |values: &[f64]| -> Vec<f64> {
            let kept = values.iter().enumerate().filter(|(at, _)| at % 2 == 0 || *at == last);
            kept.map(|(_, value)| *value).collect()
        };
        let (radii, heights) = (every_other(&self.radii), every_other(&self.heights));
        (radii.len() >= FEWEST).then(|| Self::new(radii, heights))
    }

    /// The interpolant through at least three points of rising radii.
    pub fn new(radii: Vec<f64>, heights: Vec<f64>) -> Self {
        let steps: Vec<f64> = radii.windows(2).map(|r| r[1] - r[0]).collect();
        let secants: Vec<f64> = heights.windows(2).zip(&steps).map(|(f, h)| (f[1] - f[0]) / h).collect();
        let last = secants.len() - 1;
        let mut slopes = Vec::with_capacity(radii.len());
        let apex = end_slope((steps[0], steps[1]), (secants[0], secants[1]));
        slopes.push(if apex > ROUNDING * secants[0] { apex } else { 0.0 });
        slopes.extend((1..=last).map(|i| inner_slope((steps[i - 1], steps[i]), (secants[i - 1], secants[i]))));
        slopes.push(end_slope((steps[last], steps[last - 1]), (secants[last], secants[last - 1])));
        Self { radii, heights, slopes }
    }

    /// Number of pieces.
    pub fn pieces(&self) -> usize {
        self.radii.len() - 1
    }

    /// The radii of the points.
    pub fn radii(&self) -> &[f64] {
        &self.radii
    }

    /// Radius up to which the height is zero.
    pub fn flat(&self) -> f64 {
        let risen = self.heights.partition_point(|&height| height <= self.heights[0]);
        self.radii[risen.max(1) - 1]
    }

    /// Slope f′ at the apex.
    pub fn apex_slope(&self) -> f64 {
        self.slopes[0]
    }

    /// The piece of index `i`.
    pub fn piece(&self, i: usize) -> Cubic {
        let (start, end) = (self.radii[i], self.radii[i + 1]);
        let (step, first, last) = (end - start, self.slopes[i], self.slopes[i + 1]);
        let secant = (self.heights[i + 1] - self.heights[i]) / step;
        Cubic { start, end, first, second: 3.0 * secant - 2.0 * first - last, third: first + last - 2.0 * secant }
    }

    /// Height f(r) above the apex; beyond the last point infinite.
    pub fn height(&self, r: f64) -> f64 {
        if r > self.radii[self.pieces()] {
            return f64::INFINITY;
        }
        let i = self.radii.partition_point(|&at| at <= r).clamp(1, self.pieces()) - 1;
        self.heights[i] - self.heights[0] + self.piece(i).rise(r)
    }
}

/// Part of the first secant below which the slope at the apex is rounding: the tip is smooth there
/// and its pressure finite.
const ROUNDING: f64 = 1e-9;

/// Slope at an inner point from the steps and secants on both sides.
fn inner_slope((before, after): (f64, f64), (rise, next): (f64, f64)) -> f64 {
    let parabola = (before * next + after * rise) / (before + after);
    parabola.clamp(0.0, 3.0 * rise.min(next))
}

/// Slope at an end point from the nearest and the second nearest step and secant.
fn end_slope((near, far): (f64, f64), (rise, next): (f64, f64)) -> f64 {
    let parabola = rise + near * (rise - next) / (near + far);
    parabola.clamp(0.0, 3.0 * rise)
}
