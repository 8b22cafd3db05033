//! Table of agreement of the rough bed with the full half-space over seeds and H = 0.2 … 0.9.
//!
//! `cargo run --release -p benches --example rough_agreement -- [points [seeds]]`

use springbed::check::agreement::SelfAffineSquares;
use springbed::check::case::Attempt;
use springbed::shape::rough::Scatter;

fn main() -> Attempt<()> {
    let mut numbers = std::env::args().skip(1).filter_map(|text| text.parse().ok());
    let points = numbers.next().unwrap_or(128);
    let seeds: Vec<u64> = (1..=numbers.next().unwrap_or(8) as u64).collect();
    println!("{points}² pixels, {} seeds: rough bed | half-space, mean ± deviation", seeds.len());
    println!(
        "H    1/(1+H)  exponent                      prefactor                     share in contact              Persson"
    );
    let pair = |[bed, half_space]: [Scatter; 2]| {
        let one = |s: Scatter| format!("{:.3} ± {:.3}", s.mean, s.deviation);
        format!("{} | {}", one(bed), one(half_space))
    };
    for hurst in [0.2, 0.4, 0.6, 0.8, 0.9] {
        let row = SelfAffineSquares { hurst, points, seeds: seeds.clone() }.agreement(|_| ())?;
        let (law, exponent, prefactor, area) = (row.law, pair(row.exponent), pair(row.prefactor), pair(row.area));
        println!("{hurst:.1}  {law:.3}    {exponent:30}{prefactor:30}{area:30}{:.4}", row.persson_area);
    }
    Ok(())
}
