//! The profile that a shape has on a ground.

use super::Ground;
use crate::numerics::chebyshev::Chebyshev;
use crate::numerics::panelled::PanelledCurve;
use crate::numerics::quadrature;
use crate::shape::{Moved, Profile, Rim, edge_by_search};
use std::f64::consts::{PI, TAU};
use std::sync::{Arc, OnceLock};

/// Nodes of a panel.
const NODES: usize = 20;
/// Nodes of an integrand, a product of such polynomials.
const FINE: usize = 32;
/// Part of its end at which a panel begins near the axis.
const NEAR_THE_AXIS: f64 = 0.25;
/// A panel whose last coefficients are less than this part of the first is fine enough.
const RESOLVED: f64 = 1e-14;
/// Most halvings of a panel: a root at a kink of the profile is then lost in rounding.
const HALVINGS: usize = 24;
/// Part of what a panel misses that a half of it still misses if halving does not help.
const NO_BETTER: f64 = 0.25;
/// Part of the length over which a shape rises and falls within which it is even.
const EVEN: f64 = 0.125;
/// Most steps to a depth.
const STEPS: usize = 12;
/// A step that changes a radius by less than this part is followed by one below rounding.
const MET: f64 = 1e-9;
/// Octaves of the radius.
const OCTAVES: usize = 200;

/// A shape on a ground, as the profile d_e(a(s)) of a homogeneous bed with the places s; see [the module](super).
#[derive(Debug)]
pub struct Grounded {
    shape: Arc<dyn Profile>,
    ground: Arc<dyn Ground>,
    /// Upper borders [m] of octaves of radii, over which everything changes slowly.
    borders: Vec<f64>,
    octaves: Vec<OnceLock<Vec<Panel>>>,
}

/// Part of an octave, over the radius a.
#[derive(Debug, Clone)]
struct Panel {
    /// Its upper border [m].
    high: f64,
    /// d_e/g.
    share: Chebyshev,
    /// N/(s d_e), N(a) = ∫(d_e(a) − d_e(x))ds.
    load: Chebyshev,
    /// M/(s d_e²), M(a) = ∫(d_e(a) − d_e(x))²ds.
    energy: Chebyshev,
    /// N [m²] and M [m³] at its upper border.
    ends: [f64; 2],
    /// d_e [m] at its borders.
    depths: (f64, f64),
}

/// Panels from the axis on, and N [m²] and M [m³] at their end.
struct Laid {
    panels: Vec<Panel>,
    ends: [f64; 2],
}

impl Grounded {
    /// `shape` on `ground`.
    #[must_use]
    pub fn new(shape: Arc<dyn Profile>, ground: Arc<dyn Ground>) -> Self {
        let scale = ground.scale().map_or(shape.scale(), |scale| scale.min(shape.scale()));
        let borders = (0..OCTAVES).map(|octave| 0.25 * scale * (octave as f64).exp2()).collect();
        Self { shape, ground, borders, octaves: vec![OnceLock::new(); OCTAVES] }
    }

    /// The radius [m] at which it ends: of the shape, or of what is known of the ground.
    fn reach(&self) -> f64 {
        self.shape.rim().radius().min(self.ground.end(self.shape.as_ref(), 0.0))
    }

    /// Whether the ground is known where an octave begins.
    fn is_known(&self, octave: usize) -> bool {
        let low = if octave == 0 { 0.0 } else { self.borders[octave - 1] };
        low < self.ground.end(self.shape.as_ref(), low)
    }

    fn octave_of(&self, a: f64) -> usize {
        self.borders.partition_point(|&border| border < a).min(OCTAVES - 1)
    }

    /// Panels of an octave; of the last one up to its end.
    fn panels(&self, octave: usize) -> &[Panel] {
        let Some(kept) = self.octaves.get(octave) else { return &[] };
        kept.get_or_init(|| self.laid(octave))
    }

    fn laid(&self, octave: usize) -> Vec<Panel> {
        let low = if octave == 0 { 0.0 } else { self.borders[octave - 1] };
        let high = self.borders[octave].min(self.shape.rim().radius());
        let flat = self.shape.flat_radius();
        let before = octave.checked_sub(1).and_then(|before| self.panels(before).last());
        let mut laid = Laid { panels: Vec::new(), ends: before.map_or([0.0; 2], |panel| panel.ends) };
        let inside = |at: &f64| *at > low.max(flat) && *at < high;
        let breaks = self.shape.breaks(high).into_iter().chain([flat]).filter(|at| *at > low && *at < high);
        let mut borders: Vec<f64> = std::iter::once(low.max(flat)).chain(breaks.filter(inside)).chain([high]).collect();
        borders.sort_by(f64::total_cmp);
        borders.dedup();
        for pair in borders.windows(2) {
            if let [from, to] = pair
                && to > from
            {
                self.lay((*from, *to), self.share((*from, *to)), HALVINGS, &mut laid);
            }
        }
        laid.panels
    }

    /// d_e/g between two radii.
    fn share(&self, span: (f64, f64)) -> Chebyshev {
        Chebyshev::of(|a| self.ground.depth_share(self.shape.as_ref(), a), NODES, span)
    }

    /// Panels between two radii, halved until d_e/g, `share` over all of it, is met.
    fn lay(&self, (low, high): (f64, f64), share: Chebyshev, halvings: usize, laid: &mut Laid) {
        if halvings > 0 && share.unresolved() > RESOLVED {
            let middle = 0.5 * (low + high);
            let halves = [(low, middle), (middle, high)].map(|span| (span, self.share(span)));
            let as_bad = |(_, half): &(_, Chebyshev)| half.unresolved() > NO_BETTER * share.unresolved();
            // What both halves miss as much of is rounding, unless the shape rises and falls within them.
            let is_even = self.shape.feature().is_none_or(|feature| high - low < EVEN * feature);
            if !(is_even && halves.iter().all(as_bad)) {
                for (span, half) in halves {
                    self.lay(span, half, halvings - 1, laid);
                }
                return;
            }
        }
        let panel = self.integrated(share, (low, high), laid.ends);
        laid.ends = panel.ends;
        laid.panels.push(panel);
    }

    /// N and M over a panel, which begins with `ends`.
    fn integrated(&self, share: Chebyshev, (low, high): (f64, f64), ends: [f64; 2]) -> Panel {
        let span = (low, high);
        let (measure, depth) = (|a| self.ground.measure(a), |a| share.at(a) * self.shape.reduced(a));
        let slope = |a: f64| self.slope_with(&share, a);
        let load_at = summed(|x| measure(x) * slope(x), span, ends[0]);
        let load = Chebyshev::of(|a| load_at(a) / (measure(a) * depth(a)), NODES, span);
        let known = |a: f64| measure(a) * depth(a) * load.at(a);
        let energy_at = summed(|x| 2.0 * slope(x) * known(x), span, ends[1]);
        let energy = Chebyshev::of(|a| energy_at(a) / (measure(a) * depth(a).powi(2)), NODES, span);
        let ends = [load_at(high), energy_at(high)];
        drop((load_at, energy_at));
        let depths = (depth(low), depth(high));
        Panel { high, ends, depths, load, energy, share }
    }

    /// d_e′(a), of the panel with the share `share`.
    fn slope_with(&self, share: &Chebyshev, a: f64) -> f64 {
        let (share, slope) = share.with_slope(a);
        slope * self.shape.reduced(a) + share * self.shape.reduced_slope(a)
    }

    /// The place at which d_e, of a shape that only rises, is `d`, if that is within the panels; `None` on the flat and where
    /// the steps to it do not end.
    pub(super) fn met(&self, d: f64) -> Option<f64> {
        if d <= 0.0 || self.shape.first_fall().is_some() || self.shape.rim() != Rim::None {
            return None;
        }
        let known = (0..OCTAVES).take_while(|&octave| self.is_known(octave)).flat_map(|octave| self.panels(octave));
        let panel = known.into_iter().find(|panel| d <= panel.depths.1)?;
        let radius = if d > panel.depths.0 { self.radius_at(panel, d)? } else { panel.share.low() };
        Some(self.ground.measure(radius))
    }

    /// The radius at which d_e of a panel is `d`, between those at its borders: by Newton's steps in logarithms, for d_e is
    /// nearly a power. `None` where they do not end.
    fn radius_at(&self, panel: &Panel, d: f64) -> Option<f64> {
        let (low, high) = (panel.share.low().max(0.0), panel.high);
        let rise = (d / panel.depths.1).ln() / (panel.depths.0 / panel.depths.1).ln();
        let start = if panel.depths.0 > 0.0 { rise * (low / high).ln() } else { 0.5 * (d / panel.depths.1).ln() };
        let mut a = high * start.exp();
        for _ in 0..STEPS {
            let (share, slope) = panel.share.with_slope(a);
            let (depth, bare) = (share * self.shape.reduced(a), self.shape.reduced_slope(a) / self.shape.reduced(a));
            let growth = a * (slope / share + bare);
            let next = (a * ((d / depth).ln() / growth).exp()).clamp(low, high);
            if (next - a).abs() <= MET * a {
                return Some(next);
            }
            a = next;
        }
        None
    }

    /// The panel about the place `s` with its radius; `None` on the flat of the shape.
    fn about(&self, s: f64) -> Option<(&Panel, f64)> {
        let a = self.ground.radius(s);
        if a <= self.shape.flat_radius() {
            return None;
        }
        let panels = self.panels(self.octave_of(a.min(self.shape.rim().radius())));
        let panel = panels.iter().find(|panel| a <= panel.high).or(panels.last())?;
        Some((panel, a))
    }
}

/// `before` + ∫f over x from `low` on: as a polynomial, unless the panel comes so near the axis that its begin would be
/// lost in the rounding of its end.
fn summed<'f>(f: impl Fn(f64) -> f64 + 'f, (low, high): (f64, f64), before: f64) -> Box<dyn Fn(f64) -> f64 + 'f> {
    if low < NEAR_THE_AXIS * high {
        return Box::new(move |a| before + quadrature::panel(&f, low, a));
    }
    let more = Chebyshev::of(f, FINE, (low, high)).integral(0.0);
    Box::new(move |a| before + more.at(a))
}

impl Profile for Grounded {
    fn height(&self, r: f64) -> f64 {
        self.shape.height(self.ground.radius(r))
    }

    fn reduced(&self, x: f64) -> f64 {
        self.about(x).map_or(0.0, |(panel, a)| panel.share.at(a) * self.shape.reduced(a))
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        self.about(x).map_or(0.0, |(panel, a)| self.slope_with(&panel.share, a) / self.ground.density(a))
    }

    fn load_integral(&self, a: f64) -> f64 {
        let load = |(panel, radius): (&Panel, f64)| {
            panel.load.at(radius) * a * panel.share.at(radius) * self.shape.reduced(radius)
        };
        self.about(a).map_or(0.0, load)
    }

    fn energy_integral(&self, a: f64) -> f64 {
        let energy = |(panel, radius): (&Panel, f64)| {
            panel.energy.at(radius) * a * (panel.share.at(radius) * self.shape.reduced(radius)).powi(2)
        };
        self.about(a).map_or(0.0, energy)
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        // d_e grows from b to b + db over punches of the radius b; b² = r² + t² takes the root away, and the third power
        // of y what is left of it where a body is graded.
        let (inner, outer) = (self.ground.radius(r), self.ground.radius(a));
        let last = ((outer - inner) * (outer + inner)).max(0.0).sqrt();
        let to_y = |b: f64| (((b - inner) * (b + inner)).max(0.0).sqrt() / last).cbrt();
        let at = |y: f64| {
            let t = last * y.powi(3);
            let b = inner.hypot(t);
            let slope = self.reduced_slope(self.ground.measure(b)) * self.ground.density(b);
            slope * self.ground.edge_pressure(t, b) * t / b * 3.0 * last * y * y
        };
        let breaks: Vec<f64> = self.radii(&self.breaks(a)).into_iter().filter(|&b| b > inner).map(to_y).collect();
        quadrature::panels(at, (0.0, 1.0), &breaks)
    }

    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        let depth = self.reduced(a);
        let springs = |b: f64| depth - self.reduced(self.ground.measure(b));
        let mut ends = self.radii(&self.breaks(a));
        ends.push(self.ground.radius(a));
        self.ground.surface(&springs, &ends, self.ground.radius(r))
    }

    fn edge(&self, d: f64) -> Option<f64> {
        self.met(d).or_else(|| edge_by_search(self, d))
    }

    fn flat_radius(&self) -> f64 {
        self.ground.measure(self.shape.flat_radius())
    }

    fn rim(&self) -> Rim {
        let end = self.reach();
        match self.shape.rim() {
            Rim::Wall(radius) if radius <= end => Rim::Wall(self.ground.measure(radius)),
            Rim::End(radius) if radius <= end => Rim::End(self.ground.measure(radius)),
            // A contact that goes further is refused when it is there: to know the depth would cost more than most scenes.
            Rim::Wall(_) | Rim::None | Rim::End(_) => Rim::None,
        }
    }

    fn scale(&self) -> f64 {
        let length = self.ground.scale().unwrap_or(f64::INFINITY);
        self.ground.measure(self.shape.scale().min(length))
    }

    fn feature(&self) -> Option<f64> {
        self.shape.feature().map(|feature| self.ground.measure(feature.min(self.reach())))
    }

    fn kink(&self) -> Option<f64> {
        self.shape.kink().map(|kink| self.ground.measure(kink.min(self.reach())))
    }

    fn first_fall(&self) -> Option<f64> {
        self.shape.first_fall().map(|fall| self.ground.measure(fall.min(self.reach())))
    }

    fn moved(&self) -> Option<Moved> {
        self.shape.moved()
    }

    fn sampling_error(&self, a: f64) -> f64 {
        self.shape.sampling_error(self.ground.radius(a))
    }

    fn table_error(&self) -> f64 {
        self.ground.table_error()
    }

    fn breaks(&self, a: f64) -> Vec<f64> {
        let radius = self.ground.radius(a);
        let mut breaks = self.shape.breaks(radius);
        // Below its own length a ground changes slowly.
        let length = self.ground.scale().unwrap_or(f64::INFINITY);
        let borders = self.borders.iter().copied().skip_while(|&border| border < length);
        breaks.extend(borders.take_while(|&border| border < radius));
        breaks.sort_by(f64::total_cmp);
        breaks.into_iter().map(|radius| self.ground.measure(radius)).collect()
    }

    fn bare(&self) -> Option<&dyn Profile> {
        Some(self.shape.as_ref())
    }

    fn known_to(&self, asked: f64) -> f64 {
        self.ground.end(self.shape.as_ref(), asked)
    }

    fn fields_known_to(&self) -> f64 {
        self.ground.fields_end()
    }

    fn is_mapped(&self) -> bool {
        true
    }

    fn contact_radius(&self, x: f64) -> f64 {
        self.ground.radius(x)
    }

    fn place(&self, radius: f64) -> f64 {
        self.ground.measure(radius)
    }

    fn contact_area(&self, x: f64) -> f64 {
        PI * self.ground.radius(x).powi(2)
    }

    fn contact_area_slope(&self, x: f64) -> f64 {
        TAU * self.ground.per_density(self.ground.radius(x))
    }

    fn contact_area_bend(&self, x: f64) -> f64 {
        let a = self.ground.radius(x);
        (1.0 - self.ground.density_growth(a)) / self.ground.growth(a)
    }

    fn edge_pressure(&self, r: f64, a: f64) -> f64 {
        let (inner, outer) = (self.ground.radius(r), self.ground.radius(a));
        self.ground.edge_pressure(((outer - inner) * (outer + inner)).max(0.0).sqrt(), outer)
    }

    fn edge_surface(&self, r: f64, a: f64) -> f64 {
        let edge = self.ground.radius(a);
        self.ground.surface(&|_| 1.0, &[edge], self.ground.radius(r))
    }

    fn pressure_of(&self, load: &PanelledCurve<'_>, r: f64) -> f64 {
        let ends = load.ends();
        if ends.last().is_none_or(|&a| r >= a) {
            return 0.0;
        }
        self.ground.pressure(&|b| load.at(self.ground.measure(b)), &self.radii(ends), self.ground.radius(r))
    }

    fn surface_of(&self, displacement: &PanelledCurve<'_>, r: f64) -> f64 {
        let radii = self.radii(displacement.ends());
        self.ground.surface(&|b| displacement.at(self.ground.measure(b)), &radii, self.ground.radius(r))
    }
}

impl Grounded {
    fn radii(&self, places: &[f64]) -> Vec<f64> {
        places.iter().map(|&place| self.ground.radius(place)).collect()
    }
}
