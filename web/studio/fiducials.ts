// Fiducial marks of scanned film: measured like points, each by its name in the certificate.
import { button, element, h, sign } from "./dom";
import { Model } from "./model";
import { fixed } from "./numbers";
import { say } from "./words";

export class Fiducials {
  private readonly rows = h("table", { "aria-label": say("studio_point.fiducials") });
  private readonly head = h("summary", {}, say("studio_point.fiducials"));
  private readonly about = h("p", { class: "note" });
  private readonly card = h("details", { class: "card", id: "fiducials", open: true, hidden: true }, this.head, this.about, this.rows,
    button("studio_point.find_fiducials", () => void this.find()));

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
      model.show([say("studio_point.fiducials_found", { n: answer.found.length }), ...left].join("; "), left.length ? "bad" : "good", "studio_point.fiducials_found");
      model.chooseFiducial("");
    } catch (error) {
      model.fail(error);
    }
  }

  private show(): void {
    const { model } = this;
    const names = model.overview.fiducials;
    this.card.hidden = !names.length;
    const image = model.panes[model.active];
    if (!names.length || !image) return;
    const there = new Map(model.fiducialsIn(image).map((f) => [f.name, f]));
    this.head.textContent = say("studio_point.fiducials_of", { image, n: there.size, of: names.length });
    this.about.textContent = model.fiducial
      ? say("studio_point.click_fiducial", { name: model.fiducial })
      : say("studio_point.fiducials_note");
    this.rows.replaceChildren(...names.map((name) => {
      const f = there.get(name);
      const choose = sign(name, say("studio_point.measure", { name }), () => model.chooseFiducial(model.fiducial === name ? "" : name), "link");
      choose.setAttribute("aria-pressed", String(model.fiducial === name));
      const away = () => void model.act("fiducial", { image, name }, "studio_point.removed", { name });
      return h("tr", { class: model.fiducial === name ? "at" : "" }, h("td", {}, choose),
        h("td", {}, f ? `${fixed(f.x, 1)}; ${fixed(f.y, 1)}` : "–"), h("td", {}, f ? say("studio_point.how", { how: f.how }) : ""),
        h("td", {}, ...(f ? [sign("✕", say("studio_point.remove", { name }), away, "small")] : [])));
    }));
  }
}
