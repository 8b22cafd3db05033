//! Rough and wavy surfaces: what is kept of them, and the theories beside the bed.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::theory::{
    Westergaard, area_fraction, flat_punch_load, gaussian_tail, low_load_area_slope, single_harmonic_load,
};
use crate::check::ways;
use crate::contact::model::{ContactModel, Straight};
use crate::contact::rough::YieldingRough;
use crate::numerics::quadrature;
use crate::shape::rough::{Border, HeightMap, Rings, RoughError, RoughLine, RoughnessSpectrum, rough_surface};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

pub(super) const CASES: &[Case] = &[
    Case::new(
        "rough/height and slope of the line",
        Proof::Rounding,
        1e-11,
        "cosines are orthogonal on the grid: sums of a thousand squares, relative to their largest",
    )
    .weak("one spectrum; the property tests span H, lengths and seeds")
    .by(line_keeps_its_roughness)
    .ways(ways::rough::line),
    Case::new(
        "rough/spectrum of the surface",
        Proof::Rounding,
        1e-11,
        "the Fourier transform back of what was put in, ring by ring",
    )
    .weak("one spectrum and seed")
    .by(surface_keeps_its_spectrum),
    Case::new(
        "rough/Gaussian tails of Greenwood and Williamson",
        Proof::Rounding,
        1e-11,
        "references with twelve digits",
    )
    .weak("three separations and two powers")
    .by(tails),
    Case::new("rough/low-load area after Persson", Proof::Rounding, 1e-12, "erf(x) = 2x/√π to x³ at x = 1e-7")
        .weak("the theory's own slope √(8/π); full solutions have about 2")
        .by(low_load),
    Case::new(
        "rough/EPDM seal under a flat",
        Proof::Bound,
        5e-4,
        "P = k|A|πE*/2 by hand to four digits, k = 5 and 297",
    )
    .weak("rounded numbers; Kudish et al. give the load of a parabolic seal of unstated radius")
    .by(seal),
    Case::new(
        "rough/harmonics of a seal",
        Proof::Rounding,
        1e-14,
        "P grows as the square of the order of the harmonic (Kudish et al. 2.23)",
    )
    .weak("a ratio")
    .by(harmonics),
    Case::new(
        "rough/hardness under a smooth ball",
        Proof::Bound,
        1.1e-3,
        "springs E*(d − x²/R) up to the cap 2H√(Rd − x²), in closed form; caps of a long patch are behind by 1/1024, and springs at the edge count as whole ones, Δx/a = 6e-5 of the force",
    )
    .weak("one patch: of many nothing exact is known, see the half-space beside configs/yielding_ground.ron")
    .by(capped_ball),
    Case::new(
        "rough/wave in gross sliding",
        Proof::Rounding,
        1e-11,
        "∫p dx by quadrature in the angle; Coulomb alone carries μp̄",
    )
    .weak("the pressure is checked through its integral")
    .by(wave),
];

/// Self-affine from λ = 1 down to 1/32.
fn spectrum() -> Result<RoughnessSpectrum, RoughError> {
    RoughnessSpectrum::table(&[(TAU, 1.0), (32.0 * TAU, 32.0_f64.powf(-3.6))])
}

fn line_keeps_its_roughness() -> Attempt<Pairs> {
    let rings = Rings::of(&spectrum()?, 1.0, 1000)?;
    let line = RoughLine::new(&rings, 11);
    let square = |values: Vec<f64>| values.iter().map(|z| z * z).sum::<f64>() / 1000.0;
    let heights = (square(line.heights(1000)?), spectrum()?.rms_height().powi(2));
    Ok(vec![heights, (square(line.slopes(1000)?), rings.mean_square(1))])
}

fn surface_keeps_its_spectrum() -> Attempt<Pairs> {
    let rings = Rings::of(&spectrum()?, 1.0, 72)?;
    let map = HeightMap::new(rough_surface(&spectrum()?, 1.0, 72, 5)?, (1.0 / 72.0, 1.0 / 72.0))?;
    let found = map.rings(Border::Periodic);
    // The mean is no wave, and the last ring is cut by the corners of the grid.
    Ok(found.variances().iter().copied().zip(rings.variances().iter().copied()).take(32).skip(1).collect())
}

fn tails() -> Attempt<Pairs> {
    let of = |h: f64, first: f64, second: f64| [(gaussian_tail(1.0, h), first), (gaussian_tail(1.5, h), second)];
    let pairs = [
        of(1.0, 0.083_315_470_587_7, 0.075_668_177_391),
        of(2.0, 0.008_490_702_616_83, 0.006_648_177_623_59),
        of(3.0, 0.000_382_154_317_048, 0.000_263_967_554_269),
    ];
    Ok(pairs.concat())
}

fn low_load() -> Attempt<Pairs> {
    let slope = (8.0 / PI).sqrt();
    Ok(vec![(area_fraction(1e2, 1e9, 1.0) * 1e7, slope), (low_load_area_slope(), slope)])
}

fn seal() -> Attempt<Pairs> {
    let load = |k| flat_punch_load(k, 0.2e-6, 9e6 / (1.0 - 0.4 * 0.4));
    Ok(vec![(load(297), 999.7), (load(5), 16.83)])
}

fn harmonics() -> Attempt<Pairs> {
    let load = |k| single_harmonic_load(k, 1e-3, (1e7, 0.1));
    Ok(vec![(load(297) / load(5), (297.0_f64 / 5.0).powi(2))])
}

/// R = E* = 1 and H = 0.05: from the depth 4H²R/E*² on the middle yields.
fn capped_ball() -> Attempt<Pairs> {
    let (hardness, count) = (0.05, 20_001);
    let width = 0.6 / f64::from(count);
    let gaps: Vec<f64> = (0..count).map(|k| (width * (f64::from(k) - 1e4)).powi(2)).collect();
    let mut contact = YieldingRough::of_gaps(&gaps, width, (1.0, hardness))?;
    let mut pair = |depth: f64| -> Attempt<(f64, f64)> {
        contact.follow(&Straight::between(0.0, depth, 1.0))?;
        let (a, inner) = (depth.sqrt(), (depth - 4.0 * hardness * hardness).max(0.0).sqrt());
        let capped = 2.0 * hardness * (inner * (depth - inner * inner).sqrt() + depth * (inner / a).asin());
        let elastic = |x: f64| 2.0 * (depth * x - x.powi(3) / 3.0);
        Ok((contact.state().force, capped + elastic(a) - elastic(inner)))
    };
    [5e-3, 0.02, 0.04, 0.06].into_iter().map(&mut pair).collect()
}

fn wave() -> Attempt<Pairs> {
    let wave = Westergaard { modulus: 2e6, amplitude: 1e-5, wavelength: 1e-4 };
    let mean = 0.37 * wave.full_contact_pressure();
    let a = wave.half_width(mean);
    let carried = quadrature::panel(|t: f64| wave.pressure(a * t.sin(), mean) * a * t.cos(), 0.0, FRAC_PI_2);
    let friction = (wave.sliding(mean, (0.3, 1e12)).mean_shear, 0.3 * mean);
    Ok(vec![(2.0 * carried / wave.wavelength, mean), (wave.mean_pressure(a), mean), friction])
}
