//! Files, read within bounds: size, kind and encoding.

use super::fault::Fault;
use crate::text::Position;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// The text of the file at `path` without its byte order mark, if it has at most `largest` bytes.
///
/// # Errors
/// The file is missing, a directory, too large, or not UTF-8.
pub fn read_text(path: &Path, largest: u64) -> Result<String, Fault> {
    text_of(path, read_bytes(path, largest)?)
}

/// The text of standard input, called `-`, if it has at most `largest` bytes.
///
/// # Errors
/// It cannot be read, is too large, or not UTF-8.
pub fn read_stdin(largest: u64) -> Result<String, Fault> {
    let (path, mut bytes) = (Path::new("-"), Vec::new());
    let read = io::stdin().lock().take(largest + 1).read_to_end(&mut bytes);
    read.map_err(|error| Fault::whole(path, unreadable(&error)))?;
    if bytes.len() as u64 > largest { Err(too_large(path, largest)) } else { text_of(path, bytes) }
}

fn text_of(path: &Path, bytes: Vec<u8>) -> Result<String, Fault> {
    let mut text = String::from_utf8(bytes).map_err(|error| not_utf8(path, &error))?;
    if text.starts_with('\u{feff}') {
        text.drain(..'\u{feff}'.len_utf8());
    }
    Ok(text)
}

/// The bytes of the file at `path`, if it has at most `largest`.
///
/// # Errors
/// The file is missing, a directory or too large.
pub fn read_bytes(path: &Path, largest: u64) -> Result<Vec<u8>, Fault> {
    let fault = |error: io::Error| Fault::whole(path, unreadable(&error));
    let metadata = std::fs::metadata(path).map_err(fault)?;
    if metadata.is_dir() {
        return Err(Fault::whole(path, "is a directory: expected a file"));
    }
    if metadata.len() > largest {
        return Err(too_large(path, largest));
    }
    let mut bytes = Vec::new();
    // The length of a pipe or device is not known before it is read.
    File::open(path).and_then(|file| file.take(largest + 1).read_to_end(&mut bytes)).map_err(fault)?;
    if bytes.len() as u64 > largest { Err(too_large(path, largest)) } else { Ok(bytes) }
}

/// The finite number in a cell of a table.
///
/// # Errors
/// The cell holds none; the message ends with what is `expected`.
pub fn number(cell: &str, expected: &str) -> Result<f64, String> {
    match cell.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(format!("\"{cell}\" is not finite: expected {expected}")),
        Err(_) if cell.is_empty() => Err(format!("is empty: expected {expected}")),
        Err(_) => {
            let cell: String = cell.chars().take(40).collect();
            Err(format!("\"{cell}\" is not a number: expected {expected} such as 1.5e-6"))
        }
    }
}

fn unreadable(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        io::ErrorKind::PermissionDenied => "may not be read: permission denied".to_owned(),
        _ => format!("cannot be read: {error}"),
    }
}

fn too_large(path: &Path, largest: u64) -> Fault {
    Fault::whole(path, format!("is too large: expected at most {} MiB", largest >> 20))
}

/// Names the first byte that is not UTF-8, with its line and column.
fn not_utf8(path: &Path, error: &std::string::FromUtf8Error) -> Fault {
    let at = error.utf8_error().valid_up_to();
    let bytes = error.as_bytes();
    let before = String::from_utf8_lossy(&bytes[..at]);
    let hint = match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => "the file looks like UTF-16; save it as UTF-8",
        _ => "save the file as UTF-8",
    };
    let message = format!("the byte 0x{:02x} is not UTF-8: {hint}", bytes.get(at).copied().unwrap_or(0));
    Fault { position: Some(Position::of(&before, before.len())), ..Fault::whole(path, message) }
}
