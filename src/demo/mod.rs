//! The demonstration: points, directions and the irradiance of a real map, all checked.

mod irradiance;

pub use irradiance::{Estimate, estimates};

use crate::Result;
use crate::bulk::Reference;
use crate::catalog::{Engine, Map, Mapping, Options, Request, Sequence};
use crate::image::Image;
use crate::kernels::Generator;
use crate::plot::{LinesStyle, ScatterStyle, Series, error_lines, points_and_directions, to_png};
use crate::report::{self, Element, Format, Layout, Sink, Target};
use crate::vulkan::Device;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Points and directions that the demonstration makes: 2^24.
pub const POINTS: u64 = 1 << 24;

/// Points of the scatter plot.
const PLOTTED: usize = 1024;

/// What one run of a request found.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// What was made.
    pub name: &'static str,
    /// Results that were compared, all of them.
    pub compared: u64,
    /// Results that differed from the CPU's.
    pub mismatches: u64,
    /// Time on the device, in seconds.
    pub device_s: f64,
    /// The first results, for a picture.
    pub head: Vec<u32>,
}

/// Everything that the demonstration found.
#[derive(Clone, Debug)]
pub struct Demo {
    /// Points, then directions.
    pub comparisons: Vec<Comparison>,
    /// The map's size.
    pub size: [u32; 2],
    /// Negative texels of the map that count as zero.
    pub clamped: u64,
    /// Irradiance, by axis and count.
    pub estimates: Vec<Estimate>,
    /// Files written.
    pub files: Vec<PathBuf>,
}

impl Demo {
    /// Whether every value was the CPU's.
    #[must_use]
    pub fn all_equal(&self) -> bool {
        self.comparisons
            .iter()
            .all(|c| c.mismatches == 0 && c.compared == POINTS)
            && self.estimates.iter().all(|e| e.equal)
    }
}

/// Hears of each step what it makes, how many are made and how many will be. Its error
/// stops the work, with no file left.
pub type Watch<'a> = dyn FnMut(&str, u64, u64) -> Result<()> + 'a;

/// Runs the demonstration with a map into a folder, which must exist.
///
/// # Errors
/// Those of the device, of the files and of `watch`.
pub fn run(
    device: &Arc<Device>,
    image: &Image,
    folder: &Path,
    watch: &mut Watch<'_>,
) -> Result<Demo> {
    let points = Request::new(&Options::new(Sequence::Halton, POINTS))?;
    let path = folder.join("points.npy");
    let layout = Layout {
        rows: POINTS,
        columns: points.words_per_point(),
        element: Element::F32,
    };
    let mut sink = Sink::open(
        &Target::File(path.clone()),
        Format::Npy,
        layout,
        serde_json::Value::Null,
    )?;
    let compared_points = compare(device, "Halton points", &points, watch, &mut |words| {
        sink.write(words)
    })?;
    let mut options = Options::new(Sequence::Halton, POINTS);
    options.map = Some(Mapping::new(Map::from_name("cosine-hemisphere")?, &[])?);
    let directions = Request::new(&options)?;
    let compared_directions = compare(
        device,
        "cosine-weighted directions",
        &directions,
        watch,
        &mut |_| Ok(()),
    )?;

    let estimates = estimates(device, image, watch)?;
    sink.finish()?;
    let mut files = vec![path];
    files.extend(pictures(
        folder,
        &compared_points,
        &compared_directions,
        &estimates,
    )?);
    files.push(save(
        folder,
        "irradiance.csv",
        table(&estimates).as_bytes(),
    )?);
    Ok(Demo {
        comparisons: vec![compared_points, compared_directions],
        size: [image.width, image.height],
        clamped: image.clamped as u64,
        estimates,
        files,
    })
}

/// Makes a request on the device and on the CPU, and compares every word.
fn compare(
    device: &Arc<Device>,
    name: &'static str,
    request: &Request,
    watch: &mut Watch<'_>,
    keep: &mut dyn FnMut(&[u32]) -> Result<()>,
) -> Result<Comparison> {
    let mut generator = Generator::new(device, request)?;
    let mut reference = Reference::new(request);
    let width = request.words_per_point() as usize;
    let mut result = Comparison {
        name,
        compared: 0,
        mismatches: 0,
        device_s: 0.0,
        head: Vec::new(),
    };
    let mut expected = Vec::new();
    let mut start = 0;
    while start < request.count {
        let points = generator.chunk().min(request.count - start);
        let timing = generator.dispatch(start, points)?;
        result.device_s += timing.device_ns.unwrap_or(timing.host_ns) * 1e-9;
        expected.resize(points as usize * width, 0);
        reference.fill(start, &mut expected)?;
        generator.read(points, |words| {
            let rows = words.chunks_exact(width).zip(expected.chunks_exact(width));
            result.mismatches += rows.filter(|(got, want)| got != want).count() as u64;
            if result.head.is_empty() {
                result.head = words[..words.len().min(PLOTTED * width)].to_vec();
            }
            keep(words)
        })??;
        result.compared += points;
        generator.adapt(points, &timing);
        start += points;
        watch(name, start, request.count)?;
    }
    Ok(result)
}

fn pictures(
    folder: &Path,
    points: &Comparison,
    directions: &Comparison,
    estimates: &[Estimate],
) -> Result<Vec<PathBuf>> {
    let float = f32::from_bits;
    let flat: Vec<[f32; 2]> = points
        .head
        .chunks_exact(2)
        .map(|p| [float(p[0]), float(p[1])])
        .collect();
    let lifted: Vec<[f32; 3]> = directions
        .head
        .chunks_exact(3)
        .map(|d| [float(d[0]), float(d[1]), float(d[2])])
        .collect();
    let style = ScatterStyle {
        x_label: "base 2",
        y_label: "base 3",
        ..ScatterStyle::titled("The first 1,024 Halton points, and the directions made of them")
    };
    let scatter = points_and_directions(&flat, &lifted, &style)?;
    let axes = ["+x", "−x", "+y", "−y", "+z", "−z"];
    let series: Vec<Series> = axes
        .iter()
        .enumerate()
        .map(|(axis, name)| Series {
            name: (*name).to_owned(),
            points: estimates
                .iter()
                .filter(|e| e.axis as usize == axis && e.relative_error() > 0.0)
                .map(|e| (f64::from(e.count), e.relative_error()))
                .collect(),
        })
        .collect();
    let lines = error_lines(
        &series,
        &LinesStyle {
            title: "Irradiance by Hammersley points and cosine-weighted directions",
            x_label: "points N",
            y_label: "relative error",
            ..LinesStyle::default()
        },
    )?;
    let mut files = Vec::new();
    for (name, svg) in [("points", scatter), ("irradiance", lines)] {
        files.push(save(folder, &format!("{name}.svg"), svg.as_bytes())?);
        files.push(save(folder, &format!("{name}.png"), &to_png(&svg, 2.0)?)?);
    }
    Ok(files)
}

/// The estimates as CSV.
fn table(estimates: &[Estimate]) -> String {
    let mut text = String::from(
        "axis,count,red,green,blue,true_red,true_green,true_blue,relative_error,device_ms,equal_to_cpu\n",
    );
    for e in estimates {
        let [r, g, b] = e.estimate;
        let [tr, tg, tb] = e.truth;
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{},{},{r},{g},{b},{tr},{tg},{tb},{:.6e},{:.4},{}",
            e.axis_name(),
            e.count,
            e.relative_error(),
            e.device_ms,
            e.equal
        );
    }
    text
}

/// Writes a file of the folder.
fn save(folder: &Path, name: &str, bytes: &[u8]) -> Result<PathBuf> {
    let path = folder.join(name);
    report::save(&path, bytes)?;
    Ok(path)
}
