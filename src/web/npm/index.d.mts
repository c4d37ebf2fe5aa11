// SPDX-License-Identifier: BSL-1.0

export type Law = 'frictionless' | 'reflection' | 'sticking' | 'rough' | 'coulomb' | 'any';
export type Precision = 'binary32' | 'binary64';
export type Vector = [number, number, number];
export type Range = [least: number | null, greatest: number | null];

/** A named domain, a text such as "size=0.1:10,plane=xy", or ranges by quantity and texts by kind. */
export type Domain = string | Record<string, Range | string>;

export interface Motion {
  position: Vector;
  velocity: Vector;
  angular_velocity: Vector;
}

export interface MovableBody extends Motion {
  immovable: false;
  mass: number;
  principal_inertia: Vector;
  /** A quaternion w, x, y, z of any length above 0. */
  orientation: [number, number, number, number];
}

export interface ImmovableBody extends Motion {
  immovable: true;
}

export type Body = MovableBody | ImmovableBody;

/** Two bodies that touch. The normal points from B to A and has any length above 0. */
export interface Collision {
  a: Body;
  b: Body;
  point: Vector;
  normal: Vector;
  restitution: number;
  friction: number;
  tangential_restitution: number;
}

type Numbers = readonly number[] | Float64Array | Float32Array;

export interface Velocities {
  velocity: Numbers;
  angular_velocity: Numbers;
}

/** The velocities after the impulse, and the collision matrix C [1/kg] if the solver shows it. */
export interface Outcome {
  a: Velocities;
  b: Velocities;
  C?: readonly Numbers[];
}

/** A solver refuses a collision if it throws an Error. */
export type Answer = Outcome | { skipped: string };
export type Solve = (collision: Collision) => Answer;

/** A function, the URL or the path of a module, or the name of an engine such as "cannon". */
export type Solver = Solve | URL | string;

/** What a solver claims. A module exports the same names. */
export interface Claims {
  law?: Law;
  precision?: Precision;
  name?: string;
  version?: string;
  domain?: Domain;
  /** Sizes of declared effects, such as { restitution_threshold: 0.5 }. */
  claims?: Record<string, number>;
  /** Whether an outcome holds the collision matrix C. */
  matrix?: boolean;
}

export interface JudgeOptions extends Claims {
  limit_ulps?: number;
  digits?: number;
  exact?: boolean;
  /** The time limit of each call of solve, in seconds. A function has none. */
  timeout?: number;
}

export interface GateOptions extends JudgeOptions {
  seed?: number | bigint | string;
  cases?: number;
  families?: string | readonly string[];
  within?: Domain;
  relations_every?: number;
  deviates?: string | readonly string[];
  /** The number of threads. A function is judged in the thread that calls. */
  jobs?: number;
  /** The directory that the report's texts name. `gate` writes no file. */
  out?: string;
  /** Ends the run early. The report holds what was judged. */
  signal?: AbortSignal;
  progress?: (done: number, all: number) => void;
}

export interface GateResult {
  /** 0: all invariants hold. 1: an invariant is violated. 2: there is no verdict. */
  status: 0 | 1 | 2;
  /** The content of report.json. */
  report: any;
  text: string;
  markdown: string;
  /** The files of the report: report.json, report.html, junit.xml and the witnesses. */
  files: { file: string; text: string }[];
}

export interface Judgement {
  violated: boolean;
  /** The verdict of each invariant that the solver claims. */
  verdicts: Record<string, any>;
  answer: any;
}

export interface Replay {
  violated: boolean;
  text: string;
  record: any;
  /** A drawing of the collision in SVG. */
  drawing: string;
}

export interface Listed {
  name: string;
  [field: string]: unknown;
}

/** Judges a solver on random collisions of all families. */
export function gate(solver: Solver, options?: GateOptions): Promise<GateResult>;

/** Judges a solver on 100 cases of each family, and throws an AssertionError with a witness if it is not sound. */
export function assertSound(solver: Solver, options?: GateOptions): Promise<GateResult>;

/** Judges a solver on one collision. */
export function judge(solver: Solver, collision: Collision, options?: JudgeOptions): Promise<Judgement>;

/**
 * Works a witness or a collision step by step in exact numbers, and judges a solver on it if one is given. `record` may
 * be text in JSON.
 */
export function replay(record: Collision | object | string, options?: JudgeOptions & {
  solver?: Solver;
  all_laws?: boolean;
  /** Use the collision of a witness as it was drawn, before shrinking. */
  drawn?: boolean;
  /** Names the collision in the text. */
  place?: string;
  /** In which related collisions lie. */
  within?: Domain;
}): Promise<Replay>;

/** The collisions that the gate draws with this seed. */
export function draw(options?: {
  family?: string;
  seed?: number | bigint | string;
  first?: number;
  count?: number;
  within?: Domain;
}): Promise<Collision[]>;

/**
 * The defects of an invalid collision, which a solver must refuse. Empty if it is valid. An absent friction or
 * tangential restitution counts as 0.
 */
export function validate(collision: Collision): string[];

export function families(): Promise<Listed[]>;
export function invariants(): Promise<Listed[]>;
export function features(): Promise<Listed[]>;
export function domains(): Promise<Listed[]>;

/** A mistake in an option, a claim or a file. */
export class UsageError extends Error {}
