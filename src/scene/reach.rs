//! How deep a profile can be pressed: to its end, and while its contact stays in one piece.
//!
//! # Examples
//! ```
//! use springbed::input::quantity::Length;
//! use springbed::scene::reach;
//! use springbed::shape::{Paraboloid, Sphere};
//!
//! // A sphere ends at its equator; a paraboloid goes on for ever.
//! let sphere = reach::bounds(&Sphere { radius: Length::new(1.0)? }, false);
//! assert!(sphere[0].depth == 1.0 && sphere[0].in_words().contains("where the profile ends"));
//! assert!(reach::bounds(&Paraboloid { radius: Length::new(1.0)? }, false).is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::numerics::root;
use crate::shape::{Profile, Rim};

/// A bound to the indentation and the reason for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Largest indentation [m].
    pub depth: f64,
    /// ∫₀^a (g(a) − g(x)) dx [m²] at that depth: without adhesion the force is 2E* times it.
    pub load_integral: f64,
    /// What lies beyond it.
    pub beyond: Beyond,
}

/// What lies beyond a bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beyond {
    /// The profile has ended.
    End,
    /// The strips of a section are too wide for its datum, or all but meet.
    Strips,
    /// The wave lies flat.
    FullContact,
    /// The profile touches outside the contact first: it is no longer simply connected.
    SecondContact,
}

impl Bound {
    /// The bound in words.
    #[must_use]
    pub fn in_words(&self) -> String {
        let depth = self.depth;
        match self.beyond {
            Beyond::End => {
                format!("{depth:.3e} m, where the profile ends (the radius of a sphere, the last row of a table)")
            }
            Beyond::Strips => format!(
                "{depth:.3e} m, where the half width is 0.45 datum, or a wave carries 0.99 of the load that closes it"
            ),
            Beyond::FullContact => {
                format!("{depth:.3e} m, where the wave lies flat and no depth decides the force: expected Press(to: …)")
            }
            Beyond::SecondContact => format!(
                "{depth:.3e} m, from where on the contact would not stay simply connected: a ring touches outside it"
            ),
        }
    }
}

/// How deep a profile can be pressed. With adhesion the contact is held together.
#[must_use]
pub fn bounds(profile: &dyn Profile, adhesion: bool) -> Vec<Bound> {
    let second = if adhesion { None } else { second_contact(profile) };
    second.into_iter().chain(end(profile)).chain(full_contact(profile)).collect()
}

/// The indentation at which a wave lies flat: a force presses on, a depth goes no further.
fn full_contact(profile: &dyn Profile) -> Option<Bound> {
    let Rim::Wall(end) = profile.rim() else { return None };
    let bound = |depth| Bound { depth, load_integral: f64::INFINITY, beyond: Beyond::FullContact };
    profile.is_plane().then(|| bound(profile.reduced(end)))
}

/// The indentation at which the profile ends; `None` if it goes on for ever.
///
/// A sphere ends at its equator, which is reached at no finite depth of the half-space; its radius
/// is the bound.
#[must_use]
pub fn end(profile: &dyn Profile) -> Option<Bound> {
    let Rim::End(radius) = profile.rim() else { return None };
    let reduced = profile.reduced(radius);
    let (depth, load_integral) = if reduced.is_finite() {
        (reduced, profile.load_integral(radius))
    } else {
        (profile.height(radius), f64::INFINITY)
    };
    let beyond = if profile.is_plane() { Beyond::Strips } else { Beyond::End };
    Some(Bound { depth, load_integral, beyond })
}

/// Places at which the gap is looked at, near the contact and again farther out.
const GAPS: usize = 128;
/// Features of the profile that count as near.
const NEAR: f64 = 4.0;
/// Most pieces of a profile for which the gap is integrated.
const MOST_PIECES: usize = 200;

/// The indentation from which on a contact without adhesion is not simply connected.
///
/// The mapping holds while the gap outside the contact, f(r) − d + u(r), stays open. Where g grows
/// everywhere it does; where g falls between two places, the profile touches again outside at some
/// depth at which g is still growing at the edge. `None` for a profile whose g grows everywhere.
/// The bound is located to 1e-6 of itself; of a profile of very many pieces it is the least depth
/// at which g outside the contact has come down to the indentation, which is on the safe side.
/// Check: a wavy paraboloid of R = 1, h = 0.01, λ = 0.25 gives 3.127e-2.
#[must_use]
pub fn second_contact(profile: &dyn Profile) -> Option<Bound> {
    let turn = profile.first_fall()?;
    let places = outside(profile, turn);
    let least = places.iter().map(|&x| profile.reduced(x)).fold(profile.reduced(turn), f64::min);
    let safe = root::brent(|x| profile.reduced(x) - least, 0.0, turn).unwrap_or(0.0);
    let open = |a: f64| places.iter().all(|&r| gap(profile, r, a) > 0.0);
    let (mut low, mut high) = (safe, turn);
    while profile.breaks(turn).len() < MOST_PIECES && high - low > 1e-6 * high {
        let middle = 0.5 * (low + high);
        if open(middle) { low = middle } else { high = middle }
    }
    Some(Bound {
        depth: profile.reduced(low),
        load_integral: profile.load_integral(low),
        beyond: Beyond::SecondContact,
    })
}

/// Places outside a contact of radius `turn` at which the profile may touch next, finer near it.
fn outside(profile: &dyn Profile, turn: f64) -> Vec<f64> {
    let near = NEAR * profile.feature().unwrap_or(0.0);
    let far = 1.25 * profile.edge(profile.reduced(turn)).map_or(0.0, |outer| outer - turn);
    let spread = |reach: f64| (1..=GAPS).map(move |k| turn + reach * k as f64 / GAPS as f64);
    spread(near).chain(spread(far)).filter(|&r| inside(profile, r)).collect()
}

fn inside(profile: &dyn Profile, r: f64) -> bool {
    r <= profile.rim().radius()
}

/// Gap at the radius `r` outside a contact of radius `a`.
fn gap(profile: &dyn Profile, r: f64, a: f64) -> f64 {
    profile.height(r) - profile.reduced(a) + profile.displacement_integral(r.max(a), a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::{Amplitude, Length};
    use crate::shape::{Cone, Paraboloid, Sphere, WavyParaboloid};

    fn length(si: f64) -> Length {
        Length::new(si).unwrap()
    }

    fn wavy(amplitude: f64) -> WavyParaboloid {
        WavyParaboloid { radius: length(1.0), amplitude: Amplitude::new(amplitude).unwrap(), wavelength: length(0.25) }
    }

    #[test]
    fn profiles_with_growing_g_stay_in_one_piece() {
        assert_eq!(second_contact(&Paraboloid { radius: length(1.0) }), None);
        assert_eq!(second_contact(&Cone { slope: crate::input::quantity::Positive::new(0.1).unwrap() }), None);
        // g′ = 2x/R + … is positive everywhere if the waves are flat enough: h k² R ≪ 1.
        assert_eq!(second_contact(&wavy(1e-5)), None);
    }

    #[test]
    fn a_sphere_ends_at_its_radius() {
        let bound = end(&Sphere { radius: length(0.01) }).unwrap();
        assert_eq!((bound.depth, bound.beyond), (0.01, Beyond::End));
        assert_eq!(end(&Paraboloid { radius: length(1.0) }), None);
    }

    /// The gap of the solution for a contact of radius a, ∫ₐ^r (g(x) − g(a)) dx/√(r²−x²), by a plain
    /// sum in the angle: open just before the bound, closed somewhere just beyond.
    #[test]
    fn the_gap_outside_closes_at_the_bound() {
        let profile = wavy(0.01);
        let bound = second_contact(&profile).unwrap();
        let closest = |depth: f64| {
            let a = root::brent(|x| profile.reduced(x) - depth, 0.0, profile.first_fall().unwrap()).unwrap();
            let gap = |r: f64| {
                let from = (a / r).asin();
                let angle = |k: i32| from + (std::f64::consts::FRAC_PI_2 - from) * (f64::from(k) + 0.5) / 500.0;
                (0..500).map(|k| profile.reduced(r * angle(k).sin()) - depth).sum::<f64>()
            };
            (1..100).map(|k| gap(a * (1.0 + 0.04 * f64::from(k)))).fold(f64::INFINITY, f64::min)
        };
        assert!(closest(0.99 * bound.depth) > 0.0);
        assert!(closest(1.01 * bound.depth) < 0.0);
    }
}
