//! Impact of a ball that yields, in closed form.

use super::{ImpactState, Projectile, Rebound};
use crate::contact::adhesion::line::Energy;
use crate::contact::plastic::{Dent, YieldingBall};
use crate::numerics::quadrature;
use std::f64::consts::FRAC_PI_2;

/// Relative error of what is computed: closed forms, a dozen roundings.
const ROUNDING: f64 = 1e-14;

/// An impact on a body that yields: Hertz's way in, a swing of the straight force, Hertz's way out over the dent.
///
/// Check (Thornton 1997): e = √(6√3/5) √(1 − q²/6) [q/(q + 2√(6/5 − q²/5))]^{1/4}, q = v_y/v < 1; e = 1 below v_y.
#[derive(Debug, Clone, Copy)]
pub struct PlasticPassage {
    ball: YieldingBall,
    impact: Projectile,
    deepest: f64,
    dent: Dent,
}

impl PlasticPassage {
    /// The impact of a mass; the energy W(d) = ½mv² gives the greatest depth.
    #[must_use]
    pub fn new(ball: YieldingBall, impact: Projectile) -> Self {
        let energy = impact.energy();
        let beyond = energy - ball.yield_work();
        let deepest = if beyond > 0.0 {
            let (force, stiffness) = (ball.yield_force(), ball.plastic_stiffness());
            ball.yield_depth() + 2.0 * beyond / (force + (force * force + 2.0 * stiffness * beyond).sqrt())
        } else {
            hertz_depth(&ball, energy)
        };
        Self { ball, impact, deepest, dent: ball.let_go(deepest) }
    }

    /// Greatest depth [m].
    #[must_use]
    pub fn deepest(&self) -> f64 {
        self.deepest
    }

    /// Speed of rebound [m/s].
    fn rebound_speed(&self) -> f64 {
        (2.0 * self.dent.stored(self.deepest) / self.impact.mass).sqrt()
    }

    /// How it ends.
    #[must_use]
    pub fn rebound(&self) -> Rebound {
        let back = self.dent.stored(self.deepest);
        Rebound {
            contact_time: Some(self.way_in(1.0) + self.swing().time(1.0) + self.way_out(1.0)),
            greatest_depth: self.deepest,
            greatest_force: self.dent.force(self.deepest),
            restitution: (self.rebound_speed() / self.impact.speed).min(1.0),
            lost: (self.impact.energy() - back).max(0.0),
            error: ROUNDING,
        }
    }

    /// Angle θ with d = d*sin^{4/5}θ, d* the depth at which Hertz's contact would have stopped the mass, where the elastic
    /// way in ends.
    fn last_angle(&self) -> f64 {
        let (elastic, least) = (self.elastic_depth(), self.ball.yield_depth());
        if least >= elastic { FRAC_PI_2 } else { (least / elastic).powf(1.25).asin() }
    }

    /// Depth [m] to which Hertz's contact alone would have been pressed.
    fn elastic_depth(&self) -> f64 {
        hertz_depth(&self.ball, self.impact.energy())
    }

    /// Time [s] of the part `part` of the angle of the elastic way in.
    fn way_in(&self, part: f64) -> f64 {
        self.elastic_depth() / self.impact.speed * time_to(part * self.last_angle())
    }

    /// Time [s] from rest to the part `part` of the angle of the way out.
    fn way_out(&self, part: f64) -> f64 {
        let whole = time_to(FRAC_PI_2);
        let scale = (self.deepest - self.dent.residual) / self.rebound_speed();
        scale * (whole - time_to((1.0 - part) * FRAC_PI_2))
    }

    /// The swing while it yields.
    fn swing(&self) -> Swing {
        let (force, stiffness, mass) = (self.ball.yield_force(), self.ball.plastic_stiffness(), self.impact.mass);
        let energy = self.impact.energy() - self.ball.yield_work();
        let speed = (2.0 * energy.max(0.0) / mass).sqrt();
        let frequency = (stiffness / mass).sqrt();
        let angle = (speed * stiffness).atan2(force * frequency);
        Swing { speed, frequency, rest: force / stiffness, angle: if energy > 0.0 { angle } else { 0.0 } }
    }

    /// About `count` states in order of time.
    #[must_use]
    pub fn moments(&self, count: usize) -> Vec<ImpactState> {
        let phase = (count / 3).max(2);
        let parts = || (0..=phase).map(|k| k as f64 / phase as f64);
        let swing = self.swing();
        let (to_yield, to_turn) = (self.way_in(1.0), self.way_in(1.0) + swing.time(1.0));
        let inwards = parts().map(|part| {
            let (sine, cosine) = (part * self.last_angle()).sin_cos();
            let depth = (self.elastic_depth() * sine.powf(0.8)).min(self.deepest);
            self.going_in(self.way_in(part), depth, self.impact.speed * cosine)
        });
        let yielding = parts().skip(1).filter(|_| swing.angle > 0.0).map(|part| {
            let depth = (self.ball.yield_depth() + swing.way(part)).min(self.deepest);
            self.going_in(to_yield + swing.time(part), depth, swing.speed_at(part))
        });
        let out = parts().skip(1).map(|part| self.going_out(to_turn, part));
        inwards.chain(yielding).chain(out).collect()
    }

    fn going_in(&self, time: f64, depth: f64, speed: f64) -> ImpactState {
        let dent = self.ball.let_go(depth);
        self.state(time, (depth, speed), &dent, self.ball.heat(depth))
    }

    fn going_out(&self, from: f64, part: f64) -> ImpactState {
        let (sine, cosine) = ((1.0 - part) * FRAC_PI_2).sin_cos();
        let depth = self.dent.residual + (self.deepest - self.dent.residual) * sine.powf(0.8);
        let motion = (depth, -self.rebound_speed() * cosine);
        self.state(from + self.way_out(part), motion, &self.dent, self.ball.heat(self.deepest))
    }

    fn state(&self, time: f64, (depth, speed): (f64, f64), dent: &Dent, dissipated: f64) -> ImpactState {
        let stored = Energy { elastic: dent.stored(depth), surface: 0.0 };
        ImpactState {
            time,
            depth,
            speed,
            force: dent.force(depth),
            radius: dent.contact_radius(depth),
            stored,
            dissipated,
        }
    }
}

/// m ẍ = −(F_y + kx) from x = 0 at a speed to its turn.
struct Swing {
    speed: f64,
    /// ω = √(k/m) [rad/s].
    frequency: f64,
    /// F_y/k [m].
    rest: f64,
    /// ωt at the turn.
    angle: f64,
}

impl Swing {
    fn time(&self, part: f64) -> f64 {
        part * self.angle / self.frequency
    }

    fn way(&self, part: f64) -> f64 {
        let (sine, cosine) = (0.5 * part * self.angle).sin_cos();
        2.0 * sine * (self.speed / self.frequency * cosine - self.rest * sine)
    }

    fn speed_at(&self, part: f64) -> f64 {
        let (sine, cosine) = (part * self.angle).sin_cos();
        self.speed * cosine - self.rest * self.frequency * sine
    }
}

/// Depth [m] at which Hertz's contact has taken the energy `energy` [J]: W = (8/15)E*√R d^{5/2}.
fn hertz_depth(ball: &YieldingBall, energy: f64) -> f64 {
    (1.875 * energy / (ball.modulus * ball.radius.sqrt())).powf(0.4)
}

/// (4/5)∫₀^θ sin^{−1/5} dθ: the time, over d*/v, in which Hertz's contact takes the mass from d = 0 to d*sin^{4/5}θ;
/// θ = w⁵ takes the root at zero away.
fn time_to(angle: f64) -> f64 {
    let at = |w: f64| {
        let angle = w.powi(5);
        let ratio = if angle > 0.0 { angle.sin() / angle } else { 1.0 };
        4.0 * w.powi(3) * ratio.powf(-0.2)
    };
    quadrature::panel(at, 0.0, angle.max(0.0).powf(0.2))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BALL: YieldingBall = YieldingBall { radius: 0.01, modulus: 2e11, limit: 1.6e9 };
    const MASS: f64 = 0.03;

    fn at(ratio: f64) -> PlasticPassage {
        PlasticPassage::new(BALL, Projectile { mass: MASS, speed: ratio * BALL.yield_speed(MASS) })
    }

    /// Thornton's restitution with sixteen digits, and his v_y.
    #[test]
    fn restitution_of_thornton() {
        let speed = (FRAC_PI_2 / BALL.modulus).powi(2)
            * (8.0 * std::f64::consts::PI * BALL.radius.powi(3) / (15.0 * MASS)).sqrt()
            * BALL.limit.powf(2.5);
        assert!((BALL.yield_speed(MASS) / speed - 1.0).abs() < 1e-13);
        for (ratio, right) in [
            (0.3, 1.0),
            (1.0, 1.0),
            (1.5, 0.971_239_411_072_467_1),
            (2.0, 0.930_625_877_273_653),
            (5.0, 0.773_336_898_970_150_1),
            (20.0, 0.557_108_666_503_75),
        ] {
            let found = at(ratio).rebound().restitution;
            assert!((found - right).abs() < 2e-14, "{ratio}: {found} {right}");
        }
    }

    /// At high speed e ∝ v^{−1/4}.
    #[test]
    fn fast_impacts_follow_a_power() {
        let exponent = (at(1e7).rebound().restitution / at(1e6).rebound().restitution).log10();
        assert!((exponent + 0.25).abs() < 1e-6, "{exponent}");
    }

    /// Below v_y it is Hertz: contact time 2.943275184324705 x₀/v; the states obey energy and each other.
    #[test]
    fn times_and_states_agree() {
        let slow = at(0.5);
        let time = slow.rebound().contact_time.unwrap() * slow.impact.speed / slow.deepest;
        assert!((time - 2.943_275_184_324_705).abs() < 1e-13, "{time}");
        for ratio in [0.7, 1.0001, 3.0, 40.0] {
            let passage = at(ratio);
            let energy = 0.5 * MASS * passage.impact.speed.powi(2);
            let states = passage.moments(3000);
            for state in &states {
                let sum = 0.5 * MASS * state.speed.powi(2) + state.stored.elastic + state.dissipated;
                assert!((sum / energy - 1.0).abs() < 1e-11, "{ratio} {state:?}");
            }
            for pair in states.windows(2) {
                // Trapezia of the speed are the way, to the square of a part in a thousand of the impact.
                let way = 0.5 * (pair[0].speed + pair[1].speed) * (pair[1].time - pair[0].time);
                let off = (pair[1].depth - pair[0].depth - way).abs();
                assert!(pair[1].time >= pair[0].time && off < 1e-5 * passage.deepest, "{ratio} {off:e}");
            }
        }
    }
}
