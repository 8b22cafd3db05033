//! Rough shapes as a person or a script meets them.

use std::path::Path;
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// Runs a scene with `arguments`; gives the folder of its files and what was said.
fn run(scene: &str, map: Option<&[u8]>, arguments: &[&str]) -> (TempDir, String) {
    let folder = TempDir::new().unwrap();
    std::fs::write(folder.path().join("scene.ron"), scene).unwrap();
    if let Some(bytes) = map {
        std::fs::write(folder.path().join("map"), bytes).unwrap();
    }
    let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
    command.stdin(Stdio::null()).arg("run").arg(folder.path().join("scene.ron")).args(arguments);
    let output = command.arg("--out").arg(folder.path().join("out")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    (folder, String::from_utf8(output.stdout).unwrap())
}

fn table(folder: &Path, ending: &str) -> String {
    std::fs::read_to_string(folder.join("out").join(format!("scene{ending}"))).unwrap()
}

/// The numbers of a named column; an empty cell is NaN.
fn column(table: &str, name: &str) -> Vec<f64> {
    let mut lines = table.lines();
    let at = lines.next().unwrap().split(',').position(|column| column == name).unwrap();
    lines.map(|line| line.split(',').nth(at).unwrap().parse().unwrap_or(f64::NAN)).collect()
}

fn scene(more: &str, history: &str) -> String {
    format!(
        "(shape: RoughLine({more} length: \"100 um\", points: 4096), bodies: (Elastic(young: \"3 MPa\", poisson: 0.5), Rigid), history: [{history}])"
    )
}

const SPECTRUM: &str = "spectrum: SelfAffine(hurst: 0.8, rms: \"1 um\", long: \"100 um\", short: \"0.5 um\"),";

/// A rough bed gives force and stiffness, says that it is approximate, and never an area.
#[test]
fn a_rough_bed_gives_force_and_stiffness_but_no_radius() {
    let (folder, said) = run(&scene(SPECTRUM, "Indent(to: \"2 um\", over: 1), Indent(to: 0, over: 1)"), None, &[]);
    assert!(said.contains("approximate") && !said.contains("contact radius"), "{said}");
    let records = table(folder.path(), ".csv");
    assert!(column(&records, "contact_radius_m").iter().all(|radius| radius.is_nan()));
    let (depth, force) = (column(&records, "indentation_m"), column(&records, "force_n"));
    let stiffness = column(&records, "stiffness_n_per_m");
    assert!((depth[100] - 2e-6).abs() <= 0.0 && force[0].abs() <= 0.0 && force[200].abs() <= 0.0);
    // Elastic: the way back is the way there.
    for k in 0..100 {
        assert!((force[k] - force[200 - k]).abs() <= 1e-9 * force[100], "{k}");
        // F = ∫k dd and k grows: a chord's slope lies between the stiffnesses at its ends.
        let slope = (force[k + 1] - force[k]) / (depth[k + 1] - depth[k]);
        assert!(slope >= stiffness[k] * (1.0 - 1e-9) && slope <= stiffness[k + 1] * (1.0 + 1e-9), "{k}");
    }
}

/// A line of which all springs touch is told, with the depth from which on its stiffness is E* times its length, and one of
/// which the last is free is not.
#[test]
fn a_line_that_is_pressed_flat_is_told() {
    let (whole, told) = (4e6 * 100e-6, "the last spring of the line touches");
    let pressed = |to: &str| {
        let (folder, _) = run(&scene(SPECTRUM, &format!("Indent(to: {to}, over: 1)")), None, &[]);
        let records = table(folder.path(), ".csv");
        let depths = column(&records, "indentation_m");
        let flat = column(&records, "stiffness_n_per_m").iter().position(|&slope| slope >= whole * (1.0 - 1e-9));
        (flat.map(|k| [depths[k - 1], depths[k]]), table(folder.path(), ".json"))
    };
    let (flat, said) = pressed("8e-6");
    let [free, last] = flat.expect("a depth of eight times the rms height closes the line");
    let at = said.find(told).unwrap();
    let depth = said[..at].rsplit("at the indentation ").next().unwrap().split(' ').next().unwrap();
    let depth: f64 = depth.parse().unwrap();
    assert!(depth > free && depth <= last * 1.001, "{free:e} {depth:e} {last:e}");
    let (flat, said) = pressed(&format!("{:e}", 0.99 * free));
    assert!(flat.is_none() && !said.contains(told));
}

/// Roughness of a thousandth of the indentation leaves the ball: Hertz to that order.
#[test]
fn a_hardly_rough_ball_is_hertz() {
    let base = "base: Paraboloid(radius: \"1 mm\"), spectrum: SelfAffine(hurst: 0.8, rms: \"0.1 nm\", long: \"10 um\", short: \"1 um\"),";
    let (folder, _) = run(&scene(base, "Press(to: 1e-4, over: 1)"), None, &[]);
    let depth = *column(&table(folder.path(), ".csv"), "indentation_m").last().unwrap();
    let hertz = (0.75 * 1e-4 / 4e6 / 1e-3_f64.sqrt()).powf(2.0 / 3.0);
    assert!((depth / hertz - 1.0).abs() < 1e-2, "{depth} {hertz}");
}

/// The same seeds, the same bytes on any number of threads.
#[test]
fn an_ensemble_is_the_same_on_any_number_of_threads() {
    let scene = scene(SPECTRUM, "Indent(to: \"2 um\", over: 1)").replace("4096", "4096, seeds: 6");
    let (one, said) = run(&scene, None, &["--threads", "1"]);
    assert!(said.contains("members") && said.contains("largest force deviation"), "{said}");
    let (three, _) = run(&scene, None, &["--threads", "3"]);
    for ending in [".csv", ".ensemble.csv", ".json"] {
        assert_eq!(table(one.path(), ending), table(three.path(), ending), "{ending}");
    }
    let scatter = table(one.path(), ".ensemble.csv");
    let (least, most) = (column(&scatter, "force_least_n"), column(&scatter, "force_greatest_n"));
    let mean = column(&table(one.path(), ".csv"), "force_n");
    assert!((1..mean.len()).all(|k| least[k] <= mean[k] && mean[k] <= most[k] && least[k] < most[k]));
}

/// A height map as text and as files of NumPy in both orders of bytes and of axes: the same surface, the same results.
#[test]
fn a_height_map_is_the_same_in_every_form() {
    let height = |i: u32, j: u32| 1e-7 * f64::from((7 * i + 3 * j + i * j) % 11);
    let rows = |i| (0..8).map(move |j| height(i, j));
    let text: String =
        (0..8).map(|i| rows(i).map(|h| format!("{h:e}")).collect::<Vec<_>>().join(" \t") + "\n").collect();
    let npy = |kind: &str, order: &str, numbers: Vec<[u8; 8]>| {
        let header = format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': (8, 8), }}\n");
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend(u16::try_from(header.len()).unwrap().to_le_bytes());
        bytes.extend(header.as_bytes());
        bytes.extend(numbers.concat());
        bytes
    };
    let by_rows = (0..64).map(|k| height(k / 8, k % 8));
    let by_columns = (0..64).map(|k| height(k % 8, k / 8));
    let forms = [
        text.into_bytes(),
        npy("<f8", "False", by_rows.map(f64::to_le_bytes).collect()),
        npy(">f8", "True", by_columns.map(f64::to_be_bytes).collect()),
    ];
    let scene = "(shape: HeightMap(\"map\", \"1 um\"), bodies: (Elastic(young: 1e9, poisson: 0.3), Rigid), history: [Press(to: 1e-3, over: 1)])";
    let said = forms.map(|bytes| run(scene, Some(&bytes), &["--json", "--format", "csv"]).1);
    assert!(said[0] == said[1] && said[1] == said[2]);
    let value: serde_json::Value = serde_json::from_str(&said[0]).unwrap();
    assert!(value["scenes"][0]["results"]["rms_slope"].as_f64().unwrap() > 0.1);
    assert!(value["scenes"][0]["results"]["peak_to_valley_m"].as_f64().unwrap() > 9e-7);
}

/// A contact that grows out of its line is a failed run and says what length it wants.
#[test]
fn a_line_too_short_for_its_ball_is_refused() {
    let base = "base: Paraboloid(radius: \"1 mm\"), spectrum: SelfAffine(hurst: 0.8, rms: \"10 nm\", long: \"10 um\", short: \"1 um\"),";
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("scene.ron");
    std::fs::write(&path, scene(base, "Indent(to: \"5 um\", over: 1)")).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_springbed")).arg("run").arg(&path).output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.contains("the contact reaches the ends of the rough line: expected a `length` well above 1e-4 m"),
        "{said}"
    );
}

fn plane(shape: &str, more: &str, history: &str) -> String {
    format!("(shape: {shape}, bodies: (Elastic(young: \"2 MPa\", poisson: 0.5), Rigid), {more} history: [{history}])")
}

/// Westergaard 1939: p̄ = p* sin²(πa/λ), p* = πE*Δ/λ; the work is the stored energy, that of full contact p*Δ/4 per area; a force
/// that a depth needed gives the depth again.
#[test]
fn a_wave_on_the_half_plane_is_westergaards() {
    let wave = "PlaneWave(amplitude: \"1 um\", wavelength: \"100 um\", width: \"1 cm\")";
    let (folder, _) = run(&plane(wave, "", "Indent(to: \"1 um\", over: 1)"), None, &[]);
    let records = table(folder.path(), ".csv");
    let (depth, force) = (column(&records, "indentation_m"), column(&records, "force_n"));
    let (radius, energy) = (column(&records, "contact_radius_m"), column(&records, "stored_j"));
    let full = std::f64::consts::PI * (2e6 / 0.75) * 0.01 * 1e-6;
    for k in 1..100 {
        let share = (std::f64::consts::PI * radius[k] / 1e-4).sin().powi(2);
        assert!((force[k] / (full * share) - 1.0).abs() < 1e-12, "{k}");
    }
    assert!((force[100] / full - 1.0).abs() < 1e-12 && (energy[100] / (full * 1e-6 / 4.0) - 1.0).abs() < 1e-12);
    // Simpson's rule over pairs of steps away from both ends, where F(d) is smooth: fourth order, 1e-6 at a tenth of the range.
    let simpson: f64 = (20..80).step_by(2).map(|k| (force[k] + 4.0 * force[k + 1] + force[k + 2]) * 1e-8 / 3.0).sum();
    assert!((simpson / (energy[80] - energy[20]) - 1.0).abs() < 1e-6);
    let (back, _) = run(&plane(wave, "", &format!("Press(to: {:e}, over: 1)", force[60])), None, &[]);
    let found = *column(&table(back.path(), ".csv"), "indentation_m").last().unwrap();
    assert!((found / depth[60] - 1.0).abs() < 1e-12);
}

/// Gross sliding: Coulomb alone is μF; a cap makes it less; slopes beyond 0.44 and 1.33 are told with their number.
#[test]
fn a_wave_slides_by_its_friction_and_warns_of_its_slope() {
    let sliding = |friction: &str| {
        let wave = "PlaneWave(amplitude: \"1 um\", wavelength: \"100 um\")";
        let (_, said) = run(&plane(wave, friction, "Press(to: 1, over: 1)"), None, &["--json", "--format", "csv"]);
        let value: serde_json::Value = serde_json::from_str(&said).unwrap();
        value["scenes"][0]["results"]["gross_sliding_force_n"].as_f64().unwrap()
    };
    assert!((sliding("friction: Coulomb(coefficient: 0.5),") - 0.5).abs() < 1e-12);
    let capped = sliding("friction: CoulombOrowan(coefficient: 0.5, shear_limit: \"10 kPa\"),");
    // The cap on the whole contact of half width a is the most it can carry, and nearly all of it is at the cap.
    let full = std::f64::consts::PI * (2e6 / 0.75) * 1e-6;
    let most = 2.0 * 1e4 * 1e-4 / std::f64::consts::PI * (1.0 / full).sqrt().asin();
    assert!(capped > 0.95 * most && capped < most, "{capped} {most}");
    for (amplitude, words) in [("20 um", "0.89 is above 0.44"), ("40 um", "1.78 is far outside")] {
        let wave = format!("PlaneWave(amplitude: \"{amplitude}\", wavelength: \"100 um\")");
        let (folder, _) = run(&plane(&wave, "", "Press(to: 1, over: 1)"), None, &[]);
        assert!(table(folder.path(), ".json").contains(words), "{words}");
    }
}

/// Without waves the wavy parabola is Hertz' cylinder: c² = 4PR/(πE*), d = (P/πE*)(1 + 2 ln(2D/c)) (Johnson 1985, ch. 4).
#[test]
fn a_parabola_without_waves_is_the_cylinder_of_hertz() {
    let smooth = "PlaneWavy(radius: \"10 mm\", waves: [], datum: \"0.1\")".replace("\"0.1\"", "0.1");
    let (folder, said) = run(&plane(&smooth, "", "Press(to: 100, over: 1)"), None, &[]);
    assert!(said.contains("in one piece            yes"), "{said}");
    let records = table(folder.path(), ".csv");
    let unit = 100.0 / (std::f64::consts::PI * 2e6 / 0.75);
    let half = (4.0 * unit * 0.01_f64).sqrt();
    let last = |name: &str| *column(&records, name).last().unwrap();
    assert!((last("contact_radius_m") / half - 1.0).abs() < 1e-12);
    assert!((last("indentation_m") / (unit * (1.0 + 2.0 * (0.2 / half).ln())) - 1.0).abs() < 1e-12);
    // U = ½(Pd − ∫ph), ∫ph = (P/2R)⟨x²⟩ = Pc²/8R.
    let energy = 50.0 * (last("indentation_m") - half * half / 0.08);
    assert!((last("stored_j") / energy - 1.0).abs() < 1e-12);
}

/// Fine waves break the contact: the run says so and gives no state that it does not know.
#[test]
fn a_leaking_seal_is_told() {
    let seal = "PlaneWavy(radius: \"5 mm\", waves: [(amplitude: \"0.2 um\", wavelength: \"80 um\")], datum: \"10 mm\")";
    let (folder, said) = run(&plane(seal, "steps: 4,", "Press(to: 16, over: 1)"), None, &[]);
    assert!(said.contains("in one piece            no"), "{said}");
    assert!(table(folder.path(), ".json").contains("it leaks"));
    // At rest, under 4 N on the three innermost crests, the pressure above zero between them, and from 8.7 N on.
    assert_eq!(column(&table(folder.path(), ".csv"), "force_n"), [0.0, 4.0, 12.0, 16.0]);
}

/// A seal whose waves no force of the history closes has no state to show: the run fails, and writes nothing.
#[test]
fn a_seal_that_leaks_all_the_time_is_a_failed_run() {
    let seal =
        "PlaneWavy(radius: \"5 mm\", waves: [(amplitude: \"0.2 um\", wavelength: \"13.468 um\")], datum: \"10 mm\")";
    let folder = TempDir::new().unwrap();
    std::fs::write(folder.path().join("scene.ron"), plane(seal, "steps: 4,", "Press(to: 100, over: 1)")).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
    command.stdin(Stdio::null()).current_dir(folder.path()).args(["run", "scene.ron", "--out", "out"]);
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("under no force of the history is the contact in one piece"), "{said}");
    assert!(!folder.path().join("out").exists());
}

/// A rubber pressed fast and held: the force falls from that of E*(0) towards that of E∞, and what happens between the
/// records does not depend on them.
#[test]
fn a_rough_rubber_relaxes() {
    let rubber = "Viscoelastic(poisson: 0.5, shear: (equilibrium: \"1 MPa\", terms: [(modulus: \"9 MPa\", time: 1)]))";
    let scene = |bodies: &str, history: &str| {
        format!("(shape: RoughLine({SPECTRUM} length: \"100 um\", points: 4096), bodies: ({bodies}, Rigid), {history})")
    };
    let last = |scene: &str| {
        let (folder, said) = run(scene, None, &[]);
        assert!(said.contains("approximate"), "{said}");
        column(&table(folder.path(), ".csv"), "force_n")
    };
    let held = "history: [Indent(to: \"2 um\", over: 1e-9), Hold(over: 50)]";
    let force = last(&scene(rubber, held));
    let elastic = |shear: &str| {
        let body = format!("Elastic(poisson: 0.5, shear: \"{shear}\")");
        *last(&scene(&body, "history: [Indent(to: \"2 um\", over: 1)]")).last().unwrap()
    };
    let near = |one: f64, two: f64| (one / two - 1.0).abs() < 1e-8;
    assert!(near(force[100], elastic("10 MPa")) && near(*force.last().unwrap(), elastic("1 MPa")));
    let there_and_back = |steps: usize| {
        let history = "history: [Indent(to: \"2 um\", over: 1), Hold(over: 1), Indent(to: \"1.9 um\", over: 0.5)]";
        *last(&scene(rubber, &format!("steps: {steps}, {history}"))).last().unwrap()
    };
    let (few, many) = (there_and_back(3), there_and_back(300));
    assert!((few / many - 1.0).abs() < 1e-11, "{few:e} {many:e}");
}

/// Pressed and slid: full slip carries μF, and the records say what friction has taken.
#[test]
fn a_rough_line_slides() {
    let history = "Press(to: 1e-3, over: 1), Slide(to: \"20 um\", over: 1)";
    let scene = scene(SPECTRUM, history).replace("Rigid),", "Rigid), friction: Coulomb(coefficient: 0.3),");
    let (folder, said) = run(&scene, None, &[]);
    let records = table(folder.path(), ".csv");
    let force = *column(&records, "tangential_force_n").last().unwrap();
    assert!((force - 3e-4).abs() < 1e-15, "{force:e}");
    assert!(*column(&records, "friction_dissipated_j").last().unwrap() > 0.0);
    assert!(column(&records, "stick_radius_m").iter().all(|radius| radius.is_nan()), "a rough contact has no radius");
    assert!(said.contains("friction dissipated"), "{said}");
}

/// A mass on rough surfaces: all speed is given back by elastic bodies, some kept by rubber and by adhesion; the same
/// files as of any impact, of an ensemble with the scatter of its results.
#[test]
fn rough_bodies_strike() {
    let of = |more: &str, bodies: &str, adhesion: &str, speed: &str| {
        let scene = format!(
            "(shape: RoughLine({SPECTRUM} length: \"100 um\", points: 4096 {more}), bodies: ({bodies}, Rigid), {adhesion}
            accuracy: 1e-4, history: [Impact(mass: 1e-9, speed: {speed})], steps: 50)"
        );
        run(&scene, None, &[])
    };
    let elastic = "Elastic(young: \"3 MPa\", poisson: 0.5)";
    let (folder, said) = of("", elastic, "", "\"0.1 m/s\"");
    assert!(said.contains("approximate") && !said.contains("contact radius"), "{said}");
    let (records, impacts) = (table(folder.path(), ".csv"), table(folder.path(), ".impacts.csv"));
    assert!((column(&impacts, "restitution")[0] - 1.0).abs() <= 0.0 && !impacts.contains("pressure"), "{impacts}");
    assert!((column(&impacts, "lost_j")[0]).abs() <= 0.0);
    // The way out mirrors the way in.
    let (force, depth) = (column(&records, "force_n"), column(&records, "indentation_m"));
    assert_eq!(force.len(), 51);
    let (most, deepest) = (column(&impacts, "largest_force_n")[0], column(&impacts, "greatest_depth_m")[0]);
    assert!((force[25] / most - 1.0).abs() < 1e-12 && (depth[25] / deepest - 1.0).abs() < 1e-12);
    assert!((0..=50).all(|k| (force[k] - force[50 - k]).abs() < 1e-9 * most && depth[k] < deepest * (1.0 + 1e-12)));

    let rubber = "Viscoelastic(poisson: 0.5, shear: (equilibrium: \"0.5 MPa\", terms: [(modulus: \"0.5 MPa\", time: \"1 ms\")]))";
    let wax = "Plastic(young: \"3 MPa\", poisson: 0.5, hardness: \"20 kPa\")";
    for (bodies, adhesion) in [(rubber, ""), (elastic, "adhesion: Jkr(work: 0.01, closing: 0.005),"), (wax, "")] {
        let (folder, said) = of(", seeds: 4", bodies, adhesion, "[\"0.1 m/s\", \"0.3 m/s\"]");
        assert!(said.contains("members"), "{said}");
        let impacts = table(folder.path(), ".impacts.csv");
        let (restitution, scatter) = (column(&impacts, "restitution"), column(&impacts, "restitution_deviation"));
        assert!(restitution.iter().chain(&scatter).all(|part| *part > 0.0 && *part < 0.999), "{impacts}");
        assert_eq!((restitution.len(), column(&table(folder.path(), ".ensemble.csv"), "time_s").len() > 50), (2, true));
    }
    let (one, _) = of(", seeds: 4", rubber, "", "\"0.1 m/s\"");
    let json = table(one.path(), ".json");
    for name in ["restitution", "restitution_deviation", "contact_time_deviation_s", "sticking_members", "rms_slope"] {
        assert!(json.contains(&format!("\"{name}\"")), "{name}: {json}");
    }
}

/// A rough surface that yields: below the largest force all is elastic, over the dents; the same in rows of a table of the
/// motion; what is lost is the area of the loop; friction and adhesion are refused with both names.
#[test]
fn a_rough_metal_keeps_its_dents() {
    let scene = |history: &str, more: &str| {
        format!(
            "(shape: RoughLine({SPECTRUM} length: \"100 um\", points: 4096, seeds: 3),
            bodies: (Plastic(young: \"200 GPa\", poisson: 0.3, hardness: \"2 GPa\"), Rigid), {more} history: {history})"
        )
    };
    let history = "[Press(to: 1e-3, over: 1), Press(to: 0, over: 1), Press(to: 1e-3, over: 1), Press(to: 0, over: 1)]";
    let (folder, said) = run(&scene(history, "steps: 400,"), None, &[]);
    assert!(said.contains("residual depth deviation"), "{said}");
    let records = table(folder.path(), ".csv");
    let of = |name: &str| column(&records, name);
    let (force, depth, lost) = (of("force_n"), of("indentation_m"), of("dissipated_j"));
    let work: f64 = (1..force.len()).map(|k| 0.5 * (force[k] + force[k - 1]) * (depth[k] - depth[k - 1])).sum();
    assert!((work / lost[1600] - 1.0).abs() < 1e-3, "{work:e} {:e}", lost[1600]);
    assert!(lost[1600] > 0.1 * of("stored_j")[400] && (lost[1600] / lost[400] - 1.0).abs() < 1e-12);
    // On the way back and in again the same states.
    assert!((0..=400).all(|k| (depth[800 + k] - depth[800 - k]).abs() < 1e-9 * depth[400]), "{depth:?}");
    let dent = depth[800];
    let json: serde_json::Value = serde_json::from_str(&table(folder.path(), ".json")).unwrap();
    assert!((json["results"]["residual_depth_m"].as_f64().unwrap() / dent - 1.0).abs() < 1e-9, "{json}");

    let deepest = format!("{:e}", depth[400]);
    let straight = format!("[Indent(to: {deepest}, over: 1), Indent(to: 0, over: 1)]");
    let (whole, _) = run(&scene(&straight, ""), None, &[]);
    let rows = format!("time_s,indentation_m\n0,0\n0.3,{:e}\n1,{deepest}\n2,0\n", 0.3 * depth[400]);
    let (cut, _) = run(&scene("[Table(\"map\")]", ""), Some(rows.as_bytes()), &[]);
    let last = |folder: &TempDir| column(&table(folder.path(), ".csv"), "dissipated_j").last().copied().unwrap();
    assert!((last(&whole) / last(&cut) - 1.0).abs() < 1e-12);
}

/// Rubber on a rough surface, slid: full slip carries μF while F relaxes.
#[test]
fn a_rough_rubber_slides() {
    let rubber = "Viscoelastic(poisson: 0.5, shear: (equilibrium: \"1 MPa\", terms: [(modulus: \"9 MPa\", time: 1)]))";
    let scene = format!(
        "(shape: RoughLine({SPECTRUM} length: \"100 um\", points: 4096), bodies: ({rubber}, Rigid), friction: Coulomb(coefficient: 0.3),
        history: [Indent(to: \"2 um\", over: 0.1), Slide(to: \"20 um\", over: 1)])"
    );
    let (folder, said) = run(&scene, None, &[]);
    let records = table(folder.path(), ".csv");
    let (normal, tangential) = (column(&records, "force_n"), column(&records, "tangential_force_n"));
    let last = normal.len() - 1;
    assert!(normal[last] < 0.7 * normal[last - 90], "{normal:?}");
    for k in last - 50..=last {
        assert!((tangential[k] / (0.3 * normal[k]) - 1.0).abs() < 1e-12, "{k}");
    }
    assert!(said.contains("friction dissipated"), "{said}");
}
