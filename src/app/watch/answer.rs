//! What a request is answered.

use super::bench::{Bench, Set, Stale};
use super::guard::{Asked, Guard};
use crate::app::console::Console;
use crate::app::write::write_all;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::io::{Read, Write};
use std::path::Path;
use std::time::Duration;
use tiny_http::{Method, Request, StatusCode};

/// Longest wait of a page; it then asks again.
const PATIENCE: Duration = Duration::from_secs(20);
/// Largest request in bytes.
const LARGEST: u64 = 1 << 16;

/// What every answer says: nothing is loaded from elsewhere, kept, or shown inside another page.
const HEADERS: [(&str, &str); 5] = [
    (
        "Content-Security-Policy",
        "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; \
         base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    ),
    ("X-Content-Type-Options", "nosniff"),
    ("Referrer-Policy", "no-referrer"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
    ("Cache-Control", "no-store"),
];

/// Status of an answer without content.
const NOTHING_NEW: u16 = 204;

/// Status, kind and content.
struct Reply(u16, &'static str, String);

impl Reply {
    fn text(status: u16, words: impl ToString) -> Self {
        Self(status, "text/plain", words.to_string())
    }

    /// The answer as it is sent, without its content to who asks for the head only.
    fn written(&self, method: &Method) -> Vec<u8> {
        let Self(status, kind, content) = self;
        let own = [("Content-Type", format!("{kind}; charset=utf-8")), ("Content-Length", content.len().to_string())];
        let own = own.iter().filter(|_| *status != NOTHING_NEW).map(|(name, value)| (*name, value.as_str()));
        let all = HEADERS.into_iter().chain(own);
        let headers: String = all.map(|(name, value)| format!("{name}: {value}\r\n")).collect();
        let content = if *method == Method::Head { "" } else { content };
        let words = StatusCode(*status).default_reason_phrase();
        format!("HTTP/1.1 {status} {words}\r\n{headers}\r\n{content}").into_bytes()
    }
}

/// Numbers set on the page.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Numbers {
    revision: u64,
    values: Set,
}

/// The wish to write into the file, which is named so that nobody does it by mistake.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Saving {
    revision: u64,
    over: String,
}

/// What a page has drawn, and how many milliseconds after the file was saved if it was open then.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SeenBy {
    version: u64,
    milliseconds: Option<f64>,
    width: f64,
}

/// Answers a request.
pub fn answer(mut request: Request, guard: &Guard, bench: &Bench, console: &Console) {
    let reply = match guard.asked(&request) {
        Ok(asked) => replied(asked, &mut request, bench, console).unwrap_or_else(|refused| refused),
        Err((status, words)) => Reply::text(status, words),
    };
    let bytes = reply.written(request.method());
    // Head and content in one piece: a system that waits for more to send would add 40 ms to each. A page that has
    // been closed needs no answer.
    let mut writer = request.into_writer();
    let _ = writer.write_all(&bytes).and_then(|()| writer.flush());
}

fn replied(asked: Asked, request: &mut Request, bench: &Bench, console: &Console) -> Result<Reply, Reply> {
    let stale = |stale: Stale| Reply::text(409, stale);
    match asked {
        Asked::Page => Ok(Reply(200, "text/html", include_str!("page.html").to_owned())),
        Asked::Script => Ok(Reply(200, "text/javascript", include_str!("page.js").to_owned())),
        Asked::Style => Ok(Reply(200, "text/css", include_str!("page.css").to_owned())),
        Asked::State(after) => Ok(match bench.newer(after, PATIENCE) {
            Some(view) => Reply(200, "application/json", view),
            None => Reply::text(NOTHING_NEW, ""),
        }),
        Asked::Set => {
            let Numbers { revision, values } = sent(request)?;
            bench.set(revision, values).map_err(stale)?;
            Ok(Reply::text(NOTHING_NEW, ""))
        }
        Asked::Save => {
            let Saving { revision, over } = sent(request)?;
            save(bench, revision, &over)
        }
        Asked::Seen => {
            let SeenBy { version, milliseconds, width } = sent(request)?;
            let after = milliseconds.map(|milliseconds| format!(": {milliseconds:.0} ms after the save"));
            console.message(&format!("  drawing {version}, {width:.0} px wide{}", after.unwrap_or_default()));
            Ok(Reply::text(NOTHING_NEW, ""))
        }
    }
}

/// The JSON in the body of a request.
fn sent<T: DeserializeOwned>(request: &mut Request) -> Result<T, Reply> {
    if request.body_length().is_none_or(|length| length as u64 > LARGEST) {
        return Err(Reply::text(413, "too long"));
    }
    let mut body = String::new();
    let read = request.as_reader().take(LARGEST).read_to_string(&mut body);
    read.map_err(|error| Reply::text(400, error))?;
    serde_json::from_str(&body).map_err(|error| Reply::text(400, error))
}

/// Writes the text with the numbers of its sliders into the file, if that holds what the page has seen.
fn save(bench: &Bench, revision: u64, over: &str) -> Result<Reply, Reply> {
    let (before, after) = bench.texts(revision).map_err(|stale| Reply::text(409, stale))?;
    let path = bench.path.canonicalize().map_err(|error| Reply::text(409, error))?;
    let name = bench.path.file_name().unwrap_or_default().to_string_lossy();
    if over != name {
        return Err(Reply::text(400, format!("{over} is not the scene: expected {name}")));
    }
    let held = std::fs::read_to_string(&path).unwrap_or_default();
    if held.trim_start_matches('\u{feff}') != before {
        return Err(Reply::text(409, Stale::Changed));
    }
    let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let rights = std::fs::metadata(&path).map(|told| told.permissions());
    let folder = path.parent().unwrap_or_else(|| Path::new("."));
    write_all(folder, &[(file, after.as_bytes())]).map_err(|error| Reply::text(500, error))?;
    // The new file has the rights of the old one where the system lets it.
    let _ = rights.and_then(|rights| std::fs::set_permissions(&path, rights));
    Ok(Reply::text(NOTHING_NEW, ""))
}
