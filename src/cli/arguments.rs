//! The arguments of `generate` in a sidecar, and back.

use super::args::GenerateArgs;
use super::generate::element;
use super::host;
use corput::catalog::{Profile, Scramble, Sequence};
use corput::report::{Origin, hexadecimal};
use corput::vulkan::Device;
use corput::{Error, Result};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Beside the arguments: the hash of the picture, and the device of native functions.
const PICTURE: &str = "env_sha256";
const DEVICE: &str = "device";

/// What a sidecar records: all that decides the bytes, and who made them. The device is among
/// the arguments where its own functions are.
pub fn origin(
    args: &GenerateArgs,
    scramble: Option<Scramble>,
    device: Option<&Arc<Device>>,
) -> Result<Origin> {
    let mut args = args.clone();
    // That which was chosen by default is told.
    args.scramble = scramble.map(|scramble| scramble.name().to_owned());
    args.element = Some(element(&args)?.name().to_owned());
    let mut arguments = serde_json::to_value(&args).map_err(|fault| Error::Arguments {
        asked: "arguments that FILE.json is to record".into(),
        limit: format!("it holds text of UTF-8 only ({fault})"),
        remedy: "rename the file of --env".into(),
    })?;
    if let Some(picture) = &args.env {
        arguments[PICTURE] = json!(hash(picture)?);
    }
    let device = self::device(device);
    if Profile::from_name(&args.profile)? == Profile::Native {
        arguments[DEVICE] = json!(device);
    }
    Ok(Origin { arguments, device })
}

/// Who makes the points, as a sidecar records it.
pub fn device(device: Option<&Arc<Device>>) -> String {
    device.map_or_else(|| "cpu".to_owned(), |device| host::line(device.info()))
}

/// Where the picture of recorded arguments may lie.
pub struct Places<'a> {
    /// Where it is said to lie now.
    pub given: Option<&'a Path>,
    /// The folder of what was made of it.
    pub folder: &'a Path,
}

impl Places<'_> {
    /// Refuses to be told of one where there is no picture to look for.
    pub fn refuse(&self) -> Result<()> {
        match self.given {
            None => Ok(()),
            Some(_) => Err(Error::Arguments {
                asked: "--env".into(),
                limit: "no picture is recorded, so that none is needed".into(),
                remedy: "drop --env".into(),
            }),
        }
    }
}

/// The arguments that a sidecar records; those of this run, as the device, are left open. Its
/// picture is sought where it was, seen from here and from the folder of the file.
///
/// # Errors
/// [`Error::Arguments`] where they are not all known, [`Error::Image`] where the picture is not
/// there, or another.
pub fn parse(recorded: &Value, places: &Places) -> Result<GenerateArgs> {
    let mut recorded = recorded.clone();
    let mut taken = |name: &str| recorded.as_object_mut().and_then(|all| all.remove(name));
    let picture = taken(PICTURE);
    taken(DEVICE);
    let mut args: GenerateArgs =
        serde_json::from_value(recorded).map_err(|fault| Error::Arguments {
            asked: "the recorded arguments".into(),
            limit: format!("they are not those of `corput generate` ({fault})"),
            remedy: "use the version of corput that wrote the file".into(),
        })?;
    args.env = match (&args.env, picture) {
        (Some(path), Some(picture)) => Some(find(path, &picture, places)?),
        (None, _) => {
            places.refuse()?;
            None
        }
        (Some(_), None) => {
            return Err(Error::Arguments {
                asked: "the recorded arguments".into(),
                limit: "a picture is named without its SHA-256".into(),
                remedy: "take the document that was written with the file".into(),
            });
        }
    };
    // A sequence that is random already takes no scramble, not even none.
    let sequence = Sequence::from_name(&args.sequence).ok();
    if sequence.is_none_or(|sequence| sequence.scrambles().is_empty()) {
        args.scramble = None;
    }
    Ok(args)
}

/// The first of the places where the picture of this hash is.
fn find(path: &Path, picture: &Value, places: &Places) -> Result<PathBuf> {
    let beside = places.folder.join(path);
    let candidates = match places.given {
        Some(given) => vec![given],
        None => vec![path, &beside],
    };
    let (mut problem, mut unread) = (None, None);
    for candidate in candidates {
        match hash(candidate) {
            Ok(found) if json!(found) == *picture => return Ok(candidate.to_owned()),
            Ok(_) => {
                problem.get_or_insert(Error::Image {
                    path: candidate.to_owned(),
                    problem: format!("its SHA-256 is not {picture}, as when the samples were made"),
                    remedy: "put that picture back, or say with --env where it lies".into(),
                });
            }
            Err(error) => {
                unread.get_or_insert(error);
            }
        }
    }
    Err(problem.or(unread).unwrap_or_else(|| Error::Image {
        path: path.to_owned(),
        problem: "there is no place to look for it".into(),
        remedy: "say with --env where it lies".into(),
    }))
}

/// The SHA-256 of a picture, read in blocks: a document of others may name anything.
fn hash(path: &Path) -> Result<String> {
    let refused = |problem: String| Error::Image {
        path: path.to_owned(),
        problem,
        remedy: "check the path, or say with --env where it lies".into(),
    };
    let unread = |source: io::Error| refused(format!("it cannot be read ({source})"));
    let mut file = File::open(path).map_err(unread)?;
    if !file.metadata().map_err(unread)?.is_file() {
        return Err(refused("it is no regular file".into()));
    }
    let (mut hash, mut block) = (Sha256::new(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut block).map_err(unread)? {
            0 => return Ok(hexadecimal(&hash.finalize())),
            read => hash.update(block.get(..read).unwrap_or_default()),
        }
    }
}
