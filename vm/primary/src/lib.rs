//! Channel 1: the primary interpreter.
