// What is known beside the photographs: scale bars, control coordinates, tables dropped on the window.
import { ask } from "./api";
import { choices, element, h, sign } from "./dom";
import { Model } from "./model";
import { short, withUnit } from "./numbers";
import { Page, PointRow, Role, Three } from "./types";
import { say } from "./words";

export const field = (id: string, words: string, more: Record<string, string> = {}) =>
  h("input", { id, "aria-label": words, placeholder: words, autocomplete: "off", spellcheck: "false", ...more });

/** A number as people write it; NaN for what is none, null for nothing. */
export function number(input: HTMLInputElement): number | null {
  const text = input.value.trim().replace(",", ".");
  return text ? Number(text) : null;
}

export function need(model: Model, input: HTMLInputElement, value: number | null): value is number {
  if (value !== null && Number.isFinite(value)) return true;
  model.say("studio_point.number_missing", { field: input.getAttribute("aria-label") }, "bad");
  input.focus();
  return false;
}

/** A heading, and how many there are. */
export const counted = (words: string, n: number): string => (n ? `${words}: ${n}` : words);

export class Bars {
  private readonly start = field("bar-start", say("studio_point.bar_start"), { list: "bar-names" });
  private readonly end = field("bar-end", say("studio_point.bar_end"), { list: "bar-names" });
  private readonly length = field("bar-length", say("label.length"), { inputmode: "decimal" });
  private readonly sigma = field("bar-sigma", say("label.sigma"), { inputmode: "decimal" });
  private readonly names = h("datalist", { id: "bar-names" });
  private readonly rows = h("table", { "aria-label": say("studio_point.bars") });
  private readonly head = h("summary", {}, say("studio_point.bars"));

  constructor(private readonly model: Model) {
    const form = h("form", {},
      h("div", { class: "row" }, this.start, this.end, sign("⇤", say("studio_point.last_two"), () => this.latest())),
      h("div", { class: "row" }, this.length, this.sigma, h("button", { type: "submit", id: "bar-add" }, say("studio_point.give")), this.names));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.give();
    });
    element("right").append(h("details", { class: "card", open: true }, this.head, this.rows, form));
    model.on(["state", "overview"], () => this.show());
    // a point that is chosen while an end is empty is that end
    model.on("current", () => {
      if (!model.current || document.activeElement === this.start || document.activeElement === this.end) return;
      if (!this.start.value) this.start.placeholder = say("studio_point.bar_start_as", { point: model.current });
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
    const done = await this.model.act("bar", { start, end, length, sigma }, "studio_point.bar_given", { start, end, length: String(length) });
    if (done) [this.start, this.end, this.length, this.sigma].forEach((input) => (input.value = ""));
  }

  private show(): void {
    const { state, overview } = this.model;
    const unit = overview.unit;
    this.head.textContent = counted(say("studio_point.bars"), state.bars.length);
    this.length.placeholder = withUnit(say("label.length"), unit || "m");
    this.sigma.placeholder = withUnit(say("label.sigma"), unit || "m");
    this.names.replaceChildren(...state.points.slice(-200).map((p) => h("option", { value: p.point })));
    this.rows.hidden = !state.bars.length;
    this.rows.replaceChildren(...state.bars.map((b) => h("tr", {},
      h("td", {}, `${b.start} – ${b.end}`), h("td", {}, String(b.length)), h("td", {}, `± ${short(b.sigma)}`),
      h("td", {}, sign("✕", say("studio_point.remove", { name: `${b.start} – ${b.end}` }),
        () => void this.model.act("unbar", { start: b.start, end: b.end }, "studio_point.removed", { name: `${b.start} – ${b.end}` }), "small")))));
  }
}

export class Control {
  private readonly role = h("select", { id: "control-role", "aria-label": say("studio_point.role_of_current") },
    ...choices(["tie", "control", "check"], (role) => say("studio_point.role", { role })));
  private readonly xyz = ["X", "Y", "Z"].map((axis) => field(`control-${axis}`, axis, { inputmode: "decimal" }));
  private readonly sigma = ["X", "Y", "Z"].map((axis) => field(`control-s${axis}`, say("label.sigma_of", { symbol: axis }), { inputmode: "decimal" }));
  private readonly rows = h("table", { "aria-label": say("studio_point.control") });
  private readonly head = h("summary", {}, say("studio_point.control"));
  private readonly about = h("p", { class: "note" });

  constructor(private readonly model: Model) {
    const file = h("input", { type: "file", id: "control-file", accept: ".csv,.txt,text/csv", "aria-label": say("studio_point.control_table") });
    file.addEventListener("change", () => void (file.files?.[0] && this.drop(file.files[0]).then(() => (file.value = ""))));
    const form = h("form", {}, this.about,
      h("div", { class: "row" }, this.role, h("button", { type: "submit", id: "control-give" }, say("studio_point.give"))),
      h("div", { class: "row three" }, ...this.xyz), h("div", { class: "row three" }, ...this.sigma),
      h("p", { class: "note" }, say("studio_point.control_note")), file);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.give();
    });
    element("right").append(h("details", { class: "card" }, this.head, this.rows, form));
    model.on(["state", "overview"], () => this.show());
    model.on("current", () => void this.fill());
    document.body.dataset.drop = say("studio_point.drop");
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
    if (file.size > 4e6) return this.model.say("studio_point.table_too_large", { name: file.name }, "bad");
    try {
      const answer = await this.model.actions.control(file.name, await file.text());
      this.model.command = answer.command;
      this.model.take(answer.state);
      this.model.show([say("studio_point.control_added", { n: answer.added.length, name: file.name }), ...answer.remarks].join("; "), "good", "studio_point.control_added");
    } catch (error) {
      this.model.fail(error);
    }
  }

  private async give(): Promise<void> {
    const { model } = this;
    if (!model.current) return model.say("studio_point.none_chosen", {}, "bad");
    const [xyz, sigma] = [this.xyz.map(number), this.sigma.map(number)];
    for (const [k, value] of [...xyz, ...sigma].entries()) {
      const input = [...this.xyz, ...this.sigma][k];
      if (value !== null && !need(model, input, value)) return;
    }
    const role = this.role.value as Role;
    await model.act("point", { point: model.current, role, xyz, sigma }, "studio_point.role_given", { point: model.current, role });
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
    this.about.textContent = point ? say("studio_point.of_point", { point }) : say("studio_point.none_chosen");
    this.fields(given?.role ?? "tie", given?.xyz ?? [null, null, null], given?.sigma ?? [null, null, null]);
    if (given || !point) return;
    const found = await ask<Page<PointRow>>("/api/points", { search: point, limit: 200 });
    const row = found.rows.find((r) => r.point === point);
    if (row && model.current === point) this.role.value = row.role;
  }

  private show(): void {
    const { state } = this.model;
    const given = state.points.filter((p) => p.role !== "tie" || p.xyz.some((v) => v !== null));
    this.head.textContent = counted(say("studio_point.control"), given.length);
    this.rows.hidden = !given.length;
    this.rows.replaceChildren(...given.slice(0, 300).map((p) => h("tr", {},
      h("td", {}, sign(p.point, say("studio_point.choose", { point: p.point }), () => this.model.choose(p.point), "link")), h("td", {}, say("studio_point.role", { role: p.role })),
      ...p.xyz.map((v) => h("td", {}, short(v, 7))))));
    if (!(document.activeElement instanceof HTMLInputElement)) void this.fill();
  }
}
