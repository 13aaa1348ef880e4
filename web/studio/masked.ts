// What is masked in a photograph, laid over it half transparent: drawn polygons, and masks read from a folder.
import { ask, bytes } from "./api";
import { Corner, drawing } from "./drawing";
import { COLOUR } from "./looks";
import { Model, Picture } from "./model";
import { View } from "./view";

type Pen = CanvasRenderingContext2D;
interface Area {
  mask: string;
  polygon: Corner[];
}
const SHARE = 0.36;

class Masked {
  /** Image -> what was drawn there, as of a set of masks. */
  private readonly areas = new Map<string, { of: string; found: Area[] }>();
  private readonly pictures = new Map<string, ImageBitmap | null>();

  draw(pen: Pen, view: View, model: Model, picture: Picture, ratio: number): void {
    const read = this.picture(model, picture.id);
    if (read) {
      view.apply(pen, ratio);
      pen.imageSmoothingEnabled = false;
      pen.globalAlpha = SHARE;
      pen.drawImage(read, 0, 0, picture.width, picture.height);
      pen.globalAlpha = 1;
    }
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    for (const area of this.drawn(model, picture.id)) polygon(pen, view, area.polygon, true);
    if (!drawing.on || drawing.image !== picture.id) return;
    polygon(pen, view, drawing.corners, false);
    for (const [x, y] of drawing.corners) {
      const [u, v] = view.toScreen(x, y);
      pen.beginPath();
      pen.rect(u - 4, v - 4, 8, 8);
      pen.fillStyle = COLOUR.current;
      pen.fill();
      pen.lineWidth = 1.5;
      pen.strokeStyle = "#000000";
      pen.stroke();
    }
  }

  private drawn(model: Model, image: string): Area[] {
    const { masks } = model.state;
    if (!masks.length) return [];
    const here = masks.filter((m) => m.image === image);
    // one of a camera lies elsewhere in a file that is stored turned: the server knows where
    if (!masks.some((m) => m.camera && m.image !== image)) return here;
    const of = JSON.stringify(masks);
    const known = this.areas.get(image);
    if (known?.of === of) return known.found;
    this.areas.set(image, { of, found: here });
    void ask<{ areas: Area[] }>("/api/masks", { image }).then(({ areas }) => {
      this.areas.set(image, { of, found: areas });
      model.emit("looks");
    }, () => this.areas.delete(image));
    return here;
  }

  private picture(model: Model, image: string): ImageBitmap | null {
    if (!model.overview.masks_given) return null;
    const known = this.pictures.get(image);
    if (known !== undefined) return known;
    this.pictures.set(image, null);
    void bytes(`/api/mask?image=${encodeURIComponent(image)}`).then(async (body) => {
      if (!body.byteLength) return;
      this.pictures.set(image, await createImageBitmap(new Blob([body], { type: "image/png" })));
      model.emit("looks");
    }).catch(() => this.pictures.delete(image));
    return null;
  }
}

function polygon(pen: Pen, view: View, corners: Corner[], closed: boolean): void {
  pen.beginPath();
  corners.forEach(([x, y], k) => (k ? pen.lineTo(...view.toScreen(x, y)) : pen.moveTo(...view.toScreen(x, y))));
  pen.globalAlpha = SHARE;
  pen.fillStyle = COLOUR.masked;
  pen.fill("evenodd");
  pen.globalAlpha = 1;
  if (closed) pen.closePath();
  for (const [colour, width] of [["#000000b0", 3.2], [COLOUR.masked, 1.4]] as const) {
    pen.lineWidth = width;
    pen.strokeStyle = colour;
    pen.stroke();
  }
}

export const masked = new Masked();
