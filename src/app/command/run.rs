//! `springbed run`: scenes to files.

use super::Common;
use super::check::load;
use super::sweep::{Job, SweepArgs};
use crate::app::console::{Console, Failure};
use crate::app::export;
use crate::app::overwrite::{self, Outputs};
use crate::app::picture::unwritable;
use crate::app::progress::Progress;
use crate::app::run::{Product, compute_watched, endings, products};
use crate::app::scene_file::SceneFile;
use crate::app::write::write_all;
use crate::run::in_pieces;
use rayon::prelude::*;
use std::path::PathBuf;

/// What is said about a scene that has been run.
struct Done {
    summary: String,
    json: String,
    warnings: Vec<String>,
    written: Vec<PathBuf>,
}

/// Runs scenes on all threads; says what came out in the order given.
///
/// # Errors
/// A scene is wrong (then none is run), a computation failed, or a file cannot be written.
pub fn run(paths: &[PathBuf], swept: &SweepArgs, common: &Common, console: &Console) -> Result<(), Failure> {
    let scenes = load(paths)?;
    let jobs = scenes.iter().map(|scene| swept.job(scene)).collect::<Result<Vec<_>, Failure>>()?;
    let all: Vec<(&SceneFile, Option<Job<'_>>)> = scenes.iter().zip(jobs).collect();
    no_clash(&all, common)?;
    let plain: Vec<&SceneFile> = all.iter().filter(|(_, job)| job.is_none()).map(|(scene, _)| *scene).collect();
    let mut done = all_done(&plain, common, console).into_iter();
    let (mut jsons, mut failed) = (Vec::new(), Vec::new());
    for (scene, job) in &all {
        if let Some(job) = job {
            let swept = job.run(common, console)?;
            jsons.extend(swept.json);
            failed.extend(swept.failure);
        } else {
            match done.next() {
                Some(Ok(done)) => jsons.push(said(&done, scene, common, console)?),
                Some(Err(message)) => failed.push(format!("{}: {message}", scene.path.display())),
                None => {}
            }
        }
    }
    if common.json {
        console.result(&export::json_of_all(&jsons))?;
    }
    if failed.is_empty() { Ok(()) } else { Err(Failure::Failed(failed.join("\n"))) }
}

/// The scenes in parallel under one bar; a scene alone under a bar of its own, as that of an ensemble.
fn all_done(scenes: &[&SceneFile], common: &Common, console: &Console) -> Vec<Result<Done, String>> {
    if let [scene] = scenes {
        let progress = Progress::of("computing", console);
        return vec![done(scene, common, &|share| progress.done(share))];
    }
    let progress = console.progress(scenes.len(), "scenes");
    let done = scenes.par_iter().map(|scene| done(scene, common, &|_| ())).inspect(|_| progress.inc(1)).collect();
    progress.finish_and_clear();
    done
}

/// No file a scene can write may be read by a scene or written by another.
fn no_clash(all: &[(&SceneFile, Option<Job<'_>>)], common: &Common) -> Result<(), Failure> {
    let outputs = all.iter().map(|(scene, job)| match job {
        Some(job) => job.outputs(common),
        None => outputs(scene, common),
    });
    overwrite::refuse(&common.out, &outputs.collect::<Vec<_>>())
}

fn outputs<'s>(scene: &'s SceneFile, common: &Common) -> Outputs<'s> {
    let endings = endings(&scene.plan, &common.format).into_iter();
    Outputs { scene, names: endings.map(|ending| format!("{}{ending}", scene.stem())).collect() }
}

fn done(scene: &SceneFile, common: &Common, watch: &(dyn Fn(f64) + Sync)) -> Result<Done, String> {
    let plan = &scene.plan;
    let file = scene.file_name();
    let outcome = compute_watched(plan, &common.format, watch).map_err(|error| error.to_string())?;
    if let Some(why) = in_pieces(&outcome) {
        return Err(why.to_owned());
    }
    let products = products(plan, &file, &outcome, &common.asked()).map_err(|error| error.to_string())?;
    let json = if common.json { export::json(&plan.scene, &file, &outcome) } else { Ok(String::new()) };
    Ok(Done {
        summary: export::summary(&plan.scene.title, &outcome),
        json: json.map_err(|error| error.to_string())?,
        written: written(&products, scene, common)?,
        warnings: outcome.warnings.into_iter().chain(unwritable(&plan.scene.title, &common.format)).collect(),
    })
}

fn written(products: &[Product], scene: &SceneFile, common: &Common) -> Result<Vec<PathBuf>, String> {
    let stem = scene.stem();
    let files: Vec<(String, &[u8])> =
        products.iter().map(|product| (format!("{stem}{}", product.ending), &product.content[..])).collect();
    write_all(&common.out, &files).map_err(|error| error.to_string())
}

/// Says what came out of one scene; gives back its JSON.
fn said(done: &Done, scene: &SceneFile, common: &Common, console: &Console) -> Result<String, Failure> {
    if !common.json {
        console.say(&done.summary)?;
    }
    for warning in &done.warnings {
        console.warning(&format!("{}: {warning}", scene.path.display()));
    }
    let written: Vec<String> = done.written.iter().map(|path| path.display().to_string()).collect();
    if !written.is_empty() {
        console.message(&format!("  wrote {}", written.join(", ")));
    }
    Ok(done.json.clone())
}
