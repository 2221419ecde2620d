//! Several dispatches in one submission.

use corput::vulkan::{Access, Buffer, Dispatch, MAX_BATCH};

use super::support::{on_each_device, pipeline, shader, words};
use super::{OUT, add_one};

/// Each sees what the one before it wrote, and takes its own time.
#[test]
fn batches_run_in_order_and_are_timed_one_by_one() {
    let turns = "for (uint k = 0u; k < o[0]; k++) x = x * 1664525u + k; o[i + 1u] = x;";
    let long = shader(OUT, &format!("uint x = i; {turns}"));
    on_each_device(|device| {
        let once = pipeline(device, &add_one(), &[0], 0);
        let mut out = Buffer::new(device, 256, Access::Readback).unwrap();
        out.fill_zero().unwrap();
        let buffers = [(0, &out)];
        let one = |groups| Dispatch {
            buffers: &buffers,
            push: &[],
            groups,
        };
        let times = device.run_batch(&once, &vec![one(1); MAX_BATCH]).unwrap();
        assert_eq!(times.len(), MAX_BATCH);
        let none = device.run_batch(&once, &[one(0), one(1), one(0)]).unwrap();
        assert_eq!(none.len(), 3);
        assert!(device.run_batch(&once, &[]).unwrap().is_empty());
        let refused = device.run_batch(&once, &vec![one(1); MAX_BATCH + 1]);
        assert_eq!(refused.unwrap_err().exit_code(), 2);
        let wrong = Dispatch {
            push: &[0; 4],
            ..one(1)
        };
        assert!(device.run_batch(&once, &[one(1), wrong]).is_err());
        let counted = out.read(0, 256, words).unwrap();
        assert!(
            counted.iter().all(|n| *n == MAX_BATCH as u32 + 1),
            "{counted:?}"
        );

        // A long one between short ones does not lengthen them.
        let pipeline = pipeline(device, &long, &[0], 0);
        let blocks = [10u32, 40_000, 10].map(|turns| {
            let mut block = Buffer::new(device, 1 << 18, Access::Upload).unwrap();
            block.write(0, &turns.to_ne_bytes()).unwrap();
            block
        });
        let bound = blocks.each_ref().map(|block| [(0, block)]);
        let batch = bound.each_ref().map(|buffers| Dispatch {
            buffers,
            push: &[],
            groups: 64,
        });
        device.run_batch(&pipeline, &batch).unwrap();
        let times = device.run_batch(&pipeline, &batch).unwrap();
        if device.info().limits.timestamp_valid_bits > 0 {
            let times: Vec<f64> = times.into_iter().flatten().collect();
            assert!(
                matches!(times[..], [a, b, c] if a > 0.0 && c > 0.0 && b > 10.0 * a.min(c)),
                "{times:?}"
            );
        }
    });
}
