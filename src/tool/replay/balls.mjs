// SPDX-License-Identifier: BSL-1.0
import { Color, DynamicDrawUsage, InstancedMesh, Matrix4, MeshPhysicalMaterial, Quaternion, SphereGeometry,
  Vector3 } from "three";

import { hue_of } from "./colours.mjs";

/** Ivory with a stripe, poles, a spot, and an opposite spot with an eye, so that a turn about any axis is visible. */
const pattern = /* glsl */ `
  vec3 p = normalize(place);
  float soft = max(length(fwidth(p)), 1e-4);
  vec3 ivory = vec3(0.86, 0.83, 0.76);
  vec3 dark = vColor.rgb * 0.35;
  vec3 paint = mix(ivory, vColor.rgb, 1.0 - smoothstep(0.5 - soft, 0.5 + soft, abs(p.z)));
  paint = mix(paint, vColor.rgb, smoothstep(0.965 - soft * 0.5, 0.965 + soft * 0.5, abs(p.z)));
  paint = mix(paint, ivory, smoothstep(0.93 - soft * 0.5, 0.93 + soft * 0.5, abs(p.x)));
  paint = mix(paint, dark, smoothstep(0.985 - soft * 0.25, 0.985 + soft * 0.25, p.x));
  diffuseColor.rgb = paint;
`;

function painted() {
  const material = new MeshPhysicalMaterial({ roughness: 0.45, clearcoat: 0.6, clearcoatRoughness: 0.15 });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 place;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nplace = position;");
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", "#include <common>\nvarying vec3 place;")
      .replace("#include <color_fragment>", pattern);
  };
  return material;
}

/** All spheres of a replay, drawn at once. */
export class Balls {
  /** @param bodies [{ body, index }] */
  constructor(bodies) {
    this.bodies = bodies;
    const fine = bodies.length > 3000 ? 12 : bodies.length > 300 ? 20 : 40;
    this.mesh = new InstancedMesh(new SphereGeometry(1, fine, fine / 2), painted(), bodies.length);
    this.mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    this.mesh.castShadow = true;
    this.mesh.receiveShadow = true;
    this.mesh.frustumCulled = false; // its bounds would have to be computed in each frame
    this.tilts = bodies.map(({ index }, place) => {
      this.mesh.setColorAt(place, new Color(...hue_of(index)));
      // The format has no initial orientation for a sphere. Each sphere gets its own tilt, so that no two spheres look
      // the same.
      return new Quaternion().setFromAxisAngle(
        new Vector3(Math.cos(index * 2.4), Math.sin(index * 2.4), 0.4).normalize(), 0.9 + index * 0.37);
    });
  }

  /** @param states one for each body of the replay */
  place(states) {
    const matrix = new Matrix4();
    const turn = new Quaternion();
    const position = new Vector3();
    const scale = new Vector3();
    this.bodies.forEach(({ body, index }, place) => {
      const [w, x, y, z] = states[index].orientation;
      turn.set(x, y, z, w).multiply(this.tilts[place]);
      matrix.compose(position.fromArray(states[index].position), turn, scale.setScalar(body.radius));
      this.mesh.setMatrixAt(place, matrix);
    });
    this.mesh.instanceMatrix.needsUpdate = true;
  }
}
