//! What is seen of the bed under a body that moves along.

use super::outline::Outline;
use super::{GlidingBed, Touched, integer, signed};
use crate::contact::viscoelastic::spring::{Free, Spring};
use crate::shape::Profile;

/// A place of the contact: its distance from the middle of the body [m], displacement [m] and load [N/m].
#[derive(Debug, Clone, Copy)]
struct Loaded {
    at: f64,
    displacement: f64,
    load: f64,
}

/// Where a contact ends: its last spring, and the edge.
#[derive(Debug, Clone, Copy)]
struct End {
    last: Loaded,
    edge: Loaded,
}

/// A spring beyond the contact, if it were met at once.
#[derive(Debug, Clone, Copy)]
struct Met {
    /// Its gap [m], which would be gone.
    gap: f64,
    /// What its dashpot would carry [N/m].
    damping: f64,
    /// What it would carry [N/m].
    load: f64,
}

/// Slope g′ of a profile at a distance `at` [m] from its middle.
fn slope_at(profile: &dyn Profile, at: f64) -> f64 {
    if at.abs() > 0.0 { profile.reduced_slope(at.abs()).copysign(at) } else { 0.0 }
}

/// Number, displacement [m] and load [N/m] of a spring that is pressed.
type Pressed = (i64, f64, f64);

impl GlidingBed {
    /// The number of the cell in which the body is, and the part of its chord at which every spring is.
    pub(super) fn now_below(&self) -> (i64, f64) {
        let cells = self.cells(self.now.place);
        // Of a spring below a corner the chord it came from.
        let cell = if self.moved.along > 0.0 { cells.ceil() - 1.0 } else { cells.floor() };
        (integer(cell), 1.0 - (cells - cell))
    }

    /// The springs that are pressed, in order.
    pub(super) fn pressed(&self) -> impl DoubleEndedIterator<Item = Pressed> + '_ {
        let below = self.below();
        let load = move |(at, touched): (usize, &Touched)| {
            let Spring::Pressed(loads) = &touched.spring else { return None };
            let j = self.first + signed(at);
            let (displacement, slope) = below(j);
            let speed = self.moved.down + self.moved.along * slope;
            Some((j, displacement, self.spectrum().load(displacement, loads, speed)))
        };
        self.springs.iter().enumerate().filter_map(load)
    }

    /// How deep [m] the chord above a spring is at its place, and its slope there: that of a round profile itself, of which
    /// the slope of the chord is of first order alone.
    fn below(&self) -> impl Fn(i64) -> (f64, f64) + '_ {
        let (cell, part) = self.now_below();
        let damped = self.spectrum().viscosity() > 0.0;
        move |j| {
            let (low, high) = (self.outline.height(j - cell - 1), self.outline.height(j - cell));
            let slope = match &self.outline {
                Outline::Round { profile, .. } if damped => slope_at(profile.as_ref(), self.distance(j)),
                Outline::Round { .. } | Outline::Line(_) => (high - low) / self.width,
            };
            (self.now.depth - (low + part * (high - low)), slope)
        }
    }

    /// Distance [m] of the spring `j` from the middle of the body.
    fn distance(&self, j: i64) -> f64 {
        (j as f64 + self.outline.offset()) * self.width - self.now.place
    }

    /// Normal force F and resistance F_x [N].
    pub(super) fn forces(&self) -> (f64, f64) {
        match &self.outline {
            Outline::Round { profile, .. } => (self.force(), self.resistance(profile.as_ref())),
            Outline::Line(_) => self.forces_of_line(),
        }
    }

    /// Normal force F [N] alone.
    pub(super) fn force(&self) -> f64 {
        match &self.outline {
            Outline::Round { profile, .. } => self.integral(profile.as_ref(), |place| place.load),
            Outline::Line(_) => self.forces_of_line().0,
        }
    }

    /// F_x [N] under a round profile: of the part of E∞ it is known in closed form.
    fn resistance(&self, profile: &dyn Profile) -> f64 {
        let modulus = self.spectrum().equilibrium();
        let rest = |place: Loaded| (place.load - modulus * place.displacement) * slope_at(profile, place.at);
        self.integral(profile, rest) + 0.5 * modulus * self.rise(profile)
    }

    /// Integral over a contact under a round profile of what goes straight from spring to spring and on to the edges: second
    /// order in the width, and without a jump where a spring is touched or let go.
    fn integral(&self, profile: &dyn Profile, what: impl Fn(Loaded) -> f64) -> f64 {
        let springs =
            self.pressed().map(|(j, displacement, load)| what(Loaded { at: self.distance(j), displacement, load }));
        let at_end = |End { last, edge }: End| {
            let (inner, outer) = (what(last), what(edge));
            0.5 * ((edge.at - last.at).abs() * (inner + outer) - self.width * inner)
        };
        let ends: f64 = self.ends(profile).into_iter().flatten().map(at_end).sum();
        0.0 + self.width * springs.sum::<f64>() + ends
    }

    /// 2∫ u g′ dξ over the contact: u² at its rear less that at its front [m²].
    fn rise(&self, profile: &dyn Profile) -> f64 {
        let Some(ends) = self.ends(profile) else { return 0.0 };
        let [front, rear] = ends.map(|end| end.edge.displacement.max(0.0));
        (rear - front) * (rear + front)
    }

    /// Where the contact of a round body ends [m] on the side of larger and of smaller places.
    pub(super) fn edges(&self) -> Option<(f64, f64)> {
        let Outline::Round { profile, .. } = &self.outline else { return None };
        self.ends(profile.as_ref()).map(|[front, rear]| (front.edge.at, rear.edge.at))
    }

    /// The ends of a contact under a round profile on the side of larger and of smaller places.
    fn ends(&self, profile: &dyn Profile) -> Option<[End; 2]> {
        let mut all = self.pressed();
        let rear = all.next()?;
        let front = all.next_back().unwrap_or(rear);
        Some([self.end_of(profile, front, 1), self.end_of(profile, rear, -1)])
    }

    /// The end on the side `side`, beyond the last spring that is pressed.
    ///
    /// On ground never touched it is where the profile meets it. Else it is between two springs, found with what the next
    /// one would carry if it were met now, q = η(v − u̇) − E(0) gap: at the edge that is zero, and it falls beyond as the load
    /// does inside. Where the body closes upon a dashpot, which is met at its full load, it is where the gap beyond closes.
    fn end_of(&self, profile: &dyn Profile, last: Pressed, side: i64) -> End {
        let inner = Loaded { at: self.distance(last.0), displacement: last.1, load: last.2 };
        let next = self.if_met(last.0 + side);
        let (closing, damped) = (next.damping > 0.0, self.spectrum().viscosity() > 0.0);
        let fresh = self.free(last.0 + side).is_none() && (closing || !damped);
        let untouched = if fresh { profile.edge(self.now.depth) } else { None };
        let falls = || inner.load / (inner.load - next.load);
        let part = if closing { self.closed(next.gap, last.0 + side, side) } else { falls() };
        let part = if part.is_finite() { part.clamp(0.0, 1.0) } else { 0.5 };
        let at = untouched.map_or(inner.at + side as f64 * part * self.width, |edge| edge * side as f64);
        let displacement = self.now.depth - profile.reduced(at.abs());
        End { last: inner, edge: Loaded { at, displacement, load: next.damping.max(0.0) } }
    }

    /// The part of the way from a spring to the one beyond it, j, at which a gap closes that is `gap` [m] there.
    fn closed(&self, gap: f64, j: i64, side: i64) -> f64 {
        1.0 - gap / (self.if_met(j + side).gap - gap)
    }

    /// The spring j if it were met now.
    fn if_met(&self, j: i64) -> Met {
        let (displacement, slope) = self.below()(j);
        let (spectrum, speed) = (self.spectrum(), self.moved.down + self.moved.along * slope);
        let (recovered, recovering) = self.free(j).map_or((0.0, 0.0), |(known, free)| {
            let since = (self.now.time - known).max(0.0);
            (spectrum.recovered(free, since), spectrum.recovery_speed(free, since))
        });
        let gap = recovered - displacement;
        let damping = spectrum.viscosity() * (speed - recovering);
        Met { gap, damping, load: damping - spectrum.instantaneous() * gap }
    }

    /// The spring j where it has been touched and is free, and the time [s] up to which it is known.
    fn free(&self, j: i64) -> Option<(f64, &Free)> {
        let touched = self.springs.get(usize::try_from(j - self.first).ok()?)?;
        match &touched.spring {
            Spring::Free(free) if !touched.spring.is_untouched() => Some((touched.known, free)),
            Spring::Free(_) | Spring::Pressed(_) => None,
        }
    }

    /// Energy [J] in all springs.
    pub(super) fn stored(&self) -> f64 {
        let pressed = self.pressed().map(|(j, displacement, _)| {
            let touched = self.index(j).and_then(|at| self.springs.get(at));
            match touched.map(|touched| &touched.spring) {
                Some(Spring::Pressed(loads)) => self.spectrum().stored_pressed(displacement, loads),
                Some(Spring::Free(_)) | None => 0.0,
            }
        });
        let free = self.springs.iter().map(|touched| touched.stored_free(self.spectrum(), self.now.time));
        self.width * (pressed.sum::<f64>() + free.sum::<f64>())
    }

    /// Stiffness dF/dd [N/m] at once.
    pub(super) fn stiffness(&self) -> f64 {
        self.stiffness_after(0.0)
    }

    /// What is left of it the time `t` [s] after a step of the depth.
    pub(super) fn stiffness_after(&self, t: f64) -> f64 {
        self.spectrum().relaxation(t) * self.width * self.pressed().count() as f64
    }

    /// By what the force grows with the speed down [N s/m]: of the dashpots that are pressed.
    pub(super) fn damping(&self) -> f64 {
        self.spectrum().viscosity() * self.width * self.pressed().count() as f64
    }

    /// Stiffness [N/m] of the first few springs, from which a contact begins.
    pub(super) fn stiffness_of_touch(&self) -> f64 {
        2.0 * self.spectrum().instantaneous() * self.width
    }
}
