// SPDX-License-Identifier: BSL-1.0
import { with_report } from '../npm/solver/report.mjs';
import { Hang, Stopped } from './remote.mjs';
import { asked_by } from './settings.mjs';

// The results of a part are kept if a later part ends early. Each report of a part takes time to read.
const cases_of_part = 1000;
const most_parts = 10;

const environment = () => ({
  operating_system: navigator.platform, kernel: '', processor: '',
  processor_threads: navigator.hardwareConcurrency ?? 1, date: `${new Date().toISOString().slice(0, 19)}Z`,
});

const is_early_end = (error) => error instanceof Hang || error instanceof Stopped;

/** Judges the parts of a run in turn. Adds the report of each finished part to `reports`. */
async function judge_parts(remote, asked, of, reports, view) {
  const subjects = [];
  for (let part = 1; part <= of; ++part) {
    remote.progress = (share) => view.progress((part - 1 + share) / of);
    remote.progress(0);
    reports.push((await remote.ask({ cmd: 'part', ...asked, part, of })).report);
    subjects.push(JSON.parse(reports.at(-1)).subjects[0]);
    view.found(subjects);
  }
  remote.progress = undefined;
  view.progress(1);
}

/** Sums the reports without the solver, so that witnesses stay as they were drawn. */
async function sum_up(remote, asked, reports, interrupted) {
  if (reports.length === 0) {
    return undefined;
  }
  await remote.fresh();
  return with_report(await remote.ask({ cmd: 'finish', ...asked, reports, interrupted }));
}

/**
 * Judges a solver's text, and tells `view` of the progress. Returns the request, the reply to `finish`, the Hang or the
 * Stopped that ended the run early, and the first defect that the solver's code threw.
 */
export async function judge_solver(remote, text, settings, view) {
  await remote.fresh();
  const asked = asked_by(settings, await remote.load(text), environment());
  const { cases } = await remote.ask({ cmd: 'plan', ...asked });
  const parts = Math.min(Math.ceil(cases / cases_of_part), most_parts, asked.options.cases);
  const reports = [];
  try {
    await judge_parts(remote, asked, parts, reports, view);
    const result = with_report(await remote.ask({ cmd: 'finish', ...asked, reports }));
    return { asked, thrown: remote.thrown, result };
  } catch (ended_by) {
    if (!is_early_end(ended_by)) {
      throw ended_by;
    }
    const { thrown } = remote;
    view.sums_up();
    return { asked, thrown, ended_by, result: await sum_up(remote, asked, reports, reports.length < parts) };
  }
}

/** The exact truth about a collision, given as the text of a file. The solver is judged on it if it is still there. */
export async function replayed(remote, { subject, options }, { text, file }) {
  await remote.open();
  return remote.ask({ cmd: 'replay', text, place: file, law: subject.model, options,
    ...(remote.has_solver && { subject }) });
}
