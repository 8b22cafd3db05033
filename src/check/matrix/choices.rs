//! What the combinations are made of: each part as a scene writes it, with what proves it.

use super::part::Proved::{self, Case, Laws, Whole};
use crate::check::attempt::Proof::{Other, Rounding};

/// What proves a part: under a round contact, a lying one, a rough line, a plane section, on pixels, under a pad.
pub(super) type ByKind = [Proved; 6];

/// The same under all of them.
const fn all(proved: Proved) -> ByKind {
    [proved; 6]
}

/// A value of one of the parts of a scene.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Choice {
    /// What it is called in the matrix.
    pub(super) name: &'static str,
    /// How a scene writes it.
    pub(super) text: &'static str,
    pub(super) proved: ByKind,
}

const fn choice(name: &'static str, text: &'static str, proved: ByKind) -> Choice {
    Choice { name, text, proved }
}

/// What a shape is to those who compute it; its place among what proves the other parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Round,
    Lying,
    Rough,
    Section,
    Pixels,
    Pad,
}

/// Shapes, with a depth and a force that suit them.
#[derive(Debug, PartialEq)]
pub(super) struct PressedShape {
    /// What it is called in the matrix.
    pub(super) name: &'static str,
    /// How a scene writes it.
    pub(super) text: &'static str,
    pub(super) kind: Kind,
    pub(super) proved: Proved,
    /// The solver that the scene asks for, if it does.
    pub(super) solver: &'static str,
    pub(super) depth: &'static str,
    pub(super) force: &'static str,
}

impl PressedShape {
    /// Whether it is pressed on pixels.
    pub(super) fn is_on_pixels(&self) -> bool {
        !self.solver.is_empty()
    }

    /// The unit of its force.
    pub(super) fn force_unit(&self) -> &'static str {
        self.force.trim_end_matches('>').split_once(' ').map_or("N", |(_, unit)| unit)
    }
}

const fn pressed(
    (name, text): (&'static str, &'static str),
    (kind, proved): (Kind, Proved),
    depth: &'static str,
    force: &'static str,
) -> PressedShape {
    PressedShape { name, text, kind, proved, solver: "", depth, force }
}

/// A finer solver of the same kind.
pub(super) const FINER_PIXELS: &str = "solver: HalfSpace(grid: 96),";

const fn on_pixels(
    named: (&'static str, &'static str),
    proved: Proved,
    depth: &'static str,
    force: &'static str,
) -> PressedShape {
    let shape = pressed(named, (Kind::Pixels, proved), depth, force);
    PressedShape { solver: "solver: HalfSpace(grid: 32),", ..shape }
}

/// Numbers stand in `<…>` with their units, so that a scene can be written in others.
pub(super) const SHAPES: [PressedShape; 11] = [
    pressed(("ball", "Paraboloid(radius: <5e-3 m>)"), (Kind::Round, Case("hertz/steel ball")), "<1e-5 m>", "<5e-3 N>"),
    pressed(
        ("wavy ball", "WavyParaboloid(radius: <2e-2 m>, amplitude: <1e-8 m>, wavelength: <1e-4 m>)"),
        (Kind::Round, Case("shape/waviness")),
        "<1e-5 m>",
        "<1e-2 N>",
    ),
    pressed(
        ("ellipsoid", "Ellipsoid(radius_x: <5e-3 m>, radius_y: <2e-3 m>)"),
        (Kind::Round, Case("ellipsoid/mean radius")),
        "<1e-5 m>",
        "<5e-3 N>",
    ),
    pressed(
        ("lying cylinder", "Cylinder(radius: <5e-3 m>, datum: <1e-2 m>, width: <1e-2 m>)"),
        (Kind::Lying, Case("cylinder/hertz")),
        "<1e-5 m>",
        "<1e-1 N>",
    ),
    pressed(
        (
            "rough line",
            "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: <1e-6 m>, long: <1e-4 m>, short: <2e-6 m>), length: <1e-4 m>, points: 512)",
        ),
        (Kind::Rough, Case("rough/height and slope of the line")),
        "<1e-6 m>",
        "<1e-4 N>",
    ),
    pressed(
        ("plane wave", "PlaneWave(amplitude: <1e-5 m>, wavelength: <1e-4 m>)"),
        (Kind::Lying, Case("half-plane/Westergaard wave")),
        "<1e-6 m>",
        "<20 N/m>",
    ),
    pressed(
        (
            "plane section",
            "PlaneWavy(radius: <5e-3 m>, waves: [(amplitude: <2e-7 m>, wavelength: <8e-4 m>)], datum: <1e-2 m>)",
        ),
        (Kind::Section, Case("half-plane/wavy parabola in one piece")),
        "<1e-6 m>",
        "<500 N/m>",
    ),
    on_pixels(
        ("ball on pixels", "Paraboloid(radius: <5e-3 m>)"),
        Case("half-space/scene of a ball"),
        "<1e-5 m>",
        "<5e-3 N>",
    ),
    on_pixels(
        (
            "rough map on pixels",
            "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: <5e-7 m>, long: <1e-4 m>, short: <2e-5 m>), length: <1e-4 m>, points: 32)",
        ),
        Case("half-space/work on a rough surface that repeats"),
        "<1e-6 m>",
        "<1e-4 N>",
    ),
    pressed(
        ("pad", "Pad(side: <5e-4 m>, deviation: <5e-6 m>)"),
        (Kind::Pad, Case("pad/springs")),
        "<1e-5 m>",
        "<1e-3 N>",
    ),
    pressed(
        ("pad of summits", "Pad(side: <5e-4 m>, deviation: <5e-6 m>, summits: (number: 100, radius: <1e-4 m>))"),
        (Kind::Pad, Case("pad/Greenwood and Williamson")),
        "<1e-5 m>",
        "<1e-3 N>",
    ),
];

const ELASTIC: &str = "Elastic(young: <2e6 Pa>, poisson: 0.5)";
/// A body that relaxes by the first series of a scene, and one that relaxes by the second.
pub(super) const RELAXING: [&str; 2] =
    ["Viscoelastic(poisson: 0.5, shear: {0})", "Viscoelastic(poisson: 0.5, shear: {1})"];
/// These series, unless others are drawn.
pub(super) const SERIES: [&str; 2] = [
    "(equilibrium: <3e5 Pa>, terms: [(modulus: <5e5 Pa>, time: <0.1 s>), (modulus: <2e5 Pa>, time: <3 s>)])",
    "(equilibrium: <1e6 Pa>, terms: [(modulus: <2e6 Pa>, time: <1 s>)])",
];

/// Bodies: the first, the second, and whether they relax.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct TwoBodies {
    pub(super) name: &'static str,
    pub(super) texts: [&'static str; 2],
    pub(super) relaxes: bool,
    pub(super) proved: ByKind,
}

const LAYERED: &str =
    "Layered(layers: [(body: Elastic(young: <2e6 Pa>, poisson: 0.5), thickness: <1e-3 m>)], base: Rigid)";
const GRADED: &str = "Graded(young: <2e6 Pa>, depth: <1e-3 m>, exponent: 0.3, poisson: 0.4)";
const SHEET: &str = "Winkler(modulus: <1e5 Pa>, thickness: <5e-5 m>)";
const PLASTIC: &str = "Plastic(young: <2e6 Pa>, poisson: 0.5, yield_stress: <2e4 Pa>)";
const HARD: &str = "Plastic(young: <2e6 Pa>, poisson: 0.5, hardness: <5e4 Pa>)";

/// Bodies that relax are held against Ting's histories; with another beside them against their limits and each other.
const TING: ByKind = [
    Case("ting/whole unloading branch"),
    Case("cylinder/ting's triangle"),
    Laws(Other),
    Laws(Other),
    Case("half-space/Ting's history on pixels"),
    Laws(Other),
];
const LAYERS: ByKind = [
    Case("ground/incompressible layer bonded to a rigid base"),
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Case("half-space/layers beside the bed"),
    Laws(Other),
];
const GRADES: ByKind = [
    Case("ground/jkr pull-off from a graded body"),
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Case("half-space/layers beside the bed"),
    Laws(Other),
];
const YIELDING: ByKind = [
    Case("plastic/heat of a loop"),
    Laws(Other),
    Case("rough/hardness under a smooth ball"),
    Laws(Other),
    Case("half-space/a body too hard to yield"),
    Laws(Other),
];

const SHEETS: ByKind = [
    Case("ground/sheet of springs"),
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Case("half-space/layers beside the bed"),
    Case("pad/springs"),
];

const fn two_bodies(name: &'static str, texts: [&'static str; 2], relaxes: bool, proved: ByKind) -> TwoBodies {
    TwoBodies { name, texts, relaxes, proved }
}

pub(super) const BODIES: [TwoBodies; 10] = [
    two_bodies("elastic", [ELASTIC, "Rigid"], false, all(Whole)),
    two_bodies("both elastic", [ELASTIC, ELASTIC], false, all(Whole)),
    two_bodies("viscoelastic", [RELAXING[0], "Rigid"], true, TING),
    two_bodies("viscoelastic on elastic", [RELAXING[0], ELASTIC], true, all(Laws(Other))),
    two_bodies("two viscoelastic", RELAXING, true, all(Laws(Other))),
    two_bodies("layered", [LAYERED, ELASTIC], false, LAYERS),
    two_bodies("graded", [GRADED, "Rigid"], false, GRADES),
    two_bodies("plastic", [PLASTIC, ELASTIC], false, YIELDING),
    two_bodies("plastic, by hardness", [HARD, "Rigid"], false, YIELDING),
    two_bodies("sheet", [SHEET, "Rigid"], false, SHEETS),
];

/// How a scene writes an attraction, and what proves it.
pub(super) type Attraction = (&'static str, ByKind);

/// Adhesion, as elastic bodies and as those that relax write it; `None` where it is nothing of its own.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Attracting {
    pub(super) name: &'static str,
    pub(super) elastic: Option<Attraction>,
    pub(super) relaxing: Option<Attraction>,
}

const fn attracting(name: &'static str, elastic: Option<Attraction>, relaxing: Option<Attraction>) -> Attracting {
    Attracting { name, elastic, relaxing }
}

pub(super) const MAUGIS: &str = "adhesion: Maugis(work: WORK, stress: STRESS),";
const DMT: &str = "adhesion: Dmt(work: WORK),";
const EXPONENTIAL: &str = "adhesion: Exponential(work: WORK, range: RANGE),";
/// 2γ is the work, γ/r_K the stress.
const CAPILLARY: &str = "adhesion: Capillary(tension: TENSION, angle: 0, kelvin_radius: KELVIN),";

const JKR: ByKind = [
    Case("jkr/radius under load"),
    Case("cylinder/jkr under a force"),
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Case("pad/pull-off over preload"),
];
const RELAXED: ByKind =
    [Case("viscoelastic jkr/slow pull-off"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];
const OUTSIDE: ByKind = [Case("dmt/ball"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];
const RANGE: ByKind = [
    Case("maugis/pull-off over λ"),
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Case("half-space/Maugis on pixels"),
    Laws(Other),
];
const BRIDGE: ByKind = [
    Case("maugis/bridge of liquid"),
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Case("half-space/Maugis on pixels"),
    Laws(Other),
];

const FADING: ByKind = [
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Case("half-space/JKR as the range shrinks with the pixel"),
    Laws(Other),
];

pub(super) const ADHESIONS: [Attracting; 9] = [
    attracting("none", Some(("", all(Whole))), Some(("", all(Whole)))),
    attracting(
        "JKR",
        Some(("adhesion: Jkr(work: WORK),", JKR)),
        Some(("adhesion: Jkr(work: WORK, edge: Relaxed),", RELAXED)),
    ),
    attracting("JKR, instantaneous", None, Some(("adhesion: Jkr(work: WORK, edge: Instantaneous),", all(Laws(Other))))),
    attracting(
        "JKR, rate",
        None,
        Some(("adhesion: Jkr(work: WORK, edge: Rate(speed: SPEED, exponent: 0.5)),", all(Laws(Other)))),
    ),
    attracting(
        "JKR, closing",
        Some(("adhesion: Jkr(work: WORK, closing: CLOSING),", all(Laws(Other)))),
        Some(("adhesion: Jkr(work: WORK, closing: CLOSING, edge: Relaxed),", all(Laws(Other)))),
    ),
    attracting("DMT", Some((DMT, OUTSIDE)), Some((DMT, OUTSIDE))),
    attracting("Maugis", Some((MAUGIS, RANGE)), Some((MAUGIS, RANGE))),
    attracting("capillary", Some((CAPILLARY, BRIDGE)), Some((CAPILLARY, BRIDGE))),
    attracting("exponential", Some((EXPONENTIAL, FADING)), Some((EXPONENTIAL, FADING))),
];

const PARTIAL_SLIP: ByKind = [
    Case("friction/Cattaneo–Mindlin lens"),
    Case("cylinder/partial slip"),
    Laws(Other),
    Laws(Other),
    Case("half-space/Cattaneo and Mindlin on 128²"),
    Laws(Other),
];
const WEAR: ByKind = [Case("wear/Archard's volume"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];
const CAPPED: ByKind = [
    Case("friction/Coulomb–Orowan slider"),
    Laws(Other),
    Laws(Other),
    Case("rough/wave in gross sliding"),
    Laws(Other),
    Laws(Other),
];
const PRESSED: ByKind =
    [Case("friction/peeling force of a lens"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];
const STUCK: ByKind =
    [Case("friction/lens that sticks"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];
const DROPS: ByKind = [Case("machine/stick and slip"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];

pub(super) const FRICTIONS: [Choice; 7] = [
    choice("none", "", all(Whole)),
    choice("Coulomb", "friction: Coulomb(coefficient: 0.3),", PARTIAL_SLIP),
    choice("Coulomb, wear", "friction: Coulomb(coefficient: 0.3), wear: Archard(coefficient: <1e-8 m2/N>),", WEAR),
    choice("capped", "friction: CoulombOrowan(coefficient: 0.3, shear_limit: <1e4 Pa>),", CAPPED),
    choice("pressure law", "friction: Pressure(shear: <1e4 Pa>, slope: 0.1),", PRESSED),
    choice("stuck", "friction: Stuck,", STUCK),
    choice("static, kinetic", "friction: StaticKinetic(static: 0.3, kinetic: 0.2),", DROPS),
];

/// How a contact is led; a slide or a shake goes with it where there is friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Lead {
    Depth,
    Force,
    ForceThenDepth,
    Sine,
    Rows,
    Retraction,
    Impact,
    Oblique,
    /// The steady state of a body that glides.
    Glide,
    /// A body that is set rolling.
    Roll,
    /// A body that rolls steadily with a creepage.
    Traction,
    /// A mass that is drawn along by a spring.
    Drive,
    /// A mass that swings on the contact.
    Ring,
    /// A mass that falls and bounces.
    Fall,
}

/// A way of leading a contact, and what proves it.
pub(super) type Drive = (&'static str, Lead, ByKind);

const CREEP: ByKind = [
    Case("creep/a³ = (3R/4) ∫ J dF"),
    Case("cylinder/creep under a force"),
    Laws(Other),
    Laws(Other),
    Case("half-space/creep on pixels"),
    Laws(Other),
];
const SWING: ByKind =
    [Case("oscillation/storage and loss of a punch"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];
const PULL_OFF: ByKind = [
    Case("jkr/pull-off under depth"),
    Case("cylinder/jkr pull-off"),
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Case("pad/greatest pull-off"),
];
const BLOW: ByKind = [Case("impact/Hertz"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];
const SLANT: ByKind = [Case("impact/stick and slip"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];
const GLIDES: ByKind = [
    Case("gliding/paraboloid on Kelvin–Voigt"),
    Laws(Other),
    Laws(Other),
    Laws(Other),
    Case("half-space/gliding slowly"),
    Laws(Other),
];
const TRACTION: ByKind =
    [Case("rolling/ball, Kalker"), Case("rolling/Carter"), Laws(Other), Laws(Other), Laws(Other), Laws(Other)];

pub(super) const DRIVES: [Drive; 14] = [
    ("depth", Lead::Depth, all(Whole)),
    ("force", Lead::Force, CREEP),
    ("then depth", Lead::ForceThenDepth, CREEP),
    ("sine", Lead::Sine, SWING),
    ("table", Lead::Rows, all(Laws(Rounding))),
    ("retraction", Lead::Retraction, PULL_OFF),
    ("impact", Lead::Impact, BLOW),
    ("oblique", Lead::Oblique, SLANT),
    ("glide", Lead::Glide, GLIDES),
    ("roll", Lead::Roll, GLIDES),
    ("traction", Lead::Traction, TRACTION),
    ("drive", Lead::Drive, DROPS),
    (
        "ring",
        Lead::Ring,
        [Case("machine/small swing"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)],
    ),
    (
        "fall",
        Lead::Fall,
        [Case("machine/elastic bounces"), Laws(Other), Laws(Other), Laws(Other), Laws(Other), Laws(Other)],
    ),
];
