// Targets found in the photographs: read when they are shown, sought where nothing is stored of a photograph.
import { ask, send } from "./api";
import { TargetsOf } from "./types";
import { say } from "./words";

class TargetLayer {
  on = false;
  /** Families with blanks between; null: those of the open result. */
  families: string | null = null;
  /** Why nothing is drawn; "": something is. */
  reason = "";
  private readonly found = new Map<string, TargetsOf>();
  private readonly requested = new Set<string>();
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
    this.found.clear();
    this.requested.clear();
    this.changed();
  }

  of(image: string): TargetsOf | null {
    const found = this.found.get(image);
    if (!found && !this.requested.has(image)) void this.read(image);
    return found ?? null;
  }

  private async read(image: string): Promise<void> {
    this.requested.add(image);
    try {
      const found = await ask<TargetsOf>("/api/targets/image", { image, ...this.query });
      this.found.set(image, found);
      this.reason = found.why || (found.families ? "" : say("studio_target.name_family"));
      const key = `${image} ${found.families}`;
      if (!found.from && !found.why && found.families && !this.sought.has(key)) {
        this.sought.add(key);
        await send("/api/targets", { families: found.families, images: [image] });
      }
    } catch (error) {
      this.reason = (error as Error).message;
    }
    this.changed();
  }
}

export const targetLayer = new TargetLayer();
