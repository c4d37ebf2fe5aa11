// SPDX-License-Identifier: BSL-1.0
import { read_collision } from './engines/line_protocol.mjs';
import { domain_text } from './solver/introduction.mjs';
import { this_judge } from './threads/node_judge.mjs';

/** The collisions that the gate draws of a family with this seed. */
export async function draw({ family = 'generic', seed = 1, first = 0, count = 1, within } = {}) {
  const judge = await this_judge();
  const request = { cmd: 'draw', family, seed: String(seed), first, count, within: domain_text(within) };
  return judge(request).collisions.map(read_collision);
}
