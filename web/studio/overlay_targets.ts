// Targets over a photograph: the ellipse of a dot or the place of a corner, what it is called, how precise it is.
import { COLOUR } from "./looks";
import { fixed } from "./numbers";
import { label, twice } from "./overlay";
import { Fate, TargetsOf } from "./types";
import { View } from "./view";

type Pen = CanvasRenderingContext2D;
type Target = TargetsOf["rows"][number];
type Box = [left: number, top: number, width: number, height: number];
const FULL = 2 * Math.PI;
const MOST_LABELS = 400;
/** Semi-axis of the smallest ones on the screen. */
const LEAST = 5;
export const FATES: [fate: Fate, colour: string, shape: string][] = [
  ["used", COLOUR.used, "◯"], ["rejected", COLOUR.rejected, "⊗"], ["apart", COLOUR.check, "◌"], ["unidentified", COLOUR.weak, "◍"],
];
const DASH: Record<Fate, number[]> = { used: [], rejected: [], apart: [6, 4], unidentified: [2, 3] };

export function drawTargets(pen: Pen, view: View, shown: TargetsOf): void {
  const turned = Math.atan2(view.sin, view.cos);
  const seen = shown.rows.filter((t) => {
    const [u, v] = view.toScreen(t.x, t.y);
    return u > -40 && v > -40 && u < view.width + 40 && v < view.height + 40;
  });
  for (const [fate, colour] of FATES) for (const t of seen.filter((s) => s.fate === fate)) drawTarget(pen, view, t, colour, turned);
  const labels: Box[] = [];
  for (const [fate, colour] of FATES)
    for (const t of seen.filter((s) => s.fate === fate)) {
      const [u, v] = view.toScreen(t.x, t.y);
      const precise = view.scale > 1.5 && t.s !== null ? ` ± ${fixed(t.s, 3)} px` : "";
      const words = `${t.name}${precise}`;
      const up = semiAxis(t, view) + 9; // above its target, where no other one of its row stands
      if (words && labels.length < MOST_LABELS && free(labels, [u - 5, v - up - 7, 7.6 * words.length, 14])) label(pen, words, u - 5, v - up, colour);
    }
}

const semiAxis = (t: Target, view: View): number => Math.max((t.ellipse?.a ?? 0) * view.scale, LEAST);

function drawTarget(pen: Pen, view: View, t: Target, colour: string, turned: number): void {
  const [u, v] = view.toScreen(t.x, t.y);
  const a = semiAxis(t, view);
  pen.setLineDash(DASH[t.fate]);
  pen.beginPath();
  if (t.ellipse) pen.ellipse(u, v, a, (a * t.ellipse.b) / t.ellipse.a, (t.ellipse.angle_deg * Math.PI) / 180 + turned, 0, FULL);
  else pen.rect(u - a, v - a, 2 * a, 2 * a);
  twice(pen, colour, 1.8);
  pen.setLineDash([]);
  if (t.fate === "rejected") cross(pen, u, v, a + 3, colour);
  else if (view.scale > 1) cross(pen, u, v, 3, colour);
}

/** Whether a label lies over none of those that are there; it is then one of them. */
function free(labels: Box[], box: Box): boolean {
  const [x, y, w, h] = box;
  if (labels.some(([p, q, r, s]) => x < p + r && p < x + w && y < q + s && q < y + h)) return false;
  labels.push(box);
  return true;
}

function cross(pen: Pen, u: number, v: number, r: number, colour: string): void {
  pen.beginPath();
  pen.moveTo(u - r, v - r);
  pen.lineTo(u + r, v + r);
  pen.moveTo(u + r, v - r);
  pen.lineTo(u - r, v + r);
  twice(pen, colour, 1.2);
}
