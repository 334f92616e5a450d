// The view in space (three.js): one shape coloured by one field, lines, block, and a camera for mouse, touch and keys.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  DoubleSide,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  NearestFilter,
  PerspectiveCamera,
  Points,
  Raycaster,
  Scene,
  ShaderMaterial,
  Vector2,
  Vector3,
  WebGLRenderer
} from 'three';
import {colourOf, palette} from './colour.js';

const MISSING = 1e36; // a value that is not there; interpolated with a real one it still stands out
const TABLE = 1024;

const VERTEX = `
attribute float value;
uniform float size;
varying float v;
varying vec3 place;
void main() {
  v = value;
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  place = seen.xyz;
  gl_Position = projectionMatrix * seen;
  gl_PointSize = size;
}`;
const FRAGMENT = `
uniform sampler2D table;
uniform float low, high, shade;
uniform vec3 missing;
varying float v;
varying vec3 place;
void main() {
  vec3 colour = v > 1e32 ? missing : texture2D(table, vec2(clamp((v - low) / (high - low), 0.0, 1.0), 0.5)).rgb;
  if (shade > 0.0) {
    vec3 n = normalize(cross(dFdx(place), dFdy(place)));
    colour *= 1.0 - shade * (1.0 - abs(dot(n, normalize(place))));
  }
  gl_FragColor = vec4(colour, 1.0);
}`;

// the triangles of a grid
export function gridTriangles(rows, columns) {
  const out = new Uint32Array(6 * (rows - 1) * (columns - 1));
  for (let r = 0, k = 0; r < rows - 1; r++)
    for (let c = 0; c < columns - 1; c++) {
      const i = r * columns + c;
      out.set([i, i + 1, i + columns, i + 1, i + columns + 1, i + columns], k);
      k += 6;
    }
  return out;
}

// pairs of points that draw polylines given as lists of [x, y, z] arrays
function segments(lines) {
  const out = new Float32Array(lines.reduce((n, line) => n + Math.max(0, line.length / 3 - 1), 0) * 6);
  let k = 0;
  for (const line of lines)
    for (let i = 0; i + 5 < line.length; i += 3) {
      out.set(line.subarray(i, i + 6), k);
      k += 6;
    }
  return out;
}

export class View {
  constructor(canvas, {centre, radius, corners}) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, antialias: true});
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(26, 1, 1, 10);
    this.camera.up.set(0, 0, 1);
    this.raycaster = new Raycaster();
    this.centre = centre;
    this.radius = radius;
    this.corners = corners.map(corner => corner.clone().sub(centre));
    this.groups = new Map();
    const image = new DataTexture(new Uint8Array(4 * TABLE), TABLE, 1);
    image.minFilter = image.magFilter = NearestFilter;
    this.material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 2,
      uniforms: {
        table: {value: image},
        low: {value: 0},
        high: {value: 1},
        shade: {value: 0.3},
        size: {value: 3},
        missing: {value: new Vector3()}
      }
    });
    this.home();
  }

  home() {
    this.touched = false;
    this.azimuth = -0.95;
    this.elevation = 0.5;
    this.distance = 1;
    this.target = this.centre.clone();
    this.fit();
    this.draw();
  }

  // the distance from which the whole box just fills the picture, and its middle in the picture's middle
  fit() {
    this.reach = this.radius * 8;
    for (let round = 0; round < 6; round++) {
      this.place();
      const seen = this.corners.map(corner => corner.clone().project(this.camera));
      const [left, right, bottom, top] = [
        Math.min(...seen.map(p => p.x)),
        Math.max(...seen.map(p => p.x)),
        Math.min(...seen.map(p => p.y)),
        Math.max(...seen.map(p => p.y))
      ];
      this.pan((-(left + right) / 4) * this.canvas.clientWidth, ((bottom + top) / 4) * this.canvas.clientHeight);
      this.reach *= Math.max((right - left) / 1.8, (top - bottom) / 1.76);
    }
  }

  // shape: {position, triangles or null}; positions are drawn about the centre, which keeps single precision fine
  setShape(shape) {
    if (this.surface) {
      this.scene.remove(this.surface);
      this.surface.geometry.dispose();
    }
    const geometry = new BufferGeometry(),
      moved = new Float32Array(shape.position);
    for (let i = 0; i < moved.length; i += 3) {
      moved[i] -= this.centre.x;
      moved[i + 1] -= this.centre.y;
      moved[i + 2] -= this.centre.z;
    }
    geometry.setAttribute('position', new BufferAttribute(moved, 3));
    geometry.setAttribute('value', new BufferAttribute(new Float32Array(moved.length / 3), 1));
    this.fine = shape.triangles ? new BufferAttribute(shape.triangles, 1) : null;
    this.coarse = shape.coarse ? new BufferAttribute(shape.coarse, 1) : null;
    this.slow = false;
    geometry.setIndex(this.fine);
    this.surface = shape.triangles ? new Mesh(geometry, this.material) : new Points(geometry, this.material);
    this.surface.frustumCulled = false;
    this.material.uniforms.shade.value = shape.triangles ? 0.3 : 0;
    this.scene.add(this.surface);
    this.shape = shape;
  }

  setValues(values) {
    const attribute = this.surface.geometry.getAttribute('value');
    for (let i = 0; i < values.length; i++) attribute.array[i] = Number.isNaN(values[i]) ? MISSING : values[i];
    attribute.needsUpdate = true;
  }

  setScale(scale) {
    const {table, low, high} = this.material.uniforms;
    for (let i = 0; i < TABLE; i++) {
      const rgb = colourOf(scale, scale.low + ((scale.high - scale.low) * (i + 0.5)) / TABLE);
      table.value.image.data.set([...rgb, 255], 4 * i);
    }
    table.value.needsUpdate = true;
    low.value = scale.low;
    high.value = scale.high;
    this.draw();
  }

  setShade(on) {
    this.material.uniforms.shade.value = on && this.shape.triangles ? 0.3 : 0;
    this.draw();
  }

  // lines of a group: flat [x, y, z, ...] arrays; colour is a name of the palette
  setLines(group, lines, colour) {
    this.clearLines(group);
    const points = segments(lines);
    for (let i = 0; i < points.length; i += 3) {
      points[i] -= this.centre.x;
      points[i + 1] -= this.centre.y;
      points[i + 2] -= this.centre.z;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(points, 3));
    const weak = colour === 'weak';
    const drawn = new LineSegments(geometry, new LineBasicMaterial({transparent: weak, opacity: weak ? 0.28 : 1}));
    drawn.frustumCulled = false;
    drawn.userData.colour = weak ? 'line' : colour;
    if (colour === 'accent') drawn.renderOrder = 2;
    this.groups.set(group, drawn);
    this.scene.add(drawn);
  }

  clearLines(group) {
    const drawn = this.groups.get(group);
    if (!drawn) return;
    this.scene.remove(drawn);
    drawn.geometry.dispose();
    drawn.material.dispose();
    this.groups.delete(group);
  }

  showLines(group, shown) {
    if (this.groups.has(group)) this.groups.get(group).visible = shown;
    this.draw();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    if (!this.touched) this.fit();
    this.draw(true);
  }

  place() {
    const {camera, azimuth, elevation, radius} = this;
    const distance = this.reach * this.distance;
    camera.position
      .set(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation))
      .multiplyScalar(distance)
      .add(this.target)
      .sub(this.centre);
    camera.near = Math.max(distance - 3 * radius, radius * 1e-2);
    camera.far = distance + 3 * radius;
    camera.lookAt(this.target.clone().sub(this.centre));
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  // paint at the next frame, or now
  draw(now = false) {
    if (!now) {
      if (this.waiting) return;
      const asked = performance.now();
      this.waiting = requestAnimationFrame(() => {
        // the frame before this one kept it waiting
        if (this.resting && performance.now() - asked > 100) this.slow = true;
        this.draw(true);
      });
      return;
    }
    cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    const colours = palette();
    this.place();
    this.material.uniforms.size.value = Math.max(2, (2.2 * this.renderer.getPixelRatio()) / Math.sqrt(this.distance));
    this.material.uniforms.missing.value.set(...colours.missing.map(c => c / 255));
    for (const drawn of this.groups.values()) drawn.material.color = new Color(colours[drawn.userData.colour]);
    this.renderer.setClearColor(new Color(colours.view), 1);
    this.renderer.render(this.scene, this.camera);
    this.drawn?.();
  }

  // The view is being moved: where a frame takes long, fewer points are drawn until it rests.
  moving() {
    this.touched = true;
    if (!this.coarse) return;
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.rest(), 200);
    if (this.slow) this.surface.geometry.setIndex(this.coarse);
  }

  rest() {
    this.resting = 0;
    if (this.surface.geometry.getIndex() === this.fine) return;
    this.surface.geometry.setIndex(this.fine);
    this.draw();
  }

  turn(right, up) {
    this.moving();
    this.azimuth -= right;
    this.elevation = Math.min(Math.max(this.elevation + up, -1.55), 1.55);
    this.draw();
  }

  zoom(factor) {
    this.moving();
    this.distance = Math.min(Math.max(this.distance * factor, 0.01), 4);
    this.draw();
  }

  // move the picture by pixels
  pan(dx, dy) {
    const step =
      (2 *
        Math.tan((this.camera.fov * Math.PI) / 360) *
        this.camera.position.distanceTo(this.target.clone().sub(this.centre))) /
      this.canvas.clientHeight;
    const right = new Vector3().setFromMatrixColumn(this.camera.matrix, 0),
      up = new Vector3().setFromMatrixColumn(this.camera.matrix, 1);
    this.target.addScaledVector(right, -dx * step).addScaledVector(up, dy * step);
    this.draw();
  }

  // where a point [mm] is in the picture, in CSS pixels
  project(x, y, z) {
    const p = new Vector3(x, y, z).sub(this.centre).project(this.camera);
    return [((p.x + 1) / 2) * this.canvas.clientWidth, ((1 - p.y) / 2) * this.canvas.clientHeight];
  }

  // the vertex seen at a place of the picture in CSS pixels, or -1
  pick(x, y) {
    const at = new Vector2((x / this.canvas.clientWidth) * 2 - 1, 1 - (y / this.canvas.clientHeight) * 2);
    this.raycaster.setFromCamera(at, this.camera);
    return this.shape.triangles ? this.pickTriangle() : this.pickPoint(x, y);
  }

  pickTriangle() {
    this.surface.geometry.setIndex(this.fine);
    const [hit] = this.raycaster.intersectObject(this.surface, false);
    if (!hit) return -1;
    const position = this.surface.geometry.getAttribute('position'),
      corner = new Vector3();
    let best = -1,
      nearest = Infinity;
    for (const i of [hit.face.a, hit.face.b, hit.face.c]) {
      const away = corner.fromBufferAttribute(position, i).distanceToSquared(hit.point);
      if (away < nearest) [best, nearest] = [i, away];
    }
    return best;
  }

  // of a cloud: the foremost point within a few pixels
  pickPoint(x, y, reach = 7) {
    const {array} = this.surface.geometry.getAttribute('position');
    const m = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse).elements;
    const width = this.canvas.clientWidth,
      height = this.canvas.clientHeight;
    let best = -1,
      front = Infinity;
    for (let i = 0; i < array.length; i += 3) {
      const a = array[i],
        b = array[i + 1],
        c = array[i + 2],
        w = m[3] * a + m[7] * b + m[11] * c + m[15];
      const dx = (((m[0] * a + m[4] * b + m[8] * c + m[12]) / w + 1) / 2) * width - x;
      const dy = ((1 - (m[1] * a + m[5] * b + m[9] * c + m[13]) / w) / 2) * height - y;
      const away = dx * dx + dy * dy;
      if (w <= 0 || away > reach * reach) continue;
      // a pixel nearer to the pointer counts as much as a little nearer to the eye
      const cost = w + Math.sqrt(away) * this.radius * 1e-3;
      if (cost < front) [best, front] = [i / 3, cost];
    }
    return best;
  }
}

// let mouse, touch and keys move a camera; a click that did not move anything picks
export function steer(view, canvas, onPick) {
  const held = new Map();
  let moved = 0,
    spread = 0;
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, [event.offsetX, event.offsetY]);
    if (held.size === 1) moved = 0;
    spread = 0;
  });
  canvas.addEventListener('pointermove', event => {
    const before = held.get(event.pointerId);
    if (!before) return;
    const now = [event.offsetX, event.offsetY],
      dx = now[0] - before[0],
      dy = now[1] - before[1];
    held.set(event.pointerId, now);
    moved += Math.abs(dx) + Math.abs(dy);
    if (held.size === 2) {
      const [p, q] = [...held.values()],
        apart = Math.hypot(p[0] - q[0], p[1] - q[1]);
      if (spread) view.zoom(spread / apart);
      spread = apart;
      view.pan(dx / 2, dy / 2);
    } else if (event.shiftKey || event.buttons & 6) view.pan(dx, dy);
    else view.turn(dx * 0.008, dy * 0.008);
  });
  const release = event => {
    if (held.delete(event.pointerId) && event.type === 'pointerup' && moved < 5 && event.button === 0)
      onPick(event.offsetX, event.offsetY);
  };
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', release);
  canvas.addEventListener('contextmenu', event => event.preventDefault());
  // the page scrolls over a view that was not asked for
  canvas.addEventListener(
    'wheel',
    event => {
      if (document.activeElement !== canvas) return;
      event.preventDefault();
      view.zoom(Math.exp(event.deltaY * (event.deltaMode ? 0.03 : 0.0012)));
    },
    {passive: false}
  );
  const keys = {
    ArrowLeft: () => view.turn(-0.12, 0),
    ArrowRight: () => view.turn(0.12, 0),
    ArrowUp: () => view.turn(0, 0.12),
    ArrowDown: () => view.turn(0, -0.12),
    '+': () => view.zoom(0.85),
    '=': () => view.zoom(0.85),
    '-': () => view.zoom(1 / 0.85),
    0: () => view.home()
  };
  canvas.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
}
