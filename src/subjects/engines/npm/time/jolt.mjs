// SPDX-License-Identifier: BSL-1.0
import { createRequire } from 'node:module';

import * as engine from '../jolt_engine.mjs';
import { serve_runs } from './serve_runs.mjs';

const { Jolt, engine_vector, numbers_of } = engine;
const plane = new Jolt.Plane(engine_vector([0, 0, 1]), 0);  // reused

function make_shape({ shape, sphere, box, half_space }, configured) {
  if (shape === 'sphere') {
    return new Jolt.SphereShape(sphere);
  }
  if (shape === 'box') {
    const half = box.map((x) => x / 2);
    return new Jolt.BoxShape(engine_vector(half), configured ? 0 : Math.min(0.05, ...half));  // rounds the edges
  }
  plane.SetNormal(engine_vector(half_space));
  return new Jolt.PlaneShape(plane);
}

function make_body(bodies, body, { friction, restitution, continuous }, configured) {
  const turned = engine.engine_rotation(body.half_space ? [1, 0, 0, 0] : body.orientation);
  const motion = body.fixed ? Jolt.EMotionType_Static : Jolt.EMotionType_Dynamic;
  const shape = make_shape(body, configured);
  const settings = new Jolt.BodyCreationSettings(shape, engine.engine_position(body.position), turned, motion, 0);
  settings.mFriction = friction;  // a pair has the geometric mean
  settings.mRestitution = restitution;  // a pair has the greater one
  settings.mLinearVelocity = engine_vector(body.velocity);
  settings.mAngularVelocity = engine_vector(body.angular_velocity);
  settings.mMotionQuality = continuous ? Jolt.EMotionQuality_LinearCast : Jolt.EMotionQuality_Discrete;
  if (configured) {
    settings.mLinearDamping = settings.mAngularDamping = 0;
    settings.mMaxLinearVelocity = settings.mMaxAngularVelocity = 1e9;
    settings.mAllowSleeping = false;
    settings.mApplyGyroscopicForce = true;
  }
  const made = bodies.CreateBody(settings);
  Jolt.destroy(settings);
  if (!body.fixed) {
    engine.set_mass(made, body);
  }
  bodies.AddBody(made.GetID(), body.fixed ? Jolt.EActivation_DontActivate : Jolt.EActivation_Activate);
  return made;
}

function read(body) {
  const q = body.GetRotation();
  const [position, velocity] = [numbers_of(body.GetPosition()), numbers_of(body.GetLinearVelocity())];
  const orientation = [q.GetW(), q.GetX(), q.GetY(), q.GetZ()];
  return { position, orientation, velocity, angular_velocity: numbers_of(body.GetAngularVelocity()) };
}

function mass(body) {
  const properties = body.GetMotionProperties();
  const principal_inertia = numbers_of(properties.GetInverseInertiaDiagonal()).map((j) => 1 / j);
  return { mass: 1 / properties.GetInverseMass(), principal_inertia };
}

function make(scene, step, configured) {
  const world = engine.make_interface(scene.bodies.length, 4096);
  const system = world.GetPhysicsSystem();
  system.SetGravity(engine_vector(scene.gravity));
  if (configured) {
    system.GetPhysicsSettings().mMinVelocityForRestitution = 0;  // [m/s]
  }
  const made = scene.bodies.map((body) => make_body(system.GetBodyInterface(), body, scene, configured));
  const recorder = new Jolt.StateRecorderImpl();
  return {
    step: () => world.Step(step, 1),
    read: (i) => read(made[i]),
    mass: (i) => mass(made[i]),
    save: () => (recorder.Clear(), system.SaveState(recorder), recorder),
    restore: (saved) => (saved.Rewind(), system.RestoreState(saved)),
    free: () => [recorder, world].forEach((one) => Jolt.destroy(one)),
  };
}

const { version } = createRequire(import.meta.url)('jolt-physics/package.json');
await serve_runs({ name: 'jolt', version, precision: 'binary32', restores: true, make });
