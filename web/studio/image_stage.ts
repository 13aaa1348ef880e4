// The panes of photographs side by side, and how all of them are shown.
import { beyond } from "./beyond";
import { button, element, h } from "./dom";
import { COLOUR, Filter, looks } from "./looks";
import { Measuring } from "./measuring";
import { Model } from "./model";
import { FATES } from "./overlay_targets";
import { Pane, Stage } from "./pane";
import { targetLayer } from "./target_layer";

const LEGEND: [string, string, string][] = [
  ["used", "○", "used"], ["weak", "□", "fewer than 3 rays"], ["rejected", "✕", "rejected"],
  ["control", "△", "control"], ["check", "◇", "check"], ["mark", "✛", "marked by hand"], ["predicted", "◌", "predicted, 1 and 3 sigma"],
  ["beyond", "◯", "beyond the limit"], ["masked", "▨", "masked"],
];

export class ImageStage implements Stage {
  private panes: Pane[] = [];
  private most = 1;
  private readonly box = element("panes");
  private counts: HTMLButtonElement[] = [];
  private loupe!: HTMLInputElement;
  private readonly targets = h("input", { type: "checkbox", id: "targets" });

  constructor(private readonly model: Model, private readonly measuring: Measuring, private readonly tell: (words: string) => void) {
    element("looks").append(...this.bar());
    element("image-legend").append(...LEGEND.map(([name, sign, words]) => {
      const dot = h("span", { class: "sign", "aria-hidden": "true" }, sign);
      dot.style.color = COLOUR[name as keyof typeof COLOUR];
      return h("li", { id: `legend-${name}`, hidden: name === "beyond" || name === "masked" }, dot, words);
    }));
    model.on(["looks", "state", "prediction", "current", "fiducial"], () => this.panes.forEach((p) => p.redraw()));
    beyond.onchange(() => {
      element("legend-beyond").hidden = !beyond.points.size;
      this.panes.forEach((p) => p.redraw());
    });
    this.targets.addEventListener("change", () => targetLayer.switch(this.targets.checked));
    const legend = FATES.map(([, colour, sign, words]) => {
      const dot = h("span", { class: "sign", "aria-hidden": "true" }, sign);
      dot.style.color = colour;
      return h("li", { hidden: true }, dot, words);
    });
    element("image-legend").append(...legend);
    targetLayer.onchange(() => {
      this.targets.checked = targetLayer.on;
      legend.forEach((each) => (each.hidden = !targetLayer.on));
      if (targetLayer.on && targetLayer.told) model.say(targetLayer.told, "bad");
      this.panes.forEach((p) => p.redraw());
    });
    model.on("read", () => targetLayer.forget());
    model.on("observations", () => this.panes.forEach((p) => void p.read()));
    model.on("overview", () => this.begin());
    model.on(["overview", "state"], () => (element("legend-masked").hidden = !model.state.masks.length && !model.overview.masks_given));
  }

  private bar(): HTMLElement[] {
    this.counts = [1, 2, 4].map((n) => {
      const words = n === 1 ? "1 image" : `${n} images side by side`;
      const made = button(String(n), words, () => this.setCount(n));
      made.setAttribute("aria-label", words);
      return made;
    });
    const filters: [Filter, string][] = [
      ["all", "all"], ["rejected", "rejected"], ["weak", "weak"], ["control", "control"], ["worst", "worst |w|"], ["none", "none"],
    ];
    const select = h("select", { id: "filter" }, ...filters.map(([value, words]) => h("option", { value }, words)));
    select.addEventListener("change", () => this.look(() => (looks.filter = select.value as Filter)));
    this.loupe = h("input", { type: "checkbox", id: "loupe" });
    this.loupe.addEventListener("change", () => this.look(() => (looks.loupe = this.loupe.checked)));
    const linked = h("input", { type: "checkbox", id: "linked", checked: true });
    linked.addEventListener("change", () => (looks.linked = linked.checked));
    return [
      h("span", { class: "group", role: "group", "aria-label": "Number of images" }, ...this.counts),
      h("label", {}, linked, "linked"), h("label", {}, this.loupe, "loupe"),
      h("label", { title: "Targets found in the photographs" }, this.targets, "targets"), h("label", {}, "points", select),
      this.slider("vectors", "residuals", 0, 30, 16, (v) => (looks.vectors = v ? Math.round(10 ** (v / 10)) : 0), () => String(looks.vectors)),
      this.slider("brightness", "brightness", 2, 30, 10, (v) => (looks.brightness = v / 10), () => looks.brightness.toFixed(1)),
      this.slider("contrast", "contrast", 2, 30, 10, (v) => (looks.contrast = v / 10), () => looks.contrast.toFixed(1)),
    ];
  }

  private slider(id: string, words: string, min: number, max: number, value: number, take: (v: number) => void, told: () => string): HTMLElement {
    const input = h("input", { type: "range", id, min, max, value });
    const out = h("output", { for: id }, told());
    input.addEventListener("input", () => this.look(() => {
      take(Number(input.value));
      out.textContent = told();
    }));
    input.addEventListener("dblclick", () => {
      input.value = String(value);
      input.dispatchEvent(new Event("input"));
    });
    const title = id === "vectors" ? "Length on the screen of a residual of 1 px" : "A double click sets it back";
    return h("label", { title }, words, input, out);
  }

  private look(change: () => void): void {
    change();
    this.model.emit("looks");
  }

  toggleLoupe(on = !looks.loupe): void {
    this.loupe.checked = on;
    this.look(() => (looks.loupe = on));
  }

  // --- panes ------------------------------------------------------------------------------------

  private begin(): void {
    this.panes = this.panes.filter((pane) => this.model.images.has(pane.picture.id) || (pane.gone(), false));
    for (const { picture } of this.panes) Object.assign(picture, this.model.images.get(picture.id)); // it may have another number
    const first = [...this.model.images.values()];
    if (!this.panes.length && first.length) this.open((first.find((p) => p.photo) ?? first[0]).id);
    this.arranged();
  }

  setCount(n: number): void {
    this.most = n;
    while (this.panes.length > n) this.panes.pop()!.gone();
    const here = new Set(this.panes.map((p) => p.picture.id));
    const active = this.activePane?.picture.k ?? 0;
    const every = [...this.model.images.values()];
    for (let d = 1; d < every.length && this.panes.length < n; d++) {
      const next = every[(active + d) % every.length];
      if (!here.has(next.id)) this.add(next.id);
    }
    this.arranged();
  }

  /** Show an image: in the active pane, or in one more. */
  open(image: string, beside = false): Pane {
    const there = this.panes.find((p) => p.picture.id === image);
    if (there) {
      this.activate(there);
      return there;
    }
    if (beside && this.panes.length < 4) {
      this.most = Math.max(this.most, this.panes.length + 1 > 2 ? 4 : 2);
      const added = this.add(image);
      this.activate(added);
      return added;
    }
    const old = this.activePane;
    const made = this.add(image, old);
    if (old) {
      this.panes.splice(this.panes.indexOf(old), 1);
      old.gone();
    }
    this.model.active = this.panes.indexOf(made);
    this.arranged();
    return made;
  }

  private add(image: string, before?: Pane): Pane {
    const made = new Pane(this.model, this.measuring, this, this.model.images.get(image)!);
    if (before) {
      before.root.before(made.root);
      this.panes.splice(this.panes.indexOf(before), 0, made);
    } else {
      this.box.append(made.root);
      this.panes.push(made);
    }
    return made;
  }

  private arranged(): void {
    this.box.className = `panes${this.most > 2 ? 4 : this.most}`;
    [1, 2, 4].forEach((n, k) => this.counts[k].setAttribute("aria-pressed", String(n === this.most)));
    const active = Math.min(Math.max(this.model.active, 0), this.panes.length - 1);
    this.panes.forEach((p, k) => p.root.classList.toggle("active", k === active));
    this.model.setPanes(this.panes.map((p) => p.picture.id), active);
  }

  get activePane(): Pane | undefined {
    return this.panes[this.model.active] ?? this.panes[0];
  }

  activate(pane: Pane): void {
    const k = this.panes.indexOf(pane);
    if (k === this.model.active && pane.root.classList.contains("active")) return;
    this.model.active = k;
    this.arranged();
  }

  close(pane: Pane): void {
    if (this.panes.length < 2) return this.model.say("The last image stays open.");
    this.panes.splice(this.panes.indexOf(pane), 1);
    pane.gone();
    this.most = this.panes.length > 2 ? 4 : this.panes.length;
    this.arranged();
    this.activePane?.body.focus();
  }

  moved(pane: Pane, du: number, dv: number, factor: number): void {
    if (!looks.linked) return;
    for (const other of this.panes) {
      if (other === pane) continue;
      if (factor !== 1) other.view.zoomAt(factor);
      else other.view.panBy(du, dv);
      other.redraw();
    }
  }

  pointer(words: string): void {
    this.tell(words);
  }

  /** Open an image with a place of it in the middle. */
  visit(image: string, x: number, y: number, scale = 1): void {
    const pane = this.open(image);
    requestAnimationFrame(() => {
      pane.show(x, y, scale);
      pane.body.focus();
    });
  }

  /** The image before or behind that of the active pane. */
  step(by: number): void {
    const every = [...this.model.images.keys()];
    const here = every.indexOf(this.activePane?.picture.id ?? "");
    this.open(every[(here + by + every.length) % every.length]).body.focus();
  }

  /** Bring the current point to the middle of every pane in which its place is known. */
  centre(): void {
    for (const pane of this.panes) {
      const mark = this.model.mark(pane.picture.id, this.model.current);
      const p = this.model.prediction?.predictions.find((q) => q.image === pane.picture.id);
      if (mark) pane.show(mark.x, mark.y);
      else if (p && p.x !== null && p.y !== null && p.inside) pane.show(p.x, p.y);
    }
  }
}
