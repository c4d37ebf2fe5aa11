// SPDX-License-Identifier: BSL-1.0
import { processor_threads, this_environment } from './environment.mjs';
import { sorted_options } from './options.mjs';
import { introduce } from './solver/introduction.mjs';
import { UsageError } from './solver/judge.mjs';
import { local_session } from './solver/local_session.mjs';
import { with_report } from './solver/report.mjs';
import { introduction_of, source_of } from './source.mjs';
import { JudgeThread } from './threads/judge_thread.mjs';
import { this_judge } from './threads/node_judge.mjs';

const cases_of_part = 25_000;  // at most, so that an interrupted run keeps most; the sum of many parts takes long
const default_cases = 1000;

/** Asks a judge in this thread about a function. Other code of this thread runs between two requests. */
export async function asker_of_function(solve, claimed) {
  const judge = await this_judge();
  let introduced;
  try {
    introduced = introduce({ ...claimed, solve }, solve.name || 'solve');
  } catch (error) {
    throw new UsageError(error.message);
  }
  const session = local_session(introduced.solve, introduced.introduction);
  return {
    subject: introduced.introduction,
    async ask(request, progress) {
      await new Promise(setImmediate);
      Object.assign(judge, { session, progress });
      return judge(request);
    },
    end() {},
  };
}

/** Asks a judge in another thread about a module or an engine. */
export async function asker_of_module(solver, claimed, timeout) {
  const source = source_of(solver, claimed);
  const introduction = await introduction_of(source, timeout);
  const thread = new JudgeThread(source, timeout, introduction);
  return {
    subject: { ...introduction, specification: source.specification },
    ask: (request, progress) => thread.ask(request, progress),
    end: () => thread.end(),
    another: () => new JudgeThread(source, timeout, introduction),
  };
}

export function asker_of(solver, claimed, timeout) {
  return typeof solver === 'function' ? asker_of_function(solver, claimed) : asker_of_module(solver, claimed, timeout);
}

/** Counts the judged cases of all parts. If `progress` throws, keeps the error, since the judge may be at work. */
function counter(cases, progress, failed) {
  const done_in = new Map();
  const counts = {
    thrown: undefined,
    add(part, done) {
      done_in.set(part, done);
      if (counts.thrown !== undefined) {
        return;
      }
      try {
        progress?.([...done_in.values()].reduce((sum, x) => sum + x, 0), cases);
      } catch (error) {
        counts.thrown = { error };
        failed();
      }
    },
  };
  return counts;
}

/**
 * The reports of the parts that the askers judge in turn. If `signal` aborts, ends the askers, and leaves out their
 * unfinished parts.
 */
async function reports_of_parts(askers, request, cases, { signal, progress }) {
  const end_all = () => askers.forEach((asker) => asker.end());
  const counts = counter(cases, progress, end_all);
  const reports = [];
  let next = 1;
  const judge_in_turn = async (asker) => {
    while (next <= request.of && !signal?.aborted && counts.thrown === undefined) {
      const part = next++;
      const { report } = await asker.ask({ ...request, cmd: 'part', part }, (done) => counts.add(part, done));
      reports[part - 1] = report;
    }
  };
  signal?.addEventListener('abort', end_all);
  try {
    await Promise.all(askers.map(judge_in_turn));
  } catch (error) {
    if (!signal?.aborted && counts.thrown === undefined) {
      throw error;
    }
  } finally {
    signal?.removeEventListener('abort', end_all);
  }
  if (counts.thrown !== undefined) {
    throw counts.thrown.error;
  }
  return reports.filter((report) => report !== undefined);
}

async function judged(asker, sorted) {
  const { request: options, jobs = processor_threads(), signal } = sorted;
  const request = { subject: asker.subject, options: { ...options, environment: this_environment() } };
  const plan = await asker.ask({ ...request, cmd: 'plan' });
  const threads = asker.another === undefined ? 1 : jobs;
  const parts_of_thread = Math.ceil(plan.cases / (cases_of_part * threads));
  const of = Math.min(threads * parts_of_thread, options.cases ?? default_cases);
  const askers = [asker];
  while (askers.length < Math.min(threads, of)) {
    askers.push(asker.another());
  }
  let last = asker;
  try {
    const reports = await reports_of_parts(askers, { ...request, of }, plan.cases, sorted);
    const interrupted = signal?.aborted === true;
    last = interrupted && asker.another !== undefined ? asker.another() : asker;
    return with_report(await last.ask({ ...request, cmd: 'finish', reports, interrupted }));
  } finally {
    await Promise.all([...askers, last].map((one) => one.end()));
  }
}

/** Judges a solver: a function in this thread, or a module or an engine in other threads. */
export async function gate(solver, options = {}) {
  const sorted = sorted_options(options);
  const asker = await asker_of(solver, sorted.claimed, sorted.timeout);
  try {
    return await judged(asker, sorted);
  } finally {
    await asker.end();
  }
}
