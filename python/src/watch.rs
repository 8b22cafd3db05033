//! Long work without the lock of the interpreter, given up on Ctrl-C.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::time::Duration;

/// Time between two looks for Ctrl-C.
const LOOK: Duration = Duration::from_millis(50);

/// Whether work that nobody waits for any more goes on.
#[derive(Debug, Clone, Default)]
pub struct Wanted(Arc<AtomicBool>);

impl Wanted {
    /// Whether Ctrl-C has ended the wait.
    pub fn is_given_up(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// What `work` gives. It is done on another thread, so that signals of the interpreter are seen meanwhile; on
/// Ctrl-C the wait ends at once, and the work where it next asks whether it is still wanted.
///
/// # Errors
/// Ctrl-C; the work has failed as no work should.
pub fn watched<T: Send + 'static>(py: Python<'_>, work: impl FnOnce(&Wanted) -> T + Send + 'static) -> PyResult<T> {
    let (sender, mut receiver) = sync_channel(1);
    let wanted = Wanted::default();
    let given = wanted.clone();
    // On a thread that is there: to start one takes as long as a short scene. A receiver that has gone waits for nothing.
    rayon::spawn(move || {
        if let Ok(value) = catch_unwind(AssertUnwindSafe(|| work(&given))) {
            sender.send(value).ok();
        }
    });
    loop {
        let waiting = &mut receiver;
        match py.detach(move || waiting.recv_timeout(LOOK)) {
            Ok(value) => return Ok(value),
            Err(RecvTimeoutError::Timeout) => {
                py.check_signals().inspect_err(|_| wanted.0.store(true, Ordering::Relaxed))?;
            }
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err(
                    "springbed has failed where it should not: please report the scene",
                ));
            }
        }
    }
}
