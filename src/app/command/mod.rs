//! The command line: what can be asked for, and who answers.
//!
//! # Examples
//! ```no_run
//! // All of the program.
//! let code = springbed::app::command::main();
//! ```

mod check;
mod compare;
mod delivery;
mod explain;
mod fit;
#[cfg(feature = "plot")]
mod gallery;
mod help;
mod overlay;
mod report;
mod run;
mod shell;
mod sweep;
mod verify;
#[cfg(feature = "watch")]
mod watch;

use super::console::{Colour, Console, Failure, Voice};
use super::medium::Medium;
use super::picture::{self, Drawing};
use super::run::{Asked, Format};
use super::{starters, write};
use crate::check::study::Thoroughness;
use clap::{ArgAction, Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::process::ExitCode;
use sweep::{SweepArgs, gather};

/// Exact contact mechanics from a text file: indentation, adhesion, friction, creep, impact.
#[derive(Debug, Parser)]
#[command(name = "springbed", version, max_term_width = 100, arg_required_else_help = true)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    common: Common,
}

/// Flags of all commands.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Files, figures and messages")]
pub struct Common {
    /// Folder for the files written.
    #[arg(long, global = true, value_name = "DIR", default_value = "plots")]
    pub out: PathBuf,
    /// Kinds of files to write.
    #[arg(long, global = true, value_enum, value_delimiter = ',', default_value = "csv,json,svg")]
    pub format: Vec<Format>,
    /// What figures are drawn for.
    #[arg(long, global = true, value_enum, default_value = "screen")]
    pub style: Medium,
    /// Dots per inch of PNG, 20 to 2400; 200 if not given, 600 on paper.
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u32).range(20..=2400))]
    pub dpi: Option<u32>,
    /// Threads to compute on; all cores if not given. The results do not depend on it.
    #[arg(long, global = true, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
    /// Say nothing but warnings and errors; twice, nothing but errors.
    #[arg(long, short, global = true, action = ArgAction::Count)]
    pub quiet: u8,
    /// Results on standard output as JSON.
    #[arg(long, global = true)]
    pub json: bool,
    /// Colour in messages.
    #[arg(long, global = true, value_enum, value_name = "WHEN", default_value = "auto")]
    pub color: Colour,
}

impl Common {
    /// How figures are drawn.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        Drawing { medium: self.style, dots: self.dpi }
    }

    /// The files wanted.
    #[must_use]
    pub fn asked(&self) -> Asked {
        Asked { formats: self.format.clone(), drawing: self.drawing() }
    }
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Compute scenes; write tables, summaries and figures.
    Run {
        /// Scene files, RON or JSON by their names; `-` is standard input.
        #[arg(required = true, value_name = "SCENE.ron")]
        scenes: Vec<PathBuf>,
        #[command(flatten)]
        sweep: SweepArgs,
    },
    /// Put the parts of sweeps together.
    Gather {
        /// Folder with what `run --part` has written.
        #[arg(value_name = "DIR")]
        folder: PathBuf,
    },
    /// Read and check scenes, compute nothing.
    Check {
        /// Scene files.
        #[arg(required = true, value_name = "SCENE.ron")]
        scenes: Vec<PathBuf>,
    },
    /// Say how a scene would be computed, and how well.
    Explain {
        /// Scene file.
        #[arg(value_name = "SCENE.ron", required_unless_present = "matrix", conflicts_with = "matrix")]
        scene: Option<PathBuf>,
        /// Which shapes, bodies, adhesion, friction and drives are computed together, and why the others are not.
        #[arg(long)]
        matrix: bool,
        /// Compute the scene of every combination as well, some minutes, and say how far each is off.
        #[arg(long, requires = "matrix")]
        measure: bool,
    },
    /// Print a commented scene to start from.
    New {
        /// Kind of scene; without it, the kinds.
        #[arg(value_name = "KIND")]
        kind: Option<String>,
    },
    /// Compute every case with a known answer and show the errors.
    Verify {
        /// Only cases whose name contains this.
        #[arg(value_name = "FILTER")]
        filter: Option<String>,
        /// Print the table as the VALIDATION.md of the project.
        #[arg(long)]
        markdown: bool,
        /// Compute the scene of every combination as well, some minutes, and say in its table how far each is off.
        #[arg(long, requires = "markdown")]
        measure: bool,
    },
    /// Draw the curves of several scenes, and measured ones, in one figure.
    Overlay {
        /// Scene files, and tables of measured values (.csv) with columns such as indentation_m,force_n.
        #[arg(required = true, value_name = "SCENE.ron|DATA.csv")]
        curves: Vec<PathBuf>,
    },
    /// Show scenes and what comes out of them on one page of HTML that needs nothing else.
    #[cfg(feature = "plot")]
    Gallery {
        /// Scene files.
        #[arg(required = true, value_name = "SCENE.ron")]
        scenes: Vec<PathBuf>,
    },
    /// Serve a page on this machine that follows a scene, with sliders for its numbers.
    #[cfg(feature = "watch")]
    Watch {
        /// Scene file.
        #[arg(value_name = "SCENE.ron")]
        scene: PathBuf,
        /// Port on 127.0.0.1; a free one if 0.
        #[arg(long, value_name = "PORT", default_value_t = 0)]
        port: u16,
    },
    /// Compare springs, the direct path and the full half-space on a scene.
    Compare {
        /// Scene file.
        #[arg(value_name = "SCENE.ron")]
        scene: PathBuf,
    },
    /// Find parameters of a scene from measured curves, and how sure they are.
    Fit(fit::Arguments),
    /// Error against run time, behaviour at the extremes, throughput.
    Report {
        /// What to report.
        #[arg(value_enum)]
        topic: Topic,
        /// Scene to report on; without it, the cases with known answers.
        #[arg(value_name = "SCENE.ron")]
        scene: Option<PathBuf>,
        /// Take longer than a minute if it helps.
        #[arg(long)]
        thorough: bool,
    },
    /// Print the script that completes commands and flags in a shell.
    Completions {
        /// The shell.
        #[arg(value_enum)]
        shell: Shell,
    },
    /// Print the JSON Schema of scenes in JSON, for editors.
    Schema,
    /// Print the page of the manual, for `man -l -`.
    Man {
        /// The page of one command.
        #[arg(value_name = "COMMAND")]
        topic: Option<String>,
    },
}

/// Topic of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Topic {
    /// Error against run time.
    Accuracy,
    /// Stiff and extreme values.
    Stability,
    /// Throughput.
    Speed,
}

/// Reads the command line, does what it asks for and says how it ended.
#[must_use]
pub fn main() -> ExitCode {
    let line = command_line().try_get_matches().and_then(|found| {
        let misplaced = help::misplaced(&found, &command_line());
        Ok((CommandLine::from_arg_matches(&found)?, misplaced))
    });
    let (CommandLine { command, common }, misplaced) = match line {
        Ok(line) => line,
        Err(error) => {
            // Help and version also come as an error; a closed pipe is not worth a word.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    let console = Console::new(common.color, Voice::after(common.quiet));
    let read = misplaced.map_or(Ok(()), |said| Err(Failure::Usage(said)));
    console.end(read.and_then(|()| prepared(&common)).and_then(|()| answer(command, &common, &console)))
}

/// All commands and flags, with their help.
fn command_line() -> clap::Command {
    help::shown(CommandLine::command())
}

/// What this program can write, threads and the handler of Ctrl-C.
fn prepared(common: &Common) -> Result<(), Failure> {
    picture::available(&common.format).map_err(|error| Failure::Usage(error.to_string()))?;
    write::remove_unfinished_on_interrupt().map_err(Failure::failed)?;
    let Some(threads) = common.threads else { return Ok(()) };
    if threads.get() > 4096 {
        return Err(Failure::Usage(format!("--threads {threads} is more than any machine has: expected at most 4096")));
    }
    rayon::ThreadPoolBuilder::new().num_threads(threads.get()).build_global().map_err(Failure::failed)
}

fn answer(command: Command, common: &Common, console: &Console) -> Result<(), Failure> {
    match command {
        Command::Run { scenes, sweep } => run::run(&scenes, &sweep, common, console),
        Command::Gather { folder } => gather(&folder, common, console),
        Command::Check { scenes } => check::run(&scenes, common, console),
        Command::Explain { scene, measure, .. } => match scene {
            Some(scene) => explain::run(&scene, common, console),
            None => explain::matrix(explain::Errors::asked(measure), common, console),
        },
        Command::New { kind } => starters::run(kind.as_deref(), console),
        Command::Verify { filter, markdown, measure } => {
            let errors = explain::Errors::asked(measure);
            let form = if markdown { verify::Form::Markdown(errors) } else { verify::Form::of(common) };
            verify::run(filter.as_deref().unwrap_or(""), form, console)
        }
        Command::Overlay { curves } => overlay::run(&curves, common, console),
        #[cfg(feature = "plot")]
        Command::Gallery { scenes } => gallery::run(&scenes, common, console),
        #[cfg(feature = "watch")]
        Command::Watch { scene, port } => watch::run(&scene, port, console),
        Command::Compare { scene } => compare::run(&scene, common, console),
        Command::Fit(arguments) => fit::run(&arguments, common, console),
        Command::Report { topic, scene, thorough } => {
            let effort = if thorough { Thoroughness::Thorough } else { Thoroughness::Brief };
            report::run(topic, scene.as_deref(), effort, common, console)
        }
        Command::Completions { shell } => shell::completions(shell, command_line(), console),
        Command::Schema => shell::schema(console),
        Command::Man { topic } => shell::manual(topic.as_deref(), command_line(), console),
    }
}
