// A photograph drawn from tiles: the level that fits the scale, coarser ones until it is there.
import { Picture } from "./model";
import { lastLevel, SIDE, tileKey, tiles } from "./tiles";
import { View } from "./view";

/** Draw what is there; returns the keys of the tiles that are needed, the coarsest first. */
export function drawPhoto(pen: CanvasRenderingContext2D, view: View, picture: Picture, ratio: number, moved: [number, number] = [0, 0]): string[] {
  const last = lastLevel(picture.width, picture.height);
  const level = Math.min(Math.max(Math.floor(-Math.log2(view.scale * ratio) + 0.25), 0), last);
  view.apply(pen, ratio, moved);
  pen.imageSmoothingEnabled = view.scale * ratio < 4;
  pen.imageSmoothingQuality = "high";
  pen.save();
  pen.beginPath();
  pen.rect(0, 0, picture.width, picture.height);
  pen.clip();
  const coarse = tileKey(picture.k, last, 0, 0);
  const ground = tiles.get(coarse);
  if (ground) pen.drawImage(ground, 0, 0, ground.width * 2 ** last, ground.height * 2 ** last);
  const needed = [coarse];
  if (level < last) needed.push(...drawLevel(pen, view, picture, level, last));
  pen.restore();
  return needed;
}

function drawLevel(pen: CanvasRenderingContext2D, view: View, picture: Picture, level: number, last: number): string[] {
  const side = SIDE * 2 ** level;
  const [left, top, right, bottom] = view.seen();
  const needed: [number, string][] = [];
  for (let row = Math.floor(top / side); row * side < bottom; row++)
    for (let column = Math.floor(left / side); column * side < right; column++) {
      const key = tileKey(picture.k, level, column, row);
      const far = Math.hypot((column + 0.5) * side - view.x, (row + 0.5) * side - view.y);
      needed.push([far, key]);
      const tile = tiles.get(key);
      if (tile) pen.drawImage(tile, column * side, row * side, tile.width * 2 ** level, tile.height * 2 ** level);
      else drawCoarser(pen, picture.k, level, column, row, last);
    }
  return needed.sort((a, b) => a[0] - b[0]).map(([, key]) => key);
}

/** The part of a coarser tile that stands for one that is not there yet. */
function drawCoarser(pen: CanvasRenderingContext2D, k: number, level: number, column: number, row: number, last: number): void {
  for (let up = 1; level + up < last; up++) {
    const tile = tiles.get(tileKey(k, level + up, column >> up, row >> up));
    if (!tile) continue;
    const part = SIDE >> up;
    const x = (column & ((1 << up) - 1)) * part;
    const y = (row & ((1 << up) - 1)) * part;
    const w = Math.min(part, tile.width - x);
    const h = Math.min(part, tile.height - y);
    const side = SIDE * 2 ** level;
    const size = 2 ** (level + up);
    if (w > 0 && h > 0) pen.drawImage(tile, x, y, w, h, column * side, row * side, w * size, h * size);
    return;
  }
}
