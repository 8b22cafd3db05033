//! Records of a motion, with the energy stored in the bed.

use super::collocation::{Fading, NODES, Polynomial, RADAU, slope, through_all, through_nodes, value};
use super::law::{Kinematics, Shrinking, touch_of};
use super::piece::{MotionPiece, at};
use super::{Flight, ImpactState, StruckHalfSpace};
use crate::contact::adhesion::line::Energy;
use crate::contact::viscoelastic::spring::Free;
use crate::numerics::quadrature;
use std::array::from_fn;

/// Part of the time of a mode up to which a step lets springs go whose stretch changes but little in it.
const SOON: f64 = 0.3;

/// Energies of the bed at the ends of the steps.
struct Stores {
    /// ∫ sᵢ² over the contact [N²/m] at the beginning of each step of the loading.
    squares: Vec<Vec<f64>>,
    /// ∫ zₘ² over the springs let go [m³] at the beginning of each step of the unloading, and at the end.
    modes: Vec<Vec<f64>>,
}

impl Flight {
    /// States at `count` + 1 equal times from first touch to the end, with both sides of a sudden parting.
    #[must_use]
    pub fn moments(&self, count: usize) -> Vec<ImpactState> {
        let stores = self.stores();
        let end = self.end.time;
        let times = (0..=count).map(|k| if k == count { end } else { end * k as f64 / count as f64 });
        let mut moments: Vec<ImpactState> = times.map(|t| self.moment(t, &stores)).collect();
        if self.parted && self.model.parts_at_once() {
            moments.push(self.apart(&stores));
        }
        moments
    }

    fn moment(&self, time: f64, stores: &Stores) -> ImpactState {
        let turn = self.loading.last().map_or(0.0, MotionPiece::end);
        if time <= turn || self.unloading.is_empty() {
            self.growing(time, stores)
        } else {
            self.shrinking(time, stores)
        }
    }

    /// What is not kinetic and not stored is heat.
    fn balanced(&self, moment: ImpactState) -> ImpactState {
        let kinetic = 0.5 * self.impact.mass * moment.speed * moment.speed;
        ImpactState { dissipated: (self.impact.energy() - kinetic - moment.stored.elastic).max(0.0), ..moment }
    }

    fn growing(&self, time: f64, stores: &Stores) -> ImpactState {
        let number = self.loading.partition_point(|piece| piece.end() < time).min(self.loading.len() - 1);
        let piece = &self.loading[number];
        let theta = piece.part(time);
        let (depth, speed) = (piece.depth(theta), piece.speed(theta));
        let radius = self.model.edge(depth).unwrap_or(0.0);
        let squares = self.model.squares(piece, theta, &stores.squares[number]);
        let stored = self.model.steady(depth, radius) + self.model.elements(&squares);
        let sums: f64 = piece.sums(&self.model.spectrum, theta).iter().sum();
        let force =
            self.model.steady_force(depth, radius) + sums + 2.0 * radius * self.model.spectrum.viscosity() * speed;
        let stored = Energy { elastic: stored, surface: 0.0 };
        self.balanced(ImpactState { time, depth, speed, force, radius, stored, dissipated: 0.0 })
    }

    fn shrinking(&self, time: f64, stores: &Stores) -> ImpactState {
        let number = self.unloading.partition_point(|piece| piece.end() < time).min(self.unloading.len() - 1);
        let piece = &self.unloading[number];
        let theta = piece.part(time);
        let (depth, speed, memory) =
            (piece.depth(theta), piece.speed(theta), piece.memory(&self.model.spectrum, theta));
        let place = Kinematics { time, depth, speed, memory: &memory };
        let law = Shrinking::new(&self.model, &self.loading);
        let answer = law.answer(&place, piece.touched_at(theta));
        let gone = self.model.freed(piece, theta, &stores.modes[number], &law);
        // Where the bodies part all springs have been let go, whatever rounding leaves pressed.
        let holds = answer.joined && !(self.parted && time >= self.end.time && !self.model.parts_at_once());
        let held = if holds { self.held_energy(&place, answer.touched, answer.radius, stores) } else { 0.0 };
        let force = answer.force;
        let stored = Energy { elastic: held + self.model.recovering(&gone), surface: 0.0 };
        self.balanced(ImpactState { time, depth, speed, force, radius: answer.radius, stored, dissipated: 0.0 })
    }

    /// After the last springs have been let go all at once.
    fn apart(&self, stores: &Stores) -> ImpactState {
        let a = self.last.radius;
        let mut modes = stores.modes.last().cloned().unwrap_or_default();
        let place =
            Kinematics { time: self.end.time, depth: self.end.depth, speed: self.end.speed, memory: &self.end.memory };
        let free = |x: f64| self.model.let_go(&place, touch_of(&self.model, &self.loading, x), &self.loading);
        for (m, sum) in modes.iter_mut().enumerate() {
            *sum += quadrature::panel(|x| 2.0 * free(x).modes[m].powi(2), 0.0, a);
        }
        let stored = Energy { elastic: self.model.recovering(&modes), surface: 0.0 };
        let (time, depth, speed) = (self.end.time, self.end.depth, self.end.speed);
        self.balanced(ImpactState { time, depth, speed, force: 0.0, radius: 0.0, stored, dissipated: 0.0 })
    }

    /// Energy in the springs still pressed, the edge touched at `touched`.
    fn held_energy(&self, place: &Kinematics<'_>, touched: f64, radius: f64, stores: &Stores) -> f64 {
        let spectrum = &self.model.spectrum;
        let number = self.loading.partition_point(|piece| piece.end() < touched).min(self.loading.len() - 1);
        let piece = &self.loading[number];
        let theta = piece.part(touched);
        let (squares, sums) = (self.model.squares(piece, theta, &stores.squares[number]), piece.sums(spectrum, theta));
        let memory = piece.memory(spectrum, theta);
        let terms = spectrum.terms().iter().enumerate();
        let now: Vec<f64> = terms
            .map(|(k, term)| {
                let kept = (-(place.time - touched) / term.time).exp();
                let edge = place.memory[k] - kept * memory[k];
                kept * kept * squares[k] + 2.0 * edge * (kept * sums[k] + edge * radius)
            })
            .collect();
        self.model.steady(place.depth, radius) + self.model.elements(&now)
    }

    fn stores(&self) -> Stores {
        let model = &self.model;
        let law = Shrinking::new(model, &self.loading);
        let mut squares = vec![vec![0.0; model.spectrum.terms().len()]];
        for piece in &self.loading {
            let next = squares.last().map(|before| model.squares(piece, 1.0, before));
            squares.extend(next);
        }
        let mut modes = vec![vec![0.0; model.spectrum.modes().len()]];
        for piece in &self.unloading {
            let next = modes.last().map(|before| model.freed(piece, 1.0, before, &law));
            modes.extend(next);
        }
        Stores { squares, modes }
    }
}

impl StruckHalfSpace {
    /// Whether the last springs are let go all at the same time.
    fn parts_at_once(&self) -> bool {
        self.profile.flat_radius() > 0.0
    }

    /// ∫₀^a (d − g)² dx [m³].
    pub(super) fn square_integral(&self, d: f64, a: f64) -> f64 {
        let over = d - self.profile.reduced(a);
        self.profile.energy_integral(a) + over * (2.0 * self.profile.load_integral(a) + over * a)
    }

    /// E∞ ∫₀^a (d − g)² dx [J].
    fn steady(&self, d: f64, a: f64) -> f64 {
        self.spectrum.equilibrium() * self.square_integral(d, a)
    }

    /// 2E∞ ∫₀^a (d − g) dx [N].
    pub(super) fn steady_force(&self, d: f64, a: f64) -> f64 {
        let over = d - self.profile.reduced(a);
        2.0 * self.spectrum.equilibrium() * (self.profile.load_integral(a) + a * over)
    }

    /// Σ ∫ sᵢ²/2Eᵢ [J].
    fn elements(&self, squares: &[f64]) -> f64 {
        self.spectrum.terms().iter().zip(squares).map(|(term, square)| 0.5 * square / term.modulus).sum()
    }

    /// Σ ∫ zₘ²/2Jₘ [J].
    fn recovering(&self, modes: &[f64]) -> f64 {
        self.spectrum.modes().iter().zip(modes).map(|(mode, square)| 0.5 * square / mode.compliance).sum()
    }

    /// ∫ sᵢ² at θ of a step of the loading: d/dt = 2Eᵢ ḋ Sᵢ − 2(…)/τᵢ.
    fn squares(&self, piece: &MotionPiece, theta: f64, before: &[f64]) -> Vec<f64> {
        let of = |(k, term): (usize, &crate::contact::viscoelastic::Element)| {
            let rate = |c: f64| {
                let sum = piece.sum_of(&Fading::new(piece.span / term.time, c), term.modulus, k);
                2.0 * term.modulus * piece.speed(c) * sum
            };
            let rates: Polynomial = through_all(rate(0.0), &RADAU.map(rate));
            let fading = Fading::new(2.0 * piece.span / term.time, theta);
            fading.kept * before[k] + piece.span * fading.gain(&rates)
        };
        self.spectrum.terms().iter().enumerate().map(of).collect()
    }

    /// ∫ zₘ² at θ of a step of the unloading: what is left of the springs let go before, and those let go in it.
    ///
    /// The place a of the edge may end as steeply as a logarithm, that under lying bodies does; in a step within which
    /// little of zₘ² fades ∫zₘ² da is taken by parts, so that it is not a that is differentiated.
    fn freed(&self, piece: &MotionPiece, theta: f64, before: &[f64], law: &Shrinking<'_>) -> Vec<f64> {
        let touch = |k: usize| if k == 0 { piece.touched_before(0.0) } else { piece.touched[k - 1] };
        let height = |t: f64| at(law.loading, t).map_or(0.0, |loaded| loaded.depth(loaded.part(t)));
        let radius = |k: usize| self.edge(height(touch(k))).unwrap_or(0.0);
        let radii = through_all(radius(0), &from_fn(|j| radius(j + 1)));
        let let_go = |c: f64, touched: f64| {
            let memory = piece.memory(&self.spectrum, c);
            let time = piece.start.time + c * piece.span;
            let place = Kinematics { time, depth: piece.depth(c), speed: piece.speed(c), memory: &memory };
            self.let_go(&place, (touched, height(touched)), law.loading)
        };
        let (first, free): (Free, [Free; NODES]) =
            (let_go(0.0, touch(0)), from_fn(|j| let_go(RADAU[j], piece.touched[j])));
        let mode = |(m, mode): (usize, &crate::contact::viscoelastic::Mode)| {
            let fading = Fading::new(2.0 * piece.span / mode.time, theta);
            let square = |free: &Free| free.modes[m].powi(2);
            let gone = if piece.span <= SOON * mode.time {
                let left = |c: f64| (2.0 * (c - theta) * piece.span / mode.time).exp();
                let squares = through_all(left(0.0) * square(&first), &from_fn(|j| left(RADAU[j]) * square(&free[j])));
                let swept = |c: f64| value(&squares, c) * value(&radii, c);
                let moved = quadrature::panel(|c| slope(&squares, c) * value(&radii, c), 0.0, theta);
                2.0 * (swept(0.0) - swept(theta) + moved)
            } else {
                let rate = from_fn(|j| -2.0 * slope(&radii, RADAU[j]).min(0.0) * square(&free[j]));
                fading.gain(&through_nodes(&rate))
            };
            fading.kept * before[m] + gone
        };
        self.spectrum.modes().iter().enumerate().map(mode).collect()
    }

    /// A spring touched at `touched` under the height g, let go at `place`.
    fn let_go(&self, place: &Kinematics<'_>, (touched, height): (f64, f64), loading: &[MotionPiece]) -> Free {
        let spectrum = &self.spectrum;
        let Some(piece) = at(loading, touched) else { return Free::default() };
        let before = piece.memory(spectrum, piece.part(touched));
        let terms = spectrum.terms().iter().enumerate();
        let kept = |term: &crate::contact::viscoelastic::Element| (-(place.time - touched) / term.time).exp();
        let loads: Vec<f64> = terms.map(|(k, term)| place.memory[k] - kept(term) * before[k]).collect();
        spectrum.let_go(place.depth - height, &loads)
    }
}
