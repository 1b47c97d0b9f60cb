//! Modules.

use twinrung_grammar::tree::{self, CompactString, PointKind, Span};

/// A module of the I/O tree.
#[derive(Debug, Clone)]
pub struct Module {
    /// Its name.
    pub name: CompactString,
    /// Where it is declared.
    pub span: Span,
    /// Catalogue number, where it is known.
    pub catalog_number: CompactString,
    /// Whether it carries safety data.
    pub safety: bool,
    /// The module that it is attached to.
    pub parent: CompactString,
    /// Slot in the parent's chassis or rack.
    pub slot: Option<u32>,
    /// Safety network number as written.
    pub safety_network: Option<(CompactString, Span)>,
    /// The canonical declaration, for the signature.
    pub text: String,
    /// The points that it configures.
    pub points: Vec<Point>,
    /// What was read, without opaque data: for the rules of configuration.
    pub shown: Box<tree::Module>,
}

/// The configuration of a point or test output.
#[derive(Debug, Clone)]
pub struct Point {
    /// A point of safety data, or a test output.
    pub kind: PointKind,
    /// `I00`, `O03`, `T1`, in upper case.
    pub name: CompactString,
    /// Where the name stands.
    pub span: Span,
    /// Declared integrity.
    pub sil: Option<u32>,
    /// Keys and values.
    pub settings: Vec<Setting>,
}

/// One setting of a point.
#[derive(Debug, Clone)]
pub struct Setting {
    /// The key, as written.
    pub key: CompactString,
    /// Where the key stands.
    pub key_span: Span,
    /// The value, as written.
    pub value: CompactString,
    /// Where the value stands.
    pub value_span: Span,
}

impl Point {
    /// A setting by its key.
    pub fn setting(&self, key: &str) -> Option<&Setting> {
        self.settings.iter().find(|one| one.key.eq_ignore_ascii_case(key))
    }

    /// Whether a setting has this word.
    pub fn has(&self, key: &str, word: &str) -> bool {
        self.setting(key).is_some_and(|one| one.value.eq_ignore_ascii_case(word))
    }

    /// Whether the module evaluates the point together with its neighbour.
    pub fn is_dual(&self) -> bool {
        self.has("Channel", "DUAL") || self.has("Type", "EQUIVALENT") || self.has("Type", "COMPLEMENTARY")
    }
}

impl Module {
    /// The configured point with this letter and number.
    pub fn point(&self, letter: char, number: u32) -> Option<&Point> {
        self.points.iter().find(|point| point_number(&point.name) == Some((letter, number)))
    }

    /// The configured input point behind a member of the input tag: `I00` behind `Pt00Data`, `C0` behind `Ch0Data`.
    pub fn point_of(&self, member: &str) -> Option<&Point> {
        let (letter, number) = point_behind(member)?;
        self.point(letter, number)
    }

    /// Whether a standard device is connected to the point behind a data member (1734-UM013 Tables 18 and 21).
    pub fn is_standard(&self, member: &str) -> bool {
        let data = member.len() >= 4 && member.to_ascii_lowercase().ends_with("data");
        data && self.point_of(member).is_some_and(|point| point.has("Mode", "STANDARD"))
    }

    /// Whether the module itself evaluates the point behind a member together with its neighbour.
    pub fn is_dual(&self, member: &str) -> bool {
        let Some((letter, number)) = point_behind(member) else { return false };
        [number, number ^ 1].into_iter().any(|number| self.point(letter, number).is_some_and(Point::is_dual))
    }
}

/// `I00` as letter and number.
pub(crate) fn point_number(name: &str) -> Option<(char, u32)> {
    let letter = name.chars().next()?.to_ascii_uppercase();
    let digits = name.get(1..)?;
    let number = digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok())??;
    letter.is_ascii_alphabetic().then_some((letter, number))
}

fn point_behind(member: &str) -> Option<(char, u32)> {
    let lower = member.to_ascii_lowercase();
    let (letter, rest) = match (lower.strip_prefix("pt"), lower.strip_prefix("ch")) {
        (Some(rest), _) => ('I', rest),
        (None, Some(rest)) => ('C', rest),
        (None, None) => return None,
    };
    let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
    Some((letter, digits.parse().ok()?))
}
