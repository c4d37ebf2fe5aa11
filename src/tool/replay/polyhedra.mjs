// SPDX-License-Identifier: BSL-1.0
import { BufferGeometry, Color, EdgesGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial } from "three";

import { hue_of } from "./colours.mjs";
import { cross, dot } from "./quaternion.mjs";

/** Flat faces in three alternating shades, so that a turn is visible. */
function geometry_of({ vertices, faces }) {
  const positions = [];
  const shades = [];
  faces.forEach((face, which) => {
    const corners = face.map((index) => vertices[index]);
    const side = (n) => corners[n].map((x, i) => x - corners[0][i]);
    // Orients the face outward, whatever the order of its corners. The centre of mass, at the origin, is inside.
    const outward = dot(cross(side(1), side(2)), corners[0]) >= 0;
    for (let n = 1; n + 1 < corners.length; ++n) {
      for (const corner of outward ? [0, n, n + 1] : [0, n + 1, n]) {
        positions.push(...corners[corner]);
        shades.push(...[1, 1, 1].map(() => [1, 0.72, 1.25][which % 3]));
      }
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
  geometry.setAttribute("color", new Float32BufferAttribute(shades, 3));
  geometry.computeVertexNormals();
  return geometry;
}

export class Polyhedra {
  /** @param bodies [{ body, index }] */
  constructor(bodies) {
    this.group = new Group();
    this.meshes = bodies.map(({ body, index }) => {
      const hue = new Color(...hue_of(index));
      const geometry = geometry_of(body);
      const material = new MeshStandardMaterial({ color: hue, vertexColors: true, flatShading: true, roughness: 0.55 });
      const mesh = new Mesh(geometry, material);
      mesh.castShadow = true;
      mesh.receiveShadow = true;
      mesh.add(new LineSegments(new EdgesGeometry(geometry, 5),
        new LineBasicMaterial({ color: hue.clone().multiplyScalar(0.25) })));
      this.group.add(mesh);
      return { mesh, index };
    });
  }

  place(states) {
    for (const { mesh, index } of this.meshes) {
      const [w, x, y, z] = states[index].orientation;
      mesh.position.fromArray(states[index].position);
      mesh.quaternion.set(x, y, z, w);
    }
  }
}
