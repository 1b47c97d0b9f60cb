//! Passwords for locking and for unlocking: optional, and separate (1756-RM093 Lock the GuardLogix Controller).

use std::fmt;

use argon2::Argon2;
use argon2::password_hash::rand_core::OsRng;
use argon2::password_hash::{PasswordHash, PasswordHasher, PasswordVerifier, SaltString};
use serde::{Deserialize, Serialize};

/// Longest password in bytes: long enough for a sentence, short enough to be no load.
pub const PASSWORD_BYTES_MAX: usize = 128;

/// The hashes of both passwords; none where none is set.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Passwords {
    /// For locking.
    pub lock: Option<Hash>,
    /// For unlocking.
    pub unlock: Option<Hash>,
}

/// The Argon2id hash of a password, with its salt and its costs, in the PHC form.
#[derive(Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Hash(String);

impl fmt::Debug for Hash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Hash(..)")
    }
}

/// Why a password does not open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PasswordError {
    /// One is set, and none was given.
    Missing,
    /// It is another one.
    Wrong,
    /// It is empty or longer than [`PASSWORD_BYTES_MAX`].
    Length,
    /// The kept hash is none, or no random salt was to be had.
    Hash,
}

impl fmt::Display for PasswordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PasswordError::Missing => {
                f.write_str("a password is set: give it with --password FILE, or - for the standard input")
            }
            PasswordError::Wrong => f.write_str("that is not the password"),
            PasswordError::Length => write!(f, "a password has 1 to {PASSWORD_BYTES_MAX} bytes"),
            PasswordError::Hash => f.write_str("the password cannot be hashed or checked"),
        }
    }
}

impl std::error::Error for PasswordError {}

/// Hashes a new password with a salt of its own.
///
/// # Errors
///
/// [`PasswordError::Length`], [`PasswordError::Hash`].
pub fn hash(password: &[u8]) -> Result<Hash, PasswordError> {
    if password.is_empty() || password.len() > PASSWORD_BYTES_MAX {
        return Err(PasswordError::Length);
    }
    let salt = SaltString::generate(&mut OsRng);
    let hashed = Argon2::default().hash_password(password, &salt).map_err(|_| PasswordError::Hash)?;
    Ok(Hash(hashed.to_string()))
}

/// Checks a password against the one that is set; anything will do where none is.
///
/// # Errors
///
/// [`PasswordError::Missing`], [`PasswordError::Wrong`], [`PasswordError::Hash`].
pub fn check(set: Option<&Hash>, given: Option<&[u8]>) -> Result<(), PasswordError> {
    let Some(Hash(set)) = set else { return Ok(()) };
    let given = given.ok_or(PasswordError::Missing)?;
    let set = PasswordHash::new(set).map_err(|_| PasswordError::Hash)?;
    Argon2::default().verify_password(given, &set).map_err(|error| match error {
        argon2::password_hash::Error::Password => PasswordError::Wrong,
        _ => PasswordError::Hash,
    })
}
