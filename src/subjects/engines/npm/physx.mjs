// SPDX-License-Identifier: BSL-1.0
import { limits, serve_if_program, subject_name } from './line_protocol.mjs';
import { describe_scene, engine_vector, physics, PhysX, pose_at, version } from './physx_engine.mjs';
import { components, spheres, unit } from './posing.mjs';

const overlap = 2e-6;  // about 16 roundings of binary32, so that rounding leaves no gap between the spheres

// Both bodies have this material, so the mean of their coefficients is its coefficient.
const material = physics.createMaterial(0, 0, 0);
const ball = new PhysX.PxSphereGeometry(1);  // reused, because the engine's memory has no garbage collection

// Immovable bodies are in the lower dominance group, which a contact does not move, so they keep their velocity
// exactly. (The velocity of a kinematic body would be the difference of two rounded poses.) Immovable bodies collide
// only with movable bodies.
const movable = { dominance: 1, collides: new PhysX.PxFilterData(1, 3, 0, 0) };
const immovable = { dominance: 0, collides: new PhysX.PxFilterData(2, 1, 0, 0) };

const description = describe_scene([0, 0, 0]);

// The engine's body has the world's axes. Only its centre of mass and its principal axes are posed.
function make_body(scene, body, sphere, configured) {
  const made = physics.createRigidDynamic(pose_at([0, 0, 0]));
  const { dominance, collides } = body.immovable ? immovable : movable;
  ball.radius = sphere.radius;
  const shape = physics.createShape(ball, material, true);
  shape.setLocalPose(pose_at(sphere.centre));
  shape.setSimulationFilterData(collides);
  made.attachShape(shape);
  shape.release();
  made.setDominanceGroup(dominance);
  made.setCMassLocalPose(pose_at(sphere.centre_of_mass, body.immovable ? undefined : unit(body.orientation)));
  made.setMass(body.immovable ? 1 : body.mass);
  made.setMassSpaceInertiaTensor(engine_vector(body.immovable ? [1, 1, 1] : body.principal_inertia));
  if (configured || body.immovable) {
    made.setAngularDamping(0);
    made.setMaxLinearVelocity(1e18);  // [m/s]; the square must not overflow
    made.setMaxAngularVelocity(1e18);  // [rad/s]
  }
  if (configured) {
    made.setMaxDepenetrationVelocity(0);  // the overlap causes no velocity
    made.setSolverIterationCounts(4, 255);  // 4 for positions, as shipped; 255 for velocities, the maximum
  }
  made.setLinearVelocity(engine_vector(body.velocity));
  made.setAngularVelocity(engine_vector(body.angular_velocity));
  scene.addActor(made);
  return made;
}

function velocity_of(body) {
  return { velocity: components(body.getLinearVelocity()), angular_velocity: components(body.getAngularVelocity()) };
}

function solve(collision, { configured, model }) {
  const posed = spheres(collision, overlap);
  const friction = model === 'coulomb' ? collision.friction : 0;
  material.setStaticFriction(friction);
  material.setDynamicFriction(friction);
  material.setRestitution(collision.restitution);
  const scene = physics.createScene(description);
  const bodies = ['a', 'b'].map((name) => make_body(scene, collision[name], posed[name], configured));
  scene.simulate(1 / 60);  // [s]; has no effect on the configured engine
  scene.fetchResults(true);
  const [a, b] = bodies.map(velocity_of);
  [...bodies, scene].forEach((made) => made.release());
  return { a, b };
}

export function subject(setting) {
  const { configured, model } = setting;
  if (configured) {
    description.bounceThresholdVelocity = 1e-45;  // [m/s], the smallest positive binary32 number
  }
  const claims = {
    name: subject_name('physx', setting),
    version,
    precision: 'binary32',
    model,
    claims: configured ? undefined : { restitution_threshold: 2, ...limits(model, { max_angular_velocity: 100 }) },
  };
  return { claims, solve: (collision) => solve(collision, setting) };
}

await serve_if_program(import.meta.url, subject);
