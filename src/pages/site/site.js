// The theme, the list of pages on narrow screens, and the search.
'use strict';
(function () {
  const script = document.currentScript;
  const root = script.dataset.root;
  const page = document.documentElement;
  try {
    const stored = localStorage.getItem('theme');
    if (stored) page.dataset.theme = stored;
  } catch (e) {
    // Pages opened as files may have no storage.
  }

  function isDark() {
    return page.dataset.theme ? page.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  }

  function switchTheme() {
    page.dataset.theme = isDark() ? 'light' : 'dark';
    try {
      localStorage.setItem('theme', page.dataset.theme);
    } catch (e) {
      // The theme holds for this page then.
    }
  }

  let loading;
  function loadIndex() {
    loading = loading || new Promise((resolve, reject) => {
      const element = document.createElement('script');
      element.src = root + 'search-index.js';
      element.onload = () => resolve(window.lumbreIndex);
      element.onerror = reject;
      document.head.append(element);
    });
    return loading;
  }

  function score(section, words) {
    const heading = section.heading.toLowerCase();
    const title = section.page.toLowerCase();
    const text = section.text.toLowerCase();
    let sum = 0;
    for (const word of words) {
      const hits = (heading.includes(word) ? 10 : 0) + (title.includes(word) ? 4 : 0)
        + Math.min(5, text.split(word).length - 1);
      if (hits === 0) return 0;
      sum += hits;
    }
    return sum;
  }

  function excerpt(section, word) {
    const found = section.text.toLowerCase().indexOf(word);
    // Begins at a whole word.
    const start = found < 30 ? 0 : section.text.indexOf(' ', found - 30) + 1;
    const at = Math.max(0, Math.min(start, found));
    return (at > 0 ? '… ' : '') + section.text.slice(at, at + 140);
  }

  async function search(query, results) {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    if (words.length === 0) {
      results.hidden = true;
      return;
    }
    const index = await loadIndex();
    const found = index.map(section => ({section, score: score(section, words)}))
      .filter(hit => hit.score > 0).sort((a, b) => b.score - a.score).slice(0, 12);
    results.replaceChildren();
    for (const {section} of found) {
      const link = document.createElement('a');
      link.href = root + section.url;
      const detail = document.createElement('small');
      detail.textContent = section.heading === section.page
        ? excerpt(section, words[0]) : section.page + ': ' + excerpt(section, words[0]);
      link.append(section.heading, detail);
      results.append(link);
    }
    if (found.length === 0) {
      const none = document.createElement('p');
      none.textContent = 'Nothing found.';
      results.append(none);
    }
    results.hidden = false;
  }

  document.addEventListener('DOMContentLoaded', () => {
    document.getElementById('theme').addEventListener('click', switchTheme);
    const details = document.querySelector('.side details');
    const wide = matchMedia('(min-width: 60.01rem)');
    const adapt = () => { if (details) details.open = wide.matches; };
    wide.addEventListener('change', adapt);
    adapt();
    const input = document.getElementById('query');
    const results = document.getElementById('results');
    input.addEventListener('focus', () => loadIndex().catch(() => {}));
    input.addEventListener('input', () => search(input.value, results));
    input.form.addEventListener('submit', event => {
      event.preventDefault();
      const first = results.querySelector('a');
      if (first) location.href = first.href;
    });
    document.addEventListener('keydown', event => {
      if (event.key === 'Escape') results.hidden = true;
      if (event.key === '/' && document.activeElement !== input) {
        event.preventDefault();
        input.focus();
      }
    });
    document.addEventListener('click', event => {
      if (!input.form.contains(event.target)) results.hidden = true;
    });
  });
})();
