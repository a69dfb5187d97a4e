//! Which cells around a cell are taken.
//!
//! In: a set of cells as bits, a distance. Out: those of the set that come so near. A look around a place reads whole
//! rows of bits, packs them into words and passes over empty cells without a look at them.

/// The most cells that are read at once.
const WIDEST: i64 = 57;

/// A set of cells.
#[derive(Clone)]
pub struct Bits(Vec<u8>);

/// The cells around a cell that disks can come from, for some distances.
#[derive(Clone)]
pub struct Windows {
    windows: Vec<Vec<Pack>>,
    /// Windows for each metre.
    scale: f64,
}

/// Rows of a window whose cells fill a word.
#[derive(Clone)]
pub struct Pack {
    rows: Vec<Row>,
    /// From the cell in the middle to that of each bit.
    offsets: [i32; 64],
}

/// A row of a window, or a part of it.
#[derive(Clone)]
struct Row {
    /// From the cell in the middle to the first of the row.
    offset: i32,
    /// Which of the cells from there on are in the row.
    mask: u64,
    /// By how much they are moved in the word.
    shift: u32,
}

impl Bits {
    /// Room for so many cells, none of them in it.
    pub fn new(count: usize) -> Bits {
        Bits(vec![0; count / 8 + 8])
    }

    /// Puts a cell in.
    pub fn set(&mut self, index: usize) {
        self.0[index / 8] |= 1 << (index % 8);
    }

    /// Whether a cell is in it.
    pub fn has(&self, index: usize) -> bool {
        self.0[index / 8] >> (index % 8) & 1 == 1
    }

    /// Whether one of its cells in the windows around a cell passes a test; near rows are tested first.
    #[inline(always)]
    pub fn any(&self, at: usize, packs: &[Pack], mut test: impl FnMut(usize) -> bool) -> bool {
        for pack in packs {
            let mut bits = self.packed(at, pack);
            while bits != 0 {
                if test(ahead(at, pack.offsets[bits.trailing_zeros() as usize % 64])) {
                    return true;
                }
                bits &= bits - 1;
            }
        }
        false
    }

    #[inline(always)]
    fn packed(&self, at: usize, pack: &Pack) -> u64 {
        pack.rows.iter().fold(0, |bits, row| bits | (self.from(ahead(at, row.offset)) & row.mask) << row.shift)
    }

    /// The cells from one on, it being the lowest bit; at least [`WIDEST`].
    #[inline(always)]
    fn from(&self, index: usize) -> u64 {
        let mut bytes = [0; 8];
        bytes.copy_from_slice(&self.0[index / 8..index / 8 + 8]);
        u64::from_le_bytes(bytes) >> (index % 8)
    }
}

impl Windows {
    /// So many of them for distances up to `reach` metres, in buffers whose rows are `stride` cells of side `cell`
    /// long.
    pub fn new(count: usize, stride: i64, cell: f64, reach: f64) -> Windows {
        let scale = count as f64 / reach;
        let windows = (1..=count).map(|step| packed(rows(stride, cell, step as f64 / scale))).collect();
        Windows { windows, scale }
    }

    /// The cells that come nearer to a cell than `reach` metres.
    pub fn of(&self, reach: f64) -> &[Pack] {
        &self.windows[((reach * self.scale) as usize).min(self.windows.len() - 1)]
    }
}

#[inline(always)]
fn ahead(at: usize, offset: i32) -> usize {
    (at as i64 + i64::from(offset)) as usize
}

/// The first cell and the number of cells in each row that come nearer to a cell than `reach` metres.
fn rows(stride: i64, cell: f64, reach: f64) -> Vec<[i64; 2]> {
    // Rounding may put a centre into the cell beside its own.
    let reach = reach / cell * (1.0 + 1e-9);
    let between = |d: i64| (d.abs() - 1).max(0) as f64;
    let rim = reach.ceil() as i64;
    let mut rows: Vec<i64> = (-rim..=rim).filter(|row| between(*row) < reach).collect();
    rows.sort_by_key(|row| (row.abs(), *row));
    let half = |row: i64| (reach * reach - between(row) * between(row)).sqrt().ceil() as i64;
    let whole = rows.into_iter().map(|row| [row * stride - half(row), 2 * half(row) + 1]);
    let part = |[first, count]: [i64; 2], done: i64| [first + done, (count - done).min(WIDEST)];
    whole.flat_map(|row| (0..row[1]).step_by(WIDEST as usize).map(move |done| part(row, done))).collect()
}

fn packed(rows: Vec<[i64; 2]>) -> Vec<Pack> {
    let mut packs: Vec<Pack> = Vec::new();
    let mut full = 64;
    for [first, count] in rows {
        if full + count > 64 {
            packs.push(Pack { rows: Vec::new(), offsets: [0; 64] });
            full = 0;
        }
        if let Some(pack) = packs.last_mut() {
            pack.rows.push(Row { offset: first as i32, mask: (1 << count) - 1, shift: full as u32 });
            (0..count).for_each(|i| pack.offsets[(full + i) as usize] = (first + i) as i32);
        }
        full += count;
    }
    packs
}
