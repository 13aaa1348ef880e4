// Where a photograph lies in its pane: the place in the middle, the scale, the quarter turns.

const LARGEST = 64;
const COS = [1, 0, -1, 0];
const SIN = [0, 1, 0, -1];

export class View {
  /** Place of the file in the middle of the pane [px of the file]. */
  x: number;
  y: number;
  /** CSS pixels for a pixel of the file. */
  scale = 1;
  width = 1;
  height = 1;
  fitted = true;

  constructor(readonly columns: number, readonly rows: number, public turn: number) {
    this.x = columns / 2;
    this.y = rows / 2;
  }

  get cos(): number {
    return COS[this.turn & 3];
  }

  get sin(): number {
    return SIN[this.turn & 3];
  }

  toScreen(x: number, y: number): [number, number] {
    const dx = (x - this.x) * this.scale;
    const dy = (y - this.y) * this.scale;
    return [this.width / 2 + this.cos * dx - this.sin * dy, this.height / 2 + this.sin * dx + this.cos * dy];
  }

  toImage(u: number, v: number): [number, number] {
    const [dx, dy] = this.along((u - this.width / 2) / this.scale, (v - this.height / 2) / this.scale);
    return [this.x + dx, this.y + dy];
  }

  /** A direction of the screen in the file. */
  along(du: number, dv: number): [number, number] {
    return [this.cos * du + this.sin * dv, -this.sin * du + this.cos * dv];
  }

  inside(x: number, y: number): boolean {
    return x >= 0 && y >= 0 && x <= this.columns && y <= this.rows;
  }

  get whole(): number {
    const across = this.turn & 1;
    return Math.min(this.width / (across ? this.rows : this.columns), this.height / (across ? this.columns : this.rows));
  }

  fit(): void {
    this.x = this.columns / 2;
    this.y = this.rows / 2;
    this.scale = this.whole * 0.98;
    this.fitted = true;
  }

  resize(width: number, height: number): void {
    this.width = Math.max(width, 1);
    this.height = Math.max(height, 1);
    if (this.fitted) this.fit();
  }

  zoomAt(factor: number, u = this.width / 2, v = this.height / 2): void {
    const [x, y] = this.toImage(u, v);
    this.scale = Math.min(Math.max(this.scale * factor, Math.min(this.whole / 2, 1)), LARGEST);
    const [a, b] = this.toImage(u, v);
    this.centre(this.x + x - a, this.y + y - b);
  }

  panBy(du: number, dv: number): void {
    const [dx, dy] = this.along(du / this.scale, dv / this.scale);
    this.centre(this.x - dx, this.y - dy);
  }

  centre(x: number, y: number): void {
    this.fitted = false;
    this.x = Math.min(Math.max(x, 0), this.columns);
    this.y = Math.min(Math.max(y, 0), this.rows);
  }

  /** The part of the file that is seen: left, top, right, bottom. */
  seen(): [number, number, number, number] {
    const [a, b] = this.toImage(0, 0);
    const [c, d] = this.toImage(this.width, this.height);
    return [
      Math.max(Math.min(a, c), 0), Math.max(Math.min(b, d), 0),
      Math.min(Math.max(a, c), this.columns), Math.min(Math.max(b, d), this.rows),
    ];
  }

  /** Let a canvas draw in pixels of the file. */
  apply(pen: CanvasRenderingContext2D, ratio: number, moved: [number, number] = [0, 0]): void {
    const s = this.scale * ratio;
    const u = (this.width / 2 + moved[0]) * ratio;
    const v = (this.height / 2 + moved[1]) * ratio;
    const { cos, sin, x, y } = this;
    pen.setTransform(s * cos, s * sin, -s * sin, s * cos, u - s * (cos * x - sin * y), v - s * (sin * x + cos * y));
  }
}
