//! What goes wrong, and what was seen. One session at a time has the process.

use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

use corput::vulkan::ash::vk;

/// How a call goes wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// It does nothing.
    Instead,
    /// It does its work, and then says otherwise.
    After,
}

/// Some calls of one function that fail.
#[derive(Clone, Copy, Debug)]
pub struct Fault {
    /// By its name in the specification.
    pub call: &'static str,
    pub code: vk::Result,
    pub way: Way,
    /// The first that fails, from 1.
    pub nth: u64,
    /// How many do.
    pub times: u64,
    /// Only those whose first argument this is; 0: any.
    pub of: u64,
}

impl Fault {
    /// The next call, which does nothing.
    pub fn next(call: &'static str, code: vk::Result) -> Self {
        Self {
            call,
            code,
            way: Way::Instead,
            nth: 1,
            times: 1,
            of: 0,
        }
    }

    /// Every call from now on.
    pub fn always(call: &'static str, code: vk::Result) -> Self {
        let times = u64::MAX;
        Self {
            times,
            ..Self::next(call, code)
        }
    }
}

/// What a driver says about itself, changed.
#[derive(Clone, Copy)]
pub enum Lie {
    Properties(fn(&mut vk::PhysicalDeviceProperties)),
    Features(fn(&mut vk::PhysicalDeviceFeatures)),
    Subgroup(fn(&mut vk::PhysicalDeviceSubgroupProperties<'_>)),
    Maintenance3(fn(&mut vk::PhysicalDeviceMaintenance3Properties<'_>)),
    HostMemory(fn(&mut vk::PhysicalDeviceExternalMemoryHostPropertiesEXT<'_>)),
    Family(fn(&mut vk::QueueFamilyProperties)),
    Memory(fn(&mut vk::PhysicalDeviceMemoryProperties)),
    /// The list of devices, the so-manyth time that it is told, from 1.
    Devices(fn(u64, &mut Vec<vk::PhysicalDevice>)),
    /// The loader's version.
    Version(u32),
    /// Mappings at null.
    NullMap,
    /// Bindings that reach to the ends of their buffers: drivers may check the bounds of what
    /// is bound, and need not.
    Unbounded,
    /// Modules that the driver refuses.
    Module(fn(&[u32]) -> bool),
}

#[derive(Default)]
pub struct Plan {
    faults: Vec<Fault>,
    pub lies: Vec<Lie>,
    /// Calls of each function since the plan was last changed.
    seen: HashMap<&'static str, u64>,
    /// Calls that were made to fail, or whose answers were changed.
    fired: u64,
    /// Objects made and not destroyed.
    pub live: i64,
    /// The longest wait that was asked for, in nanoseconds.
    pub longest_wait: u64,
    /// Times that the list of devices was told.
    pub told: u64,
    /// Features that a device was opened with.
    pub features_asked: u64,
}

static PLAN: Mutex<Option<Plan>> = Mutex::new(None);
static TURN: Mutex<()> = Mutex::new(());

/// Shows the plan to `look`.
pub fn with<R>(look: impl FnOnce(&mut Plan) -> R) -> R {
    let mut plan = PLAN.lock().unwrap_or_else(PoisonError::into_inner);
    look(plan.get_or_insert_default())
}

impl Plan {
    /// Counts a call, and says whether it fails.
    pub fn strike(&mut self, call: &'static str, first: u64) -> Option<(vk::Result, Way)> {
        let seen = self.seen.entry(call).or_default();
        *seen += 1;
        let fault = self.faults.iter().find(|fault| {
            fault.call == call
                && (fault.of == 0 || fault.of == first)
                && *seen >= fault.nth
                && *seen - fault.nth < fault.times
        })?;
        self.fired += 1;
        Some((fault.code, fault.way))
    }

    /// Counts an answer that was changed.
    pub fn lied(&mut self) {
        self.fired += 1;
    }
}

/// The right to make things go wrong. All is well again when it is dropped.
pub struct Session {
    _turn: MutexGuard<'static, ()>,
}

impl Session {
    pub fn begin() -> Self {
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        with(|plan| *plan = Plan::default());
        Self { _turn: turn }
    }

    /// Only this goes wrong from now on; calls are counted from here.
    pub fn fail(&self, fault: Fault) {
        self.set(&[fault], &[]);
    }

    /// Drivers say so from now on.
    pub fn lie(&self, lies: &[Lie]) {
        self.set(&[], lies);
    }

    /// Both.
    pub fn set(&self, faults: &[Fault], lies: &[Lie]) {
        self.heal();
        with(|plan| {
            plan.faults = faults.to_vec();
            plan.lies = lies.to_vec();
        });
    }

    /// All goes well from now on; calls are counted from here.
    pub fn heal(&self) {
        with(|plan| {
            *plan = Plan {
                live: plan.live,
                ..Plan::default()
            }
        });
    }

    /// Calls that failed, and answers that were changed.
    pub fn fired(&self) -> u64 {
        with(|plan| plan.fired)
    }

    /// Calls of a function.
    pub fn seen(&self, call: &str) -> u64 {
        with(|plan| plan.seen.get(call).copied().unwrap_or(0))
    }

    /// Objects that were made and not destroyed.
    pub fn live(&self) -> i64 {
        with(|plan| plan.live)
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        with(|plan| *plan = Plan::default());
    }
}
