//! Markdown tables, and thresholds.

/// Begins a table.
pub fn begin(title: &str, columns: &[&str]) {
    println!("## {title}\n");
    println!("| {} |", columns.join(" | "));
    println!("|{}", "---|".repeat(columns.len()));
}

/// One row.
pub fn row(cells: &[String]) {
    println!("| {} |", cells.join(" | "));
}

/// Ends a table, with the threshold that its ratios are to keep and how many do not.
pub fn end(at_most: Option<(f64, &[f64])>) {
    if let Some((limit, ratios)) = at_most {
        let missed = ratios.iter().filter(|ratio| **ratio > limit).count();
        let worst = ratios.iter().copied().fold(0.0, f64::max);
        println!("\nAt most {limit}: greatest {worst:.3}, {missed} of {} above.", ratios.len());
    }
    println!();
}

/// Median, least and greatest of ratios, as one cell.
pub fn spread(ratios: &[f64]) -> String {
    let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = ratios.iter().copied().fold(0.0, f64::max);
    format!("{:.3} ({least:.3} to {greatest:.3})", twinrung_benches::median(ratios.to_vec()))
}
