// The options of the next adjustment: a form that the server makes of the settings of `adjust`, and the command.
import { ask, tell } from "./api";
import { button, element, h } from "./dom";
import { Model } from "./model";
import { OptionField, OptionForm } from "./types";

type Input = HTMLInputElement | HTMLSelectElement;

export class DecideOptions {
  readonly root = h("section", { class: "leaf", "aria-label": "Options of the adjustment" });
  private readonly form = h("form", { class: "options" });
  private readonly command = h("code", { class: "command" });
  private readonly inputs = new Map<string, [OptionField, Input]>();

  constructor(private readonly model: Model) {
    const go = button("Adjust with these options", "Adjust block and marks in the background", () => element("adjust").click(), "main");
    go.id = "options-adjust";
    const usual = button("As usual", "All options as they are by default", () => void this.send({}));
    usual.id = "options-usual";
    this.form.addEventListener("submit", (event) => event.preventDefault());
    this.form.addEventListener("change", () => void this.send(this.values()));
    this.root.append(
      h("p", { class: "note" }, "They hold for every adjustment that is begun here, from this page or from the button above. While it runs, the line below shows how far it is; Stop ends it and changes nothing."),
      this.form, h("div", { class: "deeds" }, go, usual),
      h("h3", {}, "The same on the command line"), h("p", {}, this.command));
  }

  async show(): Promise<void> {
    this.fill(await ask<OptionForm>("/api/options"));
  }

  private values(): Record<string, string | number | boolean> {
    const found: Record<string, string | number | boolean> = {};
    for (const [name, [field, input]] of this.inputs) {
      if (field.kind === "flag") found[name] = (input as HTMLInputElement).checked;
      else if (field.kind === "number") found[name] = input.value.trim() ? Number(input.value.replace(",", ".")) : field.default;
      else found[name] = input.value;
    }
    return found;
  }

  private async send(values: Record<string, string | number | boolean>): Promise<void> {
    try {
      this.fill(await tell<OptionForm>("/api/options", { values }));
      this.model.say("Options of the next adjustment.", "good");
    } catch (error) {
      this.model.say((error as Error).message, "bad");
    }
  }

  private fill({ fields, command }: OptionForm): void {
    if (!this.inputs.size) this.form.append(...fields.map((f) => this.row(f)));
    for (const { name, value, default: usual } of fields) {
      const [field, input] = this.inputs.get(name)!;
      if (field.kind === "flag") (input as HTMLInputElement).checked = value === true;
      else if (document.activeElement !== input || input instanceof HTMLSelectElement) input.value = String(value);
      input.closest(".option")!.classList.toggle("changed", value !== usual);
    }
    this.command.textContent = command;
  }

  private row(field: OptionField): HTMLElement {
    const id = `option-${field.name}`;
    const more = { id, name: field.name, "aria-describedby": `${id}-help`, title: field.help };
    let input: Input;
    if (field.kind === "choice") input = h("select", more, ...field.choices.map((c) => h("option", { value: c }, c.replace("_", " "))));
    else if (field.kind === "flag") input = h("input", { ...more, type: "checkbox" });
    else if (field.kind === "number")
      input = h("input", { ...more, type: "number", min: field.low ?? "", max: field.high ?? "", step: field.whole ? 1 : "any" });
    else input = h("input", { ...more, type: "text", placeholder: field.metavar, autocomplete: "off", spellcheck: "false" });
    this.inputs.set(field.name, [field, input]);
    return h("div", { class: "option" }, h("label", { for: id }, field.name.replace(/_/g, " ")), input,
      h("p", { class: "note", id: `${id}-help` }, field.help));
  }
}
