//! The models against the manual: its tables cell by cell, its figures replayed. `docs/spec/plant.md` has the requirements.

#[path = "models/connections.rs"]
mod connections;
#[path = "models/figures_analog.rs"]
mod figures_analog;
#[path = "models/figures_digital.rs"]
mod figures_digital;
#[path = "models/followers.rs"]
mod followers;
#[path = "models/outputs.rs"]
mod outputs;
#[path = "models/support.rs"]
mod support;
#[path = "models/table_3.rs"]
mod table_3;
#[path = "models/table_4.rs"]
mod table_4;
#[path = "models/table_9.rs"]
mod table_9;
#[path = "models/wiring_faults.rs"]
mod wiring_faults;
