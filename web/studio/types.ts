// What the server sends and takes; pixels are those of the files as stored.

export type Role = "tie" | "control" | "check";
export type How = "hand" | "ellipse" | "corner" | "cross" | "patch" | "file";
export type SnapKind = "auto" | "ellipse" | "corner" | "cross" | "patch" | "hand";
export type Three = [number | null, number | null, number | null];
export type Covariance = [number, number, number];

export interface ImageInfo {
  id: string;
  file: string;
  width: number;
  height: number;
  camera: string;
  oriented: boolean;
  rays: number;
  rms_px: number | null;
  p_wrong: number | null;
  turn: number;
  photo: boolean;
}

export interface Mark {
  image: string;
  point: string;
  x: number;
  y: number;
  cov: Covariance;
  how: How;
  quality: number | null;
  clicked: [number, number] | null;
}

/** A fiducial mark of a scan of film. */
export interface Fiducial {
  image: string;
  name: string;
  x: number;
  y: number;
  cov: Covariance;
  how: How;
}

export interface State {
  seq: number;
  can_undo: number;
  can_redo: number;
  marks: Mark[];
  points: { point: string; role: Role; xyz: Three; sigma: Three }[];
  bars: { start: string; end: string; length: number; sigma: number }[];
  lines: { line: string; kind: string; points: string[]; sigma: number }[];
  fiducials: Fiducial[];
  datum: { origin: string; axis: string; plane: string } | null;
  rejected: [string, string][];
  renamed: Record<string, string>;
  masks: { mask: string; image: string; camera: boolean; polygon: [number, number][] }[];
  drawings: { drawing: string; kind: "line" | "area"; corners: [number, number][]; layer: string; note: string; surface: string }[];
}

/** How far the photographs are oriented, and what the others lack. */
export interface Standing {
  oriented: number;
  images: number;
  line: string[];
  words: string[];
  trouble: string;
  lacking: { image: string; other: string; kind: string; have: number; need: number; words: string }[];
  wrong: { point: string; images: string[]; words: string }[];
}

export interface Overview {
  /** How often the folder was read anew: images may have other numbers then. */
  times: number;
  title: string;
  kind: string;
  path: string;
  unit: string;
  free_scale: boolean;
  sigma0: number | null;
  redundancy: number | null;
  neglected: string;
  headline: string;
  grade: string;
  images: ImageInfo[];
  points: number;
  observations: number;
  state: State;
  standing: Standing;
  report: boolean;
  /** The folder of masks that the project's run was given; "": none. */
  masks_given: string;
  /** Names of the fiducial marks, where the photographs are scans of film. */
  fiducials: string[];
}

export interface Observations {
  point: string[];
  x: number[];
  y: number[];
  vx: (number | null)[];
  vy: (number | null)[];
  w: (number | null)[];
  s: number[];
  rays: number[];
  role: number[];
  rejected: string[];
}

export interface Prediction {
  image: string;
  x: number | null;
  y: number | null;
  ellipse: { a: number; b: number; angle_deg: number } | null;
  inside: boolean;
  segment: [number, number][] | null;
  segment_sigma_px: number | null;
  why: string;
  neglected: string;
}

export interface Predictions {
  point: string;
  located: {
    xyz: [number, number, number] | null;
    sigma: [number, number, number] | null;
    source: string;
    rays: number;
    neglected: string;
    residuals: Record<string, [number, number]>;
  };
  /** Images whose marks of the point are mistaken, or may be. */
  off: string[];
  predictions: Prediction[];
  visible: { image: string; x: number; y: number; angle_deg: number; distance: number }[];
}

export type Snapped =
  | { x: number; y: number; cov: Covariance; how: How; quality: number | null }
  | { why: string };

export interface ActionAnswer {
  seq: number;
  state: State;
  command: string;
  /** How far a mark lies from where the others see its point; null where nothing tests it. */
  test?: { words: string; off: boolean } | null;
}

export interface Worst {
  kind: "w" | "sigma" | "rays";
  point: string;
  image: string;
  value: number;
}

export interface PointRow {
  point: string;
  role: Role;
  xyz: Three;
  sigma: Three;
  rays: number;
  w: number | null;
}

export interface ObservationRow {
  image: string;
  point: string;
  x: number;
  y: number;
  vx: number | null;
  vy: number | null;
  w: number | null;
  /** The smaller redundancy number of x and y. */
  r: number | null;
  rejected: string;
}

/** Two images that share points. */
export interface PairRow {
  image: string;
  other: string;
  common: number;
  base: number | null;
}

export interface Page<Row> {
  total: number;
  rows: Row[];
}

export interface JournalEntry {
  seq: number;
  time: string;
  author: string;
  verb: string;
  arguments: Record<string, unknown>;
  command: string;
}

// --- what is decided ---------------------------------------------------------------------------------

export type Choice = "auto" | "free" | "held";
export type Quantity = "w" | "sigma" | "rays" | "redundancy";

export interface OptionField {
  name: string;
  flag: string;
  kind: "choice" | "flag" | "number" | "names" | "words" | "text";
  help: string;
  choices: string[];
  whole: boolean;
  low: number | null;
  high: number | null;
  metavar: string;
  value: string | number | boolean | null;
  default: string | number | boolean | null;
}

export interface OptionForm {
  fields: OptionField[];
  command: string;
}

export interface RunStage {
  title: string;
  state: "waiting" | "at work" | "done" | "kept" | "not needed";
  seconds: number | null;
  summary: string;
}

/** A run of stages as it stands. */
export interface Run {
  name: string;
  command: string;
  outcome: "running" | "done" | "stopped" | "failed";
  words: string;
  seconds: number;
  step: string;
  share: number;
  left_s: number | null;
  stopping: boolean;
  stages: RunStage[];
}

/** What became of a target in the block. */
export type Fate = "used" | "rejected" | "apart" | "unidentified";

export interface TargetsOf {
  image: string;
  families: string;
  from: string;
  why: string;
  remarks: string[];
  rows: { name: string; x: number; y: number; s: number | null; ellipse: { a: number; b: number; angle_deg: number } | null; fate: Fate }[];
}

export interface ParameterRow {
  symbol: string;
  unit: string;
  meaning: string;
  value: number | null;
  sigma: number | null;
  t: number | null;
  probability: number | null;
  effect_px: number | null;
  effect_sigma_px: number | null;
  determinability: number | null;
  correlation: { with: string; value: number; strong: boolean } | null;
  status: string;
  remark: string;
  choice: Choice;
}

export interface Interior {
  camera: string;
  image: string | null;
  parameters: ParameterRow[];
  tests: { group: string; F: number | null; probability: number | null }[];
}

export interface Criterion {
  name: Quantity;
  above: boolean;
  unit: string;
  low: number;
  high: number;
  middle: number;
  begin: number;
  whole: boolean;
  known: number;
}

export interface Selection {
  quantity: Quantity;
  limit: number;
  observations: number;
  points: number;
  marks: number;
  used: number;
  rows: [string, string][];
  all_shown: boolean;
  command: string;
}

export interface AdjustmentRow {
  number: number;
  origin: string;
  command: string;
  sigma0: number | null;
  redundancy: number | null;
  observations: number | null;
  unknowns: number | null;
  image_points: number | null;
  rejected: number | null;
  mean_std: number | null;
  noise: string;
  options: string[];
  unit: string;
  report: boolean;
  network: boolean;
  worst: { image: string; point: string; w: number; v_px: number | null }[];
  check: { points: number; rms: (number | null)[] };
  parameters: { camera: string; symbol: string; value: number | null; sigma: number | null; status: string; unit: string }[];
}

export type Live =
  | { type: "state"; state: State }
  | { type: "oriented"; seq: number }
  | { type: "progress"; stage: string; share: number }
  | { type: "run"; run: Run }
  | { type: "targets"; images: string[]; error: string; code: string }
  | { type: "adjusted"; sigma0: number | null; folder: string; error: string; code: string };

/** A file of a product. */
export interface ProductFile {
  path: string;
  name: string;
  bytes: number;
  picture: boolean;
  page: boolean;
}

export interface ProductFolder {
  folder: string;
  files: ProductFile[];
  /** How many more there are. */
  more: number;
}

export interface ProductsAnswer {
  products: string[];
  files: ProductFolder[];
  run: Run | null;
}

/** A raster: its place is x0, y0, width and height of a pixel. */
export interface ProductPicture {
  path: string;
  width: number;
  height: number;
  heights: boolean;
  /** Changes when the file is made anew. */
  stamp: string;
  place: [number, number, number, number] | null;
  system: string;
}
