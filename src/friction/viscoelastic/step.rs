//! A step of all springs of a bed at the same speeds.

use super::spring::{Rubbed, SlipState, SpringGrip, faded, grown};
use crate::contact::viscoelastic::spring::Spring;
use crate::contact::viscoelastic::{Motion, Spectrum};
use crate::material::{Element, Mode};
use crate::numerics::exponential::decay;

/// A step of all springs at the same speeds, with what it does to the load of each term worked out once.
pub(super) struct BedStep<'s> {
    spectrum: &'s Spectrum,
    speed: f64,
    pub(super) slide: f64,
    duration: f64,
    terms: Vec<TermStep>,
    /// What a displacement adds to the speed at which a spring let go recovers [1/s].
    recovery: f64,
}

/// What a step does to a Maxwell element.
struct TermStep {
    /// e^(−T/τ), and Eτ(1 − e^(−T/τ)) [Pa s], what a speed adds.
    kept: f64,
    added: f64,
    /// Mean of e^(−t/τ) over the step, and that of what a speed adds [Pa s].
    faded: f64,
    grown: f64,
    /// What its load adds to the speed at which a spring let go recovers [m/s per N/m].
    recovery: f64,
}

impl<'s> BedStep<'s> {
    pub(super) fn new(spectrum: &'s Spectrum, (speed, slide): (f64, f64), duration: f64) -> Self {
        let of = |(i, term): (usize, &Element)| {
            let y = duration / term.time;
            let (kept, lost) = decay(y);
            let (added, grown) = (term.modulus * term.time * lost, term.modulus * duration * grown(y));
            let pulled = |mode: &Mode| mode.compliance * mode.inverse_gaps[i] / mode.time;
            let recovery = term.time * spectrum.modes().iter().map(pulled).sum::<f64>();
            TermStep { kept, added, faded: faded(y), grown, recovery }
        };
        let terms = spectrum.terms().iter().enumerate().map(of).collect();
        let compliant = spectrum.modes().iter().map(|mode| mode.compliance / mode.time);
        let recovery = -spectrum.equilibrium() * compliant.sum::<f64>();
        Self { spectrum, speed, slide, duration, terms, recovery }
    }

    /// ∫q dt [N s/m] of a spring that begins at `u` with the element loads `loads` and goes at `speed`.
    fn load_over_time(&self, u: f64, loads: &[f64], speed: f64) -> f64 {
        let held = self.terms.iter().zip(loads).map(|(term, load)| load * term.faded + term.grown * speed);
        let steady =
            self.spectrum.equilibrium() * (u + 0.5 * speed * self.duration) + self.spectrum.viscosity() * speed;
        self.duration * (steady + held.sum::<f64>())
    }

    /// The work of a spring that slips all the step, over μm; `None` where it does not.
    pub(super) fn slipping(&self, place: f64, (normal, own): &(Spring, SpringGrip)) -> Option<f64> {
        let (Spring::Pressed(pressed), SpringGrip::Held { displacement, loads, slip: SlipState::Towards(side) }) =
            (normal, own)
        else {
            return None;
        };
        if self.speed < 0.0 && self.load(place, pressed, self.speed) < 0.0 {
            return None;
        }
        let elements = self.terms.iter().zip(pressed.iter().zip(loads));
        let pulled = elements.map(|(term, (down, along))| term.recovery * (down - side * along));
        let recovers = self.recovery * (place - side * displacement) + pulled.sum::<f64>();
        let slips = recovers > self.speed - side * self.slide;
        slips.then(|| side * self.slide * self.load_over_time(place, pressed, self.speed))
    }

    /// Load [N/m] at the end of the step of a spring that begins at `u` with the element loads `loads` and goes at `speed`.
    fn load(&self, u: f64, loads: &[f64], speed: f64) -> f64 {
        let elements = self.terms.iter().zip(loads).map(|(term, load)| term.kept * load + term.added * speed);
        self.spectrum.equilibrium() * (u + speed * self.duration)
            + elements.sum::<f64>()
            + self.spectrum.viscosity() * speed
    }

    /// What a spring takes that sticks all the step; `None` where it does not. The load of the normal spring less or plus
    /// that along the surface is the load of a spring that, once it begins to fall, falls to its end: its sign there tells.
    pub(super) fn sticking(&self, place: f64, (normal, own): &(Spring, SpringGrip)) -> Option<Rubbed> {
        let (Spring::Pressed(pressed), SpringGrip::Held { displacement, loads, slip: SlipState::No }) = (normal, own)
        else {
            return None;
        };
        let (down, along) = (self.load(place, pressed, self.speed), self.load(*displacement, loads, self.slide));
        let stays = |load: f64, speed: f64| speed >= 0.0 || load >= 0.0;
        let sticks = stays(down, self.speed)
            && stays(down - along, self.speed - self.slide)
            && stays(down + along, self.speed + self.slide);
        sticks.then(|| Rubbed { lost: 0.0, work: self.slide * self.load_over_time(*displacement, loads, self.slide) })
    }

    /// A spring that sticks all the step, to its end.
    pub(super) fn carry(&self, (normal, own): &mut (Spring, SpringGrip)) {
        let (Spring::Pressed(pressed), SpringGrip::Held { displacement, loads, .. }) = (normal, own) else { return };
        for ((term, down), along) in self.terms.iter().zip(pressed).zip(loads) {
            *down = term.kept * *down + term.added * self.speed;
            *along = term.kept * *along + term.added * self.slide;
        }
        *displacement += self.slide * self.duration;
    }

    /// A spring from event to event, to the end of the step.
    pub(super) fn follow(&self, place: f64, (normal, own): &mut (Spring, SpringGrip)) -> Rubbed {
        let seen = Motion { start: place, speed: self.speed, duration: self.duration };
        let mut all = Rubbed::default();
        let before = std::mem::replace(normal, Spring::Pressed(Vec::new()));
        *normal = before.follow(self.spectrum, &seen, &mut |piece| {
            let rubbed = own.follow(self.spectrum, piece, self.slide);
            all.lost += rubbed.lost;
            all.work += rubbed.work;
        });
        all
    }
}
