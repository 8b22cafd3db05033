//! One step solved: m d̈ = −F at Radau's points.

use super::collocation::{
    Fading, NODES, Polynomial, RADAU, TERMS, solved, through_all, through_nodes, value, velocity_of_node,
};
use super::law::{BedResponse, Kinematics, Shrinking};
use super::piece::{MotionPiece, MotionState};
use super::{ImpactError, StruckHalfSpace};
use crate::contact::error::BedError;
use std::array::from_fn;

/// Most iterations of a step; one that needs more is too long.
const MOST_ITERATIONS: usize = 25;
/// Part of the misfit of the acceleration at the beginning of a step that its speed may be wrong by: at
/// the beginning the polynomial goes beyond its points, between them it is off by a fifth at most.
const MISFIT: f64 = 0.2;

/// A step from one time on.
pub struct Collocation<'s> {
    /// What is driven.
    pub model: &'s StruckHalfSpace,
    /// Mass [kg].
    pub mass: f64,
    /// Beginning.
    pub start: &'s MotionState,
    /// Duration [s].
    pub span: f64,
    /// How the bed was loaded, and when the spring at the edge was touched, once the contact shrinks.
    pub shrinking: Option<(Shrinking<'s>, f64)>,
    /// Changes of the speed [m/s] that do not matter.
    pub negligible: f64,
}

/// A step that has been solved.
pub struct SolvedStep {
    /// The motion.
    pub piece: MotionPiece,
    /// Its end.
    pub end: MotionState,
    /// The bed at its end.
    pub answer: BedResponse,
    /// Estimate of the error of the speed [m/s].
    pub error: f64,
}

impl Collocation<'_> {
    /// The step; `None` if it is too long for the iteration.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn solve(&self) -> Result<Option<SolvedStep>, ImpactError> {
        let terms = self.model.spectrum.terms();
        let fadings: Vec<[Fading; NODES]> =
            terms.iter().map(|term| RADAU.map(|c| Fading::new(self.span / term.time, c))).collect();
        let mut acceleration = [self.start.acceleration; NODES];
        let mut hints: [f64; NODES] = from_fn(|j| {
            let last = self.shrinking.as_ref().map_or(0.0, |(_, touched)| *touched);
            (last - self.span * RADAU[j]).max(0.0)
        });
        let mut last = f64::INFINITY;
        for trial in 0..MOST_ITERATIONS {
            let piece = self.piece(&acceleration, hints);
            let (flow, answers) = self.answers(&piece, &fadings)?;
            let misfit: [f64; NODES] = from_fn(|j| -(acceleration[j] + answers[j].force / self.mass));
            let change = solved(self.jacobian(&fadings, &answers), misfit);
            acceleration = from_fn(|j| acceleration[j] + change[j]);
            hints = answers.map(|answer| answer.touched);
            let size = self.span * change.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
            if size <= self.negligible {
                return Ok(Some(self.finished(self.piece(&acceleration, hints), flow, &fadings, answers[NODES - 1])));
            }
            if !size.is_finite() || (trial > 8 && size > last) {
                return Ok(None);
            }
            last = size;
        }
        Ok(None)
    }

    fn piece(&self, acceleration: &[f64; NODES], touched: [f64; NODES]) -> MotionPiece {
        let rate = through_nodes(acceleration);
        let velocity = from_fn(|p| if p == 0 { self.start.speed } else { self.span * rate[p - 1] / p as f64 });
        let touched_first = self.shrinking.as_ref().map_or(self.start.time, |(_, touched)| *touched);
        MotionPiece {
            start: self.start.clone(),
            span: self.span,
            velocity,
            flow: [0.0; TERMS],
            touched,
            touched_first,
            missed: 0.0,
        }
    }

    /// What the bed does at the points, and the growth of the contact.
    fn answers(
        &self,
        piece: &MotionPiece,
        fadings: &[[Fading; NODES]],
    ) -> Result<(Polynomial, [BedResponse; NODES]), ImpactError> {
        match &self.shrinking {
            None => self.growing(piece, fadings),
            Some((law, _)) => {
                let mut memory = vec![0.0; fadings.len()];
                let answers = from_fn(|j| {
                    for (k, (term, fading)) in self.model.spectrum.terms().iter().zip(fadings).enumerate() {
                        memory[k] = piece.memory_of(&fading[j], term.modulus, k);
                    }
                    let c = RADAU[j];
                    let place = Kinematics {
                        time: piece.start.time + c * piece.span,
                        depth: piece.depth(c),
                        speed: piece.speed(c),
                        memory: &memory,
                    };
                    law.answer(&place, piece.touched[j])
                });
                Ok(([0.0; TERMS], answers))
            }
        }
    }

    fn growing(
        &self,
        piece: &MotionPiece,
        fadings: &[[Fading; NODES]],
    ) -> Result<(Polynomial, [BedResponse; NODES]), ImpactError> {
        let spectrum = &self.model.spectrum;
        let mut radius = [0.0; NODES];
        for j in 0..NODES {
            radius[j] = self.model.edge(piece.depth(RADAU[j]))?;
        }
        let flows = from_fn(|j| 2.0 * radius[j] * piece.speed(RADAU[j]));
        let flow = through_all(2.0 * self.model.edge(self.start.depth)? * self.start.speed, &flows);
        let grown = MotionPiece { flow, ..piece.clone() };
        let answer = |j: usize| {
            let elements = spectrum.terms().iter().zip(fadings).enumerate();
            let elements: f64 = elements.map(|(k, (term, fading))| grown.sum_of(&fading[j], term.modulus, k)).sum();
            let (a, d) = (radius[j], piece.depth(RADAU[j]));
            let force = self.model.steady_force(d, a) + elements + spectrum.viscosity() * flows[j];
            BedResponse { force, radius: a, touched: piece.start.time + RADAU[j] * piece.span, joined: true }
        };
        Ok((flow, from_fn(answer)))
    }

    /// ∂(d̈ + F/m)/∂d̈ with the edge where it is.
    fn jacobian(&self, fadings: &[[Fading; NODES]], answers: &[BedResponse; NODES]) -> [[f64; NODES]; NODES] {
        let spectrum = &self.model.spectrum;
        from_fn(|j| {
            let c = RADAU[j];
            let push: Polynomial = from_fn(|p| {
                let power = c.powi(i32::try_from(p).unwrap_or(0));
                let fading =
                    spectrum.terms().iter().zip(fadings).map(|(term, fading)| term.modulus * fading[j].gained[p]);
                let elastic = spectrum.equilibrium() * c * power / (p + 1) as f64 + fading.sum::<f64>();
                self.span * self.span * elastic + self.span * spectrum.viscosity() * power
            });
            let scale = 2.0 * answers[j].radius / self.mass;
            from_fn(|k| {
                let own = if j == k { 1.0 } else { 0.0 };
                own + scale * (1..TERMS).map(|p| push[p] * velocity_of_node(k, p)).sum::<f64>()
            })
        })
    }

    fn finished(
        &self,
        piece: MotionPiece,
        flow: Polynomial,
        fadings: &[[Fading; NODES]],
        answer: BedResponse,
    ) -> SolvedStep {
        let piece = MotionPiece { flow, ..piece };
        let at_end = |of: &dyn Fn(&Fading, f64, usize) -> f64| -> Vec<f64> {
            let terms = self.model.spectrum.terms().iter().zip(fadings).enumerate();
            terms.map(|(k, (term, fading))| of(&fading[NODES - 1], term.modulus, k)).collect()
        };
        let end = MotionState {
            time: piece.end(),
            depth: piece.depth(1.0),
            speed: piece.speed(1.0),
            acceleration: -answer.force / self.mass,
            memory: at_end(&|fading, modulus, k| piece.memory_of(fading, modulus, k)),
            sums: if self.shrinking.is_none() {
                at_end(&|fading, modulus, k| piece.sum_of(fading, modulus, k))
            } else {
                Vec::new()
            },
        };
        let misfit = (piece.acceleration(0.0) - self.start.acceleration).abs();
        let error = MISFIT * self.span * misfit + self.flow_error(&piece);
        let piece = MotionPiece { missed: error, ..piece };
        SolvedStep { piece, end, answer, error }
    }

    /// What the polynomial of the growth, looked at in its middle, may do to the speed [m/s].
    fn flow_error(&self, piece: &MotionPiece) -> f64 {
        if self.shrinking.is_some() {
            return 0.0;
        }
        let exact = 2.0 * self.model.edge(piece.depth(0.5)).unwrap_or(0.0) * piece.speed(0.5);
        let lasting = |term: &crate::contact::viscoelastic::Element| term.modulus * term.time.min(self.span);
        let stiffness: f64 = self.model.spectrum.terms().iter().map(lasting).sum();
        MISFIT * self.span * stiffness * (exact - value(&piece.flow, 0.5)).abs() / self.mass
    }
}

impl StruckHalfSpace {
    /// Contact radius [m] of a contact that grows, at the depth `d`.
    pub(super) fn edge(&self, d: f64) -> Result<f64, ImpactError> {
        let beyond = || ImpactError::Bed(BedError::BeyondProfile { indentation: d });
        self.profile.edge(d.max(0.0)).ok_or_else(beyond)
    }
}
