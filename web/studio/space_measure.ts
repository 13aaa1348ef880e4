// Measuring between points of object space: the server answers with standard deviations of the full covariance.
import { ask } from "./api";
import { button, choices, h } from "./dom";
import { Model } from "./model";
import { decimalsOf, fixed, withUnit } from "./numbers";
import { SpaceData } from "./space_data";
import { say, titleOf } from "./words";

interface Answer {
  values: { name: string; value: number; sigma: number | null; unit: string }[];
  remark: string;
}

const KINDS = ["", "coordinates", "distance", "angle", "area", "length", "plane", "line", "to_plane", "to_line"];
const SHOWN = 6; // values of an answer; the command line prints all
const kindName = (kind: string): string => say("studio_space.quantity", { kind: kind || "any" });

export class SpaceMeasure {
  readonly parts: HTMLElement[];
  names: string[] = [];
  words = "";
  private readonly box = h("input", { type: "checkbox", id: "space-measure" });
  private readonly kind = h("select", { id: "space-kind", "aria-label": say("studio_space.measured") }, ...choices(KINDS, kindName));
  private turn = 0;

  constructor(model: Model, private readonly changed: () => void) {
    this.box.addEventListener("change", () => this.clear());
    this.kind.addEventListener("change", () => void this.answer());
    this.parts = [h("span", { class: "group" },
      h("label", { title: titleOf("studio_space.measure") }, this.box, say("studio_space.measure")),
      this.kind, button("studio_space.add_current", () => model.current && this.add(model.current)),
      button("studio_space.clear", () => this.clear()),
    )];
  }

  get on(): boolean {
    return this.box.checked;
  }

  get closed(): boolean {
    return this.what === "area";
  }

  private get what(): string {
    const n = this.names.length;
    return this.kind.value || (n === 1 ? "coordinates" : n === 2 ? "distance" : n === 3 ? "angle" : "area");
  }

  take(data: SpaceData): void {
    if (this.names.some((name) => data.rowOf(name) === undefined)) this.clear();
  }

  add(name: string): void {
    this.names = this.names.includes(name) ? this.names.filter((n) => n !== name) : [...this.names, name];
    void this.answer();
  }

  private clear(): void {
    this.names = [];
    this.words = this.on ? say("studio_space.click_points") : say("studio_space.click");
    this.changed();
  }

  private async answer(): Promise<void> {
    const turn = ++this.turn;
    this.words = this.names.join(", ");
    this.changed();
    if (!this.names.length) return;
    try {
      const found = await ask<Answer>("/api/query", { kind: this.what, points: this.names });
      if (turn !== this.turn) return;
      const values = found.values.map(({ name, value, sigma, unit }) => {
        const whole = `${fixed(value, decimalsOf(sigma))} ± ${fixed(sigma, decimalsOf(sigma))}`;
        return `${found.values.length > 1 ? `${name} ` : ""}${withUnit(whole, unit.replace("^2", "²").replace("deg", "°"))}`;
      });
      const rest = values.length > SHOWN ? ` (+${values.length - SHOWN})` : "";
      this.words = `${kindName(this.what)} ${this.names.join(", ")}: ${values.slice(0, SHOWN).join("; ")}${rest}${found.remark ? `\n${found.remark}` : ""}`;
    } catch (error) {
      if (turn !== this.turn) return;
      this.words = `${this.names.join(", ")}: ${(error as Error).message}`;
    }
    this.changed();
  }
}
