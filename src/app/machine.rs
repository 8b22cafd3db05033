//! The machine a report was made on.

use serde::Serialize;

/// What run times depend on.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Machine {
    /// Name of the processor.
    pub cpu: String,
    /// Threads computed on.
    pub threads: usize,
    /// The compiler.
    pub compiler: &'static str,
    /// Version of this program.
    pub version: &'static str,
}

impl Machine {
    /// This machine.
    #[must_use]
    pub fn here() -> Self {
        Self {
            cpu: cpu(),
            threads: rayon::current_num_threads(),
            compiler: env!("SPRINGBED_COMPILER"),
            version: env!("CARGO_PKG_VERSION"),
        }
    }

    /// The machine in one line.
    #[must_use]
    pub fn line(&self) -> String {
        let threads = if self.threads == 1 { "1 thread".to_owned() } else { format!("{} threads", self.threads) };
        format!("{}, {threads}; {}; springbed {}", self.cpu, self.compiler, self.version)
    }
}

/// Name of the processor, or its kind where the system does not tell.
fn cpu() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = told.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned())
}
