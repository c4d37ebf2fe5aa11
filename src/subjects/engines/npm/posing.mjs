// SPDX-License-Identifier: BSL-1.0

/** v/‖v‖ for any v ≠ 0, without overflow or underflow of the length. */
export function unit(v) {
  const largest = Math.max(...v.map(Math.abs));
  const scaled = v.map((x) => x / largest);
  const length = Math.hypot(...scaled);
  return scaled.map((x) => x / length);
}

/** The object that engines take as a vector. */
export function xyz([x, y, z]) {
  return { x, y, z };
}

/** The components of the object that engines take as a vector. */
export function components({ x, y, z }) {
  return [x, y, z];
}

/**
 * A contact for engines that find contacts by themselves: two spheres, one fixed to each body, that meet at P with the
 * normal N. The origin is at P because lever arms lose digits far from the origin. The spheres overlap by `overlap`
 * times the longer lever arm, because rounding leaves a gap between spheres that touch exactly. The overlap is along N,
 * so it changes no lever arm about N.
 */
export function spheres({ a, b, point, normal }, overlap) {
  const n = unit(normal);
  const centres_of_mass = [a, b].map(({ position }) => position.map((x, i) => x - point[i]));
  const lever_arms = centres_of_mass.map((x) => Math.hypot(...x));
  const longer = Math.max(...lever_arms) || 1;
  const sphere = (index, side) => {
    // A larger sphere would round the contact point of a small body. A smaller sphere would round the normal.
    const radius = Math.max(lever_arms[index], longer / 16);
    const centre = n.map((x) => side * (radius - (overlap * longer) / 2) * x);
    const centre_of_mass = centres_of_mass[index];
    return { radius, centre, centre_of_mass, centre_of_mass_from_centre: centre_of_mass.map((x, i) => x - centre[i]) };
  };
  return { a: sphere(0, 1), b: sphere(1, -1) };
}
