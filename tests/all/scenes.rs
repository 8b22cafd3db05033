//! Every scene in `configs` runs, and gives the answers its comments quote.
//!
//! A comment `// answer: pull_off_force_n = -494.8008429e-6` holds the result of that name to half a
//! unit of its last digit. The answers are from the formulas named beside them, computed with 20 digits.

use springbed::app::run::{Asked, Format, compute, endings, products};
use springbed::app::scene_file::SceneFile;
use springbed::run::named::Finding;
use springbed::run::record::Outcome;
use std::path::{Path, PathBuf};

pub(super) fn scenes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs");
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut scenes: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|ending| ending == "ron")).collect();
    scenes.sort();
    scenes
}

/// Names and numbers in the comments, with half a unit of the last digit.
fn answers(text: &str) -> Vec<(String, f64, f64)> {
    let quoted = text.lines().filter_map(|line| line.trim().strip_prefix("// answer: "));
    quoted.map(|line| answer(line).unwrap_or_else(|| panic!("cannot be read: {line}"))).collect()
}

fn answer(line: &str) -> Option<(String, f64, f64)> {
    let (name, number) = line.split_once(" = ")?;
    let (digits, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
    let unit = 10f64.powi(exponent.parse::<i32>().ok()? - i32::try_from(decimals).ok()?);
    Some((name.to_owned(), number.parse().ok()?, 0.5 * unit))
}

fn result(outcome: &Outcome, name: &str) -> Option<f64> {
    outcome.named(name).map(|finding| match finding {
        Finding::Number(number) => number,
        other @ (Finding::Answer(_) | Finding::Count(_)) => panic!("{name} is {other:?}"),
    })
}

#[test]
fn every_scene_runs_and_gives_the_answers_in_its_comments() {
    let scenes = scenes();
    assert!(scenes.len() >= 8, "{scenes:?}");
    for path in scenes {
        let text = std::fs::read_to_string(&path).unwrap();
        let scene = SceneFile::load(&path).unwrap_or_else(|faults| panic!("{faults:?}"));
        let formats = [Format::Csv, Format::Json, Format::Svg];
        let outcome = compute(&scene.plan, &formats).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let files = products(&scene.plan, "scene.ron", &outcome, &Asked::of(&formats)).unwrap();
        assert!(files.len() >= 2 && files.iter().all(|file| !file.content.is_empty()), "{}", path.display());
        let known = endings(&scene.plan, &formats);
        assert!(files.iter().all(|file| known.contains(&file.ending)), "{}: beyond {known:?}", path.display());
        for (name, right, bound) in answers(&text) {
            let found = result(&outcome, &name).unwrap_or_else(|| panic!("{}: no {name}", path.display()));
            // Half a unit, and a rounding of the number read.
            let error = (found - right).abs();
            assert!(error <= bound * (1.0 + 1e-6), "{}: {name} is {found:e}, quoted {right:e}", path.display());
        }
    }
}

#[test]
fn elastic_and_adhesive_scenes_quote_their_answers() {
    for name in [
        "hertz",
        "rail_wheel",
        "indentation_cone",
        "flat_punch",
        "pdms_lens",
        "wavy_lens",
        "measured_tip",
        "afm_tip",
        "humid_tip",
        "adhesive_pad",
        "rough_pull_off",
        "crossed_cylinders",
        "springs_of_hertz",
        "springs_of_jkr",
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("configs/{name}.ron"));
        let text = std::fs::read_to_string(path).unwrap();
        assert!(answers(&text).len() >= 2, "{name}");
    }
}

#[test]
fn scenes_of_friction_quote_their_answers() {
    for name in ["cattaneo_mindlin", "fretting_loop", "varied_load", "sheared_lens", "rubber_slider"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("configs/{name}.ron"));
        let text = std::fs::read_to_string(path).unwrap();
        assert!(answers(&text).len() >= 2, "{name}");
    }
}

/// The numbers the README quotes from the book: 1.0 GPa and 6.8 mm.
#[test]
fn the_rail_and_the_wheel_of_the_book() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/rail_wheel.ron");
    let outcome = compute(&SceneFile::load(&path).unwrap().plan, &[Format::Json]).unwrap();
    assert!((result(&outcome, "peak_pressure_pa").unwrap() - 1.0e9).abs() < 0.05e9);
    assert!((result(&outcome, "largest_contact_radius_m").unwrap() - 6.8e-3).abs() < 0.05e-3);
    let yielding = outcome.warnings.iter().filter(|warning| warning.contains("first yield")).count();
    assert_eq!(yielding, 1, "{:?}", outcome.warnings);
}

/// The wavy lens jumps four times on the way in and five times on the way out, at the same depths
/// whatever the number of records.
#[test]
fn the_jumps_of_the_wavy_lens() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/wavy_lens.ron");
    let text = std::fs::read_to_string(&path).unwrap();
    let jumps = |steps: usize| {
        let text = text.replacen("title:", &format!("steps: {steps},\n    title:"), 1);
        let plan = springbed::app::scene_file::plan(&path, &text).unwrap_or_else(|faults| panic!("{faults:?}"));
        let records = compute(&plan, &[]).unwrap().records;
        let pairs: Vec<_> = records.windows(2).map(|pair| (pair[0], pair[1])).collect();
        let jumped = |pair: &&(springbed::run::record::Record, springbed::run::record::Record)| {
            (pair.1.time - pair.0.time).abs() <= 0.0 && pair.0.normal.contact_radius != pair.1.normal.contact_radius
        };
        let depths = |entry: usize| -> Vec<f64> {
            let of_entry = pairs.iter().filter(jumped).filter(|pair| pair.1.entry == entry);
            of_entry.filter_map(|pair| pair.0.normal.indentation).collect()
        };
        (depths(0), depths(1), records.last().map(|record| record.normal.dissipated))
    };
    let (into, out, lost) = jumps(1000);
    assert_eq!((into.len(), out.len()), (4, 5));
    for steps in [1, 2, 10] {
        let (same_in, same_out, same_loss) = jumps(steps);
        assert_eq!((same_in.len(), same_out.len()), (4, 5), "{steps} records");
        let apart = into.iter().chain(&out).zip(same_in.iter().chain(&same_out)).map(|(x, y)| (x - y).abs());
        assert!(apart.fold(0.0, f64::max) < 1e-15 * 1e-5, "{steps} records");
        // Differences of energies a hundred times as large.
        assert!((same_loss.unwrap() / lost.unwrap() - 1.0).abs() < 1e-13, "{steps} records");
    }
}

/// A history and a profile as instruments write them are those of a scene's own tables.
#[test]
fn tables_of_instruments_are_those_of_scenes() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("own.csv", "time_s,indentation_m\n0,0\n0.5,1e-6\n1,2.5e-7\n");
    write("theirs.txt", "Ramp 12\nNr\tt [s]\tz [µm]\tT [degC]\n1\t0,0\t0,0\t21\n2\t0,5\t1,0\t21\n3\t1,0\t0,25\t22\n");
    write("own_tip.csv", "radius_m,height_m\n0,0\n1e-6,1e-7\n3e-6,9e-7\n");
    write("their_tip.txt", "r [um]; z [nm]\n0; 0\n1; 100\n3; 900\n");
    let force = |history: &str, tip: &str| {
        let text = format!(
            r#"(shape: Table("{tip}"), bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: "1 kPa",
                terms: [(modulus: "2 kPa", time: "0.2 s")])), Rigid), history: [Table("{history}")])"#
        );
        write("scene.ron", &text);
        let scene = SceneFile::load(&folder.path().join("scene.ron")).unwrap_or_else(|faults| panic!("{faults:?}"));
        let outcome = compute(&scene.plan, &[]).unwrap();
        outcome.records.iter().map(|record| record.normal.force).collect::<Vec<f64>>()
    };
    let own = force("own.csv", "own_tip.csv");
    assert!(own.iter().any(|force| *force > 0.0));
    let theirs = force("theirs.txt", "their_tip.txt");
    assert_eq!(own.len(), theirs.len());
    // 100 nm is not 1e-7 m to the last bit.
    assert!(own.iter().zip(&theirs).all(|(own, their)| (own - their).abs() <= 1e-12 * own.abs()), "{own:?} {theirs:?}");
    // Two drives in one file are two questions.
    write("both.csv", "t [s],z [um],F [mN]\n0,0,0\n1,1,1\n");
    let text = r#"(shape: Cone(slope: 1), bodies: (Elastic(young: "1 kPa", poisson: 0.5), Rigid), history: [Table("both.csv")])"#;
    write("scene.ron", text);
    let faults = SceneFile::load(&folder.path().join("scene.ron")).unwrap_err();
    assert!(faults[0].message.contains("cannot both be controlled"), "{faults:?}");
}
