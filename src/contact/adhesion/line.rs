//! Attraction of vanishing range on any profile, by Heß's rule.

use super::equilibrium::{Balance, Control, Equilibrium, Search};
use crate::contact::foundation::HalfSpace;
use crate::shape::Rim;
use std::f64::consts::PI;

/// Equilibrium of a contact whose edge carries the work of adhesion w, w = 0 included.
///
/// The edge springs hold until stretched by Δl(a) = √(2πaw/E*) (Heß 2010; Popov & Heß 2015,
/// eq. 4.18), so d = g(a) − Δl(a) and F = 2E*(N(a) − aΔl(a)). With w = 0 it is the contact without
/// adhesion, to the bit. Symbols: a contact radius [m], w work of adhesion [J/m²], E* effective
/// modulus [Pa]. Check: R = E* = w = 1 parts at d = −1.608772047833270 under displacement control.
#[derive(Debug, Clone)]
pub struct EdgeLine {
    ground: HalfSpace,
    work: f64,
}

/// Energy of a contact [J]: elastic energy of the bodies and energy of the closed surface.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// Elastic energy, U = E*∫(d−g)² dx over the contact.
    pub elastic: f64,
    /// Energy of the surfaces, −wπa² for attraction of vanishing range.
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
    pub fn new(ground: HalfSpace, work: f64) -> Self {
        Self { ground, work }
    }

    /// What the indenter is pressed into.
    #[must_use]
    pub fn ground(&self) -> &HalfSpace {
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
        (2.0 * PI * a * (self.work / self.ground.modulus())).sqrt()
    }

    /// The state at the contact radius `a` [m] in equilibrium.
    #[must_use]
    pub fn at(&self, a: f64) -> Balance {
        self.under_wall(a, self.value(Control::Indentation, a))
    }

    /// The state of a contact of radius `a` whose indentation is `d`, in equilibrium or held by a wall.
    #[must_use]
    pub fn under_wall(&self, a: f64, d: f64) -> Balance {
        let edge = d - self.ground.profile().reduced(a);
        let force = 2.0 * self.ground.modulus() * (self.ground.profile().load_integral(a) + a * edge);
        Balance { contact_radius: a, reach: a, indentation: d, force }
    }

    /// Indentation [m] at which a contact of radius `a` [m], held by a wall, carries the force [N].
    #[must_use]
    pub fn indentation_under_wall(&self, a: f64, force: f64) -> f64 {
        self.ground.profile().reduced(a)
            + (0.5 * force / self.ground.modulus() - self.ground.profile().load_integral(a)) / a
    }

    /// Energy of a contact of radius `a` [m] whose edge springs are compressed by `edge` [m].
    #[must_use]
    pub fn energy(&self, a: f64, edge: f64) -> Energy {
        let (n, m) = (self.ground.profile().load_integral(a), self.ground.profile().energy_integral(a));
        Energy {
            elastic: self.ground.modulus() * (m + 2.0 * edge * n + a * edge * edge),
            surface: -self.work * PI * a * a,
        }
    }
}

impl Equilibrium for EdgeLine {
    fn value(&self, control: Control, a: f64) -> f64 {
        let elongation = self.elongation(a);
        match control {
            Control::Indentation => self.ground.profile().reduced(a) - elongation,
            Control::Force => 2.0 * self.ground.modulus() * (self.ground.profile().load_integral(a) - a * elongation),
        }
    }

    fn slope(&self, control: Control, a: f64) -> f64 {
        let (slope, elongation) = (self.ground.profile().reduced_slope(a), self.elongation(a));
        match control {
            Control::Indentation => slope - 0.5 * elongation / a,
            Control::Force => 2.0 * self.ground.modulus() * (a * slope - 1.5 * elongation),
        }
    }

    fn start(&self) -> f64 {
        if self.work > 0.0 { 0.0 } else { self.ground.profile().flat_radius() }
    }

    fn end(&self) -> f64 {
        match self.ground.profile().rim() {
            Rim::None => f64::INFINITY,
            Rim::Wall(end) | Rim::End(end) => end,
        }
    }

    fn scale(&self) -> f64 {
        self.ground.profile().scale()
    }

    fn search(&self) -> Search {
        match (self.ground.profile().feature(), self.ground.profile().kink()) {
            _ if self.work <= 0.0 => Search::Nowhere,
            (Some(length), _) => Search::Spaced(length),
            (None, Some(kink)) => Search::About(kink),
            (None, None) => Search::Once,
        }
    }
}
