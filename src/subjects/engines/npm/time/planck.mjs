// SPDX-License-Identifier: BSL-1.0
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname } from 'node:path';

import planck from 'planck';

import { serve_runs } from './serve_runs.mjs';

const { Box, Circle, Settings, Vec2, World } = planck;
const half_side = 100;  // [m] of the square that stands for a half-space, which the engine lacks

// The settings of the engine are global.
function configure() {
  Settings.velocityThreshold = 0;  // [m/s]; slower contacts do not bounce
  Settings.maxTranslation = Settings.maxRotation = Infinity;  // limits of the velocities
  Settings.linearSlop = 1e-5;  // [m]; polygons have a skin of twice this length, 0.01 m as shipped
}

const angle_of = ([w, , , z]) => 2 * Math.atan2(z, w);

function make_shape({ shape, sphere, box, half_space }) {
  switch (shape) {
    case 'sphere':
      return new Circle(sphere);
    case 'box':
      return new Box(box[0] / 2, box[1] / 2);
    default: {
      const [x, y] = half_space;
      return new Box(half_side, half_side, new Vec2(-half_side * x, -half_side * y), Math.atan2(-x, y));
    }
  }
}

function make_body(world, body, { friction, restitution, continuous }, configured) {
  const made = world.createBody({
    type: body.fixed ? 'static' : 'dynamic',
    position: new Vec2(...body.position),
    angle: body.half_space ? 0 : angle_of(body.orientation),
    linearVelocity: new Vec2(...body.velocity),
    angularVelocity: body.angular_velocity[2],
    allowSleep: !configured,
    bullet: continuous,
  });
  // A pair has the geometric mean of the frictions, and the greater restitution.
  made.createFixture({ shape: make_shape(body), density: 1, friction, restitution });
  if (!body.fixed) {
    made.setMassData({ mass: body.mass, center: new Vec2(0, 0), I: body.principal_inertia[2] });
  }
  return made;
}

function make(scene, step, configured) {
  if (configured) {
    configure();
  }
  const [x, y] = scene.gravity;
  const world = new World({ gravity: new Vec2(x, y), allowSleep: !configured });
  if (configured) {
    world.setContinuousPhysics(scene.continuous);  // as shipped, bodies do not pass through fixed ones
  }
  const iterations = configured ? [100, 20] : [8, 3];  // for velocities and for positions, as shipped
  const made = scene.bodies.map((body) => make_body(world, body, scene, configured));
  const spatial = (v) => [v.x, v.y, 0];
  return {
    step: () => world.step(step, ...iterations),
    read: (i) => {
      const half = made[i].getAngle() / 2;
      return { position: spatial(made[i].getPosition()), orientation: [Math.cos(half), 0, 0, Math.sin(half)],
        velocity: spatial(made[i].getLinearVelocity()), angular_velocity: [0, 0, made[i].getAngularVelocity()] };
    },
    mass: (i) => ({ mass: made[i].getMass(), principal_inertia: [undefined, undefined, made[i].getInertia()] }),
    free: () => {},
  };
}

const { resolve } = createRequire(import.meta.url);
const { version } = JSON.parse(readFileSync(`${dirname(resolve('planck'))}/../package.json`));
await serve_runs({ name: 'planck', version, precision: 'binary64', planar: true, make });
