//! Spherical triangles in `f64`, from what the map is to be: the moving vertex parts the
//! area, the direction parts the versine, each found by bisection.

type Vector = [f64; 3];

fn add(a: Vector, b: Vector, scale: f64) -> Vector {
    [
        a[0] + scale * b[0],
        a[1] + scale * b[1],
        a[2] + scale * b[2],
    ]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

/// The solid angle of the triangle seen from the origin (Van Oosterom and Strackee 1983).
#[must_use]
pub fn solid_angle(a: Vector, b: Vector, c: Vector) -> f64 {
    // The vertex at which the sides are formed is the nearest: they lose no digits of it.
    let length = |v: Vector| dot(v, v).sqrt();
    let (x, y, z) = (length(a), length(b), length(c));
    let [p, q, r] = if x <= y.min(z) {
        [a, b, c]
    } else if y <= z {
        [b, c, a]
    } else {
        [c, a, b]
    };
    let volume = dot(p, cross(add(q, p, -1.0), add(r, p, -1.0))).abs();
    let sum = x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y;
    2.0 * volume.atan2(sum)
}

/// The least t in [0, 1] at which an increasing function is at least `target`.
fn bisect(target: f64, function: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return high;
        }
        if function(middle) < target {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// The direction whose moving vertex on ac cuts the fraction u0 of the area off at ab, at
/// the fraction u1 of the versine from b to it.
#[must_use]
pub fn spherical_triangle(vertices: [Vector; 3], u: [u32; 2]) -> Vector {
    let [u0, u1] = u.map(|x| f64::from(x) / 4_294_967_296.0);
    let [a, b, c] = vertices.map(unit);
    let side = add(c, a, -1.0);
    let area = solid_angle(a, b, c) * u0;
    let t = bisect(area, |t| solid_angle(a, b, add(a, side, t)));
    let moving = unit(add(a, side, t));
    let way = add(moving, b, -1.0);
    let versine = |t: f64| {
        let step = add(unit(add(b, way, t)), b, -1.0);
        dot(step, step)
    };
    unit(add(b, way, bisect(u1 * dot(way, way), versine)))
}

/// The fractions, as numbers, that the map takes to a direction.
#[must_use]
pub fn spherical_triangle_invert(vertices: [Vector; 3], direction: Vector) -> [f64; 2] {
    let [a, b, c] = vertices.map(unit);
    let across = cross(b, add(direction, b, -1.0));
    // Where the plane of b and the direction meets the side.
    let (x, y) = (dot(across, a).abs(), dot(across, c).abs());
    let moving = unit(add(a, add(c, a, -1.0), x / (x + y)));
    let (way, step) = (add(moving, b, -1.0), add(direction, b, -1.0));
    let part = solid_angle(a, b, moving) / solid_angle(a, b, c);
    [part, dot(step, step) / dot(way, way)]
}

/// The solid angle of the rectangle with this corner and sides.
#[must_use]
pub fn rectangle_solid_angle([corner, x, y]: [Vector; 3]) -> f64 {
    halves(corner, x, y).iter().sum()
}

/// The solid angles of both halves of a rectangle, beside x and beside y; by the sides, of
/// which the corners have lost the digits.
fn halves(corner: Vector, x: Vector, y: Vector) -> [f64; 2] {
    let volume = dot(corner, cross(x, y)).abs();
    let length = |v: Vector| dot(v, v).sqrt();
    let (near, far) = (length(corner), add(add(corner, x, 1.0), y, 1.0));
    [x, y].map(|side| {
        let other = add(corner, side, 1.0);
        let (p, q) = (length(other), length(far));
        let sum =
            near * p * q + dot(corner, other) * q + dot(other, far) * near + dot(far, corner) * p;
        2.0 * volume.atan2(sum)
    })
}

/// The direction of a rectangle: the moving point runs from the end of x over the opposite
/// corner to the end of y, and cuts the fraction u0 of the area off.
#[must_use]
pub fn spherical_rectangle([corner, x, y]: [Vector; 3], u: [u32; 2]) -> Vector {
    let u0 = f64::from(u[0]) / 4_294_967_296.0;
    let u1 = f64::from(u[1]) / 4_294_967_296.0;
    let [first, second] = halves(corner, x, y);
    let target = u0 * (first + second);
    let (from, way, rest) = if target < first {
        (add(corner, x, 1.0), y, target)
    } else {
        (
            add(add(corner, x, 1.0), y, 1.0),
            x.map(|v| -v),
            target - first,
        )
    };
    // A part of a side cuts the same part off the volume.
    let volume = dot(corner, cross(x, y)).abs();
    let length = |v: Vector| dot(v, v).sqrt();
    let cut = |t: f64| {
        let point = add(from, way, t);
        let (a, b, c) = (length(from), length(corner), length(point));
        let sum = a * b * c + dot(from, corner) * c + dot(corner, point) * a + dot(point, from) * b;
        2.0 * (t * volume).atan2(sum)
    };
    let b = unit(corner);
    let moving = unit(add(from, way, bisect(rest, cut)));
    let way = add(moving, b, -1.0);
    let versine = |t: f64| {
        let step = add(unit(add(b, way, t)), b, -1.0);
        dot(step, step)
    };
    unit(add(b, way, bisect(u1 * dot(way, way), versine)))
}
