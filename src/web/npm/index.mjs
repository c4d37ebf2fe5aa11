// SPDX-License-Identifier: BSL-1.0
import { read_collision, validate as defects_of } from './engines/line_protocol.mjs';
import { this_judge } from './threads/node_judge.mjs';

export { assertSound } from './assert_sound.mjs';
export { draw } from './draw.mjs';
export { gate } from './gate.mjs';
export { judge, replay } from './replay.mjs';
export { UsageError } from './solver/judge.mjs';

export const validate = (collision) => defects_of(read_collision(Object(collision)));

const list = async (what) => (await this_judge())({ cmd: 'list', what });

export const families = () => list('families');
export const invariants = () => list('invariants');
export const features = () => list('features');
export const domains = () => list('domains');
