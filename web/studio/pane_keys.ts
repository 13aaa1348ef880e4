// Keys of a pane: moving, zooming, marking without a mouse.
import { drawing } from "./drawing";
import type { Measuring } from "./measuring";
import type { Model, Picture } from "./model";
import type { View } from "./view";

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1],
};
const STEP = 40;

/** What keys act on. */
export interface KeyedPane {
  readonly view: View;
  readonly model: Model;
  readonly measuring: Measuring;
  readonly picture: Picture;
  turn(by: number): void;
  fit(): void;
  zoom(factor: number): void;
  pan(du: number, dv: number): void;
  enter(): void;
  pointHere(): string | null;
}

/** Do the deed of a key; false where it has none here. */
export function paneKeys(pane: KeyedPane, event: KeyboardEvent): boolean {
  const arrow = ARROWS[event.key];
  if (arrow) return moved(pane, event, ...arrow);
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  switch (event.key) {
    case "+": case "=": pane.zoom(1.25); return true;
    case "-": pane.zoom(0.8); return true;
    case "0": pane.fit(); return true;
    case "1": pane.zoom(1 / pane.view.scale); return true;
    case "Enter": pane.enter(); return true;
    case "r": pane.turn(1); return true;
    case "Delete": case "Backspace": if (drawing.on) drawing.removeLast();
      else void pane.measuring.remove(pane.picture.id);
      return true;
    case "p": return chosen(pane);
    case "x": return rejected(pane);
    default: return false;
  }
}

function moved(pane: KeyedPane, event: KeyboardEvent, a: number, b: number): boolean {
  const { view } = pane;
  if (event.shiftKey || event.altKey) {
    const [dx, dy] = view.along(a, b);
    const size = event.altKey ? 0.01 : 0.1;
    pane.measuring.nudge(pane.picture.id, size * dx, size * dy);
    return true;
  }
  // the cross hair stays in the middle: it is the photograph that moves
  const step = event.ctrlKey || event.metaKey ? view.scale : STEP;
  pane.pan(-step * a, -step * b);
  return true;
}

function chosen(pane: KeyedPane): boolean {
  const point = pane.pointHere();
  if (point) pane.model.choose(point);
  else pane.model.say("studio_photo.no_point_here");
  return true;
}

function rejected(pane: KeyedPane): boolean {
  const point = pane.pointHere();
  if (point) void pane.measuring.reject(pane.picture.id, point);
  else pane.model.say("studio_photo.no_point_here");
  return true;
}
