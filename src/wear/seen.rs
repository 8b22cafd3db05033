//! Pressure, shear stress and surface of a worn contact.

use super::bed::{Pressed, WornBed};
use super::rings::Rings;
use crate::contact::model::Loading;
use std::f64::consts::FRAC_2_PI;

/// A worn contact, to be looked at: means over the rings, joined by straight lines.
#[derive(Debug)]
pub struct Seen<'w> {
    bed: &'w WornBed,
    pressed: &'w Pressed,
    worn: &'w [f64],
    radius: f64,
    pressures: Vec<f64>,
    shears: Vec<f64>,
}

impl<'w> Seen<'w> {
    /// A bed with the worn depths `worn` [m] of its rings and the tangential line loads `shear` [N/m] of its cells.
    pub fn new((bed, pressed): (&'w WornBed, &'w Pressed), worn: &'w [f64], shear: &[f64]) -> Self {
        let stresses = |loads: &[f64]| {
            let mut forces = vec![0.0; bed.rings.len()];
            bed.rings.forces(loads, &mut forces);
            forces.iter().zip(bed.rings.areas()).map(|(force, area)| force / area).collect::<Vec<f64>>()
        };
        let (pressures, shears) = (stresses(&pressed.loads), stresses(shear));
        Self { bed, pressed, worn, radius: bed.contact_radius(pressed), pressures, shears }
    }
}

/// Value at the radius `r` of means over rings, joined by straight lines; that of the first at the axis.
fn at(rings: &Rings, means: &[f64], r: f64) -> f64 {
    let borders = rings.rings();
    let middle = |j: usize| 0.5 * (borders[j] + borders[j + 1]);
    let next = (0..means.len()).collect::<Vec<_>>().partition_point(|&j| middle(j) < r);
    match (next.checked_sub(1), next < means.len()) {
        (None, _) => means.first().copied().unwrap_or(0.0),
        (Some(last), false) => means[last],
        (Some(last), true) => {
            let part = (r - middle(last)) / (middle(next) - middle(last));
            means[last] + part * (means[next] - means[last])
        }
    }
}

impl Loading for Seen<'_> {
    fn contact_radius(&self) -> f64 {
        self.radius
    }

    fn pressure(&self, r: f64) -> Option<f64> {
        Some(if r < self.radius { at(&self.bed.rings, &self.pressures, r) } else { 0.0 })
    }

    /// d − f(r) in the contact, (2/π)∫₀^a u dx/√(r²−x²) outside.
    fn surface(&self, r: f64) -> Option<f64> {
        let rings = &self.bed.rings;
        if r <= self.radius {
            return Some(self.pressed.depth - self.bed.profile().height(r) - at(rings, self.worn, r));
        }
        let cells = rings.cells();
        let angle = |x: f64| (x / r).min(1.0).asin();
        let raised = |(i, load): (usize, &f64)| load / self.bed.modulus() * (angle(cells[i + 1]) - angle(cells[i]));
        let inside = self.pressed.loads.iter().enumerate().take_while(|(i, _)| cells[*i] < r);
        Some(FRAC_2_PI * inside.map(raised).sum::<f64>())
    }

    fn shear(&self, radii: &[f64]) -> Vec<Option<f64>> {
        let stress = |&r: &f64| Some(if r < self.radius { at(&self.bed.rings, &self.shears, r) } else { 0.0 });
        radii.iter().map(stress).collect()
    }
}
