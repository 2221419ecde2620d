//! `corput generate`.

use super::args::GenerateArgs;
use super::{guide, host, interrupt, maps, mask, points, progress, store};
use corput::catalog::{Engine, Options, Order, Output, Profile, Request, Scramble, Sequence};
use corput::report::{Element, Format, Layout, Sink, Target};
use corput::vulkan::Device;
use corput::{Error, Result};
use serde_json::{Value, json};
use std::sync::Arc;

pub fn run(args: &GenerateArgs) -> anyhow::Result<()> {
    let in_store = store::asked(args)?;
    match args.sequence.as_str() {
        mask::NAME => return mask::run(args),
        points::NAME => return points::run(args),
        _ => mask::refuse(args)?,
    }
    let request = request(args)?;
    for warning in &request.warnings {
        eprintln!("corput: warning: {warning}");
    }
    if in_store {
        return store::run(args, &request);
    }
    let (target, format) = output(args)?;
    let layout = layout(&request);
    let mut maker = Maker::new(&request, args.device.as_deref())?;
    interrupt::clean_up();
    let sink = Sink::open(
        &target,
        format,
        layout,
        arguments(args, request.scramble, maker.device.as_ref()),
    )?;
    stream(maker.engine.as_mut(), layout, sink)?;
    Ok(maker.validated()?)
}

/// Shape and type of the points of a request.
pub fn layout(request: &Request) -> Layout {
    Layout {
        rows: request.count,
        columns: request.words_per_point(),
        element: match request.output {
            Output::Fractions => Element::U32,
            Output::Floats => Element::F32,
        },
    }
}

/// What makes points, and the device that it runs on.
pub struct Maker {
    pub engine: Box<dyn Engine>,
    /// None for the CPU.
    pub device: Option<Arc<Device>>,
}

impl Maker {
    /// That of a request, on the device asked for.
    pub fn new(request: &Request, device: Option<&str>) -> Result<Self> {
        let (engine, device) = host::engine(device, request)?;
        Ok(Self { engine, device })
    }

    /// Fails where the validation layer has found something.
    pub fn validated(&self) -> Result<()> {
        self.device
            .as_ref()
            .map_or(Ok(()), |device| host::validated(device.instance()))
    }
}

/// Where the points go, and as what.
pub fn output(args: &GenerateArgs) -> Result<(Target, Format)> {
    let target = Target::from(args.out.as_path());
    let format = match (&args.format, &target) {
        (Some(name), _) => name.parse()?,
        (None, Target::Stdout) => Format::Npy,
        (None, Target::File(path)) => Format::from_path(path)?,
    };
    Ok((target, format))
}

/// The points asked for.
pub fn count(args: &GenerateArgs) -> Result<u64> {
    args.count.ok_or_else(|| Error::Arguments {
        asked: format!("generate {} without --count", args.sequence),
        limit: "points are as many as one asks for".into(),
        remedy: "add --count 1024".into(),
    })
}

fn request(args: &GenerateArgs) -> Result<Request> {
    let sequence = Sequence::from_name(&args.sequence)
        .map_err(|_| Error::unknown_name("sequence", &args.sequence, &guide::known()))?;
    let map = maps::mapping(args)?;
    // Where nothing else says how many, as many as the map takes.
    let taken = map.as_ref().filter(|_| args.bases.is_none());
    let taken = taken.map(|mapping| u64::from(mapping.map().dimensions));
    Request::new(&Options {
        sequence,
        count: count(args)?,
        first: args.first,
        dimensions: args.dims.or(taken),
        bases: args.bases.clone(),
        total: args.total,
        index_first: args.index_first,
        seed: args.seed,
        scramble: args
            .scramble
            .as_deref()
            .map(|name| scramble(sequence, name))
            .transpose()?,
        order: Order::from_name(&args.order)?,
        grid: args.grid.as_ref().map(|grid| grid.0.clone()),
        generator: args.generator,
        fractions: args.fractions,
        map,
        with_pdf: args.with_pdf,
        profile: Profile::from_name(&args.profile)?,
    })
}

/// The scramble with this name. A name that is none is answered by those of the sequence.
pub fn scramble(sequence: Sequence, name: &str) -> Result<Scramble> {
    Scramble::from_name(name).map_err(|unknown| {
        let known = sequence.scrambles().iter().map(|scramble| scramble.name());
        match known.collect::<Vec<&str>>()[..] {
            [] => unknown,
            ref known => Error::unknown_name("scramble", name, known),
        }
    })
}

/// Chunk after chunk from the engine to the file.
pub fn stream(engine: &mut dyn Engine, layout: Layout, mut sink: Sink) -> Result<()> {
    let bar = progress::points(layout.rows);
    let width = u64::from(layout.columns);
    let mut done = 0;
    while done < layout.rows {
        let points = engine.chunk().clamp(1, layout.rows - done);
        engine.make(done, points, &mut |words| {
            interrupt::stop(bar.position(), layout.rows)?;
            sink.write(words)?;
            bar.inc(words.len() as u64 / width);
            Ok(())
        })?;
        done += points;
    }
    sink.finish()?;
    bar.finish_and_clear();
    Ok(())
}

/// What a sidecar records: the arguments, and nothing that changes the bytes of the
/// exact profile but them.
pub fn arguments(args: &GenerateArgs, scramble: Scramble, device: Option<&Arc<Device>>) -> Value {
    json!({
        "sequence": args.sequence,
        "count": args.count,
        "first": args.first,
        "dims": args.dims,
        "bases": args.bases,
        "total": args.total,
        "index_first": args.index_first,
        "seed": args.seed.unwrap_or(0),
        "scramble": scramble.name(),
        "order": args.order,
        "grid": args.grid.as_ref().map(|grid| &grid.0),
        "generator": args.generator,
        "fractions": args.fractions,
        "map": args.map,
        "param": args.param.iter().map(|p| (p.name.clone(), json!(p.numbers))).collect::<serde_json::Map<_, _>>(),
        "env": args.env,
        "env_weight": args.env_weight,
        "compensated": args.compensated,
        "with_pdf": args.with_pdf,
        "profile": args.profile,
        "device": device.map_or_else(|| "cpu".to_owned(), |device| host::line(device.info())),
    })
}
