//! Creep of a contact that only grows: the exact answer to a prescribed force.
//!
//! # Examples
//! ```
//! use springbed::contact::creep::Creep;
//! use springbed::material::{Relaxation, Spectrum};
//! use springbed::shape::Paraboloid;
//! use springbed::input::quantity::Length;
//! use std::sync::Arc;
//!
//! // A Maxwell body, E = τ = 1, under a constant force: a³ = (3R/4)F·J(t) with J = 1 + t.
//! let body = Spectrum::new(&Relaxation { equilibrium: 0.0, terms: vec![(1.0, 1.0)], viscosity: 0.0 });
//! let ball = Arc::new(Paraboloid { radius: Length::new(1.0)? });
//! let after = Creep::new(Arc::new(body), ball).after(0.1, 0.0).after(0.1, 3.0);
//! let (_, radius) = after.indented().unwrap();
//! assert!((radius.powi(3) / (0.75 * 0.1 * 4.0) - 1.0).abs() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::material::Spectrum;
use crate::numerics::exponential::{decay, square_remainder};
use crate::numerics::root;
use crate::shape::Profile;
use std::sync::Arc;

/// Contact under a force that never falls, from the first touch on; on a dashpot alone under any that presses.
///
/// N(a(t)) = ½ ∫ J(t−s) dF(s), with J the creep compliance [1/Pa] and N = ∫₀^a (g(a) − g) dx (Lee &
/// Radok 1960, inverted); for a paraboloid a³ = (3R/4) ∫ J dF. As long as F does not fall, N grows,
/// and so does the contact. No step in time is involved.
#[derive(Debug, Clone)]
pub struct Creep {
    spectrum: Arc<Spectrum>,
    profile: Arc<dyn Profile>,
    force: f64,
    /// Retarded parts ∫ Jₘ(1 − e^(−(t−s)/λₘ)) dF [m²].
    retarded: Vec<f64>,
    /// Flow of a liquid, ∫ F dt/η₀ [m²].
    flow: f64,
}

impl Creep {
    /// Bodies just touching.
    #[must_use]
    pub fn new(spectrum: Arc<Spectrum>, profile: Arc<dyn Profile>) -> Self {
        let retarded = vec![0.0; spectrum.modes().len()];
        Self { spectrum, profile, force: 0.0, retarded, flow: 0.0 }
    }

    /// The contact after the force has gone linearly to `force` [N] in `duration` [s].
    #[must_use]
    pub fn after(&self, force: f64, duration: f64) -> Self {
        let mut next = self.clone();
        next.flow += 0.5 * (force + self.force) * duration * self.spectrum.fluidity();
        for (mode, y) in self.spectrum.modes().iter().zip(&mut next.retarded) {
            // ẏ = (J F − y)/λ: the constant part of F, and its rise, which lags behind.
            let y_end = duration / mode.time;
            let (kept, lost) = decay(y_end);
            let rise = if y_end > 0.0 { square_remainder(y_end, lost) / y_end } else { 0.0 };
            *y = kept * *y + mode.compliance * (self.force * lost + (force - self.force) * rise);
        }
        next.force = force;
        next
    }

    /// Whether the contact grows until the force has gone linearly to `force` [N]: it does not fall, or presses a dashpot
    /// alone, which gives way to any force and takes nothing back.
    #[must_use]
    pub fn grows_until(&self, force: f64) -> bool {
        let gives_nothing_back = self.spectrum.modes().is_empty() && self.spectrum.glass_compliance() <= 0.0;
        force >= self.force || gives_nothing_back && force >= 0.0
    }

    /// Normal force [N].
    #[must_use]
    pub fn force(&self) -> f64 {
        self.force
    }

    /// Indentation [m]; `None` if the contact would outgrow the profile.
    #[must_use]
    pub fn indentation(&self) -> Option<f64> {
        let sum = self.force * self.spectrum.glass_compliance() + self.retarded.iter().sum::<f64>() + self.flow;
        depth_of_load(self.profile.as_ref(), 0.5 * sum)
    }

    /// Indentation and the place at which the bed ends [m]; `None` if the contact would outgrow the profile.
    #[must_use]
    pub fn indented(&self) -> Option<(f64, f64)> {
        let depth = self.indentation()?;
        Some((depth, self.profile.edge(depth).filter(|_| depth > 0.0).unwrap_or(0.0)))
    }

    /// The shape of the indenter.
    #[must_use]
    pub fn profile(&self) -> &dyn Profile {
        self.profile.as_ref()
    }
}

/// Part of a load by which a root may miss it: at a profile's end it misses by much more.
const MET: f64 = 1e-6;

/// The indentation d at which ∫₀^a (d − g) dx = `load` [m²] without adhesion.
fn depth_of_load(profile: &dyn Profile, load: f64) -> Option<f64> {
    if load <= 0.0 {
        return Some(0.0);
    }
    let residual = |d: f64| {
        let a = profile.edge(d)?;
        Some(profile.load_integral(a) + a * (d - profile.reduced(a)) - load)
    };
    let mut high = profile.reduced(profile.scale()).clamp(1e-100, 1e100);
    while residual(high).is_some_and(|rest| rest < 0.0) {
        high *= 4.0;
    }
    let mut low = high;
    while low > 0.0 && residual(low).is_none_or(|rest| rest > 0.0) {
        (low, high) = (0.25 * low, low);
    }
    let depth = root::brent(|d| residual(d).unwrap_or(load), low, high).ok()?;
    // At the end of a profile a search ends where the load is not met.
    residual(depth).filter(|rest| rest.abs() <= MET * load).map(|_| depth)
}
