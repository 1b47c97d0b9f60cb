//! Primary half of the safety instruction library.
