// What lies over a photograph: image points with residuals, marks, the prediction of the current point, the cross hair.
import { beyond } from "./beyond";
import { COLOUR, Filter, looks } from "./looks";
import { Fiducial, Mark, Observations, Prediction } from "./types";
import { View } from "./view";

export type Status = "used" | "weak" | "rejected" | "control" | "check";

export interface Shown {
  observations: Observations | null;
  rejectedHere: Set<string>;
  marks: { mark: Mark; x: number; y: number }[];
  prediction: Prediction | null;
  /** Whether the mark of the current point is mistaken here, or may be. */
  off: boolean;
  image: string;
  fiducials: Fiducial[];
  fiducial: string;
  current: string;
  hover: number;
  hair: boolean;
}

type Pen = CanvasRenderingContext2D;
const WORST = 20;
const FULL = 2 * Math.PI;

export function statusOf(o: Observations, i: number, rejectedHere: Set<string>): Status {
  if (o.rejected[i] || rejectedHere.has(o.point[i])) return "rejected";
  if (o.role[i] === 1) return "control";
  if (o.role[i] === 2) return "check";
  return o.rays[i] < 3 ? "weak" : "used";
}

/** Rows that a filter lets through. */
export function filtered(o: Observations, filter: Filter, rejectedHere: Set<string>): number[] {
  const rows = [...o.x.keys()];
  if (filter === "none") return [];
  if (filter === "worst") return rows.filter((i) => o.w[i] !== null).sort((a, b) => o.w[b]! - o.w[a]!).slice(0, WORST);
  if (filter === "all") return rows;
  const wanted: Status[] = filter === "control" ? ["control", "check"] : [filter];
  return rows.filter((i) => wanted.includes(statusOf(o, i, rejectedHere)));
}

/** Row of the image point nearest to a place of the pane, within a few pixels of the screen; -1: none. */
export function nearestPoint(o: Observations, rows: number[], view: View, u: number, v: number, within = 9): number {
  let best = -1;
  let least = within;
  for (const i of rows) {
    const [a, b] = view.toScreen(o.x[i], o.y[i]);
    const d = Math.hypot(a - u, b - v);
    if (d < least) {
      least = d;
      best = i;
    }
  }
  return best;
}

export function drawOverlay(pen: Pen, view: View, shown: Shown, ratio: number): void {
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  const { observations: o } = shown;
  if (o) {
    const rows = filtered(o, looks.filter, shown.rejectedHere);
    drawVectors(pen, view, o, rows);
    drawPoints(pen, view, o, rows, shown);
    drawBeyond(pen, view, o, shown.image);
  }
  if (shown.prediction) drawPrediction(pen, view, shown.prediction, shown.current);
  for (const each of shown.marks) drawMark(pen, view, each, each.mark.point === shown.current, shown.off);
  for (const f of shown.fiducials) drawFiducial(pen, view, f, f.name === shown.fiducial);
  if (shown.hair) drawHair(pen, view);
}

function drawVectors(pen: Pen, view: View, o: Observations, rows: number[]): void {
  if (looks.vectors <= 0) return;
  const length = looks.vectors / view.scale;
  for (const [colour, wanted] of [["#00000099", 2.8], [COLOUR.used, 1.3]] as const) {
    pen.strokeStyle = colour;
    pen.lineWidth = wanted;
    pen.beginPath();
    for (const i of rows) {
      const vx = o.vx[i];
      const vy = o.vy[i];
      if (vx === null || vy === null) continue;
      pen.moveTo(...view.toScreen(o.x[i], o.y[i]));
      pen.lineTo(...view.toScreen(o.x[i] + vx * length, o.y[i] + vy * length));
    }
    pen.stroke();
  }
}

/** One shape for each status, so that they differ by more than colour. */
function shape(pen: Pen, status: Status, u: number, v: number, size: number): void {
  const r = status === "control" || status === "check" ? 6 : size;
  if (status === "rejected") {
    pen.moveTo(u - r, v - r);
    pen.lineTo(u + r, v + r);
    pen.moveTo(u + r, v - r);
    pen.lineTo(u - r, v + r);
  } else if (status === "control") {
    pen.moveTo(u, v - r);
    pen.lineTo(u + r, v + 0.75 * r);
    pen.lineTo(u - r, v + 0.75 * r);
    pen.closePath();
  } else if (status === "check") {
    pen.moveTo(u, v - r);
    pen.lineTo(u + r, v);
    pen.lineTo(u, v + r);
    pen.lineTo(u - r, v);
    pen.closePath();
  } else if (status === "weak") pen.rect(u - r, v - r, 2 * r, 2 * r);
  else {
    pen.moveTo(u + r, v);
    pen.arc(u, v, r, 0, FULL);
  }
}

function drawPoints(pen: Pen, view: View, o: Observations, rows: number[], shown: Shown): void {
  // smaller where the whole photograph is seen, so that it is seen
  const size = Math.min(Math.max(2.6 * Math.sqrt(view.scale), 1.6), 4);
  for (const status of ["used", "weak", "rejected", "check", "control"] as const) {
    pen.beginPath();
    for (const i of rows) {
      if (statusOf(o, i, shown.rejectedHere) !== status) continue;
      const [u, v] = view.toScreen(o.x[i], o.y[i]);
      if (u < -9 || v < -9 || u > view.width + 9 || v > view.height + 9) continue;
      shape(pen, status, u, v, size);
    }
    pen.lineWidth = size < 2.5 ? 2.2 : 3;
    pen.strokeStyle = "#000000a0";
    pen.stroke();
    pen.lineWidth = size < 2.5 ? 1.2 : 1.6;
    pen.strokeStyle = COLOUR[status];
    pen.stroke();
  }
  if (shown.hover >= 0 && shown.hover < o.x.length) {
    const [u, v] = view.toScreen(o.x[shown.hover], o.y[shown.hover]);
    ring(pen, u, v, 9, "#ffffff");
  }
}

/** A ring about what is beyond the limit, whatever else is shown. */
function drawBeyond(pen: Pen, view: View, o: Observations, image: string): void {
  if (!beyond.points.size) return;
  for (const [k, point] of o.point.entries()) {
    if (!beyond.has(image, point)) continue;
    const [u, v] = view.toScreen(o.x[k], o.y[k]);
    if (u < -16 || v < -16 || u > view.width + 16 || v > view.height + 16) continue;
    ring(pen, u, v, 8, COLOUR.beyond);
  }
}

function ring(pen: Pen, u: number, v: number, r: number, colour: string): void {
  pen.beginPath();
  pen.arc(u, v, r, 0, FULL);
  twice(pen, colour, 1.6);
}

/** A line with a dark edge, seen on bright and dark pictures alike. */
export function twice(pen: Pen, colour: string, width: number): void {
  pen.lineWidth = width + 2;
  pen.strokeStyle = "#000000b0";
  pen.stroke();
  pen.lineWidth = width;
  pen.strokeStyle = colour;
  pen.stroke();
}

function drawMark(pen: Pen, view: View, { mark, x, y }: Shown["marks"][number], current: boolean, off: boolean): void {
  const [u, v] = view.toScreen(x, y);
  const r = current ? 11 : 8;
  const colour = current && off ? COLOUR.off : current ? COLOUR.current : COLOUR.mark;
  pen.beginPath();
  for (const [a, b] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
    pen.moveTo(u + 2.5 * a, v + 2.5 * b);
    pen.lineTo(u + r * a, v + r * b);
  }
  twice(pen, colour, current ? 2 : 1.6);
  if (current) ring(pen, u, v, 14, off ? COLOUR.off : COLOUR.mark);
  label(pen, current && off ? `${mark.point} !` : mark.point, u + r + 4, v - 7, colour);
}

function drawFiducial(pen: Pen, view: View, f: Fiducial, current: boolean): void {
  const [u, v] = view.toScreen(f.x, f.y);
  const colour = current ? COLOUR.current : COLOUR.control;
  pen.beginPath();
  pen.rect(u - 9, v - 9, 18, 18);
  for (const [a, b] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
    pen.moveTo(u + 3 * a, v + 3 * b);
    pen.lineTo(u + 9 * a, v + 9 * b);
  }
  twice(pen, colour, 1.6);
  label(pen, f.name, u + 14, v - 7, colour);
}

export function label(pen: Pen, words: string, u: number, v: number, colour: string): void {
  pen.font = "600 12.5px system-ui, 'Noto Sans', 'Liberation Sans', sans-serif";
  pen.textBaseline = "middle";
  pen.lineJoin = "round";
  pen.lineWidth = 3.5;
  pen.strokeStyle = "#000000c8";
  pen.strokeText(words, u, v);
  pen.fillStyle = colour;
  pen.fillText(words, u, v);
}

function drawPrediction(pen: Pen, view: View, p: Prediction, point: string): void {
  if (p.segment) drawSegment(pen, view, p);
  if (p.x === null || p.y === null) return;
  const [u, v] = view.toScreen(p.x, p.y);
  const turned = Math.atan2(view.sin, view.cos);
  if (p.ellipse) {
    const angle = (p.ellipse.angle_deg * Math.PI) / 180 + turned;
    for (const sigmas of [1, 3]) {
      pen.beginPath();
      pen.setLineDash(sigmas === 3 ? [5, 4] : []);
      pen.ellipse(u, v, sigmas * p.ellipse.a * view.scale, sigmas * p.ellipse.b * view.scale, angle, 0, FULL);
      twice(pen, COLOUR.predicted, 1.4);
    }
    pen.setLineDash([]);
  }
  ring(pen, u, v, 3, COLOUR.predicted);
  if (!p.ellipse || p.ellipse.a * view.scale < 12) {
    pen.setLineDash([3, 4]);
    ring(pen, u, v, 20, COLOUR.predicted);
    pen.setLineDash([]);
  }
  label(pen, `${point} ?`, u + 16, v + 17, COLOUR.predicted);
}

function drawSegment(pen: Pen, view: View, p: Prediction): void {
  pen.beginPath();
  p.segment!.forEach(([x, y], k) => (k ? pen.lineTo(...view.toScreen(x, y)) : pen.moveTo(...view.toScreen(x, y))));
  pen.lineJoin = "round";
  if (p.segment_sigma_px !== null) {
    // the band of 3 sigma on both sides
    pen.lineWidth = Math.max(6 * p.segment_sigma_px * view.scale, 2);
    pen.strokeStyle = "#f0e44238";
    pen.stroke();
  }
  twice(pen, COLOUR.predicted, 1.2);
}

function drawHair(pen: Pen, view: View): void {
  const [u, v] = [view.width / 2, view.height / 2];
  pen.beginPath();
  for (const [a, b] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
    pen.moveTo(u + 5 * a, v + 5 * b);
    pen.lineTo(u + 26 * a, v + 26 * b);
  }
  twice(pen, "#ffffff", 1.2);
}
