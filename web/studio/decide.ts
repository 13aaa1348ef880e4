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
import type { Leaf, Ways } from "./leaf";

export class Decide {
  private readonly leaves: [name: string, words: string, leaf: Leaf][];
  private readonly heads: HTMLButtonElement[];
  private now = 0;

  constructor(private readonly model: Model, private readonly isOpen: () => boolean, ways: Ways) {
    this.leaves = [
      ["run", "Run", new DecideRun(model)], ["options", "Options", new DecideOptions(model)], ["parameters", "Parameters", new DecideParameters(model)],
      ["select", "Select", new DecideSelect(model, ways)], ["compare", "Compare", new DecideCompare(model, ways)],
      ["calibration", "Calibration", new DecideCalibration(model)], ["targets", "Targets", new DecideTargets(model, ways)], ["report", "Report", new DecideReport()],
    ];
    this.heads = this.leaves.map(([name, words], k) => {
      const head = button(words, `Show ${words.toLowerCase()}`, () => this.turn(k));
      head.id = `decide-${name}`;
      return head;
    });
    element("decide-bar").append(h("span", { class: "group", role: "group", "aria-label": "What is decided" }, ...this.heads));
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
    this.leaves[this.now][2].show().catch((error: Error) => this.model.say(error.message, "bad"));
  }
}
