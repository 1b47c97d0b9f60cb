//! Executes a region: one loop for each run, none of which branches on data.

use twinrung_bytecode::observer::Observer;

use super::record::{Compare, Extract, Index, Insert, Move, Other, Panel, Pools, Records, Sum, Timer};
use super::{Kind, Region, Run};
use crate::ladder::{Code, Ladder, NONE};
use crate::memory::{LARGE, MEDIUM, SMALL};
use crate::timer::{TimerState, off_delay, on_delay, retentive, select};
use crate::walk::Walker;

/// Bits of a status key that are flags; the place of the instruction that set them is above.
const FLAG_BITS: u32 = 4;

/// The flags as they are after a region's records, whatever their order: those of the instruction that stands last.
#[derive(Debug, Clone, Copy)]
struct Recorded {
    key: u64,
    overflows: u32,
}

impl Recorded {
    // Inlined: what it updates stays in registers over a whole run.
    #[inline(always)]
    fn record(&mut self, condition: bool, sequence: u32, flags: u64, overflow: bool) {
        let key = (u64::from(sequence) << FLAG_BITS) | flags;
        self.key = self.key.max(key & u64::from(condition).wrapping_neg());
        self.overflows = self.overflows.wrapping_add(u32::from(condition & overflow));
    }
}

fn read<I: Index, const N: usize>(bits: &[u8; N], cell: I) -> u8 {
    byte(bits, cell.at())
}

fn byte<const N: usize>(bits: &[u8; N], position: usize) -> u8 {
    bits.get(position & N.wrapping_sub(1)).copied().unwrap_or(0xFF)
}

fn condition<I: Index, const N: usize>(bits: &[u8; N], cell: I) -> bool {
    read(bits, cell) & 1 == 0
}

fn write<const N: usize>(bits: &mut [u8; N], position: usize, byte: u8) {
    if let Some(cell) = bits.get_mut(position & N.wrapping_sub(1)) {
        *cell = byte;
    }
}

fn word<I: Index, const N: usize>(words: &[u32; N], cell: I) -> i32 {
    word_at(words, cell.at())
}

fn word_at<const N: usize>(words: &[u32; N], position: usize) -> i32 {
    !words.get(position & N.wrapping_sub(1)).copied().unwrap_or(0) as i32
}

fn put<const N: usize>(words: &mut [u32; N], position: usize, value: i32) {
    if let Some(cell) = words.get_mut(position & N.wrapping_sub(1)) {
        *cell = !(value as u32);
    }
}

/// The conduction table of a panel.
trait Table: Copy {
    /// The complemented result, in the lowest bit; the place counts modulo the bits of the table.
    fn look_up(self, place: u32) -> u8;
}

impl Table for u32 {
    fn look_up(self, place: u32) -> u8 {
        self.wrapping_shr(place) as u8
    }
}

impl Table for u64 {
    fn look_up(self, place: u32) -> u8 {
        self.wrapping_shr(place) as u8
    }
}

fn panels<I: Index, T: Table, const CONTACTS: usize, const N: usize>(
    bits: &mut [u8; N],
    records: &[Panel<I, T, CONTACTS>],
) {
    for panel in records {
        let inputs = panel.inputs.map(|cell| u32::from(read(bits, cell)));
        let (pairs, _) = inputs.as_chunks::<2>();
        let place = pairs
            .iter()
            .rev()
            .fold(0u32, |above, [first, second]| first.wrapping_add(second.wrapping_shl(1)).wrapping_add(above << 2));
        write(bits, panel.output.at(), panel.table.look_up(place) | 0xFE);
    }
}

fn compares<I: Index, const N: usize>(bits: &mut [u8; N], words: &[u32; N], records: &[Compare<I>]) {
    for compare in records {
        let (left, right) = (word(words, compare.left), word(words, compare.right));
        let order = u32::from(left >= right).wrapping_add(u32::from(left > right));
        let open = !u32::from(compare.accept).wrapping_shr(order) as u8;
        write(bits, compare.output.at(), open | 0xFE);
    }
}

fn extracts<I: Index, const N: usize>(bits: &mut [u8; N], words: &[u32; N], records: &[Extract<I>]) {
    for extract in records {
        let open = !(word(words, extract.word) as u32).wrapping_shr(u32::from(extract.bit)) as u8;
        write(bits, extract.output.at(), open | 0xFE);
    }
}

fn inserts<I: Index, const N: usize>(bits: &[u8; N], words: &mut [u32; N], records: &[Insert<I>]) {
    for insert in records {
        let input = condition(bits, insert.condition);
        let old = word(words, insert.word);
        let mask = 1i32.wrapping_shl(u32::from(insert.bit));
        let (set, cleared) = (old | mask, old & !mask);
        let when_true = select(insert.when_true, set, cleared);
        let when_false = select(insert.clears, cleared, old);
        let above = u32::from(insert.above);
        let new = select(input, when_true, when_false).wrapping_shl(above).wrapping_shr(above);
        put(words, insert.word.at(), new);
    }
}

fn timers<I: Index, const N: usize>(
    bits: &mut [u8; N],
    words: &mut [u32; N],
    stamps: &mut [i64; N],
    records: &[Timer<I>],
    now_ms: i64,
    step: impl Fn(TimerState, bool, i64) -> TimerState,
) {
    for timer in records {
        let input = condition(bits, timer.condition);
        let (bit, preset) = (timer.bit.at(), timer.word.at());
        let (timing, done, accumulated) = (bit.wrapping_add(1), bit.wrapping_add(2), preset.wrapping_add(1));
        let mask = N.wrapping_sub(1);
        let before = TimerState {
            enabled: byte(bits, bit) & 1 == 0,
            timing: false,
            done: byte(bits, done) & 1 == 0,
            preset: word_at(words, preset),
            accumulated: word_at(words, accumulated),
            last_time: stamps.get(preset & mask).copied().unwrap_or(0),
        };
        let after = step(before, input, now_ms);
        write(bits, bit, 0xFF ^ u8::from(after.enabled));
        write(bits, timing, 0xFF ^ u8::from(after.timing));
        write(bits, done, 0xFF ^ u8::from(after.done));
        put(words, accumulated, after.accumulated);
        if let Some(stamp) = stamps.get_mut(preset & mask) {
            *stamp = after.last_time;
        }
    }
}

/// A value narrowed to a type with so many unused bits above it, and its flags.
#[inline(always)]
fn narrowed(value: i32, above: u8, overflow: bool, carry: bool) -> (i32, u64, bool) {
    let above = u32::from(above);
    let stored = value.wrapping_shl(above).wrapping_shr(above);
    let overflow = overflow | (stored != value);
    let flags =
        u64::from(overflow) | (u64::from(stored == 0) << 1) | (u64::from(stored < 0) << 2) | (u64::from(carry) << 3);
    (stored, flags, overflow)
}

fn moves<I: Index, const N: usize>(bits: &[u8; N], words: &mut [u32; N], records: &[Move<I>], recorded: &mut Recorded) {
    for record in records {
        let input = condition(bits, record.condition);
        let value = word(words, record.source);
        let old = word(words, record.destination);
        let (stored, flags, overflow) = narrowed(value, record.above, false, false);
        put(words, record.destination.at(), select(input, stored, old));
        recorded.record(input, record.sequence, flags, overflow);
    }
}

fn sums<I: Index, const N: usize>(bits: &[u8; N], words: &mut [u32; N], records: &[Sum<I>], recorded: &mut Recorded) {
    for record in records {
        let input = condition(bits, record.condition);
        let (left, right) = (word(words, record.left), word(words, record.right));
        let old = word(words, record.destination);
        // Widened: the difference of a subtraction, the carry out of bit 31 as bit 32 of the unsigned operation.
        let (wide_left, wide_right) = (i64::from(left), i64::from(right));
        let sign = i64::from(record.subtract).wrapping_neg();
        let wide = wide_left.wrapping_add((wide_right ^ sign).wrapping_sub(sign));
        let value = wide as i32;
        let unsigned_right = i64::from(right as u32);
        let unsigned = i64::from(left as u32).wrapping_add((unsigned_right ^ sign).wrapping_sub(sign));
        let carry = (unsigned >> 32) & 1 != 0;
        let (stored, flags, overflow) = narrowed(value, record.above, wide != i64::from(value), carry);
        put(words, record.destination.at(), select(input, stored, old));
        recorded.record(input, record.sequence, flags, overflow);
    }
}

fn part<'a, T>(pool: &'a [T], run: &Run) -> &'a [T] {
    pool.get(run.begin as usize..run.end as usize).unwrap_or(&[])
}

impl<O: Observer> Walker<'_, O> {
    /// Executes a region; the step after it, or `None` where a timer would fault, so that the rungs must be walked.
    pub(crate) fn region(&mut self, number: u32) -> Option<u32> {
        let ladder = self.ladder;
        let region = ladder.panels.regions.get(number as usize)?;
        if !self.guards_hold(ladder, region) {
            return None;
        }
        match &ladder.panels.records {
            Records::Small(pools) => self.runs::<u16, SMALL>(ladder, region, pools),
            Records::Medium(pools) => self.runs::<u32, MEDIUM>(ladder, region, pools),
            Records::Large(pools) => self.runs::<u32, LARGE>(ladder, region, pools),
        }
        self.count(u64::from(region.executed));
        Some(region.end)
    }

    /// Whether PRE and ACC of every timer of the region are not negative. Nothing else in it writes them.
    fn guards_hold(&self, ladder: &Ladder, region: &Region) -> bool {
        let words = &self.state.memory.words;
        let mut signs = u32::MAX;
        for guard in ladder.panels.guards_of(region) {
            let preset = *guard as usize;
            if let Some([preset, accumulated]) = words.get(preset..preset.saturating_add(2)) {
                // Complemented: the sign bit of a value that is not negative is set.
                signs &= preset & accumulated;
            }
        }
        signs >> 31 == 1
    }

    fn runs<I: Index, const N: usize>(&mut self, ladder: &Ladder, region: &Region, pools: &Pools<I>) {
        let now_ms = self.inputs.now_ms;
        for run in ladder.panels.runs_of(region) {
            if run.kind == Kind::Other {
                self.others(part(&pools.others, run));
                continue;
            }
            let memory = &mut self.state.memory;
            let Ok(bits) = <&mut [u8; N]>::try_from(memory.bits.as_mut_slice()) else { continue };
            let Ok(words) = <&mut [u32; N]>::try_from(memory.words.as_mut_slice()) else { continue };
            let Ok(stamps) = <&mut [i64; N]>::try_from(memory.stamps.as_mut_slice()) else { continue };
            let mut recorded = Recorded { key: self.state.status.key, overflows: 0 };
            match run.kind {
                Kind::FourContacts => panels(bits, part(&pools.four_contacts, run)),
                Kind::SixContacts => panels(bits, part(&pools.six_contacts, run)),
                Kind::Compare => compares(bits, words, part(&pools.compares, run)),
                Kind::Extract => extracts(bits, words, part(&pools.extracts, run)),
                Kind::Insert => inserts(bits, words, part(&pools.inserts, run)),
                Kind::OnDelay => timers(bits, words, stamps, part(&pools.timers, run), now_ms, on_delay),
                Kind::OffDelay => timers(bits, words, stamps, part(&pools.timers, run), now_ms, off_delay),
                Kind::Retentive => timers(bits, words, stamps, part(&pools.timers, run), now_ms, retentive),
                Kind::Move => moves(bits, words, part(&pools.moves, run), &mut recorded),
                Kind::Sum => sums(bits, words, part(&pools.sums, run), &mut recorded),
                Kind::Other => {}
            }
            let status = &mut self.state.status;
            status.key = recorded.key;
            status.minor_faults = status.minor_faults.wrapping_add(recorded.overflows);
        }
        self.state.status.key &= (1 << FLAG_BITS) - 1;
    }

    fn others(&mut self, records: &[Other]) {
        for other in records {
            let Code::Instruction(opcode) = other.step.code else { continue };
            let input = self.state.memory.bit(other.condition);
            // Admission to a region excludes every instruction that can fault.
            let output = self.instruction(other.step, opcode, input).unwrap_or(false);
            if other.output != NONE {
                self.state.memory.set_bit(other.output, output);
            }
            if super::effect::has_status(opcode) {
                let status = &mut self.state.status;
                let flags = status.key & ((1 << FLAG_BITS) - 1);
                status.key = (u64::from(other.sequence) << FLAG_BITS) | flags;
            }
        }
    }
}
