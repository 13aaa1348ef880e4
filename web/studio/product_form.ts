// A product: its settings as a form, the command, made here or stopped, and what the command printed.
import { ask, send } from "./api";
import { button, element, h } from "./dom";
import { headline } from "./decide_run";
import { Model } from "./model";
import { OptionFields, Values } from "./option_form";
import { OptionForm, Run } from "./types";
import { say } from "./words";

interface Answer extends OptionForm {
  name: string;
  drawn: string;
  run: Run | null;
}

export class ProductForm {
  readonly root: HTMLElement;
  private readonly form: OptionFields;
  private readonly command = h("code", { class: "command" });
  private readonly go = button("studio_product.make", () => void this.make(), "main");
  private readonly stop = button("studio_run.stop", () => element("stop").click());
  private readonly status = h("p", { class: "counts", role: "status", "aria-live": "polite" });
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": say("studio_run.progress") });
  private readonly words = h("pre", { class: "printed", tabindex: 0, "aria-label": say("studio_run.output") });
  private field = "";
  private known = false;

  constructor(private readonly model: Model, private readonly name: string) {
    this.form = new OptionFields(`product-${name}`, (values) => void this.send(values));
    this.go.id = `make-${name}`;
    this.root = h("section", { class: "leaf", "aria-label": say("studio_product.part", { part: name }), hidden: true },
      h("p", { class: "note" }, say("studio_product.about", { product: name })),
      h("div", { class: "deeds" }, this.go, this.stop), this.status, this.bar, this.words,
      h("h3", {}, say("studio_decide.command")), h("p", {}, this.command), h("h3", {}, say("studio_run.settings")), this.form.root);
    this.run(null);
  }

  async show(): Promise<void> {
    if (this.known) await this.send(this.form.values());
    else this.take(await ask<Answer>("/api/product", { name: this.name }));
    this.known = true;
  }

  /** Take the corners of what was drawn as the setting for it. */
  async drawn(corners: string): Promise<void> {
    await this.show();
    await this.send({ ...this.form.values(), [this.field]: `'${corners}'` });
  }

  private take(answer: Answer): void {
    this.form.fill(answer.fields);
    this.command.textContent = answer.command;
    this.field = answer.drawn;
    if (answer.run?.name === this.name) this.run(answer.run);
  }

  private async send(values: Values): Promise<void> {
    try {
      this.take(await send<Answer>("/api/product/settings", { name: this.name, values }));
    } catch (error) {
      this.model.fail(error);
    }
  }

  private async make(): Promise<void> {
    try {
      const { run } = await send<{ run: Run }>("/api/product/make", { name: this.name, values: this.form.values() });
      this.model.run = run;
      this.run(run);
    } catch (error) {
      this.model.fail(error);
    }
  }

  run(run: Run | null): void {
    const goes = run?.outcome === "running";
    this.go.disabled = goes;
    this.stop.disabled = !goes;
    this.bar.hidden = !goes;
    this.status.hidden = !run;
    this.words.hidden = !run?.words;
    if (!run) return;
    this.bar.value = run.share;
    this.status.textContent = headline(run);
    this.words.textContent = run.outcome === "running" ? run.words : `${run.command}\n\n${run.words}`;
    this.words.classList.toggle("bad", run.outcome === "failed");
    if (run.outcome === "done") void this.show();
  }
}
