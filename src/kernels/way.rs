//! A plan with its pipelines.

use super::pipeline;
use super::points::table;
use crate::Result;
use crate::variant::Plan;
use crate::vulkan::{Buffer, BufferSlice, Device, Pipeline, Recording};
use std::sync::Arc;

/// How points are made.
pub(super) struct Way {
    pub(super) plan: Plan,
    pipelines: Vec<Arc<Pipeline>>,
    /// The table of columns, where the kernel reads one.
    pub(super) table: Option<Buffer>,
}

impl Way {
    pub(super) fn new(device: &Arc<Device>, plan: Plan, words: &[u32]) -> Result<Self> {
        let pipelines = plan
            .specializations
            .iter()
            .map(|values| pipeline(device, plan.kernel, words, values).map(Arc::new))
            .collect::<Result<Vec<_>>>()?;
        let table = match &plan.table {
            Some(words) => Some(table(device, words)?),
            None => None,
        };
        Ok(Self {
            plan,
            pipelines,
            table,
        })
    }

    /// The pipelines that points take, and the points of an invocation; none of the general
    /// kernel, of which one makes four words.
    pub(super) fn parts(&self) -> impl Iterator<Item = (&Arc<Pipeline>, Option<u64>)> {
        let tiles = self.plan.tiles.iter().map(|tile| Some(u64::from(*tile)));
        self.pipelines.iter().zip(tiles.chain([None]))
    }

    /// Records so many groups with these push constants.
    pub(super) fn record(
        &self,
        recording: &mut Recording,
        pipeline: &Arc<Pipeline>,
        results: &BufferSlice,
        (push, groups): (Vec<u8>, u64),
    ) -> Result<()> {
        if groups == 0 {
            return Ok(());
        }
        let mut slices = vec![(0, results.clone())];
        slices.extend(self.table.iter().map(|table| (1, table.whole())));
        recording.dispatch(pipeline, &slices, &push, groups)
    }
}
