// Colours of points: by role, by number of rays (the classes of the report's maps), by the classes of standard deviations
// that the page carries.
import { Color } from "three";
import { Classes, Network } from "./data";

export interface Colouring {
  rgb: Float32Array<ArrayBuffer>;
  legend: [string, string][];
}

const ROLE_COLOURS = ["#5b7c99", "#c0392b", "#2e8b57"];
const RAY_CLASSES: [number, number, string, string][] = [
  [0, 2, "#c4562b", "rays_2"],
  [3, 3, "#e0a84f", "rays_3"],
  [4, 5, "#8fb58a", "rays_4"],
  [6, 9, "#3f8fa6", "rays_6"],
  [10, Infinity, "#234b7a", "rays_10"],
];

const UNKNOWN: [number, number, number] = [0.32, 0.32, 0.32];

function rgb(hex: string): [number, number, number] {
  const n = parseInt(hex.slice(1), 16);
  // vertex colours are linear, the legend is not
  const c = new Color(n);
  return [c.r, c.g, c.b];
}

export function byRole(net: Network): Colouring {
  const colours = ROLE_COLOURS.map(rgb);
  const names = ["tie_points", "control_points", "check_points"];
  const present = names.map((_, k) => net.role.includes(k));
  return {
    rgb: filled(net.points, (i) => colours[Math.min(net.role[i], 2)]),
    legend: names.map((n, k): [string, string] => [ROLE_COLOURS[k], net.say(n)]).filter((_, k) => present[k]),
  };
}

export function byRays(net: Network): Colouring {
  const colours = RAY_CLASSES.map(([, , c]) => rgb(c));
  const classOf = (n: number) => RAY_CLASSES.findIndex(([low, high]) => n >= low && n <= high);
  return {
    rgb: filled(net.points, (i) => colours[classOf(net.rays[i])]),
    legend: RAY_CLASSES.map(([, , c, words]): [string, string] => [c, net.say(words)]),
  };
}

export function bySigma(net: Network): Colouring | null {
  return classed(net.points, (i) => net.sigmaOf(i), net.packed.classes.points);
}

/** Colours of the object's triangles: of a coordinate's standard deviation there. */
export function bySurface(net: Network): Colouring | null {
  return classed(net.surfaceSigma.length, (i) => net.surfaceSigma[i], net.packed.classes.surface);
}

/** Colours of dense points: of the photographs, by the photograph that gives them, by their standard deviations. */
export function ofCloud(net: Network): Record<string, Colouring | null> {
  const n = net.cloudImage.length;
  const linear = [...Array(256).keys()].map((v) => new Color(v << 16).r);
  const own = new Float32Array(3 * n);
  for (let k = 0; k < 3 * n; k++) own[k] = linear[net.cloudColour[k]];
  const names = net.packed.cloud?.names ?? [];
  const hues = names.map((_, k) => `#${new Color().setHSL((k * GOLDEN) % 1, 0.5, 0.36 + 0.2 * (k % 2)).getHexString()}`);
  const shades = hues.map(rgb);
  const some = names.slice(0, MOST_NAMES).map((name, k): [string, string] => [hues[k], name]);
  if (names.length > MOST_NAMES) some.push(["", "…"]);
  return {
    own: { rgb: own, legend: [] },
    photograph: { rgb: filled(n, (i) => shades[net.cloudImage[i]]), legend: some },
    sigma: classed(n, (i) => net.cloudSigma[i], net.packed.classes.cloud ?? null),
  };
}

/** Of a turn of the colour wheel from one photograph to the next, so that neighbours differ. */
const GOLDEN = 0.618034;
const MOST_NAMES = 24;

function classed(n: number, of: (i: number) => number, classes: Classes | null): Colouring | null {
  if (!classes) return null;
  const colours = classes.colours.map(rgb);
  const classOf = (s: number) => classes.limits.filter((l) => s > l).length;
  return { rgb: filled(n, (i) => (of(i) >= 0 ? colours[classOf(of(i))] : UNKNOWN)), legend: classes.legend };
}

function filled(n: number, colour: (i: number) => [number, number, number]): Float32Array<ArrayBuffer> {
  const out = new Float32Array(3 * n);
  for (let i = 0; i < n; i++) out.set(colour(i), 3 * i);
  return out;
}
