// Types of lunoid.js, the machine in a page.

/** Numbers with a name and a shape, the last axis fastest. */
export interface Plane {
  name: string;
  dtype: "u8" | "u16" | "u32" | "i32" | "f32" | "f64";
  shape: number[];
  values: Uint8Array | Uint16Array | Uint32Array | Int32Array | Float32Array | Float64Array;
}

/** A plane that is sent; of bytes alone, type and shape may be left out. */
export interface SentPlane {
  name: string;
  dtype?: Plane["dtype"];
  shape?: number[];
  values: Plane["values"];
}

/** One fault of a file or a request. */
export interface Problem {
  file: string;
  line: number | null;
  column: number | null;
  key: string | null;
  title: string;
  found: string | null;
  expected: string | null;
  help: string | null;
}

/** Where the vehicle is: metres in the frame of the scenario, angles in degrees. */
export interface Pose {
  x_m: number;
  y_m: number;
  z_m: number;
  heading_deg: number;
  pitch_deg: number;
  roll_deg: number;
  time_s?: number;
  yoke_deg?: number;
}

/** What a home does. Milliseconds of a request are those of the page's clock; memory is in bytes, null where the home does not know it. */
export type Progress =
  | { phase: "loading"; bytes: number; total: number | null }
  | { phase: "compiled" | "ready" }
  | { phase: "working" | "restoring"; do: string }
  | { phase: "idle"; do: string; milliseconds: number; memory: number | null }
  | { phase: "ended"; reason: string };

export interface RequestOptions {
  /** Gives the request up. A request under way ends the worker; a new one has the state before the request. */
  signal?: AbortSignal;
}

/** Whoever answers requests of lunoid.loop/1: a worker of the page, or a program at the other end of a socket. */
export interface Home {
  request(header: object, planes?: SentPlane[], options?: RequestOptions): Promise<{ header: object; planes: Plane[] }>;
  close(): void;
}

/** The home in the browser alone. */
export class WorkerHome implements Home {
  constructor(options?: { module?: URL | string; hear?: (progress: Progress) => void });
  request(header: object, planes?: SentPlane[], options?: RequestOptions): Promise<{ header: object; planes: Plane[] }>;
  close(): void;
  /** Makes the module panic, for tests. Rejects with an `EndedError`. */
  fail(): Promise<never>;
}

/** The home in the program that serves the page. */
export class SocketHome implements Home {
  constructor(options?: { address?: URL | string; hear?: (progress: Progress) => void });
  request(header: object, planes?: SentPlane[], options?: RequestOptions): Promise<{ header: object; planes: Plane[] }>;
  close(): void;
}

/** All faults of files or of a request, at once. The machine is as it was before. */
export class LunoidError extends Error {
  constructor(problems: Problem[]);
  readonly problems: Problem[];
}

/** Whoever answered has ended; the next one has the state before the request. */
export class EndedError extends Error {}

/** What is known of an opened scenario without drawing. */
export interface Facts {
  scenario: string;
  title: string;
  drawn_by: string;
  frames: number;
  columns: number;
  lines: number;
  sweeps: number;
  samples: number;
  /** From one sample of a sweep to the next (µs); the first is the start of the sweep. */
  sample_us: number;
  update_hz: number;
  remembers_frames: boolean;
  remarks: string[];
  set: Record<string, string>;
  driven: number;
}

export interface Seen {
  frame: number;
  pose: Pose;
  /** BLAKE3 of the pixels, as `run.json` of `lunoid replay` has it. */
  hash: string;
}

/** A place where a condition is met. Instants are in samples of the sweep, or lines of the display. */
export interface Place {
  sweep: number;
  sample: number;
  instant: number;
  instant_us: number | null;
  range_m: number | null;
  values: Record<string, number>;
  pixel: [number, number] | null;
  is_blanked: boolean;
}

export type Planes = { planes: Record<string, Plane> };
export type Setting = number | string | boolean | null;

export interface Wishes {
  machine?: string | null;
  overlays?: string[];
  channel?: string | null;
  set?: Record<string, Setting>;
}

/** Which frame is meant: one of the path, one from a pose, or the last of the loop where both are left out. */
export interface Which {
  frame?: number;
  pose?: Pose;
}

/** The machine. Every method rejects with a `LunoidError`, an `EndedError`, or the reason of an aborted signal. */
export class Lunoid {
  constructor(home?: Home);
  request(header: object, planes?: SentPlane[], options?: RequestOptions): Promise<any>;
  hello(options?: RequestOptions): Promise<any>;
  /** `files` maps names to contents; `scenario` is such a name, with at least one folder. */
  open(scenario: string, options?: Wishes & RequestOptions & { files?: Record<string, string | ArrayBuffer | Uint8Array> }): Promise<Facts & Planes>;
  frame(frame: number, options?: RequestOptions & { planes?: string[] }): Promise<Seen & Planes>;
  look(pose: Pose, options?: RequestOptions & { frame?: number; planes?: string[] }): Promise<Seen & Planes>;
  step(pose: Pose, options?: RequestOptions & { planes?: string[] }): Promise<Seen & Planes>;
  ahead(way?: { pose?: Pose; metres?: number; turn_deg?: number }, options?: RequestOptions): Promise<{ pose: Pose } & Planes>;
  /** `sweeps` is one sweep, or the first and the one after the last. */
  probe(signals: string[], sweeps: number | [number, number], options?: Which & RequestOptions): Promise<any>;
  explain(column: number, line: number, options?: Which & RequestOptions): Promise<any>;
  set(set?: Record<string, Setting>, options?: Omit<Wishes, "set"> & RequestOptions): Promise<Facts & Planes>;
  events(options?: Which & RequestOptions & { sweeps?: number | [number, number]; unit?: string[]; event?: string[]; colour?: string[]; level?: string; from?: number; to?: number; limit?: number }): Promise<any>;
  /** `sweeps` and `samples` are one, or the first and the one after the last; `after` is an instant of the first sweep, in samples. */
  trigger(on: string, options?: Which & RequestOptions & { sweeps?: number | [number, number]; samples?: number | [number, number]; after?: number; limit?: number }): Promise<{ frame: number; places: Place[]; sweeps: number } & Planes>;
  effect(late: string, options?: Which & RequestOptions): Promise<any>;
  timing(options?: Which & RequestOptions): Promise<{
    frame: number;
    folds: number | null;
    late_words: number | null;
    missed: number;
    deadlines: { name: string; count: number; missed: number; least_slack_us: number | null }[];
  } & Planes>;
  omissions(options?: RequestOptions): Promise<any>;
  signals(options?: RequestOptions): Promise<any>;
  blocks(options?: RequestOptions): Promise<any>;
  parameters(options?: RequestOptions): Promise<any>;
  faults(options?: RequestOptions): Promise<any>;
  state(options?: RequestOptions & { frames?: number }): Promise<Plane>;
  restore(state: Plane, options?: RequestOptions): Promise<Facts & Planes>;
  record(name?: string, options?: RequestOptions): Promise<any>;
  close(): void;
}
