use super::*;
use crate::numerics::normal::Below;
use proptest::prelude::*;
use std::f64::consts::PI;

fn springs(deviation: f64, (work, closing): (f64, f64)) -> Bed {
    Bed { number: 1.0, deviation, element: Element::Spring(Spring { stiffness: 1.0, work, closing }) }
}

fn summits(deviation: f64, work: f64) -> Bed {
    Bed { number: 1.0, deviation, element: Element::Summit(Summit { radius: 1.0, modulus: 1.0, work }) }
}

/// Elements one by one, each with its own height and its own memory.
struct Single {
    element: Element,
    height: f64,
    weight: f64,
    joined: bool,
    lost: f64,
}

impl Single {
    /// The elements of a bed, `count` of them at the middles of equal shares.
    fn of(bed: &Bed, count: usize) -> Vec<Self> {
        let share = |part: f64| crate::numerics::root::brent(|t| Below::of(t).share - part, -9.0, 9.0).unwrap();
        let middle = |k: usize| bed.deviation * share((k as f64 + 0.5) / count as f64);
        let weight = bed.number / count as f64;
        (0..count).map(|k| Self { element: bed.element, height: middle(k), weight, joined: false, lost: 0.0 }).collect()
    }

    fn to(&mut self, d: f64) {
        let (Hold { joins, leaves }, u) = (self.element.hold(), d - self.height);
        let energy = |u: f64| self.weight * self.element.carried(u).stored.stored();
        if !self.joined && u >= -joins {
            self.lost -= energy(-joins);
            self.joined = true;
        } else if self.joined && u < -leaves {
            self.lost += energy(-leaves);
            self.joined = false;
        }
    }

    fn force(&self, d: f64) -> f64 {
        if self.joined { self.weight * self.element.carried(d - self.height).force } else { 0.0 }
    }
}

proptest! {
    #![proptest_config(crate::laws::cases(24))]
    /// The sums are those of the elements one by one, each with its own memory, on any way.
    #[test]
    fn the_pad_is_its_elements_one_by_one(kind in 0i32..3, work in 0i32..9, ways in proptest::collection::vec(-40i32..25, 5)) {
        let work = 0.25 * f64::from(work);
        let bed = match kind {
            0 => springs(1.0, (work, 0.0)),
            1 => springs(1.0, (work, 0.25 * work)),
            _ => summits(1.0, work),
        };
        let (mut pad, mut singles) = (Pad::new(bed), Single::of(&bed, 4000));
        let mut depth = pad.depth;
        for way in ways {
            let to = 0.1 * f64::from(way);
            // The elements themselves are led in small steps, so that each joins and leaves where it does.
            for k in 1..=200 {
                let d = depth + (to - depth) * f64::from(k) / 200.0;
                singles.iter_mut().for_each(|single| single.to(d));
            }
            depth = to;
            pad.to(to);
            let force: f64 = singles.iter().map(|single| single.force(to)).sum();
            let lost: f64 = singles.iter().map(|single| single.lost).sum();
            // Heights in the middles of 4000 shares: the outermost stand for all beyond, and an edge cuts a share.
            let edge = bed.element.carried(-bed.hold().leaves).force.abs().max(1.0) / 4000.0;
            let scale = 1.0 + to.abs();
            prop_assert!((pad.state().force - force).abs() < 2.0 * edge + 2e-4 * scale, "{bed:?} {to}: {} {force}", pad.state().force);
            prop_assert!((pad.lost - lost).abs() < 3.0 * edge * (1.0 + work), "{bed:?} {to}: {} {lost}", pad.lost);
        }
    }

    /// What is done is stored or lost, on any way by depth.
    #[test]
    fn work_is_stored_or_lost(kind in 0i32..3, work in 0i32..9, to in -35i32..20, back in -60i32..-20) {
        let work = 0.25 * f64::from(work);
        let bed = match kind {
            0 => springs(1.0, (work, 0.0)),
            1 => springs(1.0, (work, 0.5 * work)),
            _ => summits(1.0, work),
        };
        let mut pad = Pad::new(bed);
        let (from, to, back) = (pad.depth, 0.1 * f64::from(to), 0.1 * f64::from(back));
        let mut done = 0.0;
        for (from, to) in [(from, to), (to, back)] {
            let start = pad.clone();
            // Kinks stand where elements begin to join or to leave.
            let Hold { joins, leaves } = bed.hold();
            let mut kinks = [start.edge - leaves, start.edge - joins];
            if to < from {
                kinks = [to.max(kinks[0].min(from)), to.max(kinks[1].min(from))];
            }
            let mut breaks = vec![from, to];
            breaks.extend(kinks.into_iter().filter(|kink| (kink - from) * (kink - to) < 0.0));
            breaks.sort_by(f64::total_cmp);
            let force = |d: f64| { let mut pad = start.clone(); pad.to(d); pad.state().force };
            let area: f64 = breaks.windows(2)
                .map(|part| crate::numerics::quadrature::equal_panels(force, (part[0], part[1]), 0.5))
                .sum();
            done += if to > from { area } else { -area };
            pad.to(to);
        }
        let state = pad.state();
        let kept = state.stored.stored() + state.dissipated;
        // The root at the turning point of a summit leaves the rule 1e-7 of it.
        prop_assert!((kept - done).abs() < 1e-7 * (1.0 + work) , "{bed:?}: {kept} {done}");
    }

    /// A force finds the depth that carries it, and what it does is stored or lost.
    #[test]
    fn a_force_finds_its_depth(kind in 0i32..2, work in 0i32..12, load in 1i32..40, back in -5i32..30) {
        // What hardly adheres never pulls.
        let work = [0.0, 1e-8, 1e-5, 1e-2].get(usize::try_from(work).unwrap()).copied().unwrap_or(0.25 * f64::from(work - 3));
        let bed = if kind == 0 { springs(1.0, (work, 0.5 * work)) } else { summits(1.0, work) };
        let mut pad = Pad::new(bed);
        let (load, back) = (0.1 * f64::from(load), 0.05 * f64::from(back));
        // Held, and with the rounding of records, it stays where it is.
        for rounding in [0.0, 0.0, 2e-16, -2e-16, 1e-12, 0.0] {
            pad.under(load * (1.0 + rounding));
            prop_assert!((pad.state().force / load - 1.0).abs() < 1e-11);
        }
        let least = pad.path().least_below(pad.depth).map_or(0.0, |turn| pad.path().force(turn));
        pad.under(back);
        let greatest = least;
        if back > greatest && back < load && back != 0.0 {
            prop_assert!((pad.state().force - back).abs() < 1e-11 * load.max(1.0), "{}", pad.state().force);
        }
        prop_assert!(pad.lost >= -1e-12);
    }
}

/// All touched, springs are pulled off with Φ(t) = (s/σ)φ(t), t = (d + s)/σ, F = kσφ(t)[1 + (t − λ)λ]; along the way out
/// no state carries less.
#[test]
fn springs_are_pulled_off_by_mills_ratio() {
    for lambda in [0.3, 1.0, 2.0, 5.0, 20.0] {
        let bed = springs(1.0, (0.5 * lambda * lambda, 0.0));
        let mut least = f64::INFINITY;
        let mut pad = Pad::new(bed);
        pad.to(8.0);
        for k in 0..4000 {
            pad.to(8.0 - lambda - 12.0 * f64::from(k) / 4000.0);
            least = least.min(pad.state().force);
        }
        let greatest = bed.greatest_pull();
        assert!(greatest <= least && greatest > least * (1.0 + 1e-4), "{lambda}: {greatest} {least}");
    }
    // Mills's ratio at t = 0 is √(π/2): λ = √(π/2) parts at F = kσφ(0)(1 − π/2).
    let bed = springs(1.0, (0.25 * PI, 0.0));
    let exact = (1.0 - 0.5 * PI) / (2.0 * PI).sqrt();
    assert!((bed.greatest_pull() / exact - 1.0).abs() < 1e-14, "{}", bed.greatest_pull());
}

/// Of flat pads all elements let go at once: springs with ks, summits with 3πwR/2.
#[test]
fn flat_pads_let_go_as_one() {
    let spring = |sigma: f64| springs(sigma, (2.0, 0.0)).greatest_pull();
    assert!((spring(1e-4) + 2.0).abs() < 1e-3 && (spring(1e-6) + 2.0).abs() < 1e-5);
    let summit = |sigma: f64| summits(sigma, 1.0).greatest_pull();
    // They come off one after the other, but near their least force: second order in σ.
    assert!((summit(1e-2) / (-1.5 * PI) - 1.0).abs() < 1e-4, "{}", summit(1e-2));
    assert!((summit(1e-3) / (-1.5 * PI) - 1.0).abs() < 1e-6, "{}", summit(1e-3));
}

/// Without adhesion F = (4/3)E*√R σ^{3/2} ∫(z − h)^{3/2} φ dz, A = πRσ ∫(z − h) φ dz (Greenwood & Williamson 1966): 25-digit numbers.
#[test]
fn summits_without_adhesion_are_greenwood_and_williamsons() {
    let mut pad = Pad::new(summits(1.0, 0.0));
    let known = [
        (1.0, 0.083_315_470_587_7, 0.075_668_177_391),
        (2.0, 0.008_490_702_616_83, 0.006_648_177_623_59),
        (3.0, 0.000_382_154_317_048, 0.000_263_967_554_269),
    ];
    for (h, first, root) in known.into_iter().rev() {
        pad.to(-h);
        assert!((pad.state().force / (4.0 / 3.0 * root) - 1.0).abs() < 1e-11, "{h}");
        assert!((pad.pieces().unwrap().area.unwrap() / (PI * first) - 1.0).abs() < 1e-11, "{h}");
    }
}

/// Rough pads adhere the less the more their heights scatter (Fuller & Tabor 1975): half of it is left where the deviation
/// is the stretch at which a summit lets go, next to nothing at four times that.
#[test]
fn roughness_takes_adhesion_away() {
    let stretch = summits(1.0, 1.0).hold().leaves;
    let pulls: Vec<f64> =
        [0.01, 0.3, 1.0, 2.0, 4.0].map(|of| summits(of * stretch, 1.0).greatest_pull() / (-1.5 * PI)).to_vec();
    assert!(pulls.windows(2).all(|pair| pair[1] < pair[0]), "{pulls:?}");
    assert!(pulls[0] > 0.999 && (pulls[2] - 0.5).abs() < 0.01 && pulls[4] < 0.01, "{pulls:?}");
}

/// A force that leads in is carried where the dip of joining summits is passed; one that leads out of the unstable part
/// of the way jumps back. Both lose energy, and the state carries the force.
#[test]
fn summits_jump_in_and_back_under_a_force() {
    let mut pad = Pad::new(summits(0.1, 1.0));
    let jumps = pad.under(0.5);
    assert!(jumps.len() == 1 && jumps[0].before.force.abs() < 1e-9 && pad.lost > 0.0);
    assert!((pad.state().force - 0.5).abs() < 1e-12);
    // Past the least force, led by depth: more than there is carried further in only.
    let turn = pad.path().least_below(pad.depth).unwrap();
    pad.to(turn - 0.3);
    let (weak, lost) = (pad.state().force, pad.lost);
    let jumps = pad.under(weak + 0.1);
    assert!(jumps.len() == 1 && pad.depth > turn && pad.lost > lost);
    assert!((pad.state().force - weak - 0.1).abs() < 1e-11);
}
