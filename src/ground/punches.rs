//! Flat punches on layers, tabulated over their radius, lengths in thicknesses of the thinnest top layer.

use super::kernel::Kernel;
use super::octave::Octave;
use super::wide::{Thin, Wide};
use crate::material::{Joint, Sheet, Stack};
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Upper border of the first octave, in thicknesses, where what lies below is not much softer.
const FIRST: f64 = 0.25;
/// Octaves of the radius from there on by the integral equation: up to 64 thicknesses of the top layer.
const OCTAVES: u32 = 9;
/// Octaves beyond them on a rigid base: up to a million thicknesses.
const WIDER: usize = 14;
/// Most octaves below: a radius of 1e-15 thicknesses.
const FINER: u32 = 48;

/// Shares of bodies that add up to one are wrong by less.
const WHOLE: f64 = 1e-12;

/// Stacks whose punches are kept: models in a fit, or scenes of a sweep, that differ in lengths and moduli alone have the
/// same ones.
const STACKS: usize = 8;

/// Layers of two bodies with their shares in the compliance of their tops.
type Parts = Vec<(f64, Stack)>;

/// The last ones that were asked for, the newest first.
static ASKED: Mutex<VecDeque<(Parts, Arc<Punches>)>> = Mutex::new(VecDeque::new());

/// Punches on layers, worked out octave by octave as they are asked for.
#[derive(Debug)]
pub(super) struct Punches {
    pub(super) kernel: Kernel,
    /// E* times what the whole gives per uniform pressure; infinite where it does so without an end.
    pub(super) compression: f64,
    /// Upper borders of octaves, each twice the one before.
    borders: Vec<f64>,
    /// Octaves by the integral equation, and those beyond.
    octaves: Vec<OnceLock<Octave>>,
    /// The layers, if nothing gives below them.
    thin: Option<Thin>,
    wide: OnceLock<Option<Wide>>,
}

/// What lies on a rigid base, if all of it does: under p = cos kx a bonded layer that cannot be compressed gives
/// by k²h³/3G.
fn thin(parts: &[(f64, Stack)]) -> Option<Thin> {
    if parts.iter().any(|(_, stack)| stack.base.is_some()) {
        return None;
    }
    let squeezed = |(share, stack): &(f64, Stack)| match stack.sheets.as_slice() {
        [one] if one.poisson >= 0.5 && one.joint == Joint::Bonded => Some(share * one.thickness.powi(3)),
        _ => None,
    };
    let softness = parts.iter().map(squeezed).sum::<Option<f64>>();
    let thickness = |stack: &Stack| stack.sheets.iter().map(|sheet| sheet.thickness).sum::<f64>();
    let thickest = parts.iter().map(|(_, stack)| thickness(stack)).fold(0.0, f64::max);
    Some(softness.map_or(Thin::Pressed(thickest), |softness| Thin::Squeezed(2.0 / 3.0 * softness)))
}

impl Punches {
    /// Those on the layers of two bodies with their shares in the compliance of their tops, lengths in `unit`.
    pub(super) fn on(parts: &[(f64, Stack)], unit: f64) -> Arc<Self> {
        let scaled = |sheet: &Sheet| Sheet { thickness: sheet.thickness / unit, ..*sheet };
        let scaled = |stack: &Stack| Stack { sheets: stack.sheets.iter().map(scaled).collect(), base: stack.base };
        let parts: Parts = parts.iter().map(|(share, stack)| (*share, scaled(stack))).collect();
        let mut asked = ASKED.lock().unwrap_or_else(PoisonError::into_inner);
        let known = asked.iter().position(|(known, _)| *known == parts).and_then(|at| asked.remove(at));
        let newest = known.unwrap_or_else(|| (parts.clone(), Arc::new(Self::new(parts))));
        let punches = newest.1.clone();
        asked.truncate(STACKS - 1);
        asked.push_front(newest);
        punches
    }

    fn new(parts: Parts) -> Self {
        let least = parts.iter().map(|(_, stack)| stack.least_wave_number()).fold(f64::INFINITY, f64::min);
        let compression = parts.iter().map(|(share, stack)| share * stack.compression()).sum::<f64>();
        // What a body without layers gives has no end.
        let whole = parts.iter().map(|(share, _)| share).sum::<f64>() > 1.0 - WHOLE;
        let thin = thin(&parts);
        let lacking = move |t: f64| parts.iter().map(|(share, stack)| share * stack.lacking(t)).sum();
        let kernel = Kernel::new(lacking, least);
        // Small punches have s = a/(1 − K(0, 0)a): a stiff layer on a soft base bends below far smaller ones.
        let bent = kernel.between(0.0, 0.0).abs();
        let finer = (0..FINER).find(|&n| bent * FIRST <= f64::from(n).exp2()).unwrap_or(FINER);
        let octaves = (OCTAVES + finer) as usize + WIDER;
        Self {
            kernel,
            compression: if whole { compression } else { f64::INFINITY },
            borders: (0..octaves).map(|octave| FIRST * (octave as f64 - f64::from(finer)).exp2()).collect(),
            octaves: vec![OnceLock::new(); octaves],
            thin: thin.filter(|_| whole),
            wide: OnceLock::new(),
        }
    }

    /// Borders of an octave, in thicknesses.
    pub(super) fn interval(&self, octave: usize) -> (f64, f64) {
        let high = self.borders[octave];
        (if octave == 0 { 0.0 } else { 0.5 * high }, high)
    }

    /// Number of octaves by the integral equation.
    pub(super) fn solved(&self) -> usize {
        self.octaves.len() - WIDER
    }

    /// Radius of the widest punch by the integral equation, in thicknesses.
    pub(super) fn widest(&self) -> f64 {
        self.interval(self.solved() - 1).1
    }

    /// Punches beyond them, if they are known.
    pub(super) fn wide(&self) -> Option<&Wide> {
        self.wide.get_or_init(|| Wide::of(&self.kernel, self.thin?)).as_ref()
    }

    fn kept(&self, octave: usize) -> Option<&Octave> {
        let kept = self.octaves.get(octave)?;
        let wide = if octave < self.solved() { None } else { Some(self.wide()?) };
        let interval = self.interval(octave);
        let Some(wide) = wide else { return Some(kept.get_or_init(|| Octave::solved(&self.kernel, interval))) };
        let before = self.kept(octave - 1)?.end;
        Some(kept.get_or_init(|| Octave::grown(|a| wide.density(a), interval, before)))
    }

    /// Number of octaves that are known for a radius `a`, in thicknesses.
    pub(super) fn count(&self, a: f64) -> usize {
        if a > self.widest() && self.wide().is_some() { self.octaves.len() } else { self.solved() }
    }

    /// Number of the octave of the radius `a` in thicknesses; of the last one for what lies beyond.
    fn number(&self, a: f64) -> usize {
        let last = self.count(a).saturating_sub(1);
        octave_of(a / self.borders[0]).min(last)
    }

    pub(super) fn about(&self, a: f64) -> Option<&Octave> {
        self.kept(self.number(a))
    }

    /// The octave in which s(a) = `s`, in thicknesses, is reached; `None` beyond all.
    pub(super) fn reaching(&self, s: f64) -> Option<&Octave> {
        (0..self.octaves.len()).map_while(|octave| self.kept(octave)).find(|kept| s <= kept.end)
    }

    /// Γ(x; a) per thickness, as a sum of P₂ₘ(x/a).
    pub(super) fn resolvent(&self, a: f64) -> Vec<f64> {
        self.about(a.min(self.widest())).map_or_else(Vec::new, |octave| octave.resolvent(a))
    }

    /// d_e/g of g = x² at the radius `a` in thicknesses.
    pub(super) fn square(&self, a: f64) -> f64 {
        let number = self.number(a);
        // From the least octave up, so that none asks down a long way.
        (0..=number)
            .try_fold((None, 0.0), |(_, before), octave| {
                let (share, end) = self.kept(octave)?.square(|| before);
                Some((Some(share), *end))
            })
            .and_then(|(share, _)| share)
            .map_or(1.0, |share| share.at(a))
    }
}

/// The least n with `x` ≤ 2ⁿ, by the exponent of `x`.
fn octave_of(x: f64) -> usize {
    if x <= 1.0 {
        return 0;
    }
    let bits = x.to_bits();
    let (exponent, mantissa) = (bits >> 52, bits << 12);
    usize::try_from(exponent - 1023).map_or(usize::MAX, |n| n + usize::from(mantissa > 0))
}
