//! Points in a part of a buffer: there, and nowhere else.

use super::support::{on_each_device, words};
use super::{reference, request, requests};
use corput::Error;
use corput::catalog::{Request, Sequence};
use corput::kernels::Generator;
use corput::vulkan::ash::vk;
use corput::vulkan::{Access, Buffer, BufferSlice, Device, Recording};
use std::sync::Arc;

/// What a buffer holds before.
const BEFORE: u8 = 0xa5;

/// Bytes around the points, which every device can bind.
const MARGIN: u64 = 256;

fn prepared(device: &Arc<Device>, bytes: u64) -> Buffer {
    let mut buffer = Buffer::new(device, bytes, Access::Readback).unwrap();
    buffer.write(0, &vec![BEFORE; bytes as usize]).unwrap();
    buffer
}

/// That a buffer holds these points from the margin on, and else what it held before.
fn holds(buffer: &mut Buffer, request: &Request, start: u64, count: u64) {
    let got = buffer.read(0, buffer.bytes(), words).unwrap();
    let mut wanted = vec![u32::from_ne_bytes([BEFORE; 4]); got.len()];
    let points = reference(request, start, count);
    wanted[MARGIN as usize / 4..][..points.len()].copy_from_slice(&points);
    let differs = got.iter().zip(&wanted).position(|(a, b)| a != b);
    let width = request.words_per_point();
    assert_eq!(
        differs, None,
        "{:?}: points {start} + {count} of {width} words",
        request.sequence
    );
}

#[test]
fn points_in_a_larger_buffer_leave_the_rest_alone() {
    on_each_device(|device| {
        for request in requests() {
            let row = 4 * u64::from(request.words_per_point());
            let mut generator = Generator::new(device, &request).unwrap();
            let all = request.count.min(generator.limit());
            let counts = [
                1, 2, 3, 4, 5, 15, 16, 17, 63, 64, 65, 239, 240, 241, 483, 1003, all,
            ];
            for (start, count) in (0..).zip(counts) {
                let start = start.min(request.count - count);
                // As long as the points, and longer.
                let spare = 4 * (count % 3);
                let mut buffer = prepared(device, MARGIN + count * row + MARGIN);
                let target = buffer.slice(MARGIN, count * row + spare).unwrap();
                let mut work = generator.submit(start, count, &target).unwrap();
                drop(target);
                work.wait().unwrap();
                holds(&mut buffer, &request, start, count);
            }
        }
    });
}

/// One in a command buffer of the caller's, twice and then again, in a buffer of the caller's.
#[test]
fn the_caller_may_record_submit_and_wait() {
    on_each_device(|device| {
        for request in [&requests()[0], &requests()[6]] {
            let row = 4 * u64::from(request.words_per_point());
            let mut generator = Generator::new(device, request).unwrap();
            let mut buffers = [203, 301].map(|count| prepared(device, count * row + 512));
            // SAFETY: plain use of a device that is alive, on one thread; all that is recorded
            // is waited for before anything is dropped. The buffers are the caller's here.
            unsafe {
                let raw = device.raw();
                let create =
                    vk::CommandPoolCreateInfo::default().queue_family_index(device.queue_family());
                let pool = raw.create_command_pool(&create, None).unwrap();
                let one = vk::CommandBufferAllocateInfo::default()
                    .command_pool(pool)
                    .command_buffer_count(1);
                let commands = raw.allocate_command_buffers(&one).unwrap()[0];
                let begin = vk::CommandBufferBeginInfo::default();
                raw.begin_command_buffer(commands, &begin).unwrap();
                let mut recording = Recording::of(device, commands);
                for (buffer, count) in buffers.iter().zip([203, 301]) {
                    let bytes = count * row;
                    let target = BufferSlice::from_raw(device, buffer.raw(), MARGIN, bytes);
                    let target = target.unwrap();
                    generator.record(&mut recording, 9, count, &target).unwrap();
                }
                raw.end_command_buffer(commands).unwrap();
                let create = vk::FenceCreateInfo::default();
                let fence = raw.create_fence(&create, None).unwrap();
                for _ in 0..2 {
                    raw.reset_fences(&[fence]).unwrap();
                    let all = [commands];
                    let submit = [vk::SubmitInfo::default().command_buffers(&all)];
                    raw.queue_submit(device.queue(), &submit, fence).unwrap();
                    raw.wait_for_fences(&[fence], true, u64::MAX).unwrap();
                }
                let refused = recording.submit().unwrap_err();
                assert!(matches!(refused, Error::Arguments { .. }), "{refused}");
                raw.destroy_fence(fence, None);
                raw.destroy_command_pool(pool, None);
            }
            for (buffer, count) in buffers.iter_mut().zip([203, 301]) {
                holds(buffer, request, 9, count);
            }
        }
    });
}

fn refused(error: &Error, part: &str) {
    assert!(matches!(error, Error::Arguments { .. }), "{error}");
    assert!(error.to_string().contains(part), "{error}");
}

#[test]
fn what_a_buffer_cannot_hold_is_refused() {
    on_each_device(|device| {
        let request = request(Sequence::Halton, 1000, 3, None);
        let mut generator = Generator::new(device, &request).unwrap();
        let mut buffer = prepared(device, 8192);
        let alignment = device.info().limits.storage_offset_alignment;
        for (offset, bytes, part) in [
            (0, 0, "the least is 1"),
            (0, 8193, "stay inside"),
            (8192, 1, "stay inside"),
            (u64::MAX, 2, "stay inside"),
        ] {
            refused(&buffer.slice(offset, bytes).unwrap_err(), part);
        }
        if alignment > 1 {
            let part = format!("multiples of {alignment}");
            refused(&buffer.slice(alignment + 1, 64).unwrap_err(), &part);
            // SAFETY: refused before the handle is used.
            let slice = unsafe { BufferSlice::from_raw(device, buffer.raw(), 1, 64) };
            refused(&slice.unwrap_err(), &part);
        }
        // SAFETY: as above.
        let none = unsafe { BufferSlice::from_raw(device, buffer.raw(), 0, 0) };
        refused(&none.unwrap_err(), "the least is 1");

        let target = buffer.slice(0, 1199).unwrap();
        let error = generator.submit(0, 0, &target).unwrap_err();
        assert!(matches!(error, Error::ZeroCount { .. }), "{error}");
        for (start, count, part) in [
            (0, 100, "slice has 1199 bytes"),
            (0, 1001, "the request has 1000"),
            (1000, 1, "the request has 1000"),
            (u64::MAX, 1, "the request has 1000"),
            (0, u64::MAX, "the request has 1000"),
        ] {
            refused(&generator.submit(start, count, &target).unwrap_err(), part);
        }
        drop(target);
        let same = buffer.read(0, 8192, |bytes| bytes.iter().all(|b| *b == BEFORE));
        assert!(same.unwrap());

        // More than one buffer holds at a time: 16 M words.
        let many = super::request(Sequence::Halton, (1 << 24) + 1, 1, None);
        let mut generator = Generator::new(device, &many).unwrap();
        let target = buffer.slice(0, 8192).unwrap();
        let error = generator.submit(0, many.count, &target).unwrap_err();
        refused(&error, "are made at a time");
    });
}

#[test]
fn objects_of_another_device_are_refused() {
    on_each_device(|device| {
        let other = Device::open(device.instance(), device.info()).unwrap();
        for request in [&requests()[1], &requests()[6]] {
            let mut generator = Generator::new(device, request).unwrap();
            let ours = prepared(device, 4096).slice(0, 4096).unwrap();
            let theirs = prepared(&other, 4096).slice(0, 4096).unwrap();
            let error = generator.submit(0, 10, &theirs).unwrap_err();
            refused(&error, "make both on one device");
            let mut recording = Recording::new(&other).unwrap();
            for target in [&ours, &theirs] {
                let error = generator.record(&mut recording, 0, 10, target).unwrap_err();
                refused(&error, "make both on one device");
            }
            // Nothing was recorded, and nothing is a submission too.
            recording.submit().unwrap().wait().unwrap();
        }
    });
}
