//! Seeds as values, and the counter-based random numbers drawn from them.
//!
//! A seed is the path of a shape through the derivation, folded into 64 bits: [`Seed::child`] for a successor,
//! [`Seed::draw`] for one named use. Two shapes share no numbers, and no shape's numbers depend on what was drawn
//! elsewhere, so an edit in one corner leaves every other tree where it stood, on any number of threads.
//! The generator is Widynski's squares (arXiv:2004.06278); the samplers are ours and frozen by golden tests.

/// Where random numbers come from: a value, copied freely, never advanced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Seed(pub u64);

impl Seed {
    /// The seed of the successor number `index`.
    #[inline]
    pub fn child(self, index: u64) -> Seed {
        Seed(mix(self.0 ^ mix(index.wrapping_add(0x9e37_79b9_7f4a_7c15))))
    }

    /// The seed of what carries `name`: an attribute, a region, a layer.
    #[inline]
    pub fn named(self, name: &str) -> Seed {
        let hash =
            name.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01b3));
        self.child(hash)
    }

    /// A stream of numbers for one use, called `name`.
    #[inline]
    pub fn draw(self, name: &str) -> Random {
        self.named(name).random()
    }

    /// A stream of numbers of this very seed.
    #[inline]
    pub fn random(self) -> Random {
        // The squares generator wants keys whose bits are well mixed, and odd.
        Random { key: mix(self.0) | 1, counter: 0 }
    }
}

/// A stream of random numbers: squares64 over a counter.
#[derive(Clone, Debug)]
pub struct Random {
    key: u64,
    counter: u64,
}

impl Random {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.counter = self.counter.wrapping_add(1);
        squares(self.counter, self.key)
    }

    /// A number in `[0, 1)`, 53 random bits.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// A number in `[from, to)`.
    pub fn uniform(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.unit()
    }

    /// A whole number in `0..count`, without bias (Lemire); 0 when `count` is 0.
    pub fn below(&mut self, count: u64) -> u64 {
        if count == 0 {
            return 0;
        }
        loop {
            let product = u128::from(self.bits()) * u128::from(count);
            if product as u64 >= count.wrapping_neg() % count {
                return (product >> 64) as u64;
            }
        }
    }

    /// A normally distributed number (Box–Muller, one of the pair).
    pub fn normal(&mut self, mean: f64, deviation: f64) -> f64 {
        let (u, v) = (1.0 - self.unit(), self.unit());
        let radius = (-2.0 * libm::log(u)).sqrt();
        mean + deviation * radius * libm::cos(std::f64::consts::TAU * v)
    }

    /// An index chosen with the given weights; `None` when they sum to nothing.
    pub fn choose(&mut self, weights: &[f64]) -> Option<usize> {
        let total: f64 = weights.iter().filter(|w| **w > 0.0).sum();
        let mut left = self.unit() * total;
        let mut last = None;
        for (index, weight) in weights.iter().enumerate().filter(|(_, w)| **w > 0.0) {
            last = Some(index);
            left -= weight;
            if left < 0.0 {
                break;
            }
        }
        last
    }
}

/// SplitMix64's finaliser: every input bit reaches every output bit.
#[inline]
fn mix(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Five rounds of squaring (Widynski's squares64).
fn squares(counter: u64, key: u64) -> u64 {
    let y = counter.wrapping_mul(key);
    let z = y.wrapping_add(key);
    let round = |x: u64, add: u64| x.wrapping_mul(x).wrapping_add(add);
    let x = round(y, y).rotate_right(32);
    let x = round(x, z).rotate_right(32);
    let x = round(x, y).rotate_right(32);
    let t = round(x, z);
    t ^ (round(t.rotate_right(32), y) >> 32)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOLDEN: [u64; 3] = [9747599291331141702, 882895351825367054, 3300048326582208514];

    #[test]
    fn streams_are_frozen() {
        // These values are the promise "same seed, same garden" between versions: change them only with a major one.
        let mut random = Seed(7).child(3).draw("rand");
        let got: Vec<u64> = (0..3).map(|_| random.bits()).collect();
        assert_eq!(got, GOLDEN);
    }

    #[test]
    fn samplers_have_their_moments() {
        let mut random = Seed(1).random();
        let n = 200_000;
        let unit: f64 = (0..n).map(|_| random.unit()).sum::<f64>() / f64::from(n);
        assert!((unit - 0.5).abs() < 0.003, "{unit}");
        let normals: Vec<f64> = (0..n).map(|_| random.normal(3.0, 0.5)).collect();
        let mean = normals.iter().sum::<f64>() / f64::from(n);
        let variance = normals.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / f64::from(n);
        assert!((mean - 3.0).abs() < 0.01 && (variance - 0.25).abs() < 0.005, "{mean} {variance}");
        let mut counts = [0u32; 7];
        (0..n).for_each(|_| counts[random.below(7) as usize] += 1);
        assert!(counts.iter().all(|c| (f64::from(*c) * 7.0 / f64::from(n) - 1.0).abs() < 0.03));
    }

    #[test]
    fn choice_follows_weights_and_skips_nothings() {
        let mut random = Seed(2).random();
        assert_eq!(random.choose(&[0.0, -1.0]), None);
        let hits = (0..10_000).filter(|_| random.choose(&[1.0, 0.0, 3.0]) == Some(2)).count();
        assert!((7_300..7_700).contains(&hits), "{hits}");
    }
}
