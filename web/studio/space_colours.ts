// Colours of the points of object space: by role, rays, standard deviation, test value, redundancy, residual; blue to orange, distinct to all eyes.
import { Color } from "three";
import { local, short, withUnit } from "./numbers";
import { SpaceData } from "./space_data";
import { say } from "./words";

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
  if (by === "rays") return inClasses(data.rays, [2, 3, 5, 9], [...SCALE].reverse(), [say("studio_space.few_rays"), "3", "4–5", "6–9", "≥ 10"]);
  if (by === "w") return inClasses(data.w, [1, 2, 2.6, 3.3], SCALE, classes(by, "", ["1", "2", "2.6", "3.3"]));
  if (by === "redundancy") return inClasses(data.r, [0.1, 0.3, 0.5, 0.7], [...SCALE].reverse(), classes(by, "", ["0.1", "0.3", "0.5", "0.7"]));
  if (by === "residual") return inFifths(data.v, by, "px");
  return inFifths(data.sigma, by, data.head.unit);
}

function byRole(data: SpaceData): Coloured {
  const colours = packed(ROLE_COLOURS);
  const rgb = new Uint32Array(data.points);
  for (let i = 0; i < data.points; i++) rgb[i] = colours[Math.min(data.role[i], 2)];
  const roles = ["tie", "control", "check"];
  return { rgb: new Uint8Array(rgb.buffer), legend: roles.map((role, k): [string, string] => [ROLE_COLOURS[k], say("studio_space.role", { role })]).filter((_, k) => data.role.includes(k)) };
}

/** Five classes of equal number: the values are spread too wide for a linear scale. */
function inFifths(values: Float32Array, by: Colouring, unit: string): Coloured {
  const known = values.filter((s) => s > 0).sort();
  if (!known.length) return inClasses(values, [0, 0, 0, 0], SCALE, []);
  const limits = [0.2, 0.4, 0.6, 0.8].map((q) => known[Math.floor(q * (known.length - 1))]);
  return inClasses(values, limits, SCALE, classes(by, unit, limits.map((limit) => short(limit, 2))));
}

/** The classes between limits; the quantity stands with the first. */
function classes(by: Colouring, unit: string, limits: string[]): string[] {
  const named = limits.map((limit) => withUnit(local(limit), unit));
  return [say("studio_space.up_to", { by, limit: named[0] }), ...named.slice(1).map((n) => `≤ ${n}`), `> ${named[3]}`];
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
  return { rgb: new Uint8Array(rgb.buffer), legend: unknown ? [...legend, [UNKNOWN, say("studio_space.unknown")]] : legend };
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
