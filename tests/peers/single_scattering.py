"""Light that a homogeneous medium scatters once, by sampling, with Mitsuba's own geometry, surfaces and random numbers.

Mitsuba's `volpath` finds no light of a point through glass: no path from the eye ends in a point. So two estimators are written here with
`Scene.ray_intersect` and `BSDF.sample`, and nothing of Vitrum's. `traced_light` follows light from the lamp through glass and by mirrors, takes
a place on each piece of its way in the medium and connects it to the pinhole. `traced_views` follows viewing rays, takes a place on each
piece, and connects it to the lamp; to a lamp of finite size through glass as well. Both are unbiased, whatever the caustic.
"""

from dataclasses import dataclass

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")

# Surfaces that a ray meets at most, and places on each piece of a ray of light.
BOUNCES, PLACES = 12, 4


@dataclass
class Medium:
    """A cube of a homogeneous medium: coefficients by world unit and colour, Henyey and Greenstein's g, its middle and half its edge."""

    absorption: tuple
    scattering: tuple
    g: float
    middle: tuple
    extent: float

    def piece(self, ray, end):
        """Where the medium begins and ends along a ray that ends at `end`."""
        low, high = (mi.Point3f(*(m + sign * self.extent for m in self.middle)) for sign in (-1, 1))
        inverse = dr.rcp(ray.d)
        a, b = (low - ray.o) * inverse, (high - ray.o) * inverse
        begin = dr.clip(dr.max(dr.minimum(a, b)), 0, 1e6)
        return begin, dr.maximum(begin, dr.minimum(end, dr.min(dr.maximum(a, b))))

    def transmittance(self, length):
        return dr.exp(-length * mi.Color3f(*(a + s for a, s in zip(self.absorption, self.scattering))))

    def scattered(self, cosine):
        """Scattering coefficient times phase function, by the cosine of the angle that light is turned by."""
        g = self.g
        return mi.Color3f(*self.scattering) * ((1 - g * g) / (4 * np.pi) / (1 + g * g - 2 * g * cosine) ** 1.5)


@dataclass
class Lamp:
    """A point or ball at `place` of a radiant intensity, or, without a place, distant light along `direction` of an irradiance."""

    strength: float
    place: tuple = None
    direction: tuple = None
    radius: float = 0.0

    def emit(self, target, reach, sampler):
        """Rays that cover the ball around `target`, and the flux for which each stands, all together."""
        if self.place is None:
            axis = mi.Frame3f(dr.normalize(mi.Vector3f(*self.direction)))
            disc = mi.warp.square_to_uniform_disk(sampler.next_2d()) * reach
            start = mi.Point3f(*target) + axis.to_world(mi.Vector3f(disc.x, disc.y, -20 * reach))
            return mi.Ray3f(start, axis.n), self.strength * np.pi * reach**2
        ray, solid = towards(mi.Point3f(*self.place), mi.Point3f(*target), reach, sampler)
        return ray, self.strength * solid

    def direct(self, scene, place, active, sampler):
        """Direction and distance of the lamp, and its irradiance across the light where nothing stands in the way."""
        if self.place is None:
            along, far, light = -dr.normalize(mi.Vector3f(*self.direction)), mi.Float(1e6), mi.Float(self.strength)
        elif self.radius:
            ray, solid = towards(place, mi.Point3f(*self.place), self.radius, sampler)
            along, far = ray.d, self.meets(ray)
            light = solid * self.strength / (np.pi * self.radius**2)
        else:
            way = mi.Point3f(*self.place) - place
            far = dr.norm(way)
            along, light = way / far, self.strength / dr.square(far)
        hidden = scene.ray_test(mi.Ray3f(place, along, far, 0.0, []), active)
        return along, far, dr.select(hidden | ~active, 0.0, light)

    def meets(self, ray):
        """Distance at which a ray comes past the middle of the ball, which the medium fills as well; infinite if it misses the ball."""
        way = mi.Point3f(*self.place) - ray.o
        along = dr.dot(way, ray.d)
        inside = self.radius**2 - dr.squared_norm(way - along * ray.d)
        return dr.select((inside > 0) & (along > 0), along, dr.inf)


@dataclass
class Pinhole:
    """The camera: an eye, a point in the middle of the picture, the vertical field of view in degrees; square pictures, z up."""

    eye: tuple
    target: tuple
    field: float
    size: int

    def __post_init__(self):
        forward = np.subtract(self.target, self.eye) / np.linalg.norm(np.subtract(self.target, self.eye))
        right = np.cross(forward, (0, 0, 1))
        right /= np.linalg.norm(right)
        self.axes = [axis.tolist() for axis in (right, np.cross(right, forward), forward)]
        self.tangent = float(np.tan(np.radians(self.field) / 2))

    def ray(self, at):
        """The viewing ray through a place of the picture in pixels, rows counted from the top."""
        x, y = (2 * at.x / self.size - 1) * self.tangent, (1 - 2 * at.y / self.size) * self.tangent
        right, up, forward = (mi.Vector3f(*axis) for axis in self.axes)
        return mi.Ray3f(mi.Point3f(*self.eye), dr.normalize(x * right + y * up + forward))

    def splat(self, film, scene, medium, ray, light, active):
        """Adds light of a radiant intensity that leaves the start of `ray`, a ray to the eye."""
        way = mi.Point3f(*self.eye) - ray.o
        far = dr.norm(way)
        x, y, z = (-dr.dot(way, mi.Vector3f(*axis)) for axis in self.axes)
        column = dr.floor((x / z / self.tangent + 1) * self.size / 2)
        row = dr.floor((1 - y / z / self.tangent) * self.size / 2)
        active &= (z > 0) & (column >= 0) & (column < self.size) & (row >= 0) & (row < self.size)
        active &= ~scene.ray_test(mi.Ray3f(ray.o, ray.d, far, 0.0, []), active)
        begin, end = medium.piece(ray, far)
        area = (2 * self.tangent / self.size) ** 2
        value = light * medium.transmittance(end - begin) / (dr.square(far) * (z / far) ** 3 * area)
        pixel = dr.select(active, mi.UInt32(row) * self.size + mi.UInt32(column), 0)
        for channel in range(3):
            dr.scatter_reduce(dr.ReduceOp.Add, film, value[channel], pixel * 3 + channel, active)


def towards(place, middle, radius, sampler):
    """Rays from a place, spread evenly over the cone around a ball, and the cone's solid angle."""
    way = middle - place
    gone = dr.squared_norm(way)
    lowest = dr.sqrt(dr.maximum(0, 1 - radius**2 / gone))
    local = mi.warp.square_to_uniform_cone(sampler.next_2d(), lowest)
    return mi.Ray3f(place, mi.Frame3f(way / dr.sqrt(gone)).to_world(local)), 2 * np.pi * (1 - lowest)


def diffuse(surface, active):
    return active & mi.has_flag(surface.bsdf().flags(), mi.BSDFFlags.Smooth)


def follow(mode, surface, active, sampler):
    """The ray after a clear surface or a mirror, its weight, and whether it runs outside of bodies, which are closed."""
    sample, weight = surface.bsdf().sample(mi.BSDFContext(mode), surface, sampler.next_1d(), sampler.next_2d(), active)
    return surface.spawn_ray(surface.to_world(sample.wo)), weight, sample.wo.z > 0


def traced_light(scene, medium, lamp, camera, target, reach, count, seed):
    """Volume caustics and caustics on diffuse surfaces by `count` rays of light at the ball around `target`."""
    sampler = mi.load_dict({"type": "independent"})
    sampler.seed(seed, count)
    films = [dr.zeros(mi.Float, 3 * camera.size**2) for _ in range(2)]
    ray, flux = lamp.emit(target, reach, sampler)
    light = mi.Color3f(flux / count)
    active, outside = mi.Bool(True), mi.Bool(True)
    for depth in range(BOUNCES + 1):
        surface = scene.ray_intersect(ray, active)
        begin, end = medium.piece(ray, dr.select(surface.is_valid(), surface.t, dr.inf))
        length = dr.select(outside, end - begin, 0)
        for place in range(PLACES if depth else 0):
            along = (place + sampler.next_1d()) / PLACES * length
            at = ray(begin + along)
            eye = dr.normalize(mi.Point3f(*camera.eye) - at)
            scattered = light * medium.transmittance(along) * medium.scattered(dr.dot(ray.d, eye)) * length / PLACES
            camera.splat(films[0], scene, medium, mi.Ray3f(at, eye), scattered, active & (length > 0))
        light *= medium.transmittance(length)
        active &= surface.is_valid()
        ends = diffuse(surface, active)
        if depth:
            eye = surface.spawn_ray_to(mi.Point3f(*camera.eye))
            eye.d = dr.normalize(eye.d)
            local = surface.to_local(eye.d)
            left = light * surface.bsdf().eval(mi.BSDFContext(mi.TransportMode.Importance), surface, local, ends)
            camera.splat(films[1], scene, medium, eye, left, mi.Bool(ends))
        active &= ~ends
        ray, weight, outside = follow(mi.TransportMode.Importance, surface, active, sampler)
        light *= weight
        active &= dr.max(weight) > 0
        dr.eval(ray, light, active, outside, *films)
        if not dr.any(active):
            break
    return [np.array(film).reshape(camera.size, camera.size, 3) for film in films]


def through_glass(scene, medium, lamp, place, back, target, reach, active, sampler):
    """Light that one place scatters along `back`, from a lamp of finite size through glass and by mirrors."""
    ray, solid = towards(place, mi.Point3f(*target), reach, sampler)
    light = medium.scattered(dr.dot(-ray.d, back)) * solid * lamp.strength / (np.pi * lamp.radius**2)
    found, active, outside = mi.Color3f(0), mi.Bool(active), mi.Bool(True)
    for depth in range(BOUNCES + 1):
        surface = scene.ray_intersect(ray, active)
        far = lamp.meets(ray)
        shines = active & outside & (far < dr.select(surface.is_valid(), surface.t, dr.inf))
        if depth:
            begin, end = medium.piece(ray, far)
            found += dr.select(shines, light * medium.transmittance(end - begin), 0)
        active &= surface.is_valid()
        active &= ~diffuse(surface, active)
        begin, end = medium.piece(ray, surface.t)
        light *= medium.transmittance(dr.select(outside, end - begin, 0))
        ray, weight, outside = follow(mi.TransportMode.Radiance, surface, active, sampler)
        light *= weight
        active &= dr.max(weight) > 0
    return found


def traced_views(scene, medium, lamp, camera, target, reach, samples, seed):
    """Airlight less the shadow, light of diffuse surfaces, volume caustics of a lamp of finite size, and the share of specular bodies."""
    sampler = mi.load_dict({"type": "independent"})
    sampler.seed(seed, samples * camera.size**2)
    pixel = dr.arange(mi.UInt32, samples * camera.size**2) // samples
    stratum = dr.arange(mi.UInt32, samples * camera.size**2) % samples
    at = mi.Point2f(mi.Float(pixel % camera.size), mi.Float(pixel // camera.size)) + sampler.next_2d()
    ray, seen = camera.ray(at), mi.Color3f(1)
    active, outside = mi.Bool(True), mi.Bool(True)
    parts = [dr.zeros(mi.Color3f, samples * camera.size**2) for _ in range(4)]
    for depth in range(BOUNCES + 1):
        surface = scene.ray_intersect(ray, active)
        begin, end = medium.piece(ray, dr.select(surface.is_valid(), surface.t, dr.inf))
        lit = active & outside & (end > begin)
        share = (mi.Float(stratum) + sampler.next_1d()) / samples
        if lamp.place is None:
            along, weight = dr.lerp(begin, end, share), end - begin
        else:
            # Places as the lamp sees them: evenly by its angle.
            way = mi.Point3f(*lamp.place) - ray.o
            foot = dr.dot(way, ray.d)
            high = dr.maximum(dr.norm(way - foot * ray.d), 1e-4)
            first, last = dr.atan((begin - foot) / high), dr.atan((end - foot) / high)
            side = high * dr.tan(dr.lerp(first, last, share))
            along, weight = foot + side, (last - first) * (dr.square(high) + dr.square(side)) / high
        weight *= seen * medium.transmittance(along - begin)
        place = ray(along)
        lamps, far, light = lamp.direct(scene, place, lit, sampler)
        start, stop = medium.piece(mi.Ray3f(place, lamps), far)
        light = light * medium.scattered(dr.dot(lamps, ray.d)) * medium.transmittance(stop - start)
        parts[0] += dr.select(lit, weight * light, 0)
        if lamp.radius:
            parts[2] += dr.select(lit, weight * through_glass(scene, medium, lamp, place, -ray.d, target, reach, lit, sampler), 0)
        seen *= medium.transmittance(dr.select(outside, end - begin, 0))
        active &= surface.is_valid()
        ends = diffuse(surface, active)
        point = surface.spawn_ray(surface.n).o
        lamps, far, light = lamp.direct(scene, point, ends, sampler)
        start, stop = medium.piece(mi.Ray3f(point, lamps), far)
        left = surface.bsdf().eval(mi.BSDFContext(), surface, surface.to_local(lamps), ends) * light
        parts[1] += dr.select(ends, seen * left * medium.transmittance(stop - start), 0)
        active &= ~ends
        if depth == 0:
            parts[3] = mi.Color3f(dr.select(active, 1.0, 0.0))
        ray, weight, outside = follow(mi.TransportMode.Radiance, surface, active, sampler)
        seen *= weight
        active &= dr.max(weight) > 0
        dr.eval(ray, seen, active, outside, *parts)
        if not dr.any(active):
            break
    return [average(part, samples, camera.size) for part in parts]


def average(part, samples, size):
    """The mean over the samples of each pixel."""
    return np.array(part).T.reshape(size, size, samples, 3).mean(axis=2, dtype=np.float64)
