//! Products with a multiplier in Fourier space, on real grids: real and even, or of an influence that is even
//! across the rows alone.
//!
//! Rows that are zero are not transformed, the zero half of a padded grid is neither stored nor
//! transformed along the rows, and the multiplier is kept as the quarter that is not its own mirror.
//! Every number is written by one task from the same inputs, so the result does not depend on threads.

use std::ops::Range;
use std::sync::Arc;

use rayon::prelude::*;
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftPlanner};

use super::precision::{Precision, Scratch, Spectra, Symbol};
use super::vector::{lengthen, rows_of_piece};

/// Rows, or columns, that travel together through the transposition.
const STRIP: usize = 8;

/// Rows and columns of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Size {
    pub(super) rows: usize,
    pub(super) columns: usize,
}

impl Size {
    pub(super) fn pixels(self) -> usize {
        self.rows * self.columns
    }

    /// Complex numbers that a transform of data of this size with this period keeps at a time.
    pub(super) fn spectrum(self, period: Size) -> usize {
        let strip = STRIP.min(self.rows);
        let columns = (period.columns / 2 + 1).div_ceil(STRIP) * STRIP;
        self.rows.div_ceil(strip) * strip * columns
    }
}

/// The map x → F⁻¹[symbol · F x] from a grid to itself, zero-padded up to the period.
pub(super) struct Multiplier<S: Symbol = f64> {
    lines: Lines<S::Real>,
    symbol: Vec<S>,
}

/// Transforms of the rows and columns of a grid, zero-padded up to the period.
pub(super) struct Lines<T = f64> {
    size: Size,
    period: Size,
    forward_row: Arc<dyn RealToComplex<T>>,
    inverse_row: Arc<dyn ComplexToReal<T>>,
    forward_column: Arc<dyn Fft<T>>,
    inverse_column: Arc<dyn Fft<T>>,
}

impl<S: Symbol> Multiplier<S> {
    /// Multiplier from its symbol, `half column × half row` frequencies of the period, column first.
    pub(super) fn new(size: Size, period: Size, mut symbol: Vec<S>) -> Self {
        let scale = (period.pixels() as f64).recip();
        symbol.par_iter_mut().for_each(|value| *value = value.scaled(scale));
        Self { lines: Lines::new(size, period), symbol }
    }

    /// y = F⁻¹[symbol · F x].
    pub(super) fn apply(&self, x: &[S::Real], y: &mut [S::Real], scratch: &mut Scratch) {
        let Lines { size, period, .. } = self.lines;
        let needed = size.spectrum(period);
        let Spectra { rows, columns } = S::Real::spectra(scratch);
        lengthen(rows, needed);
        lengthen(columns, needed);
        self.lines.transform_rows(x, rows);
        let quarter = period.rows / 2 + 1;
        self.lines.across([rows.as_slice()], (columns.as_mut_slice(), 1), |column, [line]| {
            multiply(line, &self.symbol[column * quarter..(column + 1) * quarter]);
        });
        self.lines.restore_rows(columns, (0, 1), y);
    }
}

impl Multiplier<f32> {
    /// The same multiplier in numbers of seven digits, for what is corrected afterwards.
    pub(super) fn rough(size: Size, period: Size, symbol: &[f64]) -> Self {
        Self::new(size, period, symbol.par_iter().map(|&value| f32::nearest(value)).collect())
    }
}

impl<T: Precision> Lines<T> {
    pub(super) fn new(size: Size, period: Size) -> Self {
        let mut real = RealFftPlanner::new();
        let mut complex = FftPlanner::new();
        Self {
            size,
            period,
            forward_row: real.plan_fft_forward(period.columns),
            inverse_row: real.plan_fft_inverse(period.columns),
            forward_column: complex.plan_fft_forward(period.rows),
            inverse_column: complex.plan_fft_inverse(period.rows),
        }
    }

    fn half(&self) -> usize {
        self.period.columns / 2 + 1
    }

    fn strip(&self) -> usize {
        STRIP.min(self.size.rows)
    }

    /// Rows to half spectra, stored as strips of rows: frequency by frequency, the rows of the strip side by side.
    pub(super) fn transform_rows(&self, x: &[T], spectra: &mut [Complex<T>]) {
        let (columns, strip, half) = (self.size.columns, self.strip(), self.half());
        let make = || {
            let output = vec![Complex::default(); strip * half];
            (self.forward_row.make_input_vec(), output, self.forward_row.make_scratch_vec())
        };
        let strips = spectra.par_chunks_mut(strip * half).with_min_len(rows_of_piece(strip * half));
        strips.zip(x.par_chunks(strip * columns)).for_each_init(make, |(input, output, scratch), (block, rows)| {
            for (row, output) in rows.chunks(columns).zip(output.chunks_mut(half)) {
                if row.iter().all(T::is_zero) {
                    output.fill(Complex::default());
                } else {
                    input[..columns].copy_from_slice(row);
                    input[columns..].fill(T::default());
                    // The lengths are those of the plan, the only thing it can object to.
                    let _ = self.forward_row.process_with_scratch(input, output, scratch);
                }
            }
            interleave(&output[..rows.len() / columns * half], half, (block, strip));
        });
    }

    /// Down the columns, through `change` of what `I` spectra have at each frequency of a row, and up again with the first
    /// `kept` of them, stored as strips of columns, the results of a strip one after the other.
    pub(super) fn across<const I: usize>(
        &self,
        spectra: [&[Complex<T>]; I],
        (columns, kept): (&mut [Complex<T>], usize),
        change: impl Fn(usize, [&mut [Complex<T>]; I]) + Sync,
    ) {
        let (rows, period) = (self.size.rows, self.period.rows);
        let length = self.forward_column.get_inplace_scratch_len().max(self.inverse_column.get_inplace_scratch_len());
        let make = || {
            let lines: [Vec<Complex<T>>; I] = std::array::from_fn(|_| vec![Complex::default(); STRIP * period]);
            (lines, vec![Complex::default(); kept * STRIP * rows], vec![Complex::default(); length])
        };
        let strips = columns.par_chunks_mut(kept * STRIP * rows).with_min_len(rows_of_piece(STRIP * period));
        strips.take(self.half().div_ceil(STRIP)).enumerate().for_each_init(
            make,
            |(lines, results, scratch), (index, block)| {
                let columns = index * STRIP..self.half().min((index + 1) * STRIP);
                let lanes = columns.len();
                for (lines, spectra) in lines.iter_mut().zip(spectra) {
                    self.gather_columns(spectra, columns.clone(), lines);
                }
                for (lane, column) in columns.enumerate() {
                    let mut lines = lines.each_mut().map(|lines| &mut lines[lane * period..(lane + 1) * period]);
                    for line in &mut lines {
                        line[rows..].fill(Complex::default());
                        self.forward_column.process_with_scratch(line, scratch);
                    }
                    change(column, lines.each_mut().map(|line| &mut **line));
                    for (line, part) in lines.iter_mut().zip(results.chunks_mut(STRIP * rows)) {
                        self.inverse_column.process_with_scratch(line, scratch);
                        part[lane * rows..(lane + 1) * rows].copy_from_slice(&line[..rows]);
                    }
                }
                for (result, part) in results.chunks(STRIP * rows).zip(block.chunks_mut(STRIP * rows)) {
                    interleave(&result[..lanes * rows], rows, (part, STRIP));
                }
            },
        );
    }

    /// Columns that lie side by side, each to a line of the period: what a strip of rows has of them is one stretch of memory.
    fn gather_columns(&self, spectra: &[Complex<T>], columns: Range<usize>, lines: &mut [Complex<T>]) {
        let (strip, period) = (self.strip(), self.period.rows);
        for (first, block) in (0..self.size.rows).step_by(strip).zip(spectra.chunks(strip * self.half())) {
            let rows = first..self.size.rows.min(first + strip);
            let stretch = &block[columns.start * strip..columns.end * strip];
            for (line, values) in lines.chunks_mut(period).zip(stretch.chunks(strip)) {
                copy_strip(&mut line[rows.clone()], values);
            }
        }
    }

    /// The half spectra of one result of several back to rows.
    pub(super) fn restore_rows(&self, columns: &[Complex<T>], (result, several): (usize, usize), y: &mut [T]) {
        let (size, half) = (self.size, self.half());
        let make = || {
            let inputs = vec![Complex::default(); STRIP * half];
            (inputs, self.inverse_row.make_output_vec(), self.inverse_row.make_scratch_vec())
        };
        let strips = y.par_chunks_mut(STRIP * size.columns).with_min_len(rows_of_piece(STRIP * half));
        strips.enumerate().for_each_init(make, |(inputs, output, scratch), (index, targets)| {
            let blocks = columns.chunks(STRIP * size.rows).skip(result).step_by(several);
            for (first, block) in (0..half).step_by(STRIP).zip(blocks) {
                let stretch = &block[index * STRIP * STRIP..];
                for (input, values) in inputs.chunks_mut(half).zip(stretch.chunks(STRIP)) {
                    copy_strip(&mut input[first..half.min(first + STRIP)], values);
                }
            }
            for (input, target) in inputs.chunks_mut(half).zip(targets.chunks_mut(size.columns)) {
                input[0].im = T::default();
                if self.period.columns.is_multiple_of(2) {
                    input[half - 1].im = T::default();
                }
                // The lengths are those of the plan and the imaginary parts it would object to are zero.
                let _ = self.inverse_row.process_with_scratch(input, output, scratch);
                target.copy_from_slice(&output[..size.columns]);
            }
        });
    }
}

/// Lines of `length` side by side: of every place, what all have there, `stride` apart from place to place.
fn interleave<T: Copy>(lines: &[T], length: usize, (block, stride): (&mut [T], usize)) {
    if lines.len() == STRIP * length && stride == STRIP {
        let lines: [&[T]; STRIP] = std::array::from_fn(|lane| &lines[lane * length..(lane + 1) * length]);
        for (place, values) in block.as_chunks_mut::<STRIP>().0.iter_mut().enumerate() {
            for (value, line) in values.iter_mut().zip(&lines) {
                *value = line[place];
            }
        }
    } else {
        for (lane, line) in lines.chunks(length).enumerate() {
            block[lane..].iter_mut().step_by(stride).zip(line).for_each(|(place, value)| *place = *value);
        }
    }
}

/// The first of the values: nearly always a whole strip, whose length the compiler then knows.
fn copy_strip<T: Copy>(to: &mut [T], from: &[T]) {
    if let (Ok(to), Some(from)) = (<&mut [T; STRIP]>::try_from(&mut *to), from.first_chunk::<STRIP>()) {
        *to = *from;
    } else {
        to.copy_from_slice(&from[..to.len()]);
    }
}

/// Line times an even multiplier given by its first half.
fn multiply<S: Symbol>(line: &mut [Complex<S::Real>], half: &[S]) {
    let (front, back) = line.split_at_mut(half.len());
    front.iter_mut().zip(half).for_each(|(value, factor)| *value = factor.on(*value));
    back.iter_mut().rev().zip(&half[1..]).for_each(|(value, factor)| *value = factor.on(*value));
}

/// Smallest even length of small prime factors that is at least this long.
pub(super) fn good_length(least: usize) -> usize {
    (least.max(2)..).find(|&length| length % 2 == 0 && is_smooth(length)).unwrap_or(least)
}

fn is_smooth(length: usize) -> bool {
    [2, 3, 5].into_iter().fold(length, |rest, prime| {
        std::iter::successors(Some(rest), |&rest| (rest % prime == 0).then_some(rest / prime)).last().unwrap_or(rest)
    }) == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::halfspace::spectrum::{spectrum_of_even, spectrum_of_even_columns};

    /// Zero-padded product against the sum it stands for, sizes odd, even, one row, one column.
    #[test]
    fn convolution_is_the_sum() {
        for (rows, columns) in [(1, 1), (1, 7), (6, 1), (5, 9), (12, 17), (20, 3)] {
            let size = Size { rows, columns };
            let period =
                Size { rows: if rows == 1 { 1 } else { 2 * good_length(rows) }, columns: 2 * good_length(columns) };
            let kernel = |row: usize, column: usize| 1.0 / (1.0 + (row * row + 2 * column * column) as f64).sqrt();
            let half = period.columns / 2 + 1;
            let table = (0..(period.rows / 2 + 1) * half).map(|k| kernel(k / half, k % half)).collect();
            let x: Vec<f64> = (0..size.pixels()).map(|k| ((k * 7919) % 23) as f64 - 5.0).collect();
            let mut y = vec![0.0; size.pixels()];
            Multiplier::new(size, period, spectrum_of_even(table, period)).apply(&x, &mut y, &mut Scratch::default());
            for (index, value) in y.iter().enumerate() {
                let (row, column) = (index / columns, index % columns);
                let term =
                    |(k, x): (usize, &f64)| x * kernel((k / columns).abs_diff(row), (k % columns).abs_diff(column));
                let exact: f64 = x.iter().enumerate().map(term).sum();
                // Rounding of a transform: some units of the last place of the largest sum, here below 3000.
                assert!((value - exact).abs() < 3e-12, "{rows}×{columns} at {row} {column}: {value} {exact}");
            }
        }
    }

    /// The same with an influence that is not even along the rows.
    #[test]
    fn convolution_is_the_sum_where_it_is_not_even() {
        let (size, period) = (Size { rows: 5, columns: 9 }, Size { rows: 12, columns: 20 });
        let kernel =
            |down: usize, across: i64| 1.0 / (1.0 + (down * down) as f64 + (across as f64 - 0.7).powi(2)).sqrt();
        let along = |column: usize| if 2 * column <= period.columns { column as i64 } else { column as i64 - 20 };
        let table: Vec<f64> = (0..7 * 20).map(|k| kernel(k / 20, along(k % 20))).collect();
        let x: Vec<f64> = (0..size.pixels()).map(|k| ((k * 7919) % 23) as f64 - 5.0).collect();
        let mut y = vec![0.0; size.pixels()];
        let symbol = spectrum_of_even_columns(&table, period);
        Multiplier::new(size, period, symbol).apply(&x, &mut y, &mut Scratch::default());
        for (index, value) in y.iter().enumerate() {
            let (row, column) = (index / 9, (index % 9) as i64);
            let term = |(k, x): (usize, &f64)| x * kernel((k / 9).abs_diff(row), column - (k % 9) as i64);
            let exact: f64 = x.iter().enumerate().map(term).sum();
            // Rounding of a transform of sums below 300.
            assert!((value - exact).abs() < 1e-12, "{row} {column}: {value} {exact}");
        }
    }

    /// In seven digits a multiplier of both signs is the same one: rounding of 120 products, each below 11 · 17.
    #[test]
    fn a_rough_multiplier_keeps_its_signs() {
        let size = Size { rows: 12, columns: 10 };
        let symbol: Vec<f64> = (0..7 * 6).map(|k| f64::from((k * 7919) % 23) - 11.0).collect();
        let x: Vec<f64> = (0..120).map(|k| f64::from((k * 7907) % 35) - 17.0).collect();
        let single: Vec<f32> = x.iter().map(|&value| f32::nearest(value)).collect();
        let (mut exact, mut rough) = (vec![0.0; 120], vec![0.0; 120]);
        Multiplier::rough(size, size, &symbol).apply(&single, &mut rough, &mut Scratch::default());
        Multiplier::new(size, size, symbol).apply(&x, &mut exact, &mut Scratch::default());
        for (rough, exact) in rough.iter().zip(&exact) {
            assert!(
                (f64::from(*rough) - exact).abs() < 120.0_f64.sqrt() * 11.0 * 17.0 * f64::from(f32::EPSILON),
                "{rough} {exact}"
            );
        }
    }

    #[test]
    fn good_lengths_are_even_smooth_and_close() {
        for least in 1..5000 {
            let length = good_length(least);
            assert!(
                length >= least
                    && length.is_multiple_of(2)
                    && is_smooth(length)
                    && length <= 2 * least.next_power_of_two()
            );
        }
    }
}
