// Targets: how many each photograph shows and what became of them, those of one photograph, and the sheet to print.
import { ask, tell } from "./api";
import type { Ways } from "./leaf";
import { button, h } from "./dom";
import { Model } from "./model";
import { fixed } from "./numbers";
import { OptionFields, Values } from "./option_form";
import { FATES } from "./overlay_targets";
import { targetLayer } from "./target_layer";
import { Fate, OptionForm, TargetsOf } from "./types";

interface Row {
  image: string;
  from: string;
  found: number | null;
  fates: Partial<Record<Fate, number>>;
  median_s: number | null;
  why: string;
  remarks: string[];
}

interface Overview {
  families: string;
  known: string[];
  forms: string[];
  images: Row[];
}

type Sheet = OptionForm & { files: string[] };
const HEADS = ["image", "found", ...FATES.map(([fate]) => fate), "median sigma px", "where from"];

export class DecideTargets {
  readonly root = h("section", { class: "leaf", "aria-label": "Targets" });
  private readonly family = h("input", { type: "text", id: "targets-family", list: "targets-known", placeholder: "FAMILY", autocomplete: "off", spellcheck: "false" });
  private readonly known = h("datalist", { id: "targets-known" });
  private readonly forms = h("p", { class: "note" });
  private readonly go = button("Find in all photographs", "Find the targets in the background; Stop in the line below ends it", () => void this.begin(), "main");
  private readonly told = h("p", { class: "note", role: "status" });
  private readonly body = h("tbody", {});
  private readonly one = h("div", {});
  private readonly sheet = new OptionFields("sheet", () => {});
  private readonly command = h("code", { class: "command" });
  private readonly files = h("span", { class: "links" });

  constructor(private readonly model: Model, private readonly ways: Ways) {
    this.go.id = "targets-begin";
    const print = button("Make the sheet", "A PDF at true size with a scale bar, and a TOML file with what is printed where", () => void this.print(), "main");
    print.id = "sheet-make";
    this.family.addEventListener("change", () => {
      targetLayer.choose(this.family.value.trim());
      void this.show();
    });
    this.root.append(
      h("div", { class: "deeds first" }, h("label", { for: "targets-family" }, "family"), this.family, this.known, this.go),
      this.forms, this.told,
      h("table", { class: "figures-of", "aria-label": "Targets by photograph" },
        h("thead", {}, h("tr", {}, ...HEADS.map((words, k) => h("th", { scope: "col", class: k === HEADS.length - 1 ? "l" : "" }, words)))), this.body),
      this.one,
      h("h3", {}, "A sheet to print"), h("p", { class: "note" }, "Print without scaling, and measure the scale bar on the paper. The TOML file goes with it: `raybundle calibrate --sheet` reads it."),
      this.sheet.root, h("div", { class: "deeds" }, print, this.files), h("p", {}, this.command));
    targetLayer.onchange(() => this.root.offsetParent && void this.details());
  }

  async show(): Promise<void> {
    const [found, sheet] = await Promise.all([ask<Overview>("/api/targets", targetLayer.query), ask<Sheet>("/api/sheet")]);
    if (document.activeElement !== this.family) this.family.value = found.families;
    this.known.replaceChildren(...found.known.map((k) => h("option", { value: k })));
    this.forms.textContent = `Known: ${found.forms.join("; ")}.`;
    this.go.disabled = !found.families;
    const none = found.images.every((i) => i.found === null);
    this.told.textContent = !found.families ? "Name the family that was photographed." : none ? "Nothing is kept of these targets; they are found in a photograph as soon as it is shown with them, or in all of them by the button." : "";
    this.told.hidden = !this.told.textContent;
    this.body.replaceChildren(...found.images.map((i) => this.row(i)));
    this.take(sheet);
    await this.details();
  }

  private row(i: Row): HTMLElement {
    const words = i.why || i.remarks.join("; ");
    return h("tr", {}, h("th", { scope: "row" }, button(i.image, `Show ${i.image} with its targets`, () => this.look(i.image), "link")),
      h("td", {}, i.found === null ? "–" : String(i.found)), ...FATES.map(([fate]) => h("td", {}, i.found === null ? "–" : String(i.fates[fate] ?? 0))),
      h("td", {}, fixed(i.median_s, 3)), h("td", { class: `l ${i.why ? "doubt" : ""}` }, [i.from, words].filter((w) => w).join("; ") || "not found yet"));
  }

  private look(image: string): void {
    targetLayer.switch(true);
    this.ways.images(image);
  }

  /** The targets of the photograph in front. */
  private async details(): Promise<void> {
    const image = this.model.panes[this.model.active];
    if (!image) return;
    const t = await ask<TargetsOf>("/api/targets/image", { image, ...targetLayer.query });
    const rows = t.rows.slice(0, 500).map((r) => h("tr", {}, h("th", { scope: "row" }, r.name || "–"), h("td", {}, fixed(r.x, 2)), h("td", {}, fixed(r.y, 2)),
      h("td", {}, fixed(r.s, 3)), h("td", {}, r.ellipse ? fixed(r.ellipse.a, 2) : "–"), h("td", {}, r.ellipse ? fixed(r.ellipse.b, 2) : "–"), h("td", { class: "l" }, r.fate)));
    this.one.replaceChildren(...(rows.length ? [h("details", {}, h("summary", {}, `Targets of ${image}: ${t.rows.length}`),
      h("table", { class: "figures-of", "aria-label": `Targets of ${image}` },
        h("thead", {}, h("tr", {}, ...["name", "x px", "y px", "sigma px", "semi-axis a px", "b px", "what became of it"].map((w, k) => h("th", { scope: "col", class: k === 6 ? "l" : "" }, w)))),
        h("tbody", {}, ...rows)))] : []));
  }

  private async begin(): Promise<void> {
    try {
      await tell("/api/targets", { families: this.family.value.trim(), images: [] });
      this.model.say("Finding targets.");
    } catch (error) {
      this.model.say((error as Error).message, "bad");
    }
  }

  private async print(): Promise<void> {
    try {
      const values: Values = Object.fromEntries(Object.entries(this.sheet.values()).filter(([, v]) => v !== null));
      this.take(await tell<Sheet>("/api/sheet", { values }));
      this.model.say("The sheet is made.", "good");
    } catch (error) {
      this.model.say((error as Error).message, "bad");
    }
  }

  private take(s: Sheet): void {
    this.sheet.fill(s.fields);
    this.command.textContent = s.command;
    this.files.replaceChildren(...s.files.map((name) => h("a", { href: `/sheet/${name}`, download: name }, name)));
  }
}
