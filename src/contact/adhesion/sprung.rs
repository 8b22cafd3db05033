//! An equilibrium curve led through a spring in series: the far end of the spring is what is prescribed.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::equilibrium::{Control, Equilibrium};
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::foundation::Foundation;
//! use springbed::contact::adhesion::sprung::Sprung;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // R = E* = 1 at a = 1: d = 1 under F = 4/3, and a spring of k = 1/3 gives by 4.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let line = EdgeLine::new(ground, 0.0);
//! let sprung = Sprung { curve: &line, compliance: 3.0 };
//! assert!((sprung.value(Control::Indentation, 1.0) - 5.0).abs() < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::equilibrium::{Control, Equilibrium, Search};

/// An equilibrium curve behind a spring of the stiffness k = 1/c that a machine leads by its far end.
///
/// Prescribed is z = d + cF, with which a state is stable where dz/ds > 0: it is lost where dF/dd = −k, between the limits
/// of a prescribed depth (c = 0) and a prescribed force (c → ∞). Symbols: d indentation [m], F normal force [N], c
/// compliance [m/N], z way of the far end towards the ground [m]. Source: Johnson 1985, ch. 5.5; Maugis 2000, ch. 3.
/// Valid for slow motion: what a jump sets free is lost. Check: JKR's ball parts between −(5/6)πwR and −(3/2)πwR.
#[derive(Debug, Clone, Copy)]
pub struct Sprung<'c, C> {
    /// The contact alone.
    pub curve: &'c C,
    /// Compliance c of the spring [m/N].
    pub compliance: f64,
}

impl<C: Equilibrium> Sprung<'_, C> {
    fn with_spring(&self, control: Control, of: impl Fn(Control) -> f64) -> f64 {
        match control {
            Control::Indentation if self.compliance > 0.0 => of(control) + self.compliance * of(Control::Force),
            Control::Indentation | Control::Force => of(control),
        }
    }
}

impl<C: Equilibrium> Equilibrium for Sprung<'_, C> {
    fn value(&self, control: Control, s: f64) -> f64 {
        self.with_spring(control, |control| self.curve.value(control, s))
    }

    fn slope(&self, control: Control, s: f64) -> f64 {
        self.with_spring(control, |control| self.curve.slope(control, s))
    }

    fn known(&self, control: Control, target: f64) -> Option<f64> {
        if self.compliance > 0.0 { None } else { self.curve.known(control, target) }
    }

    fn start(&self) -> f64 {
        self.curve.start()
    }

    fn end(&self) -> f64 {
        self.curve.end()
    }

    fn scale(&self) -> f64 {
        self.curve.scale()
    }

    fn search(&self) -> Search {
        self.curve.search()
    }
}
