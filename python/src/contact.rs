//! Contacts that a program of the user holds and moves, as many as it likes in one call.

use crate::errors::{failed, of_places};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use rayon::prelude::*;
use springbed::input::problem::Problem;
use springbed::library::{self, Indenter, LibraryError};
use springbed::material::Relaxation;

/// Contacts of one thread's share: fewer are not worth another thread.
const SHARE: usize = 256;

/// E*(t): equilibrium modulus, terms of modulus and time, viscosity.
type Written = (f64, Vec<(f64, f64)>, f64);

/// Arrays of contacts, moved by depth or force.
#[pyclass(module = "springbed._springbed")]
pub struct Contact {
    all: Vec<library::Contact>,
}

/// What the contacts of an array differ in, and what they share.
#[derive(FromPyObject)]
pub struct Parts {
    shape: String,
    size: Vec<f64>,
    modulus: Option<Vec<f64>>,
    relaxation: Option<Written>,
    work: Option<Vec<f64>>,
    stress: Option<Vec<f64>>,
    tangential_modulus: Option<Vec<f64>>,
    friction: Option<Vec<f64>>,
}

/// The value of a contact: its own, or that of all.
fn of(values: &[f64], at: usize) -> f64 {
    values.get(at).or(values.first()).copied().unwrap_or(f64::NAN)
}

impl Parts {
    fn indenter(&self, at: usize) -> Result<Indenter, LibraryError> {
        let size = of(&self.size, at);
        match self.shape.as_str() {
            "sphere" => library::Contact::sphere(size),
            "cone" => library::Contact::cone(size),
            _ => library::Contact::paraboloid(size),
        }
    }

    fn contact(&self, at: usize) -> Result<library::Contact, LibraryError> {
        let indenter = self.indenter(at)?;
        let own = |values: &Option<Vec<f64>>| values.as_ref().map(|values| of(values, at));
        let contact = match &self.relaxation {
            Some((equilibrium, terms, viscosity)) => {
                let relaxation = Relaxation { equilibrium: *equilibrium, terms: terms.clone(), viscosity: *viscosity };
                indenter.viscoelastic(&relaxation)?
            }
            None => indenter.elastic(own(&self.modulus).unwrap_or(f64::NAN))?,
        };
        let contact = match (own(&self.work), own(&self.stress)) {
            (Some(work), Some(stress)) => contact.maugis(work, stress)?,
            (Some(work), None) => contact.jkr(work)?,
            (None, _) => contact,
        };
        match own(&self.friction) {
            Some(coefficient) => contact.coulomb(own(&self.tangential_modulus).unwrap_or(f64::NAN), coefficient),
            None => Ok(contact),
        }
    }
}

#[pymethods]
impl Contact {
    /// `count` contacts of the given parts, untouched.
    #[new]
    fn new(py: Python<'_>, parts: Parts, count: usize) -> PyResult<Self> {
        let made = |at| parts.contact(at).map_err(|error| Problem::new(format!("contact {at}"), error.to_string()));
        let all = (0..count).map(made).collect::<Result<Vec<_>, _>>();
        Ok(Self { all: all.map_err(|problem| of_places(py, &[problem]))? })
    }

    fn __len__(&self) -> usize {
        self.all.len()
    }

    /// The same contacts in the same state, moved on their own from here.
    fn copy(&self) -> Self {
        Self { all: self.all.clone() }
    }

    /// Moves all contacts to depths and tangential displacements [m] in so many seconds.
    fn advance(
        &mut self,
        py: Python<'_>,
        depth: PyReadonlyArray1<'_, f64>,
        slide: PyReadonlyArray1<'_, f64>,
        seconds: f64,
    ) -> PyResult<()> {
        let (depth, slide) = (depth.as_slice()?, slide.as_slice()?);
        self.each(py, |at, contact| contact.advance_over(of(depth, at), of(slide, at), seconds).map(drop))
    }

    /// Presses all contacts with forces [N].
    fn press(&mut self, py: Python<'_>, force: PyReadonlyArray1<'_, f64>) -> PyResult<()> {
        let force = force.as_slice()?;
        self.each(py, |at, contact| contact.press(of(force, at)).map(drop))
    }

    /// A quantity of all contacts by its name.
    fn state<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let of: fn(&library::Contact) -> f64 = match name {
            "indentation" => |contact| contact.indentation().unwrap_or(f64::NAN),
            "force" => library::Contact::force,
            "tangential_force" => library::Contact::tangential_force,
            "contact_radius" => library::Contact::contact_radius,
            "stick_radius" => library::Contact::stick_radius,
            "stiffness" => library::Contact::stiffness,
            "stored" => library::Contact::stored,
            "dissipated" => library::Contact::dissipated,
            "joined" => |contact| f64::from(u8::from(contact.is_joined())),
            other => return Err(failed(py, format!("a contact has no {other}"))),
        };
        let all = &self.all;
        let values: Vec<f64> = py.detach(|| all.par_iter().with_min_len(SHARE).map(of).collect());
        Ok(values.into_pyarray(py))
    }

    /// Pressure [Pa] of one contact at radii [m].
    fn pressure<'py>(
        &self,
        py: Python<'py>,
        at: usize,
        radius: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let contact = self.all.get(at).ok_or_else(|| failed(py, format!("there is no contact {at}")))?;
        let loaded = contact.loaded();
        let pressures: Vec<f64> = radius.as_slice()?.iter().map(|radius| loaded.pressure(radius.abs())).collect();
        Ok(pressures.into_pyarray(py))
    }
}

impl Contact {
    /// Moves every contact without the lock of the interpreter; the first that cannot be moved is told, the others have.
    fn each(
        &mut self,
        py: Python<'_>,
        step: impl Fn(usize, &mut library::Contact) -> Result<(), LibraryError> + Sync,
    ) -> PyResult<()> {
        let all = &mut self.all;
        let failure = py.detach(|| {
            let each = all.par_iter_mut().enumerate().with_min_len(SHARE);
            each.filter_map(|(at, contact)| Some((at, step(at, contact).err()?))).min_by_key(|failure| failure.0)
        });
        match failure {
            Some((at, error)) => Err(failed(py, format!("contact {at}: {error}"))),
            None => Ok(()),
        }
    }
}
