//! The program springbed.
//!
//! `springbed run SCENE.ron` goes: command line → scene file → setup → simulation → exports → files.

use std::process::ExitCode;

fn main() -> ExitCode {
    springbed::app::command::main()
}
