//! A spring swept along a track.

use super::kernel::Kernel;
use super::tally::Tally;
use super::track::Track;
use crate::contact::viscoelastic::spring::{Motion, Spring};

/// A spring swept along a track at the speed `speed` [m/s]: how it is at the end.
pub(super) fn swept(
    kernel: &mut Kernel,
    track: &Track,
    (speed, mut spring): (f64, Spring),
    tally: &mut Tally,
) -> Spring {
    for (step, depths) in track.steps.iter().zip(track.depths.windows(2)) {
        let duration = step / speed;
        kernel.prepare(duration);
        let motion = Motion { start: depths[0], speed: (depths[1] - depths[0]) / duration, duration };
        kernel.step(&mut spring, &motion, tally);
    }
    spring
}
