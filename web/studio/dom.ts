// Elements by hand: texts are always text, never markup.
import { say, titleOf, Values } from "./words";

export const element = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;

type Value = string | number | boolean | ((event: never) => void);

/** An element with attributes, `on...` listeners and children; true sets an empty attribute, false leaves it out. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, Value> = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value as EventListener);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false) made.setAttribute(name, String(value));
  }
  made.append(...children);
  return made;
}

/** A button that shows a sign or a name; its title is in words. */
export const sign = (shown: string, title: string, press: () => void, kind = ""): HTMLButtonElement =>
  h("button", { type: "button", title, class: kind, onclick: press }, shown);

/** A button with the words of a code and their title. */
export const button = (code: string, press: () => void, kind = "", values: Values = {}): HTMLButtonElement =>
  sign(say(code, values), titleOf(code, values), press, kind);

/** The head of a table, a code for each column; `left`: columns of text. */
export const heads = (codes: string[], left: number[] = []): HTMLElement =>
  h("thead", {}, h("tr", {}, ...codes.map((code, k) =>
    h("th", { scope: "col", class: left.includes(k) ? "l" : "", title: titleOf(code) }, code && say(code)))));

/** A choice by words: values and what is shown of each. */
export const choices = (values: readonly string[], shown: (value: string) => string, chosen = ""): HTMLOptionElement[] =>
  values.map((value) => h("option", { value, selected: value === chosen }, shown(value)));

/** Whether what is typed goes into a field. */
export function typing(target: EventTarget | null): boolean {
  if (target instanceof HTMLInputElement) return !["checkbox", "range", "radio", "button", "file"].includes(target.type);
  return target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;
}

/** A call at most once a frame. */
export function onceAFrame(call: () => void): () => void {
  let pending = false;
  return () => {
    if (pending) return;
    pending = true;
    requestAnimationFrame(() => {
      pending = false;
      call();
    });
  };
}

/** A call at once where the page is seen, else once when it is: three hundred tabs behind another ask nothing. */
export function whenSeen(call: () => void): () => void {
  let pending = false;
  return () => {
    if (!document.hidden) return call();
    if (pending) return;
    pending = true;
    document.addEventListener("visibilitychange", () => {
      pending = false;
      call();
    }, { once: true });
  };
}

/** A call when nothing new was asked for some time. */
export function afterPause(call: () => void, ms: number): () => void {
  let timer = 0;
  return () => {
    clearTimeout(timer);
    timer = window.setTimeout(call, ms);
  };
}
