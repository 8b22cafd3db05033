//! Scenes and what came out of them as one page that needs nothing else.

use super::figures;
use super::summary::with_prefix;
use crate::run::named::{Finding, Named};
use crate::run::record::Outcome;
use crate::scene::plan::Plan;
use crate::text::place::Places;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// How the page looks and what its buttons do.
const STYLE: &str = include_str!("gallery.css");
const SCRIPT: &str = include_str!("gallery.js");
/// Results that stand in the list of all scenes, and most parameters of one.
const LISTED: [&str; 4] = ["largest_force_n", "largest_contact_radius_m", "pull_off_force_n", "restitution"];
const MOST_PARAMETERS: usize = 60;

/// A scene on the page.
#[derive(Debug)]
pub struct Shown {
    /// Name of its file without extension.
    pub stem: String,
    /// Its text.
    pub text: String,
    /// The plan.
    pub plan: Plan,
    /// What came out of it.
    pub outcome: Outcome,
}

impl Shown {
    fn title(&self) -> &str {
        let title = &self.plan.scene.title;
        if title.is_empty() { &self.stem } else { title }
    }
}

/// The page: a list of all scenes to sort, then each with its figure, results, parameters, sources and text.
#[must_use]
pub fn gallery(scenes: &[Shown]) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { "Scenes of springbed" }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { "Scenes" }
                (list(scenes))
                @for shown in scenes { (article(shown)) }
                p.soft { "springbed " (env!("CARGO_PKG_VERSION")) }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    page.into_string()
}

fn list(scenes: &[Shown]) -> Markup {
    let heads = ["scene", "computed by"].into_iter().map(str::to_owned);
    let heads = heads.chain(LISTED.map(|name| crate::run::unit::Unit::of_name(name).0.replace('_', " ")));
    html! {
        nav.wide {
            table {
                thead { tr { @for head in heads.chain(["relative error".to_owned()]) { th { button type="button" { (head) } } } } }
                tbody {
                    @for shown in scenes {
                        tr {
                            td { a href={ "#" (shown.stem) } { (shown.title()) } }
                            td { (shown.outcome.plan.solver) }
                            @for name in LISTED { (listed(&shown.outcome, name)) }
                            @let error = shown.outcome.error_estimate.relative;
                            td.number data-value=(error) { (format!("{error:.0e}")) }
                        }
                    }
                }
            }
        }
    }
}

fn listed(outcome: &Outcome, name: &str) -> Markup {
    let found = outcome.results.iter().find(|named| named.is_called(name));
    let value = outcome.number(name).map(|number| number.to_string()).unwrap_or_default();
    html! { td.number data-value=(value) { (found.map(shown).unwrap_or_default()) } }
}

/// A result in words, with a prefix and its unit.
#[must_use]
pub fn shown(named: &Named) -> String {
    match named.finding {
        Finding::Number(number) if named.unit.prefixed => with_prefix(number, named.unit.symbol),
        Finding::Number(number) => format!("{number:.6} {}", named.unit.symbol).trim_end().to_owned(),
        Finding::Answer(_) | Finding::Count(_) => named.finding.to_string(),
    }
}

fn article(scene: &Shown) -> Markup {
    let Shown { stem, text, plan, outcome } = scene;
    let estimate = &outcome.error_estimate;
    html! {
        article id=(stem) {
            h2 { (scene.title()) }
            figure { (PreEscaped(figures(plan, outcome).svg())) }
            @for warning in &outcome.warnings { p.warning { "Warning: " (warning) } }
            div.columns {
                section {
                    h3 { "Results" }
                    div.wide { table { tbody {
                        @for named in &outcome.results { tr { th { (named.quantity.replace('_', " ")) } td.number { (shown(named)) } } }
                        tr { th { "relative error" } td.number { (format!("{:.0e}", estimate.relative)) } }
                    } } }
                    p.soft { (estimate.basis) }
                    p.soft { (outcome.plan.solver) ": " (outcome.plan.reason) }
                }
                section {
                    h3 { "Parameters" }
                    div.wide { table { tbody {
                        @for (path, value) in parameters(plan) { tr { th { (path) } td.number { (value) } } }
                    } } }
                }
            }
            @let remarks = remarks(text);
            @if !remarks.is_empty() { h3 { "Sources and remarks" } @for remark in remarks { p { (linked(remark)) } } }
            details {
                summary { "The scene" }
                button.copy type="button" { "copy" }
                pre { (text) }
            }
        }
    }
}

/// The numbers of a scene by their paths, with their units.
fn parameters(plan: &Plan) -> Vec<(String, String)> {
    let Ok(places) = Places::of(&plan.scene) else { return Vec::new() };
    let numbers = places.numbers().into_iter().take(MOST_PARAMETERS);
    let written = |(path, number): (String, f64)| {
        let value = match places.unit(&path) {
            Some(unit) if !matches!(unit, "" | "kg" | "rad" | "rad/s") => with_prefix(number, unit).replace("^2", "²"),
            unit => format!("{number} {}", unit.unwrap_or("")).trim_end().to_owned(),
        };
        (path, value)
    };
    numbers.map(written).collect()
}

/// The lines of comment before the scene.
fn remarks(text: &str) -> Vec<&str> {
    let lines = text.lines().map(str::trim).take_while(|line| line.is_empty() || line.starts_with("//"));
    lines.map(|line| line.trim_start_matches('/').trim()).filter(|line| !line.is_empty()).collect()
}

/// A remark with its DOIs as links.
fn linked(remark: &str) -> Markup {
    let doi = |word: &str| {
        let bare = word.trim_start_matches("doi:").trim_start_matches("https://doi.org/");
        let bare = bare.trim_matches(['(', ')', ',', ';', '.']);
        (bare.starts_with("10.") && bare.contains('/')).then(|| bare.to_owned())
    };
    html! {
        @for word in remark.split(' ') {
            @match doi(word) {
                Some(doi) => { a href={ "https://doi.org/" (doi) } { (word) } " " }
                None => { (word) " " }
            }
        }
    }
}
