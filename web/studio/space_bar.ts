// What object space shows, and how.
import { button, choices, h } from "./dom";
import { local } from "./numbers";
import { Colouring } from "./space_colours";
import { say } from "./words";

type Shown = "points" | "stations" | "ellipsoids" | "bars";

export class SpaceBar {
  readonly parts: HTMLElement[];
  private readonly boxes = new Map<Shown, HTMLInputElement>();
  private readonly select = h("select", { id: "space-colour" },
    ...choices(["role", "rays", "sigma", "w", "redundancy", "residual"], (by) => say("studio_space.colouring", { by })));
  private readonly scale = h("input", { type: "range", id: "ellipsoid-scale", min: -20, max: 20, value: 0 });
  private readonly scaleWords = h("output", { for: "ellipsoid-scale" });
  private typicalSize = 1;

  constructor(changed: () => void, home: () => void) {
    const box = (name: Shown, on: boolean) => {
      const made = h("input", { type: "checkbox", id: `show-${name}`, checked: on });
      made.addEventListener("change", changed);
      this.boxes.set(name, made);
      return h("label", {}, made, say("studio_space.shown", { name }));
    };
    this.select.addEventListener("change", changed);
    this.scale.addEventListener("input", () => {
      this.showScale();
      changed();
    });
    this.parts = [
      h("label", {}, say("studio_space.colour"), this.select), box("points", true), box("stations", true), box("bars", true), box("ellipsoids", false),
      h("label", { title: say("studio_space.enlargement") }, "×", this.scale, this.scaleWords),
      button("studio_space.all", home),
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
    this.showScale();
  }

  get enlarged(): number {
    return this.typicalSize * 10 ** (Number(this.scale.value) / 10);
  }

  private showScale(): void {
    this.scaleWords.textContent = local(String(Number(this.enlarged.toPrecision(2))));
  }
}
