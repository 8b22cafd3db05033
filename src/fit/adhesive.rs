//! The force of an adhesive contact led through a row of depths, without a run.
//!
//! On a smooth shape whose slope grows the equilibrium d(a) = g(a) − Δl(a) falls to its least value at one radius and
//! rises from there on: the contact joins at d = 0, follows the rising branch, and parts at the least depth.

use super::slopes::Slopes;
use crate::contact::adhesion::equilibrium::{Control, Equilibrium, Search};
use crate::contact::adhesion::line::EdgeLine;
use crate::numerics::root;
use crate::shape::Rim;

/// The stable branch of an adhesive contact.
#[derive(Debug, Clone)]
pub struct Branch {
    line: EdgeLine,
    /// Radius [m] at which a retraction parts the bodies.
    last: f64,
    /// Depth [m] there.
    least: f64,
}

/// Forces and slopes of a contact that is led through depths, and where it jumps.
#[derive(Debug, Clone)]
pub struct Followed {
    /// Forces [N].
    pub forces: Vec<f64>,
    /// Slopes in E* and in the work of adhesion, and in first touch.
    pub slopes: Slopes,
    /// Jumps on the way.
    pub jumps: Vec<Jump>,
}

/// A jump of a contact led through a row of depths: the bodies snap together or part, or are on the brink of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// The first row behind it, or behind the row that comes nearest to it.
    pub row: usize,
    /// By how much the response jumps.
    pub height: f64,
    /// The drive at which it is [m or N]; `None` where no more is known than between which rows.
    pub at: Option<f64>,
}

/// The most steps of Newton's rule, which squares the error, before the root is bracketed instead.
const STEPS: usize = 30;

/// Part of the scale of a shape below which no contact is looked for.
const SMALL: f64 = 1e-12;

impl Branch {
    /// The branch of `line`; `None` if there may be more than one.
    pub fn of(line: EdgeLine) -> Option<Self> {
        let profile = line.ground().profile();
        let one = line.search() == Search::Once && profile.flat_radius() <= 0.0 && profile.first_fall().is_none();
        if !one || matches!(profile.rim(), Rim::Wall(_)) {
            return None;
        }
        let slope = |a: f64| line.slope(Control::Indentation, a);
        let (low, high) = root::bracket_upwards(slope, SMALL * line.scale(), line.scale(), line.end())?;
        let last = root::within(slope, low, high);
        let least = line.value(Control::Indentation, last);
        (least < 0.0).then_some(Self { line, last, least })
    }

    /// The contact at the depths `depths` [m] in their order, first touch at `contact`.
    ///
    /// # Errors
    /// A depth is not met.
    pub fn followed(&self, depths: &[f64], contact: f64) -> Result<Followed, String> {
        let (mut joined, mut radius) = (false, self.last);
        let (mut jumps, mut brink) = (Vec::new(), None);
        let touched = self.radius(0.0, self.last).map_or(0.0, |radius| self.line.value(Control::Force, radius));
        let torn = self.line.value(Control::Force, self.last);
        let parting = |row: usize| Jump { row, height: torn.abs(), at: Some(contact + self.least) };
        let mut follow = |(row, d): (usize, f64)| {
            let before = joined;
            joined = d >= self.least && (before || d >= 0.0);
            match (before, joined) {
                (false, true) => jumps.push(Jump { row, height: touched.abs(), at: Some(contact) }),
                (true, false) => {
                    jumps.push(parting(row));
                    brink = None;
                }
                (true, true) if brink.is_none_or(|(_, least)| d < least) => brink = Some((row, d)),
                (true, true) | (false, false) => {}
            }
            if !joined {
                return Ok([0.0; 4]);
            }
            radius = self.radius(d, radius).ok_or_else(|| format!("no contact has the depth {d:e} m"))?;
            Ok(self.state(radius))
        };
        let rows = depths.iter().map(|d| d - contact).enumerate();
        let states = rows.map(&mut follow).collect::<Result<Vec<[f64; 4]>, String>>()?;
        jumps.extend(brink.map(|(row, _)| parting(row + 1)));
        let of = |at: usize| states.iter().map(|state| state[at]).collect::<Vec<f64>>();
        Ok(Followed { forces: of(0), slopes: Slopes { numbers: vec![of(1), of(2)], touch: of(3) }, jumps })
    }

    /// E* [Pa] and the work of adhesion [J/m²].
    pub fn numbers(&self) -> Vec<f64> {
        vec![self.line.ground().modulus(), self.line.work()]
    }

    /// Force [N] of the contact of the radius `a` [m], and its slopes at one depth in E*, in the work w and in first touch.
    ///
    /// From d = g(a) − Δl and F = 2E*(N(a) − aΔl) with Δl ~ √(w/E*): at one radius ∂d/∂E* = Δl/2E*, ∂F/∂E* = F/E* + aΔl,
    /// ∂d/∂w = −Δl/2w, ∂F/∂w = −E*aΔl/w; what d gains is taken back by the slope dF/dd.
    fn state(&self, a: f64) -> [f64; 4] {
        let (modulus, work, elongation) = (self.line.ground().modulus(), self.line.work(), self.line.elongation(a));
        let force = self.line.value(Control::Force, a);
        let slope = self.line.slope(Control::Force, a) / self.line.slope(Control::Indentation, a);
        let held = a * elongation - 0.5 * slope * elongation / modulus;
        [force, force / modulus + held, -held * modulus / work, -slope]
    }

    /// The radius [m] on the branch at the depth `d` [m], searched from the radius `near` on.
    ///
    /// A step of Newton's rule misses by no more than its square over the way to the radius at which d′(a) vanishes.
    fn radius(&self, d: f64, near: f64) -> Option<f64> {
        let mut a = near.max(self.last * (1.0 + 1e-3));
        for _ in 0..STEPS {
            let off = self.line.value(Control::Indentation, a) - d;
            let step = off / self.line.slope(Control::Indentation, a);
            let next = (a - step).max(0.5 * (a + self.last)).min(self.line.end());
            let moved = (next - a).abs();
            if moved <= 4.0 * f64::EPSILON * a || moved * moved <= f64::EPSILON * next * (next - self.last) {
                return Some(next);
            }
            a = next;
        }
        let residual = |a: f64| self.line.value(Control::Indentation, a) - d;
        let (low, high) = root::bracket_upwards(residual, self.last, 2.0 * self.last, self.line.end())?;
        Some(root::within(residual, low, high))
    }
}
