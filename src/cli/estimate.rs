//! `corput estimate`.

use super::args::EstimateArgs;
use super::{host, interrupt, pixels, print, progress};
use corput::bulk;
use corput::catalog::{Options, Problem, Profile, Raster, Request, Sampler, Scramble, Shard};
use corput::estimate::Estimate;
use corput::interface::Column;
use corput::kernels::Estimator;
use corput::{Error, Result};
use serde_json::{Map, Value, json};
use std::ops::Range;
use std::time::Instant;

pub fn run(args: &EstimateArgs) -> anyhow::Result<()> {
    let problem = problem(args)?;
    let sampler = Sampler::parse(&args.sampler)?;
    let options = options(args, sampler, &problem);
    let request = Request::new(&options)?;
    for warning in request.warnings.iter().chain(&sampler.lost_at(args.count)) {
        eprintln!("corput: warning: {warning}");
    }
    if let Some(size) = args.pixels {
        return pixels::run(args, &Raster::new(&problem, &options, size)?, &request);
    }
    pixels::refuse(args)?;
    let points = share(args.shard.unwrap_or(Shard::WHOLE), args.count)?;
    let result = made(args, &problem, &request, points)?;
    if args.json {
        let document = document(&problem, &request, &result);
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        print(&text(&problem, &request, &result));
    }
    Ok(())
}

/// What is integrated, and by which estimator.
pub fn problem(args: &EstimateArgs) -> Result<Problem> {
    let problem = Problem::parse(&args.integrand)?;
    match &args.estimator {
        Some(name) => problem.with_estimator(name),
        None => Ok(problem),
    }
}

/// The points, of which the integrand says the dimensions.
pub fn options(args: &EstimateArgs, sampler: Sampler, problem: &Problem) -> Options {
    Options {
        first: args.start,
        dimensions: Some(problem.dimensions().into()),
        seed: args.seed,
        scramble: sampler.scramble(),
        fractions: true,
        ..Options::new(sampler.sequence(), args.count)
    }
}

/// The points of a shard, counted from the first that was asked for.
fn share(shard: Shard, count: u64) -> Result<Range<u64>> {
    let points = shard.of(count);
    if points.is_empty() {
        return Err(Error::Arguments {
            asked: format!("shard {shard} of {count} points"),
            limit: "it has none".into(),
            remedy: format!("cut them into at most {count} shards"),
        });
    }
    Ok(points)
}

/// An estimate, and what made it.
struct Made {
    /// Its points, counted from the request's first.
    points: Range<u64>,
    estimate: Estimate,
    device: String,
    kernel: Option<&'static str>,
    device_ms: Option<f64>,
    total_ms: f64,
}

fn made(
    args: &EstimateArgs,
    problem: &Problem,
    request: &Request,
    points: Range<u64>,
) -> anyhow::Result<Made> {
    let count = points.end - points.start;
    let Some(device) = host::open_or_cpu(args.device.as_deref(), Profile::Exact)? else {
        let begun = Instant::now();
        let estimate = bulk::estimate(problem, request, points.start, count)?;
        return Ok(Made {
            points,
            estimate,
            device: "cpu".to_owned(),
            kernel: None,
            device_ms: None,
            total_ms: begun.elapsed().as_secs_f64() * 1e3,
        });
    };
    let mut estimator = Estimator::new(&device, problem, request)?;
    let bar = progress::points(count);
    interrupt::clean_up();
    let begun = Instant::now();
    let (estimate, timing) = estimator.run(points.start, count, &mut |done| {
        bar.set_position(done);
        interrupt::stop(done, count)
    })?;
    let total_ms = begun.elapsed().as_secs_f64() * 1e3;
    bar.finish_and_clear();
    host::validated(device.instance())?;
    Ok(Made {
        points,
        estimate,
        device: host::line(device.info()),
        kernel: Some(estimator.kernel_name()),
        device_ms: timing.device_ns.map(|ns| ns * 1e-6),
        total_ms,
    })
}

/// Whether the points are independent, so that their variance says how far off the mean is.
fn independent(request: &Request) -> bool {
    let random = |column: &Column| matches!(column, Column::Random { .. });
    request.columns.iter().all(random)
}

fn sampler(request: &Request) -> String {
    match request.scramble {
        Scramble::None => request.sequence.name().to_owned(),
        scramble => format!("{}:{}", request.sequence.name(), scramble.name()),
    }
}

/// What is estimated, by what points.
pub fn heading(problem: &Problem, request: &Request, points: Range<u64>) -> String {
    format!(
        "{}{} in {} dimension{}, {} points of {} from {} on",
        problem.integrand().name,
        problem
            .estimator()
            .map_or(String::new(), |name| format!(" by {name}")),
        problem.dimensions(),
        if problem.dimensions() == 1 { "" } else { "s" },
        points.end - points.start,
        sampler(request),
        request.first + points.start,
    )
}

fn text(problem: &Problem, request: &Request, made: &Made) -> String {
    let estimate = &made.estimate;
    let mean = estimate.mean().unwrap_or(f64::NAN);
    let mut lines = vec![
        heading(problem, request, made.points.clone()),
        format!("mean            {mean}"),
        format!("truth           {}", problem.truth()),
        format!("error           {:+.3e}", mean - problem.truth()),
    ];
    lines.push(match (independent(request), estimate.standard_error()) {
        (true, Some(error)) => format!("standard error  {error:.3e}"),
        (true, None) => "standard error  none of one point".to_owned(),
        (false, _) => format!(
            "standard error  none: points of {} are not independent{}",
            request.sequence.name(),
            if request.scramble.is_random() {
                "; compare several seeds"
            } else {
                ""
            },
        ),
    });
    if let Some(variance) = estimate.variance() {
        lines.push(format!("variance        {variance}"));
    }
    let rate = estimate.count() as f64 / made.total_ms * 1e-6;
    lines.push(format!(
        "time            {:.3} ms, {rate:.3} G points/s, on {}",
        made.total_ms, made.device
    ));
    if let Some(device_ms) = made.device_ms {
        lines.push(format!("device time     {device_ms:.3} ms"));
    }
    lines.join("\n")
}

/// The parameters of a problem by name.
fn parameters(problem: &Problem) -> Map<String, Value> {
    let parameters = problem.integrand().parameters.iter();
    let mut parameters: Map<String, Value> = parameters
        .zip(problem.values())
        .map(|(one, value)| {
            let word = one.words().get(*value as usize);
            let value = word.map_or(json!(value), |word| json!(word));
            (one.name.to_owned(), value)
        })
        .collect();
    if let Some(map) = problem.map() {
        parameters.insert("map".to_owned(), json!(map.name()));
    }
    parameters
}

/// What was asked for.
pub fn about(problem: &Problem, request: &Request) -> Map<String, Value> {
    let about = json!({
        "integrand": problem.integrand().name,
        "estimator": problem.estimator(),
        "dimensions": problem.dimensions(),
        "parameters": parameters(problem),
        "sampler": request.sequence.name(),
        "scramble": request.scramble.name(),
        "seed": request.seed,
        "start": request.first,
    });
    about.as_object().cloned().unwrap_or_default()
}

/// What exact sums say of an integral, in the same words whoever added them.
pub fn numbers(estimate: &Estimate, independent: bool, truth: f64) -> Map<String, Value> {
    let mean = estimate.mean();
    let numbers = json!({
        "count": estimate.count(),
        "mean": mean,
        "variance": estimate.variance(),
        "independent": independent,
        "standard_error": estimate.standard_error().filter(|_| independent),
        "truth": truth,
        "error": mean.map(|mean| mean - truth),
        "sum": estimate.sum().to_string(),
        "sum_of_squares": estimate.squares().to_string(),
        "scale": estimate.scale(),
    });
    numbers.as_object().cloned().unwrap_or_default()
}

fn document(problem: &Problem, request: &Request, made: &Made) -> Value {
    let mut document = about(problem, request);
    document.extend(numbers(
        &made.estimate,
        independent(request),
        problem.truth(),
    ));
    let first = request.first + made.points.start;
    // Points of a set depend on how many it has, those of a sequence on their index alone.
    let set = request.sequence.options().contains(&"--total");
    let result = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "start": first,
        "ranges": [{ "first": first, "count": made.estimate.count() }],
        "total": set.then_some(request.first + request.count),
        "term_error": problem.integrand().error * problem.coefficients().peak,
        "device": made.device,
        "kernel": made.kernel,
        "device_ms": made.device_ms,
        "total_ms": made.total_ms,
    });
    document.extend(result.as_object().cloned().unwrap_or_default());
    Value::Object(document)
}
