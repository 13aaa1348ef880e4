// The last adjustments beside one another, two of them compared as `raybundle compare` does it.
import { ask } from "./api";
import { button, h } from "./dom";
import type { Ways } from "./leaf";
import { framed, nameOf } from "./decide_report";
import { Model } from "./model";
import { fixed, short, withUnit } from "./numbers";
import { Kept } from "./types";

const HEADS = ["first", "second", "adjustment", "sigma0", "redundancy", "rejected", "free", "mean sigma", "rms at check points"];

export class DecideCompare {
  readonly root = h("section", { class: "leaf whole", "aria-label": "Adjustments beside one another" });
  private readonly body = h("tbody", {});
  private readonly worst = h("div", { class: "beside" });
  private readonly told = h("p", { class: "note", role: "status" });
  private readonly frame = framed("Comparison of the two adjustments");
  private kept: Kept[] = [];
  private pair: [number, number] = [-1, -1];
  private at = "";

  constructor(private readonly model: Model, private readonly ways: Ways) {
    this.root.append(
      h("table", { class: "kept", "aria-label": "Adjustments of this session" },
        h("thead", {}, h("tr", {}, ...HEADS.map((words) => h("th", { scope: "col" }, words)))), this.body),
      this.worst, this.told, this.frame);
  }

  async show(): Promise<void> {
    const before = this.kept.length ? this.kept[this.kept.length - 1].number : -1;
    this.kept = (await ask<{ adjustments: Kept[] }>("/api/adjustments")).adjustments;
    const numbers = this.kept.map((k) => k.number);
    // what was made last beside what was made before it
    if (numbers[numbers.length - 1] !== before || !this.pair.every((n) => numbers.includes(n)))
      this.pair = [numbers[numbers.length - 2] ?? -1, numbers[numbers.length - 1] ?? -1];
    this.body.replaceChildren(...this.kept.map((k) => this.row(k)));
    this.compare();
  }

  private row(k: Kept): HTMLElement {
    const rms = k.check.points ? k.check.rms.map((v) => short(v, 2)).join(", ") : "–";
    const free = k.parameters.filter((p) => p.sigma !== null).length;
    return h("tr", {}, h("td", {}, this.radio(0, k)), h("td", {}, this.radio(1, k)), h("th", { scope: "row" }, nameOf(k), h("small", { class: "note", title: k.options.join(" ") }, k.options.join(" ") || "options as usual")),
      h("td", {}, fixed(k.sigma0, 4)), h("td", {}, k.redundancy?.toLocaleString("en") ?? "–"), h("td", {}, k.rejected?.toLocaleString("en") ?? "–"),
      h("td", {}, String(free)), h("td", {}, withUnit(short(k.mean_std, 2), k.unit)), h("td", {}, k.check.points ? withUnit(rms, k.unit) : rms));
  }

  private radio(which: 0 | 1, k: Kept): HTMLElement {
    const side = which ? "second" : "first";
    const input = h("input", { type: "radio", name: `compare-${side}`, id: `compare-${side}-${k.number}`, checked: this.pair[which] === k.number, "aria-label": `${nameOf(k)} as the ${side}` });
    input.addEventListener("change", () => {
      this.pair[which] = k.number;
      this.compare();
    });
    return input;
  }

  private compare(): void {
    const two = this.pair.map((n) => this.kept.find((k) => k.number === n));
    const [first, second] = two;
    const ready = first !== undefined && second !== undefined && first !== second;
    this.told.textContent = ready ? "" : this.kept.length < 2 ? "Adjust once more, with another option or parameter, to compare." : "Choose two different adjustments.";
    this.told.hidden = ready;
    this.worst.replaceChildren(...two.filter((k) => k !== undefined).filter((k, i, all) => all.indexOf(k) === i).map((k) => this.largest(k)));
    const address = ready ? `/comparison/${first.number}/${second.number}` : "";
    this.frame.hidden = !ready;
    if (ready && address !== this.at) this.frame.src = address;
    this.at = address;
  }

  private largest(k: Kept): HTMLElement {
    return h("div", {}, h("h3", {}, `Largest residuals of ${nameOf(k)}`),
      h("table", { "aria-label": `Largest residuals of ${nameOf(k)}` }, h("thead", {}, h("tr", {}, ...["image observation", "|w|", "v px"].map((words) => h("th", { scope: "col" }, words)))),
        h("tbody", {}, ...k.worst.map((w) => h("tr", {},
          h("td", { class: "l" }, button(`${w.point} in ${w.image}`, `Show ${w.point} in ${w.image}`, () => this.visit(w.point, w.image), "link")),
          h("td", {}, fixed(w.w, 2)), h("td", {}, fixed(w.v_px, 2)))))));
  }

  private visit(point: string, image: string): void {
    if (this.model.images.has(image)) this.ways.visit(point, image);
  }
}
