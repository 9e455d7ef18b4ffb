// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// The style sheet of the report. Black on white, because it is meant for paper; headers of tables come again
// on each sheet.
inline constexpr char reportStyle[] = R"css(
html { color: black; background: white; font: 10pt sans-serif; }
body { max-width: 180mm; margin: 8mm auto; padding: 0 4mm; }
h1 { font-size: 18pt; margin: 0; }
h2 { font-size: 13pt; margin: 8mm 0 2mm; border-bottom: 1px solid black; }
h3 { font-size: 11pt; margin: 6mm 0 2mm; }
h1, h2, h3, p, td, th, dd { overflow-wrap: anywhere; }
p, td, dd { white-space: pre-line; }
p.subject { font-size: 13pt; margin: 1mm 0 4mm; }
table { border-collapse: collapse; width: 100%; margin: 2mm 0; font-size: 8.5pt; }
th { text-align: left; vertical-align: bottom; border-bottom: 1.5px solid black; padding: 1mm 2mm; }
td { text-align: left; vertical-align: top; border-bottom: 0.5px solid gray; padding: 0.8mm 2mm; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
.code { font-family: monospace; }
.stressed td { font-weight: bold; border-bottom: 1.5px solid black; }
dl { display: grid; grid-template-columns: 40mm 1fr; gap: 0.8mm 2mm; margin: 2mm 0; }
dd { margin: 0; }
figure { margin: 3mm 0; }
figcaption { font-size: 9pt; }
svg { width: 100%; height: auto; font: 9px sans-serif; }
.sign { display: grid; grid-template-columns: 2fr 1fr 2fr; gap: 0 6mm; margin: 4mm 0 10mm; }
.sign p { grid-column: 1 / 4; margin: 0; }
.sign span { border-top: 1px solid black; margin-top: 14mm; font-size: 8pt; }
@page { size: A4; margin: 15mm; }
@media print {
  body { max-width: none; margin: 0; padding: 0; }
  thead { display: table-header-group; }
  tr, figure, .sign { break-inside: avoid; }
  h1, h2, h3, figcaption { break-after: avoid; }
}
)css";

} // namespace codewheel
