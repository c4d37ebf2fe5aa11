// SPDX-License-Identifier: BSL-1.0
import { createRequire } from 'node:module';

import { Body, Box, Plane, Quaternion, Sphere, Vec3, World } from 'cannon-es';

import { unit } from '../posing.mjs';
import { serve_runs } from './serve_runs.mjs';

function make_shape({ shape, sphere, box }) {
  switch (shape) {
    case 'sphere':
      return new Sphere(sphere);
    case 'box':
      return new Box(new Vec3(...box).scale(1 / 2));
    default:
      return new Plane();  // z = 0, solid below
  }
}

function orientation({ half_space, orientation: [w, x, y, z] }) {
  const turned = new Quaternion(x, y, z, w);
  return half_space ? turned.setFromVectors(new Vec3(0, 0, 1), new Vec3(...half_space)) : turned;
}

function make_body(body, configured) {
  const made = new Body({
    mass: body.fixed ? 0 : body.mass,
    shape: make_shape(body),
    position: new Vec3(...body.position),
    quaternion: orientation(body),
    velocity: new Vec3(...body.velocity),
    angularVelocity: new Vec3(...body.angular_velocity),
  });
  if (!body.fixed) {
    made.inertia.set(...body.principal_inertia);
    made.invInertia.set(...body.principal_inertia.map((moment) => 1 / moment));
    made.updateInertiaWorld(true);
  }
  if (configured) {
    made.linearDamping = made.angularDamping = 0;
  }
  return made;
}

// The engine limits the friction impulse of a step to μ m times this gravity. So a gravity times the step limits the
// friction force of a body that rests to μ m g.
function configure(world, step) {
  world.solver.iterations = 100;
  world.solver.tolerance = 0;
  world.frictionGravity = world.gravity.scale(step);
}

function make({ gravity, friction, restitution, bodies }, step, configured) {
  const world = new World({ gravity: new Vec3(...gravity) });  // sleeping is off by default
  Object.assign(world.defaultContactMaterial, { friction, restitution });
  if (configured) {
    configure(world, step);
  }
  const made = bodies.map((body) => make_body(body, configured));
  made.forEach((body) => world.addBody(body));
  return {
    step: () => world.step(step),
    read: (i) => {
      const { position, quaternion: { w, x, y, z }, velocity, angularVelocity } = made[i];
      return { position: position.toArray(), orientation: unit([w, x, y, z]), velocity: velocity.toArray(),
        angular_velocity: angularVelocity.toArray() };
    },
    mass: (i) => ({ mass: 1 / made[i].invMass, principal_inertia: made[i].invInertia.toArray().map((x) => 1 / x) }),
    free: () => {},
  };
}

const { version } = createRequire(import.meta.url)('cannon-es/package.json');
await serve_runs({ name: 'cannon', version, precision: 'binary64', cannot: ['continuous'], make });
