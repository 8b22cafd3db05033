//! Sums and updates over pixels in fixed pieces: the same bits on any number of threads.

use ndarray::{Array2, ArrayView2};
use rayon::prelude::*;
use std::borrow::Cow;

/// Pixels per piece; part of the result's definition, since it fixes the order of the sums.
pub(super) const PIECE: usize = 1 << 13;

/// Rows of so many columns that are worth a task of their own.
pub(super) fn rows_of_piece(columns: usize) -> usize {
    PIECE.div_ceil(columns.max(1))
}

/// Values one by one, in pieces that are worth a task of their own.
pub(super) fn each<T: Sync>(values: &[T]) -> impl IndexedParallelIterator<Item = &T> {
    values.par_iter().with_min_len(PIECE)
}

/// The same to be changed.
pub(super) fn each_mut<T: Send>(values: &mut [T]) -> impl IndexedParallelIterator<Item = &mut T> {
    values.par_iter_mut().with_min_len(PIECE)
}

/// Rows of so many columns, as many together as are worth a task of their own.
pub(super) fn rows_mut<T: Send>(values: &mut [T], columns: usize) -> impl IndexedParallelIterator<Item = &mut [T]> {
    values.par_chunks_mut(columns).with_min_len(rows_of_piece(columns))
}

/// The index of the first value chosen. A piece is looked through without asking the others at each value.
pub(super) fn first<T: Copy + Sync>(values: &[T], chosen: impl Fn(T) -> bool + Sync) -> Option<usize> {
    let piece = values.par_chunks(PIECE).position_first(|piece| piece.iter().any(|&value| chosen(value)))?;
    let from = piece * PIECE;
    values[from..].iter().position(|&value| chosen(value)).map(|index| from + index)
}

/// All of them `by` times.
pub(super) fn scale(values: &mut [f64], by: f64) {
    each_mut(values).for_each(|value| *value *= by);
}

/// Σ of a quantity over the pieces `range` of 0..length, added in order.
pub(super) fn sum(length: usize, piece: impl Fn(std::ops::Range<usize>) -> f64 + Sync) -> f64 {
    fold(length, piece, 0.0, |total, part| total + part)
}

/// Pieces of 0..length mapped in parallel and folded in order.
pub(super) fn fold<T: Send>(
    length: usize,
    piece: impl Fn(std::ops::Range<usize>) -> T + Sync,
    start: T,
    join: impl Fn(T, T) -> T,
) -> T {
    let pieces: Vec<T> = (0..length.div_ceil(PIECE))
        .into_par_iter()
        .map(|index| piece(index * PIECE..((index + 1) * PIECE).min(length)))
        .collect();
    pieces.into_iter().fold(start, join)
}

/// Σ x·y.
pub(super) fn dot(x: &[f64], y: &[f64]) -> f64 {
    sum(x.len(), |range| x[range.clone()].iter().zip(&y[range]).map(|(a, b)| a * b).sum())
}

/// Σ x.
pub(super) fn total(x: &[f64]) -> f64 {
    sum(x.len(), |range| x[range].iter().sum())
}

/// Pieces of the target changed in parallel, and the sum of what each change gives, added in order.
pub(super) fn swept<T: Send>(target: &mut [T], change: impl Fn(std::ops::Range<usize>, &mut [T]) -> f64 + Sync) -> f64 {
    let each = target.par_chunks_mut(PIECE).enumerate();
    let given: Vec<f64> = each.map(|(index, part)| change(index * PIECE..index * PIECE + part.len(), part)).collect();
    given.into_iter().sum()
}

/// Values row after row: as they lie in memory, where they do so.
pub(super) fn row_after_row<'v>(values: &'v ArrayView2<'_, f64>) -> Cow<'v, [f64]> {
    values.as_slice().map_or_else(|| values.iter().copied().collect(), Cow::Borrowed)
}

/// Values pixel by pixel, row after row, as an array of rows and columns.
pub(super) fn on_pixels(values: Vec<f64>, pixels: (usize, usize)) -> Array2<f64> {
    // There are as many values as pixels, the only thing it can object to.
    Array2::from_shape_vec(pixels, values).unwrap_or_else(|_| Array2::zeros(pixels))
}

/// Makes it at least so long. What it held is lost; all threads write what it holds then, so that none waits for memory
/// to be handed out page by page.
pub(super) fn lengthen<T: Copy + Default + Send + Sync>(values: &mut Vec<T>, length: usize) {
    if values.len() < length {
        values.clear();
        values.par_extend(rayon::iter::repeat_n(T::default(), length));
    }
}

/// `change(target, source)` for each pair.
pub(super) fn update<T: Send, S: Copy + Sync>(target: &mut [T], source: &[S], change: impl Fn(&mut T, S) + Sync) {
    target
        .par_chunks_mut(PIECE)
        .zip(source.par_chunks(PIECE))
        .for_each(|(target, source)| target.iter_mut().zip(source).for_each(|(place, &value)| change(place, value)));
}
