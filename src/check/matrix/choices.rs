//! What the combinations are made of: each part as a scene writes it.

/// A value of one of the parts of a scene.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Choice {
    /// What it is called in the matrix.
    pub(super) name: &'static str,
    /// How a scene writes it.
    pub(super) text: &'static str,
}

const fn choice(name: &'static str, text: &'static str) -> Choice {
    Choice { name, text }
}

/// Shapes, with a depth and a force that suit them.
#[derive(Debug, PartialEq)]
pub(super) struct PressedShape {
    pub(super) shape: Choice,
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

const fn pressed(shape: Choice, depth: &'static str, force: &'static str) -> PressedShape {
    PressedShape { shape, solver: "", depth, force }
}

/// A finer solver of the same kind.
pub(super) const FINER_PIXELS: &str = "solver: HalfSpace(grid: 96),";

const fn on_pixels(shape: Choice, depth: &'static str, force: &'static str) -> PressedShape {
    PressedShape { shape, solver: "solver: HalfSpace(grid: 32),", depth, force }
}

/// Numbers stand in `<…>` with their units, so that a scene can be written in others.
pub(super) const SHAPES: [PressedShape; 9] = [
    pressed(choice("ball", "Paraboloid(radius: <5e-3 m>)"), "<1e-5 m>", "<5e-3 N>"),
    pressed(
        choice("wavy ball", "WavyParaboloid(radius: <2e-2 m>, amplitude: <1e-8 m>, wavelength: <1e-4 m>)"),
        "<1e-5 m>",
        "<1e-2 N>",
    ),
    pressed(choice("ellipsoid", "Ellipsoid(radius_x: <5e-3 m>, radius_y: <2e-3 m>)"), "<1e-5 m>", "<5e-3 N>"),
    pressed(
        choice("lying cylinder", "Cylinder(radius: <5e-3 m>, datum: <1e-2 m>, width: <1e-2 m>)"),
        "<1e-5 m>",
        "<1e-1 N>",
    ),
    pressed(
        choice(
            "rough line",
            "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: <1e-6 m>, long: <1e-4 m>, short: <2e-6 m>), length: <1e-4 m>, points: 512)",
        ),
        "<1e-6 m>",
        "<1e-4 N>",
    ),
    pressed(choice("plane wave", "PlaneWave(amplitude: <1e-5 m>, wavelength: <1e-4 m>)"), "<1e-6 m>", "<20 N/m>"),
    pressed(
        choice(
            "plane section",
            "PlaneWavy(radius: <5e-3 m>, waves: [(amplitude: <2e-7 m>, wavelength: <8e-4 m>)], datum: <1e-2 m>)",
        ),
        "<1e-6 m>",
        "<500 N/m>",
    ),
    on_pixels(choice("ball on pixels", "Paraboloid(radius: <5e-3 m>)"), "<1e-5 m>", "<5e-3 N>"),
    on_pixels(
        choice(
            "rough map on pixels",
            "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: <5e-7 m>, long: <1e-4 m>, short: <2e-5 m>), length: <1e-4 m>, points: 32)",
        ),
        "<1e-6 m>",
        "<1e-4 N>",
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
}

const LAYERED: &str =
    "Layered(layers: [(body: Elastic(young: <2e6 Pa>, poisson: 0.5), thickness: <1e-3 m>)], base: Rigid)";
const GRADED: &str = "Graded(young: <2e6 Pa>, depth: <1e-3 m>, exponent: 0.3, poisson: 0.4)";
const PLASTIC: &str = "Plastic(young: <2e6 Pa>, poisson: 0.5, yield_stress: <2e4 Pa>)";
const HARD: &str = "Plastic(young: <2e6 Pa>, poisson: 0.5, hardness: <5e4 Pa>)";

pub(super) const BODIES: [TwoBodies; 9] = [
    TwoBodies { name: "elastic", texts: [ELASTIC, "Rigid"], relaxes: false },
    TwoBodies { name: "both elastic", texts: [ELASTIC, ELASTIC], relaxes: false },
    TwoBodies { name: "viscoelastic", texts: [RELAXING[0], "Rigid"], relaxes: true },
    TwoBodies { name: "viscoelastic on elastic", texts: [RELAXING[0], ELASTIC], relaxes: true },
    TwoBodies { name: "two viscoelastic", texts: RELAXING, relaxes: true },
    TwoBodies { name: "layered", texts: [LAYERED, ELASTIC], relaxes: false },
    TwoBodies { name: "graded", texts: [GRADED, "Rigid"], relaxes: false },
    TwoBodies { name: "plastic", texts: [PLASTIC, ELASTIC], relaxes: false },
    TwoBodies { name: "plastic, by hardness", texts: [HARD, "Rigid"], relaxes: false },
];

/// Adhesion, as elastic bodies and as those that relax write it; `None` where it is nothing of its own.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Attracting {
    pub(super) name: &'static str,
    pub(super) elastic: Option<&'static str>,
    pub(super) relaxing: Option<&'static str>,
}

const fn attracting(name: &'static str, elastic: Option<&'static str>, relaxing: Option<&'static str>) -> Attracting {
    Attracting { name, elastic, relaxing }
}

pub(super) const MAUGIS: &str = "adhesion: Maugis(work: WORK, stress: STRESS),";
/// 2γ is the work, γ/r_K the stress.
const CAPILLARY: &str = "adhesion: Capillary(tension: TENSION, angle: 0, kelvin_radius: KELVIN),";

pub(super) const ADHESIONS: [Attracting; 7] = [
    attracting("none", Some(""), Some("")),
    attracting("JKR", Some("adhesion: Jkr(work: WORK),"), Some("adhesion: Jkr(work: WORK, edge: Relaxed),")),
    attracting("JKR, instantaneous", None, Some("adhesion: Jkr(work: WORK, edge: Instantaneous),")),
    attracting("JKR, rate", None, Some("adhesion: Jkr(work: WORK, edge: Rate(speed: SPEED, exponent: 0.5)),")),
    attracting(
        "JKR, closing",
        Some("adhesion: Jkr(work: WORK, closing: CLOSING),"),
        Some("adhesion: Jkr(work: WORK, closing: CLOSING, edge: Relaxed),"),
    ),
    attracting("Maugis", Some(MAUGIS), Some(MAUGIS)),
    attracting("capillary", Some(CAPILLARY), Some(CAPILLARY)),
];

pub(super) const FRICTIONS: [Choice; 6] = [
    choice("none", ""),
    choice("Coulomb", "friction: Coulomb(coefficient: 0.3),"),
    choice("Coulomb, wear", "friction: Coulomb(coefficient: 0.3), wear: Archard(coefficient: <1e-8 m2/N>),"),
    choice("capped", "friction: CoulombOrowan(coefficient: 0.3, shear_limit: <1e4 Pa>),"),
    choice("pressure law", "friction: Pressure(shear: <1e4 Pa>, slope: 0.1),"),
    choice("static, kinetic", "friction: StaticKinetic(static: 0.3, kinetic: 0.2),"),
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

pub(super) const DRIVES: [(&str, Lead); 14] = [
    ("depth", Lead::Depth),
    ("force", Lead::Force),
    ("then depth", Lead::ForceThenDepth),
    ("sine", Lead::Sine),
    ("table", Lead::Rows),
    ("retraction", Lead::Retraction),
    ("impact", Lead::Impact),
    ("oblique", Lead::Oblique),
    ("glide", Lead::Glide),
    ("roll", Lead::Roll),
    ("traction", Lead::Traction),
    ("drive", Lead::Drive),
    ("ring", Lead::Ring),
    ("fall", Lead::Fall),
];
