// SPDX-License-Identifier: BSL-1.0
import { Color, InstancedBufferAttribute, InstancedMesh, LatheGeometry, Matrix4, Quaternion, ShaderMaterial, Vector2,
  Vector3 } from "three";

import { count_up_to } from "./replay_data.mjs";

/** How long an arrow is visible [s of the scene] at speed ×1. */
const lifetime = 0.4;
const most = 400;

/** A bead at the contact point, a shaft and a head, of length 1 along y. */
function geometry() {
  const profile = [[0, -0.05], [0.04, -0.03], [0.05, 0], [0.04, 0.03], [0.022, 0.045], [0.022, 0.72], [0.085, 0.72], [0, 1]];
  return new LatheGeometry(profile.map(([x, y]) => new Vector2(x, y)), 20);
}

const vertex = /* glsl */ `
  attribute float fade;
  varying float opacity;
  void main() {
    opacity = fade;
    gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
  }`;
const fragment = /* glsl */ `
  uniform vec3 colour;
  varying float opacity;
  void main() {
    gl_FragColor = vec4(colour, opacity);
    #include <colorspace_fragment>
  }`;

/** The impulses of the latest impacts. Lengths grow with the square root, so that small impulses are visible. */
export class Arrows {
  constructor(impacts, longest) {
    this.impacts = impacts;
    const sizes = impacts.map(({ impulse }) => Math.hypot(...impulse));
    const greatest = sizes.reduce((a, b) => Math.max(a, b), 0);
    this.lengths = sizes.map((size) => (greatest > 0 ? longest * Math.sqrt(size / greatest) : 0));
    this.fade = new InstancedBufferAttribute(new Float32Array(most), 1);
    const shape = geometry();
    shape.setAttribute("fade", this.fade);
    // An arrow points from the surface of a body into the body, so it is drawn on top of everything.
    this.material = new ShaderMaterial({ vertexShader: vertex, fragmentShader: fragment, transparent: true,
      depthTest: false, depthWrite: false, uniforms: { colour: { value: new Color() } } });
    this.mesh = new InstancedMesh(shape, this.material, most);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 3;
  }

  set_colour(colour) {
    this.material.uniforms.colour.value.set(colour);
  }

  /** Places the arrows of the impacts just before this time. A faster replay shows a longer span of time. */
  place(time, speed) {
    const span = lifetime * speed;
    const end = count_up_to(this.impacts.length, (i) => this.impacts[i].time, time);
    const matrix = new Matrix4();
    const up = new Vector3(0, 1, 0);
    const turn = new Quaternion();
    let count = 0;
    for (let i = end - 1; i >= 0 && count < most && time - this.impacts[i].time < span; --i) {
      if (this.lengths[i] > 0) {
        const { point, impulse, time: began } = this.impacts[i];
        turn.setFromUnitVectors(up, new Vector3(...impulse).normalize());
        matrix.compose(new Vector3(...point), turn, new Vector3().setScalar(this.lengths[i]));
        this.mesh.setMatrixAt(count, matrix);
        this.fade.array[count] = 1 - (time - began) / span;
        count += 1;
      }
    }
    this.mesh.count = count;
    this.mesh.instanceMatrix.needsUpdate = true;
    this.fade.needsUpdate = true;
  }
}
