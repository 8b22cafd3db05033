//! What `--help` shows: first steps, examples, and of the flags of all commands those that mean something to one.

use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Command};

/// The first steps.
const FIRST: &str = "First steps:
  springbed new                    kinds of scenes to start from
  springbed new jkr > lens.ron     a commented one, to be edited
  springbed check lens.ron         what is wrong with it, with line and column
  springbed run lens.ron           plots/lens.csv, .json and .svg
  springbed explain lens.ron       how it is computed, how well, and what to beware of

`springbed COMMAND --help` has the flags of a command, and examples.";

/// The command line with its help.
#[must_use]
pub fn shown(command: Command) -> Command {
    let everywhere: Vec<Arg> = command.get_arguments().filter(|flag| flag.is_global_set()).cloned().collect();
    let own = |of: Command| {
        let (meant, examples) = of_command(of.get_name());
        let hidden = everywhere.iter().filter(|flag| !SAID.contains(&flag.get_id().as_str()));
        let hidden = hidden.filter(|flag| !meant.contains(&flag.get_id().as_str()));
        let of = of.args(hidden.map(|flag| flag.clone().hide(true)));
        if examples.is_empty() { of } else { of.after_help(format!("Examples:\n{examples}")) }
    };
    command.mut_subcommands(own).after_help(FIRST)
}

/// What is wrong with a command line that gives a command a flag which means nothing to it; `None` if nothing is.
#[must_use]
pub fn misplaced(line: &ArgMatches, command: &Command) -> Option<String> {
    let (name, given) = line.subcommand()?;
    let is_given = |flag: &&str| given.value_source(flag) == Some(ValueSource::CommandLine);
    let flag = ALL.into_iter().filter(|flag| !of_command(name).0.contains(flag)).find(|flag| is_given(flag))?;
    let names = command.get_subcommands().map(Command::get_name);
    let others: Vec<&str> = names.filter(|name| of_command(name).0.contains(&flag)).collect();
    Some(format!("--{flag} means nothing to `springbed {name}`: it goes with {}", others.join(", ")))
}

/// Flags that go with every command.
const SAID: [&str; 2] = ["quiet", "color"];
/// Flags of what computes and writes figures.
const ALL: [&str; 6] = ["out", "format", "style", "dpi", "threads", "json"];

/// The flags that mean something to a command, and its examples.
fn of_command(name: &str) -> (&'static [&'static str], &'static str) {
    match name {
        "run" => (
            &ALL,
            "  springbed run lens.ron --out figures --format svg,csv
  springbed run a.ron b.ron --style paper
  springbed run lens.ron --set bodies.0.young=1kPa..1MPa:50log --set 'adhesion.work=[0.01,0.05]'
  springbed run lens.ron --set shape.radius=1mm..9mm:5 --part 3/100   # one of 100 jobs of a cluster
  springbed new hertz | springbed run - --json",
        ),
        "gather" => (&ALL, "  springbed gather plots   # behind all jobs of `run --part`"),
        "check" => (&["json"], ""),
        "explain" => (&["threads", "json"], "  springbed explain lens.ron\n  springbed explain --matrix"),
        "new" => (&[], "  springbed new\n  springbed new jkr > lens.ron"),
        "verify" => (&["threads", "json"], "  springbed verify jkr"),
        "overlay" => (&ALL, "  springbed overlay soft.ron hard.ron measured.csv"),
        "gallery" => (&["out", "threads"], "  springbed gallery configs/*.ron --out site"),
        "watch" => (&["threads"], "  springbed watch lens.ron   # prints an address to open in a browser"),
        "compare" => (&ALL, "  springbed compare lens.ron"),
        "fit" => (
            &ALL,
            "  springbed fit gel.ron curve.csv --free 'bodies.0.young=100 Pa..100 kPa'
  springbed fit gel.ron map/*.csv --free bodies.0.young=1kPa..1MPa --columns 'depth=z [nm], force=F [nN]'
  springbed fit lens.ron pull.csv --models hertz,jkr --given 'shape.radius=2 %'
  springbed fit --moduli dma.csv --terms fewest",
        ),
        "report" => (&ALL, "  springbed report accuracy\n  springbed report stability"),
        "completions" => (&[], "  springbed completions bash > ~/.local/share/bash-completion/completions/springbed"),
        "man" => (&[], "  springbed man run | man -l -"),
        _ => (&[], ""),
    }
}
