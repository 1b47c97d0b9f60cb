//! What engineers do with a controller: stimulus, recordings, diagrams, measurements.
