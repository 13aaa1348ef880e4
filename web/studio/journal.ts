// The journal: every action with its time and its command; nothing is taken out of it.
import { ask } from "./api";
import { button, element, h, whenSeen } from "./dom";
import { Model } from "./model";
import { count } from "./numbers";
import { JournalEntry } from "./types";

const MOST = 500;

export class Journal {
  private readonly author = h("input", { id: "author", type: "text", autocomplete: "off", spellcheck: "false", maxlength: 100 });
  private readonly told = h("span", { class: "note" });
  private entries: JournalEntry[] = [];

  constructor(private readonly model: Model, private readonly isOpen: () => boolean) {
    this.author.value = model.actions.author = localStorage.getItem("raybundle-author") ?? "";
    this.author.addEventListener("change", () => {
      model.actions.author = this.author.value.trim();
      localStorage.setItem("raybundle-author", model.actions.author);
    });
    element("journal-bar").append(h("label", {}, "your name", this.author),
      button("Copy all", "Copy all commands", () => this.copy(this.entries.map((e) => e.command).filter((c) => c).join("\n"))), this.told);
    model.on("state", whenSeen(() => this.isOpen() && void this.show()));
  }

  async show(): Promise<void> {
    this.entries = (await ask<{ actions: JournalEntry[] }>("/api/journal")).actions;
    const latest = this.entries.slice(-MOST).reverse();
    this.told.textContent = `${count(this.entries.length, "action")}, the latest first${this.entries.length > MOST ? `; the last ${MOST} are shown` : ""}`;
    element("journal").replaceChildren(h("table", { "aria-label": "Journal" },
      h("thead", {}, h("tr", {}, ...["no.", "time", "by", "what", "command", "copy"].map((words) => h("th", { scope: "col" }, words)))),
      h("tbody", {}, ...latest.map((entry) => this.row(entry)))));
  }

  private row(e: JournalEntry): HTMLElement {
    const copy = button("Copy", `Copy the command of action ${e.seq}`, () => this.copy(e.command), "small");
    const { image, point, start, end, line } = e.arguments;
    const named = [image, point, start, end, line].filter((v) => typeof v === "string").join(" · ");
    return h("tr", {}, h("td", {}, String(e.seq)), h("td", { class: "whole" }, e.time.replace("T", " ").slice(0, 19)), h("td", {}, e.author),
      h("td", { class: "l" }, h("b", {}, e.verb), ` ${named}`), h("td", { class: "l" }, h("code", {}, e.command)), h("td", {}, e.command ? copy : ""));
  }

  private copy(words: string): void {
    navigator.clipboard.writeText(words).then(
      () => this.model.say("Copied.", "good"), () => this.model.say("The browser does not let this page copy.", "bad"),
    );
  }
}
