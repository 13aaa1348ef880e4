// What is open, what is measured, what is looked at; the parts of the page hear of what changes.
import { Actions } from "./actions";
import { ask, Refused } from "./api";
import { afterPause, whenSeen } from "./dom";
import { tiles } from "./tiles";
import { say, Values } from "./words";
import { Fiducial, ImageInfo, Mark, Observations, Overview, Predictions, Role, Run, State } from "./types";

export type Topic =
  | "overview" | "state" | "current" | "prediction" | "panes" | "looks" | "observations" | "message" | "read" | "fiducial" | "run" | "targets";

export interface Message {
  code: string;
  words: string;
  kind: "" | "bad" | "good";
}

export interface Picture extends ImageInfo {
  k: number;
}

export class Model {
  overview!: Overview;
  readonly images = new Map<string, Picture>();
  readonly actions = new Actions();
  state!: State;
  /** The point that is being measured; "": none. */
  current = "";
  /** The fiducial mark that is being measured, in place of a point; "": none. */
  fiducial = "";
  prediction: Predictions | null = null;
  /** Images of the panes, and which of them is active. */
  panes: string[] = [];
  active = 0;
  /** The run that goes on or was the last; null: none. */
  run: Run | null = null;
  message: Message = { code: "", words: "", kind: "" };
  command = "";
  private readonly marks = new Map<string, Mark[]>();
  private readonly given = new Map<string, Promise<Observations>>();
  private readonly listeners = new Map<Topic, (() => void)[]>();
  private turn = 0;
  private readonly predictSoon = afterPause(whenSeen(() => void this.predict()), 20);

  on(topics: Topic | Topic[], call: () => void): void {
    for (const topic of Array.isArray(topics) ? topics : [topics])
      this.listeners.set(topic, [...(this.listeners.get(topic) ?? []), call]);
  }

  emit(topic: Topic): void {
    for (const call of this.listeners.get(topic) ?? []) call();
  }

  /** Read everything; again after an adjustment or a lost connection. */
  async read(): Promise<void> {
    this.overview = await ask<Overview>("/api/overview");
    tiles.readAnew(this.overview.times);
    this.images.clear();
    this.overview.images.forEach((image, k) => this.images.set(image.id, { ...image, k }));
    this.given.clear();
    this.take(this.overview.state);
    this.emit("overview");
    this.emit("read");
    this.emit("observations");
    this.predictSoon();
  }

  /** A state of the server; an older one than is known is left out. */
  take(state: State): void {
    if (this.state && state.seq < this.state.seq) return;
    this.state = state;
    this.marks.clear();
    for (const mark of state.marks) this.marks.set(mark.image, [...(this.marks.get(mark.image) ?? []), mark]);
    this.emit("state");
    this.predictSoon();
  }

  /** Do something, and show the text of a code; where it cannot be done, the reason.  Returns whether it was done. */
  async act(verb: string, args: Record<string, unknown>, code: string, values: Values = {}): Promise<boolean> {
    try {
      const answer = await this.actions.send(verb, args);
      this.command = answer.command;
      this.take(answer.state);
      const { test } = answer;
      this.show([say(code, values), test?.words ?? ""].filter((t) => t).reverse().join(" "), test?.off ? "bad" : "good", code);
      return true;
    } catch (error) {
      this.fail(error);
      return false;
    }
  }

  /** Show the text of a code in the line below. */
  say(code: string, values: Values = {}, kind: Message["kind"] = ""): void {
    this.show(say(code, values), kind, code);
  }

  /** Show a text there; an error of the server with its code, by which `raybundle explain` finds it. */
  show(words: string, kind: Message["kind"] = "", code = ""): void {
    const explained = kind === "bad" && code && !code.startsWith("studio_");
    this.message = { code, words: explained ? `${words} [${code}]` : words, kind };
    this.emit("message");
  }

  /** Show why something could not be done. */
  fail(error: unknown): void {
    this.show((error as Error).message, "bad", error instanceof Refused ? error.code : "");
  }

  choose(point: string): void {
    if (this.fiducial) this.chooseFiducial("");
    if (point === this.current) return;
    this.current = point;
    this.prediction = null;
    this.emit("current");
    this.predictSoon();
  }

  chooseFiducial(name: string): void {
    this.fiducial = name;
    this.emit("fiducial");
  }

  fiducialsIn(image: string): Fiducial[] {
    return this.state.fiducials.filter((f) => f.image === image);
  }

  marksIn(image: string): Mark[] {
    return this.marks.get(image) ?? [];
  }

  mark(image: string, point: string): Mark | undefined {
    return this.marksIn(image).find((m) => m.point === point);
  }

  marksOf(point: string): Mark[] {
    return this.state.marks.filter((m) => m.point === point);
  }

  isRejected(image: string, point: string): boolean {
    return this.state.rejected.some(([i, p]) => i === image && p === point);
  }

  /** What a point was given, or how the block has it. */
  roleOf(point: string): Role {
    return this.state.points.find((p) => p.point === point)?.role ?? "tie";
  }

  observations(image: string): Promise<Observations> {
    let found = this.given.get(image);
    if (!found) {
      found = ask<Observations>("/api/observations", { image });
      found.catch(() => this.given.delete(image));
      this.given.set(image, found);
    }
    return found;
  }

  setPanes(images: string[], active: number): void {
    this.panes = images;
    this.active = active;
    this.emit("panes");
    this.predictSoon();
  }

  private async predict(): Promise<void> {
    const turn = ++this.turn;
    const point = this.current;
    if (!point) {
      this.prediction = null;
      this.emit("prediction");
      return;
    }
    try {
      const found = await ask<Predictions>("/api/predict", { point, images: [...new Set(this.panes)] });
      if (turn !== this.turn) return;
      this.prediction = found;
      this.emit("prediction");
    } catch (error) {
      if (error instanceof Refused) this.fail(error);
    }
  }
}
