// SPDX-License-Identifier: BSL-1.0
import { answer_requests } from '../line_protocol.mjs';
import { is_planar, read_run } from './scene.mjs';

const warm_up = 10;  // [steps]
const roundings = 2 ** -20;  // 16 roundings of binary32: an engine stores reciprocals, and some turn the moments

/** The error for a scene that the engine cannot pose. */
export function not_posed(why) {
  return Object.assign(new Error(why), { is_skip: true });
}

function check_scene(scene, { cannot = [], planar = false }) {
  const asked = [...scene.bodies.map(({ shape }) => shape), ...(scene.continuous ? ['continuous'] : [])];
  const missing = asked.find((name) => cannot.includes(name));
  if (missing || (planar && !is_planar(scene))) {
    throw not_posed(`the engine cannot pose ${missing ?? 'a scene out of the plane z = 0'}`);
  }
}

// An engine that computes with another mass would be blamed for the adapter's fault.
function check_masses(world, { bodies }) {
  bodies.forEach((body, i) => {
    const found = body.fixed ? {} : world.mass(i);
    for (const [name, value] of Object.entries(found)) {
      const [has, wanted] = [[value].flat(), [body[name]].flat()];
      if (!has.every((x, k) => x === undefined || Math.abs(x - wanted[k]) <= roundings * wanted[k])) {
        throw not_posed(`scene.bodies[${i}].${name}: asked for ${wanted}, the engine has ${has}`);
      }
    }
  });
}

// The world that warms up is a copy, so the run begins with the scene.
function begin(run, scene, step) {
  check_scene(scene, run.engine);
  run.world?.free();
  Object.assign(run, { world: undefined, saved: undefined });
  const copy = run.engine.make(scene, step, run.configured);
  for (let i = 0; i < warm_up; ++i) {
    copy.step();
  }
  copy.free();
  Object.assign(run, { scene, step, world: run.engine.make(scene, step, run.configured) });
  check_masses(run.world, scene);
}

function states({ world, scene }) {
  return scene.bodies.map(({ fixed, position, orientation, velocity, angular_velocity }, i) =>
    fixed ? { position, orientation, velocity, angular_velocity } : world.read(i));
}

function advance(run, request) {
  const { step, steps, report, scene } = read_run(request);
  if (scene) {
    begin(run, scene, step);
  } else if (step !== run.step) {
    throw new Error(`step: expected ${run.step} as in the run that this one continues, found ${step}`);
  }
  let [done, seconds] = [0, 0];
  const advance_to = (count) => {
    const start = performance.now();
    for (; done < count; ++done) {
      run.world.step();
    }
    seconds += (performance.now() - start) / 1000;
  };
  const reported = report.map((count) => {
    advance_to(count);
    return states(run);
  });
  advance_to(steps);
  return { states: reported, seconds };
}

function restore(run) {
  if (!run.saved) {
    throw new Error('restore: nothing was saved in this run');
  }
  run.world.restore(run.saved);
}

function answer({ cmd, ...request }, run) {
  switch (cmd) {
    case 'run':
      if (request.scene === undefined && !run.world) {
        throw new Error('scene: is missing, and there is no run to continue');
      }
      return advance(run, request);
    case 'save':
    case 'restore':
      if (!run.engine.restores || !run.world) {
        throw new Error(`${cmd}: ${run.world ? 'this engine cannot do so' : 'there is no run'}`);
      }
      return cmd === 'save' ? void (run.saved = run.world.save()) : restore(run);
    default:
      throw new Error(`cmd: expected 'start', 'run', 'save', 'restore' or 'stop', found '${cmd}'`);
  }
}

function reply({ id, ...request }, run) {
  try {
    return { id, ...answer(request, run) };
  } catch (error) {
    return { id, [error.is_skip ? 'skipped' : 'error']: error.message ?? String(error) };
  }
}

// JSON has no NaN and no infinity.
const text = (json) => JSON.stringify(json, (_, x) =>
  typeof x !== 'number' || Number.isFinite(x) ? x : Number.isNaN(x) ? 'nan' : x > 0 ? 'inf' : '-inf');

/**
 * Serves an engine that steps in time, with the setting on the command line: `[configured|as-shipped]`. `engine` has
 * the fields name, version, precision, and if they apply cannot, planar and restores. Its function `make(scene, step,
 * configured)` returns a world with step(), read(i), mass(i), free(), and if the engine restores, save() and
 * restore(saved).
 */
export async function serve_runs(engine) {
  const [setting = 'configured', ...rest] = process.argv.slice(2);
  if (!['configured', 'as-shipped'].includes(setting) || rest.length > 0) {
    console.error(`expected [configured|as-shipped], found ${process.argv.slice(2).join(' ')}`);
    process.exit(2);
  }
  const configured = setting === 'configured';
  const { version, precision, cannot, planar, restores } = engine;
  const name = engine.name + (configured ? '' : '-as-shipped');
  const abilities = { time: true, cannot, planar, restores };
  const introduction = { protocol: 1, name, version, precision, model: 'coulomb', ...abilities };
  const run = { engine, configured };
  await answer_requests((request) => text(request.cmd === 'start' ? introduction : reply(request, run)));
}
