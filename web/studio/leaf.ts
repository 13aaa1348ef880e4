// A leaf of the decisions, and where it can lead.
export interface Ways {
  /** Show the photographs, one of them in front. */
  images(image: string): void;
  space(): void;
  /** Go to a point in an image. */
  visit(point: string, image: string): void;
}

export interface Leaf {
  readonly root: HTMLElement;
  /** Read what it shows, anew. */
  show(): Promise<void>;
}
