// How far the photographs are oriented, what the next one needs, and marks that contradict the others.
import { element, h, sign } from "./dom";
import { Model } from "./model";
import { say } from "./words";

export class StandingLine {
  constructor(private readonly model: Model, private readonly goTo: (point: string, image: string) => void) {
    model.on("overview", () => this.show());
  }

  private show(): void {
    const { standing } = this.model.overview;
    const open = standing.oriented < standing.images || standing.wrong.length > 0 || standing.words.length > 0;
    const box = element("standing");
    box.hidden = !open;
    if (!open) return;
    const wrong = new Set(standing.wrong.map((w) => w.words));
    // what has begun comes first; photographs in which nothing is marked are in the list below
    const bare = new Set(standing.lacking.filter((l) => l.kind === "marks" && !l.have).map((l) => l.words));
    const words = standing.words.filter((line) => !wrong.has(line) && !bare.has(line));
    box.replaceChildren(
      h("p", { id: "standing-line", class: standing.oriented < standing.images ? "open" : "" }, standing.line.join("; ")),
      h("ul", {},
        ...standing.wrong.map((w) => h("li", { class: "wrong" },
          sign(w.words, say("studio_point.show", { point: w.point }), () => this.goTo(w.point, w.images[0]), "link"))),
        ...words.map((line) => h("li", {}, line))),
    );
  }
}
