// How photographs and their image points are shown, the same in all panes.
import { SnapKind } from "./types";

export type Filter = "all" | "none" | "rejected" | "weak" | "control" | "worst";

export interface Looks {
  brightness: number;
  contrast: number;
  /** Length on the screen of a residual of 1 px [CSS px]. */
  vectors: number;
  filter: Filter;
  loupe: boolean;
  linked: boolean;
  snap: SnapKind;
}

export const looks: Looks = {
  brightness: 1, contrast: 1, vectors: 40, filter: "worst", loupe: false, linked: true, snap: "auto",
};

export const SNAPS: SnapKind[] = ["auto", "ellipse", "corner", "cross", "patch", "hand"];

/** Okabe and Ito 2008: distinct to all eyes; each has a shape of its own beside. */
export const COLOUR = {
  used: "#56b4e9", weak: "#e69f00", rejected: "#d55e00", control: "#f0e442", check: "#2fc79a", mark: "#f5a3cf",
  current: "#ffffff", predicted: "#f0e442", beyond: "#ff5ad1", masked: "#ff7f2a",
  off: "#ff3b30",
};

export const photoFilter = (): string =>
  looks.brightness === 1 && looks.contrast === 1 ? "none" : `brightness(${looks.brightness}) contrast(${looks.contrast})`;
