//! Names the compiler, for the footer of the reports.

use std::process::Command;

fn main() {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let said = Command::new(rustc).arg("--version").output().ok();
    let name = said.and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_default();
    println!("cargo:rustc-env=SPRINGBED_COMPILER={}", name.trim());
    println!("cargo:rerun-if-changed=build.rs");
}
