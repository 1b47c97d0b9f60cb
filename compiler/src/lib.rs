//! Turns a parsed project into a checked one, and a checked one into a signed image.
