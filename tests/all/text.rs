//! Scenes as RON and as JSON: one says what the other says.

use springbed::scene::Scene;
use std::path::{Path, PathBuf};

fn scenes() -> Vec<(PathBuf, Scene)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs");
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let texts = paths.filter(|path| path.extension().is_some_and(|extension| extension == "ron"));
    texts.map(|path| (path.clone(), Scene::from_ron(&std::fs::read_to_string(path).unwrap()).unwrap())).collect()
}

/// To the bit: numbers are written so that they read back the same.
#[test]
fn every_scene_reads_back_from_its_json() {
    let scenes = scenes();
    assert!(scenes.len() > 30);
    for (path, scene) in scenes {
        let json = scene.to_json().unwrap();
        let back = Scene::from_json(&json).unwrap_or_else(|error| panic!("{}: {error}\n{json}", path.display()));
        assert_eq!(back, scene, "{}", path.display());
    }
}

const SCENE: &str = r#"{
  "shape": {"Sphere": {"radius": "5 mm"}},
  "bodies": [{"Elastic": {"young": "1 MPa", "poisson": 0.5}}, "Rigid"],
  "history": [{"Indent": {"to": "10 um", "over": 1}}]
}"#;

#[test]
fn json_is_written_as_ron_is() {
    let ron = r#"(shape: Sphere(radius: "5 mm"), bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid),
        history: [Indent(to: "10 um", over: 1)])"#;
    assert_eq!(Scene::from_json(SCENE).unwrap(), Scene::from_ron(ron).unwrap());
}

/// Wrong words, and where and what is said of them.
#[test]
fn wrong_json_is_refused_with_its_place() {
    let wrong = [
        ("\"5 mm\"", "\"5 kg\"", (2, 34), "shape.radius: \"5 kg\" has the unit \"kg\": expected a length"),
        ("radius", "radus", (2, 24), "shape.radus: unknown field `radus`, expected `radius`"),
        ("Sphere", "Ball", (2, 13), "shape: unknown variant `Ball`"),
        ("0.5", "0.7", (3, 56), "bodies[0].poisson: 0.7 is out of range"),
        (", \"poisson\": 0.5", "", (3, 26), "missing field `poisson`"),
        ("\"Rigid\"]", "\"Rigid\"", (4, 3), "trailing characters: expected a scene in the notation of JSON"),
    ];
    let found = wrong.map(|(right, other, ..)| Scene::from_json(&SCENE.replacen(right, other, 1)).unwrap_err());
    for ((_, other, place, message), error) in wrong.iter().zip(&found) {
        assert_eq!((error.position.line, error.position.column), *place, "{other}: {found:#?}");
        assert!(error.message.contains(message), "{other}: {found:#?}");
    }
}

/// What does not fit together stands at its value as well.
#[cfg(feature = "cli")]
#[test]
fn a_scene_file_may_be_json() {
    use springbed::app::scene_file::plan;
    let path = Path::new("scene.json");
    assert!(plan(path, SCENE).is_ok());
    let faults = plan(path, &SCENE.replace("Indent", "Slide")).unwrap_err();
    assert_eq!(faults[0].position.unwrap().line, 4, "{faults:?}");
}
