// SPDX-License-Identifier: BSL-1.0
import { DirectionalLight, NeutralToneMapping, PCFShadowMap, PerspectiveCamera, PMREMGenerator, Scene, Vector3,
  WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";

import { Arrows } from "./arrows.mjs";
import { Balls } from "./balls.mjs";
import { box_of, corners_of, frame, up_of } from "./framing.mjs";
import { Polyhedra } from "./polyhedra.mjs";
import { steepness } from "./region.mjs";
import { typical_radius } from "./replay_data.mjs";
import { Rings } from "./rings.mjs";
import { Surroundings } from "./surroundings.mjs";

/** The 3D picture of a replay. Throws if the browser has no WebGL. */
export class View {
  /** @param changed called when the picture must be redrawn */
  constructor(canvas, replay, changed) {
    this.replay = replay;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.scene = new Scene();
    const box = box_of(replay);
    const up = up_of(replay);
    this.steepness = steepness(box, up);
    this.corners = corners_of(box);
    this.size = this.corners[0].distanceTo(this.corners[7]);
    this.camera = new PerspectiveCamera(32, 1, this.size / 200, this.size * 40);
    this.camera.up.set(...up);
    this.controls = new OrbitControls(this.camera, canvas);
    this.centre = this.corners[0].clone().add(this.corners[7]).multiplyScalar(0.5);
    this.controls.target.copy(this.centre);
    this.controls.maxDistance = this.size * 10;
    this.controls.addEventListener("start", () => { this.is_own_view = true; });
    this.controls.addEventListener("change", changed);

    this.light(up);
    const bodies = replay.bodies.map((body, index) => ({ body, index }));
    this.balls = new Balls(bodies.filter(({ body }) => body.kind === "sphere"));
    this.polyhedra = new Polyhedra(bodies.filter(({ body }) => body.kind !== "sphere"));
    this.rings = new Rings(replay.bodies);
    this.arrows = new Arrows(replay.impacts, Math.min(this.size * 0.16, typical_radius(replay.bodies) * 6));
    this.surroundings = new Surroundings(replay, box, up);
    this.scene.add(this.surroundings.group, this.balls.mesh, this.polyhedra.group, this.rings.mesh, this.arrows.mesh);
    this.look_from_the_start();
  }

  light(up) {
    const generator = new PMREMGenerator(this.renderer);
    this.scene.environment = generator.fromScene(new RoomEnvironment(), 0.04).texture;
    this.scene.environmentIntensity = 0.55;
    generator.dispose();
    const sun = new DirectionalLight(0xffffff, 2.2);
    const aside = this.aside(up);
    sun.position.copy(this.controls.target).addScaledVector(new Vector3(...up), this.size)
      .addScaledVector(aside, this.size * 0.35);
    sun.target.position.copy(this.controls.target);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    sun.shadow.radius = 3;
    sun.shadow.normalBias = this.size * 5e-4;
    const half = this.size * 0.55;
    Object.assign(sun.shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: this.size * 0.1,
      far: this.size * 2 });
    this.scene.add(sun, sun.target);
  }

  /** A level direction, to the right and in front of the viewer. */
  aside(up) {
    const axis = new Vector3(...up);
    const level = Math.abs(axis.x) < 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
    level.addScaledVector(axis, -level.dot(axis)).normalize();
    return level.applyAxisAngle(axis, -Math.PI / 3);
  }

  look_from_the_start() {
    this.is_own_view = false;
    const direction = this.aside(this.camera.up.toArray()).addScaledVector(this.camera.up, this.steepness);
    frame(this.camera, this.controls.target.copy(this.centre), this.corners, direction);
    this.controls.update();
  }

  resize(width, height, ratio) {
    this.renderer.setPixelRatio(Math.min(ratio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.rings.resize(height, this.camera);
    this.camera.updateProjectionMatrix();
    if (!this.is_own_view) {
      this.look_from_the_start();
    }
  }

  /** @param colours { phases, arrow, line, dark } */
  set_colours(colours) {
    this.rings.set_colours(colours.phases);
    this.arrows.set_colour(colours.arrow);
    this.surroundings.set_colours(colours);
  }

  /** @param shown { arrows, rings } */
  draw(time, speed, states, shown) {
    this.balls.place(states);
    this.polyhedra.place(states);
    this.rings.mesh.visible = shown.rings;
    if (shown.rings && states.length > 0) {
      this.rings.place(states);
    }
    this.arrows.mesh.visible = shown.arrows;
    this.arrows.place(time, speed);
    this.renderer.render(this.scene, this.camera);
  }
}
