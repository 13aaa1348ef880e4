// Object space as the server sends it: a head, then arrays one after the other.

export interface Head {
  origin: [number, number, number];
  extent: number;
  unit: string;
  basis: number[];
  arrays: { name: string; kind: "f4" | "u1" | "u2" | "u4"; shape: number[] }[];
  image_ids: string[];
  names: string[];
  total: number;
  /** Common points below which a connection is weak, and from which on it is strong. */
  few: number;
  strong: number;
}

type Numbers = Float32Array<ArrayBuffer> | Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;
const KIND = { f4: Float32Array, u1: Uint8Array, u2: Uint16Array, u4: Uint32Array };

export class SpaceData {
  readonly head: Head;
  readonly xyz: Float32Array<ArrayBuffer>;
  readonly role: Uint8Array<ArrayBuffer>;
  readonly rays: Uint16Array<ArrayBuffer>;
  readonly sigma: Float32Array<ArrayBuffer>;
  readonly w: Float32Array<ArrayBuffer>;
  /** Smallest redundancy number of its image observations, and the root mean square of their residuals in px. */
  readonly r: Float32Array<ArrayBuffer>;
  readonly v: Float32Array<ArrayBuffer>;
  readonly centre: Float32Array<ArrayBuffer>;
  /** Each image: centre and four corners. */
  readonly frusta: Float32Array<ArrayBuffer>;
  readonly ellipsoid: Uint32Array<ArrayBuffer>;
  readonly axes: Float32Array<ArrayBuffer>;
  readonly bars: Uint32Array<ArrayBuffer>;
  /** Pairs of images that share points, and how many; most first. */
  readonly pairs: Uint32Array<ArrayBuffer>;
  readonly common: Uint32Array<ArrayBuffer>;
  private rows: Map<string, number> | null = null;

  constructor(buffer: ArrayBuffer) {
    const length = new DataView(buffer).getUint32(0, true);
    this.head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))) as Head;
    const found = new Map<string, Numbers>();
    let at = 4 + length;
    for (const { name, kind, shape } of this.head.arrays) {
      const type = KIND[kind];
      const count = shape.reduce((a, b) => a * b, 1);
      found.set(name, new type(buffer, at, count) as Numbers);
      at += Math.ceil((count * type.BYTES_PER_ELEMENT) / 4) * 4;
    }
    const of = <T extends Numbers>(name: string, empty: T): T => (found.get(name) as T | undefined) ?? empty;
    this.xyz = of("xyz", new Float32Array(0));
    this.role = of("role", new Uint8Array(0));
    this.rays = of("rays", new Uint16Array(0));
    this.sigma = of("sigma", new Float32Array(0));
    this.w = of("w", new Float32Array(0));
    this.r = of("r", new Float32Array(0));
    this.v = of("v", new Float32Array(0));
    this.centre = of("centre", new Float32Array(0));
    this.ellipsoid = of("ellipsoid_of", new Uint32Array(0));
    this.axes = of("ellipsoid", new Float32Array(0));
    this.bars = of("bars", new Uint32Array(0));
    this.pairs = of("pair", new Uint32Array(0));
    this.common = of("common", new Uint32Array(0));
    this.frusta = this.pyramids(of("frustum", new Float32Array(0)));
  }

  private pyramids(corners: Float32Array): Float32Array<ArrayBuffer> {
    const out = new Float32Array(5 * this.centre.length);
    for (let k = 0; k < this.centre.length / 3; k++) {
      out.set(this.centre.subarray(3 * k, 3 * k + 3), 15 * k);
      out.set(corners.subarray(12 * k, 12 * k + 12), 15 * k + 3);
    }
    return out;
  }

  get points(): number {
    return this.role.length;
  }

  nameOf(row: number): string {
    return this.head.names[row] ?? "";
  }

  rowOf(name: string): number | undefined {
    this.rows ??= new Map(this.head.names.map((n, k) => [n, k]));
    return this.rows.get(name);
  }

  centreOf(image: string): Float32Array | null {
    const k = this.head.image_ids.indexOf(image);
    return k < 0 ? null : this.centre.subarray(3 * k, 3 * k + 3);
  }

  at(row: number): Float32Array {
    return this.xyz.subarray(3 * row, 3 * row + 3);
  }
}
