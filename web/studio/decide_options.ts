// The options of the next adjustment: a form that the server makes of the settings of `adjust`, and the command.
import { ask, send } from "./api";
import { button, element, h } from "./dom";
import { Model } from "./model";
import { OptionFields, Values } from "./option_form";
import { OptionForm } from "./types";
import { say } from "./words";

export class DecideOptions {
  readonly root = h("section", { class: "leaf", "aria-label": say("studio_decide.options") });
  private readonly form = new OptionFields("option", (values) => void this.send(values));
  private readonly command = h("code", { class: "command" });

  constructor(private readonly model: Model) {
    const go = button("studio_decide.adjust", () => element("adjust").click(), "main");
    go.id = "options-adjust";
    const usual = button("studio_decide.reset", () => void this.send({}));
    usual.id = "options-usual";
    this.root.append(
      h("p", { class: "note" }, say("studio_decide.options_note")),
      this.form.root, h("div", { class: "deeds" }, go, usual),
      h("h3", {}, say("studio_decide.command")), h("p", {}, this.command));
  }

  async show(): Promise<void> {
    this.fill(await ask<OptionForm>("/api/options"));
  }

  private async send(values: Values): Promise<void> {
    try {
      this.fill(await send<OptionForm>("/api/options", { values }));
      this.model.say("studio_decide.options_stored", {}, "good");
    } catch (error) {
      this.model.fail(error);
    }
  }

  private fill({ fields, command }: OptionForm): void {
    this.form.fill(fields);
    this.command.textContent = command;
  }
}
