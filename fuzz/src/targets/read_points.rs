//! Bytes that claim to be coordinates, separated by white space or commas.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Runs one case as both formats.
pub(crate) fn run(bytes: &[u8]) {
    check(bytes, &Files::default(), Expected::new(Format::Xyz));
    check(bytes, &Files::default(), Expected::new(Format::Csv));
}

/// Makes tables with and without heads, and hostile ones.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let texts = [
        "0 0 0\n1 0 0\n0 1 0\n\n5 5 5\n6 6 6\n",
        "# x y z\n0\t0\t0\r\n1\t2\t3\r\n",
        "x,y,z\n0,0,0\n1,0,0\n0,1,0\n",
        "x;y;z\n0,5;0;0\n1;2,5;3\n",
        "\u{feff}\"X\",\"Y\",\"Z\",nx,ny,nz,r,g,b\n1,2,3,0,0,1,255,0,0\n4,5,6,0,1,0,0,255,0\n",
        "2\n1 2 3\n4 5 6\n",
        "1 2\n3 4\n",
        "1,2,3,\n,,\n4,5\n",
        "nan inf 1e999\n-nan(ind) 1.#QNAN -1e-999\n",
        "\"\"\"\"\"\n,,,,,,,,,,,,\n",
        "",
    ];
    texts.iter().map(|text| text.as_bytes().to_vec()).collect()
}
