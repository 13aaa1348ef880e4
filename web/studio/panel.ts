// The measuring panel: the current point, its marks, where else it may be measured.
import { ask } from "./api";
import { Choice } from "./choice";
import { afterPause, button, choices, element, h, heads, sign, whenSeen } from "./dom";
import { looks, SNAPS } from "./looks";
import { Measuring } from "./measuring";
import { Model } from "./model";
import { decimalsOf, fixed, short } from "./numbers";
import { Mark, Page, PointRow, Predictions, SnapKind } from "./types";
import { say } from "./words";

export interface Going {
  /** Show a place of an image. */
  visit(image: string, x: number, y: number): void;
}

type Visible = Predictions["visible"][number];

export class Panel {
  private readonly name = h("input", {
    id: "point-name", type: "text", "aria-label": say("studio_point.current_name"), placeholder: say("studio_point.current_none"),
    autocomplete: "off", spellcheck: "false", list: "point-names", maxlength: 200,
  });
  private readonly names = h("datalist", { id: "point-names" });
  private readonly where = h("table", { class: "where", "aria-label": say("studio_point.coordinates") });
  private readonly about = h("p", { class: "note", "aria-live": "polite" });
  private readonly marks = h("table", { class: "marks", "aria-label": say("studio_point.marks") });
  private readonly visible: Choice<Visible>;
  private readonly visibleHead = h("h3", {});
  private readonly points: Choice<PointRow>;
  private readonly search = h("input", { type: "search", id: "point-search", "aria-label": say("studio_point.filter"), placeholder: say("studio_point.filter"), autocomplete: "off", spellcheck: "false" });
  private readonly pointsHead = h("summary", {}, say("studio_point.points"));
  private readonly snap = h("select", { id: "snap" }, ...choices(SNAPS, (how) => say("studio_point.how", { how })));
  private visited = -1;

  constructor(private readonly model: Model, private readonly measuring: Measuring, private readonly going: Going) {
    this.visible = new Choice<Visible>(say("studio_point.visible_images"), (v) => v.image,
      (v) => [h("b", {}, v.image), h("small", { title: say("studio_point.angle") }, `${v.angle_deg.toFixed(0)}°`)],
      (v) => going.visit(v.image, v.x, v.y));
    this.points = new Choice<PointRow>(say("studio_point.points"), (p) => p.point, (p) => this.pointRow(p), (p) => model.choose(p.point));
    element("right").append(this.current(), this.list());
    this.name.addEventListener("change", () => this.chooseNamed());
    this.name.addEventListener("input", afterPause(() => void this.suggest(), 150));
    this.search.addEventListener("input", afterPause(() => void this.showPoints(), 150));
    this.snap.addEventListener("change", () => (looks.snap = this.snap.value as SnapKind));
    model.on("current", () => {
      this.visited = -1;
      this.name.value = model.current;
      this.points.select(model.current);
    });
    model.on(["current", "prediction", "state"], () => this.show());
    const later = afterPause(whenSeen(() => void this.showPoints()), 60);
    model.on(["state", "read"], later);
  }

  private current(): HTMLElement {
    return h("section", { class: "card", "aria-label": say("studio_point.current") },
      h("h2", {}, say("studio_point.current")),
      h("div", { class: "row" }, this.name, this.names, button("studio_point.new", () => void this.measuring.newPoint(), "main")),
      h("div", { class: "row" }, h("label", {}, say("studio_point.snap"), this.snap),
        button("studio_point.worst_next", () => void this.worst())),
      this.where, this.about, this.marks, this.visibleHead, this.visible.root);
  }

  private list(): HTMLElement {
    return h("details", { class: "card", open: true }, this.pointsHead, h("div", { class: "row" }, this.search), this.points.root);
  }

  private chooseNamed(): void {
    this.model.choose(this.name.value.trim());
    this.name.blur();
  }

  private async suggest(): Promise<void> {
    const found = await ask<Page<PointRow>>("/api/points", { search: this.name.value.trim(), limit: 12 });
    this.names.replaceChildren(...found.rows.map((row) => h("option", { value: row.point })));
  }

  typeName(): void {
    this.name.focus();
    this.name.select();
  }

  nextSnap(): void {
    looks.snap = SNAPS[(SNAPS.indexOf(looks.snap) + 1) % SNAPS.length];
    this.snap.value = looks.snap;
    this.model.say("studio_point.snapping", { how: looks.snap });
  }

  /** The next image in which the current point is visible and not measured. */
  visitNext(): void {
    const there = this.model.prediction?.visible ?? [];
    if (!there.length) return this.model.say("studio_point.none_visible");
    this.visited = (this.visited + 1) % there.length;
    const { image, x, y } = there[this.visited];
    this.visible.select(image);
    this.going.visit(image, x, y);
  }

  async worst(): Promise<void> {
    const found = await this.measuring.worstNext();
    if (!found) return;
    this.model.choose(found.point);
    await this.goTo(found.point, found.image);
  }

  /** Show a point in an image; in the first one in which it is measured where none is named. */
  async goTo(point: string, image = ""): Promise<void> {
    const mark = this.model.marksOf(point).find((m) => !image || m.image === image);
    if (mark) return this.going.visit(mark.image, mark.x, mark.y);
    const seen = image ? [image] : [...this.model.images.keys()].slice(0, 400);
    for (const id of seen) {
      const o = await this.model.observations(id);
      const i = o.point.indexOf(point);
      if (i >= 0) return this.going.visit(id, o.x[i], o.y[i]);
    }
    const there = this.model.prediction?.visible[0];
    if (there) this.going.visit(there.image, there.x, there.y);
  }

  // --- what is shown ------------------------------------------------------------------------------

  private show(): void {
    const { model } = this;
    const p = model.prediction?.point === model.current ? model.prediction : null;
    const { unit } = model.overview;
    this.where.replaceChildren();
    if (p?.located.xyz) {
      const s = p.located.sigma;
      const head = h("tr", {}, h("td"), h("th", { scope: "col" }, unit || say("studio_point.no_unit")), h("th", { scope: "col" }, say("label.sigma")));
      this.where.append(head, ...["X", "Y", "Z"].map((axis, k) => h("tr", {}, h("th", { scope: "row" }, axis),
        h("td", {}, fixed(p.located.xyz![k], decimalsOf(s?.[k]))), h("td", { class: "sigma" }, s ? fixed(s[k], decimalsOf(s[k])) : "–"))));
    }
    this.about.textContent = this.words(p);
    this.showMarks(p);
    const there = p?.visible ?? [];
    this.visibleHead.hidden = this.visible.root.hidden = !there.length;
    this.visibleHead.textContent = say("studio_point.visible", { n: there.length });
    this.visible.set(there);
  }

  private words(p: Predictions | null): string {
    const { model } = this;
    if (!model.current) return say("studio_point.choose_or_begin");
    if (!p) return "";
    const { source, rays, neglected } = p.located;
    return [say("studio_point.located", { source, n: rays }), neglected].join(" ");
  }

  private showMarks(p: Predictions | null): void {
    const { model } = this;
    const marks = model.marksOf(model.current);
    this.marks.hidden = !marks.length;
    this.marks.replaceChildren(heads(["label.image", "studio_point.by", "studio_point.sigma_px", "studio_point.vx", "studio_point.vy", ""]), ...marks.map((m) => {
      const v = p?.located.residuals[m.image];
      const show = sign(m.image, say("studio_point.show", { point: m.image }), () => this.going.visit(m.image, m.x, m.y), "link");
      const remove = sign("✕", say("studio_point.remove", { name: m.image }), () => void model.act("remove", { image: m.image, point: m.point }, "studio_point.mark_removed", { point: m.point }), "small");
      const s = Math.sqrt(Math.max(m.cov[0], m.cov[1]));
      return h("tr", {}, h("td", {}, show), h("td", {}, say("studio_point.how", { how: m.how })), h("td", {}, short(s, 2)),
        ...this.residual(m, v), h("td", {}, remove));
    }));
  }

  /** Of a mark that took part just now, or in the adjustment. */
  private residual(mark: Mark, now: [number, number] | undefined): HTMLElement[] {
    const cells = [0, 1].map((k) => h("td", {}, fixed(now?.[k], 2)));
    if (!now)
      void this.model.observations(mark.image).then((o) => {
        const i = o.point.indexOf(mark.point);
        const same = i >= 0 && Math.hypot(o.x[i] - mark.x, o.y[i] - mark.y) < 1e-3;
        if (same) [cells[0].textContent, cells[1].textContent] = [fixed(o.vx[i], 2), fixed(o.vy[i], 2)];
      }, () => {});
    return cells;
  }

  private pointRow(p: PointRow): Node[] {
    const marks = this.model.marksOf(p.point).length;
    const sigma = Math.max(...p.sigma.map((s) => s ?? -1));
    const parts = [
      p.role === "tie" ? "" : say("studio_point.role", { role: p.role }), marks ? say("studio_point.mark_count", { n: marks }) : "",
      p.rays ? say("studio_photo.rays", { n: p.rays }) : "", sigma >= 0 ? `s ${short(sigma, 2)}` : "",
    ];
    return [h("b", {}, p.point), h("small", {}, parts.filter((t) => t).join(" · "))];
  }

  private async showPoints(): Promise<void> {
    const { model } = this;
    const part = this.search.value.trim();
    const found = await ask<Page<PointRow>>("/api/points", { search: part, limit: 60 });
    const ofBlock = new Map(found.rows.map((row) => [row.point, row]));
    const measured = model.state.points.filter((p) => p.point.toLowerCase().includes(part.toLowerCase())).map((p): PointRow => {
      const known = ofBlock.get(p.point);
      return { ...(known ?? { rays: 0, w: null, xyz: p.xyz, sigma: [null, null, null] }), point: p.point, role: p.role };
    });
    const names = new Set(measured.map((p) => p.point));
    this.points.set([...measured, ...found.rows.filter((row) => !names.has(row.point))], model.current);
    this.pointsHead.textContent = say("studio_point.points_of", { n: model.state.points.length, of: model.overview.points });
  }
}
