// Targets over a photograph: the ellipse of a dot or the place of a corner, what it is called, how precise it is.
import { COLOUR } from "./looks";
import { label, twice } from "./overlay";
import { Fate, TargetsOf } from "./types";
import { View } from "./view";

type Pen = CanvasRenderingContext2D;
type Box = [left: number, top: number, width: number, height: number];
const FULL = 2 * Math.PI;
const MOST_LABELS = 400;
export const FATES: [Fate, string, string, string][] = [
  ["used", COLOUR.used, "◯", "target used"], ["rejected", COLOUR.rejected, "⊗", "target rejected"],
  ["not in the block", COLOUR.check, "◌", "target not in the block"], ["unidentified", COLOUR.weak, "◍", "dot without a name"],
];
const DASH: Record<Fate, number[]> = { used: [], rejected: [], "not in the block": [6, 4], unidentified: [2, 3] };

export function drawTargets(pen: Pen, view: View, shown: TargetsOf): void {
  const turned = Math.atan2(view.sin, view.cos);
  const seen = shown.rows.filter((t) => {
    const [u, v] = view.toScreen(t.x, t.y);
    return u > -40 && v > -40 && u < view.width + 40 && v < view.height + 40;
  });
  const labels: Box[] = [];
  for (const [fate, colour] of FATES)
    for (const t of seen.filter((s) => s.fate === fate)) {
      const [u, v] = view.toScreen(t.x, t.y);
      const a = Math.max((t.ellipse?.a ?? 0) * view.scale, 5);
      const b = t.ellipse ? Math.max(t.ellipse.b * view.scale, (5 * t.ellipse.b) / t.ellipse.a) : a;
      pen.setLineDash(DASH[fate]);
      pen.beginPath();
      if (t.ellipse) pen.ellipse(u, v, a, b, (t.ellipse.angle_deg * Math.PI) / 180 + turned, 0, FULL);
      else pen.rect(u - a, v - a, 2 * a, 2 * a);
      twice(pen, colour, 1.8);
      pen.setLineDash([]);
      if (fate === "rejected") cross(pen, u, v, Math.max(a, 7), colour);
      if (view.scale > 1) cross(pen, u, v, 3, colour);
      const precise = view.scale > 1.5 && t.s !== null ? ` ± ${t.s.toFixed(3)} px` : "";
      const words = `${t.name}${precise}`;
      if (words && labels.length < MOST_LABELS && free(labels, [u + a + 4, v - 8, 8 * words.length, 16])) label(pen, words, u + a + 4, v, colour);
    }
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
