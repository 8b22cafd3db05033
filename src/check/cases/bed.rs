//! The springs of a bed one by one, as they are drawn.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::contacts::{jkr, paraboloid};
use crate::contact::viscoelastic::memory::Memory;
use crate::material::{Relaxation, Spectrum};
use crate::numerics::quadrature;
use std::f64::consts::TAU;
use std::sync::Arc;

pub(super) const CASES: &[Case] = &[
    Case::new(
        "bed/springs of a sticky lens",
        Proof::Rounding,
        1e-12,
        "2∫q dx is the force, u = d − g(x) in the contact, −√(2πaw/E*) at its edge; a root and differences of the order of the depth",
    )
    .weak("one lens at three depths")
    .by(springs_of_jkr),
    Case::new(
        "bed/springs let go",
        Proof::Rounding,
        1e-12,
        "a free spring comes back by e^(−t/λ), λ = τ(E∞ + E₁)/E∞, wherever it was let go",
    )
    .weak("one term of the series")
    .by(springs_let_go),
];

fn springs_of_jkr() -> Attempt<Pairs> {
    let (modulus, work) = (3.0, 0.2);
    let mut contact = jkr(paraboloid(1.0)?, modulus, work);
    let mut pairs = Pairs::new();
    for depth in [1.0, 0.1, -0.1] {
        contact.indent(depth)?;
        let loaded = contact.loaded();
        let a = loaded.contact_radius();
        let force = 2.0 * quadrature::panel(|x| loaded.line_load(x), 0.0, a);
        pairs.push((force, 4.0 / 3.0 * modulus * a.powi(3) - (4.0 * TAU * modulus * work * a.powi(3)).sqrt()));
        pairs.push((loaded.displacement(a), -(TAU * a * work / modulus).sqrt()));
        pairs.extend([0.2, 0.9].map(|part| (loaded.displacement(part * a), depth - (part * a).powi(2))));
    }
    Ok(pairs)
}

fn springs_let_go() -> Attempt<Pairs> {
    let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(9.0, 0.2)], viscosity: 0.0 };
    let mut bed = Memory::new(Arc::new(Spectrum::new(&relaxation)), paraboloid(1.0)?);
    bed.advance(0.01, 1.0)?;
    bed.advance(-0.02, 0.5)?;
    let before = bed.loaded();
    bed.advance(0.0, 1.5)?;
    let after = bed.loaded();
    let places = [0.0, 0.03, 0.06, 0.09];
    Ok(places.map(|x| (after.displacement(x), before.displacement(x) * (-0.75f64).exp())).to_vec())
}
