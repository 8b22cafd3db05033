//! What is seen of the bed under a rough line.

use super::{GlidingBed, signed};
use crate::contact::viscoelastic::spring::Spring;

/// What a spring tells of the chord above it.
#[derive(Debug, Clone, Copy, Default)]
struct Told {
    /// Load [N/m].
    load: f64,
    /// That of the Maxwell elements alone [N/m].
    memory: f64,
    /// Slope g′ of the chord; zero where nothing is carried.
    slope: f64,
    /// Resistance [N] of the equilibrium modulus and the dashpot over the chord.
    along: f64,
}

impl GlidingBed {
    /// Normal force F and resistance F_x = ∫ f g′ dξ [N] under a rough line.
    ///
    /// In motion F_x is its mean over the last whole chord passed by the springs, of which ∫ F_x dt = Σ Δg ∫ f dt is known exactly: between
    /// its points the slope of a line jumps. Of a line that stands again the parts of E∞, ∫ E∞u dg, and of the dashpot, whose load is constant along a chord, are those of whole chords. The
    /// load of the elements goes straight from spring to spring past the corner between them: second order in the width.
    /// Before it glides a line does not resist, for the load depends on the height alone: ∫ f(g) dg over each patch is zero.
    pub(super) fn forces_of_line(&self) -> (f64, f64) {
        let told = self.told();
        let normal = self.width * told.iter().map(|spring| spring.load).sum::<f64>();
        if self.now.place.total_cmp(&0.0).is_eq() {
            return (normal, 0.0);
        }
        if let Some(mean) = self.window.mean() {
            return (normal, mean);
        }
        let part = self.now_below().1;
        let next = told.iter().cycle().skip(1);
        let between = told.iter().zip(next).map(|(one, other)| {
            let corner = part * one.memory + (1.0 - part) * other.memory;
            (1.0 - part) * one.slope * (one.memory + corner) + part * other.slope * (corner + other.memory)
        });
        let memory = 0.5 * self.width * between.sum::<f64>();
        (normal, memory + told.iter().map(|spring| spring.along).sum::<f64>())
    }

    /// All springs, in order.
    fn told(&self) -> Vec<Told> {
        let (cell, part) = self.now_below();
        let (equilibrium, viscosity) = (self.spectrum().equilibrium(), self.spectrum().viscosity());
        let of = |(at, touched): (usize, &super::Touched)| {
            let chord = self.first + signed(at) - cell - 1;
            let (low, high) = (self.outline.height(chord), self.outline.height(chord + 1));
            let slope = (high - low) / self.width;
            if !slope.is_finite() {
                return Told::default();
            }
            let Spring::Pressed(loads) = &touched.spring else { return Told { slope, ..Told::default() } };
            let speed = self.moved.down + self.moved.along * slope;
            let displacement = self.now.depth - (low + part * (high - low));
            let load = self.spectrum().load(displacement, loads, speed);
            let square = |height: f64| (self.now.depth - height).max(0.0).powi(2);
            Told {
                load,
                memory: load - equilibrium * displacement - viscosity * speed,
                slope,
                along: 0.5 * equilibrium * (square(low) - square(high)) + viscosity * speed * (high - low),
            }
        };
        self.springs.iter().enumerate().map(of).collect()
    }
}
