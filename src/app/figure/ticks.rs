//! Ticks at round numbers, as many as fit.

use super::range::AxisRange;
use super::{Scale, text};

/// A mark on an axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    /// Fraction of the axis.
    pub(super) at: f64,
    /// Number beside it; empty on a minor tick.
    pub(super) label: String,
}

/// Which way the labels stand in each other's way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Along {
    X,
    Y,
}

/// Font size of tick labels in px.
pub(super) const SIZE: f64 = 11.0;

/// The densest ticks whose labels keep apart on an axis of `length` px.
pub(super) fn ticks(range: &AxisRange, along: Along, length: f64) -> Vec<Tick> {
    let most = (length / if along == Along::X { 52.0 } else { 34.0 }).max(2.0);
    let choices = match range.scale {
        Scale::Linear => linear_choices(range, most),
        Scale::Log => log_choices(range, most),
    };
    let best = choices.iter().find(|ticks| fits(ticks, along, length));
    best.or(choices.last()).cloned().unwrap_or_default()
}

fn fits(ticks: &[Tick], along: Along, length: f64) -> bool {
    let half = |t: &Tick| match along {
        Along::X => 0.5 * text::width(&t.label, SIZE) + 4.0,
        Along::Y => 0.75 * SIZE,
    };
    let labelled: Vec<&Tick> = ticks.iter().filter(|t| !t.label.is_empty()).collect();
    labelled.windows(2).all(|pair| (pair[1].at - pair[0].at) * length >= half(pair[0]) + half(pair[1]))
}

fn linear_choices(range: &AxisRange, most: f64) -> Vec<Vec<Tick>> {
    // Two numbers make a scale: denser than usual where there would be one.
    let denser = [1.0, 1.5, 2.0, 3.0].into_iter().find(|share| linear(range, (most * share).max(2.0)).len() > 1);
    let shares = [denser.unwrap_or(1.0), 0.8, 0.6, 0.45, 0.3, 0.2];
    shares.iter().map(|share| linear(range, (most * share).max(2.0))).collect()
}

fn linear(range: &AxisRange, most: f64) -> Vec<Tick> {
    let (step, places) = nice_step((range.hi - range.lo) / most);
    let label = |k: f64| text::decimal(k * step, places);
    multiples(range.lo / step, range.hi / step)
        .map(|k| Tick { at: range.fraction(k * step), label: label(k) })
        .collect()
}

/// Smallest of 1, 2, 5 times a power of ten not below `raw`, and the decimal places it needs.
fn nice_step(raw: f64) -> (f64, usize) {
    let decade = raw.log10().floor();
    let base = 10f64.powf(decade);
    let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|m| m * base >= raw * (1.0 - 1e-9)).unwrap_or(10.0);
    let carry = if factor > 5.0 { 1.0 } else { 0.0 };
    (factor * base, places(-decade - carry))
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded by clamp")]
fn places(count: f64) -> usize {
    count.clamp(0.0, 12.0) as usize
}

/// Whole numbers between two ends, with room for rounding.
fn multiples(lo: f64, hi: f64) -> impl Iterator<Item = f64> {
    let (first, last) = ((lo - 1e-7).ceil(), (hi + 1e-7).floor());
    (0..100).map(move |i| first + f64::from(i)).take_while(move |k| *k <= last)
}

fn log_choices(range: &AxisRange, most: f64) -> Vec<Vec<Tick>> {
    let span = range.hi - range.lo;
    if span < 0.45 {
        return linear_on_log(range, most);
    }
    let mut choices = Vec::new();
    if range.is_plain() {
        let all = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0];
        choices.push(subdivided(range, if span < 0.9 { &all } else { &[1.0, 2.0, 5.0] }));
        choices.push(subdivided(range, &[1.0, 2.0, 5.0]));
        choices.push(subdivided(range, &[1.0, 3.0]));
    }
    choices.extend(every(range, most));
    choices
}

/// Ticks at equal steps of the value on a short logarithmic axis.
fn linear_on_log(range: &AxisRange, most: f64) -> Vec<Vec<Tick>> {
    let at = |t: f64| 10f64.powf(t - f64::from(range.exponent));
    let values = AxisRange { scale: Scale::Linear, lo: at(range.lo), hi: at(range.hi), ..*range };
    let mut choices = linear_choices(&values, most);
    for tick in choices.iter_mut().flatten() {
        let value = values.lo + tick.at * (values.hi - values.lo);
        tick.at = range.fraction(value.log10() + f64::from(range.exponent));
    }
    choices
}

/// Every decade divided; the numbers in `labelled` carry labels.
fn subdivided(range: &AxisRange, labelled: &[f64]) -> Vec<Tick> {
    let label = |decade: f64, m: f64| {
        let decade = decade - f64::from(range.exponent);
        let wanted = labelled.iter().any(|l| (l - m).abs() < 0.5);
        let text = || text::decimal(m * 10f64.powf(decade), places(-decade));
        if wanted { text() } else { String::new() }
    };
    within_decades(range, label)
}

fn within_decades(range: &AxisRange, label: impl Fn(f64, f64) -> String) -> Vec<Tick> {
    let digits = (1..10).map(f64::from);
    multiples(range.lo.floor(), range.hi.ceil())
        .flat_map(|decade| digits.clone().map(move |m| (decade, m)))
        .map(|(decade, m)| (range.fraction(decade + m.log10()), decade, m))
        .filter(|(at, ..)| (-1e-9..=1.0 + 1e-9).contains(at))
        .map(|(at, decade, m)| Tick { at, label: label(decade, m) })
        .collect()
}

/// Choices with a label at every first, second, third, fifth … decade.
fn every(range: &AxisRange, most: f64) -> Vec<Vec<Tick>> {
    let least = 0.5 * (range.hi - range.lo) / most;
    [1, 2, 3, 4, 5, 6, 10, 20, 50, 100, 200]
        .into_iter()
        .filter(|step| f64::from(*step) >= least)
        .map(|step| decades(range, step, most))
        .collect()
}

fn decades(range: &AxisRange, step: i32, most: f64) -> Vec<Tick> {
    let name = |decade: f64| {
        let n = whole(decade);
        if n.rem_euclid(step) != 0 {
            String::new()
        } else if range.is_plain() {
            let n = n - range.exponent;
            text::decimal(10f64.powi(n), places(f64::from(-n)))
        } else {
            text::power(n)
        }
    };
    if step == 1 && range.hi - range.lo <= 0.9 * most {
        return within_decades(range, |decade, m| if m < 1.5 { name(decade) } else { String::new() });
    }
    (whole(range.lo.floor())..=whole(range.hi.ceil()))
        .map(f64::from)
        .map(|decade| Tick { at: range.fraction(decade), label: name(decade) })
        .filter(|tick| (-1e-9..=1.0 + 1e-9).contains(&tick.at))
        .filter(|tick| step <= 10 || !tick.label.is_empty())
        .collect()
}

#[expect(clippy::cast_possible_truncation, reason = "decades of a double lie within ±324")]
fn whole(decade: f64) -> i32 {
    decade.round() as i32
}

#[cfg(test)]
mod tests {
    use super::super::Axis;
    use super::*;

    fn labels(axis: &Axis, data: (f64, f64), length: f64) -> Vec<String> {
        let range = AxisRange::new(axis, Some(data));
        let ticks = ticks(&range, Along::X, length);
        let all = ticks.into_iter().map(|t| t.label);
        all.filter(|l| !l.is_empty()).collect()
    }

    #[test]
    fn linear_ticks_are_round() {
        let axis = Axis::linear("", "N");
        assert_eq!(labels(&axis, (0.0, 4.7e-3), 300.0), ["0", "1", "2", "3", "4"]);
        assert_eq!(labels(&axis, (-0.4, 0.4), 300.0), ["−400", "−200", "0", "200", "400"]);
        assert_eq!(labels(&axis, (1.0, 1.1), 220.0), ["1.00", "1.05", "1.10"]);
    }

    #[test]
    fn decades_are_powers_of_ten() {
        let axis = Axis::log("", "s");
        assert_eq!(labels(&axis, (1e-6, 1e-3), 300.0), ["10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³"]);
        let many = labels(&axis, (1e-9, 1e9), 300.0);
        assert!(many.contains(&"10⁰".to_owned()) && many.len() >= 5, "{many:?}");
    }

    #[test]
    fn inside_one_decade_there_are_still_labels() {
        let axis = Axis::log("", "m");
        assert_eq!(labels(&axis, (1.0e-6, 6.0e-6), 300.0), ["1", "2", "3", "4", "5", "6"]);
        assert!(labels(&axis, (1.0e-6, 1.1e-6), 300.0).len() >= 3);
        assert!(labels(&axis, (1.2e-5, 1.9e-5), 300.0).len() >= 2);
        assert_eq!(labels(&axis, (1e-5, 1e-4), 300.0), ["10", "20", "50", "100"]);
    }

    #[test]
    fn labels_keep_apart_over_all_ranges() {
        for k in -300..300 {
            let lo = 10f64.powi(k);
            for axis in [Axis::linear("", "N"), Axis::log("", "N")] {
                for factor in [1.0, 1.001, 1.3, 7.0, 1e2, 1e4] {
                    let range = AxisRange::new(&axis, Some((lo, lo * factor)));
                    let ticks = ticks(&range, Along::X, 200.0);
                    let named = ticks.iter().filter(|t| !t.label.is_empty()).count();
                    assert!(fits(&ticks, Along::X, 200.0) && named >= 1, "{range:?} {ticks:?}");
                }
            }
        }
    }
}
