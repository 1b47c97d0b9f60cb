//! The bytes of an image file.
//!
//! ```text
//! file    = magic:8 version:u32 count:u32 (kind:u32 length:u32) * count
//!           application_signature:32 image_signature:32
//!           section * count
//! ```
//!
//! All numbers are little-endian. The sections are those of [`Section::ALL`], all of them, in that order, one directly
//! after the other up to the end of the file. A table is a count and its records; a record is its fields in declared
//! order; a text is its length in bytes and its UTF-8; an optional value is 0, or 1 and the value. Nothing has two
//! forms: [`read`] accepts exactly the bytes that [`encode`] makes of the records that it returns.

mod cursor;
mod field;
mod records;

use alloc::vec::Vec;

use sha2::{Digest, Sha256};

use crate::error::ImageError;
use crate::image::Image;
use crate::limits;
use crate::signature::{self, Signatures};
use cursor::Cursor;
use field::Field;

/// The first bytes of an image: not text, and broken by every transfer that changes line ends or the eighth bit.
pub const MAGIC: [u8; 8] = *b"\x89TWR\r\n\x1a\n";
/// The version of this format.
pub const VERSION: u32 = 1;
/// Bytes before the first section: magic, version, count, section table, both signatures.
pub const HEADER_BYTES: usize = 16 + 8 * Section::ALL.len() + 64;

macro_rules! sections {
    ($($(#[$doc:meta])* $variant:ident = $number:literal, $name:literal, $($field:ident).+;)*) => {
        /// The sections of an image.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        #[repr(u32)]
        pub enum Section {
            $($(#[$doc])* $variant = $number,)*
        }

        impl Section {
            /// Every section, in the order of the file.
            pub const ALL: [Section; sections!(@count $($variant)*)] = [$(Section::$variant,)*];

            /// Its name, for people.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Section::$variant => $name,)*
                }
            }

            fn write(self, image: &Image, out: &mut Vec<u8>) {
                match self {
                    $(Section::$variant => image.$($field).+.write(out),)*
                }
            }

            fn read(self, from: &mut Cursor<'_>, image: &mut Image) -> Result<(), ImageError> {
                match self {
                    $(Section::$variant => image.$($field).+ = Field::read(from)?,)*
                }
                from.finish()
            }
        }
    };
    (@count $($variant:ident)*) => { [$(Section::$variant,)*].len() };
}

sections! {
    /// The controller.
    Controller = 1, "controller", controller;
    /// Structure types.
    Types = 2, "types", types;
    /// Add-On Instructions.
    AddOns = 3, "Add-On Instructions", add_ons;
    /// Programs.
    Programs = 4, "programs", programs;
    /// Tags.
    Tags = 5, "tags", tags;
    /// Routines: code and text.
    Routines = 6, "routines", routines;
    /// The operand table.
    Operands = 7, "operands", operands;
    /// The safety task.
    Task = 8, "task", task;
    /// Safety modules.
    Modules = 9, "modules", modules;
    /// The tag map.
    Map = 10, "tag map", map;
    /// Attributes that GSV and SSV name.
    SystemValues = 11, "system values", system_values;
    /// Event tasks that EVENT names.
    EventTasks = 12, "event tasks", event_tasks;
    /// Initial values of the bit cells.
    InitialBits = 13, "initial bits", initial_bits;
    /// Initial values of the word cells.
    InitialWords = 14, "initial words", initial_words;
}

/// An image as read: every record is well formed by itself, nothing is verified.
#[derive(Debug, Clone)]
pub struct ReadImage {
    /// The records.
    pub image: Image,
    /// The signatures that the file carries.
    pub carried: Signatures,
    /// Hash of everything in the file but the signatures.
    pub(crate) body: [u8; 32],
}

impl ReadImage {
    /// The image signature over the bytes that were read; the one that the file carries may be another.
    pub fn image_signature(&self) -> [u8; 32] {
        signature::image_signature(&self.carried.application, &self.body)
    }
}

/// Where a section lies, for people.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SectionPlace {
    /// Which.
    pub section: Section,
    /// First byte in the file.
    pub offset: usize,
    /// Number of bytes.
    pub length: usize,
}

/// The bytes of an image with these signatures; [`crate::seal`] computes them.
pub fn encode(image: &Image, signatures: &Signatures) -> Vec<u8> {
    let mut bytes = encode_unsigned(image);
    sign(&mut bytes, signatures);
    bytes
}

/// The bytes of an image with zeros for signatures.
pub(crate) fn encode_unsigned(image: &Image) -> Vec<u8> {
    let mut table = Vec::with_capacity(HEADER_BYTES);
    let mut body = Vec::new();
    table.extend_from_slice(&MAGIC);
    VERSION.write(&mut table);
    field::write_count(Section::ALL.len(), &mut table);
    for section in Section::ALL {
        let begin = body.len();
        section.write(image, &mut body);
        (section as u32).write(&mut table);
        field::write_count(body.len().saturating_sub(begin), &mut table);
    }
    table.resize(HEADER_BYTES, 0);
    table.append(&mut body);
    table
}

/// Puts signatures into their place in the bytes of an image.
pub(crate) fn sign(bytes: &mut [u8], signatures: &Signatures) {
    let place = bytes.get_mut(SIGNATURE_OFFSET..HEADER_BYTES).and_then(|block| block.split_at_mut_checked(32));
    if let Some((application, image)) = place {
        application.copy_from_slice(&signatures.application);
        image.copy_from_slice(&signatures.image);
    }
}

const SIGNATURE_OFFSET: usize = HEADER_BYTES - 64;

/// Hash of everything in the bytes of an image but the signatures.
pub(crate) fn body_hash(bytes: &[u8]) -> [u8; 32] {
    let mut hash = Sha256::new();
    hash.update(b"twinrung image body 1\0");
    hash.update(bytes.get(..SIGNATURE_OFFSET).unwrap_or_default());
    hash.update(bytes.get(HEADER_BYTES..).unwrap_or_default());
    hash.finalize().into()
}

/// Reads the records of an image.
///
/// # Errors
///
/// The first place that is not as [this page](self) says, or that is beyond [`crate::limits`].
pub fn read(bytes: &[u8]) -> Result<ReadImage, ImageError> {
    let (places, carried) = header(bytes)?;
    let mut image = Image::default();
    for place in places {
        let end = place.offset.saturating_add(place.length);
        let piece = bytes.get(place.offset..end).ok_or(ImageError::Truncated { offset: place.offset })?;
        place.section.read(&mut Cursor::new(piece, place.offset), &mut image)?;
    }
    Ok(ReadImage { image, carried, body: body_hash(bytes) })
}

/// Where the sections lie.
///
/// # Errors
///
/// The header is not as [this page](self) says.
pub fn section_places(bytes: &[u8]) -> Result<[SectionPlace; Section::ALL.len()], ImageError> {
    header(bytes).map(|(places, _)| places)
}

fn header(bytes: &[u8]) -> Result<([SectionPlace; Section::ALL.len()], Signatures), ImageError> {
    if bytes.len() > limits::IMAGE_BYTES {
        return Err(ImageError::TooManyBytes { count: bytes.len() });
    }
    let mut from = Cursor::new(bytes, 0);
    if from.array() != Ok(MAGIC) {
        return Err(ImageError::NotAnImage);
    }
    let version = u32::read(&mut from)?;
    if version != VERSION {
        return Err(ImageError::UnknownVersion { version });
    }
    if u32::read(&mut from)? as usize != Section::ALL.len() {
        return Err(ImageError::SectionTable { offset: 12 });
    }
    let mut places = Section::ALL.map(|section| SectionPlace { section, offset: 0, length: 0 });
    let mut next = HEADER_BYTES;
    for place in &mut places {
        let offset = from.offset();
        if u32::read(&mut from)? != place.section as u32 {
            return Err(ImageError::SectionTable { offset });
        }
        place.offset = next;
        place.length = u32::read(&mut from)? as usize;
        next = next.saturating_add(place.length);
    }
    let carried = Signatures { application: from.array()?, image: from.array()? };
    if next > bytes.len() {
        return Err(ImageError::Truncated { offset: bytes.len() });
    }
    if next < bytes.len() {
        return Err(ImageError::SlackBytes { offset: next });
    }
    Ok((places, carried))
}
