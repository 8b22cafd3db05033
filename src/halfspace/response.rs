//! The surface under pressures that are given.

use super::grid::{Grid, Law, Operators, Windows};
use super::kernel::Beneath;
use super::precision::Scratch;
use super::transform::Size;
use super::vector::{self, on_pixels, row_after_row};
use super::{Boundary, PressedMap};
use crate::ground::Ground;
use ndarray::{Array2, ArrayView2};
use std::fmt::{self, Debug, Formatter};
use std::sync::Arc;

/// What pressures do to the pixels of a half-space, whatever lies on it: u = G p.
///
/// Made once for many pressures. G is that of [`solve`](super::solve): free, Love's uniformly loaded rectangles (Johnson
/// 1985, eq. 3.25); periodic, 2/(E*|q|) on every wave (Johnson, eq. 13.7), the mean displacement being zero.
///
/// # Examples
/// ```
/// use ndarray::Array2;
/// use springbed::halfspace::{Boundary, SurfaceResponse};
///
/// // A wave of the wavelength λ under the pressure p cos(2πx/λ): u = pλ/(πE*) cos(2πx/λ).
/// let wave = Array2::from_shape_fn((8, 64), |(_, j)| (std::f64::consts::TAU * j as f64 / 64.0).cos());
/// let response = SurfaceResponse::new([8, 64], [1.0 / 64.0; 2], Boundary::Periodic);
/// let displacement = response.displacement(wave.view(), 2.0);
/// assert!((displacement[[3, 0]] * std::f64::consts::TAU - 1.0).abs() < 1e-14);
/// ```
#[derive(Clone)]
pub struct SurfaceResponse {
    operators: Arc<Operators>,
    /// Smaller windows; none where every wave stands for itself.
    windows: Option<Arc<Windows>>,
    /// Rows and columns, width and height of a pixel \[m\], and what is beyond the border.
    pixels: ([usize; 2], [f64; 2], Boundary),
    /// Mean side of a pixel \[m\].
    unit: f64,
    /// Largest pressure \[Pa\].
    hardness: f64,
    /// What lies beneath, if it is no half-space.
    ground: Option<Arc<dyn Ground>>,
}

impl Debug for SurfaceResponse {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { pixels, hardness, ground, .. } = self;
        f.debug_struct("SurfaceResponse")
            .field("pixels", pixels)
            .field("hardness", hardness)
            .field("ground", ground)
            .finish_non_exhaustive()
    }
}

impl SurfaceResponse {
    /// Of `[rows, columns]` pixels of the width and height `pixel` \[m\].
    #[must_use]
    pub fn new(size: [usize; 2], pixel: [f64; 2], boundary: Boundary) -> Self {
        Self::over(None, size, pixel, boundary)
    }

    /// The same over layers or another ground that is not alike at all depths, a homogeneous half-space if absent. Where
    /// a layer between rigid bodies ends, the displacement that repeats has a mean too.
    #[must_use]
    pub fn over(
        ground: Option<Arc<dyn Ground>>,
        [rows, columns]: [usize; 2],
        pixel: [f64; 2],
        boundary: Boundary,
    ) -> Self {
        let size = Size { rows, columns };
        let unit = pixel[0].sqrt() * pixel[1].sqrt();
        let grid = Grid { size, pixel: pixel.map(|side| side / unit), heights: Vec::new() };
        let under = beneath(ground.as_ref(), unit);
        let windows = (boundary == Boundary::Free).then(|| Arc::new(Windows::new(&grid, under)));
        let operators = match &windows {
            Some(windows) => windows.of(size),
            None => Arc::new(Operators::new(&grid, size, Law::PeriodicSpace, under)),
        };
        Self { operators, windows, pixels: ([rows, columns], pixel, boundary), unit, hardness: f64::INFINITY, ground }
    }

    /// The same surface, which yields under the pressure `hardness` \[Pa\]: no pixel carries more (Persson 2001;
    /// Almqvist et al. 2007). Above zero.
    #[must_use]
    pub fn yielding_under(self, hardness: f64) -> Self {
        Self { hardness, ..self }
    }

    /// That of at most as many of its pixels, `[rows, columns]`, with nothing beyond them; where everything repeats, of as many that
    /// repeat by themselves.
    #[must_use]
    pub(crate) fn part(&self, [rows, columns]: [usize; 2]) -> Self {
        let (_, pixel, boundary) = self.pixels;
        let pixels = ([rows, columns], pixel, boundary);
        match &self.windows {
            Some(windows) => Self { operators: windows.of(Size { rows, columns }), pixels, ..self.clone() },
            None => Self::over(self.ground.clone(), [rows, columns], pixel, boundary).yielding_under(self.hardness),
        }
    }

    /// Largest pressure \[Pa\]; infinite for a surface that does not yield.
    #[must_use]
    pub fn hardness(&self) -> f64 {
        self.hardness
    }

    /// E* times what a uniform pressure gives where everything repeats \[m\]; 0 where that has no end, and the mean
    /// displacement is zero.
    #[must_use]
    pub fn compression(&self) -> f64 {
        self.beneath(1.0).map_or(0.0, |beneath| beneath.wave(0.0))
    }

    /// E* times what a pixel gives per pressure on it \[m\], where its neighbours do nothing to it.
    pub(crate) fn alone(&self) -> Option<f64> {
        self.ground.as_ref()?.alone()
    }

    /// Whether the map has the same pixels.
    pub(super) fn suits(&self, map: &PressedMap<'_>) -> bool {
        self.pixels == (map.heights.dim().into(), map.pixel, map.boundary)
    }

    /// What lies beneath, lengths in `unit` \[m\].
    pub(super) fn beneath(&self, unit: f64) -> Option<Beneath<'_>> {
        beneath(self.ground.as_ref(), unit)
    }

    /// The maps of windows of the pixels.
    pub(super) fn windows(&self) -> Option<&Windows> {
        self.windows.as_deref()
    }

    pub(super) fn operators(&self) -> &Operators {
        &self.operators
    }

    /// Displacement into the half-space \[m\] under `pressure` \[Pa\], pressing or pulling, with the modulus E* \[Pa\].
    ///
    /// # Panics
    /// The pressure has other pixels than the response.
    #[must_use]
    pub fn displacement(&self, pressure: ArrayView2<'_, f64>, modulus: f64) -> Array2<f64> {
        if let Some(give) = self.alone() {
            return &pressure * (give / modulus);
        }
        let given = row_after_row(&pressure);
        let mut displacement = vec![0.0; given.len()];
        self.operators.influence.apply(&given, &mut displacement, &mut Scratch::default());
        vector::scale(&mut displacement, self.unit / modulus);
        on_pixels(displacement, pressure.dim())
    }
}

fn beneath(ground: Option<&Arc<dyn Ground>>, unit: f64) -> Option<Beneath<'_>> {
    ground.map(|ground| Beneath { ground: ground.as_ref(), unit })
}
