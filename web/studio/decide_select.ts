// Gradual selection: a limit that is moved, how much is beyond it, where that is, and one action that rejects it.
import { ask } from "./api";
import { beyond } from "./beyond";
import { afterPause, button, h } from "./dom";
import type { Ways } from "./leaf";
import { Model } from "./model";
import { count, short, withUnit } from "./numbers";
import { Criterion, Quantity, Selection } from "./types";

const STEPS = 1000;
const LISTED = 60;
const NAMES: Record<Quantity, string> = { w: "|w|", sigma: "sigma XYZ", rays: "rays", redundancy: "redundancy number" };

export class DecideSelect {
  readonly root = h("section", { class: "leaf", "aria-label": "Selection by a limit" });
  private readonly kinds = h("fieldset", { class: "kinds" }, h("legend", {}, "Image observations by"));
  private readonly slider = h("input", { type: "range", id: "select-slider", min: 0, max: STEPS, value: 0, "aria-label": "Limit" });
  private readonly limit = h("input", { type: "text", id: "select-limit", inputmode: "decimal", autocomplete: "off" });
  private readonly unit = h("span", { class: "note" });
  private readonly words = h("p", { class: "note" });
  private readonly counts = h("p", { class: "counts", role: "status", "aria-live": "polite" });
  private readonly hand = h("p", { class: "note" });
  private readonly command = h("code", { class: "command" });
  private readonly list = h("div", { class: "found", tabindex: 0, role: "region", "aria-label": "What is beyond the limit" });
  private readonly draw = h("input", { type: "checkbox", id: "select-draw" });
  private readonly reject: HTMLButtonElement;
  private readonly shows: HTMLButtonElement[];
  private criteria: Criterion[] = [];
  private by: Quantity = "w";
  private readonly limits = new Map<Quantity, number>();
  private turn = 0;
  private readonly soon = afterPause(() => void this.count(), 50);

  constructor(private readonly model: Model, private readonly ways: Ways) {
    this.reject = button("Reject all of them", "One action, taken back with one undo", () => void this.rejectAll(), "main");
    this.reject.id = "select-reject";
    this.slider.disabled = this.limit.disabled = true; // until the criteria are there
    this.shows = [
      button("Show in images", "Rings about what is beyond the limit", () => this.drawn(() => ways.images(beyond.worstImage))),
      button("Show in space", "The object points that are beyond the limit", () => this.drawn(() => ways.space())),
    ];
    this.draw.addEventListener("change", () => void this.count());
    model.on(["read", "state"], () => this.draw.checked && void this.count());
    this.slider.addEventListener("input", () => this.moved());
    this.limit.addEventListener("change", () => this.typed());
    this.root.append(this.kinds, this.words,
      h("div", { class: "limit" }, h("label", { for: "select-limit" }, "limit"), this.slider, this.limit, this.unit),
      this.counts, this.hand, h("div", { class: "deeds" }, this.reject, ...this.shows,
        h("label", { class: "row" }, this.draw, "draw it in images and space")),
      h("h3", {}, "The same on the command line"), h("p", {}, this.command), this.list);
  }

  async show(): Promise<void> {
    this.criteria = (await ask<{ criteria: Criterion[] }>("/api/criteria")).criteria;
    if (this.kinds.childElementCount < 2) this.kinds.append(...this.criteria.map((c) => this.kind(c)));
    for (const c of this.criteria) if (!this.limits.has(c.name)) this.limits.set(c.name, Number(c.begin.toPrecision(3)));
    this.slider.disabled = this.limit.disabled = false;
    this.take();
  }

  private kind(c: Criterion): HTMLElement {
    const input = h("input", { type: "radio", name: "select-by", id: `select-${c.name}`, value: c.name, checked: c.name === this.by });
    input.addEventListener("change", () => {
      this.by = c.name;
      this.take();
    });
    return h("label", { title: c.words }, input, NAMES[c.name]);
  }

  private get criterion(): Criterion {
    return this.criteria.find((c) => c.name === this.by)!;
  }

  /** Limits over the slider: even steps of the logarithm where values are spread wide, whole numbers of rays. */
  private at(step: number): number {
    const c = this.criterion;
    const share = step / STEPS;
    if (c.whole) return Math.round(2 + share * Math.max(c.high - 2, 1));
    if (c.name === "redundancy") return Number((share * Math.min(c.high, 1)).toPrecision(3));
    const low = Math.max(c.middle, c.high / 1e4) || 1e-9;
    return Number((low * (Math.max(c.high, low) / low) ** share).toPrecision(3));
  }

  private step(limit: number): number {
    let best = 0;
    for (let k = 0; k <= STEPS; k += 5) if (Math.abs(this.at(k) - limit) < Math.abs(this.at(best) - limit)) best = k;
    return best;
  }

  private take(): void {
    const c = this.criterion;
    const range = c.known ? `from ${withUnit(short(c.low), c.unit)} to ${withUnit(short(c.high), c.unit)}, half of them ${c.above ? "above" : "below"} ${withUnit(short(c.middle), c.unit)}` : "not known: the adjustment is without statistics";
    this.words.textContent = `${c.words[0].toUpperCase()}${c.words.slice(1)}: ${range}. Selected is what is ${c.above ? "above" : "below"} the limit.`;
    this.limit.value = String(this.limits.get(this.by));
    this.slider.value = String(this.step(this.limits.get(this.by)!));
    this.slider.setAttribute("aria-valuetext", this.limit.value);
    this.unit.textContent = c.unit;
    void this.count();
  }

  private moved(): void {
    const limit = this.at(Number(this.slider.value));
    this.limits.set(this.by, limit);
    this.limit.value = String(limit);
    this.slider.setAttribute("aria-valuetext", withUnit(String(limit), this.criterion.unit));
    this.soon();
  }

  private typed(): void {
    const limit = this.limit.value.trim() ? Number(this.limit.value.replace(",", ".")) : NaN;
    if (!(limit >= 0)) return this.model.say("Limit: give a number.", "bad");
    this.limits.set(this.by, limit);
    this.slider.value = String(this.step(limit));
    void this.count();
  }

  private drawn(go: () => void): void {
    this.draw.checked = true;
    void this.count().then(go);
  }

  private async count(): Promise<void> {
    const turn = ++this.turn;
    this.reject.disabled = true; // nothing is rejected whose count is not shown
    this.counts.setAttribute("aria-busy", "true");
    try {
      const found = await ask<Selection>("/api/selection", { by: this.by, limit: this.limits.get(this.by)! });
      if (turn === this.turn) this.told(found);
    } catch (error) {
      this.model.say((error as Error).message, "bad");
    }
  }

  private told(s: Selection): void {
    beyond.show(this.draw.checked ? s.rows : []);
    const share = s.used ? (100 * s.observations) / s.used : 0;
    this.counts.setAttribute("aria-busy", "false");
    this.counts.textContent = `${count(s.observations, "image observation")} of ${count(s.points, "point")} beyond it: ${short(share, 2)} % of ${s.used.toLocaleString("en")}.`;
    this.hand.textContent = s.marks ? `${count(s.marks, "mark")} made by hand beyond it: not rejected here; move or remove ${s.marks === 1 ? "it" : "them"}.` : "";
    this.command.textContent = s.command;
    this.reject.disabled = !s.observations;
    this.shows.forEach((show) => (show.disabled = !s.observations));
    const rows = s.rows.slice(0, LISTED).map(([image, point]) =>
      h("li", {}, button(`${point} in ${image}`, `Show ${point} in ${image}`, () => this.ways.visit(point, image), "link")));
    const rest = s.observations - rows.length;
    this.list.hidden = !rows.length;
    this.list.replaceChildren(h("ul", {}, ...rows), ...(rest > 0 ? [h("p", { class: "note" }, `and ${rest.toLocaleString("en")} more${s.all_shown ? "" : "; not all are drawn"}`)] : []));
  }

  private async rejectAll(): Promise<void> {
    this.reject.disabled = true;
    const limit = this.limits.get(this.by)!;
    try {
      const answer = await this.model.actions.reject(this.by, limit);
      this.model.command = answer.command;
      this.model.take(answer.state);
      this.model.say(`Rejected what is beyond ${limit} in ${NAMES[this.by]}; adjust again.`, "good");
    } catch (error) {
      this.model.say((error as Error).message, "bad");
      await this.count();
    }
  }
}
