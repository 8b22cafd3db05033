//! Figures like those of the program, from closed forms.

use std::f64::consts::PI;

use super::super::*;

pub(super) fn all() -> Vec<(&'static str, Figure)> {
    vec![
        ("hertz", hertz()),
        ("jkr", jkr()),
        ("work-precision", work_precision()),
        ("moduli", moduli()),
        ("restitution", restitution()),
        ("time", time()),
        ("awkward", awkward()),
    ]
}

fn grid(n: u32) -> impl DoubleEndedIterator<Item = f64> + Clone {
    (0..=n).map(move |i| f64::from(i) / f64::from(n))
}

/// Steel ball, R = 10 mm, E* = 231 GPa, pressed in by 1 µm.
fn hertz() -> Figure {
    let (modulus, radius, deepest) = (231e9, 0.01, 1e-6);
    let force = |d: f64| 4.0 / 3.0 * modulus * (radius * d * d * d).sqrt();
    let edge = (radius * deepest).sqrt();
    let down: Vec<f64> = grid(500).map(|t| t * deepest).collect();
    let up: Vec<f64> = down.iter().rev().copied().collect();
    let both = |f: &dyn Fn(f64) -> f64| {
        let curve = |d: &[f64]| d.iter().map(|d| (*d, f(*d))).collect::<Vec<_>>();
        (curve(&down), curve(&up))
    };
    let depth = || Axis::linear("indentation d", "m");
    let (fd, fu) = both(&force);
    let (ad, au) = both(&|d| (radius * d).sqrt());
    let peak = 2.0 / PI * modulus * (deepest / radius).sqrt();
    let pressure = grid(300).map(|t| (t * edge, peak * (1.0 - t * t).max(0.0).sqrt()));
    let shape = |k: f64| grid(200).map(move |t| (1.3 * t * edge, k * (1.3 * t * edge).powi(2) / radius));
    Figure::new("Steel ball on a rigid flat")
        .with(
            Panel::new(depth(), Axis::linear("force F", "N"))
                .with(Series::new("approach", fd).arrow())
                .with(Series::new("retract", fu).arrow()),
        )
        .with(
            Panel::new(depth(), Axis::linear("contact radius a", "m"))
                .with(Series::new("approach", ad).arrow())
                .with(Series::new("retract", au).arrow()),
        )
        .with(
            Panel::new(Axis::linear("radius r", "m"), Axis::linear("pressure p", "Pa"))
                .with(Series::new("at the largest depth, d = 1 µm", pressure))
                .guide(Guide::vertical(edge, "edge a"))
                .guide(Guide::horizontal(peak, "peak 1.47 GPa")),
        )
        .with(
            Panel::new(Axis::linear("radius r, coordinate x", "m"), Axis::linear("height", "m"))
                .with(Series::new("shape f(r)", shape(0.5)))
                .with(Series::new("one-dimensional profile g(x)", shape(1.0)))
                .guide(Guide::horizontal(deepest, "depth d")),
        )
}

/// Lens of Persson: R = 2.5 mm, E = 4.8 MPa, w = 0.042 J/m².
fn jkr() -> Figure {
    let (modulus, radius, work) = (6.4e6f64, 2.5e-3, 0.042);
    let depth = |a: f64| a * a / radius - (2.0 * PI * a * work / modulus).sqrt();
    let force = |a: f64| 4.0 / 3.0 * modulus * a.powi(3) / radius - (8.0 * PI * modulus * work * a.powi(3)).sqrt();
    let scale = (9.0 * PI * work * radius * radius / (8.0 * modulus)).cbrt();
    let (least, first, last) =
        (0.303 * scale * 1.19, (2.0 * PI * work * radius * radius / modulus).cbrt(), 3.0 * scale);
    let stable = |from: f64| grid(400).map(move |t| from + t * (last - from));
    let parted = depth(least);
    let air = [(parted * 1.5, 0.0), (0.0, 0.0), (f64::NAN, f64::NAN)];
    let approach =
        |f: &dyn Fn(f64) -> f64| air.into_iter().chain(stable(first).map(|a| (depth(a), f(a)))).collect::<Vec<_>>();
    let retract = |f: &dyn Fn(f64) -> f64| {
        let back = stable(least).rev().map(|a| (depth(a), f(a)));
        back.chain([(f64::NAN, 0.0), (parted, 0.0), (parted * 1.5, 0.0)]).collect::<Vec<_>>()
    };
    let pressure = grid(600).map(|t| t * last).map(|r| {
        let root = (1.0 - (r / last).powi(2)).sqrt();
        (r, 2.0 * modulus * last / (PI * radius) * root - (2.0 * modulus * work / (PI * last)).sqrt() / root)
    });
    let d = || Axis::linear("indentation d", "m");
    let shape = |k: f64| grid(200).map(move |t| (1.2 * t * last, k * (1.2 * t * last).powi(2) / radius));
    Figure::new("Soft PDMS lens on glass: adhesion after Johnson, Kendall and Roberts")
        .with(
            Panel::new(d(), Axis::linear("force F", "N"))
                .with(Series::new("approach", approach(&force)).arrow())
                .with(Series::new("retract", retract(&force)).arrow())
                .guide(Guide::Jump { from: (0.0, 0.0), to: (0.0, force(first)) })
                .guide(Guide::Jump { from: (parted, force(least)), to: (parted, 0.0) })
                .note("Dotted: jumps into and out of contact at prescribed depth; energy lost 3.1 nJ and 1.2 nJ."),
        )
        .with(
            Panel::new(d(), Axis::linear("contact radius a", "m"))
                .with(Series::new("approach", approach(&|a| a)).arrow())
                .with(Series::new("retract", retract(&|a| a)).arrow()),
        )
        .with(
            Panel::new(Axis::linear("radius r", "m"), Axis::linear("pressure p", "Pa").from(-1.5e5))
                .with(Series::new("at the largest depth", pressure))
                .guide(Guide::vertical(last, "edge a"))
                .note("Singular at the edge: K = 13.1 kPa·√m; cut off below −150 kPa."),
        )
        .with(
            Panel::new(Axis::linear("radius r, coordinate x", "m"), Axis::linear("height", "m"))
                .with(Series::new("shape f(r)", shape(0.5)))
                .with(Series::new("one-dimensional profile g(x)", shape(1.0))),
        )
}

fn work_precision() -> Figure {
    let names = [
        "direct path",
        "springs, edge located",
        "springs, edges counted",
        "lazy bed",
        "direct bed",
        "explicit Euler",
        "half-space, FFT",
        "half-space, multigrid",
    ];
    let mut panel = Panel::new(Axis::log("relative error of the force", "1"), Axis::log("run time", "s"))
        .guide(Guide::slope(-1.0, "slope −1"))
        .guide(Guide::slope(-0.5, "slope −1/2"));
    for (i, name) in (0..).zip(names) {
        let i = f64::from(i);
        let order = 0.35 + 0.11 * i;
        let points = (0..7)
            .map(f64::from)
            .map(|k| (10f64.powf(-1.5 - 0.25 * i - 1.1 * k), 10f64.powf(-7.0 + 0.55 * i + 1.1 * k * order)));
        panel = panel.with(Series::new(name, points).marks(Marks::Numbered));
    }
    Figure::new("Work and precision: Hertz contact").with(panel)
}

fn moduli() -> Figure {
    let omega = || grid(600).map(|t| 10f64.powf(-9.0 + 18.0 * t));
    let terms: Vec<(f64, f64)> =
        (0..30).map(|k| (10f64.powf(4.0 + 0.17 * f64::from(k)), 10f64.powf(8.0 - 0.57 * f64::from(k)))).collect();
    let sum = |w: f64, f: &dyn Fn(f64) -> f64| terms.iter().map(|(g, t)| g * f(w * t)).sum::<f64>();
    let storage = omega().map(|w| (w, sum(w, &|x| x * x / (1.0 + x * x))));
    let loss = omega().map(|w| (w, sum(w, &|x| x / (1.0 + x * x))));
    let relax = omega().map(|t| (t, terms.iter().map(|(g, tau)| g * (-t / tau).exp()).sum::<f64>()));
    Figure::new("Polyisobutylene, 30 Prony terms")
        .with(
            Panel::new(Axis::log("time t", "s"), Axis::log("relaxation modulus G", "Pa").from(1e-2))
                .with(Series::new("G(t)", relax)),
        )
        .with(
            Panel::new(Axis::log("angular frequency ω", "rad/s"), Axis::log("modulus", "Pa"))
                .with(Series::new("storage G′", storage))
                .with(Series::new("loss G″", loss)),
        )
}

fn restitution() -> Figure {
    let speed = || grid(100).map(|t| 10f64.powf(-2.7 + 1.5 * t));
    let stick = 0.012;
    let adhesive = speed().map(|v| (v, (1.0 - (stick / v).powi(2)).max(0.0).sqrt()));
    let viscous = speed().map(|v| (v, 1.0 - 0.3 * v.powf(0.2)));
    let measured: Vec<_> = (0..12)
        .map(|i| 0.011 * 1.28f64.powi(i))
        .map(|v| (v, (1.0 - (stick / v).powi(2)).max(0.0).sqrt() * 0.97))
        .collect();
    let panel = Panel::new(
        Axis::log("approach speed v", "m/s"),
        Axis::linear("restitution coefficient e", "1").from(0.0).to(1.05),
    )
    .with(Series::new("adhesive, e = √(1 − (vₛ/v)²)", adhesive))
    .with(Series::new("viscoelastic", viscous))
    .with(Series::new("measured", measured).line(Line::Absent).marks(Marks::As(Mark::Ring)))
    .guide(Guide::vertical(stick, "sticking speed vₛ"))
    .guide(Guide::horizontal(1.0, "elastic"));
    Figure::new("Rubber ball on glass").with(panel)
}

fn time() -> Figure {
    let t = || grid(20_000).map(|t| t * 0.02);
    let force = t().map(|t| (t, 2e-8 * (1.0 - (-t / 4e-3).exp()) + 1e-9 * (2e4 * t).sin()));
    let radius = t().map(|t| (t, 3e-7 * t.cbrt()));
    let looped = grid(50_000).map(|t| t * 600.0).map(|p| (1e-6 + 2e-7 * p.sin(), 3e-9 * (p + 0.4).sin()));
    Figure::new("Oscillating indentation")
        .with(Panel::new(Axis::linear("time t", "s"), Axis::linear("force F", "N")).with(Series::new("", force)))
        .with(
            Panel::new(Axis::linear("time t", "s"), Axis::linear("contact radius a", "m"))
                .with(Series::new("", radius)),
        )
        .with(
            Panel::new(Axis::linear("indentation d", "m"), Axis::linear("force F", "N"))
                .with(Series::new("loop", looped).arrow()),
        )
}

fn awkward() -> Figure {
    let panel = |name: &str, points: &[(f64, f64)]| {
        Panel::new(Axis::linear("distance", "m"), Axis::linear("force", "N"))
            .titled(name)
            .with(Series::new("data", points.to_vec()))
    };
    let log = |points: &[(f64, f64)]| {
        Panel::new(Axis::log("speed", "m/s"), Axis::log("error", "1"))
            .titled("logarithmic")
            .with(Series::new("data", points.to_vec()).marks(Marks::Numbered))
    };
    Figure::new("A very long title that a user wrote without thinking of the width of the figure, and which goes on for so long that it must be wrapped to several lines; nothing of it may be cut off, not even Donaudampfschifffahrtselektrizitätenhauptbetriebswerkbauunterbeamtengesellschaft")
        .with(panel("one point", &[(1e-6, 2.0)]))
        .with(panel("constant", &[(0.0, 5.0), (1.0, 5.0)]))
        .with(panel("empty", &[]))
        .with(panel("tiny and huge", &[(1e-300, 1e300), (3e-300, -1e300)]))
        .with(panel("nearly constant", &[(0.0, 1.0), (1.0, 1.0 + 3e-6), (2.0, 1.0 - 3e-6)]))
        .with(panel("negative", &[(-5e4, -3.0), (-1e4, -2.0)]))
        .with(log(&[(1e-3, 1e-16), (0.0, 1e-10), (2e-3, 1e-2), (5e-3, -1.0)]))
        .with(log(&[(1.0, 1.0), (1.1, 1.05), (1.2, 1.15)]))
        .with(log(&[(1e-9, 1e-300), (1e9, 1e300)]))
}
