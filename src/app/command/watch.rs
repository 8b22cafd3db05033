//! `springbed watch`: a page that follows a scene.

use crate::app::console::{Console, Failure};
use crate::app::watch::serve;
use std::path::Path;

/// Serves the page of a scene until the program is stopped.
///
/// # Errors
/// The scene is not in a file that is there, or the port is taken.
pub fn run(scene: &Path, port: u16, console: &Console) -> Result<(), Failure> {
    if !scene.is_file() {
        return Err(Failure::Usage(format!("{}: there is no such file: expected a scene to follow", scene.display())));
    }
    serve(scene, port, console)
}
