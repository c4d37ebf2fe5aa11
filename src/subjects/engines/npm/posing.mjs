// SPDX-License-Identifier: BSL-1.0

/** v/‖v‖ for any v ≠ 0. Divided by its largest component first, so that the length neither over- nor underflows. */
export function unit(v) {
  const largest = Math.max(...v.map(Math.abs));
  const scaled = v.map((x) => x / largest);
  const length = Math.hypot(...scaled);
  return scaled.map((x) => x / length);
}

/** The object that engines take for a vector. */
export function xyz([x, y, z]) {
  return { x, y, z };
}

/** The numbers of such an object. */
export function components({ x, y, z }) {
  return [x, y, z];
}

/**
 * A contact for engines that find contacts by themselves: two spheres, one fixed to each body, that meet at P with the
 * normal N. The origin is at P, for lever arms would lose digits far away from it. They overlap by `overlap` of the
 * longer lever arm: posed exactly touching, rounding leaves a gap; and along N no overlap changes a lever arm about N.
 */
export function spheres({ a, b, point, normal }, overlap) {
  const n = unit(normal);
  const centres_of_mass = [a, b].map(({ position }) => position.map((x, i) => x - point[i]));
  const lever_arms = centres_of_mass.map((x) => Math.hypot(...x));
  const longer = Math.max(...lever_arms) || 1;
  const sphere = (index, side) => {
    // Larger than the lever arm, a sphere rounds the contact point of a small body; smaller, it rounds the normal.
    const radius = Math.max(lever_arms[index], longer / 16);
    const centre = n.map((x) => side * (radius - (overlap * longer) / 2) * x);
    const centre_of_mass = centres_of_mass[index];
    return { radius, centre, centre_of_mass, centre_of_mass_from_centre: centre_of_mass.map((x, i) => x - centre[i]) };
  };
  return { a: sphere(0, 1), b: sphere(1, -1) };
}
