// SPDX-License-Identifier: BSL-1.0
import { describe_scene, engine_vector, physics, PhysX, pose_at, version } from '../physx_engine.mjs';
import { components, unit } from '../posing.mjs';
import { serve_runs } from './serve_runs.mjs';

const { PxPairFlagEnum: PairFlag, PxRigidBodyFlagEnum: BodyFlag } = PhysX;
const collides = new PhysX.PxFilterData(1, 1, 0, 0);
const continuous_filter = new PhysX.PassThroughFilterShaderImpl();  // the default one asks for no such detection
continuous_filter.filterShader = () => {
  continuous_filter.outputPairFlags = PairFlag.eCONTACT_DEFAULT | PairFlag.eDETECT_CCD_CONTACT;
  return 0;
};

function make_scene({ gravity, continuous }, configured) {
  const description = describe_scene(gravity);
  if (continuous) {
    description.flags.raise(PhysX.PxSceneFlagEnum.eENABLE_CCD);
    PhysX.setupPassThroughFilterShader(description, continuous_filter);
  }
  description.bounceThresholdVelocity = configured ? 1e-45 : description.bounceThresholdVelocity;  // [m/s], must be > 0
  const made = physics.createScene(description);
  PhysX.destroy(description);
  return made;
}

function make_shape({ sphere, box }, material) {
  const solid = () => sphere ? new PhysX.PxSphereGeometry(sphere) : new PhysX.PxBoxGeometry(...box.map((x) => x / 2));
  const geometry = sphere || box ? solid() : new PhysX.PxPlaneGeometry();
  const made = physics.createShape(geometry, material, true);
  made.setSimulationFilterData(collides);
  PhysX.destroy(geometry);
  return made;
}

// The engine's half-space is solid below x = 0.
const turn_from_x = ([x, y, z]) => x > -1 ? unit([1 + x, 0, -z, y]) : [0, 0, 0, 1];

function make_body(body, material, continuous, configured) {
  const pose = pose_at(body.position, body.half_space ? turn_from_x(body.half_space) : body.orientation);
  const made = body.fixed ? physics.createRigidStatic(pose) : physics.createRigidDynamic(pose);
  const shape = make_shape(body, material);
  made.attachShape(shape);
  shape.release();
  if (body.fixed) {
    return made;
  }
  made.setMass(body.mass);
  made.setMassSpaceInertiaTensor(engine_vector(body.principal_inertia));
  made.setRigidBodyFlag(BodyFlag.eENABLE_CCD, continuous);
  if (configured) {
    made.setAngularDamping(0);
    made.setMaxLinearVelocity(1e18);  // [m/s]; the square must not overflow
    made.setMaxAngularVelocity(1e18);
    made.setSleepThreshold(0);
    made.setSolverIterationCounts(32, 32);  // for positions and for velocities
  }
  made.setLinearVelocity(engine_vector(body.velocity));
  made.setAngularVelocity(engine_vector(body.angular_velocity));
  return made;
}

function make({ bodies, friction, restitution, ...scene }, step, configured) {
  const world = make_scene(scene, configured);
  const material = physics.createMaterial(friction, friction, restitution);  // a pair has the mean
  const made = bodies.map((body) => make_body(body, material, scene.continuous, configured));
  made.forEach((body) => world.addActor(body));
  return {
    step: () => (world.simulate(step), world.fetchResults(true)),
    read: (i) => {
      const { p, q: { w, x, y, z } } = made[i].getGlobalPose();
      const [position, orientation] = [components(p), [w, x, y, z]];
      const velocity = components(made[i].getLinearVelocity());
      return { position, orientation, velocity, angular_velocity: components(made[i].getAngularVelocity()) };
    },
    mass: (i) => ({ mass: made[i].getMass(), principal_inertia: components(made[i].getMassSpaceInertiaTensor()) }),
    free: () => [...made, material, world].forEach((one) => one.release()),
  };
}

await serve_runs({ name: 'physx', version, precision: 'binary32', make });
