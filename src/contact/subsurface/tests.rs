//! The field against point loads, equilibrium and what is known at the surface and far away.

use super::StressField;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::foundation::Foundation;
use crate::contact::loaded::Loaded;
use crate::contact::punch::Stresses;
use crate::input::quantity::{Length, Positive};
use crate::numerics::quadrature;
use crate::shape::{
    Cone, FlatPunch, Paraboloid, Power, Profile, RoundedCone, RoundedPunch, Sphere, TruncatedCone, TruncatedParaboloid,
};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

fn length(metres: f64) -> Length {
    Length::new(metres).unwrap()
}

fn number(value: f64) -> Positive {
    Positive::new(value).unwrap()
}

/// Shapes of every kind whose contact of radius one is more than a flat.
fn shapes() -> Vec<Arc<dyn Profile>> {
    let (flat_radius, slope) = (length(0.6), number(0.2));
    vec![
        Arc::new(Paraboloid { radius: length(2.0) }),
        Arc::new(Sphere { radius: length(1.2) }),
        Arc::new(Cone { slope }),
        Arc::new(Power { coefficient: slope, exponent: number(1.4) }),
        Arc::new(RoundedCone { radius: length(3.0), slope }),
        Arc::new(RoundedPunch { flat_radius, edge_radius: length(1.0) }),
        Arc::new(TruncatedCone { flat_radius, slope }),
        Arc::new(TruncatedParaboloid { flat_radius, radius: length(1.0) }),
    ]
}

fn loaded(profile: Arc<dyn Profile>, edge: f64) -> Loaded {
    Loaded::elastic(Foundation::new(profile, 1.0), 1.0, edge)
}

/// σ_xx, σ_yy, σ_zz, τ_xz of a load of one newton at the origin, pressing (Boussinesq) or dragging along x (Cerruti):
/// Johnson 1985, eqs. 3.19 and 3.76.
fn point_load([x, y, z]: [f64; 3], poisson: f64, drag: f64) -> [f64; 4] {
    let r2 = x * x + y * y;
    let rho = (r2 + z * z).sqrt();
    let (n, sum) = (1.0 - 2.0 * poisson, rho + z);
    let spread = 1.0 / (rho * sum);
    let (radial, hoop) = (n * spread - 3.0 * z * r2 / rho.powi(5), -n * (spread - z / rho.powi(3)));
    let (c2, s2) = if r2 > 0.0 { (x * x / r2, y * y / r2) } else { (1.0, 0.0) };
    let pressed = [
        radial * c2 + hoop * s2,
        radial * s2 + hoop * c2,
        -3.0 * z.powi(3) / rho.powi(5),
        -3.0 * x * z * z / rho.powi(5),
    ];
    let along = x / rho.powi(3) - 3.0 * x / (rho * sum * sum)
        + x.powi(3) / (rho.powi(3) * sum * sum)
        + 2.0 * x.powi(3) / (rho * rho * sum.powi(3));
    let across = x / rho.powi(3) - x / (rho * sum * sum)
        + x * y * y / (rho.powi(3) * sum * sum)
        + 2.0 * x * y * y / (rho * rho * sum.powi(3));
    let dragged = [
        -3.0 * x.powi(3) / rho.powi(5) + n * along,
        -3.0 * x * y * y / rho.powi(5) + n * across,
        -3.0 * x * z * z / rho.powi(5),
        -3.0 * x * x * z / rho.powi(5),
    ];
    std::array::from_fn(|k| (pressed[k] + drag * dragged[k]) / TAU)
}

/// The pressure of a contact of radius one as point loads: trapezia about the axis, root ends along the radius.
fn by_point_loads(loaded: &Loaded, (x, z): (f64, f64), poisson: f64, drag: f64) -> [f64; 4] {
    const ANGLES: u32 = 240;
    let kink = loaded.profile().kink().filter(|&kink| kink < 1.0);
    // A kink has a logarithm in its pressure, of which short panels miss little.
    let about = kink.into_iter().flat_map(|kink| [-1e-2, -1e-4, 0.0, 1e-4, 1e-2].map(|away| kink + away));
    let ends: Vec<f64> = [0.0].into_iter().chain(about).chain([1.0]).collect();
    let ring = |r: f64, k: usize| {
        let turn = |step: u32| TAU * f64::from(step) / f64::from(ANGLES);
        let place = |angle: f64| [x - r * angle.cos(), r * angle.sin(), z];
        let sum: f64 = (0..ANGLES).map(|step| point_load(place(turn(step)), poisson, drag)[k]).sum();
        r * TAU / f64::from(ANGLES) * sum
    };
    std::array::from_fn(|k| {
        let panels = ends.windows(2).map(|pair| {
            let at = |inner: f64, outer: f64| {
                // The place from the nearer end, so that a root at it keeps its digits.
                let r = if inner < outer { pair[0] + inner } else { pair[1] - outer };
                loaded.pressure(r) * ring(r, k)
            };
            let third = (pair[1] - pair[0]) / 3.0;
            let middle = quadrature::panels(
                |r| loaded.pressure(r) * ring(r, k),
                (pair[0] + third, pair[1] - third),
                &[0.5 * (pair[0] + pair[1])],
            );
            let side = |low: f64| {
                quadrature::panel_with_root_ends(|inner, outer| at_side(&at, low, pair, (inner, outer), third), third)
            };
            middle + side(pair[0]) + side(pair[1] - third)
        });
        panels.sum()
    })
}

/// The integrand in a third of a panel that begins at `low`.
fn at_side(at: &impl Fn(f64, f64) -> f64, low: f64, pair: &[f64], (inner, outer): (f64, f64), third: f64) -> f64 {
    if low <= pair[0] { at(inner, 2.0 * third + outer) } else { at(2.0 * third + inner, outer) }
}

fn four(stress: Stresses) -> [f64; 4] {
    [stress.radial, stress.hoop, stress.axial, stress.shear]
}

/// Largest difference of two states of stress.
fn apart(one: [f64; 4], other: [f64; 4]) -> f64 {
    one.into_iter().zip(other).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(crate::laws::cases(24))]

    /// At random places at least a quarter of the contact deep, where trapezia converge to rounding; a pull at the edge too.
    #[test]
    fn the_field_is_that_of_point_loads(
        shape in 0usize..8, across in -200i32..200, down in 25i32..200, ratio in 0i32..50, drag in -5i32..6, pull in 0i32..2,
    ) {
        let loaded = loaded(shapes()[shape].clone(), -0.05 * f64::from(pull));
        let (x, z, poisson, drag) =
            (0.01 * f64::from(across), 0.01 * f64::from(down), 0.01 * f64::from(ratio), 0.1 * f64::from(drag));
        let field = loaded.field(poisson).dragged(drag);
        let x = if field.slides() { x } else { x.abs() };
        let right = by_point_loads(&loaded, (x, z), poisson, drag);
        let bound = 1e-7 * loaded.force().abs().max(0.01);
        prop_assert!(apart(four(field.at(x, z)), right) < bound, "{:?} {right:?}", field.at(x, z));
    }

    /// ∂σ_rr/∂r + ∂τ/∂z + (σ_rr − σ_θθ)/r = 0 and ∂τ/∂r + ∂σ_zz/∂z + τ/r = 0 by differences of fourth order.
    #[test]
    fn the_field_is_in_equilibrium(shape in 0usize..8, across in 10i32..200, down in 5i32..200, ratio in 0i32..50) {
        let loaded = loaded(shapes()[shape].clone(), -0.02);
        let field = loaded.field(0.01 * f64::from(ratio));
        let (r, z) = (0.01 * f64::from(across), 0.01 * f64::from(down));
        let h = 0.02 * z;
        let slope = |of: fn(&Stresses) -> f64, (u, v): (f64, f64)| {
            let at = |k: f64| of(&field.at(r + k * h * u, z + k * h * v));
            (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h)
        };
        let here = field.at(r, z);
        let out = slope(|s| s.radial, (1.0, 0.0)) + slope(|s| s.shear, (0.0, 1.0)) + (here.radial - here.hoop) / r;
        let down = slope(|s| s.shear, (1.0, 0.0)) + slope(|s| s.axial, (0.0, 1.0)) + here.shear / r;
        // The fifth derivative of a pole at the distance z: h⁴/z⁵ = 1.6e-7/z of the stress, with a factor of it.
        let bound = 3e-5 / z * (four(here).into_iter().map(f64::abs).fold(0.0, f64::max) + loaded.force().abs());
        prop_assert!(out.abs() < bound && down.abs() < bound, "{out:e} {down:e} {bound:e}");
    }

    /// Close to the surface σ_zz is minus the pressure and τ minus the drag; outside the contact both vanish. Away from the edges.
    #[test]
    fn the_surface_carries_the_pressure(
        shape in 0usize..8, across in prop_oneof![2i32..56, 65i32..95, 106i32..180], drag in 0i32..5,
    ) {
        let (r, drag) = (0.01 * f64::from(across), 0.1 * f64::from(drag));
        let loaded = loaded(shapes()[shape].clone(), -0.03);
        let stress = loaded.field(0.3).dragged(drag).at(r, 0.0);
        let (pressure, scale) = (loaded.pressure(r), 1e-7);
        prop_assert!((stress.axial + pressure).abs() < scale && (stress.shear + drag * pressure).abs() < scale);
    }

    /// Far away the contact is its force: a point load, to the square of a/R.
    #[test]
    fn far_away_it_is_a_point_load(shape in 0usize..8, away in 0i32..60, angle in 1i32..89) {
        let loaded = loaded(shapes()[shape].clone(), 0.01);
        let distance = 100.0 * 10f64.powf(0.1 * f64::from(away));
        let (sine, cosine) = f64::from(angle).to_radians().sin_cos();
        let (x, z) = (distance * sine, distance * cosine);
        let right = point_load([x, 0.0, z], 0.3, 0.2).map(|stress| loaded.force() * stress);
        let found = four(loaded.field(0.3).dragged(0.2).at(x, z));
        let bound = (20.0 / distance.powi(2) + 1e-12) * loaded.force() / distance.powi(2);
        prop_assert!(apart(found, right) < bound, "{found:?} {right:?}");
    }
}

/// A ball that slides: at the trailing edge σ_xx = p₀[(1 − 2ν)/3 + πμ(4 + ν)/8] (Hamilton 1983; Johnson 1985, §7.1(b)).
#[test]
fn the_trailing_edge_of_a_sliding_ball_is_torn() {
    for (poisson, drag) in [(0.3, 0.5), (0.0, 0.1), (0.5, 1.0)] {
        let loaded = loaded(Arc::new(Paraboloid { radius: length(2.0) }), 0.0);
        let torn = (1.0 - 2.0 * poisson) / 3.0 + PI * drag * (4.0 + poisson) / 8.0;
        let found = loaded.field(poisson).dragged(drag).at(-1.0, 0.0).radial / loaded.pressure(0.0);
        // σ leaves the edge as 4[μ + (1 − 2ν)/3]√(z/a), here at z = 1e-9 a.
        let rise = 4.0 * (drag + (1.0 - 2.0 * poisson) / 3.0) * 1e-9f64.sqrt();
        assert!((found - torn).abs() < 1.1 * rise, "{found} {torn}");
    }
}

/// Deep in the contact, at its edge and far away nothing is lost: a ball by pieces is the ball by its closed forms on
/// the axis, from 10⁻⁸ to 10⁸ radii.
#[test]
fn no_digits_are_lost_at_any_depth() {
    let loaded = loaded(Arc::new(Paraboloid { radius: length(2.0) }), 0.0);
    let (field, peak) = (loaded.field(0.3), loaded.pressure(0.0));
    for k in -80..=80 {
        let z = 10f64.powf(0.1 * f64::from(k));
        let axial = -peak / (1.0 + z * z);
        assert!(
            (field.at(0.0, z).axial / axial - 1.0).abs() < 1e-13,
            "{z}: {:e}",
            field.at(0.0, z).axial / axial - 1.0
        );
    }
}

/// An attraction of finite range: the surface carries its pressure too, inside and in the ring.
#[test]
fn the_ring_of_an_attraction_is_in_the_field() {
    let ground = Foundation::new(Arc::new(Paraboloid { radius: length(1.0) }), 1.0);
    let disc = RangeDisc::new(ground, 0.01, 0.2).unwrap();
    let balance = disc.at(0.6);
    assert!(balance.contact_radius > 0.1 && balance.contact_radius < 0.59);
    let loaded = Loaded::attracted(disc, balance);
    let field = loaded.field(0.3);
    for r in [0.02, 0.1, 0.3, 0.58, 0.65, 1.0] {
        if (r - balance.contact_radius).abs() < 0.01 {
            continue;
        }
        let axial = field.at(r, 0.0).axial;
        assert!((axial + loaded.pressure(r)).abs() < 1e-6, "{r} {axial} {}", loaded.pressure(r));
    }
}

/// Where the stress has no bound no hardest place is told.
#[test]
fn sharp_contacts_have_no_hardest_place() {
    let sharp: [Arc<dyn Profile>; 4] = [
        Arc::new(Cone { slope: number(0.1) }),
        Arc::new(TruncatedCone { flat_radius: length(0.5), slope: number(0.1) }),
        Arc::new(TruncatedParaboloid { flat_radius: length(0.5), radius: length(1.0) }),
        Arc::new(FlatPunch { radius: length(1.0) }),
    ];
    for (profile, edge) in sharp.into_iter().zip([0.0, 0.0, 0.0, 0.3]) {
        let field: StressField = loaded(profile.clone(), edge).field(0.3);
        assert!(field.hardest().is_none(), "{profile:?}");
    }
    assert!(loaded(Arc::new(Paraboloid { radius: length(1.0) }), -0.1).field(0.3).hardest().is_none());
}

/// No place of a fine map is harder than the hardest: below a ball, at rest and sliding, the rim of a rounded punch, and
/// beside the ring of an attraction.
#[test]
fn no_place_is_harder_than_the_hardest() {
    let ground = Foundation::new(Arc::new(Paraboloid { radius: length(1.0) }), 1.0);
    let disc = RangeDisc::new(ground, 0.01, 0.2).unwrap();
    let balance = disc.at(0.6);
    let rim = RoundedPunch { flat_radius: length(0.9), edge_radius: length(0.5) };
    let ball = || loaded(Arc::new(Paraboloid { radius: length(1.0) }), 0.0).field(0.3);
    let fields = [
        ball(),
        ball().dragged(0.25),
        ball().dragged(-0.6),
        loaded(Arc::new(rim), 0.0).field(0.2),
        Loaded::attracted(disc, balance).field(0.3),
    ];
    for (number, field) in fields.iter().enumerate() {
        let hardest = field.hardest().unwrap();
        let places = (-130..=130).flat_map(|k| (0..60).map(move |j| (0.01 * f64::from(k), 0.0002 * f64::from(j * j))));
        for (r, z) in places.filter(|(r, _)| *r >= 0.0 || field.slides()) {
            let there = field.at(r * field.scale(), z * field.scale()).von_mises();
            assert!(there <= hardest.von_mises * (1.0 + 1e-9), "{number}: {there} at {r} {z}, {hardest:?}");
        }
    }
}
