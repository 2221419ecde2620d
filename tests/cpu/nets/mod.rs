//! Elementary intervals in base 2.

/// Intervals of area 2^-m, of all m + 1 shapes, that do not hold exactly one of 2^m
/// points.
pub fn wrong_intervals(points: &[[u32; 2]], m: u32) -> usize {
    assert_eq!(points.len(), 1 << m);
    let mut wrong = 0;
    for across in 0..=m {
        let mut held = vec![0u32; 1 << m];
        for [x, y] in points {
            let column = u64::from(*x) >> (32 - across);
            let row = u64::from(*y) >> (32 - (m - across));
            held[((column << (m - across)) | row) as usize] += 1;
        }
        wrong += held.iter().filter(|&&count| count != 1).count();
    }
    wrong
}

/// Whether 2^m points are a (0, m, 2)-net.
pub fn is_net(points: &[[u32; 2]], m: u32) -> bool {
    wrong_intervals(points, m) == 0
}
