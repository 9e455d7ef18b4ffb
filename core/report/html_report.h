// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"

#include <QByteArray>

#include <functional>

namespace codewheel {

// The report as one web page (HTML 5 that is also XML, UTF-8) for a screen and for A4 paper. Self-contained.
// The same report gives the same bytes.
QByteArray reportAsHtml(const Report &report);

// The content of its <body>; `drawn` returns the element of a picture.
QString reportBody(const Report &report, const std::function<QString(const CamPicture &)> &drawn);

// The picture as <svg>: a row for each cam, active ones filled, inactive ones as an outline.
QString camPictureAsSvg(const CamPicture &picture);

} // namespace codewheel
