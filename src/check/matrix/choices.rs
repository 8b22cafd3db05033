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
    /// Depth [m] and force [N].
    pub(super) depth: f64,
    pub(super) force: f64,
}

pub(super) const SHAPES: [PressedShape; 7] = [
    PressedShape { shape: choice("ball", "Paraboloid(radius: 5e-3)"), depth: 1e-5, force: 5e-3 },
    PressedShape {
        shape: choice("wavy ball", "WavyParaboloid(radius: 2e-2, amplitude: 1e-8, wavelength: 1e-4)"),
        depth: 1e-5,
        force: 1e-2,
    },
    PressedShape { shape: choice("ellipsoid", "Ellipsoid(radius_x: 5e-3, radius_y: 2e-3)"), depth: 1e-5, force: 5e-3 },
    PressedShape {
        shape: choice("lying cylinder", "Cylinder(radius: 5e-3, datum: 1e-2, width: 1e-2)"),
        depth: 1e-5,
        force: 0.1,
    },
    PressedShape {
        shape: choice(
            "rough line",
            "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-6, long: 1e-4, short: 2e-6), length: 1e-4, points: 512)",
        ),
        depth: 1e-6,
        force: 1e-4,
    },
    PressedShape {
        shape: choice("plane wave", "PlaneWave(amplitude: 1e-5, wavelength: 1e-4)"),
        depth: 1e-6,
        force: 20.0,
    },
    PressedShape {
        shape: choice(
            "plane section",
            "PlaneWavy(radius: 5e-3, waves: [(amplitude: 2e-7, wavelength: 8e-4)], datum: 1e-2)",
        ),
        depth: 1e-6,
        force: 500.0,
    },
];

const ELASTIC: &str = "Elastic(young: 2e6, poisson: 0.5)";
pub(super) const RELAXING: &str = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, terms: [(modulus: 5e5, time: 0.1), (modulus: 2e5, time: 3)]))";
pub(super) const OTHER: &str =
    "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 2e6, time: 1)]))";

/// Bodies: the first, the second, and whether they relax.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct TwoBodies {
    pub(super) name: &'static str,
    pub(super) texts: [&'static str; 2],
    pub(super) relaxes: bool,
}

const LAYERED: &str = "Layered(layers: [(body: Elastic(young: 2e6, poisson: 0.5), thickness: 1e-3)], base: Rigid)";
const GRADED: &str = "Graded(young: 2e6, depth: 1e-3, exponent: 0.3, poisson: 0.4)";
const PLASTIC: &str = "Plastic(young: 2e6, poisson: 0.5, yield_stress: 2e4)";

pub(super) const BODIES: [TwoBodies; 8] = [
    TwoBodies { name: "elastic", texts: [ELASTIC, "Rigid"], relaxes: false },
    TwoBodies { name: "both elastic", texts: [ELASTIC, ELASTIC], relaxes: false },
    TwoBodies { name: "viscoelastic", texts: [RELAXING, "Rigid"], relaxes: true },
    TwoBodies { name: "viscoelastic on elastic", texts: [RELAXING, ELASTIC], relaxes: true },
    TwoBodies { name: "two viscoelastic", texts: [RELAXING, OTHER], relaxes: true },
    TwoBodies { name: "layered", texts: [LAYERED, ELASTIC], relaxes: false },
    TwoBodies { name: "graded", texts: [GRADED, "Rigid"], relaxes: false },
    TwoBodies { name: "plastic", texts: [PLASTIC, ELASTIC], relaxes: false },
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

const MAUGIS: Option<&str> = Some("adhesion: Maugis(work: WORK, stress: 2e4),");

pub(super) const ADHESIONS: [Attracting; 6] = [
    attracting("none", Some(""), Some("")),
    attracting("JKR", Some("adhesion: Jkr(work: WORK),"), Some("adhesion: Jkr(work: WORK, edge: Relaxed),")),
    attracting("JKR, instantaneous", None, Some("adhesion: Jkr(work: WORK, edge: Instantaneous),")),
    attracting("JKR, rate", None, Some("adhesion: Jkr(work: WORK, edge: Rate(speed: 1e-4, exponent: 0.5)),")),
    attracting(
        "JKR, closing",
        Some("adhesion: Jkr(work: WORK, closing: CLOSING),"),
        Some("adhesion: Jkr(work: WORK, closing: CLOSING, edge: Relaxed),"),
    ),
    attracting("Maugis", MAUGIS, MAUGIS),
];

pub(super) const FRICTIONS: [Choice; 4] = [
    choice("none", ""),
    choice("Coulomb", "friction: Coulomb(coefficient: 0.3),"),
    choice("capped", "friction: CoulombOrowan(coefficient: 0.3, shear_limit: 1e4),"),
    choice("pressure law", "friction: Pressure(shear: 1e4, slope: 0.1),"),
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
}

pub(super) const DRIVES: [(&str, Lead); 8] = [
    ("depth", Lead::Depth),
    ("force", Lead::Force),
    ("then depth", Lead::ForceThenDepth),
    ("sine", Lead::Sine),
    ("table", Lead::Rows),
    ("retraction", Lead::Retraction),
    ("impact", Lead::Impact),
    ("oblique", Lead::Oblique),
];
