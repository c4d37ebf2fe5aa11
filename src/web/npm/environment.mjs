// SPDX-License-Identifier: BSL-1.0
import { readFileSync } from 'node:fs';
import * as os from 'node:os';

function system_name() {
  try {
    return /^PRETTY_NAME="?([^"\n]*)/m.exec(readFileSync('/etc/os-release', 'utf8'))[1];
  } catch {
    return os.version();
  }
}

export function processor_threads() {
  return os.availableParallelism?.() ?? os.cpus().length;
}

/** The facts about this machine that a report states. */
export function this_environment() {
  return {
    operating_system: system_name(),
    kernel: `${os.type()} ${os.release()} ${os.machine?.() ?? os.arch()}`,
    processor: os.cpus()[0]?.model ?? '',
    processor_threads: processor_threads(),
    date: new Date().toISOString().replace(/\.\d+Z$/, 'Z'),
  };
}
