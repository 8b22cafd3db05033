//! The native half of the Python package `springbed`: scenes in, arrays out; the rest is in `springbed/*.py`.

mod columns;
mod contact;
mod errors;
mod fit;
mod half_space;
mod scene;
mod sweep;
mod watch;

use pyo3::prelude::*;

#[pymodule]
mod _springbed {
    #[pymodule_export]
    use super::contact::Contact;
    #[pymodule_export]
    use super::fit::fit;
    #[pymodule_export]
    use super::half_space::half_space;
    #[pymodule_export]
    use super::scene::{check, figure, picture, run};
    #[pymodule_export]
    use super::sweep::{rows, sweep};

    use super::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
