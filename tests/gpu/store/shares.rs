//! Shares of work: each item in one of them, whatever the numbers.

use corput::catalog::Shard;

fn shard(index: u64, count: u64) -> Shard {
    Shard::new(index, count).expect("a shard")
}

fn holding(item: u64, items: u64, count: u64) -> Option<Shard> {
    Shard::holding(item, items, count).ok()
}

#[test]
fn shards_have_each_item_once() {
    for count in 1..=40 {
        for items in 0..=50 {
            let mut next = 0;
            for index in 0..count {
                let own = shard(index, count).of(items);
                assert_eq!(own.start, next, "{index}/{count} of {items}");
                next = own.end;
                for item in own {
                    assert_eq!(holding(item, items, count), Some(shard(index, count)));
                }
            }
            assert_eq!(next, items, "{count} shards of {items}");
        }
    }
}

#[test]
fn items_that_are_dealt_are_in_one_shard() {
    for count in 1..=9 {
        for item in 0..30 {
            let having = (0..count).filter(|index| shard(*index, count).is_dealt(item));
            let having: Vec<u64> = having.collect();
            let dealt = Shard::dealing(item, count).expect("a shard");
            assert_eq!(
                (having, dealt.parts()),
                (vec![item % count], (item % count, count))
            );
        }
    }
    assert!(Shard::dealing(3, 0).is_err());
}

#[test]
fn the_largest_numbers_are_no_trouble() {
    let most = u64::MAX;
    assert_eq!(shard(most - 1, most).of(most), most - 1..most);
    assert_eq!(holding(most - 1, most, most), Some(shard(most - 1, most)));
    assert_eq!(holding(0, 1, most), Some(shard(most - 1, most)));
    assert_eq!(Shard::WHOLE.of(most), 0..most);
    assert_eq!((holding(3, 3, 2), holding(0, 1, 0)), (None, None));
}
