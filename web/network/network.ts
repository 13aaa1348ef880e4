// The network in three dimensions: turn, zoom, pick a point or an image and see its rays.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { nearest } from "../common/shapes";
import { byRays, byRole, bySigma, bySurface, Colouring, ofCloud } from "./colours";
import { Network, Packed, ROLES } from "./data";
import { Drawn } from "./scene";

const element = <T extends HTMLElement>(id: string) => document.getElementById(id) as T;

function start(): void {
  const net = new Network(JSON.parse(element("network-data").textContent!) as Packed);
  const stage = element<HTMLDivElement>("stage");
  let renderer: THREE.WebGLRenderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  } catch {
    stage.textContent = net.say("no_graphics");
    return;
  }
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  stage.append(renderer.domElement);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xf7f5f0);
  // mostly from all sides, so that colours are those of the legend; the rest from where one looks
  scene.add(new THREE.AmbientLight(0xffffff, 0.75 * Math.PI));
  const lamp = new THREE.DirectionalLight(0xffffff, 0.25 * Math.PI);
  scene.add(lamp, lamp.target);
  const drawn = new Drawn(net);
  scene.add(...drawn.all());

  const { extent, basis } = net.packed;
  const axis = (k: number) => new THREE.Vector3(basis[3 * k], basis[3 * k + 1], basis[3 * k + 2]);
  const camera = new THREE.PerspectiveCamera(40, 1, extent / 1000, extent * 200);
  camera.up.copy(axis(2));
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.zoomToCursor = true;
  const home = () => {
    const far = Math.max(extent, FITTING * reachOf(net.frustaOf(net.proposed)));
    camera.position.set(0, 0, 0).addScaledVector(axis(1), 1.35 * far).addScaledVector(axis(2), 0.45 * far)
      .addScaledVector(axis(0), 0.4 * far);
    controls.target.set(0, 0, 0);
    controls.update();
  };
  const render = () => {
    lamp.position.copy(camera.position);
    lamp.target.position.copy(controls.target);
    renderer.render(scene, camera);
  };
  const size = () => {
    renderer.setSize(stage.clientWidth, stage.clientHeight);
    camera.aspect = stage.clientWidth / Math.max(stage.clientHeight, 1);
    camera.updateProjectionMatrix();
    render();
  };
  controls.addEventListener("change", render);
  addEventListener("resize", size);

  panel(net, drawn, render, home);
  picking(net, drawn, camera, renderer.domElement, render);
  home();
  size();
}

// of the farthest proposed photograph's distance: then it is seen from the first view, behind which it could stand else
const FITTING = 1.8;

/** Largest distance of corners from the middle. */
function reachOf(corners: Float32Array): number {
  let far = 0;
  for (let k = 0; k < corners.length; k += 3) far = Math.max(far, Math.hypot(corners[k], corners[k + 1], corners[k + 2]));
  return far;
}

function panel(net: Network, drawn: Drawn, render: () => void, home: () => void): void {
  const choices: Record<string, Colouring | null> = { role: byRole(net), rays: byRays(net), sigma: bySigma(net) };
  const select = element<HTMLSelectElement>("colouring");
  if (!choices.sigma) select.querySelector('option[value="sigma"]')!.remove();
  const surface = bySurface(net);
  if (surface) {
    drawn.colourSurface(surface.rgb);
    choices.surface = { rgb: choices.rays!.rgb, legend: surface.legend };
    select.value = "surface";
  } else {
    select.querySelector('option[value="surface"]')!.remove();
    if (net.proposed.length && choices.sigma) select.value = "sigma";
  }
  const colour = () => {
    const chosen = choices[select.value]!;
    drawn.colour(chosen.rgb, choices.role!.rgb);
    legend("legend", chosen);
    render();
  };
  select.addEventListener("change", colour);
  colour();
  cloudPanel(net, drawn, render);

  const shown: [string, THREE.Object3D[], number][] = [
    ["show-points", [drawn.points], net.points],
    ["show-images", [drawn.frames], net.images - net.proposed.length],
    ["show-proposals", [drawn.proposals], net.proposed.length],
    ["show-surface", [drawn.surface], net.surface.length],
    ["show-cloud", [drawn.cloud], net.cloudImage.length],
    ["show-known", [drawn.special], net.role.some((r) => r > 0) ? 1 : 0],
    ["show-bars", [drawn.bars], net.bars.length],
    ["show-ellipsoids", [drawn.ellipsoids], net.ellipsoid.length],
  ];
  for (const [id, objects, count] of shown) {
    const box = element<HTMLInputElement>(id);
    if (!count) box.closest("label")!.remove();
    const apply = () => {
      objects.forEach((o) => (o.visible = box.checked));
      render();
    };
    box.addEventListener("change", apply);
    apply();
  }

  const slider = element<HTMLInputElement>("enlarged");
  if (!net.ellipsoid.length) slider.closest("label")!.remove();
  const start = net.packed.ellipsoids.enlarged;
  const scale = () => {
    const factor = start * 10 ** (Number(slider.value) / 10);
    drawn.enlarge(factor);
    element("enlarged-words").textContent = `${Number(factor.toPrecision(2)).toLocaleString(document.documentElement.lang)} ×`;
    render();
  };
  slider.addEventListener("input", scale);
  if (net.ellipsoid.length) scale();
  element("home").addEventListener("click", () => {
    home();
    render();
  });
}

/** What the colours say. */
function legend(id: string, chosen: Colouring): void {
  element(id).replaceChildren(
    ...chosen.legend.map(([hex, words]) => {
      const item = document.createElement("li");
      if (hex) {
        const dot = document.createElement("span");
        dot.style.background = hex;
        item.append(dot);
      }
      item.append(words);
      return item;
    }),
  );
}

/** The choice of the dense points' colours; nothing of it where there are none. */
function cloudPanel(net: Network, drawn: Drawn, render: () => void): void {
  const select = element<HTMLSelectElement>("cloud-colouring");
  if (!net.cloudImage.length) {
    select.closest("fieldset")!.remove();
    return;
  }
  const choices = ofCloud(net);
  if (!choices.sigma) select.querySelector('option[value="sigma"]')!.remove();
  const colour = () => {
    drawn.colourCloud(choices[select.value]!.rgb);
    legend("cloud-legend", choices[select.value]!);
    render();
  };
  select.addEventListener("change", colour);
  // tie points would hide what lies between them
  element<HTMLInputElement>("show-points").checked = false;
  colour();
}

function picking(net: Network, drawn: Drawn, camera: THREE.Camera, canvas: HTMLCanvasElement, render: () => void): void {
  let down = [0, 0];
  canvas.addEventListener("pointerdown", (e) => (down = [e.clientX, e.clientY]));
  canvas.addEventListener("pointerup", (e) => {
    if (Math.hypot(e.clientX - down[0], e.clientY - down[1]) > 4) return;
    const box = canvas.getBoundingClientRect();
    const at: [number, number] = [e.clientX - box.left, e.clientY - box.top];
    const point = drawn.points.visible ? nearest(net.xyz, 3, camera, box, at) : null;
    const image = drawn.frames.visible || drawn.proposals.visible ? nearest(net.frusta, 15, camera, box, at) : null;
    const told = element("picked");
    // the image's centre is the smaller aim: it goes first where both are near
    if (image !== null) {
      drawn.selectImage(image);
      const words = net.packed.images.words?.[image];
      told.textContent = `${net.say("image")} ${net.packed.images.id[image]}${words ? `\n${words}` : ""}`;
    } else if (point !== null) {
      drawn.select(point);
      told.textContent = pointWords(net, point);
    } else {
      drawn.select(null);
      told.textContent = net.say("click");
    }
    render();
  });
}

function pointWords(net: Network, point: number): string {
  const { unit, sigmaUnit } = net.packed;
  const s = [0, 1, 2].map((a) => net.sigma[3 * point + a]);
  const lines = [
    `${net.say(`${ROLES[Math.min(net.role[point], 2)]}_point`)} ${net.packed.points.id[point]}`,
    `X, Y, Z  ${net.coordinates(point)} ${unit}`,
    s.every((v) => v >= 0) ? `${net.say("sigma")}    ${net.listed(s.map((v) => v.toPrecision(2)))} ${sigmaUnit}` : "",
    `${net.rays[point]} ${net.say("rays")}: ${[...net.imagesOf(point)].map((i) => net.packed.images.id[i]).join(", ")}`,
  ];
  return lines.filter((l) => l).join("\n");
}

start();
