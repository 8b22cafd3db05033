//! The bed of cells under a worn profile, and how it wears.

use super::edge::edge;
use super::rings::{Rings, Start, dot};
use crate::numerics::quadrature;
use crate::shape::Profile;
use std::sync::Arc;

/// What is kept while a contact wears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Load {
    /// The indentation d [m].
    Indentation(f64),
    /// The normal force F [N].
    Force(f64),
}

/// Most steps of Newton's method for the depth under a force; it takes as many as cells come and go.
const MOST_STEPS: usize = 200;

/// Cells kept outside the contact.
const SPARE: usize = 4;

/// Part of the largest compression within which a spring that is worn off lies at the depth: what the steps leave.
const SLACK: f64 = 1e-6;

/// Springs in cells under a profile that wears.
#[derive(Debug, Clone)]
pub struct WornBed {
    profile: Arc<dyn Profile>,
    /// Effective modulus E* [Pa].
    modulus: f64,
    pub rings: Rings,
    /// Mean of the unworn g over each cell [m].
    unworn: Vec<f64>,
}

/// The bed at one instant.
#[derive(Debug, Clone, Default)]
pub struct Pressed {
    /// Indentation d [m].
    pub depth: f64,
    /// Means of g over the cells [m].
    pub reduced: Vec<f64>,
    /// Means of the line load q over the cells [N/m].
    pub loads: Vec<f64>,
}

impl WornBed {
    pub fn new(profile: Arc<dyn Profile>, modulus: f64, start: Start) -> Self {
        let rings = Rings::new(profile.as_ref(), start);
        let mut bed = Self { profile, modulus, rings, unworn: Vec::new() };
        bed.fill();
        bed
    }

    /// Mean of g over the cells that have come last.
    fn fill(&mut self) {
        for i in self.unworn.len()..self.rings.len() {
            let (from, to) = (self.rings.cells()[i], self.rings.cells()[i + 1]);
            let breaks: Vec<f64> = self.profile.breaks(to).into_iter().filter(|&x| x > from).collect();
            let area = quadrature::panels(|x| self.profile.reduced(x), (from, to), &breaks);
            self.unworn.push(area / (to - from));
        }
    }

    /// A tenth more cells, at least one; nothing where the profile ends.
    pub fn widen(&mut self) {
        for _ in 0..=self.rings.len() / 10 {
            self.rings.grow();
        }
        self.fill();
    }

    pub fn profile(&self) -> &Arc<dyn Profile> {
        &self.profile
    }

    pub fn modulus(&self) -> f64 {
        self.modulus
    }

    /// The bed under the worn depths `worn` [m] of the rings and a load; `guess` is a depth [m] to begin with.
    pub fn press(&self, worn: &[f64], load: Load, pressed: &mut Pressed) {
        let cells = 0..self.rings.len();
        pressed.reduced.clear();
        pressed.reduced.extend(cells.map(|i| self.unworn[i] + self.rings.raised(i, worn)));
        pressed.depth = match load {
            Load::Indentation(depth) => depth,
            Load::Force(force) => self.depth_under(force, &pressed.reduced, pressed.depth),
        };
        pressed.loads.clear();
        let load = |g: &f64| self.modulus * (pressed.depth - g).max(0.0);
        pressed.loads.extend(pressed.reduced.iter().map(load));
    }

    /// Depth [m] under the force `force` [N]. The force is a convex function of the depth: Newton's method comes from
    /// above after its first step. Without a force it is that of the first touch.
    fn depth_under(&self, force: f64, reduced: &[f64], guess: f64) -> f64 {
        let touch = reduced.iter().copied().fold(f64::INFINITY, f64::min);
        if force <= 0.0 {
            return touch;
        }
        let mut depth = guess.max(touch);
        for _ in 0..MOST_STEPS {
            let (mut area, mut width) = (0.0, 0.0);
            for (i, g) in reduced.iter().enumerate().filter(|(_, g)| **g <= depth) {
                area += self.rings.width(i) * (depth - g);
                width += self.rings.width(i);
            }
            let next = (depth - (area - 0.5 * force / self.modulus) / width).max(touch);
            if (next - depth).abs() <= 2.0 * f64::EPSILON * depth.abs() {
                return next;
            }
            depth = next;
        }
        depth
    }

    /// Normal force F = 2 Σ h q [N].
    pub fn force(&self, pressed: &Pressed) -> f64 {
        2.0 * pressed.loads.iter().enumerate().map(|(i, q)| self.rings.width(i) * q).sum::<f64>()
    }

    /// Elastic energy U = Σ h q²/E* [J].
    pub fn energy(&self, pressed: &Pressed) -> f64 {
        let square = |(i, q): (usize, &f64)| self.rings.width(i) * q * q;
        pressed.loads.iter().enumerate().map(square).sum::<f64>() / self.modulus
    }

    /// Contact radius [m].
    pub fn contact_radius(&self, pressed: &Pressed) -> f64 {
        let depth = pressed.depth + slack(pressed);
        let below: Vec<f64> = pressed.reduced.iter().map(|g| depth - g).collect();
        match below.iter().rposition(|&below| below > 0.0) {
            None => 0.0,
            Some(last) if last + 1 >= below.len() => self.rings.outer(),
            Some(last) => edge(self.rings.cells(), &below, last),
        }
    }

    /// Whether one of the last cells is touched, and the profile goes on beyond them.
    pub fn is_too_narrow(&self, pressed: &Pressed) -> bool {
        !self.rings.ended() && pressed.loads.iter().rev().take(SPARE).any(|&load| load > 0.0)
    }

    /// Whether the contact is one piece: no cell is apart inside one that is touched.
    pub fn is_in_one_piece(&self, pressed: &Pressed) -> bool {
        let slack = slack(pressed);
        let apart = |g: &f64| *g > pressed.depth + slack;
        let first = pressed.reduced.iter().position(apart).unwrap_or(pressed.reduced.len());
        pressed.reduced[first..].iter().all(|g| *g >= pressed.depth - slack)
    }

    /// An upper bound of the rates [1/m] at which a form of the profile decays per k_w under the slips `slips` of the rings:
    /// the largest sum of a row of 2E* H⁻¹|M| S A⁻¹ |M|ᵀ.
    pub fn stiffness(&self, slips: &[f64]) -> f64 {
        let rings = &self.rings;
        let mut columns = vec![0.0; rings.len()];
        for i in 0..rings.len() {
            columns.iter_mut().zip(rings.row(i)).for_each(|(sum, m)| *sum += m.abs());
        }
        columns.iter_mut().zip(slips).zip(rings.areas()).for_each(|((sum, slip), area)| *sum *= slip / area);
        let row = |i: usize| {
            let sizes: Vec<f64> = rings.row(i).iter().map(|m| m.abs()).collect();
            dot(&sizes, &columns) / rings.width(i)
        };
        2.0 * self.modulus * (0..rings.len()).map(row).fold(0.0, f64::max)
    }
}

/// How far above the depth [m] a spring still counts as touched.
fn slack(pressed: &Pressed) -> f64 {
    let touch = pressed.reduced.iter().copied().fold(f64::INFINITY, f64::min);
    SLACK * (pressed.depth - touch).max(0.0)
}
