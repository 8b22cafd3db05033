//! Searches for the place at which the edge comes to rest or turns.

use super::{BESIDE, EdgePhase, Front, Way};
use crate::numerics::{extremum, root};

/// First step of the search for the edge, and the longest, relative to where it is.
const FIRST_STEP: f64 = 1e-5;
const LONGEST_STEP: f64 = 1.0 / 24.0;
/// The longest step inwards under an attraction, relative to the distance from the axis.
const LONGEST_INWARDS: f64 = 0.25;
impl Front<'_> {
    /// The next place of a search that way, `step` further [m]; `None` where there is none.
    ///
    /// Springs of another past have other limits at once: a search stops on both sides of each border.
    pub(super) fn further(&self, way: Way, x: f64, step: f64) -> Option<f64> {
        let (there, to) = match way {
            Way::Opening => (x > 0.0, (x - step).max(0.0)),
            Way::Closing => (x < self.limit, (x + step).min(self.limit)),
        };
        let ahead = |&border: &f64| match way {
            Way::Opening => border < x && to < border * (1.0 + BESIDE),
            Way::Closing => border > x && to > border * (1.0 - BESIDE),
        };
        // The nearest that way, or none.
        let nearest = match way {
            Way::Opening => self.borders.partition_point(|&border| border < x).checked_sub(1),
            Way::Closing => Some(self.borders.partition_point(|&border| border <= x)),
        };
        let next = nearest.and_then(|k| self.borders.get(k).copied()).filter(ahead);
        let stop = |border: f64| {
            let (near, far) = match way {
                Way::Opening => (border * (1.0 + BESIDE), border * (1.0 - BESIDE)),
                Way::Closing => (border * (1.0 - BESIDE), border * (1.0 + BESIDE)),
            };
            // Where two borders lie side by side, a place may be beside both: it is the one ahead that counts.
            if is_beside(x, border) { far } else { near }
        };
        there.then(|| next.map_or(to, stop))
    }

    /// The border beside which `x` is, if it is beside one.
    pub(super) fn border_at(&self, x: f64) -> Option<f64> {
        let first = self.borders.partition_point(|&border| border < x && !is_beside(x, border));
        self.borders.get(first).copied().filter(|&border| is_beside(x, border))
    }

    /// Steps of a search: from fine to coarse, and fine again beyond a border; inwards under an attraction too, for the
    /// radius at which a contact collapses may be a small part of the one it had.
    pub(super) fn longer(&self, way: Way, step: f64, x: f64) -> f64 {
        let first = self.first_step();
        if self.border_at(x).is_some() {
            // The first step of an edge all but at the axis would be below the rounding of the border.
            return FIRST_STEP * x.max(self.start_length());
        }
        let longest = if self.edge > 0.0 { LONGEST_STEP * self.edge.max(x) } else { 0.5 * x };
        let inwards =
            if way == Way::Opening && self.attraction.is_some() { LONGEST_INWARDS * x } else { f64::INFINITY };
        (1.7 * step).min(longest.min(inwards).max(first)).min(0.25 * self.feature)
    }

    /// The first step [m] of a search.
    pub(super) fn first_step(&self) -> f64 {
        FIRST_STEP * self.start_length()
    }

    /// A length [m] with which a search from the axis begins.
    fn start_length(&self) -> f64 {
        if self.edge > 0.0 { self.edge } else { 1e-3 * self.scale }
    }

    /// Where an edge that jumps comes to rest, from `x` on.
    pub(super) fn landing(&self, way: Way, mut x: f64) -> f64 {
        let urge = |x: f64| self.candidate(way, x).urge(self.spectrum, 0.0);
        let mut step = self.first_step();
        while let Some(next) = self.further(way, x, step) {
            if urge(next) <= 0.0 {
                return root::brent(urge, x.min(next), x.max(next)).unwrap_or(next);
            }
            x = next;
            step = self.longer(way, step, x);
        }
        x
    }

    /// The edge comes to an end between two places: the first has its instant, the other has not.
    pub(super) fn ends(&self, way: Way, inside: f64, outside: f64) -> EdgePhase {
        let top = |x: f64| self.top(&self.candidate(way, x));
        let missing = |x: f64| -top(x).value;
        let to = match root::brent(missing, inside.min(outside), inside.max(outside)) {
            Ok(to) if missing(inside) < 0.0 => to,
            _ => inside,
        };
        EdgePhase::Moves { to, duration: top(to).place, passed: Vec::new() }
    }

    /// The edge gets ahead of itself between two places: it moves to where the instants are latest, or to the first
    /// spring between that has none.
    pub(super) fn folds(&self, way: Way, before: f64, next: f64) -> EdgePhase {
        let at = |x: f64| self.first(&self.candidate(way, x)).unwrap_or(self.motion.duration);
        let latest = extremum::greatest(at, before.min(next), before.max(next));
        if self.first(&self.candidate(way, latest.place)).is_none() {
            return self.ends(way, before, latest.place);
        }
        EdgePhase::Moves { to: latest.place, duration: latest.value, passed: Vec::new() }
    }
}

/// Whether a place is beside a border.
fn is_beside(x: f64, border: f64) -> bool {
    (x - border).abs() <= 1.5 * BESIDE * border
}

#[cfg(test)]
mod tests {
    use super::super::super::laws::unit_ball;
    use super::super::super::spring::{Motion, Spring};
    use super::super::{SightedSpring, Spectrum, instants};
    use super::*;
    use crate::material::Relaxation;

    /// Calls `told` with the way a search goes over `borders` from beside an edge.
    fn searching(edge: f64, borders: &[f64], told: impl Fn(&Front<'_>)) {
        let spectrum = Spectrum::new(&Relaxation { equilibrium: 1.0, terms: vec![(1.0, 1.0)], viscosity: 0.0 });
        let see = |_: Way, _: f64| SightedSpring { spring: Spring::untouched(&spectrum), height: 0.0, doubt: 0.0 };
        told(&Front {
            spectrum: &spectrum,
            attraction: None,
            see: &see,
            fails: &|| false,
            profile: &unit_ball(),
            edge,
            limit: 2.0,
            borders,
            scale: 1.0,
            feature: f64::INFINITY,
            motion: Motion { start: 0.0, speed: 1.0, duration: 1.0 },
            least: 0.0,
            instantly: 1e-12,
            instants: instants(&spectrum, 1.0),
        });
    }

    /// Borders within the rounding of each other, three of them beside the edge itself: a search gets past them all, each
    /// place of it beyond the last one.
    #[test]
    fn a_search_gets_past_borders_side_by_side() {
        for ulps in 0..40 {
            let apart = 1.0 + f64::EPSILON * f64::from(ulps);
            let borders = [0.5 / apart, 0.5, 0.5 * apart, 1.0, apart, apart * apart];
            searching(0.5, &borders, |front| {
                for (way, sign, mut x) in [(Way::Closing, 1.0, 0.4), (Way::Opening, -1.0, 1.1)] {
                    let mut places = 0;
                    while let Some(next) = front.further(way, x, 0.05) {
                        assert!(sign * (next - x) > 0.0 && places < 60, "{ulps} {way:?}: {x:e} {next:e}");
                        (x, places) = (next, places + 1);
                    }
                }
            });
        }
    }

    /// An edge that has all but come to the axis looks out of a contact of before, which ended far from there.
    #[test]
    fn a_search_gets_past_a_border_from_next_to_the_axis() {
        searching(1e-18, &[1e-3, 0.5], |front| {
            let (mut x, mut step, mut places) = (front.edge, front.first_step(), 0);
            while let Some(next) = front.further(Way::Closing, x, step) {
                assert!(next > x && places < 2000, "{x:e} {next:e}");
                (x, places) = (next, places + 1);
                step = front.longer(Way::Closing, step, x);
            }
        });
    }
}
