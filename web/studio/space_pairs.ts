// The match graph: images joined where they share points.
import * as THREE from "three";
import { positions } from "../common/shapes";
import { h } from "./dom";
import { grouped } from "./numbers";
import { SpaceData } from "./space_data";
import { say, titleOf } from "./words";

const STEPS = 100;
/** Weak, middle and strong connections, distinct to all eyes. */
export const PAIR_COLOURS = ["#882255", "#ddaa33", "#0072b2"];

export class SpacePairs {
  readonly parts: HTMLElement[];
  readonly lines = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ vertexColors: true }));
  private readonly box = h("input", { type: "checkbox", id: "show-pairs" });
  private readonly least = h("input", { type: "range", id: "pairs-least", min: 0, max: STEPS, value: 0, "aria-label": say("studio_space.fewest") });
  private readonly words = h("output", { for: "pairs-least" });
  private data: SpaceData | null = null;

  constructor(private readonly changed: () => void) {
    for (const each of [this.box, this.least]) each.addEventListener("input", () => this.show());
    this.parts = [h("span", { class: "group" },
      h("label", { title: titleOf("studio_space.pairs") }, this.box, say("studio_space.pairs")), this.least, this.words)];
    this.lines.frustumCulled = false;
    this.showFewest();
  }

  take(data: SpaceData): void {
    this.data = data;
    const { pairs, common, centre, head } = data;
    const ends = new Float32Array(3 * pairs.length);
    const rgb = new Float32Array(3 * pairs.length);
    const colours = PAIR_COLOURS.map((hex) => new THREE.Color(hex));
    pairs.forEach((image, k) => {
      const n = common[k >> 1];
      ends.set(centre.subarray(3 * image, 3 * image + 3), 3 * k);
      colours[n < head.few ? 0 : n < head.strong ? 1 : 2].toArray(rgb, 3 * k);
    });
    this.lines.geometry.dispose();
    this.lines.geometry = positions(ends).setAttribute("color", new THREE.BufferAttribute(rgb, 3));
    this.show();
  }

  /** Its colours. */
  get legend(): [string, string][] {
    if (!this.box.checked || !this.data) return [];
    const { few, strong } = this.data.head;
    const counts = [0, 0, 0];
    for (let k = 0; k < this.drawn; k++) counts[this.data.common[k] < few ? 0 : this.data.common[k] < strong ? 1 : 2]++;
    const words = [say("studio_space.weak_pairs", { limit: few }), `${few}–${strong - 1}`, `≥ ${strong}`];
    return PAIR_COLOURS.map((hex, k): [string, string] => [hex, `${words[k]}: ${grouped(counts[k])}`]);
  }

  /** Common points from which on a connection is drawn: even steps of the logarithm. */
  private get fewest(): number {
    return Math.round(Math.max(this.data?.common[0] ?? 1, 1) ** (Number(this.least.value) / STEPS));
  }

  /** Connections that are drawn; they are sorted, most common points first. */
  private get drawn(): number {
    const { common } = this.data!;
    let [low, high] = [0, common.length];
    while (low < high) {
      const k = (low + high) >> 1;
      if (common[k] >= this.fewest) low = k + 1;
      else high = k;
    }
    return low;
  }

  private show(): void {
    this.lines.visible = this.box.checked;
    if (this.data) this.lines.geometry.setDrawRange(0, 2 * this.drawn);
    this.showFewest();
    this.changed();
  }

  private showFewest(): void {
    this.words.textContent = `≥ ${grouped(this.fewest)}`;
    this.least.setAttribute("aria-valuetext", String(this.fewest));
  }
}
