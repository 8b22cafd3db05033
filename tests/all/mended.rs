//! A scene with a fault in its text is told as much of its parts as is wrong whatever should stand there.

use proptest::prelude::*;
use proptest::sample::select;
use springbed::input::table::InMemory;
use springbed::text::Notation;
use std::cell::Cell;
use std::ops::Range;

/// All that is said of a scene.
fn told(text: &str) -> Vec<String> {
    let plan = Notation::Ron.plan(text, &InMemory::default());
    plan.err().into_iter().flatten().map(|error| error.message).collect()
}

/// What is wrong with the text by itself.
fn misread(text: &str) -> Vec<String> {
    Notation::Ron.scene(text).err().into_iter().flatten().map(|error| error.message).collect()
}

const SHAPES: &[&str] = &[
    "Paraboloid(radius: \"10 mm\")",
    "Sphere(radius: \"1 mm\")",
    "FlatPunch(radius: 1e-3)",
    "WavyParaboloid(radius: 1e-2, amplitude: 1e-5, wavelength: 1e-4)",
    "PlaneWavy(radius: 1e-2, waves: [], datum: 1e-2)",
    "Cylinder(radius: 1e-2, datum: 1e-2, width: 1e-2)",
    "RoughLine(length: 1e-3, points: 4096, seed: 1, seeds: 2, base: Sphere(radius: 1e-4), \
     spectrum: SelfAffine(hurst: 0.8, rms: 1e-7, long: 1e-4, short: 1e-6))",
    "Table(\"no_such.csv\")",
];

const BODIES: &[&str] = &[
    "Rigid",
    "Elastic(young: \"2 MPa\", poisson: 0.5)",
    "Elastic(shear: 1e6, poisson: 0.3, yield_stress: 1e4)",
    "Plastic(young: 1e9, poisson: 0.3, yield_stress: 1e6)",
    "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e5, terms: [(modulus: 1e6, time: 1)]))",
    "Viscoelastic(poisson: 0.5, shear: (terms: [(modulus: 1e6, time: 1)], viscosity: 10))",
    "Viscoelastic(poisson: 0.5, shear: (terms: \"no_such.csv\"))",
];

const ADHESIONS: &[&str] = &[
    "",
    "",
    "adhesion: Jkr(work: 0.05),",
    "adhesion: Jkr(work: (surface_1: 0.02, surface_2: 0.03), closing: 0.08),",
    "adhesion: Jkr(work: 0.05, closing: 0.01),",
    "adhesion: Jkr(work: 0.05, closing: 0.08, edge: Instantaneous),",
    "adhesion: Jkr(work: 0.05, edge: Rate(speed: 1e-6, exponent: 0.5)),",
    "adhesion: Dmt(work: 0.05),",
    "adhesion: Maugis(work: 0, stress: 1e5),",
    "adhesion: Capillary(tension: \"72 mN/m\", angle: \"60 deg\", kelvin_radius: \"1 nm\"),",
];

const FRICTIONS: &[&str] = &[
    "",
    "",
    "friction: Coulomb(coefficient: 0.3),",
    "friction: Stuck,",
    "friction: CoulombOrowan(coefficient: 0.3, shear_limit: 1e6),",
    "friction: StaticKinetic(static: 0.3, kinetic: 0.4), machine: (mass: 1, stiffness: 10),",
    "friction: Coulomb(coefficient: 0.3), machine: (mass: 1),",
    "friction: Pressure(shear: 1e5, slope: 0.1),",
    "friction: Pressure(shear: \"no_such.csv\", slope: 0),",
];

const ENTRIES: &[&str] = &[
    "Indent(to: \"10 um\", over: 1)",
    "Indent(to: 1, over: 1e308)",
    "Press(to: -1, over: \"1 s\")",
    "Hold(over: 1e308)",
    "HoldForce(over: 2)",
    "Slide(to: 1e-3, over: 2)",
    "Oscillate(amplitude: 1, frequency: 1, cycles: 3)",
    "Shake(amplitude: 1e-3, frequency: 1, cycles: 3)",
    "Retract(speed: 1e-6)",
    "Impact(mass: 1, speed: [1], angle: \"30 deg\")",
    "Impact(mass: 1, speed: [])",
    "Glide(speed: [1, \"2 mm/s\"])",
    "Glide(speed: 1e-3, over: 2)",
    "Roll(speed: [1, 2], over: 1)",
    "Roll(speed: 1, creepage: [\"1 %\", -2e-3])",
    "Roll(speed: [1, 2], traction: 1, over: 1)",
    "Glide(speed: 1, creepage: [], traction: [\"1 N\"])",
    "Table(\"no_such.csv\")",
    "Drive(speed: -1e-3, over: 2)",
    "Ring(amplitude: 1e-9, over: 2)",
    "Fall(height: 1, over: 1e308)",
];

const SETTINGS: &[&str] = &[
    "",
    "",
    "springs: 10, ",
    "steps: 9999999, ",
    "springs: 99999999, steps: 10, accuracy: 1e-4,",
    "solver: HalfSpace(grid: 4, boundary: Periodic),",
    "solver: HalfSpace(),",
];

const PLOTS: &[&str] = &[
    "Force",
    "Radius",
    "Stress",
    "Field",
    "Bed",
    "Surface",
    "Shape",
    "Moduli",
    "Friction",
    "Stick",
    "Fretting",
    "Coefficient",
    "Area",
    "Restitution",
    "Resistance",
    "Traction",
    "Contact",
    "Distribution",
];

/// Scenes of which few parts fit together.
fn scenes() -> impl Strategy<Value = String> {
    let parts = (select(SHAPES), select(BODIES), select(BODIES), select(ADHESIONS), select(FRICTIONS));
    let rest =
        (prop::collection::vec(select(ENTRIES), 0..4), select(SETTINGS), prop::collection::vec(select(PLOTS), 0..3));
    (parts, rest).prop_map(|((shape, one, other, adhesion, friction), (entries, settings, plots))| {
        format!(
            "(title: \"x\", shape: {shape}, bodies: ({one}, {other}), {adhesion} {friction} history: [{}], {settings} plots: [{}])",
            entries.join(", "),
            plots.join(", ")
        )
    })
}

/// The names, numbers and texts in a scene.
fn words(text: &str) -> Vec<Range<usize>> {
    let is_word = |c: char| c.is_alphanumeric() || "_.\"-".contains(c);
    let (mut words, mut start, mut quoted) = (Vec::new(), None, false);
    for (at, c) in text.char_indices() {
        quoted ^= c == '"';
        if is_word(c) || quoted {
            start.get_or_insert(at);
        } else {
            words.extend(start.take().map(|start| start..at));
        }
    }
    words
}

/// What makes a place of a scene wrong.
#[derive(Debug, Clone, Copy)]
enum Slip {
    /// One more letter in a name or number.
    Letter,
    /// A name with a letter less.
    Short,
    /// Something of the wrong kind.
    Other(&'static str),
    /// A field that is not there.
    Lost,
    /// A field that is there twice.
    Twice,
}

fn slips() -> impl Strategy<Value = Slip> {
    let others = select(&["\"1 furlong\"", "-1e30", "7.5", "[]", "()", "\"\"", "Nonsense(a: 1)", "true"][..]);
    prop_oneof![
        Just(Slip::Letter),
        Just(Slip::Short),
        others.prop_map(Slip::Other),
        Just(Slip::Lost),
        Just(Slip::Twice)
    ]
}

/// The scene with its word at `at` made wrong.
fn spoilt(text: &str, at: usize, slip: Slip) -> String {
    let words = words(text);
    let word = words[at % words.len()].clone();
    let with = |new: &str| format!("{}{new}{}", &text[..word.start], &text[word.end..]);
    let old = &text[word.clone()];
    match slip {
        Slip::Letter => with(&format!("{old}x")),
        Slip::Short => with(&old[..old.len() - 1]),
        Slip::Other(new) => with(new),
        Slip::Lost => format!("{}{}", &text[..word.start], &text[field_end(text, word.start)..]),
        Slip::Twice => {
            let end = field_end(text, word.start);
            format!("{}{}, {}", &text[..end], &text[word.start..end].trim_end_matches([',', ' ']), &text[end..])
        }
    }
}

/// The end of the field that begins at `start`, with its comma.
fn field_end(text: &str, start: usize) -> usize {
    let mut depth = 0i32;
    for (at, c) in text[start..].char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' if depth == 0 => return start + at,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => return start + at + 1,
            _ => {}
        }
    }
    text.len()
}

/// Whatever is wrong in one place, nothing is said of the parts that would not be said with that place right.
#[test]
fn a_fault_of_the_text_never_brings_a_false_one_of_the_parts() {
    let (tried, told_beside) = (Cell::new(0), Cell::new(0));
    let cases = ProptestConfig::default().cases.max(2000);
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    proptest!(config, |(right in scenes(), at in 0usize..1000, slip in slips())| {
        prop_assert!(misread(&right).is_empty(), "{right}");
        let wrong = spoilt(&right, at, slip);
        let faults = misread(&wrong);
        if !faults.is_empty() {
            let (all, of_right) = (told(&wrong), told(&right));
            prop_assert!(faults.iter().all(|message| all.contains(message)), "{wrong}: {all:#?}");
            let beside: Vec<&String> = all.iter().filter(|message| !faults.contains(message)).collect();
            prop_assert_eq!(all.len(), faults.len() + beside.len());
            for message in &beside {
                prop_assert!(of_right.contains(message), "{}\n{}\n{}", right, wrong, message);
            }
            tried.set(tried.get() + 1);
            told_beside.set(told_beside.get() + usize::from(!beside.is_empty()));
        }
    });
    assert!(3 * told_beside.get() > tried.get(), "{} of {}", told_beside.get(), tried.get());
}

/// In JSON too, where a body is counted as the element of a list.
#[test]
fn all_is_told_of_json_at_once() {
    let text = r#"{"shape": {"Sphere": {"radius": "5 mm"}},
 "bodies": [{"Elastic": {"young": "2 MPa", "poisson": 0.7}}, "Rigid"],
 "adhesion": {"Jkr": {"work": 0.05, "closing": 0.08, "edge": "Relaxed"}},
 "history": [{"Slide": {"to": 1e-6, "over": 1}}, {"Retrct": {"speed": 1e-6}}]}"#;
    let errors = Notation::Json.plan(text, &InMemory::default()).unwrap_err();
    let right = [
        (2, 55, "bodies[0].poisson: 0.7 is out of range"),
        (3, 48, "adhesion.closing: a closing edge gives 0.08 J/m²"),
        (3, 62, "adhesion.edge: an edge is a matter of Viscoelastic bodies"),
        (4, 14, "history[0]: Slide needs friction"),
        (4, 51, "unknown variant `Retrct`"),
    ];
    assert_eq!(errors.len(), right.len(), "{errors:#?}");
    for (error, (line, column, message)) in errors.iter().zip(right) {
        let place = (error.position.line, error.position.column);
        assert!(place == (line, column) && error.message.contains(message), "{error:?}, not {line}:{column} {message}");
    }
    // The friction has got into the shape: whether the slide lacks it cannot be told.
    let strayed = text.replace(r#""5 mm""#, r#""5 mm", "friction": {"Coulomb": {"coefficient": 0.3}}"#);
    let errors = Notation::Json.plan(&strayed, &InMemory::default()).unwrap_err();
    assert_eq!(errors.len(), right.len(), "{errors:#?}");
    assert!(!errors.iter().any(|error| error.message.contains("needs friction")), "{errors:#?}");
}
