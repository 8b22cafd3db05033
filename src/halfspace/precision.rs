//! Numbers that waves are computed in, and what waves are multiplied by.

use realfft::num_complex::Complex;
use rustfft::FftNum;

/// Scratch space shared by the transforms of one solution.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    double: Spectra<f64>,
    single: Spectra<f32>,
}

/// Spectra of the rows and of the columns.
#[derive(Debug, Default)]
pub(super) struct Spectra<T> {
    pub(super) rows: Vec<Complex<T>>,
    pub(super) columns: Vec<Complex<T>>,
}

/// Numbers that waves are computed in.
pub(super) trait Precision: FftNum + Default {
    /// The nearest of these numbers.
    fn nearest(value: f64) -> Self;

    fn spectra(scratch: &mut Scratch) -> &mut Spectra<Self>;
}

impl Precision for f64 {
    fn nearest(value: f64) -> Self {
        value
    }

    fn spectra(scratch: &mut Scratch) -> &mut Spectra<f64> {
        &mut scratch.double
    }
}

impl Precision for f32 {
    #[expect(clippy::cast_possible_truncation, reason = "rounded to the nearest, on purpose")]
    fn nearest(value: f64) -> Self {
        value as Self
    }

    fn spectra(scratch: &mut Scratch) -> &mut Spectra<f32> {
        &mut scratch.single
    }
}

/// What a wave is multiplied by.
pub(super) trait Symbol: Copy + Send + Sync {
    /// Numbers of the amplitudes.
    type Real: Precision;

    /// The number `by` times.
    fn scaled(self, by: f64) -> Self;

    /// Its product with the amplitude of a wave.
    fn on(self, amplitude: Complex<Self::Real>) -> Complex<Self::Real>;
}

impl<T: Precision> Symbol for T {
    type Real = T;

    fn scaled(self, by: f64) -> Self {
        self * T::nearest(by)
    }

    fn on(self, amplitude: Complex<T>) -> Complex<T> {
        amplitude * self
    }
}

impl Symbol for Complex<f64> {
    type Real = f64;

    fn scaled(self, by: f64) -> Self {
        self * by
    }

    fn on(self, amplitude: Self) -> Self {
        amplitude * self
    }
}
