//! From SI units, checked, to the solver's units and back.

use ndarray::ArrayView2;
use rayon::prelude::*;
use std::ops::{Range, RangeInclusive};

use super::alone::LonePixels;
use super::grid::{Grid, Law};
use super::run::{Origin, ScaledLoad, ScaledSolution, Task};
use super::transform::{Size, good_length};
use super::vector::{self, each, first, fold, row_after_row, sum};
use super::{HalfSpaceError, Prescribed, Settings, Start, SurfaceResponse};

/// Width over height of a pixel.
const DRAWN_OUT: RangeInclusive<f64> = 1e-3..=1e3;

/// A problem without its heights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Input {
    pub(super) size: Size,
    pub(super) pixel: [f64; 2],
    pub(super) modulus: f64,
    pub(super) law: Law,
    pub(super) control: Prescribed,
}

/// Solution in SI units.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Raw {
    pub(super) pressure: Vec<f64>,
    pub(super) displacement: Vec<f64>,
    pub(super) approach: f64,
    pub(super) residual: f64,
    pub(super) iterations: usize,
    pub(super) products: usize,
    pub(super) bytes: u64,
}

/// Bounds of the heights, and their mean.
#[derive(Debug, Clone, Copy, PartialEq)]
struct HeightBounds {
    low: f64,
    high: f64,
    mean: f64,
}

impl Input {
    /// Checks, scales, solves and scales back.
    pub(super) fn solve(
        &self,
        heights: &ArrayView2<'_, f64>,
        start: Start<'_>,
        (settings, response): (&Settings, Option<&SurfaceResponse>),
    ) -> Result<Raw, HalfSpaceError> {
        let bytes = self.check(settings)?;
        let heights = row_after_row(heights);
        let range = self.range(&heights)?;
        let floats = response.is_none_or(|response| response.compression() <= 0.0);
        let Some(scale) = self.height_scale(range, floats)? else {
            return Ok(self.apart(range.low, bytes));
        };
        let scaled = each(&heights).map(|height| (height - range.low) / scale);
        let heights: Vec<f64> = scaled.collect();
        let pressure_unit = self.modulus * scale / self.unit();
        let hardness = match self.control {
            Prescribed::Indentation(_) => response.map_or(f64::INFINITY, SurfaceResponse::hardness),
            Prescribed::Force(_) => f64::INFINITY,
        };
        if let Some(give) = response.and_then(SurfaceResponse::alone) {
            let wanted = self.wanted([range.low, scale]);
            let springs = LonePixels { heights, give: give / self.unit(), hardness: hardness / pressure_unit };
            return Ok(Raw { bytes, ..self.restore(springs.pressed(wanted), [range.low, scale], pressure_unit) });
        }
        let origin = self.origin(start, pressure_unit)?;
        let task = Task {
            whole: response.map(SurfaceResponse::operators),
            windows: response.and_then(SurfaceResponse::windows),
            beneath: response.and_then(|response| response.beneath(self.unit())),
            hardness: hardness / pressure_unit,
            ..self.task(heights, [range.low, scale], settings)
        };
        // From within its threads none of the many short loops need wake them.
        let answer = rayon::scope(|_| task.run(origin))?;
        Ok(Raw { bytes, ..self.restore(answer, [range.low, scale], pressure_unit) })
    }

    fn check(&self, settings: &Settings) -> Result<u64, HalfSpaceError> {
        let Size { rows, columns } = self.size;
        if rows == 0 || columns == 0 {
            return Err(HalfSpaceError::Empty { rows, columns });
        }
        positive("pixel width", self.pixel[0])?;
        positive("pixel height", self.pixel[1])?;
        positive("effective modulus", self.modulus)?;
        let wanted = "between 1e-3 and 1e3, for pixels longer than that show nothing of what lies along them";
        within("width of a pixel over its height", self.pixel[0] / self.pixel[1], DRAWN_OUT, wanted)?;
        self.check_control()?;
        within("tolerance", settings.tolerance, 1e-14..=0.1, "between 1e-14 and 0.1")?;
        let needed = bytes_needed(self.size, self.law.is_periodic());
        if needed > settings.memory_limit {
            return Err(HalfSpaceError::Memory { rows, columns, needed, limit: settings.memory_limit });
        }
        Ok(needed)
    }

    fn check_control(&self) -> Result<(), HalfSpaceError> {
        match self.control {
            Prescribed::Indentation(value) => within("indentation", value, f64::MIN..=f64::MAX, "finite"),
            Prescribed::Force(value) => within("force", value, 0.0..=f64::MAX, "finite and not negative"),
        }
    }

    fn range(&self, heights: &[f64]) -> Result<HeightBounds, HalfSpaceError> {
        let refused = |height: f64| height.is_nan() || height <= f64::NEG_INFINITY;
        if let Some(index) = first(heights, refused) {
            let (row, column) = (index / self.size.columns, index % self.size.columns);
            return Err(HalfSpaceError::Height { row, column, value: heights[index] });
        }
        let bounds = |range: Range<usize>| {
            let material = heights[range].iter().filter(|height| height.is_finite());
            material
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &height| [low.min(height), high.max(height)])
        };
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let [low, high] =
            fold(heights.len(), bounds, nothing, |one, other| [one[0].min(other[0]), one[1].max(other[1])]);
        if low.is_infinite() {
            return Err(HalfSpaceError::NoMaterial);
        }
        let above = sum(heights.len(), |range| heights[range].iter().map(|height| height - low).sum());
        let mean = low + above / heights.len() as f64;
        Ok(HeightBounds { low, high, mean })
    }

    /// Height that becomes 1, or nothing if the bodies do not touch; what `floats` has no mean displacement and is never
    /// pressed beyond full contact.
    fn height_scale(&self, range: HeightBounds, floats: bool) -> Result<Option<f64>, HalfSpaceError> {
        match self.control {
            Prescribed::Indentation(depth) if depth <= range.low => Ok(None),
            Prescribed::Indentation(depth) if floats && self.law.is_periodic() && depth >= range.mean => {
                Err(HalfSpaceError::FullContact { indentation: depth, mean: range.mean })
            }
            Prescribed::Indentation(depth) => Ok(Some(depth - range.low)),
            Prescribed::Force(force) if force <= 0.0 => Ok(None),
            Prescribed::Force(_) if range.high > range.low => Ok(Some(range.high - range.low)),
            Prescribed::Force(force) => Ok(Some(self.force_length(force))),
        }
    }

    /// Length of the order of the displacement that a force makes under a flat.
    fn force_length(&self, force: f64) -> f64 {
        force / self.force_unit() / (self.size.pixels() as f64).sqrt()
    }

    /// Force that is 1 in the solver's units, per unit of height.
    fn force_unit(&self) -> f64 {
        if self.is_plane() { self.modulus } else { self.modulus * self.unit() }
    }

    fn is_plane(&self) -> bool {
        matches!(self.law, Law::FreePlane(_) | Law::PeriodicPlane)
    }

    fn unit(&self) -> f64 {
        self.pixel[0].sqrt() * self.pixel[1].sqrt()
    }

    fn wanted(&self, [low, scale]: [f64; 2]) -> ScaledLoad {
        match self.control {
            Prescribed::Indentation(depth) => ScaledLoad::Approach((depth - low) / scale),
            Prescribed::Force(force) => ScaledLoad::Force(force / self.force_unit() / scale),
        }
    }

    fn task(&self, heights: Vec<f64>, [low, scale]: [f64; 2], settings: &Settings) -> Task<'static> {
        let wanted = self.wanted([low, scale]);
        let law = match self.law {
            Law::FreePlane(datum) => Law::FreePlane(datum / self.unit()),
            Law::FreeSpace | Law::PeriodicSpace | Law::PeriodicPlane => self.law,
        };
        let pixel = self.pixel.map(|side| side / self.unit());
        let grid = Grid { size: self.size, pixel, heights };
        let Settings { tolerance, max_iterations, .. } = *settings;
        Task {
            grid,
            law,
            wanted,
            tolerance,
            max_iterations,
            hardness: f64::INFINITY,
            whole: None,
            beneath: None,
            windows: None,
        }
    }

    fn origin(&self, start: Start<'_>, pressure_unit: f64) -> Result<Origin, HalfSpaceError> {
        match start {
            Start::Coarser => Ok(Origin::Coarser),
            Start::Nothing => Ok(Origin::Nothing),
            Start::Pressure(pressure) => self.given(pressure, pressure_unit),
        }
    }

    /// Starting pressure in the solver's units; one without any contact is no knowledge.
    fn given(&self, pressure: ArrayView2<'_, f64>, unit: f64) -> Result<Origin, HalfSpaceError> {
        let (found_rows, found_columns) = pressure.dim();
        let Size { rows, columns } = self.size;
        if (found_rows, found_columns) != (rows, columns) {
            return Err(HalfSpaceError::StartSize { found_rows, found_columns, rows, columns });
        }
        let refused = |value: f64| !value.is_finite() || value < 0.0;
        let pressure = row_after_row(&pressure);
        if let Some(index) = first(&pressure, refused) {
            let (row, column) = (index / columns, index % columns);
            return Err(HalfSpaceError::StartValue { row, column, value: pressure[index] });
        }
        let scaled: Vec<f64> = each(&pressure).map(|value| value / unit).collect();
        Ok(if first(&scaled, |value| value > 0.0).is_some() { Origin::Pressure(scaled) } else { Origin::Nothing })
    }

    fn restore(&self, answer: ScaledSolution, [low, scale]: [f64; 2], pressure_unit: f64) -> Raw {
        let to_si = |mut values: Vec<f64>, unit: f64| {
            vector::scale(&mut values, unit);
            values
        };
        Raw {
            pressure: to_si(answer.pressure, pressure_unit),
            displacement: to_si(answer.displacement, scale),
            approach: low + scale * answer.approach,
            residual: answer.residual,
            iterations: answer.effort.iterations,
            products: answer.effort.products,
            bytes: 0,
        }
    }

    /// Bodies that do not press on each other: no force at first touch, or the indentation prescribed.
    fn apart(&self, lowest: f64, bytes: u64) -> Raw {
        let zeros = || vec![0.0; self.size.pixels()];
        let approach = match self.control {
            Prescribed::Indentation(depth) => depth,
            Prescribed::Force(_) => lowest,
        };
        Raw { pressure: zeros(), displacement: zeros(), approach, bytes, ..Raw::default() }
    }
}

fn positive(name: &'static str, value: f64) -> Result<(), HalfSpaceError> {
    within(name, value, f64::MIN_POSITIVE..=f64::MAX, "finite and positive")
}

fn within(
    name: &'static str,
    value: f64,
    range: RangeInclusive<f64>,
    wanted: &'static str,
) -> Result<(), HalfSpaceError> {
    if range.contains(&value) { Ok(()) } else { Err(HalfSpaceError::Parameter { name, value, wanted }) }
}

/// Vectors on pixels alive at once: heights of all grids, pressure, lift, displacement, copies of a window's heights and
/// pressure, and residual, direction, work and stiffness against a uniform displacement, which take half of one.
const VECTORS: f64 = 9.0;

/// Upper bound of the bytes a solution takes.
pub(super) fn bytes_needed(size: Size, periodic: bool) -> u64 {
    let padded = |side: usize| {
        if side == 1 || periodic { side } else { side.saturating_mul(2) }
    };
    let smooth = |side: usize| {
        if side == 1 || periodic || side > 1 << 40 { side } else { good_length(side) }
    };
    let good = Size { rows: smooth(size.rows), columns: smooth(size.columns) };
    let pixels = size.rows as f64 * size.columns as f64;
    let half_spectrum = size.rows as f64 * (padded(good.columns) as f64 / 2.0 + 8.0);
    let quarter = (padded(good.rows) as f64 / 2.0 + 1.0) * (padded(good.columns) as f64 / 2.0 + 1.0);
    let stiffness = if periodic { quarter } else { quarter / 4.0 };
    // Two spectra in double and two in single precision; the influence in both, and where it does not repeat itself over the
    // pixels, of which windows are made.
    let influences = if periodic { 0.0 } else { 8.0 * quarter };
    let bytes = 8.0 * VECTORS * pixels + 48.0 * half_spectrum + 20.0 * quarter + influences + 16.0 * stiffness;
    // Saturates where no memory could follow; the value is rounded up to whole bytes.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a positive float to an integer saturates"
    )]
    let bytes = bytes.ceil() as u64;
    bytes
}
