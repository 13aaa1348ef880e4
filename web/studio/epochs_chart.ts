// A displacement over time with the band in which 95 % of true ones lie.
import type { Moved } from "./epochs";
import { local } from "./numbers";
import { say } from "./words";

const SVG = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM] = [420, 210, 52, 12, 10, 30];
const QUANTILE = 1.96;

export interface LengthUnit {
  per: number;
  name: string;
}

/** A round length that is no longer, and the unit that it is written in. */
export function lengthUnit(length: number): [number, LengthUnit] {
  const power = 10 ** Math.floor(Math.log10(length));
  const round = power * ([5, 2, 1].find((f) => f * power <= length * 1.0001) ?? 1);
  return [round, length < 1 ? { per: 1000, name: "mm" } : { per: 1, name: "m" }];
}

const drawn = (tag: string, attributes: Record<string, string | number>, text = ""): SVGElement => {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.textContent = text;
  return made;
};

/** Round numbers between two, some four of them. */
function ticks(low: number, high: number): number[] {
  const [step] = lengthUnit((high - low) / 3);
  const found: number[] = [];
  for (let v = Math.ceil(low / step) * step; v <= high + step * 1e-9; v += step) found.push(Math.abs(v) < step * 1e-9 ? 0 : v);
  return found;
}

export function band(r: Moved, dates: string[], unit: LengthUnit, now: number): SVGElement {
  const days = [r.first, ...r.at].map((k) => Date.parse(dates[k]) / 864e5);
  const values = [0, ...r.along.map((v) => v * unit.per)];
  const widths = [0, ...r.along_sigma.map((s) => QUANTILE * s * unit.per)];
  const [from, to] = [Date.parse(dates[0]) / 864e5, Date.parse(dates[dates.length - 1]) / 864e5];
  const low = Math.min(...values.map((v, k) => v - widths[k]));
  const high = Math.max(...values.map((v, k) => v + widths[k]));
  const room = 0.08 * (high - low || 1);
  const x = (day: number) => LEFT + 6 + (WIDTH - LEFT - RIGHT - 12) * ((day - from) / (to - from || 1));
  const y = (v: number) => TOP + (HEIGHT - TOP - BOTTOM) * ((high + room - v) / (high - low + 2 * room));
  const at = (day: number, v: number) => `${x(day).toFixed(1)},${y(v).toFixed(1)}`;
  const svg = drawn("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": say("studio_epochs.over_time", { name: r.name, n: r.points?.length ?? 0 }) });
  const levels = ticks(low - room, high + room);
  const digits = Math.max(0, -Math.floor(Math.log10(Math.abs((levels[1] ?? 1) - (levels[0] ?? 0)) || 1) + 1e-9));
  for (const v of levels)
    svg.append(drawn("line", { class: v ? "level" : "zero", x1: LEFT, x2: WIDTH - RIGHT, y1: y(v), y2: y(v) }),
      drawn("text", { x: LEFT - 6, y: y(v) + 4, "text-anchor": "end" }, local(v.toFixed(digits))));
  svg.append(drawn("polygon", { class: "band", points: [...days.map((d, k) => at(d, values[k] + widths[k])), ...days.map((d, k) => at(d, values[k] - widths[k])).reverse()].join(" ") }),
    drawn("polyline", { class: "line", points: days.map((d, k) => at(d, values[k])).join(" ") }));
  days.forEach((d, k) => {
    const date = k ? r.at[k - 1] : r.first;
    const sure = k > 0 && r.moved[k - 1];
    svg.append(drawn("line", { class: "bar", x1: x(d), x2: x(d), y1: y(values[k] - widths[k]), y2: y(values[k] + widths[k]) }),
      drawn("circle", { class: `${sure ? "sure" : "open"}${date === now ? " now" : ""}`, cx: x(d), cy: y(values[k]), r: date === now ? 5 : 3.5 }));
  });
  let last = -1e9;
  for (const date of dates) {
    const u = x(Date.parse(date) / 864e5);
    if (u - last < 72) continue;
    const anchor = u < LEFT + 30 ? "start" : u > WIDTH - RIGHT - 30 ? "end" : "middle";
    svg.append(drawn("text", { x: u, y: HEIGHT - 12, "text-anchor": anchor }, date));
    last = u;
  }
  svg.append(drawn("text", { x: LEFT - 12, y: HEIGHT - 12, "text-anchor": "end" }, unit.name));
  return svg;
}
