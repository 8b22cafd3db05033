//! Hands in a browser: what a page is told to do over the port that Chromium opens for it (Chrome DevTools Protocol over
//! WebSocket, RFC 6455).

use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::time::{Duration, Instant};

/// Time after which a browser is given up.
const PATIENCE: Duration = Duration::from_secs(60);

/// What `look` finds, as soon as it finds something.
pub fn wait_for<T>(what: &str, mut look: impl FnMut() -> Option<T>) -> T {
    let begin = Instant::now();
    loop {
        if let Some(found) = look() {
            return found;
        }
        assert!(begin.elapsed() < PATIENCE, "no {what} after {PATIENCE:?}");
        std::thread::sleep(Duration::from_millis(50));
    }
}

/// The page that a browser shows.
pub struct Shown {
    stream: TcpStream,
    number: u64,
}

impl Shown {
    /// The page at `address` in the browser that runs with a profile.
    pub fn of(profile: &Path, address: &str) -> Self {
        let host = wait_for("port of the browser", || {
            let text = std::fs::read_to_string(profile.join("DevToolsActivePort")).ok()?;
            text.lines().next().map(|port| format!("127.0.0.1:{port}"))
        });
        let path = wait_for("page in the browser", || {
            let pages: Value = serde_json::from_str(&get(&host, "/json")?).ok()?;
            let page = pages.as_array()?.iter().find(|page| page["url"].as_str() == Some(address))?;
            page["webSocketDebuggerUrl"].as_str()?.split_once(&host).map(|(_, path)| path.to_owned())
        });
        let mut stream = TcpStream::connect(&host).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        let asked = format!(
            "GET {path} HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\
             Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
        );
        stream.write_all(asked.as_bytes()).unwrap();
        let mut head = Vec::new();
        while !head.ends_with(b"\r\n\r\n") {
            head.push(bytes::<1>(&mut stream)[0]);
        }
        assert!(head.starts_with(b"HTTP/1.1 101"), "{}", String::from_utf8_lossy(&head));
        Self { stream, number: 0 }
    }

    /// The value of an expression of the page.
    pub fn value(&mut self, expression: &str) -> Value {
        self.number += 1;
        let parameters = json!({"expression": expression, "returnByValue": true, "awaitPromise": true});
        let asked = json!({"id": self.number, "method": "Runtime.evaluate", "params": parameters});
        self.send(&asked.to_string());
        loop {
            let answer: Value = serde_json::from_slice(&self.frame()).unwrap();
            if answer["id"] == json!(self.number) {
                return answer["result"]["result"]["value"].clone();
            }
        }
    }

    /// A frame of text, masked by zeros.
    fn send(&mut self, text: &str) {
        let length = u16::try_from(text.len()).unwrap();
        let mut frame = vec![0x81, 0x80 | 126];
        frame.extend(length.to_be_bytes());
        frame.extend([0; 4]);
        frame.extend(text.as_bytes());
        self.stream.write_all(&frame).unwrap();
    }

    /// What a frame of the browser holds.
    fn frame(&mut self) -> Vec<u8> {
        let [_, short] = bytes::<2>(&mut self.stream);
        let length = match short {
            126 => u64::from(u16::from_be_bytes(bytes(&mut self.stream))),
            127 => u64::from_be_bytes(bytes(&mut self.stream)),
            short => u64::from(short),
        };
        let mut held = vec![0; usize::try_from(length).unwrap()];
        self.stream.read_exact(&mut held).unwrap();
        held
    }
}

fn bytes<const N: usize>(stream: &mut TcpStream) -> [u8; N] {
    let mut read = [0; N];
    stream.read_exact(&mut read).unwrap();
    read
}

/// The body of an answer.
fn get(host: &str, path: &str) -> Option<String> {
    let mut stream = TcpStream::connect(host).ok()?;
    stream.set_read_timeout(Some(Duration::from_secs(5))).ok()?;
    stream.write_all(format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").as_bytes()).ok()?;
    let mut answer = Vec::new();
    // A browser may keep the connection open behind its answer.
    let _ended = stream.read_to_end(&mut answer);
    String::from_utf8(answer).ok()?.split_once("\r\n\r\n").map(|(_, body)| body.to_owned())
}
