//! The scan around the two channels: freeze, execute, compare, publish.
