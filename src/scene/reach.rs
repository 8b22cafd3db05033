//! How deep a profile can be pressed: to its end, and while its contact stays in one piece.

use crate::input::problem::Problem;
use crate::numerics::root;
use crate::scene::history::{Driven, Entry, Motion};
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
            Beyond::SecondContact => format!(
                "{depth:.3e} m, from where on the contact would not stay simply connected: a ring touches outside it"
            ),
        }
    }
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
    Some(Bound { depth, load_integral, beyond: Beyond::End })
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
    !matches!(profile.rim(), Rim::End(end) | Rim::Wall(end) if r > end)
}

/// Gap at the radius `r` outside a contact of radius `a`.
fn gap(profile: &dyn Profile, r: f64, a: f64) -> f64 {
    profile.height(r) - profile.reduced(a) + profile.displacement_integral(r.max(a), a)
}

/// What is wrong with the depths and forces a history prescribes; `modulus` is E* [Pa] if the force
/// follows from the depth without adhesion and without relaxation.
#[must_use]
pub fn problems(
    bounds: &[Bound],
    modulus: Option<f64>,
    (history, motions): (&[Entry], &[Option<Motion>]),
) -> Vec<Problem> {
    let mut found = Vec::new();
    let mut depth = Some(0.0);
    for (index, (entry, motion)) in history.iter().zip(motions).enumerate() {
        if let Some(target) = target(entry, motion.as_ref(), depth) {
            found.extend(bounds.iter().find_map(|bound| beyond(&target, bound, modulus, index)));
        }
        depth = depth_after(entry, motion.as_ref(), depth);
    }
    found
}

/// A value that an entry prescribes.
struct Target {
    value: Value,
    /// Field of the entry, with a point.
    field: &'static str,
    /// Where in a table.
    row: String,
}

enum Value {
    Depth(f64),
    Force(f64),
}

fn target(entry: &Entry, motion: Option<&Motion>, depth: Option<f64>) -> Option<Target> {
    let plain = |value, field| Some(Target { value, field, row: String::new() });
    match (entry, motion) {
        (Entry::Indent(indent), _) => plain(Value::Depth(indent.to.si()), ".to"),
        (Entry::Press(press), _) => plain(Value::Force(press.to.si()), ".to"),
        (Entry::Oscillate(wave), _) => plain(Value::Depth(depth? + wave.amplitude.si()), ".amplitude"),
        (Entry::Table(path), Some(motion)) => {
            let (Driven::Indentation(values) | Driven::Force(values)) = &motion.control;
            let most = (0..values.len()).max_by(|&i, &j| values[i].total_cmp(&values[j]))?;
            let value = match &motion.control {
                Driven::Indentation(_) => Value::Depth(values[most]),
                Driven::Force(_) => Value::Force(values[most]),
            };
            Some(Target { value, field: "", row: format!("{}, row {}: ", path.display(), motion.rows[most]) })
        }
        _ => None,
    }
}

fn beyond(target: &Target, bound: &Bound, modulus: Option<f64>, index: usize) -> Option<Problem> {
    let what = match target.value {
        Value::Depth(depth) if depth > bound.depth => format!("{depth:e} m is deeper than"),
        Value::Force(force) if modulus.is_some_and(|modulus| force > 2.0 * modulus * bound.load_integral) => {
            format!("{force:e} N presses deeper than")
        }
        _ => return None,
    };
    let path = format!("history[{index}]{}", target.field);
    Some(Problem::new(path, format!("{}{what} {}", target.row, bound.in_words())))
}

/// The indentation after an entry, where it is known before the contact is computed.
fn depth_after(entry: &Entry, motion: Option<&Motion>, before: Option<f64>) -> Option<f64> {
    match (entry, motion.map(|motion| &motion.control)) {
        (Entry::Indent(indent), _) => Some(indent.to.si()),
        (Entry::Hold(_) | Entry::Slide(_) | Entry::Shake(_), _) => before,
        (Entry::Oscillate(wave), _) => {
            before.map(|depth| depth + wave.amplitude.si() * (std::f64::consts::TAU * wave.cycles.si().fract()).sin())
        }
        (Entry::Table(_), Some(Driven::Indentation(depths))) => depths.last().copied(),
        _ => None,
    }
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
