//! Grids of one problem: the measured one, the coarser ones that start it, and the part of each that matters.

use std::borrow::Cow;
use std::sync::{Arc, Mutex, PoisonError};

use rayon::prelude::*;

use super::kernel::{Beneath, Influence, KernelTable, Rectangle};
use super::spectrum::spectrum_of_even;
use super::transform::{Multiplier, Size, good_length};
use super::vector::{rows_mut, rows_of_piece};

/// Windows of the finest grid have sides of as many of these as they need: a contact that grows or shrinks a little keeps
/// its window, and the maps made for it.
const WINDOW_STEP: usize = 8;

/// Windows whose maps are kept.
const WINDOWS_KEPT: usize = 6;

/// Fewest pixels a side may have to be halved once more.
const COARSEST: usize = 24;

/// What the displacement of a grid is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Law {
    /// Free half-space.
    FreeSpace,
    /// Free half-plane whose datum is this far from the load, in the units of the pixel.
    FreePlane(f64),
    /// Half-space repeated periodically.
    PeriodicSpace,
    /// Half-plane repeated periodically.
    PeriodicPlane,
}

impl Law {
    pub(super) fn is_periodic(self) -> bool {
        matches!(self, Self::PeriodicSpace | Self::PeriodicPlane)
    }
}

/// Heights on pixels, in the units of the solver.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    pub(super) size: Size,
    /// Pixel width (along a row) and height; equal for a line.
    pub(super) pixel: [f64; 2],
    pub(super) heights: Vec<f64>,
}

/// Part of a grid: first row and column, and size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Window {
    pub(super) row: usize,
    pub(super) column: usize,
    pub(super) size: Size,
}

impl Grid {
    /// Length in which the solver measures: the mean side of a pixel.
    pub(super) fn unit(&self) -> f64 {
        (self.pixel[0] * self.pixel[1]).sqrt()
    }

    /// Grid of pixels twice as large, if the sides allow it.
    pub(super) fn coarser(&self, law: Law) -> Option<Self> {
        let line = self.size.rows == 1;
        let even = |side: usize| !law.is_periodic() || side.is_multiple_of(2);
        let large = |side: usize| side >= COARSEST && even(side);
        if !large(self.size.columns) || !(line || large(self.size.rows)) {
            return None;
        }
        let step = if line { 1 } else { 2 };
        let size = Size { rows: self.size.rows.div_ceil(step), columns: self.size.columns.div_ceil(2) };
        let heights = (0..size.pixels())
            .into_par_iter()
            .map(|index| self.mean_height(index / size.columns * step, step, index % size.columns * 2))
            .collect();
        Some(Self { size, pixel: self.pixel.map(|side| 2.0 * side), heights })
    }

    /// Mean of the finite heights of a pixel twice as large, +∞ where there are none.
    fn mean_height(&self, row: usize, step: usize, column: usize) -> f64 {
        let Size { rows, columns } = self.size;
        let (mut sum, mut count) = (0.0, 0.0);
        for row in row..(row + step).min(rows) {
            for height in &self.heights[row * columns + column..row * columns + (column + 2).min(columns)] {
                if height.is_finite() {
                    sum += height;
                    count += 1.0;
                }
            }
        }
        if count > 0.0 { sum / count } else { f64::INFINITY }
    }

    pub(super) fn whole(&self) -> Window {
        Window { row: 0, column: 0, size: self.size }
    }

    /// Smallest window that holds every pixel chosen, widened by a margin; nothing if none is chosen.
    pub(super) fn window(&self, margin: usize, chosen: impl Fn(usize) -> bool + Sync) -> Option<Window> {
        let in_row = |row: usize| {
            let mut along = row * self.size.columns..(row + 1) * self.size.columns;
            let first = along.clone().find(|&index| chosen(index))?;
            let last = along.rfind(|&index| chosen(index))?;
            let column = |index: usize| index - row * self.size.columns;
            Some(([row, column(first)], [row + 1, column(last) + 1]))
        };
        type Corners = ([usize; 2], [usize; 2]);
        let both = |(first, last): Corners, (start, end): Corners| {
            let corners = |axis: usize| (first[axis].min(start[axis]), last[axis].max(end[axis]));
            let (rows, columns) = (corners(0), corners(1));
            ([rows.0, columns.0], [rows.1, columns.1])
        };
        let chosen = (0..self.size.rows).into_par_iter().with_min_len(rows_of_piece(self.size.columns));
        let chosen = chosen.filter_map(in_row).reduce_with(both);
        chosen.map(|(first, last)| {
            let low = first.map(|side| side.saturating_sub(margin));
            let high = [(last[0] + margin).min(self.size.rows), (last[1] + margin).min(self.size.columns)];
            Window { row: low[0], column: low[1], size: Size { rows: high[0] - low[0], columns: high[1] - low[1] } }
        })
    }

    /// The window widened to sides of whole steps, where the grid is as large.
    pub(super) fn stepped(&self, window: Window) -> Window {
        let side = |side: usize, most: usize| side.next_multiple_of(WINDOW_STEP).min(most);
        let size = Size {
            rows: side(window.size.rows, self.size.rows),
            columns: side(window.size.columns, self.size.columns),
        };
        Window {
            row: window.row.min(self.size.rows - size.rows),
            column: window.column.min(self.size.columns - size.columns),
            size,
        }
    }

    /// Values of a window of the grid.
    pub(super) fn cut<'v>(&self, values: &'v [f64], window: Window) -> Cow<'v, [f64]> {
        if window == self.whole() {
            return Cow::Borrowed(values);
        }
        let mut part = vec![0.0; window.size.pixels()];
        let rows = values.par_chunks(self.size.columns).skip(window.row);
        rows_mut(&mut part, window.size.columns)
            .zip(rows)
            .for_each(|(part, row)| part.copy_from_slice(&row[window.column..window.column + window.size.columns]));
        Cow::Owned(part)
    }

    /// Values of a window put back into the grid, which is zero elsewhere.
    pub(super) fn paste(&self, part: Vec<f64>, window: Window, values: &mut Vec<f64>) {
        if window == self.whole() {
            *values = part;
            return;
        }
        let columns = window.column..window.column + window.size.columns;
        let rows = rows_mut(values, self.size.columns);
        rows.enumerate().for_each(|(row, values)| {
            values.fill(0.0);
            if (window.row..window.row + window.size.rows).contains(&row) {
                let from = (row - window.row) * window.size.columns;
                values[columns.clone()].copy_from_slice(&part[from..from + window.size.columns]);
            }
        });
    }

    /// Pressure of the twice coarser grid on this one.
    ///
    /// Linear in the square of the pressure, which is smooth up to the edge of a contact where the
    /// pressure itself rises like a root; a pixel's pressure halves with the unit it is measured in.
    pub(super) fn refine(&self, coarse: &[f64], from: &Grid, law: Law) -> Vec<f64> {
        let periodic = law.is_periodic();
        let square = |row: usize, column: usize| coarse[row * from.size.columns + column].powi(2);
        (0..self.size.pixels())
            .into_par_iter()
            .map(|index| {
                let (row, column) = (index / self.size.columns, index % self.size.columns);
                let columns = neighbours(column, from.size.columns, periodic);
                let rows =
                    if self.size.rows == from.size.rows { [row; 2] } else { neighbours(row, from.size.rows, periodic) };
                let near = 0.75 * square(rows[0], columns[0]) + 0.25 * square(rows[0], columns[1]);
                let far = 0.75 * square(rows[1], columns[0]) + 0.25 * square(rows[1], columns[1]);
                0.5 * (0.75 * near + 0.25 * far).sqrt()
            })
            .collect()
    }
}

/// Coarse pixel that holds a fine one, and the nearest of its neighbours.
fn neighbours(fine: usize, coarse: usize, periodic: bool) -> [usize; 2] {
    let own = fine / 2;
    let next = match (fine % 2, periodic) {
        (0, true) => (own + coarse - 1) % coarse,
        (0, false) => own.saturating_sub(1),
        (_, true) => (own + 1) % coarse,
        (_, false) => (own + 1).min(coarse - 1),
    };
    [own, next]
}

/// The maps of a window: pressure → displacement, and roughly back.
pub(super) struct Operators {
    pub(super) influence: Multiplier,
    /// The same to seven digits of the largest displacement, for steps whose outcome is looked at exactly.
    pub(super) swift: Multiplier<f32>,
    pub(super) stiffness: Multiplier<f32>,
    pub(super) compliance: f64,
    /// Whether a uniform pressure displaces nothing: where everything touches it is known up to a constant only.
    pub(super) floats: bool,
}

impl Operators {
    /// Over the ground `beneath`, if that is not a half-space.
    pub(super) fn new(grid: &Grid, size: Size, law: Law, beneath: Option<Beneath<'_>>) -> Self {
        match law {
            Law::PeriodicSpace | Law::PeriodicPlane => {
                Self::periodic(grid, beneath.map(|beneath| beneath.in_units(grid.unit())))
            }
            Law::FreeSpace => Self::free(size, influence(grid, beneath)),
            Law::FreePlane(datum) => Self::free(size, Influence::Strip { datum: datum / grid.unit() }),
        }
    }

    /// Zero-padded convolution, and the inverse of the circulant nearest to it (T. Chan 1988).
    pub(super) fn free(size: Size, kernel: Influence<'_>) -> Self {
        let (period, table) = kernel_table(size, kernel);
        let circulant = Size { rows: period.rows.div_ceil(2), columns: period.columns / 2 };
        let nearest = circulant_table(&table, period, circulant);
        let stiffness: Vec<f64> = spectrum_of_even(nearest, circulant).into_par_iter().map(f64::recip).collect();
        let own = table[0];
        let compliance = spectrum_of_even(table, period);
        Self {
            compliance: own,
            floats: false,
            swift: Multiplier::rough(size, period, &compliance),
            influence: Multiplier::new(size, period, compliance),
            stiffness: Multiplier::rough(size, circulant, &stiffness),
        }
    }

    /// Every wave by itself; where a uniform pressure sinks everything without an end, the mean displacement is zero.
    fn periodic(grid: &Grid, beneath: Option<Beneath<'_>>) -> Self {
        let endless = |q: f64| if q > 0.0 { 2.0 / q } else { 0.0 };
        let given = |q: f64| beneath.map_or_else(|| endless(q), |beneath| beneath.wave(q));
        let compliance: Vec<f64> = wave_numbers(grid).into_par_iter().map(given).collect();
        let softest = compliance.iter().copied().reduce(f64::max).filter(|&most| most > 0.0).unwrap_or(2.0);
        let stiffness: Vec<f64> =
            compliance.iter().map(|&given| if given > 0.0 { given } else { softest }.recip()).collect();
        Self {
            compliance: mean_over_period(&compliance, grid.size),
            floats: compliance.first().is_some_and(|&uniform| uniform <= 0.0),
            swift: Multiplier::rough(grid.size, grid.size, &compliance),
            influence: Multiplier::new(grid.size, grid.size, compliance),
            stiffness: Multiplier::rough(grid.size, grid.size, &stiffness),
        }
    }
}

/// Influence of a pixel on the half-space, or on the ground `beneath`.
fn influence<'g>(grid: &Grid, beneath: Option<Beneath<'g>>) -> Influence<'g> {
    let rectangle = Rectangle::new(grid.pixel[0], grid.pixel[1]);
    let over = |beneath: Beneath<'g>| Influence::Over(rectangle, beneath.in_units(grid.unit()));
    beneath.map_or(Influence::Rectangle(rectangle), over)
}

/// The maps of windows of one free grid, whose influences are known, for many contacts on it.
pub(super) struct Windows {
    influences: KernelTable,
    /// Those asked for last, the latest at the end.
    made: Mutex<Vec<(Size, Arc<Operators>)>>,
}

impl Windows {
    pub(super) fn new(grid: &Grid, beneath: Option<Beneath<'_>>) -> Self {
        let (period, values) = kernel_table(grid.size, influence(grid, beneath));
        Self { influences: KernelTable { stride: period.columns / 2 + 1, values }, made: Mutex::default() }
    }

    /// The maps of a window of this size, made where they are not known. They are made without the lock: whoever makes
    /// them lends a hand elsewhere meanwhile, perhaps to another who asks.
    pub(super) fn of(&self, size: Size) -> Arc<Operators> {
        let made = || self.made.lock().unwrap_or_else(PoisonError::into_inner);
        let known = made().iter().find(|(at, _)| *at == size).map(|(_, operators)| Arc::clone(operators));
        let operators = known.unwrap_or_else(|| Arc::new(Operators::free(size, Influence::Kept(&self.influences))));
        let mut made = made();
        made.retain(|(at, _)| *at != size);
        if made.len() == WINDOWS_KEPT {
            made.remove(0);
        }
        made.push((size, Arc::clone(&operators)));
        operators
    }
}

/// Padded period of a free window and the influence of one pixel over a quarter of it.
pub(super) fn kernel_table(size: Size, kernel: Influence<'_>) -> (Size, Vec<f64>) {
    let rows = if size.rows == 1 { 1 } else { 2 * good_length(size.rows) };
    let period = Size { rows, columns: 2 * good_length(size.columns) };
    let half = period.columns / 2 + 1;
    let mut table = vec![0.0; (rows / 2 + 1) * half];
    table.par_chunks_mut(half).enumerate().for_each(|(row, line)| {
        line.iter_mut().enumerate().for_each(|(column, value)| *value = kernel.at(row, column));
    });
    (period, table)
}

/// Quarter of the circulant nearest to the convolution, weights as for a full window.
fn circulant_table(table: &[f64], period: Size, circulant: Size) -> Vec<f64> {
    let stride = period.columns / 2 + 1;
    let (rows, columns) = (circulant.rows, circulant.columns);
    let share = |step: usize, period: usize| (period - step) as f64 / period as f64;
    let at = |row: usize, column: usize| table[row * stride + column];
    let mut nearest = vec![0.0; (rows / 2 + 1) * (columns / 2 + 1)];
    let lines = rows_mut(&mut nearest, columns / 2 + 1);
    lines.enumerate().for_each(|(row, line)| {
        let down = share(row, rows);
        let other = if row == 0 { 0 } else { rows - row };
        for (column, value) in line.iter_mut().enumerate() {
            let across = share(column, columns);
            let near = across * at(row, column) + (1.0 - across) * at(row, columns - column);
            let far = across * at(other, column) + (1.0 - across) * at(other, columns - column);
            *value = down * near + (1.0 - down) * far;
        }
    });
    nearest
}

/// |q| in the units of the grid over a quarter of the frequencies, column first.
fn wave_numbers(grid: &Grid) -> Vec<f64> {
    let unit = std::f64::consts::TAU * grid.unit();
    let step = [unit / (grid.pixel[0] * grid.size.columns as f64), unit / (grid.pixel[1] * grid.size.rows as f64)];
    let quarter = grid.size.rows / 2 + 1;
    let mut waves = vec![0.0; (grid.size.columns / 2 + 1) * quarter];
    let lines = rows_mut(&mut waves, quarter);
    lines.enumerate().for_each(|(column, waves)| {
        let across = column as f64 * step[0];
        waves.iter_mut().enumerate().for_each(|(row, wave)| *wave = across.hypot(row as f64 * step[1]));
    });
    waves
}

/// Mean of an even quantity over all frequencies: the displacement of a pixel under its own unit pressure.
pub(super) fn mean_over_period(quarter: &[f64], size: Size) -> f64 {
    let copies = |index: usize, period: usize| {
        if index == 0 || 2 * index == period { 1.0 } else { 2.0 }
    };
    let stride = size.rows / 2 + 1;
    let weighted = quarter.iter().enumerate();
    let sum: f64 = weighted
        .map(|(index, value)| copies(index / stride, size.columns) * copies(index % stride, size.rows) * value)
        .sum();
    sum / size.pixels() as f64
}
