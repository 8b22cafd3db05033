//! Where a computed contact leaves the assumptions of the half-space, with numbers.

use super::record::{ErrorEstimate, Record};
use crate::contact::elliptic;
use crate::contact::inward::left_out;
use crate::contact::rough::RoughBed;
use crate::scene::law::ElasticAdhesion;
use crate::scene::plan::{HalfSpacePlan, Plan, RoughImpactPlan, RoughPlan, Shared};
use crate::scene::surface::Source;
use crate::shape::rough::RoughLine;
use crate::shape::{Moved, Profile, Shape, Sphere};
use std::f64::consts::{PI, SQRT_2};

/// Slope of the indenter at the edge beyond which the half-space is doubtful.
const STEEP: f64 = 0.3;
/// Slope below which nothing is left out that is worth a word.
const FLAT: f64 = 0.02;
/// Part of the force that is worth a word.
const LEFT_OUT: f64 = 0.01;
/// Relative difference between a paraboloid and the ball it stands for that is worth a word.
const BALL: f64 = 0.01;
/// Range of the attraction assumed for the Tabor parameter [m], an atomic distance.
const ATOMIC_RANGE: f64 = 0.3e-9;

/// Heat taken back, as a part of the largest elastic energy, that is worth a word.
const TAKEN_BACK: f64 = 1e-2;

/// The physics a user must know about the records of a scene.
#[must_use]
pub fn of(plan: &Plan, records: &[Record]) -> Vec<String> {
    let mut warnings = of_kind(plan, records);
    warnings.extend(power_law(plan, records));
    warnings.extend(taken_back(plan, records));
    warnings
}

/// Heat that comes back: an edge that holds by E∞ takes more of the springs than a quick pull has put into them.
///
/// A spring that leaves moves by Q/E∞ under its load Q, its Maxwell elements at the loads s they have: their dashpots then do
/// the work −ΣsQ/E∞, which is above zero where the pull has stretched them (s < 0) faster than they relax.
fn taken_back(plan: &Plan, records: &[Record]) -> Option<String> {
    let relaxation = plan.relaxation().filter(|_| plan.adheres())?;
    let (mut most, mut fall, mut at) = (f64::NEG_INFINITY, 0.0, 0.0);
    for record in records {
        most = most.max(record.normal.dissipated);
        if most - record.normal.dissipated > fall {
            (fall, at) = (most - record.normal.dissipated, record.time);
        }
    }
    let stored = records.iter().map(|record| record.normal.stored.elastic.abs()).fold(0.0, f64::max);
    // A dashpot has no instantaneous modulus.
    let rule =
        if relaxation.viscosity > 0.0 { "" } else { ", or edge: Instantaneous, which keeps the balance at any speed" };
    (fall > TAKEN_BACK * stored).then(|| {
        format!(
            "heat of {fall:.2e} J is taken back until {at:.6e} s: an edge held by the relaxed modulus draws the work of adhesion from springs that a pull faster than their relaxation has stretched, more than they hold, and dissipated_j is too small by as much; expected a slower pull{rule}"
        )
    })
}

/// What a power law does not say: its stiffness at once, and its force behind the times its series is laid out over.
fn power_law(plan: &Plan, records: &[Record]) -> Vec<String> {
    let Some(times) = plan.times() else { return Vec::new() };
    let at_once = format!(
        "a power law is infinitely stiff at once: stiffness_n_per_m is that against a motion of {:.1e} s, a tenth of the shortest step, and grows as steps get shorter",
        times.shortest
    );
    let end = records.last().map_or(0.0, |record| record.time);
    let late = (end > times.longest * (1.0 + 1e-9)).then(|| {
        format!(
            "the history took {end:.3e} s, longer than the {:.3e} s over which the series of the power law is laid out: what comes after is too stiff; expected a retraction from a prescribed depth, or a table",
            times.longest
        )
    });
    [at_once].into_iter().chain(late).collect()
}

fn of_kind(plan: &Plan, records: &[Record]) -> Vec<String> {
    match plan {
        Plan::Round(of) => round(plan, of.ground().profile(), records),
        Plan::Impact(of) => round(plan, of.ground().profile(), records),
        Plan::Pad(_) => Vec::new(),
        Plan::Plane(plan) => steep_waves(plan.section.rms_slope()).into_iter().collect(),
        Plan::Rough(rough) | Plan::RoughImpact(RoughImpactPlan { rough, .. }) => {
            let steep = steep_waves(rough.surface.roughness().rms_slope);
            let closed = crushed(rough, records).or_else(|| flattened(rough, records));
            [steep, closed].into_iter().flatten().collect()
        }
        Plan::HalfSpace(of) => on_pixels(of, records),
    }
}

/// Mean pressures, in E* times the rms slope, above which a rough flat touches all over: three standard deviations of what closes
/// the gap, ½E*h′ (Persson 2001), which leave 0.3 % of it.
const CLOSED: f64 = 1.5;

/// A rough flat pressed so hard that no gap is left, of which its bed knows nothing.
fn crushed(plan: &RoughPlan, records: &[Record]) -> Option<String> {
    let slope = plan.surface.roughness().rms_slope;
    if plan.base.is_some() || slope <= 0.0 {
        return None;
    }
    let area = match &plan.surface.source {
        Source::Map(map) => map.sides().0 * map.sides().1,
        Source::Spectrum(_) => plan.surface.length().powi(2),
    };
    let most = records.iter().map(|record| record.normal.force).fold(0.0, f64::max) / area;
    let closing = CLOSED * plan.pair.normal * slope;
    (most > closing).then(|| {
        format!(
            "the mean pressure reaches {most:.2e} Pa, and at {closing:.2e} Pa, 1.5 E* times the rms slope, the whole area touches: the bed, whose springs stay apart, has left its meaning, expected less force, or solver: HalfSpace()"
        )
    })
}

/// A rough flat whose line is pressed so deep that all of its springs touch, as they do long before the surface does.
fn flattened(plan: &RoughPlan, records: &[Record]) -> Option<String> {
    let surface = &plan.surface;
    let deepest = records.iter().filter_map(|record| record.normal.indentation).fold(0.0, f64::max);
    // From the first to the last it is no less than twice the rms height of the line, which may be less than the surface's.
    if plan.base.is_some() || deepest <= surface.roughness().rms_height {
        return None;
    }
    let last = |&seed: &u64| {
        let line = RoughLine::new(&surface.rings, seed);
        RoughBed::under(&line, surface.points, plan.pair.normal, |_| 0.0).ok()?.heights().last().copied()
    };
    let least = surface.seeds.iter().filter_map(last).reduce(f64::min)?;
    (deepest >= least).then(|| {
        format!(
            "at the indentation {least:.3e} m the last spring of the line touches: from there on its stiffness is that of all of them and grows no more, long before the whole area touches, expected less depth, or solver: HalfSpace()"
        )
    })
}

/// Slopes on pixels, and of a tip what it stands for.
fn on_pixels(plan: &HalfSpacePlan, records: &[Record]) -> Vec<String> {
    if let Some(surface) = plan.surface() {
        return steep_waves(surface.roughness().rms_slope).into_iter().collect();
    }
    let radii = records.iter().filter_map(|record| record.normal.contact_radius);
    let (Some(a), Some(profile)) = (radii.max_by(f64::total_cmp), plan.profile()) else { return Vec::new() };
    [steep(plan, profile, a), not_a_ball(plan, a), not_two_balls(plan, a)].into_iter().flatten().collect()
}

fn round(plan: &Plan, profile: &dyn Profile, records: &[Record]) -> Vec<String> {
    let radii = records.iter().filter_map(|record| record.normal.contact_radius);
    let Some(a) = radii.max_by(f64::total_cmp) else { return Vec::new() };
    let shape =
        [steep(plan, profile, a), not_a_ball(plan, a), not_two_balls(plan, a), two_radii(plan), connected(profile, a)];
    let shape = shape.into_iter().chain([profile.moved().map(told_of_moved)]);
    shape.chain([tabor(plan), coupled(plan)]).flatten().collect()
}

/// What was done to a measured profile with noise.
fn told_of_moved(moved: Moved) -> String {
    format!(
        "the measured heights were made to rise, their slope over ln r too, so that the contact stays a circle: moved by {:.2e} m (root of the mean square), {:.2e} m at most",
        moved.rms, moved.largest
    )
}

/// Whether a body has a yield stress.
#[must_use]
pub fn can_yield(shared: &Shared) -> bool {
    let (one, other) = &shared.scene.bodies;
    one.yield_stress().or(other.yield_stress()).is_some()
}

/// Peak pressure of an ellipsoid over that of the paraboloid that stands for it, under the same force; `None` of other
/// shapes and where adhesion makes another contact of it.
#[must_use]
pub fn pressure_on_ellipse(plan: &Plan) -> Option<f64> {
    let (Shape::Ellipsoid(ellipsoid), None) = (&plan.scene.shape, &plan.scene.adhesion) else { return None };
    elliptic::peak_pressure_ratio([ellipsoid.radius_x.si(), ellipsoid.radius_y.si()]).ok()
}

/// The error of the shape: that of an ellipsoid's effective radius, or of what lies between the rows of a measured
/// profile at the largest contact of the records.
#[must_use]
pub fn error_of_shape(plan: &Plan, records: &[Record]) -> Option<ErrorEstimate> {
    let radii = records.iter().filter_map(|record| record.normal.contact_radius);
    let largest = radii.filter(|&a| a > 0.0).reduce(f64::max);
    let sampled = || {
        let profile = plan.profile()?;
        let relative = profile.sampling_error(profile.place(largest?));
        let basis = "profile between the rows of its table, against every other row".to_owned();
        Some(ErrorEstimate { relative, basis })
    };
    error_of_radius(plan).or_else(sampled)
}

/// The error of an ellipsoid's effective radius; with adhesion, where no elliptic contact is known, that of the peak
/// pressure too.
fn error_of_radius(shared: &Shared) -> Option<ErrorEstimate> {
    let Shape::Ellipsoid(ellipsoid) = &shared.scene.shape else { return None };
    let force = mean_radius_error(shared)?.abs();
    let pressure = match &shared.scene.adhesion {
        None => 0.0,
        Some(_) => {
            let ratio = elliptic::peak_pressure_ratio([ellipsoid.radius_x.si(), ellipsoid.radius_y.si()]).ok()?;
            1.0 - ratio.recip()
        }
    };
    let relative = force.max(pressure);
    let basis = "effective radius of the ellipsoid, against the elliptic Hertz contact".to_owned();
    Some(ErrorEstimate { relative, basis })
}

/// Relative error of the force of an ellipsoid that stands as a paraboloid; `None` of other shapes and below rounding.
fn mean_radius_error(shared: &Shared) -> Option<f64> {
    let Shape::Ellipsoid(ellipsoid) = &shared.scene.shape else { return None };
    let error = elliptic::mean_radius_error([ellipsoid.radius_x.si(), ellipsoid.radius_y.si()]);
    error.ok().filter(|error| error.abs() > 1e-6)
}

/// An rms slope beyond the linear theory of small slopes (Ceglie et al., section 4: a wave of amplitude 0.1 λ has
/// 0.44, where linear theory begins to differ from finite elasticity; one of 0.3 λ has 1.33, where finite
/// elasticity changes even the sign of the change of area on sliding).
fn steep_waves(rms_slope: f64) -> Option<String> {
    let of_wave = |aspect: f64| SQRT_2 * PI * aspect;
    if rms_slope <= of_wave(0.1) {
        return None;
    }
    Some(if rms_slope < of_wave(0.3) {
        format!(
            "rms slope {rms_slope:.2} is above 0.44, the edge of the small-slope theory (1.33 is far outside): expect deviations of real bodies"
        )
    } else {
        format!(
            "rms slope {rms_slope:.2} is far outside the small-slope theory (edge 0.44, far outside 1.33): do not trust forces or areas"
        )
    })
}

fn steep(shared: &Shared, profile: &dyn Profile, a: f64) -> Option<String> {
    if let Shape::PlaneWave(wave) = &shared.scene.shape {
        return steep_waves(wave.rms_slope());
    }
    let height = |radius: f64| profile.height(profile.place(radius));
    let slope = (height(a) - height(a * (1.0 - 1e-3))) / (1e-3 * a);
    if !(a > 0.0 && slope.is_finite() && slope > FLAT) {
        return None;
    }
    let left_out = if shared.scene.shape.is_plane() { None } else { left_out(&shared.scene.bodies, profile, a) };
    let told = left_out.filter(|error| error.abs() > LEFT_OUT).map(|error| {
        let (percent, way) = (100.0 * error.abs(), if error > 0.0 { "small" } else { "large" });
        format!("the force at a given depth is some {percent:.1} % too {way}, for the surface moves inwards too")
    });
    let begins = format!("the indenter's slope reaches {slope:.2} at the edge of the contact");
    match (told, slope > STEEP) {
        (Some(told), true) => Some(format!(
            "{begins}: the half-space assumes slopes well below one; to their first order {told}, their second is not known"
        )),
        (Some(told), false) => Some(format!("{begins}: {told}")),
        (None, true) => Some(format!(
            "{begins}: the half-space assumes slopes well below one; the error is of their second order and not known"
        )),
        (None, false) => None,
    }
}

/// A paraboloid stands for two spheres only while a is small against the smaller one.
fn not_two_balls(shared: &Shared, a: f64) -> Option<String> {
    let Shape::Spheres(spheres) = &shared.scene.shape else { return None };
    let part = a / spheres.radius_1.si().abs().min(spheres.radius_2.si().abs());
    // x artanh(x/R) = (x²/R)(1 + x²/3R² + …), in the force three fifths of it.
    let difference = 0.2 * part * part;
    (difference > BALL).then(|| {
        format!(
            "a/R = {part:.2} of the smaller sphere: the paraboloid that stands for both errs by some {:.0} % in the force",
            100.0 * difference
        )
    })
}

/// A paraboloid stands for a ball only while a ≪ R: the difference of the forces at equal a.
fn not_a_ball(shared: &Shared, a: f64) -> Option<String> {
    let Shape::Paraboloid(paraboloid) = &shared.scene.shape else { return None };
    let part = a / paraboloid.radius.si();
    let (one, other) = &shared.scene.bodies;
    let yields = one.hardness().or(other.hardness()).is_some();
    if part >= 1.0 {
        return Some(format!(
            "the contact radius is {part:.2} times the radius of curvature: no ball has such a contact"
        ));
    }
    let difference = Sphere { radius: paraboloid.radius }.load_integral(a) / paraboloid.load_integral(a) - 1.0;
    // A ball that yields is a paraboloid whatever it is called.
    (difference > BALL && !yields).then(|| {
        format!(
            "a/R = {part:.2}: if the paraboloid stands for a ball, use Sphere(radius: …), whose force at this contact radius is {:.1} % larger",
            100.0 * difference
        )
    })
}

/// The contact of an ellipsoid is an ellipse: what its effective radius costs.
fn two_radii(shared: &Shared) -> Option<String> {
    let Shape::Ellipsoid(ellipsoid) = &shared.scene.shape else { return None };
    Some(format!(
        "the ellipsoid stands as a paraboloid of the effective radius {:.4e} m: its force at a given indentation is {:.2} % too small; of the elliptic Hertz contact is the peak pressure alone, pressures over the radius are those of the paraboloid",
        ellipsoid.effective_radius(),
        -100.0 * mean_radius_error(shared)?
    ))
}

/// With adhesion the contact is taken to be connected even where the waves would part.
fn connected(profile: &dyn Profile, a: f64) -> Option<String> {
    let limit = profile.first_fall().filter(|&limit| a > limit)?;
    Some(format!(
        "beyond the radius {limit:.3e} m the one-dimensional profile falls: the contact is assumed to stay connected, which only adhesion can bring about (Guduru 2007)"
    ))
}

/// Tabor's parameter (Rw²/(E*²z₀³))^{1/3} of a round tip under attraction at its edge or outside it, with an atomic
/// range z₀ of 0.3 nm (Tabor 1977); `None` of others.
#[must_use]
pub fn tabor_parameter(plan: &Plan) -> Option<f64> {
    let (work, radius) = (plan.edge_work().or(work_outside(plan))?, plan.scene.shape.tip_radius()?);
    Some((radius * (work / plan.pair.normal).powi(2) / ATOMIC_RANGE.powi(3)).cbrt())
}

/// Work of adhesion [J/m²] of an attraction outside the contact.
fn work_outside(plan: &Plan) -> Option<f64> {
    match plan.direct()? {
        ElasticAdhesion::Outside { work } => Some(work),
        ElasticAdhesion::None
        | ElasticAdhesion::Vanishing { .. }
        | ElasticAdhesion::Finite { .. }
        | ElasticAdhesion::Fading { .. } => None,
    }
}

/// JKR needs more than 5, DMT less than 0.1.
fn tabor(plan: &Plan) -> Option<String> {
    let parameter = tabor_parameter(plan)?;
    if work_outside(plan).is_some() {
        return (parameter > 0.1).then(|| {
            format!(
                "Tabor parameter {parameter:.2} (range of attraction 0.3 nm): DMT holds below 0.1; use Maugis(work: …, stress: …), or Jkr(work: …) above 5"
            )
        });
    }
    (parameter < 5.0).then(|| {
        format!(
            "Tabor parameter {parameter:.2} (range of attraction 0.3 nm): JKR holds above 5; use Maugis(work: …, stress: …)"
        )
    })
}

fn coupled(plan: &Plan) -> Option<String> {
    plan.has_friction().then(|| dissimilar(plan)).flatten()
}

/// Friction of bodies that are not elastically similar.
pub(super) fn dissimilar(plan: &Shared) -> Option<String> {
    let beta = plan.pair.coupling;
    (beta.abs() > 1e-9).then(|| {
        format!(
            "the pair breaks elastic similarity (Dundurs' β = {beta:.3}): normal and tangential contact are treated as independent, expect errors of this order in friction; solver: HalfSpace(tractions: Coupled) finds both together under Coulomb(…)"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_judged_at_the_stated_limits() {
        assert_eq!(steep_waves(0.44), None);
        for (slope, words) in [(0.45, "0.45 is above 0.44"), (0.7, "0.70 is above 0.44"), (1.34, "1.34 is far outside")]
        {
            assert!(steep_waves(slope).is_some_and(|told| told.contains(words)));
        }
    }
}
