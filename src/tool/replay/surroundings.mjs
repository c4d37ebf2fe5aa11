// SPDX-License-Identifier: BSL-1.0
import { BufferGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial,
  ShadowMaterial } from "three";

import { dot } from "./quaternion.mjs";
import { face_of, grid_on, grid_step, half_spaces } from "./region.mjs";

function lines(points, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points.flat(), 3));
  const segments = new LineSegments(geometry, material);
  segments.renderOrder = -1;
  return segments;
}

function filled(corners, material) {
  const points = [];
  for (let n = 1; n + 1 < corners.length; ++n) {
    points.push(corners[0].point, corners[n].point, corners[n + 1].point);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points.flat(), 3));
  geometry.computeVertexNormals();
  return new Mesh(geometry, material);
}

/** Floors with a grid and shadows. Walls as edges and a faint colour. */
export class Surroundings {
  constructor(replay, box, up) {
    this.group = new Group();
    this.materials = {
      grid: new LineBasicMaterial({ transparent: true, depthWrite: false, toneMapped: false }),
      edge: new LineBasicMaterial({ transparent: true, depthWrite: false, toneMapped: false }),
      wall: new MeshBasicMaterial({ transparent: true, depthWrite: false, toneMapped: false }),
      shadow: new ShadowMaterial({ transparent: true, depthWrite: false }),
    };
    const size = Math.hypot(...box[1].map((x, i) => x - box[0][i]));
    const spaces = half_spaces(replay.planes, replay.room, box);
    const edges = [];
    const grid = [];
    this.step = 0;
    spaces.forEach(({ normal, real }, index) => {
      const corners = face_of(index, spaces, size, up);
      if (!real || corners.length < 3) {
        return;
      }
      const meets = ({ behind }) => behind >= 0 && spaces[behind].real;
      // A wall that stands alone gets an outline, so that it is visible from behind.
      const is_alone = Math.abs(dot(normal, up)) < 0.3 && !corners.some(meets);
      corners.forEach((corner, i) => {
        const { point } = corner;
        if (is_alone || meets(corner)) {
          edges.push(point, corners[(i + 1) % corners.length].point);
        }
      });
      const wall = filled(corners, this.materials.wall);
      wall.renderOrder = -3;
      this.group.add(wall);
      if (dot(normal, up) > 0.3) {
        this.step ||= grid_step(size, 24);
        grid.push(...grid_on(corners, normal, this.step, up).flat());
        const shade = filled(corners, this.materials.shadow);
        shade.receiveShadow = true;
        shade.renderOrder = -2;
        this.group.add(shade);
      }
    });
    this.group.add(lines(grid, this.materials.grid), lines(edges, this.materials.edge));
  }

  set_colours({ line, dark }) {
    const { grid, edge, wall, shadow } = this.materials;
    [[grid, dark ? 0.2 : 0.22], [edge, dark ? 0.5 : 0.42], [wall, 0.035]].forEach(([material, opacity]) => {
      material.color.set(line);
      material.opacity = opacity;
    });
    shadow.opacity = dark ? 0.55 : 0.22;
  }
}
