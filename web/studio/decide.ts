// The page on which an adjustment is decided: its options, its parameters, what is left out, and what came of it.
import { button, element, h } from "./dom";
import { DecideCalibration } from "./decide_calibration";
import { DecideCompare } from "./decide_compare";
import { DecideOptions } from "./decide_options";
import { DecideParameters } from "./decide_parameters";
import { DecideReport } from "./decide_report";
import { DecideRun } from "./decide_run";
import { DecideSelect } from "./decide_select";
import { DecideTargets } from "./decide_targets";
import { Model } from "./model";
import { say } from "./words";
import type { Leaf, Ways } from "./leaf";

export class Decide {
  private readonly leaves: [name: string, code: string, leaf: Leaf][];
  private readonly heads: HTMLButtonElement[];
  private now = 0;

  constructor(private readonly model: Model, private readonly isOpen: () => boolean, ways: Ways) {
    this.leaves = [
      ["run", "studio_decide.run", new DecideRun(model)], ["options", "studio_decide.options", new DecideOptions(model)],
      ["parameters", "studio_decide.parameters", new DecideParameters(model)], ["select", "studio_decide.select", new DecideSelect(model, ways)],
      ["compare", "studio_decide.compare", new DecideCompare(model, ways)], ["calibration", "studio_decide.calibration", new DecideCalibration(model)],
      ["targets", "studio_decide.targets", new DecideTargets(model, ways)], ["report", "studio_page.report", new DecideReport()],
    ];
    this.heads = this.leaves.map(([name, code], k) => {
      const head = button(code, () => this.turn(k));
      head.id = `decide-${name}`;
      return head;
    });
    element("decide-bar").append(h("span", { class: "group", role: "group", "aria-label": say("studio_decide.parts") }, ...this.heads));
    element("decide").append(...this.leaves.map(([, , leaf]) => leaf.root));
    this.turn(1);
    model.on(["read", "state", "targets"], () => this.isOpen() && this.show());
  }

  private turn(k: number): void {
    this.now = k;
    this.heads.forEach((head, i) => head.setAttribute("aria-pressed", String(i === k)));
    this.leaves.forEach(([, , leaf], i) => (leaf.root.hidden = i !== k));
    if (this.isOpen()) this.show();
  }

  show(): void {
    this.leaves[this.now][2].show().catch((error) => this.model.fail(error));
  }
}
