//! Rough and wavy surfaces: what is kept of them, and the theories beside the bed.

use crate::check::case::{Case, Proof, worst};
use crate::check::theory::{
    Westergaard, area_fraction, flat_punch_load, gaussian_tail, low_load_area_slope, single_harmonic_load,
};
use crate::numerics::quadrature;
use crate::shape::rough::{Border, HeightMap, Rings, RoughLine, RoughnessSpectrum, rough_surface};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "rough/height and slope of the line",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: "cosines are orthogonal on the grid: sums of a thousand squares, relative to their largest",
        weak: "one spectrum; the property tests span H, lengths and seeds",
        error: || line_keeps_its_roughness().unwrap_or(f64::NAN),
    },
    Case {
        name: "rough/spectrum of the surface",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: "the Fourier transform back of what was put in, ring by ring",
        weak: "one spectrum and seed",
        error: || surface_keeps_its_spectrum().unwrap_or(f64::NAN),
    },
    Case {
        name: "rough/Gaussian tails of Greenwood and Williamson",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: "references with twelve digits",
        weak: "three separations and two powers",
        error: tails,
    },
    Case {
        name: "rough/low-load area after Persson",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "erf(x) = 2x/√π to x³ at x = 1e-7",
        weak: "the theory's own slope √(8/π); full solutions have about 2",
        error: || {
            worst(&[
                (area_fraction(1e2, 1e9, 1.0) * 1e7, (8.0 / PI).sqrt()),
                (low_load_area_slope(), (8.0 / PI).sqrt()),
            ])
        },
    },
    Case {
        name: "rough/EPDM seal under a flat",
        proof: Proof::Bound,
        bound: 5e-4,
        reason: "P = k|A|πE*/2 by hand to four digits, k = 5 and 297",
        weak: "rounded numbers; Kudish et al. give the load of a parabolic seal of unstated radius",
        error: seal,
    },
    Case {
        name: "rough/harmonics of a seal",
        proof: Proof::Rounding,
        bound: 1e-14,
        reason: "P grows as the square of the order of the harmonic (Kudish et al. 2.23)",
        weak: "a ratio",
        error: || {
            let load = |k| single_harmonic_load(k, 1e-3, (1e7, 0.1));
            worst(&[(load(297) / load(5), (297.0_f64 / 5.0).powi(2))])
        },
    },
    Case {
        name: "rough/wave in gross sliding",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: "∫p dx by quadrature in the angle; Coulomb alone carries μp̄",
        weak: "the pressure is checked through its integral",
        error: wave,
    },
];

/// Self-affine from λ = 1 down to 1/32.
fn spectrum() -> Option<RoughnessSpectrum> {
    RoughnessSpectrum::table(&[(TAU, 1.0), (32.0 * TAU, 32.0_f64.powf(-3.6))]).ok()
}

fn line_keeps_its_roughness() -> Option<f64> {
    let rings = Rings::of(&spectrum()?, 1.0, 1000).ok()?;
    let line = RoughLine::new(&rings, 11);
    let square = |values: Vec<f64>| values.iter().map(|z| z * z).sum::<f64>() / 1000.0;
    Some(worst(&[
        (square(line.heights(1000).ok()?), spectrum()?.rms_height().powi(2)),
        (square(line.slopes(1000).ok()?), rings.mean_square(1)),
    ]))
}

fn surface_keeps_its_spectrum() -> Option<f64> {
    let rings = Rings::of(&spectrum()?, 1.0, 72).ok()?;
    let map = HeightMap::new(rough_surface(&spectrum()?, 1.0, 72, 5).ok()?, (1.0 / 72.0, 1.0 / 72.0)).ok()?;
    let found = map.rings(Border::Periodic);
    // The last ring is cut by the corners of the grid.
    let pairs: Vec<_> = rings.variances().iter().zip(found.variances()).take(32).map(|(v, f)| (*f, *v)).collect();
    Some(worst(&pairs[1..]))
}

fn tails() -> f64 {
    let of = |h: f64, first: f64, second: f64| [(gaussian_tail(1.0, h), first), (gaussian_tail(1.5, h), second)];
    worst(
        &[
            of(1.0, 0.083_315_470_587_7, 0.075_668_177_391),
            of(2.0, 0.008_490_702_616_83, 0.006_648_177_623_59),
            of(3.0, 0.000_382_154_317_048, 0.000_263_967_554_269),
        ]
        .concat(),
    )
}

fn seal() -> f64 {
    let modulus = 9e6 / (1.0 - 0.4 * 0.4);
    worst(&[(flat_punch_load(297, 0.2e-6, modulus), 999.7), (flat_punch_load(5, 0.2e-6, modulus), 16.83)])
}

fn wave() -> f64 {
    let wave = Westergaard { modulus: 2e6, amplitude: 1e-5, wavelength: 1e-4 };
    let mean = 0.37 * wave.full_contact_pressure();
    let a = wave.half_width(mean);
    let carried = quadrature::panel(|t: f64| wave.pressure(a * t.sin(), mean) * a * t.cos(), 0.0, FRAC_PI_2);
    worst(&[
        (2.0 * carried / wave.wavelength, mean),
        (wave.mean_pressure(a), mean),
        (wave.sliding(mean, (0.3, 1e12)).mean_shear, 0.3 * mean),
    ])
}
