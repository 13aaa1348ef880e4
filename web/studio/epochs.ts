// What moved between the dates: rectified photographs with displacements over them, and which points and areas moved when.
import { ask } from "./api";
import { button, choices, element, h, onceAFrame, sign } from "./dom";
import { band, lengthUnit } from "./epochs_chart";
import { Model } from "./model";
import { decimalsOf, fixed, grouped, short, withUnit } from "./numbers";
import { say } from "./words";
import { View } from "./view";

export interface Moved {
  name: string;
  area: boolean;
  verdict: "moved" | "moved_area" | "not_significant" | "untested" | "stable";
  /** Number of the first date, of the later ones, and at which of these it had moved. */
  first: number;
  at: number[];
  moved: boolean[];
  /** Least and largest displacements of the points of an area that did not move alike, at each date. */
  between?: [number, number][] | null;
  /** Points of an area. */
  points?: string[];
  /** Against the first date: in the axes of the block, with standard deviations; lengths; along the largest one. */
  d: number[][];
  s: number[][];
  length: number[];
  sigma: number[];
  along: number[];
  along_sigma: number[];
  /** To the right, upwards and towards the viewer of the picture. */
  seen: number[][];
  place: [number, number] | null;
}

interface Found {
  dates: string[];
  rows: Moved[];
  picture: { width: number; height: number; pixel: number } | null;
  why: string;
  unit: string;
  of: number;
}

const MOST_ROWS = 400;
const BLINK_MS = 900;
const KINDS = ["moved", "untested", "every"] as const;
const [NEAR, AWAY, OPEN, STABLE, INK] = ["#d55e00", "#0072b2", "#7c8792", "#009e73", "#10151a"];

export class Epochs {
  private found: Found = { dates: [], rows: [], picture: null, why: "", unit: "", of: 0 };
  private view = new View(1, 1, 0);
  private pictures: (HTMLImageElement | null)[] = [];
  private at = 0;
  private against = 0;
  private chosen = "";
  private blinking = 0;
  private before = false;
  private kind: (typeof KINDS)[number] = "moved";
  private usual = 1;
  private readonly date = h("input", { type: "range", id: "epochs-date", min: 0, max: 0, step: 1, "aria-label": say("studio_epochs.date") });
  private readonly dated = h("output", { id: "epochs-dated" });
  private readonly other = h("select", { id: "epochs-against", "aria-label": say("studio_epochs.against") });
  private readonly blink = button("studio_epochs.blink", () => this.toggle());
  private readonly larger = h("input", { type: "range", id: "epochs-larger", min: -3, max: 3, step: 1, value: 0, "aria-label": say("studio_epochs.larger") });
  private readonly enlarged = h("output", {});
  private readonly stable = h("input", { type: "checkbox", id: "epochs-stable" });
  private readonly canvas = h("canvas", { tabindex: 0, role: "img", "aria-label": say("studio_epochs.picture") });
  private readonly status = h("p", { class: "note", role: "status" });
  private readonly box = h("div", { class: "picture" }, this.canvas, this.status);
  private readonly table = h("div", { class: "wide", tabindex: 0, "aria-label": say("studio_epochs.moved_when") });
  private readonly chart = h("div", { class: "chart" });
  private readonly shown = h("select", { id: "epochs-kind", "aria-label": say("studio_epochs.rows") }, ...choices(KINDS, (kind) => say("studio_epochs.kind", { kind }), "moved"));
  private readonly count = h("span", { class: "note" });
  private readonly drawSoon = onceAFrame(() => this.draw());

  constructor(model: Model, private readonly isOpen: () => boolean, private readonly visit: (point: string) => void) {
    element("epochs-bar").append(
      h("label", {}, say("studio_epochs.date"), this.date), this.dated, h("label", {}, say("studio_epochs.against"), this.other), this.blink,
      h("label", {}, say("studio_epochs.larger"), this.larger), this.enlarged, h("label", {}, this.stable, say("studio_epochs.stable")),
      button("studio_epochs.whole", () => this.fit()));
    element("epochs-legend").append(...[["near", "●"], ["away", "●"], ["open", "●"], ["arrow", "→"]].map(([part, shape]) =>
      h("li", {}, h("span", { class: `sign ${part}` }, shape), say("studio_epochs.legend", { part }))));
    element("epochs").append(this.box, h("div", { class: "side" }, h("div", { class: "deeds first" }, this.shown, this.count), this.table, this.chart));
    this.date.addEventListener("input", () => this.turnTo(Number(this.date.value)));
    this.other.addEventListener("change", () => (this.against = Number(this.other.value)));
    this.larger.addEventListener("input", this.drawSoon);
    this.stable.addEventListener("change", this.drawSoon);
    this.shown.addEventListener("change", () => {
      this.kind = this.shown.value as (typeof KINDS)[number];
      this.list();
    });
    this.mouse();
    new ResizeObserver(() => this.drawSoon()).observe(this.box);
    model.on("read", () => void this.read().catch(() => {}));
  }

  /** The tab is there where the result has displacements. */
  private async read(): Promise<void> {
    const found = await ask<Found>("/api/epochs");
    element("tab-epochs").hidden = !found.dates.length;
    if (found.of === this.found.of && found.dates.length === this.found.dates.length) return;
    this.found = found;
    this.pictures = found.dates.map(() => null);
    if (!found.dates.length) return;
    const { width, height } = found.picture ?? { width: 1, height: 1 };
    this.view = new View(width, height, 0);
    this.date.max = String(found.dates.length - 1);
    this.other.replaceChildren(...found.dates.map((d, k) => h("option", { value: k }, d)));
    this.usual = this.usualFactor();
    const moved = this.rows("moved");
    this.chosen = moved[0]?.name ?? "";
    this.turnTo(found.dates.length - 1);
    if (this.isOpen()) this.show();
  }

  show(): void {
    this.list();
    this.fit();
  }

  private fit(): void {
    this.view.fit();
    this.drawSoon();
  }

  private turnTo(date: number): void {
    this.at = date;
    this.date.value = String(date);
    this.date.setAttribute("aria-valuetext", this.found.dates[date]);
    this.dated.textContent = this.found.dates[date];
    this.list();
    this.drawSoon();
  }

  private toggle(): void {
    clearInterval(this.blinking);
    this.before = false;
    const on = this.blink.getAttribute("aria-pressed") !== "true";
    this.blink.setAttribute("aria-pressed", String(on));
    this.blinking = on ? window.setInterval(() => {
      if (!this.isOpen()) return;
      this.before = !this.before;
      this.drawSoon();
    }, BLINK_MS) : 0;
    this.drawSoon();
  }

  // --- the picture --------------------------------------------------------------------------------

  /** A round factor by which the larger displacements are an eighteenth of the picture. */
  private usualFactor(): number {
    const { picture } = this.found;
    const sizes = this.rows("moved").map((r) => Math.max(...r.length)).sort((a, b) => a - b);
    if (!picture || !sizes.length) return 1;
    const factor = (Math.max(picture.width, picture.height) * this.pixel) / 18 / Math.max(sizes[Math.floor(0.9 * (sizes.length - 1))], 1e-12);
    const power = 10 ** Math.floor(Math.log10(factor));
    return power * ([5, 2, 1].find((f) => f * power <= factor) ?? 1);
  }

  /** Side of a pixel in metres, as displacements are. */
  private get pixel(): number {
    return this.found.picture?.pixel ?? 1;
  }

  private get factor(): number {
    return this.usual * 2 ** Number(this.larger.value);
  }

  private image(date: number): HTMLImageElement | null {
    if (!this.found.picture) return null;
    let image = this.pictures[date];
    if (!image) {
      image = this.pictures[date] = h("img", { src: `/figure/date/${date}.jpg?of=${this.found.of}`, alt: "" });
      image.addEventListener("load", this.drawSoon);
      image.addEventListener("error", () => {
        this.status.textContent = say("studio_epochs.no_picture", { date: this.found.dates[date] });
        this.status.hidden = false;
      });
    }
    return image;
  }

  private draw(): void {
    if (!this.isOpen() || !this.found.dates.length) return;
    const { view, canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    const { clientWidth, clientHeight } = this.box;
    view.resize(clientWidth, clientHeight);
    [canvas.width, canvas.height] = [Math.round(clientWidth * ratio), Math.round(clientHeight * ratio)];
    const pen = canvas.getContext("2d")!;
    pen.fillStyle = "#2b2b2b";
    pen.fillRect(0, 0, canvas.width, canvas.height);
    const date = this.before ? this.against : this.at;
    const image = this.image(date);
    const ready = Boolean(image?.complete && image.naturalWidth);
    this.status.hidden = ready;
    this.status.textContent = image ? say("studio_epochs.rectifying", { date: this.found.dates[date] }) : this.found.why;
    if (image && ready) {
      view.apply(pen, ratio);
      pen.drawImage(image, 0, 0, view.columns, view.rows);
    }
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.enlarged.textContent = `${grouped(Math.round(this.factor * 100) / 100)} ×`;
    for (const row of this.found.rows) if (row.verdict === "stable" && !row.area) this.stable.checked && this.dot(pen, row, 2);
    for (const row of this.found.rows) if (row.verdict !== "stable") this.vector(pen, row);
    this.label(pen, clientHeight);
  }

  private label(pen: CanvasRenderingContext2D, height: number): void {
    pen.font = "600 15px system-ui, sans-serif";
    pen.lineWidth = 4;
    pen.strokeStyle = "rgba(0, 0, 0, .7)";
    pen.fillStyle = "#fff";
    const text = this.found.dates[this.before ? this.against : this.at];
    pen.strokeText(text, 12, 24);
    pen.fillText(text, 12, 24);
    // an arrow of a round length
    const [length, unit] = lengthUnit(60 / this.view.scale * this.pixel / this.factor);
    const long = (length / this.pixel) * this.factor * this.view.scale;
    const words = this.found.unit ? withUnit(short(length * unit.per, 2), unit.name) : short(length, 2);
    arrow(pen, 14, height - 18, 14 + long, height - 18, INK, 2);
    pen.lineWidth = 4;
    pen.lineJoin = "round";
    pen.strokeStyle = "rgba(0, 0, 0, .7)";
    pen.font = "13px system-ui, sans-serif";
    pen.strokeText(words, 22 + long, height - 14);
    pen.fillText(words, 22 + long, height - 14);
  }

  private dot(pen: CanvasRenderingContext2D, row: Moved, radius: number): void {
    if (!row.place) return;
    const [u, v] = this.view.toScreen(...row.place);
    pen.fillStyle = STABLE;
    pen.beginPath();
    pen.arc(u, v, radius, 0, 7);
    pen.fill();
  }

  /** An arrow in the plane of the picture, and a dot for what is across it: as large, towards the viewer or away. */
  private vector(pen: CanvasRenderingContext2D, row: Moved): void {
    if (!row.place || row.between) return;
    const [u, v] = this.view.toScreen(...row.place);
    const k = row.at.indexOf(this.at);
    const chosen = row.name === this.chosen;
    const sure = k >= 0 && row.moved[k];
    const [right, up, near] = k >= 0 ? row.seen[k] : [0, 0, 0];
    const size = (this.factor / this.pixel) * this.view.scale;
    const colour = sure ? (near < 0 ? AWAY : NEAR) : OPEN;
    if (Math.hypot(right, up) * size > 2) arrow(pen, u, v, u + right * size, v - up * size, sure ? INK : OPEN, row.area || chosen ? 3 : 1.5);
    pen.fillStyle = colour;
    pen.strokeStyle = chosen ? "#fff" : "rgba(255, 255, 255, .75)";
    pen.lineWidth = chosen ? 3 : 1;
    pen.beginPath();
    pen.arc(u, v, Math.min(Math.max(2.5, 0.12 * Math.abs(near) * size), 9) + (row.area || chosen ? 3 : 0), 0, 7);
    pen.fill();
    pen.stroke();
  }

  private mouse(): void {
    const { canvas } = this;
    let from: [number, number] | null = null;
    let gone = 0;
    canvas.addEventListener("pointerdown", (event) => {
      from = [event.offsetX, event.offsetY];
      gone = 0;
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!from) return;
      const [du, dv] = [event.offsetX - from[0], event.offsetY - from[1]];
      gone += Math.hypot(du, dv);
      from = [event.offsetX, event.offsetY];
      this.view.panBy(du, dv);
      this.drawSoon();
    });
    canvas.addEventListener("pointerup", (event) => {
      if (from && gone < 4) this.pick(event.offsetX, event.offsetY);
      from = null;
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.view.zoomAt(Math.exp(-event.deltaY * 0.0016), event.offsetX, event.offsetY);
      this.drawSoon();
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => {
      const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!by) return;
      event.preventDefault();
      this.turnTo(Math.min(Math.max(this.at + by, 0), this.found.dates.length - 1));
    });
  }

  private pick(u: number, v: number): void {
    let best = 14;
    let name = "";
    for (const row of this.found.rows) {
      if (!row.place || row.between || row.verdict === "stable") continue;
      const [a, b] = this.view.toScreen(...row.place);
      const far = Math.hypot(a - u, b - v);
      if (far < best) [best, name] = [far, row.name];
    }
    if (name) this.choose(name);
  }

  // --- what moved, when, and by how much ------------------------------------------------------------

  private rows(kind: (typeof KINDS)[number]): Moved[] {
    const wanted = this.found.rows.filter((r) => r.at && r.verdict !== "stable" &&
      (kind === "every" || (kind === "untested" ? r.verdict === "untested" : r.verdict === "moved" || r.verdict === "moved_area")));
    const even = (r: Moved): number => Number(r.area && !r.between);
    return wanted.sort((a, b) => even(b) - even(a) || Number(b.area) - Number(a.area) || Math.max(...b.length) - Math.max(...a.length));
  }

  private choose(name: string): void {
    this.chosen = name;
    this.list();
    this.drawSoon();
    this.table.querySelector("tr.at")?.scrollIntoView({ block: "nearest" });
  }

  private list(): void {
    if (!this.isOpen()) return;
    const { dates } = this.found;
    const every = this.rows(this.kind);
    const rows = every.slice(0, MOST_ROWS);
    const longest = Math.max(...every.flatMap((r) => r.length), 0.001);
    const picked = this.found.rows.find((r) => r.name === this.chosen && r.at);
    if (picked && !rows.includes(picked)) rows.unshift(picked);
    this.count.textContent = say("studio_epochs.count", { n: every.length, shown: Math.min(every.length, MOST_ROWS), unit: this.found.unit ? lengthUnit(longest)[1].name : "–" });
    const [, unit] = lengthUnit(longest);
    const lengths = this.found.unit ? unit : { per: 1, name: "" };
    const head = h("thead", {}, h("tr", {}, h("th", { scope: "col" }, say("studio_epochs.point")), h("th", { scope: "col" }, say("studio_epochs.since")),
      ...dates.slice(1).map((d, k) => h("th", { scope: "col", class: k + 1 === this.at ? "now" : "" }, d))));
    this.table.replaceChildren(h("table", { "aria-label": say("studio_epochs.moved_when") }, head, h("tbody", {}, ...rows.map((r) => this.row(r, lengths.per)))));
    const show = picked && !picked.area ? button("studio_epochs.visit", () => this.visit(picked.name)) : "";
    this.chart.replaceChildren(...(picked ? [
      h("h3", {}, say("studio_epochs.over_time", { name: picked.name, n: picked.points?.length ?? 0 })),
      band(picked, dates, lengths, this.at), picked.between ? h("p", { class: "note" }, say("studio_epochs.mean_of_uneven")) : "",
      h("p", { class: "note" }, this.axes(picked, lengths)), show,
    ] : [h("p", { class: "note" }, say("studio_epochs.nothing_chosen"))]));
  }

  private row(r: Moved, per: number): HTMLElement {
    const first = r.at.find((_, k) => r.moved[k]);
    const cells = this.found.dates.slice(1).map((_, j) => {
      const k = r.at.indexOf(j + 1);
      if (k < 0) return h("td", {}, "–");
      const digits = decimalsOf(r.sigma[k] * per);
      if (r.between) return h("td", { class: r.moved[k] ? "sure" : "" }, say("studio_epochs.uneven", { least: fixed(r.between[k][0] * per, digits), largest: fixed(r.between[k][1] * per, digits) }));
      return h("td", { class: r.moved[k] ? "sure" : "" }, `${fixed(r.length[k] * per, digits)} ± ${fixed(r.sigma[k] * per, digits)}`);
    });
    const name = sign(r.name, say("studio_epochs.choose", { name: r.name }), () => this.choose(r.name), "link");
    return h("tr", { class: r.name === this.chosen ? "at" : "", onclick: () => this.choose(r.name) }, h("th", { scope: "row" }, name),
      h("td", { class: "l" }, first === undefined ? say("studio_epochs.verdict", { verdict: r.verdict }) : this.found.dates[first]), ...cells);
  }

  private axes(r: Moved, unit: { per: number; name: string }): string {
    const k = r.at.indexOf(this.at);
    if (k < 0) return say("studio_epochs.no_place", { date: this.found.dates[this.at] });
    const each = ["X", "Y", "Z"].map((axis, i) => {
      const digits = decimalsOf(r.s[k][i] * unit.per);
      return `d${axis} ${fixed(r.d[k][i] * unit.per, digits)} ± ${fixed(r.s[k][i] * unit.per, digits)}`;
    });
    return say("studio_epochs.at_date", { from: this.found.dates[r.first], to: this.found.dates[this.at], values: withUnit(each.join(", "), unit.name) });
  }
}

/** A line with a head, light beside dark. */
function arrow(pen: CanvasRenderingContext2D, u: number, v: number, a: number, b: number, colour: string, width: number): void {
  const angle = Math.atan2(b - v, a - u);
  const head = Math.min(4 + 2 * width, Math.hypot(a - u, b - v));
  for (const [style, more] of [["rgba(255, 255, 255, .75)", 2.5], [colour, 0]] as const) {
    pen.strokeStyle = style;
    pen.lineWidth = width + more;
    pen.beginPath();
    pen.moveTo(u, v);
    pen.lineTo(a, b);
    for (const turn of [2.7, -2.7]) {
      pen.moveTo(a, b);
      pen.lineTo(a + head * Math.cos(angle + turn), b + head * Math.sin(angle + turn));
    }
    pen.stroke();
  }
}
