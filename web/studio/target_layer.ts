// Targets found in the photographs: read when they are shown, sought where nothing is kept of a photograph.
import { ask, tell } from "./api";
import { TargetsOf } from "./types";

class TargetLayer {
  on = false;
  /** Families with blanks between; null: as the result says that is open. */
  families: string | null = null;
  /** Why nothing is drawn; "": something is. */
  told = "";
  private readonly kept = new Map<string, TargetsOf>();
  private readonly asked = new Set<string>();
  private readonly sought = new Set<string>();
  private readonly listeners: (() => void)[] = [];

  onchange(call: () => void): void {
    this.listeners.push(call);
  }

  private changed(): void {
    this.listeners.forEach((call) => call());
  }

  switch(on: boolean): void {
    this.on = on;
    this.changed();
  }

  choose(families: string): void {
    if (families === this.families) return;
    this.families = families;
    this.forget();
  }

  get query(): Record<string, string> {
    return this.families === null ? {} : { families: this.families };
  }

  /** Read anew what is shown: after an adjustment, or when targets were found. */
  forget(): void {
    this.kept.clear();
    this.asked.clear();
    this.changed();
  }

  of(image: string): TargetsOf | null {
    const found = this.kept.get(image);
    if (!found && !this.asked.has(image)) void this.read(image);
    return found ?? null;
  }

  private async read(image: string): Promise<void> {
    this.asked.add(image);
    try {
      const found = await ask<TargetsOf>("/api/targets/image", { image, ...this.query });
      this.kept.set(image, found);
      this.told = found.why || (found.families ? "" : "Name the family of the targets under Decide, Targets.");
      const key = `${image} ${found.families}`;
      if (!found.from && !found.why && found.families && !this.sought.has(key)) {
        this.sought.add(key);
        await tell("/api/targets", { families: found.families, images: [image] });
      }
    } catch (error) {
      this.told = (error as Error).message;
    }
    this.changed();
  }
}

export const targetLayer = new TargetLayer();
