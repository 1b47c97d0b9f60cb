//! Guidance: genomes that reached something new are kept, and what is run next is mostly a change of one of them. A change
//! touches the choices of a rung or of a step and leaves the others, so that what had been reached is mostly reached again.

mod corpus;
mod mutate;

pub use corpus::Corpus;
