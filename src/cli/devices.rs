//! `corput devices`.

use super::args::DevicesArgs;
use super::{host, print};
use corput::Error;
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
    let (major, minor, patch) = info.api_version;
    let (l, f, c) = (&info.limits, &info.features, &info.float_controls);
    json!({
        "index": info.index,
        "name": info.name,
        "kind": info.kind.name(),
        "vendor_id": info.vendor_id,
        "device_id": info.device_id,
        "api_version": format!("{major}.{minor}.{patch}"),
        "driver": {
            "name": info.driver_name,
            "info": info.driver_info,
            "version": info.driver_version,
            "uuid": info.driver_uuid,
        },
        "device_uuid": info.device_uuid,
        "limits": {
            "max_storage_buffer_range": l.max_storage_buffer_range,
            "max_push_constants": l.max_push_constants,
            "max_group_invocations": l.max_group_invocations,
            "max_group_size": l.max_group_size,
            "max_group_count": l.max_group_count,
            "max_storage_buffers": l.max_storage_buffers,
            "storage_offset_alignment": l.storage_offset_alignment,
            "timestamp_period_ns": l.timestamp_period_ns,
            "timestamp_valid_bits": l.timestamp_valid_bits,
            "subgroup_size": l.subgroup_size,
            "max_allocation": l.max_allocation,
            "memory_bytes": l.memory_bytes,
        },
        "features": {
            "float64": f.float64,
            "int64": f.int64,
            "int16": f.int16,
            "float16": f.float16,
            "external_memory_host": f.external_memory_host,
        },
        "float_controls_32": {
            "rounding_rte": c.rte,
            "rounding_rtz": c.rtz,
            "denorm_preserve": c.denorm_preserve,
            "denorm_flush_to_zero": c.denorm_flush,
            "signed_zero_inf_nan_preserve": c.signed_zero_inf_nan_preserve,
        },
        "probe": match probed {
            Ok(p) => probe_document(p),
            Err(error) => json!({ "error": error.to_string() }),
        },
    })
}

/// The probe's findings as JSON.
pub fn probe_document(p: &Probe) -> Value {
    json!({
        "operations": p.operations,
        "rounding_add": format!("{:?}", p.rounding_add),
        "rounding_multiply": format!("{:?}", p.rounding_multiply),
        "rounding_convert": format!("{:?}", p.rounding_convert),
        "contracts": p.contracts,
        "reassociates": p.reassociates,
        "denormals_in": format!("{:?}", p.denormals_in),
        "denormals_out": format!("{:?}", p.denormals_out),
        "signed_zero_kept": p.signed_zero_kept,
        "infinity_nan_kept": p.infinity_nan_kept,
        "conversions_exact": p.conversions_exact,
        "shifts_exact": p.shifts_exact,
        "tier_i": p.tier_i(),
        "tier_f": p.tier_f(),
    })
}
