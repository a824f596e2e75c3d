// The paths of a pixel: a list of its brightest samples, and the chosen one over the picture.
const Paths = (() => {
  const NS = 'http://www.w3.org/2000/svg';
  const $ = id => document.getElementById(id);
  const rgb = v => v.map(x => typeof x === 'number' ? x.toPrecision(3) * 1 : x).join(' ');
  const sum = v => v.reduce((a, b) => a + (typeof b === 'number' ? b : 0), 0);
  let all = [], chosen = -1, pixel = null, serial = 0;

  const shape = (name, attributes) => {
    const element = document.createElementNS(NS, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return element;
  };

  const draw = (overlay, scale) => {
    overlay.replaceChildren();
    if (!pixel) return;
    const [x, y] = pixel, r = 4 / scale;
    for (const kind of ['mark under', 'mark'])
      overlay.append(shape('rect', {class: kind, x: x + .5 - r, y: y + .5 - r, width: 2 * r, height: 2 * r}));
    const path = all[chosen];
    if (!path) return;
    const lines = (from, to, kind) => {
      for (const k of ['path under', 'path ' + kind])
        overlay.append(shape('path', {class: k, d: `M${from.join(' ')}L${to.join(' ')}`}));
    };
    path.drawing.forEach((v, i) => {
      if (i > 0 && v.from && v.to) lines(v.from, v.to, v.isHit ? '' : 'light');
      if (v.to) v.lights.forEach(l => l.to && lines(v.to, l.to, l.isBlocked ? 'light blocked' : 'light'));
    });
    path.drawing.forEach(v => {
      if (v.isHit && v.to) overlay.append(shape('circle', {class: 'dot', cx: v.to[0], cy: v.to[1], r: 4 / scale}));
    });
  };

  const item = (vertex, number) => {
    const li = document.createElement('li');
    const say = text => { const s = document.createElement('small'); s.textContent = text; li.append(s); };
    if (vertex.hit) {
      const name = vertex.hit.object_name || vertex.hit.object_path || 'a surface';
      const material = vertex.hit.material_name || vertex.hit.bsdf || '';
      li.append(document.createTextNode(name + (material ? ', ' + material : '')));
      say(`at ${vertex.hit.position.map(v => (+v).toPrecision(4) * 1).join(', ')}`);
    } else {
      li.append(document.createTextNode('leaves the scene'));
    }
    for (const c of vertex.contributions) {
      const names = c.lights.map(l => {
        const what = l.emitter_name || l.emitter_path || l.source;
        return what + (l.is_blocked ? ' (blocked)' : '') + (l.source === 'light' ? `, MIS ${(+l.mis_weight).toPrecision(3)}` : '');
      });
      say(`adds ${rgb(c.amount)} from ${names.join('; ')}`);
    }
    const going = vertex.scattered[0];
    say(vertex.end === 'continues' && going
      ? `continues, weight ${rgb(going.weight)}` : String(vertex.end).replace(/_/g, ' '));
    return li;
  };

  const choose = (index, redraw) => {
    chosen = index;
    [...$('samplelist').children].forEach((b, i) => b.setAttribute('aria-pressed', i === index));
    const path = all[index];
    $('vertices').replaceChildren(...(path ? path.vertices.map(item) : []));
    $('text').textContent = path ? path.text : '';
    redraw();
  };

  const list = redraw => {
    $('samplelist').replaceChildren(...all.map((p, i) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = `${p.sample}: ${(sum(p.film) / 3).toPrecision(3) * 1}, ${p.vertices.length} vert.`;
      button.title = `sample ${p.sample}, film value ${rgb(p.film)}`;
      button.onclick = () => choose(i, redraw);
      return button;
    }));
  };

  // On a wide screen the panel scrolls by itself, and the picture stays where it is.
  const reveal = () => {
    const section = $('paths'), panel = section.parentElement;
    if (matchMedia('(max-width: 760px)').matches) return;
    section.scrollIntoView({block: section.offsetHeight > panel.clientHeight ? 'start' : 'nearest'});
  };

  const load = async (x, y, sample, redraw) => {
    const mine = ++serial;
    pixel = [x, y];
    $('paths').hidden = false;
    reveal();
    $('pathshead').textContent = `Paths of pixel ${x}, ${y}`;
    $('pathnote').textContent = 'Repeating its samples…';
    redraw();
    try {
      const answer = await fetch(`pixel?x=${x}&y=${y}` + (sample === null ? '' : `&sample=${sample}`));
      if (mine !== serial) return;
      if (!answer.ok) throw new Error(await answer.text());
      const json = await answer.json();
      if (mine !== serial) return;
      all = json.brightest;
      $('pathnote').textContent = json.samples
        ? `Mean ${rgb(json.mean)} over ${json.samples} ${json.samples === 1 ? 'sample' : 'samples'}` + (json.rejected ? `, ${json.rejected} rejected` : '') + '. Brightest:'
        : `Sample ${sample}:`;
      list(redraw);
      choose(0, redraw);
      reveal();
    } catch (e) {
      if (mine !== serial) return;
      all = [];
      list(redraw);
      $('vertices').replaceChildren();
      $('pathnote').textContent = String(e.message);
      redraw();
    }
  };

  const close = redraw => {
    serial++;
    pixel = null;
    all = [];
    $('paths').hidden = true;
    redraw();
  };

  return {draw, load, close, pixel: () => pixel};
})();
