//! The four crates of `vm/` in a program without std: what a firmware would link.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::support::{image_of, project_path, read_whole};

const MAIN: &str = r#"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int64_t twinrung_run(const uint8_t *image, size_t length, uint32_t scans);
size_t twinrung_channel_bytes(void);

/* The compiled `alloc` that comes with Rust names it; nothing unwinds in this program. */
void rust_eh_personality(void) { abort(); }

int main(int count, char **arguments) {
    static uint8_t image[1 << 20];
    FILE *file = count == 3 ? fopen(arguments[1], "rb") : NULL;
    if (!file) return 2;
    size_t length = fread(image, 1, sizeof image, file);
    printf("%lld", (long long)twinrung_run(image, length, (uint32_t)atoi(arguments[2])));
    return twinrung_channel_bytes() > 0 ? 0 : 3;
}
"#;

fn succeeded(what: &str, output: Output) -> Output {
    assert!(output.status.success(), "{what}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

/// Runs an image in a program that holds the static library and the C library, and no Rust std.
fn run(program: &Path, image: &Path, scans: &str) -> String {
    let output = Command::new(program).arg(image).arg(scans).output().expect("the program starts");
    String::from_utf8(succeeded("the program", output).stdout).expect("a number")
}

#[test]
fn vm_crates_when_linked_without_std_then_an_image_runs_and_a_corrupted_one_is_refused() {
    // Beside the other builds: what a build of the workspace has compiled already is not compiled again.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("the target folder").to_owned();
    let built = Command::new(env!("CARGO"))
        .args(["build", "--locked", "--manifest-path"])
        .arg(project_path("tests/freestanding/Cargo.toml"))
        .arg("--target-dir")
        .arg(&target)
        .output();
    succeeded("cargo build", built.expect("cargo starts"));

    let folder = tempfile::tempdir().expect("a folder");
    let (source, program) = (folder.path().join("main.c"), folder.path().join("main"));
    fs::write(&source, MAIN).expect("the source is written");
    let linked = Command::new("cc")
        .args(["-O1", "-o"])
        .arg(&program)
        .arg(&source)
        .arg(target.join("debug/libtwinrung_freestanding.a"))
        .output();
    succeeded("cc", linked.expect("cc starts"));

    let (_, bytes) = image_of(&read_whole(&project_path("samples/estop-with-contactors")));
    let (good, bad) = (folder.path().join("good.image"), folder.path().join("bad.image"));
    fs::write(&good, &bytes).expect("the image is written");
    let mut corrupted = bytes;
    let middle = corrupted.len() / 2;
    corrupted[middle] ^= 1;
    fs::write(&bad, corrupted).expect("the image is written");

    assert_eq!(run(&program, &good, "250"), "250");
    assert_eq!(run(&program, &bad, "250"), "-1");
}
