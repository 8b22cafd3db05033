//! The ledger of energies of a scene: what is put in is stored or lost.

use super::ends::Largest;
use crate::run::record::{MachineState, Outcome, Record};

/// What the trapezoidal rule between records may miss of the work.
const TRAPEZOIDS: f64 = 2e-3;

/// Part of the force that parts the bodies which records must show for the work between them to be known.
const SHOWN: f64 = 0.5;

/// Work by the trapezoidal rule between records, against what is stored and lost; nothing lost is found again but by an
/// edge that `finds` it, and never as a pull tears the bodies apart.
pub(super) fn ledger(whole: &Outcome, exact: f64, finds: bool) -> Option<String> {
    let energy = Largest::of(whole).energy;
    let tears = |one: &Record, two: &Record| one.normal.indentation.is_some() && two.normal.indentation.is_none();
    let counts = |one: &Record, two: &Record| !finds || tears(one, two);
    if let Some(why) = regained(whole, exact * energy, counts) {
        return Some(why);
    }
    let led = led(&whole.records);
    // A pull that is over on the way from one record to the next is in none of them.
    let told = whole.number("pull_off_force_n").unwrap_or(0.0);
    let shown = led.iter().map(|record| record.normal.force.abs()).fold(0.0, f64::max);
    if shown <= 0.0 || shown < SHOWN * told.abs() {
        return None;
    }
    let (first, last) = (led.first()?, led.last()?);
    let [every, second] = [1, 2].map(|step| put_in(led, step));
    let off = (every - accounted(last) + accounted(first)).abs();
    // Of a force that changes between two records nobody knows the work: then every second record tells another, and one
    // that jumps may do so at either of them.
    let seldom = if told.abs() > shown { passed(led, told.abs()) } else { 0.0 };
    let bound = (TRAPEZOIDS + exact) * energy + (every - second).abs() + jump(led) + seldom;
    (off > bound || off.is_nan()).then(|| format!("the ledger is open by {:e} of the energies", off / energy))
}

/// Where dissipation falls by more than `bound` [J] between two records that count.
fn regained(whole: &Outcome, bound: f64, counts: impl Fn(&Record, &Record) -> bool) -> Option<String> {
    let lost = |record: &Record| record.normal.dissipated;
    let pairs = whole.records.windows(2).filter(|pair| counts(&pair[0], &pair[1]));
    let back = pairs.map(|pair| lost(&pair[0]) - lost(&pair[1])).fold(0.0, f64::max);
    (back > bound).then(|| format!("dissipation falls by {:e} of the energies", back / Largest::of(whole).energy))
}

/// The ledger of a machine, which keeps the work that is put in by itself: at each record what has been put in is
/// kinetic, in the spring, in the contact, or lost.
pub(super) fn ledger_of_machine(whole: &Outcome, exact: f64) -> Option<String> {
    let driven = || whole.records.iter().filter_map(|record| Some((record, record.machine?)));
    let largest = driven().map(|(_, machine)| machine.work.abs().max(machine.kinetic)).fold(0.0, f64::max);
    let open = driven()
        .map(|(record, machine)| open(record, &machine))
        .fold(0.0, |most: f64, off| if off.is_nan() { f64::INFINITY } else { most.max(off.abs()) });
    (open > exact * largest).then(|| format!("the ledger of the machine is open by {:e} of its work", open / largest))
}

/// What is missing of the work put in [J].
fn open(record: &Record, machine: &MachineState) -> f64 {
    let rubbed = record.tangential.and_then(|state| state.dissipated).unwrap_or(0.0);
    let stored = machine.kinetic + machine.spring + machine.sheared.unwrap_or(0.0) + record.normal.stored.stored();
    machine.work - stored - machine.damped - record.normal.dissipated - rubbed
}

/// What has been stored and lost [J].
fn accounted(record: &Record) -> f64 {
    let rubbed = record.tangential.map_or(0.0, |state| state.stored.unwrap_or(0.0) + state.dissipated.unwrap_or(0.0));
    record.normal.stored.stored() + record.normal.dissipated + rubbed
}

/// The records from which on the depth is led: a table may begin in contact, to which the bodies come at once.
fn led(records: &[Record]) -> &[Record] {
    let Some(first) = records.first() else { return records };
    let begin = records.partition_point(|record| record.time <= first.time).saturating_sub(1);
    let came = |record: &Record| record.normal.indentation != first.normal.indentation;
    if records.get(begin).is_some_and(came) { &records[begin..] } else { records }
}

/// Work [J] by the trapezoidal rule over every `step`-th record, and the last.
fn put_in(records: &[Record], step: usize) -> f64 {
    let last = records.len().saturating_sub(1);
    let taken: Vec<&Record> = (0..last).step_by(step).chain([last]).filter_map(|k| records.get(k)).collect();
    taken.windows(2).map(|pair| work(pair[0], pair[1])).sum()
}

/// The most [J] that a jump between two records may leave open.
fn jump(records: &[Record]) -> f64 {
    let depth = |record: &Record| record.normal.indentation.unwrap_or(0.0);
    let open =
        |one: &Record, two: &Record| 0.5 * ((two.normal.force - one.normal.force) * (depth(two) - depth(one))).abs();
    let between = records.windows(2).filter(|pair| pair.iter().all(|record| record.normal.indentation.is_some()));
    between.map(|pair| open(&pair[0], &pair[1])).fold(0.0, f64::max)
}

/// The most [J] that a pull `greatest` [N], above all that records show, may have done between two of them beyond their mean.
fn passed(records: &[Record], greatest: f64) -> f64 {
    let depth = |record: &Record| record.normal.indentation.filter(|_| record.normal.force < 0.0);
    let beyond = |one: &Record, two: &Record| {
        let mean = 0.5 * (one.normal.force + two.normal.force).abs();
        Some((greatest - mean) * (depth(two)? - depth(one)?).abs())
    };
    records.windows(2).filter_map(|pair| beyond(&pair[0], &pair[1])).fold(0.0, f64::max)
}

/// Work between two records [J]; what a force does as it tears the bodies apart no record tells, but it is lost, not found.
fn work(one: &Record, two: &Record) -> f64 {
    let slide = |record: &Record| record.tangential.map_or((0.0, 0.0), |state| (state.slide, state.force));
    let ((from, resisted), (to, resists)) = (slide(one), slide(two));
    let rubbed = 0.5 * (resisted + resists) * (to - from);
    let (Some(from), Some(to)) = (one.normal.indentation, two.normal.indentation) else {
        let torn = one.normal.indentation.is_some() && one.normal.force <= 0.0;
        return rubbed + if torn { (accounted(two) - accounted(one)).max(0.0) } else { 0.0 };
    };
    0.5 * (one.normal.force + two.normal.force) * (to - from) + rubbed
}
