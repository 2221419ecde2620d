//! `corput check` on every device present: zero mismatches, every bound kept.

mod support;

use corput::check;

#[test]
fn every_row_passes_on_every_device() {
    support::on_each_device(|device| {
        let outcome = check::run(device, &check::Options::default(), &mut |row| {
            println!(
                "{:?} {:<36} {:<18} {:>8} {:?} {:?} {} {}",
                row.verdict,
                row.name,
                row.kernel,
                row.compared,
                row.mismatches,
                row.worst,
                row.unit,
                row.witness
            );
        })
        .unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(outcome.failures(), 0);
    });
}
