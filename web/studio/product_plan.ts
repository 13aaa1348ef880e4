// An orthophoto or the heights, moved and zoomed; the place under the pointer; areas and lines drawn on it.
import { ask } from "./api";
import { afterPause, button, h } from "./dom";
import { Model } from "./model";
import { fixed } from "./numbers";
import { Kept, ProductDrawings } from "./product_drawings";
import { ProductFolder, ProductPicture } from "./types";
import { say } from "./words";
import type { Leaf } from "./leaf";

type Drawing = "area" | "line";
type XY = [number, number];
const ZOOM = 0.0016;
const FIRST = ["orthophoto.tif", "heights.tif", "facade.tif"];
const REACH = 8;
const NEW = "#1f5a96";
const KEPT = "#8a2be2";

export class ProductPlan implements Leaf {
  readonly root = h("section", { class: "leaf whole", "aria-label": say("studio_product.part", { part: "plan" }), hidden: true });
  private readonly select = h("select", { id: "plan-file", "aria-label": say("studio_product.picture") });
  private readonly canvas = h("canvas", { id: "plan", tabindex: 0, "aria-label": say("studio_product.part", { part: "plan" }) });
  private readonly place = h("p", { class: "note", id: "plan-place", role: "status" });
  private readonly modes: [Drawing, HTMLButtonElement][];
  private readonly uses: [Drawing, HTMLButtonElement][];
  private picture: ProductPicture | null = null;
  private files: string[] = [];
  /** Pixel of the picture in the upper left corner, and pixels of the screen for one of the picture. */
  private left = 0;
  private top = 0;
  private scale = 1;
  private shown: { image: ImageBitmap; left: number; top: number; width: number; height: number } | null = null;
  private turn = 0;
  private mode: Drawing | "" = "";
  private kind: Drawing = "area";
  private corners: XY[] = [];
  private readonly fetchSoon = afterPause(() => void this.fetch(), 120);
  private readonly valueSoon = afterPause(() => void this.value(), 120);
  private at: XY | null = null;
  private readonly kept: ProductDrawings;

  /** drawn  gets the product and the corners of what was drawn for it */
  constructor(private readonly model: Model, private readonly drawn: (product: string, corners: string) => void) {
    this.modes = (["area", "line"] as const).map((mode) => {
      const made = button("studio_product.draw", () => this.begin(mode), "", { shape: mode });
      made.id = `plan-${mode}`;
      return [mode, made];
    });
    this.uses = ([["area", "volume"], ["line", "section"]] as const).map(([mode, product]) => {
      const made = button("studio_product.use", () => this.drawn(product, this.text()), "main", { shape: mode });
      made.id = `plan-use-${mode}`;
      return [mode, made];
    });
    const clear = button("studio_product.clear", () => this.begin(""));
    clear.id = "plan-clear";
    this.select.addEventListener("change", () => void this.open(this.select.value));
    this.root.append(h("div", { class: "deeds" }, h("label", { for: "plan-file" }, say("studio_product.picture")), this.select,
      ...this.modes.map(([, b]) => b), clear, ...this.uses.map(([, b]) => b), button("studio_space.all", () => this.whole())),
      this.canvas, this.place);
    this.kept = new ProductDrawings(model, () => this.enough() ? { kind: this.kind, corners: this.corners.map((c) => this.rounded(c)) } : null,
      (d) => this.again(d), () => this.begin(""));
    this.root.append(this.kept.root);
    model.on("state", () => this.paint());
    this.listen();
    new ResizeObserver(() => this.resized()).observe(this.canvas);
    this.buttons();
  }

  get has(): boolean {
    return this.files.length > 0;
  }

  take(folders: ProductFolder[]): void {
    const paths = folders.flatMap((f) => f.files.filter((each) => each.picture).map((each) => each.path));
    const rank = (path: string) => (FIRST.indexOf(path.split("/").pop()!) + FIRST.length + 1) % (FIRST.length + 1);
    this.files = paths.sort((a, b) => rank(a) - rank(b) || a.localeCompare(b));
    const before = this.select.value;
    this.select.replaceChildren(...this.files.map((path) => h("option", { value: path, selected: path === before }, path)));
    this.select.disabled = !this.has;
    if (!this.has) this.place.textContent = say("studio_product.no_picture");
  }

  async show(): Promise<void> {
    if (this.has) await this.open(this.select.value); // it may have been made anew
    this.resized();
  }

  async open(path: string): Promise<void> {
    try {
      const before = this.picture;
      this.picture = { ...(await ask<ProductPicture>("/api/picture", { file: path })), path };
      this.select.value = path;
      this.shown = null;
      const p = this.picture;
      const [folder] = path.split("/");
      this.kept.turn(folder === "surface" ? folder : `${folder}/surface`);
      const same = before && before.width === p.width && before.height === p.height && String(before.place) === String(p.place);
      if (!same || (before.path === p.path && before.stamp !== p.stamp)) {
        this.corners = [];
        this.whole();
      } else this.fetchSoon();
      this.buttons();
    } catch (error) {
      this.model.fail(error);
    }
  }

  private begin(mode: Drawing | ""): void {
    this.mode = mode;
    if (mode) this.kind = mode;
    this.corners = [];
    this.buttons();
    this.paint();
    this.canvas.focus();
  }

  private buttons(): void {
    const placed = !!this.picture?.place;
    for (const [mode, each] of this.modes) {
      each.disabled = !placed;
      each.setAttribute("aria-pressed", String(mode === this.mode));
    }
    for (const [mode, each] of this.uses) each.hidden = !this.picture?.path.startsWith("surface/") || mode !== this.kind || !this.enough();
    this.kept.offer();
  }

  private enough(): boolean {
    return !!this.picture?.place && this.corners.length >= (this.kind === "area" ? 3 : 2);
  }

  /** Draw what was kept again. */
  private again(d: Kept): void {
    const place = this.picture?.place;
    if (!place) return;
    this.begin(d.kind);
    this.corners = d.corners.map((c) => this.inPicture(c));
    this.buttons();
    this.paint();
  }

  private inPicture([X, Y]: XY): XY {
    const place = this.picture!.place!;
    return [(X - place[0]) / place[2], (place[1] - Y) / place[3]];
  }

  /** Coordinates in the plane or the map, to a tenth of a pixel. */
  private rounded(corner: XY): XY {
    const decimals = this.decimals();
    return this.object(corner)!.map((v) => Number(v.toFixed(decimals))) as XY;
  }

  private decimals(): number {
    return Math.max(0, Math.ceil(-Math.log10(Math.abs(this.picture!.place![2]))) + 1);
  }

  /** The corners in coordinates of the plane or the map, as commands take them. */
  private text(): string {
    return this.corners.map((corner) => this.object(corner)!.map((v) => v.toFixed(this.decimals())).join(" ")).join(", ");
  }

  private object([column, row]: XY): XY | null {
    const place = this.picture?.place;
    return place ? [place[0] + place[2] * column, place[1] - place[3] * row] : null;
  }

  private whole(): void {
    const p = this.picture;
    if (!p || !this.canvas.clientWidth) return;
    this.scale = Math.min(this.canvas.clientWidth / p.width, this.canvas.clientHeight / p.height);
    this.left = (p.width - this.canvas.clientWidth / this.scale) / 2;
    this.top = (p.height - this.canvas.clientHeight / this.scale) / 2;
    this.paint();
    this.fetchSoon();
  }

  private resized(): void {
    const ratio = window.devicePixelRatio || 1;
    const [w, height] = [Math.round(this.canvas.clientWidth * ratio), Math.round(this.canvas.clientHeight * ratio)];
    if (!w || (w === this.canvas.width && height === this.canvas.height)) return;
    const first = this.canvas.width === 300;
    this.canvas.width = w;
    this.canvas.height = height;
    if (first || !this.shown) this.whole();
    else this.paint();
    this.fetchSoon();
  }

  /** Get what is seen, at the size of the screen. */
  private async fetch(): Promise<void> {
    const p = this.picture;
    if (!p || !this.canvas.clientWidth) return;
    const turn = ++this.turn;
    const view = { left: this.left, top: this.top, width: this.canvas.clientWidth / this.scale, height: this.canvas.clientHeight / this.scale };
    const query = new URLSearchParams({ ...Object.fromEntries(Object.entries(view).map(([k, v]) => [k, String(v)])),
      stamp: p.stamp, across: String(Math.min(4096, this.canvas.width)), down: String(Math.min(4096, this.canvas.height)) });
    try {
      const answer = await fetch(`/product/picture/${p.path.split("/").map(encodeURIComponent).join("/")}?${query}`);
      if (!answer.ok) throw new Error(((await answer.json()) as { error: string }).error);
      const image = await createImageBitmap(await answer.blob());
      if (turn !== this.turn) return;
      this.shown = { image, ...view };
      this.paint();
    } catch (error) {
      this.model.fail(error);
    }
  }

  private paint(): void {
    const c = this.canvas.getContext("2d")!;
    const ratio = this.canvas.width / Math.max(this.canvas.clientWidth, 1);
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.fillStyle = "#fff";
    c.fillRect(0, 0, this.canvas.width, this.canvas.height);
    const s = this.scale * ratio;
    if (this.shown) {
      const { image, left, top, width, height } = this.shown;
      c.imageSmoothingEnabled = true;
      c.drawImage(image, (left - this.left) * s, (top - this.top) * s, width * s, height * s);
    }
    const onScreen = (corners: XY[]) => corners.map(([x, y]) => [(x - this.left) * s, (y - this.top) * s] as XY);
    c.font = "13px system-ui, sans-serif".replace("13", String(13 * ratio));
    if (this.picture?.place) for (const d of this.kept.here) {
      const on = onScreen(d.corners.map((corner) => this.inPicture(corner)));
      stroke(c, on, d.kind, ratio, KEPT);
      c.strokeStyle = "#fff";
      c.lineWidth = 3 * ratio;
      c.strokeText(d.drawing, on[0][0] + 6 * ratio, on[0][1] - 6 * ratio);
      c.fillStyle = KEPT;
      c.fillText(d.drawing, on[0][0] + 6 * ratio, on[0][1] - 6 * ratio);
    }
    const on = onScreen(this.corners);
    if (!on.length) return;
    stroke(c, on, this.kind, ratio, NEW);
    c.fillStyle = NEW;
    for (const [x, y] of on) c.fillRect(x - 3 * ratio, y - 3 * ratio, 6 * ratio, 6 * ratio);
  }

  private pixel(event: MouseEvent): XY {
    const box = this.canvas.getBoundingClientRect();
    return [this.left + (event.clientX - box.left) / this.scale, this.top + (event.clientY - box.top) / this.scale];
  }

  private listen(): void {
    let from: XY | null = null;
    let moved = 0;
    this.canvas.addEventListener("pointerdown", (event) => {
      from = [event.clientX, event.clientY];
      moved = 0;
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      this.at = this.pixel(event);
      this.valueSoon();
      if (!from) return;
      const [dx, dy] = [event.clientX - from[0], event.clientY - from[1]];
      moved += Math.abs(dx) + Math.abs(dy);
      if (moved < REACH / 2) return;
      this.left -= dx / this.scale;
      this.top -= dy / this.scale;
      from = [event.clientX, event.clientY];
      this.paint();
      this.fetchSoon();
    });
    this.canvas.addEventListener("pointerup", (event) => {
      if (from && moved < REACH / 2 && this.mode) this.corner(this.pixel(event));
      from = null;
    });
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * ZOOM), this.pixel(event));
    }, { passive: false });
    this.canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** By keys: arrows move, + and - zoom, Enter puts a corner in the middle, Backspace takes the last away, Escape ends. */
  private key(event: KeyboardEvent): void {
    const step = 60 / this.scale;
    const middle: XY = [this.left + this.canvas.clientWidth / this.scale / 2, this.top + this.canvas.clientHeight / this.scale / 2];
    const moves: Record<string, XY> = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] };
    if (moves[event.key]) {
      this.left += moves[event.key][0];
      this.top += moves[event.key][1];
      this.at = middle;
      this.valueSoon();
      this.paint();
      this.fetchSoon();
    } else if (event.key === "+" || event.key === "-") this.zoom(event.key === "+" ? 1.25 : 0.8, middle);
    else if (event.key === "Enter" && this.mode) this.corner(middle);
    else if (event.key === "Backspace" && this.corners.length) {
      this.corners.pop();
      this.buttons();
      this.paint();
    } else if (event.key === "Escape" && this.mode) this.begin("");
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private zoom(by: number, [x, y]: XY): void {
    const to = Math.min(64, Math.max(this.scale * by, 1e-4));
    this.left = x - ((x - this.left) * this.scale) / to;
    this.top = y - ((y - this.top) * this.scale) / to;
    this.scale = to;
    this.paint();
    this.fetchSoon();
  }

  private corner(at: XY): void {
    this.corners.push(at);
    this.buttons();
    this.paint();
  }

  /** Place and height under the pointer. */
  private async value(): Promise<void> {
    const p = this.picture;
    if (!p?.place || !this.at) return;
    const at = this.at;
    const [X, Y] = this.object(at)!;
    const decimals = this.decimals();
    const values = { x: fixed(X, decimals), y: fixed(Y, decimals), z: "none", s: "none" };
    if (p.heights) {
      try {
        const found = await ask<{ height: number | null; sigma: number | null }>("/api/picture/place", { file: p.path, column: at[0], row: at[1] });
        if (at !== this.at) return;
        if (found.height !== null) values.z = fixed(found.height, decimals + 1);
        if (found.sigma !== null) values.s = fixed(found.sigma, decimals + 2);
      } catch (error) {
        return this.model.fail(error);
      }
    }
    this.place.textContent = say("studio_product.place", values);
  }
}

function stroke(c: CanvasRenderingContext2D, on: XY[], kind: Drawing, ratio: number, colour: string): void {
  const path = new Path2D();
  on.forEach(([x, y], k) => (k ? path.lineTo(x, y) : path.moveTo(x, y)));
  if (kind === "area") {
    if (on.length > 2) path.closePath();
    c.fillStyle = `${colour}2e`;
    c.fill(path);
  }
  for (const [each, width] of [["#fff", 4], [colour, 2]] as const) {
    c.strokeStyle = each;
    c.lineWidth = width * ratio;
    c.stroke(path);
  }
}
