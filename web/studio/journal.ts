// The journal: every action with its time and its command; nothing is taken out of it.
import { ask } from "./api";
import { button, element, h, heads, whenSeen } from "./dom";
import { Model } from "./model";
import { JournalEntry } from "./types";
import { say } from "./words";

const MOST = 500;

export class Journal {
  private readonly author = h("input", { id: "author", type: "text", autocomplete: "off", spellcheck: "false", maxlength: 100 });
  private readonly status = h("span", { class: "note" });
  private entries: JournalEntry[] = [];

  constructor(private readonly model: Model, private readonly isOpen: () => boolean) {
    this.author.value = model.actions.author = localStorage.getItem("raybundle-author") ?? "";
    this.author.addEventListener("change", () => {
      model.actions.author = this.author.value.trim();
      localStorage.setItem("raybundle-author", model.actions.author);
    });
    element("journal-bar").append(h("label", {}, say("studio_page.author"), this.author),
      button("studio_page.copy_all", () => this.copy(this.entries.map((e) => e.command).filter((c) => c).join("\n"))), this.status);
    model.on("state", whenSeen(() => this.isOpen() && void this.show()));
  }

  async show(): Promise<void> {
    this.entries = (await ask<{ actions: JournalEntry[] }>("/api/journal")).actions;
    const latest = this.entries.slice(-MOST).reverse();
    this.status.textContent = say("studio_page.actions", { n: this.entries.length, shown: Math.min(this.entries.length, MOST) });
    element("journal").replaceChildren(h("table", { "aria-label": say("studio_page.journal") },
      heads(["studio_page.number", "label.time", "studio_page.by", "studio_page.action", "studio_page.command", "studio_page.copy"]),
      h("tbody", {}, ...latest.map((entry) => this.row(entry)))));
  }

  private row(e: JournalEntry): HTMLElement {
    const copy = button("studio_page.copy", () => this.copy(e.command), "small", { n: e.seq });
    const { image, point, start, end, line } = e.arguments;
    const named = [image, point, start, end, line].filter((v) => typeof v === "string").join(" · ");
    return h("tr", {}, h("td", {}, String(e.seq)), h("td", { class: "whole" }, e.time.replace("T", " ").slice(0, 19)), h("td", {}, e.author),
      h("td", { class: "l" }, h("b", {}, say("studio_page.verb", { verb: e.verb })), ` ${named}`), h("td", { class: "l" }, h("code", {}, e.command)), h("td", {}, e.command ? copy : ""));
  }

  private copy(words: string): void {
    navigator.clipboard.writeText(words).then(
      () => this.model.say("studio_page.copied", {}, "good"), () => this.model.say("studio_page.not_copied", {}, "bad"),
    );
  }
}
