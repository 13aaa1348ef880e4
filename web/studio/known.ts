// What is known beside the photographs: scale bars, control coordinates, tables dropped on the window.
import { ask } from "./api";
import { button, element, h } from "./dom";
import { Model } from "./model";
import { count, short, withUnit } from "./numbers";
import { Page, PointRow, Role, Three } from "./types";

export const field = (id: string, words: string, more: Record<string, string> = {}) =>
  h("input", { id, "aria-label": words, placeholder: words, autocomplete: "off", spellcheck: "false", ...more });

/** A number as people write it; NaN for what is none, null for nothing. */
export function number(input: HTMLInputElement): number | null {
  const text = input.value.trim().replace(",", ".");
  return text ? Number(text) : null;
}

export function need(model: Model, input: HTMLInputElement, value: number | null): value is number {
  if (value !== null && Number.isFinite(value)) return true;
  model.say(`${input.getAttribute("aria-label")}: give a number.`, "bad");
  input.focus();
  return false;
}

export class Bars {
  private readonly start = field("bar-start", "from point", { list: "bar-names" });
  private readonly end = field("bar-end", "to point", { list: "bar-names" });
  private readonly length = field("bar-length", "length", { inputmode: "decimal" });
  private readonly sigma = field("bar-sigma", "sigma", { inputmode: "decimal" });
  private readonly names = h("datalist", { id: "bar-names" });
  private readonly rows = h("table", { "aria-label": "Scale bars" });
  private readonly head = h("summary", {}, "Scale bars");

  constructor(private readonly model: Model) {
    const form = h("form", {},
      h("div", { class: "row" }, this.start, this.end, button("⇤", "Both ends: the two points that were measured last", () => this.latest())),
      h("div", { class: "row" }, this.length, this.sigma, h("button", { type: "submit", id: "bar-add" }, "Give"), this.names));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.give();
    });
    element("right").append(h("details", { class: "card", open: true }, this.head, this.rows, form));
    model.on(["state", "overview"], () => this.show());
    // a point that is chosen while an end is empty is that end
    model.on("current", () => {
      if (!model.current || document.activeElement === this.start || document.activeElement === this.end) return;
      if (!this.start.value) this.start.placeholder = `from point, as ${model.current}`;
    });
  }

  private latest(): void {
    const names = [...new Set([...this.model.state.marks].reverse().map((m) => m.point))];
    [this.end.value, this.start.value] = [names[0] ?? "", names[1] ?? ""];
    this.length.focus();
  }

  private async give(): Promise<void> {
    const [length, sigma] = [number(this.length), number(this.sigma)];
    if (!need(this.model, this.length, length) || !need(this.model, this.sigma, sigma)) return;
    const [start, end] = [this.start.value.trim(), this.end.value.trim()];
    const done = await this.model.act("bar", { start, end, length, sigma }, `scale bar ${start} – ${end}: ${length}`);
    if (done) [this.start, this.end, this.length, this.sigma].forEach((input) => (input.value = ""));
  }

  private show(): void {
    const { state, overview } = this.model;
    const unit = overview.unit;
    this.head.textContent = state.bars.length ? `Scale bars: ${state.bars.length}` : "Scale bars";
    this.length.placeholder = withUnit("length", unit || "m");
    this.sigma.placeholder = withUnit("sigma", unit || "m");
    this.names.replaceChildren(...state.points.slice(-200).map((p) => h("option", { value: p.point })));
    this.rows.hidden = !state.bars.length;
    this.rows.replaceChildren(...state.bars.map((b) => h("tr", {},
      h("td", {}, `${b.start} – ${b.end}`), h("td", {}, String(b.length)), h("td", {}, `± ${short(b.sigma)}`),
      h("td", {}, button("✕", `Take the scale bar ${b.start} – ${b.end} away`,
        () => void this.model.act("unbar", { start: b.start, end: b.end }, "scale bar taken away"), "small")))));
  }
}

export class Control {
  private readonly role = h("select", { id: "control-role", "aria-label": "Role of the current point" },
    ...["tie", "control", "check"].map((role) => h("option", { value: role }, role)));
  private readonly xyz = ["X", "Y", "Z"].map((axis) => field(`control-${axis}`, axis, { inputmode: "decimal" }));
  private readonly sigma = ["X", "Y", "Z"].map((axis) => field(`control-s${axis}`, `sigma ${axis}`, { inputmode: "decimal" }));
  private readonly rows = h("table", { "aria-label": "Control and check points" });
  private readonly head = h("summary", {}, "Control");
  private readonly whose = h("p", { class: "note" });

  constructor(private readonly model: Model) {
    const file = h("input", { type: "file", id: "control-file", accept: ".csv,.txt,text/csv", "aria-label": "Table of control coordinates" });
    file.addEventListener("change", () => void (file.files?.[0] && this.drop(file.files[0]).then(() => (file.value = ""))));
    const form = h("form", {}, this.whose,
      h("div", { class: "row" }, this.role, h("button", { type: "submit", id: "control-give" }, "Give")),
      h("div", { class: "row three" }, ...this.xyz), h("div", { class: "row three" }, ...this.sigma),
      h("p", { class: "note" }, "A table point,X,Y,Z,sX,sY,sZ may be dropped anywhere on this window."), file);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.give();
    });
    element("right").append(h("details", { class: "card" }, this.head, this.rows, form));
    model.on(["state", "overview"], () => this.show());
    model.on("current", () => void this.fill());
    this.dropping();
  }

  private dropping(): void {
    addEventListener("dragover", (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      document.body.classList.add("dropping");
    });
    addEventListener("dragleave", (event) => event.relatedTarget === null && document.body.classList.remove("dropping"));
    addEventListener("drop", (event) => {
      event.preventDefault();
      document.body.classList.remove("dropping");
      const file = event.dataTransfer?.files[0];
      if (file) void this.drop(file);
    });
  }

  /** Give a table of control coordinates. */
  private async drop(file: File): Promise<void> {
    if (file.size > 4e6) return this.model.say(`${file.name} is too large for a table of control coordinates.`, "bad");
    try {
      const answer = await this.model.actions.control(file.name, await file.text());
      this.model.command = answer.command;
      this.model.take(answer.state);
      this.model.say([`${count(answer.added.length, "control point")} from ${file.name}`, ...answer.remarks].join("; "), "good");
    } catch (error) {
      this.model.say(`${file.name}: ${(error as Error).message}`, "bad");
    }
  }

  private async give(): Promise<void> {
    const { model } = this;
    if (!model.current) return model.say("No point is chosen.", "bad");
    const [xyz, sigma] = [this.xyz.map(number), this.sigma.map(number)];
    for (const [k, value] of [...xyz, ...sigma].entries()) {
      const input = [...this.xyz, ...this.sigma][k];
      if (value !== null && !need(model, input, value)) return;
    }
    const role = this.role.value as Role;
    await model.act("point", { point: model.current, role, xyz, sigma }, `${model.current}: ${role}`);
  }

  private fields(role: Role, xyz: Three, sigma: Three): void {
    this.role.value = role;
    this.xyz.forEach((input, k) => (input.value = xyz[k] === null ? "" : String(xyz[k])));
    this.sigma.forEach((input, k) => (input.value = sigma[k] === null ? "" : String(sigma[k])));
  }

  /** What the current point was given; nothing where it was given nothing. */
  private async fill(): Promise<void> {
    const { model } = this;
    const point = model.current;
    const given = model.state.points.find((p) => p.point === point);
    this.whose.textContent = point ? `of ${point}` : "of the current point";
    this.fields(given?.role ?? "tie", given?.xyz ?? [null, null, null], given?.sigma ?? [null, null, null]);
    if (given || !point) return;
    const found = await ask<Page<PointRow>>("/api/points", { search: point, limit: 200 });
    const row = found.rows.find((r) => r.point === point);
    if (row && model.current === point) this.role.value = row.role;
  }

  private show(): void {
    const { state } = this.model;
    const told = state.points.filter((p) => p.role !== "tie" || p.xyz.some((v) => v !== null));
    this.head.textContent = told.length ? `Control: ${told.length}` : "Control";
    this.rows.hidden = !told.length;
    this.rows.replaceChildren(...told.slice(0, 300).map((p) => h("tr", {},
      h("td", {}, button(p.point, `Choose ${p.point}`, () => this.model.choose(p.point), "link")), h("td", {}, p.role),
      ...p.xyz.map((v) => h("td", {}, short(v, 7))))));
    if (!(document.activeElement instanceof HTMLInputElement)) void this.fill();
  }
}
