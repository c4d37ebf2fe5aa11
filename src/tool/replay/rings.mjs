// SPDX-License-Identifier: BSL-1.0
import { Color, DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, RingGeometry,
  ShaderMaterial, Vector2 } from "three";

import { radius_of } from "./replay_data.mjs";

const vertex = `
  attribute vec4 ball; // centre and radius
  attribute vec3 colour;
  uniform vec2 picture; // height in pixels of the screen, and the tangent of half the field of view
  varying vec3 shade;
  void main() {
    shade = colour;
    vec3 centre = (viewMatrix * vec4(ball.xyz, 1.0)).xyz;
    float distance = max(length(centre), 1e-6);
    float pixel = 2.0 * picture.y * distance / picture.x;
    // Near the camera the outline of a ball is wider than the ball.
    float ratio = min(ball.w / distance, 0.95);
    float outline = ball.w / sqrt(1.0 - ratio * ratio);
    // As thick on all bodies, and thinner on those that are hardly thicker themselves.
    float thickness = min(2.2 * pixel, 0.12 * outline);
    float radius = outline + thickness * (length(position.xy) > 1.5 ? 2.2 : 1.2);
    vec3 toward = -centre / distance;
    vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), toward));
    vec2 direction = normalize(position.xy);
    vec3 place = centre + (right * direction.x + cross(toward, right) * direction.y) * radius;
    gl_Position = projectionMatrix * vec4(place, 1.0);
  }`;
const fragment = `
  varying vec3 shade;
  void main() {
    gl_FragColor = vec4(shade, 1.0);
    #include <colorspace_fragment>
  }`;

/** A ring about the outline of each body, in the colour of its phase. */
export class Rings {
  constructor(bodies) {
    const count = bodies.length;
    const ring = new RingGeometry(1, 2, 56);
    const geometry = new InstancedBufferGeometry();
    geometry.index = ring.index;
    geometry.setAttribute("position", ring.getAttribute("position"));
    geometry.instanceCount = count;
    this.balls = new InstancedBufferAttribute(new Float32Array(count * 4), 4).setUsage(DynamicDrawUsage);
    this.shades = new InstancedBufferAttribute(new Float32Array(count * 3), 3).setUsage(DynamicDrawUsage);
    bodies.forEach((body, index) => this.balls.setW(index, radius_of(body)));
    geometry.setAttribute("ball", this.balls);
    geometry.setAttribute("colour", this.shades);
    this.picture = new Vector2(1, 1);
    this.mesh = new Mesh(geometry, new ShaderMaterial({ vertexShader: vertex, fragmentShader: fragment,
      transparent: true, depthWrite: false, uniforms: { picture: { value: this.picture } } }));
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
    this.colours = [];
  }

  /** @param colours one for each phase */
  set_colours(colours) {
    this.colours = colours.map((colour) => new Color(colour));
  }

  resize(height, camera) {
    this.picture.set(height, Math.tan(camera.fov * Math.PI / 360));
  }

  place(states) {
    states.forEach(({ position, phase }, index) => {
      const { r, g, b } = this.colours[phase];
      this.balls.setXYZ(index, ...position);
      this.shades.setXYZ(index, r, g, b);
    });
    this.balls.needsUpdate = true;
    this.shades.needsUpdate = true;
  }
}
