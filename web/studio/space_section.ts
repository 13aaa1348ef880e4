// A slab of object space: what lies before and behind it is not drawn.
import * as THREE from "three";
import { choices, h } from "./dom";
import { short, withUnit } from "./numbers";
import { SpaceData } from "./space_data";
import { say, titleOf } from "./words";

const STEPS = 200;
type Across = "" | "0" | "1" | "2" | "points";
const ACROSS: Record<Across, string> = { "": "none", 0: "side", 1: "front", 2: "level", points: "points" };

export class SpaceSection {
  readonly parts: HTMLElement[];
  private readonly across = h("select", { id: "section-across", },
    ...choices(["", "0", "1", "2", "points"], (across) => say("studio_space.across", { across: ACROSS[across as Across] })));
  private readonly place = h("input", { type: "range", id: "section-place", min: 0, max: STEPS, value: STEPS / 2, "aria-label": say("studio_space.section_place") });
  private readonly thick = h("input", { type: "range", id: "section-thickness", min: 1, max: STEPS, value: STEPS / 10, "aria-label": say("studio_space.section_thickness") });
  private readonly words = h("output", { for: "section-place section-thickness" });
  private data: SpaceData | null = null;
  private normal = new THREE.Vector3();
  private range: [number, number] = [0, 0];
  private begin = 0;

  /** names: the points that are measured between, for a section through three of them. */
  constructor(private readonly names: () => string[], private readonly changed: () => void) {
    this.across.addEventListener("change", () => this.turn());
    for (const each of [this.place, this.thick]) each.addEventListener("input", () => this.changed());
    this.parts = [h("span", { class: "group" }, h("label", { title: titleOf("studio_space.section") }, say("studio_space.section"), this.across),
      h("label", { title: say("studio_space.section_place") }, "↔", this.place), h("label", { title: say("studio_space.section_thickness") }, "↕", this.thick), this.words)];
    this.place.disabled = this.thick.disabled = true;
  }

  take(data: SpaceData): void {
    this.data = data;
    this.turn();
  }

  /** Planes between which is drawn; none where all is. */
  get planes(): THREE.Plane[] {
    if (!this.on) return [];
    const { middle, half } = this;
    return [new THREE.Plane(this.normal.clone(), half - middle), new THREE.Plane(this.normal.clone().negate(), half + middle)];
  }

  /** Other points are measured between: a section that waited for three has them now. */
  measured(): void {
    if (this.across.value === "points" && !this.on) this.turn();
  }

  /** Whether a point is within. */
  holds(x: number, y: number, z: number): boolean {
    if (!this.on) return true;
    return Math.abs(this.normal.x * x + this.normal.y * y + this.normal.z * z - this.middle) <= this.half;
  }

  /** Show how thick it is. */
  show(): void {
    const half = `± ${withUnit(short(this.half), this.data?.head.unit ?? "")}`;
    this.words.textContent = !this.across.value ? "" : this.on ? half : say("studio_space.three_points_first");
  }

  private get on(): boolean {
    return this.across.value !== "" && this.normal.lengthSq() > 0;
  }

  private get middle(): number {
    const [low, high] = this.range;
    return low + ((high - low) * Number(this.place.value)) / STEPS;
  }

  private get half(): number {
    const [low, high] = this.range;
    return (Math.max(high - low, 1e-12) * Number(this.thick.value)) / STEPS / 2;
  }

  private turn(): void {
    const across = this.across.value as Across;
    for (const each of [this.place, this.thick]) each.disabled = !across;
    this.normal.set(0, 0, 0);
    if (this.data && across === "points") this.throughPoints(this.data);
    else if (this.data && across) this.normal.set(...(this.data.head.basis.slice(3 * Number(across), 3 * Number(across) + 3) as [number, number, number]));
    if (this.data && this.on) this.ranged(this.data);
    this.changed();
  }

  private throughPoints(data: SpaceData): void {
    const at = this.names().slice(0, 3).map((name) => data.rowOf(name)).filter((row) => row !== undefined).map((row) => new THREE.Vector3(...data.at(row)));
    if (at.length < 3) return;
    this.normal.crossVectors(at[1].clone().sub(at[0]), at[2].clone().sub(at[0]));
    if (this.normal.length() < 1e-9 * data.head.extent ** 2) return void this.normal.set(0, 0, 0);
    this.normal.normalize();
    this.begin = this.normal.dot(at[0]);
  }

  /** From where to where a section can be: 98 % of the points; through three points it begins at these. */
  private ranged(data: SpaceData): void {
    const step = Math.max(Math.floor(data.points / 20000), 1);
    const along: number[] = [];
    for (let k = 0; k < data.points; k += step) {
      const [x, y, z] = data.at(k);
      along.push(this.normal.x * x + this.normal.y * y + this.normal.z * z);
    }
    along.sort((a, b) => a - b);
    this.range = along.length ? [along[Math.floor(0.01 * along.length)], along[Math.ceil(0.99 * along.length) - 1]] : [0, 0];
    if (this.across.value !== "points") return;
    const [low, high] = this.range;
    const reach = Math.max(high - this.begin, this.begin - low, 1e-9 * data.head.extent);
    this.range = [this.begin - reach, this.begin + reach];
    this.place.value = String(STEPS / 2);
    this.thick.value = String(STEPS / 40);
  }
}
