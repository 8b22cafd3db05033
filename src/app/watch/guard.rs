//! Who is answered: pages of this server on this machine, and nobody else.
//!
//! A page of another host can send requests here, and by a name that leads to 127.0.0.1 even read the answers; both
//! show in the headers `Host` and `Origin`. Other users of the machine do not know the key in the address.

use tiny_http::{Header, Method, Request};

/// What is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// The page.
    Page,
    /// Its script.
    Script,
    /// Its looks.
    Style,
    /// What is to be seen, if it is newer than this.
    State(u64),
    /// Other numbers in the scene.
    Set,
    /// The text with these numbers written into the file.
    Save,
    /// A page says when it has drawn.
    Seen,
}

/// Why a request is refused: status and words.
pub type Refusal = (u16, &'static str);

/// The address of the page.
#[derive(Debug)]
pub struct Guard {
    hosts: [String; 2],
    key: String,
}

impl Guard {
    /// The guard of a port.
    #[must_use]
    pub fn new(port: u16, key: String) -> Self {
        Self { hosts: [format!("127.0.0.1:{port}"), format!("localhost:{port}")], key }
    }

    /// The address of the page.
    #[must_use]
    pub fn address(&self) -> String {
        format!("http://{}/{}/", self.hosts[0], self.key)
    }

    /// What a request asks for.
    ///
    /// # Errors
    /// It comes from elsewhere, or asks for what is not there.
    pub fn asked(&self, request: &Request) -> Result<Asked, Refusal> {
        self.is_own(request.headers())?;
        let (path, query) = request.url().split_once('?').unwrap_or((request.url(), ""));
        let name = path.strip_prefix('/').and_then(|path| path.strip_prefix(&self.key)?.strip_prefix('/'));
        let known = match name.ok_or(NOTHING)? {
            "" => Asked::Page,
            "page.js" => Asked::Script,
            "page.css" => Asked::Style,
            "state" => Asked::State(query.strip_prefix("after=").and_then(|n| n.parse().ok()).unwrap_or(0)),
            "set" => Asked::Set,
            "save" => Asked::Save,
            "seen" => Asked::Seen,
            _ => return Err(NOTHING),
        };
        let posted = matches!(known, Asked::Set | Asked::Save | Asked::Seen);
        let wanted = if posted { Method::Post } else { Method::Get };
        if *request.method() != wanted {
            return Err((405, "another method is expected"));
        }
        // Of another origin, a form cannot send this, and a script has to ask first.
        let json = values(request.headers(), "Content-Type").any(|kind| kind.starts_with("application/json"));
        if posted && !json { Err((415, "JSON is expected")) } else { Ok(known) }
    }

    fn is_own(&self, headers: &[Header]) -> Result<(), Refusal> {
        let mut hosts = values(headers, "Host");
        let host = hosts.next().is_some_and(|host| self.hosts.iter().any(|own| own == host)) && hosts.next().is_none();
        let origin = |origin: &str| self.hosts.iter().any(|own| origin.strip_prefix("http://") == Some(own));
        let site = |site: &str| matches!(site, "same-origin" | "none");
        if host && values(headers, "Origin").all(origin) && values(headers, "Sec-Fetch-Site").all(site) {
            Ok(())
        } else {
            Err((403, "only pages of this server are answered"))
        }
    }
}

const NOTHING: Refusal = (404, "there is nothing here");

/// The values of all headers of a name.
fn values<'h>(headers: &'h [Header], name: &'static str) -> impl Iterator<Item = &'h str> {
    headers.iter().filter(move |header| header.field.equiv(name)).map(|header| header.value.as_str())
}
