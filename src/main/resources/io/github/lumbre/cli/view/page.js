(() => {
  const $ = id => document.getElementById(id);
  const canvas = $('picture'), overlay = $('overlay'), stage = $('stage');
  const LIGHT = /^(|albedo|direct|indirect|denoisingAlbedo|lights.*)$/;
  const MATTE = /^(object|material|CryptoObject\d*|CryptoMaterial\d*)$/;
  const SIGNED = /^(normal|geometricNormal|denoisingNormal)$/;
  const LAYERS = [...new DOMParser().parseFromString('<select><!--layers--></select>', 'text/html').querySelectorAll('option')]
    .map(o => o.textContent);
  // The choice among the layers that shows the denoised picture, and the layers that denoising needs.
  const DENOISED = 'denoised', GUIDES = ['variance', 'denoisingAlbedo', 'denoisingNormal'];

  let state = null, since = 0, cost = 0;
  let picture = null, other = null, kept = null;
  let cursor = null, factor = 1, touched = false, failures = 0;

  // ---- Requests

  const post = async command => {
    try {
      const answer = await fetch('do', {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify(command)});
      if (!answer.ok) tell(await answer.text());
    } catch (e) { tell('The program does not answer.'); }
  };

  const fetchPicture = async (path) => {
    const answer = await fetch(path);
    // 204: the render does not have this layer yet.
    if (answer.status !== 200) return null;
    return {...Tone.read(await answer.arrayBuffer()), automatic: +answer.headers.get('Automatic-Exposure'), denoisedAt: +answer.headers.get('Denoised-Samples')};
  };

  const poll = async () => {
    while (true) {
      try {
        const answer = await fetch(`state?since=${since}&cost=${Math.min(5000, Math.round(cost))}&hidden=${document.hidden ? 1 : 0}&denoised=${isClean()}`);
        cost = 0;
        if (!answer.ok) throw new Error();
        state = await answer.json();
        since = state.version;
        failures = 0;
        showState();
        if (!document.hidden) await refresh();
        else await new Promise(done => setTimeout(done, 500));
      } catch (e) {
        failures++;
        setStatus(failures > 1 ? 'The program has ended' : 'Connecting…', false);
        await new Promise(done => setTimeout(done, Math.min(5000, 500 * failures)));
      }
    }
  };

  // Fetches the frame that the state names, if it is not here yet.
  const refresh = async () => {
    const frame = state.frame;
    if (!frame) return;
    const clean = isClean(), layer = frame.isDraft || clean ? '' : $('layer').value;
    const exact = frame.isFinal || clean ? 1 : 0, auto = $('auto').checked ? 1 : 0;
    const key = [clean && frame.denoised || frame.version, layer, exact, clean].join('/');
    if (picture && picture.key === key && (!auto || picture.automatic)) return;
    const found = await fetchPicture(`image?layer=${encodeURIComponent(layer)}&exact=${exact}&auto=${auto}&v=${frame.version}&denoised=${clean}`);
    if (!found) return;
    const start = performance.now();
    found.key = key;
    found.layer = layer;
    found.isDraft = frame.isDraft;
    picture = found;
    $('empty').hidden = true;
    showStatus();
    paint();
    canvas.dataset.final = frame.isFinal;
    cost += performance.now() - start;
  };

  // 1 if the denoised picture is wanted, which is there some time after the noisy one.
  const isClean = () => state && state.render && $('layer').value === DENOISED ? 1 : 0;

  // ---- Painting

  const limits = p => {
    if (SIGNED.test(p.layer)) return [[-1, -1, -1], [1, 1, 1]];
    if (p.layer === 'uv') return [[0, 0, 0], [1, 1, 1]];
    const low = [], high = [], n = p.channels;
    for (let c = 0; c < n; c++) {
      let a = Infinity, b = -Infinity;
      for (let i = c; i < p.values.length; i += n) {
        const v = p.values[i];
        if (Number.isFinite(v)) { if (v < a) a = v; if (v > b) b = v; }
      }
      low.push(a); high.push(b > a ? b : a + 1);
    }
    return [low, high];
  };

  // PNG and JPEG files have the exposure and the tone curve already. If the viewed picture is such a file itself,
  // the controls change both.
  const isFinished = p => p.isDisplayReferred && !state.isDisplayReferred;

  // The color behind a picture that is rendered here.
  const behind = p => p === picture && !p.layer ? state.background : p.background;

  const put = (target, p) => {
    target.width = p.width;
    target.height = p.height;
    const context = target.getContext('2d', {willReadFrequently: true});
    const image = context.createImageData(p.width, p.height);
    if (MATTE.test(p.layer || '')) Tone.matte(p, image.data);
    else if (!LIGHT.test(p.layer || '')) Tone.scale(p, ...limits(p), image.data);
    else Tone.develop(p, isFinished(p) ? 1 : factor, isFinished(p) ? 'srgb' : $('tone').value, image.data, behind(p));
    context.putImageData(image, 0, 0);
  };

  // Draws a picture of another size into the middle of a canvas of the viewed picture's size.
  const putInside = (target, p) => {
    const scratch = document.createElement('canvas');
    put(scratch, p);
    [target.width, target.height] = fullSize();
    const s = Math.min(target.width / p.width, target.height / p.height), w = p.width * s, h = p.height * s;
    target.getContext('2d', {willReadFrequently: true}).drawImage(scratch, (target.width - w) / 2, (target.height - h) / 2, w, h);
  };

  const sizeOf = p => `${p.width}×${p.height}`;

  // A picture as it is shown, in linear light.
  const asShown = p => {
    const bytes = new Uint8ClampedArray(4 * p.width * p.height), values = new Float32Array(3 * p.width * p.height);
    Tone.develop(p, factor, $('tone').value, bytes, behind(p));
    const table = Float32Array.from({length: 256}, (_, i) => Tone.decode(i / 255));
    for (let i = 0; i < values.length / 3; i++) for (let c = 0; c < 3; c++) values[3 * i + c] = table[bytes[4 * i + c]];
    return {width: p.width, height: p.height, channels: 3, values};
  };

  const difference = (a, b) => {
    const values = new Float32Array(3 * a.width * a.height);
    for (let i = 0; i < a.width * a.height; i++) {
      for (let c = 0; c < 3; c++) {
        values[3 * i + c] = Math.abs(a.values[i * a.channels + Math.min(c, a.channels - 1)] - b.values[i * b.channels + Math.min(c, b.channels - 1)]);
      }
    }
    return {width: a.width, height: a.height, channels: 3, values, layer: '', isDisplayReferred: b.isDisplayReferred};
  };

  const rival = () => kept || (other && other.width ? other : null);

  const paint = () => {
    if (!picture) return;
    factor = $('auto').checked ? picture.automatic || factor : 2 ** +$('exposure').value;
    if ($('auto').checked) $('stops').textContent = Math.log2(factor).toFixed(1);
    const b = rival(), mode = b ? $('mode').value : '';
    const isLight = LIGHT.test(picture.layer || '');
    const same = b && isLight && b.width === picture.width && b.height === picture.height;
    const [width, height] = fullSize();
    const hasSize = b && b.width === width && b.height === height;
    // What a picture with a tone curve can be compared with is what this one shows.
    const own = same && isFinished(b) ? asShown(picture) : Tone.asLight(picture, behind(picture));
    const against = b && Tone.asLight(b, behind(b));
    $('second').hidden = mode !== 'side';
    $('caption').hidden = !mode;
    let text = state.name, otherText = '';
    if (b) otherText = hasSize ? b.name : `${b.name}, ${sizeOf(b)} pixels`;
    if (b && !hasSize) text += `, ${width}×${height} pixels`;
    if (mode === 'diff' && same) text = 'absolute difference';
    if (mode === 'diff' && !same) {
      text = !isLight ? 'no difference: this layer is not light'
        : picture.isDraft && hasSize ? 'no difference yet: this is a draft'
        : `no difference: ${b.name} has ${sizeOf(b)} pixels, this picture ${width}×${height}`;
    }
    if (mode === 'other') text = otherText;
    if (mode === 'diff' && same) put(canvas, difference(own, against));
    else if (mode === 'other' && !hasSize) putInside(canvas, b);
    else put(canvas, mode === 'other' ? b : picture);
    if (mode === 'side') {
      if (hasSize) put($('otherpicture'), b);
      else putInside($('otherpicture'), b);
      $('othercaption').textContent = otherText;
    }
    $('caption').textContent = text;
    if (b) {
      $('comparison').textContent = same
        ? `Compared with ${b.name}${isFinished(b) ? ', as shown' : ''}: mean absolute difference ${meanDifference(own, against).toPrecision(3)}.`
        : !isLight ? 'Layers that are not light are not compared.'
        : hasSize ? `Compared with ${b.name} when the first full picture is there.`
        : `${b.name} has ${sizeOf(b)} pixels, this picture ${width}×${height}: there is no difference of pictures of different sizes.`;
    }
    layout();
    magnify();
  };

  const meanDifference = (a, b) => {
    let sum = 0;
    const n = a.width * a.height;
    for (let i = 0; i < n; i++) for (let c = 0; c < 3; c++)
      sum += Math.abs(a.values[i * a.channels + Math.min(c, a.channels - 1)] - b.values[i * b.channels + Math.min(c, b.channels - 1)]);
    return sum / (3 * n);
  };

  // The size of the picture in full, also while a draft is shown.
  const fullSize = () => picture && picture.isDraft && state.render
    ? [state.render.window[2], state.render.window[3]] : [picture.width, picture.height];

  let scale = 1;
  const layout = () => {
    if (!picture) return;
    const [w, h] = fullSize();
    const side = !$('second').hidden;
    const isNarrow = matchMedia('(max-width: 760px)').matches;
    const pad = isNarrow ? 20 : 40;
    const room = stage.clientWidth - pad - (side && !isNarrow ? 16 : 0);
    const columns = side && !isNarrow ? 2 : 1;
    const space = isNarrow ? Infinity : stage.clientHeight - pad - ($('caption').hidden ? 0 : 24);
    const wanted = +$('zoom').value;
    scale = wanted || Math.max(.02, Math.min(room / columns / w, space / h, w < 200 ? 4 : 2));
    for (const c of [canvas, $('otherpicture')]) {
      c.style.width = w * scale + 'px';
      c.style.height = h * scale + 'px';
      c.classList.toggle('sharp', scale >= 2 && !picture.isDraft);
    }
    const origin = state.render ? state.render.window : [0, 0, w, h];
    overlay.setAttribute('viewBox', `${origin[0]} ${origin[1]} ${w} ${h}`);
    overlay.style.width = w * scale + 'px';
    overlay.style.height = h * scale + 'px';
    redraw();
  };

  const redraw = () => {
    Paths.draw(overlay, scale);
    if (cursor && document.activeElement === canvas) {
      const o = state && state.render ? state.render.window : [0, 0];
      for (const kind of ['mark under', 'mark']) {
        const rect = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
        const r = Math.max(.5, 3 / scale);
        const set = {class: kind, x: o[0] + cursor[0] + .5 - r, y: o[1] + cursor[1] + .5 - r, width: 2 * r, height: 2 * r};
        for (const [k, v] of Object.entries(set)) rect.setAttribute(k, v);
        overlay.append(rect);
      }
    }
  };

  // ---- The magnifier and its values

  const digits = v => Number.isFinite(v) ? String(+v.toPrecision(picture.isExact ? 7 : 4)) : String(v);

  const magnify = () => {
    if (!picture || picture.isDraft || !cursor) return;
    const [x, y] = cursor, target = $('magnifier').getContext('2d');
    target.imageSmoothingEnabled = false;
    target.fillStyle = '#808080';
    target.fillRect(0, 0, 143, 143);
    target.drawImage(canvas, x - 5, y - 5, 11, 11, 0, 0, 143, 143);
    target.strokeStyle = '#000'; target.strokeRect(64.5, 64.5, 14, 14);
    target.strokeStyle = '#fff'; target.strokeRect(65.5, 65.5, 12, 12);
    if (MATTE.test(picture.layer)) {
      const found = Tone.items(picture, y * picture.width + x);
      showValues([['Pixel', `${x}, ${y}`], ...found.map(([id, share]) => [names[id] || id, percent(share)])]);
      if (found.some(([id]) => !names[id])) learnNames();
      return;
    }
    const letters = picture.layer ? picture.channels === 3 && LIGHT.test(picture.layer) ? ['R', 'G', 'B'] : ['X', 'Y', 'Z', 'W'] : ['R', 'G', 'B', 'Alpha'];
    const rows = [['Pixel', `${x}, ${y}`]];
    const i = (y * picture.width + x) * picture.channels;
    for (let c = 0; c < picture.channels; c++) rows.push([letters[c] || c, digits(picture.values[i + c])]);
    if (!picture.layer) rows.push(['Luminance', digits(Tone.luminance(picture.values[i], picture.values[i + 1], picture.values[i + 2]))]);
    const b = rival();
    if (b && b.width === picture.width && b.height === picture.height) {
      const j = (y * b.width + x) * b.channels;
      rows.push(['Other', [0, 1, 2].map(c => +b.values[j + Math.min(c, b.channels - 1)].toPrecision(3)).join(' ')]);
    }
    showValues(rows);
  };

  const showValues = rows => $('values').replaceChildren(...rows.map(([name, value]) => {
    const div = document.createElement('div'), dt = document.createElement('dt'), dd = document.createElement('dd');
    dt.textContent = name; dd.textContent = value; div.append(dt, dd);
    return div;
  }));

  // The names of objects and materials by their ids, for the frame that is shown.
  let names = {}, namesOf = '';
  const learnNames = async () => {
    if (namesOf === picture.key) return;
    namesOf = picture.key;
    const answer = await fetch('names?layer=' + encodeURIComponent(picture.layer));
    if (answer.ok) { names = {...names, ...await answer.json()}; magnify(); }
  };

  const pixelAt = event => {
    const box = canvas.getBoundingClientRect();
    const x = Math.floor((event.clientX - box.left) / box.width * canvas.width);
    const y = Math.floor((event.clientY - box.top) / box.height * canvas.height);
    return [Math.max(0, Math.min(canvas.width - 1, x)), Math.max(0, Math.min(canvas.height - 1, y))];
  };

  const explain = () => {
    if (!cursor || !state.render || picture.isDraft) return;
    const o = state.render.window;
    Paths.load(cursor[0] + o[0], cursor[1] + o[1], null, redraw);
  };

  // ---- The camera

  let pending = null, moving = false;
  const move = delta => {
    if (!state || !state.render) return;
    pending = pending || {action: 'move', right: 0, up: 0, panRight: 0, panUp: 0, zoom: 0, still: false};
    for (const key of ['right', 'up', 'panRight', 'panUp', 'zoom']) pending[key] += delta[key] || 0;
    pending.still = delta.still || false;
    if (Paths.pixel()) Paths.close(redraw);
    send();
  };
  const send = async () => {
    if (moving || !pending) return;
    moving = true;
    const next = pending;
    pending = null;
    await post(next);
    moving = false;
    send();
  };

  let drag = null;
  canvas.addEventListener('pointerdown', e => {
    if (e.button !== 0) return;
    drag = {x: e.clientX, y: e.clientY, moved: false};
    canvas.setPointerCapture(e.pointerId);
  });
  canvas.addEventListener('pointermove', e => {
    if (picture && !picture.isDraft && !(drag && drag.moved)) { cursor = pixelAt(e); magnify(); }
    if (!drag) return;
    const dx = e.clientX - drag.x, dy = e.clientY - drag.y;
    if (!drag.moved && Math.hypot(dx, dy) < 4) return;
    drag.moved = true;
    drag.x = e.clientX; drag.y = e.clientY;
    if (!state.render) { stage.scrollBy(-dx, -dy); return; }
    const h = canvas.clientHeight;
    if (e.shiftKey) move({panRight: -dx / h, panUp: dy / h});
    else move({right: -dx * .4, up: dy * .4});
  });
  const release = e => {
    if (!drag) return;
    if (drag.moved && state.render) move({still: true});
    else if (!drag.moved && e.type === 'pointerup' && picture && !picture.isDraft) { cursor = pixelAt(e); explain(); }
    drag = null;
  };
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', release);
  let wheelTimer = 0;
  canvas.addEventListener('wheel', e => {
    if (!state || !state.render || e.ctrlKey) return;
    e.preventDefault();
    move({zoom: Math.max(-1, Math.min(1, e.deltaY * .001))});
    clearTimeout(wheelTimer);
    wheelTimer = setTimeout(() => move({still: true}), 250);
  }, {passive: false});

  const copyCamera = async () => {
    const [camera, line] = await Promise.all([fetch('camera'), fetch('command')]);
    const command = (await line.json()).command;
    $('cameratext').textContent = await camera.text();
    $('commandtext').textContent = command;
    $('command').hidden = !command;
    $('nocommand').hidden = !!command;
    $('json').showModal();
    copy($(command ? 'commandtext' : 'cameratext'));
  };
  const copy = async element => {
    const what = element.id === 'commandtext' ? 'command line' : 'JSON';
    $('copied').textContent = '';
    try {
      await navigator.clipboard.writeText(element.textContent);
      $('copied').textContent = 'The ' + what + ' is in the clipboard.';
    } catch (e) { $('copied').textContent = 'Select the text to copy it.'; }
  };

  // ---- The state beside the picture

  const setStatus = (text, isOn) => {
    if ($('status').textContent !== text) $('status').textContent = text;
    $('status').classList.toggle('on', isOn);
  };
  const tell = text => { $('problems').hidden = !text; $('problems').textContent = text; };
  const number = v => v >= 100 ? Math.round(v).toLocaleString('en') : v.toFixed(v >= 10 ? 1 : 2).replace(/\.?0+$/, '');
  const percent = v => v < 0 ? 'unknown' : +(100 * v).toPrecision(2) + ' %';

  const STATUS = {reading: 'Reading…', rendering: 'Rendering', stopped: 'Stopped', finished: 'Finished', moving: 'Moving the camera', still: 'Picture'};

  const showStatus = () => {
    const note = !picture || picture.isDraft ? '' : picture.denoisedAt ? `, denoised at ${number(picture.denoisedAt)} samples`
      : isClean() ? ', noisy until it is denoised' : '';
    setStatus((STATUS[state.status] || state.status) + note, state.status === 'rendering');
  };

  const showState = () => {
    document.title = state.name + ' – Lumbre';
    $('name').textContent = state.name;
    tell(state.problems.join('\n'));
    if (!touched) {
      $('tone').value = state.toneMap;
      $('auto').checked = state.exposure === 'auto';
      $('exposure').value = state.exposure === 'auto' ? 0 : state.exposure;
      if (!$('auto').checked) $('stops').textContent = (+$('exposure').value).toFixed(1);
    }
    const r = state.render;
    for (const id of ['progress', 'run', 'camera']) $(id).hidden = !r;
    $('home').hidden = !state.isMoved;
    layers();
    showStatus();
    if (state.other && !other) loadOther();
    if (!r) return;
    $('run').textContent = state.status === 'stopped' ? 'Continue' : 'Stop';
    $('run').disabled = state.status === 'finished';
    const done = r.goal < 0 ? r.samples : Math.min(r.samples, r.goal);
    $('samples').textContent = r.goal < 0 ? number(done) : `${number(done)} of ${number(r.goal)}`;
    // Without a number of samples, a limit of time or error ends the render.
    const isOver = state.status === 'finished';
    const part = isOver ? 1 : r.goal > 0 ? done / r.goal : r.secondsLeft < 0 ? 0 : r.seconds / Math.max(1e-9, r.seconds + r.secondsLeft);
    const share = Math.round(100 * part);
    $('bar').setAttribute('aria-valuenow', share);
    $('bar').firstElementChild.style.width = share + '%';
    $('rate').textContent = r.rate >= 1e6 ? `${(r.rate / 1e6).toFixed(2)} M/s` : `${Math.round(r.rate / 1e3)} k/s`;
    $('time').textContent = duration(r.seconds);
    $('left').textContent = state.status === 'finished' ? '–' : r.secondsLeft < 0 ? '–' : duration(r.secondsLeft);
    const last = r.errors[r.errors.length - 1];
    $('error').textContent = last ? `${percent(last[2])} ${r.estimatedAt}`.trim() : '–';
    $('bound').textContent = last ? `${percent(last[3])}${last[4] ? ', may not hold: few bright samples' : ''}` : '–';
    drawChart($('chart'), r.errors);
  };

  const isRecorded = name => (name === DENOISED ? GUIDES : [name]).every(n => state.render.recorded.includes(n));
  let layerKey = '';
  const layers = () => {
    const own = state.frame ? state.frame.layers : [];
    const recorded = state.render ? state.render.recorded : own;
    const all = !state.render ? own : [DENOISED, ...LAYERS.flatMap(name => {
      const parts = recorded.filter(r => r === name || name === 'lights' && r.startsWith('lights.'));
      return parts.length ? parts : [name];
    })];
    const key = all.join() + '/' + recorded.join();
    if (key === layerKey) return;
    // A render that records what denoising needs, as of a model, is shown denoised at first.
    const chosen = !layerKey && state.render && isRecorded(DENOISED) ? DENOISED : $('layer').value;
    layerKey = key;
    const options = all.map(name => {
      const has = !state.render || isRecorded(name);
      return new Option(has ? name : name + ' (renders anew)', name);
    });
    $('layer').replaceChildren(new Option('picture', ''), ...options);
    $('layer').value = all.includes(chosen) ? chosen : all.find(name => chosen && name.startsWith(chosen + '.')) || '';
  };

  const loadOther = async () => {
    other = {};
    const found = await fetchPicture('other');
    if (found) {
      found.name = state.other;
      found.isDisplayReferred = state.otherIsDisplayReferred;
      other = found;
      comparing();
    } else other = null;
  };
  const comparing = () => { $('mode').disabled = !rival(); paint(); };

  // ---- Controls

  const touch = () => { touched = true; paint(); if (state) refresh(); };
  $('exposure').oninput = () => { $('auto').checked = false; $('stops').textContent = (+$('exposure').value).toFixed(1); touch(); };
  $('auto').onchange = () => { $('stops').textContent = (+$('exposure').value).toFixed(1); touch(); };
  $('tone').onchange = touch;
  $('zoom').onchange = layout;
  $('mode').onchange = paint;
  $('layer').onchange = async () => {
    const name = $('layer').value;
    if (name && state.render && !isRecorded(name)) await post({action: 'record', layer: name});
    showStatus();
    await refresh();
  };
  $('run').onclick = () => post({action: state.status === 'stopped' ? 'continue' : 'stop'});
  $('home').onclick = () => { Paths.close(redraw); post({action: 'home'}); };
  $('camera').onclick = copyCamera;
  $('help').onclick = () => $('keys').showModal();
  $('closekeys').onclick = () => $('keys').close();
  $('copycommand').onclick = () => copy($('commandtext'));
  $('copyjson').onclick = () => copy($('cameratext'));
  $('closejson').onclick = () => $('json').close();
  $('closepaths').onclick = () => { Paths.close(redraw); canvas.focus(); };
  $('show').onclick = () => { const p = Paths.pixel(); if (p) Paths.load(p[0], p[1], Math.max(0, Math.round(+$('number').value)), redraw); };
  $('keep').onclick = () => {
    if (!picture || picture.isDraft) return;
    kept = {...picture, background: behind(picture), name: picture.denoisedAt ? `the picture denoised at ${number(picture.denoisedAt)} samples`
      : 'the picture kept at ' + (state.render ? number(state.render.samples) + ' samples' : state.name)};
    if (!$('mode').value) $('mode').value = 'side';
    comparing();
  };
  $('file').onchange = async () => {
    const file = $('file').files[0];
    if (!file) return;
    try {
      const bitmap = await createImageBitmap(file, {colorSpaceConversion: 'none'});
      const scratch = document.createElement('canvas');
      scratch.width = bitmap.width; scratch.height = bitmap.height;
      const context = scratch.getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const data = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
      const table = Float32Array.from({length: 256}, (_, i) => Tone.decode(i / 255));
      const values = new Float32Array(3 * bitmap.width * bitmap.height);
      for (let i = 0; i < values.length / 3; i++) for (let c = 0; c < 3; c++) values[3 * i + c] = table[data[4 * i + c]];
      kept = {width: bitmap.width, height: bitmap.height, channels: 3, values, layer: '', name: file.name, isDisplayReferred: true};
      if (!$('mode').value) $('mode').value = 'side';
      comparing();
    } catch (e) { tell(`${file.name}: expected a PNG or JPEG picture`); }
    $('file').value = '';
  };
  for (const id of ['png', 'exr']) {
    $(id).onclick = () => {
      const stops = $('auto').checked ? 'auto' : $('exposure').value;
      $(id).href = `save?format=${id}&exposure=${stops}&tone=${$('tone').value}&denoised=${isClean()}`;
    };
  }

  // ---- Keys

  const next = (select, step = 1) => {
    select.selectedIndex = (select.selectedIndex + step + select.options.length) % select.options.length;
    select.dispatchEvent(new Event('change'));
  };
  const mode = name => {
    if ($('mode').disabled) return;
    $('mode').value = $('mode').value === name ? '' : name;
    paint();
  };
  const expose = by => { $('exposure').value = +$('exposure').value + by; $('exposure').oninput(); };
  const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  const ACTIONS = {
    s: () => { if (!$('run').hidden && !$('run').disabled) $('run').click(); },
    h: () => { if (!$('home').hidden) $('home').click(); },
    c: () => { if (!$('camera').hidden) copyCamera(); },
    k: () => $('keep').click(), b: () => mode('side'), d: () => mode('diff'), x: () => mode('other'),
    n: () => { if (state.render) { $('layer').value = isClean() ? '' : DENOISED; $('layer').dispatchEvent(new Event('change')); } },
    t: () => next($('tone')), l: () => next($('layer')),
    z: () => { $('zoom').value = $('zoom').value === '0' ? '1' : '0'; layout(); },
    '[': () => expose(-.5), ']': () => expose(.5), '?': () => $('keys').showModal(),
    Escape: () => { if (Paths.pixel()) Paths.close(redraw); },
  };
  document.addEventListener('keydown', e => {
    if (e.ctrlKey || e.metaKey || e.altKey || $('keys').open || $('json').open || !state) return;
    const tag = e.target.tagName;
    const arrow = ARROWS[e.key];
    if (e.target === canvas && (arrow || e.key === 'Enter')) {
      e.preventDefault();
      if (!arrow) { explain(); return; }
      if (e.shiftKey) { move({right: 5 * arrow[0], up: -5 * arrow[1], still: true}); return; }
      cursor = cursor || [Math.floor(canvas.width / 2), Math.floor(canvas.height / 2)];
      cursor = [Math.max(0, Math.min(canvas.width - 1, cursor[0] + arrow[0])), Math.max(0, Math.min(canvas.height - 1, cursor[1] + arrow[1]))];
      magnify();
      redraw();
      return;
    }
    if (tag === 'SELECT' || tag === 'INPUT' && e.target.type !== 'range' && e.target.type !== 'checkbox') return;
    const action = ACTIONS[e.key.length === 1 ? e.key.toLowerCase() : e.key];
    if (action) { e.preventDefault(); action(); }
  });
  canvas.addEventListener('focus', redraw);
  canvas.addEventListener('blur', redraw);
  new ResizeObserver(layout).observe(stage);
  drawChart($('chart'), []);
  poll();
})();
