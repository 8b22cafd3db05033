//! A walk over the text of a scene: where the value of a field path stands, and what stands at a place.
//!
//! A parser forgets where a value stood once it has been read. The walker here knows only brackets,
//! commas, colons, text and comments, so it also works on a scene that does not parse, in RON and in JSON.

use std::collections::HashMap;
use std::ops::Range;

/// Byte offsets of the values at the given field paths (`history[3].to`, `bodies.0.young`).
///
/// A path that is not there stands at the value that should hold it; the empty path at the scene.
#[must_use]
pub fn locate(text: &str, paths: &[&str]) -> Vec<usize> {
    let listed: Vec<String> = paths.iter().map(|path| listed(path)).collect();
    let spellings = || paths.iter().copied().zip(listed.iter().map(String::as_str));
    let mut wanted: HashMap<&str, usize> = HashMap::new();
    for (path, listed) in spellings() {
        wanted.extend(with_parents(path).chain(with_parents(listed)).map(|part| (part, usize::MAX)));
    }
    let mut walker = Walker::new(text);
    while let Some(token) = walker.next_value() {
        if let Some(found) = wanted.get_mut(walker.path.as_str()) {
            *found = token.min(*found);
        }
    }
    let both = |(path, listed)| with_parents(path).zip(with_parents(listed));
    let place = |(one, other)| wanted[one].min(wanted[other]);
    spellings().map(|paths| both(paths).map(place).find(|&at| at < usize::MAX).unwrap_or(0)).collect()
}

/// The paths of all values in the order of the text, each with the bytes of its first token.
#[must_use]
pub fn values(text: &str) -> Vec<(String, Range<usize>)> {
    let mut walker = Walker::new(text);
    let mut found = Vec::new();
    while let Some(start) = walker.next_value() {
        found.push((walker.path.clone(), start..start + token(text, start).len()));
    }
    found
}

/// The path with the members of pairs counted like those of lists, as JSON has them: `bodies[0]` for `bodies.0`.
fn listed(path: &str) -> String {
    let number = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let mut parts = path.split('.');
    let first = parts.next().unwrap_or("").to_owned();
    parts.fold(first, |path, part| if number(part) { format!("{path}[{part}]") } else { format!("{path}.{part}") })
}

/// The path, then the paths of what holds it, outwards.
fn with_parents(path: &str) -> impl Iterator<Item = &str> {
    fn holder<'p>(path: &&'p str) -> Option<&'p str> {
        path.rfind(['.', '[']).map(|at| &path[..at])
    }
    std::iter::successors(Some(path), holder).chain(std::iter::once(""))
}

/// What stands around a byte offset of a scene.
#[derive(Debug, PartialEq, Eq)]
pub struct Surroundings {
    /// Path of the field whose value is there; empty outside any.
    pub path: String,
    /// The innermost bracket still open there and its byte offset.
    pub open: Option<(char, usize)>,
    /// Byte offset of the token that holds the place or follows it.
    pub token: usize,
    /// The token before that one.
    pub before: Option<(usize, usize)>,
}

/// What stands around the byte `offset` of `text`.
#[must_use]
pub fn surroundings(text: &str, offset: usize) -> Surroundings {
    let mut walker = Walker::new(text);
    let mut before = None;
    loop {
        let state = (walker.path.clone(), walker.frames.last().map(|frame| (frame.bracket, frame.at)));
        let Some((start, end)) = walker.advance() else {
            return Surroundings { path: state.0, open: state.1, token: text.len(), before };
        };
        if end > offset {
            let path = if walker.path.len() > state.0.len() { walker.path } else { state.0 };
            return Surroundings { path, open: state.1, token: start, before };
        }
        before = Some((start, end));
    }
}

/// One open bracket.
struct Frame {
    bracket: char,
    at: usize,
    /// Length of the path outside the bracket.
    outside: usize,
    /// Number of the present element.
    index: usize,
    /// Whether the present element has begun.
    begun: bool,
}

struct Walker<'t> {
    text: &'t str,
    at: usize,
    frames: Vec<Frame>,
    path: String,
    value: bool,
    root: bool,
}

impl<'t> Walker<'t> {
    fn new(text: &'t str) -> Self {
        Self { text, at: 0, frames: Vec::new(), path: String::new(), value: false, root: false }
    }

    /// Byte offset of the first token of the next value; its path is then `self.path`.
    fn next_value(&mut self) -> Option<usize> {
        loop {
            let (start, _) = self.advance()?;
            if self.value {
                return Some(start);
            }
        }
    }

    /// Takes the next token and keeps the path; `self.value` says whether a value begins with it.
    fn advance(&mut self) -> Option<(usize, usize)> {
        let (start, end) = self.token()?;
        let token = &self.text[start..end];
        self.at = end;
        self.value = false;
        match token {
            "," => self.comma(),
            ":" => {}
            ")" | "]" | "}" => self.close(),
            _ if self.is_key(token) => self.key(token),
            _ => self.begin(),
        }
        if let "(" | "[" | "{" = token {
            let bracket = char::from(token.as_bytes()[0]);
            let outside = self.path.len();
            self.frames.push(Frame { bracket, at: start, outside, index: 0, begun: false });
        }
        Some((start, end))
    }

    fn comma(&mut self) {
        if let Some(frame) = self.frames.last_mut() {
            frame.index += 1;
            frame.begun = false;
            self.path.truncate(frame.outside);
        }
    }

    fn close(&mut self) {
        if let Some(frame) = self.frames.pop() {
            self.path.truncate(frame.outside);
        }
    }

    fn is_key(&self, token: &str) -> bool {
        let fresh = self.frames.last().is_some_and(|frame| !frame.begun && frame.bracket != '[');
        let next = skip_blank(self.text, self.at);
        fresh && token.starts_with(|c| word(c) || c == '"') && self.text[next..].starts_with(':')
    }

    /// A name of a field; that of a kind, as JSON has it before its fields, is no part of the path.
    fn key(&mut self, name: &str) {
        let name = name.trim_matches('"');
        if !name.starts_with(char::is_uppercase) {
            if !self.path.is_empty() {
                self.path.push('.');
            }
            self.path.push_str(name);
        }
        if let Some(frame) = self.frames.last_mut() {
            frame.begun = true;
        }
        self.value = false;
        self.root = true;
    }

    /// A value begins, unless the token belongs to the one that has begun already.
    fn begin(&mut self) {
        let Some(frame) = self.frames.last_mut() else {
            self.value = !std::mem::replace(&mut self.root, true);
            return;
        };
        if !frame.begun {
            frame.begun = true;
            let index = frame.index;
            let segment = if frame.bracket == '[' { format!("[{index}]") } else { format!(".{index}") };
            self.path.push_str(if self.path.is_empty() { segment.trim_start_matches('.') } else { &segment });
        }
        self.value = true;
    }

    fn token(&self) -> Option<(usize, usize)> {
        let start = skip_blank(self.text, self.at);
        let length = token(self.text, start).len();
        (length > 0).then_some((start, start + length))
    }
}

/// The token that begins at the byte `start`; empty at the end of the text.
#[must_use]
pub fn token(text: &str, start: usize) -> &str {
    let rest = &text[start..];
    let length = match rest.chars().next() {
        None => 0,
        Some('"') => text_length(rest),
        Some(c) if word(c) => rest.find(|c| !word(c)).unwrap_or(rest.len()),
        Some(c) => c.len_utf8(),
    };
    &rest[..length]
}

/// Characters of names and numbers.
pub fn word(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '.' | '+' | '-')
}

/// The length of the text in quotes at the start of `rest`, or of all of it if it has no end.
fn text_length(rest: &str) -> usize {
    let mut escaped = false;
    for (at, c) in rest.char_indices().skip(1) {
        match c {
            '"' if !escaped => return at + 1,
            _ => escaped = c == '\\' && !escaped,
        }
    }
    rest.len()
}

/// The first offset from `at` on that is neither blank nor in a comment.
fn skip_blank(text: &str, mut at: usize) -> usize {
    loop {
        let rest = &text[at..];
        let blank = rest.len() - rest.trim_start().len();
        at += match &rest[blank..] {
            comment if comment.starts_with("//") => blank + comment.find('\n').unwrap_or(comment.len()),
            comment if comment.starts_with("/*") => blank + block_length(comment),
            _ => return at + blank,
        };
    }
}

/// The length of the block comment at the start of `rest`; block comments nest.
fn block_length(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let (mut at, mut depth) = (0, 0usize);
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"/*" => (at, depth) = (at + 2, depth + 1),
            b"*/" => (at, depth) = (at + 2, depth - 1),
            _ => at += 1,
        }
        if depth == 0 {
            return at;
        }
    }
    rest.len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::position::Position;
    use proptest::prelude::*;

    const SCENE: &str = r#"// (
(
    title: "a, b: (",
    bodies: (Elastic(young: 1, /* , */ poisson: 0.3), Rigid),
    history: [
        Indent(to: "1 µm", over: 1),
        Impact(mass: 1, speed: [1, 2]),
        Table("h.csv"),
    ],
)"#;

    fn at(path: &str) -> &str {
        let rest = &SCENE[locate(SCENE, &[path])[0]..];
        &rest[..rest.find([',', '(', '\n', ')', ':']).unwrap_or(rest.len())]
    }

    #[test]
    fn a_path_leads_to_its_value() {
        assert_eq!(at("bodies.0"), "Elastic");
        assert_eq!(at("bodies.0.poisson"), "0.3");
        assert_eq!(at("bodies.1"), "Rigid");
        assert_eq!(at("history[0].over"), "1");
        assert_eq!(at("history[1].speed[1]"), "2]");
        assert_eq!(at("history[2]"), "Table");
        assert_eq!(at("history"), "[");
        assert_eq!(at(""), "");
    }

    #[test]
    fn a_path_that_is_not_there_stands_at_what_should_hold_it() {
        assert_eq!(at("bodies.0.shear.terms"), "Elastic");
        assert_eq!(at("history[1].angle"), "Impact");
        assert_eq!(locate(SCENE, &["adhesion"]), locate(SCENE, &[""]));
    }

    #[test]
    fn surroundings_name_the_field_and_the_open_bracket() {
        let offset = SCENE.find("1 µm").unwrap();
        let found = surroundings(SCENE, offset);
        assert_eq!(found.path, "history[0].to");
        assert_eq!(&SCENE[found.token..offset], "\"");
        assert_eq!(found.open.unwrap().0, '(');
        assert_eq!(surroundings(SCENE, SCENE.len()).open, None);
    }

    #[test]
    fn a_path_leads_to_its_value_in_json() {
        let text = r#"{"bodies": [{"Elastic": {"young": 1, "poisson": 0.3}}, "Rigid"],
            "history": [{"Indent": {"to": "1 µm"}}, {"Table": "h.csv"}]}"#;
        let at = |path: &str| &text[locate(text, &[path])[0]..];
        assert!(at("bodies.0.poisson").starts_with("0.3"));
        assert!(at("bodies.1").starts_with("\"Rigid"));
        assert!(at("history[0].to").starts_with("\"1 µm"));
        assert!(at("history[1]").starts_with("{\"Table"));
        assert_eq!(surroundings(text, text.find("µm").unwrap()).path, "history[0].to");
    }

    #[test]
    fn columns_count_characters() {
        let place = Position::of(SCENE, SCENE.find(", over").unwrap());
        assert_eq!(place, Position { line: 6, column: 26 });
        assert_eq!(place.offset(SCENE), SCENE.find(", over").unwrap());
    }

    proptest! {
        /// Arbitrary text is walked to its end, and every offset has its surroundings.
        #[test]
        fn any_text_is_walked(text in "[ -~\n\"/*(){}\\[\\],:µ]{0,80}", offset in 0usize..100) {
            let paths = ["history[0].to", "a", ""];
            prop_assert!(locate(&text, &paths).iter().all(|&at| text.get(at..).is_some()));
            prop_assert!(surroundings(&text, offset).token <= text.len());
            let place = Position::of(&text, offset);
            prop_assert_eq!(Position::of(&text, place.offset(&text)), place);
        }
    }
}
