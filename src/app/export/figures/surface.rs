//! The surfaces of both bodies at an instant, to scale and exaggerated.

use crate::app::export::with_prefix;
use crate::app::figure::{Area, Axis, Hue, Line, Panel, Series, Shade};
use crate::material::{Body, Shares};
use crate::run::record::Outcome;
use crate::run::table::Table;
use crate::scene::plan::Plan;

/// Width of a frame over its height.
const RATIO: f64 = 2.0;
/// Part of the height of a frame below the undeformed plane.
const BELOW: f64 = 0.45;
/// Part of the radii shown in which an exaggerated indenter is seen.
const SEEN: f64 = 0.55;
/// Height shown of an exaggerated picture over that of what is to be seen.
const ROOM: f64 = 1.25;

/// Both bodies to scale and, if that leaves them flat, exaggerated.
pub fn panels(plan: &Plan, outcome: &Outcome) -> Vec<Panel> {
    let surfaces = outcome.table("surface").and_then(Surfaces::of);
    let drawn = surfaces.zip(Shares::of(&plan.scene.bodies));
    let panels = |(surfaces, shares): (Surfaces, Shares)| {
        let whole = surfaces.panel(plan, shares, 1.0).note(surfaces.told(&plan.scene.bodies, shares));
        let factor = surfaces.exaggeration();
        let tall = (factor > 1.0).then(|| surfaces.panel(plan, shares, factor));
        std::iter::once(whole).chain(tall).collect()
    };
    drawn.map(panels).unwrap_or_default()
}

/// Heights over the radius from the axis outwards.
struct Surfaces {
    time: f64,
    shape: Vec<(f64, f64)>,
    upper: Vec<(f64, f64)>,
    lower: Vec<(f64, f64)>,
}

impl Surfaces {
    fn of(table: &Table) -> Option<Self> {
        let radii = table.column("radius")?.numbers();
        let heights = |quantity| {
            let heights = table.column(quantity)?.numbers();
            Some(radii.iter().zip(heights).filter_map(|(r, height)| r.zip(*height)).collect())
        };
        let time = table.column("time")?.numbers().first().copied().flatten()?;
        Some(Self { time, shape: heights("shape")?, upper: heights("upper")?, lower: heights("lower")? })
    }

    /// Radius [m] out to which they are shown.
    fn reach(&self) -> f64 {
        self.lower.last().map_or(0.0, |point| point.0)
    }

    /// Least and largest height [m] to be seen of an exaggerated picture.
    fn heights(&self) -> (f64, f64) {
        let near = SEEN * self.reach();
        let upper = self.upper.iter().chain(&self.shape).filter(|point| point.0 <= near);
        let seen = upper.chain(&self.lower).map(|point| point.1);
        seen.fold((0.0, 0.0), |(low, high): (f64, f64), z| (low.min(z), high.max(z)))
    }

    /// The largest of 1, 2, 5, 10, … by which heights can be drawn larger than lengths.
    fn exaggeration(&self) -> f64 {
        let (low, high) = self.heights();
        round_below(2.0 * self.reach() / RATIO / (ROOM * (high - low)))
    }

    /// Least and largest height [m] in a frame of heights drawn `factor` times as large as lengths.
    fn ends(&self, factor: f64) -> (f64, f64) {
        let span = 2.0 * self.reach() / RATIO / factor;
        let (low, high) = self.heights();
        let bottom = if factor > 1.0 { 0.5 * (low + high - span) } else { (-BELOW * span).min(low - 0.05 * span) };
        (bottom, bottom + span)
    }

    fn told(&self, bodies: &(Body, Body), shares: Shares) -> String {
        let (time, taken) = (with_prefix(self.time, "s"), taken(bodies, shares));
        format!(
            "t = {time}. {taken} The shape is drawn on the stiffer body; to the contact it is all one which has it."
        )
    }

    fn panel(&self, plan: &Plan, shares: Shares, factor: f64) -> Panel {
        let (bottom, top) = self.ends(factor);
        let reach = self.reach();
        let across = Axis::linear("radius r", "m").from(-reach).to(reach);
        let heading = if factor > 1.0 { format!("heights × {factor}") } else { "to scale".to_owned() };
        let panel = Panel::new(across, Axis::linear("height z", "m").from(bottom).to(top))
            .titled(format!("largest force: {heading}"))
            .ratio(RATIO);
        let [above, below] = names(&plan.scene.bodies, shares);
        let (upper, lower) = (walled(&self.upper, (reach, top)), mirrored(&self.lower));
        let panel = panel
            .filled(Area { outline: closed(&lower, (reach, bottom)), shade: Shade::Medium })
            .filled(Area { outline: closed(&upper, (reach, top)), shade: Shade::Light });
        let thin =
            |points: Vec<(f64, f64)>| Series::new("undeformed", points).colour(Hue::Grey).line(Line::Dashed).fine();
        panel
            .with(thin(walled(&self.shape, (reach, top))))
            .with(thin(vec![(-reach, 0.0), (reach, 0.0)]))
            .with(Series::new(below, lower).colour(Hue::Vermillion).line(Line::Solid))
            .with(Series::new(above, upper).colour(Hue::Black).line(Line::Dashed))
    }
}

/// What is given from the axis outwards, on both sides from left to right.
fn mirrored(right: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let left = right.iter().rev().filter(|(r, _)| *r > 0.0).map(|&(r, z)| (-r, z));
    left.chain(right.iter().copied()).collect()
}

/// The same of an indenter that, if it ends before `reach`, ends in walls up to the top.
fn walled(right: &[(f64, f64)], (reach, top): (f64, f64)) -> Vec<(f64, f64)> {
    let wall = right.last().filter(|end| end.0 < reach).map(|&(r, z)| (r, z.max(2.0 * top)));
    mirrored(&right.iter().copied().chain(wall).collect::<Vec<_>>())
}

/// What lies between a line and the bottom or the top of the frame.
fn closed(line: &[(f64, f64)], (reach, end): (f64, f64)) -> Vec<(f64, f64)> {
    let at = |point: Option<&(f64, f64)>| (point.map_or(reach, |point| point.0), end);
    std::iter::once(at(line.first())).chain(line.iter().copied()).chain([at(line.last())]).collect()
}

/// Names of the body above and of the body below.
fn names(bodies: &(Body, Body), shares: Shares) -> [String; 2] {
    let (one, two) = (format!("body 1, {}", bodies.0.name()), format!("body 2, {}", bodies.1.name()));
    if shares.first_is_softer() { [two, one] } else { [one, two] }
}

/// Who takes how much of the displacement.
fn taken(bodies: &(Body, Body), shares: Shares) -> String {
    if [&bodies.0, &bodies.1].into_iter().any(|body| matches!(body, Body::Rigid)) {
        return "All of the displacement is that of the body that is not rigid.".to_owned();
    }
    let percent = |share: f64| format!("{:.1} %", 100.0 * share);
    format!(
        "Body 1 takes {} of the displacement, body 2 {}: in the ratio of their compliances 1/E*₁ : 1/E*₂.",
        percent(shares.one),
        percent(shares.two)
    )
}

/// The largest of …, 1, 2, 5, 10, … that is not above `value`.
fn round_below(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [5.0, 2.0].into_iter().map(|step| step * decade).find(|&round| round <= value).unwrap_or(decade)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_round() {
        for (value, round) in [(1.0, 1.0), (1.99, 1.0), (4.9, 2.0), (73.0, 50.0), (0.3, 0.2), (1000.0, 1000.0)] {
            assert!((round_below(value) - round).abs() < 1e-9 * round, "{value}");
        }
    }
}
