//! What is seen of the bed under a body that moves along.

use super::outline::Outline;
use super::{GlidingBed, Touched, integer, signed};
use crate::contact::viscoelastic::spring::Spring;
use crate::shape::Profile;

/// What a spring at a distance [m] from the middle of the body carries and holds back, both over its width [N/m].
#[derive(Debug, Clone, Copy)]
struct Loads {
    at: f64,
    normal: f64,
    along: f64,
}

impl Loads {
    /// What lies between `half` a width beyond this spring, the last one, and the edge, as it is drawn on from the one before.
    fn up_to(self, before: Self, (edge, half): (f64, f64)) -> Self {
        let border = self.at + half;
        let (way, middle) = ((edge - border) * half.signum(), 0.5 * (edge + border));
        let on = (middle - self.at) / (self.at - before.at);
        let drawn = |last: f64, before: f64| way * (last + on * (last - before));
        Self { at: middle, normal: drawn(self.normal, before.normal), along: drawn(self.along, before.along) }
    }
}

impl GlidingBed {
    /// The number of the cell in which the body is, and the part of its chord at which every spring is.
    pub(super) fn now_below(&self) -> (i64, f64) {
        let cells = self.cells(self.now.place);
        // Of a spring below a corner the chord it came from.
        let cell = if self.moved.along > 0.0 { cells.ceil() - 1.0 } else { cells.floor() };
        (integer(cell), 1.0 - (cells - cell))
    }

    /// The springs that are pressed: their distance from the middle of the body [m], displacement [m] and load [N/m].
    pub(super) fn pressed(&self) -> impl DoubleEndedIterator<Item = (i64, f64, f64)> + '_ {
        let (cell, part) = self.now_below();
        let load = move |(at, touched): (usize, &Touched)| {
            let Spring::Pressed(loads) = &touched.spring else { return None };
            let j = self.first + signed(at);
            let (low, high) = (self.outline.height(j - cell - 1), self.outline.height(j - cell));
            let speed = self.moved.down + self.moved.along * (high - low) / self.width;
            let displacement = self.now.depth - (low + part * (high - low));
            Some((j, displacement, self.spectrum().load(displacement, loads, speed)))
        };
        self.springs.iter().enumerate().filter_map(load)
    }

    /// Distance [m] of the spring `j` from the middle of the body.
    fn distance(&self, j: i64) -> f64 {
        (j as f64 + self.outline.offset()) * self.width - self.now.place
    }

    /// Normal force F and resistance F_x [N].
    pub(super) fn forces(&self) -> (f64, f64) {
        match &self.outline {
            Outline::Round { profile, .. } => self.forces_of_round(profile.as_ref()),
            Outline::Line(_) => self.forces_of_line(),
        }
    }

    /// Those under a round profile.
    ///
    /// Of F_x the part of E∞ is known in closed form. The rest, and F, are sums over the springs, each of which stands for
    /// its width, and what lies between the last of them and the edge: second order in the width.
    fn forces_of_round(&self, profile: &dyn Profile) -> (f64, f64) {
        let modulus = self.spectrum().equilibrium();
        let loads = |(j, displacement, load): (i64, f64, f64)| {
            let at = self.distance(j);
            let slope = if at.abs() > 0.0 { profile.reduced_slope(at.abs()).copysign(at) } else { 0.0 };
            Loads { at, normal: load, along: (load - modulus * displacement) * slope }
        };
        let springs: Vec<Loads> = self.pressed().map(loads).collect();
        let sums = springs.iter().fold((0.0, 0.0), |sums, spring| (sums.0 + spring.normal, sums.1 + spring.along));
        let (mut normal, mut along) = (self.width * sums.0, self.width * sums.1);
        if let ([first, .., last], Some((front, rear))) = (&springs[..], self.edges_of(profile)) {
            let (second, before) = (springs[1], springs[springs.len() - 2]);
            for rest in [last.up_to(before, (front, 0.5 * self.width)), first.up_to(second, (rear, -0.5 * self.width))]
            {
                normal += rest.normal;
                along += rest.along;
            }
        }
        (normal, along + 0.5 * modulus * self.rise(profile))
    }

    /// 2∫ u g′ dξ over the contact: u² at its rear less that at its front [m²].
    fn rise(&self, profile: &dyn Profile) -> f64 {
        let Some((front, rear)) = self.edges_of(profile) else { return 0.0 };
        let displacement = |at: f64| (self.now.depth - profile.reduced(at.abs())).max(0.0);
        (displacement(rear) - displacement(front)) * (displacement(rear) + displacement(front))
    }

    /// Where the contact of a round body ends [m].
    pub(super) fn edges(&self) -> Option<(f64, f64)> {
        match &self.outline {
            Outline::Round { profile, .. } => self.edges_of(profile.as_ref()),
            Outline::Line(_) => None,
        }
    }

    /// Where the contact ends on the side of larger and of smaller places [m]: on ground never touched where the profile
    /// meets it, else between two springs where the load goes to zero.
    fn edges_of(&self, profile: &dyn Profile) -> Option<(f64, f64)> {
        let mut all = self.pressed().map(|(j, _, load)| (j, load));
        let front = (all.next_back()?, all.next_back());
        let mut all = self.pressed().map(|(j, _, load)| (j, load));
        let rear = (all.next()?, all.next());
        Some((self.edge(profile, front, 1), self.edge(profile, rear, -1)))
    }

    fn edge(&self, profile: &dyn Profile, (last, before): ((i64, f64), Option<(i64, f64)>), side: i64) -> f64 {
        let outside = usize::try_from(last.0 + side - self.first).ok().and_then(|at| self.springs.get(at));
        if outside.is_none_or(|touched| touched.spring.is_untouched())
            && let Some(edge) = profile.edge(self.now.depth)
        {
            return edge * side as f64;
        }
        let part = before.map_or(0.5, |before| (last.1 / (before.1 - last.1)).clamp(0.0, 1.0));
        let part = if part.is_finite() { part } else { 0.5 };
        self.distance(last.0) + side as f64 * part * self.width
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
        self.spectrum().instantaneous() * self.width * self.pressed().count() as f64
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
