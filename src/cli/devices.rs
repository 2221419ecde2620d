//! `corput devices`.

use super::args::DevicesArgs;
use super::{host, print};
use corput::Error;
use corput::card::{device_document, probe_document};
use corput::kernels::probe;
use corput::vulkan::{Device, DeviceInfo, Probe};
use serde_json::{Value, json};

pub fn run(args: &DevicesArgs) -> anyhow::Result<()> {
    let instance = host::instance()?;
    let devices = instance.devices()?;
    if devices.is_empty() {
        return Err(Error::NoDevice {
            reason: "the loader lists none".into(),
        }
        .into());
    }
    let mut documents = Vec::new();
    for info in &devices {
        let probed = Device::open(&instance, info).and_then(|device| probe(&device));
        if args.json {
            documents.push(document(info, &probed));
        } else {
            print(&text(info, &probed));
        }
    }
    if args.json {
        print(&serde_json::to_string_pretty(
            &json!({ "devices": documents }),
        )?);
    }
    Ok(())
}

fn text(info: &DeviceInfo, probed: &corput::Result<Probe>) -> String {
    let limits = &info.limits;
    let mut lines = vec![
        format!("{}: {}", info.index, host::line(info)),
        format!(
            "   buffers to {} MiB, {} invocations a group, {} bytes of push constants, groups to {:?}",
            limits.max_storage_buffer_range >> 20,
            limits.max_group_invocations,
            limits.max_push_constants,
            limits.max_group_count
        ),
        format!(
            "   memory {} MiB, subgroups of {}, timestamps of {} bits and {} ns",
            limits.memory_bytes >> 20,
            limits.subgroup_size,
            limits.timestamp_valid_bits,
            limits.timestamp_period_ns
        ),
    ];
    match probed {
        Ok(p) => {
            lines.push(format!(
                "   probe of {} operations: + - {:?}, * {:?}, integer to float {:?}; contracts: {}; \
                 denormals in {:?}, out {:?}",
                p.operations,
                p.rounding_add,
                p.rounding_multiply,
                p.rounding_convert,
                yes(p.contracts),
                p.denormals_in,
                p.denormals_out
            ));
            lines.push(format!(
                "   exact profile: tier I {}, tier F {}",
                promised(p.tier_i()),
                promised(p.tier_f())
            ));
        }
        Err(error) => lines.push(format!("   not usable: {error}")),
    }
    lines.join("\n")
}

fn yes(value: bool) -> &'static str {
    if value { "yes" } else { "no" }
}

fn promised(value: bool) -> &'static str {
    if value { "yes" } else { "refused" }
}

fn document(info: &DeviceInfo, probed: &corput::Result<Probe>) -> Value {
    let mut document = device_document(info);
    document["probe"] = match probed {
        Ok(p) => probe_document(p),
        Err(error) => json!({ "error": error.to_string() }),
    };
    document
}
