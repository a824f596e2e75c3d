package io.github.lumbre.lab.trade;

/** The style sheet of a study's page, for light and dark mode, wide and narrow screens. */
final class TradeStyle {
  static final String SHEET =
"""
:root{color-scheme:light dark;--paper:#fff;--ink:#1c2430;--quiet:#5a6270;
--line:#dde2e8;--bad:#b3261e;--faint:#9aa3ad}
@media(prefers-color-scheme:dark){:root{--paper:#12161c;--ink:#e6eaef;
--quiet:#a3adb9;--line:#303843;--bad:#ff8f73;--faint:#6b7582}}
*{box-sizing:border-box}
body{font:16px/1.55 system-ui,sans-serif;max-width:76rem;margin:0 auto;padding:1.5rem 1rem 4rem;
background:var(--paper);color:var(--ink)}
h1{font-size:1.9rem;line-height:1.2;margin:.5rem 0}
h2{font-size:1.3rem;margin:2.8rem 0 .4rem;border-top:1px solid var(--line);padding-top:1.4rem}
p{max-width:48rem;margin:.4rem 0 .8rem}.lead{font-size:1.08rem;color:var(--quiet)}
.note{font-size:.88rem;color:var(--quiet)}
.scroll{overflow-x:auto;margin:.8rem 0 1.2rem}
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
@media(max-width:40rem){th,td{padding:.3rem .5rem}table{font-size:.82rem}th.group{text-align:left}
.scroll :is(th,td):first-child{position:sticky;left:0;background:var(--paper);min-width:7rem;
white-space:normal}
.hint{display:block;font-size:.82rem;color:var(--quiet);margin:.8rem 0 -.5rem}}
""";

  private TradeStyle() {}
}
