// What is beyond the limit that is looked at: drawn in photographs and in object space until it is taken away.

export class Beyond {
  private images = new Map<string, Set<string>>();
  /** Object points that it touches. */
  points = new Set<string>();
  private readonly listeners: (() => void)[] = [];

  onchange(call: () => void): void {
    this.listeners.push(call);
  }

  show(rows: [image: string, point: string][]): void {
    this.images = new Map();
    this.points = new Set();
    for (const [image, point] of rows) {
      this.points.add(point);
      const there = this.images.get(image);
      if (there) there.add(point);
      else this.images.set(image, new Set([point]));
    }
    for (const call of this.listeners) call();
  }

  has(image: string, point: string): boolean {
    return this.images.get(image)?.has(point) ?? false;
  }

  /** The image with most of it; "": nothing is beyond. */
  get worstImage(): string {
    let worst = "";
    for (const [image, points] of this.images) if (points.size > (this.images.get(worst)?.size ?? 0)) worst = image;
    return worst;
  }
}

export const beyond = new Beyond();
