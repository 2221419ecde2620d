//! Rows on several threads, since drivers compile on the thread that asks.

use super::rows::Row;
use crate::Result;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

/// Makes some rows.
pub(super) type Task<'a> = Box<dyn Fn() -> Result<Vec<Row>> + Send + Sync + 'a>;

/// Threads at most: each may hold two of the largest buffers.
const THREADS: usize = 4;

/// The rows of all tasks in their order; `progress` sees each once all before it have ended.
/// The first error in that order ends it.
///
/// # Errors
/// Those of the tasks.
pub(super) fn run(tasks: &[Task], progress: &mut dyn FnMut(&Row)) -> Result<Vec<Row>> {
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
                    if send.send((at, task())).is_err() {
                        break;
                    }
                }
            });
        }
        drop(send);
        let (mut early, mut rows) = (BTreeMap::new(), Vec::new());
        let mut due = 0;
        for (at, made) in receive {
            early.insert(at, made);
            while let Some(made) = early.remove(&due) {
                due += 1;
                for row in made? {
                    progress(&row);
                    rows.push(row);
                }
            }
        }
        Ok(rows)
    })
}

#[cfg(test)]
mod tests {
    use super::{Row, Task, run};
    use crate::Error;
    use std::time::Duration;

    fn refused() -> Error {
        Error::Arguments {
            asked: String::new(),
            limit: String::new(),
            remedy: String::new(),
        }
    }

    /// Rows of which the later end first.
    fn task(at: u64) -> Task<'static> {
        Box::new(move || {
            std::thread::sleep(Duration::from_millis(20 - 2 * at));
            Ok(vec![Row::exact(&at.to_string(), ""); at as usize % 3])
        })
    }

    #[test]
    fn rows_come_in_order_and_errors_end_them() {
        let tasks: Vec<Task> = (0..10).map(task).collect();
        let mut seen = Vec::new();
        let rows = run(&tasks, &mut |row| seen.push(row.name.clone())).expect("rows");
        let names: Vec<String> = rows.into_iter().map(|row| row.name).collect();
        assert_eq!(names, ["1", "2", "2", "4", "5", "5", "7", "8", "8"]);
        assert_eq!(names, seen);

        let mut tasks: Vec<Task> = (0..10).map(task).collect();
        tasks.insert(3, Box::new(|| Err(refused())));
        let mut seen = 0;
        assert!(run(&tasks, &mut |_| seen += 1).is_err());
        assert_eq!(seen, 3);
    }
}
