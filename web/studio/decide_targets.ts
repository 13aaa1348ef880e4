// Targets: how many each photograph shows and what became of them, those of one photograph, and the sheet to print.
import { ask, send } from "./api";
import type { Ways } from "./leaf";
import { button, h, heads, sign } from "./dom";
import { Model } from "./model";
import { fixed } from "./numbers";
import { OptionFields, Values } from "./option_form";
import { FATES } from "./overlay_targets";
import { targetLayer } from "./target_layer";
import { Fate, OptionForm, TargetsOf } from "./types";
import { say } from "./words";

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
const HEADS = [
  "label.image", "studio_target.found", "studio_target.used", "studio_target.rejected", "studio_target.apart", "studio_target.unidentified",
  "studio_target.median_sigma", "studio_target.source",
];

export class DecideTargets {
  readonly root = h("section", { class: "leaf", "aria-label": say("studio_decide.targets") });
  private readonly family = h("input", { type: "text", id: "targets-family", list: "targets-known", placeholder: say("studio_target.family"), autocomplete: "off", spellcheck: "false" });
  private readonly known = h("datalist", { id: "targets-known" });
  private readonly forms = h("p", { class: "note" });
  private readonly go = button("studio_target.find", () => void this.begin(), "main");
  private readonly status = h("p", { class: "note", role: "status" });
  private readonly body = h("tbody", {});
  private readonly one = h("div", {});
  private readonly sheet = new OptionFields("sheet", () => {});
  private readonly command = h("code", { class: "command" });
  private readonly files = h("span", { class: "links" });

  constructor(private readonly model: Model, private readonly ways: Ways) {
    this.go.id = "targets-begin";
    const print = button("studio_target.make_sheet", () => void this.print(), "main");
    print.id = "sheet-make";
    this.family.addEventListener("change", () => {
      targetLayer.choose(this.family.value.trim());
      void this.show();
    });
    this.root.append(
      h("div", { class: "deeds first" }, h("label", { for: "targets-family" }, say("studio_target.family")), this.family, this.known, this.go),
      this.forms, this.status,
      h("table", { class: "figures-of", "aria-label": say("studio_target.by_photograph"), id: "targets-by-photograph" },
        heads(HEADS, [HEADS.length - 1]), this.body),
      this.one,
      h("h3", {}, say("studio_target.sheet")), h("p", { class: "note" }, say("studio_target.sheet_note")),
      this.sheet.root, h("div", { class: "deeds" }, print, this.files), h("p", {}, this.command));
    targetLayer.onchange(() => this.root.offsetParent && void this.details());
  }

  async show(): Promise<void> {
    const [found, sheet] = await Promise.all([ask<Overview>("/api/targets", targetLayer.query), ask<Sheet>("/api/sheet")]);
    if (document.activeElement !== this.family) this.family.value = found.families;
    this.known.replaceChildren(...found.known.map((k) => h("option", { value: k })));
    this.forms.textContent = say("studio_target.families", { names: found.forms.join("; ") });
    this.go.disabled = !found.families;
    const none = found.images.every((i) => i.found === null);
    this.status.textContent = !found.families ? say("studio_target.family_missing") : none ? say("studio_target.none_stored") : "";
    this.status.hidden = !this.status.textContent;
    this.body.replaceChildren(...found.images.map((i) => this.row(i)));
    this.take(sheet);
    await this.details();
  }

  private row(i: Row): HTMLElement {
    const words = i.why || i.remarks.join("; ");
    return h("tr", {}, h("th", { scope: "row" }, sign(i.image, say("studio_target.show", { image: i.image }), () => this.look(i.image), "link")),
      h("td", {}, i.found === null ? "–" : String(i.found)), ...FATES.map(([fate]) => h("td", {}, i.found === null ? "–" : String(i.fates[fate] ?? 0))),
      h("td", {}, fixed(i.median_s, 3)), h("td", { class: `l ${i.why ? "doubt" : ""}` }, [i.from && say("studio_target.origin", { origin: i.from }), words].filter((w) => w).join("; ") || say("studio_target.not_found")));
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
      h("td", {}, fixed(r.s, 3)), h("td", {}, r.ellipse ? fixed(r.ellipse.a, 2) : "–"), h("td", {}, r.ellipse ? fixed(r.ellipse.b, 2) : "–"), h("td", { class: "l" }, say("studio_target.fate", { fate: r.fate }))));
    this.one.replaceChildren(...(rows.length ? [h("details", {}, h("summary", {}, say("studio_target.of_image", { image, n: t.rows.length })),
      h("table", { class: "figures-of", "aria-label": say("studio_target.of_image", { image, n: t.rows.length }) },
        heads(["label.name", "studio_table.x", "studio_table.y", "studio_target.sigma", "studio_target.semi_axis_a", "studio_target.semi_axis_b", "label.status"], [6]),
        h("tbody", {}, ...rows)))] : []));
  }

  private async begin(): Promise<void> {
    try {
      await send("/api/targets", { families: this.family.value.trim(), images: [] });
      this.model.say("studio_target.finding");
    } catch (error) {
      this.model.fail(error);
    }
  }

  private async print(): Promise<void> {
    try {
      const values: Values = Object.fromEntries(Object.entries(this.sheet.values()).filter(([, v]) => v !== null));
      this.take(await send<Sheet>("/api/sheet", { values }));
      this.model.say("studio_target.sheet_made", {}, "good");
    } catch (error) {
      this.model.fail(error);
    }
  }

  private take(s: Sheet): void {
    this.sheet.fill(s.fields);
    this.command.textContent = s.command;
    this.files.replaceChildren(...s.files.map((name) => h("a", { href: `/sheet/${name}`, download: name }, name)));
  }
}
