// The report of an adjustment, within the page: a document of no origin, which reaches nothing here.
import { ask } from "./api";
import { h } from "./dom";
import { Kept } from "./types";

/** A frame for a page with a script of its own, apart from this one. */
export function framed(title: string): HTMLIFrameElement {
  return h("iframe", { class: "page", sandbox: "allow-scripts", referrerpolicy: "no-referrer", title });
}

export const nameOf = (k: Kept): string => `${k.number}: ${k.words}`;

export class DecideReport {
  readonly root = h("section", { class: "leaf whole", "aria-label": "Report" });
  private readonly select = h("select", { id: "report-of" });
  private readonly told = h("p", { class: "note", role: "status" });
  private readonly links = h("span", { class: "links" });
  private readonly frame = framed("Report of the adjustment");
  private at = "";

  constructor() {
    this.select.addEventListener("change", () => void this.show());
    this.root.append(h("div", { class: "deeds" }, h("label", { for: "report-of" }, "of adjustment"), this.select, this.links), this.told, this.frame);
  }

  async show(): Promise<void> {
    const kept = (await ask<{ adjustments: Kept[] }>("/api/adjustments")).adjustments;
    const before = this.select.options.length;
    const chosen = before === kept.length ? Number(this.select.value) : (kept[kept.length - 1]?.number ?? -1);
    this.select.replaceChildren(...kept.map((k) => h("option", { value: k.number, selected: k.number === chosen }, nameOf(k))));
    const one = kept.find((k) => k.number === chosen);
    const address = one?.report ? `/adjustment/${one.number}/report.html` : "";
    this.select.disabled = !kept.length;
    this.frame.hidden = !address;
    this.told.textContent = !one ? "Nothing has been adjusted here yet: press Adjust." : address ? "" : "This result was written without a report: press Adjust, which writes one.";
    this.told.hidden = !this.told.textContent;
    this.links.replaceChildren(
      ...(address ? [link("In a window of its own", address)] : []),
      ...(one?.network ? [link("Network in three dimensions", `/adjustment/${one.number}/network.html`)] : []));
    if (address && address !== this.at) this.frame.src = address;
    this.at = address;
  }
}

const link = (words: string, href: string): HTMLElement => h("a", { href, target: "_blank", rel: "noopener" }, words);
