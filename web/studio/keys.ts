// All keys of the page in one table: what is told in the help is what is done.
import { button, element, h, typing } from "./dom";

export interface Deeds {
  [name: string]: () => void;
}

/** Keys that are told of; those of a photograph are done by its pane. */
const TOLD: [string, [string, string][]][] = [
  ["Anywhere", [
    ["N", "new point"], ["V", "next image where the current point is visible, not measured"], ["W", "worst next"],
    ["Ctrl Z", "undo"], ["Ctrl Shift Z", "redo"], ["S", "next way of snapping"], ["L", "loupe: held, or pressed once"],
    ["C", "centre all panes on the current point"], ["G", "1, 2 or 4 images"], ["[  ]", "image before, image behind"],
    ["Esc", "no current point"], ["F2", "type the name of a point"], ["?", "this table"],
  ]],
  ["In a photograph", [
    ["Arrow keys", "move the cross hair; with Ctrl 1 px"], ["Enter", "mark the current point at the cross hair"],
    ["Shift and arrows", "move the mark of the current point by 0.1 px; with Alt 0.01 px"], ["Delete", "remove the mark"],
    ["P", "choose the image point here"], ["X", "reject the image observation here, or accept it again"],
    ["Enter, Delete, Esc", "while a mask is drawn: one corner more at the cross hair, the last one back, no mask"],
    ["+  -", "zoom"], ["0", "whole photograph"], ["1", "pixel by pixel"], ["R", "turn"],
  ]],
  ["By mouse", [
    ["Click", "mark the current point; on a mark: choose it"], ["Ctrl click", "choose the image point there"],
    ["Drag", "move the photograph, or a mark"], ["Wheel", "zoom"], ["Shift click in the list", "open the image beside"],
  ]],
];

export function help(): void {
  const box = element<HTMLDialogElement>("keys");
  if (box.open) return box.close();
  box.replaceChildren(
    h("h2", { id: "keys-head" }, "Keys"),
    h("div", { class: "keys" }, ...TOLD.map(([where, rows]) => h("section", {}, h("h3", {}, where), h("dl", {},
      ...rows.flatMap(([key, words]) => [h("dt", {}, h("kbd", {}, key)), h("dd", {}, words)]))))),
    button("Close", "Close this table (Esc)", () => box.close(), "main"),
  );
  box.showModal();
}

/** Let keys do what they say, wherever nothing is typed. */
export function keys(deeds: Deeds, loupe: (on: boolean) => void, loupeOn: () => boolean): void {
  let held = 0;
  let before = false;
  addEventListener("keydown", (event) => {
    if (element<HTMLDialogElement>("keys").open && event.key !== "?") return;
    const ctrl = event.ctrlKey || event.metaKey;
    if (typing(event.target) && event.key !== "Escape" && event.key !== "F2") return;
    if (!ctrl && !event.altKey && event.key.toLowerCase() === "l") {
      if (!event.repeat) {
        held = performance.now();
        before = loupeOn();
        loupe(true);
      }
      return event.preventDefault();
    }
    const name = `${ctrl ? "ctrl " : ""}${ctrl && event.shiftKey ? "shift " : ""}${event.key.toLowerCase()}`;
    const deed = event.altKey ? undefined : deeds[name];
    if (!deed) return;
    event.preventDefault();
    deed();
  });
  addEventListener("keyup", (event) => {
    if (event.key.toLowerCase() !== "l" || !held) return;
    // held: only while it is held; pressed once: on or off
    if (performance.now() - held > 350) loupe(false);
    else loupe(!before);
    held = 0;
  });
}
