//! Balls that yield, with known answers.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::contact::model::{ContactModel, Pull, Straight};
use crate::contact::plastic::{PlasticContact, YieldingBall};
use crate::drive::impact::{PlasticPassage, Projectile};
use crate::numerics::quadrature;
use std::f64::consts::PI;

const ROUNDING: &str = "closed forms, some dozen roundings";

pub(super) const CASES: &[Case] = &[
    Case::new("plastic/restitution", Proof::Rounding, 1e-13, "Thornton 1997, with sixteen digits at v/v_y = 1 … 20")
        .weak("the model of the force is his, the way to e another: the energies of both ways")
        .by(restitution),
    Case::new("plastic/fast impacts", Proof::Bound, 1e-7, "e ∝ v^(−1/4), to a fifth of v_y/v = 1e-7")
        .weak("an exponent")
        .by(exponent),
    Case::new("plastic/heat of a loop", Proof::Rounding, 1e-11, "∫F dd by quadrature of the ways in and out")
        .weak("one depth; the property tests take any ball and depth")
        .by(heat),
    Case::new("plastic/pressed again", Proof::Rounding, 1e-13, ROUNDING)
        .weak("force and stiffness at the point where it was let go")
        .by(pressed_again),
];

/// R = 10 mm, E* = 200 GPa, p_y = 1.6 GPa.
const BALL: YieldingBall = YieldingBall { radius: 0.01, modulus: 2e11, limit: 1.6e9 };
const MASS: f64 = 0.03;

fn rebound(ratio: f64) -> f64 {
    let impact = Projectile { mass: MASS, speed: ratio * BALL.yield_speed(MASS) };
    PlasticPassage::new(BALL, impact).rebound().restitution
}

fn restitution() -> Attempt<Pairs> {
    let right = [
        (1.0, 1.0),
        (1.5, 0.971_239_411_072_467_1),
        (2.0, 0.930_625_877_273_653),
        (5.0, 0.773_336_898_970_150_1),
        (20.0, 0.557_108_666_503_75),
    ];
    Ok(right.into_iter().map(|(ratio, right)| (rebound(ratio), right)).collect())
}

fn exponent() -> Attempt<Pairs> {
    Ok(vec![((rebound(1e8) / rebound(1e7)).log10(), -0.25)])
}

fn heat() -> Attempt<Pairs> {
    let (first, deepest) = (BALL.yield_depth(), 6.0 * BALL.yield_depth());
    let dent = BALL.let_go(deepest);
    let way_in = quadrature::panel_with_root_ends(|depth, _| BALL.force(depth), first)
        + quadrature::panel(|depth| BALL.force(depth), first, deepest);
    let way_out = quadrature::panel_with_root_ends(|rise, _| dent.force(dent.residual + rise), deepest - dent.residual);
    // As Thornton writes the force of first yield.
    let force = PI.powi(3) * BALL.radius.powi(2) * BALL.limit.powi(3) / (6.0 * BALL.modulus.powi(2));
    Ok(vec![(BALL.heat(deepest), way_in - way_out), (BALL.force(first), force)])
}

fn pressed_again() -> Attempt<Pairs> {
    let mut contact = PlasticContact::new(BALL);
    let deepest = 6.0 * BALL.yield_depth();
    contact.follow(&Straight::between(0.0, deepest, 1.0))?;
    contact.follow(&Straight::between(deepest, 0.0, 1.0))?;
    let pull = Pull { force: BALL.force(deepest), slide: 0.0, sliding_speed: 0.0, duration: 1.0 };
    contact.press(&pull).ok_or("no force")??;
    let state = contact.state();
    Ok(vec![
        (state.indentation.unwrap_or(f64::NAN), deepest),
        (state.contact_radius.unwrap_or(f64::NAN), (BALL.radius * deepest).sqrt()),
        (state.dissipated, BALL.heat(deepest)),
    ])
}
