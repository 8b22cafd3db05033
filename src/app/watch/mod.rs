//! A page on this machine that follows a scene: it is drawn anew when the file is saved or a slider is moved.
//!
//! `follow` looks at the file, `Bench` holds what is to be seen and has it computed, `guard` says who is answered,
//! and `answer` what. A page asks `state?after=N` and is answered as soon as there is something newer than N.

mod answer;
mod bench;
mod drawing;
mod follow;
mod guard;

use super::console::{Console, Failure};
use bench::Bench;
use guard::Guard;
use std::collections::hash_map::RandomState;
use std::hash::{BuildHasher, Hasher};
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::path::Path;
use std::sync::Arc;
use tiny_http::Server;

/// Serves the page of the scene at `path` on the loopback address, on `port` or, if that is 0, on a free one, until
/// the program is stopped.
///
/// # Errors
/// The port is taken.
pub fn serve(path: &Path, port: u16, console: &Console) -> Result<(), Failure> {
    let unavailable = |error: std::io::Error| Failure::Failed(format!("port {port} of 127.0.0.1: {error}"));
    let listener = TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port))).map_err(unavailable)?;
    let port = listener.local_addr().map_err(unavailable)?.port();
    let server = Server::from_listener(listener, None).map_err(Failure::failed)?;
    let guard = Arc::new(Guard::new(port, key()));
    let bench = Bench::of(path);
    let follower = bench.clone();
    std::thread::spawn(move || follow::follow(&follower));
    console.result(&guard.address())?;
    console.message(&format!("  follows {}; Ctrl-C ends it", path.display()));
    for request in server.incoming_requests() {
        let (bench, guard, console) = (bench.clone(), guard.clone(), *console);
        // A page that waits for something newer holds its thread.
        std::thread::spawn(move || answer::answer(request, &guard, &bench, &console));
    }
    Ok(())
}

/// A word nobody else on this machine can guess: the keys of hash maps are drawn by the system.
fn key() -> String {
    (0..2).map(|_| format!("{:016x}", RandomState::new().build_hasher().finish())).collect()
}
