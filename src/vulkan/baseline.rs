//! The least that a device must offer.

use super::info::DeviceInfo;
use crate::error::{Error, Result};

/// Refuses a device of less than Vulkan 1.1 guarantees, as far as it is relied on.
pub(super) fn check_baseline(info: &DeviceInfo) -> Result<()> {
    let (major, minor, _) = info.api_version;
    let limits = &info.limits;
    let [groups_x, groups_y, _] = limits.max_group_count;
    let needs: [(&str, u64, u64); 7] = [
        ("storage buffers", limits.max_storage_buffers.into(), 4),
        (
            "bytes of a storage buffer",
            limits.max_storage_buffer_range,
            1 << 27,
        ),
        (
            "invocations in a group",
            limits.max_group_invocations.into(),
            128,
        ),
        (
            "invocations on a group's x axis",
            limits.max_group_size[0].into(),
            128,
        ),
        ("groups on the x axis", groups_x.into(), 65_535),
        ("groups on the y axis", groups_y.into(), 65_535),
        (
            "bytes of push constants",
            limits.max_push_constants.into(),
            128,
        ),
    ];
    if (major, minor) < (1, 1) {
        let problem = format!("it offers Vulkan {major}.{minor}, and 1.1 is needed");
        return Err(inadequate(info, problem));
    }
    match needs.iter().find(|(_, has, least)| has < least) {
        Some((name, has, least)) => {
            let problem = format!("{name}: it has {has}, and {least} are needed");
            Err(inadequate(info, problem))
        }
        None => Ok(()),
    }
}

/// The device cannot do what is needed.
pub(super) fn inadequate(info: &DeviceInfo, problem: impl Into<String>) -> Error {
    Error::InadequateDevice {
        device: info.name.clone(),
        problem: problem.into(),
        remedy: "choose another device, or `--device cpu`".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::info::Limits;
    use super::*;

    fn baseline() -> DeviceInfo {
        DeviceInfo {
            api_version: (1, 1, 0),
            limits: Limits {
                max_storage_buffers: 4,
                max_storage_buffer_range: 1 << 27,
                max_group_invocations: 128,
                max_group_size: [128, 1, 1],
                max_group_count: [65_535, 65_535, 1],
                max_push_constants: 128,
                ..Limits::default()
            },
            ..DeviceInfo::default()
        }
    }

    #[test]
    fn the_baseline_is_enough_and_nothing_less_is() {
        assert!(check_baseline(&baseline()).is_ok());
        let weaker: [fn(&mut DeviceInfo); 8] = [
            |info| info.api_version = (1, 0, 300),
            |info| info.limits.max_storage_buffers = 3,
            |info| info.limits.max_storage_buffer_range -= 1,
            |info| info.limits.max_group_invocations = 127,
            |info| info.limits.max_group_size[0] = 64,
            |info| info.limits.max_group_count[0] = 65_534,
            |info| info.limits.max_group_count[1] = 65_534,
            |info| info.limits.max_push_constants = 124,
        ];
        for weaken in weaker {
            let mut info = baseline();
            weaken(&mut info);
            let error = check_baseline(&info).unwrap_err();
            assert!(matches!(error, Error::InadequateDevice { .. }), "{error}");
            assert_eq!(error.exit_code(), 3);
        }
    }
}
