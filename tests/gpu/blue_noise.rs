//! Dither masks on every device present: the CPU's, bit for bit.

mod support;

use corput::Error;
use corput::blue_noise::{MaskShape, void_and_cluster};
use corput::kernels::VoidAndCluster;
use corput::vulkan::{Device, DeviceKind};
use std::sync::Arc;
use std::time::Instant;

fn assert_same(device: &Arc<Device>, sides: [u64; 3], seed: u64) {
    let shape = MaskShape::new(sides[0], sides[1], sides[2]).expect("a shape");
    let kernel = VoidAndCluster::new(device).unwrap_or_else(|error| panic!("{error}"));
    let start = Instant::now();
    let mut ranked = 0;
    let found = kernel.ranks(shape, seed, &mut |more| {
        ranked += more;
        Ok(())
    });
    println!("{sides:?}: {:?}", start.elapsed());
    let found = found.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(ranked, shape.pixels());
    assert!(found == void_and_cluster(shape, seed), "{sides:?}");
}

/// Sides below, at and above what energy reaches, rows longer than a workgroup, time.
#[test]
fn masks_are_those_of_the_cpu() {
    support::on_each_device(|device| {
        for (seed, sides) in (0..).zip([
            [4, 4, 1],
            [17, 16, 1],
            [31, 33, 1],
            [129, 8, 1],
            [256, 4, 1],
            [4, 256, 1],
            [8, 8, 16],
            [11, 5, 7],
        ]) {
            assert_same(device, sides, seed);
        }
    });
}

/// The usual sizes, on the device that is quickest here.
#[test]
fn larger_masks_are_those_of_the_cpu() {
    support::on_one_device(|device| {
        assert_same(device, [128, 128, 1], 1);
        // As many rows as shared memory holds.
        assert_same(device, [4, 64, 16], 4);
        // The largest take drivers on a CPU a quarter of a minute each.
        if device.info().kind != DeviceKind::Cpu {
            assert_same(device, [64, 64, 16], 2);
            assert_same(device, [256, 256, 1], 3);
        }
    });
}

#[test]
fn work_can_be_stopped() {
    support::on_one_device(|device| {
        let kernel = VoidAndCluster::new(device).unwrap_or_else(|error| panic!("{error}"));
        let shape = MaskShape::new(64, 64, 1).expect("a shape");
        let stopped = kernel.ranks(shape, 1, &mut |_| {
            Err(Error::Interrupted { done: 1, total: 2 })
        });
        assert!(matches!(stopped, Err(Error::Interrupted { .. })));
    });
}
