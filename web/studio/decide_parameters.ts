// The parameters of each interior orientation with their tests; each is free, held, or as block and options say.
import { ask } from "./api";
import { choices, heads, h } from "./dom";
import { Model } from "./model";
import { decimalsOf, fixed, local, short } from "./numbers";
import { Choice, Interior, ParameterRow } from "./types";
import { keyed, say } from "./words";

const CHOICES: Choice[] = ["auto", "free", "held"];
const HEADS = [
  "label.parameter", "studio_decide.next", "studio_decide.last_status", "label.value", "studio_decide.sigma", "label.unit", "studio_decide.t",
  "studio_decide.p", "studio_decide.effect", "studio_decide.effect_sigma", "studio_decide.correlation",
];

interface Answer {
  interiors: Interior[];
  total: number;
  strong: number;
  significance: number;
}

export class DecideParameters {
  readonly root = h("section", { class: "leaf", "aria-label": say("studio_decide.parameters") });
  private readonly box = h("div", {});

  constructor(private readonly model: Model) {
    this.root.append(
      h("p", { class: "note" }, say("studio_decide.parameters_note")),
      this.box);
  }

  async show(): Promise<void> {
    const found = await ask<Answer>("/api/parameters");
    const focus = (document.activeElement as HTMLElement | null)?.id ?? "";
    const rest = found.total > found.interiors.length ? [h("p", { class: "note" }, say("studio_decide.interiors_shown", { n: found.interiors.length, of: found.total }))] : [];
    this.box.replaceChildren(...found.interiors.map((i) => this.table(i, found)), ...rest);
    if (focus.startsWith("choice-")) document.getElementById(focus)?.focus();
  }

  private table(interior: Interior, answer: Answer): HTMLElement {
    const name = interior.image === null ? say("studio_decide.camera", { camera: interior.camera }) : say("studio_decide.camera_image", { camera: interior.camera, image: interior.image });
    const tests = interior.tests.map((t) => h("li", {}, say("studio_decide.joint_test", { group: t.group, F: short(t.F), p: chance(t.probability) })));
    return h("div", { class: "card" }, h("h3", {}, name),
      h("table", { class: "parameters", "aria-label": say("studio_decide.parameters_of", { name }) }, heads(HEADS),
        h("tbody", {}, ...interior.parameters.map((p) => this.row(interior, p, answer)))),
      ...(tests.length ? [h("p", { class: "note" }, say("studio_decide.joint_tests")), h("ul", { class: "tests" }, ...tests)] : []));
  }

  private row(interior: Interior, p: ParameterRow, { strong, significance }: Answer): HTMLElement {
    const decimals = decimalsOf(p.sigma, 6);
    const r = p.correlation;
    const other = r?.with || say("studio_decide.exterior");
    const correlation = r ? `${fixed(r.value, 2)} ${other}` : "–";
    const weak = p.probability !== null && p.probability > significance;
    const flag = r?.strong ? h("span", { class: "flag", title: say("studio_decide.strong", { strong }) }, "⚠ ") : "";
    return h("tr", {},
      h("th", { scope: "row", title: p.meaning }, p.symbol), h("td", { class: "l" }, this.choice(interior, p)),
      h("td", { class: `l ${p.status === "not determinable" ? "doubt" : ""}`, title: p.remark }, say("studio_decide.status", { status: keyed(p.status) })), h("td", {}, p.sigma === null ? short(p.value, 6) : exact(p.value, p.sigma, decimals)), h("td", {}, small(p.sigma)),
      h("td", { class: "l" }, raised(p.unit)), h("td", {}, short(p.t)), h("td", { class: weak ? "doubt" : "" }, chance(p.probability)),
      h("td", {}, short(p.effect_px)), h("td", {}, short(p.effect_sigma_px, 2)), h("td", { class: "l", title: r ? say("studio_decide.correlated", { other }) : "" }, flag, correlation));
  }

  private choice(interior: Interior, p: ParameterRow): HTMLElement {
    const id = `choice-${interior.camera}-${interior.image ?? ""}-${p.symbol}`;
    const select = h("select", { id, "aria-label": say("studio_decide.choice_of", { symbol: p.symbol, camera: interior.camera }), class: p.choice === "auto" ? "" : "chosen" },
      ...choices(CHOICES, (choice) => say("studio_decide.choice", { choice }), p.choice));
    select.addEventListener("change", () => void this.model.act("parameter", { camera: interior.camera, symbol: p.symbol, choice: select.value },
      "studio_decide.choice_stored", { symbol: p.symbol, camera: interior.camera, choice: select.value }));
    return select;
  }
}

/** Standard deviations below this are written with an exponent. */
const SMALL = 1e-4;

export const small = (sigma: number | null): string => (sigma !== null && sigma > 0 && sigma < SMALL ? local(sigma.toExponential(1)) : short(sigma, 2));

/** mm^-2 as it is printed. */
export const raised = (unit: string): string => unit.replace(/\^(-?\d)/, (_, power: string) => [...power].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)])).join(""));

/** A value with the decimals that its standard deviation lets it have; very small ones with an exponent. */
export function exact(value: number | null, sigma: number, decimals: number): string {
  if (value === null) return "–";
  if (sigma > 0 && sigma < SMALL) return local(value.toExponential(Math.min(Math.max(Math.floor(Math.log10(Math.abs(value) / sigma)) + 1, 1), 8)));
  return fixed(value, decimals);
}

const chance = (p: number | null): string => (p === null ? "–" : p < 1e-4 ? `< ${local("0.0001")}` : fixed(p, p < 0.01 ? 4 : 2));
