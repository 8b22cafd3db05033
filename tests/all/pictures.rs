//! PNG and PDF beside SVG, and figures for paper.

use std::path::Path;
use std::process::{Command, Output, Stdio};

fn springbed(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
    command.stdin(Stdio::null()).current_dir(folder).args(arguments).output().unwrap()
}

const SCENE: &str = r#"(title: "鋼 ball", shape: Paraboloid(radius: "10 mm"),
    bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid), history: [Indent(to: "1 um", over: 1)])"#;

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.ron"), SCENE).unwrap();
    folder
}

/// Width of a PNG, its height and its dots per metre.
fn size(png: &[u8]) -> [u32; 3] {
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    let physical = png.windows(4).position(|word| word == b"pHYs").unwrap() + 4;
    [number(16), number(20), number(physical)]
}

#[test]
fn pictures_come_with_their_feature_and_without_it_it_is_said_how() {
    let folder = folder();
    let at = folder.path();
    let output = springbed(at, &["run", "a.ron", "--format", "svg,png,pdf", "--out", "x"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    if !cfg!(feature = "pictures") {
        assert_eq!(output.status.code(), Some(2));
        assert!(said.contains("needs the feature `pictures`") && said.contains("--features pictures"), "{said}");
        assert!(!at.join("x").exists());
        return;
    }
    assert!(output.status.success(), "{said}");
    assert!(said.contains("boxes for 鋼"), "{said}");
    let read = |name: &str| std::fs::read(at.join(name)).unwrap();
    assert!(read("x/a.png").starts_with(b"\x89PNG") && read("x/a.pdf").starts_with(b"%PDF"));
    // The same bytes again, on another number of threads.
    let again = ["run", "a.ron", "--format", "png,pdf", "--out", "y", "--threads", "1"];
    assert!(springbed(at, &again).status.success());
    assert!(read("x/a.png") == read("y/a.png") && read("x/a.pdf") == read("y/a.pdf"));
    // Paper: 85 mm with 600 dots per inch are 2008 dots.
    let paper = ["run", "a.ron", "--format", "png", "--style", "paper", "--out", "z"];
    assert!(springbed(at, &paper).status.success());
    let [width, _, dots] = size(&read("z/a.png"));
    assert_eq!((width, dots), (2008, 23623));
    let [wide, high, _] = size(&read("x/a.png"));
    let coarse = ["run", "a.ron", "--format", "png", "--dpi", "100", "--out", "w"];
    assert!(springbed(at, &coarse).status.success());
    let [half, half_high, _] = size(&read("w/a.png"));
    assert!(half.abs_diff(wide.div_ceil(2)) <= 1 && half_high.abs_diff(high.div_ceil(2)) <= 1);
    let overlay = ["overlay", "a.ron", "--format", "pdf", "--out", "o"];
    assert!(springbed(at, &overlay).status.success() && read("o/overlay.pdf").starts_with(b"%PDF"));
}

#[cfg(feature = "plot")]
#[test]
fn a_figure_for_paper_is_as_wide_as_a_column() {
    let folder = folder();
    let at = folder.path();
    for (style, width) in [("paper", "85mm"), ("paper-wide", "175mm")] {
        assert!(springbed(at, &["run", "a.ron", "--format", "svg", "--style", style]).status.success());
        let svg = std::fs::read_to_string(at.join("plots/a.svg")).unwrap();
        assert!(svg.contains(&format!("width=\"{width}\"")) && svg.contains("(a)"), "{style}");
    }
    assert_eq!(springbed(at, &["run", "a.ron", "--dpi", "5"]).status.code(), Some(2));
}

/// Measured with the font itself: of no shipped scene does a letter leave the sheet, on a screen or on paper.
#[cfg(feature = "pictures")]
#[test]
fn no_text_of_a_shipped_scene_leaves_its_sheet() {
    use rayon::prelude::*;
    use resvg::usvg::{Group, Node, Options, Tree, fontdb::Database};
    use springbed::app::medium::Medium;
    use springbed::app::{export, run, scene_file::SceneFile};

    /// The texts whose ink is not on the sheet.
    fn outside(group: &Group, size: (f32, f32), found: &mut Vec<String>) {
        for node in group.children() {
            match node {
                Node::Group(group) => outside(group, size, found),
                Node::Text(text) => {
                    let ink = text.abs_bounding_box();
                    let on = ink.left() >= 0.0 && ink.top() >= 0.0 && ink.right() <= size.0 && ink.bottom() <= size.1;
                    let words = text.chunks().iter().map(|chunk| chunk.text());
                    found.extend((!on).then(|| format!("{} at {ink:?} of {size:?}", words.collect::<String>())));
                }
                Node::Path(_) | Node::Image(_) => {}
            }
        }
    }

    let mut fonts = Database::new();
    fonts.load_font_data(dejavu::sans::regular().to_vec());
    fonts.load_font_data(dejavu::sans::bold().to_vec());
    fonts.set_sans_serif_family("DejaVu Sans");
    let options = Options { fontdb: fonts.into(), ..Options::default() };
    super::scenes::scenes().into_par_iter().for_each(|path| {
        let scene = SceneFile::load(&path).unwrap_or_else(|faults| panic!("{faults:?}"));
        let outcome = run::compute(&scene.plan, &[run::Format::Csv, run::Format::Svg]).unwrap();
        let figure = export::figures(&scene.plan, &outcome);
        for medium in [Medium::Screen, Medium::Paper, Medium::PaperWide] {
            let tree = Tree::from_str(&figure.drawn(medium), &options).unwrap();
            let mut found = Vec::new();
            outside(tree.root(), (tree.size().width(), tree.size().height()), &mut found);
            assert!(found.is_empty(), "{} {medium:?}: {found:?}", path.display());
        }
    });
}
