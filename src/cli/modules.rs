//! `corput modules`.

use super::args::ModulesArgs;
use super::print;
use corput::catalog::{Options, Request, Sampler};
use corput::modules::{File, Target, all, of_points};
use corput::report::{create_folder, save_all};

pub fn run(args: &ModulesArgs) -> anyhow::Result<()> {
    let files = match &args.sampler {
        Some(name) => points(args, Sampler::parse(name)?)?,
        None => all()?,
    };
    create_folder(&args.out, "--out")?;
    let bytes = |file: &File| file.bytes.len();
    let total: usize = files.iter().map(bytes).sum();
    save_all(
        files
            .iter()
            .map(|file| (args.out.join(&file.name), file.bytes.as_slice())),
    )?;
    let last = files.last().map_or("", |file| file.name.as_str());
    print(&format!(
        "{} files in {}, {total} bytes; {last} says what an engine passes to them",
        files.len(),
        args.out.display()
    ));
    Ok(())
}

fn points(args: &ModulesArgs, sampler: Sampler) -> corput::Result<Vec<File>> {
    let is_random = sampler.is_random();
    let request = Request::new(&Options {
        first: args.first.unwrap_or(0),
        dimensions: Some(args.dims.unwrap_or(2)),
        scramble: sampler.scramble(),
        seed: args.seed.or(is_random.then_some(0)),
        fractions: args.fractions,
        ..Options::new(sampler.sequence(), args.count.unwrap_or(1 << 20))
    })?;
    for warning in &request.warnings {
        eprintln!("corput: warning: {warning}");
    }
    let target = Target {
        cpu: args.cpu,
        int64: args.int64,
    };
    of_points(sampler, &request, target)
}
