// The line below and the buttons above: what is going on, what was done last.
import { Refused, tell } from "./api";
import { element } from "./dom";
import { Measuring } from "./measuring";
import { Model } from "./model";
import { short } from "./numbers";
import { targetLayer } from "./target_layer";
import { Live, Run } from "./types";

export class Status {
  private readonly undo = element<HTMLButtonElement>("undo");
  private readonly redo = element<HTMLButtonElement>("redo");
  private readonly adjust = element<HTMLButtonElement>("adjust");
  private outcome: Run["outcome"] | "" = "";
  private readonly progress = element<HTMLProgressElement>("progress");

  constructor(private readonly model: Model, measuring: Measuring) {
    this.undo.addEventListener("click", () => void measuring.undo());
    this.redo.addEventListener("click", () => void measuring.redo());
    this.adjust.addEventListener("click", () => void this.begin());
    element("stop").addEventListener("click", () => void tell("/api/stop", {}));
    model.on("state", () => this.buttons());
    model.on("message", () => this.message());
    model.on("overview", () => this.names());
    model.actions.onwaiting = (n, lost) => this.waiting(n, lost);
  }

  private buttons(): void {
    this.undo.disabled = !this.model.state.can_undo;
    this.redo.disabled = !this.model.state.can_redo;
  }

  private message(): void {
    const { words, kind } = this.model.message;
    const line = element("message");
    line.textContent = line.title = words;
    line.className = kind;
    const command = element("command");
    command.textContent = this.model.command;
  }

  private names(): void {
    const o = this.model.overview;
    element("title").textContent = document.title = `${o.title} – studio`;
    element("title").textContent = o.title || "raybundle studio";
    const sigma0 = o.sigma0 === null ? "" : `sigma0 ${short(o.sigma0)}`;
    const told = [o.headline, sigma0, o.free_scale ? "free scale" : ""].filter((t) => t).join(" · ");
    const line = element("headline");
    line.textContent = line.title = told || `${o.kind}: ${o.images.length} images, ${o.points} points`;
    line.className = o.grade;
    element("report").hidden = !o.report;
  }

  private async begin(): Promise<void> {
    try {
      const { begun } = await tell<{ begun: boolean }>("/api/adjust", {});
      this.model.say(begun ? "Adjusting block and marks." : "Something is being adjusted already.");
    } catch (error) {
      this.model.say(error instanceof Refused ? error.message : "The server does not answer.", "bad");
    }
  }

  pointer(words: string): void {
    element("pointer").textContent = words;
  }

  connection(open: boolean): void {
    const told = element("connection");
    told.textContent = open ? "connected" : "connection lost: trying again";
    told.className = open ? "" : "bad";
  }

  private waiting(n: number, lost: boolean): void {
    if (!lost) return;
    this.model.say(n ? `No answer: ${n} ${n === 1 ? "action waits" : "actions wait"} and will be sent again.` : "", "bad");
  }

  heard(message: Live): void {
    if (message.type === "state") this.model.take(message.state);
    else if (message.type === "oriented") void this.model.read().catch(() => {});
    else if (message.type === "progress") {
      element("work").hidden = false;
      this.adjust.disabled = true;
      this.progress.value = message.share;
      element("work-stage").textContent = message.stage;
    } else if (message.type === "run") this.ran(message.run);
    else if (message.type === "targets") this.found(message.images, message.error);
    else void this.adjusted(message);
  }

  private found(images: string[], error: string): void {
    element("work").hidden = true;
    this.adjust.disabled = false;
    if (error) this.model.say(error, "bad");
    else this.model.say(`Targets found in ${images.length === 1 ? images[0] : `${images.length} photographs`}.`, "good");
    targetLayer.forget();
    this.model.emit("targets");
  }

  private ran(run: Run): void {
    const before = this.outcome;
    this.outcome = run.outcome;
    this.model.run = run;
    const goes = run.outcome === "running";
    element("work").hidden = !goes;
    this.adjust.disabled = goes;
    this.progress.value = run.share;
    element("work-stage").textContent = `${run.name}: ${run.step}`;
    this.model.emit("run");
    if (goes || before === run.outcome) return;
    const last = run.words.split("\n");
    if (run.outcome === "done") this.model.say(last[0].trim(), "good");
    else this.model.say(run.outcome === "failed" ? last[last.length - 1] : run.words, run.outcome === "failed" ? "bad" : "");
    if (run.outcome === "done") void this.model.read().catch(() => {});
  }

  private async adjusted(message: Live & { type: "adjusted" }): Promise<void> {
    element("work").hidden = true;
    this.adjust.disabled = false;
    if (message.error) return this.model.say(message.error, "bad");
    await this.model.read();
    const sigma0 = message.sigma0 === null ? "" : `: sigma0 ${short(message.sigma0)}`;
    const folder = message.folder ? `; the result is in ${message.folder}` : "";
    this.model.say(`Adjusted${sigma0}${folder}`, "good");
  }
}
