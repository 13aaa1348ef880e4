// What the calibration of each camera is worth, what to photograph next, its parameters and figures.
import { ask } from "./api";
import { exact, raised, small } from "./decide_parameters";
import { heads, h } from "./dom";
import { Model } from "./model";
import { decimalsOf, short } from "./numbers";
import { keyed, say } from "./words";

interface Verdict {
  grade: string;
  headline: string;
  reasons: string[];
  advice: { photographs: string; uncertainty_px: number | null; ratio: number | null }[];
  photographs: number;
  image_sigma_px: number | null;
  uncertainty_px: number | null;
  typical_uncertainty_px: number | null;
  reach: number | null;
  coverage: number | null;
  rolls: number;
  convergence_deg: number | null;
  cross_validation: { folds: number; rms_px: number; fit_px: number } | null;
}

interface Calibrated {
  camera: string;
  about: string;
  verdict: Verdict | null;
  verdict_is: "stored" | "computed";
  figures: { number: number; caption: string; width: number }[];
  parameters: { symbol: string; meaning: string; unit: string; value: number | null; sigma: number | null; status: string; determinability: number | null }[];
}

const LOOKS: Record<string, string> = { good: "good", usable: "remarks" };

export class DecideCalibration {
  readonly root = h("section", { class: "leaf", tabindex: 0, "aria-label": say("studio_decide.calibration") });
  private readonly status = h("p", { class: "note", role: "status" });
  private readonly box = h("div", {});
  private turn = 0;

  constructor(private readonly model: Model) {
    this.root.append(this.status, this.box);
  }

  async show(): Promise<void> {
    const turn = ++this.turn;
    this.status.hidden = false;
    this.status.textContent = say("studio_decide.judging");
    try {
      const { cameras, why } = await ask<{ cameras: Calibrated[]; why: string }>("/api/calibration");
      if (turn !== this.turn) return;
      this.status.hidden = !why;
      this.status.textContent = why;
      this.box.replaceChildren(...cameras.map((c) => this.camera(c)));
    } catch (error) {
      if (turn !== this.turn) return;
      this.status.textContent = (error as Error).message;
      this.box.replaceChildren();
    }
  }

  private camera(c: Calibrated): HTMLElement {
    const v = c.verdict;
    return h("div", { class: "camera" }, h("h3", {}, say("studio_decide.camera", { camera: c.camera })), h("p", { class: "note" }, c.about),
      ...(v ? this.verdict(c, v) : [h("p", { class: "note" }, say("studio_decide.no_verdict"))]),
      h("div", { class: "halves" }, this.parameters(c), ...(v ? [facts(v)] : [])),
      h("div", { class: "figures" }, ...c.figures.map((f) =>
        h("figure", {}, h("img", { src: `/figure/calibration/${f.number}.svg?of=${this.model.overview.times}-${this.turn}`, alt: f.caption, loading: "lazy" }), h("figcaption", {}, f.caption)))));
  }

  private verdict(c: Calibrated, v: Verdict): HTMLElement[] {
    const found: HTMLElement[] = [h("p", { class: `verdict ${LOOKS[v.grade] ?? "attention"}` }, v.headline),
      h("p", { class: "note" }, say("studio_decide.verdict_source", { source: c.verdict_is }))];
    if (v.reasons.length) found.push(h("h4", {}, say("studio_decide.weaknesses")), h("ul", { class: "reasons" }, ...v.reasons.map((r) => h("li", {}, r))));
    const best = v.advice[v.advice.length - 1];
    const now = best?.ratio && best.uncertainty_px ? best.uncertainty_px / best.ratio : v.uncertainty_px;
    if (v.advice.length)
      found.push(h("h4", {}, say("studio_decide.next_photographs")),
        h("table", { class: "figures-of", "aria-label": say("studio_decide.next_photographs_of", { camera: c.camera }) },
          heads(["label.photograph", "studio_decide.uncertainty_then", "studio_decide.smaller_by"]),
          h("tbody", {}, ...v.advice.map((a, k) => h("tr", {}, h("th", { scope: "row" }, `${k + 1}. ${a.photographs}`), h("td", {}, short(a.uncertainty_px, 2)),
            h("td", {}, a.ratio === null || !(a.ratio > 0) ? "–" : `${Math.round(100 * (1 - a.ratio))} %`))))),
        h("p", { class: "note" }, say("studio_decide.next_photographs_note", { now_px: short(now, 2) })));
    else found.push(h("p", { class: "note" }, say("studio_decide.no_next_photographs")));
    return found;
  }

  private parameters(c: Calibrated): HTMLElement {
    return h("div", { class: "wide" }, h("table", { class: "figures-of", "aria-label": say("studio_decide.parameters_of", { name: c.camera }) },
      heads(["label.parameter", "label.value", "label.sigma", "label.unit", "studio_decide.determinability", "label.status"], [3, 5]),
      h("tbody", {}, ...c.parameters.map((p) => h("tr", {},
        h("th", { scope: "row" }, p.symbol, h("small", { class: "note" }, ` ${p.meaning}`)), h("td", {}, p.sigma === null ? short(p.value, 6) : exact(p.value, p.sigma, decimalsOf(p.sigma, 6))), h("td", {}, small(p.sigma)),
        h("td", { class: "l" }, raised(p.unit)), h("td", {}, short(p.determinability, 2)), h("td", { class: `l ${p.status === "not determinable" ? "doubt" : ""}` }, say("studio_decide.status", { status: keyed(p.status) })))))));
  }
}

function facts(v: Verdict): HTMLElement {
  const per = (x: number | null) => (x === null ? "–" : `${Math.round(100 * x)} %`);
  const rows: [code: string, value: string][] = [
    ["studio_decide.largest_uncertainty", `${short(v.uncertainty_px, 2)} px`], ["studio_decide.median_uncertainty", `${short(v.typical_uncertainty_px, 2)} px`],
    ["studio_decide.image_sigma", `${short(v.image_sigma_px, 2)} px`], ["studio_decide.coverage", per(v.coverage)], ["studio_decide.reach", per(v.reach)],
    ["label.photographs", String(v.photographs)], ["studio_decide.quarter_turns", say("label.n_of", { n: v.rolls, of: 4 })], ["studio_decide.convergence", `${short(v.convergence_deg, 2)}°`],
    ["label.cross_validation", v.cross_validation ? say("studio_decide.cross_validation", { rms_px: short(v.cross_validation.rms_px, 2), fit_px: short(v.cross_validation.fit_px, 2) }) : "–"],
  ];
  return h("dl", { class: "facts" }, ...rows.map(([code, value]) => h("div", {}, h("dt", {}, say(code)), h("dd", {}, value))));
}
