//! `corput strip`.

use super::args::StripArgs;
use super::{host, maps, print};
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use corput::bench::scene::{Comparison, compare, document, page, rows, sizes};
use corput::catalog::{Group, Profile, Sampler};
use corput::compile::warm_up;
use corput::report::{create_folder, save_all};
use corput::scene::{self, Needs, Scene, Stated};
use corput::strip::program::Form;
use corput::strip::{Bundle, BundleOptions, Target, bundle};
use corput::{Error, Result};
use std::panic::resume_unwind;
use std::path::PathBuf;

pub fn run(args: &StripArgs) -> anyhow::Result<()> {
    // The compiler's own declarations are read beside the scene's pictures.
    let (scene, needs) = std::thread::scope(|scope| {
        let asked = scope.spawn(|| asked(args));
        warm_up();
        asked.join().unwrap_or_else(|panic| resume_unwind(panic))
    })?;
    for warning in &needs.warnings {
        eprintln!("corput: warning: {warning}");
    }
    let targets = targets(args)?;
    let options = BundleOptions {
        cpu: args.cpu,
        int64: args.int64,
        spirv_opt: args.spirv_opt,
    };
    let made = bundle(&scene, &needs, &targets, options)?;
    let (comparison, device) = compared(args, &needs, &made)?;
    // All is made before anything is written.
    let page = args
        .report
        .as_ref()
        .map(|path| (path, page(&scene, &needs, &comparison, device.as_deref())));
    let mut files: Vec<(PathBuf, &[u8])> = Vec::new();
    if let Some((path, _)) = &page
        && let Some(folder) = path
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty())
    {
        create_folder(folder, "--report")?;
    }
    if let Some(out) = &args.out {
        create_folder(out, "--out")?;
        let made = made.files.iter();
        files.extend(made.map(|file| (out.join(&file.name), file.bytes.as_slice())));
    }
    if let Some((path, page)) = &page {
        files.push(((*path).clone(), page.as_bytes()));
    }
    save_all(files)?;
    if args.json {
        let mut document = document(&comparison);
        if let Some(all) = document.as_object_mut() {
            all.insert("scene".to_owned(), scene::document(&scene, &needs));
        }
        print(&serde_json::to_string_pretty(&document)?);
        return Ok(());
    }
    print(&super::scene::kept(&needs));
    print(&format!("\n{}", table(&comparison)));
    print(&said(args, &made));
    Ok(())
}

/// The scene of the file, or that of the options.
fn asked(args: &StripArgs) -> Result<(Scene, Needs)> {
    let Some(file) = &args.file else {
        return points(args);
    };
    let given = [
        ("--sampler", args.sampler.is_some()),
        ("--dims", args.dims.is_some()),
        ("--map", args.map.is_some()),
        ("--samples", args.samples.is_some()),
        ("--seed", args.seed.is_some()),
        ("--profile", args.profile.is_some()),
    ];
    if let Some((option, _)) = given.iter().find(|(_, given)| *given) {
        return Err(Error::Arguments {
            asked: format!("{option} beside a scene"),
            limit: "a scene says that itself".into(),
            remedy: "drop one of the two, or edit the scene".into(),
        });
    }
    let scene = scene::read(file)?;
    let needs = Needs::of(&scene)?;
    Ok((scene, needs))
}

/// Points of a sampler, and a map over the first of their dimensions.
fn points(args: &StripArgs) -> Result<(Scene, Needs)> {
    let Some(sampler) = &args.sampler else {
        return Err(Error::Arguments {
            asked: "strip of nothing".into(),
            limit: "it takes a scene, or a sampler".into(),
            remedy: "name a scene file, .gltf or .glb; or give --sampler sobol --dims 2".into(),
        });
    };
    let mapping = maps::named(args.map.as_deref(), &args.param)?;
    if mapping
        .as_ref()
        .is_some_and(|one| one.map().group == Group::Environment)
    {
        return Err(Error::Arguments {
            asked: "strip with an environment map".into(),
            limit: "its picture is named by a scene".into(),
            remedy: "write a scene file with [environment], as tests/data/scenes/diffuse_sky.toml"
                .into(),
        });
    }
    let taken = mapping.as_ref().map(|one| u64::from(one.map().dimensions));
    let dimensions = args.dims.or(taken).unwrap_or(2);
    let dimensions = u32::try_from(dimensions).unwrap_or(u32::MAX);
    let mut name = sampler.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
    if let Some(map) = &args.map {
        name += &format!("_{}", map.replace('-', "_"));
    }
    let mut scene = Scene::new(name)?;
    scene.sampler = Stated {
        value: Sampler::parse(sampler)?,
        cause: scene::Cause::new("--sampler"),
    };
    if let Some(samples) = args.samples {
        scene.samples.value = samples;
    }
    scene.seed = args.seed.unwrap_or(0);
    if let Some(profile) = &args.profile {
        scene.profile = Profile::from_name(profile)?;
    }
    let needs = Needs::of_points(&scene, dimensions, mapping)?;
    Ok((scene, needs))
}

/// The targets of `--target`; by default what every Vulkan engine takes.
fn targets(args: &StripArgs) -> Result<Vec<Target>> {
    match &args.target[..] {
        [] => Ok(vec![Target::Glsl, Target::Spirv, Target::C, Target::Rust]),
        names => names.iter().map(|name| Target::from_name(name)).collect(),
    }
}

/// Sizes; for a report with times, where there is a device.
fn compared(
    args: &StripArgs,
    needs: &Needs,
    made: &Bundle,
) -> anyhow::Result<(Comparison, Option<String>)> {
    let untimed = || sizes(needs, &made.program, &made.spirv);
    if args.report.is_none() && args.device.is_none() {
        return Ok((untimed()?, None));
    }
    if host::is_cpu(host::asked(args.device.as_deref()).as_deref()) {
        eprintln!("corput: warning: nothing is timed: the reference runs no kernel");
        return Ok((untimed()?, None));
    }
    let device = match host::open(args.device.as_deref()) {
        // What is known without one still is a report.
        Err(error @ (Error::NoDevice { .. } | Error::InadequateDevice { .. })) => {
            eprintln!("corput: warning: nothing is timed: {error}");
            return Ok((untimed()?, None));
        }
        opened => opened?,
    };
    if made.program.form == Form::Eight && !device.has_int64() {
        let name = &device.info().name;
        eprintln!("corput: warning: nothing is timed: {name} has no integers of 64 bits");
        return Ok((untimed()?, None));
    }
    let comparison = compare(&device, needs, &made.program, &made.spirv)?;
    host::validated(device.instance())?;
    Ok((comparison, Some(host::line(device.info()))))
}

/// The comparison for a terminal.
pub fn table(comparison: &Comparison) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Disabled)
        .set_header([
            comparison.name.as_str(),
            "full",
            "stripped",
            "full / stripped",
        ]);
    for row in rows(comparison) {
        table.add_row(row);
    }
    for column in 1..4 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

fn said(args: &StripArgs, made: &Bundle) -> String {
    let Some(out) = &args.out else {
        return "\nNothing was written: --out DIR writes the files".to_owned();
    };
    let mut lines = vec![format!(
        "\nwrote {} files into {}:",
        made.files.len(),
        out.display()
    )];
    for file in &made.files {
        let checked = file.target.map_or("", Target::checked_by);
        lines.push(format!(
            "  {:<32} {:>9} bytes  {checked}",
            file.name,
            file.bytes.len()
        ));
    }
    lines.join("\n")
}
