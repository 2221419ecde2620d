//! Windows of files that are refused, and devices that hang while they write to one.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use corput::catalog::{Engine, Request};
use corput::kernels::Generator;
use corput::report::{Element, Format, Keeping, Layout, Sink, Target};
use corput::vulkan::ash::vk;
use corput::vulkan::{Access, Buffer, Device, DeviceInfo, FileWindow};
use corput::{Error, Result};
use serde_json::json;
use tempfile::TempDir;

use super::plan::{Fault, Lie};
use super::support::{pipeline, shader};
use super::work::{on_each, on_each_that_hangs, reference};

/// Three windows: two of 1 MiB, and an end.
const ROWS: u64 = 300_003;
const CHUNK: u64 = 131_072;

fn request() -> Request {
    use corput::catalog::{Options, Sequence};
    Request::new(&Options::new(Sequence::Halton, ROWS)).expect("a request")
}

struct Output {
    folder: TempDir,
    path: PathBuf,
}

impl Output {
    fn new() -> Self {
        let folder = TempDir::new().expect("a folder");
        let path = folder.path().join("p.npy");
        Self { folder, path }
    }

    fn open(&self, resume: bool) -> Result<Sink> {
        let layout = Layout {
            rows: ROWS,
            columns: 2,
            element: Element::F32,
        };
        let keeping = Keeping {
            resume,
            chunk_rows: Some(CHUNK),
        };
        let (target, origin) = (Target::File(self.path.clone()), json!({}).into());
        Sink::keeping(
            &target,
            Format::Npy,
            layout,
            origin,
            keeping,
            &mut |_, _| Ok(()),
        )
    }

    /// Bytes of the file, finished or not.
    fn length(&self) -> u64 {
        let partial = self.folder.path().join(".p.npy.partial");
        let found = fs::metadata(&partial).or_else(|_| fs::metadata(&self.path));
        found.expect("a file").len()
    }

    fn holds_the_points(&self) {
        let bytes = fs::read(&self.path).expect("a file");
        let (words, rest) = bytes[4096..].as_chunks::<4>();
        let words = words.iter().map(|word| u32::from_le_bytes(*word));
        assert!(rest.is_empty() && words.eq(reference(&request())));
    }

    /// Mappings of files in the folder.
    fn mappings(&self) -> usize {
        mappings(self.folder.path())
    }
}

fn mappings(folder: &Path) -> usize {
    let maps = fs::read_to_string("/proc/self/maps").expect("a list");
    maps.matches(folder.to_str().expect("UTF-8")).count()
}

/// By windows as far as that goes, and the rest by copies: the refusal, and the rows before.
fn write(generator: &mut Generator, output: &Output) -> Result<(Option<Error>, u64)> {
    let mut sink = output.open(false)?;
    let refusal = generator.write_windows(&mut sink, &mut |_| Ok(()))?;
    let by_windows = sink.rows();
    assert_eq!(output.mappings(), 0);
    generator.make_range(by_windows..ROWS, &mut |words| sink.write(words))?;
    sink.finish()?;
    Ok((refusal, by_windows))
}

/// Whether the device has windows. Those of lavapipe are known to.
fn has_windows(device: &Arc<Device>, info: &DeviceInfo) -> bool {
    let mut generator = Generator::new(device, &request()).expect("a generator");
    let output = Output::new();
    let (refusal, by_windows) = write(&mut generator, &output).expect("a file");
    output.holds_the_points();
    assert_eq!(refusal.is_none(), by_windows == ROWS);
    if let Some(refusal) = &refusal {
        println!("none on {}: {refusal}", info.name);
        assert!(!info.name.contains("llvmpipe"), "{refusal}");
        assert_eq!(by_windows, 0);
    }
    refusal.is_none()
}

#[test]
fn a_refused_window_is_a_copy() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        if !has_windows(&device, info) {
            return;
        }
        let mut generator = Generator::new(&device, &request()).expect("a generator");
        write(&mut generator, &Output::new()).expect("a file");
        let before = session.live();
        for call in [
            "vkGetMemoryHostPointerPropertiesEXT",
            "vkAllocateMemory",
            "vkCreateBuffer",
            "vkBindBufferMemory",
        ] {
            for nth in 1..=3 {
                let output = Output::new();
                let code = vk::Result::ERROR_OUT_OF_HOST_MEMORY;
                session.fail(Fault {
                    nth,
                    ..Fault::next(call, code)
                });
                let (refusal, rows) = write(&mut generator, &output).expect("a file");
                let refusal = refusal.expect("a refusal").to_string();
                assert!(refusal.starts_with(&format!("{call} failed")), "{refusal}");
                assert_eq!(rows, (nth - 1) * CHUNK, "{call} {nth}");
                assert_eq!((session.fired(), session.live()), (1, before), "{call}");
                assert_eq!(output.mappings(), 0);
                output.holds_the_points();
            }
        }
    });
}

#[test]
fn what_a_driver_says_of_its_memory_is_heeded() {
    let incoherent = Lie::Memory(|said| {
        for one in &mut said.memory_types {
            one.property_flags &= !vk::MemoryPropertyFlags::HOST_COHERENT;
        }
    });
    let coarse = Lie::HostMemory(|said| said.min_imported_host_pointer_alignment = 1 << 30);
    let small = Lie::Maintenance3(|said| said.max_memory_allocation_size = (1 << 20) - 4096);
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        let has = has_windows(&device, info);
        for (lie, words) in [
            (incoherent, "has no coherent memory"),
            (coarse, "the system does not map it"),
            (small, "or allocates less"),
        ] {
            session.lie(&[lie]);
            let listed = instance.devices().expect("a list");
            let device = Device::open(instance, &listed[info.index]).expect("a device");
            assert!(session.fired() > 0);
            let folder = TempDir::new().expect("a folder");
            let file = fs::File::create_new(folder.path().join("f")).expect("a file");
            file.set_len(1 << 20).expect("a length");
            let file = fs::File::options()
                .read(true)
                .write(true)
                .open(folder.path().join("f"));
            let file = Arc::new(file.expect("a file"));
            let before = session.live();
            let refusal = FileWindow::new(&device, &file, 0, 1 << 20).expect_err("a lie");
            let refusal = refusal.to_string();
            assert!(!has || refusal.contains(words), "{refusal}");
            assert_eq!((session.live(), mappings(folder.path())), (before, 0));
        }
    });
}

/// The pages of a window stay, as long as work that was given up may still write there, and the
/// file keeps its length.
#[test]
fn a_device_that_hangs_finds_its_window() {
    on_each_that_hangs(|session, instance, info| {
        for heals in [true, false] {
            session.heal();
            let device = Device::open(instance, info).expect("a device");
            if !has_windows(&device, info) {
                return;
            }
            let output = Output::new();
            let mut sink = output.open(false).expect("a sink");
            let mut generator = Generator::new(&device, &request()).expect("a generator");
            device.set_wait_limit(Duration::from_millis(20));
            let mut points = 0;
            let error = generator
                .write_windows(&mut sink, &mut |more| {
                    points += more;
                    if points > CHUNK {
                        session.fail(Fault::always("vkWaitForFences", vk::Result::TIMEOUT));
                    }
                    Ok(())
                })
                .expect_err("late");
            assert!(matches!(error, Error::Timeout { .. }), "{error}");
            assert_eq!((sink.rows(), output.mappings()), (CHUNK, 1));
            let error = sink.abandon(error);
            assert!(matches!(error, Error::Kept { kept: CHUNK, .. }), "{error}");
            assert!(output.length() > 4096 + 8 * CHUNK, "it was shortened");
            let text = output.open(true).err().expect("it is locked").to_string();
            assert!(text.contains("another run is writing"), "{text}");
            drop(generator);
            assert_eq!(output.mappings(), 1);
            if heals {
                session.heal();
                device.set_wait_limit(Duration::from_secs(30));
                let mut buffer = Buffer::new(&device, 64, Access::Readback).expect("a buffer");
                while output.mappings() > 0 {
                    buffer.read(0, 64, |_| ()).expect("bytes");
                    std::thread::yield_now();
                }
            }
            drop(device);
            assert_eq!(output.mappings(), usize::from(!heals));
        }
    });
}

/// The same where other work hangs, so that nothing is destroyed.
#[test]
fn a_window_outlives_the_device_that_hangs() {
    on_each_that_hangs(|session, instance, info| {
        for heals in [true, false] {
            session.heal();
            let device = Device::open(instance, info).expect("a device");
            if !has_windows(&device, info) {
                return;
            }
            let output = Output::new();
            let sink = output.open(false).expect("a sink");
            let extent = sink.extent(0).expect("space").expect("an extent");
            let window = FileWindow::new(&device, extent.file(), extent.offset(), extent.bytes());
            let window = window.expect("a window");
            let out = "layout(std430, binding = 0) buffer Out { uint o[]; };";
            let pipeline = pipeline(&device, &shader(out, "o[i] = i;"), &[0], 0);
            let mut buffer = Buffer::new(&device, 4096, Access::Readback).expect("a buffer");
            device.set_wait_limit(Duration::from_millis(20));
            session.fail(Fault::always("vkWaitForFences", vk::Result::TIMEOUT));
            let late = device.run(&pipeline, &[(0, &buffer)], &[], 16);
            assert!(matches!(late, Err(Error::Timeout { .. })));
            drop(window);
            assert_eq!(output.mappings(), 1);
            if heals {
                session.heal();
                device.set_wait_limit(Duration::from_secs(30));
                buffer.read(0, 64, |_| ()).expect("bytes");
                assert_eq!(output.mappings(), 0);
            }
            drop((buffer, pipeline, device));
            assert_eq!(output.mappings(), usize::from(!heals));
        }
    });
}
