// All keys of the page in one table, and what they do.
import { button, element, h, typing } from "./dom";
import { say } from "./words";

export interface Deeds {
  [name: string]: () => void;
}

/** Keys and their deeds; those of a photograph are done by its pane.  A key of several letters has words, too. */
const TABLE: [group: string, [key: string, deed: string][]][] = [
  ["studio_keys.anywhere", [
    ["N", "studio_keys.new_point"], ["V", "studio_keys.next_image"], ["W", "studio_keys.worst"], ["studio_keys.ctrl_z", "studio_keys.undo"],
    ["studio_keys.ctrl_shift_z", "studio_keys.redo"], ["S", "studio_keys.snap"], ["L", "studio_keys.loupe"], ["C", "studio_keys.centre"],
    ["G", "studio_keys.panes"], ["[  ]", "studio_keys.neighbour"], ["Esc", "studio_keys.no_point"], ["F2", "studio_keys.name"], ["?", "studio_keys.this_table"],
  ]],
  ["studio_keys.in_photograph", [
    ["studio_keys.arrows", "studio_keys.hair"], ["Enter", "studio_keys.mark"], ["studio_keys.shift_arrows", "studio_keys.move"],
    ["studio_keys.delete", "studio_keys.remove"], ["P", "studio_keys.choose"], ["X", "studio_keys.reject"], ["studio_keys.of_mask", "studio_keys.mask"],
    ["+  -", "studio_keys.zoom"], ["0", "studio_keys.whole"], ["1", "studio_keys.pixels"], ["R", "studio_keys.turn"],
  ]],
  ["studio_keys.by_mouse", [
    ["studio_keys.click", "studio_keys.click_deed"], ["studio_keys.ctrl_click", "studio_keys.choose"], ["studio_keys.drag", "studio_keys.drag_deed"],
    ["studio_keys.wheel", "studio_keys.zoom"], ["studio_keys.shift_click", "studio_keys.beside"],
  ]],
];

export function help(): void {
  const box = element<HTMLDialogElement>("keys");
  if (box.open) return box.close();
  box.replaceChildren(
    h("h2", { id: "keys-head" }, say("studio_keys.title")),
    h("div", { class: "keys" }, ...TABLE.map(([group, rows]) => h("section", {}, h("h3", {}, say(group)), h("dl", {},
      ...rows.flatMap(([key, deed]) => [h("dt", {}, h("kbd", {}, say(key))), h("dd", {}, say(deed))]))))),
    button("studio_keys.close", () => box.close(), "main"),
  );
  box.showModal();
}

/** Let keys do their deeds, wherever nothing is typed. */
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
