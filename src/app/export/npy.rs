//! Arrays as files of NumPy.

use ndarray::Array2;

/// Bytes to whose multiple a header is filled up.
const ALIGNED: usize = 64;
/// Magic word and version 1.0.
const BEGIN: &[u8] = b"\x93NUMPY\x01\x00";

/// An array as `numpy.load` reads it: format 1.0, little-endian numbers of 8 bytes, row by row.
#[must_use]
pub fn npy(array: &Array2<f64>) -> Vec<u8> {
    let (rows, columns) = array.dim();
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
    let length = (BEGIN.len() + 2 + header.len() + 1).next_multiple_of(ALIGNED) - BEGIN.len() - 2;
    header.extend(std::iter::repeat_n(' ', length - header.len() - 1));
    header.push('\n');
    let mut bytes = BEGIN.to_vec();
    bytes.extend(u16::try_from(length).unwrap_or(u16::MAX).to_le_bytes());
    bytes.extend(header.bytes());
    bytes.extend(array.iter().flat_map(|number| number.to_le_bytes()));
    bytes
}
