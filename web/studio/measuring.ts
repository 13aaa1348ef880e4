// Measuring: marks are placed where the picture has a feature, moved, taken away; each is an action of the journal.
import { ask, Refused, send } from "./api";
import { looks } from "./looks";
import { Model } from "./model";
import { short } from "./numbers";
import { say, Values } from "./words";
import { Covariance, How, Page, PointRow, Snapped, Worst } from "./types";

const HAND_PX = 0.5;
const REST_MS = 450;

interface Place {
  x_px: number;
  y_px: number;
  covariance: Covariance;
  how: How;
  clicked: [number, number] | null;
  quality: number | null;
}

const byHand = (x: number, y: number, clicked: [number, number] | null): Place => ({
  x_px: x, y_px: y, covariance: [HAND_PX ** 2, HAND_PX ** 2, 0], how: "hand", clicked, quality: null,
});

/** From which on the line below shows how far a mark was brought from the click: a hand is as fine as this. */
const FAR_PX = 2;

/** A hand's miss on the screen [CSS px]. */
const MISSED_PX = 6;
/** Fineness of a picture's places, and as far as the server looks [px]. */
const [LEAST_REACH_PX, MOST_REACH_PX] = [2, 12];

/** How far a click is moved at most [px]: no farther than a hand misses on the screen, and within what is looked at. */
const reachAt = (scale: number): number => Math.min(Math.max(MISSED_PX / scale, LEAST_REACH_PX), MOST_REACH_PX);

/** Code and values of what was done with a mark. */
function report(code: string, point: string, place: Place, why: string): [string, Values] {
  const s = Math.sqrt(Math.max(place.covariance[0], place.covariance[1]));
  const far = place.clicked ? Math.hypot(place.x_px - place.clicked[0], place.y_px - place.clicked[1]) : 0;
  return [code, { point, how: place.how, sigma_px: short(s, 2), cause: why || "none", far_px: why || far < FAR_PX ? 0 : far }];
}

export class Measuring {
  /** Marks that are being moved, where they are now: image and point -> place. */
  readonly moving = new Map<string, [number, number]>();
  private resting = 0;
  private worstOnes: Worst[] = [];
  private worstAt = -1;

  constructor(private readonly model: Model) {
    model.on("read", () => (this.worstAt = -1));
  }

  static key(image: string, point: string): string {
    return `${image}\n${point}`;
  }

  /** Mark the current point where somebody clicked, at a scale of the picture [CSS px per px]. */
  async place(image: string, x: number, y: number, scale: number): Promise<void> {
    const { model } = this;
    if (model.fiducial) return this.placeFiducial(image, x, y, scale);
    const point = model.current;
    if (!point) return model.say("studio_point.none_chosen", {}, "bad");
    if (model.mark(image, point)) return model.say("studio_point.marked_before", { point }, "bad");
    const [place, why] = await this.snapped(image, point, x, y, scale);
    await model.act("put", { image, point, ...place }, ...report("studio_point.marked", point, place, why));
  }

  /** The fiducial mark that is being measured is there; the next one that is not measured is next. */
  private async placeFiducial(image: string, x: number, y: number, scale: number): Promise<void> {
    const { model } = this;
    const name = model.fiducial;
    const [place, why] = await this.snapped(image, "", x, y, scale);
    const done = await model.act("fiducial", { image, name, ...place }, ...report("studio_point.marked", name, place, why));
    if (!done) return;
    const there = new Set(model.fiducialsIn(image).map((f) => f.name));
    const names = model.overview.fiducials;
    const after = [...names.slice(names.indexOf(name)), ...names].find((n) => !there.has(n)) ?? "";
    model.chooseFiducial(after);
  }

  /** Bring the mark of a point to another place, snapped as a click is. */
  async move(image: string, point: string, x: number, y: number, scale: number): Promise<void> {
    const [place, why] = await this.snapped(image, point, x, y, scale);
    await this.model.act("move", { image, point, ...place }, ...report("studio_point.moved", point, place, why));
    this.moving.delete(Measuring.key(image, point));
    this.model.emit("looks");
  }

  private async snapped(image: string, point: string, x: number, y: number, scale: number): Promise<[Place, string]> {
    if (looks.snap === "hand") return [byHand(x, y, [x, y]), ""];
    try {
      const found = await send<Snapped>("/api/snap", { image, x, y, kind: looks.snap, point, reach: reachAt(scale) });
      if ("why" in found) return [byHand(x, y, [x, y]), found.why];
      const { cov, how, quality } = found;
      return [{ x_px: found.x, y_px: found.y, covariance: cov, how, clicked: [x, y], quality }, ""];
    } catch (error) {
      // what cannot be looked at is marked by hand: nothing that was clicked is lost
      return [byHand(x, y, [x, y]), error instanceof Refused ? error.message : say("studio_page.no_answer")];
    }
  }

  /** Move a mark a little; one action for all steps that follow each other. */
  nudge(image: string, dx: number, dy: number): void {
    const { model } = this;
    const mark = model.mark(image, model.current);
    if (!mark) return model.say("studio_point.not_marked", {}, "bad");
    const key = Measuring.key(image, mark.point);
    const [x, y] = this.moving.get(key) ?? [mark.x, mark.y];
    this.moving.set(key, [x + dx, y + dy]);
    model.emit("looks");
    clearTimeout(this.resting);
    this.resting = window.setTimeout(() => void this.rest(image, mark.point, mark.clicked), REST_MS);
  }

  private async rest(image: string, point: string, clicked: [number, number] | null): Promise<void> {
    const key = Measuring.key(image, point);
    const at = this.moving.get(key);
    if (!at) return;
    await this.model.act("move", { image, point, ...byHand(at[0], at[1], clicked) }, ...report("studio_point.moved", point, byHand(at[0], at[1], null), ""));
    this.moving.delete(key);
    this.model.emit("looks");
  }

  async remove(image: string): Promise<void> {
    const point = this.model.current;
    if (!this.model.mark(image, point)) return this.model.say("studio_point.not_marked", {}, "bad");
    await this.model.act("remove", { image, point }, "studio_point.mark_removed", { point });
  }

  /** Reject an image observation of the block, or accept it again. */
  async reject(image: string, point: string): Promise<void> {
    const back = this.model.isRejected(image, point);
    const done = back
      ? await this.model.act("accept", { image, point }, "studio_point.accepted", { point })
      : await this.model.act("reject", { image, point }, "studio_point.rejected", { point });
    if (done) this.model.emit("looks");
  }

  async undo(): Promise<void> {
    await this.model.act("undo", {}, "studio_page.undone");
  }

  async redo(): Promise<void> {
    await this.model.act("redo", {}, "studio_page.redone");
  }

  /** Begin a point with a name that nobody has. */
  async newPoint(): Promise<void> {
    const named = new Set(this.model.state.points.map((p) => p.point));
    for (let n = 1; ; n++) {
      const name = `M${n}`;
      if (named.has(name)) continue;
      const found = await ask<Page<PointRow>>("/api/points", { search: name, limit: 500 });
      if (found.rows.some((row) => row.point === name)) continue;
      this.model.choose(name);
      this.model.say("studio_point.new_point", { point: name });
      return;
    }
  }

  /** The next of what is worth looking at; null where nothing is. */
  async worstNext(): Promise<Worst | null> {
    if (this.worstAt < 0) this.worstOnes = (await ask<{ worst: Worst[] }>("/api/worst")).worst;
    if (!this.worstOnes.length) {
      this.model.say("studio_point.no_worst");
      return null;
    }
    this.worstAt = (this.worstAt + 1) % this.worstOnes.length;
    const found = this.worstOnes[this.worstAt];
    const { kind, point, value } = found;
    this.model.say("studio_point.worst", {
      number: this.worstAt + 1, of: this.worstOnes.length, point, kind, value: short(value), n: Math.round(value), unit: this.model.overview.unit,
    });
    return found;
  }
}
