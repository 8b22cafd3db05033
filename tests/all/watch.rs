//! The page that follows a scene, spoken to over its port and looked at in a browser.

use super::devtools::{Shown, wait_for};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

const SCENE: &str = r#"// ours
(title: "gel <b>", shape: Paraboloid(radius: "10 mm"), // a lens
    bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid), history: [Indent(to: "1 um", over: 1)])
"#;

/// A program that runs, ended when the test is.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A page served for a scene of its own.
struct Page {
    _program: Running,
    folder: tempfile::TempDir,
    address: String,
    host: String,
    path: String,
    said: Receiver<String>,
}

struct Answer {
    status: u16,
    head: String,
    body: String,
}

impl Page {
    fn open() -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("lens.ron"), SCENE).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
        command.current_dir(folder.path()).args(["watch", "lens.ron"]).stdin(Stdio::null());
        let mut program = Running(command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap());
        let mut address = String::new();
        BufReader::new(program.0.stdout.take().unwrap()).read_line(&mut address).unwrap();
        let address = address.trim().to_owned();
        let (host, path) = address.strip_prefix("http://").unwrap().split_once('/').unwrap();
        let (host, path) = (host.to_owned(), format!("/{path}"));
        let (sender, said) = channel();
        let lines = BufReader::new(program.0.stderr.take().unwrap()).lines();
        std::thread::spawn(move || lines.map_while(Result::ok).all(|line| sender.send(line).is_ok()));
        Self { _program: program, folder, address, host, path, said }
    }

    fn scene(&self) -> PathBuf {
        self.folder.path().join("lens.ron")
    }

    fn ask(&self, first: &str, headers: &[(&str, &str)], body: &str) -> Answer {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        let headers: String = headers.iter().map(|(name, value)| format!("{name}: {value}\r\n")).collect();
        let length = body.len();
        let sent = format!("{first} HTTP/1.1\r\nConnection: close\r\nContent-Length: {length}\r\n{headers}\r\n{body}");
        stream.write_all(sent.as_bytes()).unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let answer = String::from_utf8(answer).unwrap();
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        Answer { status, head: head.to_owned(), body: body.to_owned() }
    }

    fn get(&self, name: &str) -> Answer {
        self.ask(&format!("GET {}{name}", self.path), &[("Host", &self.host)], "")
    }

    fn post(&self, name: &str, body: &Value) -> Answer {
        let headers = [("Host", self.host.as_str()), ("Content-Type", "application/json")];
        self.ask(&format!("POST {}{name}", self.path), &headers, &body.to_string())
    }

    /// What is seen once nothing is computed any more that is newer than `after`.
    fn seen(&self, after: u64) -> Value {
        let mut after = after;
        loop {
            let answer = self.get(&format!("state?after={after}"));
            assert_eq!(answer.status, 200, "{}", answer.body);
            let view: Value = serde_json::from_str(&answer.body).unwrap();
            after = view["version"].as_u64().unwrap();
            if view["busy"] == json!(false) {
                return view;
            }
        }
    }
}

#[test]
fn only_own_pages_are_answered() {
    let page = Page::open();
    assert_eq!(page.get("").status, 200);
    let port = page.host.split_once(':').unwrap().1.to_owned();
    let get = |path: &str, headers: &[(&str, &str)]| page.ask(&format!("GET {path}"), headers, "").status;
    let (own, localhost) = (page.host.as_str(), format!("localhost:{port}"));
    assert_eq!(get(&page.path, &[("Host", &localhost)]), 200);
    for (name, host) in [("a name that leads here", format!("evil.example:{port}")), ("no port", "127.0.0.1".into())] {
        assert_eq!(get(&page.path, &[("Host", &host)]), 403, "{name}");
    }
    assert_eq!(get(&page.path, &[]), 403);
    assert_eq!(get(&page.path, &[("Host", own), ("Host", "evil.example")]), 403);
    for origin in ["http://evil.example", "null", &format!("https://{own}"), &format!("http://{own}.evil.example")] {
        assert_eq!(get(&page.path, &[("Host", own), ("Origin", origin)]), 403, "{origin}");
    }
    assert_eq!(get(&page.path, &[("Host", own), ("Origin", &format!("http://{own}"))]), 200);
    assert_eq!(get(&page.path, &[("Host", own), ("Sec-Fetch-Site", "cross-site")]), 403);
    // Who does not know the key finds nothing, nor does who asks for a file.
    for path in ["/", "/state", "/0123456789abcdef0123456789abcdef/", &format!("{}../lens.ron", page.path)] {
        assert_eq!(get(path, &[("Host", own)]), 404, "{path}");
    }
}

#[test]
fn what_is_no_question_of_the_page_is_refused() {
    let page = Page::open();
    // Before the first scene is read no revision is the present one.
    page.seen(0);
    let host = [("Host", page.host.as_str())];
    for method in ["PUT", "DELETE", "OPTIONS", "HEAD", "POST"] {
        assert_eq!(page.ask(&format!("{method} {}", page.path), &host, "").status, 405, "{method}");
    }
    assert_eq!(page.get("set").status, 405);
    // A form of another page can send text, but no JSON.
    assert_eq!(page.ask(&format!("POST {}set", page.path), &host, "{}").status, 415);
    assert_eq!(page.post("set", &json!({"revision": 1})).status, 400);
    assert_eq!(page.post("set", &json!({"revision": 1, "values": [["x".repeat(1 << 17), 1.0]]})).status, 413);
    assert_eq!(page.post("save", &json!({"revision": 1, "over": "/etc/passwd"})).status, 400);
    // Nothing is loaded from elsewhere, and no other page may show this one.
    let answer = page.get("");
    let head = answer.head.to_lowercase();
    assert!(head.contains("default-src 'none'") && head.contains("frame-ancestors 'none'"), "{head}");
    let all = [answer.body, page.get("page.js").body, page.get("page.css").body].concat();
    for elsewhere in ["http:", "https:", "//cdn", "@import", "url("] {
        assert!(!all.contains(elsewhere), "{elsewhere}");
    }
}

#[test]
fn a_saved_scene_is_drawn_and_a_wrong_one_told_with_its_place() {
    let page = Page::open();
    let first = page.seen(0);
    assert_eq!((&first["drawn"]["title"], &first["drawn"]["faults"]), (&json!("gel <b>"), &json!([])));
    let figure = first["drawn"]["figures"][0].as_str().unwrap();
    assert!(figure.starts_with("<svg") && figure.contains("gel &lt;b&gt;") && !figure.contains("gel <b>"));
    assert!(first["drawn"]["results"].as_array().unwrap().iter().any(|row| row[0] == "largest force"));
    // By an editor that puts a new file in the place of the old one.
    let beside = page.folder.path().join("lens.ron~");
    std::fs::write(&beside, SCENE.replace("1 MPa", "2 kg")).unwrap();
    std::fs::rename(&beside, page.scene()).unwrap();
    let wrong = page.seen(first["version"].as_u64().unwrap());
    let fault = &wrong["drawn"]["faults"][0];
    assert_eq!((&fault["line"], &fault["column"], &fault["file"]), (&json!(3), &json!(29), &json!("lens.ron")));
    assert!(fault["message"].as_str().unwrap().contains("expected a pressure"), "{fault}");
    std::fs::write(page.scene(), SCENE.replace("1 MPa", "2 MPa")).unwrap();
    let right = page.seen(wrong["version"].as_u64().unwrap());
    assert_eq!(right["drawn"]["faults"], json!([]));
    assert_ne!(right["drawn"]["figures"], first["drawn"]["figures"]);
    // A file that is gone is told too, and one that is there again is drawn.
    std::fs::remove_file(page.scene()).unwrap();
    let gone = page.seen(right["version"].as_u64().unwrap());
    assert!(gone["drawn"]["faults"][0]["message"].as_str().unwrap().contains("no such file"), "{gone}");
    std::fs::write(page.scene(), SCENE).unwrap();
    let back = page.seen(gone["version"].as_u64().unwrap());
    assert_eq!(back["drawn"]["figures"], first["drawn"]["figures"]);
}

#[test]
fn numbers_are_put_in_and_the_file_stays_until_it_is_asked_for() {
    let page = Page::open();
    let first = page.seen(0);
    let version = |view: &Value| view["version"].as_u64().unwrap();
    let paths: Vec<&str> =
        first["sliders"].as_array().unwrap().iter().map(|slider| slider["path"].as_str().unwrap()).collect();
    let right = ["shape.radius", "bodies.0.young", "bodies.0.poisson", "history[0].to", "history[0].over"];
    assert_eq!(paths, right);
    let set = json!({"revision": first["revision"], "values": [["bodies.0.young", 3.5], ["history[0].to", 2]]});
    assert_eq!(page.post("set", &set).status, 204);
    let moved = page.seen(version(&first));
    let text = SCENE.replace("1 MPa", "3.5 MPa").replace("1 um", "2 um");
    assert_eq!(moved["text"], json!(text));
    assert_ne!(moved["drawn"]["results"], first["drawn"]["results"]);
    assert_eq!(std::fs::read_to_string(page.scene()).unwrap(), SCENE);
    // What the page shows is what the text gives.
    let saving = json!({"revision": moved["revision"], "over": "lens.ron"});
    assert_eq!(page.post("save", &saving).status, 204);
    assert_eq!(std::fs::read_to_string(page.scene()).unwrap(), text);
    let saved = page.seen(version(&moved));
    assert_eq!((&saved["drawn"]["results"], &saved["set"]), (&moved["drawn"]["results"], &json!([])));
    // Numbers for a file that has changed since are not put into the new one.
    assert_eq!(page.post("set", &set).status, 409);
    assert_eq!(page.post("save", &saving).status, 409);
    // A number that cannot stand there is told with its place.
    let set = json!({"revision": saved["revision"], "values": [["bodies.0.poisson", 0.7]]});
    assert_eq!(page.post("set", &set).status, 204);
    let fault = page.seen(version(&saved))["drawn"]["faults"][0].clone();
    assert_eq!(fault["line"], json!(3), "{fault}");
}

/// A scene that takes minutes is in nobody's way.
#[test]
fn the_newest_wins_over_what_takes_long() {
    let page = Page::open();
    let first = page.seen(0);
    let slow = SCENE.replace("history:", "springs: 2000000, steps: 2000, history:");
    std::fs::write(page.scene(), slow).unwrap();
    let answer = page.get(&format!("state?after={}", first["version"]));
    let busy: Value = serde_json::from_str(&answer.body).unwrap();
    assert_eq!(busy["busy"], json!(true));
    let from = Instant::now();
    std::fs::write(page.scene(), SCENE.replace("1 MPa", "2 MPa")).unwrap();
    let next = page.seen(busy["version"].as_u64().unwrap());
    assert!(next["text"].as_str().unwrap().contains("2 MPa") && next["drawn"]["faults"] == json!([]));
    assert!(from.elapsed() < Duration::from_secs(20), "{:?}", from.elapsed());
}

#[test]
fn a_scene_that_is_not_there_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["none.ron", "-", "."] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_springbed"));
        let output = command.current_dir(folder.path()).args(["watch", name]).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{name}");
    }
}

fn browser() -> Option<PathBuf> {
    let names = ["chromium", "chromium-browser", "google-chrome"];
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|path| path.is_file())
}

fn chromium(browser: &Path, profile: &Path, address: &str) -> Running {
    let mut command = Command::new(browser);
    command.args([
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--remote-debugging-port=0",
    ]);
    command.arg(format!("--user-data-dir={}", profile.display())).arg(address);
    Running(command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap())
}

/// In a browser the figure is drawn, and drawn again when the file is saved.
#[test]
fn a_browser_draws_what_is_saved() {
    let Some(browser) = browser() else {
        println!("skipped: no Chromium is installed");
        return;
    };
    let page = Page::open();
    let profile = tempfile::tempdir().unwrap();
    let _browser = chromium(&browser, profile.path(), &page.address);
    let drawn = || -> (f64, Option<f64>) {
        let mut lines = std::iter::from_fn(|| page.said.recv_timeout(Duration::from_secs(60)).ok());
        let line = lines.find(|line| line.contains("drawing ")).unwrap();
        let words: Vec<&str> = line.split_whitespace().collect();
        (words[2].parse().unwrap(), words.get(5).map(|after| after.parse().unwrap()))
    };
    assert!(drawn().0 > 100.0);
    for young in ["2 MPa", "3 MPa"] {
        std::fs::write(page.scene(), SCENE.replace("1 MPa", young)).unwrap();
        let (width, after) = drawn();
        assert!(
            width > 100.0 && after.is_some_and(|after| (0.0..30_000.0).contains(&after)),
            "{width} px, {after:?} ms"
        );
    }
}

/// A number typed into the page and a click write it into the file, comments and units as they were, if one says so.
#[test]
fn a_click_in_a_browser_writes_into_the_file() {
    let Some(browser) = browser() else {
        println!("skipped: no Chromium is installed");
        return;
    };
    let page = Page::open();
    let profile = tempfile::tempdir().unwrap();
    let _browser = chromium(&browser, profile.path(), &page.address);
    let mut shown = Shown::of(profile.path(), &page.address);
    let field = r#"document.querySelector('[aria-label^="bodies.0.young"]')"#;
    wait_for("field on the page", || (shown.value(&format!("{field} !== null")) == json!(true)).then_some(()));
    let typed = format!("{field}.value = '2,5'; {field}.dispatchEvent(new Event('input')); true");
    assert_eq!(shown.value(&typed), json!(true));
    let can_write = "!document.getElementById('write').disabled";
    wait_for("button to write", || (shown.value(can_write) == json!(true)).then_some(()));
    // Who says no has the file as it was.
    let click = "document.getElementById('write').click()";
    shown.value(&format!("window.confirm = () => false; {click}"));
    assert_eq!(std::fs::read_to_string(page.scene()).unwrap(), SCENE);
    shown.value(&format!("window.confirm = () => true; {click}"));
    let text = SCENE.replace("1 MPa", "2.5 MPa");
    wait_for("file with the number", || (std::fs::read_to_string(page.scene()).unwrap() == text).then_some(()));
}
