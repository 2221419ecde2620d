//! Where the bytes go, and how a file comes to its name all at once.

use std::fs::{self, File, OpenOptions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use super::Format;
use super::aside::{Aside, ENDING};
use crate::error::{Error, Result};

/// Where results go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// A file. What it holds is replaced when all is written, not before.
    /// A device or pipe that is already there is written in place.
    File(PathBuf),
    /// Standard output.
    Stdout,
}

impl<P: Into<PathBuf>> From<P> for Target {
    /// `-` is standard output, all else a file.
    fn from(path: P) -> Self {
        let path = path.into();
        if path.as_os_str() == "-" {
            Self::Stdout
        } else {
            Self::File(path)
        }
    }
}

impl Target {
    /// The name of the file without its folder.
    pub(super) fn name(&self) -> String {
        match self {
            Self::File(path) => path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into(),
            Self::Stdout => "stdout".to_owned(),
        }
    }
}

/// An open destination.
pub(super) enum Place {
    /// Written aside; `commit` gives it its name.
    Aside(Aside),
    /// A device or a pipe, which has no name to take over.
    Device(File),
    Stdout(io::Stdout),
}

impl Place {
    /// Opens the target and returns it with the path that messages name.
    pub(super) fn open(target: &Target, format: Format) -> Result<(Self, PathBuf)> {
        match target {
            Target::Stdout => {
                let out = io::stdout();
                let path = PathBuf::from("standard output");
                if !format.is_text() && out.is_terminal() {
                    return Err(refused(
                        &path,
                        "it is a terminal, and the data is binary",
                        "redirect it, or use --format csv",
                    ));
                }
                Ok((Self::Stdout(out), path))
            }
            Target::File(path) => {
                let place = match existing(path)? {
                    Existing::Device => Self::Device(
                        OpenOptions::new()
                            .write(true)
                            .open(path)
                            .map_err(|e| cannot_create(path, path, &e))?,
                    ),
                    Existing::File(real) => {
                        let folder = folder_of(&real).to_owned();
                        let made = folder.join(ENDING);
                        let aside = Aside::create_in(&folder, path, real);
                        Self::Aside(aside.map_err(|e| cannot_create(path, &made, &e))?)
                    }
                };
                Ok((place, path.clone()))
            }
        }
    }
}

impl Write for Place {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Aside(aside) => aside.file.write(bytes),
            Self::Device(file) => file.write(bytes),
            Self::Stdout(out) => out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Aside(_) | Self::Device(_) => Ok(()),
            Self::Stdout(out) => out.flush(),
        }
    }
}

/// What stands under a final name.
pub(super) enum Existing {
    /// A device or pipe.
    Device,
    /// A regular file or nothing, under this name without symbolic links.
    File(PathBuf),
}

/// Looks at what is there, and refuses what cannot become the output.
pub(super) fn existing(path: &Path) -> Result<Existing> {
    let ends_in_separator = path
        .as_os_str()
        .as_encoded_bytes()
        .last()
        .is_some_and(|b| std::path::is_separator(char::from(*b)));
    if path.is_dir() || ends_in_separator || path.file_name().is_none() {
        return Err(refused(
            path,
            "it names a folder",
            "give the name of a file",
        ));
    }
    match fs::metadata(path) {
        Ok(found) if !found.is_file() => Ok(Existing::Device),
        Ok(_) => path
            .canonicalize()
            .map(Existing::File)
            .map_err(|e| cannot_create(path, path, &e)),
        Err(_) if path.is_symlink() => Err(refused(
            path,
            "it is a symbolic link that leads nowhere",
            "remove the link, or make what it points at",
        )),
        // What is written aside may have a shorter name.
        Err(error) if error.kind() == io::ErrorKind::InvalidFilename => Err(too_long(path)),
        // Whatever else is wrong, creating the partial file meets it too.
        Err(_) => Ok(Existing::File(path.to_owned())),
    }
}

fn folder_of(file: &Path) -> &Path {
    file.parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}

/// Makes a rename last: it is an entry of the folder.
#[cfg(unix)]
pub(super) fn sync_folder(file: &Path) -> io::Result<()> {
    match File::open(folder_of(file)).and_then(|f| f.sync_all()) {
        // Some network and FUSE file systems cannot do this; the rename stands.
        Err(e)
            if matches!(
                e.kind(),
                io::ErrorKind::InvalidInput
                    | io::ErrorKind::Unsupported
                    | io::ErrorKind::PermissionDenied
            ) =>
        {
            Ok(())
        }
        result => result,
    }
}

#[cfg(not(unix))]
pub(super) fn sync_folder(_: &Path) -> io::Result<()> {
    Ok(())
}

/// A file operation that failed once work had begun.
pub(super) fn failed(action: &'static str, path: &Path, source: io::Error) -> Error {
    Error::Io {
        action,
        path: path.to_owned(),
        source,
    }
}

pub(super) fn refused(path: &Path, problem: impl Into<String>, remedy: impl Into<String>) -> Error {
    Error::Output {
        path: path.to_owned(),
        problem: problem.into(),
        remedy: remedy.into(),
    }
}

/// Why `made` could not be created on behalf of `asked`.
pub(super) fn cannot_create(asked: &Path, made: &Path, source: &io::Error) -> Error {
    let folder = folder_of(made);
    let shown = folder.display();
    match source.kind() {
        io::ErrorKind::NotFound if !folder.exists() => refused(
            asked,
            format!("folder {shown} does not exist"),
            "make it, or give another one",
        ),
        io::ErrorKind::NotADirectory => refused(
            asked,
            format!("{shown} is not a folder"),
            "give another folder",
        ),
        io::ErrorKind::InvalidFilename => too_long(asked),
        _ if made == asked => refused(
            asked,
            format!("it cannot be opened for writing: {}", reason(source)),
            "allow writing to it, or choose another file",
        ),
        _ => refused(
            asked,
            format!("folder {shown} is not writable: {}", reason(source)),
            "allow writing to it, or choose another folder",
        ),
    }
}

/// Why nothing can be written somewhere.
fn reason(source: &io::Error) -> String {
    match source.kind() {
        io::ErrorKind::PermissionDenied => format!("this user may not ({source})"),
        io::ErrorKind::ReadOnlyFilesystem => {
            format!("its file system may only be read ({source})")
        }
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
            format!("no space is left ({source})")
        }
        // As in /proc.
        io::ErrorKind::NotFound => format!("it takes no new files ({source})"),
        _ => source.to_string(),
    }
}

/// The longest name of a file that usual file systems take, in bytes, and what journals have
/// more than the file that they are beside.
const NAME_BYTES: usize = 255;
const MORE_BYTES: usize = "..partial.json".len();

fn too_long(asked: &Path) -> Error {
    let own = asked.file_name().map_or(0, |name| name.len());
    if own + MORE_BYTES <= NAME_BYTES {
        return refused(
            asked,
            "its path is longer than the file system takes",
            "give a shorter one",
        );
    }
    let most = NAME_BYTES - MORE_BYTES;
    refused(
        asked,
        format!(
            "its name has {own} bytes, what is written beside it {MORE_BYTES} more, and any name \
             {NAME_BYTES} at most"
        ),
        format!("give a name of at most {most} bytes"),
    )
}
