// The images on the left: a small picture, the name, its rays and residuals.
import { Choice } from "./choice";
import { element, h } from "./dom";
import { Model, Picture } from "./model";
import { short } from "./numbers";
import { lastLevel, tileKey, tiles } from "./tiles";
import { say } from "./words";

const WIDTH = 72;
const HEIGHT = 54;

export class ImageList {
  private readonly filter = element<HTMLInputElement>("image-filter");
  private readonly list: Choice<Picture>;
  private readonly small = new Map<Element, Picture>();
  private readonly watch: IntersectionObserver;

  constructor(private readonly model: Model, open: (image: string, beside: boolean) => void) {
    this.list = new Choice<Picture>(say("studio_page.images"), (p) => p.id, (p) => this.row(p), (p, event) => {
      open(p.id, (event as MouseEvent | KeyboardEvent).shiftKey);
    });
    const box = element("image-list");
    box.append(this.list.root);
    this.watch = new IntersectionObserver((entries) => entries.forEach((e) => this.seen(e)), { root: this.list.root });
    tiles.onarrival(() => this.small.forEach((picture, canvas) => this.draw(canvas as HTMLCanvasElement, picture)));
    this.filter.addEventListener("input", () => this.show());
    model.on("overview", () => this.show());
    model.on("panes", () => this.list.select(model.panes[model.active] ?? ""));
  }

  private show(): void {
    const part = this.filter.value.toLowerCase();
    this.watch.disconnect();
    this.small.forEach((_, canvas) => tiles.want(canvas, []));
    this.small.clear();
    const shown = [...this.model.images.values()].filter((p) => p.id.toLowerCase().includes(part));
    this.list.set(shown, this.model.panes[this.model.active]);
    element("images-head").textContent = say("studio_photo.count", { n: shown.length });
  }

  private row(picture: Picture): Node[] {
    const canvas = h("canvas", { width: WIDTH * 2, height: HEIGHT * 2, "aria-hidden": "true" });
    this.small.set(canvas, picture);
    queueMicrotask(() => this.watch.observe(canvas));
    const rms = picture.rms_px === null ? "" : `, ${short(picture.rms_px, 2)}\u00a0px`;
    const about = picture.oriented
      ? say("studio_photo.rays", { n: picture.rays }) + rms
      : say("studio_photo.not_oriented", { n: this.model.marksIn(picture.id).length });
    const chance = picture.p_wrong === null ? "" : `\n${say("studio_photo.p_wrong", { percent: 100 * picture.p_wrong })}`;
    return [canvas, h("span", { class: "about", title: picture.id + chance }, h("b", {}, picture.id), h("small", { class: picture.oriented ? "" : "open" }, about))];
  }

  private seen(entry: IntersectionObserverEntry): void {
    const picture = this.small.get(entry.target);
    if (!picture?.photo) return;
    const key = tileKey(picture.k, lastLevel(picture.width, picture.height), 0, 0);
    tiles.want(entry.target, entry.isIntersecting ? [key] : [], true);
    this.draw(entry.target as HTMLCanvasElement, picture);
  }

  private draw(canvas: HTMLCanvasElement, picture: Picture): void {
    const last = lastLevel(picture.width, picture.height);
    const tile = canvas.dataset.drawn ? undefined : tiles.get(tileKey(picture.k, last, 0, 0));
    if (!tile) return;
    canvas.dataset.drawn = "yes";
    const pen = canvas.getContext("2d")!;
    const [w, height] = picture.turn & 1 ? [tile.height, tile.width] : [tile.width, tile.height];
    const scale = Math.min(canvas.width / w, canvas.height / height);
    pen.translate(canvas.width / 2, canvas.height / 2);
    pen.rotate((picture.turn * Math.PI) / 2);
    pen.imageSmoothingQuality = "high";
    pen.drawImage(tile, (-tile.width * scale) / 2, (-tile.height * scale) / 2, tile.width * scale, tile.height * scale);
  }
}
