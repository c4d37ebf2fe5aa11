// SPDX-License-Identifier: BSL-1.0
import assert from 'node:assert';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

import { carom, gated, installed, run, violated } from './installed.mjs';

const folder = installed();
const few = ['--cases', '4', '--families', 'generic,inelastic,immovable_b,invalid'];
const bounces = ['backward_error', 'restitution'];

function module(name, text) {
  writeFileSync(join(folder, name), text);
  return `./${name}`;
}

test('a sound solver passes', async () => {
  const { status, subject, stderr } = await gated(folder, './sound.mjs', '--cases', '4');
  assert.deepStrictEqual([status, stderr, violated(subject)], [0, '', []]);
  assert.strictEqual(subject.name, 'sound');
});

test('a wrong solver fails, and the text shows a witness', async () => {
  const { status, subject } = await gated(folder, './wrong.mjs', ...few);
  assert.deepStrictEqual([status, violated(subject), subject.name, subject.version], [1, bounces, 'wrong', '7']);
  const { status: of_text, stdout } = await carom(folder, 'gate', './wrong.mjs', ...few);
  assert.strictEqual(of_text, 1);
  assert.match(stdout, /It violates restitution[^]*N·V⁺ and −ε N·V⁻/);
});

test('npx runs the program', async () => {
  const npx = await run(folder, process.platform === 'win32' ? 'npx.cmd' : 'npx',
    'carom', 'gate', './wrong.mjs', '--cases', '2', '--families', 'elastic,generic');
  assert.strictEqual(npx.status, 1);
});

test('the number of threads changes no result', async () => {
  const of_jobs = async (jobs) => {
    const { subject } = await gated(folder, './wrong.mjs', ...few, '--jobs', jobs, '--out', `jobs${jobs}`);
    delete subject.nanoseconds_per_solve;
    const names = readdirSync(join(folder, `jobs${jobs}`, 'witnesses')).sort();
    const witnesses = names.map((name) => {
      const { replay, ...witness } = JSON.parse(readFileSync(join(folder, `jobs${jobs}`, 'witnesses', name), 'utf8'));
      return witness;
    });
    return { subject, names, witnesses };
  };
  const one = await of_jobs('1');
  assert.strictEqual(one.witnesses.length, bounces.length);
  assert.deepStrictEqual(await of_jobs('3'), one);
});

test('a seed of 64 bits gives its own cases', async () => {
  const counts = async (seed) => {
    const { stdout } = await gated(folder, './sound.mjs', ...few, '--seed', seed);
    return stdout;
  };
  const big = await counts('18446744073709551615');
  assert.match(big, /"seed": 18446744073709551615\b/);
  assert.notDeepStrictEqual(JSON.parse(big).families, JSON.parse(await counts('1')).families);
});

test('--out replaces the report and the witnesses that it lists, and nothing else', async () => {
  const out = join(folder, 'report');
  mkdirSync(join(out, 'witnesses'), { recursive: true });
  writeFileSync(join(out, 'witnesses', 'mine.energy.json'), 'mine');
  writeFileSync(join(out, 'notes.txt'), 'mine');
  await carom(folder, 'gate', './wrong.mjs', ...few, '--out', 'report');
  const witness = join(out, 'witnesses', 'wrong.restitution.json');
  assert.strictEqual(JSON.parse(readFileSync(witness, 'utf8')).invariant, 'restitution');
  assert.match(readFileSync(join(out, 'report.html'), 'utf8'), /^<!DOCTYPE html>/i);
  assert.match(readFileSync(join(out, 'junit.xml'), 'utf8'), /<testsuite/);
  const { stdout } = await carom(folder, 'gate', './sound.mjs', ...few, '--out', 'report', '--format', 'json');
  assert.strictEqual(readFileSync(join(out, 'report.json'), 'utf8'), stdout);
  assert.deepStrictEqual(readdirSync(out).sort(),
    ['junit.xml', 'notes.txt', 'report.html', 'report.json', 'witnesses']);
  assert.deepStrictEqual(readdirSync(join(out, 'witnesses')), ['mine.energy.json']);
});

test('a report of others leads to no removal of files', async () => {
  const out = join(folder, 'foreign');
  mkdirSync(join(out, 'witnesses'), { recursive: true });
  const kept = ['../precious.energy.json', 'witnesses/../../other.energy.json', 'witnesses/mine.none.json'];
  kept.forEach((file) => writeFileSync(join(out, file), 'mine'));
  const violations = [...kept, 'witnesses/old.energy.json'].map((witness) => ({ witness }));
  writeFileSync(join(out, 'witnesses', 'old.energy.json'), '{}');
  writeFileSync(join(out, 'report.json'), JSON.stringify({ carom: '0', subjects: [{ violations }] }));
  assert.strictEqual((await carom(folder, 'gate', './sound.mjs', '--cases', '4', '--out', 'foreign')).status, 0);
  assert.ok(kept.every((file) => existsSync(join(out, file))));
  assert.ok(!existsSync(join(out, 'witnesses', 'old.energy.json')));
});

test('a directory that cannot be written is an error before the run', async () => {
  writeFileSync(join(folder, 'file'), '');
  const { status, stderr } = await carom(folder, 'gate', './sound.mjs', '--out', 'file');
  assert.strictEqual(status, 2);
  assert.match(stderr, /^carom: --out: file/);
});

for (const [words, message] of [
  [['gate', './sound.mjs', '--sed', '1'], /there is no option '--sed'; did you mean '--seed'\?/],
  [['gate', './sound.mjs', '--cases', '-1'], /--cases: a value is missing; write --cases=VALUE/],
  [['gate', './sound.mjs', '--cases'], /--cases: a value is missing/],
  [['gate', './sound.mjs', '--cases', '0'], /--cases: expected an integer from 1 to 1000000000, found 0/],
  [['gate', './sound.mjs', '--digits', '3', '--limit-ulps', '4'], /digits excludes limit_ulps/],
  [['gate', './sound.mjs', '--families', 'generics'], /generics.*did you mean 'generic'\?/],
  [['gate', './sound.mjs', '--within', 'size=10:1'], /--within|within/],
  [['gate', './sound.mjs', '--deviates', 'enrgy'], /enrgy.*did you mean 'energy'\?/],
  [['gate', './sound.mjs', '--out='], /--out: expected a value, found an empty text; is a variable not set\?/],
  [['gate', './sound.mjs', '--within', ''], /--within: expected a value/],
  [['gate', ''], /SOLVER: expected a value/],
  [['replay', './absent.json', '--subject', ''], /--subject: expected a value/],
  [['gate', './absent.mjs'], /\.\/absent\.mjs: there is no such file/],
  [['gate'], /SOLVER is missing/],
  [['gate', 'canon'], /there is no engine 'canon'; did you mean 'cannon'\?/],
  [['gat'], /there is no command 'gat'; did you mean 'gate'\?/],
  [['replay', './absent.json'], /absent\.json/],
]) {
  test(`an error: carom ${words.join(' ')}`, async () => {
    const { status, stdout, stderr } = await carom(folder, ...words);
    assert.deepStrictEqual([status, stdout], [2, '']);
    assert.match(stderr, message);
  });
}

for (const [text, message] of [
  ["export const law = 'frictionles'; export const solve = () => 0;", /frictionles/],
  ["export const precision = 'binary128'; export const solve = () => 0;", /binary128/],
  ["export const claims = { slip: 1 }; export const solve = () => 0;", /slip/],
  ["export const Law = 'rough'; export const solve = () => 0;", /there is no claim 'Law'; did you mean 'law'\?/],
  ["export const domain = 'gamess'; export const solve = () => 0;", /domain: .*did you mean 'games'\?/],
  ["export const domain = { size: [1] }; export const solve = () => 0;", /domain: size: expected the least/],
  ["export const law = 'rough';", /solve: expected a function, found undefined/],
  ["export const solve = ;", /Unexpected token/],
  ["import 'no-such-package'; export const solve = () => 0;", /no-such-package/],
  ["process.exit(0);", /ended with status 0/],
]) {
  test(`an error: a module with ${text}`, async () => {
    const { status, stdout, stderr } = await carom(folder, 'gate', module('module.mjs', text), ...few);
    assert.deepStrictEqual([status, stdout], [2, '']);
    assert.match(stderr, message);
  });
}

test('a folder with the name of an engine hides no engine', async () => {
  mkdirSync(join(folder, 'cannon'));
  const { status, stderr } = await carom(folder, 'gate', 'cannon', ...few);
  assert.strictEqual(status, 2);
  assert.match(stderr, /cannon-es is not installed/);
});

test('a reader that closes the pipe keeps the exit status', { skip: process.platform === 'win32' }, async () => {
  const program = `${process.execPath} node_modules/carom/carom.mjs gate ./wrong.mjs ${few.join(' ')} --format json`;
  const { stdout } = await run(folder, 'bash', '-c', `${program} | head -c 1; echo " \${PIPESTATUS[0]}"`);
  assert.strictEqual(stdout, '{ 1\n');
});

test('a module in CommonJS is judged', async () => {
  const name = module('solver.cjs', "module.exports = { law: 'any', name: 'old', solve: ({ a, b }) => ({ a, b }) };");
  const { subject } = await gated(folder, name, '--cases', '4', '--families', 'separating');
  assert.strictEqual(subject.name, 'old');
  assert.deepStrictEqual(violated(subject), []);
});

test('a domain from a file is a domain', async () => {
  writeFileSync(join(folder, 'ranges.json'), '{ "size": [0.5, 2], "mass_ratio": [null, 10] }');
  const { stdout } = await gated(folder, './sound.mjs', ...few, '--within', 'ranges.json');
  assert.match(stdout, /"size": \[\s*0\.5,\s*2/);
});

/** Starts a long gate. Returns its process after the solver has answered many collisions. */
async function started(...more) {
  const name = module('slow.mjs', `import { solve as sound } from './sound.mjs';
    export const law = 'frictionless';
    let count = 0;
    export async function solve(collision) {
      if (++count === 30000) console.log('now');
      return sound(collision);
    }`);
  const words = ['node_modules/carom/carom.mjs', 'gate', name, '--cases', '1000000', '--jobs', '1', '--format', 'json'];
  const child = spawn(process.execPath, [...words, ...more], { cwd: folder });
  await new Promise((resolve) => child.stderr.once('data', resolve));
  return child;
}

const ended = (child) => new Promise((resolve) => child.on('close', resolve));

for (const signal of ['SIGINT', 'SIGHUP']) {
  test(`${signal} reports what was judged`, { skip: process.platform === 'win32' }, async () => {
    const child = await started();
    let stdout = '';
    child.stdout.on('data', (text) => { stdout += text; });
    child.kill(signal);
    assert.strictEqual(await ended(child), 2);
    assert.strictEqual(JSON.parse(stdout).interrupted, true);
  });
}

test('a directory that another run writes to is refused', async () => {
  const other = await started('--out', 'shared');
  const words = ['gate', './wrong.mjs', ...few, '--out', 'shared'];
  const { status, stderr } = await carom(folder, ...words);
  assert.strictEqual(status, 2);
  assert.match(stderr, /^carom: --out: another run writes to the directory shared; /);
  other.kill('SIGKILL');
  await ended(other);
  assert.strictEqual((await carom(folder, ...words)).status, 1, 'a killed run locks nothing');
  assert.deepStrictEqual(readdirSync(join(folder, 'shared')).filter((name) => name.startsWith('.')), []);
});

test('a foreign file with the name of the lock stays', async () => {
  mkdirSync(join(folder, 'occupied'));
  writeFileSync(join(folder, 'occupied', '.carom-lock-npm'), 'mine');
  const { status, stderr } = await carom(folder, 'gate', './sound.mjs', ...few, '--out', 'occupied');
  assert.strictEqual(status, 2);
  assert.match(stderr, /another run writes to the directory occupied/);
  assert.strictEqual(readFileSync(join(folder, 'occupied', '.carom-lock-npm'), 'utf8'), 'mine');
});

test('the lists', async () => {
  const { stdout } = await carom(folder, 'families', '--format', 'json');
  assert.ok(JSON.parse(stdout).some(({ name }) => name === 'near_head_on'));
  assert.match((await carom(folder, 'invariants')).stdout, /^restitution$/m);
  assert.match((await carom(folder, 'domains')).stdout, /^games$/m);
  assert.match((await carom(folder, 'features')).stdout, /a\.mass_one/);
  assert.match((await carom(folder, '--version')).stdout, /^\d+\.\d+\.\d+\n$/);
});

test('a witness is replayed', async () => {
  await carom(folder, 'gate', './wrong.mjs', ...few, '--out', 'replayed');
  const witness = join('replayed', 'witnesses', 'wrong.restitution.json');
  const alone = await carom(folder, 'replay', witness);
  assert.strictEqual(alone.status, 0);
  assert.match(alone.stdout, /frictionless, exactly/);
  const judged = await carom(folder, 'replay', witness, '--subject', './wrong.mjs');
  assert.strictEqual(judged.status, 1);
  assert.match(judged.stdout, /restitution +VIOLATED/);
  const sound = await carom(folder, 'replay', witness, '--subject', './sound.mjs', '--all-laws', '--drawn');
  assert.strictEqual(sound.status, 0);
  assert.match(sound.stdout, /rough, exactly/);
});

test('−0 is printed as it is', async () => {
  const witness = JSON.parse(readFileSync(join(folder, 'replayed', 'witnesses', 'wrong.restitution.json'), 'utf8'));
  const text = JSON.stringify({ ...witness.collision, friction: 0 }).replace('"friction":0', '"friction":-0.0');
  const files = { 'one.json': text, 'array.json': `[${text}]`, 'lines.jsonl': `${text}\n${text}` };
  for (const [file, contents] of Object.entries(files)) {
    writeFileSync(join(folder, file), contents);
    const { stdout } = await carom(folder, 'replay', file, '--format', 'json', '--subject', './sound.mjs');
    assert.match(stdout, /"friction":-0\.0\b/, file);
  }
});

test('a case is replayed by its number', async () => {
  const shown = await carom(folder, 'replay', '--family', 'generic', '--case', '0', '--subject', './wrong.mjs');
  assert.strictEqual(shown.status, 1);
  assert.match(shown.stdout, /^generic #0 of seed 1\n[^]*restitution +VIOLATED/);
  for (const words of [[], ['--case', '2'], ['--family', 'elastic'], ['a.json', '--family', 'slow', '--case', '1']]) {
    const { status, stderr } = await carom(folder, 'replay', ...words);
    assert.strictEqual(status, 2);
    assert.match(stderr, /expected FILE, or --family and --case/);
  }
});

test('a late notification ends no other wait', async () => {
  const slow = installed();
  const channel = join(slow, 'node_modules/carom/threads/channel.mjs');
  const notifies_at_once = readFileSync(channel, 'utf8');
  const notifies_late = notifies_at_once.replace('  Atomics.notify(',
    '  for (const start = performance.now(); performance.now() < start + 5;) {}\n  Atomics.notify(');
  assert.notStrictEqual(notifies_late, notifies_at_once);
  writeFileSync(channel, notifies_late);
  const { status, subject } = await gated(slow, './sound.mjs', '--cases', '50', '--families', 'generic,slow,elastic',
    '--deviates', 'invalid_refused,immovable_untouched');
  assert.deepStrictEqual([status, violated(subject)], [0, []]);
});
