//! `corput estimate`.

use super::args::EstimateArgs;
use super::{host, interrupt, pixels, print, progress};
use corput::bulk;
use corput::catalog::{Options, Problem, Raster, Request, Sampler, Scramble};
use corput::estimate::Estimate;
use corput::interface::Column;
use corput::kernels::Estimator;
use serde_json::{Map, Value, json};
use std::time::Instant;

pub fn run(args: &EstimateArgs) -> anyhow::Result<()> {
    let mut problem = Problem::parse(&args.integrand)?;
    if let Some(name) = &args.estimator {
        problem = problem.with_estimator(name)?;
    }
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
    let result = made(args, &problem, &request)?;
    if args.json {
        let document = document(&problem, &request, &result);
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        print(&text(&problem, &request, &result));
    }
    Ok(())
}

/// The points, of which the integrand says the dimensions.
fn options(args: &EstimateArgs, sampler: Sampler, problem: &Problem) -> Options {
    Options {
        first: args.start,
        dimensions: Some(problem.dimensions().into()),
        seed: args.seed,
        scramble: sampler.scramble(),
        fractions: true,
        ..Options::new(sampler.sequence(), args.count)
    }
}

/// An estimate, and what made it.
struct Made {
    estimate: Estimate,
    device: String,
    kernel: Option<&'static str>,
    device_ms: Option<f64>,
    total_ms: f64,
}

fn made(args: &EstimateArgs, problem: &Problem, request: &Request) -> anyhow::Result<Made> {
    let asked = host::asked(args.device.as_deref());
    if host::is_cpu(asked.as_deref()) {
        let begun = Instant::now();
        let estimate = bulk::estimate(problem, request, 0, request.count)?;
        return Ok(Made {
            estimate,
            device: "cpu".to_owned(),
            kernel: None,
            device_ms: None,
            total_ms: begun.elapsed().as_secs_f64() * 1e3,
        });
    }
    let device = host::open(args.device.as_deref())?;
    let mut estimator = Estimator::new(&device, problem, request)?;
    let bar = progress::points(request.count);
    interrupt::clean_up();
    let begun = Instant::now();
    let (estimate, timing) = estimator.run(0, request.count, &mut |done| {
        bar.set_position(done);
        interrupt::stop(done, request.count)
    })?;
    let total_ms = begun.elapsed().as_secs_f64() * 1e3;
    bar.finish_and_clear();
    host::validated(device.instance())?;
    Ok(Made {
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
pub fn heading(problem: &Problem, request: &Request, count: u64) -> String {
    format!(
        "{}{} in {} dimension{}, {count} points of {} from {} on",
        problem.integrand().name,
        problem
            .estimator()
            .map_or(String::new(), |name| format!(" by {name}")),
        problem.dimensions(),
        if problem.dimensions() == 1 { "" } else { "s" },
        sampler(request),
        request.first,
    )
}

fn text(problem: &Problem, request: &Request, made: &Made) -> String {
    let estimate = &made.estimate;
    let mean = estimate.mean().unwrap_or(f64::NAN);
    let mut lines = vec![
        heading(problem, request, estimate.count()),
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

fn document(problem: &Problem, request: &Request, made: &Made) -> Value {
    let estimate = &made.estimate;
    let independent = independent(request);
    let mean = estimate.mean();
    let mut document = about(problem, request);
    let result = json!({
        "count": estimate.count(),
        "mean": mean,
        "variance": estimate.variance(),
        "independent": independent,
        "standard_error": estimate.standard_error().filter(|_| independent),
        "truth": problem.truth(),
        "error": mean.map(|mean| mean - problem.truth()),
        "term_error": problem.integrand().error * problem.coefficients().peak,
        "sum": estimate.sum().to_string(),
        "sum_of_squares": estimate.squares().to_string(),
        "scale": estimate.scale(),
        "device": made.device,
        "kernel": made.kernel,
        "device_ms": made.device_ms,
        "total_ms": made.total_ms,
    });
    document.extend(result.as_object().cloned().unwrap_or_default());
    Value::Object(document)
}
