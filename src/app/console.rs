//! What a person or a pipe reads: results on standard output, messages on standard error.

use super::fault::{Fault, Paint};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, IsTerminal, Write};
use std::process::ExitCode;

/// How the program ends if it does not end well.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// A scene is wrong; exit code 2.
    #[error("the scene is wrong")]
    Scene(Vec<Fault>),
    /// The program is used wrongly; exit code 2.
    #[error("{0}")]
    Usage(String),
    /// The computation or a check failed; exit code 1.
    #[error("{0}")]
    Failed(String),
}

impl Failure {
    /// A failure of the computation.
    pub fn failed(error: impl ToString) -> Self {
        Self::Failed(error.to_string())
    }
}

/// When messages are coloured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Colour {
    /// On a terminal, unless NO_COLOR is set.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

impl Colour {
    fn paint(self) -> Paint {
        let terminal =
            || io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
        let coloured = match self {
            Self::Auto => terminal(),
            Self::Always => true,
            Self::Never => false,
        };
        if coloured { Paint::Coloured } else { Paint::Plain }
    }
}

/// How much is said.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Voice {
    /// Results, messages and progress.
    Normal,
    /// Warnings and errors.
    Quiet,
    /// Errors only.
    Silent,
}

impl Voice {
    /// The voice of a program told so many times to be quiet.
    #[must_use]
    pub fn after(quiet: u8) -> Self {
        match quiet {
            0 => Self::Normal,
            1 => Self::Quiet,
            _ => Self::Silent,
        }
    }
}

/// Standard output and standard error.
#[derive(Debug, Clone, Copy)]
pub struct Console {
    paint: Paint,
    voice: Voice,
}

impl Console {
    /// A console with the colours and the voice asked for.
    #[must_use]
    pub fn new(colour: Colour, voice: Voice) -> Self {
        Self { paint: colour.paint(), voice }
    }

    /// Whether progress and messages are wanted.
    #[must_use]
    pub fn talks(&self) -> bool {
        self.voice == Voice::Normal
    }

    /// Writes a result to standard output, with a line end unless it has one.
    ///
    /// A reader that has gone away (`springbed … | head`) is no failure.
    ///
    /// # Errors
    /// Standard output cannot be written, as on a full disk.
    pub fn result(&self, text: &str) -> Result<(), Failure> {
        let end = if text.ends_with('\n') || text.is_empty() { "" } else { "\n" };
        let mut out = io::stdout().lock();
        match out.write_all(text.as_bytes()).and_then(|()| out.write_all(end.as_bytes())).and_then(|()| out.flush()) {
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
                Err(Failure::Failed(format!("standard output cannot be written: {error}")))
            }
            _ => Ok(()),
        }
    }

    /// Writes a result to standard output unless the program is to be quiet.
    ///
    /// # Errors
    /// Standard output cannot be written.
    pub fn say(&self, text: &str) -> Result<(), Failure> {
        if self.talks() { self.result(text) } else { Ok(()) }
    }

    /// Writes a message to standard error unless the program is to be quiet.
    pub fn message(&self, text: &str) {
        if self.talks() {
            Self::error(text);
        }
    }

    /// A bar for `count` pieces of work such as "scenes"; shown on a terminal only.
    #[must_use]
    pub fn progress(&self, count: usize, what: &'static str) -> ProgressBar {
        if count < 2 || !self.talks() {
            return ProgressBar::hidden();
        }
        let style = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {what}, {{eta}} left"));
        ProgressBar::new(count as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
    }

    /// Writes a warning to standard error unless the program is to say nothing but errors.
    pub fn warning(&self, text: &str) {
        if self.voice != Voice::Silent {
            Self::error(&format!("{}: {text}", self.paint.bold("warning")));
        }
    }

    /// Says how it ended, and gives the exit code.
    #[must_use]
    pub fn end(&self, outcome: Result<(), Failure>) -> ExitCode {
        let (code, lines) = match outcome {
            Ok(()) => return ExitCode::SUCCESS,
            Err(Failure::Scene(faults)) => (2, faults.iter().map(|fault| fault.rendered(self.paint)).collect()),
            Err(Failure::Usage(message)) => (2, vec![self.error_line(&message)]),
            Err(Failure::Failed(message)) => (1, vec![self.error_line(&message)]),
        };
        for line in lines {
            Self::error(&line);
        }
        ExitCode::from(code)
    }

    fn error_line(&self, message: &str) -> String {
        format!("{}: {message}", self.paint.red("error"))
    }

    /// Standard error may be closed; there is nobody left to tell.
    fn error(text: &str) {
        let _ = writeln!(io::stderr().lock(), "{text}");
    }
}
