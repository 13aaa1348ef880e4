// What the calibration of each camera is worth, what to photograph next, its parameters and figures.
import { ask } from "./api";
import { exact, raised, small } from "./decide_parameters";
import { h } from "./dom";
import { Model } from "./model";
import { decimalsOf, short } from "./numbers";

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
  readonly root = h("section", { class: "leaf", tabindex: 0, "aria-label": "Calibration" });
  private readonly told = h("p", { class: "note", role: "status" });
  private readonly box = h("div", {});
  private turn = 0;

  constructor(private readonly model: Model) {
    this.root.append(this.told, this.box);
  }

  async show(): Promise<void> {
    const turn = ++this.turn;
    this.told.hidden = false;
    this.told.textContent = "Judging the calibration …";
    try {
      const { cameras, why } = await ask<{ cameras: Calibrated[]; why: string }>("/api/calibration");
      if (turn !== this.turn) return;
      this.told.hidden = !why;
      this.told.textContent = why;
      this.box.replaceChildren(...cameras.map((c) => this.camera(c)));
    } catch (error) {
      if (turn !== this.turn) return;
      this.told.textContent = (error as Error).message;
      this.box.replaceChildren();
    }
  }

  private camera(c: Calibrated): HTMLElement {
    const v = c.verdict;
    return h("div", { class: "camera" }, h("h3", {}, `Camera ${c.camera}`), h("p", { class: "note" }, c.about),
      ...(v ? this.verdict(c, v) : [h("p", { class: "note" }, "Nothing of it was estimated: there is no verdict.")]),
      h("div", { class: "halves" }, this.parameters(c), ...(v ? [facts(v)] : [])),
      h("div", { class: "figures" }, ...c.figures.map((f) =>
        h("figure", {}, h("img", { src: `/figure/calibration/${f.number}.svg?of=${this.model.overview.times}-${this.turn}`, alt: f.caption, loading: "lazy" }), h("figcaption", {}, f.caption)))));
  }

  private verdict(c: Calibrated, v: Verdict): HTMLElement[] {
    const how = c.verdict_is === "stored" ? "As `raybundle calibrate` judged it, cross-validated." : "Judged from the last adjustment here, without cross-validation: `raybundle calibrate` adds it.";
    const found: HTMLElement[] = [h("p", { class: `verdict ${LOOKS[v.grade] ?? "attention"}` }, v.headline), h("p", { class: "note" }, how)];
    if (v.reasons.length) found.push(h("h4", {}, "What speaks against it"), h("ul", { class: "reasons" }, ...v.reasons.map((r) => h("li", {}, r))));
    const best = v.advice[0];
    const now = best?.ratio && best.uncertainty_px ? best.uncertainty_px / best.ratio : v.uncertainty_px;
    if (v.advice.length)
      found.push(h("h4", {}, "What to photograph next"),
        h("table", { class: "figures-of", "aria-label": `What to photograph next with camera ${c.camera}` },
          h("thead", {}, h("tr", {}, ...["photographs", "uncertainty then px", "smaller by"].map((w) => h("th", { scope: "col" }, w)))),
          h("tbody", {}, ...v.advice.map((a) => h("tr", {}, h("th", { scope: "row" }, a.photographs), h("td", {}, short(a.uncertainty_px, 2)),
            h("td", {}, a.ratio === null || !(a.ratio > 0) ? "–" : `${Math.round(100 * (1 - a.ratio))} %`))))),
        h("p", { class: "note" }, `The largest uncertainty of projection over the format, now ${short(now, 2)} px, if these are added with the precision of the others. Add the first set, run again, look again.`));
    else found.push(h("p", { class: "note" }, "No four further photographs would improve it by a tenth."));
    return found;
  }

  private parameters(c: Calibrated): HTMLElement {
    const heads = ["parameter", "value", "sigma", "unit", "determinability", "status"];
    return h("div", { class: "wide" }, h("table", { class: "figures-of", "aria-label": `Parameters of camera ${c.camera} with sigma` },
      h("thead", {}, h("tr", {}, ...heads.map((w) => h("th", { scope: "col", class: ["unit", "status"].includes(w) ? "l" : "" }, w)))),
      h("tbody", {}, ...c.parameters.map((p) => h("tr", {},
        h("th", { scope: "row" }, p.symbol, h("small", { class: "note" }, ` ${p.meaning}`)), h("td", {}, p.sigma === null ? short(p.value, 6) : exact(p.value, p.sigma, decimalsOf(p.sigma, 6))), h("td", {}, small(p.sigma)),
        h("td", { class: "l" }, raised(p.unit)), h("td", {}, short(p.determinability, 2)), h("td", { class: `l ${p.status === "not determinable" ? "doubt" : ""}` }, p.status))))));
  }
}

function facts(v: Verdict): HTMLElement {
  const per = (x: number | null) => (x === null ? "–" : `${Math.round(100 * x)} %`);
  const rows: [string, string][] = [
    ["largest uncertainty of projection", `${short(v.uncertainty_px, 2)} px`], ["its median over the format", `${short(v.typical_uncertainty_px, 2)} px`],
    ["image points", `${short(v.image_sigma_px, 2)} px`], ["format covered", per(v.coverage)], ["reached of the way to the corners", per(v.reach)],
    ["photographs", String(v.photographs)], ["quarter turns about the axis", `${v.rolls} of 4`], ["axes within", `${short(v.convergence_deg, 2)}° of their mean`],
    ["cross-validation", v.cross_validation ? `${short(v.cross_validation.rms_px, 2)} px left out, ${short(v.cross_validation.fit_px, 2)} px in the fit` : "–"],
  ];
  return h("dl", { class: "facts" }, ...rows.map(([words, what]) => h("div", {}, h("dt", {}, words), h("dd", {}, what))));
}
