// SPDX-License-Identifier: BSL-1.0
import { createRequire } from 'node:module';

import { oimo } from 'oimophysics';

import { components, unit } from '../posing.mjs';
import { serve_runs } from './serve_runs.mjs';

const { Mat3, Quat, Setting, Vec3 } = oimo.common;
const { MassData, RigidBody, RigidBodyConfig, RigidBodyType, Shape, ShapeConfig } = oimo.dynamics.rigidbody;
const { BoxGeometry, SphereGeometry } = oimo.collision.geometry;
const half_side = 100;  // [m] of the cube that stands for a half-space, which the engine lacks

function configure() {
  Setting.contactEnableBounceThreshold = 0;  // [m/s]
  Setting.maxTranslationPerStep = Setting.maxRotationPerStep = Infinity;  // limits of the velocities
}

// The engine's matrix from a quaternion of unit length.
function rotation({ half_space, orientation: [w, x, y, z] }) {
  const turned = new Quat(x, y, z, w);
  return (half_space ? turned.setArc(new Vec3(0, 0, 1), new Vec3(...half_space)) : turned).toMat3();
}

function make_shape({ shape, sphere, box }, { friction, restitution }) {
  const config = new ShapeConfig();
  const half = shape === 'box' ? box.map((x) => x / 2) : [half_side, half_side, half_side];
  config.geometry = shape === 'sphere' ? new SphereGeometry(sphere) : new BoxGeometry(new Vec3(...half));
  Object.assign(config, { friction, restitution });  // a pair has the geometric mean of two equal coefficients
  return new Shape(config);
}

function make_body(body, scene, configured) {
  const config = new RigidBodyConfig();
  const depth = body.half_space ? body.half_space.map((x) => x * half_side) : [0, 0, 0];
  config.type = body.fixed ? RigidBodyType.STATIC : RigidBodyType.DYNAMIC;
  config.position = new Vec3(...body.position.map((x, i) => x - depth[i]));
  config.rotation = rotation(body);
  config.linearVelocity = new Vec3(...body.velocity);
  config.angularVelocity = new Vec3(...body.angular_velocity);
  config.autoSleep = !configured;
  const made = new RigidBody(config);
  made.addShape(make_shape(body, scene));
  if (!body.fixed) {
    const [x, y, z] = body.principal_inertia;
    const mass_data = new MassData();
    mass_data.mass = body.mass;
    mass_data.localInertia = new Mat3(x, 0, 0, 0, y, 0, 0, 0, z);
    made.setMassData(mass_data);
  }
  return made;
}

function make(scene, step, configured) {
  const { World } = oimo.dynamics;
  const world = new World(oimo.collision.broadphase.BroadPhaseType.BRUTE_FORCE, new Vec3(...scene.gravity));
  if (configured) {
    configure();
    world.setNumVelocityIterations(100);
  }
  const made = scene.bodies.map((body) => make_body(body, scene, configured));
  made.forEach((body) => world.addRigidBody(body));
  return {
    step: () => world.step(step),
    read: (i) => {
      const { x, y, z, w } = made[i].getOrientation();
      return { position: components(made[i].getPosition()), orientation: unit([w, x, y, z]),
        velocity: components(made[i].getLinearVelocity()), angular_velocity: components(made[i].getAngularVelocity()) };
    },
    mass: (i) => {
      const inertia = made[i].getLocalInertia();
      return { mass: made[i].getMass(), principal_inertia: [inertia.e00, inertia.e11, inertia.e22] };
    },
    free: () => {},
  };
}

const { version } = createRequire(import.meta.url)('oimophysics/package.json');
await serve_runs({ name: 'oimo', version, precision: 'binary64', cannot: ['continuous'], make });
