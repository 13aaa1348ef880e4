// Lines and areas that are kept in the project: named, with layer and note; chosen again, taken away.
import { button, h, sign } from "./dom";
import { field } from "./known";
import { Model } from "./model";
import { State } from "./types";
import { say } from "./words";

export type Kept = State["drawings"][number];
type XY = [number, number];

export class ProductDrawings {
  private readonly name = field("drawing-name", say("studio_product.name"), { maxlength: "200" });
  private readonly layer = field("drawing-layer", say("studio_product.layer"), { maxlength: "200" });
  private readonly note = field("drawing-note", say("studio_product.note"), { maxlength: "200" });
  private readonly rows = h("table", { id: "drawings", "aria-label": say("studio_product.drawings") });
  private readonly form: HTMLFormElement;
  readonly root: HTMLElement;
  private surface = "";

  /** drawn  kind and corners in coordinates, null: too few; edit  draws it again; kept  clears what was drawn */
  constructor(private readonly model: Model, private readonly drawn: () => { kind: "area" | "line"; corners: XY[] } | null,
    private readonly edit: (kept: Kept) => void, private readonly kept: () => void) {
    const keep = button("studio_product.keep", () => this.form.requestSubmit(), "main");
    keep.id = "drawing-keep";
    keep.type = "button";
    this.form = h("form", { class: "deeds", hidden: true }, this.name, this.layer, this.note, keep);
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.keep();
    });
    this.root = h("div", {}, this.form, this.rows);
    model.on("state", () => this.show());
  }

  /** Those of the surface whose picture is shown. */
  get here(): Kept[] {
    return this.model.state.drawings.filter((d) => d.surface === this.surface);
  }

  turn(surface: string): void {
    this.surface = surface;
    this.show();
  }

  /** Show the form where enough is drawn. */
  offer(): void {
    const drawn = this.drawn();
    if (drawn && this.form.hidden && !this.name.value) {
      const names = new Set(this.model.state.drawings.map((d) => d.drawing));
      let n = 1;
      while (names.has(say("studio_product.default_name", { shape: drawn.kind, n }))) n++;
      this.name.value = say("studio_product.default_name", { shape: drawn.kind, n });
      this.layer.value ||= "lines";
    }
    this.form.hidden = !drawn;
  }

  private show(): void {
    this.rows.hidden = !this.here.length;
    this.rows.replaceChildren(...this.here.map((d) => h("tr", {},
      h("td", {}, sign(d.drawing, say("studio_product.edit", { name: d.drawing }), () => this.again(d), "link")),
      h("td", {}, d.layer), h("td", {}, d.note),
      h("td", {}, sign("✕", say("studio_product.erase", { name: d.drawing }), () => void this.model.act("erase", { drawing: d.drawing }, "studio_product.erased", { name: d.drawing }), "small")))));
  }

  private again(d: Kept): void {
    [this.name.value, this.layer.value, this.note.value] = [d.drawing, d.layer, d.note];
    this.edit(d);
  }

  private async keep(): Promise<void> {
    const drawn = this.drawn();
    const drawing = this.name.value.trim();
    if (!drawn) return;
    const given = { drawing, ...drawn, layer: this.layer.value.trim() || "lines", note: this.note.value.trim(), surface: this.surface };
    if (!(await this.model.act("draw", given, "studio_product.kept", { name: drawing }))) return;
    this.name.value = this.note.value = "";
    this.kept();
  }
}
