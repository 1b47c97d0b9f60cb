//! Checks and compiles a file, for a look at findings and times: `compile FILE [CONTEXT...] [--plant]`.

use std::path::Path;
use std::time::Instant;

use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::tree::Sources;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut sources = Sources::new();
    let begin = Instant::now();
    let Some((first, contexts)) = arguments.split_first() else { return };
    let reading = twinrung_grammar::read_path(&mut sources, Path::new(first));
    let read = begin.elapsed();
    let mut completion = Completion::default();
    for context in contexts {
        completion.contexts.push(twinrung_grammar::read_path(&mut sources, Path::new(context)).file);
        completion.controller = Some("1756-L84ES".to_owned());
        completion.revision = Some(35);
        completion.period_ms = Some(20);
        completion.watchdog_ms = Some(20);
    }
    let begin = Instant::now();
    let checked = check(&reading, &completion);
    let check_time = begin.elapsed();
    for finding in checked.findings.iter().take(60) {
        let place = sources.line_column(finding.span);
        let path = sources.get(finding.span.source).map_or_else(String::new, |file| file.path().display().to_string());
        println!("{path}:{}:{}: {} {}", place.line, place.column, finding.code.id, finding.message);
        if let Some(help) = &finding.help {
            println!("    help: {help}");
        }
    }
    println!("{} findings; read {read:?}, check {check_time:?}", checked.findings.len());
    if let Some(project) = checked.project {
        let begin = Instant::now();
        match compile(&project) {
            Ok(image) => {
                println!("{} bytes, compile {:?}", image.bytes.len(), begin.elapsed());
                let begin = Instant::now();
                match twinrung_bytecode::admit(&image.bytes) {
                    Ok(_) => println!("admitted in {:?}", begin.elapsed()),
                    Err(error) => println!("REFUSED {error}"),
                }
            }
            Err(finding) => println!("{} {}", finding.code.id, finding.message),
        }
    }
}
