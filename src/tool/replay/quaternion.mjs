// SPDX-License-Identifier: BSL-1.0
// Quaternions as [w, x, y, z], and vectors as [x, y, z].

export function product([w, x, y, z], [a, b, c, d]) {
  return [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b,
    w * d + x * c - y * b + z * a];
}

export function normalized(q) {
  const length = Math.hypot(...q);
  return length > 0 ? q.map((component) => component / length) : [1, 0, 0, 0];
}

/** The turn about a vector by its length [rad]. */
export function turn(vector) {
  const angle = Math.hypot(...vector);
  // sin(x/2)/x, whose limit at 0 is 1/2. For x ≤ 10⁻⁸, the relative error x²/24 of the limit is below the last digit.
  const share = angle > 1e-8 ? Math.sin(angle / 2) / angle : 0.5;
  return [Math.cos(angle / 2), ...vector.map((component) => component * share)];
}

export function cross([a, b, c], [x, y, z]) {
  return [b * z - c * y, c * x - a * z, a * y - b * x];
}

export function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
