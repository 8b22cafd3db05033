//! The program springbed.
//!
//! `springbed run SCENE.ron` goes: command line → scene file → plan → simulation → exports → files.

use std::process::ExitCode;

fn main() -> ExitCode {
    springbed::app::command::main()
}
