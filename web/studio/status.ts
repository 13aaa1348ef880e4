// The line below and the buttons above: what is going on, what was done last.
import { send } from "./api";
import { stageName } from "./decide_run";
import { element } from "./dom";
import { Measuring } from "./measuring";
import { Model } from "./model";
import { targetLayer } from "./target_layer";
import { Live, Run } from "./types";
import { say } from "./words";

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
    element("stop").addEventListener("click", () => void send("/api/stop", {}));
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
    const { code, words, kind } = this.model.message;
    const line = element("message");
    line.dataset.code = code;
    line.textContent = line.title = words;
    line.className = kind;
    const command = element("command");
    command.textContent = this.model.command;
  }

  private names(): void {
    const o = this.model.overview;
    element("title").textContent = document.title = `${o.title} – studio`;
    element("title").textContent = o.title || "raybundle studio";
    const facts = [o.headline, o.sigma0 === null ? "" : say("studio_page.sigma0", { sigma0: o.sigma0 }), o.free_scale ? say("studio_page.free_scale") : ""];
    const line = element("headline");
    line.textContent = line.title = facts.filter((t) => t).join(" · ") || say("studio_page.contents", { kind: o.kind, images: o.images.length, points: o.points });
    line.className = o.grade;
    element("report").hidden = !o.report;
  }

  private async begin(): Promise<void> {
    try {
      const { begun } = await send<{ begun: boolean }>("/api/adjust", {});
      if (begun) this.model.say("studio_page.adjusting");
      else this.model.say("studio_page.busy");
    } catch (error) {
      this.model.fail(error);
    }
  }

  pointer(words: string): void {
    element("pointer").textContent = words;
  }

  connection(open: boolean): void {
    const line = element("connection");
    line.textContent = open ? say("studio_page.connected") : say("studio_page.connection_lost");
    line.className = open ? "" : "bad";
  }

  private waiting(n: number, lost: boolean): void {
    if (!lost) return;
    if (n) this.model.say("studio_page.actions_wait", { n }, "bad");
    else this.model.show("");
  }

  receive(message: Live): void {
    if (message.type === "state") this.model.take(message.state);
    else if (message.type === "oriented") void this.model.read().catch(() => {});
    else if (message.type === "progress") {
      element("work").hidden = false;
      this.adjust.disabled = true;
      this.progress.value = message.share;
      element("work-stage").textContent = stageName(message.stage);
    } else if (message.type === "run") this.showRun(message.run);
    else if (message.type === "targets") this.showTargets(message);
    else void this.adjusted(message);
  }

  private showTargets({ images, error, code }: Live & { type: "targets" }): void {
    element("work").hidden = true;
    this.adjust.disabled = false;
    if (error) this.model.show(error, "bad", code);
    else this.model.say("studio_target.found_in", { n: images.length, image: images[0] ?? "" }, "good");
    targetLayer.forget();
    this.model.emit("targets");
  }

  private showRun(run: Run): void {
    const before = this.outcome;
    this.outcome = run.outcome;
    this.model.run = run;
    const goes = run.outcome === "running";
    element("work").hidden = !goes;
    this.adjust.disabled = goes;
    this.progress.value = run.share;
    element("work-stage").textContent = `${run.name}: ${stageName(run.step)}`;
    this.model.emit("run");
    if (goes || before === run.outcome) return;
    const last = run.words.split("\n");
    if (run.outcome === "done") this.model.show(last[0].trim(), "good");
    else if (run.outcome === "failed") this.model.show(last[last.length - 1], "bad");
    else this.model.say("studio_run.stopped");
    if (run.outcome === "done") void this.model.read().catch(() => {});
  }

  private async adjusted(message: Live & { type: "adjusted" }): Promise<void> {
    element("work").hidden = true;
    this.adjust.disabled = false;
    if (message.error) return this.model.show(message.error, "bad", message.code);
    await this.model.read();
    this.showResult(message.folder);
  }

  /** That it is adjusted, how well, and where the result is. */
  showResult(folder: string): void {
    this.model.say("studio_page.adjusted", { sigma0: this.model.overview.sigma0, folder: folder || "none" }, "good");
  }
}
