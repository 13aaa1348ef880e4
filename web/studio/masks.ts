// Areas that are left out of all measuring: drawn, edited, taken away.
import { button, element, h, sign } from "./dom";
import { Corner, drawing } from "./drawing";
import { counted, field } from "./known";
import { Model } from "./model";
import { State } from "./types";
import { say } from "./words";

type Drawn = State["masks"][number];

export class Masks {
  private readonly name = field("mask-name", say("studio_point.mask_name"), { maxlength: "200" });
  private readonly camera = h("input", { type: "checkbox", id: "mask-camera" });
  private readonly rows = h("table", { "aria-label": say("studio_point.masks") });
  private readonly head = h("summary", {}, say("studio_point.masks"));
  private readonly about = h("p", { class: "note", "aria-live": "polite" });
  private readonly begin = button("studio_point.draw_mask", () => this.draw());
  private readonly give = h("button", { type: "submit", id: "mask-give", class: "main" }, say("studio_point.exclude"));
  private readonly last = button("studio_point.last_corner", () => drawing.removeLast());
  private readonly form: HTMLFormElement;

  constructor(private readonly model: Model, private readonly toPhoto: (image: string) => void) {
    this.form = h("form", { hidden: true },
      h("div", { class: "row" }, this.name),
      h("label", { class: "check" }, this.camera, say("studio_point.mask_of_camera")),
      h("div", { class: "row" }, this.last, button("studio_point.cancel_mask", () => drawing.end()), this.give));
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.exclude();
    });
    this.begin.id = "mask-draw";
    element("right").append(h("details", { class: "card", id: "masks" }, this.head, this.about, this.rows, this.begin, this.form));
    model.on(["state", "overview"], () => this.show());
    drawing.onchange(() => {
      this.show();
      model.emit("looks");
    });
  }

  private draw(): void {
    const names = new Set(this.model.state.masks.map((m) => m.mask));
    let n = 1;
    while (names.has(say("studio_point.mask_default", { number: n }))) n++;
    this.name.value = say("studio_point.mask_default", { number: n });
    this.camera.checked = false;
    drawing.begin();
    this.toPhoto("");
    this.form.scrollIntoView({ block: "nearest" });
  }

  private edit(mask: Drawn): void {
    this.name.value = mask.mask;
    this.camera.checked = mask.camera;
    drawing.begin(mask.image, mask.polygon.map(([x, y]): Corner => [x, y]));
    this.toPhoto(mask.image);
    this.form.scrollIntoView({ block: "nearest" });
  }

  private async exclude(): Promise<void> {
    const { corners, image } = drawing;
    if (!image) return this.model.say("studio_point.no_corner", {}, "bad");
    const mask = this.name.value.trim();
    const args = { mask, image, polygon: corners, camera: this.camera.checked };
    if (await this.model.act("mask", args, "studio_point.mask_given", { mask })) drawing.end();
  }

  private show(): void {
    const { state, overview } = this.model;
    this.head.textContent = counted(say("studio_point.masks"), state.masks.length);
    this.form.hidden = !drawing.on;
    this.begin.hidden = drawing.on;
    this.give.disabled = drawing.corners.length < 3;
    this.last.disabled = !drawing.corners.length;
    this.about.textContent = drawing.on
      ? say("studio_point.corners", { n: drawing.corners.length, image: drawing.image || "none" })
      : say("studio_point.masks_note", { folder: overview.masks_given || "none" });
    this.rows.hidden = !state.masks.length;
    this.rows.replaceChildren(...state.masks.map((m) => h("tr", {},
      h("td", {}, sign(m.mask, say("studio_point.edit_mask", { mask: m.mask }), () => this.edit(m), "link")),
      h("td", { class: "l" }, m.camera ? say("studio_point.camera_of", { image: m.image }) : m.image),
      h("td", {}, sign("✕", say("studio_point.remove", { name: m.mask }), () => void this.model.act("unmask", { mask: m.mask }, "studio_point.removed", { name: m.mask }), "small")))));
  }
}
