//! From RON to a scene, and from a parser's error to a message a person can act on.

use super::TextError;
use super::mend::{self, Faulty, Mending, Wrong};
use super::names::{FIELDS, advice};
use super::position::Position;
use super::walk::{self, Surroundings};
use crate::scene::Scene;
use ron::error::{Error, SpannedError};
use ron::extensions::Extensions;
use std::marker::PhantomData;

/// Deepest nesting of brackets; a scene needs eight.
const DEEPEST: usize = 64;

/// The scene in `text`; single values are checked, whether they fit together is not.
///
/// # Errors
/// All faults of the text, up to and with the first of its notation.
pub fn scene(text: &str) -> Result<Scene, Faulty<Scene, TextError>> {
    let options = ron::Options::default()
        .with_default_extension(Extensions::IMPLICIT_SOME | Extensions::UNWRAP_VARIANT_NEWTYPES)
        .with_recursion_limit(DEEPEST);
    let read = |mending: &Mending| options.from_str_seed(text, mending.watch(PhantomData));
    let scene = mend::read_all(text.len(), read, |error| wrong(&error.code))
        .map_err(|faulty| faulty.told(|error| explained(text, error)))?;
    match no_power_law(text) {
        Some(fault) => Err(vec![fault].into()),
        None => Ok(scene),
    }
}

/// A series of terms under the name of a power law: RON reads the name before fields and forgets it.
fn no_power_law(text: &str) -> Option<TextError> {
    const NAME: &str = "PowerLaw";
    if !text.contains(NAME) {
        return None;
    }
    let values = walk::values(text);
    let named = values.iter().filter(|(path, token)| path.ends_with(".shear") && text[token.clone()] == *NAME);
    let mut empty = named.filter(|(path, _)| {
        let modulus = format!("{path}.modulus");
        values.iter().all(|(path, _)| *path != modulus)
    });
    empty.next().map(|(path, token)| {
        let right =
            "expected PowerLaw(modulus: …, exponent: …, time: …), or (equilibrium: …, terms: […]) without a name";
        TextError::at(text, token.start, format!("{path}: PowerLaw has no modulus: {right}"))
    })
}

fn explained(text: &str, error: &SpannedError) -> TextError {
    let (offset, message) = Stop::new(text, error).explained(&error.code);
    TextError::at(text, offset, message)
}

/// What an error is about.
fn wrong(code: &Error) -> Wrong {
    match code {
        Error::Message(_) | Error::InvalidValueForType { .. } | Error::NoSuchEnumVariant { .. } => Wrong::Value,
        // A field of the scene in a part of it: a bracket is missing.
        Error::NoSuchStructField { found, outer, .. } if names_another(found, outer.as_deref()) => Wrong::Notation,
        Error::NoSuchStructField { found, .. } => Wrong::UnknownField(found.clone()),
        Error::DuplicateStructField { field, .. } => Wrong::RepeatedField((*field).to_owned()),
        Error::MissingStructField { field, .. } => Wrong::MissingField((*field).to_owned()),
        _ => Wrong::Notation,
    }
}

/// The text around the place at which the parser stopped.
struct Stop<'t> {
    text: &'t str,
    /// Whether the parser ran into the end of the text.
    ended: bool,
    /// Byte offset of the place.
    at: usize,
    around: Surroundings,
}

impl<'t> Stop<'t> {
    fn new(text: &'t str, error: &SpannedError) -> Self {
        let offset = |place: ron::error::Position| Position { line: place.line, column: place.col }.offset(text);
        let mut at = offset(error.span.start);
        let next = text[at..].chars().next();
        if matches!(error.code, Error::InvalidValueForType { .. }) && next.is_none_or(|c| !walk::word(c)) {
            // The parser has stepped over a bare word such as `ten`.
            at -= text[..at].chars().next_back().filter(|&c| walk::word(c)).map_or(0, char::len_utf8);
        }
        let ended = text[offset(error.span.end)..].trim_start().is_empty();
        Self { text, ended, at, around: walk::surroundings(text, at) }
    }

    /// The token at the place.
    fn token(&self) -> &'t str {
        walk::token(self.text, self.around.token)
    }

    /// The token before the place.
    fn before(&self) -> &'t str {
        self.around.before.map_or("", |(start, end)| &self.text[start..end])
    }

    /// The rest of the line from the token on.
    fn rest(&self) -> &'t str {
        self.text[self.around.token..].lines().next().unwrap_or("")
    }

    fn explained(&self, code: &Error) -> (usize, String) {
        let message = match code {
            Error::Message(what) if self.token() == ")" => return self.wrong_whole(what),
            Error::Message(_) | Error::InvalidValueForType { .. } => self.wrong_value(code),
            Error::ExpectedStringEnd => "this text has no closing quote: expected `\"`".into(),
            Error::UnclosedBlockComment => return self.endless_comment(),
            Error::MissingStructField { field, outer } => return self.missing(field, outer.as_deref()),
            Error::ExceededRecursionLimit => format!("brackets are nested deeper than {DEEPEST}: expected a scene"),
            Error::Eof | Error::ExpectedComma if self.ended => return self.never_closed(),
            _ if self.token().is_empty() && self.around.open.is_some() => return self.never_closed(),
            _ => self.wrong_form(code),
        };
        (self.around.token, message)
    }

    fn endless_comment(&self) -> (usize, String) {
        (self.text.rfind("/*").unwrap_or(self.at), "this comment has no end: expected `*/`".into())
    }

    fn never_closed(&self) -> (usize, String) {
        let Some((open, at)) = walk::surroundings(self.text, self.text.len()).open else {
            return (self.at, "the text ends too early: expected a scene".into());
        };
        let close = match open {
            '(' => ')',
            '[' => ']',
            _ => '}',
        };
        (at, format!("the bracket `{open}` is never closed: expected `{close}` before the end of the file"))
    }

    /// The head of the bracket that is open, with its name.
    fn head(&self) -> usize {
        let open = self.around.open.map_or(self.at, |(_, at)| at);
        self.text[..open].trim_end_matches(walk::word).len()
    }

    /// Fields that are right one by one and make nothing together.
    fn wrong_whole(&self, what: &str) -> (usize, String) {
        let holder = self.around.path.rsplit_once('.').map_or("", |(holder, _)| holder);
        (self.head(), if holder.is_empty() { what.to_owned() } else { format!("{holder}: {what}") })
    }

    fn missing(&self, field: &str, holder: Option<&str>) -> (usize, String) {
        let head = self.head();
        let other = if (field, holder) == ("young", Some("Elastic")) { " or `shear: …`" } else { "" };
        (head, format!("{} lacks the field `{field}`: expected `{field}: …`{other}", holder.unwrap_or("this")))
    }

    /// A value that was read but is not right, with the path of its field.
    fn wrong_value(&self, code: &Error) -> String {
        let what = match code {
            Error::InvalidValueForType { expected, found } => {
                let least = match expected.as_str() {
                    "a nonzero usize" => Some("one above zero"),
                    "usize" | "u64" | "u32" => Some("one from 0"),
                    _ => None,
                };
                let number = self.token().parse().ok().filter(|_| self.token().parse::<u64>().is_err());
                if let Some((least, number)) = least.zip(number) {
                    return self.not_whole(number, least);
                }
                let some = if found.contains("optional") { "Some(…) is not needed: " } else { "" };
                let expected = least.map_or_else(|| expected.clone(), |one| one.replace("one", "a whole number"));
                format!("{some}`{}` cannot stand here: expected {expected}", self.token())
            }
            other => other.to_string(),
        };
        if self.around.path.is_empty() { what } else { format!("{}: {what}", self.around.path) }
    }

    /// A text whose form is not right.
    fn wrong_form(&self, code: &Error) -> String {
        self.wrong_name(code).or_else(|| self.wrong_number(code)).unwrap_or_else(|| self.wrong_bracket(code))
    }

    fn wrong_name(&self, code: &Error) -> Option<String> {
        let outer = |outer: &Option<String>| match outer.as_deref() {
            // A series of terms has no name before it, a power law has one.
            Some("PowerLaw") if !self.text[self.head()..].starts_with("PowerLaw") => "Shear".to_owned(),
            Some(outer) => outer.to_owned(),
            None => "this".to_owned(),
        };
        Some(match code {
            Error::NoSuchEnumVariant { expected, found, outer: kind } => {
                format!("unknown {} `{found}`: {}", kind_in_words(kind.as_deref()), advice(found, expected))
            }
            Error::NoSuchStructField { expected, found, outer: holder } => {
                let missing = names_another(found, holder.as_deref());
                let bracket = if missing { ", or is a closing bracket missing before it?" } else { "" };
                let holder = outer(holder);
                format!("{holder} has no field `{found}`: {}{bracket}", advice(found, expected))
            }
            Error::DuplicateStructField { field, outer: holder } => {
                format!("the field `{field}` of {} is given twice: expected it once", outer(holder))
            }
            Error::NoSuchExtension(name) => format!("unknown extension `{name}`: expected none"),
            _ => return None,
        })
    }

    fn wrong_number(&self, code: &Error) -> Option<String> {
        let (before, token) = (self.before(), self.token());
        let number = before.starts_with(|c: char| c.is_ascii_digit());
        Some(match code {
            Error::ExpectedFloat => format!("`{token}` is not a number: expected one such as 1.5 or 1e-6"),
            Error::ExpectedChar => "text stands in double quotes: expected \"…\"".into(),
            Error::ExpectedComma | Error::UnexpectedChar(_) if number && token == "/" => {
                "fractions are not computed: expected the number itself, such as 0.3333333333333333 for 1/3".into()
            }
            Error::ExpectedComma if number && matches!(token, "*" | "^") => {
                "arithmetic is not computed: expected the number itself, such as 1e3 for 10^3".into()
            }
            Error::ExpectedComma if number && token.starts_with(char::is_alphabetic) && !self.names_a_field() => {
                format!("a number with a unit stands in quotes: expected \"{before} {}\"", self.unit())
            }
            Error::ExpectedComma if token.starts_with(|c: char| c.is_ascii_digit()) => self.broken_number(token)?,
            _ => return None,
        })
    }

    /// A number that goes on where it should end.
    fn broken_number(&self, token: &str) -> Option<String> {
        let unit = token.find(|c: char| c.is_alphabetic())?;
        Some(format!("a number with a unit stands in quotes: expected \"{} {}\"", &token[..unit], &token[unit..]))
    }

    /// A `number` where a whole one should be, which `least` says.
    fn not_whole(&self, number: f64, least: &str) -> String {
        let whole = (number.fract() == 0.0 && (1.0..1e15).contains(&number)).then(|| format!("{number:.0}"));
        let (path, token, right) = (&self.around.path, self.token(), whole.as_deref().unwrap_or(least));
        format!("{path}: `{token}` is not a whole number: expected {right}")
    }

    /// Whether a colon follows the token, so that it is the name of the next field.
    fn names_a_field(&self) -> bool {
        self.rest()[self.token().len()..].trim_start().starts_with(':')
    }

    /// What looks like a unit: all up to the next comma or bracket.
    fn unit(&self) -> &'t str {
        let rest = self.rest();
        rest[..rest.find([',', ')', ']']).unwrap_or(rest.len())].trim_end()
    }

    fn wrong_bracket(&self, code: &Error) -> String {
        let found = if self.token().is_empty() { "the end of the file" } else { self.token() };
        let expected = match code {
            Error::ExpectedNamedStructLike(_) | Error::ExpectedDifferentStructName { .. } => return self.no_scene(),
            Error::TrailingCharacters => "nothing after the closing bracket of the scene",
            Error::ExpectedDifferentLength { .. } | Error::ExpectedStructLike if self.wants_bodies() => {
                "a pair of bodies such as (Elastic(young: \"210 GPa\", poisson: 0.3), Rigid)"
            }
            Error::ExpectedStructLike => return self.no_fields(found),
            Error::ExpectedStructLikeEnd if self.in_bodies() => "`)`: there are two bodies, and Rigid has no fields",
            Error::ExpectedStructLikeEnd => "`)`",
            Error::ExpectedArray => "a list in square brackets, […]",
            Error::ExpectedString => "text in double quotes, \"…\"",
            Error::ExpectedMapColon => {
                return format!("`{}` needs a value: expected `{0}: …`, found `{found}`", self.before());
            }
            Error::ExpectedComma => "a comma or a closing bracket",
            Error::InvalidEscape(_) => return "unknown escape in the text: expected `\\\\` for a backslash".into(),
            Error::SuggestRawIdentifier(_) | Error::InvalidIdentifier(_) | Error::ExpectedIdentifier => {
                return self.no_name(found);
            }
            Error::UnexpectedChar(_) => "a value",
            other => return format!("{other}: expected a scene in the notation of RON"),
        };
        format!("found `{found}`: expected {expected}")
    }

    fn wants_bodies(&self) -> bool {
        self.in_bodies() && !self.before().starts_with(char::is_alphabetic)
    }

    fn in_bodies(&self) -> bool {
        self.around.path.starts_with("bodies") && !self.around.path.contains("shear")
    }

    /// Something else where a scene should be, or a part of it with fields of its own.
    fn no_scene(&self) -> String {
        if let Some(field) = self.around.path.rsplit('.').next().filter(|field| !field.is_empty()) {
            let (path, found) = (&self.around.path, self.token());
            return format!("{path}: found `{found}`: expected fields in round brackets, {field}: (…)");
        }
        let found = match self.token() {
            "" => "there is no scene in the file".to_owned(),
            token => format!("found `{token}`"),
        };
        format!("{found}: expected (shape: …, bodies: (…), history: […])")
    }

    fn no_fields(&self, found: &str) -> String {
        let before = self.before();
        if before.starts_with(char::is_alphabetic) {
            return format!("`{before}` needs its fields in round brackets: expected {before}(…), found `{found}`");
        }
        format!("found `{found}`: expected `(`")
    }

    /// Something else where a name should be.
    fn no_name(&self, found: &str) -> String {
        let decimals = found.chars().all(|c| c.is_ascii_digit()) && self.before() == ",";
        if decimals && self.around.path.is_empty() {
            return format!("found `{found}`: expected a field such as `title: …`");
        }
        match found.chars().next() {
            Some('0'..='9') if decimals => {
                format!("found `{found}`: expected a field; a decimal number has a point, as in 1.5")
            }
            Some('"') => format!("found {found}: names stand without quotes, expected {}", found.trim_matches('"')),
            Some('#' | '%' | ';') => format!("found `{found}`: expected a name; a comment begins with //"),
            _ => format!("found `{found}`: expected a name, such as that of a field: `name: …`"),
        }
    }
}

/// Whether `found` is a field of the scene that stands in another part, `holder`.
fn names_another(found: &str, holder: Option<&str>) -> bool {
    holder != Some("Scene") && FIELDS.contains(&found)
}

fn kind_in_words(kind: Option<&str>) -> String {
    match kind {
        Some("Entry") => "history entry".into(),
        Some(kind) => kind.to_lowercase(),
        None => "name".into(),
    }
}
