// What every three-dimensional page of ours draws: discs for points, pyramids for images, error ellipsoids.
import * as THREE from "three";

type Floats = Float32Array<ArrayBuffer>;

/** A round sprite. */
export function disc(): THREE.Texture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d")!;
  pen.fillStyle = "#fff";
  pen.beginPath();
  pen.arc(32, 32, 30, 0, 7);
  pen.fill();
  return new THREE.CanvasTexture(canvas);
}

export function positions(xyz: Floats): THREE.BufferGeometry {
  return new THREE.BufferGeometry().setAttribute("position", new THREE.BufferAttribute(xyz, 3));
}

/** Edges of the pyramids, each five positions: centre to corners, and corners to each other. */
export function edges(frusta: Float32Array): Floats {
  const pairs = [0, 1, 0, 2, 0, 3, 0, 4, 1, 2, 2, 3, 3, 4, 4, 1];
  const n = frusta.length / 15;
  const out = new Float32Array(n * pairs.length * 3);
  for (let i = 0; i < n; i++)
    pairs.forEach((corner, k) => {
      const from = 15 * i + 3 * corner;
      out.set(frusta.subarray(from, from + 3), 3 * (i * pairs.length + k));
    });
  return out;
}

export function ellipsoids(count: number): THREE.InstancedMesh {
  const made = new THREE.InstancedMesh(
    new THREE.SphereGeometry(1, 16, 12),
    new THREE.MeshLambertMaterial({ color: 0xb5532a, transparent: true, opacity: 0.45, depthWrite: false }),
    count,
  );
  made.frustumCulled = false;
  return made;
}

/** Draw ellipsoids this many times their 1 sigma size; the half axes are the rows of `axes`. */
export function enlarge(mesh: THREE.InstancedMesh, xyz: Float32Array, rows: Uint32Array, axes: Float32Array, factor: number): void {
  const m = new THREE.Matrix4();
  for (let k = 0; k < rows.length; k++) {
    const a = axes.subarray(9 * k, 9 * k + 9);
    const p = 3 * rows[k];
    // the half axes are the columns of the matrix
    m.set(
      a[0] * factor, a[3] * factor, a[6] * factor, xyz[p],
      a[1] * factor, a[4] * factor, a[7] * factor, xyz[p + 1],
      a[2] * factor, a[5] * factor, a[8] * factor, xyz[p + 2],
      0, 0, 0, 1,
    );
    mesh.setMatrixAt(k, m);
  }
  mesh.instanceMatrix.needsUpdate = true;
}

/** Row of the position (every `stride` numbers) nearest to a place on the canvas, within some px, among those that are shown; null: none is. */
export function nearest(
  xyz: Float32Array, stride: number, camera: THREE.Camera, box: { width: number; height: number }, at: [number, number],
  within = 9, shown: (x: number, y: number, z: number) => boolean = () => true,
): number | null {
  // one matrix for all: a hundred thousand points take a millisecond or two
  const e = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  let best: number | null = null;
  let least = within * within;
  for (let k = 0; k < xyz.length; k += stride) {
    const x = xyz[k];
    const y = xyz[k + 1];
    const z = xyz[k + 2];
    const w = e[3] * x + e[7] * y + e[11] * z + e[15];
    if (w <= 0) continue;
    const u = (((e[0] * x + e[4] * y + e[8] * z + e[12]) / w + 1) / 2) * box.width - at[0];
    const v = ((1 - (e[1] * x + e[5] * y + e[9] * z + e[13]) / w) / 2) * box.height - at[1];
    const d = u * u + v * v;
    if (d < least && shown(x, y, z)) {
      least = d;
      best = k / stride;
    }
  }
  return best;
}
