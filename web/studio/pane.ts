// One photograph in its pane: drawn, moved, measured in.
import { button, h, onceAFrame, sign } from "./dom";
import { drawing } from "./drawing";
import { masked } from "./masked";
import { COLOUR, looks, photoFilter } from "./looks";
import { Measuring } from "./measuring";
import { Model, Picture } from "./model";
import { drawOverlay, filtered, nearestPoint, Shown, statusOf } from "./overlay";
import { drawTargets } from "./overlay_targets";
import { paneKeys } from "./pane_keys";
import { drawPhoto } from "./photo";
import { fixed, short } from "./numbers";
import { targetLayer } from "./target_layer";
import { tiles } from "./tiles";
import { say } from "./words";
import { Mark, Observations } from "./types";
import { View } from "./view";

export interface Stage {
  /** A pane was moved or zoomed: the linked ones follow. */
  moved(pane: Pane, du: number, dv: number, factor: number): void;
  activate(pane: Pane): void;
  close(pane: Pane): void;
  pointer(words: string): void;
}

const LOUPE = 190;

export class Pane {
  readonly root: HTMLElement;
  readonly body: HTMLElement;
  readonly view: View;
  private readonly photo = h("canvas", { class: "photo" });
  private readonly over = h("canvas", { class: "over" });
  private readonly status = h("p", { class: "status" });
  private readonly tip = h("div", { class: "tip", hidden: true });
  private observations: Observations | null = null;
  private hover = -1;
  private at: [number, number] | null = null;
  private keyboard = false;
  private readonly draw = onceAFrame(() => this.drawn());
  private readonly forget: () => void;
  private readonly watch = new ResizeObserver(() => this.sized());

  constructor(
    readonly model: Model, readonly measuring: Measuring, readonly stage: Stage, readonly picture: Picture,
  ) {
    this.view = new View(picture.width, picture.height, picture.turn);
    this.body = h("div", {
      class: "canvas", tabindex: 0, role: "application",
      "aria-label": say("studio_photo.canvas", { image: picture.id }),
    }, this.photo, this.over, this.status, this.tip);
    this.root = h("section", { class: "pane", "aria-label": say("studio_photo.pane", { image: picture.id }) }, this.head(), this.body);
    this.forget = tiles.onarrival(() => this.draw());
    this.watch.observe(this.body);
    this.pointers();
    this.body.addEventListener("keydown", (event) => this.key(event));
    this.body.addEventListener("focus", () => this.stage.activate(this));
    this.body.addEventListener("blur", () => this.redraw());
    void this.read();
  }

  private head(): HTMLElement {
    const image = this.picture.id;
    return h("header", {}, h("b", { class: "name" }, image),
      sign("⟲", say("studio_photo.turn_left", { image }), () => this.turn(3)),
      sign("⟳", say("studio_photo.turn_right", { image }), () => this.turn(1)),
      sign("1:1", say("studio_photo.pixels", { image }), () => this.zoom(1 / this.view.scale)),
      button("studio_photo.fit", () => this.fit(), "", { image }),
      sign("✕", say("studio_photo.close", { image }), () => this.stage.close(this)));
  }

  async read(): Promise<void> {
    try {
      this.observations = await this.model.observations(this.picture.id);
    } catch (error) {
      this.model.fail(error);
    }
    this.redraw();
  }

  gone(): void {
    this.forget();
    this.watch.disconnect();
    tiles.want(this, []);
    this.root.remove();
  }

  redraw(): void {
    this.draw();
  }

  private sized(): void {
    const { clientWidth: w, clientHeight: height } = this.body;
    for (const canvas of [this.photo, this.over]) {
      canvas.width = Math.round(w * devicePixelRatio);
      canvas.height = Math.round(height * devicePixelRatio);
    }
    this.view.resize(w, height);
    this.drawn();
  }

  // --- what is seen -----------------------------------------------------------------------------

  private rejectedHere(): Set<string> {
    return new Set(this.model.state.rejected.filter(([i]) => i === this.picture.id).map(([, p]) => p));
  }

  private placed(mark: Mark): Shown["marks"][number] {
    const at = this.measuring.moving.get(Measuring.key(mark.image, mark.point));
    return { mark, x: at?.[0] ?? mark.x, y: at?.[1] ?? mark.y };
  }

  private marks(): Shown["marks"] {
    return this.model.marksIn(this.picture.id).map((m) => this.placed(m));
  }

  private shown(): Shown {
    const { model, picture } = this;
    const prediction = model.prediction?.predictions.find((p) => p.image === picture.id) ?? null;
    return {
      observations: this.observations, rejectedHere: this.rejectedHere(), marks: this.marks(), prediction, off: model.prediction?.off.includes(picture.id) ?? false,
      image: picture.id, fiducials: model.fiducialsIn(picture.id), fiducial: model.fiducial,
      current: model.current, hover: this.hover, hair: this.keyboard && document.activeElement === this.body,
    };
  }

  private drawn(): void {
    const { view, picture } = this;
    const ratio = devicePixelRatio;
    const pen = this.photo.getContext("2d", { alpha: false })!;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.fillStyle = "#2b2b2b";
    pen.fillRect(0, 0, this.photo.width, this.photo.height);
    this.photo.style.filter = photoFilter();
    const needed = drawPhoto(pen, view, picture, ratio);
    const over = this.over.getContext("2d")!;
    over.setTransform(1, 0, 0, 1, 0, 0);
    over.clearRect(0, 0, this.over.width, this.over.height);
    masked.draw(over, view, this.model, picture, ratio);
    drawOverlay(over, view, this.shown(), ratio);
    const targets = targetLayer.on ? targetLayer.of(picture.id) : null;
    if (targets) drawTargets(over, view, targets);
    if (looks.loupe && (this.at || document.activeElement === this.body)) needed.push(...this.loupe(over, ratio));
    tiles.want(this, needed);
    this.status.textContent = picture.photo ? tiles.why(needed[0]) : say("studio_photo.unknown");
  }

  /** A part four times larger that goes with the pointer, or the cross hair. */
  private loupe(pen: CanvasRenderingContext2D, ratio: number): string[] {
    const [u, v] = this.at ?? [this.view.width / 2, this.view.height / 2];
    const [x, y] = this.view.toImage(u, v);
    const near = new View(this.picture.width, this.picture.height, this.view.turn);
    Object.assign(near, { x, y, scale: Math.min(4 * this.view.scale, Math.max(16, this.view.scale)), width: LOUPE, height: LOUPE, fitted: false });
    const left = u + LOUPE + 30 < this.view.width ? u + 24 : u - LOUPE - 24;
    const top = v + LOUPE + 30 < this.view.height ? v + 24 : v - LOUPE - 24;
    pen.save();
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.beginPath();
    pen.rect(left, top, LOUPE, LOUPE);
    pen.fillStyle = "#2b2b2b";
    pen.fill();
    pen.clip();
    pen.filter = photoFilter();
    const needed = drawPhoto(pen, near, this.picture, ratio, [left, top]);
    pen.restore();
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.beginPath();
    pen.rect(left, top, LOUPE, LOUPE);
    pen.moveTo(left + LOUPE / 2, top);
    pen.lineTo(left + LOUPE / 2, top + LOUPE);
    pen.moveTo(left, top + LOUPE / 2);
    pen.lineTo(left + LOUPE, top + LOUPE / 2);
    pen.lineWidth = 1;
    pen.strokeStyle = COLOUR.current;
    pen.stroke();
    return needed;
  }

  // --- moving -----------------------------------------------------------------------------------

  turn(by: number): void {
    this.view.turn = (this.view.turn + by) & 3;
    if (this.view.fitted) this.view.fit();
    this.redraw();
  }

  fit(): void {
    this.view.fit();
    this.redraw();
    this.showPlace();
  }

  zoom(factor: number, u?: number, v?: number): void {
    this.view.zoomAt(factor, u, v);
    this.stage.moved(this, 0, 0, factor);
    this.redraw();
    this.showPlace();
  }

  pan(du: number, dv: number): void {
    this.view.panBy(du, dv);
    this.stage.moved(this, du, dv, 1);
    this.redraw();
    this.showPlace();
  }

  /** Bring a place to the middle; no less than so large. */
  show(x: number, y: number, least = 1): void {
    this.view.scale = Math.max(this.view.scale, least);
    this.view.centre(x, y);
    this.redraw();
    this.showPlace();
  }

  private showPlace(): void {
    const [x, y] = this.keyboard || !this.at ? [this.view.x, this.view.y] : this.view.toImage(...this.at);
    this.stage.pointer(`${this.picture.id}  x ${fixed(x, 2)}  y ${fixed(y, 2)} px  ·  ${short(100 * this.view.scale, 3)} %`);
  }

  // --- the hand -----------------------------------------------------------------------------------

  private pointers(): void {
    const { body } = this;
    let down: [number, number] | null = null;
    let last: [number, number] = [0, 0];
    let dragged: Mark | null = null;
    let corner = -1;
    let far = false;
    body.addEventListener("pointerdown", (event) => {
      if (event.button > 1) return;
      body.focus();
      body.setPointerCapture(event.pointerId);
      down = last = this.place(event);
      corner = event.button === 0 ? drawing.cornerAt(this.picture.id, this.view, ...down) : -1;
      dragged = event.button === 0 && !drawing.on ? this.markAt(...down) : null;
      far = false;
    });
    body.addEventListener("pointermove", (event) => {
      const at = this.place(event);
      this.keyboard = false;
      this.at = at;
      if (down) {
        far ||= Math.hypot(at[0] - down[0], at[1] - down[1]) > 4;
        if (far && corner >= 0) drawing.move(corner, this.clamped(...at));
        else if (far && dragged) this.measuring.moving.set(Measuring.key(dragged.image, dragged.point), this.view.toImage(...at));
        else if (far) this.pan(at[0] - last[0], at[1] - last[1]);
        last = at;
        this.redraw();
      } else this.hovered(...at);
      this.showPlace();
    });
    body.addEventListener("pointerup", (event) => {
      const at = this.place(event);
      if (down && far && dragged) void this.measuring.move(dragged.image, dragged.point, ...this.view.toImage(...at), this.view.scale);
      else if (down && !far && event.button === 0) this.click(event, ...at);
      down = dragged = null;
    });
    body.addEventListener("pointercancel", () => (down = dragged = null));
    body.addEventListener("pointerleave", () => this.left());
    body.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0016)), ...this.place(event));
    }, { passive: false });
  }

  private place(event: MouseEvent): [number, number] {
    const box = this.body.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private markAt(u: number, v: number): Mark | null {
    let best: Mark | null = null;
    let least = 10;
    for (const { mark, x, y } of this.marks()) {
      const [a, b] = this.view.toScreen(x, y);
      const d = Math.hypot(a - u, b - v) - (mark.point === this.model.current ? 2 : 0);
      if (d < least) {
        least = d;
        best = mark;
      }
    }
    return best;
  }

  private pointAt(u: number, v: number): number {
    const o = this.observations;
    return o ? nearestPoint(o, filtered(o, looks.filter, this.rejectedHere()), this.view, u, v) : -1;
  }

  private click(event: MouseEvent, u: number, v: number): void {
    const { model } = this;
    if (drawing.on) {
      if (drawing.cornerAt(this.picture.id, this.view, u, v) < 0) this.enter(u, v);
      return;
    }
    if (model.fiducial) return this.enter(u, v);
    const mark = this.markAt(u, v);
    if (mark) return model.choose(mark.point);
    const row = this.pointAt(u, v);
    const free = !model.current || model.mark(this.picture.id, model.current) !== undefined;
    if (row >= 0 && (free || event.ctrlKey || event.metaKey)) return model.choose(this.observations!.point[row]);
    this.enter(u, v);
  }

  /** Mark the current point at a place of the pane. */
  enter(u = this.view.width / 2, v = this.view.height / 2): void {
    if (drawing.on) {
      if (!drawing.add(this.picture.id, this.clamped(u, v))) this.model.say("studio_point.mask_elsewhere", { image: drawing.image }, "bad");
      return;
    }
    const [x, y] = this.view.toImage(u, v);
    if (!this.view.inside(x, y)) return this.model.say("studio_photo.outside", {}, "bad");
    void this.measuring.place(this.picture.id, x, y, this.view.scale);
  }

  /** A place of the pane in the file, or the nearest one within the format: a mask may reach to its edge. */
  private clamped(u: number, v: number): [number, number] {
    const within = (value: number, most: number) => Math.round(100 * Math.min(Math.max(value, 0), most)) / 100;
    const [x, y] = this.view.toImage(u, v);
    return [within(x, this.picture.width), within(y, this.picture.height)];
  }

  private left(): void {
    this.at = null;
    this.hover = -1;
    this.tip.hidden = true;
    this.redraw();
  }

  private hovered(u: number, v: number): void {
    const row = this.pointAt(u, v);
    if (row !== this.hover || looks.loupe) this.redraw();
    this.hover = row;
    this.tip.hidden = row < 0;
    if (row < 0) return;
    this.tip.textContent = this.words(row);
    const over = u > this.view.width - 240;
    this.tip.style.left = `${over ? Math.max(u - 230, 4) : u + 16}px`;
    // the loupe is below
    this.tip.style.top = `${looks.loupe ? Math.max(v - 60, 4) : Math.min(v + 14, this.view.height - 70)}px`;
  }

  private words(i: number): string {
    const o = this.observations!;
    const status = statusOf(o, i, this.rejectedHere());
    const name = say("studio_photo.legend", { name: status });
    const lines = [
      `${o.point[i]} (${name})`,
      say("studio_photo.residual", { vx: short(o.vx[i], 2), vy: short(o.vy[i], 2), w: short(o.w[i], 2), n: o.rays[i] }),
    ];
    if (status === "rejected") lines.push(say("studio_photo.rejected", { cause: o.rejected[i] || say("studio_photo.by_hand") }));
    return lines.join("\n");
  }

  /** The image point under the pointer or the cross hair. */
  pointHere(): string | null {
    const row = this.at && !this.keyboard ? this.hover : this.pointAt(this.view.width / 2, this.view.height / 2);
    return row >= 0 ? this.observations!.point[row] : null;
  }

  private key(event: KeyboardEvent): void {
    if (!paneKeys(this, event)) return;
    event.preventDefault();
    event.stopPropagation();
    this.keyboard = true;
    this.tip.hidden = true;
    this.redraw();
    this.showPlace();
  }
}
