use corput::{catalog::*, kernels::*, vulkan::*};
use std::time::Instant;
fn main() {
    let inst = Instance::new(&InstanceOptions { validation: false }).unwrap();
    for info in inst.devices().unwrap() {
        let dev = Device::open(&inst, &info).unwrap();
        println!("{}", info.name);
        if let Ok(x) = std::env::var("ONLY") {
            if !info.name.contains(&x) {
                continue;
            }
        }
        for (dims, general, map) in [
            (2u64, true, false),
            (2, false, false),
            (2, false, true),
            (4, false, false),
        ] {
            let n: u64 = if info.name.contains("Swift") {
                1 << 16
            } else {
                1 << 22
            };
            let mut o = Options::new(Sequence::Halton, n);
            o.dimensions = Some(dims);
            if map {
                o.map = Some(Map::from_name("cosine-hemisphere-polar").unwrap());
            }
            let r = Request::new(&o).unwrap();
            let t = Instant::now();
            let mut g = if general {
                Generator::general(&dev, &r).unwrap()
            } else {
                Generator::new(&dev, &r).unwrap()
            };
            let tp = t.elapsed();
            let lim = g.limit().min(n);
            let t = Instant::now();
            g.dispatch(0, 64).unwrap();
            let t0 = t.elapsed();
            let mut best = f64::MAX;
            for _ in 0..5 {
                let t = g.dispatch(0, lim).unwrap();
                best = best.min(t.device_ns.unwrap());
            }
            println!(
                "{dims} {general} {map} {} pipe {tp:?} first {t0:?} rate {:.3} Gpoints/s {:.2} GB/s",
                g.kernel_name(),
                lim as f64 / best,
                lim as f64 * r.words_per_point() as f64 * 4.0 / best
            );
        }
    }
    let mut v = vec![1u8; 1 << 27];
    for i in 0..4u8 {
        let t = Instant::now();
        std::hint::black_box(&mut v).fill(i);
        std::hint::black_box(&v);
        println!(
            "memset1 {:.2} GB/s",
            (1u64 << 27) as f64 / t.elapsed().as_nanos() as f64
        );
    }
}
