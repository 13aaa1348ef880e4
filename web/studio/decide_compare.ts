// The last adjustments beside one another, two of them compared as `raybundle compare` does it.
import { ask } from "./api";
import { heads, h, sign } from "./dom";
import type { Ways } from "./leaf";
import { framed, nameOf } from "./decide_report";
import { Model } from "./model";
import { fixed, grouped, short, withUnit } from "./numbers";
import { AdjustmentRow } from "./types";
import { say } from "./words";

export class DecideCompare {
  readonly root = h("section", { class: "leaf whole", "aria-label": say("studio_decide.compare") });
  private readonly body = h("tbody", {});
  private readonly worst = h("div", { class: "beside" });
  private readonly status = h("p", { class: "note", role: "status" });
  private readonly frame = framed(say("studio_decide.comparison"));
  private adjustments: AdjustmentRow[] = [];
  private pair: [number, number] = [-1, -1];
  private at = "";

  constructor(private readonly model: Model, private readonly ways: Ways) {
    this.root.append(
      h("table", { class: "adjustments", "aria-label": say("studio_decide.adjustments") },
        heads(["studio_decide.first", "studio_decide.second", "studio_decide.adjustment", "studio_decide.sigma0", "label.redundancy", "label.rejected",
          "studio_decide.free", "studio_decide.mean_sigma", "studio_decide.rms_check"]), this.body),
      this.worst, this.status, this.frame);
  }

  async show(): Promise<void> {
    const before = this.adjustments.length ? this.adjustments[this.adjustments.length - 1].number : -1;
    this.adjustments = (await ask<{ adjustments: AdjustmentRow[] }>("/api/adjustments")).adjustments;
    const numbers = this.adjustments.map((k) => k.number);
    // what was made last beside what was made before it
    if (numbers[numbers.length - 1] !== before || !this.pair.every((n) => numbers.includes(n)))
      this.pair = [numbers[numbers.length - 2] ?? -1, numbers[numbers.length - 1] ?? -1];
    this.body.replaceChildren(...this.adjustments.map((k) => this.row(k)));
    this.compare();
  }

  private row(k: AdjustmentRow): HTMLElement {
    const rms = k.check.points ? k.check.rms.map((v) => short(v, 2)).join(", ") : "–";
    const free = k.parameters.filter((p) => p.sigma !== null).length;
    return h("tr", {}, h("td", {}, this.radio(0, k)), h("td", {}, this.radio(1, k)), h("th", { scope: "row" }, nameOf(k), h("small", { class: "note", title: k.options.join(" ") }, k.options.join(" ") || say("studio_decide.defaults"))),
      h("td", {}, fixed(k.sigma0, 4)), h("td", {}, k.redundancy === null ? "–" : grouped(k.redundancy)), h("td", {}, k.rejected === null ? "–" : grouped(k.rejected)),
      h("td", {}, String(free)), h("td", {}, withUnit(short(k.mean_std, 2), k.unit)), h("td", {}, k.check.points ? withUnit(rms, k.unit) : rms));
  }

  private radio(which: 0 | 1, k: AdjustmentRow): HTMLElement {
    const side = which ? "second" : "first";
    const input = h("input", { type: "radio", name: `compare-${side}`, id: `compare-${side}-${k.number}`, checked: this.pair[which] === k.number, "aria-label": say("studio_decide.as_side", { name: nameOf(k), side }) });
    input.addEventListener("change", () => {
      this.pair[which] = k.number;
      this.compare();
    });
    return input;
  }

  private compare(): void {
    const two = this.pair.map((n) => this.adjustments.find((k) => k.number === n));
    const [first, second] = two;
    const ready = first !== undefined && second !== undefined && first !== second;
    this.status.textContent = ready ? "" : this.adjustments.length < 2 ? say("studio_decide.adjust_again") : say("studio_decide.choose_two");
    this.status.hidden = ready;
    this.worst.replaceChildren(...two.filter((k) => k !== undefined).filter((k, i, all) => all.indexOf(k) === i).map((k) => this.largest(k)));
    const address = ready ? `/comparison/${first.number}/${second.number}` : "";
    this.frame.hidden = !ready;
    if (ready && address !== this.at) this.frame.src = address;
    this.at = address;
  }

  private largest(k: AdjustmentRow): HTMLElement {
    const title = say("studio_decide.largest_residuals", { name: nameOf(k) });
    return h("div", {}, h("h3", {}, title),
      h("table", { "aria-label": title }, heads(["studio_table.observation", "studio_table.w", "studio_decide.v"]),
        h("tbody", {}, ...k.worst.map((w) => h("tr", {},
          h("td", { class: "l" }, sign(say("studio_decide.point_in_image", { ...w }), say("studio_decide.show_point", { ...w }), () => this.visit(w.point, w.image), "link")),
          h("td", {}, fixed(w.w, 2)), h("td", {}, fixed(w.v_px, 2)))))));
  }

  private visit(point: string, image: string): void {
    if (this.model.images.has(image)) this.ways.visit(point, image);
  }
}
