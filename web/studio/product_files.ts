// The files of the products, to be opened or saved.
import { button, h } from "./dom";
import { fixed } from "./numbers";
import { ProductFolder } from "./types";
import { say } from "./words";
import type { Leaf } from "./leaf";

export class ProductFiles implements Leaf {
  readonly root = h("section", { class: "leaf", "aria-label": say("studio_product.part", { part: "files" }), hidden: true });

  /** open  shows a picture */
  constructor(private readonly open: (path: string) => void) {}

  async show(): Promise<void> {}

  take(folders: ProductFolder[]): void {
    this.root.replaceChildren(...folders.map((folder) => this.folder(folder)));
    if (!folders.length) this.root.append(h("p", { class: "note" }, say("studio_product.no_files")));
  }

  private folder({ folder, files, more }: ProductFolder): HTMLElement {
    const rows = files.map((f) => h("tr", {},
      h("th", { scope: "row" }, h("a", { href: address(f.path), target: "_blank", rel: "noopener" }, f.name)),
      h("td", {}, size(f.bytes)), h("td", {}, f.picture ? button("studio_product.show", () => this.open(f.path)) : "")));
    const rest = more ? [h("p", { class: "note" }, say("studio_product.more", { n: more }))] : [];
    return h("div", { class: "camera" }, h("h3", {}, folder), h("table", { class: "figures-of" }, h("tbody", {}, ...rows)), ...rest);
  }
}

export const address = (path: string): string => `/product/file/${path.split("/").map(encodeURIComponent).join("/")}`;

/** Bytes, with the unit that suits them. */
function size(bytes: number): string {
  if (bytes < 1e3) return `${bytes} B`;
  return bytes < 1e6 ? `${fixed(bytes / 1e3, 0)} kB` : `${fixed(bytes / 1e6, bytes < 1e7 ? 1 : 0)} MB`;
}
