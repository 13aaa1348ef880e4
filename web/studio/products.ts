// What is made of the result: pictures and drawing on them, surface, elevation, volumes, profiles, exchange files, archive.
import { ask } from "./api";
import { button, element, h } from "./dom";
import { Model } from "./model";
import { ProductFiles } from "./product_files";
import { ProductForm } from "./product_form";
import { ProductPages } from "./product_pages";
import { ProductPlan } from "./product_plan";
import { ProductsAnswer } from "./types";
import { say } from "./words";
import type { Leaf } from "./leaf";

const ENDS: string[] = ["done", "failed", "stopped"];

export class Products {
  private readonly plan: ProductPlan;
  private readonly pages = new ProductPages();
  private readonly files: ProductFiles;
  private readonly forms = new Map<string, ProductForm>();
  private leaves: [name: string, leaf: Leaf][] = [];
  private heads: HTMLButtonElement[] = [];
  private now = "";

  constructor(private readonly model: Model, private readonly isOpen: () => boolean) {
    this.plan = new ProductPlan(model, (name, corners) => void this.drawn(name, corners));
    this.files = new ProductFiles((path) => {
      this.turn("plan");
      void this.plan.open(path);
    });
    model.on("run", () => {
      const run = model.run;
      this.forms.get(run?.name ?? "")?.run(run);
      if (run && ENDS.includes(run.outcome) && this.isOpen()) void this.read();
    });
    model.on("read", () => this.isOpen() && void this.show());
  }

  async show(): Promise<void> {
    try {
      await this.read();
      await this.leaf(this.now).show();
    } catch (error) {
      this.model.fail(error);
    }
  }

  private async read(): Promise<void> {
    const answer = await ask<ProductsAnswer>("/api/products");
    if (!this.leaves.length) this.make(answer.products);
    this.files.take(answer.files);
    this.plan.take(answer.files);
    this.pages.take(answer.files);
    if (!this.now) this.turn(this.plan.has ? "plan" : answer.products[0]);
  }

  private make(names: string[]): void {
    for (const name of names) this.forms.set(name, new ProductForm(this.model, name));
    this.leaves = [["plan", this.plan], ...this.forms.entries(), ["pages", this.pages], ["files", this.files]];
    this.heads = this.leaves.map(([name]) => {
      const head = button("studio_product.part", () => this.turn(name), "", { part: name });
      head.id = `product-${name}`;
      return head;
    });
    element("products-bar").append(h("span", { class: "group", role: "group", "aria-label": say("studio_product.title") }, ...this.heads));
    element("products").append(...this.leaves.map(([, leaf]) => leaf.root));
  }

  private leaf(name: string): Leaf {
    return this.leaves.find(([each]) => each === name)![1];
  }

  private turn(to: string): void {
    this.now = to;
    this.leaves.forEach(([name, leaf], k) => {
      this.heads[k].setAttribute("aria-pressed", String(name === to));
      leaf.root.hidden = name !== to;
    });
    if (this.isOpen()) this.leaf(to).show().catch((error) => this.model.fail(error));
  }

  /** Go to a product with what was drawn. */
  private async drawn(name: string, corners: string): Promise<void> {
    const form = this.forms.get(name)!;
    this.turn(name);
    await form.drawn(corners);
  }
}
