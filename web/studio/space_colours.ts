// Colours of the points of object space: by role, rays, standard deviation, test value, redundancy, residual; blue to orange, told apart by everybody.
import { Color } from "three";
import { short } from "./numbers";
import { SpaceData } from "./space_data";

export type Colouring = "role" | "rays" | "sigma" | "w" | "redundancy" | "residual";

export interface Coloured {
  /** Four bytes each: less to fill and to send to the graphics card than numbers. */
  rgb: Uint8Array<ArrayBuffer>;
  legend: [string, string][];
}

export const ROLE_COLOURS = ["#4f7896", "#d55e00", "#007f5f"];
const SCALE = ["#20406e", "#2f86b0", "#7fb79a", "#e69f00", "#c2410c"];
const UNKNOWN = "#9aa3ab";

export function coloured(data: SpaceData, by: Colouring): Coloured {
  if (by === "role") return byRole(data);
  if (by === "rays") return inClasses(data.rays, [2, 3, 5, 9], [...SCALE].reverse(), ["2 rays or fewer", "3", "4 to 5", "6 to 9", "10 and more"]);
  if (by === "w") return inClasses(data.w, [1, 2, 2.6, 3.3], SCALE, ["|w| up to 1", "to 2", "to 2.6", "to 3.3", "above 3.3"]);
  if (by === "redundancy") return inClasses(data.r, [0.1, 0.3, 0.5, 0.7], [...SCALE].reverse(), ["smallest redundancy number up to 0.1", "to 0.3", "to 0.5", "to 0.7", "above 0.7"]);
  if (by === "residual") return inFifths(data.v, "residual (rms)", "px");
  return inFifths(data.sigma, "sigma", data.head.unit);
}

function byRole(data: SpaceData): Coloured {
  const colours = packed(ROLE_COLOURS);
  const rgb = new Uint32Array(data.points);
  for (let i = 0; i < data.points; i++) rgb[i] = colours[Math.min(data.role[i], 2)];
  const names = ["tie points", "control points", "check points"];
  return { rgb: new Uint8Array(rgb.buffer), legend: names.map((n, k): [string, string] => [ROLE_COLOURS[k], n]).filter((_, k) => data.role.includes(k)) };
}

/** Five classes of equal number: the values are spread too wide for a linear scale. */
function inFifths(values: Float32Array, what: string, unit: string): Coloured {
  const known = values.filter((s) => s > 0).sort();
  if (!known.length) return inClasses(values, [0, 0, 0, 0], SCALE, []);
  const limits = [0.2, 0.4, 0.6, 0.8].map((q) => known[Math.floor(q * (known.length - 1))]);
  const name = (k: number) => `${short(limits[k], 2)} ${unit}`.trim();
  return inClasses(values, limits, SCALE, [`${what} up to ${name(0)}`, `to ${name(1)}`, `to ${name(2)}`, `to ${name(3)}`, `above ${name(3)}`]);
}

function inClasses(values: Float32Array | Uint16Array, limits: number[], scale: string[], words: string[]): Coloured {
  const colours = packed(scale);
  const [none] = packed([UNKNOWN]);
  const rgb = new Uint32Array(values.length);
  let unknown = false;
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    if (!(value >= 0)) unknown = true;
    let k = 0;
    while (k < limits.length && value > limits[k]) k++;
    rgb[i] = value >= 0 ? colours[k] : none;
  }
  const legend = words.map((text, k): [string, string] => [scale[k], text]);
  return { rgb: new Uint8Array(rgb.buffer), legend: unknown ? [...legend, [UNKNOWN, "not known"]] : legend };
}

/** Colours as four bytes in one number each, linear as three.js wants them. */
function packed(of: string[]): Uint32Array {
  const found = new Uint8Array(4 * of.length).fill(255);
  of.forEach((hex, k) => {
    const { r, g, b } = new Color(hex);
    found.set([r, g, b].map((v) => Math.round(255 * v)), 4 * k);
  });
  return new Uint32Array(found.buffer);
}
