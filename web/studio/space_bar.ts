// What object space shows, and how.
import { button, h } from "./dom";
import { Colouring } from "./space_colours";

type Shown = "points" | "stations" | "ellipsoids" | "bars";

export class SpaceBar {
  readonly parts: HTMLElement[];
  private readonly boxes = new Map<Shown, HTMLInputElement>();
  private readonly select = h("select", { id: "space-colour" },
    ...[["role", "role"], ["rays", "rays"], ["sigma", "sigma"], ["w", "largest |w|"],
      ["redundancy", "redundancy"], ["residual", "residual"]].map(([value, words]) => h("option", { value }, words)));
  private readonly scale = h("input", { type: "range", id: "ellipsoid-scale", min: -20, max: 20, value: 0 });
  private readonly scaleWords = h("output", { for: "ellipsoid-scale" });
  private typicalSize = 1;

  constructor(changed: () => void, home: () => void) {
    const box = (name: Shown, words: string, on: boolean) => {
      const made = h("input", { type: "checkbox", id: `show-${name}`, checked: on });
      made.addEventListener("change", changed);
      this.boxes.set(name, made);
      return h("label", {}, made, words);
    };
    this.select.addEventListener("change", changed);
    this.scale.addEventListener("input", () => {
      this.tell();
      changed();
    });
    this.parts = [
      h("label", {}, "colour", this.select), box("points", "points", true), box("stations", "stations", true),
      box("bars", "scale bars", true), box("ellipsoids", "ellipsoids", false),
      h("label", { title: "Enlargement of the error ellipsoids" }, "×", this.scale, this.scaleWords),
      button("All", "Show all of it (0)", home),
    ];
  }

  shows(name: Shown): boolean {
    return this.boxes.get(name)!.checked;
  }

  get colouring(): Colouring {
    return this.select.value as Colouring;
  }

  /** Enlargement at which a typical ellipsoid is seen. */
  set typical(value: number) {
    this.typicalSize = value;
    this.tell();
  }

  get enlarged(): number {
    return this.typicalSize * 10 ** (Number(this.scale.value) / 10);
  }

  private tell(): void {
    this.scaleWords.textContent = Number(this.enlarged.toPrecision(2)).toLocaleString("en");
  }
}
