//! What to do about what others report: the loader, a driver, the file system.

/// How to get a Vulkan driver, for messages that report none.
pub const INSTALL_HINT: &str = if cfg!(target_os = "linux") {
    "install one: `apt-get install mesa-vulkan-drivers libvulkan1` (Debian, Ubuntu) gives lavapipe, \
     a CPU driver; or use `--device cpu`, which needs no driver and gives the same bytes"
} else if cfg!(target_os = "macos") {
    "install the Vulkan SDK for macOS (MoltenVK), or use `--device cpu`, which needs no driver and \
     gives the same bytes"
} else {
    "install your graphics vendor's driver, or use `--device cpu`, which needs no driver and gives \
     the same bytes"
};

pub(super) fn io_remedy(kind: std::io::ErrorKind) -> &'static str {
    match kind {
        std::io::ErrorKind::BrokenPipe => "its reader has gone: keep it reading to the end",
        _ => "free space or choose another folder, then run again",
    }
}

pub(super) fn vulkan_remedy(result: &str) -> &'static str {
    if result.contains("DEVICE_LOST") {
        "the device was lost: run again, or use `--device cpu`"
    } else if ["OUT_OF", "TOO_MANY", "MAP_FAILED"]
        .iter()
        .any(|lack| result.contains(lack))
    {
        "memory ran out: close other programs, or ask for fewer points at a time"
    } else {
        "run `corput devices` to see what the driver offers, or use `--device cpu`"
    }
}
