// Tiles of photographs: cached, requested in order of need, a few at once, so that other questions find a way through.
import { onceAFrame } from "./dom";

export const SIDE = 512;
const AT_ONCE = 4;
const LARGEST_CACHE = 320;
const AGAIN_MS = 2500;

export const tileKey = (k: number, level: number, column: number, row: number): string => `${k}/${level}/${column}/${row}`;

export function lastLevel(width: number, height: number): number {
  let n = 0;
  while (Math.max(width, height) > SIDE) {
    width = Math.ceil(width / 2);
    height = Math.ceil(height / 2);
    n++;
  }
  return n;
}

export class Tiles {
  private readonly cache = new Map<string, ImageBitmap>();
  private readonly loading = new Map<string, AbortController>();
  private readonly wanted = new Map<object, { keys: string[]; late: boolean }>();
  private readonly failed = new Map<string, string>();
  private readonly listeners = new Set<() => void>();
  private readonly arrived = onceAFrame(() => this.listeners.forEach((call) => call()));
  private timesRead = 0;
  /** How long each took [ms]. */
  readonly times: number[] = [];

  onarrival(call: () => void): () => void {
    this.listeners.add(call);
    return () => this.listeners.delete(call);
  }

  /** Images have other numbers after the folder was read anew: nothing in the cache is theirs. */
  readAnew(times: number): void {
    if (times === this.timesRead) return;
    this.timesRead = times;
    this.loading.forEach((control) => control.abort());
    this.cache.forEach((bitmap) => bitmap.close());
    this.cache.clear();
    this.failed.clear();
  }

  get(key: string): ImageBitmap | undefined {
    const found = this.cache.get(key);
    if (found) {
      this.cache.delete(key);
      this.cache.set(key, found);
    }
    return found;
  }

  /** Why a tile does not come; "" where it may. */
  why(key: string): string {
    return this.failed.get(key) ?? "";
  }

  /** What somebody needs now, the most urgent first; late: after all others. */
  want(owner: object, keys: string[], late = false): void {
    const missing = keys.filter((key) => !this.cache.has(key) && !this.failed.has(key));
    if (missing.length) this.wanted.set(owner, { keys: missing, late });
    else this.wanted.delete(owner);
    const still = new Set([...this.wanted.values()].flatMap((w) => w.keys));
    for (const [key, control] of this.loading) if (!still.has(key)) control.abort();
    this.pump();
  }

  private pump(): void {
    while (this.loading.size < AT_ONCE) {
      const next = this.next();
      if (!next) return;
      void this.load(next);
    }
  }

  private next(): string | undefined {
    for (const late of [false, true]) {
      // small pictures of the list come one by one: each may be a photograph to decode
      if (late && this.loading.size) return undefined;
      // turn by turn, so that each pane gets its coarse tiles first
      const lists = [...this.wanted.values()].filter((w) => w.late === late);
      const longest = Math.max(0, ...lists.map((w) => w.keys.length));
      for (let k = 0; k < longest; k++)
        for (const { keys } of lists) {
          const key = keys[k];
          if (key && !this.loading.has(key) && !this.cache.has(key) && !this.failed.has(key)) return key;
        }
    }
    return undefined;
  }

  private async load(key: string): Promise<void> {
    const control = new AbortController();
    this.loading.set(key, control);
    const began = performance.now();
    const times = this.timesRead;
    try {
      const answer = await fetch(`/api/tile/${key}?read=${times}`, { signal: control.signal });
      if (answer.status === 404) this.failed.set(key, ((await answer.json()) as { error: string }).error);
      else if (!answer.ok) throw new Error(String(answer.status));
      else {
        const bitmap = await createImageBitmap(await answer.blob());
        if (times === this.timesRead) this.keep(key, bitmap);
        this.times.push(performance.now() - began);
      }
    } catch {
      if (!control.signal.aborted) await new Promise((go) => setTimeout(go, AGAIN_MS));
    }
    this.loading.delete(key);
    this.arrived();
    this.pump();
  }

  private keep(key: string, bitmap: ImageBitmap): void {
    this.cache.set(key, bitmap);
    while (this.cache.size > LARGEST_CACHE) {
      const oldest = this.cache.keys().next().value as string;
      this.cache.get(oldest)!.close();
      this.cache.delete(oldest);
    }
  }
}

export const tiles = new Tiles();
