// The studio: the parts of the page put together.
import { afterPause, element } from "./dom";
import { Decide } from "./decide";
import { drawing } from "./drawing";
import { Epochs } from "./epochs";
import { Fiducials } from "./fiducials";
import { Datum, Lines, Naming } from "./figures";
import { ImageList } from "./image_list";
import { ImageStage } from "./image_stage";
import { Journal } from "./journal";
import { help, keys } from "./keys";
import { Bars, Control } from "./known";
import { connect } from "./live";
import { looks } from "./looks";
import { Masks } from "./masks";
import { Measuring } from "./measuring";
import { Model } from "./model";
import { Panel } from "./panel";
import { Space } from "./space";
import { StandingLine } from "./standing";
import { Products } from "./products";
import { Status } from "./status";
import { isPair, isPoint, Tables } from "./tables";
import { Tabs } from "./tabs";
import { fillPage } from "./words";

async function start(): Promise<void> {
  fillPage();
  const model = new Model();
  const measuring = new Measuring(model);
  const status = new Status(model, measuring);
  const tabs = new Tabs();
  const stage = new ImageStage(model, measuring, (words) => status.pointer(words));
  const visit = (image: string, x: number, y: number) => {
    tabs.show("images");
    stage.visit(image, x, y);
  };
  new ImageList(model, (image, beside) => {
    tabs.show("images");
    stage.open(image, beside).body.focus();
  });
  const panel = new Panel(model, measuring, { visit });
  new StandingLine(model, (point, image) => {
    model.choose(point);
    void panel.goTo(point, image);
  });
  new Fiducials(model);
  new Bars(model);
  new Control(model);
  new Lines(model);
  new Datum(model);
  new Naming(model);
  new Masks(model, (image) => {
    tabs.show("images");
    (image ? stage.open(image) : stage.activePane)?.body.focus();
  });
  const space = new Space(model, (image) => {
    tabs.show("images");
    stage.open(image);
  });
  const tables = new Tables(model, () => tabs.now === "tables", (row) => {
    if (isPair(row)) {
      tabs.show("images");
      stage.open(row.image).body.focus();
      return void stage.open(row.other, true);
    }
    model.choose(row.point);
    if (!isPoint(row)) void panel.goTo(row.point, row.image);
  });
  const journal = new Journal(model, () => tabs.now === "journal");
  const decide = new Decide(model, () => tabs.now === "decide", {
    images: (image) => {
      tabs.show("images");
      if (image) stage.open(image).body.focus();
    },
    space: () => tabs.show("space"),
    visit: (point, image) => {
      model.choose(point);
      void panel.goTo(point, image);
    },
  });
  const products = new Products(model, () => tabs.now === "products");
  tabs.onopen("products", () => void products.show());
  const epochs = new Epochs(model, () => tabs.now === "epochs", (point) => {
    model.choose(point);
    void panel.goTo(point);
  });
  tabs.onopen("epochs", () => epochs.show());
  tabs.onopen("decide", () => decide.show());
  tabs.onopen("space", () => void space.show());
  tabs.onopen("tables", () => tables.show());
  tabs.onopen("journal", () => void journal.show());
  element("help").addEventListener("click", help);
  const focusPane = (deed: () => void) => () => {
    tabs.show("images");
    deed();
    stage.activePane?.body.focus();
  };
  keys({
    "?": help, n: focusPane(() => void measuring.newPoint()), w: () => void panel.worst(), v: () => panel.visitNext(),
    "ctrl z": () => void measuring.undo(), "ctrl shift z": () => void measuring.redo(), "ctrl y": () => void measuring.redo(),
    s: () => panel.nextSnap(), c: focusPane(() => stage.centre()), escape: () => escape(model, stage),
    g: focusPane(() => stage.setCount({ 1: 2, 2: 4 }[model.panes.length] ?? 1)),
    "[": () => stage.step(-1), "]": () => stage.step(1), f2: () => panel.typeName(),
  }, (on) => stage.toggleLoupe(on), () => looks.loupe);
  await begin(model, status);
  stage.activePane?.body.focus();
}

function escape(model: Model, stage: ImageStage): void {
  if (drawing.on) return drawing.end();
  if (document.activeElement !== stage.activePane?.body) stage.activePane?.body.focus();
  else model.choose("");
}

/** Read everything, then listen; read everything again when the connection comes back. */
async function begin(model: Model, status: Status): Promise<void> {
  try {
    await model.read();
  } catch (error) {
    model.fail(error);
    throw error;
  }
  const report = () => {
    if (model.overview.sigma0 !== null && !model.message.words) status.showResult("");
  };
  report();
  const again = afterPause(() => void model.read().then(report).catch(() => {}), 100);
  connect((message) => status.receive(message), (open, before) => {
    status.connection(open);
    // an adjustment that ended before the connection stood was reported to nobody
    if (open && (before || model.overview.sigma0 === null)) again();
  });
}

void start();
