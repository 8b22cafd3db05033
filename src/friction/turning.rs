//! The exact memory of a Coulomb contact: a short list of turning points.
//!
//! A spring touched at the depth h carries the tangential displacement v = u − s, where s is the
//! way it has slipped, and |v| ≤ m (d − h) with m = μE*/G*. As a function of m h its slip s is a
//! polyline with slopes between −1 and 1 that ends at the present point (m d, u). A step to a new
//! point keeps the part of the polyline inside the cone |u − s| ≤ m (d − h) and joins the last point
//! inside with the new one: on the mantle of the cone where springs have slipped, by a chord where
//! springs have been touched without slip. Both follow from the law of the single spring alone, for
//! normal and tangential motion in any order, and are exact for every step whose path is straight;
//! unless the depth grows faster than m⁻¹ times the slide, they are exact for every monotone path.
//!
//! The tangential force is the superposition F_x = μ Σ σₖ ΔFₖ over the pieces of the polyline, σₖ
//! their slopes and ΔFₖ the normal force between their depths (Jäger 1993 for a single turning
//! point; the memory is that of Masing and Preisach).
//!
//! # Examples
//! ```
//! use springbed::friction::{Grip, Pose, TangentialMemory};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Slid to and fro under a constant load the loop closes: 19 slides later the force is the same to rounding.
//! let ball = Paraboloid { radius: Length::new(1.0)? };
//! let grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 0.3 };
//! let mut contact = TangentialMemory::new(Arc::new(ball), grip);
//! contact.advance(Pose { indentation: 1.0, slide: 0.0 })?;
//! let mut forces = Vec::new();
//! for k in 0..20 {
//!     contact.advance(Pose { indentation: 1.0, slide: if k % 2 == 0 { 0.2 } else { -0.2 } })?;
//!     forces.push(contact.state().tangential_force);
//! }
//! assert!((forces[1] + forces[0]).abs() < 1e-15 && (forces[19] - forces[1]).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod branch;
mod whole;

use super::FrictionError;
use super::load::{LinearProduct, LoadCurve, NormalLoad, SpringDepth};
use super::slipped::{Node, SlideStep, slip_work};
pub use crate::contact::model::Pose;
use crate::shape::Profile;
pub use branch::{Branch, PowerBranch};
use std::cmp::Ordering;
use std::sync::Arc;
pub use whole::Corner;

/// Moduli and friction of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grip {
    /// Effective modulus E* [Pa].
    pub normal_modulus: f64,
    /// Effective tangential modulus G* [Pa].
    pub tangential_modulus: f64,
    /// Coefficient of friction μ.
    pub coefficient: f64,
}

impl Grip {
    /// m = μE*/G*: the slide that makes a contact of unit depth slip as a whole.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.coefficient * (self.normal_modulus / self.tangential_modulus)
    }
}

/// Tangential state of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentialState {
    /// Tangential force F_x [N].
    pub tangential_force: f64,
    /// Contact radius a [m].
    pub contact_radius: f64,
    /// Radius c [m] up to which all sticks while the last step goes on; a if nothing slips.
    pub stick_radius: f64,
    /// dF_x/du_x = 2G*c [N/m] while the slide goes on; 2G*a at the moment it turns.
    pub stiffness: f64,
    /// Energy dissipated by friction so far [J].
    pub dissipated: f64,
}

/// A vertex of the memory and the piece of it below, towards the axis.
#[derive(Debug, Clone, Copy)]
struct Turn {
    place: SpringDepth,
    /// Slip s = `slide` − `behind` [m], kept as a difference like the place.
    slide: f64,
    behind: f64,
    /// Slope σ of the piece below.
    slope: f64,
    /// Σ σₖ ΔNₖ up to here [m²].
    sum: f64,
}

/// The last point of the memory a new position can see.
struct Cut {
    /// Vertices that stay.
    kept: usize,
    /// The corner of the memory on the mantle of the cone, if springs slip.
    corner: Option<Turn>,
    /// The new end.
    end: Turn,
}

/// Memory of a Coulomb contact by turning points.
///
/// State and cost do not depend on any number of springs: a step costs the turning points it wipes
/// out. The bed of springs is [`CoulombBed`](super::bed::CoulombBed).
///
/// Valid for a simply connected contact of elastically similar bodies
/// ([`Pair::coupling`](crate::material::Pair::coupling) zero).
/// Check: a paraboloid, E* = G* = R = 1, μ = 0.3, at d = 1, pushed to u_x = 0.225 has c = 0.5 a and
/// F_x = μF (1 − c³/a³) = 0.35.
#[derive(Debug, Clone)]
pub struct TangentialMemory<L = LoadCurve> {
    curve: L,
    grip: Grip,
    reach: f64,
    at: Pose,
    contact_radius: f64,
    stick: SpringDepth,
    dissipated: f64,
    turns: Vec<Turn>,
}

/// A piece of the memory: the springs touched between two depths, which carry σ of what they slip at more than those below.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    /// Where it begins.
    pub lower: SpringDepth,
    /// Where it ends.
    pub upper: SpringDepth,
    /// Slope σ, from −1 to 1.
    pub slope: f64,
}

impl TangentialMemory {
    /// Bytes of one turning point.
    pub const BYTES_PER_TURN: usize = size_of::<Turn>();

    /// Bodies that just touch, without tangential load.
    #[must_use]
    pub fn new(profile: Arc<dyn Profile>, grip: Grip) -> Self {
        Self::over(LoadCurve::new(profile), grip)
    }
}

impl<L: NormalLoad> TangentialMemory<L> {
    /// Bodies that just touch, without tangential load, whose normal load grows as `curve` says.
    ///
    /// The friction of a contact that is not round is the same sum over turning points (Ciavarella 1998; Jäger 1998), as
    /// far as what tangential tractions do along the surface is in one ratio to what pressures do across it.
    #[must_use]
    pub fn over(curve: L, grip: Grip) -> Self {
        let (reach, at) = (grip.reach(), Pose::default());
        let stick = SpringDepth::AXIS;
        Self { curve, grip, reach, at, contact_radius: 0.0, stick, dissipated: 0.0, turns: Vec::new() }
    }

    /// How the normal load grows.
    #[must_use]
    pub fn curve(&self) -> &L {
        &self.curve
    }

    /// The pieces of the memory from the axis outwards: q = μ Σ σ Δp, Δp the pressure between two depths.
    pub fn pieces(&self) -> impl Iterator<Item = Piece> {
        let piece = |pair: &[Turn]| Piece { lower: pair[0].place, upper: pair[1].place, slope: pair[1].slope };
        self.turns.windows(2).map(piece)
    }

    /// The outermost spring that sticks while the last step goes on.
    #[must_use]
    pub fn stick(&self) -> SpringDepth {
        self.stick
    }

    /// Moves on a straight line to `to`.
    ///
    /// # Errors
    /// The indentation leaves the profile; nothing has moved then.
    pub fn advance(&mut self, to: Pose) -> Result<(), FrictionError> {
        let edge = self.edge(to.indentation)?;
        if self.at.indentation <= 0.0 && to.indentation > 0.0 {
            self.at = crossing(self.at, to);
            self.turns = vec![self.axis(0.0)];
        }
        if self.at.indentation > 0.0 && to.indentation <= 0.0 && self.reach > 0.0 {
            self.advance_in_contact(crossing(self.at, to))?;
        }
        if to.indentation > 0.0 && self.reach > 0.0 {
            self.advance_in_contact(to)?;
        } else {
            self.turns.clear();
            self.stick = SpringDepth::AXIS;
        }
        self.at = to;
        self.contact_radius = edge;
        Ok(())
    }

    fn edge(&self, depth: f64) -> Result<f64, FrictionError> {
        if depth > 0.0 { self.place(depth, 0.0).map(|place| place.radius) } else { Ok(0.0) }
    }

    fn place(&self, reference: f64, below: f64) -> Result<SpringDepth, FrictionError> {
        self.curve.place(reference, below).ok_or(FrictionError::BeyondProfile { depth: reference - below })
    }

    /// The vertex on the axis of springs that are `behind` the present slide.
    fn axis(&self, behind: f64) -> Turn {
        Turn { place: SpringDepth::AXIS, slide: self.at.slide, behind, slope: 0.0, sum: 0.0 }
    }

    /// Depth below `to` and displacement of the spring at a vertex, the latter divided by m.
    fn seen(&self, turn: &Turn, to: Pose) -> Node {
        let displacement = ((to.slide - turn.slide) + turn.behind) / self.reach;
        Node { place: turn.place, below: turn.place.below(to.indentation), displacement }
    }

    fn advance_in_contact(&mut self, to: Pose) -> Result<(), FrictionError> {
        if to == self.at && self.turns.len() > 1 {
            return Ok(());
        }
        let cut = self.cut(to)?;
        self.stick = cut.corner.map_or(cut.end.place, |corner| corner.place);
        self.dissipated += self.slip_work(&cut, to)?;
        self.turns.truncate(cut.kept);
        self.turns.extend(cut.corner);
        match self.turns.last_mut() {
            Some(last) if last.slope.to_bits() == cut.end.slope.to_bits() && last.place.depth() > 0.0 => {
                *last = cut.end
            }
            _ => self.turns.push(cut.end),
        }
        self.at = to;
        Ok(())
    }

    /// What stays of the memory when the contact moves to `to`.
    fn cut(&self, to: Pose) -> Result<Cut, FrictionError> {
        let kept = self.turns.partition_point(|turn| self.seen(turn, to).is_inside());
        let end = self.place(to.indentation, 0.0)?;
        let inner = kept.checked_sub(1).and_then(|k| self.turns.get(k));
        let (corner, inner, slope) = match (inner, self.turns.get(kept)) {
            (Some(&inner), None) => (None, inner, self.seen(&inner, to).chord()),
            (Some(inner), Some(outer)) => {
                let (below, side) = mantle(self.seen(inner, to), self.seen(outer, to), outer.slope);
                let place = self.place(to.indentation, below)?;
                let sum = inner.sum + outer.slope * self.curve.increment((inner.place, place));
                let behind = side * self.reach * below;
                let corner = Turn { place, slide: to.slide, behind, slope: outer.slope, sum };
                (Some(corner), corner, side)
            }
            (None, outer) => {
                let side = outer.map_or(1.0, |outer| self.seen(outer, to).displacement.signum());
                let axis = Turn { slide: to.slide, ..self.axis(side * self.reach * to.indentation) };
                (Some(axis), axis, side)
            }
        };
        let sum = inner.sum + slope * self.curve.increment((inner.place, end));
        Ok(Cut { kept, corner, end: Turn { place: end, slide: to.slide, behind: 0.0, slope, sum } })
    }

    /// Energy [J] the springs lose that slip on the way to `to`.
    fn slip_work(&self, cut: &Cut, to: Pose) -> Result<f64, FrictionError> {
        let Some(corner) = cut.corner else { return Ok(0.0) };
        let motion = SlideStep {
            depth: to.indentation - self.at.indentation,
            slide: (to.slide - self.at.slide) / self.reach,
            edge: cut.end.place,
        };
        // From the outermost spring that took part: the new edge of a growing contact, else the old one.
        let mut chain = self.turns.iter().skip(cut.kept).rev();
        let outermost = if motion.depth > 0.0 { None } else { chain.next() };
        let mut upper = self.seen(outermost.unwrap_or(&cut.end), to);
        let mut work = 0.0;
        for turn in chain {
            let lower = self.seen(turn, to);
            work += slip_work(&self.curve, (lower, upper), motion);
            upper = lower;
        }
        if cut.kept > 0 {
            work += slip_work(&self.curve, (self.seen(&corner, to), upper), motion);
        }
        Ok(2.0 * self.grip.coefficient * self.grip.normal_modulus * self.reach * work)
    }

    /// Where the indenter is.
    #[must_use]
    pub fn position(&self) -> Pose {
        self.at
    }

    /// Moduli and friction.
    #[must_use]
    pub fn grip(&self) -> Grip {
        self.grip
    }

    /// Number of turning points in memory.
    #[must_use]
    pub fn turning_points(&self) -> usize {
        self.turns.len()
    }

    /// Present state.
    #[must_use]
    pub fn state(&self) -> TangentialState {
        TangentialState {
            tangential_force: self.force(self.turns.last().map_or(0.0, |end| end.sum)),
            contact_radius: self.contact_radius,
            stick_radius: self.stick.radius,
            stiffness: 2.0 * self.grip.tangential_modulus * self.stick.radius,
            dissipated: self.dissipated,
        }
    }

    fn force(&self, sum: f64) -> f64 {
        2.0 * self.grip.coefficient * self.grip.normal_modulus * sum
    }

    /// Elastic energy stored in tangential deformation, G* ∫₀^a v² dx [J].
    #[must_use]
    pub fn stored(&self) -> f64 {
        let square = |pair: &[Turn]| {
            let [lower, upper] = [0, 1].map(|k| self.seen(&pair[k], self.at).displacement);
            let product = LinearProduct { first: (lower, upper), second: (lower, upper) };
            self.curve.integral((pair[0].place, pair[1].place), product)
        };
        let sum: f64 = self.turns.windows(2).map(square).sum();
        self.grip.coefficient * self.grip.normal_modulus * self.reach * sum
    }
}

impl TangentialMemory {
    /// The tangential force [N] a straight step to `to` would lead to, without taking it.
    ///
    /// # Errors
    /// The indentation leaves the profile.
    pub fn force_at(&self, to: Pose) -> Result<f64, FrictionError> {
        if to.indentation <= 0.0 || self.reach <= 0.0 {
            return Ok(0.0);
        }
        if self.at.indentation <= 0.0 {
            let mut touched = self.clone();
            touched.advance(to)?;
            return Ok(touched.state().tangential_force);
        }
        Ok(self.force(self.cut(to)?.end.sum))
    }

    /// Tangential displacement v(x) [m] of the spring at the distance `x` ≥ 0 [m] from the axis.
    #[must_use]
    pub fn displacement(&self, x: f64) -> f64 {
        if x > self.contact_radius { 0.0 } else { self.displacement_at(self.curve.profile.reduced(x)) }
    }

    fn displacement_at(&self, depth: f64) -> f64 {
        let k = self.turns.partition_point(|turn| turn.place.depth() < depth);
        let Some(upper) = self.turns.get(k) else { return 0.0 };
        let rise = upper.place.depth() - depth;
        (self.at.slide - upper.slide) + upper.behind + self.reach * upper.slope * rise
    }

    /// Shear stress τ [Pa] at the radii `radii` [m].
    ///
    /// τ(r) = μ Σ σₖ Δpₖ(r), Δpₖ the pressure between two depths, and at a vertical wall the edge
    /// term q_x(a)/(π√(a²−r²)), infinite at the wall itself. Zero outside the contact.
    #[must_use]
    pub fn shear_stress(&self, radii: &[f64]) -> Vec<f64> {
        let limit = self.grip.coefficient * self.grip.normal_modulus;
        let wall = self.curve.wall_below(self.at.indentation);
        let edge = |r: f64| {
            wall.filter(|wall| r <= wall.radius).map_or(0.0, |wall| {
                let load = self.grip.tangential_modulus * self.displacement_at(wall.depth());
                load * self.curve.profile.edge_pressure(r, wall.radius)
            })
        };
        let pieces = |r: f64| {
            let share = |pair: &[Turn]| pair[1].slope * self.curve.pressure(r, (pair[0].place, pair[1].place));
            limit * self.turns.windows(2).map(share).sum::<f64>()
        };
        radii.iter().map(|&r| pieces(r) + edge(r)).collect()
    }
}

/// The position on the straight line at which the bodies touch or part.
fn crossing(from: Pose, to: Pose) -> Pose {
    let fraction = from.indentation / (from.indentation - to.indentation);
    Pose { indentation: 0.0, slide: from.slide + fraction * (to.slide - from.slide) }
}

/// Where a piece of slope `slope` leaves the cone: depth below the apex, and the side.
///
/// Counted from the vertex nearer to the apex, which has the fewest digits to lose. The side of a
/// spring still in contact is the sign of its displacement; a piece that ends at springs already left
/// may cross both sides, and leaves by the one it reaches first on its way outwards. A piece parallel
/// to a side lies on it up to rounding: any corner between its ends will do.
fn mantle(inner: Node, outer: Node, slope: f64) -> (f64, f64) {
    if outer.below > 0.0 {
        let side = outer.displacement.signum();
        return (on_side(side, (inner, outer), slope), side);
    }
    let [forward, backward] = [1.0, -1.0].map(|side| on_side(side, (inner, outer), slope));
    match forward.total_cmp(&backward) {
        Ordering::Greater => (forward, 1.0),
        Ordering::Less => (backward, -1.0),
        // At the apex both meet: the side is that of the springs beyond, so that mirrored histories mirror.
        Ordering::Equal => (forward, outer.displacement.signum()),
    }
}

/// Depth below the apex at which a piece of slope `slope` meets the side `side` of the cone, between its vertices.
fn on_side(side: f64, (inner, outer): (Node, Node), slope: f64) -> f64 {
    let size = |node: &Node| node.below.abs() + node.displacement.abs();
    let near = if size(&inner) < size(&outer) { inner } else { outer };
    let (lowest, highest) = (outer.below.max(0.0), inner.below.max(0.0));
    let below = (side * near.displacement - side * slope * near.below) / (1.0 - side * slope);
    if below.is_nan() { lowest } else { below.clamp(lowest, highest) }
}

#[cfg(test)]
mod tests {
    use super::super::bed::CoulombBed;
    use super::super::fretting::FrettingMap;
    use super::*;
    use crate::input::quantity::{Length, Positive};
    use crate::shape::{Cone, FlatPunch, Paraboloid, Power, RoundedCone, RoundedPunch, TruncatedParaboloid};
    use proptest::prelude::*;

    fn shapes() -> [Arc<dyn Profile>; 4] {
        [
            Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() }),
            Arc::new(Cone { slope: Positive::new(0.7).unwrap() }),
            Arc::new(Power { coefficient: Positive::new(0.4).unwrap(), exponent: Positive::new(3.3).unwrap() }),
            Arc::new(RoundedPunch { flat_radius: Length::new(0.4).unwrap(), edge_radius: Length::new(0.5).unwrap() }),
        ]
    }

    fn grip(coefficient: f64) -> Grip {
        Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient }
    }

    fn at(indentation: f64, slide: f64) -> Pose {
        Pose { indentation, slide }
    }

    /// Normal force at a depth.
    fn load(profile: &dyn Profile, d: f64) -> f64 {
        2.0 * profile.load_integral(profile.edge(d).unwrap())
    }

    /// F_x = μ[F(d) − F(g(c))] with u_x = m (d − g(c)), for any shape and c.
    #[test]
    fn first_loading_is_cattaneo_mindlin() {
        for profile in shapes() {
            let mut memory = TangentialMemory::new(profile.clone(), grip(0.3));
            memory.advance(at(1.0, 0.0)).unwrap();
            let a = profile.edge(1.0).unwrap();
            for k in 1..=20 {
                let c = a * (1.0 - 0.05 * f64::from(k));
                let slide = memory.reach * (1.0 - profile.reduced(c));
                memory.advance(at(1.0, slide)).unwrap();
                let state = memory.state();
                let exact = 0.3 * (load(profile.as_ref(), 1.0) - load(profile.as_ref(), profile.reduced(c)));
                assert!((state.tangential_force / exact - 1.0).abs() < 1e-13);
                // c from the small remaining depth near the axis: an absolute error of rounding of d.
                assert!((profile.reduced(state.stick_radius) - profile.reduced(c)).abs() < 4e-16);
            }
            assert!(memory.turning_points() <= 3);
        }
    }

    #[test]
    fn without_friction_there_is_no_force_and_with_infinite_friction_no_slip() {
        for profile in shapes() {
            let mut smooth = TangentialMemory::new(profile.clone(), grip(0.0));
            let mut rough = TangentialMemory::new(profile.clone(), grip(1e12));
            for memory in [&mut smooth, &mut rough] {
                memory.advance(at(1.0, 0.0)).unwrap();
                memory.advance(at(1.0, 3.0)).unwrap();
            }
            let (none, all) = (smooth.state(), rough.state());
            assert!(none.tangential_force.abs() <= 0.0 && none.dissipated.abs() <= 0.0);
            // 2G*a u_x, short of it by the annulus of depth u/m = 2.4e-12 only.
            let stuck = 2.0 * 0.8 * all.contact_radius * 3.0;
            assert!((all.tangential_force / stuck - 1.0).abs() < 3e-12);
        }
    }

    /// A flat punch sticks as a whole, F_x = 2G*b u, and slips as a whole at μF; its shear stress is
    /// F_x/(2πb√(b²−r²)).
    #[test]
    fn a_flat_punch_holds_or_slips_as_a_whole() {
        let punch = FlatPunch { radius: Length::new(0.5).unwrap() };
        let mut memory = TangentialMemory::new(Arc::new(punch.clone()), grip(0.3));
        memory.advance(at(0.2, 0.0)).unwrap();
        memory.advance(at(0.2, 0.07)).unwrap();
        let state = memory.state();
        assert!((state.tangential_force / (2.0 * 0.8 * 0.5 * 0.07) - 1.0).abs() < 1e-14);
        assert!((state.stick_radius - 0.5).abs() <= 0.0 && state.dissipated.abs() <= 0.0);
        let stress = memory.shear_stress(&[0.3])[0];
        assert!((stress / (state.tangential_force / (2.0 * std::f64::consts::PI * 0.5 * 0.4)) - 1.0).abs() < 1e-14);
        assert!((memory.stored() / (0.5 * state.tangential_force * 0.07) - 1.0).abs() < 1e-14);
        memory.advance(at(0.2, 0.1)).unwrap();
        // Limit μE*d/G* = 0.075: it has slipped 0.025 under μF = 0.06.
        let state = memory.state();
        assert!((state.tangential_force / 0.06 - 1.0).abs() < 1e-14);
        assert!(state.stick_radius.abs() <= 0.0);
        assert!((state.dissipated / (0.025 * 0.06) - 1.0).abs() < 1e-13);
    }

    /// Shapes with a flat, a wall, an edge or ripples: F_x, the energy and the stress are those of the
    /// springs, by the same laws as above.
    #[test]
    fn shapes_with_corners_keep_the_laws() {
        let length = |x: f64| Length::new(x).unwrap();
        let shapes: [Arc<dyn Profile>; 3] = [
            Arc::new(TruncatedParaboloid { flat_radius: length(0.4), radius: length(1.0) }),
            Arc::new(RoundedPunch { flat_radius: length(0.4), edge_radius: length(0.5) }),
            Arc::new(RoundedCone { radius: length(1.0), slope: Positive::new(0.5).unwrap() }),
        ];
        for profile in &shapes {
            let mut memory = TangentialMemory::new(profile.clone(), grip(0.3));
            memory.advance(at(0.3, 0.0)).unwrap();
            for part in [0.2, 0.9, 0.4, -0.3, 0.1, -0.95, 1.5, 1.0 - 1e-9] {
                memory.advance(at(0.3, part * 0.3 * memory.reach)).unwrap();
                let a = memory.state().contact_radius;
                let springs = 200_000;
                let width = a / f64::from(springs);
                let sum: f64 = (0..springs).map(|k| memory.displacement((f64::from(k) + 0.5) * width)).sum();
                let force = 2.0 * 0.8 * width * sum;
                // Midpoint rule: half a cell of the variation at worst, μE*dΔx.
                let bound = 0.3 * 0.3 * width;
                assert!((memory.state().tangential_force - force).abs() < bound);
                // F_x = ∫ τ 2πr dr: Gauss in r² with the root at the edge taken out by r = a sin θ.
                let turn = std::f64::consts::FRAC_PI_2 / 4000.0;
                let radii: Vec<f64> = (0..4000).map(|k| a * ((f64::from(k) + 0.5) * turn).sin()).collect();
                let stress = memory.shear_stress(&radii);
                let ring =
                    |(r, stress): (&f64, &f64)| 2.0 * std::f64::consts::PI * r * stress * (a * a - r * r).sqrt() * turn;
                let whole: f64 = radii.iter().zip(&stress).map(ring).sum();
                // Midpoint rule across the roots at stick borders: Δθ^{3/2} of the load.
                assert!(
                    (whole - memory.state().tangential_force).abs() < 1e-4 * 0.3 * load(profile.as_ref(), 0.3),
                    "{whole}"
                );
            }
        }
    }

    /// Random histories: knots (depth in [-0.2, 1.2], slide within ±3 m) from integers.
    fn history() -> impl Strategy<Value = (i32, Vec<(i32, i32)>)> {
        (-20i32..20, prop::collection::vec((-2i32..12, -30i32..30), 1..24))
    }

    fn positions(coefficient: f64, knots: &[(i32, i32)]) -> Vec<Pose> {
        let reach = grip(coefficient).reach();
        knots.iter().map(|&(d, u)| at(0.1 * f64::from(d), 0.1 * f64::from(u) * reach)).collect()
    }

    /// Held against each other: the loss of the memory, and the sum over a map of springs.
    fn summed_and_lost(k: i32, knots: &[(i32, i32)]) -> Result<(), TestCaseError> {
        let coefficient = 10f64.powf(0.1 * f64::from(k));
        for profile in shapes() {
            let (n, radius) = (2000, profile.edge(1.3).unwrap());
            let cell = radius / f64::from(n);
            let middles: Vec<f64> = (0..n).map(|k| (f64::from(k) + 0.5) * cell).collect();
            let mut map = FrettingMap::new(profile.as_ref(), grip(coefficient), &middles);
            let mut memory = TangentialMemory::new(profile.clone(), grip(coefficient));
            for to in positions(coefficient, knots) {
                memory.advance(to).unwrap();
                map.advance(to);
            }
            let springs = map.energy();
            let sum: f64 = springs.iter().map(|energy| energy * cell).sum();
            let variation: f64 = springs.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
            let bound = cell * (variation + springs[0]) + 1e-15 * coefficient * memory.reach;
            prop_assert!((memory.state().dissipated - sum).abs() <= bound, "{} {sum}", memory.state().dissipated);
        }
        Ok(())
    }

    /// A flat that is lifted while all of it slips, to where the bodies just part and, but for its rounding, nothing is slid.
    #[test]
    fn a_flat_slips_until_it_is_lifted() {
        summed_and_lost(-19, &[(8, 26), (11, 7), (2, 20), (0, 0)]).unwrap();
    }

    proptest! {
        #![proptest_config(crate::laws::cases(64))]

        /// Every spring of the bed and of the memory carries the same, |q_x| ≤ μq, and the forces
        /// agree within the bound of the bed, μE*dΔx.
        #[test]
        fn memory_is_the_bed((k, knots) in history()) {
            let coefficient = 10f64.powf(0.1 * f64::from(k));
            for profile in shapes() {
                let radius = profile.edge(1.3).unwrap();
                let mut memory = TangentialMemory::new(profile.clone(), grip(coefficient));
                let mut bed = CoulombBed::new(profile.as_ref(), grip(coefficient), 500.try_into().unwrap(), radius).unwrap();
                for to in positions(coefficient, &knots) {
                    memory.advance(to).unwrap();
                    let force = bed.advance(&[to])[0];
                    let bound = coefficient * to.indentation.max(0.0) * radius / 500.0;
                    prop_assert!((memory.state().tangential_force - force).abs() <= bound * (1.0 + 1e-9) + 1e-15 * coefficient);
                    for (k, (v, depth)) in bed.displacements().iter().zip(bed.depths()).enumerate() {
                        let exact = memory.displacement((k as f64 + 0.5) * radius / 500.0);
                        let limit = memory.reach * (to.indentation - depth).max(0.0);
                        prop_assert!(exact.abs() <= limit + 1e-15 * memory.reach);
                        prop_assert!((v - exact).abs() <= 4e-15 * memory.reach, "{v} {exact}");
                    }
                }
            }
        }

        /// Dissipation never falls, and is the work of the force less the energy stored.
        #[test]
        fn dissipation_closes_the_ledger((k, knots) in history()) {
            let coefficient = 10f64.powf(0.1 * f64::from(k));
            for profile in shapes() {
                let mut memory = TangentialMemory::new(profile.clone(), grip(coefficient));
                let (mut work, mut bound) = (0.0, 0.0);
                let stiffness = 2.0 * 0.8 * profile.edge(1.2).unwrap();
                for to in positions(coefficient, &knots) {
                    let before = memory.state().dissipated;
                    let from = memory.position();
                    // Simpson's rule in steps. Where the memory closes a loop or contact is lost, F_x has
                    // a kink of at most twice its slope 2G*a(|Δu| + mΔd), which costs 1/24 of it;
                    // a knot brings one vertex and wipes it out later, gross slip and parting are two more.
                    let steps = 64;
                    let (slide, depth) = (to.slide - from.slide, to.indentation - from.indentation);
                    let part = f64::from(steps).recip();
                    let kink = 2.0 / 24.0 * stiffness * (slide.abs() + memory.reach * depth.abs()) * slide.abs();
                    bound += 4.0 * kink * part * part;
                    for j in 0..steps {
                        let way = |t: f64| at(from.indentation + t * depth, from.slide + t * slide);
                        let middle = way((f64::from(j) + 0.5) * part);
                        let end = way((f64::from(j) + 1.0) * part);
                        let forces = [memory.state().tangential_force, memory.force_at(middle).unwrap()];
                        let start = memory.position().slide;
                        memory.advance(end).unwrap();
                        let last = memory.state().tangential_force;
                        work += (end.slide - start) / 6.0 * (forces[0] + 4.0 * forces[1] + last);
                    }
                    prop_assert!(memory.state().dissipated >= before);
                }
                let ledger = memory.state().dissipated + memory.stored();
                let rounding = 1e-13 * (ledger.abs() + bound);
                prop_assert!((ledger - work).abs() <= bound + rounding, "{ledger:e} {work:e} {bound:e}");
            }
        }

        /// The map of springs sums to the loss of the memory, within a cell of its variation.
        #[test]
        fn the_map_sums_to_the_loss((k, knots) in history()) {
            summed_and_lost(k, &knots)?;
        }

        /// The mirrored history gives the mirrored force, to the last bit.
        #[test]
        fn reversing_all_slides_reverses_the_force((k, knots) in history()) {
            let coefficient = 10f64.powf(0.1 * f64::from(k));
            for profile in shapes() {
                let mut memory = TangentialMemory::new(profile.clone(), grip(coefficient));
                let mut mirror = memory.clone();
                for to in positions(coefficient, &knots) {
                    memory.advance(to).unwrap();
                    mirror.advance(at(to.indentation, -to.slide)).unwrap();
                    let (state, other) = (memory.state(), mirror.state());
                    prop_assert!((state.tangential_force + other.tangential_force).abs() <= 0.0);
                    prop_assert!((state.dissipated - other.dissipated).abs() <= 0.0, "{:e} {:e}", state.dissipated, other.dissipated);
                    prop_assert!((state.stick_radius - other.stick_radius).abs() <= 0.0);
                }
            }
        }
    }
}
