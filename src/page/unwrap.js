'use strict';
(function () {
  const positions = new Float32Array(bytes(data.positions)), places = new Float32Array(bytes(data.places));
  const original = new Uint32Array(bytes(data.original)), corners = new Uint32Array(bytes(data.corners));
  const stretch = new Float32Array(bytes(data.stretch));

  // Normals of vertices before they were doubled, so that seams cast no edge.
  const normals = new Float32Array(positions.length);
  const a = new THREE.Vector3(), b = new THREE.Vector3(), c = new THREE.Vector3();
  for (let i = 0; i < corners.length; i += 3) {
    a.fromArray(positions, 3 * original[corners[i]]);
    b.fromArray(positions, 3 * original[corners[i + 1]]).sub(a);
    c.fromArray(positions, 3 * original[corners[i + 2]]).sub(a);
    b.cross(c);
    for (let k = 0; k < 3; ++k) {
      const v = 3 * original[corners[i + k]];
      normals[v] += b.x;
      normals[v + 1] += b.y;
      normals[v + 2] += b.z;
    }
  }

  // One vertex a corner, because stretch belongs to faces.
  const n = corners.length, at = new Float32Array(3 * n), turn = new Float32Array(3 * n);
  const place = new Float32Array(2 * n), value = new Float32Array(n);
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  let covered = 0;
  for (let i = 0; i < n; ++i) {
    const v = 3 * original[corners[i]];
    for (let k = 0; k < 3; ++k) {
      at[3 * i + k] = positions[v + k];
      turn[3 * i + k] = normals[v + k];
    }
    for (let k = 0; k < 2; ++k) {
      const x = place[2 * i + k] = places[2 * corners[i] + k];
      low[k] = Math.min(low[k], x);
      high[k] = Math.max(high[k], x);
    }
    value[i] = Math.min(Math.max(Math.log2(stretch[Math.floor(i / 3)]) / 2, -1), 1);
    if (i % 3 === 2) {
      const p = 2 * (i - 2);
      covered += Math.abs((place[p + 2] - place[p]) * (place[p + 5] - place[p + 1])
        - (place[p + 4] - place[p]) * (place[p + 3] - place[p + 1])) / 2;
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(at, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(turn, 3));
  geometry.setAttribute('uv', new THREE.BufferAttribute(place, 2));
  geometry.setAttribute('value', new THREE.BufferAttribute(value, 1));

  // Squares of one size on the whole surface if nothing is stretched; dark ones grow red to the right and blue upwards.
  const squares = { value: Math.min(Math.max(Math.round(40 / Math.sqrt(covered || 1)), 5), 200) };
  const mode = { value: location.hash === '#stretch' ? 1 : 0 };
  function material(isFlat) {
    return new THREE.ShaderMaterial({
      uniforms: { squares: squares, mode: mode },
      side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 1.5,
      extensions: { derivatives: true },
      vertexShader: `
        attribute float value;
        varying vec2 vPlace;
        varying vec3 vNormal;
        varying float vValue;
        void main() {
          vPlace = uv;
          vNormal = normalMatrix * normal;
          vValue = value;
          gl_Position = projectionMatrix * modelViewMatrix * vec4(` + (isFlat ? 'uv, 0.0' : 'position') + `, 1.0);
        }`,
      fragmentShader: `
        uniform float squares, mode;
        varying vec2 vPlace;
        varying vec3 vNormal;
        varying float vValue;
        void main() {
          vec2 p = vPlace * squares, w = max(fwidth(p), 1e-5);
          // of a pixel's width
          vec2 share = (abs(fract((p - 0.5 * w) * 0.5) - 0.5) - abs(fract((p + 0.5 * w) * 0.5) - 0.5)) * 2.0 / w;
          vec3 board = mix(vec3(0.25 + 0.45 * vPlace.x, 0.34, 0.25 + 0.45 * vPlace.y), vec3(0.93),
                           0.5 - 0.5 * share.x * share.y);
          vec3 heat = mix(vec3(0.933, 0.933, 0.918),
                          vValue > 0.0 ? vec3(0.784, 0.118, 0.157) : vec3(0.118, 0.294, 0.745), abs(vValue));
          vec3 color = mode > 0.5 ? heat : board;
          gl_FragColor = vec4(color * ` + (isFlat ? '1.0' : '(0.35 + 0.65 * abs(normalize(vNormal).z))') + `, 1.0);
        }`
    });
  }
  const paints = [];
  function lines(scene, text, width, coordinates) {
    const ends = new Uint32Array(bytes(text));
    if (ends.length === 0) return;
    const array = new Float32Array(3 * ends.length);
    ends.forEach(function (v, i) { array.set(coordinates(v), 3 * i); });
    const segments = new THREE.LineSegmentsGeometry();
    segments.setPositions(array);
    paints.push(new THREE.LineMaterial({ color: 0x161616, linewidth: width }));
    const object = new THREE.LineSegments2(segments, paints[paints.length - 1]);
    object.frustumCulled = false;
    scene.add(object);
  }
  const surface = new THREE.Scene(), layout = new THREE.Scene();
  surface.background = layout.background = new THREE.Color(0xffffff);
  surface.add(new THREE.Mesh(geometry, material(false)));
  const flat = new THREE.Mesh(geometry, material(true));
  flat.frustumCulled = false;
  layout.add(flat);
  lines(surface, data.seams, 3, function (v) { return positions.subarray(3 * original[v], 3 * original[v] + 3); });
  lines(layout, data.borders, 2, function (v) { return [places[2 * v], places[2 * v + 1], 0.01]; });

  const camera = new THREE.PerspectiveCamera(35, 1, 0.01, 100);
  const above = new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1);
  let radius = 0;
  for (let i = 0; i < at.length; i += 3) radius = Math.max(radius, Math.hypot(at[i], at[i + 1], at[i + 2]));
  camera.position.set(1.5, 1.1, 2.8)
    .setLength(3.35 * (radius || 1) * Math.max(1, window.innerHeight / (window.innerWidth / 2)));
  const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setScissorTest(true);
  document.body.insertBefore(renderer.domElement, document.body.firstChild);
  const left = document.getElementById('surface'), right = document.getElementById('layout');
  const controls = new THREE.TrackballControls(camera, left);
  controls.rotateSpeed = 3;
  controls.dynamicDampingFactor = 0.3;

  // What the layout shows: the point in the middle, and the height of a pixel.
  const middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  let pixel = 0, width = 1, height = 1;
  function render() {
    above.left = middle[0] - pixel * width / 2;
    above.right = middle[0] + pixel * width / 2;
    above.bottom = middle[1] - pixel * height / 2;
    above.top = middle[1] + pixel * height / 2;
    above.updateProjectionMatrix();
    [[surface, camera, 0], [layout, above, width]].forEach(function (view) {
      renderer.setViewport(view[2], 0, width, height);
      renderer.setScissor(view[2], 0, width, height);
      renderer.render(view[0], view[1]);
    });
  }
  function resize() {
    width = window.innerWidth / 2;
    height = window.innerHeight;
    if (pixel === 0) pixel = Math.max((high[0] - low[0]) / (width - 40), (high[1] - low[1]) / (height - 80), 1e-9);
    renderer.setSize(2 * width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    paints.forEach(function (p) { p.resolution.set(width, height); });
    controls.handleResize();
    render();
  }
  window.addEventListener('resize', resize);
  controls.addEventListener('change', render);
  right.addEventListener('pointerdown', function (event) { right.setPointerCapture(event.pointerId); });
  right.addEventListener('pointermove', function (event) {
    if (!right.hasPointerCapture(event.pointerId)) return;
    middle[0] -= pixel * event.movementX;
    middle[1] += pixel * event.movementY;
    render();
  });
  right.addEventListener('wheel', function (event) { // the point under the pointer stays
    event.preventDefault();
    const factor = Math.exp(Math.max(-1, Math.min(1, event.deltaY / 300)));
    middle[0] += pixel * (1 - factor) * (event.clientX - 1.5 * width);
    middle[1] -= pixel * (1 - factor) * (event.clientY - height / 2);
    pixel *= factor;
    render();
  }, { passive: false });

  const toggle = document.getElementById('toggle'), range = document.getElementById('squares');
  const scale = document.getElementById('scale');
  function show(what) {
    mode.value = what;
    toggle.textContent = what ? 'show checkerboard' : 'show stretch';
    scale.style.display = what ? 'block' : 'none';
    range.parentNode.style.display = what ? 'none' : '';
    render();
  }
  range.value = squares.value;
  range.addEventListener('input', function () { squares.value = Number(range.value); render(); });
  toggle.addEventListener('click', function () { show(1 - mode.value); });
  window.addEventListener('keydown', function (event) {
    if (event.key === 'c' || event.key === 'C') show(1 - mode.value);
  });
  resize();
  show(mode.value);

  // With #count in the address: how many pixels show something, for whoever opens the page without eyes.
  if (location.hash === '#count') {
    const { values: pixels, width: w } = readPixels(renderer);
    let drawn = 0, flatDrawn = 0, dark = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      const isDrawn = pixels[i] < 250 || pixels[i + 1] < 250 || pixels[i + 2] < 250;
      if (isDrawn && (i / 4) % w < w / 2) ++drawn;
      if (isDrawn && (i / 4) % w >= w / 2) ++flatDrawn;
      if (pixels[i] < 30 && pixels[i + 1] < 30 && pixels[i + 2] < 30) ++dark;
    }
    document.body.setAttribute('data-pixels', drawn);
    document.body.setAttribute('data-layout-pixels', flatDrawn);
    document.body.setAttribute('data-cut-pixels', dark);
  }

  (function animate() {
    requestAnimationFrame(animate);
    controls.update();
  })();
})();
