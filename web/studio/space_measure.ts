// Measuring between points of object space: the server answers with standard deviations of the full covariance.
import { ask } from "./api";
import { button, h } from "./dom";
import { Model } from "./model";
import { decimalsOf, fixed, withUnit } from "./numbers";
import { SpaceData } from "./space_data";

interface Answer {
  words: string;
  values: { name: string; value: number; sigma: number | null; unit: string }[];
  remark: string;
}

const KINDS: Record<string, string> = {
  "": "by number of points", coordinates: "coordinates", distance: "distance", angle: "angle", area: "area",
  length: "length of a polyline", plane: "flatness", line: "straightness",
  to_plane: "first to a plane", to_line: "first to a line",
};
const SHOWN = 6; // values of an answer; the command line tells all

export class SpaceMeasure {
  readonly parts: HTMLElement[];
  names: string[] = [];
  words = "";
  private readonly box = h("input", { type: "checkbox", id: "space-measure" });
  private readonly kind = h("select", { id: "space-kind", "aria-label": "What is measured" },
    ...Object.entries(KINDS).map(([kind, words]) => h("option", { value: kind }, words)));
  private turn = 0;

  constructor(model: Model, private readonly changed: () => void) {
    this.box.addEventListener("change", () => this.clear());
    this.kind.addEventListener("change", () => void this.asked());
    this.parts = [h("span", { class: "group" },
      h("label", { title: "Clicks choose points to measure between: 2 a distance, 3 an angle, more an area" }, this.box, "measure"),
      this.kind, button("Add current", "Measure to the current point, too", () => model.current && this.add(model.current)),
      button("Clear", "Measure anew", () => this.clear()),
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
    void this.asked();
  }

  private clear(): void {
    this.names = [];
    this.words = this.on ? "Click the points to measure between." : "Click a point to choose it, a station to open its image.";
    this.changed();
  }

  private async asked(): Promise<void> {
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
      const rest = values.length > SHOWN ? ` and ${values.length - SHOWN} more` : "";
      this.words = `${found.words}: ${values.slice(0, SHOWN).join(", ")}${rest}${found.remark ? `\n${found.remark}` : ""}`;
    } catch (error) {
      if (turn !== this.turn) return;
      this.words = `${this.names.join(", ")}: ${(error as Error).message}`;
    }
    this.changed();
  }
}
