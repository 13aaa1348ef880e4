// The report of an adjustment, within the page: a document of no origin, which reaches nothing here.
import { ask } from "./api";
import { h } from "./dom";
import { AdjustmentRow } from "./types";
import { say } from "./words";

/** A frame for a page with a script of its own, apart from this one. */
export function framed(title: string): HTMLIFrameElement {
  return h("iframe", { class: "page", sandbox: "allow-scripts", referrerpolicy: "no-referrer", title });
}

export const nameOf = (k: AdjustmentRow): string => `${k.number}: ${say("studio_decide.origin", { origin: k.origin })}`;

export class DecideReport {
  readonly root = h("section", { class: "leaf whole", "aria-label": say("studio_page.report") });
  private readonly select = h("select", { id: "report-of" });
  private readonly status = h("p", { class: "note", role: "status" });
  private readonly links = h("span", { class: "links" });
  private readonly frame = framed(say("studio_decide.report"));
  private at = "";

  constructor() {
    this.select.addEventListener("change", () => void this.show());
    this.root.append(h("div", { class: "deeds" }, h("label", { for: "report-of" }, say("studio_decide.of_adjustment")), this.select, this.links), this.status, this.frame);
  }

  async show(): Promise<void> {
    const { adjustments } = await ask<{ adjustments: AdjustmentRow[] }>("/api/adjustments");
    const before = this.select.options.length;
    const chosen = before === adjustments.length ? Number(this.select.value) : (adjustments[adjustments.length - 1]?.number ?? -1);
    this.select.replaceChildren(...adjustments.map((k) => h("option", { value: k.number, selected: k.number === chosen }, nameOf(k))));
    const one = adjustments.find((k) => k.number === chosen);
    const address = one?.report ? `/adjustment/${one.number}/report.html` : "";
    this.select.disabled = !adjustments.length;
    this.frame.hidden = !address;
    this.status.textContent = !one ? say("studio_decide.not_adjusted") : address ? "" : say("studio_decide.no_report");
    this.status.hidden = !this.status.textContent;
    this.links.replaceChildren(
      ...(address ? [link(say("studio_decide.window"), address)] : []),
      ...(one?.network ? [link(say("studio_decide.network"), `/adjustment/${one.number}/network.html`)] : []));
    if (address && address !== this.at) this.frame.src = address;
    this.at = address;
  }
}

const link = (words: string, href: string): HTMLElement => h("a", { href, target: "_blank", rel: "noopener" }, words);
