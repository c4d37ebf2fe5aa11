// SPDX-License-Identifier: BSL-1.0
import { once } from 'node:events';
import { realpathSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { isMainThread } from 'node:worker_threads';

const notNumbers = new Map([['nan', NaN], ['inf', Infinity], ['-inf', -Infinity]]);

function number(json) {
  return typeof json === 'number' ? json : notNumbers.get(json);
}

// A malformed record becomes NaN, which validate() reports.
function numbers(json, count) {
  const is_list = Array.isArray(json) || ArrayBuffer.isView(json);
  return is_list && json.length === count ? Array.from(json, number) : new Array(count).fill(NaN);
}

function read_body(json) {
  const body = {
    immovable: json.immovable === true,
    position: numbers(json.position, 3),
    velocity: numbers(json.velocity, 3),
    angular_velocity: numbers(json.angular_velocity, 3),
  };
  if (!body.immovable) {
    body.mass = number(json.mass);
    body.principal_inertia = numbers(json.principal_inertia, 3);
    body.orientation = numbers(json.orientation ?? [1, 0, 0, 0], 4);  // w, x, y, z
  }
  return body;
}

/** The collision of a record. A missing field has its default, and a malformed record becomes NaN. */
export function read_collision(json) {
  return {
    a: read_body(json.a ?? {}),
    b: read_body(json.b ?? {}),
    point: numbers(json.point, 3),
    normal: numbers(json.normal, 3),
    restitution: number(json.restitution),
    friction: number(json.friction ?? 0),
    tangential_restitution: number(json.tangential_restitution ?? 0),
  };
}

export function validate(collision) {
  const defects = [];
  const expect = (holds, field, expected) => {
    if (!holds) {
      defects.push(`${field}: expected ${expected}`);
    }
  };
  const finite = (vector, field) => expect(vector.every(Number.isFinite), field, `${vector.length} finite numbers`);
  const nonzero = (vector, field) => expect(vector.some((x) => x !== 0), field, 'a nonzero length');
  const positive = (x, field) => expect(Number.isFinite(x) && x > 0, field, 'a finite number greater than 0');
  const between = (x, low, high, field) =>
    expect(Number.isFinite(x) && x >= low && x <= high, field, `a finite number from ${low} to ${high}`);
  for (const name of ['a', 'b']) {
    const body = collision[name];
    for (const field of ['position', 'velocity', 'angular_velocity']) {
      finite(body[field], `${name}.${field}`);
    }
    if (!body.immovable) {
      positive(body.mass, `${name}.mass`);
      body.principal_inertia.forEach((moment, i) => positive(moment, `${name}.principal_inertia[${i}]`));
      finite(body.orientation, `${name}.orientation`);
      nonzero(body.orientation, `${name}.orientation`);
    }
  }
  finite(collision.point, 'point');
  finite(collision.normal, 'normal');
  nonzero(collision.normal, 'normal');
  between(collision.restitution, 0, 1, 'restitution');
  between(collision.friction, 0, Infinity, 'friction');
  between(collision.tangential_restitution, -1, 1, 'tangential_restitution');
  return defects;
}

function text_of(x) {
  if (Number.isFinite(x)) {
    return Object.is(x, -0) ? '-0.0' : String(x);
  }
  return Number.isNaN(x) ? '"nan"' : x > 0 ? '"inf"' : '"-inf"';
}

function text_of_body({ velocity, angular_velocity }) {
  return `{"velocity":[${velocity.map(text_of)}],"angular_velocity":[${angular_velocity.map(text_of)}]}`;
}

function reply_to_solve({ id, collision: json }, solve) {
  try {
    const collision = read_collision(json);
    const defects = validate(collision);
    if (defects.length > 0) {
      return JSON.stringify({ id, error: defects.join('; ') });
    }
    const { a, b } = solve(collision);
    return `{"id":${JSON.stringify(id)},"a":${text_of_body(a)},"b":${text_of_body(b)}}`;
  } catch (error) {
    return JSON.stringify({ id, error: String(error) });
  }
}

function reply(request, claims, solve) {
  switch (request.cmd) {
    case 'start':
      return JSON.stringify({ protocol: 1, ...claims });
    case 'solve':
      return reply_to_solve(request, solve);
    default:
      throw new Error(`expected the request 'start', 'solve' or 'stop', found '${request.cmd}'`);
  }
}

/**
 * Answers each request on standard input with the line `answer(request)`, until `stop` or the end of the input.
 */
export async function answer_requests(answer) {
  let rest = '';
  process.stdin.setEncoding('utf8');
  for await (const chunk of process.stdin) {
    const lines = (rest + chunk).split('\n');
    rest = lines.pop();
    const requests = lines.map((line) => JSON.parse(line));
    const stop = requests.findIndex(({ cmd }) => cmd === 'stop');
    const answered = stop < 0 ? requests : requests.slice(0, stop);
    const replies = answered.map((request) => answer(request) + '\n');
    if (!process.stdout.write(replies.join(''))) {
      await once(process.stdout, 'drain');
    }
    if (stop >= 0) {
      return;
    }
  }
}

/** The settings on the command line: `[configured|as-shipped] [frictionless|coulomb]`. The first of each is default. */
function settings() {
  const [setting = 'configured', model = 'frictionless', ...rest] = process.argv.slice(2);
  const known = ['configured', 'as-shipped'].includes(setting) && ['frictionless', 'coulomb'].includes(model);
  if (!known || rest.length > 0) {
    console.error(`expected [configured|as-shipped] [frictionless|coulomb], found ${process.argv.slice(2).join(' ')}`);
    process.exit(2);
  }
  return { configured: setting === 'configured', model };
}

function is_program(url) {
  try {
    return isMainThread && realpathSync(process.argv[1]) === fileURLToPath(url);
  } catch {
    return false;  // node runs no file
  }
}

/**
 * Serves an engine's subject, with the settings on the command line, if the module at `url` is the program that node
 * runs. `subject` returns {claims, solve} for the settings {configured, model}. `claims` has the fields name, version,
 * precision and model of the introduction. `solve` takes a valid collision and returns the velocities {a, b}.
 */
export async function serve_if_program(url, subject) {
  if (is_program(url)) {
    const { claims, solve } = subject(settings());
    await answer_requests((request) => reply(request, claims, solve));
  }
}

/** The limits of speeds that a subject of this model can declare: only if the model determines the outcome. */
export function limits(model, sizes) {
  return model === 'frictionless' ? sizes : {};
}

/** The name of an engine's subject with these settings, as `carom subjects` lists it. */
export function subject_name(engine, { configured, model }) {
  return engine + (model === 'coulomb' ? '-coulomb' : '') + (configured ? '' : '-as-shipped');
}
