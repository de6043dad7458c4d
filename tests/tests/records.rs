//! Records: fields, components and names say the same.

use vitrum_kernels::abi::record::{
    carried, carried_clear, carried_straight, film, irradiance, light, mirror, node, path, probe, projected, ray,
    received, trace, view,
};
use vitrum_kernels::kernel::{ALL, Access};

/// Component numbers as components.
fn numbers<const SIZE: usize>() -> [f32; SIZE] {
    std::array::from_fn(|component| component as f32)
}

#[test]
fn records_are_stored_as_they_are_loaded() {
    macro_rules! hold {
        ($($module:ident::$record:ident),* $(,)?) => {
            $(assert_eq!($module::$record::load(&numbers()).store(), numbers::<{ $module::SIZE }>(), stringify!($module));)*
        };
    }
    hold!(
        carried::Carried,
        carried_clear::CarriedClear,
        carried_straight::CarriedStraight,
        film::Pixel,
        irradiance::Irradiance,
        light::Light,
        mirror::Mirror,
        node::Node,
        path::Path,
        probe::Results,
        projected::Projected,
        ray::Ray,
        received::Received,
        trace::Trace,
        view::MeshPixel,
    );
}

#[test]
fn components_have_the_names_of_their_fields() {
    let ray = ray::Ray::load(&numbers());
    let component = |name: &str| ray::NAMES.iter().position(|other| *other == name).map(|at| at as f32);
    assert_eq!(component("position.z"), Some(ray.position.z));
    assert_eq!(component("transmittance.green"), Some(ray.transmittance.y));
    assert_eq!(component("sampled"), Some(ray.sampled));
    assert_eq!(ray::NAMES[ray::COLOR], "color.red");
}

#[test]
fn every_record_of_a_kernel_has_a_name_for_each_component() {
    for kernel in ALL {
        let declaration = &kernel.declaration;
        let adds = declaration.bindings.iter().any(|binding| binding.access == Access::Add);
        let expected = if adds { 0 } else { declaration.components };
        assert_eq!(declaration.names.len(), expected, "{}", declaration.name);
        let mut names = declaration.names.to_vec();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), expected, "{}: two components have the same name", declaration.name);
    }
}
