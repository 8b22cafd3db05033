//! `springbed fit`: parameters of a scene from measured curves.

use super::Common;
use super::delivery::{Files, Findings, Written};
use crate::app::console::{Console, Failure};
use crate::app::data_file::{Data, Wanted};
use crate::app::export::{self, FitsRow, Fitted};
use crate::app::fitting::Fitting;
use crate::app::scene_file::SceneFile;
use crate::app::table_file::TableFiles;
use crate::fit::{FitError, Sweeps, Terms};
use crate::input::quantity::{SpringStiffness, Temperature};
use crate::scene::fit::{Baseline, Drive, FirstTouch, Loss, Measured, Way};
use clap::Args;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// What a fit is asked for.
#[derive(Debug, Clone, Args)]
pub struct Arguments {
    /// Scene file; its values are where the search starts, its `fit` says what is not said here.
    #[arg(value_name = "SCENE.ron", required_unless_present = "moduli")]
    scene: Option<PathBuf>,
    /// Data files; each is fitted by itself.
    #[arg(value_name = "DATA")]
    data: Vec<PathBuf>,
    /// Free parameter and its range, such as `bodies.0.young=1 kPa..1 MPa`; may be given several times.
    #[arg(long, value_name = "PATH=LO..HI")]
    free: Vec<String>,
    /// Columns of the data, such as "depth=z [nm], force=F [nN], time=t [s]", "speed=v [m/s], restitution=e" or
    /// "slide=x [um], tangential=Fx [mN]"; by their names if not given.
    #[arg(long, value_name = "COLUMNS", allow_hyphen_values = true)]
    columns: Option<String>,
    /// Stiffness of the cantilever, for data of deflection and piezo, such as "0.05 N/m".
    #[arg(long, value_name = "STIFFNESS")]
    spring: Option<SpringStiffness>,
    /// Line under the force: absent, constant (the default), linear, or virtual: a deflection of the cantilever in proportion
    /// to the way of the piezo.
    #[arg(long, value_name = "KIND", value_parser = baseline)]
    baseline: Option<Baseline>,
    /// First touch: free (the default), or at the zero of the depths.
    #[arg(long, value_name = "WHERE", value_parser = contact)]
    contact: Option<FirstTouch>,
    /// What drives, depth, force, speed or slide; what the history says if not given: an impact its speed, a last entry that
    /// slides its slide, else the first entry.
    #[arg(long, value_name = "WHAT", value_parser = drive)]
    drive: Option<Drive>,
    /// Way that counts: both (the default), in or out.
    #[arg(long, value_name = "WAY", value_parser = way)]
    way: Option<Way>,
    /// Depths that count, as measured, such as "-1 um..300 nm"; forces where they drive.
    #[arg(long, value_name = "LO..HI", allow_hyphen_values = true)]
    range: Option<String>,
    /// Points far off count less.
    #[arg(long)]
    robust: bool,
    /// Number known with a standard error only, such as "shape.radius=2 %" or "spring=10 %"; may be given several times.
    #[arg(long, value_name = "PATH=SPREAD")]
    given: Vec<String>,
    /// Models that are compared: scene, hertz, jkr, maugis, layered, power-law, or scene files beside the scene.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    models: Vec<String>,
    /// Two free parameters over which the confidence is mapped, such as bodies.0.young,adhesion.work.
    #[arg(long, value_name = "PATH,PATH")]
    map: Option<String>,
    /// Relaxation spectrum from storage and loss moduli over frequency, instead of curves.
    #[arg(long, value_name = "DATA", conflicts_with_all = ["scene", "data", "free", "given", "models", "map"])]
    moduli: Option<PathBuf>,
    /// Terms of the spectrum: fewest, or a number; a smooth spectrum if not given.
    #[arg(long, value_name = "COUNT", requires = "moduli", conflicts_with = "scene")]
    terms: Option<Terms>,
    /// Reference temperature of moduli at several temperatures, such as "25 degC"; the middle one if not given.
    #[arg(long, value_name = "TEMPERATURE", requires = "moduli", conflicts_with = "scene")]
    reference: Option<Temperature>,
    /// Moduli at several temperatures are shifted too, by T over the reference, as those of rubbers above the glass transition.
    #[arg(long, requires = "moduli", conflicts_with = "scene")]
    vertical: bool,
}

fn baseline(text: &str) -> Result<Baseline, String> {
    match text {
        "absent" => Ok(Baseline::Absent),
        "constant" => Ok(Baseline::Constant),
        "linear" => Ok(Baseline::Linear),
        "virtual" => Ok(Baseline::Virtual),
        _ => Err("expected absent, constant, linear or virtual".to_owned()),
    }
}

fn contact(text: &str) -> Result<FirstTouch, String> {
    match text {
        "free" => Ok(FirstTouch::Free),
        "zero" => Ok(FirstTouch::Zero),
        _ => Err("expected free or zero".to_owned()),
    }
}

fn drive(text: &str) -> Result<Drive, String> {
    match text {
        "depth" => Ok(Drive::Depth),
        "force" => Ok(Drive::Force),
        "speed" => Ok(Drive::Speed),
        "slide" => Ok(Drive::Slide),
        _ => Err("expected depth, force, speed or slide".to_owned()),
    }
}

fn way(text: &str) -> Result<Way, String> {
    match text {
        "both" => Ok(Way::Both),
        "in" => Ok(Way::In),
        "out" => Ok(Way::Out),
        _ => Err("expected both, in or out".to_owned()),
    }
}

impl Arguments {
    /// What the scene at `path` asks for, and in its place what is asked for here.
    fn over(&self, scene: &SceneFile) -> Measured {
        let written = scene.plan.scene.fit.clone().unwrap_or_default();
        let folder = scene.path.parent().unwrap_or_else(|| Path::new(""));
        let data = written.data.iter().map(|path| folder.join(path)).collect();
        Measured {
            data: if self.data.is_empty() { data } else { self.data.clone() },
            free: if self.free.is_empty() { written.free } else { self.free.clone() },
            columns: self.columns.clone().unwrap_or(written.columns),
            spring: self.spring.or(written.spring),
            baseline: self.baseline.unwrap_or(written.baseline),
            contact: self.contact.unwrap_or(written.contact),
            drive: self.drive.or(written.drive),
            way: self.way.unwrap_or(written.way),
            range: self.range.clone().unwrap_or(written.range),
            loss: if self.robust { Loss::Robust } else { written.loss },
            given: if self.given.is_empty() { written.given } else { self.given.clone() },
            map: self.map.clone().unwrap_or(written.map),
            models: if self.models.is_empty() { written.models } else { self.models.clone() },
        }
    }
}

/// Fits curves, each by itself, on all threads; the files of each are written as soon as it is fitted, so that no more
/// curves are held than there are threads.
///
/// # Errors
/// The scene, a parameter or a range is wrong; a curve cannot be fitted (the others are); a file cannot be written.
pub fn run(arguments: &Arguments, common: &Common, console: &Console) -> Result<(), Failure> {
    if let Some(path) = &arguments.moduli {
        return moduli(path, arguments, common, console);
    }
    let Some(path) = &arguments.scene else {
        return Err(Failure::Usage("there is no scene: expected SCENE.ron".to_owned()));
    };
    let scene = SceneFile::load(path).map_err(Failure::Scene)?;
    let measured = arguments.over(&scene);
    if measured.data.is_empty() {
        return Err(Failure::Usage(
            "there are no data: expected files behind the scene, or fit: (data: [...]) in it".to_owned(),
        ));
    }
    let folder = path.parent().unwrap_or_else(|| Path::new(""));
    let fitting = Fitting::new(&measured, &scene.plan.scene, folder).map_err(Failure::Usage)?;
    let stems = stems(&measured.data)?;
    not_over_inputs(&measured.data, &scene, &stems, common)?;
    let progress = console.progress(measured.data.len(), "curves");
    let tables = TableFiles::beside(&scene.path);
    let one = |(path, stem): (&PathBuf, &String)| {
        let fit = fitting.of_file(path, &tables);
        let done = fit.and_then(|fit| Done::with(&fit, stem, common));
        done.map_err(|error| (path.display().to_string(), error))
    };
    let curves = measured.data.par_iter().zip(&stems);
    let fits: Vec<Result<Done, (String, String)>> = curves.map(one).inspect(|_| progress.inc(1)).collect();
    progress.finish_and_clear();
    told(&fits, common, console)
}

/// What is kept of a curve that has been fitted and whose files are written.
struct Done {
    text: String,
    json: String,
    warnings: Vec<String>,
    row: FitsRow,
    written: Written,
}

impl Done {
    fn with(fitted: &Fitted, stem: &str, common: &Common) -> Result<Self, String> {
        let told = |error: Failure| error.to_string();
        let json = if common.json { export::fit_member(fitted) } else { Ok(String::new()) };
        let warnings = fitted.data_notes.iter().chain(&fitted.fit.notes);
        Ok(Self {
            text: export::fit_text(fitted),
            json: json.map_err(|error| error.to_string())?,
            warnings: warnings.map(|note| format!("{}: {note}", fitted.file)).collect(),
            row: FitsRow::of(fitted),
            written: files(fitted, stem).map_err(told)?.write(common).map_err(told)?,
        })
    }
}

/// Says what came out, in the order of the data, and writes the table of several.
fn told(fits: &[Result<Done, (String, String)>], common: &Common, console: &Console) -> Result<(), Failure> {
    let good: Vec<&Done> = fits.iter().flatten().collect();
    for warning in good.iter().flat_map(|done| &done.warnings) {
        console.warning(warning);
    }
    let joined = |of: fn(&Done) -> &String| good.iter().map(|done| of(done).clone()).collect::<Vec<_>>();
    let row = |fit: &Result<Done, (String, String)>| match fit {
        Ok(done) => done.row.clone(),
        Err((file, error)) => FitsRow::without_fit(file.clone(), error),
    };
    let rows: Vec<FitsRow> = fits.iter().map(row).collect();
    let table = if rows.len() > 1 { Some(export::fits_table(&rows).map_err(Failure::failed)?) } else { None };
    let all = Findings {
        table: joined(|done| &done.text).join("\n"),
        json: export::fits_json(&joined(|done| &done.json)),
        files: Files {
            texts: table.map(|table| (ALL.to_owned(), table)).into_iter().collect(),
            #[cfg(feature = "plot")]
            figures: Vec::new(),
        },
    };
    for done in good {
        done.written.tell(console);
    }
    all.deliver(common, console)?;
    let bad = fits.iter().filter_map(|fit| fit.as_ref().err());
    let bad: Vec<String> = bad.map(|(file, error)| with_its_file(file, error)).collect();
    if bad.is_empty() { Ok(()) } else { Err(Failure::Failed(bad.join("\n"))) }
}

/// An error with its file, unless it begins with it.
fn with_its_file(name: &str, error: &str) -> String {
    if error.starts_with(name) { error.to_owned() } else { format!("{name}: {error}") }
}

/// Stems of the data files, by which the outputs are called.
fn stems(data: &[PathBuf]) -> Result<Vec<String>, Failure> {
    let stem =
        |path: &PathBuf| path.file_stem().map_or_else(|| "data".to_owned(), |stem| stem.to_string_lossy().into());
    let stems: Vec<String> = data.iter().map(stem).collect();
    let mut seen = BTreeSet::new();
    match stems.iter().find(|stem| !seen.insert(stem.as_str())) {
        None => Ok(stems),
        Some(twice) => Err(Failure::Usage(format!(
            "two data files are called {twice}: expected different names, for {twice}.fit.json"
        ))),
    }
}

/// No file written may be one that is read.
fn not_over_inputs(data: &[PathBuf], scene: &SceneFile, stems: &[String], common: &Common) -> Result<(), Failure> {
    let real = |path: &Path| path.canonicalize().ok();
    let read: BTreeSet<PathBuf> =
        data.iter().chain([&scene.path]).chain(&scene.tables).filter_map(|path| real(path)).collect();
    let of = |stem: &String| NAMES.map(|name| FORMATS.map(|format| format!("{stem}{name}{format}"))).concat();
    let names = stems.iter().flat_map(of);
    let over = names
        .chain([ALL.to_owned()])
        .find(|name| real(&common.out.join(name)).is_some_and(|path| read.contains(&path)));
    match over {
        None => Ok(()),
        Some(name) => {
            let path = common.out.join(name);
            Err(Failure::Usage(format!(
                "{} would be written over, and it is read: expected another folder in --out",
                path.display()
            )))
        }
    }
}

/// What follows the stem of a data file, but for the formats of figures.
const NAMES: [&str; 3] = [".fit", ".models", ".chi2"];
/// Formats of files.
const FORMATS: [&str; 5] = [".csv", ".json", ".svg", ".png", ".pdf"];
/// The table of several fits.
const ALL: &str = "fits.csv";

/// The files of one curve.
fn files(fit: &Fitted, stem: &str) -> Result<Files, Failure> {
    let mut texts = vec![
        (format!("{stem}.fit.csv"), export::fit_points(fit).map_err(Failure::failed)?),
        (format!("{stem}.fit.json"), export::fit_json(fit).map_err(Failure::failed)?),
    ];
    #[cfg(feature = "plot")]
    let mut figures = vec![(format!("{stem}.fit"), export::fit_figure(fit))];
    if let Some(map) = &fit.fit.map {
        texts.push((format!("{stem}.chi2.csv"), export::map_table(map).map_err(Failure::failed)?));
        #[cfg(feature = "plot")]
        figures.push((format!("{stem}.chi2"), export::map_figure(fit, map)));
    }
    if !fit.models.is_empty() {
        texts.push((format!("{stem}.models.csv"), export::models_table(fit).map_err(Failure::failed)?));
        #[cfg(feature = "plot")]
        figures.push((format!("{stem}.models"), export::models_figure(fit)));
    }
    Ok(Files {
        texts,
        #[cfg(feature = "plot")]
        figures,
    })
}

/// A spectrum from moduli over frequency, at one temperature or at several.
fn moduli(path: &Path, arguments: &Arguments, common: &Common, console: &Console) -> Result<(), Failure> {
    let wanted = Wanted::read(arguments.columns.as_deref().unwrap_or(""), None);
    let wanted = wanted.map_err(|what| Failure::Usage(format!("columns: {what}")))?;
    let faulty = |fault| Failure::Scene(vec![fault]);
    let data = Data::load(path, &wanted).map_err(faulty)?;
    for note in &data.notes {
        console.warning(&format!("{}: {note}", path.display()));
    }
    let stem = stems(&[path.to_owned()])?.concat();
    let file = path.display().to_string();
    let failed = |error: FitError| Failure::Failed(format!("{file}: {error}"));
    let reference = arguments.reference.map(Temperature::si);
    let sweeps = data.sweeps().map_err(faulty)?;
    let one_curve = |sweeps: Sweeps| Sweeps { entropic: arguments.vertical, ..sweeps }.master(reference);
    let master = sweeps.map(one_curve).transpose().map_err(failed)?;
    let moduli = match &master {
        Some(master) => master.reduced.clone(),
        None => data.moduli().map_err(faulty)?,
    };
    let spectrum = arguments.terms.map_or_else(|| moduli.spectrum(), |terms| moduli.spectrum_of(terms));
    let spectrum = spectrum.map_err(failed)?;
    let points = export::spectrum_points(&moduli, &spectrum).map_err(Failure::failed)?;
    let mut files = vec![(format!("{stem}.moduli.csv"), points)];
    if let Some(master) = &master {
        files.push((format!("{stem}.shifts.csv"), export::shifts_table(master).map_err(Failure::failed)?));
    }
    let json = export::spectrum_json(&file, &spectrum, master.as_ref()).map_err(Failure::failed)?;
    let name = format!("{stem}.moduli");
    let findings = Findings {
        table: export::spectrum_text(&file, &spectrum, master.as_ref()),
        json,
        files: Files {
            texts: files,
            #[cfg(feature = "plot")]
            figures: vec![(name.clone(), export::spectrum_figure(&moduli, &spectrum, master.as_ref()))],
        },
    };
    findings.named(&name).deliver(common, console)
}
