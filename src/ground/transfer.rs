//! How far the surface of a layered body gives under a pressure cos kx.
//!
//! In plane strain a layer is φ = f(ζ) cos kx, ζ = kz, with f a sum of (A + Bζ)e^(−ζ) from above and (C + Dη)e^(−η)
//! from below, η = kh − ζ: σ_zz = −f, τ_xz = f′, 2Gu_x = (1−ν)f″ + νf, 2Gu_z = (1−ν)f‴ − (2−ν)f′, stresses per k².
//! From the base upwards each layer turns the compliance of what lies below it into that at its top; only decaying
//! exponentials occur, so that no thickness overflows. A pressure round about its axis gives the same (Hankel for
//! Fourier).

use crate::material::{Joint, Sheet, Stack};

/// From waves that long on the series of M has but its first term.
const FAR: f64 = 1.0 / 16.0;

type Pair = [f64; 2];
type Matrix = [Pair; 2];

fn times(m: &Matrix, n: &Matrix) -> Matrix {
    let entry = |i: usize, j: usize| m[i][0] * n[0][j] + m[i][1] * n[1][j];
    [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
}

fn plus(m: &Matrix, n: &Matrix, factor: f64) -> Matrix {
    let entry = |i: usize, j: usize| m[i][j] + factor * n[i][j];
    [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
}

fn inverse(m: &Matrix) -> Matrix {
    let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let [[a, b], [c, d]] = *m;
    [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
}

/// Displacements (u_x, u_z) and stresses (τ_xz, σ_zz) of the two parts of one family of a layer.
struct State {
    displacement: Matrix,
    stress: Matrix,
}

/// The family from above at the depth ζ = `depth` below its border, without its decay.
fn from_above(sheet: &Sheet, depth: f64) -> State {
    let (nu, give) = (sheet.poisson, 0.5 / sheet.shear);
    let (across, down) = (depth - 2.0 * (1.0 - nu), depth + 1.0 - 2.0 * nu);
    State { displacement: [[give, give * across], [give, give * down]], stress: [[-1.0, 1.0 - depth], [-1.0, -depth]] }
}

/// The family from below at the height η = `height` above its border: the same looked at upwards.
fn from_below(sheet: &Sheet, height: f64) -> State {
    let State { displacement: [across, down], stress: [shear, normal] } = from_above(sheet, height);
    State { displacement: [across, down.map(|u| -u)], stress: [shear.map(|t| -t), normal] }
}

/// (u_x, u_z) at the top of the base per (τ_xz, σ_zz).
fn base(sheet: Option<&Sheet>) -> Matrix {
    let Some(sheet) = sheet else { return [[0.0; 2]; 2] };
    let State { displacement, stress } = from_above(sheet, 0.0);
    times(&displacement, &inverse(&stress))
}

/// (u_x, u_z) at the top of `sheet`, of the thickness kh = `thickness`, per (τ_xz, σ_zz), if that of what lies below
/// is `below`.
fn over(below: &Matrix, sheet: &Sheet, thickness: f64) -> Matrix {
    let decay = (-thickness).exp();
    let (down, up) = (from_above(sheet, thickness), from_below(sheet, 0.0));
    // What must vanish at the joint, per (A, B) and per (C, D).
    let misfit = |state: &State| match sheet.joint {
        Joint::Bonded => plus(&state.displacement, &times(below, &state.stress), -1.0),
        Joint::Sliding => {
            let [shear, normal] = state.stress;
            let opened = |part: usize| state.displacement[1][part] - below[1][1] * normal[part];
            // The compliance without a shear stress below: its other entries do not count.
            [shear, [opened(0), opened(1)]]
        }
    };
    let reflected = times(&inverse(&misfit(&up)), &misfit(&down));
    let (near, far) = (from_above(sheet, 0.0), from_below(sheet, thickness));
    let echo = -decay * decay;
    let displacement = plus(&near.displacement, &times(&far.displacement, &reflected), echo);
    let stress = plus(&near.stress, &times(&far.stress, &reflected), echo);
    times(&displacement, &inverse(&stress))
}

impl Stack {
    /// A wave number [1/m] below which M does not change any more: waves longer than the whole stack, by as much as a
    /// layer is stiffer or softer than what lies below it.
    #[must_use]
    pub fn least_wave_number(&self) -> f64 {
        let thickness: f64 = self.sheets.iter().map(|sheet| sheet.thickness).sum();
        let moduli = || self.sheets.iter().chain(&self.base).map(|sheet| sheet.shear);
        let contrast = moduli().fold(0.0, f64::max) / moduli().fold(f64::INFINITY, f64::min);
        FAR / (thickness * contrast)
    }

    /// E* of an endless top layer times what the whole gives per uniform pressure [m]: Σh(1−2ν)/(2G(1−ν)) on a rigid
    /// base, infinite on one that gives, or without a layer.
    #[must_use]
    pub fn compression(&self) -> f64 {
        let (Some(top), None) = (self.sheets.first(), &self.base) else { return f64::INFINITY };
        let given = |sheet: &Sheet| sheet.thickness * (0.5 - sheet.poisson) / (sheet.shear * (1.0 - sheet.poisson));
        2.0 * top.shear / (1.0 - top.poisson) * self.sheets.iter().map(given).sum::<f64>()
    }

    /// 1 − M(k) [1], where M is what the surface gives under p = cos kx, u = (2/E*k)M cos kx with E* of the topmost
    /// layer: 1 for an endless one. `k` [1/m] above zero.
    ///
    /// Absolute error: a rounding of 1 and of M.
    #[must_use]
    pub fn lacking(&self, k: f64) -> f64 {
        let Some((top, rest)) = self.sheets.split_first() else { return 0.0 };
        let below =
            rest.iter().rev().fold(base(self.base.as_ref()), |below, sheet| over(&below, sheet, k * sheet.thickness));
        let given = -over(&below, top, k * top.thickness)[1][1];
        1.0 - given * top.shear / (1.0 - top.poisson)
    }
}
