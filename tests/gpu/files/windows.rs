//! Files that a device writes in place, by windows, and those that it does not.

use super::full::{Mount, mount};
use super::killed::{kill_command, random};
use super::support::{instance, skips, turn};
use super::{Desk, Run};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// `off` or `require`.
pub(super) const VARIABLE: &str = "CORPUT_WINDOWS";

/// Chunks of 1 MiB, and an end that is no whole page.
const POINTS: &str = "sobol --count 1000001 --dims 4 --chunk-rows 65536";

/// A device, as `--device` takes it.
pub(super) struct Listed {
    pub index: usize,
    pub name: String,
    /// Whether it has windows, as lavapipe has.
    has: bool,
}

impl Listed {
    /// What the variable may say.
    pub(super) fn wishes(&self) -> &'static [&'static str] {
        match self.has {
            true => &["require", "off", ""],
            false => &["off", ""],
        }
    }
}

/// All devices. What their windows cannot do, the message says.
pub(super) fn devices() -> Vec<Listed> {
    if skips() {
        return Vec::new();
    }
    let turn = turn();
    let listed = instance(&turn).devices().unwrap();
    drop(turn);
    let desk = Desk::new();
    let look = |info: corput::vulkan::DeviceInfo| {
        let line = format!("generate {POINTS} --out p.npy --device {}", info.index);
        let run = wishing(&desk, "require", &line);
        if run.code != Some(0) {
            run.expect(2, &["a window of 1048576 bytes", &info.name]);
            assert!(!info.name.contains("llvmpipe"), "{}", run.stderr);
        }
        let has = run.code == Some(0);
        println!("{}: {}", info.name, if has { "windows" } else { "copies" });
        Listed {
            index: info.index,
            name: info.name,
            has,
        }
    };
    listed.into_iter().map(look).collect()
}

fn command(desk: &Desk, wish: &str, line: &str) -> Command {
    let mut command = desk.command(line);
    command.env(VARIABLE, wish);
    command
}

fn wishing(desk: &Desk, wish: &str, line: &str) -> Run {
    Run::of(line, command(desk, wish, line))
}

#[test]
fn windows_and_copies_give_the_same_file() {
    let points = [
        POINTS,
        "halton --count 400003 --dims 3 --chunk-rows 131072 --fractions --format raw",
        "sobol --count 300001 --chunk-rows 131072 --map ggx-vndf --param alpha=0.5 --param wo=0,0,1",
        "halton --count 200000 --dims 2 --map cosine-hemisphere --with-pdf --chunk-rows 65536",
        // Chunks of more than a window, the second of them short.
        "lattice --count 300000 --dims 64",
    ];
    for device in devices() {
        for points in points {
            let desk = Desk::new();
            let mut files = Vec::new();
            for wish in device.wishes() {
                let line = format!("generate {points} --out p.npy --device {}", device.index);
                wishing(&desk, wish, &line).expect(0, &[]);
                assert_eq!(desk.names(), ["p.npy", "p.npy.json"]);
                files.push((desk.bytes("p.npy"), desk.bytes("p.npy.json")));
            }
            files.dedup();
            assert_eq!(files.len(), 1, "`{points}` on {}", device.name);
            desk.run(&format!("generate {points} --out c.npy --device cpu"))
                .expect(0, &[]);
            assert!(desk.bytes("c.npy") == files[0].0, "`{points}`");
            desk.run("verify p.npy --device cpu").expect(0, &[]);
        }
    }
}

#[test]
fn a_run_that_was_killed_goes_on_either_way() {
    const KILLS: usize = 24;
    for device in devices().into_iter().filter(|device| device.has) {
        let desk = Desk::new();
        let line = |count: u64| {
            let points = POINTS.replace("1000001", &count.to_string());
            format!("generate {points} --scramble owen-hash --out p.npy")
        };
        let line = line(4_000_001);
        let there = format!("{line} --device {}", device.index);
        let start = Instant::now();
        wishing(&desk, "require", &there).expect(0, &[]);
        let mut whole = start.elapsed();
        let expected = (desk.bytes("p.npy"), desk.bytes("p.npy.json"));
        let (mut state, mut kills, mut chunks) = (5, 0, 0);
        for _ in 0..4 * KILLS {
            for name in ["p.npy", "p.npy.json"] {
                std::fs::remove_file(desk.path(name)).unwrap();
            }
            let wish = if kills % 3 == 2 { "off" } else { "require" };
            let after = whole.mul_f64(random(&mut state));
            let killed = kill_command(command(&desk, wish, &there), after);
            whole = whole.mul_f64(if killed { 1.05 } else { 0.8 });
            kills += usize::from(killed);
            chunks += usize::from(desk.chunks() > 0);
            let by = if kills % 2 == 0 { "require" } else { "off" };
            wishing(&desk, by, &format!("{there} --resume")).expect(0, &[]);
            let found = (desk.bytes("p.npy"), desk.bytes("p.npy.json"));
            assert!(found == expected, "kill {kills}");
            assert_eq!(desk.names(), ["p.npy", "p.npy.json"]);
            if kills == KILLS {
                break;
            }
        }
        assert_eq!(kills, KILLS, "killed while they ran");
        assert!(
            chunks >= KILLS / 4,
            "only {chunks} had a chunk to go on from"
        );
        // The CPU goes on from windows, too.
        std::fs::remove_file(desk.path("p.npy")).unwrap();
        kill_command(command(&desk, "require", &there), whole.div_f64(2.0));
        desk.run(&format!("{line} --device cpu --resume"))
            .expect(0, &[]);
        assert!(desk.bytes("p.npy") == expected.0);
    }
}

/// An error, and not the signal of a page for which there is no space.
#[test]
fn a_full_disk_is_an_error_of_a_window_too() {
    let words = [
        "cannot write",
        "free space",
        " of 1000001 rows stay in",
        "--resume",
    ];
    for device in devices().into_iter().filter(|device| device.has) {
        let desk = Desk::new();
        let points = |out: &str| format!("generate {POINTS} --out {out} --device {}", device.index);
        wishing(&desk, "off", &points("whole.npy")).expect(0, &[]);
        let Some(disk) = Mount::new(desk.path("disk"), "size=8m") else {
            eprintln!("SKIPPED: no file system may be mounted here");
            return;
        };
        let line = points("disk/p.npy");
        for line in [line.clone(), format!("{line} --resume")] {
            let run = wishing(&desk, "require", &line);
            run.expect(4, &words);
            run.expect(4, &["No space left"]);
            // What there was space for is complete: seven chunks and a header, after a line that
            // says what they are of.
            let journal = std::fs::read_to_string(disk.0.join(".p.npy.partial.json")).unwrap();
            assert_eq!(journal.matches('\n').count(), 8, "{journal}");
        }
        assert!(mount(&["-o", "remount,size=64m"], &disk.0));
        wishing(&desk, "require", &format!("{line} --resume")).expect(0, &[]);
        assert!(desk.bytes("disk/p.npy") == desk.bytes("whole.npy"));
    }
}

#[test]
fn a_file_at_its_limit_is_an_error_of_a_window_too() {
    for device in devices().into_iter().filter(|device| device.has) {
        let desk = Desk::new();
        let line = format!("generate {POINTS} --out p.npy --device {}", device.index);
        let mut limited = Command::new("sh");
        limited
            .current_dir(desk.path(""))
            .args(["-c", "trap '' XFSZ; ulimit -f 8192; exec \"$0\" \"$@\""])
            .arg(env!("CARGO_BIN_EXE_corput"))
            .args(line.split_whitespace())
            .env(VARIABLE, "require");
        Run::of(&line, limited).expect(4, &["cannot write p.npy", "rows stay in .p.npy.partial"]);
        assert!(desk.chunks() >= 3);
        wishing(&desk, "require", &format!("{line} --resume")).expect(0, &[]);
    }
}

#[test]
fn a_signal_is_heard_between_dispatches() {
    for device in devices().into_iter().filter(|device| device.has) {
        let desk = Desk::new();
        let line = format!(
            "generate sobol --count 40000000 --dims 4 --scramble owen --chunk-rows 65536 \
             --out p.npy --device {}",
            device.index
        );
        let mut command = command(&desk, "require", &line);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let running = desk.follow(command, &line, 3);
        running.signal("INT");
        let sent = Instant::now();
        let said = running.end(&line);
        assert!(sent.elapsed() < Duration::from_secs(20));
        said.expect(
            4,
            &[
                "interrupted after ",
                " rows stay in .p.npy.partial",
                "--resume",
            ],
        );
        assert_eq!(desk.names(), [".p.npy.partial", ".p.npy.partial.json"]);
        // The space of what is not kept is given back.
        let length = std::fs::metadata(desk.path(".p.npy.partial"))
            .unwrap()
            .len();
        assert_eq!(length, 4096 + ((desk.chunks() as u64) << 20));
    }
}

#[test]
fn what_stands_in_the_way_of_windows_is_said_where_they_are_required() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "generate sobol --count 1000";
    for out in ["p.csv", "p.npy"] {
        let line = format!("{line} --out {out}");
        let run = wishing(&desk, "require", &line);
        run.expect(2, &["windows of the output", "at least 1 MiB"]);
        assert!(desk.names().is_empty());
        wishing(&desk, "", &line).expect(0, &[]);
        let words = ["CORPUT_WINDOWS=on", "`off` or `require`", "unset it"];
        wishing(&desk, "on", &line).expect(2, &words);
        for name in [out.to_owned(), format!("{out}.json")] {
            std::fs::remove_file(desk.path(&name)).unwrap();
        }
    }
}
