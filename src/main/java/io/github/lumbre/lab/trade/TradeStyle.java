package io.github.lumbre.lab.trade;

/** The style sheet of a study's page, for light and dark mode, wide and narrow screens. */
final class TradeStyle {
  static final String SHEET =
      """
:root{color-scheme:light dark;--paper:#fff;--panel:#f6f7f9;--ink:#1c2430;--quiet:#5a6270;
--line:#dde2e8;--accent:#0b62a8;--bad:#b3261e;--faint:#9aa3ad;--grid:#e3e7ec;--s0:#0b62a8;
--s1:#c4472b;--s2:#2e7d46;--s3:#8250a8;--s4:#a66a00;--s5:#00808a;--s6:#b5306f;--s7:#5a6270}
@media(prefers-color-scheme:dark){:root{--paper:#12161c;--panel:#1a2028;--ink:#e6eaef;
--quiet:#a3adb9;--line:#303843;--accent:#6db3f2;--bad:#ff8f73;--faint:#6b7582;--grid:#2a313b;
--s0:#6db3f2;--s1:#ff8f73;--s2:#6fcf8f;--s3:#c49bf0;--s4:#f0b040;--s5:#4fd0d8;--s6:#ff85b8;
--s7:#b4bcc6}}
*{box-sizing:border-box}
body{font:16px/1.55 system-ui,sans-serif;max-width:76rem;margin:0 auto;padding:1.5rem 1rem 4rem;
background:var(--paper);color:var(--ink)}
h1{font-size:1.9rem;line-height:1.2;margin:.5rem 0}
h2{font-size:1.3rem;margin:2.8rem 0 .4rem;border-top:1px solid var(--line);padding-top:1.4rem}
h3{font-size:1.02rem;margin:1.6rem 0 .3rem}
p{max-width:48rem;margin:.4rem 0 .8rem}.lead{font-size:1.08rem;color:var(--quiet)}
.note{font-size:.88rem;color:var(--quiet)}
.scroll{overflow-x:auto;margin:.8rem 0 1.2rem;background:
linear-gradient(to right,var(--paper) 30%,transparent) left/2.5rem 100%,
linear-gradient(to left,var(--paper) 30%,transparent) right/2.5rem 100%,
linear-gradient(to right,var(--faint),transparent) left/.8rem 100%,
linear-gradient(to left,var(--faint),transparent) right/.8rem 100%;
background-repeat:no-repeat;background-attachment:local,local,scroll,scroll}
.scroll::-webkit-scrollbar{height:.6rem}
.scroll::-webkit-scrollbar-thumb{background:var(--faint);border-radius:.3rem}
.hint{display:none}
table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums}
th,td{padding:.3rem .8rem;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}
th{color:var(--quiet);font-weight:600}th.group{text-align:center}
th:first-child,td:first-child{text-align:left;padding-left:0}
tr.dominated td{color:var(--faint)}tr.best td{font-weight:650}tr.bad td{color:var(--bad)}
table.facts td{text-align:left;white-space:normal;overflow-wrap:anywhere}
table.facts td:first-child{overflow-wrap:normal}
table.facts td:first-child{color:var(--quiet)}
.charts{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,23rem),1fr));
gap:1rem;margin:1rem 0}
.charts svg{width:100%;height:auto;display:block;background:var(--panel);border-radius:8px}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,22rem),1fr));
gap:1.2rem 1rem;margin:1rem 0}
figure{margin:0}.pair{display:grid;grid-template-columns:1fr 1fr;gap:3px}
img{width:100%;height:auto;display:block;image-rendering:pixelated;border-radius:4px}
figcaption{font-size:.85rem;color:var(--quiet);padding-top:.25rem}
.scale{height:.8rem;max-width:22rem;border-radius:4px;margin-top:.6rem}
@media(max-width:40rem){th,td{padding:.3rem .5rem}table{font-size:.82rem}th.group{text-align:left}
.scroll :is(th,td):first-child{position:sticky;left:0;background:var(--paper);min-width:7rem;
white-space:normal}
.hint{display:block;font-size:.82rem;color:var(--quiet);margin:.8rem 0 -.5rem}}
.marks{display:flex;justify-content:space-between;max-width:22rem;font-size:.8rem;
color:var(--quiet)}
""";

  private TradeStyle() {}
}
