// The panes of photographs side by side, and how all of them are shown.
import { beyond } from "./beyond";
import { choices, element, h, sign } from "./dom";
import { COLOUR, Filter, looks } from "./looks";
import { Measuring } from "./measuring";
import { Model } from "./model";
import { fixed } from "./numbers";
import { FATES } from "./overlay_targets";
import { Pane, Stage } from "./pane";
import { targetLayer } from "./target_layer";
import { say, titleOf } from "./words";

const LEGEND = {
  used: "○", weak: "□", rejected: "✕", control: "△", check: "◇", mark: "✛", predicted: "◌", beyond: "◯", masked: "▨",
};
const FILTERS: Filter[] = ["all", "rejected", "weak", "control", "worst", "none"];

export class ImageStage implements Stage {
  private panes: Pane[] = [];
  private most = 1;
  private readonly box = element("panes");
  private counts: HTMLButtonElement[] = [];
  private loupe!: HTMLInputElement;
  private readonly targets = h("input", { type: "checkbox", id: "targets" });

  constructor(private readonly model: Model, private readonly measuring: Measuring, private readonly showPlace: (words: string) => void) {
    element("looks").append(...this.bar());
    element("image-legend").append(...Object.entries(LEGEND).map(([name, shape]) => {
      const dot = h("span", { class: "sign", "aria-hidden": "true" }, shape);
      dot.style.color = COLOUR[name as keyof typeof COLOUR];
      return h("li", { id: `legend-${name}`, hidden: name === "beyond" || name === "masked" }, dot, say("studio_photo.legend", { name }));
    }));
    model.on(["looks", "state", "prediction", "current", "fiducial"], () => this.panes.forEach((p) => p.redraw()));
    beyond.onchange(() => {
      element("legend-beyond").hidden = !beyond.points.size;
      this.panes.forEach((p) => p.redraw());
    });
    this.targets.addEventListener("change", () => targetLayer.switch(this.targets.checked));
    const legend = FATES.map(([fate, colour, shape]) => {
      const dot = h("span", { class: "sign", "aria-hidden": "true" }, shape);
      dot.style.color = colour;
      return h("li", { hidden: true, id: `legend-target-${fate}` }, dot, say("studio_target.legend", { fate }));
    });
    element("image-legend").append(...legend);
    targetLayer.onchange(() => {
      this.targets.checked = targetLayer.on;
      legend.forEach((each) => (each.hidden = !targetLayer.on));
      if (targetLayer.on && targetLayer.reason) model.show(targetLayer.reason, "bad");
      this.panes.forEach((p) => p.redraw());
    });
    model.on("read", () => targetLayer.forget());
    model.on("observations", () => this.panes.forEach((p) => void p.read()));
    model.on("overview", () => this.begin());
    model.on(["overview", "state"], () => (element("legend-masked").hidden = !model.state.masks.length && !model.overview.masks_given));
  }

  private bar(): HTMLElement[] {
    this.counts = [1, 2, 4].map((n) => {
      const words = say("studio_photo.panes", { n });
      const made = sign(String(n), words, () => this.setCount(n));
      made.setAttribute("aria-label", words);
      return made;
    });
    const select = h("select", { id: "filter" }, ...choices(FILTERS, (filter) => say("studio_photo.filter", { filter }), looks.filter));
    select.addEventListener("change", () => this.look(() => (looks.filter = select.value as Filter)));
    this.loupe = h("input", { type: "checkbox", id: "loupe" });
    this.loupe.addEventListener("change", () => this.look(() => (looks.loupe = this.loupe.checked)));
    const linked = h("input", { type: "checkbox", id: "linked", checked: true });
    linked.addEventListener("change", () => (looks.linked = linked.checked));
    return [
      h("span", { class: "group", role: "group", "aria-label": say("studio_photo.pane_count") }, ...this.counts),
      h("label", {}, linked, say("studio_photo.linked")), h("label", {}, this.loupe, say("studio_photo.loupe")),
      h("label", { title: titleOf("studio_photo.targets") }, this.targets, say("studio_photo.targets")), h("label", {}, say("label.points"), select),
      this.slider("vectors", "studio_photo.residuals", 0, 30, 16, (v) => (looks.vectors = v ? Math.round(10 ** (v / 10)) : 0), () => String(looks.vectors)),
      this.slider("brightness", "studio_photo.brightness", 2, 30, 10, (v) => (looks.brightness = v / 10), () => fixed(looks.brightness, 1)),
      this.slider("contrast", "studio_photo.contrast", 2, 30, 10, (v) => (looks.contrast = v / 10), () => fixed(looks.contrast, 1)),
    ];
  }

  private slider(id: string, code: string, min: number, max: number, value: number, take: (v: number) => void, shown: () => string): HTMLElement {
    const input = h("input", { type: "range", id, min, max, value });
    const out = h("output", { for: id }, shown());
    input.addEventListener("input", () => this.look(() => {
      take(Number(input.value));
      out.textContent = shown();
    }));
    input.addEventListener("dblclick", () => {
      input.value = String(value);
      input.dispatchEvent(new Event("input"));
    });
    return h("label", { title: titleOf(code) }, say(code), input, out);
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
    if (this.panes.length < 2) return this.model.say("studio_photo.last_open");
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
    this.showPlace(words);
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
