//! Adhesion: the models as a scene names them, their equilibria and the branches of these.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::{Adhesion, Jkr, Range};
//! use springbed::input::quantity::WorkOfAdhesion;
//!
//! let gel = Adhesion::Jkr(Jkr { work: WorkOfAdhesion::new(0.02)?, closing: None, edge: None });
//! assert_eq!((gel.traits().name, gel.traits().work), ("Jkr", 0.02));
//! assert_eq!(gel.traits().range, Range::Vanishing(None));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod dmt;
pub(super) mod elastic;
pub mod equilibrium;
pub mod line;
pub mod neck;
pub mod range;
pub mod sprung;

use crate::input::quantity::{ContactAngle, Length, Modulus, Positive, Speed, SurfaceTension, WorkOfAdhesion};
use serde::{Deserialize, Serialize};

/// Model of adhesion.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Adhesion {
    /// Johnson, Kendall & Roberts: attraction of vanishing range.
    Jkr(Jkr),
    /// Derjaguin, Muller & Toporov: an attraction outside the contact that bends nothing.
    Dmt(Dmt),
    /// Maugis–Dugdale: constant attractive stress up to a finite range.
    Maugis(Maugis),
    /// Attractive stress that falls exponentially with the gap.
    Exponential(Exponential),
    /// A liquid that condenses around the contact.
    Capillary(Capillary),
}

/// What a model of adhesion is, for all that must know.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AdhesionTraits<'a> {
    /// The name a scene gives it.
    pub name: &'static str,
    /// Work of adhesion w [J/m²].
    pub work: f64,
    /// Work of adhesion [J/m²] of a closing edge, where it is less.
    pub closing: Option<f64>,
    /// How far the attraction reaches.
    pub range: Range<'a>,
}

/// How far an attraction reaches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range<'a> {
    /// It acts at the edge alone; what holds an opening edge of a viscoelastic body.
    Vanishing(Option<&'a EdgeRule>),
    /// It acts outside the contact and is too weak to bend a surface there.
    Outside,
    /// It acts across the gap, with the attractive stress [Pa].
    Finite(f64),
    /// It fades across the gap by a factor e over this length [m].
    Fading(f64),
}

impl Adhesion {
    /// What the model is: the one place that knows every kind.
    #[must_use]
    pub fn traits(&self) -> AdhesionTraits<'_> {
        match self {
            Self::Jkr(jkr) => AdhesionTraits {
                name: "Jkr",
                work: jkr.work.si(),
                closing: jkr.closing.map(|closing| closing.si()).filter(|&closing| closing < jkr.work.si()),
                range: Range::Vanishing(jkr.edge.as_ref()),
            },
            Self::Dmt(Dmt { work }) => {
                AdhesionTraits { name: "Dmt", work: work.si(), closing: None, range: Range::Outside }
            }
            Self::Maugis(Maugis { work, stress }) => {
                AdhesionTraits { name: "Maugis", work: work.si(), closing: None, range: Range::Finite(stress.si()) }
            }
            Self::Exponential(Exponential { work, range }) => {
                AdhesionTraits { name: "Exponential", work: work.si(), closing: None, range: Range::Fading(range.si()) }
            }
            Self::Capillary(bridge) => AdhesionTraits {
                name: "Capillary",
                work: bridge.work(),
                closing: None,
                range: Range::Finite(bridge.suction()),
            },
        }
    }
}

/// Adhesion of vanishing range.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Jkr {
    /// Work of adhesion w [J/m²].
    pub work: WorkOfAdhesion,
    /// Work of adhesion [J/m²] of a closing edge, at most `work`, which it is unless given; with 0 the edge attaches
    /// where the bodies touch. Between the two limits the edge stands still.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub closing: Option<WorkOfAdhesion>,
    /// What holds the edge of a viscoelastic body; needed there, refused elsewhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<EdgeRule>,
}

/// What holds the edge of an adhesive contact of a viscoelastic body.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(rename = "Edge")]
pub enum EdgeRule {
    /// The relaxed modulus E∞: the process zone is long against the relaxation.
    Relaxed,
    /// The instantaneous modulus E(0): a process zone of length zero.
    Instantaneous,
    /// Gent & Schultz: the relaxed modulus and w·[1 + (v/v₀)ⁿ].
    Rate(Rate),
}

impl EdgeRule {
    /// The rule by which the edge of a viscoelastic contact holds, in words.
    #[must_use]
    pub fn in_words(&self) -> String {
        let held = match self {
            Self::Relaxed => "E_c = E*(∞), w_eff = w: the process zone is long against the relaxation".to_owned(),
            Self::Instantaneous => "E_c = E*(0), w_eff = w: the process zone has no length".to_owned(),
            Self::Rate(rate) => format!(
                "E_c = E*(∞), w_eff = w [1 + (v/v₀)ⁿ] with v₀ = {:e} m/s, n = {} (Gent & Schultz): a fast edge holds stronger",
                rate.speed.si(),
                rate.exponent.si()
            ),
        };
        format!(
            "an edge spring leaves at q² = A′E_c w_eff and joins where the bodies are √(A′w/E_c) apart, moved by E_c alone, with A′ = 2πa under a round contact and {held}"
        )
    }
}

/// Gent–Schultz law w_eff = w·[1 + (v/v₀)ⁿ] of an edge opening at the speed v.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Rate {
    /// Reference speed v₀ [m/s].
    pub speed: Speed,
    /// Exponent n.
    pub exponent: Positive,
}

/// Attraction outside the contact of hard bodies, which bends no surface: 2πwR of a paraboloid.
///
/// Symbols: w work of adhesion [J/m²], R radius of curvature [m]. The contact is that of Hertz under F + 2πwR. Source:
/// B. V. Derjaguin, V. M. Muller & Yu. P. Toporov, *J. Colloid Interface Sci.* 53 (1975) 314, as simplified by D. Maugis,
/// *J. Colloid Interface Sci.* 150 (1992) 243, eq. 17. Valid for a Tabor parameter below 0.1 (hard, small, weakly
/// adhering bodies) and for paraboloids alone: of other profiles the force depends on the range of the attraction.
/// Check: a ball of 10 nm with 0.05 J/m² is torn off by 3.14 nN.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Dmt {
    /// Work of adhesion w [J/m²].
    pub work: WorkOfAdhesion,
}

/// Constant attractive stress σ₀ up to the range w/σ₀.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Maugis {
    /// Work of adhesion w [J/m²].
    pub work: WorkOfAdhesion,
    /// Attractive stress σ₀ [Pa].
    pub stress: Modulus,
}

/// Attractive stress (w/ρ) e^(−g/ρ) across the gap g, the work of which is w; on the pixels of a half-space.
///
/// Symbols: w work of adhesion [J/m²], ρ range [m]. As ρ → 0 it becomes the attraction of vanishing range, and of hard bodies
/// 2πwR. Check: bodies that touch attract each other by w/ρ, 0.05 J/m² over 1 nm by 50 MPa.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Exponential {
    /// Work of adhesion w [J/m²].
    pub work: WorkOfAdhesion,
    /// Range ρ [m] over which the stress falls by a factor e.
    pub range: Length,
}

/// A bridge of liquid around the contact, in equilibrium with its vapour.
///
/// Wherever the gap is below 2r_K cos θ liquid has condensed, and under its curved surface is the pressure of Laplace,
/// σ₀ = γ/r_K below that of the vapour: the attraction of Maugis with w = 2γ cos θ. Symbols: γ surface tension [N/m],
/// θ contact angle on both bodies [rad], r_K Kelvin's radius [m], by which the surface bends at the humidity there is
/// (0.54 nm over the logarithm of the inverse humidity, for water at 20 °C). Source: D. Maugis, *Contact, Adhesion and
/// Rupture of Elastic Solids* (2000), ch. 4; Popov 2010, ch. 4.13. Not valid for a given amount of liquid, nor faster
/// than the vapour condenses; the attraction of the solids through the liquid is left out.
/// Check: a hard ball, θ = 0, is torn off by 4πγR.
///
/// ```
/// # use springbed::contact::adhesion::Capillary;
/// # use springbed::input::quantity::{ContactAngle, Length, SurfaceTension};
/// let water = Capillary {
///     tension: SurfaceTension::new(0.072)?,
///     angle: ContactAngle::new(0.0)?,
///     kelvin_radius: Length::new(1e-9)?,
/// };
/// assert_eq!((water.work(), water.height()), (0.144, 2e-9));
/// assert!((water.suction() - 72e6).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Capillary {
    /// Surface tension γ of the liquid [N/m].
    pub tension: SurfaceTension,
    /// Contact angle θ [rad], through the liquid, on both bodies.
    pub angle: ContactAngle,
    /// Kelvin's radius r_K [m] of the meniscus.
    pub kelvin_radius: Length,
}

impl Capillary {
    /// Work of adhesion w = 2γ cos θ [J/m²].
    #[must_use]
    pub fn work(&self) -> f64 {
        2.0 * self.tension.si() * self.angle.si().cos()
    }

    /// How much lower the pressure is in the liquid, σ₀ = γ/r_K [Pa].
    #[must_use]
    pub fn suction(&self) -> f64 {
        self.tension.si() / self.kelvin_radius.si()
    }

    /// Gap 2r_K cos θ [m] at the meniscus.
    #[must_use]
    pub fn height(&self) -> f64 {
        2.0 * self.kelvin_radius.si() * self.angle.si().cos()
    }
}
