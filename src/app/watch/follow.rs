//! A look at a file, many times a second.
//!
//! Looking costs microseconds, works on every file system and follows editors that put a new file in the place of the
//! old one, where being told of changes does not.

use super::bench::{Bench, Tables};
use crate::app::read::read_text;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Time between two looks.
const LOOK: Duration = Duration::from_millis(10);
/// A file as young as this is read at each look: the clock of the file system may not tell two saves apart.
const YOUNG: Duration = Duration::from_millis(500);
/// Time for which a file may be missing or empty while it is saved.
const BETWEEN: Duration = Duration::from_millis(60);
/// Largest scene that is followed.
const LARGEST: u64 = 16 << 20;

/// What tells one state of a file from another.
type Stamp = Option<(SystemTime, u64)>;

fn stamp(path: &Path) -> Stamp {
    let told = std::fs::metadata(path).ok()?;
    Some((told.modified().ok()?, told.len()))
}

/// Tells `bench` of every change of the scene and of the tables it names, for ever.
pub fn follow(bench: &Bench) {
    let (mut before, mut stamps): (Option<Stamp>, Vec<(PathBuf, Stamp)>) = (None, Vec::new());
    loop {
        let now = stamp(&bench.path);
        let young = now.is_some_and(|(at, _)| at.elapsed().is_ok_and(|age| age < YOUNG));
        let changed = stamps.iter().any(|(path, was)| stamp(path) != *was);
        if before != Some(now) || young || changed {
            before = Some(now);
            look(bench, now, if changed { Tables::Changed } else { Tables::Same });
        }
        let named = bench.tables();
        if changed || !named.iter().eq(stamps.iter().map(|(path, _)| path)) {
            stamps = named.into_iter().map(|path| (path.clone(), stamp(&path))).collect();
        }
        bench.tick();
        std::thread::sleep(LOOK);
    }
}

fn look(bench: &Bench, now: Stamp, tables: Tables) {
    let mut read = read_text(&bench.path, LARGEST);
    if read.as_ref().is_ok_and(|text| text.is_empty()) || read.is_err() {
        std::thread::sleep(BETWEEN);
        read = read_text(&bench.path, LARGEST);
    }
    let saved = stamp(&bench.path).or(now).map(|(at, _)| at);
    bench.saved(read.map_err(|fault| vec![fault]), saved, tables);
}
