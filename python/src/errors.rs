//! Errors of the library as exceptions of the package.

use pyo3::prelude::*;
use springbed::input::problem::Problem;
use springbed::text::TextError;

/// One problem: its place in words, what it is, and its line and column if it stands in a text.
type Told = (String, String, Option<usize>, Option<usize>);

/// `springbed.SceneError` with what is wrong with a text.
pub fn of_text(py: Python<'_>, errors: &[TextError]) -> PyErr {
    let told = errors.iter().map(|error| {
        let (line, column) = (error.position.line, error.position.column);
        (format!("line {line}, column {column}"), error.message.clone(), Some(line), Some(column))
    });
    raised(py, told.collect())
}

/// `springbed.SceneError` with what is wrong at places of a scene.
pub fn of_places(py: Python<'_>, problems: &[Problem]) -> PyErr {
    raised(py, problems.iter().map(|problem| (problem.path.clone(), problem.message.clone(), None, None)).collect())
}

/// `springbed.ComputationError`: the scene is right and cannot be followed to its end.
pub fn failed(py: Python<'_>, why: impl ToString) -> PyErr {
    made(py, "ComputationError", why.to_string())
}

fn raised(py: Python<'_>, problems: Vec<Told>) -> PyErr {
    made(py, "SceneError", problems)
}

fn made<'py>(py: Python<'py>, name: &str, argument: impl IntoPyObject<'py>) -> PyErr {
    let class = py.import("springbed._errors").and_then(|module| module.getattr(name));
    match class.and_then(|class| class.call1((argument,))) {
        Ok(error) => PyErr::from_value(error),
        Err(error) => error,
    }
}
