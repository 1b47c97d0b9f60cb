//! The files that figures were taken from, and the builds and machines of their measurements.

use std::collections::BTreeSet;

use crate::html::{self, Cell, duration};
use crate::provenance::Provenance;

use super::super::Origin;
use super::{build, machine, recorded};

pub(super) fn write(out: &mut String, origins: &[Origin], here: &Provenance) {
    html::heading(out, 2, "Where the figures come from");
    html::paragraph(
        out,
        "Reports are part of the project, since they were measured and no build can make them. SHA-256 of each file that was read:",
    );
    let row = |origin: &Origin| vec![Cell::text(&origin.file), Cell::Code(origin.sha256.clone())];
    html::table(out, &["file", "SHA-256"], origins.iter().map(row));
    let all = || origins.iter().flat_map(|origin| origin.measurements.iter().map(move |made| (origin, made)));
    // Without its commit nobody can tell which build it was.
    let is_here = |made: &Provenance| made.commit.is_some() && build(made) == build(here);
    let others: BTreeSet<String> = all().filter(|(_, made)| !is_here(made)).map(|(_, made)| build(made)).collect();
    if !others.is_empty() {
        html::warning(
            out,
            &format!(
                "Measured by builds that are not, or are not known to be, the one that writes this page ({}): {}.",
                build(here),
                others.into_iter().collect::<Vec<_>>().join("; ")
            ),
        );
    }
    let heads = ["file", "command", "build", "machine", "begun (UTC)", "elapsed", "processor time"];
    let rows = all().map(|(origin, made)| {
        vec![
            Cell::text(&origin.file),
            Cell::Code(recorded(made.command.as_deref())),
            Cell::Text(build(made)),
            Cell::Text(machine(made)),
            Cell::Text(recorded(made.begun.as_deref())),
            Cell::Number(duration(made.seconds)),
            Cell::Number(made.processor_seconds.map_or_else(|| "not recorded".to_owned(), duration)),
        ]
    });
    html::table(out, &heads, rows);
}
