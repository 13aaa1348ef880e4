// A form that the server makes of the settings of a command: a field for each, with its help and limits.
import { choices, h } from "./dom";
import { OptionField } from "./types";

type Input = HTMLInputElement | HTMLSelectElement;
export type Values = Record<string, string | number | boolean | null>;

export class OptionFields {
  readonly root = h("form", { class: "options" });
  private readonly inputs = new Map<string, [OptionField, Input]>();

  /** prefix  of the fields' ids; changed  gets the values of all fields */
  constructor(private readonly prefix: string, changed: (values: Values) => void) {
    this.root.addEventListener("submit", (event) => event.preventDefault());
    this.root.addEventListener("change", () => changed(this.values()));
  }

  values(): Values {
    const found: Values = {};
    for (const [name, [field, input]] of this.inputs) {
      if (field.kind === "flag") found[name] = (input as HTMLInputElement).checked;
      else if (field.kind === "number") found[name] = input.value.trim() ? Number(input.value.replace(",", ".")) : field.default;
      else found[name] = input.value;
    }
    return found;
  }

  fill(fields: OptionField[]): void {
    if (!this.inputs.size) this.root.append(...fields.map((f) => this.row(f)));
    for (const { name, value, default: usual } of fields) {
      const [field, input] = this.inputs.get(name)!;
      if (field.kind === "flag") (input as HTMLInputElement).checked = value === true;
      else if (document.activeElement !== input || input instanceof HTMLSelectElement) input.value = value === null ? "" : String(value);
      input.closest(".option")!.classList.toggle("changed", value !== usual);
    }
  }

  private row(field: OptionField): HTMLElement {
    const id = `${this.prefix}-${field.name}`;
    const more = { id, name: field.name, "aria-describedby": `${id}-help`, title: field.help };
    let input: Input;
    if (field.kind === "choice") input = h("select", more, ...choices(field.choices, (c) => c.replace("_", " ") || "–"));
    else if (field.kind === "flag") input = h("input", { ...more, type: "checkbox" });
    else if (field.kind === "number")
      input = h("input", { ...more, type: "number", min: field.low ?? "", max: field.high ?? "", step: field.whole ? 1 : "any", placeholder: field.metavar });
    else input = h("input", { ...more, type: "text", placeholder: field.metavar, autocomplete: "off", spellcheck: "false" });
    this.inputs.set(field.name, [field, input]);
    return h("div", { class: "option" }, h("label", { for: id }, field.flag.replace(/^--/, "").replace(/-/g, " ")), input,
      h("p", { class: "note", id: `${id}-help` }, field.help));
  }
}
