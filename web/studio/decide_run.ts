// The stages of orient or calibrate, run from here: settings, command, how far it is, stopped, run again.
import { ask, send } from "./api";
import { button, element, h, heads } from "./dom";
import { Model } from "./model";
import { OptionFields, Values } from "./option_form";
import { fixed } from "./numbers";
import { OptionForm, Run, RunStage } from "./types";
import { keyed, say } from "./words";

interface Answer {
  form: (OptionForm & { name: string }) | null;
  why: string;
  run: Run | null;
}

export class DecideRun {
  readonly root = h("section", { class: "leaf", "aria-label": say("studio_run.title") });
  private readonly form = new OptionFields("run", (values) => void this.send(values));
  private readonly command = h("code", { class: "command" });
  private readonly why = h("p", { class: "note" });
  private readonly go = button("studio_run.begin", () => void this.begin(), "main", { name: "" });
  private readonly stop = button("studio_run.stop", () => element("stop").click());
  private readonly usual = button("studio_decide.reset", () => void this.send({}));
  private readonly status = h("p", { class: "counts", role: "status", "aria-live": "polite" });
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": say("studio_run.progress") });
  private readonly body = h("tbody", {});
  private readonly table = h("table", { class: "stages", "aria-label": say("studio_run.stages") },
    heads(["studio_run.stage", "studio_run.state", "label.time", "label.result"]), this.body);
  private readonly words = h("pre", { class: "printed", tabindex: 0, "aria-label": say("studio_run.output") });
  private readonly settings: HTMLElement;

  constructor(private readonly model: Model) {
    this.go.id = "run-begin";
    this.stop.id = "run-stop";
    this.usual.id = "run-usual";
    this.settings = h("div", {},
      h("h3", {}, say("studio_decide.command")), h("p", {}, this.command),
      h("h3", {}, say("studio_run.settings")), h("p", { class: "note" }, say("studio_run.settings_note")),
      this.form.root);
    this.root.append(this.why, h("div", { class: "deeds first" }, this.go, this.stop, this.usual), this.status, this.bar, this.table, this.words, this.settings);
    model.on("run", () => model.run?.stages.length !== 0 && this.run(model.run));
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
      this.go.textContent = say("studio_run.begin", { name: form.name });
    }
    this.model.run = run;
    this.run(run);
  }

  private async send(values: Values): Promise<void> {
    try {
      this.take(await send<Answer>("/api/run/settings", { values }));
      this.model.say("studio_run.settings_stored", {}, "good");
    } catch (error) {
      this.model.fail(error);
    }
  }

  private async begin(): Promise<void> {
    try {
      this.take(await send<Answer>("/api/run", {}));
      this.model.say("studio_run.begun");
    } catch (error) {
      this.model.fail(error);
    }
  }

  private run(run: Run | null): void {
    const goes = run?.outcome === "running";
    this.go.disabled = goes;
    this.stop.disabled = !goes;
    this.bar.hidden = !goes;
    this.status.hidden = this.table.hidden = !run;
    this.words.hidden = !run?.words;
    if (!run) return;
    this.bar.value = run.share;
    this.status.textContent = headline(run);
    this.body.replaceChildren(...run.stages.map(row));
    this.words.textContent = run.words;
    this.words.classList.toggle("bad", run.outcome === "failed");
  }
}

export function headline(run: Run): string {
  if (run.outcome !== "running") return say("studio_run.ended", { outcome: run.outcome, time: time(run.seconds) });
  const step = stageName(run.step);
  if (run.stopping) return say("studio_run.stopping", { step });
  const rest = run.left_s === null ? "none" : time(run.left_s);
  return say("studio_run.going", { step, percent: Math.round(100 * run.share), rest, time: time(run.seconds) });
}

/** A stage, or a step of one, in words. */
export const stageName = (stage: string): string => say("studio_run.stage_name", { stage: keyed(stage.split(":")[0]), name: stage });

const row = (s: RunStage): HTMLElement =>
  h("tr", { class: s.state.replace(" ", "-") }, h("th", { scope: "row" }, stageName(s.title)),
    h("td", { class: "l" }, say("studio_run.stage_state", { state: keyed(s.state) })), h("td", {}, s.seconds === null ? "–" : time(s.seconds)), h("td", { class: "l" }, s.summary));

/** A time, with the unit that suits it. */
function time(seconds: number): string {
  if (seconds < 9.95) return `${fixed(seconds, 1)} s`;
  if (seconds < 120) return `${Math.round(seconds)} s`;
  return seconds < 7200 ? `${Math.round(seconds / 60)} min` : `${fixed(seconds / 3600, 1)} h`;
}
