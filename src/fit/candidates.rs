//! Models that are tried on the same data: variants of a scene by their names.

use super::FitError;
use crate::contact::adhesion::Adhesion;
use crate::material::{Body, Elastic};
use crate::scene::Scene;
use crate::text::place::{Places, Value, json};

/// A scene and what is free in it, under a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Its name.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// What is free, each `PATH=LO..HI` or `PATH`.
    pub free: Vec<String>,
    /// What is known with a standard error only, each `PATH=SPREAD`.
    pub given: Vec<String>,
}

/// A variant of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Variant {
    /// As it is written.
    Scene,
    /// Without adhesion (Hertz, Sneddon).
    Hertz,
    /// With adhesion of vanishing range.
    Jkr,
    /// With an attraction outside the contact.
    Dmt,
    /// With adhesion of finite range.
    Maugis,
    /// A layer of its elastic body on a rigid base.
    Layered,
    /// A body that relaxes by a power of time instead of its elastic one.
    PowerLaw,
}

const VARIANTS: [(&str, Variant); 7] = [
    ("scene", Variant::Scene),
    ("hertz", Variant::Hertz),
    ("jkr", Variant::Jkr),
    ("dmt", Variant::Dmt),
    ("maugis", Variant::Maugis),
    ("layered", Variant::Layered),
    ("power-law", Variant::PowerLaw),
];

/// Work of adhesion a search starts with [J/m²], and its range.
const WORK: (f64, &str) = (0.05, "adhesion.work=1e-9..10");
/// Attractive stress a search starts with [Pa], and its range.
const STRESS: (f64, &str) = (1e6, "adhesion.stress=1..1e10");
/// Exponent a search starts with, and its range.
const EXPONENT: (f64, &str) = (0.1, "shear.exponent=1e-3..0.9");

impl Candidate {
    /// This one varied as `name` says; `None` if there is no variant of that name.
    ///
    /// # Errors
    /// The scene has nothing to be varied so.
    #[must_use]
    pub fn varied(&self, name: &str) -> Option<Result<Self, FitError>> {
        let (_, variant) = VARIANTS.into_iter().find(|(known, _)| *known == name)?;
        Some(variant.of(self).map(|varied| Self { name: name.to_owned(), ..varied }))
    }

    /// Names of all variants.
    #[must_use]
    pub fn names() -> [&'static str; 7] {
        VARIANTS.map(|(name, _)| name)
    }
}

impl Variant {
    fn of(self, plain: &Candidate) -> Result<Candidate, FitError> {
        match self {
            Self::Scene => Ok(plain.clone()),
            Self::Hertz => Ok(plain.with_adhesion(None, (&[], "adhesion."))?),
            Self::Jkr => {
                let kept = match &plain.scene.adhesion {
                    Some(Adhesion::Jkr(jkr)) => json!({"Jkr": jkr}),
                    Some(
                        Adhesion::Dmt(_) | Adhesion::Maugis(_) | Adhesion::Exponential(_) | Adhesion::Capillary(_),
                    )
                    | None => {
                        json!({"Jkr": {"work": work_of(&plain.scene)}})
                    }
                };
                Ok(plain.with_adhesion(Some(kept), (&[WORK.1], "adhesion.stress"))?)
            }
            Self::Dmt => {
                let model = json!({"Dmt": {"work": work_of(&plain.scene)}});
                let plain = plain.with_adhesion(None, (&[], "adhesion.stress"))?;
                Ok(plain.with_adhesion(Some(model), (&[WORK.1], "adhesion.edge"))?)
            }
            Self::Maugis => {
                let stress = match &plain.scene.adhesion {
                    Some(Adhesion::Maugis(maugis)) => maugis.stress.si(),
                    Some(Adhesion::Jkr(_) | Adhesion::Dmt(_) | Adhesion::Exponential(_) | Adhesion::Capillary(_))
                    | None => STRESS.0,
                };
                let model = json!({"Maugis": {"work": work_of(&plain.scene), "stress": stress}});
                Ok(plain.with_adhesion(Some(model), (&[WORK.1, STRESS.1], "adhesion.edge"))?)
            }
            Self::Layered => layered(plain),
            Self::PowerLaw => power_law(plain),
        }
    }
}

impl Candidate {
    /// The same with this adhesion, `more` free beside what is and not where `left` begins the place.
    fn with_adhesion(&self, adhesion: Option<Value>, (more, left): (&[&str], &str)) -> Result<Self, FitError> {
        let plain = Scene { adhesion: None, ..self.scene.clone() };
        let scene = match adhesion {
            Some(model) => Places::of(&plain)?.with(&[("adhesion", model)])?,
            None => plain,
        };
        let free = also(&without(&self.free, left), more);
        Ok(Self { scene, free, given: without(&self.given, left), name: self.name.clone() })
    }

    /// The same with another body at `at`, and its free numbers.
    fn with_body(&self, (at, body): (&str, Value), free: Vec<String>, given: Vec<String>) -> Result<Self, FitError> {
        let scene = Places::of(&self.scene)?.with(&[(at, body)])?;
        Ok(Self { scene, free, given, name: self.name.clone() })
    }
}

fn work_of(scene: &Scene) -> f64 {
    scene.adhesion.as_ref().map_or(WORK.0, |adhesion| adhesion.traits().work)
}

fn path(free: &str) -> &str {
    free.split_once('=').map_or(free, |(path, _)| path).trim()
}

fn without(free: &[String], begins: &str) -> Vec<String> {
    free.iter().filter(|free| !path(free).starts_with(begins)).cloned().collect()
}

/// What is free, and the places of `more` that are not free yet.
fn also(free: &[String], more: &[&str]) -> Vec<String> {
    let new = more.iter().filter(|more| !free.iter().any(|free| path(free) == path(more)));
    free.iter().cloned().chain(new.map(|more| (*more).to_owned())).collect()
}

/// The place of the elastic body that stands beside a rigid one, and the body.
fn elastic(scene: &Scene) -> Result<(&'static str, &Elastic), FitError> {
    match &scene.bodies {
        (Body::Elastic(body), Body::Rigid) => Ok(("bodies.0", body)),
        (Body::Rigid, Body::Elastic(body)) => Ok(("bodies.1", body)),
        _ => {
            let what = "the models layered and power-law are made of an Elastic body beside Rigid";
            Err(FitError::Scene(format!("{what}: expected such bodies, or a scene file for the model")))
        }
    }
}

/// A layer as thick as the tip is round, to be searched from a hundredth to ten thousand times of that.
fn layered(plain: &Candidate) -> Result<Candidate, FitError> {
    let (at, body) = elastic(&plain.scene)?;
    let radius = plain.scene.shape.tip_radius().ok_or_else(|| {
        let what = "the model layered starts from the radius of a round tip: expected a scene file for the model";
        FitError::Scene(what.to_owned())
    })?;
    let layer = json!({"body": {"Elastic": body}, "thickness": radius});
    let layers = json!({"Layered": {"layers": [layer], "base": "Rigid", "bond": "Bonded"}});
    let inside = format!("{at}.");
    let moved = |path: &String| match path.strip_prefix(&inside) {
        Some(rest) => format!("{inside}layers.0.body.{rest}"),
        None => path.clone(),
    };
    let thickness = format!("{inside}layers.0.thickness={:e}..{:e}", radius / 100.0, radius * 1e4);
    let free = plain.free.iter().map(moved).chain([thickness]).collect();
    plain.with_body((at, layers), free, plain.given.iter().map(moved).collect())
}

/// G = E/(2(1 + ν)) at one second, in any range, and an exponent.
fn power_law(plain: &Candidate) -> Result<Candidate, FitError> {
    let (at, body) = elastic(&plain.scene)?;
    let modulus = body.young.si() / (2.0 * (1.0 + body.poisson.si()));
    let law = json!({"modulus": modulus, "exponent": EXPONENT.0, "time": 1.0});
    let body = json!({"Viscoelastic": {"poisson": body.poisson, "shear": {"PowerLaw": law}}});
    let young = format!("{at}.young");
    let new = [format!("{at}.shear.modulus"), format!("{at}.{}", EXPONENT.1)];
    let free = without(&plain.free, &young).into_iter().chain(new).collect();
    plain.with_body((at, body), free, without(&plain.given, &young))
}
