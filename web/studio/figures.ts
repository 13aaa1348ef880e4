// Points together: lines, levels and planes, a coordinate system by some of them; and another name for a point.
import { ask } from "./api";
import { afterPause, button, choices, element, h, sign } from "./dom";
import { counted, field, need, number } from "./known";
import { Model } from "./model";
import { short, withUnit } from "./numbers";
import { Page, PointRow } from "./types";
import { say, titleOf } from "./words";

/** A field for a point's name that suggests those that there are. */
function pointField(id: string, words: string): [HTMLInputElement, HTMLDataListElement] {
  const names = h("datalist", { id: `${id}-names` });
  const input = field(id, words, { list: `${id}-names`, maxlength: "200" });
  input.addEventListener("input", afterPause(() => void ask<Page<PointRow>>("/api/points", { search: input.value.trim(), limit: 12 })
    .then((found) => names.replaceChildren(...found.rows.map((row) => h("option", { value: row.point }))), () => {}), 150));
  return [input, names];
}

export class Lines {
  private readonly name = field("line-name", say("studio_point.line_name"), { maxlength: "200" });
  private readonly kind = h("select", { id: "line-kind", "aria-label": say("studio_point.line_kinds") },
    ...choices(["straight", "plumb", "level", "plane"], (kind) => say("studio_point.line_kind", { kind })));
  private readonly sigma = field("line-sigma", say("label.sigma"), { inputmode: "decimal" });
  private readonly point: HTMLInputElement;
  private readonly follow = h("input", { type: "checkbox", id: "line-follow" });
  private readonly picked = h("ol", { class: "picked", id: "line-points", "aria-label": say("studio_point.line_points") });
  private readonly rows = h("table", { "aria-label": say("studio_point.lines") });
  private readonly head = h("summary", {}, say("studio_point.lines"));
  private points: string[] = [];

  constructor(private readonly model: Model) {
    const [point, names] = pointField("line-point", say("label.point"));
    this.point = point;
    point.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" || !point.value.trim()) return; // an empty field gives the line
      event.preventDefault();
      this.add();
    });
    const form = h("form", {},
      h("div", { class: "row" }, this.name),
      h("div", { class: "row" }, this.kind, this.sigma),
      h("div", { class: "row" }, point, names, button("studio_point.add", () => this.add())),
      h("label", { class: "check", title: titleOf("studio_point.add_chosen") }, this.follow, say("studio_point.add_chosen")),
      this.picked,
      h("div", { class: "row" }, h("button", { type: "submit", id: "line-give" }, say("studio_point.give")), button("studio_point.clear", () => this.pick([]))));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.give();
    });
    element("right").append(h("details", { class: "card" }, this.head, this.rows, form));
    model.on(["state", "overview"], () => this.show());
    model.on("current", () => this.follow.checked && model.current && this.pick([...this.points, model.current]));
  }

  private add(): void {
    const name = this.point.value.trim() || this.model.current;
    if (!name) return this.model.say("studio_point.none_chosen", {}, "bad");
    this.pick([...this.points, name]);
    this.point.value = "";
    this.point.focus();
  }

  private pick(points: string[]): void {
    this.points = [...new Set(points)];
    this.picked.hidden = !this.points.length;
    this.picked.replaceChildren(...this.points.map((p) => h("li", {}, p, " ",
      sign("✕", say("studio_point.remove", { name: p }), () => this.pick(this.points.filter((q) => q !== p)), "small"))));
  }

  private async give(): Promise<void> {
    const { model } = this;
    const sigma = number(this.sigma);
    if (!need(model, this.sigma, sigma)) return;
    const line = this.name.value.trim();
    const kind = this.kind.value;
    const done = await model.act("line", { line, points: this.points, kind, sigma }, "studio_point.line_given", { kind, line, points: this.points.join(", ") });
    if (!done) return;
    this.name.value = "";
    this.follow.checked = false;
    this.pick([]);
  }

  private show(): void {
    const { state, overview } = this.model;
    this.sigma.placeholder = withUnit(say("label.sigma"), overview.unit);
    this.sigma.title = say("studio_point.line_sigma");
    this.head.textContent = counted(say("studio_point.lines"), state.lines.length);
    this.rows.hidden = !state.lines.length;
    this.rows.replaceChildren(...state.lines.map((l) => h("tr", {},
      h("td", {}, l.line), h("td", {}, say("studio_point.line_kind", { kind: l.kind })), h("td", { class: "l" }, l.points.join(", ")), h("td", {}, `± ${short(l.sigma)}`),
      h("td", {}, sign("✕", say("studio_point.remove", { name: l.line }),
        () => void this.model.act("line", { line: l.line, points: [] }, "studio_point.removed", { name: l.line }), "small")))));
    this.picked.hidden = !this.points.length;
  }
}

const AXES = [["origin", "studio_point.origin"], ["axis", "studio_point.on_axis"], ["plane", "studio_point.in_plane"]] as const;

export class Datum {
  private readonly inputs: HTMLInputElement[];
  private readonly about = h("p", { class: "note" });
  private readonly away = button("studio_point.remove_datum", () => void this.model.act("datum", {}, "studio_point.datum_removed"));

  constructor(private readonly model: Model) {
    const fields = AXES.map(([name, code]) => pointField(`datum-${name}`, say(code)));
    this.inputs = fields.map(([input]) => input);
    const here = (input: HTMLInputElement, code: string) => sign("⇤", say("studio_point.use_current", { role: say(code) }), () => (input.value = model.current));
    const form = h("form", {}, this.about,
      ...fields.map(([input, names], k) => h("div", { class: "row" }, input, names, here(input, AXES[k][1]))),
      h("div", { class: "row" }, h("button", { type: "submit", id: "datum-give" }, say("studio_point.give")), this.away));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.give();
    });
    element("right").append(h("details", { class: "card" }, h("summary", {}, say("studio_point.datum")), form));
    model.on("state", () => this.show());
  }

  private async give(): Promise<void> {
    const [origin, axis, plane] = this.inputs.map((input) => input.value.trim());
    const done = await this.model.act("datum", { origin, axis, plane }, "studio_point.datum_given", { points: [origin, axis, plane].filter((p) => p).join(", ") });
    if (done) this.inputs.forEach((input) => (input.value = ""));
  }

  private show(): void {
    const { datum } = this.model.state;
    this.away.disabled = !datum;
    this.about.textContent = datum
      ? say("studio_point.datum_is", { ...datum, plane: datum.plane || "none" })
      : say("studio_point.datum_note");
  }
}

export class Naming {
  private readonly to = field("rename-to", say("studio_point.new_name"), { maxlength: "200" });
  private readonly about = h("p", { class: "note" });

  constructor(private readonly model: Model) {
    const form = h("form", {}, this.about,
      h("div", { class: "row" }, this.to, h("button", { type: "submit", id: "rename-give" }, say("studio_point.rename")),
        button("studio_point.forget", () => this.forget())));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.rename();
    });
    element("right").append(h("details", { class: "card" }, h("summary", {}, say("studio_point.rename_or_forget")), form));
    model.on("current", () => this.show());
    this.show();
  }

  private show(): void {
    this.about.textContent = this.model.current ? say("studio_point.of_point", { point: this.model.current }) : say("studio_point.none_chosen");
  }

  private async rename(): Promise<void> {
    const { model } = this;
    const point = model.current;
    if (!point) return model.say("studio_point.none_chosen", {}, "bad");
    const to = this.to.value.trim();
    if (!(await model.act("rename", { point, to }, "studio_point.renamed", { point, to }))) return;
    this.to.value = "";
    model.choose(to);
  }

  private forget(): void {
    const { model } = this;
    if (!model.current) return model.say("studio_point.none_chosen", {}, "bad");
    void model.act("forget", { point: model.current }, "studio_point.forgotten", { point: model.current });
  }
}
