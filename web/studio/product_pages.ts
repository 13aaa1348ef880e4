// Pages of products within this one: the surface in space, its quality.
import { framed } from "./decide_report";
import { h } from "./dom";
import { address } from "./product_files";
import { ProductFolder } from "./types";
import { say } from "./words";
import type { Leaf } from "./leaf";

const FIRST = "surface_3d.html";

export class ProductPages implements Leaf {
  readonly root = h("section", { class: "leaf whole", "aria-label": say("studio_product.part", { part: "pages" }), hidden: true });
  private readonly select = h("select", { id: "page-file" });
  private readonly note = h("p", { class: "note" }, say("studio_product.no_files"));
  private readonly frame = framed(say("studio_product.part", { part: "pages" }));
  private at = "";

  constructor() {
    this.select.addEventListener("change", () => void this.show());
    this.root.append(h("div", { class: "deeds" }, h("label", { for: "page-file" }, say("studio_product.page")), this.select), this.note, this.frame);
  }

  take(folders: ProductFolder[]): void {
    const paths = folders.flatMap((f) => f.files.filter((each) => each.page).map((each) => each.path));
    const chosen = paths.includes(this.select.value) ? this.select.value : (paths.find((p) => p.endsWith(FIRST)) ?? paths[0]);
    this.select.replaceChildren(...paths.map((path) => h("option", { value: path, selected: path === chosen }, path)));
    this.select.disabled = this.frame.hidden = !paths.length;
    this.note.hidden = !!paths.length;
  }

  async show(): Promise<void> {
    if (!this.select.value || this.select.value === this.at) return;
    this.at = this.select.value;
    this.frame.src = address(this.at);
  }
}
