// Object space: turn, zoom, choose a point or a station, measure between points.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { nearest } from "../common/shapes";
import { bytes } from "./api";
import { beyond } from "./beyond";
import { afterPause, element, h, onceAFrame } from "./dom";
import { Model } from "./model";
import { short, withUnit } from "./numbers";
import { SpaceBar } from "./space_bar";
import { SpaceData } from "./space_data";
import { SpaceMeasure } from "./space_measure";
import { SpacePairs } from "./space_pairs";
import { SpaceScene } from "./space_scene";
import { SpaceSection } from "./space_section";
import { say } from "./words";

const NEAR_PX = 10;
/** Time that a picture of a motion should take [ms]. */
const PICTURE_MS = 33;
/** Points that a processor draws in about that time: the first share of a motion. */
const AT_FIRST = 30_000;
/** Pixels of a picture that a processor does not make in time. */
const LARGE_PX = 1.5e6;

/** Whether pictures are made by the processor: their edges are not smoothed then, which is the greater part of the work. */
function drawnBySoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl ? String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class Space {
  private readonly box = element("space");
  private readonly status = element("space-status");
  private readonly tip = h("div", { class: "tip", hidden: true });
  private readonly bar: SpaceBar;
  private readonly measure: SpaceMeasure;
  private readonly pairs: SpacePairs;
  private readonly section: SpaceSection;
  private renderer: THREE.WebGLRenderer | null = null;
  private controls!: OrbitControls;
  private readonly camera = new THREE.PerspectiveCamera(40, 1, 0.01, 1000);
  private drawn: SpaceScene | null = null;
  private stale = true;
  private readonly frameSoon = onceAFrame(() => this.frame());
  /** Share of the points that is drawn while it is turned. */
  private share = 1;
  private software = false;
  private coarse = false;
  private turning = false;
  private timed = false;
  private readonly rest = afterPause(() => this.still(), 250);

  constructor(private readonly model: Model, private readonly open: (image: string) => void) {
    this.bar = new SpaceBar(() => this.shown(), () => this.home());
    this.measure = new SpaceMeasure(model, () => this.measured());
    this.pairs = new SpacePairs(() => this.shown());
    this.section = new SpaceSection(() => this.measure.names, () => this.cut());
    element("space-bar").append(...this.bar.parts, ...this.measure.parts, ...this.pairs.parts, ...this.section.parts);
    model.on("read", () => {
      this.stale = true;
      if (!element("stage-space").hidden) void this.show();
    });
    beyond.onchange(() => this.far());
    model.on(["current", "prediction", "state"], () => this.current());
  }

  async show(): Promise<void> {
    if (!this.renderer && !this.begin()) return;
    if (this.stale) {
      this.stale = false;
      try {
        this.take(new SpaceData(await bytes("/api/scene")));
      } catch (error) {
        this.stale = true;
        return this.model.fail(error);
      }
    }
    this.sized();
  }

  private begin(): boolean {
    this.software = drawnBySoftware();
    try {
      this.renderer = new THREE.WebGLRenderer({ antialias: !this.software });
    } catch {
      this.box.textContent = say("studio_space.no_graphics");
      return false;
    }
    this.renderer.localClippingEnabled = true;
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.setAttribute("aria-label", say("studio_space.canvas"));
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.box.append(canvas, this.tip);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.moving());
    new ResizeObserver(() => this.sized()).observe(this.box);
    this.pointers(canvas);
    return true;
  }

  private take(data: SpaceData): void {
    const first = !this.drawn;
    this.drawn?.dispose();
    this.drawn = new SpaceScene(data, this.pairs.lines);
    this.measure.take(data);
    this.pairs.take(data);
    this.section.take(data);
    const { extent } = data.head;
    this.camera.near = extent / 1000;
    this.camera.far = extent * 200;
    this.bar.typical = this.drawn.typical;
    if (first) this.share = this.software ? Math.min(AT_FIRST / Math.max(data.points, 1), 1) : 1;
    if (first) this.home();
    this.shown();
    this.current();
    this.far();
    this.status.textContent = data.points < data.head.total ? say("studio_space.points_shown", { n: data.points, of: data.head.total }) : say("studio_space.click");
  }

  private axis(k: number): THREE.Vector3 {
    return new THREE.Vector3(...this.drawn!.data.head.basis.slice(3 * k, 3 * k + 3));
  }

  home(): void {
    if (!this.drawn) return;
    const { extent } = this.drawn.data.head;
    this.camera.up.copy(this.axis(2));
    this.camera.position.set(0, 0, 0).addScaledVector(this.axis(1), 1.35 * extent).addScaledVector(this.axis(2), 0.45 * extent)
      .addScaledVector(this.axis(0), 0.4 * extent);
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.render();
  }

  private sized(): void {
    const { clientWidth: w, clientHeight: height } = this.box;
    if (!this.renderer || !w || !height) return;
    this.renderer.setSize(w, height);
    this.camera.aspect = w / height;
    this.camera.updateProjectionMatrix();
    this.frame();
  }

  /** The next picture; where one of all points takes long, one of some comes first. */
  private render(): void {
    if (this.share < 1) {
      this.drawn?.thin(this.share);
      this.rest();
    }
    this.frameSoon();
  }

  private frame(): void {
    if (!this.renderer || !this.drawn || element("stage-space").hidden) return;
    this.renderer.render(this.drawn.scene, this.camera);
    if (this.turning) this.timing();
  }

  /** The next picture of a motion, of as many points as are drawn in time. */
  private moving(): void {
    const large = this.box.clientWidth * this.box.clientHeight > LARGE_PX;
    if (this.software && large && !this.coarse) this.fine(false);
    this.turning = true;
    this.render();
    this.rest();
  }

  /** Let the share of points follow the time that a picture takes: until the graphics card, or the processor, has it done. */
  private timing(): void {
    const gl = this.renderer!.getContext() as WebGL2RenderingContext;
    const done = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!done) return;
    if (this.timed) return gl.deleteSync(done);
    this.timed = true;
    const began = performance.now();
    gl.flush();
    const look = () => {
      if (gl.getSyncParameter(done, gl.SYNC_STATUS) !== gl.SIGNALED) return void setTimeout(look, 4);
      gl.deleteSync(done);
      this.timed = false;
      const wanted = PICTURE_MS / Math.max(performance.now() - began, 1);
      this.share = Math.min(Math.max(this.share * Math.min(Math.max(wanted, 0.25), 1.25), 0.005), 1);
    };
    setTimeout(look, 4);
  }

  /** Every pixel of the screen, or a quarter of them. */
  private fine(on: boolean): void {
    this.coarse = !on;
    this.renderer!.setPixelRatio(on ? Math.min(devicePixelRatio, 2) : 0.5);
  }

  private still(): void {
    this.turning = false;
    this.drawn?.thin(1);
    if (this.coarse) this.fine(true);
    this.frameSoon();
  }

  // --- what is shown --------------------------------------------------------------------------------

  private shown(): void {
    const { drawn, bar } = this;
    if (!drawn) return;
    const legend = drawn.colour(bar.colouring);
    drawn.points.visible = bar.shows("points");
    drawn.stations.visible = bar.shows("stations");
    drawn.ellipsoids.visible = bar.shows("ellipsoids");
    drawn.bars.visible = bar.shows("bars");
    if (drawn.ellipsoids.visible) drawn.enlarge(bar.enlarged);
    legend.push(...this.pairs.legend);
    if (beyond.points.size) legend.push(["#c2188f", say("studio_space.beyond", { n: beyond.points.size })]);
    element("space-legend").replaceChildren(...legend.map(([hex, words]) => {
      const dot = h("span", { class: "dot" });
      dot.style.background = hex;
      return h("li", {}, dot, words);
    }));
    this.render();
  }

  private cut(): void {
    this.section.show();
    this.drawn?.cut(this.section.planes);
    this.render();
  }

  private current(): void {
    const { drawn, model } = this;
    if (!drawn) return;
    const row = drawn.data.rowOf(model.current);
    const found = model.prediction?.point === model.current ? model.prediction?.located.xyz : null;
    const at = found ? found.map((v, k) => v - drawn.data.head.origin[k]) : row === undefined ? null : drawn.data.at(row);
    drawn.current(model.current ? at : null, model.marksOf(model.current).map((m) => m.image));
    this.render();
  }

  private far(): void {
    if (!this.drawn) return;
    this.drawn.far([...beyond.points].map((n) => this.drawn!.data.rowOf(n)).filter((r) => r !== undefined));
    this.shown();
  }

  private measured(): void {
    if (!this.drawn) return;
    const rows = this.measure.names.map((n) => this.drawn!.data.rowOf(n)).filter((r) => r !== undefined);
    this.drawn.between(rows, this.measure.closed);
    this.section.measured();
    if (this.measure.words) this.status.textContent = this.measure.words;
    this.render();
  }

  // --- hand and keys ----------------------------------------------------------------------------------

  private pointers(canvas: HTMLCanvasElement): void {
    let down = [0, 0];
    let pressed = false;
    const at = (event: PointerEvent): [number, number] => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      down = [event.clientX, event.clientY];
      pressed = true;
      this.tip.hidden = true;
    });
    canvas.addEventListener("pointerup", (event) => {
      pressed = false;
      if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) this.click(at(event));
    });
    let last: [number, number] = [0, 0];
    const hover = onceAFrame(() => this.hover(last));
    canvas.addEventListener("pointermove", (event) => {
      last = at(event);
      if (!pressed) hover();
    });
    canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** Point or station near a place; the station is the smaller aim and goes first. */
  private find(at: [number, number]): { image?: string; row?: number } {
    const { drawn, box } = this;
    if (!drawn) return {};
    const size = { width: box.clientWidth, height: box.clientHeight };
    const within = (x: number, y: number, z: number) => this.section.holds(x, y, z);
    const image = drawn.stations.visible ? nearest(drawn.data.centre, 3, this.camera, size, at, NEAR_PX) : null;
    if (image !== null) return { image: drawn.data.head.image_ids[image] };
    const row = drawn.points.visible ? nearest(drawn.data.xyz, 3, this.camera, size, at, NEAR_PX, within) : null;
    return row === null ? {} : { row };
  }

  private hover(at: [number, number]): void {
    const { image, row } = this.find(at);
    this.tip.hidden = image === undefined && row === undefined;
    if (this.tip.hidden) return;
    this.tip.textContent = image ?? this.words(row!);
    this.tip.style.left = `${Math.min(at[0] + 16, this.box.clientWidth - 230)}px`;
    this.tip.style.top = `${Math.min(at[1] + 14, this.box.clientHeight - 70)}px`;
  }

  private words(row: number): string {
    const { data } = this.drawn!;
    const unit = data.head.unit;
    return say("studio_space.point", {
      name: data.nameOf(row) || "none", n: data.rays[row], sigma: data.sigma[row] > 0 ? withUnit(short(data.sigma[row], 2), unit) : "none",
      w: data.w[row] >= 0 ? short(data.w[row], 2) : "none",
    });
  }

  private click(at: [number, number]): void {
    const { image, row } = this.find(at);
    if (image !== undefined && !this.measure.on) return this.open(image);
    if (row === undefined) return;
    const name = this.drawn!.data.nameOf(row);
    if (!name) return;
    if (this.measure.on) this.measure.add(name);
    else {
      this.model.choose(name);
      this.status.textContent = this.words(row);
    }
  }

  private key(event: KeyboardEvent): void {
    const turns: Record<string, [number, number]> = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const turn = turns[event.key];
    if (turn) this.turn(0.1 * turn[0], 0.1 * turn[1]);
    else if (event.key === "+" || event.key === "=") this.closer(0.85);
    else if (event.key === "-") this.closer(1.18);
    else if (event.key === "0") this.home();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private turn(about: number, over: number): void {
    const { target } = this.controls;
    const from = this.camera.position.clone().sub(target);
    const up = this.camera.up.clone().normalize();
    from.applyAxisAngle(up, -about);
    const side = up.clone().cross(from).normalize();
    const tilted = from.clone().applyAxisAngle(side, -over);
    // not over the pole
    if (tilted.clone().cross(up).length() > 0.05 * tilted.length()) from.copy(tilted);
    this.camera.position.copy(target).add(from);
    this.controls.update();
  }

  private closer(factor: number): void {
    const { target } = this.controls;
    this.camera.position.sub(target).multiplyScalar(factor).add(target);
    this.controls.update();
  }
}
