//! Which device a user means.

use super::info::{DeviceInfo, DeviceKind};
use super::refused;
use crate::error::{Error, Result};

/// The device that `asked` names: its index, or a part of its name or of its
/// driver's name, in any case. Without `asked`: the first discrete device, else
/// the first integrated one, then virtual, CPU, other.
///
/// # Errors
/// [`Error::NoDevice`] for an empty list, [`Error::UnknownDevice`] for a name
/// that fits nothing, [`Error::Arguments`] for one that fits several.
pub fn select<'a>(devices: &'a [DeviceInfo], asked: Option<&str>) -> Result<&'a DeviceInfo> {
    let Some(asked) = asked else {
        return devices
            .iter()
            .min_by_key(|device| preference(device.kind))
            .ok_or_else(none);
    };
    if devices.is_empty() {
        return Err(none());
    }
    let unknown = || Error::UnknownDevice {
        asked: asked.to_owned(),
        present: list(devices.iter()),
    };
    if asked.is_empty() {
        return Err(unknown());
    }
    if asked.bytes().all(|byte| byte.is_ascii_digit()) {
        let index = asked.parse::<usize>().ok();
        return devices
            .iter()
            .find(|device| Some(device.index) == index)
            .ok_or_else(unknown);
    }
    let needle = asked.to_lowercase();
    let exact: Vec<_> = devices
        .iter()
        .filter(|device| device.name.to_lowercase() == needle)
        .collect();
    if let [only] = exact[..] {
        return Ok(only);
    }
    let fitting: Vec<_> = devices
        .iter()
        .filter(|device| {
            device.name.to_lowercase().contains(&needle)
                || device.driver_name.to_lowercase().contains(&needle)
        })
        .collect();
    match fitting[..] {
        [] => Err(unknown()),
        [only] => Ok(only),
        _ => Err(refused(
            format!("device `{asked}`"),
            format!(
                "it fits {} devices: {}",
                fitting.len(),
                list(fitting.into_iter())
            ),
            "give the index",
        )),
    }
}

fn preference(kind: DeviceKind) -> u8 {
    match kind {
        DeviceKind::Discrete => 0,
        DeviceKind::Integrated => 1,
        DeviceKind::Virtual => 2,
        DeviceKind::Cpu => 3,
        DeviceKind::Other => 4,
    }
}

fn none() -> Error {
    Error::NoDevice {
        reason: "the loader lists no device".to_owned(),
    }
}

fn list<'a>(devices: impl Iterator<Item = &'a DeviceInfo>) -> String {
    devices
        .map(|device| format!("{}: `{}`", device.index, device.name))
        .collect::<Vec<_>>()
        .join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn device(index: usize, name: &str, driver: &str, kind: DeviceKind) -> DeviceInfo {
        DeviceInfo {
            index,
            name: name.to_owned(),
            driver_name: driver.to_owned(),
            kind,
            ..DeviceInfo::default()
        }
    }

    fn devices() -> Vec<DeviceInfo> {
        vec![
            device(
                0,
                "llvmpipe (LLVM 15.0.6, 256 bits)",
                "llvmpipe",
                DeviceKind::Cpu,
            ),
            device(1, "Radeon 780M", "radv", DeviceKind::Integrated),
            device(2, "GeForce RTX 4090", "NVIDIA", DeviceKind::Discrete),
            device(3, "GeForce RTX 4090 D", "NVIDIA", DeviceKind::Discrete),
        ]
    }

    #[test]
    fn the_default_prefers_real_hardware() {
        let all = devices();
        assert_eq!(select(&all, None).unwrap().index, 2);
        assert_eq!(select(&all[..2], None).unwrap().index, 1);
        assert_eq!(select(&all[..1], None).unwrap().index, 0);
        let mut odd = vec![device(0, "x", "", DeviceKind::Other)];
        assert_eq!(select(&odd, None).unwrap().index, 0);
        odd.push(device(1, "y", "", DeviceKind::Cpu));
        odd.push(device(2, "z", "", DeviceKind::Virtual));
        assert_eq!(select(&odd, None).unwrap().index, 2);
        assert_eq!(select(&odd[..2], None).unwrap().index, 1);
    }

    #[test]
    fn an_index_or_a_part_of_a_name_will_do() {
        let all = devices();
        assert_eq!(select(&all, Some("1")).unwrap().index, 1);
        assert_eq!(select(&all, Some("RADV")).unwrap().index, 1);
        assert_eq!(select(&all, Some("llvm")).unwrap().index, 0);
        assert_eq!(select(&all, Some("4090 d")).unwrap().index, 3);
        assert_eq!(select(&all, Some("geforce rtx 4090")).unwrap().index, 2);
    }

    #[test]
    fn digits_are_never_a_part_of_a_name() {
        for asked in ["4", "780", "99999999999999999999999"] {
            let error = select(&devices(), Some(asked)).unwrap_err();
            assert!(
                matches!(&error, Error::UnknownDevice { present, .. } if present.contains("1: `Radeon 780M`"))
            );
            assert_eq!(error.exit_code(), 2);
        }
    }

    #[test]
    fn what_fits_several_or_nothing_is_refused() {
        let all = devices();
        let several = select(&all, Some("nvidia")).unwrap_err();
        assert!(matches!(several, Error::Arguments { .. }));
        let text = several.to_string();
        assert!(
            text.contains("2: `GeForce RTX 4090`") && text.contains("3: `GeForce"),
            "{text}"
        );
        assert!(!text.contains("Radeon"), "{text}");
        assert!(matches!(
            select(&all, Some("")),
            Err(Error::UnknownDevice { .. })
        ));
        assert!(matches!(
            select(&all, Some("arc")),
            Err(Error::UnknownDevice { .. })
        ));
        assert!(matches!(select(&[], None), Err(Error::NoDevice { .. })));
        assert!(matches!(
            select(&[], Some("0")),
            Err(Error::NoDevice { .. })
        ));
    }
}
