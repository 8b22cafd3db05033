//! Table of agreement of the rough bed with the full half-space over seeds and H = 0.2 … 0.9.
//!
//! `cargo run --release -p benches --example rough_agreement -- [points [seeds]]`

use springbed::check::agreement::{Agreement, AgreementError, Compared};

fn main() -> Result<(), AgreementError> {
    let mut numbers = std::env::args().skip(1).filter_map(|text| text.parse().ok());
    let points = numbers.next().unwrap_or(128);
    let study = Agreement { points, seeds: (1..=numbers.next().unwrap_or(8) as u64).collect(), ..Agreement::default() };
    println!("{points}² pixels, {} seeds: rough bed | half-space, mean ± deviation", study.seeds.len());
    println!(
        "H    1/(1+H)  exponent                      prefactor                     share in contact              Persson"
    );
    let pair = |c: Compared| {
        let one = |s: springbed::shape::rough::Scatter| format!("{:.3} ± {:.3}", s.mean, s.deviation);
        format!("{} | {}", one(c.bed), one(c.half_space))
    };
    for tenths in [2, 4, 6, 8, 9] {
        let row = study.row(f64::from(tenths) / 10.0, |_| ())?;
        let (law, exponent, prefactor, area) = (row.law, pair(row.exponent), pair(row.prefactor), pair(row.area));
        println!("{:.1}  {law:.3}    {exponent:30}{prefactor:30}{area:30}{:.4}", row.hurst, row.persson_area);
    }
    Ok(())
}
