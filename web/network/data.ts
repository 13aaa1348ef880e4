// What the page carries: arrays as base64 of little-endian bytes, lengths relative to `origin` in object units.

/** Classes of standard deviations: limits of all but the last, and colours with words; no colour: a heading. */
export interface Classes {
  limits: number[];
  colours: string[];
  legend: [string, string][];
}

export interface Packed {
  unit: string;
  sigmaUnit: string;
  decimals: number;
  origin: [number, number, number];
  extent: number;
  basis: number[];
  points: { id: string[]; xyz: string; role: string; rays: string; sigma: string; starts: string; seen: string };
  images: { id: string[]; frusta: string; size: number; words?: string[]; proposed?: number[] };
  ellipsoids: { point: string; axes: string; enlarged: number };
  bars: string;
  surface: { xyz: string; sigma: string } | null;
  /** Dense points: places in steps from a corner, colours, reference photographs, standard deviations along the rays. */
  cloud?: { low: number[]; step: number; xyz: string; rgb: string; image: string; sigma: string; names: string[] } | null;
  classes: { points: Classes | null; surface: Classes | null; cloud?: Classes | null };
  /** Texts of the script in the reader's language by name, and its decimal sign. */
  words: Record<string, string>;
  decimal: string;
}

export const ROLES = ["tie", "control", "check"] as const;

function bytes(text: string): ArrayBuffer {
  const raw = atob(text);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) out[i] = raw.charCodeAt(i);
  return out.buffer;
}

export const floats = (text: string): Float32Array<ArrayBuffer> => new Float32Array(bytes(text));
export const words32 = (text: string): Uint32Array<ArrayBuffer> => new Uint32Array(bytes(text));
export const words16 = (text: string): Uint16Array<ArrayBuffer> => new Uint16Array(bytes(text));
export const words8 = (text: string): Uint8Array<ArrayBuffer> => new Uint8Array(bytes(text));

export class Network {
  readonly xyz: Float32Array<ArrayBuffer>;
  readonly role: Uint8Array<ArrayBuffer>;
  readonly rays: Uint16Array<ArrayBuffer>;
  readonly sigma: Float32Array<ArrayBuffer>;
  readonly starts: Uint32Array<ArrayBuffer>;
  readonly seen: Uint32Array<ArrayBuffer>;
  readonly frusta: Float32Array<ArrayBuffer>;
  readonly ellipsoid: Uint32Array<ArrayBuffer>;
  readonly axes: Float32Array<ArrayBuffer>;
  readonly bars: Uint32Array<ArrayBuffer>;
  /** Corners of the object's triangles, nine numbers each, and the standard deviation of each triangle. */
  readonly surface: Float32Array<ArrayBuffer>;
  readonly surfaceSigma: Float32Array<ArrayBuffer>;
  /** Dense points. */
  readonly cloud: Float32Array<ArrayBuffer>;
  readonly cloudColour: Uint8Array<ArrayBuffer>;
  readonly cloudImage: Uint16Array<ArrayBuffer>;
  readonly cloudSigma: Float32Array<ArrayBuffer>;

  constructor(readonly packed: Packed) {
    this.xyz = floats(packed.points.xyz);
    this.role = words8(packed.points.role);
    this.rays = words16(packed.points.rays);
    this.sigma = floats(packed.points.sigma);
    this.starts = words32(packed.points.starts);
    this.seen = words32(packed.points.seen);
    this.frusta = floats(packed.images.frusta);
    this.ellipsoid = words32(packed.ellipsoids.point);
    this.axes = floats(packed.ellipsoids.axes);
    this.bars = words32(packed.bars);
    this.surface = floats(packed.surface?.xyz ?? "");
    this.surfaceSigma = floats(packed.surface?.sigma ?? "");
    const steps = words16(packed.cloud?.xyz ?? "");
    this.cloud = new Float32Array(steps.length);
    for (let k = 0; k < steps.length; k++) this.cloud[k] = packed.cloud!.low[k % 3] + packed.cloud!.step * steps[k];
    this.cloudColour = words8(packed.cloud?.rgb ?? "");
    this.cloudImage = words16(packed.cloud?.image ?? "");
    this.cloudSigma = floats(packed.cloud?.sigma ?? "");
    // corners lie one object unit from the centre; bring them to the drawn size
    const size = packed.images.size;
    for (let k = 0; k < this.frusta.length; k += 15)
      for (let j = 3; j < 15; j++) {
        const c = this.frusta[k + (j % 3)];
        this.frusta[k + j] = c + (this.frusta[k + j] - c) * size;
      }
  }

  get points(): number {
    return this.role.length;
  }

  get images(): number {
    return this.frusta.length / 15;
  }

  /** Images that are to be taken yet, where others were. */
  get proposed(): number[] {
    return this.packed.images.proposed ?? [];
  }

  /** Corners of some images, fifteen numbers each. */
  frustaOf(rows: number[]): Float32Array<ArrayBuffer> {
    const out = new Float32Array(15 * rows.length);
    rows.forEach((i, k) => out.set(this.frusta.subarray(15 * i, 15 * i + 15), 15 * k));
    return out;
  }

  imagesOf(point: number): Uint32Array {
    return this.seen.subarray(this.starts[point], this.starts[point + 1]);
  }

  /** Standard deviation of a coordinate of a point, root mean square of the three, or NaN. */
  sigmaOf(point: number): number {
    return Math.hypot(this.sigma[3 * point], this.sigma[3 * point + 1], this.sigma[3 * point + 2]) / Math.sqrt(3);
  }

  coordinates(point: number): string {
    const { origin, decimals } = this.packed;
    return this.listed([0, 1, 2].map((a) => (this.xyz[3 * point + a] + origin[a]).toFixed(decimals)));
  }

  /** A text of the page in the reader's language. */
  say(name: string): string {
    return this.packed.words[name] ?? name;
  }

  /** Numbers in a row, as they are written. */
  listed(numbers: string[]): string {
    const { decimal } = this.packed;
    return numbers.map((n) => n.replace(".", decimal)).join(decimal === "," ? "; " : ", ");
  }
}
