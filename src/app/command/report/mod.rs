//! `springbed report`: accuracy, stability, speed.

mod accuracy;
mod peers;
mod speed;
mod stability;

use super::{Common, Topic};
use crate::app::console::{Console, Failure};
use crate::app::run::Format;
use crate::app::write::write_all;
use crate::check::work_precision::Effort;
use std::path::Path;

/// Makes a report.
///
/// # Errors
/// A scene is wrong, a check failed, or a file cannot be written.
pub fn run(
    (topic, scene): (Topic, Option<&Path>),
    effort: Effort,
    common: &Common,
    console: &Console,
) -> Result<(), Failure> {
    match (topic, scene) {
        (Topic::Accuracy, None) => accuracy::run(effort, common, console),
        (Topic::Stability, None) => stability::run(common, console),
        (Topic::Speed, None) => speed::run(effort, common, console),
        (Topic::Accuracy, Some(scene)) => accuracy::of_scene(scene, effort, common, console),
        (Topic::Stability | Topic::Speed, Some(scene)) => Err(Failure::Usage(format!(
            "{}: stability and speed are those of the program: expected no scene",
            scene.display()
        ))),
    }
}

/// A file of a report: its name and its text.
type File = (String, String);

/// Says the report on standard output, as a table or as JSON, and writes its files of the formats asked for.
fn deliver(files: Vec<File>, said: &str, common: &Common, console: &Console) -> Result<(), Failure> {
    if common.json {
        console.result(said)?
    } else {
        console.say(said)?
    }
    let wanted = |name: &str| {
        let of = |format: Format, ending: &str| common.format.contains(&format) && name.ends_with(ending);
        of(Format::Csv, ".csv") || of(Format::Json, ".json") || of(Format::Svg, ".svg")
    };
    let files: Vec<(String, &[u8])> =
        files.iter().filter(|file| wanted(&file.0)).map(|(name, text)| (name.clone(), text.as_bytes())).collect();
    let written = write_all(&common.out, &files).map_err(Failure::failed)?;
    let written: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
    if !written.is_empty() {
        console.message(&format!("  wrote {}", written.join(", ")));
    }
    Ok(())
}
