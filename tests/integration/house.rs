//! The house rules that a machine can check: who may depend on whom, what stands at the top of each crate, and that every
//! numbered requirement is shown by a test.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cargo_metadata::{DependencyKind, Metadata, MetadataCommand};

/// Direct dependencies of each crate on crates of this workspace: those it is built with, and those its build script uses.
const ALLOWED: &[(&str, &[&str], &[&str])] = &[
    ("twinrung-catalog", &[], &[]),
    ("twinrung-bytecode", &["twinrung-catalog"], &[]),
    ("twinrung-grammar", &[], &[]),
    ("twinrung-compiler", &["twinrung-grammar", "twinrung-catalog", "twinrung-bytecode"], &[]),
    ("twinrung-safety-primary", &["twinrung-catalog"], &[]),
    ("twinrung-safety-partner", &["twinrung-catalog"], &["twinrung-bytecode", "twinrung-compiler"]),
    ("twinrung-safety-vectors", &["twinrung-catalog"], &[]),
    ("twinrung-primary", &["twinrung-bytecode", "twinrung-catalog", "twinrung-safety-primary"], &[]),
    ("twinrung-partner", &["twinrung-bytecode", "twinrung-catalog", "twinrung-safety-partner"], &[]),
    ("twinrung-controller", &["twinrung-bytecode", "twinrung-primary", "twinrung-partner"], &[]),
    ("twinrung-plant", &["twinrung-catalog"], &[]),
    ("twinrung-commission", &["twinrung-bytecode", "twinrung-controller"], &[]),
    (
        "twinrung-contest",
        &["twinrung-bytecode", "twinrung-catalog", "twinrung-compiler", "twinrung-grammar", "twinrung-safety-vectors"],
        &[],
    ),
    (
        "twinrung-workbench",
        &[
            "twinrung-contest",
            "twinrung-controller",
            "twinrung-compiler",
            "twinrung-bytecode",
            "twinrung-catalog",
            "twinrung-grammar",
            "twinrung-plant",
            "twinrung-safety-vectors",
        ],
        &[],
    ),
    ("twinrung-conformance", &["twinrung-catalog", "twinrung-contest", "twinrung-trio"], &[]),
    ("twinrung-defects", &["twinrung-mutants", "twinrung-workbench"], &[]),
    (
        "twinrung-hostile",
        &[
            "twinrung-bytecode",
            "twinrung-compiler",
            "twinrung-controller",
            "twinrung-grammar",
            // The reader of scenario files is there.
            "twinrung-workbench",
        ],
        &[],
    ),
    (
        "twinrung-judge",
        &["twinrung-compiler", "twinrung-grammar", "twinrung-catalog", "twinrung-bytecode", "twinrung-safety-partner"],
        &[],
    ),
    ("twinrung-mutants", &[], &[]),
    ("twinrung-sarif", &[], &[]),
    (
        "twinrung-trio",
        &[
            "twinrung-bytecode",
            "twinrung-catalog",
            "twinrung-compiler",
            "twinrung-contest",
            "twinrung-grammar",
            "twinrung-judge",
            "twinrung-partner",
            "twinrung-primary",
            "twinrung-safety-partner",
            "twinrung-safety-vectors",
        ],
        &[],
    ),
    (
        "twinrung-benches",
        &[
            "twinrung-bytecode",
            "twinrung-catalog",
            "twinrung-compiler",
            "twinrung-controller",
            "twinrung-grammar",
            "twinrung-workbench",
        ],
        &[],
    ),
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn metadata() -> Metadata {
    MetadataCommand::new()
        .manifest_path(root().join("Cargo.toml"))
        .no_deps()
        .exec()
        .expect("cargo describes the workspace")
}

/// Workspace crates that each workspace crate depends on, by kind.
fn own_dependencies(metadata: &Metadata, kind: DependencyKind) -> BTreeMap<String, BTreeSet<String>> {
    metadata
        .packages
        .iter()
        .map(|package| {
            let own = package
                .dependencies
                .iter()
                .filter(|dependency| dependency.kind == kind && dependency.path.is_some())
                .map(|dependency| dependency.name.clone())
                .collect();
            (package.name.to_string(), own)
        })
        .collect()
}

fn reachable(graph: &BTreeMap<String, BTreeSet<String>>, from: &str) -> BTreeSet<String> {
    let mut seen = BTreeSet::new();
    let mut open = vec![from.to_owned()];
    while let Some(name) = open.pop() {
        open.extend(graph[&name].iter().filter(|next| seen.insert((*next).clone())).cloned());
    }
    seen
}

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            let name = entry.file_name();
            let skip = name == "target" || name.to_string_lossy().starts_with('.');
            match (skip, path.is_dir()) {
                (true, _) => {}
                (false, true) => open.push(path),
                (false, false) if path.to_string_lossy().ends_with(ending) => found.push(path),
                (false, false) => {}
            }
        }
    }
    found.sort();
    found
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn crates_when_their_manifests_are_read_then_each_depends_on_what_the_architecture_allows() {
    let metadata = metadata();
    let normal = own_dependencies(&metadata, DependencyKind::Normal);
    let build = own_dependencies(&metadata, DependencyKind::Build);
    let allowed: BTreeMap<&str, (&[&str], &[&str])> =
        ALLOWED.iter().map(|(name, normal, build)| (*name, (*normal, *build))).collect();
    let mut wrong = Vec::new();
    for name in normal.keys().filter(|name| *name != "twinrung" && *name != "twinrung-fuzz") {
        let (may, may_build) = allowed.get(name.as_str()).unwrap_or_else(|| panic!("{name} is not in the table"));
        wrong.extend(normal[name].iter().filter(|to| !may.contains(&to.as_str())).map(|to| format!("{name} -> {to}")));
        wrong.extend(
            build[name].iter().filter(|to| !may_build.contains(&to.as_str())).map(|to| format!("{name} =build=> {to}")),
        );
    }
    assert!(wrong.is_empty(), "not allowed: {wrong:#?}");
}

#[test]
fn channels_when_all_their_dependencies_are_followed_then_neither_reaches_a_half_of_the_other() {
    let graph = own_dependencies(&metadata(), DependencyKind::Normal);
    let primary = reachable(&graph, "twinrung-primary");
    let partner = reachable(&graph, "twinrung-partner");
    let shared: Vec<&String> = primary.intersection(&partner).collect();
    assert_eq!(shared, ["twinrung-bytecode", "twinrung-catalog"], "the channels share definitions and nothing else");
    assert!(!primary.contains("twinrung-partner") && !primary.contains("twinrung-safety-partner"));
    assert!(!partner.contains("twinrung-primary") && !partner.contains("twinrung-safety-primary"));
}

#[test]
fn trusted_crates_when_their_first_lines_are_read_then_they_are_no_std_and_forbid_unsafe_code() {
    let mut wrong = Vec::new();
    for folder in ["vm/bytecode", "vm/primary", "vm/partner", "vm/controller"].into_iter().chain([
        "stdlib-safety/catalog",
        "stdlib-safety/primary",
        "stdlib-safety/partner",
        "stdlib-safety/vectors",
    ]) {
        let top = read(&root().join(folder).join("src/lib.rs"));
        for line in ["#![no_std]", "#![forbid(unsafe_code)]"] {
            if !top.contains(line) {
                wrong.push(format!("{folder}: {line}"));
            }
        }
    }
    assert!(wrong.is_empty(), "missing: {wrong:#?}");
}

#[test]
fn sources_when_searched_then_they_hold_no_unfinished_marks() {
    let marks = [concat!("to", "do!("), concat!("unimple", "mented!("), concat!("FIX", "ME"), concat!("#[ig", "nore")];
    let found: Vec<String> = files(&root(), ".rs")
        .iter()
        .filter(|path| marks.iter().any(|mark| read(path).contains(mark)))
        .map(|path| path.display().to_string())
        .collect();
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn requirements_when_the_tests_are_searched_then_each_is_named_by_one_and_none_is_invented() {
    let is_id = |word: &&str| {
        let number = word.strip_prefix("REQ-").and_then(|rest| rest.rsplit_once('-')).map(|(_, number)| number);
        number.is_some_and(|number| number.len() == 3 && number.bytes().all(|digit| digit.is_ascii_digit()))
    };
    let ids = |text: &str| -> BTreeSet<String> {
        text.split(|c: char| !(c.is_ascii_uppercase() || c.is_ascii_digit() || c == '-'))
            .filter(is_id)
            .map(str::to_owned)
            .collect()
    };
    let declared: BTreeSet<String> = files(&root().join("docs/spec"), ".md")
        .iter()
        .flat_map(|path| {
            read(path)
                .lines()
                .filter(|line| line.starts_with("- **REQ-"))
                .flat_map(|line| ids(&line[..24.min(line.len())]))
                .collect::<Vec<_>>()
        })
        .collect();
    let shown: BTreeSet<String> = files(&root(), ".rs")
        .iter()
        .filter(|path| path.components().any(|part| part.as_os_str() == "tests"))
        .flat_map(|path| ids(&read(path)))
        .collect();
    let without: Vec<&String> = declared.difference(&shown).collect();
    let unknown: Vec<&String> = shown.difference(&declared).collect();
    assert!(!declared.is_empty());
    assert!(without.is_empty(), "requirements without a test: {without:#?}");
    assert!(unknown.is_empty(), "tests name requirements that no specification has: {unknown:#?}");
}

#[test]
fn limits_when_declared_then_the_page_on_limits_names_each_of_them() {
    let page = read(&root().join("docs/limits.md"));
    let mut missing = Vec::new();
    for path in ["grammar/src/limits.rs", "vm/bytecode/src/limits.rs"] {
        let text = read(&root().join(path));
        let names = text.lines().filter_map(|line| line.strip_prefix("pub const ")?.split(':').next());
        missing.extend(names.filter(|name| !page.contains(&format!("`{name}`"))).map(str::to_owned));
    }
    assert!(missing.is_empty(), "not on the page: {missing:?}");
}
