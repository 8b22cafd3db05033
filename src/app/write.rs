//! Files, written whole or not at all.

use std::collections::BTreeSet;
use std::fs::{DirEntry, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::{Builder, NamedTempFile};

/// Files being written, to be removed if the program is stopped.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Why a file could not be written.
#[derive(Debug, thiserror::Error)]
#[error("{}: cannot be written: {source}", path.display())]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// Why.
    pub source: io::Error,
}

/// Writes files of the given names and contents into `folder`, which is made if it is not there.
///
/// Each is written beside its place and renamed, the renaming only after all have been written: a
/// full disk or a stopped program leaves the old files or the new ones, never a part of one. What runs that
/// were killed have left of theirs is removed.
///
/// # Errors
/// The folder cannot be made or a file cannot be written.
pub fn write_all(folder: &Path, files: &[(String, &[u8])]) -> Result<Vec<PathBuf>, WriteError> {
    let error = |path: &Path| {
        let path = path.to_owned();
        move |source| WriteError { path, source }
    };
    if folder.is_file() {
        return Err(error(folder)(io::Error::other("it is a file, expected a folder")));
    }
    std::fs::create_dir_all(folder).map_err(error(folder))?;
    remove_abandoned(folder);
    let mut written = Vec::new();
    for (name, content) in files {
        let path = folder.join(name);
        let beside = written_beside(folder, content).map_err(error(&path))?;
        written.push((beside, path));
    }
    written
        .into_iter()
        .map(|(beside, path)| renamed(beside, &path).map(|()| path.clone()).map_err(error(&path)))
        .collect()
}

/// What the names of files being written begin and end with.
const PART: (&str, &str) = (".springbed-", ".part");

/// Removes files being written whose writer is gone: a writer holds the lock of its file as long as it lives.
///
/// A file that cannot be looked at or locked is left where it is.
fn remove_abandoned(folder: &Path) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let part = |entry: &DirEntry| {
        let (name, kind) = (entry.file_name(), entry.file_type());
        let name = name.to_string_lossy();
        name.starts_with(PART.0) && name.ends_with(PART.1) && kind.is_ok_and(|kind| kind.is_file())
    };
    for path in entries.filter(part).map(|entry| entry.path()) {
        if let Ok(file) = File::options().write(true).open(&path)
            && file.try_lock().is_ok()
        {
            // The lock is kept until the file is gone; a writer that waits for it then takes another file.
            let _ = std::fs::remove_file(&path);
        }
    }
}

/// A file of its own in `folder`, locked for as long as it is open.
fn begun(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(PART.0).suffix(PART.1);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    loop {
        let file = builder.tempfile_in(folder)?;
        // A file system without locks has nobody who removes the files of others.
        let _ = file.as_file().lock();
        // Another program may have taken it for abandoned before it was locked.
        if file.path().exists() {
            return Ok(file);
        }
    }
}

fn written_beside(folder: &Path, content: &[u8]) -> io::Result<NamedTempFile> {
    let mut list = unfinished();
    let mut file = begun(folder)?;
    list.insert(file.path().to_owned());
    drop(list);
    file.write_all(content)?;
    file.flush()?;
    Ok(file)
}

fn renamed(beside: NamedTempFile, path: &Path) -> io::Result<()> {
    let mut list = unfinished();
    list.remove(beside.path());
    beside.persist(path).map_err(|error| error.error)?;
    Ok(())
}

/// Stops the program on Ctrl-C, with the files that are not finished removed.
///
/// # Errors
/// The handler cannot be set.
pub fn remove_unfinished_on_interrupt() -> Result<(), ctrlc::Error> {
    ctrlc::set_handler(|| {
        // The lock is kept: nothing is written or renamed any more.
        let list = unfinished();
        for path in list.iter() {
            let _ = std::fs::remove_file(path);
        }
        std::process::exit(130);
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_replaced_whole_and_nothing_else_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("a/b");
        for content in ["first", "second"] {
            let paths = write_all(&inner, &[("x.csv".to_owned(), content.as_bytes())]).unwrap();
            assert_eq!(std::fs::read_to_string(&paths[0]).unwrap(), content);
        }
        assert_eq!(std::fs::read_dir(&inner).unwrap().count(), 1);
        assert!(unfinished().iter().all(|path| !path.starts_with(folder.path())));
    }

    /// A file without a writer goes, one that is being written stays.
    #[test]
    fn what_a_killed_run_left_is_removed_and_what_a_living_one_writes_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let left = folder.path().join(".springbed-left.part");
        std::fs::write(&left, "half a fi").unwrap();
        let going = begun(folder.path()).unwrap();
        write_all(folder.path(), &[("x.csv".to_owned(), b"1")]).unwrap();
        assert!(!left.exists() && going.path().exists());
        let abandoned = going.keep().unwrap().1;
        write_all(folder.path(), &[("x.csv".to_owned(), b"2")]).unwrap();
        assert!(!abandoned.exists());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        std::fs::write(&file, "").unwrap();
        let error = write_all(&file.join("below"), &[]).unwrap_err();
        assert!(error.to_string().contains("below: cannot be written"));
    }

    #[test]
    fn a_file_that_cannot_replace_a_folder_leaves_nothing_behind() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("x.csv")).unwrap();
        assert!(write_all(folder.path(), &[("x.csv".to_owned(), b"1")]).is_err());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
