// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// The style sheet of the report, for browsers and for the sheets of the PDF; the latter support only simple
// selectors, margins, paddings, borders and fonts. Black on white, because it is meant for paper; table
// headers are repeated on each sheet.
inline constexpr char reportStyle[] = R"css(
html { color: black; background: white; font: 9.5pt sans-serif; }
body { max-width: 180mm; margin: 8mm auto; padding: 0 4mm; }
h1 { font-size: 18pt; margin: 0; }
h2 { font-size: 13pt; margin: 6mm 0 2mm; border-bottom: 1px solid black; }
h3 { font-size: 11pt; margin: 5mm 0 2mm; }
h1, h2, h3, p, td, th { overflow-wrap: anywhere; }
p, td, th { white-space: pre-line; }
p { margin: 2mm 0; }
.subject { font-size: 13pt; font-weight: bold; margin: 1mm 0 4mm; }
table { border-collapse: collapse; width: 100%; margin: 2mm 0; font-size: 8pt; }
th { text-align: left; vertical-align: bottom; border-bottom: 1.5px solid black; padding: 0.8mm 3mm 0.8mm 0; }
td { text-align: left; vertical-align: top; border-bottom: 0.5px solid gray; padding: 0.8mm 3mm 0.8mm 0; }
.number { text-align: right; }
.code { font-family: monospace; }
.stressed td { font-weight: bold; }
.facts th { width: 40mm; font-weight: normal; vertical-align: top; }
.facts th, .facts td { font-size: 9.5pt; border-bottom: none; padding: 0; }
figure { margin: 3mm 0; }
svg { width: 100%; height: auto; }
.role { margin: 4mm 0 0; }
.sign { font-size: 7.5pt; margin: 14mm 0 10mm; }
.sign td { width: 32%; border-top: 1px solid black; border-bottom: none; padding: 0; }
.sign .gap { width: 2%; border: none; }
@page { size: A4; margin: 15mm; }
@media print {
  body { max-width: none; margin: 0; padding: 0; }
  thead { display: table-header-group; }
  tr, figure, .sign { break-inside: avoid; }
  h1, h2, h3, figcaption, .role { break-after: avoid; }
}
)css";

} // namespace codewheel
