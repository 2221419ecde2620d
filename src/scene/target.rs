//! Limits of the device that a scene is for.

use super::Choice;
use super::needs::{Domain, Draw, refused};
use crate::Result;
use crate::catalog::Group;

/// Invocations of a workgroup of a scene's kernel.
pub const GROUP: u32 = 64;

/// Bytes of its push constants: the first sample, and how many.
pub const PUSH_BYTES: u32 = 8;

/// Limits, each unknown unless stated.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Target {
    /// Invocations of a workgroup: `maxComputeWorkGroupInvocations`.
    pub group_invocations: Option<u64>,
    /// Bytes of push constants: `maxPushConstantsSize`.
    pub push_constant_bytes: Option<u64>,
    /// Storage buffers of a stage: `maxPerStageDescriptorStorageBuffers`.
    pub storage_buffers: Option<u64>,
    /// Bytes of a storage buffer: `maxStorageBufferRange`.
    pub storage_buffer_bytes: Option<u64>,
}

/// What a kernel that draws the domains needs of a target. Parameters are constants; the
/// results, each environment and each choice among many have a buffer.
pub(super) fn check(target: &Target, domains: &[Domain]) -> Result<()> {
    let mut tables: Vec<(&str, u64)> = Vec::new();
    for domain in domains {
        tables.extend(table(domain)?);
    }
    within(
        target.group_invocations,
        GROUP.into(),
        "invocations of a workgroup",
        "group-invocations",
    )?;
    within(
        target.push_constant_bytes,
        PUSH_BYTES.into(),
        "bytes of push constants",
        "push-constant-bytes",
    )?;
    let keys: Vec<&str> = tables.iter().map(|(key, _)| *key).collect();
    let of = match keys.as_slice() {
        [] => String::new(),
        keys => format!(" and the tables of {}", keys.join(", ")),
    };
    within(
        target.storage_buffers,
        1 + tables.len() as u64,
        &format!("storage buffers, for results{of}"),
        "storage-buffers",
    )?;
    for (key, bytes) in tables {
        let what = format!("bytes of a storage buffer, for the table of {key}");
        within(
            target.storage_buffer_bytes,
            bytes,
            &what,
            "storage-buffer-bytes",
        )?;
    }
    Ok(())
}

/// Key and bytes of the table of a domain, if it has one.
fn table(domain: &Domain) -> Result<Option<(&str, u64)>> {
    let words = match &domain.draw {
        Draw::Map(mapping) if mapping.map().group == Group::Environment => {
            mapping.tables().iter().map(Vec::len).sum()
        }
        Draw::Choice(weights) => Choice::new(weights)?.words().len(),
        _ => 0,
    };
    Ok((words > 0).then_some((domain.key.as_str(), 4 * words as u64)))
}

fn within(limit: Option<u64>, needed: u64, what: &str, key: &str) -> Result<()> {
    match limit {
        Some(limit) if limit < needed => Err(refused(
            format!("{needed} {what}"),
            &format!("the target has {limit}, says [target] {key}"),
            "choose another target, or leave out of the scene what needs them",
        )),
        _ => Ok(()),
    }
}
