// Fiducial marks of scanned film: measured like points, each by its name in the certificate.
import { button, element, h } from "./dom";
import { Model } from "./model";
import { count } from "./numbers";

export class Fiducials {
  private readonly rows = h("table", { "aria-label": "Fiducial marks of the active image" });
  private readonly head = h("summary", {}, "Fiducial marks");
  private readonly about = h("p", { class: "note" });
  private readonly card = h("details", { class: "card", id: "fiducials", open: true, hidden: true }, this.head, this.about, this.rows,
    button("Find the others", "Where those that are measured say that they must be", () => void this.find()));

  constructor(private readonly model: Model) {
    element("right").prepend(this.card);
    model.on(["state", "overview", "panes", "fiducial"], () => this.show());
  }

  private async find(): Promise<void> {
    const { model } = this;
    const image = model.panes[model.active];
    try {
      const answer = await model.actions.fiducials(image);
      model.take(answer.state);
      const left = Object.entries(answer.left).map(([name, why]) => `${name}: ${why}`);
      model.say([`${count(answer.found.length, "fiducial mark")} found`, ...left].join("; "), left.length ? "bad" : "good");
      model.chooseFiducial("");
    } catch (error) {
      model.say((error as Error).message, "bad");
    }
  }

  private show(): void {
    const { model } = this;
    const names = model.overview.fiducials;
    this.card.hidden = !names.length;
    const image = model.panes[model.active];
    if (!names.length || !image) return;
    const there = new Map(model.fiducialsIn(image).map((f) => [f.name, f]));
    this.head.textContent = `Fiducial marks of ${image}: ${there.size} of ${count(names.length, "mark")}`;
    this.about.textContent = model.fiducial
      ? `Click ${model.fiducial} in the scan; Esc ends.`
      : "Choose one and click it in the scan: they say where the scan lies in its camera's frame.";
    this.rows.replaceChildren(...names.map((name) => {
      const f = there.get(name);
      const choose = button(name, `Measure ${name}`, () => model.chooseFiducial(model.fiducial === name ? "" : name), "link");
      choose.setAttribute("aria-pressed", String(model.fiducial === name));
      const away = () => void model.act("fiducial", { image, name }, `${name} taken away`);
      return h("tr", { class: model.fiducial === name ? "at" : "" }, h("td", {}, choose),
        h("td", {}, f ? `${f.x.toFixed(1)}, ${f.y.toFixed(1)}` : "–"), h("td", {}, f?.how ?? ""),
        h("td", {}, ...(f ? [button("✕", `Take ${name} away`, away, "small")] : [])));
    }));
  }
}
