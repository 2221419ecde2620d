//! `corput demo`.

use super::args::DemoArgs;
use super::{host, interrupt, print, progress};
use comfy_table::{CellAlignment, Table, presets};
use corput::demo::{self, Demo};
use corput::image::{Image, load_exr};
use corput::report::create_folder;
use corput::{Error, vulkan::Device};
use std::sync::Arc;

pub fn run(args: &DemoArgs) -> anyhow::Result<()> {
    let device = host::open(args.device.as_deref())?;
    let image = load_exr(&args.env)?;
    fits(&device, &image, args)?;
    create_folder(&args.out, "--out")?;
    print(&host::line(device.info()));
    interrupt::clean_up();
    let bar = progress::steps();
    let found = demo::run(&device, &image, &args.out, &mut |name, done, total| {
        progress::step(&bar, name, done, total);
        interrupt::stop(done, total)
    })?;
    bar.finish_and_clear();
    print(&report(args, &found, &device));
    host::validated(device.instance())?;
    if found.all_equal() {
        return Ok(());
    }
    let sums = found.estimates.iter().filter(|e| !e.equal).count();
    let wrong = found
        .comparisons
        .iter()
        .filter(|c| c.mismatches > 0)
        .count();
    Err(Error::CheckFailed {
        failures: sums + wrong,
        total: found.estimates.len() + found.comparisons.len(),
    }
    .into())
}

/// Refuses before work a map that one buffer cannot hold, or whose sums would overflow.
fn fits(device: &Device, image: &Image, args: &DemoArgs) -> corput::Result<()> {
    let refused = |problem: String, remedy: &str| Error::Image {
        path: args.env.clone(),
        problem,
        remedy: remedy.to_owned(),
    };
    let bytes = 12 * image.texels.len() as u64;
    let limit = device.info().limits.max_storage_buffer_range;
    if bytes > limit {
        return Err(refused(
            format!("its texels take {bytes} bytes, and a buffer of this device holds {limit}"),
            "scale the map down",
        ));
    }
    let peak = image.texels.iter().flatten().fold(0f32, |a, &b| a.max(b));
    if peak > PEAK {
        return Err(refused(
            format!("its brightest texel has a radiance of {peak:e}; the sums hold up to {PEAK:e}"),
            "scale its radiance down",
        ));
    }
    Ok(())
}

/// Radiance of which 2^20 samples fit in sums of 64 bits.
const PEAK: f32 = 1e12;

fn report(args: &DemoArgs, found: &Demo, device: &Arc<Device>) -> String {
    let mut lines = Vec::new();
    for c in &found.comparisons {
        lines.push(format!(
            "{} {}: {} differ from the CPU's; {:.1} ms on the device, {:.3} G points/s",
            c.compared,
            c.name,
            c.mismatches,
            c.device_s * 1e3,
            c.compared as f64 / c.device_s / 1e9
        ));
    }
    let [width, height] = found.size;
    lines.push(format!(
        "\nirradiance of {} ({width} x {height}, {} negative texels taken as 0), luminance:",
        args.env.display(),
        found.clamped
    ));
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header([
        "normal",
        "points",
        "estimate",
        "truth",
        "relative error",
        "device ms",
        "sum",
    ]);
    for e in &found.estimates {
        let (estimate, truth) = e.luminances();
        table.add_row([
            e.axis_name().to_owned(),
            e.count.to_string(),
            format!("{estimate:.6}"),
            format!("{truth:.6}"),
            format!("{:.2e}", e.relative_error()),
            format!("{:.3}", e.device_ms),
            if e.equal { "= CPU" } else { "NOT the CPU's" }.to_owned(),
        ]);
    }
    for column in 1..6 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    lines.push(table.to_string());
    let files: Vec<String> = found
        .files
        .iter()
        .map(|f| f.display().to_string())
        .collect();
    lines.push(format!("\nwritten: {}", files.join(", ")));
    let sums = found.estimates.iter().filter(|e| e.equal).count();
    let equal: u64 = found
        .comparisons
        .iter()
        .map(|c| c.compared - c.mismatches)
        .sum();
    let all: u64 = found.comparisons.iter().map(|c| c.compared).sum();
    lines.push(format!(
        "equal to the CPU bit for bit on {}: {equal} of {all} points and directions, {sums} of {} \
         irradiance sums",
        device.info().name,
        found.estimates.len()
    ));
    lines.join("\n")
}
