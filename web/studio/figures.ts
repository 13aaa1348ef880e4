// Points together: lines, levels and planes, a coordinate system by some of them; and another name for a point.
import { ask } from "./api";
import { afterPause, button, element, h } from "./dom";
import { field, need, number } from "./known";
import { Model } from "./model";
import { short, withUnit } from "./numbers";
import { Page, PointRow } from "./types";

/** What a figure is called. */
const named = (kind: string) => (kind === "level" || kind === "plane" ? kind : `${kind} line`);

/** A field for a point's name that suggests those that there are. */
function pointField(id: string, words: string): [HTMLInputElement, HTMLDataListElement] {
  const names = h("datalist", { id: `${id}-names` });
  const input = field(id, words, { list: `${id}-names`, maxlength: "200" });
  input.addEventListener("input", afterPause(() => void ask<Page<PointRow>>("/api/points", { search: input.value.trim(), limit: 12 })
    .then((found) => names.replaceChildren(...found.rows.map((row) => h("option", { value: row.point }))), () => {}), 150));
  return [input, names];
}

export class Lines {
  private readonly name = field("line-name", "name of the line, level or plane", { maxlength: "200" });
  private readonly kind = h("select", { id: "line-kind", "aria-label": "Kind of the figure" },
    ...["straight", "plumb", "level", "plane"].map((kind) => h("option", { value: kind }, kind)));
  private readonly sigma = field("line-sigma", "sigma", { inputmode: "decimal" });
  private readonly point: HTMLInputElement;
  private readonly follow = h("input", { type: "checkbox", id: "line-follow" });
  private readonly picked = h("ol", { class: "picked", id: "line-points", "aria-label": "Points of the line" });
  private readonly rows = h("table", { "aria-label": "Lines" });
  private readonly head = h("summary", {}, "Lines, levels, planes");
  private points: string[] = [];

  constructor(private readonly model: Model) {
    const [point, names] = pointField("line-point", "point");
    this.point = point;
    point.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" || !point.value.trim()) return; // an empty field gives the line
      event.preventDefault();
      this.add();
    });
    const form = h("form", {},
      h("div", { class: "row" }, this.name),
      h("div", { class: "row" }, this.kind, this.sigma),
      h("div", { class: "row" }, point, names, button("Add", "Add the point that is named, or the current one", () => this.add())),
      h("label", { class: "check", title: "A point that is chosen in a photograph, in space or in a list is the next one of the line" }, this.follow, "add each point that is chosen"),
      this.picked,
      h("div", { class: "row" }, h("button", { type: "submit", id: "line-give" }, "Give"), button("Clear", "No points", () => this.pick([]))));
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
    if (!name) return this.model.say("No point is named, and none is chosen.", "bad");
    this.pick([...this.points, name]);
    this.point.value = "";
    this.point.focus();
  }

  private pick(points: string[]): void {
    this.points = [...new Set(points)];
    this.picked.hidden = !this.points.length;
    this.picked.replaceChildren(...this.points.map((p) => h("li", {}, p, " ",
      button("✕", `Leave ${p} out of the line`, () => this.pick(this.points.filter((q) => q !== p)), "small"))));
  }

  private async give(): Promise<void> {
    const { model } = this;
    const sigma = number(this.sigma);
    if (!need(model, this.sigma, sigma)) return;
    const line = this.name.value.trim();
    const kind = this.kind.value;
    const done = await model.act("line", { line, points: this.points, kind, sigma }, `${named(kind)} ${line}: ${this.points.join(", ")}`);
    if (!done) return;
    this.name.value = "";
    this.follow.checked = false;
    this.pick([]);
  }

  private show(): void {
    const { state, overview } = this.model;
    this.sigma.placeholder = withUnit("sigma", overview.unit);
    this.sigma.title = "Standard deviation of a point's distance from it";
    this.head.textContent = state.lines.length ? `Lines, levels, planes: ${state.lines.length}` : "Lines, levels, planes";
    this.rows.hidden = !state.lines.length;
    this.rows.replaceChildren(...state.lines.map((l) => h("tr", {},
      h("td", {}, l.line), h("td", {}, l.kind), h("td", { class: "l" }, l.points.join(", ")), h("td", {}, `± ${short(l.sigma)}`),
      h("td", {}, button("✕", `Take the ${named(l.kind)} ${l.line} away`,
        () => void this.model.act("line", { line: l.line, points: [] }, `${named(l.kind)} ${l.line} taken away`), "small")))));
    this.picked.hidden = !this.points.length;
  }
}

const AXES = [["origin", "origin"], ["axis", "point on the X axis"], ["plane", "point in the XY plane, or none"]] as const;

export class Datum {
  private readonly inputs: HTMLInputElement[];
  private readonly about = h("p", { class: "note" });
  private readonly away = button("Take away", "The coordinate system as the block has it", () => void this.model.act("datum", {}, "coordinate system as the block has it"));

  constructor(private readonly model: Model) {
    const fields = AXES.map(([name, words]) => pointField(`datum-${name}`, words));
    this.inputs = fields.map(([input]) => input);
    const here = (input: HTMLInputElement, words: string) => button("⇤", `The current point is the ${words}`, () => (input.value = model.current));
    const form = h("form", {}, this.about,
      ...fields.map(([input, names], k) => h("div", { class: "row" }, input, names, here(input, AXES[k][1]))),
      h("div", { class: "row" }, h("button", { type: "submit", id: "datum-give" }, "Give"), this.away));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.give();
    });
    element("right").append(h("details", { class: "card" }, h("summary", {}, "Coordinate system"), form));
    model.on("state", () => this.show());
  }

  private async give(): Promise<void> {
    const [origin, axis, plane] = this.inputs.map((input) => input.value.trim());
    const done = await this.model.act("datum", { origin, axis, plane }, `coordinate system: ${[origin, axis, plane].filter((p) => p).join(", ")}`);
    if (done) this.inputs.forEach((input) => (input.value = ""));
  }

  private show(): void {
    const { datum } = this.model.state;
    this.away.disabled = !datum;
    this.about.textContent = datum
      ? `Origin ${datum.origin}, X axis ${datum.plane ? "through" : "towards"} ${datum.axis}, ${datum.plane ? `${datum.plane} in the XY plane` : "levels and plumb lines tell the vertical"}.`
      : "As the block has it. Three points make another: origin, X axis, XY plane; or two where levels or plumb lines tell the vertical.";
  }
}

export class Naming {
  private readonly to = field("rename-to", "new name", { maxlength: "200" });
  private readonly whose = h("p", { class: "note" });

  constructor(private readonly model: Model) {
    const form = h("form", {}, this.whose,
      h("div", { class: "row" }, this.to, h("button", { type: "submit", id: "rename-give" }, "Rename"),
        button("Forget", "Take away all that was measured of the current point", () => this.forget())));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.rename();
    });
    element("right").append(h("details", { class: "card" }, h("summary", {}, "Rename, forget"), form));
    model.on("current", () => this.show());
    this.show();
  }

  private show(): void {
    this.whose.textContent = this.model.current ? `of ${this.model.current}` : "of the current point: none is chosen";
  }

  private async rename(): Promise<void> {
    const { model } = this;
    const point = model.current;
    if (!point) return model.say("No point is chosen.", "bad");
    const to = this.to.value.trim();
    if (!(await model.act("rename", { point, to }, `${point} is called ${to} now`))) return;
    this.to.value = "";
    model.choose(to);
  }

  private forget(): void {
    const { model } = this;
    if (!model.current) return model.say("No point is chosen.", "bad");
    void model.act("forget", { point: model.current }, `${model.current} forgotten, with its marks`);
  }
}
