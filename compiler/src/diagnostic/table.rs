//! The table of all codes.

use super::Code;

/// Every code, the rules' ones after those of reading and resolving.
pub fn all() -> impl Iterator<Item = &'static Code> {
    super::codes::HERE.iter().copied().chain(crate::rules::CODES.iter().copied())
}

/// Every code, as a list ordered by id.
pub static ALL: std::sync::LazyLock<Vec<&'static Code>> = std::sync::LazyLock::new(|| {
    let mut list: Vec<&'static Code> = all().collect();
    list.sort_by_key(|code| code.id);
    list
});

/// The code with this id; upper and lower case are the same.
pub fn by_id(id: &str) -> Option<&'static Code> {
    all().find(|code| code.id.eq_ignore_ascii_case(id))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_when_listed_then_ids_are_unique_and_texts_complete() {
        let mut ids: Vec<_> = ALL.iter().map(|code| code.id).collect();
        let listed = ids.len();
        ids.dedup();
        assert_eq!(ids.len(), listed);
        assert!(ALL.iter().all(|code| !code.title.is_empty() && !code.explanation.is_empty()));
    }
}
