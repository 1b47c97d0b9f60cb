//! Makes the parsers out of the `.lalrpop` grammars.

/// Every grammar of the crate.
const GRAMMARS: &[&str] = &[
    "src/reading/operand.lalrpop",
    "src/scenario/scenario.lalrpop",
    "src/text/declaration.lalrpop",
    "src/text/rung.lalrpop",
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    for grammar in GRAMMARS {
        println!("cargo:rerun-if-changed={grammar}");
        lalrpop::Configuration::new().emit_rerun_directives(false).use_cargo_dir_conventions().process_file(grammar)?;
    }
    Ok(())
}
