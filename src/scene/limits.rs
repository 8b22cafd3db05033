//! What is too much, too long or too little of one part by itself.

use crate::input::problem::Problem;
use crate::scene::history::EntryTraits;
use crate::scene::rules::Draft;

/// Most springs: their state alone has a gigabyte.
const MOST_SPRINGS: usize = 1 << 26;
/// Most records of a scene: beyond it the outputs alone would fill the memory.
const MOST_RECORDS: usize = 10_000_000;
/// Records of a contact that wears, unless the scene asks for more: few of many cycles are kept.
const MOST_WORN: usize = 10_000;

/// What is beyond the limits of a scene.
#[must_use]
pub fn problems(draft: &Draft<'_>) -> Vec<Problem> {
    let once = [too_many_springs(draft), no_history(draft), too_many_records(draft), endless(draft)];
    once.into_iter().flatten().chain(draft.entries().flatten().filter_map(no_speed)).collect()
}

fn too_many_springs(draft: &Draft<'_>) -> Option<Problem> {
    let springs = draft.springs()?.get();
    (springs > MOST_SPRINGS)
        .then(|| Problem::new("springs", format!("{springs} do not fit into memory: expected at most {MOST_SPRINGS}")))
}

fn no_history(draft: &Draft<'_>) -> Option<Problem> {
    (draft.length()? == 0).then(|| {
        Problem::new("history", "is empty: expected at least one entry such as Indent(to: \"1 um\", over: \"1 s\")")
    })
}

fn no_speed(entry: &EntryTraits<'_>) -> Option<Problem> {
    let impact = entry.impact.map(|impact| &impact.speed);
    let speeds = impact.or(entry.glide.map(|(glide, _)| &glide.speed))?;
    speeds.is_empty().then(|| {
        Problem::new(
            format!("{}.speed", entry.place()),
            "is an empty list: expected at least one speed such as \"1 m/s\"",
        )
    })
}

fn too_many_records(draft: &Draft<'_>) -> Option<Problem> {
    let (counted, mut sum) = (draft.counts_records()?, 0usize);
    let entry = draft.entries().map_while(|entry| entry).find(|entry| {
        let least = if draft.wear().is_some() { entry.least_records.min(MOST_WORN) } else { entry.least_records };
        sum = sum.saturating_add(least);
        sum > MOST_RECORDS
    })?;
    let path = if counted { "steps".to_owned() } else { entry.place() };
    let what =
        format!("the history would have more than {MOST_RECORDS} records: expected fewer steps, cycles or entries");
    Some(Problem::new(path, what))
}

/// The duration of a history must be a number.
fn endless(draft: &Draft<'_>) -> Option<Problem> {
    let mut time = 0.0;
    let entry = draft.entries().map_while(|entry| entry).find(|entry| {
        time += entry.stages.iter().map(|stage| stage.over).sum::<f64>();
        time += entry.machine.map_or(0.0, |machine| machine.over);
        f64::is_infinite(time)
    })?;
    Some(Problem::new(entry.place(), "ends at a time too large to compute with: expected shorter entries"))
}
