//! Channel 2: the safety partner interpreter.
