//! What the channels share.

use crate::html::{self, Cell};

use super::super::Independence;

pub(super) fn write(out: &mut String, review: Option<&Independence>) {
    html::heading(out, 2, "Independence");
    let Some(review) = review else {
        html::warning(
            out,
            "Not there: docs/independence.md cannot be found, and without it nobody has said what the channels share.",
        );
        return;
    };
    html::paragraph(
        out,
        &format!(
            "What both channels share, and what covers it: the review in {}, in its own words. A test follows the dependency graph and fails where the channels meet in anything that computes.",
            review.file
        ),
    );
    let or =
        |text: &str, otherwise: &str| if text.is_empty() { Cell::Not(otherwise.to_owned()) } else { Cell::text(text) };
    let rows = review.areas.iter().map(|area| {
        vec![
            Cell::text(&area.name),
            or(&area.covered_by, "NOTHING IS SAID"),
            Cell::text(&area.not_covered),
            Cell::text(&area.user),
        ]
    });
    html::table(out, &["shared", "covered by", "not covered", "what the user must do"], rows);
    if !review.unnamed.is_empty() {
        html::warning(
            out,
            &format!("Residual classes of faults that the review does not name: {}.", review.unnamed.join(", ")),
        );
    }
}
