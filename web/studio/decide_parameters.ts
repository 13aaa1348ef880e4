// The parameters of each interior orientation with their tests; each is free, held, or as block and options say.
import { ask } from "./api";
import { h } from "./dom";
import { Model } from "./model";
import { decimalsOf, fixed, short } from "./numbers";
import { Choice, Interior, ParameterRow } from "./types";

const CHOICES: Choice[] = ["auto", "free", "held"];
const HEADS: [words: string, title: string][] = [
  ["parameter", "The parameter of the sensor model"], ["next", "In the next adjustments"], ["status", "In the last adjustment"], ["value", "Adjusted value"], ["sigma", "Its standard deviation, a posteriori"], ["unit", "Of both"],
  ["t", "Value over its standard deviation; of an additional parameter, whether it is significant"],
  ["p", "Probability of a larger |t| by chance: small ones are significant"],
  ["effect px", "Largest shift within the format that the parameter causes at its value"],
  ["± px", "The same for one standard deviation"],
  ["correlation", "The largest, with another parameter or with the exterior orientation of an image"],
];

interface Answer {
  interiors: Interior[];
  total: number;
  strong: number;
  significance: number;
}

export class DecideParameters {
  readonly root = h("section", { class: "leaf", "aria-label": "Parameters" });
  private readonly box = h("div", {});

  constructor(private readonly model: Model) {
    this.root.append(
      h("p", { class: "note" }, "auto: as the block and the options say; free and held go before both. A choice is an action: it stands in the journal and can be taken back. It holds from the next adjustment on."),
      this.box);
  }

  async show(): Promise<void> {
    const found = await ask<Answer>("/api/parameters");
    const focus = (document.activeElement as HTMLElement | null)?.id ?? "";
    const rest = found.total > found.interiors.length ? [h("p", { class: "note" }, `${found.interiors.length} of ${found.total} interior orientations are shown.`)] : [];
    this.box.replaceChildren(...found.interiors.map((i) => this.table(i, found)), ...rest);
    if (focus.startsWith("choice-")) document.getElementById(focus)?.focus();
  }

  private table(interior: Interior, answer: Answer): HTMLElement {
    const name = interior.image === null ? `Camera ${interior.camera}` : `Camera ${interior.camera}, image ${interior.image}`;
    const tests = interior.tests.map((t) => h("li", {}, `${t.group}: F ${short(t.F)}, p ${chance(t.probability)}`));
    return h("div", { class: "card" }, h("h3", {}, name),
      h("table", { class: "parameters", "aria-label": `Parameters of ${name}` },
        h("thead", {}, h("tr", {}, ...HEADS.map(([words, title]) => h("th", { scope: "col", title }, words)))),
        h("tbody", {}, ...interior.parameters.map((p) => this.row(interior, p, answer)))),
      ...(tests.length ? [h("p", { class: "note" }, "Groups tested together"), h("ul", { class: "tests" }, ...tests)] : []));
  }

  private row(interior: Interior, p: ParameterRow, { strong, significance }: Answer): HTMLElement {
    const decimals = decimalsOf(p.sigma, 6);
    const r = p.correlation;
    const told = r ? `${r.value.toFixed(2)} ${r.with === "exterior orientation" ? "exterior" : r.with}` : "–";
    const weak = p.probability !== null && p.probability > significance;
    const flag = r?.strong ? h("span", { class: "flag", title: `Beyond ${strong}: the two can hardly be told apart` }, "⚠ ") : "";
    return h("tr", {},
      h("th", { scope: "row", title: p.meaning }, p.symbol), h("td", { class: "l" }, this.choice(interior, p)),
      h("td", { class: `l ${p.status === "not determinable" ? "doubt" : ""}`, title: p.remark }, p.status), h("td", {}, p.sigma === null ? short(p.value, 6) : exact(p.value, p.sigma, decimals)), h("td", {}, small(p.sigma)),
      h("td", { class: "l" }, raised(p.unit)), h("td", {}, short(p.t)), h("td", { class: weak ? "doubt" : "" }, chance(p.probability)),
      h("td", {}, short(p.effect_px)), h("td", {}, short(p.effect_sigma_px, 2)), h("td", { class: "l", title: r ? `with ${r.with}` : "" }, flag, told));
  }

  private choice(interior: Interior, p: ParameterRow): HTMLElement {
    const id = `choice-${interior.camera}-${interior.image ?? ""}-${p.symbol}`;
    const select = h("select", { id, "aria-label": `${p.symbol} of camera ${interior.camera} in the next adjustments`, class: p.choice === "auto" ? "" : "chosen" },
      ...CHOICES.map((c) => h("option", { value: c, selected: c === p.choice }, c)));
    select.addEventListener("change", () => void this.model.act("parameter", { camera: interior.camera, symbol: p.symbol, choice: select.value },
      `${p.symbol} of ${interior.camera}: ${select.value} from the next adjustment on`));
    return select;
  }
}

/** Standard deviations below this are written with an exponent. */
const SMALL = 1e-4;

export const small = (sigma: number | null): string => (sigma !== null && sigma > 0 && sigma < SMALL ? sigma.toExponential(1) : short(sigma, 2));

/** mm^-2 as it is printed. */
export const raised = (unit: string): string => unit.replace(/\^(-?\d)/, (_, power: string) => [...power].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)])).join(""));

/** A value with the decimals that its standard deviation lets it have; very small ones with an exponent. */
export function exact(value: number | null, sigma: number, decimals: number): string {
  if (value === null) return "–";
  if (sigma > 0 && sigma < SMALL) return value.toExponential(Math.min(Math.max(Math.floor(Math.log10(Math.abs(value) / sigma)) + 1, 1), 8));
  return fixed(value, decimals);
}

const chance = (p: number | null): string => (p === null ? "–" : p < 1e-4 ? "< 0.0001" : p.toFixed(p < 0.01 ? 4 : 2));
