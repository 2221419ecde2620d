//! `corput generate`.

use super::args::GenerateArgs;
use super::arguments::origin;
use super::{guide, host, interrupt, maps, mask, points, progress, store, windows};
use corput::catalog::{Engine, Options, Order, Output, Profile, Request, Scramble, Sequence};
use corput::report::{Element, Format, Keeping, Layout, Origin, Sink, Target};
use corput::vulkan::Device;
use corput::{Error, Result};
use indicatif::ProgressBar;
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
    let layout = layout(&request, element(args)?);
    let mut maker = Maker::new(&request, args.device.as_deref())?;
    interrupt::clean_up();
    let origin = origin(args, Some(request.scramble), maker.device.as_ref())?;
    if let Some(sink) = open(args, &target, format, layout, origin)? {
        stream(&mut maker.engine, layout, sink)?;
    }
    Ok(maker.validated()?)
}

/// The type of the file's elements.
///
/// # Errors
/// [`Error::UnknownName`], and [`Error::Arguments`] for two types, or other than floats of a map.
pub fn element(args: &GenerateArgs) -> Result<Element> {
    let Some(name) = &args.element else {
        return Ok(if args.fractions {
            Element::U32
        } else {
            Element::F32
        });
    };
    let element = Element::from_name(name)?;
    let refused = |with: &str, limit: &str| Error::Arguments {
        asked: format!("--type {name} with {with}"),
        limit: limit.into(),
        remedy: "drop one of the two".into(),
    };
    if args.fractions && element != Element::U32 {
        return Err(refused("--fractions", "--fractions means --type u32"));
    }
    if args.map.is_some() && element != Element::F32 {
        let limit = "a map's results are floats; only points have fractions";
        return Err(refused("--map", limit));
    }
    Ok(element)
}

/// What an engine must make for elements of a type.
pub fn words(element: Element) -> Output {
    match element {
        Element::F32 => Output::Floats,
        Element::U32 | Element::U16 | Element::F64 => Output::Fractions,
    }
}

/// Shape and type of the points of a request.
pub fn layout(request: &Request, element: Element) -> Layout {
    Layout {
        rows: request.count,
        columns: request.words_per_point(),
        element,
    }
}

/// What makes points, and the device that it runs on.
pub struct Maker {
    pub engine: host::Source,
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

/// The output, begun or taken up again; none where it is finished already.
pub fn open(
    args: &GenerateArgs,
    target: &Target,
    format: Format,
    layout: Layout,
    origin: Origin,
) -> Result<Option<Sink>> {
    if args.resume && Sink::is_finished(target, format, layout, &origin)? {
        let file = args.out.display();
        eprintln!("corput: {file} is finished; `corput verify {file}` checks it");
        return Ok(None);
    }
    let keeping = Keeping {
        resume: args.resume,
        chunk_rows: args.chunk_rows,
    };
    let bar = progress::bytes("checking what is there");
    let mut watch = |done: u64, total: u64| {
        bar.set_length(total);
        bar.set_position(done);
        interrupt::stop(done, total)
    };
    let sink = Sink::keeping(target, format, layout, origin, keeping, &mut watch);
    bar.finish_and_clear();
    sink.map(Some)
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

/// The points that the arguments describe.
pub fn request(args: &GenerateArgs) -> Result<Request> {
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
        fractions: words(element(args)?) == Output::Fractions,
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

/// All points into the file: by windows of it as far as that goes, and piece after piece.
pub fn stream(source: &mut host::Source, layout: Layout, mut sink: Sink) -> Result<()> {
    let bar = progress::points(layout.rows);
    // What is there already counts for no rate.
    bar.set_position(sink.rows());
    bar.reset_eta();
    let by_windows = match source {
        host::Source::Device(generator) => windows::fill(generator, &mut sink, &bar),
        host::Source::Host(_) => Ok(()),
    };
    match by_windows.and_then(|()| produce(source.as_mut(), layout, &mut sink, &bar)) {
        Ok(()) => sink.finish()?,
        Err(cause) => return Err(sink.abandon(cause)),
    };
    bar.finish_and_clear();
    Ok(())
}

fn produce(
    engine: &mut dyn Engine,
    layout: Layout,
    sink: &mut Sink,
    bar: &ProgressBar,
) -> Result<()> {
    let width = u64::from(layout.columns);
    engine.make_range(sink.rows()..layout.rows, &mut |mut words| {
        // A piece may have thousands of chunks, each of which waits for the disk.
        while !words.is_empty() {
            interrupt::stop(bar.position(), layout.rows)?;
            let fit = sink.chunk_left().min(words.len() as u64);
            let (now, later) = words.split_at(fit as usize);
            sink.write(now)?;
            bar.inc(fit / width);
            words = later;
        }
        Ok(())
    })
}
