//! Times this channel alone on a shared mix: `mix DIRECTORY [SCANS] [TOGGLES]`, where `../shared/bench/gen.py` wrote the
//! directory. Prints ns per rung, what one scan executed, and the hash that every contender ends with.

use std::path::Path;
use std::time::Instant;

use twinrung_bytecode::channel::{Channel, ScanEnd, ScanInputs};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::{BitCell, EventTaskIndex};
use twinrung_bytecode::observer::Silent;
use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::tree::Sources;
use twinrung_partner::Partner;

/// The generator of the mix's stimulus.
struct Toggles(u64);

impl Toggles {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
}

fn hash(mut state: u64, bytes: &[u8]) -> u64 {
    for byte in bytes {
        state = (state ^ u64::from(*byte)).wrapping_mul(1_099_511_628_211);
    }
    state
}

/// Cells of the tags `letter0`, `letter1`, ... in the order of their numbers.
fn cells(image: &Image, letter: char, words: bool) -> Vec<u32> {
    let mut found: Vec<(u32, u32)> = image
        .tags
        .iter()
        .filter_map(|tag| {
            let number = tag.name.strip_prefix(letter)?.parse().ok()?;
            Some((number, if words { tag.word_cell } else { tag.bit_cell }))
        })
        .collect();
    found.sort_unstable();
    found.into_iter().map(|(_, cell)| cell).collect()
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some(directory) = arguments.first() else {
        println!("usage: mix DIRECTORY [SCANS] [TOGGLES]");
        return;
    };
    let number =
        |index: usize, otherwise: usize| arguments.get(index).and_then(|text| text.parse().ok()).unwrap_or(otherwise);
    let (scans, toggles) = (number(1, 300), number(2, 16));
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read_path(&mut sources, &Path::new(directory).join("project.rll"));
    let checked = check(&reading, &Completion::default());
    let project = checked.project.expect("the mix is a correct project");
    let compiled = compile(&project).expect("a correct project compiles");
    let admitted = twinrung_bytecode::admit(&compiled.bytes).expect("what was compiled is admitted");
    let begin = Instant::now();
    let mut partner = Partner::load(&admitted).expect("an admitted image loads");
    let load = begin.elapsed();
    let image = admitted.image();
    let (x, y, n) = (cells(image, 'x', false), cells(image, 'y', false), cells(image, 'n', true));

    let inputs = |now_ms| ScanInputs { now_ms, budget: u64::MAX, system_values: &[] };
    partner.prescan(inputs(0), &mut Silent);
    let prescanned = partner.status().executed;
    let mut generator = Toggles(88_172_645_463_325_252);
    let mut field = vec![false; x.len()];
    let mut times = Vec::with_capacity(scans);
    for scan in 0..scans {
        for _ in 0..toggles {
            let index = (generator.next() >> 20 & 255) as usize;
            field[index] ^= true;
            partner.set_bit(BitCell(x[index]), field[index]);
        }
        let begin = Instant::now();
        let end = partner.scan(inputs(scan as i64 * 10), &mut Silent);
        times.push(begin.elapsed().as_nanos() as f64);
        assert_eq!(end, ScanEnd::Completed);
    }
    times.sort_by(f64::total_cmp);
    let rungs = y.len() as f64;
    let mut state = 14_695_981_039_346_656_037u64;
    for cell in &y {
        state = hash(state, &[!partner.bits()[*cell as usize]]);
    }
    for cell in &n {
        state = hash(state, &(!partner.words()[*cell as usize]).to_le_bytes());
    }
    let executed = (partner.status().executed - prescanned) / scans as u64;
    println!(
        "rungs={} min={:.2} p50={:.2} p99={:.2} ns/rung  executed={executed} load={load:?} events={} yn={state:016x}",
        y.len(),
        times[0] / rungs,
        times[scans / 2] / rungs,
        times[scans * 99 / 100] / rungs,
        partner.events(EventTaskIndex(0)),
    );
}
