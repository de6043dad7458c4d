//! T1: the records that each kernel writes, at stops within a frame.
//!
//! Both backends run the same pass list, and stop after chosen passes: the first and the last of each kernel, and those a
//! quarter, half and three quarters in between. There the records that the last pass wrote are compared. Where a bound does not
//! hold, the passes since the stop before are run once more, one by one, so that the first row that differs names the kernel that
//! is wrong, not one that read what it wrote.

use std::collections::BTreeMap;
use std::sync::Arc;

use vitrum::Assets;
use vitrum::backend::{Backend, ReadBack as _};
use vitrum::method::sweep::Sweep;
use vitrum::method::{self, Cache, ChosenRays, Job, PreparedFrame, RefinedPixels, Tools};
use vitrum_io::{Mesh, Picture, Volume, Voxels};
use vitrum_kernels::abi::record::{inscattered, landed};
use vitrum_kernels::field::sums::to_number;
use vitrum_kernels::glam::{DQuat, DVec3, EulerRot};
use vitrum_kernels::kernel::{Access, kernels};
use vitrum_kernels::sweep::place::word;

use crate::Failure;
use crate::bounds;
use crate::case::Case;
use crate::raster::Raster;
use crate::refraction;
use crate::run::{About, Run};

/// Light that a wavefront carries.
const FORWARD: &str = "sweep.light=forward";
/// A point beside and before a built-in volume.
const POINT: &str = "light.0={kind='point',position=[1.5,2.5,1.5],intensity=12}";
/// A spot whose cone ends on the volume.
const SPOT: &str = "light.0={kind='spot',position=[1.5,2.5,1.5],direction=[-1.5,-2.5,-1.5],cone_angle=9,intensity=12}";
/// A part of a volume.
const CROP: &str = "crop={min=[0.1,0.05,0.2],max=[0.7,0.9,0.85]}";
/// A clear surface before an opaque one, in `phantom`.
const ISOSURFACES: &str = "isosurface=[{value=35,opacity=0.3,color='red'},{value=130}]";
/// Opaque bodies within a built-in volume, partly outside of it.
const BODIES: &str = "mesh=[{builtin='torus',scale=0.5,position=[0.2,0.3,0.1]}]";
/// The material of clear bodies.
const CLEAR: &str = "material=[{}]";
/// Light on texels, which cases have that do not name a carrier.
const TEXELS: &str = "sweep.light=texels";

/// Small cases that together run every kernel in every mode.
///
/// # Errors
/// None that built-in scenes cause.
pub fn cases(edge: u32, resolution: u32) -> Result<Vec<Case>, Failure> {
    let case = |label: &str, scene: &str, settings: &[&str]| {
        let case = Case::builtin(scene, edge, Some(resolution), &[&[TEXELS][..], settings].concat())?;
        Ok::<_, Failure>(Case { name: label.to_owned(), ..case })
    };
    let euler = ["sweep.integrator=euler", "sweep.intensity=paper", "camera.projection=orthographic"];
    let mut cases = Vec::from([
        case("ball", "ball", &[])?,
        case("ball chain", "ball", &["sweep.gradient=chain"])?,
        case("ball euler", "ball", &euler)?,
        case("glass hard", "glass", &["light.0.angular_radius=0"])?,
        case("glass/straight", "glass/straight", &["light.0.angular_radius=1"])?,
        case("glass/straight hard", "glass/straight", &["light.0.angular_radius=0"])?,
        case("head", "head", &[])?,
        case("head all", "head", &["sweep.empty_space_skipping=false"])?,
        case("head u8", "head", &[])?.in_bytes()?,
        case("head u8 without light", "head", &[])?.in_bytes()?.without_light(),
        case("luneburg without light", "luneburg", &["light.0.angular_radius=0", "sweep.gradient=chain"])?
            .without_light(),
        case("phantom unshaded", "phantom", &["light.0.shadows=false", "sweep.refraction=false"])?,
        case("phantom flat", "phantom", &["light.0.shadows=false", "sweep.refraction=false", "shading.diffuse=light"])?,
        case("phantom by gradient", "phantom", &[FORWARD, "sweep.refraction=false", "shading.diffuse=gradient"])?,
        case("phantom", "phantom", &[])?,
        case("phantom straight hard", "phantom", &["sweep.refraction=false", "light.0.angular_radius=0"])?,
        case("phantom forward", "phantom", &[FORWARD])?,
        case("phantom streamed", "phantom", &[])?.streamed(),
        case("phantom streamed straight", "phantom", &["sweep.refraction=false"])?.streamed(),
        case("ball without shadows", "ball", &["light.0.shadows=false"])?,
        case("luneburg chain hard", "luneburg", &["light.0.angular_radius=0", "sweep.gradient=chain"])?,
        case("combustion/mixture", "combustion/mixture", &[])?,
        case("phantom chain forward", "phantom", &[FORWARD, "sweep.gradient=chain"])?,
        case("phantom straight forward", "phantom", &[FORWARD, "sweep.refraction=false"])?,
        case("phantom soft forward", "phantom", &[FORWARD, "light.0.angular_radius=20"])?,
        case("phantom point forward", "phantom", &[FORWARD, POINT])?,
        case("glass spot forward", "glass", &[FORWARD, SPOT])?,
        case("ball forward", "ball", &[FORWARD])?,
        case("ball refined", "ball", &[FORWARD, "film.refinement=3", "environment.kind=checkerboard"])?,
        case("glass forward", "glass", &[FORWARD])?,
        case("glass/straight forward", "glass/straight", &[FORWARD])?,
        case("head u8 forward", "head", &[FORWARD])?.in_bytes()?,
        case("luneburg chain forward", "luneburg", &[FORWARD, "sweep.gradient=chain"])?,
        case("ball streamed", "ball", &[])?.streamed(),
        case("ball streamed chain", "ball", &["sweep.gradient=chain"])?.streamed(),
        case("ball streamed straight", "ball", &["sweep.refraction=false"])?.streamed(),
        case("ball streamed forward", "ball", &[FORWARD])?.streamed(),
        case("ball streamed unshaded", "ball", &["light.0.shadows=false", "sweep.refraction=false"])?.streamed(),
        case("head u8 streamed", "head", &[])?.in_bytes()?.streamed(),
        case("head u8 streamed forward", "head", &[FORWARD])?.in_bytes()?.streamed(),
        case("luneburg streamed", "luneburg", &["sweep.gradient=chain"])?.streamed(),
        case("luneburg streamed forward", "luneburg", &[FORWARD])?.streamed(),
        case("combustion/mixture streamed", "combustion/mixture", &[])?.streamed(),
        case("combustion/mixture streamed forward", "combustion/mixture", &[FORWARD])?.streamed(),
        case("combustion/mixture forward", "combustion/mixture", &[FORWARD])?,
        case("phantom isosurfaces", "phantom", &[ISOSURFACES])?,
        case(
            "phantom isosurfaces forward",
            "phantom",
            &[FORWARD, ISOSURFACES, "ground={}", "shading.diffuse=gradient"],
        )?,
        case("phantom isosurfaces straight forward", "phantom", &[FORWARD, ISOSURFACES, "sweep.refraction=false"])?,
        case("ball colours", "ball", &[])?.in_colors()?,
        case("luneburg colours forward", "luneburg", &[FORWARD])?.in_colors()?,
        case("phantom colours isosurfaces forward", "phantom", &[FORWARD, ISOSURFACES])?.in_colors()?,
        case("phantom bodies", "phantom", &[BODIES])?,
        case("phantom bodies forward", "phantom", &[FORWARD, BODIES, "ground={}"])?,
        case("phantom bodies straight forward", "phantom", &[FORWARD, BODIES, "sweep.refraction=false"])?,
        case("head bodies unshaded", "head", &["light.0.shadows=false", BODIES])?,
        case("phantom clear bodies forward", "phantom", &[FORWARD, BODIES, CLEAR, "transfer.ior=[]"])?,
        case("phantom cropped", "phantom", &[CROP])?,
        case("glass cropped forward", "glass", &[FORWARD, CROP])?,
    ]);
    cases.extend(projections(case)?);
    cases.extend(meshes(edge, resolution)?);
    // A method without a case of its own shows a built-in volume or mesh.
    for method in method::ALL {
        let name = method.name();
        if cases.iter().all(|case| case.scene.method != name) {
            let scene = if name.capabilities().volumes { "ball" } else { "vase" };
            cases.push(case(name.as_str(), scene, &[&format!("method={}", name.as_str())])?);
        }
    }
    Ok(cases)
}

/// Small projections that together run their kernels in every mode.
fn projections(case: impl Fn(&str, &str, &[&str]) -> Result<Case, Failure>) -> Result<Vec<Case>, Failure> {
    let [maximum, minimum, mean] =
        ["maximum", "minimum", "mean"].map(|blend_mode| format!("shading.blend_mode={blend_mode}"));
    Ok(vec![
        case("ball maximum", "ball", &[&maximum, "film.refinement=3", CROP])?,
        case("head u8 minimum", "head", &[&minimum])?.in_bytes()?,
        case("head all maximum", "head", &[&maximum, "sweep.empty_space_skipping=false"])?,
        case("phantom mean", "phantom", &[&mean, "camera.projection=orthographic"])?,
        case("luneburg minimum", "luneburg", &[&minimum])?,
        case("combustion/mixture maximum", "combustion/mixture", &[&maximum])?,
        case("ball streamed mean", "ball", &[&mean])?.streamed(),
        case("phantom streamed maximum", "phantom", &[&maximum, CROP])?.streamed(),
        case("head u8 streamed maximum", "head", &[&maximum])?.in_bytes()?.streamed(),
        case("luneburg streamed minimum", "luneburg", &[&minimum])?.streamed(),
        case("combustion/mixture streamed mean", "combustion/mixture", &[&mean])?.streamed(),
        case("ball colours mean", "ball", &[&mean])?.in_colors()?,
    ])
}

/// Small meshes that together run every kernel of rays through them in every mode.
///
/// # Errors
/// None that these meshes cause.
pub fn meshes(edge: u32, resolution: u32) -> Result<Vec<Case>, Failure> {
    let voxels = format!("voxelization.resolution={resolution}");
    let case = |label: &str, mesh: &Mesh, settings: &[&str]| {
        let case = refraction::case(label, mesh.clone(), edge, &[settings, &[&voxels]].concat())?;
        Ok::<_, Failure>(Case { name: label.to_owned(), ..case })
    };
    let ball = refraction::ball(24);
    let turned = DQuat::from_euler(EulerRot::XYZ, 0.4, 0.5, 0.6);
    let around = refraction::cuboid(DVec3::new(1.2, 1.3, 1.1), turned);
    let nested = refraction::together(&[around, Mesh { normals: None, ..ball.clone() }]);
    let mut colored = nested.clone();
    colored.colors = Some(nested.positions.iter().map(|at| [at[0].abs(), 0.5, at[2].abs(), 1.0]).collect());
    let checkerboard = "environment.kind=checkerboard";
    // The ball in the box is opaque, the box coloured glass.
    const OPAQUE: &str = "material=[{name=\"m1\",opaque=true,density=0.7},{ior=1.4,attenuation_color=[0.5,0.7,0.9]}]";
    Ok(vec![
        case("mesh ball", &ball, &[checkerboard])?,
        case("mesh ball two", &ball, &["voxels.surfaces=two", "camera.projection=orthographic"])?,
        case("mesh ball paper", &ball, &["voxels.normals=paper", "environment.visible=false"])?,
        case("mesh ball paper two", &ball, &["voxels.normals=paper", "voxels.surfaces=two"])?,
        case("mesh ball exact", &ball, &["voxels.surfaces=exact", checkerboard])?,
        case("mesh nested", &nested, &["material=[{name=\"m1\",ior=1.2},{ior=1.7,attenuation_color=[0.5,0.7,0.9]}]"])?,
        case("mesh opaque", &nested, &[OPAQUE, "light.0.attachment=world", "light.0.elevation=60", "ground={}"])?,
        case(
            "mesh opaque two",
            &nested,
            &[&OPAQUE.replace("m1", "m0"), "voxels.surfaces=two", "wall={}", "shadow.filter_radius=0.1"],
        )?,
        case(
            "mesh opaque paper",
            &nested,
            &[OPAQUE, "voxels.normals=paper", "ground={}", "wall={}", "shadow.coefficient=uniform"],
        )?,
        case("mesh opaque exact", &colored, &[OPAQUE, "voxels.surfaces=exact", "ground={height=-1.5}"])?,
        case(
            "mesh all opaque",
            &nested,
            &["material=[{opaque=true,density=0.5}]", "voxels.surfaces=two", "light.0.shadows=false"],
        )?,
        case(
            "mesh opaque point",
            &nested,
            &[OPAQUE, "light.0={kind='point',position=[2,-1,3],intensity=20}", "ground={}", "wall={}"],
        )?,
        Case {
            assets: slide(&nested),
            ..case(
                "mesh opaque spot",
                &nested,
                &[
                    OPAQUE,
                    "light.0={kind='spot',position=[2,2,3],intensity=20,cone_angle=25,texture='slide.png'}",
                    "ground={height=-1.6}",
                    checkerboard,
                ],
            )?
        },
        // A clear box around a mirror, above the ground.
        case(
            "mesh beams",
            &nested,
            &[
                "method=beams",
                "material=[{name=\"m1\",mirror=true,color=[0.9,0.8,0.7]},{ior=1.4,attenuation_color=[0.5,0.7,0.9]}]",
                "light.0={kind='point',position=[2,-1,3],intensity=20}",
                "medium={scattering=[0.1,0.2,0.3],absorption=[0.03,0.02,0.01],anisotropy=0.6}",
                "ground={}",
                "beams.rays=12",
                "beams.segments=4",
            ],
        )?,
        // The same by maps: the light that the box's front reflects is a piece of its own.
        case(
            "mesh beams maps",
            &nested,
            &[
                "method=beams",
                "material=[{name=\"m1\",mirror=true,color=[0.9,0.8,0.7]},{ior=1.4,attenuation_color=[0.5,0.7,0.9]}]",
                "light.0={kind='point',position=[2,-1,3],intensity=20}",
                "medium={scattering=[0.1,0.2,0.3],absorption=[0.03,0.02,0.01],anisotropy=0.6}",
                "ground={}",
                "beams.rays=12",
                "beams.tracer='depth-map'",
            ],
        )?,
        // A mirror by maps, in parallel light.
        case(
            "mesh beams maps distant",
            &ball,
            &[
                "method=beams",
                "material=[{mirror=true,color=[0.9,0.8,0.7]}]",
                "light.0={attachment='world',elevation=50,azimuth=20}",
                "medium={scattering=[0.2,0.2,0.2],extent=2}",
                "beams.rays=17",
                "beams.segments=1",
                "beams.tracer='depth-map'",
            ],
        )?,
        // An opaque ball in a clear box, in a medium that ends within the picture.
        case(
            "mesh beams distant",
            &colored,
            &[
                "method=beams",
                OPAQUE,
                "camera.projection=orthographic",
                "light.0={attachment='world',elevation=50,azimuth=20}",
                "medium={scattering=[0.2,0.2,0.2],phase='rayleigh',extent=2}",
                "wall={}",
                "beams.rays=9",
                "beams.segments=3",
                "beams.threshold=0.01",
            ],
        )?,
        Case {
            assets: slide(&ball),
            ..case(
                "mesh beams spot",
                &ball,
                &[
                    "method=beams",
                    "light.0={kind='spot',position=[2,2,3],intensity=20,cone_angle=25,texture='slide.png'}",
                    "medium={scattering=[0.1,0.1,0.1]}",
                    "beams.rays=16",
                    "beams.pyramid=false",
                    checkerboard,
                ],
            )?
        },
        // The same by the estimator for comparison.
        case(
            "mesh beams march",
            &ball,
            &[
                "method=beams",
                "light.0={kind='point',position=[2,-1,3],intensity=20}",
                "medium={scattering=[0.1,0.2,0.3],absorption=[0.03,0.02,0.01]}",
                "beams.rays=12",
                "beams.segments=2",
                "beams.estimator=hu2010",
                "beams.filter_radius=1.5",
            ],
        )?,
        // Light that is scattered up to three times.
        case(
            "mesh beams multiple",
            &nested,
            &[
                "method=beams",
                "material=[{name=\"m1\",mirror=true,color=[0.9,0.8,0.7]},{ior=1.4,attenuation_color=[0.5,0.7,0.9]}]",
                "light.0={kind='point',position=[2,-1,3],intensity=20}",
                "medium={scattering=[0.4,0.5,0.6],absorption=[0.03,0.02,0.01],anisotropy=0.5,extent=4}",
                "ground={}",
                "beams.rays=12",
                "beams.segments=3",
                "beams.orders=3",
            ],
        )?,
        // A clear ball in a medium whose density is a volume.
        Case {
            assets: Assets { density: Some(Arc::new(cloud()?)), ..Assets::from(ball.clone()) },
            ..case(
                "mesh beams density",
                &ball,
                &[
                    "method=beams",
                    "light.0={kind='point',position=[2,-1,3],intensity=20}",
                    "medium={scattering=[0.3,0.4,0.5],absorption=[0.1,0.05,0.02],phase='tabulated',phase_values=[4,2,1,1.5]}",
                    "medium.density.builtin='smoke'",
                    "beams.rays=12",
                    "beams.segments=4",
                    "beams.nodes=5",
                    "beams.orders=2",
                    "beams.adaptive=true",
                ],
            )?
        },
        case("mesh nested exact", &nested, &["voxels.surfaces=exact", "voxels.reflection=false"])?,
    ])
}

/// A density of another number of voxels along each axis, around the origin.
fn cloud() -> Result<Volume, Failure> {
    let density = |[x, y, z]: [u8; 3]| f32::from((x * 7 + y * 5 + z * 3) % 11) / 10.0;
    let values =
        (0..9u8).flat_map(|z| (0..8).flat_map(move |y| (0..7).map(move |x| density([x, y, z])))).collect::<Vec<_>>();
    Ok(Volume::new("cloud", [7, 8, 9], [0.5, 0.45, 0.4], Voxels::F32(values.into()))?)
}

/// A mesh, and the picture `slide.png` for a spot to project.
fn slide(mesh: &Mesh) -> Assets {
    let texels =
        (0..12u8).map(|texel| [f32::from(texel) / 11.0, f32::from(texel % 4) / 3.0, f32::from(texel / 4) / 2.0]);
    let mut assets = Assets::from(mesh.clone());
    assets.textures.insert("slide.png".into(), Arc::new(Picture::rgb(4, 3, texels.collect())));
    assets
}

/// Compares what kernels wrote, the CPU's first.
///
/// # Errors
/// If a backend fails, or evidence cannot be written.
pub fn compare(case: &Case, cpu: &mut dyn Backend, other: &mut dyn Backend, run: &mut Run) -> Result<(), Failure> {
    run.method(case.scene.method);
    let bound = bounds::of_backend(other, false);
    let holds = |stop: &Stopped| {
        let compared = stop.expected.compare(&stop.found);
        compared
            .map(|found| bound.check(&found).passed())
            .map_err(|error| Failure::Compare { what: stop.item(), error })
    };
    let mut stopped = stop_after(case, cpu, other, stops)?;
    let mut breach = None;
    for (index, stop) in stopped.iter().enumerate() {
        if !holds(stop)? {
            breach = Some(index);
            break;
        }
    }
    if let Some(breach) = breach {
        let after = breach.checked_sub(1).map(|before| stopped[before].at.pass);
        let until = stopped[breach].at.pass;
        let between = |frame: &dyn PreparedFrame| {
            let between = after.map_or(0, |pass| pass + 1)..until;
            between.map(|pass| Stop::new(pass, frame)).collect()
        };
        for stop in stop_after(case, cpu, other, between)? {
            if !holds(&stop)? {
                stopped.insert(breach, stop);
                break;
            }
        }
    }
    for stop in &stopped {
        let item = stop.item();
        let about = About { tier: "T1", scene: &case.name, item: &item, components: stop.at.components };
        run.hold(about, bound, &stop.expected, &stop.found)?;
    }
    Ok(())
}

/// The records of both backends after a pass.
struct Stopped {
    at: Stop,
    expected: Raster,
    found: Raster,
}

impl Stopped {
    fn item(&self) -> String {
        match self.at.plane {
            Some(plane) => format!("{} at plane {plane}", self.at.kernel),
            None => format!("{} as pass {}", self.at.kernel, self.at.pass),
        }
    }
}

/// Runs a frame on both backends, in parts that end where `stops` says.
fn stop_after(
    case: &Case,
    cpu: &mut dyn Backend,
    other: &mut dyn Backend,
    stops: impl FnOnce(&dyn PreparedFrame) -> Vec<Stop>,
) -> Result<Vec<Stopped>, Failure> {
    let exact = bounds::is_exact(other);
    let mut reference = Stepper::new(case, exact, cpu)?;
    let mut other = Stepper::new(case, exact, other)?;
    let mut stopped = Vec::new();
    for at in stops(reference.frame.as_ref()) {
        stopped.push(Stopped { at, expected: reference.advance(at.pass)?, found: other.advance(at.pass)? });
    }
    Ok(stopped)
}

/// A pass after which both backends stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Stop {
    pass: usize,
    /// The plane that it leads to, in a sweep.
    plane: Option<u32>,
    kernel: &'static str,
    /// The names of the components of its record.
    components: &'static [&'static str],
}

impl Stop {
    fn new(pass: usize, frame: &dyn PreparedFrame) -> Self {
        let chosen = &frame.passes().passes[pass];
        let declaration = &chosen.kernel.declaration;
        Self { pass, plane: frame.plane(chosen), kernel: declaration.name, components: declaration.names }
    }
}

/// The first, quarter, middle, three-quarter and last pass of each kernel, in order.
fn stops(frame: &dyn PreparedFrame) -> Vec<Stop> {
    let mut by_kernel: BTreeMap<&str, Vec<Stop>> = BTreeMap::new();
    for index in 0..frame.passes().passes.len() {
        let stop = Stop::new(index, frame);
        by_kernel.entry(stop.kernel).or_default().push(stop);
    }
    let chosen = |stops: &Vec<Stop>| {
        let last = stops.len() - 1;
        [0, last / 4, last / 2, 3 * last / 4, last].map(|index| stops[index])
    };
    let mut stops: Vec<Stop> = by_kernel.values().flat_map(chosen).collect();
    stops.sort_unstable();
    stops.dedup();
    stops
}

/// The prepared first exposure of a case.
///
/// # Errors
/// If the backend fails.
pub fn prepare(case: &Case, backend: &mut dyn Backend) -> Result<Box<dyn PreparedFrame>, Failure> {
    let Case { scene, assets, request, .. } = case;
    if case.streamed {
        return Ok(Box::new(Sweep::prepare_streamed(scene, assets, *request, backend)?));
    }
    let method = method::of(scene.method);
    let exposures = method.exposures(scene, assets);
    // Pixels here and there.
    let pixels: Vec<u32> =
        (0..RefinedPixels::COLUMNS).map(|i| word(7 * i % scene.film.width, 3 * i % scene.film.height)).collect();
    let edge = scene.film.refinement;
    let refined = ChosenRays::Refined(RefinedPixels { pixels: &pixels, edge });
    let chosen = (edge > scene.film.supersampling).then_some(refined);
    let job = Job { scene: &exposures[0].scene, assets, request: *request, chosen };
    let mut tools = Tools { backend, progress: &mut |_| true };
    Ok(method.prepare(&job, &mut Cache::default(), &mut tools)?)
}

/// A frame that runs in parts.
struct Stepper<'a> {
    backend: &'a mut dyn Backend,
    frame: Box<dyn PreparedFrame>,
    done: usize,
    /// Whether the last bit counts.
    exact: bool,
}

impl<'a> Stepper<'a> {
    fn new(case: &Case, exact: bool, backend: &'a mut dyn Backend) -> Result<Self, Failure> {
        let frame = prepare(case, backend)?;
        Ok(Self { backend, frame, done: 0, exact })
    }

    /// Runs on until pass `last` is done. The result has the records that this pass wrote, each component's plane below the one before.
    fn advance(&mut self, last: usize) -> Result<Raster, Failure> {
        // Every pass counts here, also one that no pixel needs: nothing is left out.
        let list = self.frame.passes().part(self.done, last + 1);
        self.done = last + 1;
        self.backend.run(&list, &mut |_| true)?;
        let pass = list.passes.last().expect("stops are in ascending order, and different");
        let output = pass.output().expect("every kernel writes");
        let declaration = &pass.kernel.declaration;
        if declaration.bindings.iter().any(|binding| binding.access == Access::Add) {
            let bytes: Vec<u8> = self.backend.read_all(output)?;
            // A tolerance is for numbers: where one is a unit more, its lower half may be 65535 less.
            let words: Vec<u32> = bytemuck::pod_collect_to_vec(&bytes);
            if !self.exact && declaration.family == kernels::sweep_scatter_cells.declaration.family {
                let numbers: Vec<f32> = words.iter().map(|&word| word.cast_signed() as f32).collect();
                return Ok(Raster::stacked(pass.width, [numbers.as_slice()]));
            }
            if !self.exact && [inscattered::SIZE, landed::SIZE].contains(&declaration.components) {
                let numbers: Vec<f32> = words.chunks_exact(2).map(|pair| to_number(pair[0], pair[1])).collect();
                return Ok(Raster::stacked(pass.width, [numbers.as_slice()]));
            }
            // Sums are integers, of which some bit patterns are no numbers as floats: their halves are.
            let halves: Vec<f32> =
                bytes.chunks_exact(2).map(|half| f32::from(u16::from_le_bytes([half[0], half[1]]))).collect();
            return Ok(Raster::stacked(pass.width, [halves.as_slice()]));
        }
        // Records of one plane or map of several, or of several pictures in a row.
        let count = u64::from(pass.width) * u64::from(pass.height) * declaration.components as u64;
        let records: Vec<f32> = self.backend.read_part(output, pass.start * 4..(pass.start + count) * 4)?;
        Ok(Raster::stacked(pass.width, [records.as_slice()]))
    }
}
