// Colours of points: by role, by number of rays (the classes of the report's maps), by standard deviation.
import { Color } from "three";
import { Network } from "./data";

export interface Colouring {
  rgb: Float32Array<ArrayBuffer>;
  legend: [string, string][];
}

const ROLE_COLOURS = ["#5b7c99", "#c0392b", "#2e8b57"];
const RAY_CLASSES: [number, number, string, string][] = [
  [0, 2, "#c4562b", "2 rays or fewer"],
  [3, 3, "#e0a84f", "3 rays"],
  [4, 5, "#8fb58a", "4 to 5"],
  [6, 9, "#3f8fa6", "6 to 9"],
  [10, Infinity, "#234b7a", "10 and more"],
];
const SIGMA_COLOURS = ["#234b7a", "#3f8fa6", "#8fb58a", "#e0a84f", "#c4562b"];

function rgb(hex: string): [number, number, number] {
  const n = parseInt(hex.slice(1), 16);
  // vertex colours are linear, the legend is not
  const c = new Color(n);
  return [c.r, c.g, c.b];
}

export function byRole(net: Network): Colouring {
  const colours = ROLE_COLOURS.map(rgb);
  const names = ["tie points", "control points", "check points"];
  const present = names.map((_, k) => net.role.includes(k));
  return {
    rgb: filled(net.points, (i) => colours[Math.min(net.role[i], 2)]),
    legend: names.map((n, k): [string, string] => [ROLE_COLOURS[k], n]).filter((_, k) => present[k]),
  };
}

export function byRays(net: Network): Colouring {
  const colours = RAY_CLASSES.map(([, , c]) => rgb(c));
  const classOf = (n: number) => RAY_CLASSES.findIndex(([low, high]) => n >= low && n <= high);
  return {
    rgb: filled(net.points, (i) => colours[classOf(net.rays[i])]),
    legend: RAY_CLASSES.map(([, , c, words]): [string, string] => [c, words]),
  };
}

export function bySigma(net: Network): Colouring | null {
  return classes(Array.from({ length: net.points }, (_, i) => net.sigmaOf(i)), net.packed.sigmaUnit, "sigma");
}

/** Colours of the object's triangles: of a coordinate's standard deviation there. */
export function bySurface(net: Network): Colouring | null {
  const found = classes([...net.surfaceSigma], net.packed.sigmaUnit, "sigma of a coordinate");
  const unseen = net.surfaceSigma.some((s) => !(s >= 0));
  if (found && unseen) found.legend.push(["#999999", "seen by less than two images"]);
  return found;
}

function classes(all: number[], scale: string, what: string): Colouring | null {
  const known = all.filter((s) => s >= 0).sort((a, b) => a - b);
  if (!known.length) return null;
  // five classes of equal number: the spread of sigmas is too wide for a linear scale
  const limits = [0.2, 0.4, 0.6, 0.8].map((q) => known[Math.floor(q * (known.length - 1))]);
  const colours = SIGMA_COLOURS.map(rgb);
  const name = (s: number) => `${s.toPrecision(2)} ${scale}`;
  return {
    rgb: filled(all.length, (i) => (all[i] >= 0 ? colours[limits.filter((l) => all[i] > l).length] : [0.6, 0.6, 0.6])),
    legend: SIGMA_COLOURS.map((c, k): [string, string] => [
      c,
      k === 0 ? `${what} up to ${name(limits[0])}` : k === 4 ? `above ${name(limits[3])}` : `to ${name(limits[k])}`,
    ]),
  };
}

function filled(n: number, colour: (i: number) => [number, number, number]): Float32Array<ArrayBuffer> {
  const out = new Float32Array(3 * n);
  for (let i = 0; i < n; i++) out.set(colour(i), 3 * i);
  return out;
}
