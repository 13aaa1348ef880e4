// A list of which one is chosen, by mouse and by keys alike.
import { h } from "./dom";

let lists = 0;

export class Choice<T> {
  readonly root: HTMLElement;
  private items: T[] = [];
  private at = -1;
  private readonly id = `list${lists++}`;

  constructor(
    name: string, private readonly keyOf: (item: T) => string, private readonly row: (item: T) => (Node | string)[],
    private readonly chosen: (item: T, event: Event) => void,
  ) {
    this.root = h("div", { role: "listbox", tabindex: 0, class: "choice", "aria-label": name });
    this.root.addEventListener("keydown", (event) => this.key(event));
    this.root.addEventListener("click", (event) => {
      const row = (event.target as HTMLElement).closest("[role=option]");
      const k = row ? [...this.root.children].indexOf(row) : -1;
      if (k < 0) return;
      this.point(k);
      this.chosen(this.items[k], event);
    });
  }

  /** Show other items; `selected` is the key of the one that is chosen. */
  set(items: T[], selected = ""): void {
    this.items = items;
    this.root.replaceChildren(
      ...items.map((item, k) => h("div", { role: "option", id: `${this.id}-${k}`, "aria-selected": "false" }, ...this.row(item))),
    );
    this.at = -1;
    this.select(selected);
  }

  select(selected: string): void {
    this.items.forEach((item, k) => {
      const on = this.keyOf(item) === selected;
      this.root.children[k].setAttribute("aria-selected", String(on));
      if (on) this.point(k);
    });
  }

  get length(): number {
    return this.items.length;
  }

  private point(k: number): void {
    this.root.children[this.at]?.classList.remove("at");
    this.at = k;
    const row = this.root.children[k];
    if (!row) return;
    row.classList.add("at");
    this.root.setAttribute("aria-activedescendant", row.id);
    // the list alone is scrolled, not what it stands in
    const { offsetTop: top, offsetHeight: tall } = row as HTMLElement;
    const { scrollTop, clientHeight } = this.root;
    if (top < scrollTop) this.root.scrollTop = top;
    else if (top + tall > scrollTop + clientHeight) this.root.scrollTop = top + tall - clientHeight;
  }

  private key(event: KeyboardEvent): void {
    const last = this.items.length - 1;
    const to: Record<string, number> = {
      ArrowDown: Math.min(this.at + 1, last), ArrowUp: Math.max(this.at - 1, 0), Home: 0, End: last,
      PageDown: Math.min(this.at + 8, last), PageUp: Math.max(this.at - 8, 0),
    };
    if (event.key in to) this.point(to[event.key]);
    else if (event.key === "Enter" && this.at >= 0) this.chosen(this.items[this.at], event);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
