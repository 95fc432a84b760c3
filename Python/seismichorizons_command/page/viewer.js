// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes of a report, to be turned around. They are in the page as bytes (see album.py), and are drawn by WebGL.
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
  const FARTHEST = 12.0; // of what is drawn, from the middle; the first width is 1
  const EDGE_COLOR = [0.047, 0.067, 0.086, 0.35];

  const gl = canvas.getContext("webgl2", { alpha: true, antialias: true });
  if (!gl) {
    return; // the page tells that nothing is drawn
  }
  byId("viewer").hidden = false;
  byId("viewer-failure").hidden = true;

  let view = { ...FIRST_VIEW };
  let shown = { drawn: [] };

  // Shaders ----------------------------------------------------------------------------------------------------------

  // Places turn into the axes of the screen: right, up and towards the viewer.
  const VERTEX = `#version 300 es
    uniform mat3 axes;
    uniform vec3 scale, place, low, high;
    in vec3 position, normal, color;
    out vec3 seen, turned, own;
    void main() {
      seen = axes * (scale * (position + place));
      turned = axes * (normal / scale);
      own = color;
      gl_Position = vec4((2.0 * seen - low - high) / (high - low) * vec3(1.0, 1.0, -1.0), 1.0);
    }`;
  // A light from aside, a weaker one from the viewer, and both sides of a surface alike. Flat faces take their normals
  // from the screen.
  const FRAGMENT = `#version 300 es
    precision highp float;
    uniform vec4 plain;
    uniform int style;
    in vec3 seen, turned, own;
    out vec4 result;
    void main() {
      if (style == 2) {
        result = vec4(plain.rgb * plain.a, plain.a);
        return;
      }
      vec3 n = normalize(style == 1 ? cross(dFdx(seen), dFdy(seen)) : turned);
      n = n.z < 0.0 ? -n : n;
      float light = 0.24 + 0.62 * max(0.0, dot(n, normalize(vec3(-1.2, 0.9, 1.8)))) + 0.38 * n.z;
      result = vec4((style == 1 ? plain.rgb : own) * min(light, 1.0), 1.0);
    }`;
  const SMOOTH = 0, FLAT = 1, EDGES = 2;

  const program = gl.createProgram();
  [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]].forEach(([kind, text]) => {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  });
  gl.linkProgram(program);
  gl.useProgram(program);
  const uniform = (name) => gl.getUniformLocation(program, name);

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
      const places = new Float32Array(bytes.buffer, 0, 3 * mesh.points);
      const corners = new Index(bytes.buffer, start + 4 * errorCount);
      const faces = corners.subarray(0, 3 * mesh.triangles);
      const box = [0, 1, 2].map((axis) => [Infinity, -Infinity]);
      places.forEach((value, n) => {
        const range = box[n % 3];
        range[0] = Math.min(range[0], value);
        range[1] = Math.max(range[1], value);
      });
      known.set(id, { ...mesh, places, faces, walls: corners.subarray(3 * mesh.triangles), box,
        normals: normalsOf(places, faces), errors: new Float32Array(bytes.buffer, start, errorCount) });
    }
    return known.get(id);
  }

  // The normal of a point is the mean of those of its triangles, by their areas.
  function normalsOf(places, faces) {
    const normals = new Float32Array(places.length);
    for (let n = 0; n < faces.length; n += 3) {
      const [a, b, c] = [3 * faces[n], 3 * faces[n + 1], 3 * faces[n + 2]];
      const [ux, uy, uz] = [0, 1, 2].map((axis) => places[b + axis] - places[a + axis]);
      const [vx, vy, vz] = [0, 1, 2].map((axis) => places[c + axis] - places[a + axis]);
      const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
      [a, b, c].forEach((point) => normal.forEach((value, axis) => { normals[point + axis] += value; }));
    }
    return normals;
  }

  // Each edge once, as pairs of points.
  function edgesOf(faces, points) {
    const keys = new Float64Array(faces.length);
    for (let n = 0; n < faces.length; n += 1) {
      const [a, b] = [faces[n], faces[n % 3 === 2 ? n - 2 : n + 1]];
      keys[n] = Math.min(a, b) * points + Math.max(a, b);
    }
    keys.sort();
    const unique = keys.filter((key, n) => n === 0 || key !== keys[n - 1]);
    const edges = new Uint32Array(2 * unique.length);
    unique.forEach((key, n) => {
      edges[2 * n] = Math.floor(key / points);
      edges[2 * n + 1] = key % points;
    });
    return edges;
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

  function heightColors(mesh, range) {
    const values = Float32Array.from({ length: mesh.points },
      (_, n) => (mesh.places[3 * n + 2] + mesh.center[2] - range[0]) / (range[1] - range[0] || 1));
    return colorsOf(values, data.low_to_high);
  }

  function errorColors(mesh, range) {
    return colorsOf(mesh.errors.map((error) => error / (range[1] || 1)), data.near_to_far);
  }

  // Triangles with one colour each share no points.
  function apart(mesh, colors) {
    const spread = (values) => Float32Array.from({ length: 3 * mesh.faces.length },
      (_, n) => values[3 * mesh.faces[Math.floor(n / 3)] + n % 3]);
    return { places: spread(mesh.places), normals: spread(mesh.normals),
      colors: Float32Array.from({ length: 9 * mesh.triangles }, (_, n) => colors[3 * Math.floor(n / 9) + n % 3]) };
  }

  function rangeOf(meshes, byError) {
    if (byError) {
      return [0, Math.max(...meshes.map((mesh) => mesh.farthest))];
    }
    return [Math.min(...meshes.map((m) => m.center[2] + m.box[2][0])), Math.max(...meshes.map((m) => m.center[2] + m.box[2][1]))];
  }

  // What is chosen ---------------------------------------------------------------------------------------------------

  function chosenIds() {
    const choice = byId("viewer-choice").value;
    return choice.startsWith("file-") ? data.files[Number(choice.slice(5))] : [choice];
  }

  // Buffers of what is drawn: arrays of three numbers a point, and an index or none.
  function add(style, arrays, index, place, color) {
    const drawn = { style, place, color, array: gl.createVertexArray(), buffers: [] };
    gl.bindVertexArray(drawn.array);
    const fill = (target, values) => {
      drawn.buffers.push(gl.createBuffer());
      gl.bindBuffer(target, drawn.buffers[drawn.buffers.length - 1]);
      gl.bufferData(target, values, gl.STATIC_DRAW);
    };
    Object.entries(arrays).forEach(([name, values]) => {
      const where = gl.getAttribLocation(program, name);
      fill(gl.ARRAY_BUFFER, values);
      gl.enableVertexAttribArray(where);
      gl.vertexAttribPointer(where, 3, gl.FLOAT, false, 0, 0);
    });
    drawn.count = index ? index.length : arrays.position.length / 3;
    if (index) {
      drawn.type = index instanceof Uint16Array ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT;
      fill(gl.ELEMENT_ARRAY_BUFFER, index);
    }
    gl.bindVertexArray(null);
    shown.drawn.push(drawn);
  }

  function build() {
    const ids = chosenIds();
    const meshes = ids.map(load);
    const byError = byId("viewer-colors").value === "error" && meshes.every((mesh) => mesh.error_on);
    const range = rangeOf(meshes, byError);
    const offsets = meshes.map((mesh) => mesh.center.map((c, n) => c - meshes[0].center[n]));
    const bounds = [0, 1, 2].map((axis) => [0, 1].map((end) => Math[end ? "max" : "min"](
      ...meshes.map((mesh, n) => mesh.box[axis][end] + offsets[n][axis]))));
    const extent = bounds.map(([low, high]) => high - low);
    const width = Math.max(extent[0], extent[1], 1e-9);

    shown.drawn.forEach((drawn) => {
      gl.deleteVertexArray(drawn.array);
      drawn.buffers.forEach((buffer) => gl.deleteBuffer(buffer));
    });
    const share = HEIGHT_SHARES[meshes.length > 1 ? 1 : 0];
    shown = { drawn: [], ids, width, factor: extent[2] > 0 ? share * width / extent[2] : 1 };
    meshes.forEach((mesh, n) => {
      const place = offsets[n].map((value, axis) => value - (bounds[axis][0] + bounds[axis][1]) / 2);
      const colors = byError ? errorColors(mesh, range) : heightColors(mesh, range);
      if (byError && mesh.error_on === "triangles") {
        const own = apart(mesh, colors);
        add(SMOOTH, { position: own.places, normal: own.normals, color: own.colors }, null, place);
      } else {
        add(SMOOTH, { position: mesh.places, normal: mesh.normals, color: colors }, mesh.faces, place);
      }
      // What closes faults is no part of the surface: it has a colour of its own, and sharp edges to what is beside it.
      if (mesh.fault_triangles) {
        add(FLAT, { position: mesh.places }, mesh.walls, place, [...data.fault_colors[byError ? "error" : "height"], 1.0]);
      }
      if (byId("viewer-edges").checked) {
        [mesh.faces, mesh.walls].filter((faces) => faces.length).forEach((faces) => add(
          EDGES, { position: mesh.places }, edgesOf(faces, mesh.points), place, EDGE_COLOR));
      }
    });
    fit(extent.map((size) => size / width));
    tellColors(byError, range);
    draw();
  }

  // Half of how wide and how high a box is at first sight, with a margin.
  function fit(box) {
    const [sin, cos] = [Math.sin, Math.cos];
    const { azimuth, elevation } = FIRST_VIEW;
    const [x, y, z] = box;
    shown.wide = 0.53 * (x * Math.abs(sin(azimuth)) + y * Math.abs(cos(azimuth)));
    shown.high = 0.53 * (sin(elevation) * (x * Math.abs(cos(azimuth)) + y * Math.abs(sin(azimuth)))
      + cos(elevation) * z * shown.factor);
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

  // Half of what is seen, in parts of the first width: across, and up.
  function halves() {
    const aspect = canvas.clientWidth / canvas.clientHeight;
    const half = Math.max(shown.high, shown.wide / aspect) / view.zoom;
    return [half * aspect, half];
  }

  function drawNow() {
    asked = false;
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    canvas.width = Math.round(ratio * canvas.clientWidth);
    canvas.height = Math.round(ratio * canvas.clientHeight);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.polygonOffset(1, 1); // what has edges on it is behind them
    byId("viewer-factor").textContent = "\u00d7 " + exaggeration();

    const [sinA, cosA] = [Math.sin(view.azimuth), Math.cos(view.azimuth)];
    const [sinE, cosE] = [Math.sin(view.elevation), Math.cos(view.elevation)];
    const [across, up] = halves();
    gl.uniformMatrix3fv(uniform("axes"), false,
      [-sinA, -sinE * cosA, cosE * cosA, cosA, -sinE * sinA, cosE * sinA, 0, cosE, sinE]);
    const scale = 1 / shown.width;
    gl.uniform3f(uniform("scale"), scale, scale, scale * exaggeration());
    gl.uniform3f(uniform("low"), view.x - across, view.y - up, -FARTHEST);
    gl.uniform3f(uniform("high"), view.x + across, view.y + up, FARTHEST);
    let triangles = 0;
    shown.drawn.forEach((drawn) => {
      const isEdges = drawn.style === EDGES;
      (isEdges ? gl.enable : gl.disable).call(gl, gl.BLEND);
      (isEdges ? gl.disable : gl.enable).call(gl, gl.POLYGON_OFFSET_FILL);
      gl.uniform1i(uniform("style"), drawn.style);
      gl.uniform3fv(uniform("place"), drawn.place);
      gl.uniform4fv(uniform("plain"), drawn.color || EDGE_COLOR);
      gl.bindVertexArray(drawn.array);
      if (drawn.type) {
        gl.drawElements(isEdges ? gl.LINES : gl.TRIANGLES, drawn.count, drawn.type, 0);
      } else {
        gl.drawArrays(gl.TRIANGLES, 0, drawn.count);
      }
      triangles += isEdges ? 0 : drawn.count / 3;
    });
    gl.bindVertexArray(null);
    canvas.dataset.triangles = triangles;
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
      const pixel = 2 * halves()[1] / canvas.clientHeight;
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
