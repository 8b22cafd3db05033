//! Punches of the radii of one octave, as polynomials in the radius.

use super::kernel::Kernel;
use super::punch::{self, Punch};
use crate::numerics::chebyshev::Chebyshev;
use crate::numerics::legendre::EvenRule;
use crate::numerics::root;
use std::sync::OnceLock;

/// Nodes per octave of the radius.
const NODES: usize = 20;

/// Punches between two radii, one of which is twice the other or zero. Lengths in thicknesses.
#[derive(Debug, Clone)]
pub(super) struct Octave {
    interval: (f64, f64),
    /// s(a)/a over a.
    pub(super) measure: Chebyshev,
    /// a(s)/s over s.
    radius: Chebyshev,
    /// s at its end.
    pub(super) end: f64,
    /// q₁(a; a) over a.
    pub(super) edge: Chebyshev,
    punches: Vec<Punch>,
    series: OnceLock<[Vec<Chebyshev>; 2]>,
    square: OnceLock<(Chebyshev, f64)>,
}

impl Octave {
    /// By the integral equation of its punches.
    pub(super) fn solved(kernel: &Kernel, interval: (f64, f64)) -> Self {
        let rule = punch::rule(punch::count(interval.1));
        let radii: Vec<f64> = Chebyshev::nodes(NODES, interval).collect();
        let punches: Vec<Punch> = radii.iter().map(|&a| Punch::new(kernel, a, &rule)).collect();
        let measures: Vec<f64> = punches.iter().zip(&radii).map(|(punch, a)| punch.measure / a).collect();
        let edges: Vec<f64> = punches.iter().map(|punch| punch.edge).collect();
        let [measure, edge] = [measures, edges].map(|values| Chebyshev::met(&values, interval));
        Self { punches, ..Self::of(measure, edge, interval) }
    }

    /// By q₁²(a) = `density`, from s = `before` at its begin.
    pub(super) fn grown(density: impl Fn(f64) -> f64, interval: (f64, f64), before: f64) -> Self {
        let edge = Chebyshev::of(|a| density(a).sqrt(), NODES, interval);
        let more = Chebyshev::of(density, NODES, interval).integral(0.0);
        let measure = Chebyshev::of(|a| (before + more.at(a)) / a, NODES, interval);
        Self::of(measure, edge, interval)
    }

    fn of(measure: Chebyshev, edge: Chebyshev, interval: (f64, f64)) -> Self {
        let (low, high) = interval;
        let ends = (low * measure.at(low), high * measure.at(high));
        let inverse = |s: f64| root::within(|a| a * measure.at(a) - s, low, high) / s;
        let radius = Chebyshev::of(inverse, NODES, ends);
        let (series, square) = (OnceLock::new(), OnceLock::new());
        Self { interval, end: ends.1, radius, edge, punches: Vec::new(), series, square, measure }
    }

    /// d ln s/d ln a at the radius `a`.
    pub(super) fn growth(&self, a: f64) -> f64 {
        self.edge.at(a).powi(2) / self.measure.at(a)
    }

    /// The radius at which s(a) = `s`: two steps of Newton make good what the table lacks, whose function is a root where
    /// the layer is thin.
    pub(super) fn radius(&self, s: f64) -> f64 {
        let nearer = |a: f64| a - (a * self.measure.at(a) - s) / self.edge.at(a).powi(2);
        nearer(nearer(s * self.radius.at(s)))
    }

    /// Coefficients of P₂ₘ(x/a) in q₁(x; a).
    pub(super) fn load(&self, a: f64) -> Vec<f64> {
        self.series()[0].iter().map(|coefficient| coefficient.at(a)).collect()
    }

    /// Coefficients of P₂ₘ(x/a) in Γ(x; a).
    pub(super) fn resolvent(&self, a: f64) -> Vec<f64> {
        self.series()[1].iter().map(|coefficient| coefficient.at(a)).collect()
    }

    fn series(&self) -> &[Vec<Chebyshev>; 2] {
        self.series.get_or_init(|| {
            let count = self.punches.first().map_or(0, |punch| punch.load.len());
            let rule = EvenRule::new(punch::rule(count));
            let values =
                [|punch: &Punch| &punch.load, |punch: &Punch| &punch.resolvent] as [fn(&Punch) -> &Vec<f64>; 2];
            values.map(|of| {
                let series: Vec<Vec<f64>> = self.punches.iter().map(|punch| rule.coefficients(of(punch))).collect();
                let of_degree = |m: usize| series.iter().map(|one| one[m]).collect::<Vec<f64>>();
                (0..count).map(|m| Chebyshev::met(&of_degree(m), self.interval)).collect()
            })
        })
    }

    /// d_e/g of the profile g = x² over a, and d_e at the end; at the begin of the octave d_e is `before`.
    ///
    /// d_e = ∫2s/q₁² da: the depth of g = cos kx obeys (q₁² d_e′)′ = −k²q₁² d_e as a string of the mass q₁² does
    /// (Krein 1952), and the second term of its series in k belongs to x².
    pub(super) fn square(&self, before: impl FnOnce() -> f64) -> &(Chebyshev, f64) {
        self.square.get_or_init(|| {
            let (low, high) = self.interval;
            let slope = |a: f64| 2.0 * self.measure.at(a) / self.edge.at(a).powi(2);
            // From the axis on the integral counts beside a², not beside the whole: ∫₀¹ x·slope(ax) dx.
            let share = if low > 0.0 {
                let (start, more) = (before(), Chebyshev::of(|a| a * slope(a), NODES, self.interval).integral(0.0));
                Chebyshev::of(|a| (start + more.at(a)) / (a * a), NODES, self.interval)
            } else {
                let mean = |a: f64| crate::numerics::quadrature::panel(|x| x * slope(a * x), 0.0, 1.0);
                Chebyshev::of(mean, NODES, self.interval)
            };
            let end = share.at(high) * high * high;
            (share, end)
        })
    }
}
