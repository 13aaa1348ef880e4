// The options of the next adjustment: a form that the server makes of the settings of `adjust`, and the command.
import { ask, tell } from "./api";
import { button, element, h } from "./dom";
import { Model } from "./model";
import { OptionFields, Values } from "./option_form";
import { OptionForm } from "./types";

export class DecideOptions {
  readonly root = h("section", { class: "leaf", "aria-label": "Options of the adjustment" });
  private readonly form = new OptionFields("option", (values) => void this.send(values));
  private readonly command = h("code", { class: "command" });

  constructor(private readonly model: Model) {
    const go = button("Adjust with these options", "Adjust block and marks in the background", () => element("adjust").click(), "main");
    go.id = "options-adjust";
    const usual = button("As usual", "All options as they are by default", () => void this.send({}));
    usual.id = "options-usual";
    this.root.append(
      h("p", { class: "note" }, "They hold for every adjustment that is begun here, from this page or from the button above. While it runs, the line below shows how far it is; Stop ends it and changes nothing."),
      this.form.root, h("div", { class: "deeds" }, go, usual),
      h("h3", {}, "The same on the command line"), h("p", {}, this.command));
  }

  async show(): Promise<void> {
    this.fill(await ask<OptionForm>("/api/options"));
  }

  private async send(values: Values): Promise<void> {
    try {
      this.fill(await tell<OptionForm>("/api/options", { values }));
      this.model.say("Options of the next adjustment.", "good");
    } catch (error) {
      this.model.say((error as Error).message, "bad");
    }
  }

  private fill({ fields, command }: OptionForm): void {
    this.form.fill(fields);
    this.command.textContent = command;
  }
}
