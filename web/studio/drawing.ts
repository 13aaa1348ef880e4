// The polygon of a mask that is being drawn: its corners, in the pixels of one photograph's file.
import { View } from "./view";

export type Corner = [number, number];
const NEAR = 9;

class Drawing {
  on = false;
  /** The photograph of the first corner; "": none yet. */
  image = "";
  corners: Corner[] = [];
  private readonly calls: (() => void)[] = [];

  onchange(call: () => void): void {
    this.calls.push(call);
  }

  begin(image = "", corners: Corner[] = []): void {
    this.on = true;
    this.image = image;
    this.set(corners);
  }

  end(): void {
    this.on = false;
    this.image = "";
    this.set([]);
  }

  /** One corner more; false in another photograph than that of the first. */
  add(image: string, corner: Corner): boolean {
    if (this.image && image !== this.image) return false;
    this.image = image;
    this.set([...this.corners, corner]);
    return true;
  }

  move(k: number, corner: Corner): void {
    this.set(this.corners.map((old, i) => (i === k ? corner : old)));
  }

  removeLast(): void {
    this.set(this.corners.slice(0, -1));
    if (!this.corners.length) this.image = "";
  }

  /** Which corner lies at a place of a pane; -1: none. */
  cornerAt(image: string, view: View, u: number, v: number): number {
    if (!this.on || image !== this.image) return -1;
    return this.corners.findIndex(([x, y]) => {
      const [a, b] = view.toScreen(x, y);
      return Math.hypot(a - u, b - v) < NEAR;
    });
  }

  private set(corners: Corner[]): void {
    this.corners = corners;
    for (const call of this.calls) call();
  }
}

export const drawing = new Drawing();
