//! Bodies whose stiffness depends on the depth, alone against a rigid one.

use super::alone::{Alone, Known, Stiffness};
use super::layered::{Graded, Joint, Layered, Sheet, Stack, Under, Winkler};
use super::viscoelastic::instantly_stiff;
use super::{Body, Relaxation, Spectrum};
use crate::input::problem::Problem;

/// A body of a layer or of a base, in numbers.
struct Material {
    shear: f64,
    poisson: f64,
    relaxation: Relaxation,
}

impl Material {
    fn of(body: &Body, path: &str, known: Known<'_>) -> Result<Self, Problem> {
        let (poisson, relaxation) = match body {
            Body::Elastic(elastic) => {
                let equilibrium = elastic.plane_modulus();
                (elastic.poisson.si(), Relaxation { equilibrium, terms: Vec::new(), viscosity: 0.0 })
            }
            Body::Viscoelastic(body) => (body.poisson.si(), instantly_stiff(body, path, known)?),
            Body::Rigid | Body::Plastic(_) | Body::Layered(_) | Body::Winkler(_) | Body::Graded(_) => {
                let what =
                    format!("{} cannot be part of a layered body: expected Elastic(…) or Viscoelastic(…)", body.name());
                return Err(Problem::new(path, what));
            }
        };
        Ok(Self { shear: 0.5 * (1.0 - poisson) * relaxation.instantaneous(), poisson, relaxation })
    }

    /// Whether it relaxes by the same function of time as another one.
    fn relaxes_as(&self, other: &Self) -> bool {
        let (one, two) = (&self.relaxation, &other.relaxation);
        let (first, second) = (one.instantaneous(), two.instantaneous());
        let near = |a: f64, b: f64| (a / first - b / second).abs() <= SAME;
        let terms = one.terms.iter().zip(&two.terms);
        one.terms.len() == two.terms.len()
            && near(one.equilibrium, two.equilibrium)
            && near(one.viscosity, two.viscosity)
            && terms.into_iter().all(|(a, b)| near(a.0, b.0) && (a.1 / b.1 - 1.0).abs() <= SAME)
    }
}

/// Relaxation functions that differ by less are written differently, not different.
const SAME: f64 = 1e-12;

/// A layered body against a rigid one: its modulus is that of an endless top layer.
pub(super) fn layered(body: &Layered, path: &str, known: Known<'_>) -> Result<Alone, Vec<Problem>> {
    let layers = body.layers.iter().enumerate();
    let layers = layers.map(|(k, layer)| Material::of(&layer.body, &format!("{path}.layers[{k}].body"), known));
    let base = (!matches!(*body.base, Body::Rigid)).then(|| Material::of(&body.base, &format!("{path}.base"), known));
    let (materials, problems): (Vec<_>, Vec<_>) = layers.chain(base).partition(Result::is_ok);
    let problems: Vec<Problem> = problems.into_iter().filter_map(Result::err).collect();
    let materials: Vec<Material> = materials.into_iter().flatten().collect();
    if !problems.is_empty() {
        return Err(problems);
    }
    let (Some(top), false) = (materials.first(), body.layers.is_empty()) else {
        return Err(vec![Problem::new(format!("{path}.layers"), "has no layer: expected at least one")]);
    };
    if let Some(number) = materials.iter().position(|other| !top.relaxes_as(other)) {
        let place = if number < body.layers.len() { format!("layers[{number}].body") } else { "base".to_owned() };
        let what = "does not relax as the topmost layer does, by the same share in the same times: expected one relaxation function for all layers and a base that gives";
        return Err(vec![Problem::new(format!("{path}.{place}"), what)]);
    }
    let sheet = |material: &Material, thickness: f64, joint: Joint| Sheet {
        shear: material.shear / top.shear,
        poisson: material.poisson,
        thickness,
        joint,
    };
    let sheets = body.layers.iter().zip(&materials);
    let sheets = sheets.map(|(layer, material)| sheet(material, layer.thickness.si(), layer.bond.unwrap_or(body.bond)));
    let base = materials.get(body.layers.len()).map(|material| sheet(material, 0.0, Joint::Bonded));
    let stack = Stack { sheets: sheets.collect(), base };
    Ok(Alone {
        stiffness: Stiffness::new(top.relaxation.instantaneous(), top.poisson),
        spectrum: Some(Spectrum::new(&top.relaxation)),
        under: Under::Layers(vec![(1.0, stack)]),
    })
}

/// A sheet of springs: its modulus stands for E*.
pub(super) fn winkler(body: &Winkler) -> Alone {
    let modulus = body.modulus.si();
    Alone {
        stiffness: Stiffness::new(modulus, 0.0),
        spectrum: Some(Spectrum::elastic(modulus)),
        under: Under::Springs(body.thickness.si()),
    }
}

/// A graded body: E₀/(1−ν²) stands for E*.
pub(super) fn graded(body: &Graded) -> Alone {
    let poisson = body.poisson.si();
    let modulus = body.young.si() / ((1.0 - poisson) * (1.0 + poisson));
    Alone {
        stiffness: Stiffness::new(modulus, poisson),
        spectrum: Some(Spectrum::elastic(modulus)),
        under: Under::Graded(body.clone()),
    }
}
