//! `springbed completions`, `man` and `schema`: what shells and editors want to know.

use crate::app::console::{Console, Failure};
use crate::text::advice;
use clap::Command;
use clap_complete::Shell;
use clap_mangen::Man;

/// Prints the script that completes the words of `command` in a shell.
///
/// # Errors
/// Standard output cannot be written.
pub fn completions(shell: Shell, mut command: Command, console: &Console) -> Result<(), Failure> {
    let (name, mut script) = (command.get_name().to_owned(), Vec::new());
    clap_complete::generate(shell, &mut command, name, &mut script);
    console.result(&String::from_utf8_lossy(&script))
}

/// Prints the JSON Schema of a scene in JSON.
///
/// # Errors
/// Standard output cannot be written.
pub fn schema(console: &Console) -> Result<(), Failure> {
    console.result(&serde_json::to_string_pretty(&crate::text::schema::schema()).map_err(Failure::failed)?)
}

/// Prints the page of the manual of `command`, or that of one of its own commands.
///
/// # Errors
/// There is no such command; standard output cannot be written.
pub fn manual(topic: Option<&str>, mut command: Command, console: &Console) -> Result<(), Failure> {
    command.build();
    let page = match topic {
        None => command,
        Some(topic) => command.find_subcommand(topic).cloned().ok_or_else(|| unknown(topic, &command))?,
    };
    let mut text = Vec::new();
    Man::new(page).render(&mut text).map_err(Failure::failed)?;
    console.result(&String::from_utf8_lossy(&text))
}

fn unknown(topic: &str, command: &Command) -> Failure {
    let known: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
    Failure::Usage(format!("unknown command `{topic}`: {}", advice(topic, &known)))
}
