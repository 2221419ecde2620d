//! Discrete distributions and combined techniques: what a device must give, and how far
//! weights are from the truth.

use crate::environment::alias_table;
use crate::judge::ulp_error;
use crate::reference::discrete::{
    Reservoir, alias_index, alias_rest, alias_weight, cdf, cdf_invert, discrete_divide,
    discrete_part, discrete_rest, discrete_scale, reservoir_add, reservoir_merge, reservoir_pdf,
};
use crate::reference::mis::{
    mis_balance, mis_balance4, mis_choose, mis_maximum, mis_one_sample, mis_power, mis_power4,
    roulette, roulette_survival,
};
use glam::{UVec4, Vec4, uvec2};
use std::sync::LazyLock;

/// Where the alias table begins, and its items.
const ALIAS: u32 = 16;
const ITEMS: u32 = 5;

/// The words of the kernel's tables.
static TABLES: LazyLock<Vec<u32>> = LazyLock::new(|| {
    let cdf = (0..ALIAS).map(|i| if i == 0 { 13 } else { (i & 14) << 28 });
    let alias = alias_table(&[3, 1, 0, 10, 2]).expect("positive weights");
    cdf.chain(alias).collect()
});

fn counts(a: [u32; 4]) -> [u32; 4] {
    [a[2] & 7, a[3] & 3, a[3] >> 30, a[2] >> 30]
}

/// `evaluate_discrete.comp`, line by line; `None` for a name that it does not have.
pub fn reference(name: &str, a: [u32; 4]) -> Option<[u32; 4]> {
    let [x, y, z, w] = a;
    let words = TABLES.as_slice();
    let pdfs = Vec4::from_array(a.map(f32::from_bits));
    let n = UVec4::from_array(counts(a));
    Some(match name {
        "discrete_divide" => {
            let width = z.max(1);
            let part = x % width;
            [
                discrete_divide(uvec2(y, part), width),
                discrete_rest(part, width),
                discrete_part(x, w),
                discrete_scale(uvec2(x, y), z).y,
            ]
        }
        "cdf" => {
            let choice = cdf(0, x, words);
            [
                choice.index,
                choice.rest,
                choice.weight.x ^ (choice.weight.y << 31),
                cdf_invert(0, choice.index, choice.rest, words),
            ]
        }
        "alias" => {
            let weight = alias_weight(ALIAS, z % ITEMS, words);
            [
                alias_index(ALIAS, ITEMS, x, words),
                alias_rest(ALIAS, ITEMS, uvec2(x, y), words),
                weight.x,
                weight.y,
            ]
        }
        "reservoir" => {
            let r = Reservoir {
                index: x & 1023,
                weight: y,
                total: uvec2(z >> 1, w >> 1),
            };
            let more = reservoir_add(r, 1024, y >> (x & 31), z);
            let other = Reservoir {
                index: 1025,
                weight: x,
                total: uvec2(w >> 1, z >> 1),
            };
            let both = reservoir_merge(more, other, y);
            [
                both.index,
                more.index,
                both.total.y,
                reservoir_pdf(both).to_bits(),
            ]
        }
        "mis" => [
            mis_balance(n.x, pdfs.x, n.y, pdfs.y),
            mis_power(n.x, pdfs.x, n.y, pdfs.y),
            mis_maximum(n.x, pdfs.x, n.y, pdfs.y),
            mis_one_sample(n, pdfs),
        ]
        .map(f32::to_bits),
        "mis_four" => {
            let technique = mis_choose(UVec4::from_array(a.map(|w| w >> 2)), x ^ w);
            [
                mis_balance4(n, pdfs).to_bits(),
                mis_power4(n, pdfs).to_bits(),
                technique.index,
                technique.rest,
            ]
        }
        "roulette" => {
            let r = roulette(x, y);
            [
                u32::from(r.survives),
                r.weight.to_bits(),
                r.rest,
                roulette_survival(pdfs.z),
            ]
        }
        _ => return None,
    })
}

/// The larger error of the balance and the power heuristic in ULP; of weights that are no
/// normal floats nothing is asked.
pub fn error(name: &str, a: [u32; 4], got: [u32; 4]) -> Option<f64> {
    if name != "mis" {
        return None;
    }
    let n = counts(a).map(f64::from);
    let term = |i: usize| match f32::from_bits(a[i]) {
        pdf if pdf.is_infinite() && pdf > 0.0 => n[i] * 1e150,
        pdf if pdf >= f32::MIN_POSITIVE => n[i] * f64::from(pdf),
        _ => 0.0,
    };
    let (p, q) = (term(0), term(1));
    let worst = (0..2).map(|i| {
        let truth = match p {
            0.0 => 0.0,
            _ => 1.0 / (1.0 + (q / p).powi(i + 1)),
        };
        let weight = f32::from_bits(got[i as usize]);
        if truth < f64::from(f32::MIN_POSITIVE) * 1.1 && weight <= f32::MIN_POSITIVE * 1.1 {
            0.0
        } else {
            ulp_error(weight, truth)
        }
    });
    Some(worst.fold(0.0, f64::max))
}
