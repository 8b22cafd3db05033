//! One spring of friction on a body that relaxes: sticking, slipping and free, exact in time.

use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::spring::{Free, Piece, Spring};
use crate::material::{Element, Mode};
use crate::numerics::exponential::{decay, square_remainder};

/// What a spring has lost and taken along the surface, over μm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Rubbed {
    /// ∫q ds, the normal load over the way slipped.
    pub(super) lost: f64,
    /// ∫q_x du/μ, the tangential load over the way of the indenter.
    pub(super) work: f64,
}

/// Tangential state of a spring, divided by m.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum SpringGrip {
    /// Under the indenter.
    Held {
        /// Displacement [m].
        displacement: f64,
        /// Element loads [N/m].
        loads: Vec<f64>,
        /// Whether and whither it slips.
        slip: SlipState,
    },
    /// Not under it.
    Free(Free),
}

/// Whether a spring slips; +1 forwards, −1 backwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum SlipState {
    No,
    Towards(f64),
}

/// A stretch in which the spring stays under the indenter.
struct UnderIndenter<'a> {
    start: f64,
    loads: &'a [f64],
    speed: f64,
    slide: f64,
    duration: f64,
}

/// Whether a spring sticks, if it is under the indenter.
pub(super) fn is_stuck((normal, own): &(Spring, SpringGrip)) -> Option<bool> {
    match (normal, own) {
        (Spring::Pressed(_), SpringGrip::Held { slip, .. }) => Some(*slip == SlipState::No),
        (Spring::Pressed(_) | Spring::Free(_), _) => None,
    }
}

impl SpringGrip {
    /// The same displacement and loads, divided by the part `part` of what m was.
    pub(super) fn divide(&mut self, part: f64) {
        let all = match self {
            Self::Held { displacement, loads, .. } => std::iter::once(displacement).chain(loads),
            Self::Free(free) => std::iter::once(&mut free.rest).chain(&mut free.modes),
        };
        all.for_each(|value| *value /= part);
    }

    /// Energy stored [N], over μm.
    pub(super) fn stored(&self, spectrum: &Spectrum) -> f64 {
        let of = |displacement: f64, loads: &[f64]| {
            let elements = spectrum.terms().iter().zip(loads).map(|(term, load)| load * load / term.modulus);
            0.5 * (spectrum.equilibrium() * displacement * displacement + elements.sum::<f64>())
        };
        if let Self::Held { displacement, loads, .. } = self {
            return of(*displacement, loads);
        }
        let (displacement, loads, _) = self.touched(spectrum);
        of(displacement, &loads)
    }

    /// Follows a stretch of the normal motion while the indenter slides at the speed `slide`.
    pub(super) fn follow(&mut self, spectrum: &Spectrum, piece: &Piece<'_>, slide: f64) -> Rubbed {
        match *piece {
            Piece::Free { duration, .. } => {
                self.recover(spectrum, duration);
                Rubbed::default()
            }
            Piece::Pressed { u, s, speed, duration } => {
                self.drag(spectrum, &UnderIndenter { start: u, loads: s, speed, slide, duration })
            }
        }
    }

    fn recover(&mut self, spectrum: &Spectrum, duration: f64) {
        if let Self::Held { displacement, loads, .. } = self {
            *self = Self::Free(spectrum.let_go(*displacement, loads));
        }
        if let Self::Free(free) = self {
            spectrum.recover(free, duration);
        }
    }

    fn drag(&mut self, spectrum: &Spectrum, pressed: &UnderIndenter<'_>) -> Rubbed {
        let (mut displacement, mut loads, slip) = self.touched(spectrum);
        if let SlipState::Towards(side) = slip {
            let free = pressed.difference(spectrum, side, displacement, &loads);
            if spectrum.recovery_speed(&free, 0.0) > pressed.speed - side * pressed.slide {
                let rubbed = pressed.rubbed(spectrum, side, &free);
                *self = pressed.slipped(spectrum, side, free);
                return rubbed;
            }
        }
        let first = pressed.first_slip(spectrum, displacement, &loads);
        let stuck = first.map_or(pressed.duration, |(time, _)| time);
        let work = pressed.slide * load_over_time(spectrum, (displacement, &loads), pressed.slide, stuck);
        spectrum.press(&mut loads, pressed.slide, stuck);
        displacement += pressed.slide * stuck;
        let Some((time, side)) = first else {
            *self = Self::Held { displacement, loads, slip: SlipState::No };
            return Rubbed { lost: 0.0, work };
        };
        let (start, mut normal) = (pressed.start + pressed.speed * time, pressed.loads.to_vec());
        spectrum.press(&mut normal, pressed.speed, time);
        let rest = UnderIndenter { start, loads: &normal, duration: pressed.duration - time, ..*pressed };
        let free = rest.difference(spectrum, side, displacement, &loads);
        let slipping = rest.rubbed(spectrum, side, &free);
        *self = rest.slipped(spectrum, side, free);
        Rubbed { work: work + slipping.work, ..slipping }
    }

    /// The state of a spring that is, or has just come, under the indenter.
    fn touched(&self, spectrum: &Spectrum) -> (f64, Vec<f64>, SlipState) {
        match self {
            Self::Held { displacement, loads, slip } => (*displacement, loads.clone(), *slip),
            Self::Free(free) => {
                let mut loads = vec![0.0; spectrum.terms().len()];
                spectrum.loads_of_free(free, &mut loads);
                (spectrum.recovered(free, 0.0), loads, SlipState::No)
            }
        }
    }
}

impl UnderIndenter<'_> {
    /// The spring n − side·v, let go.
    fn difference(&self, spectrum: &Spectrum, side: f64, displacement: f64, loads: &[f64]) -> Free {
        let elements: Vec<f64> = self.loads.iter().zip(loads).map(|(normal, own)| normal - side * own).collect();
        spectrum.let_go(self.start - side * displacement, &elements)
    }

    /// When and whither a sticking spring begins to slip.
    fn first_slip(&self, spectrum: &Spectrum, displacement: f64, loads: &[f64]) -> Option<(f64, f64)> {
        let time = |side: f64| {
            let elements: Vec<f64> = self.loads.iter().zip(loads).map(|(normal, own)| normal - side * own).collect();
            let (u, speed) = (self.start - side * displacement, self.speed - side * self.slide);
            spectrum.release(u, &elements, speed, self.duration).map(|time| (time, side))
        };
        match (time(1.0), time(-1.0)) {
            (Some(forward), Some(backward)) => Some(if forward.0 <= backward.0 { forward } else { backward }),
            (forward, backward) => forward.or(backward),
        }
    }

    /// A stretch slipped all along: ∫₀^T q (side·u̇ − ṅ + ż) dt [N], the load of the normal spring over the way the
    /// indenter slips on it, with the free difference z = z₀ + Σ zₖ e^(−t/λₖ), and side·∫ q u̇ dt.
    ///
    /// With q(t) as of [`load_over_time`] all is a sum of integrals of e^(−t/λ), e^(−t/τ) and their products; x = T/λ
    /// and y = T/τ, with 1 − e^(−x−y) = (1 − e^(−x)) + e^(−x) (1 − e^(−y)).
    fn rubbed(&self, spectrum: &Spectrum, side: f64, free: &Free) -> Rubbed {
        let (time, speed) = (self.duration, self.speed);
        if time <= 0.0 {
            return Rubbed::default();
        }
        let (floor, steady) = (spectrum.equilibrium() * speed * time, spectrum.viscosity() * speed);
        let start = spectrum.equilibrium() * self.start + steady;
        let elements = || spectrum.terms().iter().zip(self.loads);
        let ramp = load_over_time(spectrum, (self.start, self.loads), speed, time);
        let creeping = |(mode, z): (&Mode, &f64)| {
            let x = time / mode.time;
            let (kept, lost) = decay(x);
            let element = |(term, load): (&Element, &f64)| {
                let y = time / term.time;
                let both = x / (x + y) * (lost + kept * y * faded(y));
                load * both + term.modulus * speed * time * (lost - x * kept * faded(y)) / (x + y)
            };
            let rising = if x > 0.0 { (lost - x * kept) / x } else { 0.0 };
            -z * (start * lost + floor * rising + elements().map(element).sum::<f64>())
        };
        let creep: f64 = spectrum.modes().iter().zip(&free.modes).map(creeping).sum();
        Rubbed { lost: (side * self.slide - speed) * ramp + creep, work: side * self.slide * ramp }
    }

    /// The end of a stretch slipped all along: v = side·(n − z) with the free difference z.
    fn slipped(&self, spectrum: &Spectrum, side: f64, mut free: Free) -> SpringGrip {
        spectrum.recover(&mut free, self.duration);
        let mut normal = self.loads.to_vec();
        spectrum.press(&mut normal, self.speed, self.duration);
        let mut loads = vec![0.0; normal.len()];
        spectrum.loads_of_free(&free, &mut loads);
        for (own, normal) in loads.iter_mut().zip(&normal) {
            *own = side * (normal - *own);
        }
        let displacement = side * (self.start + self.speed * self.duration - spectrum.recovered(&free, 0.0));
        SpringGrip::Held { displacement, loads, slip: SlipState::Towards(side) }
    }
}

/// ∫₀^T q dt [N s/m] of a spring of the displacement u₀ and the element loads sᵢ that goes at the speed u̇ for the time T:
/// q(t) = E∞u + ηu̇ + Σ [sᵢ e^(−t/τᵢ) + Eᵢu̇τᵢ (1 − e^(−t/τᵢ))].
fn load_over_time(spectrum: &Spectrum, (start, loads): (f64, &[f64]), speed: f64, time: f64) -> f64 {
    let held = |(term, load): (&Element, &f64)| {
        let y = time / term.time;
        load * faded(y) + term.modulus * speed * time * grown(y)
    };
    let steady = spectrum.equilibrium() * (start + 0.5 * speed * time) + spectrum.viscosity() * speed;
    time * (steady + spectrum.terms().iter().zip(loads).map(held).sum::<f64>())
}

/// (1 − e^(−y))/y, the mean of e^(−t) over 0 … y.
pub(super) fn faded(y: f64) -> f64 {
    if y > 0.0 { decay(y).1 / y } else { 1.0 }
}

/// (y − 1 + e^(−y))/y², which is ½ at y = 0.
pub(super) fn grown(y: f64) -> f64 {
    if y > 1e-100 { square_remainder(y, decay(y).1) / (y * y) } else { 0.5 }
}
