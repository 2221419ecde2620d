//! A device and its floats as JSON.

use crate::vulkan::{DeviceInfo, Probe};
use serde_json::{Value, json};

/// What a device says about itself.
#[must_use]
pub fn device_document(info: &DeviceInfo) -> Value {
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
    })
}

/// The probe's findings as JSON.
#[must_use]
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
