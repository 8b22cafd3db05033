//! Range of an axis and the place of a value on it.

use super::{Axis, Scale, unit};

/// Values beyond are gaps: their sums and scaled forms would overflow.
const LARGEST: f64 = 1e305;
/// Magnitudes below count as zero on a linear axis.
const SMALLEST: f64 = 1e-300;
/// Relative span below which a quantity counts as constant: labels would need more than six digits.
const CONSTANT: f64 = 1e-6;
/// Decades up to which a logarithmic axis is labelled by plain numbers.
const FEW_DECADES: f64 = 2.5;

/// What an axis shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisRange {
    pub(super) scale: Scale,
    /// The numbers on the axis are values divided by 10ⁿ.
    pub(super) exponent: i32,
    /// Ends: values divided by 10ⁿ on a linear axis, decimal logarithms of values on a logarithmic one.
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// Whether the place of the lower end is one and that of the upper end zero.
    pub(super) falling: bool,
}

impl AxisRange {
    /// Range of `axis` around the data between `lo` and `hi`, if there are any.
    pub(super) fn new(axis: &Axis, data: Option<(f64, f64)>) -> Self {
        let limits = limits(axis, data);
        let data = data.unwrap_or_else(|| lonely(axis.scale, limits));
        let ends = (limits.0.unwrap_or(data.0), limits.1.unwrap_or(data.1));
        match axis.scale {
            Scale::Linear => Self::linear(axis, ends, limits),
            Scale::Log => Self::log(axis, ends, limits),
        }
    }

    fn linear(axis: &Axis, ends: (f64, f64), limits: Limits) -> Self {
        let largest = ends.0.abs().max(ends.1.abs());
        let largest = if largest < SMALLEST { 0.0 } else { largest };
        let exponent = unit::exponent(&axis.unit, largest);
        let (lo, hi) = (shift(ends.0, exponent), shift(ends.1, exponent));
        let (low, high) = widen(lo, hi);
        let wide = hi - lo > CONSTANT * lo.abs().max(hi.abs());
        Self {
            scale: Scale::Linear,
            exponent,
            lo: if wide && limits.0.is_some() { lo } else { low },
            hi: if wide && limits.1.is_some() { hi } else { high },
            falling: false,
        }
    }

    fn log(axis: &Axis, ends: (f64, f64), limits: Limits) -> Self {
        let (lo, hi) = (ends.0.log10(), ends.1.log10());
        let wide = hi - lo > CONSTANT;
        let pad = if wide { 0.04 * (hi - lo) } else { 0.5 };
        let lo = if wide && limits.0.is_some() { lo } else { lo - pad };
        let hi = if wide && limits.1.is_some() { hi } else { hi + pad };
        let few = hi - lo <= FEW_DECADES;
        Self {
            scale: Scale::Log,
            exponent: if few { unit::exponent(&axis.unit, ends.1) } else { 0 },
            lo,
            hi,
            falling: false,
        }
    }

    /// Whether the ticks are plain numbers, not powers of ten.
    pub(super) fn is_plain(&self) -> bool {
        self.scale == Scale::Linear || self.hi - self.lo <= FEW_DECADES
    }

    /// Fraction of the axis at `value`; none if the value cannot be shown.
    pub(super) fn place(&self, value: f64) -> Option<f64> {
        usable(self.scale, value).then(|| {
            let t = match self.scale {
                Scale::Linear => shift(value, self.exponent),
                Scale::Log => value.log10(),
            };
            let along = self.fraction(t);
            if self.falling { 1.0 - along } else { along }
        })
    }

    /// Fraction of the axis at the coordinate `t` in which its ends are given.
    pub(super) fn fraction(&self, t: f64) -> f64 {
        ((t - self.lo) / (self.hi - self.lo)).clamp(-1e4, 1e4)
    }

    /// Whether `value` lies on the axis.
    pub(super) fn holds(&self, value: f64) -> bool {
        self.place(value).is_some_and(|f| (-1e-9..=1.0 + 1e-9).contains(&f))
    }
}

type Limits = (Option<f64>, Option<f64>);

/// Limits that can be kept: usable, and leaving something between them.
fn limits(axis: &Axis, data: Option<(f64, f64)>) -> Limits {
    let keep = |v: Option<f64>| v.filter(|v| usable(axis.scale, *v));
    let (least, largest) = (keep(axis.limits.0), keep(axis.limits.1));
    let lo = least.or(data.map(|d| d.0));
    let hi = largest.or(data.map(|d| d.1));
    match (lo, hi) {
        (Some(lo), Some(hi)) if lo >= hi => (None, None),
        _ => (least, largest),
    }
}

/// Ends of an axis without data.
fn lonely(scale: Scale, limits: Limits) -> (f64, f64) {
    match (scale, limits) {
        (Scale::Linear, (Some(lo), _)) => (lo, lo + lo.abs().max(1.0)),
        (Scale::Linear, (_, Some(hi))) => (hi - hi.abs().max(1.0), hi),
        (Scale::Linear, _) => (0.0, 1.0),
        (Scale::Log, (Some(lo), _)) => (lo, 10.0 * lo),
        (Scale::Log, (_, Some(hi))) => (0.1 * hi, hi),
        (Scale::Log, _) => (0.1, 1.0),
    }
}

/// Whether a value has a place on an axis.
pub(super) fn usable(scale: Scale, value: f64) -> bool {
    let bounded = value.is_finite() && value.abs() <= LARGEST;
    bounded && (scale == Scale::Linear || value > 0.0)
}

/// Value divided by 10ⁿ.
fn shift(value: f64, exponent: i32) -> f64 {
    if value.abs() < SMALLEST {
        0.0
    } else if exponent < 0 {
        value * 10f64.powi(-exponent)
    } else {
        value / 10f64.powi(exponent)
    }
}

/// Ends with room for the curve; an end near zero goes to zero, a constant gets a tenth on either side.
fn widen(lo: f64, hi: f64) -> (f64, f64) {
    let largest = lo.abs().max(hi.abs());
    if largest <= 0.0 {
        return (-1.0, 1.0);
    }
    if hi - lo <= CONSTANT * largest {
        let (middle, half) = (0.5 * (lo + hi), 0.1 * largest);
        return (middle - half, middle + half);
    }
    let pad = 0.05 * (hi - lo);
    let low = if (0.0..=0.15 * hi).contains(&lo) { 0.0 } else { lo - pad };
    let high = if (0.15 * lo..=0.0).contains(&hi) { 0.0 } else { hi + pad };
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_is_shown_in_the_middle() {
        for axis in [Axis::linear("", "N"), Axis::log("", "N")] {
            let range = AxisRange::new(&axis, Some((5.0, 5.0)));
            // a few roundings
            assert!(range.place(5.0).is_some_and(|at| (at - 0.5).abs() < 1e-14));
        }
    }

    #[test]
    fn a_curve_from_zero_starts_at_the_frame() {
        let range = AxisRange::new(&Axis::linear("", "N"), Some((0.0, 5e-3)));
        assert_eq!(range.place(0.0), Some(0.0));
        assert_eq!(range.exponent, -3);
    }

    #[test]
    fn limits_are_kept_and_impossible_ones_ignored() {
        let range = AxisRange::new(&Axis::linear("", "1").from(-2.0).to(3.0), Some((0.0, 9.0)));
        assert_eq!((range.lo, range.hi), (-2.0, 3.0));
        let range = AxisRange::new(&Axis::linear("", "1").from(20.0), Some((0.0, 9.0)));
        assert!(range.lo < range.hi && range.holds(9.0));
        let close = Axis::linear("", "1").from(1.0).to(1.0 + 1e-12);
        let range = AxisRange::new(&close, Some((0.0, 9.0)));
        assert!(range.hi - range.lo > 0.1);
        let range = AxisRange::new(&Axis::log("", "1").from(-20.0), Some((1.0, 9.0)));
        assert!(range.holds(1.0));
    }

    #[test]
    fn zero_and_negative_have_no_place_on_a_logarithmic_axis() {
        let range = AxisRange::new(&Axis::log("", "1"), Some((1e-9, 9.0)));
        assert_eq!(range.place(0.0), None);
        assert_eq!(range.place(-1.0), None);
        assert_eq!(range.place(f64::NAN), None);
    }

    #[test]
    fn the_extremes_of_double_precision_have_a_place() {
        for (lo, hi) in [(-1e300, 1e300), (1e-300, 3e-300), (5e-324, 5e-324), (0.0, 0.0)] {
            let range = AxisRange::new(&Axis::linear("", "N"), Some((lo, hi)));
            assert!(range.holds(lo) && range.holds(hi), "{lo} {hi} {range:?}");
        }
    }
}
