// The stages of orient or calibrate, run from here: settings, command, how far it is, stopped, run again.
import { ask, tell } from "./api";
import { button, element, h } from "./dom";
import { Model } from "./model";
import { OptionFields, Values } from "./option_form";
import { OptionForm, Run, RunStage } from "./types";

interface Answer {
  form: (OptionForm & { name: string }) | null;
  why: string;
  run: Run | null;
}

const HEADS = ["stage", "state", "time", "what came of it"];

export class DecideRun {
  readonly root = h("section", { class: "leaf", "aria-label": "Run of all stages" });
  private readonly form = new OptionFields("run", (values) => void this.send(values));
  private readonly command = h("code", { class: "command" });
  private readonly why = h("p", { class: "note" });
  private readonly go = button("Run", "Run all stages in the background; those that are kept are taken as they are", () => void this.begin(), "main");
  private readonly stop = button("Stop", "Stop between two tasks; what is finished is kept", () => element("stop").click());
  private readonly usual = button("As usual", "All settings as they are by default", () => void this.send({}));
  private readonly told = h("p", { class: "counts", role: "status", "aria-live": "polite" });
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": "Progress of this step" });
  private readonly body = h("tbody", {});
  private readonly table = h("table", { class: "stages", "aria-label": "Stages" },
    h("thead", {}, h("tr", {}, ...HEADS.map((words) => h("th", { scope: "col" }, words)))), this.body);
  private readonly words = h("pre", { class: "printed", tabindex: 0, "aria-label": "What the command says" });
  private readonly settings: HTMLElement;

  constructor(private readonly model: Model) {
    this.go.id = "run-begin";
    this.stop.id = "run-stop";
    this.usual.id = "run-usual";
    this.settings = h("div", {},
      h("h3", {}, "The same on the command line"), h("p", {}, this.command),
      h("h3", {}, "Settings"), h("p", { class: "note" }, "Those of the last run in this folder; what differs from the default is marked. What was measured by hand stays, and takes part again with the next Adjust."),
      this.form.root);
    this.root.append(this.why, h("div", { class: "deeds first" }, this.go, this.stop, this.usual), this.told, this.bar, this.table, this.words, this.settings);
    model.on("run", () => this.run(model.run));
  }

  async show(): Promise<void> {
    this.take(await ask<Answer>("/api/run"));
  }

  private take({ form, why, run }: Answer): void {
    this.why.textContent = why;
    this.why.hidden = !why;
    this.settings.hidden = this.usual.hidden = this.go.hidden = !form;
    if (form) {
      this.form.fill(form.fields);
      this.command.textContent = form.command;
      this.go.textContent = `Run ${form.name}`;
    }
    this.model.run = run;
    this.run(run);
  }

  private async send(values: Values): Promise<void> {
    try {
      this.take(await tell<Answer>("/api/run/settings", { values }));
      this.model.say("Settings of the next run.", "good");
    } catch (error) {
      this.model.say((error as Error).message, "bad");
    }
  }

  private async begin(): Promise<void> {
    try {
      this.take(await tell<Answer>("/api/run", {}));
      this.model.say("Running the stages.");
    } catch (error) {
      this.model.say((error as Error).message, "bad");
    }
  }

  private run(run: Run | null): void {
    const goes = run?.outcome === "running";
    this.go.disabled = goes;
    this.stop.disabled = !goes;
    this.bar.hidden = !goes;
    this.told.hidden = this.table.hidden = !run;
    this.words.hidden = !run?.words;
    if (!run) return;
    this.bar.value = run.share;
    this.told.textContent = headline(run);
    this.body.replaceChildren(...run.stages.map(row));
    this.words.textContent = run.words;
    this.words.classList.toggle("bad", run.outcome === "failed");
  }
}

function headline(run: Run): string {
  if (run.outcome !== "running") return { done: "Done", stopped: "Stopped", failed: "Failed" }[run.outcome] + ` after ${time(run.seconds)}`;
  if (run.stopping) return `Stopping behind the task at work: ${run.step}`;
  const left = run.left_s === null ? "" : `, ${time(run.left_s)} of it left`;
  return `${run.step}: ${Math.round(100 * run.share)} %${left}; ${time(run.seconds)} since the beginning`;
}

const WORDS: Record<RunStage["state"], string> = { waiting: "waiting", "at work": "at work", done: "done", kept: "kept from before", "not needed": "not needed" };

const row = (s: RunStage): HTMLElement =>
  h("tr", { class: s.state.replace(" ", "-") }, h("th", { scope: "row" }, s.title),
    h("td", { class: "l" }, WORDS[s.state]), h("td", {}, s.seconds === null ? "–" : time(s.seconds)), h("td", { class: "l" }, s.summary));

/** Seconds as people say them. */
function time(seconds: number): string {
  if (seconds < 9.95) return `${seconds.toFixed(1)} s`;
  if (seconds < 120) return `${Math.round(seconds)} s`;
  return seconds < 7200 ? `${Math.round(seconds / 60)} min` : `${(seconds / 3600).toFixed(1)} h`;
}
