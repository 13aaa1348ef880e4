// Areas that are left out of all measuring: drawn, edited, taken away.
import { button, element, h } from "./dom";
import { Corner, drawing } from "./drawing";
import { field } from "./known";
import { Model } from "./model";
import { count } from "./numbers";
import { State } from "./types";

type Drawn = State["masks"][number];

export class Masks {
  private readonly name = field("mask-name", "name of the mask", { maxlength: "200" });
  private readonly camera = h("input", { type: "checkbox", id: "mask-camera" });
  private readonly rows = h("table", { "aria-label": "Masks" });
  private readonly head = h("summary", {}, "Masks");
  private readonly about = h("p", { class: "note", "aria-live": "polite" });
  private readonly begin = button("Draw an area", "Click its corners in a photograph, or bring the cross hair there and press Enter", () => this.draw());
  private readonly give = h("button", { type: "submit", id: "mask-give", class: "main" }, "Exclude this area");
  private readonly last = button("Back", "Take the last corner away (Delete)", () => drawing.removeLast());
  private readonly form: HTMLFormElement;

  constructor(private readonly model: Model, private readonly toPhoto: (image: string) => void) {
    this.form = h("form", { hidden: true },
      h("div", { class: "row" }, this.name),
      h("label", { class: "check" }, this.camera, "in all photographs of the camera"),
      h("div", { class: "row" }, this.last, button("Cancel", "Draw no mask (Esc)", () => drawing.end()), this.give));
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
    while (names.has(`mask ${n}`)) n++;
    this.name.value = `mask ${n}`;
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
    if (!image) return this.model.say("No corner is drawn: click the corners in a photograph.", "bad");
    const mask = this.name.value.trim();
    const args = { mask, image, polygon: corners, camera: this.camera.checked };
    if (await this.model.act("mask", args, `${mask}: nothing is measured there when orient runs again`)) drawing.end();
  }

  private show(): void {
    const { state, overview } = this.model;
    this.head.textContent = state.masks.length ? `Masks: ${state.masks.length}` : "Masks";
    this.form.hidden = !drawing.on;
    this.begin.hidden = drawing.on;
    this.give.disabled = drawing.corners.length < 3;
    this.last.disabled = !drawing.corners.length;
    const read = overview.masks_given ? ` Masks of ${overview.masks_given} are shown, too.` : "";
    this.about.textContent = drawing.on
      ? `${count(drawing.corners.length, "corner")}${drawing.image ? ` in ${drawing.image}` : ""}: a corner is dragged, Delete takes the last back.`
      : `What is excluded is left out when orient runs again in this project.${read}`;
    this.rows.hidden = !state.masks.length;
    this.rows.replaceChildren(...state.masks.map((m) => h("tr", {},
      h("td", {}, button(m.mask, `Edit ${m.mask}`, () => this.edit(m), "link")),
      h("td", { class: "l" }, m.camera ? `camera of ${m.image}` : m.image),
      h("td", {}, button("✕", `Take ${m.mask} away`, () => void this.model.act("unmask", { mask: m.mask }, `${m.mask} taken away`), "small")))));
  }
}
