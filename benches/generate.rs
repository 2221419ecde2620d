//! `cargo bench`: the jobs of `corput bench` on the default device, as text.

use corput::vulkan::{Device, Instance, InstanceOptions, select};

fn main() -> corput::Result<()> {
    let instance = Instance::new(&InstanceOptions::default())?;
    let devices = instance.devices()?;
    let device = Device::open(&instance, select(&devices, None)?)?;
    println!("{} ({})", device.info().name, device.info().driver_info);
    for job in corput::bench::jobs()? {
        let m = corput::bench::on_device(&device, &job)?;
        println!(
            "{:<26} {:>8.2} ms  ± {:>6.2}  {:>6.2} x fill  {:.3} G points/s",
            m.name,
            m.median_s * 1e3,
            m.deviation_s * 1e3,
            m.fills(),
            m.rate() / 1e9
        );
    }
    Ok(())
}
