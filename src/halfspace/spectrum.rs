//! Spectra of influences, even or odd along rows and columns.

use rayon::prelude::*;
use realfft::RealFftPlanner;
use realfft::num_complex::Complex;
use rustfft::FftPlanner;

use super::transform::Size;

/// Rows that are transposed together.
const STRIP: usize = 8;

/// Two-dimensional transform of a table even from row to row, given by the upper half of its rows, `row × column` with
/// all columns of the period; half of the spectrum either way, `column × row`.
pub(super) fn spectrum_of_even_columns(table: &[f64], period: Size) -> Vec<Complex<f64>> {
    let (half, quarter) = (period.columns / 2 + 1, period.rows / 2 + 1);
    let plan = RealFftPlanner::<f64>::new().plan_fft_forward(period.columns);
    let mut rows = vec![Complex::default(); quarter * half];
    let make = || (plan.make_input_vec(), plan.make_scratch_vec());
    rows.par_chunks_mut(half).zip(table.par_chunks(period.columns)).for_each_init(
        make,
        |(input, scratch), (spectrum, row)| {
            input.copy_from_slice(row);
            // The lengths are those of the plan, the only thing it can object to.
            let _ = plan.process_with_scratch(input, spectrum, scratch);
        },
    );
    let down = FftPlanner::new().plan_fft_forward(period.rows);
    let mut turned = vec![Complex::default(); half * quarter];
    turned.par_chunks_mut(quarter).enumerate().for_each_init(
        || vec![Complex::default(); period.rows],
        |line, (column, spectrum)| {
            for (row, place) in line.iter_mut().enumerate() {
                *place = rows[row.min(period.rows - row) * half + column];
            }
            down.process(line);
            spectrum.copy_from_slice(&line[..quarter]);
        },
    );
    turned
}

/// How a table goes on before its first value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Parity {
    Even,
    Odd,
}

/// Two-dimensional transform of a table that is even or odd along `[rows' number, columns' number]`, given by its
/// quarter `row × column`; the quarter of the spectrum, `column × row`, without a factor i for each odd direction.
pub(super) fn spectrum_of_quarter(table: Vec<f64>, period: Size, [down, across]: [Parity; 2]) -> Vec<f64> {
    let half = Size { rows: period.rows / 2 + 1, columns: period.columns / 2 + 1 };
    let mut table = table;
    transform_rows_of(&mut table, period.columns, across);
    let mut turned = transpose(&table, half);
    drop(table);
    transform_rows_of(&mut turned, period.rows, down);
    turned
}

/// Two-dimensional cosine transform of an even table given by its quarter `row × column`;
/// the quarter of the (real, even) spectrum, `column × row`.
pub(super) fn spectrum_of_even(table: Vec<f64>, period: Size) -> Vec<f64> {
    spectrum_of_quarter(table, period, [Parity::Even; 2])
}

/// Each row, half of an even or odd sequence, to half of its spectrum, which is real or i times what is stored.
fn transform_rows_of(table: &mut [f64], period: usize, parity: Parity) {
    let plan = RealFftPlanner::<f64>::new().plan_fft_forward(period);
    let half = period / 2 + 1;
    let make = || (plan.make_input_vec(), plan.make_output_vec(), plan.make_scratch_vec());
    table.par_chunks_mut(half).for_each_init(make, |(input, output, scratch), row| {
        if parity == Parity::Odd {
            row[0] = 0.0;
            row[half - 1] *= if period.is_multiple_of(2) { 0.0 } else { 1.0 };
        }
        input[..half].copy_from_slice(row);
        for (place, value) in input[half..].iter_mut().rev().zip(&row[1..]) {
            *place = if parity == Parity::Odd { -*value } else { *value };
        }
        // The lengths are those of the plan, the only thing it can object to.
        let _ = plan.process_with_scratch(input, output, scratch);
        let part = |value: &Complex<f64>| if parity == Parity::Odd { value.im } else { value.re };
        row.iter_mut().zip(output.iter()).for_each(|(place, value)| *place = part(value));
    });
}

fn transpose(table: &[f64], size: Size) -> Vec<f64> {
    let mut turned = vec![0.0; table.len()];
    turned.par_chunks_mut(size.rows * STRIP).enumerate().for_each(|(index, block)| {
        let first = index * STRIP;
        for (row, values) in table.chunks(size.columns).enumerate() {
            for (lane, place) in block[row..].iter_mut().step_by(size.rows).enumerate() {
                *place = values[first + lane];
            }
        }
    });
    turned
}
