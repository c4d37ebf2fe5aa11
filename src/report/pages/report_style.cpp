// SPDX-License-Identifier: BSL-1.0
#include <carom/report/pages/document.hpp>

namespace carom::report {

const std::string_view report_style = R"css(
:root {
  color-scheme: light dark;
  --paper: #fff; --ink: #1c1e21; --faint: #5a6067; --rule: #c9ced4; --raised: #f3f5f7; --link: #0b57a4;
  --good: #17692f; --bad: #a3161c; --bad-paper: #fdeaea; --good-paper: #e8f5ec; --odd-paper: #fff4d6;
  --before: #5a6067; --computed: #c03d14; --exact: #0b57a4; --body: #8a929b; --body-fill: #8a929b22;
  --shade-0: #f4f8f5; --shade-1: #e3f0e6; --shade-2: #cfe6d5; --shade-3: #fde9c4; --shade-4: #fbd08f;
  --shade-5: #f7b06a; --shade-6: #f09060; --shade-7: #ea7a66;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --paper: #15181b; --ink: #e6e8ea; --faint: #a3abb3; --rule: #3d444b; --raised: #1f2428; --link: #85bdf5;
    --good: #7fd098; --bad: #ff9a94; --bad-paper: #3f1d1e; --good-paper: #17301f; --odd-paper: #3a300f;
    --before: #b4bbc2; --computed: #ff8a5c; --exact: #6fb4ff; --body: #8f98a1; --body-fill: #8f98a122;
    --shade-0: #1b211d; --shade-1: #1e2f23; --shade-2: #213d2a; --shade-3: #453411; --shade-4: #5d3d0c;
    --shade-5: #74400f; --shade-6: #853a1a; --shade-7: #96302a;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
header, main, footer { padding: 0 1rem; max-width: 110rem; margin: 0 auto; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 1rem 0 0.5rem; }
h2 { font-size: 1.3rem; margin: 2.5rem 0 0.5rem; padding-top: 0.5rem; border-top: 1px solid var(--rule); }
h3 { font-size: 1.1rem; margin: 2rem 0 0.5rem; }
h4 { font-size: 1rem; margin: 0 0 0.5rem; }
h1, h3, h4, dd, p, li { overflow-wrap: anywhere; }
p { max-width: 50rem; margin: 0.5rem 0; }
a { color: var(--link); }
:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
main:focus { outline: none; }
footer { color: var(--faint); border-top: 1px solid var(--rule); margin-top: 3rem; }
.skip { position: absolute; left: 0.5rem; top: -4rem; background: var(--paper); padding: 0.5rem; }
.skip:focus { top: 0.5rem; }
.spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
nav ul, .legend { display: flex; flex-wrap: wrap; gap: 0.25rem 1rem; list-style: none; padding: 0; margin: 0.5rem 0; }
.legend { font-size: 0.875rem; gap: 0.25rem 1rem; }
.swatch { display: inline-block; width: 1.5em; height: 1em; border: 1px solid var(--rule); vertical-align: -0.1em; }
.result { font-size: 1.15rem; padding: 0.6rem 0.8rem; border-left: 0.4rem solid; max-width: none; }
.exit-0 { background: var(--good-paper); border-color: var(--good); }
.exit-1 { background: var(--bad-paper); border-color: var(--bad); }
.exit-2 { background: var(--odd-paper); border-color: var(--ink); }
dl { margin: 0.75rem 0; }
dl div { display: flex; flex-wrap: wrap; gap: 0 1rem; padding: 0.15rem 0; }
dt { flex: 0 0 12rem; color: var(--faint); overflow-wrap: anywhere; }
dd { flex: 1 1 14rem; margin: 0; }
.diagnosis { border-left: 0.4rem solid var(--bad); background: var(--raised); padding: 0.25rem 0.8rem; margin: 0.75rem 0; }
.diagnosis h3 { margin: 0.25rem 0; }
.diagnosis dl { margin: 0.25rem 0; }
.diagnosis dt { flex-basis: 7rem; }
.diagnosis dd { flex-basis: 24rem; max-width: 60rem; }
.scroll { overflow-x: auto; margin: 0.75rem 0; position: relative; }
table { border-collapse: collapse; font-size: 0.875rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: 0.25rem 0; }
caption span { display: inline-block; position: sticky; left: 0; width: max-content;
  max-width: min(34rem, calc(100vw - 4.5rem)); }
th, td { padding: 0.2rem 0.55rem; border-bottom: 1px solid var(--rule); text-align: left; vertical-align: top;
  unicode-bidi: isolate; }
th { font-weight: 600; }
thead th { vertical-align: bottom; }
.subjects th[scope=row], .matrix th[scope=row], .matrix thead th:first-child, .subjects thead th:first-child,
.coverage th[scope=row], .coverage thead th:first-child {
  position: sticky; left: 0; background: var(--paper); z-index: 1; min-width: 9rem; max-width: 18rem;
  border-right: 1px solid var(--rule); overflow-wrap: break-word; }
.subjects thead th { max-width: 8rem; }
.subjects thead th:nth-child(2) { text-align: left; }
th small { display: block; font-weight: 400; color: var(--faint); }
.number, .matrix td { text-align: right; white-space: nowrap; }
thead .number { white-space: normal; }
.word { white-space: nowrap; }
.zero { color: var(--faint); }
.group th { background: var(--raised); font-weight: 400; color: var(--faint); }
.group span { position: sticky; left: 0.55rem; }
.verdict { white-space: nowrap; font-weight: 600; }
.verdict.sound { color: var(--good); }
.verdict.violated, .verdict.error { color: var(--bad); }
.verdict a { color: inherit; }
.matrix td { padding: 0.15rem 0.3rem; border-right: 1px solid var(--rule); }
.matrix .upright { vertical-align: bottom; padding: 0.4rem 0.2rem; border-right: 1px solid var(--rule); }
.upright span { writing-mode: vertical-rl; transform: rotate(180deg); white-space: nowrap; display: inline-block; }
.matrix { font-size: 0.8125rem; }
.matrix .sign { display: block; line-height: 1.1; }
@media (min-width: 60rem) { .matrix th[scope=row], .subjects th[scope=row] { white-space: nowrap; max-width: none; } }
.holds .sign { color: var(--good); }
.violated { background: var(--bad-paper); font-weight: 600; }
td.violated a { color: var(--bad); }
.unclaimed, .nothing { color: var(--faint); }
.matrix td.unclaimed, .matrix td.nothing { text-align: center; }
.above { font-weight: 700; }
.shade-0 { background: var(--shade-0); } .shade-1 { background: var(--shade-1); }
.shade-2 { background: var(--shade-2); } .shade-3 { background: var(--shade-3); }
.shade-4 { background: var(--shade-4); } .shade-5 { background: var(--shade-5); }
.shade-6 { background: var(--shade-6); } .shade-7 { background: var(--shade-7); }
pre { background: var(--raised); padding: 0.5rem 0.75rem; margin: 0.5rem 0; overflow: auto; max-height: 30rem;
  font: 0.8125rem/1.5 ui-monospace, monospace; white-space: pre-wrap; overflow-wrap: anywhere; }
article { border: 1px solid var(--rule); border-radius: 0.4rem; padding: 0.8rem; margin: 1rem 0; }
article:target { border-color: var(--link); box-shadow: 0 0 0 1px var(--link); }
.formula { overflow-x: auto; overflow-y: hidden; padding: 0.3rem 0; font-size: 1.1rem; }
.columns { display: flex; flex-wrap: wrap; gap: 0 2rem; align-items: flex-start; }
.witness-numbers { flex: 1 1 36rem; min-width: 0; max-width: 100%; display: flex; flex-wrap: wrap; gap: 0 2rem;
  align-content: flex-start; }
.witness-numbers .scroll { max-width: 100%; }
.witness-numbers p, .witness-numbers pre { flex: 1 0 100%; }
.pictures { flex: 1 1 18rem; min-width: 0; }
.numbers td { font-family: ui-monospace, monospace; font-size: 0.8125rem; }
.numbers th[scope=row] { font-weight: 400; white-space: nowrap; color: var(--faint); }
@media (max-width: 40rem) {
  .numbers th[scope=row] { white-space: normal; }
  .subjects th[scope=row], .matrix th[scope=row] { min-width: 7rem; max-width: 8rem; }
}
.drawings { display: flex; flex-wrap: wrap; gap: 0.5rem 1.5rem; }
figure { margin: 0; max-width: 26rem; }
figure svg { display: block; max-width: 100%; height: auto; background: var(--raised); border-radius: 0.3rem; }
figcaption { max-width: 17rem; font-size: 0.8125rem; color: var(--faint); }
svg path, svg ellipse { fill: none; stroke: var(--ink); stroke-width: 1.5; }
svg text { fill: var(--ink); font: 12px system-ui, sans-serif; }
svg .body { stroke: var(--body); fill: var(--body-fill); }
svg .surface { stroke: var(--body); }
svg .hatching { stroke: var(--body); stroke-width: 1; }
svg .arm { stroke: var(--body); stroke-width: 1; stroke-dasharray: 1 3; }
svg .point { fill: var(--ink); }
svg .centre { fill: var(--body); }
svg .normal { stroke: var(--ink); }
svg .normal.head { fill: var(--ink); }
svg .before { stroke: var(--before); stroke-width: 2; stroke-dasharray: 5 3; }
svg .before.head { fill: var(--before); stroke: none; }
svg .computed { stroke: var(--computed); stroke-width: 4.5; stroke-opacity: 0.75; }
svg .computed.head { fill: var(--computed); stroke: var(--computed); stroke-width: 2; }
svg .exact { stroke: var(--exact); stroke-width: 2; }
svg .exact.head { fill: var(--exact); stroke: none; }
svg text.before, svg text.computed, svg text.exact, svg text.normal { stroke: none; }
svg text.before { fill: var(--before); } svg text.computed { fill: var(--computed); } svg text.exact { fill: var(--exact); }
@page { size: A4 landscape; margin: 12mm; }
@media print {
  :root { color-scheme: light; }
  body { font-size: 10pt; }
  nav, .skip { display: none; }
  .scroll { overflow: visible; }
  table { font-size: 7pt; }
  .matrix td { padding: 0.1rem; } .matrix, .subjects, .coverage { font-size: 6.5pt; }
  th, td { padding: 0.1rem 0.2rem; }
  tr, figure, h2, h3, h4, .formula { break-inside: avoid; }
  h2, h3, h4 { break-after: avoid; }
  article { border: none; border-top: 1px solid var(--rule); border-radius: 0; padding: 0.5rem 0; }
  pre { max-height: none; }
  th, td { overflow-wrap: break-word; }
  .columns { flex-wrap: nowrap; } .pictures { flex: 0 0 16rem; }
  figure svg { max-height: 11rem; width: auto; }
  td, .swatch, .result, svg { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

}  // namespace carom::report
