// Tables of points and image observations: rows come from the server as they are scrolled to.
import { ask } from "./api";
import { afterPause, choices, element, h, onceAFrame } from "./dom";
import { Model } from "./model";
import { fixed, decimalsOf, grouped, short } from "./numbers";
import { ObservationRow, Page, PairRow, PointRow } from "./types";
import { say } from "./words";

const ROW = 26;
const PAGE = 200;
/** Height of the longest thing that a browser scrolls exactly. */
const TALLEST = 8e6;

type Row = PointRow | ObservationRow | PairRow;
type Column = [name: string, head: string, cell: (row: never) => string];
type Kind = "points" | "observations" | "pairs";
const PATHS: Record<Kind, string> = { points: "/api/points", observations: "/api/table/observations", pairs: "/api/table/pairs" };

const COLUMNS: Record<Kind, Column[]> = {
  points: [
    ["point", say("label.point"), (r: PointRow) => r.point], ["role", say("label.role"), (r: PointRow) => say("studio_point.role", { role: r.role })],
    ...["X", "Y", "Z"].map((axis, k): Column => [axis, axis, (r: PointRow) => fixed(r.xyz[k], decimalsOf(r.sigma[k]))]),
    ...["X", "Y", "Z"].map((axis, k): Column => [`s${axis}`, say("label.sigma_of", { symbol: axis }), (r: PointRow) => fixed(r.sigma[k], decimalsOf(r.sigma[k]))]),
    ["rays", say("label.rays"), (r: PointRow) => String(r.rays)], ["w", say("studio_table.largest_w"), (r: PointRow) => fixed(r.w, 2)],
  ],
  observations: [
    ["image", say("label.image"), (r: ObservationRow) => r.image], ["point", say("label.point"), (r: ObservationRow) => r.point],
    ["x", say("studio_table.x"), (r: ObservationRow) => fixed(r.x, 2)], ["y", say("studio_table.y"), (r: ObservationRow) => fixed(r.y, 2)],
    ["vx", say("studio_table.vx"), (r: ObservationRow) => fixed(r.vx, 3)], ["vy", say("studio_table.vy"), (r: ObservationRow) => fixed(r.vy, 3)],
    ["w", say("studio_table.w"), (r: ObservationRow) => fixed(r.w, 2)], ["r", say("studio_table.redundancy"), (r: ObservationRow) => fixed(r.r, 2)],
    ["", say("label.rejected"), (r: ObservationRow) => r.rejected],
  ],
  pairs: [
    ["image", say("label.image"), (r: PairRow) => r.image], ["other", say("studio_table.other_image"), (r: PairRow) => r.other],
    ["common", say("label.common_points"), (r: PairRow) => grouped(r.common)], ["base", say("studio_table.base"), (r: PairRow) => short(r.base, 4)],
  ],
};

export class Tables {
  private kind: Kind = "points";
  private sort = "";
  private down = false;
  private total = 0;
  private at = -1;
  private pages = new Map<number, Row[] | null>();
  private turn = 0;
  private readonly search = h("input", { type: "search", id: "table-search", "aria-label": say("studio_table.filter"), placeholder: say("studio_table.filter"), autocomplete: "off", spellcheck: "false" });
  private readonly status = h("span", { class: "note", "aria-live": "polite" });
  private readonly head = h("div", { role: "row", class: "head" });
  private readonly rows = h("div", { class: "rows" });
  private readonly tall = h("div", { class: "tall" }, this.rows);
  private readonly scroll = h("div", { class: "scroll", tabindex: 0, role: "rowgroup", "aria-label": say("studio_table.rows") }, this.tall);
  private readonly grid = h("div", { role: "table", class: "grid", "aria-label": say("studio_table.table") }, this.head, this.scroll);
  private readonly drawSoon = onceAFrame(() => this.draw());

  constructor(model: Model, private readonly isOpen: () => boolean, private readonly opened: (row: Row) => void) {
    const kinds = h("select", { id: "table-kind", "aria-label": say("studio_table.table") }, ...choices(Object.keys(PATHS), (kind) => say("studio_table.kind", { kind })));
    kinds.addEventListener("change", () => this.of(kinds.value as Kind));
    element("table-bar").append(kinds, this.search, this.status);
    element("table").append(this.grid);
    this.search.addEventListener("input", afterPause(() => this.begin(), 200));
    this.scroll.addEventListener("scroll", this.drawSoon);
    this.scroll.addEventListener("keydown", (event) => this.key(event));
    this.rows.addEventListener("click", (event) => {
      const row = (event.target as HTMLElement).closest<HTMLElement>("[data-row]");
      if (row) this.open(Number(row.dataset.row));
    });
    new ResizeObserver(this.drawSoon).observe(this.scroll);
    model.on("read", () => this.isOpen() && this.begin());
  }

  show(): void {
    this.of(this.kind);
  }

  private of(kind: Kind): void {
    if (kind !== this.kind) [this.sort, this.down] = ["", false];
    this.kind = kind;
    this.grid.className = `grid ${kind}`;
    this.begin();
  }

  private heads(): void {
    this.head.replaceChildren(...COLUMNS[this.kind].map(([name, words]) => {
      const sorted = name && name === this.sort;
      const press = () => {
        this.down = sorted ? !this.down : ["w", "common", "base"].includes(name) || name.startsWith("s");
        this.sort = name;
        this.begin();
      };
      const cell = h("div", { role: "columnheader", "aria-sort": sorted ? (this.down ? "descending" : "ascending") : "none" });
      cell.append(name ? h("button", { type: "button", title: say("studio_table.sort", { name: words }), onclick: press }, `${words}${sorted ? (this.down ? " ▼" : " ▲") : ""}`) : words);
      return cell;
    }));
  }

  private begin(): void {
    this.heads();
    this.turn++;
    this.pages.clear();
    this.at = -1;
    this.scroll.scrollTop = 0;
    this.rows.replaceChildren();
    void this.load(0);
  }

  private async load(page: number): Promise<void> {
    if (this.pages.has(page)) return;
    const { turn } = this;
    this.pages.set(page, null);
    try {
      const found = await ask<Page<Row>>(PATHS[this.kind], {
        sort: this.sort, down: this.down ? 1 : 0, search: this.search.value.trim(), offset: page * PAGE, limit: PAGE,
      });
      if (turn !== this.turn) return;
      this.pages.set(page, found.rows);
      this.total = found.total;
      this.status.textContent = say("studio_table.count", { n: found.total });
      this.grid.setAttribute("aria-rowcount", String(found.total + 1));
      this.tall.style.height = `${Math.min(found.total * ROW, TALLEST)}px`;
    } catch {
      if (turn === this.turn) this.pages.delete(page);
    }
    this.drawSoon();
  }

  /** Rows for each pixel of scrolling: one a row's height, but for tables that are taller than browsers scroll. */
  private get first(): number {
    const { scrollTop, clientHeight } = this.scroll;
    const height = this.total * ROW;
    if (height <= TALLEST) return scrollTop / ROW;
    const share = scrollTop / Math.max(TALLEST - clientHeight, 1);
    return share * Math.max(this.total - clientHeight / ROW, 0);
  }

  private draw(): void {
    if (!this.isOpen() || !this.total) return void (this.total || this.rows.replaceChildren());
    const { first } = this;
    const many = Math.ceil(this.scroll.clientHeight / ROW) + 1;
    const begin = Math.floor(first);
    this.rows.style.transform = `translateY(${this.scroll.scrollTop - (first - begin) * ROW}px)`;
    const shown: HTMLElement[] = [];
    for (let k = begin; k < Math.min(begin + many, this.total); k++) {
      const page = Math.floor(k / PAGE);
      const row = this.pages.get(page)?.[k % PAGE];
      if (!row) void this.load(page);
      shown.push(this.row(k, row));
    }
    this.rows.replaceChildren(...shown);
  }

  private row(k: number, row?: Row): HTMLElement {
    const cells = COLUMNS[this.kind].map(([, , cell]) => h("div", { role: "cell" }, row ? cell(row as never) : "…"));
    return h("div", { role: "row", "data-row": k, "aria-rowindex": k + 2, class: k === this.at ? "at" : "" }, ...cells);
  }

  private open(k: number): void {
    this.at = k;
    const row = this.pages.get(Math.floor(k / PAGE))?.[k % PAGE];
    this.draw();
    if (row) this.opened(row);
  }

  private key(event: KeyboardEvent): void {
    const many = Math.max(Math.floor(this.scroll.clientHeight / ROW) - 1, 1);
    const by: Record<string, number> = { ArrowDown: 1, ArrowUp: -1, PageDown: many, PageUp: -many, Home: -this.total, End: this.total };
    if (event.key === "Enter" && this.at >= 0) this.open(this.at);
    else if (event.key in by) {
      this.at = Math.min(Math.max(this.at + by[event.key], 0), this.total - 1);
      this.reveal();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private reveal(): void {
    const many = this.scroll.clientHeight / ROW;
    const { first } = this;
    const to = this.at < first ? this.at : this.at + 1 > first + many ? this.at + 1 - many : first;
    const height = this.total * ROW;
    const share = to / Math.max(this.total - many, 1);
    this.scroll.scrollTop = height <= TALLEST ? to * ROW : share * (TALLEST - this.scroll.clientHeight);
    this.draw();
  }
}

export const isPair = (row: Row): row is PairRow => "other" in row;
export const isPoint = (row: Row): row is PointRow => "xyz" in row;
