// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes of a report, to be turned around. They are in the page as bytes (see album.py), and are drawn by three.js.
(() => {
  "use strict";

  const byId = (id) => document.getElementById(id);
  const data = JSON.parse(byId("viewer-data").textContent);
  const canvas = byId("viewer-canvas");
  // The height of what is shown at first, in parts of its width: of one horizon, and of several, one above the other.
  const HEIGHT_SHARES = [0.18, 0.45];
  const FIRST_VIEW = { azimuth: -1.08, elevation: 0.66, zoom: 1.0, x: 0.0, y: 0.0 };
  const TURN = 0.01; // radians for each pixel
  const KEY_TURN = 0.12;
  // Of materials: seen from both sides, and behind the edges on them.
  const FACES = { side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };

  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ canvas, alpha: true, antialias: true });
  } catch (error) {
    return; // the page tells that nothing is drawn
  }
  byId("viewer").hidden = false;
  byId("viewer-failure").hidden = true;

  const scene = new THREE.Scene();
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.01, 20.0);
  camera.up.set(0, 0, 1);
  const side = new THREE.DirectionalLight(0xffffff, 0.62);
  side.position.set(-1.2, 0.9, 0.9);
  const front = new THREE.DirectionalLight(0xffffff, 0.38);
  front.position.set(0, 0, 1);
  camera.add(side, front);
  scene.add(camera, new THREE.AmbientLight(0xffffff, 0.18));

  let view = { ...FIRST_VIEW };
  let shown = { group: new THREE.Group() };
  scene.add(shown.group);

  // Meshes ----------------------------------------------------------------------------------------------------------

  const known = new Map();

  function load(id) {
    if (!known.has(id)) {
      const mesh = data.meshes[id];
      const text = atob(byId("mesh-" + id).textContent.trim());
      const bytes = new Uint8Array(text.length);
      for (let n = 0; n < text.length; n += 1) {
        bytes[n] = text.charCodeAt(n);
      }
      const errorCount = { triangles: mesh.triangles, points: mesh.points }[mesh.error_on] || 0;
      const start = 12 * mesh.points;
      const Index = mesh.points <= 65536 ? Uint16Array : Uint32Array;
      const points = new THREE.BufferAttribute(new Float32Array(bytes.buffer, 0, 3 * mesh.points), 3);
      const corners = new Index(bytes.buffer, start + 4 * errorCount);
      const geometryOf = (index) => {
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute("position", points);
        geometry.setIndex(new THREE.BufferAttribute(index, 1));
        geometry.computeVertexNormals();
        geometry.computeBoundingBox();
        return geometry;
      };
      known.set(id, { ...mesh, geometry: geometryOf(corners.subarray(0, 3 * mesh.triangles)),
        walls: geometryOf(corners.subarray(3 * mesh.triangles)),
        errors: new Float32Array(bytes.buffer, start, errorCount) });
    }
    return known.get(id);
  }

  // The colours of values from 0 to 1, between stops of [value, red, green, blue].
  function colorsOf(values, stops) {
    const colors = new Float32Array(3 * values.length);
    values.forEach((value, n) => {
      let s = 1;
      while (s < stops.length - 1 && value > stops[s][0]) {
        s += 1;
      }
      const [low, high] = [stops[s - 1], stops[s]];
      const part = Math.min(1, Math.max(0, (value - low[0]) / (high[0] - low[0])));
      for (let c = 0; c < 3; c += 1) {
        colors[3 * n + c] = low[c + 1] + part * (high[c + 1] - low[c + 1]);
      }
    });
    return colors;
  }

  function colorByHeight(mesh, range) {
    const points = mesh.geometry.getAttribute("position");
    const values = Float32Array.from({ length: mesh.points },
      (_, n) => (points.getZ(n) + mesh.center[2] - range[0]) / (range[1] - range[0] || 1));
    mesh.geometry.setAttribute("color", new THREE.BufferAttribute(colorsOf(values, data.low_to_high), 3));
    return mesh.geometry;
  }

  // Triangles with one colour each share no points.
  function colorByError(mesh, range) {
    const values = mesh.errors.map((error) => error / (range[1] || 1));
    const colors = colorsOf(values, data.near_to_far);
    if (mesh.error_on === "points") {
      mesh.geometry.setAttribute("color", new THREE.BufferAttribute(colors, 3));
      return mesh.geometry;
    }
    const plain = new THREE.BufferGeometry();
    plain.setIndex(mesh.geometry.index);
    plain.setAttribute("position", mesh.geometry.getAttribute("position"));
    plain.setAttribute("normal", mesh.geometry.getAttribute("normal"));
    const apart = plain.toNonIndexed();
    const spread = new Float32Array(9 * mesh.triangles);
    for (let n = 0; n < spread.length; n += 1) {
      spread[n] = colors[3 * Math.floor(n / 9) + n % 3];
    }
    apart.setAttribute("color", new THREE.BufferAttribute(spread, 3));
    return apart;
  }

  function rangeOf(meshes, byError) {
    if (byError) {
      return [0, Math.max(...meshes.map((mesh) => mesh.farthest))];
    }
    return [Math.min(...meshes.map((m) => m.center[2] + m.geometry.boundingBox.min.z)),
      Math.max(...meshes.map((m) => m.center[2] + m.geometry.boundingBox.max.z))];
  }

  // What is chosen ---------------------------------------------------------------------------------------------------

  function chosenIds() {
    const choice = byId("viewer-choice").value;
    return choice.startsWith("file-") ? data.files[Number(choice.slice(5))] : [choice];
  }

  function add(geometry, material, place) {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.position.copy(place);
    shown.group.add(mesh);
  }

  function build() {
    const ids = chosenIds();
    const meshes = ids.map(load);
    const byError = byId("viewer-colors").value === "error" && meshes.every((mesh) => mesh.error_on);
    const range = rangeOf(meshes, byError);
    const bounds = new THREE.Box3();
    const offsets = meshes.map((mesh) => new THREE.Vector3(...mesh.center.map((c, n) => c - meshes[0].center[n])));
    meshes.forEach((mesh, n) => bounds.union(mesh.geometry.boundingBox.clone().translate(offsets[n])));
    const middle = bounds.getCenter(new THREE.Vector3());
    const extent = bounds.getSize(new THREE.Vector3());
    const width = Math.max(extent.x, extent.y, 1e-9);

    scene.remove(shown.group);
    const share = HEIGHT_SHARES[meshes.length > 1 ? 1 : 0];
    shown = { group: new THREE.Group(), ids, width, factor: extent.z > 0 ? share * width / extent.z : 1 };
    meshes.forEach((mesh, n) => {
      const geometry = byError ? colorByError(mesh, range) : colorByHeight(mesh, range);
      const place = offsets[n].clone().sub(middle);
      add(geometry, new THREE.MeshLambertMaterial({ vertexColors: THREE.VertexColors, ...FACES }), place);
      // What closes faults is no part of the surface: it has a colour of its own, and sharp edges to what is beside it.
      if (mesh.fault_triangles) {
        const color = new THREE.Color(...data.fault_colors[byError ? "error" : "height"]);
        add(mesh.walls, new THREE.MeshPhongMaterial({ color, flatShading: true, shininess: 0, ...FACES }), place);
      }
      if (byId("viewer-edges").checked) {
        const lines = new THREE.MeshBasicMaterial({ color: 0x0c1116, wireframe: true, transparent: true, opacity: 0.35 });
        [mesh.geometry, ...(mesh.fault_triangles ? [mesh.walls] : [])].forEach((edges) => add(edges, lines, place));
      }
    });
    scene.add(shown.group);
    fit(extent.divideScalar(width));
    tellColors(byError, range);
    draw();
  }

  // Half of how wide and how high a box is at first sight, with a margin.
  function fit(box) {
    const [sin, cos] = [Math.sin, Math.cos];
    const { azimuth, elevation } = FIRST_VIEW;
    shown.wide = 0.53 * (box.x * Math.abs(sin(azimuth)) + box.y * Math.abs(cos(azimuth)));
    shown.high = 0.53 * (sin(elevation) * (box.x * Math.abs(cos(azimuth)) + box.y * Math.abs(sin(azimuth)))
      + cos(elevation) * box.z * shown.factor);
  }

  function tellColors(byError, range) {
    const text = (value) => String(Number(value.toPrecision(5)));
    byId("viewer-low").textContent = text(range[0]);
    byId("viewer-high").textContent = text(range[1]);
    byId("viewer-ramp").className = byError ? "near-to-far" : "low-to-high";
    const [mesh] = shown.ids.map((id) => data.meshes[id]);
    const faults = byId("viewer-faults");
    if (faults) {
      faults.hidden = !shown.ids.some((id) => data.meshes[id].fault_triangles);
    }
    const errors = { triangles: "largest vertical distance of a point in each triangle, lattice units",
      points: "distance of each corner, " + data.unit };
    byId("viewer-unit").textContent = byError ? errors[mesh.error_on] : "z" + (mesh.unit ? ", " + mesh.unit : "");
  }

  // Drawing ----------------------------------------------------------------------------------------------------------

  let asked = false;

  function draw() {
    if (!asked) {
      asked = true;
      requestAnimationFrame(drawNow);
    }
  }

  function exaggeration() {
    return Number((shown.factor * 2 ** Number(byId("viewer-heights").value)).toPrecision(2));
  }

  function drawNow() {
    asked = false;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    renderer.setSize(width, height, false);
    const scale = 1 / shown.width;
    shown.group.scale.set(scale, scale, scale * exaggeration());
    byId("viewer-factor").textContent = "\u00d7 " + exaggeration();

    const aspect = width / height;
    const half = Math.max(shown.high, shown.wide / aspect) / view.zoom;
    camera.left = view.x - half * aspect;
    camera.right = view.x + half * aspect;
    camera.top = view.y + half;
    camera.bottom = view.y - half;
    camera.updateProjectionMatrix();
    camera.position.set(Math.cos(view.elevation) * Math.cos(view.azimuth), Math.cos(view.elevation) * Math.sin(view.azimuth),
      Math.sin(view.elevation)).multiplyScalar(8);
    camera.lookAt(0, 0, 0);
    renderer.render(scene, camera);
    canvas.dataset.triangles = renderer.info.render.triangles;
  }

  function turn(right, up) {
    view.azimuth -= right;
    view.elevation = Math.min(Math.PI / 2 - 0.001, Math.max(-Math.PI / 2 + 0.001, view.elevation + up));
    draw();
  }

  function zoom(factor) {
    view.zoom = Math.min(60, Math.max(0.3, view.zoom * factor));
    draw();
  }

  // Pointers and keys ------------------------------------------------------------------------------------------------

  const pointers = new Map();

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) {
      return;
    }
    const [right, down] = [event.clientX - last[0], event.clientY - last[1]];
    const other = Array.from(pointers).find(([id]) => id !== event.pointerId);
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (other) { // two fingers
      const distance = (place) => Math.hypot(place[0] - other[1][0], place[1] - other[1][1]) || 1;
      zoom(distance([event.clientX, event.clientY]) / distance(last));
    } else if (event.shiftKey || event.buttons === 4) {
      const pixel = (camera.top - camera.bottom) / canvas.clientHeight;
      view.x -= pixel * right;
      view.y += pixel * down;
      draw();
    } else {
      turn(TURN * right, TURN * down);
    }
  });
  ["pointerup", "pointercancel"].forEach((name) => canvas.addEventListener(name, (e) => pointers.delete(e.pointerId)));
  canvas.addEventListener("wheel", (event) => {
    if (event.ctrlKey || document.activeElement === canvas) { // the page scrolls otherwise
      event.preventDefault();
      zoom(Math.exp(-0.0015 * event.deltaY));
    }
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const actions = {
      ArrowLeft: () => turn(-KEY_TURN, 0), ArrowRight: () => turn(KEY_TURN, 0), ArrowUp: () => turn(0, -KEY_TURN),
      ArrowDown: () => turn(0, KEY_TURN), "+": () => zoom(1.2), "=": () => zoom(1.2), "-": () => zoom(1 / 1.2) };
    if (actions[event.key]) {
      event.preventDefault();
      actions[event.key]();
    }
  });

  function reset() {
    view = { ...FIRST_VIEW };
    byId("viewer-heights").value = 0;
    draw();
  }

  byId("viewer-choice").addEventListener("change", () => { view = { ...FIRST_VIEW }; build(); });
  byId("viewer-colors").addEventListener("change", build);
  byId("viewer-edges").addEventListener("change", build);
  byId("viewer-heights").addEventListener("input", draw);
  byId("viewer-reset").addEventListener("click", reset);
  byId("viewer").querySelector("form").addEventListener("submit", (event) => event.preventDefault());
  new ResizeObserver(draw).observe(canvas);
  document.addEventListener("click", (event) => {
    const button = event.target.closest("[data-turn]");
    if (button) {
      byId("viewer-choice").value = button.dataset.turn;
      build();
      byId("meshes").scrollIntoView();
      canvas.focus({ preventScroll: true });
    }
  });
  build();
})();
