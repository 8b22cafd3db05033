//! What happens on a straight piece of the depth: the force turns, the bodies touch or part.

use super::bed::ReadBed;
use crate::contact::viscoelastic::drive::State;
use crate::contact::viscoelastic::memory::BedError;

/// Something that happens at an instant, with the states on both sides.
#[derive(Debug, Clone, Copy)]
pub struct Instant {
    /// Time since the beginning of the piece [s].
    pub time: f64,
    /// State just before.
    pub before: State,
    /// State just after.
    pub after: State,
}

/// A straight piece of the depth.
#[derive(Debug, Clone, Copy)]
pub struct Straight {
    /// Speed [m/s].
    pub speed: f64,
    /// Duration [s].
    pub duration: f64,
}

/// A glance at the contact.
#[derive(Debug, Clone, Copy)]
struct Glance {
    time: f64,
    force: f64,
    radius: f64,
}

/// Relative change of the force below which a turn is rounding.
const NOISE: f64 = 1e-12;
/// What happens before this part of a look is the beginning, where there is a record already.
const BEGINNING: f64 = 1e-12;
/// Looks at equal distances in a whole entry.
const EVEN: i32 = 24;
/// Looks per decade towards the beginning of a piece, where the fast elements relax.
const PER_DECADE: i32 = 2;

/// Times at which a piece is looked at, whatever the records; `fastest` is the shortest time of the material [s].
pub fn looks(duration: f64, fastest: f64) -> Vec<f64> {
    let first = (0.1 * fastest / duration).clamp(1e-18, 1.0);
    let decades = (1..).map(|k| 10f64.powf(-f64::from(k) / f64::from(PER_DECADE))).take_while(|&part| part >= first);
    let mut parts: Vec<f64> = decades.filter(|&part| part < 1.0 / f64::from(EVEN)).collect();
    parts.reverse();
    parts.extend((1..EVEN).map(|k| f64::from(k) / f64::from(EVEN)));
    // A pull may turn just before the bodies part.
    parts.extend((3..=12).map(|k| 1.0 - 10f64.powf(-0.5 * f64::from(k))));
    parts.push(1.0);
    parts.into_iter().map(|part| part * duration).collect()
}

/// The instants of a piece, found between looks at `times`.
///
/// # Errors
/// The contact would outgrow the profile.
pub fn instants<B: ReadBed>(bed: &mut B, piece: &Straight, times: &[f64]) -> Result<Vec<Instant>, BedError> {
    let start = bed.state();
    let mut seen = vec![Glance { time: 0.0, force: start.force, radius: start.contact_radius }];
    for &time in times {
        let (force, radius) = bed.glance(piece.speed, time)?;
        seen.push(Glance { time, force, radius });
    }
    let mut found = Vec::new();
    for pair in seen.windows(2) {
        if (pair[0].radius > 0.0) != (pair[1].radius > 0.0) {
            found.extend(edge_of_contact(bed, piece, (pair[0], pair[1]))?);
        }
    }
    for three in seen.windows(3).filter(|three| three.iter().all(|glance| glance.radius > 0.0)) {
        found.extend(turn(bed, piece, three)?);
    }
    found.sort_by(|one, other| one.time.total_cmp(&other.time));
    Ok(found)
}

/// The instant between two looks at which the bodies touch or part.
fn edge_of_contact<B: ReadBed>(
    bed: &mut B,
    piece: &Straight,
    (before, after): (Glance, Glance),
) -> Result<Option<Instant>, BedError> {
    let joined = before.radius > 0.0;
    let (mut low, mut high) = (before.time, after.time);
    if low <= 0.0 && (bed.glance(piece.speed, BEGINNING * high)?.1 > 0.0) != joined {
        return Ok(None);
    }
    let torn = if joined { bed.parting(piece.speed, piece.duration)? } else { None };
    for time in torn.iter().flat_map(|time| [time * (1.0 - 1e-9), time * (1.0 + 1e-9)]) {
        if low < time && time < high {
            let still = bed.glance(piece.speed, time)?.1 > 0.0;
            *(if still == joined { &mut low } else { &mut high }) = time;
        }
    }
    while low < 0.5 * (low + high) && 0.5 * (low + high) < high {
        let middle = 0.5 * (low + high);
        let still = bed.glance(piece.speed, middle)?.1 > 0.0;
        *(if still == joined { &mut low } else { &mut high }) = middle;
    }
    let after = bed.state_after(piece.speed, high)?;
    let before = if torn.is_some() { bed.state_after(piece.speed, low)? } else { after };
    Ok(Some(Instant { time: high, before, after }))
}

/// The turn of the force among three looks.
fn turn<B: ReadBed>(bed: &mut B, piece: &Straight, three: &[Glance]) -> Result<Option<Instant>, BedError> {
    let [first, middle, last] = [three[0], three[1], three[2]];
    let noise = NOISE * middle.force.abs().max(first.force.abs()).max(last.force.abs());
    let sign = if middle.force > first.force { 1.0 } else { -1.0 };
    let over = |other: &Glance| sign * (middle.force - other.force);
    if over(&first).min(over(&last)) < 0.0 || over(&first).max(over(&last)) <= noise {
        return Ok(None);
    }
    let time = highest(|t| Ok(sign * bed.glance(piece.speed, t)?.0), (first.time, middle.time, last.time))?;
    let state = bed.state_after(piece.speed, time)?;
    Ok(Some(Instant { time, before: state, after: state }))
}

/// Where a function is greatest between `low` and `high`, by the golden section from `middle`.
fn highest(
    mut function: impl FnMut(f64) -> Result<f64, BedError>,
    (mut low, middle, mut high): (f64, f64, f64),
) -> Result<f64, BedError> {
    const GOLDEN: f64 = 0.381_966_011_250_105_15;
    let mut best = (middle, function(middle)?);
    for _ in 0..48 {
        let upper = high - best.0 > best.0 - low;
        let next = if upper { best.0 + GOLDEN * (high - best.0) } else { best.0 - GOLDEN * (best.0 - low) };
        let value = function(next)?;
        let (inside, outside) = if value > best.1 { (next, best.0) } else { (best.0, next) };
        *(if outside < inside { &mut low } else { &mut high }) = outside;
        best = if value > best.1 { (next, value) } else { best };
    }
    Ok(best.0)
}
