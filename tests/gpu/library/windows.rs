//! Points in windows of files.

use super::support::{on_each_device, on_one_device, words};
use super::{reference, requests};
use corput::Error;
use corput::kernels::Generator;
use corput::vulkan::{Access, Buffer, Device, FileWindow};
use std::fs::{self, File};
use std::path::Path;
use std::sync::Arc;
use tempfile::TempDir;

/// What the file holds before.
const BEFORE: u8 = 0xa5;

/// Where the window begins.
const AT: u64 = 8192;

fn file(folder: &TempDir, bytes: u64) -> Arc<File> {
    let path = folder.path().join("f");
    fs::write(&path, vec![BEFORE; bytes as usize]).unwrap();
    let opened = File::options().read(true).write(true).open(path);
    Arc::new(opened.unwrap())
}

fn mappings(folder: &Path) -> usize {
    let maps = fs::read_to_string("/proc/self/maps").unwrap();
    maps.matches(folder.to_str().unwrap()).count()
}

#[test]
fn a_device_writes_a_file_and_nothing_beside_its_window() {
    on_each_device(|device| {
        let mut windows = 0;
        for request in requests() {
            let folder = TempDir::new().unwrap();
            let points = request.count.min(50_003);
            let row = 4 * u64::from(request.words_per_point());
            let end = AT + points * row;
            let file = file(&folder, end + 5000);
            let window = match FileWindow::new(device, &file, AT, points * row) {
                Ok(window) => window,
                Err(refusal) => {
                    println!("none on {}: {refusal}", device.info().name);
                    assert!(!device.info().name.contains("llvmpipe"), "{refusal}");
                    continue;
                }
            };
            windows += 1;
            assert_eq!((window.bytes(), mappings(folder.path())), (points * row, 1));
            let mut generator = Generator::new(device, &request).unwrap();
            let slice = window.slice();
            let mut work = generator.submit(3, points - 3, &slice).unwrap();
            // What is made of a window holds it.
            drop((window, slice));
            assert_eq!(mappings(folder.path()), 1);
            work.wait().unwrap();
            assert_eq!(mappings(folder.path()), 0);
            let bytes = fs::read(folder.path().join("f")).unwrap();
            let made = reference(&request, 3, points - 3);
            let made: Vec<u8> = made.iter().flat_map(|word| word.to_le_bytes()).collect();
            let (before, rest) = bytes.split_at(AT as usize);
            let (there, after) = rest.split_at(made.len());
            assert!(there == made, "{:?}", request.sequence);
            assert!(before.iter().chain(after).all(|byte| *byte == BEFORE));
            assert_eq!(bytes.len() as u64, end + 5000);
        }
        println!("{windows} windows on {}", device.info().name);
    });
}

#[test]
fn what_cannot_be_mapped_is_refused() {
    on_each_device(|device| {
        let folder = TempDir::new().unwrap();
        let path = folder.path().join("f");
        let file = file(&folder, 1 << 16);
        let can = FileWindow::new(device, &file, 0, 1 << 16).is_ok();
        let read_only = Arc::new(File::open(&path).unwrap());
        let (_, pipe) = std::io::pipe().unwrap();
        let pipe = Arc::new(File::from(std::os::fd::OwnedFd::from(pipe)));
        for (file, offset, bytes) in [
            (&file, 0, 0),
            (&file, 100, 4096),
            // Past the end, where there are no pages.
            (&file, 4096, 1 << 16),
            (&file, 1 << 20, 4096),
            (&file, 0, u64::MAX),
            (&file, u64::MAX, 4096),
            (&read_only, 0, 4096),
            (&pipe, 0, 4096),
        ] {
            let error = FileWindow::new(device, file, offset, bytes).unwrap_err();
            assert!(matches!(error, Error::Arguments { .. }), "{error}");
            let text = error.to_string();
            let reason = match bytes {
                u64::MAX => "binds at most",
                _ => "does not map it",
            };
            assert!(!can || text.contains(reason), "{text}");
        }
        assert_eq!(mappings(folder.path()), 0);
    });
}

#[test]
fn a_device_of_the_callers_has_no_windows() {
    on_one_device(|device| {
        let folder = TempDir::new().unwrap();
        let file = file(&folder, 1 << 16);
        // SAFETY: the loader's own functions.
        let entry = unsafe { corput::vulkan::ash::Entry::load() }.unwrap();
        // SAFETY: the handles are of one device, which outlives the wrapper; nobody else uses
        // its queue.
        let wrapped = unsafe {
            Device::from_existing(
                &entry,
                device.instance().raw(),
                device.physical(),
                device.raw().clone(),
                device.queue(),
                device.queue_family(),
            )
        };
        let error = FileWindow::new(&wrapped.unwrap(), &file, 0, 1 << 16).unwrap_err();
        let text = error.to_string();
        assert!(
            text.contains("was not opened with VK_EXT_external_memory_host"),
            "{text}"
        );
    });
}

/// Longer than one submission, so that later ones begin within the buffer.
#[test]
fn any_number_of_points_is_placed_in_a_buffer() {
    on_each_device(|device| {
        for request in requests() {
            let row = 4 * u64::from(request.words_per_point());
            let (start, count) = (1, request.count - 1);
            let mut buffer = Buffer::new(device, count * row + 256, Access::Readback).unwrap();
            let before = [BEFORE; 256];
            buffer.write(count * row, &before).unwrap();
            let mut generator = Generator::new(device, &request).unwrap();
            let (mut calls, mut told) = (0, 0);
            let slice = buffer.slice(0, count * row).unwrap();
            generator
                .place(start, count, &slice, &mut |points| {
                    // Where every device can bind a buffer.
                    assert!((told * row).is_multiple_of(256), "{told} rows of {row}");
                    calls += 1;
                    told += points;
                    Ok(())
                })
                .unwrap();
            assert_eq!(told, count);
            assert!(calls > 1 || count * row < 1 << 18, "{calls} submissions");
            // An error stops it after what was begun.
            let mut calls = 0;
            let stopped = generator.place(start, count, &slice, &mut |_| {
                calls += 1;
                Err(Error::ZeroCount { what: "a test" })
            });
            assert!(matches!(stopped, Err(Error::ZeroCount { .. })) && calls == 1);
            for (start, count, bytes) in [
                (2, count, count * row),
                (start, count, count * row - 4),
                (u64::MAX, 1, row),
            ] {
                let slice = buffer.slice(0, bytes).unwrap();
                let error = generator.place(start, count, &slice, &mut |_| Ok(()));
                assert!(matches!(error, Err(Error::Arguments { .. })));
            }
            generator.place(0, 0, &slice, &mut |_| Ok(())).unwrap();
            drop(slice);
            let made = buffer.read(0, count * row, words).unwrap();
            assert!(
                made == reference(&request, start, count),
                "{:?}",
                request.sequence
            );
            let after = buffer.read(count * row, 256, <[u8]>::to_vec).unwrap();
            assert!(after == before);
        }
    });
}
