//! No two files or folders side by side use each other: what a name is made of can be read from one
//! end. A file and the `mod.rs` of its own folder do not count, nor do tests.

use super::layers::{code, only_tests, sources, src};
use std::collections::{BTreeMap, BTreeSet};

/// A module or a name in it, from the root.
type Place = Vec<String>;

/// A `use` declaration or a path in the code of a module.
struct Mention {
    place: Place,
    /// Whether it is `pub use`, a second name for what stands elsewhere.
    again: bool,
}

/// All modules that are not tests, and the places each mentions.
struct House(BTreeMap<Place, Vec<Mention>>);

impl House {
    fn of_src() -> Self {
        let files = sources(&src()).into_iter().filter(|path| !only_tests(path));
        let texts: BTreeMap<Place, String> = files.map(|path| (module(&path), code(&path))).collect();
        let mentions = |(from, text): (&Place, &String)| (from.clone(), mentions(text, from, &texts));
        Self(texts.iter().map(mentions).collect())
    }

    /// The module a place is in, other names followed to where they stand.
    fn home(&self, place: &[String]) -> Place {
        let held = (0..=place.len()).rev().find(|&k| self.0.contains_key(&place[..k])).unwrap();
        let (module, rest) = place.split_at(held);
        let again = |name: &String| {
            self.0[module].iter().find(|mention| {
                mention.again && mention.place.last() == Some(name) && mention.place.as_slice() != place
            })
        };
        match rest.split_first().and_then(|(name, rest)| Some((again(name)?, rest))) {
            Some((mention, rest)) => self.home(&[mention.place.as_slice(), rest].concat()),
            None => module.to_vec(),
        }
    }

    /// What each file or folder uses of those beside it.
    fn beside(&self) -> BTreeMap<Place, BTreeSet<Place>> {
        let mut uses = BTreeMap::<Place, BTreeSet<Place>>::new();
        for (from, mentions) in &self.0 {
            for to in mentions.iter().map(|mention| self.home(&mention.place)) {
                let alike = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
                if alike < from.len().min(to.len()) {
                    uses.entry(from[..=alike].to_vec()).or_default().insert(to[..=alike].to_vec());
                }
            }
        }
        uses
    }
}

/// src/a/b.rs and src/a/b/mod.rs are a::b.
fn module(path: &std::path::Path) -> Place {
    let relative = path.strip_prefix(src()).unwrap().with_extension("");
    let mut parts: Place = relative.components().map(|part| part.as_os_str().to_string_lossy().into()).collect();
    if ["mod", "lib", "main"].contains(&parts.last().unwrap().as_str()) {
        parts.pop();
    }
    parts
}

fn mentions(text: &str, from: &Place, modules: &BTreeMap<Place, String>) -> Vec<Mention> {
    let mut found = Vec::new();
    for statement in text.split(';') {
        let statement = statement.trim_start().lines().filter(|line| !line.starts_with("#[")).collect::<String>();
        let (again, rest) = match statement.split_once("use ") {
            Some((before, tree)) if before.is_empty() || before.starts_with("pub") => {
                (!before.is_empty(), leaves(tree))
            }
            _ => (false, inline(&statement)),
        };
        let places = rest.iter().filter_map(|path| absolute(path, from, modules));
        found.extend(places.map(|place| Mention { place, again }));
    }
    found
}

/// `a::{b, c::{d, e}}` is a::b, a::c::d, a::c::e.
fn leaves(tree: &str) -> Vec<String> {
    let Some((before, list)) = tree.split_once('{') else {
        return vec![tree.split(" as ").next().unwrap().trim().to_owned()];
    };
    let (mut depth, mut found, mut from) = (0, Vec::new(), 0);
    let list = list.trim_end().trim_end_matches('}');
    for (at, sign) in list.char_indices().chain([(list.len(), ',')]) {
        match sign {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                let part = &list[from..at];
                found.extend(leaves(part).into_iter().map(|leaf| format!("{}{leaf}", before.trim())));
                from = at + 1;
            }
            _ => {}
        }
    }
    found
}

/// Paths in an expression or a type.
fn inline(text: &str) -> Vec<String> {
    let words = text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
    words.filter(|word| word.starts_with("crate::") || word.starts_with("super::")).map(str::to_owned).collect()
}

/// A path as seen from a module; `None` if it leads to another crate.
fn absolute(path: &str, from: &Place, modules: &BTreeMap<Place, String>) -> Option<Place> {
    let names: Vec<&str> = path.split("::").filter(|name| !name.is_empty()).collect();
    let ups = names.iter().take_while(|name| **name == "super").count();
    let start = match *names.first()? {
        "crate" => (Vec::new(), 1),
        "self" => (from.clone(), 1),
        "super" => (from[..from.len() - ups].to_vec(), ups),
        name if modules.contains_key(&[from.as_slice(), &[name.to_owned()]].concat()) => (from.clone(), 0),
        _ => return None,
    };
    Some(start.0.into_iter().chain(names[start.1..].iter().map(|name| (*name).to_owned())).collect())
}

/// All that is used by `from`, directly or not.
fn reached<'a>(from: &'a Place, uses: &'a BTreeMap<Place, BTreeSet<Place>>) -> BTreeSet<&'a Place> {
    let (mut seen, mut next) = (BTreeSet::new(), vec![from]);
    while let Some(place) = next.pop() {
        next.extend(uses.get(place).into_iter().flatten().filter(|used| seen.insert(*used)));
    }
    seen
}

#[test]
fn no_circles_between_files() {
    let uses = House::of_src().beside();
    assert!(uses.len() > 50, "{} files or folders use others", uses.len());
    let reach: BTreeMap<&Place, BTreeSet<&Place>> = uses.keys().map(|from| (from, reached(from, &uses))).collect();
    let circles = reach.iter().filter(|(from, reached)| reached.contains(*from)).map(|(from, reached)| {
        let circle = reached.iter().filter(|to| reach.get(*to).is_some_and(|back| back.contains(from)));
        circle.map(|place| place.join("::")).collect::<Vec<_>>().join(", ")
    });
    assert_eq!(circles.collect::<BTreeSet<_>>(), BTreeSet::new(), "these use each other");
}

#[test]
fn lists_of_names_are_taken_apart() {
    assert_eq!(leaves("a::{b, c::{d, e as f}, g}"), ["a::b", "a::c::d", "a::c::e", "a::g"]);
    assert_eq!(inline("let x: &crate::a::b::C = super::d(y)"), ["crate::a::b::C", "super::d"]);
}
