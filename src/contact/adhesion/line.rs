//! Attraction of vanishing range on any profile, by Heß's rule.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // R = E* = w = 1 at a = 1: the edge springs are pulled by √(2πaw/E*), d = a²/R − √(2πaw/E*).
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let edge = EdgeLine::new(ground, 1.0);
//! assert!((edge.elongation(1.0) - (2.0 * std::f64::consts::PI).sqrt()).abs() < 1e-15);
//! assert!((edge.at(1.0).indentation - (1.0 - edge.elongation(1.0))).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::equilibrium::{Balance, Control, Equilibrium, Search};
use crate::contact::foundation::Foundation;
use crate::shape::Rim;

/// Equilibrium of a contact whose edge carries the work of adhesion w, w = 0 included.
///
/// The edge springs hold until stretched by Δl(a), on a half-space √(2πaw/E*) (Heß 2010; Popov & Heß
/// 2015, eq. 4.18), so d = g(a) − Δl(a) and F = 2E*(N(a) − aΔl(a)) (see
/// [`Foundation`]). With w = 0 it is the contact without adhesion, to the bit. Symbols: a contact
/// radius [m], w work of adhesion [J/m²], E* effective modulus [Pa]. Check: R = E* = w = 1 parts at d = −1.608772047833270 under displacement control.
#[derive(Debug, Clone)]
pub struct EdgeLine {
    ground: Foundation,
    work: f64,
}

/// Energy of a contact [J]: elastic energy of the bodies and energy of the closed surface.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// Elastic energy, U = E*∫(d−g)² dx over the contact.
    pub elastic: f64,
    /// Energy of the surfaces, −wA for attraction of vanishing range, A = πa².
    pub surface: f64,
}

impl Energy {
    /// Sum of the contributions [J].
    #[must_use]
    pub fn stored(&self) -> f64 {
        self.elastic + self.surface
    }
}

impl EdgeLine {
    /// A contact on `ground` with the work of adhesion w [J/m²].
    #[must_use]
    pub fn new(ground: Foundation, work: f64) -> Self {
        Self { ground, work }
    }

    /// What the indenter is pressed into.
    #[must_use]
    pub fn ground(&self) -> &Foundation {
        &self.ground
    }

    /// Work of adhesion w [J/m²].
    #[must_use]
    pub fn work(&self) -> f64 {
        self.work
    }

    /// Δl(a) [m], the elongation at which the edge springs part.
    #[must_use]
    pub fn elongation(&self, a: f64) -> f64 {
        self.ground.elongation(a, self.work)
    }

    /// The state at the contact radius `a` [m] in equilibrium.
    #[must_use]
    pub fn at(&self, a: f64) -> Balance {
        self.under_wall(a, self.value(Control::Indentation, a))
    }

    /// The state of a contact of radius `a` whose indentation is `d`, in equilibrium or held by a wall.
    #[must_use]
    pub fn under_wall(&self, a: f64, d: f64) -> Balance {
        let force = self.ground.force(a, d - self.ground.depth(a));
        Balance { contact_radius: a, reach: a, indentation: d, force }
    }

    /// Indentation [m] at which a contact of radius `a` [m], held by a wall, carries the force [N].
    #[must_use]
    pub fn indentation_under_wall(&self, a: f64, force: f64) -> f64 {
        self.ground.depth(a) + self.ground.edge_under(a, force)
    }

    /// Energy of a contact of radius `a` [m] at the indentation `d` [m].
    #[must_use]
    pub fn energy(&self, a: f64, d: f64) -> Energy {
        let elastic = self.ground.energy(a, d - self.ground.depth(a));
        Energy { elastic, surface: -self.work * self.ground.profile().contact_area(a) }
    }
}

/// Decades below the scale of a section in which its strips have a width that a number can tell.
const FIRST_STRIPS: f64 = 1.5;

impl Equilibrium for EdgeLine {
    fn value(&self, control: Control, a: f64) -> f64 {
        let elongation = self.elongation(a);
        match control {
            Control::Indentation => self.ground.depth(a) - elongation,
            Control::Force => self.ground.force(a, -elongation),
        }
    }

    fn slope(&self, control: Control, a: f64) -> f64 {
        let ground = &self.ground;
        let (slope, elongation, growth) = (ground.depth_slope(a), self.elongation(a), ground.elongation_growth(a));
        match control {
            Control::Indentation => slope - growth * elongation / a,
            Control::Force => 2.0 * ground.modulus() * (a * slope - (1.0 + growth) * elongation),
        }
    }

    fn known(&self, control: Control, target: f64) -> Option<f64> {
        let profile = self.ground.profile();
        let rises = self.work <= 0.0 && profile.rim() == Rim::None && profile.first_fall().is_none();
        if rises && control == Control::Indentation { profile.edge(target) } else { None }
    }

    fn start(&self) -> f64 {
        if self.work > 0.0 { 0.0 } else { self.ground.profile().flat_radius() }
    }

    fn end(&self) -> f64 {
        self.ground.profile().rim().radius()
    }

    fn scale(&self) -> f64 {
        self.ground.profile().scale()
    }

    fn search(&self) -> Search {
        match (self.ground.profile().feature(), self.ground.profile().kink()) {
            _ if self.work <= 0.0 => Search::Nowhere,
            // The strips of a wave: pulled in, and again where they all but meet.
            _ if self.ground.profile().is_plane() && self.end().is_finite() => {
                Search::Decades(FIRST_STRIPS, (self.end() / self.scale()).log10())
            }
            (Some(length), _) => Search::Spaced(length),
            (None, Some(kink)) => Search::About(kink),
            (None, None) => Search::Once,
        }
    }
}
