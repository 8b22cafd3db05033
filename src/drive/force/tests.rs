//! A prescribed force against exact creep, Hertz, JKR and Kelvin & Voigt.

use super::*;
use crate::contact::model::{Event, Glance, Loading};
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::attraction::Attraction;
use crate::contact::viscoelastic::continuous::ContinuousContact;
use crate::contact::viscoelastic::growing::GrowingBed;
use crate::contact::viscoelastic::laws::unit_ball;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::memory::Memory;
use crate::material::Relaxation;
use crate::shape::Profile;
use std::sync::Arc;

fn solid() -> Arc<Spectrum> {
    let terms = vec![(3.0, 0.3), (2.0, 5.0)];
    Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.0 }))
}

/// A ball on a damped body that adheres, led to depths [m] within times [s].
fn led(ways: &[(f64, f64)]) -> ContinuousContact {
    let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms: vec![(0.5, 0.1)], viscosity: 1.0 }));
    let attraction = Attraction::relaxed(0.01, &spectrum).to_accuracy(1e-6);
    let mut contact = ContinuousContact::new(Memory::new(spectrum, Arc::new(unit_ball())).with(attraction));
    for &(depth, duration) in ways {
        contact.follow(&Straight::between(depth_of(&contact), depth, duration)).unwrap();
    }
    contact
}

/// The same, pushed from -1 to 1 N then.
fn pushed_after(ways: &[(f64, f64)]) -> Normal {
    let mut contact = led(ways);
    let ramp = Ramp { from: -1.0, rate: 1.0, accuracy: 1e-5, scale: 1.0, stiffness: 0.0 };
    let (mut drive, mut now) = (ForceDrive::new(ramp, 2.0, None, true), 0.0);
    loop {
        let here = contact.state();
        let Some(piece) = drive.next(&mut contact, &here).unwrap() else { break };
        contact.follow(&ahead(&contact, piece.speed, piece.until - now)).unwrap();
        now = piece.until;
    }
    contact.state()
}

/// A damped contact that adheres is drawn in as it touches, and what its dashpot takes then does not depend on the gap it
/// came from, which is closed in no time: from undented bodies, and beside the floor of a dent, where it has filled up
/// when the force begins to push. Bound: the accuracy asked for; beside a dent, whose pieces are others each time, ten
/// times that.
#[test]
fn a_gap_costs_a_dashpot_nothing() {
    let (press, part, at_once) = ((0.3, 1.0), (-0.1, 1.0), 1e-12);
    // The touch as the bodies meet a second later, between the floor of the dent and its brim.
    let meets = |depth: f64| led(&[press, part, part, (depth, at_once)]).joined();
    let (mut near, mut far) = (0.0, 0.3);
    while far - near > 1e-14 {
        let middle = 0.5 * (near + far);
        *(if meets(middle) { &mut far } else { &mut near }) = middle;
    }
    let dented = (pushed_after(&[press, part, (near, at_once)]), pushed_after(&[press, part]));
    let undented = (pushed_after(&[(0.0, 1.0)]), pushed_after(&[(-0.1, 1.0)]));
    assert!(near > 0.01, "{near}");
    for ((near, far), bound) in [(undented, 1e-6), (dented, 1e-4)] {
        let depths = far.indentation.zip(near.indentation).map(|(far, near)| far / near - 1.0);
        let off = (far.dissipated / near.dissipated - 1.0).abs().max(depths.unwrap().abs());
        assert!(near.contact_radius.unwrap() > 0.5 && off < bound, "{off:e} {near:?} {far:?}");
    }
}

/// Sudden load: a³ = (3R/4) F J(t). Bound: rounding, and the ramp of 1e-12 s.
#[test]
fn creep_under_a_sudden_load() {
    let spectrum = solid();
    let creep = Creep::new(spectrum.clone(), Arc::new(unit_ball())).after(1e-3, 1e-12);
    for t in [0.0, 1e-6, 0.1, 1.0, 30.0, 1e9] {
        let cube = creep.after(1e-3, t).indentation().unwrap().powf(1.5);
        let exact = 0.75e-3 * spectrum.creep(t);
        assert!((cube / exact - 1.0).abs() < 1e-11, "{t}: {cube:e} {exact:e}");
    }
}

/// The bed driven to a force against the exact creep. Bound: the accuracy asked for, and the cells.
#[test]
fn driven_creep_is_exact_creep() {
    let (spectrum, ball): (_, Arc<dyn Profile>) = (solid(), Arc::new(unit_ball()));
    let exact = Creep::new(spectrum.clone(), ball.clone());
    let layout = Layout::graded(ball.as_ref(), (1e-3, 0.1), 2000);
    let mut bed = GrowingBed::new(spectrum, ball, layout);
    let up = press(
        &mut bed,
        &Ramp { from: 0.0, rate: 1e-3, accuracy: 1e-5, scale: 1e-3, stiffness: 0.0 },
        &[0.25, 0.5, 1.0],
    )
    .unwrap();
    let held = press(
        &mut bed,
        &Ramp { from: 1e-3, rate: 0.0, accuracy: 1e-5, scale: 1e-3, stiffness: 0.0 },
        &[0.1, 1.0, 10.0],
    )
    .unwrap();
    let top = exact.after(1e-3, 1.0);
    let expected = [0.25, 0.5, 1.0].map(|t| exact.after(1e-3 * t, t));
    let expected = expected.into_iter().chain([0.1, 1.0, 10.0].map(|t| top.after(1e-3, t)));
    for (seen, exact) in up.iter().chain(&held).zip(expected) {
        let d = exact.indentation().unwrap();
        let depth = seen.indentation.unwrap();
        assert!((depth / d - 1.0).abs() < 3e-5, "{depth} {d}");
    }
}

/// A spring of the stiffness 1 that presses a second one as well from a depth on, as where an edge jumps over a dent.
#[derive(Clone)]
struct Stepped {
    depth: f64,
    jumps_at: f64,
}

impl ContactModel for Stepped {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        self.depth = piece.to;
        Ok(Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let jump = if piece.to >= self.jumps_at { 1.0 } else { 0.0 };
        Ok(Glance { force: piece.to + jump, contact_radius: 1.0 })
    }

    fn state(&self) -> Normal {
        Normal { indentation: Some(self.depth), force: self.depth, stiffness: 1.0, ..Normal::default() }
    }

    fn joined(&self) -> bool {
        true
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }
}

/// A search that stops before a jump, by as much as it may, is led over it, either way.
#[test]
fn a_jump_is_gone_over_from_where_the_search_stops() {
    for accuracy in [1e-2, 1e-3, 1e-6] {
        let ramp = Ramp { from: 1.5, rate: 0.0, accuracy, scale: 1.5, stiffness: 0.0 };
        let drive = ForceDrive::new(ramp, 1.0, None, false);
        for (depth, found) in [(0.0, 1.0 - CLOSE * accuracy), (2.0, -1.0 + CLOSE * accuracy)] {
            let mut contact = Stepped { depth, jumps_at: 1.0 };
            let here = contact.state();
            let speed = drive.over_the_jump((&mut contact, &here), found, 1.0).unwrap();
            let is_over = |speed: f64| depth + speed >= 1.0;
            assert!(is_over(speed) != is_over(found), "{accuracy:e} from {depth}: {speed}");
        }
    }
}

/// A piece shorter than the one before that is as far off stands before a jump: the next one is no shorter still. One that
/// is nearer, or longer, tells how long the next may be.
#[test]
fn before_a_jump_pieces_do_not_dwindle() {
    let ramp = Ramp { from: 0.0, rate: 1.0, accuracy: 1e-3, scale: 1.0, stiffness: 0.0 };
    let after = |last| ForceDrive { last, ..ForceDrive::new(ramp, 1.0, None, false) };
    assert!((after(Some((0.1, 0.87))).lengthened(0.09, 0.87) - LONGER).abs() < 1e-15);
    for (last, duration, error) in
        [(None, 0.09, 0.87), (Some((0.1, 0.99)), 0.09, 0.87), (Some((0.1, 0.87)), 0.11, 0.87)]
    {
        assert!((after(last).lengthened(duration, error) - SHORTER / 0.87_f64.sqrt()).abs() < 1e-15);
    }
}

/// Unloading by force, and waiting unloaded: the force is met, the contact shrinks.
#[test]
fn unloaded_by_force() {
    let ball: Arc<dyn Profile> = Arc::new(unit_ball());
    let mut bed = ContinuousContact::new(Memory::new(solid(), ball));
    bed.follow(&Straight::between(0.0, 0.01, 1.0)).unwrap();
    let force = bed.state().force;
    let ramp = Ramp { from: force, rate: -0.5 * force, accuracy: 1e-4, scale: force, stiffness: 0.0 };
    let seen = press(&mut bed, &ramp, &[0.5, 1.0, 1.5]).unwrap();
    for (state, part) in seen.iter().zip([0.75, 0.5, 0.25]) {
        assert!((state.force / force - part).abs() < 1e-4, "{} {part}", state.force / force);
    }
    assert!(seen.windows(2).all(|pair| pair[1].contact_radius < pair[0].contact_radius));
}

/// A force that ends leaves JKR's contact under none, a³ = 9πwR²/2E*, also where all that the adhesion pulls is a part of
/// 1e-4 of the largest force, less than the accuracy. Bound: the force at the end is met to rounding, and what has not relaxed is some 1e-7.
#[test]
fn a_force_that_ends_leaves_the_contact_of_a_weak_adhesion() {
    let spectrum = solid();
    let (largest, end) = (1e-3, 1e8);
    let work = 1e-4 * largest / (1.5 * std::f64::consts::PI);
    let attraction = Attraction::relaxed(work, &spectrum);
    let mut bed = ContinuousContact::new(Memory::new(spectrum, Arc::new(unit_ball())).with(attraction));
    let up = Ramp { from: 0.0, rate: largest / end, accuracy: 1e-3, scale: largest, stiffness: 0.0 };
    let down = Ramp { from: largest, rate: -largest / end, ..up };
    press(&mut bed, &up, &[end]).unwrap();
    let left = press(&mut bed, &down, &[end]).unwrap()[0];
    let exact = (4.5 * std::f64::consts::PI * work).cbrt();
    let radius = left.contact_radius.unwrap();
    assert!(left.force.abs() < 1e-10 * largest && (radius / exact - 1.0).abs() < 1e-3, "{left:?} {exact:e}");
}

/// On the way to no force the radius is as well known as the largest, however small the contact has become: that of JKR,
/// a³ = ¾R(F + P + √(2PF + P²))/E*, P = 3πwR, or of Hertz. Bound: the accuracy, and what has not relaxed is some 1e-7.
#[test]
fn a_contact_that_shrinks_keeps_its_radius() {
    let (largest, end, accuracy) = (1e-3, 1e8, 1e-3);
    for work in [0.0, 1e-6 * largest] {
        let spectrum = solid();
        let attraction = Attraction::relaxed(work, &spectrum);
        let memory = Memory::new(spectrum, Arc::new(unit_ball()));
        let mut bed = ContinuousContact::new(if work > 0.0 { memory.with(attraction) } else { memory });
        let up = Ramp { from: 0.0, rate: largest / end, accuracy, scale: largest, stiffness: 0.0 };
        let down = Ramp { from: largest, rate: -largest / end, ..up };
        press(&mut bed, &up, &[end]).unwrap();
        let parts = [0.3, 0.5, 0.7, 0.9, 0.97, 0.99, 0.997, 0.999, 0.9997, 0.9999, 0.99997, 1.0 - 1e-7];
        let times: Vec<f64> = parts.iter().map(|part| part * end).chain([end]).collect();
        let pull = 3.0 * std::f64::consts::PI * work;
        let exact = |force: f64| (0.75 * (force + pull + (2.0 * pull * force + pull * pull).sqrt())).cbrt();
        for (state, t) in press(&mut bed, &down, &times).unwrap().iter().zip(&times) {
            // Where nothing attracts bodies under no force just touch.
            let force = down.force(*t).max(if work > 0.0 { 0.0 } else { TOUCH * largest });
            let (radius, right) = (state.contact_radius.unwrap_or(0.0), exact(force));
            let off = (radius - right).abs() / exact(largest);
            assert!(off < accuracy, "{work:e} {:e}: {radius:e} {right:e}, {off:e}", t / end);
        }
    }
}

/// A Kelvin–Voigt body let go by a force that falls: the springs pressed reach to g(a) = d + τv, so that the depth is that
/// of Hertz, retarded: τd′ + d = (F/K)^{2/3}, K = (4/3)E*√R. Pieces are few, as those of the second order are.
#[test]
fn a_damped_contact_follows_a_falling_force() {
    const TAU: f64 = 0.1;
    let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity: TAU }));
    let ball: Arc<dyn Profile> = Arc::new(unit_ball());
    let (d, times) = (0.01, [0.1, 0.3, 0.6, 1.0]);
    let force = 4.0 / 3.0 * f64::powf(d, 1.5);
    let exact = |t: f64| {
        let hertz = |s: f64| ((s - t) / TAU).exp() * (1.0 - 0.5 * s).powf(2.0 / 3.0) / TAU;
        d * ((-t / TAU).exp() + crate::numerics::quadrature::panels(hertz, (0.0, t), &[]))
    };
    for accuracy in [1e-4, 1e-6] {
        let layout = Layout::graded(ball.as_ref(), (1e-3, 0.15), 4000);
        let mut bed = GrowingBed::new(spectrum.clone(), ball.clone(), layout);
        bed.follow(&Straight::between(0.0, d, 1.0)).unwrap();
        bed.follow(&Straight::between(d, d, 100.0)).unwrap();
        let ramp = Ramp { from: force, rate: -0.5 * force, accuracy, scale: force, stiffness: 0.0 };
        let (mut drive, mut now, mut pieces) = (ForceDrive::new(ramp, 1.0, None, false), 0.0, 0);
        let mut records = times.into_iter().peekable();
        loop {
            let here = bed.state();
            let Some(piece) = drive.next(&mut bed, &here).unwrap() else { break };
            pieces += 1;
            while let Some(t) = records.next_if(|&t| t <= piece.until) {
                bed.follow(&ahead(&bed, piece.speed, t - now)).unwrap();
                let mut seen = bed.clone();
                let instant = drive.met(&mut seen, t).unwrap().unwrap();
                seen.follow(&instant).unwrap();
                let (state, depth) = (seen.state(), exact(t));
                assert!((state.force / ramp.force(t) - 1.0).abs() < 1e-9, "{t}: {}", state.force / ramp.force(t));
                let off = (state.indentation.unwrap() / depth - 1.0).abs();
                assert!(off < 3.0 * accuracy + 1e-6, "{accuracy:e} {t}: {off:e}");
                let width = (ramp.force(t) / force).cbrt() * d.sqrt();
                assert!((state.contact_radius.unwrap() / width - 1.0).abs() < 2e-3, "{t}");
                now = t;
            }
            bed.follow(&ahead(&bed, piece.speed, piece.until - now)).unwrap();
            now = piece.until;
        }
        assert!(f64::from(pieces) < 2.0 / f64::sqrt(accuracy), "{accuracy:e}: {pieces} pieces");
    }
}

/// The same once it is let go: its surface comes up as e^{−t/τ}, however little force tells of that.
#[test]
fn a_damped_contact_that_is_let_go_comes_up() {
    const TAU: f64 = 0.1;
    let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity: TAU }));
    let ball: Arc<dyn Profile> = Arc::new(unit_ball());
    let (d, accuracy) = (0.01, 1e-3);
    let mut bed = GrowingBed::new(spectrum, ball.clone(), Layout::graded(ball.as_ref(), (1e-3, 0.15), 1000));
    bed.follow(&Straight::between(0.0, d, 1.0)).unwrap();
    bed.follow(&Straight::between(d, d, 100.0)).unwrap();
    let force = bed.state().force;
    let down = Ramp { from: force, rate: -force, accuracy, scale: force, stiffness: force / d };
    press(&mut bed, &down, &[1.0]).unwrap();
    let start = bed.state().indentation.unwrap();
    let times = [0.05, 0.1, 0.2, 0.4, 1.0, 17.0];
    let seen = press(&mut bed, &Ramp { from: 0.0, rate: 0.0, ..down }, &times).unwrap();
    for (state, t) in seen.iter().zip(times) {
        let depth = state.indentation.unwrap_or(0.0);
        let right = start * (-t / TAU).exp();
        // By a piece as by the whole: each keeps to the accuracy, and their errors fade as the depth does.
        assert!((depth - right).abs() < 4.0 * accuracy * d, "{t}: {depth:e} {right:e}");
    }
}
