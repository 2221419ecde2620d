//! Rows on several threads, since drivers compile on the thread that asks.

use super::rows::Row;
use crate::Result;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::time::Instant;

/// Makes a row.
type Check<'a> = Box<dyn Fn() -> Result<Row> + Send + Sync + 'a>;

/// A row to make.
pub(super) struct Task<'a> {
    /// What it is called where there is no time for it.
    pub(super) name: String,
    pub(super) check: Check<'a>,
}

/// A row; or the name of one that no time was left for.
type Made = core::result::Result<Row, String>;

/// Threads at most: each may hold two of the largest buffers.
const THREADS: usize = 4;

/// The rows of all tasks in their order, and the names of those that would have begun after
/// the deadline; `progress` sees each row once all before it have ended. The first error in
/// that order ends it.
///
/// # Errors
/// Those of the tasks.
pub(super) fn run(
    tasks: &[Task],
    deadline: Option<Instant>,
    progress: &mut dyn FnMut(&Row),
) -> Result<(Vec<Row>, Vec<String>)> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let next = AtomicUsize::new(0);
    let (send, receive) = mpsc::channel();
    std::thread::scope(|scope| {
        for _ in 0..cores.min(THREADS) {
            let (send, next) = (send.clone(), &next);
            scope.spawn(move || {
                loop {
                    let at = next.fetch_add(1, Ordering::Relaxed);
                    let Some(task) = tasks.get(at) else { break };
                    // No one listens any more after an error.
                    if send.send((at, made(task, deadline))).is_err() {
                        break;
                    }
                }
            });
        }
        drop(send);
        let (mut early, mut rows) = (BTreeMap::new(), Vec::new());
        let mut left_out = Vec::new();
        let mut due = 0;
        for (at, made) in receive {
            early.insert(at, made);
            while let Some(made) = early.remove(&due) {
                due += 1;
                match made? {
                    Ok(row) => {
                        progress(&row);
                        rows.push(row);
                    }
                    Err(name) => left_out.push(name),
                }
            }
        }
        Ok((rows, left_out))
    })
}

fn made(task: &Task, deadline: Option<Instant>) -> Result<Made> {
    let begun = Instant::now();
    if deadline.is_some_and(|deadline| begun >= deadline) {
        return Ok(Err(task.name.clone()));
    }
    let mut row = (task.check)()?;
    row.seconds = begun.elapsed().as_secs_f64();
    Ok(Ok(row))
}

#[cfg(test)]
mod tests {
    use super::{Row, Task, run};
    use crate::Error;
    use std::time::{Duration, Instant};

    fn refused() -> Error {
        Error::Arguments {
            asked: String::new(),
            limit: String::new(),
            remedy: String::new(),
        }
    }

    fn task(
        name: &str,
        check: impl Fn() -> crate::Result<Row> + Send + Sync + 'static,
    ) -> Task<'static> {
        Task {
            name: name.to_owned(),
            check: Box::new(check),
        }
    }

    /// Rows of which the later end first.
    fn tasks() -> Vec<Task<'static>> {
        let one = |at: u64| {
            task("", move || {
                std::thread::sleep(Duration::from_millis(20 - 2 * at));
                Ok(Row::exact(&at.to_string(), ""))
            })
        };
        (0..10).map(one).collect()
    }

    #[test]
    fn rows_come_in_order_and_errors_end_them() {
        let mut seen = Vec::new();
        let (rows, left_out) =
            run(&tasks(), None, &mut |row| seen.push(row.name.clone())).expect("rows");
        assert!(rows.iter().all(|row| row.seconds > 0.0) && left_out.is_empty());
        let names: Vec<String> = rows.into_iter().map(|row| row.name).collect();
        assert_eq!(names, ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"]);
        assert_eq!(names, seen);

        let mut tasks = tasks();
        tasks.insert(3, task("", || Err(refused())));
        let mut seen = 0;
        assert!(run(&tasks, None, &mut |_| seen += 1).is_err());
        assert_eq!(seen, 3);
    }

    #[test]
    fn no_row_begins_after_the_deadline() {
        let slow = || {
            std::thread::sleep(Duration::from_millis(50));
            Ok(Row::exact("slow", ""))
        };
        let tasks: Vec<Task> = (0..100).map(|_| task("slow", slow)).collect();
        let deadline = Instant::now() + Duration::from_millis(20);
        let (rows, left_out) = run(&tasks, Some(deadline), &mut |_| ()).expect("rows");
        assert!((1..=super::THREADS).contains(&rows.len()), "{}", rows.len());
        assert_eq!(rows.len() + left_out.len(), 100);
    }
}
