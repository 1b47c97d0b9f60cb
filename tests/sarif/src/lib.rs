//! Nothing but a test: the SARIF logs under `tests/verdict`, which the command must write byte for byte, against the schema
//! of SARIF 2.1.0. A package of its own, since the validator takes longer to build than what it validates. It depends on
//! nothing of this project.

#![forbid(unsafe_code)]
