//! The limits of a run as flags.

use bosquet::derive::Limits;
use std::time::Duration;

/// Where a run stops by itself.
#[derive(clap::Args, Clone, Copy)]
pub struct LimitArguments {
    /// Rules inside rules
    #[arg(long, value_name = "N", default_value_t = 1_000, help_heading = "Limits")]
    limit_depth: usize,
    /// Functions inside functions
    #[arg(long, value_name = "N", default_value_t = 200, help_heading = "Limits")]
    #[arg(value_parser = clap::value_parser!(u16).range(1..=4_000))]
    limit_calls: u16,
    /// Shapes of one lot
    #[arg(long, value_name = "N", default_value_t = 1_500_000, help_heading = "Limits")]
    limit_shapes: usize,
    /// Children of one operation
    #[arg(long, value_name = "N", default_value_t = 1_000_000, help_heading = "Limits")]
    limit_children: usize,
    /// Seconds for one lot
    #[arg(long, value_name = "S", default_value_t = 600, help_heading = "Limits")]
    limit_time: u64,
    /// Bytes of one file that is read
    #[arg(long, value_name = "BYTES", default_value_t = 1 << 30, help_heading = "Limits")]
    pub limit_file: u64,
}

/// Room for checking and for rules that are not functions, bytes.
pub const STACK: usize = 256 << 20;
/// Room for one function, whose expression may be 512 levels high, bytes; half of it was ever seen in use.
const STACK_PER_CALL: usize = 1 << 20;

impl LimitArguments {
    /// The stack of a worker: functions are evaluated recursively, within the limit of calls.
    pub fn stack(&self) -> usize {
        STACK.max(usize::from(self.limit_calls) * STACK_PER_CALL)
    }

    /// The limits of a derivation.
    pub fn limits(&self) -> Limits {
        Limits {
            depth: self.limit_depth,
            calls: self.limit_calls.into(),
            shapes: self.limit_shapes,
            children: self.limit_children,
            time: Duration::from_secs(self.limit_time),
        }
    }
}
