#include "analysis/report/page/page_style.h"

namespace seamline::analysis {

const char* page_style() {
  return R"css(
:root { color-scheme: light dark; --page: #ffffff; --ink: #1f2326; --soft: #5a6268; --line: #d5d9dd; --card: #f5f6f7;
  --accent: #0062a3; --note: #fff6df; --note-line: #e0b040;
  --line-0: #0072b2; --line-1: #d55e00; --line-2: #009e73; --line-3: #cc79a7; --line-4: #e69f00; --line-5: #56b4e9; }
@media (prefers-color-scheme: dark) { :root { --page: #15181b; --ink: #e6e8ea; --soft: #a3abb2; --line: #3a4046;
  --card: #1d2125; --accent: #6db8ea; --note: #2d2716; --note-line: #a5822e;
  --line-0: #3f9fe0; --line-1: #f07c2c; --line-2: #20bf92; --line-3: #e39cc4; --line-4: #f0b429; --line-5: #8accf5; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2.5rem 1.5rem 4rem; max-width: 70rem; background: var(--page); color: var(--ink);
  font: 16px/1.55 system-ui, "Helvetica Neue", Arial, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .4rem; }
h2 { font-size: 1.3rem; margin: 2.8rem 0 .8rem; }
h3 { font-size: 1.05rem; margin: 1.6rem 0 .5rem; }
p { max-width: 46rem; }
nav { display: flex; flex-wrap: wrap; gap: .2rem 1.1rem; margin: 1.2rem 0; font-size: .95rem; }
.plain { padding-left: 1.1rem; max-width: 46rem; font-size: .94rem; }
.quote { border-left: 3px solid var(--line); padding-left: 1.1rem; }
details { margin: 1rem 0; } summary { cursor: pointer; color: var(--accent); }
.soft, figcaption, .facts dt { color: var(--soft); }
.badge { display: inline-block; margin: .6rem 0; padding: .15rem .7rem; border: 1px solid var(--note-line); border-radius: 1rem;
  background: var(--note); font-size: .92rem; }
.notes { padding: .6rem 1rem .6rem 2rem; border-left: 4px solid var(--note-line); background: var(--note); max-width: 46rem; }
.facts { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1.2rem; margin: 1rem 0; }
.facts dd { margin: 0; overflow-wrap: anywhere; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .94rem; }
th, td { padding: .38rem .9rem .38rem 0; text-align: left; vertical-align: top; white-space: nowrap; }
thead th { border-bottom: 2px solid var(--ink); vertical-align: bottom; }
tbody tr { border-bottom: 1px solid var(--line); }
tbody tr.group { border-top: 1px solid var(--soft); }
td.number, th.number { text-align: right; }
td.number { white-space: normal; max-width: 11rem; }
table.tight { font-size: .88rem; } .tight th, .tight td { padding-right: .7rem; }
.tight th, .tight td { white-space: normal; }
table.tight td.number, table.tight td:last-child { white-space: nowrap; min-width: 0; }
td.verdict { white-space: normal; color: var(--soft); font-style: italic; max-width: 24rem; }
tbody .sentence { white-space: normal; font-weight: normal; max-width: 56rem; }
td:last-child:not(.number) { white-space: normal; min-width: 12rem; }
figure { margin: 1.2rem 0 2rem; }
figure svg { width: 100%; height: auto; max-width: 46rem; display: block; }
figcaption { font-size: .92rem; max-width: 50rem; margin-top: .5rem; }
.samples { display: grid; gap: .5rem; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); }
.samples div { font-size: .85rem; text-align: center; color: var(--soft); }
.samples img { width: 100%; height: auto; display: block; border-radius: 3px; }
.sample-title { margin: 1.2rem 0 .4rem; font-weight: 600; }
a { color: var(--accent); }
@page { size: A4; margin: 16mm 15mm; }
@media print { :root { font-size: 12px; --page: #fff; --ink: #000; --soft: #444; --line: #bbb; --card: #fff; --note: #fff;
  --line-0: #0072b2; --line-1: #d55e00; --line-2: #009e73; --line-3: #cc79a7; --line-4: #e69f00; --line-5: #56b4e9; }
  nav { display: none; }
  body { max-width: none; padding: 0; font-size: 10pt; line-height: 1.4; }
  h2 { margin-top: 1.6rem; } h2, h3, .sample-title { break-after: avoid; }
  p, figcaption, .plain, .notes { max-width: none; }
  .scroll { overflow: visible; }
  table { font-size: 8pt; } thead { display: table-header-group; }
  th, td { padding: .2rem .6rem .2rem 0; white-space: normal; } td.number { max-width: none; }
  tbody .sentence { max-width: none; } td:last-child:not(.number) { min-width: 0; }
  figure, tr, .samples div { break-inside: avoid; } figure { margin: .8rem 0 1.2rem; }
  figure svg { max-height: 98mm; } .samples { grid-template-columns: repeat(4, 1fr); } }
)css";
}

}  // namespace seamline::analysis
