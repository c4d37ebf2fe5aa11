// SPDX-License-Identifier: BSL-1.0
import { createRequire } from 'node:module';

import { oimo } from 'oimophysics';

import { limits, serve_if_program, subject_name } from './line_protocol.mjs';
import { components, spheres, unit } from './posing.mjs';

const { Mat3, Quat, Setting, Vec3 } = oimo.common;
const { MassData, RigidBody, RigidBodyConfig, RigidBodyType, Shape, ShapeConfig } = oimo.dynamics.rigidbody;
const { PositionCorrectionAlgorithm } = oimo.dynamics.constraint;

const overlap = 64 * Number.EPSILON;  // exceeds the rounding error of the spheres' distance, about 10 roundings
const step = 1 / 60;  // [s]; has no effect on the configured engine

function configure() {
  Setting.contactEnableBounceThreshold = 0;  // [m/s]
  Setting.maxTranslationPerStep = Setting.maxRotationPerStep = Infinity;  // limits of the velocities
  // The overlap causes no velocity.
  Setting.defaultContactPositionCorrectionAlgorithm = PositionCorrectionAlgorithm.SPLIT_IMPULSE;
}

function make_shape(sphere, rotation, { friction, restitution }) {
  const config = new ShapeConfig();
  config.geometry = new oimo.collision.geometry.SphereGeometry(sphere.radius);
  const centre = new Vec3(...sphere.centre_of_mass_from_centre).negate();
  config.position = centre.mulMat3(rotation.transpose());
  config.friction = friction;  // a contact has the geometric mean of two equal coefficients
  config.restitution = restitution;
  return new Shape(config);
}

function make_body(body, sphere, collision) {
  const [w, x, y, z] = body.immovable ? [1, 0, 0, 0] : unit(body.orientation);
  const config = new RigidBodyConfig();
  config.type = body.immovable ? RigidBodyType.KINEMATIC : RigidBodyType.DYNAMIC;
  config.position = new Vec3(...sphere.centre_of_mass);
  config.rotation = new Quat(x, y, z, w).toMat3();
  config.linearVelocity = new Vec3(...body.velocity);
  config.angularVelocity = new Vec3(...body.angular_velocity);
  const made = new RigidBody(config);
  made.addShape(make_shape(sphere, config.rotation, collision));
  if (!body.immovable) {
    const [x, y, z] = body.principal_inertia;
    const mass_data = new MassData();
    mass_data.mass = body.mass;
    mass_data.localInertia = new Mat3(x, 0, 0, 0, y, 0, 0, 0, z);
    made.setMassData(mass_data);
  }
  return made;
}

function velocity_of(body) {
  return { velocity: components(body.getLinearVelocity()), angular_velocity: components(body.getAngularVelocity()) };
}

function solve(collision, { configured, model }) {
  const contact = { friction: model === 'coulomb' ? collision.friction : 0, restitution: collision.restitution };
  const posed = spheres(collision, overlap);
  const a = make_body(collision.a, posed.a, contact);
  const b = make_body(collision.b, posed.b, contact);
  const world = new oimo.dynamics.World(oimo.collision.broadphase.BroadPhaseType.BRUTE_FORCE, new Vec3(0, 0, 0));
  if (configured) {
    world.setNumVelocityIterations(100);
  }
  world.addRigidBody(a);
  world.addRigidBody(b);
  world.step(step);
  return { a: velocity_of(a), b: velocity_of(b) };
}

export function subject(setting) {
  const { configured, model } = setting;
  if (configured) {
    configure();
  }
  const claims = {
    name: subject_name('oimo', setting),
    version: createRequire(import.meta.url)('oimophysics/package.json').version,
    precision: 'binary64',
    model,
    claims: configured ? undefined : {
      restitution_threshold: 0.5,
      ...limits(model, { max_speed: 20 / step, max_angular_velocity: Math.PI / step }),
    },
  };
  return { claims, solve: (collision) => solve(collision, setting) };
}

await serve_if_program(import.meta.url, subject);
