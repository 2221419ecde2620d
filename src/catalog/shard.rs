//! Shares of work that machines do apart.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use crate::{Error, Result};

/// Share `index` of `count`, from 0: of items 0..n those from floor(index n / count) up to the
/// next share's first. The shares of one count have each item once.
///
/// ```
/// use corput::catalog::Shard;
///
/// let shard: Shard = "1/3".parse()?;
/// assert_eq!(shard.of(10), 3..6);
/// assert_eq!(Shard::holding(5, 10, 3)?, shard);
/// # Ok::<(), corput::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Shard {
    /// Everything: 0/1.
    pub const WHOLE: Self = Self { index: 0, count: 1 };

    /// Share `index` of `count`.
    ///
    /// # Errors
    /// [`Error::Arguments`] for no shares, and for an index that is not below their number.
    pub fn new(index: u64, count: u64) -> Result<Self> {
        let refused = |limit: &str, remedy: String| Error::Arguments {
            asked: format!("shard {index}/{count}"),
            limit: limit.to_owned(),
            remedy,
        };
        match count.checked_sub(1) {
            None => Err(refused(
                "work is cut into at least one shard",
                "give --shard 0/1, or none, for all of it".to_owned(),
            )),
            Some(last) if index > last => Err(refused(
                "shards count from 0",
                format!("the last of {count} is {last}/{count}"),
            )),
            Some(_) => Ok(Self { index, count }),
        }
    }

    /// Its items, of `items`. With more shares than items, some have none.
    #[must_use]
    pub fn of(self, items: u64) -> Range<u64> {
        let begin = |index: u64| {
            let at = u128::from(index) * u128::from(items) / u128::from(self.count);
            // At most `items`, since no index is above the count.
            at as u64
        };
        begin(self.index)..begin(self.index + 1)
    }

    /// Index and number of shares.
    #[must_use]
    pub fn parts(self) -> (u64, u64) {
        (self.index, self.count)
    }

    /// Whether it has an item where they are dealt in turn, as cards are: item 0 to share 0, item
    /// 1 to share 1.
    #[must_use]
    pub fn is_dealt(self, item: u64) -> bool {
        item % self.count == self.index
    }

    /// The share that is dealt an item, of `count` shares.
    ///
    /// # Errors
    /// As [`Shard::new`].
    pub fn dealing(item: u64, count: u64) -> Result<Self> {
        Self::new(item.checked_rem(count).unwrap_or_default(), count)
    }

    /// The share that has an item, of `items` in `count` shares.
    ///
    /// # Errors
    /// As [`Shard::new`], and for an item that is none of them.
    pub fn holding(item: u64, items: u64, count: u64) -> Result<Self> {
        if item >= items {
            return Err(Error::Arguments {
                asked: format!("the shard of item {item}"),
                limit: format!("there are {items}, counted from 0"),
                remedy: "ask for one of them".into(),
            });
        }
        let index = (u128::from(count) * (u128::from(item) + 1)).saturating_sub(1);
        // Below the count, since item + 1 is at most `items`.
        Self::new((index / u128::from(items)) as u64, count)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let parts = text.split_once('/');
        let parts =
            parts.and_then(|(index, count)| Some((index.parse().ok()?, count.parse().ok()?)));
        let (index, count) = parts.ok_or_else(|| Error::Arguments {
            asked: format!("shard `{text}`"),
            limit: "a shard is its index and their number, as 3/8".into(),
            remedy: "count from 0: 0/8 is the first of 8, 7/8 the last".into(),
        })?;
        Self::new(index, count)
    }
}
