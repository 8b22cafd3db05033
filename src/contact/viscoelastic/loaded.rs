//! The bed that remembers as a loaded contact: stresses, pressure and surface of its present loads.

use super::memory::Memory;
use super::panel::Strip;
use super::spring::Spring;
use crate::contact::loaded::Loaded;
use crate::contact::viscoelastic::Spectrum;
use crate::numerics::panelled::PanelledCurve;
use crate::shape::Profile;
use std::sync::Arc;

/// Panels finer than this part of the contact are put together: a contact of thousands of strips has
/// loads with thousands of kinks too faint to see.
const FINEST: f64 = 1.0 / 4096.0;

/// Borders beyond which that is done.
const MOST: usize = 8192;

/// Borders at least [`FINEST`] of the last one apart, the last one always among them.
fn thinned(ends: Vec<f64>) -> Vec<f64> {
    let Some(&last) = ends.last() else { return ends };
    let mut kept: Vec<f64> = Vec::new();
    for x in ends {
        if kept.last().is_none_or(|&before| x - before >= FINEST * last) {
            kept.push(x);
        }
    }
    kept.pop();
    kept.push(last);
    kept
}

/// The springs of a bed at one instant: what their Maxwell elements carry [N/m], or how far they are displaced [m] if
/// they are free.
struct Snapshot {
    spectrum: Arc<Spectrum>,
    profile: Arc<dyn Profile>,
    depth: f64,
    speed: f64,
    held: Vec<Strip>,
    free: Vec<Strip>,
}

/// The value at `x` of the strip that holds it, or of the last one.
fn among(strips: &[Strip], x: f64) -> Option<f64> {
    let k = strips.partition_point(|strip| strip.outer < x);
    Some(strips.get(k).or(strips.last())?.at(x))
}

impl Snapshot {
    fn edge(&self) -> f64 {
        self.held.last().map_or(0.0, |strip| strip.outer)
    }

    /// Line load q(x) [N/m].
    fn load(&self, x: f64) -> f64 {
        let elements = among(&self.held, x).filter(|_| x <= self.edge());
        elements.map_or(0.0, |s| self.spectrum.load(self.depth - self.profile.reduced(x), &[s], self.speed))
    }

    /// Displacement u(x) [m].
    fn displacement(&self, x: f64) -> f64 {
        if x < self.edge() { self.depth - self.profile.reduced(x) } else { among(&self.free, x).unwrap_or(0.0) }
    }
}

impl Memory {
    fn snapshot(&self) -> Snapshot {
        let spectrum = self.spectrum();
        let value = |spring: &Spring| match spring {
            Spring::Pressed(loads) => loads.iter().sum(),
            Spring::Free(free) => spectrum.recovered(free, 0.0),
        };
        let [held, free] = self.sides().map(|panels| panels.iter().map(|panel| panel.strip(value)).collect());
        let (depth, speed) = (self.indentation(), self.speed());
        Snapshot { spectrum, profile: self.profile(), depth, speed, held, free }
    }

    /// The contact as it is now, under the present load of its springs.
    #[must_use]
    pub fn loaded(&self) -> Loaded {
        let (ends, all) = (self.ends(true), self.ends(false));
        let (ends, all) = if all.len() > MOST { (thinned(ends), thinned(all)) } else { (ends, all) };
        let bed = Arc::new(self.snapshot());
        let same = bed.clone();
        let load = PanelledCurve::new(move |x| same.load(x), ends);
        let displacement = PanelledCurve::new(move |x| bed.displacement(x), all);
        Loaded::remembered(self.profile(), self.indentation(), load, displacement)
    }

    /// Pressure [Pa] at the radius `r` [m], see [`Loaded::pressure`].
    #[must_use]
    pub fn pressure(&self, r: f64) -> f64 {
        self.loaded().pressure(r)
    }

    /// Displacement [m] of the surface at the radius `r` [m], see [`Loaded::surface`].
    #[must_use]
    pub fn surface(&self, r: f64) -> f64 {
        self.loaded().surface(r)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::model::Loading;
    use crate::contact::viscoelastic::Spectrum;
    use crate::contact::viscoelastic::attraction::Attraction;
    use crate::input::quantity::Length;
    use crate::material::Relaxation;
    use crate::shape::Paraboloid;
    use std::f64::consts::FRAC_2_PI;

    /// At an edge that pulls the pressure falls without bound: the edge itself has none, and beside it is a pull.
    #[test]
    fn an_edge_that_pulls_has_no_pressure() {
        let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(2.0, 0.5)], viscosity: 0.0 };
        let (spectrum, ball) = (Arc::new(Spectrum::new(&relaxation)), Paraboloid { radius: Length::new(1.0).unwrap() });
        let attraction = Attraction::relaxed(1e-3, &spectrum);
        let mut bed = Memory::new(spectrum, Arc::new(ball)).with(attraction);
        bed.advance(0.01, 1.0).unwrap();
        let (loaded, a) = (bed.loaded(), bed.radius());
        assert!(loaded.pressure(a) == f64::NEG_INFINITY && loaded.pressure(a * (1.0 - 1e-9)) < 0.0);
        assert!(Loading::pressure(&loaded, a).is_none() && loaded.pressure(1.1 * a) == 0.0);
    }

    /// 10 mm and 4 MPa + 396 MPa at 1 ms, pressed 10 µm deep in 1000 s: stresses of the 80.5 kPa it carries by then,
    /// not of the 8 MPa of the modulus at once; so it yields nowhere at 0.1 MPa.
    #[test]
    fn stresses_are_those_of_the_present_load() {
        let relaxation = Relaxation { equilibrium: 4e6, terms: vec![(396e6, 1e-3)], viscosity: 0.0 };
        let ball = Arc::new(Paraboloid { radius: Length::new(0.01).unwrap() });
        let mut bed = Memory::new(Arc::new(Spectrum::new(&relaxation)), ball);
        bed.advance(1e-8, 1000.0).unwrap();
        let loaded = bed.loaded();
        let a = loaded.contact_radius();
        // The term holds E₁τ/E∞t = 1e-4 of the load, and of it at the apex half.
        let peak = FRAC_2_PI * 4e6 * a / 0.01;
        assert!((loaded.pressure(0.0) / peak - 1.0).abs() < 1.5e-4, "{}", loaded.pressure(0.0));
        for part in [1e-3, 0.3, 0.48, 1.0, 3.0] {
            let axial = -peak / (1.0 + part * part);
            let row = loaded.on_axis(part * a, 0.5);
            assert!((row.axial / axial - 1.0).abs() < 1.5e-4, "{part}: {}", row.axial);
        }
        assert!((loaded.force() / bed.force() - 1.0).abs() < 1e-9);
        assert!(2.0 * loaded.hardest(0.5).unwrap().shear < 0.1e6);
    }
}
