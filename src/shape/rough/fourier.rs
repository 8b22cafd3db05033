//! Discrete Fourier transform of any length with the same rounding on every machine.
//!
//! Fast libraries pick their instructions at run time, so their last bits depend on the processor;
//! a rough surface must be the same bytes everywhere. Lengths of a power of two take the
//! radix-2 transform, all others Bluestein's chirp; sines come from `libm`.

use crate::numerics::complex::Complex;
use rayon::prelude::*;
use std::f64::consts::PI;

/// e^{iπ·numerator/denominator}, the argument reduced exactly.
#[expect(clippy::cast_precision_loss, reason = "lengths of a transform are far below 2^53")]
fn unit_root(numerator: usize, denominator: usize) -> Complex {
    Complex::polar(1.0, PI * (numerator % (2 * denominator)) as f64 / denominator as f64)
}

/// A transform of one length: X_k = Σ_j x_j e^{+2πi jk/n}, without a factor 1/n.
#[derive(Debug, Clone)]
pub(super) struct Transform {
    length: usize,
    /// e^{2πi j/size} for j < size/2 of the power-of-two transform.
    roots: Vec<Complex>,
    /// Chirp e^{iπ j²/n} and the transform of its conjugate; absent for powers of two.
    chirp: Option<(Vec<Complex>, Vec<Complex>)>,
}

impl Transform {
    /// The transform of `length` points, `length` above zero.
    pub(super) fn new(length: usize) -> Self {
        if length.is_power_of_two() {
            return Self { length, roots: roots(length), chirp: None };
        }
        let size = (2 * length - 1).next_power_of_two();
        let chirp: Vec<_> = (0..length).map(|j| unit_root(square_modulo(j, 2 * length), length)).collect();
        let mut kernel = vec![Complex::default(); size];
        for (j, c) in chirp.iter().enumerate() {
            kernel[j] = c.conjugate();
            kernel[(size - j) % size] = c.conjugate();
        }
        let roots = roots(size);
        radix_two(&mut kernel, &roots);
        Self { length, roots, chirp: Some((chirp, kernel)) }
    }

    /// Transforms `data` in place; `data` has the length of the transform.
    pub(super) fn run(&self, data: &mut [Complex]) {
        debug_assert_eq!(data.len(), self.length);
        match &self.chirp {
            None => radix_two(data, &self.roots),
            Some((chirp, kernel)) => bluestein(data, (chirp, kernel), &self.roots),
        }
    }

    /// Transforms every line of a matrix in place, in parallel.
    pub(super) fn run_lines(&self, data: &mut [Complex]) {
        data.par_chunks_mut(self.length).for_each(|line| self.run(line));
    }
}

/// The rows of a matrix of `columns` columns as columns, rows stored one after another.
pub(super) fn transposed(data: &[Complex], columns: usize) -> Vec<Complex> {
    let rows = data.len() / columns;
    let mut turned = vec![Complex::default(); data.len()];
    turned.par_chunks_mut(rows).enumerate().for_each(|(j, line)| {
        for (i, value) in line.iter_mut().enumerate() {
            *value = data[i * columns + j];
        }
    });
    turned
}

/// j² modulo `modulus` without overflow.
fn square_modulo(j: usize, modulus: usize) -> usize {
    ((j as u128 * j as u128) % modulus as u128) as usize
}

fn roots(size: usize) -> Vec<Complex> {
    (0..size / 2).map(|j| unit_root(2 * j, size)).collect()
}

/// In-place radix-2 transform by decimation in time.
fn radix_two(data: &mut [Complex], roots: &[Complex]) {
    let size = data.len();
    if size < 2 {
        return;
    }
    let shift = usize::BITS - size.trailing_zeros();
    for j in 0..size {
        let k = j.reverse_bits() >> shift;
        if j < k {
            data.swap(j, k);
        }
    }
    let mut half = 1;
    while half < size {
        let stride = size / (2 * half);
        for block in data.chunks_exact_mut(2 * half) {
            let (low, high) = block.split_at_mut(half);
            for (j, (a, b)) in low.iter_mut().zip(high).enumerate() {
                let turned = roots[j * stride] * *b;
                (*a, *b) = (*a + turned, *a - turned);
            }
        }
        half *= 2;
    }
}

/// Any length as a convolution with a chirp (Bluestein 1970): jk = (j² + k² − (k−j)²)/2.
fn bluestein(data: &mut [Complex], (chirp, kernel): (&[Complex], &[Complex]), roots: &[Complex]) {
    let mut work = vec![Complex::default(); kernel.len()];
    for ((w, &x), &c) in work.iter_mut().zip(&*data).zip(chirp) {
        *w = x * c;
    }
    radix_two(&mut work, roots);
    for (w, &k) in work.iter_mut().zip(kernel) {
        *w = (*w * k).conjugate();
    }
    radix_two(&mut work, roots);
    #[expect(clippy::cast_precision_loss, reason = "lengths of a transform are far below 2^53")]
    let scale = 1.0 / kernel.len() as f64;
    for ((x, &w), &c) in data.iter_mut().zip(&work).zip(chirp) {
        *x = w.conjugate() * scale * c;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::rough::Random;

    /// Against the defining sum; rounding grows as log n, so 1e-13 leaves two digits for n ≤ 100.
    #[test]
    fn every_length_is_its_defining_sum() {
        for length in (1..40).chain([64, 97, 100]) {
            let mut random = Random::seeded(length as u64);
            let data: Vec<Complex> = (0..length).map(|_| Complex { re: random.unit(), im: random.unit() }).collect();
            let mut fast = data.clone();
            Transform::new(length).run(&mut fast);
            for (k, f) in fast.iter().enumerate() {
                let mut sum = Complex::default();
                for (j, &x) in data.iter().enumerate() {
                    sum = sum + x * unit_root(2 * (j * k % length), length);
                }
                let error = (*f - sum).square().sqrt();
                assert!(error < 1e-13 * length as f64, "n = {length}, k = {k}: {error:e}");
            }
        }
    }
}
