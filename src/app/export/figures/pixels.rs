//! A contact on pixels: its area over the force, the map of its pressure, how often pressures and gaps occur.

use super::curve::{axis_of, few, log, of_records, short};
use super::friction::from_first_slide;
use super::gliding;
use super::rough::beside_the_law;
use super::slides;
use crate::app::figure::{Axis, Cells, Hue, Line, Mark, Marks, Panel, Points, Series};
use crate::check::theory::NominallyFlat;
use crate::run::record::{AREA, ContactMap, FORCE, INDENTATION, LEAK, Outcome, Record, STICK_AREA, STIFFNESS, TIME};
use crate::run::table::Table;
use crate::scene::Plot;
use crate::scene::law::{ElasticAdhesion, PixelFriction};
use crate::scene::plan::{HalfSpacePlan, Plan};
use ndarray::{Array2, s};
use std::collections::BTreeMap;

/// Ratio of the largest conductance to the least from which on both are seen over decades only.
const DECADE: f64 = 10.0;

/// Pieces of the curve of a theory.
const THEORY: u32 = 64;

/// Corners of a piece of an outline; longer curves are thinned column by column, which a way round does not bear.
const PIECE: usize = 128;

/// Most cells along a side of the map.
const SHOWN: usize = 128;

/// What suits a contact on pixels.
pub fn suiting(plan: &HalfSpacePlan, outcome: &Outcome) -> Vec<Plot> {
    let map = outcome.map.as_ref().map(|_| Plot::Contact);
    let rough = plan.surface().map(|_| Plot::Distribution);
    let leak = plan.leak.map(|_| Plot::Leak);
    let glides = plan.travel.iter().flat_map(gliding::suiting);
    let sheared = outcome.map.as_ref().and_then(|map| map.shear.as_ref());
    if slides(outcome) {
        let stick = matches!(plan.friction, Some(PixelFriction::Partial { .. } | PixelFriction::Coupled { .. }))
            .then_some(Plot::Stick);
        let shear = sheared.map(|_| Plot::Shear);
        return [Plot::Friction].into_iter().chain(stick).chain(map).chain(shear).collect();
    }
    glides.chain([Plot::Force, Plot::Area]).chain(leak).chain(map).chain(rough).collect()
}

/// What the gap lets through over the force; nothing of a gap that is closed is drawn over decades.
pub fn leak(outcome: &Outcome) -> Option<Panel> {
    let through = |record: &Record| record.pixels?.leak.filter(|&through| through > 0.0);
    let open = outcome
        .records
        .iter()
        .filter_map(through)
        .fold((f64::INFINITY, 0.0_f64), |(least, most), through| (least.min(through), most.max(through)));
    let up = axis_of(&LEAK);
    let up = if open.1 > DECADE * open.0 { Axis::log(up.label, up.unit) } else { up.from(0.0) };
    let points = outcome.records.iter().map(|record| Some((record.normal.force, through(record)?)));
    let closed = outcome.records.iter().find(|record| record.pixels.is_some_and(|pixels| pixels.leak == Some(0.0)));
    let panel = Panel::new(axis_of(&FORCE).from(0.0), up).with(Series::new("", points));
    let note = closed.map(|record| format!("No way leads through from {} on.", short(record.normal.force, "N")));
    (open.1 > 0.0).then(|| note.into_iter().fold(panel, Panel::note))
}

/// Area of contact over the force; over the time where bodies remember, over the depth where they attract each other.
pub fn area(scene: &Plan, plan: &HalfSpacePlan, outcome: &Outcome) -> Panel {
    let (across, axis) = match (&plan.relaxation, plan.attraction) {
        (Some(_), _) => (TIME, axis_of(&TIME).from(0.0)),
        (
            None,
            ElasticAdhesion::Vanishing { .. }
            | ElasticAdhesion::Outside { .. }
            | ElasticAdhesion::Finite { .. }
            | ElasticAdhesion::Fading { .. },
        ) => (INDENTATION, axis_of(&INDENTATION)),
        (None, ElasticAdhesion::None) => (FORCE, axis_of(&FORCE).from(0.0)),
    };
    let points = of_records(&outcome.records, &across, &AREA);
    let panel = Panel::new(axis, axis_of(&AREA).from(0.0));
    let computed = |label: &str| {
        let series = Series::new(label, points);
        if few(scene, &outcome.records) { series.marks(Marks::As(Mark::Point)) } else { series }
    };
    match NominallyFlat::of(scene) {
        Some(flat) => theories(flat, outcome).into_iter().fold(panel.with(computed("computed")), Panel::with),
        None => panel.with(computed("")),
    }
}

/// Stiffness over the force of a rough contact that is flat as a whole, with the power of the force nearest to it.
pub fn stiffness(scene: &Plan, outcome: &Outcome) -> Option<Panel> {
    let flat = NominallyFlat::of(scene)?;
    let pressed = |record: &Record| record.normal.force > 0.0 && record.normal.stiffness > 0.0;
    let records: Vec<Record> = outcome.records.iter().filter(|record| pressed(record)).copied().collect();
    let points: Vec<_> = records.iter().map(|record| (record.normal.force, record.normal.stiffness)).collect();
    let law = flat.stiffness_law(&points)?;
    let ends = points.iter().fold((f64::INFINITY, 0.0_f64), |ends, at| (ends.0.min(at.0), ends.1.max(at.0)));
    let name = format!("{:.2} E*L (F/E*hL)^{:.2}", law.prefactor, law.exponent);
    let line = [ends.0, ends.1].map(|force| Some((force, flat.stiffness(law, force))));
    let panel = Panel::new(log(axis_of(&FORCE)), log(axis_of(&STIFFNESS)))
        .with(Series::new("computed", of_records(&records, &FORCE, &STIFFNESS)).marks(Marks::As(Mark::Point)))
        .with(Series::new(name, line).line(Line::Dashed))
        .note("L side of the nominal area, h rms height; the conductance of heat and current is 2k/(E*(ρ₁+ρ₂)) (Barber 2003).");
    Some(beside_the_law(panel, &scene.scene))
}

/// What theories of the real contact say up to the largest force.
fn theories(flat: NominallyFlat, outcome: &Outcome) -> [Series; 2] {
    let most = outcome.records.iter().map(|record| record.normal.force).fold(0.0, f64::max);
    let over = |share: &dyn Fn(f64) -> Option<f64>| -> Points {
        let forces = (0..=THEORY).map(|k| most * f64::from(k) / f64::from(THEORY));
        forces.map(|force| Some((force, flat.area() * share(force)?))).collect()
    };
    let summits = |force: f64| if force > 0.0 { flat.greenwood_williamson(force) } else { Some(0.0) };
    [
        Series::new("Persson", over(&|force| Some(flat.persson(force)))).line(Line::Dashed),
        Series::new("Greenwood–Williamson", over(&summits)).line(Line::Dotted),
    ]
}

/// Area of the contact and of what sticks of it over time from the first slide on.
pub fn stick(records: &[Record]) -> Panel {
    let of = |column| of_records(from_first_slide(records), &TIME, column);
    Panel::new(axis_of(&TIME), Axis::linear("area", "m²").from(0.0))
        .with(Series::new("contact A", of(&AREA)))
        .with(Series::new("stick", of(&STICK_AREA)))
}

/// The pressure where the bodies touch, with the outline of the contact.
pub fn contact(outcome: &Outcome) -> Option<Panel> {
    let map = outcome.map.as_ref()?;
    let pressure = Axis::linear("pressure p", "Pa");
    let pulls = map.pressure.iter().any(|&pressure| pressure < 0.0);
    let axis = if pulls { pressure } else { pressure.from(0.0) };
    let speed = outcome.table("glides").and_then(|glides| glides.column("speed")?.numbers().last().copied().flatten());
    let at = speed.map_or_else(String::new, |speed| format!(" at {}", short(speed, "m/s")));
    let title = format!("contact under {}{at}", short(map.force, "N"));
    Some(drawn(&Shown::of(map, &map.pressure), axis, title))
}

/// The shear stress where the bodies touch, with the outline of the contact.
pub fn shear(outcome: &Outcome) -> Option<Panel> {
    let map = outcome.map.as_ref()?;
    let shear = map.shear.as_ref()?;
    let shown = Shown::of(map, shear);
    let title = format!("shear of {}", short(shear.sum() * map.pixel[0] * map.pixel[1], "N"));
    let stress =
        Array2::from_shape_fn(shown.stress.dim(), |at| if shown.touching[at] { shown.stress[at] } else { 0.0 });
    Some(drawn(&Shown { stress, ..shown }, Axis::linear("shear stress τ", "Pa"), title))
}

/// A stress on pixels, with the outline of the contact.
fn drawn(shown: &Shown, axis: Axis, title: String) -> Panel {
    let (rows, columns) = shown.stress.dim();
    let place = |index: usize, count: usize, side: f64| (index as f64 + 0.5 - 0.5 * count as f64) * side;
    let cells = Cells {
        x: (0..columns).map(|column| place(column, columns, shown.side[0])).collect(),
        y: (0..rows).map(|row| place(row, rows, shown.side[1])).collect(),
        values: (0..columns)
            .flat_map(|column| (0..rows).map(move |row| (row, column)))
            .map(|at| shown.value(at))
            .collect(),
        of: axis,
    };
    let panel = Panel::new(Axis::linear("x", "m"), Axis::linear("y", "m"))
        .titled(title)
        .ratio(columns as f64 * shown.side[0] / (rows as f64 * shown.side[1]))
        .cells(cells)
        .with(Series::new("", shown.outline()).colour(Hue::Black).line(Line::Solid));
    let coarser = (shown.block > 1).then(|| format!("A cell is {0} × {0} pixels.", shown.block));
    coarser.into_iter().fold(panel, Panel::note)
}

/// A map of few enough cells to be drawn.
struct Shown {
    /// Mean stress [Pa]; zero where less than half of a cell touches and nothing pulls.
    stress: Array2<f64>,
    /// Whether half of a cell touches.
    touching: Array2<bool>,
    /// Width and height of a cell [m].
    side: [f64; 2],
    /// Pixels along a cell.
    block: usize,
}

impl Shown {
    fn of(map: &ContactMap, stress: &Array2<f64>) -> Self {
        let (rows, columns) = stress.dim();
        let block = rows.max(columns).div_ceil(SHOWN);
        let inside = |(row, column): (usize, usize)| {
            let (top, left) = (row * block, column * block);
            s![top..(top + block).min(rows), left..(left + block).min(columns)]
        };
        let cells = (rows.div_ceil(block), columns.div_ceil(block));
        let touching = Array2::from_shape_fn(cells, |at| {
            let gap = map.gap.slice(inside(at));
            2 * gap.iter().filter(|&&gap| gap <= 0.0).count() >= gap.len()
        });
        let stress = Array2::from_shape_fn(cells, |at| {
            let mean = stress.slice(inside(at)).mean().unwrap_or(0.0);
            if touching[at] { mean } else { mean.min(0.0) }
        });
        Self { stress, touching, side: map.pixel.map(|side| side * block as f64), block }
    }

    fn value(&self, at: (usize, usize)) -> Option<f64> {
        Some(self.stress[at]).filter(|&stress| self.touching[at] || stress < 0.0)
    }

    /// Whether a cell touches; beyond the border nothing does.
    fn touches(&self, row: Option<usize>, column: Option<usize>) -> bool {
        row.zip(column).and_then(|at| self.touching.get(at)).is_some_and(|&touching| touching)
    }

    /// Closed ways round what touches, along the sides between cells that do and cells that do not.
    fn outline(&self) -> Points {
        let (rows, columns) = self.stress.dim();
        let x = |column: usize| (column as f64 - 0.5 * columns as f64) * self.side[0];
        let y = |row: usize| (row as f64 - 0.5 * rows as f64) * self.side[1];
        let mut ways = self.sides();
        let mut points = Points::new();
        while let Some((&first, _)) = ways.first_key_value() {
            let mut way = vec![first];
            let mut at = first;
            while let Some(next) = taken(&mut ways, at) {
                at = next;
                way.push(at);
            }
            let corners = corners(&way);
            for first in (0..corners.len() - 1).step_by(PIECE) {
                let piece = &corners[first..corners.len().min(first + PIECE + 1)];
                points.extend(piece.iter().map(|&[row, column]| Some((x(column), y(row)))));
                points.push(None);
            }
        }
        points
    }

    /// From corner to corner of the cells along each side, what touches on the right.
    fn sides(&self) -> BTreeMap<Corner, Vec<Corner>> {
        let mut sides: BTreeMap<Corner, Vec<Corner>> = BTreeMap::new();
        for ((row, column), _) in self.touching.indexed_iter().filter(|(_, touches)| **touches) {
            let (below, beyond) = (row + 1, column + 1);
            let around = [
                (row.checked_sub(1), Some(column), [row, column], [row, beyond]),
                (Some(row), Some(beyond), [row, beyond], [below, beyond]),
                (Some(below), Some(column), [below, beyond], [below, column]),
                (Some(row), column.checked_sub(1), [below, column], [row, column]),
            ];
            for (next_row, next_column, from, to) in around {
                if !self.touches(next_row, next_column) {
                    sides.entry(from).or_default().push(to);
                }
            }
        }
        sides
    }
}

/// Row and column of a corner of a cell.
type Corner = [usize; 2];

/// A side that leads on from a corner, which is then used up.
fn taken(ways: &mut BTreeMap<Corner, Vec<Corner>>, from: Corner) -> Option<Corner> {
    let next = ways.get_mut(&from)?;
    let to = next.pop();
    if next.is_empty() {
        ways.remove(&from);
    }
    to
}

/// The ends of a way and the corners at which it turns.
fn corners(way: &[Corner]) -> Vec<Corner> {
    let straight = |index: usize| {
        let [before, at, after] = [way[index - 1], way[index], way[index + 1]];
        (0..2).any(|axis| before[axis] == at[axis] && at[axis] == after[axis])
    };
    let turns = |index: usize| index == 0 || index + 1 == way.len() || !straight(index);
    (0..way.len()).filter(|&index| turns(index)).map(|index| way[index]).collect()
}

/// Densities of the pressure and of the gap, a curve for each force.
pub fn distribution(outcome: &Outcome) -> Vec<Panel> {
    let Some(table) = outcome.table("distribution") else { return Vec::new() };
    let kinds = [("pressure", "pressure_density"), ("gap", "gap_density")];
    kinds.into_iter().filter_map(|(of, density)| densities(table, of, density)).collect()
}

fn densities(table: &Table, of: &str, density: &str) -> Option<Panel> {
    let (x, y) = (table.column(of)?, table.column(density)?);
    let forces = table.column("force")?.numbers();
    let axes = [x, y].map(|column| Axis::linear(column.label, column.unit.symbol).from(0.0));
    let [across, up] = axes;
    let mut panel = Panel::new(across, up);
    let rows: Vec<usize> = (0..table.rows()).collect();
    for rows in rows.chunk_by(|&one, &next| forces[one] == forces[next]) {
        let points = rows.iter().map(|&row| x.numbers()[row].zip(y.numbers()[row]));
        let label = rows.first().and_then(|&row| forces[row]).map_or_else(String::new, |force| short(force, "N"));
        panel = panel.with(Series::new(label, points));
    }
    Some(panel)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Boundary;

    fn map(side: usize, touching: impl Fn(usize, usize) -> bool) -> ContactMap {
        let at = |(row, column): (usize, usize)| if touching(row, column) { 2.0 } else { 0.0 };
        let pressure = Array2::from_shape_fn((side, side), at);
        let gap = pressure.mapv(|pressure| if pressure > 0.0 { 0.0 } else { 1.0 });
        ContactMap { gap, pressure, shear: None, pixel: [1.0; 2], boundary: Boundary::Free, force: 1.0 }
    }

    fn shown(map: &ContactMap) -> Shown {
        Shown::of(map, &map.pressure)
    }

    /// Two pixels beside each other have six sides in four lines, which are one way; two that meet at a corner have ways that pass it.
    #[test]
    fn the_outline_goes_round_the_contact() {
        let shown = shown(&map(4, |row, column| row == 0 && column < 2));
        let points = shown.outline();
        let way = [(-2.0, -2.0), (0.0, -2.0), (0.0, -1.0), (-2.0, -1.0), (-2.0, -2.0)].map(Some);
        assert_eq!(points[..5], way);
        assert_eq!(points[5..], [None]);
        let cornered = self::shown(&map(4, |row, column| row < 2 && row == column)).outline();
        assert_eq!(cornered.iter().flatten().filter(|point| **point == (-1.0, -1.0)).count(), 2);
        assert_eq!(cornered.first(), cornered.iter().rev().flatten().next().map(|point| Some(*point)).as_ref());
    }

    #[test]
    fn a_large_map_is_drawn_in_cells() {
        let shown = shown(&map(2 * SHOWN, |row, _| row < 3));
        assert_eq!((shown.block, shown.stress.dim()), (2, (SHOWN, SHOWN)));
        // Half of the second row of cells touches.
        assert_eq!((shown.value((0, 5)), shown.value((1, 5)), shown.value((2, 5))), (Some(2.0), Some(1.0), None));
    }
}
