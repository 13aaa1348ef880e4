// Tabs of the stage: one is shown; the arrow keys go through them.
import { element } from "./dom";

export const TABS = ["images", "space", "tables", "epochs", "decide", "products", "journal"] as const;
export type Tab = (typeof TABS)[number];

export class Tabs {
  private readonly opened = new Map<Tab, () => void>();
  now: Tab = "images";

  constructor() {
    TABS.forEach((tab) => {
      const head = element<HTMLButtonElement>(`tab-${tab}`);
      head.addEventListener("click", () => this.show(tab));
      head.addEventListener("keydown", (event) => {
        const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!by) return;
        event.preventDefault();
        const there = TABS.filter((t) => !element(`tab-${t}`).hidden);
        const next = there[(there.indexOf(tab) + by + there.length) % there.length];
        this.show(next);
        element(`tab-${next}`).focus();
      });
    });
  }

  onopen(tab: Tab, call: () => void): void {
    this.opened.set(tab, call);
  }

  show(tab: Tab): void {
    this.now = tab;
    for (const each of TABS) {
      const head = element(`tab-${each}`);
      head.setAttribute("aria-selected", String(each === tab));
      head.tabIndex = each === tab ? 0 : -1;
      element(`stage-${each}`).hidden = each !== tab;
    }
    this.opened.get(tab)?.();
  }
}
