// Gradual selection: a limit that is moved, how much is beyond it, where that is, and one action that rejects it.
import { ask } from "./api";
import { beyond } from "./beyond";
import { afterPause, button, h, sign } from "./dom";
import type { Ways } from "./leaf";
import { Model } from "./model";
import { short, withUnit } from "./numbers";
import { Criterion, Quantity, Selection } from "./types";
import { say } from "./words";

const STEPS = 1000;
const LISTED = 60;

export class DecideSelect {
  readonly root = h("section", { class: "leaf", "aria-label": say("studio_decide.select") });
  private readonly kinds = h("fieldset", { class: "kinds" }, h("legend", {}, say("studio_decide.observations_by")));
  private readonly slider = h("input", { type: "range", id: "select-slider", min: 0, max: STEPS, value: 0, "aria-label": say("studio_decide.limit") });
  private readonly limit = h("input", { type: "text", id: "select-limit", inputmode: "decimal", autocomplete: "off" });
  private readonly unit = h("span", { class: "note" });
  private readonly words = h("p", { class: "note" });
  private readonly counts = h("p", { class: "counts", role: "status", "aria-live": "polite" });
  private readonly hand = h("p", { class: "note" });
  private readonly command = h("code", { class: "command" });
  private readonly list = h("div", { class: "found", tabindex: 0, role: "region", "aria-label": say("studio_decide.beyond") });
  private readonly draw = h("input", { type: "checkbox", id: "select-draw" });
  private readonly reject: HTMLButtonElement;
  private readonly shows: HTMLButtonElement[];
  private criteria: Criterion[] = [];
  private by: Quantity = "w";
  private readonly limits = new Map<Quantity, number>();
  private turn = 0;
  private readonly soon = afterPause(() => void this.count(), 50);

  constructor(private readonly model: Model, private readonly ways: Ways) {
    this.reject = button("studio_decide.reject_all", () => void this.rejectAll(), "main");
    this.reject.id = "select-reject";
    this.slider.disabled = this.limit.disabled = true; // until the criteria are there
    this.shows = [
      button("studio_decide.show_in_images", () => this.drawn(() => ways.images(beyond.worstImage))),
      button("studio_decide.show_in_space", () => this.drawn(() => ways.space())),
    ];
    this.draw.addEventListener("change", () => void this.count());
    model.on(["read", "state"], () => this.draw.checked && void this.count());
    this.slider.addEventListener("input", () => this.moved());
    this.limit.addEventListener("change", () => this.setLimit());
    this.root.append(this.kinds, this.words,
      h("div", { class: "limit" }, h("label", { for: "select-limit" }, say("studio_decide.limit")), this.slider, this.limit, this.unit),
      this.counts, this.hand, h("div", { class: "deeds" }, this.reject, ...this.shows,
        h("label", { class: "row" }, this.draw, say("studio_decide.draw"))),
      h("h3", {}, say("studio_decide.command")), h("p", {}, this.command), this.list);
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
    return h("label", { title: say("studio_decide.quantity_meaning", { quantity: c.name }) }, input, say("studio_decide.quantity", { quantity: c.name }));
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
    const [low, high, middle] = [c.low, c.high, c.middle].map((v) => withUnit(short(v), c.unit));
    const side = c.above ? "above" : "below";
    const range = c.known ? say("studio_decide.range", { low, high, middle }) : say("studio_decide.no_range");
    this.words.textContent = [say("studio_decide.quantity_meaning", { quantity: c.name }), range, say("studio_decide.selected", { side })].join(" ");
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

  private setLimit(): void {
    const limit = this.limit.value.trim() ? Number(this.limit.value.replace(",", ".")) : NaN;
    if (!(limit >= 0)) return this.model.say("studio_point.number_missing", { field: say("studio_decide.limit") }, "bad");
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
    this.reject.disabled = true; // nothing is rejected before its count is shown
    this.counts.setAttribute("aria-busy", "true");
    try {
      const found = await ask<Selection>("/api/selection", { by: this.by, limit: this.limits.get(this.by)! });
      if (turn === this.turn) this.report(found);
    } catch (error) {
      this.model.fail(error);
    }
  }

  private report(s: Selection): void {
    beyond.show(this.draw.checked ? s.rows : []);
    const share = s.used ? (100 * s.observations) / s.used : 0;
    this.counts.setAttribute("aria-busy", "false");
    this.counts.textContent = say("studio_decide.counts", { n: s.observations, points: s.points, percent: short(share, 2), used: s.used });
    this.hand.textContent = s.marks ? say("studio_decide.marks_beyond", { n: s.marks }) : "";
    this.command.textContent = s.command;
    this.reject.disabled = !s.observations;
    this.shows.forEach((show) => (show.disabled = !s.observations));
    const rows = s.rows.slice(0, LISTED).map(([image, point]) =>
      h("li", {}, sign(say("studio_decide.point_in_image", { point, image }), say("studio_decide.show_point", { point, image }), () => this.ways.visit(point, image), "link")));
    const rest = s.observations - rows.length;
    this.list.hidden = !rows.length;
    this.list.replaceChildren(h("ul", {}, ...rows), ...(rest > 0 ? [h("p", { class: "note" }, say("studio_decide.more", { n: rest, drawn: s.all_shown ? "all" : "some" }))] : []));
  }

  private async rejectAll(): Promise<void> {
    this.reject.disabled = true;
    const limit = this.limits.get(this.by)!;
    try {
      const answer = await this.model.actions.reject(this.by, limit);
      this.model.command = answer.command;
      this.model.take(answer.state);
      this.model.say("studio_decide.rejected", { limit: short(limit), quantity: this.by }, "good");
    } catch (error) {
      this.model.fail(error);
      await this.count();
    }
  }
}
